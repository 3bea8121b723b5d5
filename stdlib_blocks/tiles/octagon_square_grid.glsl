// SPDX-License-Identifier: Apache-2.0
/// Divides the surface into octagons and small squares that stand on a corner between them.
/// The octagons fill a grid of rows and columns, less their corners; a square has its middle where
/// four octagons would meet. The column of a tile's cell is even for octagons, odd for squares. An
/// octagon's frame is the upright box around it; a square's frame is turned by an eighth to the
/// left, along its sides: with other than as many rows as columns it is stretched along with the
/// square. The random bits are hash(column + hash(row + hash(seed))).
/// @param uv coordinate @default uv
/// @param rows rows of octagons for each unit of the coordinate @default 6 @range 1 4096
/// @param columns octagons for each unit of the coordinate, in a row @default 6 @range 1 4096
/// @param corner how far the squares reach from their middle along the grid's lines, in cells;
///   0.29289 makes regular octagons, 0.5 leaves only squares @default 0.29289322 @range 0.01 0.5
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the tiles repeat with each unit of the coordinate, for a texture without
///   a border @default false
/// @param tile the octagon or the square
/// @param edge distance to the border of the tile, in texture space
/// @param spacing how far joints are from each other, for `joint`
void octagon_square_grid(vec2 uv, int rows, int columns, float corner, int seed,
                         const bool toroidal, out Tile tile, out float edge, out float spacing) {
  vec2 cells = vec2(columns, rows);
  vec2 p = uv * cells;
  vec2 nearest = floor(p + 0.5);
  vec2 from_corner = p - nearest;
  vec2 away = abs(from_corner);
  float inside = away.x + away.y - corner;
  float slanted = abs(inside) / length(cells);
  float side = corner * length(1.0 / cells);
  bool is_square = inside < 0.0;
  vec2 base = is_square ? nearest : floor(p);
  ivec2 cell = ivec2(base);
  if (toroidal) {
    cell = wrap_cell(cell, ivec2(columns, rows));
  }
  tile.cell = ivec2(2 * cell.x + (is_square ? 1 : 0), cell.y);
  tile.seed = hash(tile.cell, uint(seed));
  tile.pitch = vec2(0.0);
  tile.smallest = vec2(0.0);
  tile.largest = vec2(0.0);
  tile.drift = vec2(0.0);
  tile.tilt = vec2(0.0);
  if (is_square) {
    tile.local =
        vec2(from_corner.x + from_corner.y, from_corner.y - from_corner.x) / (2.0 * corner) + 0.5;
    tile.size = vec2(side);
    tile.right = normalize(1.0 / cells);
    tile.up = tile.right * vec2(-1.0, 1.0);
    edge = slanted;
  } else {
    tile.local = p - base;
    tile.size = 1.0 / cells;
    tile.right = vec2(1.0, 0.0);
    tile.up = vec2(0.0, 1.0);
    edge = min(slanted, min(away.x / cells.x, away.y / cells.y));
  }
  float straight = (2.0 - 4.0 * corner) * (1.0 / cells.x + 1.0 / cells.y);
  spacing = 4.0 / (cells.x * cells.y * (straight + 8.0 * side));
}
