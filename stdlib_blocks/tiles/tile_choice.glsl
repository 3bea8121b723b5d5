// SPDX-License-Identifier: Apache-2.0
/// A random whole number for each tile: which of several things it gets.
/// The upper 16 bits of a hash times the count, shifted down: every number comes up equally often,
/// to 1 in 65536.
/// @param tile the tile
/// @param count how many things there are @default 2 @range 1 65536
/// @param stream blocks with different streams choose independently @default 0
int tile_choice(Tile tile, int count, int stream) {
  return int((hash(tile.seed + uint(stream)) >> 16u) * uint(count) >> 16u);
}

/// @param tile the cell in space
/// @param count how many things there are @default 2 @range 1 65536
/// @param stream blocks with different streams choose independently @default 0
int tile_choice(Tile3 tile, int count, int stream) {
  return int((hash(tile.seed + uint(stream)) >> 16u) * uint(count) >> 16u);
}
