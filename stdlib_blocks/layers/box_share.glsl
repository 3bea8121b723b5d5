// SPDX-License-Identifier: Apache-2.0
/// The share of a pixel that is in a box, from 0 to 1 in the box' own frame: the coverage of an
/// element that is drawn in a cell.
/// It is the product of the shares along the box' two axes. Where a pixel is larger than the cell
/// it counts as the cell, so that far away the coverage is the share of the cell that the box
/// takes. Of a box that is cut it is the share of the pixel's part in the cell: one that fills its
/// cell is whole up to the border, where the next cell goes on.
/// @param q the point in the box
/// @param cell_in_q how large the cell is in the box' frame
/// @param local the point in the cell, from 0 to 1
/// @param cut whether the box ends at the border of the cell
/// @return from 0 to 1
float box_share(vec2 q, vec2 cell_in_q, vec2 local, const bool cut) {
  vec2 density = 1.0 / clamp(footprint(q), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  if (!cut) {
    vec2 covered = clamp(share, 0.0, 1.0);
    return covered.x * covered.y;
  }
  vec2 cell_width = clamp(footprint(local), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}
