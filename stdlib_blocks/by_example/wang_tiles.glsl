// SPDX-License-Identifier: Apache-2.0
/// Covers any surface with a texture like a small sample, without a period: each edge of a grid
/// draws a colour, and each tile is the one that has these colours on its edges, so that it goes on
/// into its neighbours. It takes one look-up. Textures with the key `tiles` and `edge_colors` are
/// such sets, made of a sample by the compiler. Around the corners the pack has other neighbours
/// than the tiling: a filter sees a little of them there, as it does not with `corner_tiles`.
/// @source Wei, Tile-Based Texture Mapping on Graphics Hardware, 2004, with an integer hash in
///   place of its permutations (equation 2), which repeat; tiles after Cohen, Shade, Hiller and
///   Deussen, Wang Tiles for Image and Texture Generation, 2003
/// @param tiles the tiles, in layers of 2 x 2 for each two colours of the edges that stand, even and
///   odd ones, and two of those that lie
/// @param colors how many colours edges have: those that lie, and those that stand; of a texture
///   with the key `tiles` they are known @colors_of tiles @range 1 4
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
void wang_tiles(sampler2DArray tiles, vec2 uv, vec2 tiling, const ivec2 colors, const ivec2 period,
                int seed, out vec4 color, out Tile tile, out int index) {
  vec2 p = uv * tiling;
  ivec2 cell = ivec2(floor(p));
  ivec2 next = cell + 1;
  bvec2 is_odd = equal(cell & 1, ivec2(1));
  if (period.x > 0) {
    cell.x = wrap_cell(cell.x, period.x);
    next.x = wrap_cell(next.x, period.x);
  }
  if (period.y > 0) {
    cell.y = wrap_cell(cell.y, period.y);
    next.y = wrap_cell(next.y, period.y);
  }
  // The bits of a cell have the colours of its south and west edge.
  uvec2 rows = hash(uvec2(cell.y, next.y) + hash(uint(seed)));
  uvec3 own = uvec3(hash(uvec2(cell.x, next.x) + rows.x), hash(uint(cell.x) + rows.y));
  ivec2 across = ivec2((own.xy >> 16u) % uint(colors.y));
  ivec2 upwards = ivec2((own.xz & 65535u) % uint(colors.x));
  // Of the edges that stand, and of those that lie, one is even and one is odd.
  ivec2 stand = is_odd.x ? across.yx : across;
  ivec2 lie = is_odd.y ? upwards.yx : upwards;
  int layer = stand.x + colors.y * (stand.y + colors.y * (lie.x + colors.x * lie.y));
  // The layer repeats after two tiles: the place in it goes on from tile to tile.
  vec2 place = p * 0.5;
  color = texture(tiles, vec3(place - floor(place), layer));
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
  index = tile_index(across.x, across.y) +
          tile_index(upwards.x, upwards.y) * colors.y * colors.y;
}

/// All tiles in one picture take a quarter of the memory, but the place in it jumps from tile to
/// tile: the shader has to say how large a pixel is there, which takes half as long again.
/// @param tiles the pack of tiles
/// @param colors how many colours edges have: those that lie, and those that stand; of a texture
///   with the key `tiles` they are known @colors_of tiles @range 1 4
/// @param uv coordinate @default uv
/// @param tiling how many tiles for each unit of the coordinate @default vec2(8)
/// @param period after how many tiles the plane repeats, across and up; 0 never @default ivec2(0)
///   @range 0 65536
/// @param seed another seed gives another plane. It may differ from place to place, if all of a
///   tile and its neighbours have the same one, or a seam does not matter @default 0
void wang_tiles(sampler2D tiles, vec2 uv, vec2 tiling, const ivec2 colors, const ivec2 period,
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
  // The bits of a cell have the colours of its south and west edge.
  uvec2 rows = hash(uvec2(cell.y, next.y) + hash(uint(seed)));
  uvec3 bits = uvec3(hash(uvec2(cell.x, next.x) + rows.x), hash(uint(cell.x) + rows.y));
  ivec2 across = ivec2((bits.xy >> 16u) % uint(colors.y));
  ivec2 upwards = ivec2((bits.xz & 65535u) % uint(colors.x));
  ivec2 place = ivec2(tile_index(across.x, across.y), tile_index(upwards.x, upwards.y));
  const ivec2 pack = ivec2(colors.y * colors.y, colors.x * colors.x);
  color = texture(tiles, pack_place(tiles, place, local, pack, false));
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
  index = place.x + place.y * pack.x;
}
