// SPDX-License-Identifier: Apache-2.0
/// The area that a tile takes where areas of many tiles dissolve into each other: one of the four
/// whose middles are around the tile's, as often as bilinear interpolation would weigh it.
/// `dithered_areas_map` and `virtual_areas_map` look up what this area has. In x and y two random
/// numbers decide, of 16 bits each.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Dithered
///   Areas Map
/// @param cell column and row of the tile
/// @param seed the tile's random bits
/// @param cells columns and rows of the tile map, which repeats @range 1 1048576
/// @param tiles how many tiles an area has, across and up @range 1 1048576
/// @param stream blocks with different streams dither independently @default 1
/// @return column and row of the area, from -1 to one beyond the last
ivec2 dithered_area(ivec2 cell, uint seed, ivec2 cells, ivec2 tiles, const int stream) {
  ivec2 area = 2 * tiles;
  // In half tiles, from the middle of the area before the first one on, so that nothing is below 0.
  ivec2 middle = 2 * wrap_cell(cell, cells) + tiles + 1;
  ivec2 last = middle / area;
  ivec2 share = middle % area;
  uint bits = hash(seed + uint(stream));
  uvec2 numbers = uvec2(bits & 65535u, bits >> 16u);
  // numbers * area / 65536; the product alone is too large for areas of more than 32768 tiles.
  uvec2 luck = numbers * uvec2(area >> 16) + (numbers * uvec2(area & 65535) >> 16u);
  return last - ivec2(greaterThanEqual(ivec2(luck), share));
}

/// Of a line one random number decides, in space three.
/// @param cell which cell
/// @param seed the cell's random bits
/// @param cells how many cells the tile map has @range 1 1048576
/// @param tiles how many cells an area has @range 1 1048576
/// @param stream blocks with different streams dither independently @default 1
int dithered_area(int cell, uint seed, int cells, int tiles, const int stream) {
  int area = 2 * tiles;
  int middle = 2 * wrap_cell(cell, cells) + tiles + 1;
  uint number = hash(seed + uint(stream)) >> 16u;
  uint luck = number * uint(area >> 16) + (number * uint(area & 65535) >> 16u);
  return middle / area - int(int(luck) >= middle % area);
}

/// @param cell column, row and slice
/// @param seed the cell's random bits
/// @param cells columns, rows and slices of the tile map @range 1 1048576
/// @param tiles how many cells an area has in each direction @range 1 1048576
/// @param stream blocks with different streams dither independently @default 1
ivec3 dithered_area(ivec3 cell, uint seed, ivec3 cells, ivec3 tiles, const int stream) {
  ivec3 area = 2 * tiles;
  ivec3 middle = 2 * wrap_cell(cell, cells) + tiles + 1;
  uint bits = hash(seed + uint(stream));
  uvec3 numbers = uvec3(bits & 65535u, bits >> 16u, hash(bits) >> 16u);
  uvec3 luck = numbers * uvec3(area >> 16) + (numbers * uvec3(area & 65535) >> 16u);
  return middle / area - ivec3(greaterThanEqual(ivec3(luck), middle % area));
}
