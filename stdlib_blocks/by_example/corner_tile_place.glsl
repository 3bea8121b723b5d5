// SPDX-License-Identifier: Apache-2.0
/// Where the tile with these corners stands in the pack of a set of corner tiles. Two tiles that
/// touch there have the same colours where they touch, so that a filter sees in the pack what it
/// sees in the tiling.
/// @source Lagae and Dutré, An Alternative for Wang Tiles: Colored Edges versus Colored Corners,
///   2006, has the tiles; the pack is a torus found by search for 2 colours, else Wei's tour, each
///   row shifted against the one below: each 2 x 2 window of colours is there once
/// @param corners the colours: left bottom, right bottom, left top, right top
/// @param colors how many colours there are @default 2 @range 2 4
/// @return column and row, from the left lower corner
ivec2 corner_tile_place(ivec4 corners, const int colors) {
  if (colors == 2) {
    // Two bits for each tile.
    int bit = 2 * (corners.x + 2 * corners.y + 4 * corners.z + 8 * corners.w);
    return ivec2(uvec2(0x313B46E6u >> uint(bit), 0x0F72275Au >> uint(bit)) & 3u);
  }
  const int count = colors * colors;
  int below = tile_index(corners.x, corners.y);
  int row = (tile_index(corners.z, corners.w) - below + count) % count;
  // 120 is the greatest shift.
  int column = (below - row * (row - 1) / 2 + 16 * count) % count;
  return ivec2(column, row);
}
