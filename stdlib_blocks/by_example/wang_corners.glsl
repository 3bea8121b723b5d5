// SPDX-License-Identifier: Apache-2.0
/// What `wang_tiles` with the same ports should show around its corners: the look-up in the pack of
/// corners, and how much it counts. `wang_tiles_with_corners` mixes both.
/// @source Wei, Tile-Based Texture Mapping on Graphics Hardware, 2004, appendix B; the weight is
///   shown there in plate 1 alone
/// @param corners the pack of corners of the tiles: a texture with the key `corners`
/// @param colors how many colours edges have: those that lie, and those that stand @range 1 4
/// @param uv coordinate @default uv
/// @param tiling how many tiles for each unit of the coordinate @default vec2(8)
/// @param period after how many tiles the plane repeats, across and up; 0 never @default ivec2(0)
///   @range 0 65536
/// @param seed that of `wang_tiles` @default 0
/// @param reach how far from a corner tiles show something that depends on both edges that meet
///   there, in tiles: the pack of corners counts in full at least so far. Of tiles that are cut from
///   a picture 0 is right @default 0 @range 0 0.25
/// @param color the texture around the nearest corner, straight alpha
/// @param weight 1 where a filter sees other tiles over the corner: within a texel of the pack, or a
///   pixel if that is larger, a sixteenth of a tile at most, or `reach`. It is 0 from twice that on:
///   so far what tiles cut from a picture have around a corner depends on its edges alone
void wang_corners(sampler2D corners, vec2 uv, vec2 tiling, const ivec2 colors, const ivec2 period,
                  int seed, float reach, out vec4 color, out float weight) {
  vec2 p = uv * tiling;
  ivec2 corner = ivec2(floor(p + 0.5));
  // From the corner, the right top one of its tile in the pack.
  vec2 away = p - vec2(corner);
  ivec2 before = corner - 1;
  if (period.x > 0) {
    corner.x = wrap_cell(corner.x, period.x);
    before.x = wrap_cell(before.x, period.x);
  }
  if (period.y > 0) {
    corner.y = wrap_cell(corner.y, period.y);
    before.y = wrap_cell(before.y, period.y);
  }
  const ivec2 pack = ivec2(colors.x * colors.x, colors.y * colors.y);
  vec2 texel = vec2(pack) / vec2(textureSize(corners, 0));
  vec2 within = max(min(max(texel, footprint(p)), 0.0625), reach);
  vec2 near = clamp(2.0 - abs(away) / within, 0.0, 1.0);
  weight = min(near.x, near.y);
  uvec2 rows = hash(uvec2(before.y, corner.y) + hash(uint(seed)));
  uint own = hash(uint(corner.x) + rows.y);
  int right = int((own & 65535u) % uint(colors.x));
  int left = int((hash(uint(before.x) + rows.y) & 65535u) % uint(colors.x));
  int top = int((own >> 16u) % uint(colors.y));
  int bottom = int((hash(uint(corner.x) + rows.x) >> 16u) % uint(colors.y));
  ivec2 place = ivec2(tile_index(left, right), tile_index(bottom, top));
  color = texture(corners, pack_place(corners, place, away + 1.0, pack, false));
}
