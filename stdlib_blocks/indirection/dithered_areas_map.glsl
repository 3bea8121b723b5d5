// SPDX-License-Identifier: Apache-2.0
/// What a rough painted map has for a tile, with borders that dissolve: near a border some of the
/// tiles take what the next area has.
/// Each tile takes one of the four areas whose middles are around its own middle, as often as
/// bilinear interpolation would weigh it; so the mean over many tiles is that of a smooth map. A
/// tile is of one material throughout: the paper's weights, taken for the pixel, would cut tiles.
/// In x and y two random numbers decide. With a single one, as in the paper's figure 8, two of the
/// four areas would never come up in the middle. The neighbour is picked first and the map read
/// once.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Dithered
///   Areas Map; which lets open that the map's numbers are those of the areas' middles
/// @param areas numbers of materials, in the first channel; the row v = 0 is the lowest. The map
///   covers one unit of the coordinate, and repeats
/// @param tile the tile
/// @param cells columns and rows of the tile map: multiples of the map's @multiple_of areas
///   @range 1 1048576
/// @param stream blocks with different streams dither independently; maps that are to dissolve
///   alike have the same @default 1
/// @return the number in the map, -1 for nothing @one_of areas
int dithered_areas_map(sampler2D areas, Tile tile, const ivec2 cells, const int stream) {
  ivec2 size = textureSize(areas, 0);
  ivec2 picked = dithered_area(tile.cell, tile.seed, cells, max(cells / size, 1), stream);
  return int(texelFetch(areas, wrap_cell(picked, size), 0).r);
}

/// Of a line the map is the row v = 0 of a texture, in space it is a volume.
/// @param areas numbers of materials, in the first channel
/// @param tile the cell of a line
/// @param cells how many cells the tile map has: a multiple of the map's @range 1 1048576
/// @param stream blocks with different streams dither independently @default 1
int dithered_areas_map(sampler2D areas, Tile1 tile, const int cells, const int stream) {
  int size = textureSize(areas, 0).x;
  int picked = dithered_area(tile.cell, tile.seed, cells, max(cells / size, 1), stream);
  return int(texelFetch(areas, ivec2(wrap_cell(picked, size), 0), 0).r);
}

/// @param areas numbers of materials, in the first channel
/// @param tile the cell in space
/// @param cells columns, rows and slices of the tile map: multiples of the map's @range 1 1048576
/// @param stream blocks with different streams dither independently @default 1
int dithered_areas_map(sampler3D areas, Tile3 tile, const ivec3 cells, const int stream) {
  ivec3 size = textureSize(areas, 0);
  ivec3 picked = dithered_area(tile.cell, tile.seed, cells, max(cells / size, 1), stream);
  return int(texelFetch(areas, wrap_cell(picked, size), 0).r);
}
