// SPDX-License-Identifier: Apache-2.0
// The number that one random number chooses by the weights.
int choice(uint seed, vec4 weights, int stream) {
  vec2 first = vec2(weights.x, weights.x + weights.y);
  float third = first.y + weights.z;
  float place = random(seed, stream) * (third + weights.w);
  return int(place >= first.x) + int(place >= first.y) + int(place >= third);
}

/// A random number from 0 to 3 for each tile, some more often than others: which of four things it
/// gets.
/// Each number comes up as often as its weight says, compared with the sum of all; never if its
/// weight is 0. If all are 0, the last comes up.
/// @source the brick shader generator, section 3.1: elements that are chosen at random
/// @param tile the tile
/// @param weights how often 0, 1, 2 and 3 come up; at least 0 @default vec4(1)
/// @param stream blocks with different streams choose independently @default 0
int tile_weighted_choice(Tile tile, vec4 weights, int stream) {
  return choice(tile.seed, weights, stream);
}

/// @param tile the cell in space
/// @param weights how often 0, 1, 2 and 3 come up; at least 0 @default vec4(1)
/// @param stream blocks with different streams choose independently @default 0
int tile_weighted_choice(Tile3 tile, vec4 weights, int stream) {
  return choice(tile.seed, weights, stream);
}
