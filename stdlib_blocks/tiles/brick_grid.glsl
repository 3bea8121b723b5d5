// SPDX-License-Identifier: Apache-2.0
/// Divides the surface into bricks: rows of equal height, each moved sideways, and columns.
/// Every point learns in which brick it lies, where in it, and random bits that are the brick's
/// own. The column is counted after the row was moved, so that a brick has one number from end to
/// end. The random bits are hash(column + hash(row + hash(seed))).
/// @source the tile template of the brick shader generator, section 3.2; row offset and jitter
///   added
/// @param uv coordinate @default uv
/// @param rows rows for each unit of the coordinate @default 8 @range 1 4096
/// @param columns bricks for each unit of the coordinate, in a row @default 4 @range 1 4096
/// @param row_offset how far every second row is moved to the left, in bricks; 0.5 is a running
///   bond @default 0.5 @range 0 1
/// @param row_jitter how far each row is moved to the left at random, up to that many bricks
///   @default 0 @range 0 1
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the bricks repeat with each unit of the coordinate, for a texture
///   without a border; with an odd number of rows the last and the first are not offset from each
///   other @default false
/// @param neighbour the brick that many columns and rows further is given, instead of the one that
///   the point is in; `layer` asks for it @default neighbour
/// @param tile the brick
void brick_grid(vec2 uv, int rows, int columns, float row_offset, float row_jitter, int seed,
                const bool toroidal, ivec2 neighbour, out Tile tile) {
  vec2 cells = vec2(columns, rows);
  vec2 p = uv * cells;
  int row = int(floor(p.y)) + neighbour.y;
  if (toroidal) {
    row = wrap_cell(row, rows);
  }
  uint row_bits = hash(uint(row) + hash(uint(seed)));
  p.x += row_offset * float(row & 1) + row_jitter * random(row_bits, -1);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  if (toroidal) {
    column = wrap_cell(column, columns);
  }
  tile.cell = ivec2(column, row);
  tile.local = p - corner;
  tile.size = 1.0 / cells;
  tile.seed = hash(uint(column) + row_bits);
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  tile.pitch = tile.size;
  tile.smallest = tile.size;
  tile.largest = tile.size;
  tile.drift = vec2(0.0);
  tile.tilt = vec2(1.0, 0.0);
}
