// SPDX-License-Identifier: Apache-2.0
/// A random colour for each tile, each channel evenly spread between those of two colours.
/// Where a pixel holds many tiles it is their mean, half way between the two; see `tile_near`.
/// @param tile the tile
/// @param low the least red, green and blue @default vec3(0)
/// @param high the greatest red, green and blue @default vec3(1)
/// @param stream blocks with different streams draw different colours for the same tile @default 0
vec3 tile_random_color(Tile tile, vec3 low, vec3 high, int stream) {
  return mix(low, high, mix(vec3(0.5), random3(tile.seed, stream), tile_near(tile)));
}

/// @param tile the cell in space
/// @param low the least red, green and blue @default vec3(0)
/// @param high the greatest red, green and blue @default vec3(1)
/// @param stream blocks with different streams draw different colours for the same tile @default 0
vec3 tile_random_color(Tile3 tile, vec3 low, vec3 high, int stream) {
  return mix(low, high, mix(vec3(0.5), random3(tile.seed, stream), tile_near(tile)));
}
