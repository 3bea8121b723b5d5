// SPDX-License-Identifier: Apache-2.0
/// A pattern that lies anywhere, by a map that says for each cell which pattern is to be seen in it
/// and how far it is moved: a texture sprite.
/// A sprite is as large as a cell, and stands in the map in each of the four cells that it can
/// touch; so one look-up finds it. Moving a sprite means to write these texels. A map with several
/// layers has as many sprites in a cell; they are drawn by `texture_sprites`.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Explicit
///   Positioning, and figure 6
/// @param sprites a layer has for each cell the offset of the sprite's left lower corner from the
///   cell's, in cells, and the number of the pattern, -1 for none; the map repeats where the grid
///   has more cells
/// @param tile the tile, a cell of the map
/// @param layer which layer of the map, from 0; beyond the last there is nothing @default 0
///   @range 0 255
/// @param pattern the pattern, -1 for none @one_of sprites
/// @param inner the pattern's frame; its cell is the one that the sprite's middle is in, so that
///   its random bits are the same all over the sprite
/// @param coverage the share of the pixel that the sprite covers
void explicit_positioning(sampler2DArray sprites, Tile tile, int layer, out int pattern,
                          out Tile inner, out float coverage) {
  ivec3 size = textureSize(sprites, 0);
  ivec2 cell = wrap_cell(tile.cell, size.xy);
  vec4 sprite = texelFetch(sprites, ivec3(cell, clamp(layer, 0, size.z - 1)), 0);
  vec2 q = tile.local - sprite.xy;
  pattern = layer < 0 || layer >= size.z ? -1 : int(sprite.z);
  inner = tile;
  inner.cell = cell + ivec2(floor(sprite.xy + 0.5));
  inner.local = q;
  inner.seed = cell_hash(inner.cell, layer);
  inner.pitch = vec2(0.0);
  inner.smallest = vec2(0.0);
  inner.largest = vec2(0.0);
  inner.drift = vec2(0.0);
  inner.tilt = vec2(0.0);
  vec2 width = footprint(tile.local);
  vec2 share = clamp((0.5 - abs(q - 0.5)) / clamp(width, 1e-5, 1.0) + 0.5, 0.0, 1.0);
  // Where a pixel holds cells it shows how much of its cell the sprite takes; all four, of one.
  vec2 part = clamp(1.0 - abs(sprite.xy), 0.0, 1.0);
  float away = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  coverage = pattern < 0 ? 0.0 : mix(share.x * share.y, part.x * part.y, away);
}
