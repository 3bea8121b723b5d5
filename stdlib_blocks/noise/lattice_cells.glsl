// SPDX-License-Identifier: Apache-2.0
/// A cell of a line of cells and the one after it, in the form that `hash` takes: the two ends of
/// what a noise interpolates.
/// @param cell which cell; below 0 as its two's complement
/// @param period after how many cells they come again; 0 never @default 0 @range 0 16777216
/// @return the cell and the next
uvec2 lattice_cells(uint cell, const int period) {
  if (period == 0) {
    return uvec2(cell, cell + 1u);
  }
  uint first = uint(wrap_cell(int(cell), period));
  uint next = first + 1u;
  return uvec2(first, next == uint(period) ? 0u : next);
}
