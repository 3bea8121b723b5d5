// SPDX-License-Identifier: Apache-2.0
/// Where the cube with these corners stands in the pack of a set of corner cubes, a torus: two cubes
/// that touch there have the same colours where they touch, so that a filter sees in the pack what
/// it sees in the tiling. Layers of corners are the pack of corner tiles, each moved against the one
/// below by another step, in the order of the steps.
/// @source after Lagae and Dutré, An Alternative for Wang Tiles: Colored Edges versus Colored
///   Corners, 2006; the layers are texgraph's, docs/decisions/0024-cube-tiles.md
/// @param below the colours of the lower corners: left bottom, right bottom, left top, right top
/// @param above those of the upper ones
/// @param colors how many colours there are @default 2 @range 2 3
/// @return column, row and layer, from the lowest left corner
ivec3 corner_cube_place(ivec4 below, ivec4 above, const int colors) {
  const uint count = uint(colors * colors);
  uvec2 window = uvec2(corner_tile_place(below, colors));
  // The step to the layer above, and what the steps below it sum to.
  uvec2 ij = (uvec2(corner_tile_place(above, colors)) + count - window) % count;
  uvec2 moved = uvec2(ij.x * (ij.x - 1u) / 2u + ij.y * (count * (count - 1u) / 2u), ij.x * ij.y);
  return ivec3(uvec3((window + count - moved % count) % count, ij.x + ij.y * count));
}
