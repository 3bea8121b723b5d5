// SPDX-License-Identifier: Apache-2.0
/// A random number for each tile, evenly spread between two values.
/// @param tile the tile
/// @param low the least value @default 0
/// @param high the greatest value @default 1
/// @param stream blocks with different streams draw different numbers for the same tile @default 0
float tile_random(Tile tile, float low, float high, int stream) {
  return mix(low, high, random(tile.seed, stream));
}
