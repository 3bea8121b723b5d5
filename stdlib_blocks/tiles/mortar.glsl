// SPDX-License-Identifier: Apache-2.0
// The integral from 0 to p of a wave of period 1 that is 1 from `joint` to 1 - `joint`, else 0.
vec2 brick_integral(vec2 p, vec2 joint) {
  vec2 turns = floor(p);
  return turns * (1.0 - 2.0 * joint) + clamp(p - turns - joint, vec2(0.0), 1.0 - 2.0 * joint);
}

/// The joints between tiles: 1 in the mortar, 0 on the bricks.
/// The joints are equally wide everywhere and in both directions, whatever the tiles' shape: half
/// of a joint belongs to each of the two tiles that it parts. Filtered analytically, exactly so for
/// a box as large as the pixel's footprint within a row of tiles; far away it is the share of the
/// surface that is mortar.
/// @param tile the tile
/// @param width width of a joint, in texture space; at most the tile's shorter side @default 0.01
///   @range 0 1
float mortar(Tile tile, float width) {
  vec2 joint = 0.5 * width / tile.size;
  vec2 pixel = max(footprint(tile.local), 1e-4);
  vec2 brick = (brick_integral(tile.local + 0.5 * pixel, joint) -
                brick_integral(tile.local - 0.5 * pixel, joint)) /
               pixel;
  return 1.0 - brick.x * brick.y;
}
