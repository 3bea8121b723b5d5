// SPDX-License-Identifier: Apache-2.0
/// The pattern that a painted map has for a tile: a texel a cell.
/// The map's whole numbers are read as they are. The paper encodes number i of M as i / M and takes
/// floor(M r), which rounding can make i - 1. The map repeats where the grid has more cells; below
/// 0 as well.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Explicit
///   Indirection Map, and section 3.6, Encoding maps as textures
/// @param map numbers of patterns, in the first channel; the row v = 0 is that of the cells of row
///   0
/// @param tile the tile
/// @return the number in the map, -1 for nothing @one_of map
int explicit_indirection_map(sampler2D map, Tile tile) {
  return int(texelFetch(map, wrap_cell(tile.cell, textureSize(map, 0)), 0).r);
}

/// Of a line the map is the row v = 0 of a texture, in space it is a volume.
/// @param map numbers of patterns, in the first channel
/// @param tile the tile
int explicit_indirection_map(sampler2D map, Tile1 tile) {
  return int(texelFetch(map, ivec2(wrap_cell(tile.cell, textureSize(map, 0).x), 0), 0).r);
}

/// @param map numbers of patterns, in the first channel
/// @param tile the tile
int explicit_indirection_map(sampler3D map, Tile3 tile) {
  return int(texelFetch(map, wrap_cell(tile.cell, textureSize(map, 0)), 0).r);
}
