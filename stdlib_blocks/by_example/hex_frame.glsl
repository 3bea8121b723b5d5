// SPDX-License-Identifier: Apache-2.0
/// One hexagon of `hex_tiling`, turned as the picture is that it shows.
/// The tile's frame is as wide as a column of hexagons and 4/3 as high as a row, turned about its
/// middle. Its random bits are hash(column + hash(row + hash(seed))).
/// @param uv coordinate @default uv
/// @param cells columns and rows of hexagons for each unit of the coordinate
/// @param node column and row, as of `hex_shares`
/// @param rotation as of `hex_tiling` @default vec2(0) @unit degrees @ordered
/// @param period as of `hex_tiling` @default ivec2(0) @range 0 65536
/// @param seed as of `hex_tiling` @default 0
/// @param tile the hexagon
/// @param place the point, turned about the middle of the hexagon: where to look in a picture that
///   is not turned
void hex_frame(vec2 uv, vec2 cells, ivec2 node, vec2 rotation, const ivec2 period, int seed,
               out Tile tile, out vec2 place) {
  vec2 middle = vec2(float(node.x) + 0.5 * float(node.y & 1), float(node.y)) / cells;
  vec2 from = uv - middle;
  tile.cell = node;
  if (period.x > 0) {
    tile.cell.x = wrap_cell(tile.cell.x, period.x);
  }
  if (period.y > 0) {
    // An even number, since every second row is moved.
    tile.cell.y = wrap_cell(tile.cell.y, period.y + (period.y & 1));
  }
  tile.seed = hash(tile.cell, uint(seed));
  float angle = radians(mix(rotation.x, rotation.y, random(tile.seed, -2)));
  float c = cos(angle);
  float s = sin(angle);
  vec2 arm = c * from + s * vec2(from.y, -from.x);
  vec2 home = vec2(float(tile.cell.x) + 0.5 * float(tile.cell.y & 1), float(tile.cell.y)) / cells;
  place = home + arm;
  tile.size = vec2(1.0, 4.0 / 3.0) / cells;
  tile.local = arm / tile.size + 0.5;
  tile.right = vec2(c, s);
  tile.up = vec2(-s, c);
  tile.pitch = vec2(0.0);
  tile.smallest = vec2(0.0);
  tile.largest = tile.size;
  tile.drift = vec2(0.0);
  tile.tilt = vec2(1.0);
}
