// SPDX-License-Identifier: Apache-2.0
const int GRID_SQUARE = 0;
const int GRID_HEXAGON = 1;

/// How many cells across and up have copies whose centres can be nearer than `spacing` to one
/// place; none without spacing. `bomb` computes it when the shader is made; it is `bomb_cells` for
/// discs of that radius.
/// @param grid as of `bomb` @default GRID_SQUARE
/// @param jitter as of `bomb` @default vec2(1)
/// @param spacing as of `bomb` @default 0
ivec2 bomb_rivals(const int grid, vec2 jitter, const float spacing) {
  if (spacing <= 0.0) {
    return ivec2(0);
  }
  return bomb_cells(grid, jitter, vec2(2.0 * spacing), vec2(0.0), SHAPE_DISC);
}
