// SPDX-License-Identifier: Apache-2.0
/// The place in the texture of a pack of tiles.
/// @param tiles the pack; beside and above its tiles it may have gutters, equally many texels on
///   both sides, which follow from its size
/// @param place column and row of the tile, from the left lower corner
/// @param local where in the tile, from (0, 0) to (1, 1)
/// @param pack columns and rows of tiles; of a texture with the key `tiles` they are known
///   @grid_of tiles @range 1 4096
/// @param gutters whether there may be gutters @default false
vec2 pack_place(sampler2D tiles, ivec2 place, vec2 local, const ivec2 pack, const bool gutters) {
  vec2 at = (vec2(place) + local) / vec2(pack);
  if (gutters) {
    // The tiles are squares: what is left of the height are gutters.
    vec2 size = vec2(textureSize(tiles, 0));
    float part = float(pack.y) * size.x / (float(pack.x) * size.y);
    at.y = 0.5 + (at.y - 0.5) * part;
  }
  return at;
}
