// SPDX-License-Identifier: Apache-2.0
// Where the border before cell `index` of a line of cells is: up to half of `variation` from its
// place, in cells.
float moved_border(float index, int cell, float variation, uint bits) {
  return index + variation * (random(bits + uint(cell), -2) - 0.5);
}

// Which cell of such a line the point is in, or that many cells further, and where that begins and
// ends. The nearest whole number is the only border that can be on either side of the point.
int find_cell(float p, int count, float variation, uint bits, const bool toroidal, int further,
              out float low, out float high) {
  float index = floor(p + 0.5);
  int cell = int(index);
  float middle = moved_border(index, toroidal ? wrap_cell(cell, count) : cell, variation, bits);
  bool is_before = p < middle;
  if (further != 0) {
    int there = cell + further - (is_before ? 1 : 0);
    int next = there + 1;
    low = moved_border(float(there), toroidal ? wrap_cell(there, count) : there, variation, bits);
    high = moved_border(float(next), toroidal ? wrap_cell(next, count) : next, variation, bits);
    return toroidal ? wrap_cell(there, count) : there;
  }
  int other = is_before ? cell - 1 : cell + 1;
  float far =
      moved_border(float(other), toroidal ? wrap_cell(other, count) : other, variation, bits);
  low = is_before ? far : middle;
  high = is_before ? middle : far;
  int found = is_before ? other : cell;
  return toroidal ? wrap_cell(found, count) : found;
}

/// Divides the surface into courses of bricks with random lengths and, if wanted, random heights.
/// The borders of a regular grid are each moved at random, by a hash of the border's number, so
/// that every point finds its brick at once. Lengths lie between 1 - length_variation and
/// 1 + length_variation times the mean, and their mean is exactly 1 / columns; heights likewise.
/// The random bits are hash(column + hash(row + hash(seed))).
/// @param uv coordinate @default uv
/// @param rows rows for each unit of the coordinate @default 8 @range 1 4096
/// @param columns bricks for each unit of the coordinate, in a row, on average @default 4
///   @range 1 4096
/// @param length_variation how much longer or shorter than the mean a brick can be @default 0.5
///   @range 0 0.95
/// @param height_variation how much higher or lower than the mean a row can be @default 0
///   @range 0 0.95
/// @param row_offset how far every second row is moved to the left, in mean bricks @default 0.5
///   @range 0 1
/// @param row_jitter how far each row is moved to the left at random, up to that many mean bricks
///   @default 0 @range 0 1
/// @param seed another seed gives other lengths and other random bits @default 0
/// @param toroidal whether the bricks repeat with each unit of the coordinate, for a texture
///   without a border; with an odd number of rows the last and the first are not offset from each
///   other @default false
/// @param neighbour the brick that many columns and rows further is given, instead of the one that
///   the point is in; `layer` asks for it @default neighbour
/// @param tile the brick
/// @param edge distance to the border of the brick, in texture space
/// @param spacing how far joints are from each other, for `joint`
void random_length_grid(vec2 uv, int rows, int columns, float length_variation,
                        float height_variation, float row_offset, float row_jitter, int seed,
                        const bool toroidal, ivec2 neighbour, out Tile tile, out float edge,
                        out float spacing) {
  vec2 cells = vec2(columns, rows);
  vec2 p = uv * cells;
  vec2 low;
  vec2 high;
  float from;
  float to;
  uint bits = hash(uint(seed));
  int row = find_cell(p.y, rows, height_variation, bits, toroidal, neighbour.y, from, to);
  low.y = from;
  high.y = to;
  uint row_bits = hash(uint(row) + bits);
  p.x += row_offset * float(row & 1) + row_jitter * random(row_bits, -1);
  int column =
      find_cell(p.x, columns, length_variation, row_bits, toroidal, neighbour.x, from, to);
  low.x = from;
  high.x = to;
  tile.cell = ivec2(column, row);
  tile.local = (p - low) / (high - low);
  if (neighbour.x == 0 && neighbour.y == 0) {
    tile.local = clamp(tile.local, 0.0, 1.0);
  }
  tile.size = (high - low) / cells;
  tile.seed = hash(uint(column) + row_bits);
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  vec2 variation = vec2(length_variation, height_variation);
  tile.pitch = 1.0 / cells;
  tile.smallest = (1.0 - variation) / cells;
  tile.largest = (1.0 + variation) / cells;
  tile.drift = variation / cells;
  tile.tilt = vec2(1.0, 0.0);
  edge = tile_distance(tile);
  spacing = 2.0 / (cells.x + cells.y);
}
