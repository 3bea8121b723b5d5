// SPDX-License-Identifier: Apache-2.0
/// Covers a surface with the tiles that a map says, each cell of the map with one: a tiling that
/// was made before (a texture with the key `tiling`), or painted. Reading the map takes one more
/// look-up than `corner_tiles` and `wang_tiles`, and no hash. The map repeats.
/// @source Wei, Tile-Based Texture Mapping on Graphics Hardware, 2004, section 5, the precomputed
///   index texture
/// @param tiles the pack of tiles, of corners or of edges
/// @param map for each cell the number of a tile: its column and row in the pack, as column + row *
///   columns. Beyond the last it is the last, below 0 there is none: transparent black
/// @param uv coordinate @default uv
/// @param tiling how many tiles for each unit of the coordinate @default vec2(8)
/// @param pack columns and rows of tiles; of a texture with the key `tiles` they are known
///   @grid_of tiles @range 1 4096
/// @param color the texture, straight alpha
/// @param tile the tile, for whatever else shall vary with it
/// @param index the number from the map
void tile_map(sampler2D tiles, sampler2D map, vec2 uv, vec2 tiling, const ivec2 pack,
              out vec4 color, out Tile tile, out int index) {
  vec2 p = uv * tiling;
  vec2 local = p - floor(p);
  ivec2 cell = wrap_cell(ivec2(floor(p)), textureSize(map, 0));
  index = int(texelFetch(map, cell, 0).x);
  int which = clamp(index, 0, pack.x * pack.y - 1);
  vec2 place = pack_place(tiles, ivec2(which % pack.x, which / pack.x), local, pack, true);
  vec4 seen = texture(tiles, place);
  color = index < 0 ? vec4(0.0) : seen;
  tile.cell = cell;
  tile.local = local;
  tile.size = 1.0 / tiling;
  tile.seed = hash(cell, 0u);
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  tile.pitch = tile.size;
  tile.smallest = tile.size;
  tile.largest = tile.size;
  tile.drift = vec2(0.0);
  tile.tilt = vec2(1.0);
}
