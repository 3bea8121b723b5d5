// SPDX-License-Identifier: Apache-2.0
/// Divides the surface into herringbone: bricks that are a whole number of times as long as wide,
/// lying and standing in turn, each ending at the side of another.
/// In units of a brick's width, the cell (x, y) belongs to a lying brick if x - y leaves less than
/// `ratio` when divided by 2 ratio, else to a standing one. A standing brick's frame is turned by a
/// quarter to the left: its local x goes up, its local y to the left. The random bits are
/// hash(column + hash(row + hash(seed))) of the brick's lower left cell.
/// The pattern repeats after 2 ratio cells, and `rows` and `columns` count these repetitions;
/// therefore every whole number of them fits a toroidal texture.
/// @param uv coordinate @default uv
/// @param rows repetitions for each unit of the coordinate, upwards; each is 2 ratio brick widths
///   @default 2 @range 1 256
/// @param columns repetitions for each unit of the coordinate, across; other than `rows`, the
///   standing bricks have another shape than the lying ones @default 2 @range 1 256
/// @param ratio a brick's length in widths; 1 gives squares @default 3 @range 1 64
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the bricks repeat with each unit of the coordinate, for a texture
///   without a border @default false
/// @param tile the brick; local x goes along it
/// @param edge distance to the border of the brick, in texture space
/// @param spacing how far joints are from each other, for `joint`
void herringbone_grid(vec2 uv, int rows, int columns, int ratio, int seed, const bool toroidal,
                      out Tile tile, out float edge, out float spacing) {
  ivec2 count = 2 * ratio * ivec2(columns, rows);
  vec2 cells = vec2(count);
  vec2 p = uv * cells;
  vec2 corner = floor(p);
  vec2 inner = p - corner;
  ivec2 cell = ivec2(corner);
  int phase = wrap_cell(cell.x - cell.y, 2 * ratio);
  float parts = float(ratio);
  if (phase < ratio) {
    cell.x -= phase;
    tile.local = vec2((float(phase) + inner.x) / parts, inner.y);
    tile.size = vec2(parts / cells.x, 1.0 / cells.y);
    tile.right = vec2(1.0, 0.0);
    tile.up = vec2(0.0, 1.0);
  } else {
    int step_up = 2 * ratio - 1 - phase;
    cell.y -= step_up;
    tile.local = vec2((float(step_up) + inner.y) / parts, 1.0 - inner.x);
    tile.size = vec2(parts / cells.y, 1.0 / cells.x);
    tile.right = vec2(0.0, 1.0);
    tile.up = vec2(-1.0, 0.0);
  }
  if (toroidal) {
    cell = wrap_cell(cell, count);
  }
  tile.cell = cell;
  tile.seed = hash(cell, uint(seed));
  tile.pitch = vec2(0.0);
  tile.smallest = vec2(0.0);
  tile.largest = vec2(0.0);
  tile.drift = vec2(0.0);
  tile.tilt = vec2(0.0);
  edge = max(tile_distance(tile), 0.0);
  spacing = 4.0 * parts / ((parts + 1.0) * (cells.x + cells.y));
}
