// SPDX-License-Identifier: Apache-2.0
/// What a computed map has for a tile: an areas map whose numbers are drawn by nodes of the graph.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Areas Map,
///   explicit or virtual, and Dithered Areas Map
/// @param area the number of an area: from its middle, or its column and row
/// @param tile the tile
/// @param cells columns and rows of the tile map; multiples of the areas' @range 1 1048576
/// @param areas columns and rows of areas in a unit of the coordinate; they repeat with it
///   @default ivec2(8) @range 1 1048576
/// @param dithered whether borders dissolve, as those of `dithered_areas_map` @default false
/// @param stream as of `dithered_areas_map` @default 1
/// @return the number of the tile's area @one_of area
int area(vec2 uv, ivec2 cell);

int virtual_areas_map(Tile tile, const ivec2 cells, const ivec2 areas, const bool dithered,
                      const int stream) {
  ivec2 tiles = max(cells / areas, 1);
  ivec2 found;
  if (dithered) {
    found = wrap_cell(dithered_area(tile.cell, tile.seed, cells, tiles, stream), areas);
  } else {
    found = min(wrap_cell(tile.cell, cells) / tiles, areas - 1);
  }
  return area((vec2(found) + 0.5) / vec2(areas), found);
}
