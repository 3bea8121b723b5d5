// SPDX-License-Identifier: Apache-2.0
const int GRID_SQUARE = 0;
const int GRID_HEXAGON = 1;

/// How many cells across and up have copies that can reach one point, whatever is drawn at random.
/// A copy whose centre is up to a from the middle of its cell, and that reaches r to each side, is
/// seen at p only if the middle of its cell is between p - a - r and p + a + r: that many whole
/// numbers lie there at most. `bomb` computes it when the shader is made and looks at no more cells
/// than these.
/// @param grid as of `bomb` @default GRID_SQUARE
/// @param jitter as of `bomb` @default vec2(1)
/// @param size as of `bomb` @default vec2(1)
/// @param rotation as of `bomb` @default vec2(0) @unit degrees
/// @param shape as of `bomb` @default SHAPE_SQUARE
ivec2 bomb_cells(const int grid, vec2 jitter, vec2 size, vec2 rotation, const int shape) {
  float height = grid == GRID_HEXAGON ? 0.8660254037844386 : 1.0;
  vec2 width = jitter + 2.0 * bomb_reach(size, rotation, shape) / vec2(1.0, height);
  // What only touches a point, but for rounding, does not reach it.
  return max(ivec2(ceil(width - 1e-6)), 1);
}
