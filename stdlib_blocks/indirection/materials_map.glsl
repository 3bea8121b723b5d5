// SPDX-License-Identifier: Apache-2.0
// The number at a place that is drawn by 16 random bits.
int drawn(sampler2D lists, int material, uint seed, const int stream) {
  ivec2 size = textureSize(lists, 0);
  // The first stream takes the tile's own bits, which nobody else takes from above.
  uint bits = stream == 0 ? seed : hash(seed + uint(stream));
  int place = int((bits >> 16u) * uint(size.x) >> 16u);
  int row = clamp(material, 0, size.y - 1);
  int pattern = int(texelFetch(lists, ivec2(place, row), 0).r);
  return material < 0 ? -1 : pattern;
}

/// A random pattern of a material: a material is a list of patterns, in which frequent ones stand
/// several times.
/// In a list of P numbers, one that stands there n times has the probability n / P, to 1 in 65536.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Materials Map
/// @param lists a material a row, from the row v = 0, in the first channel
/// @param material which material, from 0; below 0 there is none, and the result is -1. Beyond the
///   last it is the last @below lists
/// @param tile the tile
/// @param stream blocks with different streams choose independently @default 0
/// @return a pattern, or -1 for nothing @one_of lists
int materials_map(sampler2D lists, int material, Tile tile, const int stream) {
  return drawn(lists, material, tile.seed, stream);
}

/// @param lists a material a row
/// @param material which material, from 0; below 0 there is none @below lists
/// @param tile the cell of a line
/// @param stream blocks with different streams choose independently @default 0
int materials_map(sampler2D lists, int material, Tile1 tile, const int stream) {
  return drawn(lists, material, tile.seed, stream);
}

/// @param lists a material a row
/// @param material which material, from 0; below 0 there is none @below lists
/// @param tile the cell in space
/// @param stream blocks with different streams choose independently @default 0
int materials_map(sampler2D lists, int material, Tile3 tile, const int stream) {
  return drawn(lists, material, tile.seed, stream);
}
