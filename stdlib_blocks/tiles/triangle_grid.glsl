// SPDX-License-Identifier: Apache-2.0
/// Divides the surface into triangles: in every row those that point up and those that point down
/// in turn.
/// The triangles have equal sides where there are 2 / sqrt(3) = 1.1547 times as many rows as
/// columns (8 rows to 7 columns are off by 1 %), else they are stretched. The tile's frame is the
/// box around the triangle; for those that point down it is turned by half a turn, so that in its
/// frame every triangle has the corners (0, 0), (1, 0) and (0.5, 1). The column of a triangle's
/// cell is even if it points up. The random bits are hash(column + hash(row + hash(seed))).
/// @param uv coordinate @default uv
/// @param rows rows for each unit of the coordinate @default 8 @range 1 4096
/// @param columns pairs of triangles for each unit of the coordinate, in a row @default 7
///   @range 1 4096
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the triangles repeat with each unit of the coordinate, for a texture
///   without a border; an odd number of rows becomes the next even one then @default false
/// @param tile the triangle
/// @param edge distance to the border of the triangle, in texture space
/// @param spacing how far joints are from each other, for `joint`
void triangle_grid(vec2 uv, int rows, int columns, int seed, const bool toroidal, out Tile tile,
                   out float edge, out float spacing) {
  int row_count = toroidal ? rows + (rows & 1) : rows;
  vec2 cells = vec2(columns, row_count);
  vec2 p = uv * cells;
  float bottom = floor(p.y);
  int row = int(bottom);
  float y = p.y - bottom;
  // Along slanted lines that rise to the right, x is constant.
  float x = p.x + 0.5 * float(row & 1) - 0.5 * y;
  float column = floor(x);
  x -= column;
  int points_down = x + y > 1.0 ? 1 : 0;
  if (points_down == 1) {
    x = 1.0 - x;
    y = 1.0 - y;
  }
  ivec2 pair = ivec2(int(column), row);
  if (toroidal) {
    pair = wrap_cell(pair, ivec2(columns, row_count));
  }
  tile.cell = ivec2(2 * pair.x + points_down, pair.y);
  tile.local = vec2(x + 0.5 * y, y);
  tile.size = 1.0 / cells;
  tile.seed = hash(tile.cell, uint(seed));
  float way = points_down == 1 ? -1.0 : 1.0;
  tile.right = vec2(way, 0.0);
  tile.up = vec2(0.0, way);
  tile.pitch = vec2(0.0);
  tile.smallest = vec2(0.0);
  tile.largest = vec2(0.0);
  tile.drift = vec2(0.0);
  tile.tilt = vec2(0.0);
  float slanted = min(x, 1.0 - x - y) / length(cells * vec2(1.0, 0.5));
  edge = max(min(y / cells.y, slanted), 0.0);
  float perimeter = 1.0 / cells.x + 2.0 * length(vec2(0.5, 1.0) / cells);
  spacing = 2.0 / (cells.x * cells.y * perimeter);
}
