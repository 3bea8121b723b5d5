// SPDX-License-Identifier: Apache-2.0
// Four times 16 bits, of two hashes.
vec4 four_numbers(uint seed) {
  uint first = hash(seed);
  uint second = hash(first);
  return vec4(first & 65535u, first >> 16u, second & 65535u, second >> 16u) * 0.0000152587890625;
}

// Where the numbers of a stream come from in the table: far away from each other.
int far_away(const int stream, const int component) {
  return int(hash(4u * uint(stream) + uint(component)) >> 8u);
}

/// Four random numbers for each tile, at least 0 and below 1, for whatever varies from tile to
/// tile: places, sizes, angles, phases.
/// With `hash` they come in steps of 1/65536, with `permutation` in steps of 1/256 and whatever the
/// seed of the tile map; see `cell_permutation`. To choose one of n things take
/// `virtual_indirection_map`: the paper warns of its own numbers there, whose steps fall on n
/// things unevenly.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Virtual
///   Random Map
/// @param tile the tile
/// @param stream blocks with different streams draw different numbers @default 0
/// @param randomness hash, an integer hash of the cell; permutation, the paper's table
///   @default RANDOMNESS_HASH
vec4 virtual_random_map(Tile tile, const int stream, const int randomness) {
  if (randomness == RANDOMNESS_PERMUTATION) {
    return vec4(cell_permutation(tile.cell + far_away(stream, 0)),
                cell_permutation(tile.cell + far_away(stream, 1)),
                cell_permutation(tile.cell + far_away(stream, 2)),
                cell_permutation(tile.cell + far_away(stream, 3))) * 0.00390625;
  }
  return four_numbers(tile.seed + uint(stream));
}

/// @param tile the cell of a line
/// @param stream blocks with different streams draw different numbers @default 0
/// @param randomness hash, an integer hash of the cell; permutation, the paper's table
///   @default RANDOMNESS_HASH
vec4 virtual_random_map(Tile1 tile, const int stream, const int randomness) {
  if (randomness == RANDOMNESS_PERMUTATION) {
    return vec4(cell_permutation(tile.cell + far_away(stream, 0)),
                cell_permutation(tile.cell + far_away(stream, 1)),
                cell_permutation(tile.cell + far_away(stream, 2)),
                cell_permutation(tile.cell + far_away(stream, 3))) * 0.00390625;
  }
  return four_numbers(tile.seed + uint(stream));
}

/// @param tile the cell in space
/// @param stream blocks with different streams draw different numbers @default 0
/// @param randomness hash, an integer hash of the cell; permutation, the paper's table
///   @default RANDOMNESS_HASH
vec4 virtual_random_map(Tile3 tile, const int stream, const int randomness) {
  if (randomness == RANDOMNESS_PERMUTATION) {
    return vec4(cell_permutation(tile.cell + far_away(stream, 0)),
                cell_permutation(tile.cell + far_away(stream, 1)),
                cell_permutation(tile.cell + far_away(stream, 2)),
                cell_permutation(tile.cell + far_away(stream, 3))) * 0.00390625;
  }
  return four_numbers(tile.seed + uint(stream));
}
