// SPDX-License-Identifier: Apache-2.0
/// What a tile consists of.
/// @param tile the tile
/// @param cell column and row
/// @param local the point in the tile, from (0, 0) at its lower left corner to (1, 1)
/// @param size width and height of the tile in texture space
/// @param seed the tile's random bits
void tile_parts(Tile tile, out ivec2 cell, out vec2 local, out vec2 size, out uint seed) {
  cell = tile.cell;
  local = tile.local;
  size = tile.size;
  seed = tile.seed;
}

/// @param tile the cell in space
/// @param cell column, row and slice
/// @param local the point in the cell, from (0, 0, 0) to (1, 1, 1)
/// @param size the cell's extent in texture space
/// @param seed the cell's random bits
void tile_parts(Tile3 tile, out ivec3 cell, out vec3 local, out vec3 size, out uint seed) {
  cell = tile.cell;
  local = tile.local;
  size = tile.size;
  seed = tile.seed;
}
