// SPDX-License-Identifier: Apache-2.0
/// A random number for each tile, evenly spread between two values.
/// A number that colours are multiplied by is better `filtered`: where a pixel holds many tiles it
/// is then their mean, half way between the two, and nothing shimmers; see `tile_near`. A number
/// that goes through a threshold or a gradient is not, for what these make of the mean is not the
/// mean of what they make.
/// @param tile the tile
/// @param low the least value @default 0
/// @param high the greatest value @default 1
/// @param stream blocks with different streams draw different numbers for the same tile @default 0
/// @param filtered whether it goes to its mean where a pixel holds many tiles @default false
float tile_random(Tile tile, float low, float high, int stream, const bool filtered) {
  float luck = random(tile.seed, stream);
  return mix(low, high, filtered ? mix(0.5, luck, tile_near(tile)) : luck);
}

/// @param tile the cell in space
/// @param low the least value @default 0
/// @param high the greatest value @default 1
/// @param stream blocks with different streams draw different numbers for the same tile @default 0
/// @param filtered whether it goes to its mean where a pixel holds many tiles @default false
float tile_random(Tile3 tile, float low, float high, int stream, const bool filtered) {
  float luck = random(tile.seed, stream);
  return mix(low, high, filtered ? mix(0.5, luck, tile_near(tile)) : luck);
}
