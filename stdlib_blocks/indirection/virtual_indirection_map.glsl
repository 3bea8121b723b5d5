// SPDX-License-Identifier: Apache-2.0
// The 16 upper bits times the count, shifted down: evenly, to 1 in 65536.
int pick(uint bits, const int patterns) { return int((bits >> 16u) * uint(patterns) >> 16u); }

// Far cells have nothing to do with each other; the paper's way to several random numbers.
int far_away(const int stream) { return stream == 0 ? 0 : int(hash(uint(stream)) >> 8u); }

/// A random pattern for each tile, every pattern equally often, with nothing that repeats.
/// With `hash` the pattern is drawn independently for each tile. With `permutation` it follows from
/// the paper's table, whatever the seed of the tile map: see `cell_permutation`. Its 256 numbers
/// fall on the patterns evenly where their count divides 256; there should be no more than that.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Virtual
///   Indirection Map. The paper's table is too even for chance and has periods; hence the hash
/// @param tile the tile
/// @param patterns how many patterns there are @default 16 @range 1 65536
/// @param stream blocks with different streams choose independently @default 0
/// @param randomness hash, an integer hash of the cell; permutation, the paper's table
///   @default RANDOMNESS_HASH
/// @return from 0 to patterns - 1 @one_of patterns
int virtual_indirection_map(Tile tile, const int patterns, const int stream,
                            const int randomness) {
  if (randomness == RANDOMNESS_PERMUTATION) {
    return int(cell_permutation(tile.cell + far_away(stream)) * uint(patterns) >> 8u);
  }
  // The first stream takes the tile's own bits, which nobody else takes from above.
  return pick(stream == 0 ? tile.seed : hash(tile.seed + uint(stream)), patterns);
}

/// @param tile the cell of a line
/// @param patterns how many patterns there are @default 16 @range 1 65536
/// @param stream blocks with different streams choose independently @default 0
/// @param randomness hash, an integer hash of the cell; permutation, the paper's table
///   @default RANDOMNESS_HASH
int virtual_indirection_map(Tile1 tile, const int patterns, const int stream,
                            const int randomness) {
  if (randomness == RANDOMNESS_PERMUTATION) {
    return int(cell_permutation(tile.cell + far_away(stream)) * uint(patterns) >> 8u);
  }
  return pick(stream == 0 ? tile.seed : hash(tile.seed + uint(stream)), patterns);
}

/// @param tile the cell in space
/// @param patterns how many patterns there are @default 16 @range 1 65536
/// @param stream blocks with different streams choose independently @default 0
/// @param randomness hash, an integer hash of the cell; permutation, the paper's table
///   @default RANDOMNESS_HASH
int virtual_indirection_map(Tile3 tile, const int patterns, const int stream,
                            const int randomness) {
  if (randomness == RANDOMNESS_PERMUTATION) {
    return int(cell_permutation(tile.cell + far_away(stream)) * uint(patterns) >> 8u);
  }
  return pick(stream == 0 ? tile.seed : hash(tile.seed + uint(stream)), patterns);
}
