// SPDX-License-Identifier: Apache-2.0
/// Divides the surface into a basket weave: blocks of parallel bricks, lying in one block and
/// standing in the next, like a chessboard.
/// A standing brick's frame is turned by a quarter to the left: its local x goes up, its local y to
/// the left. The bricks of a block have numbers from below, or from the right where they stand:
/// column * bricks + number is the column of the brick's cell. The random bits are
/// hash(column + hash(row + hash(seed))) of that.
/// @param uv coordinate @default uv
/// @param rows rows of blocks for each unit of the coordinate @default 6 @range 1 4096
/// @param columns blocks for each unit of the coordinate, in a row @default 6 @range 1 4096
/// @param bricks bricks in a block @default 2 @range 1 64
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the bricks repeat with each unit of the coordinate, for a texture
///   without a border; with an odd number of rows or columns, blocks of the same direction meet at
///   the border @default false
/// @param tile the brick; local x goes along it
/// @param edge distance to the border of the brick, in texture space
/// @param spacing how far joints are from each other, for `joint`
void basket_weave_grid(vec2 uv, int rows, int columns, int bricks, int seed, const bool toroidal,
                       out Tile tile, out float edge, out float spacing) {
  vec2 cells = vec2(columns, rows);
  vec2 p = uv * cells;
  vec2 corner = floor(p);
  ivec2 block = ivec2(corner);
  if (toroidal) {
    block = wrap_cell(block, ivec2(columns, rows));
  }
  float parts = float(bricks);
  vec2 inner = p - corner;
  tile.size = vec2(1.0 / cells.x, 1.0 / (cells.y * parts));
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  if (((block.x + block.y) & 1) == 1) {
    inner = vec2(inner.y, 1.0 - inner.x);
    tile.size = vec2(1.0 / cells.y, 1.0 / (cells.x * parts));
    tile.right = vec2(0.0, 1.0);
    tile.up = vec2(-1.0, 0.0);
  }
  float across = inner.y * parts;
  // At the very border, rounding can reach the number after the last.
  float number = min(floor(across), parts - 1.0);
  tile.local = vec2(inner.x, across - number);
  tile.cell = ivec2(block.x * bricks + int(number), block.y);
  tile.seed = hash(tile.cell, uint(seed));
  tile.pitch = vec2(0.0);
  tile.smallest = vec2(0.0);
  tile.largest = vec2(0.0);
  tile.drift = vec2(0.0);
  tile.tilt = vec2(0.0);
  edge = max(tile_distance(tile), 0.0);
  spacing = 4.0 / ((parts + 1.0) * (cells.x + cells.y));
}
