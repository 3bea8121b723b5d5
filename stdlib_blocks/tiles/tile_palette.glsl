// SPDX-License-Identifier: Apache-2.0
/// One of a few colours for each tile, each of them equally often.
/// It takes the upper 16 bits of the tile's seed as they are, without a hash: all palettes of a tile
/// choose the same number.
/// @param tile the tile
/// @param colors the colours, red, green and blue @length 1 256
vec3 tile_palette(Tile tile, const vec3 colors[]) {
  return colors[int((tile.seed >> 16u) * uint(colors.length()) >> 16u)];
}

/// @param tile the cell in space
/// @param colors the colours, red, green and blue @length 1 256
vec3 tile_palette(Tile3 tile, const vec3 colors[]) {
  return colors[int((tile.seed >> 16u) * uint(colors.length()) >> 16u)];
}
