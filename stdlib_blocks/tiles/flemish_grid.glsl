// SPDX-License-Identifier: Apache-2.0
/// Divides the surface into a Flemish bond: in every row long bricks (stretchers) and short ones
/// (headers) in turn, each header over the middle of a stretcher.
/// Every second row is moved to the left by half of a pair. The column of a brick's cell is twice
/// that of its pair for the stretcher, and one more for the header. The random bits are
/// hash(column + hash(row + hash(seed))).
/// @param uv coordinate @default uv
/// @param rows rows for each unit of the coordinate @default 8 @range 1 4096
/// @param columns pairs of a stretcher and a header for each unit of the coordinate, in a row
///   @default 3 @range 1 4096
/// @param header length of a header, in lengths of a stretcher @default 0.5 @range 0.01 1
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the bricks repeat with each unit of the coordinate, for a texture
///   without a border; with an odd number of rows the last and the first are not offset from each
///   other @default false
/// @param neighbour the brick that many columns and rows further is given, instead of the one that
///   the point is in; `layer` asks for it @default neighbour
/// @param tile the brick
/// @param edge distance to the border of the brick, in texture space
/// @param spacing how far joints are from each other, for `joint`
void flemish_grid(vec2 uv, int rows, int columns, float header, int seed, const bool toroidal,
                  ivec2 neighbour, out Tile tile, out float edge, out float spacing) {
  vec2 cells = vec2(columns, rows);
  vec2 p = uv * cells;
  float bottom = floor(p.y) + float(neighbour.y);
  int row = int(bottom);
  if (toroidal) {
    row = wrap_cell(row, rows);
  }
  p.x += 0.5 * float(row & 1);
  float left = floor(p.x);
  float stretcher = 1.0 / (1.0 + header);
  bool is_header = p.x - left >= stretcher;
  int pair = int(left);
  if (neighbour.x != 0) {
    int number = 2 * pair + (is_header ? 1 : 0) + neighbour.x;
    pair = number >> 1;
    left = float(pair);
    is_header = (number & 1) == 1;
  }
  float inner = p.x - left;
  if (toroidal) {
    pair = wrap_cell(pair, columns);
  }
  float first = is_header ? stretcher : 0.0;
  float share = is_header ? 1.0 - stretcher : stretcher;
  tile.cell = ivec2(2 * pair + (is_header ? 1 : 0), row);
  tile.local = vec2((inner - first) / share, p.y - bottom);
  tile.size = vec2(share, 1.0) / cells;
  tile.seed = hash(tile.cell, uint(seed));
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  // Two tiles in a row are as long as a pair, but one of them may be a header.
  vec2 lengths = vec2(max(stretcher, 1.0 - stretcher), min(stretcher, 1.0 - stretcher));
  tile.pitch = vec2(0.5, 1.0) / cells;
  tile.smallest = vec2(lengths.y, 1.0) / cells;
  tile.largest = vec2(lengths.x, 1.0) / cells;
  tile.drift = vec2(0.5 * lengths.x - lengths.y + 0.25, 0.0) / cells;
  tile.tilt = vec2(1.0, 0.0);
  edge = max(tile_distance(tile), 0.0);
  spacing = 2.0 / (2.0 * cells.x + cells.y);
}
