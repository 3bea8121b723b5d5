// SPDX-License-Identifier: Apache-2.0
int permuted(sampler2D table, int index, int size) {
  return int(texelFetch(table, ivec2(index % size, 0), 0).x);
}

/// Wang tiles as the paper has them: the colours of the edges come from a table of permuted
/// numbers, which is read six times. It is there to compare, and for machines that multiply
/// integers slowly. Standing edges repeat after half as many rows as the table has numbers, and
/// each of their rows is one sequence, moved along: `wang_tiles` has neither, and needs no table.
/// @source Wei, Tile-Based Texture Mapping on Graphics Hardware, 2004, equations 2 and 7
/// @param tiles the pack of tiles
/// @param table a texture with the key `permutation`: a row of numbers from 0 to below its width
/// @param colors how many colours edges have: those that lie, and those that stand; of a texture
///   with the key `tiles` they are known @colors_of tiles @range 1 4
/// @param uv coordinate @default uv
/// @param tiling how many tiles for each unit of the coordinate @default vec2(8)
/// @param period after how many tiles the plane repeats, across and up, the paper's M; 0: as many
///   as the table has numbers @default ivec2(0) @range 0 16384
/// @param color the texture, straight alpha
/// @param tile the tile, for whatever else shall vary with it
/// @param index which tile of the set it is: its column and row in the pack, as column + row *
///   columns
void permutation_wang_tiles(sampler2D tiles, sampler2D table, vec2 uv, vec2 tiling,
                            const ivec2 colors, const ivec2 period, out vec4 color,
                            out Tile tile, out int index) {
  vec2 p = uv * tiling;
  vec2 local = p - floor(p);
  int size = textureSize(table, 0).x;
  ivec2 every = ivec2(period.x > 0 ? period.x : size, period.y > 0 ? period.y : size);
  ivec2 cell = wrap_cell(ivec2(floor(p)), every);
  ivec2 next = wrap_cell(ivec2(floor(p)) + 1, every);
  // What both edges that lie have in common, and both that stand.
  int column = permuted(table, cell.x, size);
  int row = permuted(table, 2 * cell.y, size);
  int south = permuted(table, column + cell.y, size) % colors.x;
  int east = permuted(table, next.x + row, size) % colors.y;
  int north = permuted(table, column + next.y, size) % colors.x;
  int west = permuted(table, cell.x + row, size) % colors.y;
  ivec2 place = ivec2(tile_index(west, east), tile_index(south, north));
  const ivec2 pack = ivec2(colors.y * colors.y, colors.x * colors.x);
  color = texture(tiles, pack_place(tiles, place, local, pack, false));
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
  index = place.x + place.y * pack.x;
}
