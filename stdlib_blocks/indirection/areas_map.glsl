// SPDX-License-Identifier: Apache-2.0
/// What a rough painted map has for a tile: which material to use where, a texel for many tiles.
/// The map covers one unit of the coordinate, and repeats. Each of its texels is an area of as many
/// whole tiles as all others.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Areas Map
/// @param areas numbers of materials, in the first channel; the row v = 0 is the lowest
/// @param tile the tile
/// @param cells columns and rows of the tile map: multiples of the map's @multiple_of areas
///   @range 1 1048576
/// @return the number in the map, -1 for nothing @one_of areas
int areas_map(sampler2D areas, Tile tile, const ivec2 cells) {
  ivec2 size = textureSize(areas, 0);
  ivec2 area = wrap_cell(tile.cell, cells) / max(cells / size, 1);
  return int(texelFetch(areas, min(area, size - 1), 0).r);
}

/// Of a line the map is the row v = 0 of a texture, in space it is a volume.
/// @param areas numbers of materials, in the first channel
/// @param tile the cell of a line
/// @param cells how many cells the tile map has: a multiple of the map's @range 1 1048576
int areas_map(sampler2D areas, Tile1 tile, const int cells) {
  int size = textureSize(areas, 0).x;
  int area = wrap_cell(tile.cell, cells) / max(cells / size, 1);
  return int(texelFetch(areas, ivec2(min(area, size - 1), 0), 0).r);
}

/// @param areas numbers of materials, in the first channel
/// @param tile the cell in space
/// @param cells columns, rows and slices of the tile map: multiples of the map's @range 1 1048576
int areas_map(sampler3D areas, Tile3 tile, const ivec3 cells) {
  ivec3 size = textureSize(areas, 0);
  ivec3 area = wrap_cell(tile.cell, cells) / max(cells / size, 1);
  return int(texelFetch(areas, min(area, size - 1), 0).r);
}
