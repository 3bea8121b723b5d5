// SPDX-License-Identifier: Apache-2.0
/// Which part of its exemplar a hexagon of `noise_field` shows: how far the exemplar is moved.
/// By whole texels, so that hexagons that are blended are filtered alike; otherwise the filter
/// would take variance away from what is fine.
/// @param node column and row of the hexagon, as of `hex_shares`
/// @param texels columns and rows of the exemplar
/// @param period as of `noise_field` @default ivec2(0) @range 0 65536
/// @param seed as of `noise_field` @default 0
/// @return parts of the exemplar, at least 0 and below 1
vec2 noise_offset(ivec2 node, ivec2 texels, const ivec2 period, int seed) {
  ivec2 cell = node;
  if (period.x > 0) {
    cell.x = wrap_cell(cell.x, period.x);
  }
  if (period.y > 0) {
    // An even number, since every second row is moved.
    cell.y = wrap_cell(cell.y, period.y + (period.y & 1));
  }
  vec2 size = vec2(texels);
  return floor(random2(hash(cell, uint(seed)), -1) * size) / size;
}
