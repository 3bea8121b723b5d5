// SPDX-License-Identifier: Apache-2.0
/// Divides the surface into hexagons that stand on a corner, row over row, every second row moved
/// to the left by half a hexagon. The hexagons are regular where there are 2 / sqrt(3) = 1.1547
/// times as many rows as columns (8 rows to 7 columns are off by 1 %), else stretched. The tile's
/// frame is the upright box around the hexagon, 4/3 of a row high. The random bits are hash(column
/// + hash(row + hash(seed))).
/// @param uv coordinate @default uv
/// @param rows rows for each unit of the coordinate @default 8 @range 1 4096
/// @param columns hexagons for each unit of the coordinate, in a row @default 7 @range 1 4096
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the hexagons repeat with each unit of the coordinate, for a texture
///   without a border; an odd number of rows becomes the next even one then @default false
/// @param neighbour the hexagon that many columns and rows further is given, not the one that
///   the point is in; `layer` asks for it @default neighbour
/// @param tile the hexagon
/// @param edge distance to the border of the hexagon, in texture space
/// @param spacing how far joints are from each other, for `joint`
void hexagon_grid(vec2 uv, int rows, int columns, int seed, const bool toroidal, ivec2 neighbour,
                  out Tile tile, out float edge, out float spacing) {
  int row_count = toroidal ? rows + (rows & 1) : rows;
  vec2 cells = vec2(columns, row_count);
  vec2 p = uv * cells;
  // The row whose middle is below; its hexagon's upper corners reach 2/3 of a row above the middle.
  float middle = floor(p.y - 0.5) + 0.5;
  int row = int(floor(p.y - 0.5));
  float x = p.x + 0.5 * float(row & 1);
  float column = floor(x);
  vec2 offset = vec2(x - column - 0.5, p.y - middle);
  // The two rows' values of this add up to 2; it is 1 on the slanted sides.
  if (abs(offset.x) + 1.5 * offset.y > 1.0) {
    row += 1;
    x = p.x + 0.5 * float(row & 1);
    column = floor(x);
    offset = vec2(x - column - 0.5, p.y - middle - 1.0);
  }
  if (neighbour.x != 0 || neighbour.y != 0) {
    row += neighbour.y;
    x = p.x + 0.5 * float(row & 1);
    column = floor(x) + float(neighbour.x);
    offset = vec2(x - column - 0.5, p.y - float(row) - 0.5);
  }
  tile.cell = ivec2(int(column), row);
  if (toroidal) {
    tile.cell = wrap_cell(tile.cell, ivec2(columns, row_count));
  }
  tile.local = offset * vec2(1.0, 0.75) + 0.5;
  tile.size = vec2(1.0, 4.0 / 3.0) / cells;
  tile.seed = hash(tile.cell, uint(seed));
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  tile.pitch = 1.0 / cells;
  tile.smallest = tile.size;
  tile.largest = tile.size;
  // The hexagon itself is a third higher than the rows are apart.
  tile.drift = vec2(0.0, 1.0 / 6.0) / cells;
  tile.tilt = vec2(1.0, 0.0);
  float slanted = 1.0 - abs(offset.x) - 1.5 * abs(offset.y);
  edge = max(min((0.5 - abs(offset.x)) / cells.x, slanted / length(cells * vec2(1.0, 1.5))), 0.0);
  float perimeter = 4.0 / (3.0 * cells.y) + 4.0 * length(vec2(0.5, 1.0 / 3.0) / cells);
  spacing = 4.0 / (cells.x * cells.y * perimeter);
}
