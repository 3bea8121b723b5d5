// SPDX-License-Identifier: Apache-2.0
/// Covers any surface with a texture like a small sample, without a period: each corner of a grid
/// draws a colour, and each tile is the one that has these colours at its corners. Tiles with the
/// same colour at a corner go on into each other there. It takes one look-up. Textures with the key
/// `tiles` are such sets, made of a sample by the compiler. From far away, where a tile is no
/// larger than a pixel, it is the mean of the set.
/// @source Lagae and Dutré, An Alternative for Wang Tiles: Colored Edges versus Colored Corners,
///   2006; Wei, Tile-Based Texture Mapping on Graphics Hardware, 2004, for the packing, with an
///   integer hash in place of its permutations, which repeat
/// @param tiles the tiles, in layers of 2 x 2 for each four colours of the corners that are even in
///   both directions, odd across, odd up, odd in both
/// @param colors how many colours corners have; of a texture with the key `tiles` they are known
///   @colors_of tiles @range 2 4
/// @param uv coordinate @default uv
/// @param tiling how many tiles for each unit of the coordinate @default vec2(8)
/// @param period after how many tiles the plane repeats, across and up; 0 never @default ivec2(0)
///   @range 0 65536
/// @param seed another seed gives another plane. It may differ from place to place, if all of a
///   tile and its neighbours have the same one, or a seam does not matter @default 0
/// @param color the texture, straight alpha
/// @param tile the tile, for whatever else shall vary with it
/// @param index which tile of the set it is: its column and row in the pack, as column + row *
///   columns
void corner_tiles(sampler2DArray tiles, vec2 uv, vec2 tiling, const int colors,
                  const ivec2 period, int seed, out vec4 color, out Tile tile, out int index) {
  vec2 p = uv * tiling;
  ivec2 cell = ivec2(floor(p));
  // Of the corners of the tile, in each direction one is even and one is odd.
  ivec2 even = (cell + 1) & ivec2(-2);
  ivec2 odd = cell | 1;
  if (period.x > 0) {
    cell.x = wrap_cell(cell.x, period.x);
    even.x = wrap_cell(even.x, period.x);
    odd.x = wrap_cell(odd.x, period.x);
  }
  if (period.y > 0) {
    cell.y = wrap_cell(cell.y, period.y);
    even.y = wrap_cell(even.y, period.y);
    odd.y = wrap_cell(odd.y, period.y);
  }
  uvec2 rows = hash(uvec2(even.y, odd.y) + hash(uint(seed)));
  uvec4 bits = hash(uvec4(even.x, odd.x, even.x, odd.x) + rows.xxyy);
  ivec4 around = ivec4(bits % uint(colors));
  int layer = around.x + colors * (around.y + colors * (around.z + colors * around.w));
  // The layer repeats after two tiles: the place in it goes on from tile to tile.
  vec2 place = p * 0.5;
  color = texture(tiles, vec3(place - floor(place), layer));
  // From the tile's own left bottom corner.
  uvec4 own = cell.x == even.x ? bits : bits.yxwz;
  if (cell.y != even.y) own = own.zwxy;
  tile.cell = cell;
  tile.local = p - floor(p);
  tile.size = 1.0 / tiling;
  tile.seed = hash(own.x);
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  tile.pitch = tile.size;
  tile.smallest = tile.size;
  tile.largest = tile.size;
  tile.drift = vec2(0.0);
  tile.tilt = vec2(1.0);
  ivec2 at = corner_tile_place(ivec4(own % uint(colors)), colors);
  index = at.x + at.y * colors * colors;
}

/// All tiles in one picture take a quarter of the memory, but the place in it jumps from tile to
/// tile: the shader has to say how large a pixel is there, which takes half as long again.
/// @param tiles the pack of tiles
/// @param colors how many colours corners have; of a texture with the key `tiles` they are known
///   @colors_of tiles @range 2 4
/// @param uv coordinate @default uv
/// @param tiling how many tiles for each unit of the coordinate @default vec2(8)
/// @param period after how many tiles the plane repeats, across and up; 0 never @default ivec2(0)
///   @range 0 65536
/// @param seed another seed gives another plane. It may differ from place to place, if all of a
///   tile and its neighbours have the same one, or a seam does not matter @default 0
void corner_tiles(sampler2D tiles, vec2 uv, vec2 tiling, const int colors, const ivec2 period,
                  int seed, out vec4 color, out Tile tile, out int index) {
  vec2 p = uv * tiling;
  vec2 local = p - floor(p);
  ivec2 cell = ivec2(floor(p));
  ivec2 next = cell + 1;
  if (period.x > 0) {
    cell.x = wrap_cell(cell.x, period.x);
    next.x = wrap_cell(next.x, period.x);
  }
  if (period.y > 0) {
    cell.y = wrap_cell(cell.y, period.y);
    next.y = wrap_cell(next.y, period.y);
  }
  uvec2 rows = hash(uvec2(cell.y, next.y) + hash(uint(seed)));
  uvec4 bits = hash(uvec4(cell.x, next.x, cell.x, next.x) + rows.xxyy);
  ivec2 place = corner_tile_place(ivec4(bits % uint(colors)), colors);
  const int count = colors * colors;
  color = texture(tiles, pack_place(tiles, place, local, ivec2(count), colors == 4));
  tile.cell = cell;
  tile.local = local;
  tile.size = 1.0 / tiling;
  tile.seed = hash(bits.x);
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  tile.pitch = tile.size;
  tile.smallest = tile.size;
  tile.largest = tile.size;
  tile.drift = vec2(0.0);
  tile.tilt = vec2(1.0);
  index = place.x + place.y * count;
}
