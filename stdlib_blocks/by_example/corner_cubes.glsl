// SPDX-License-Identifier: Apache-2.0
/// Fills space with a texture like a small solid sample, without a period: each corner of a grid
/// draws a colour, and each cube is the one that has these colours at its corners. Cubes with the
/// same colours at a face go on into each other there. It takes one look-up. Textures with the key
/// `cubes` are such sets, made of a sample by the compiler. From far away, where a cube is no larger
/// than a pixel, it is the mean of the set.
/// @source after Lagae and Dutré, An Alternative for Wang Tiles: Colored Edges versus Colored
///   Corners, 2006, with cubes for tiles; see `corner_cube_place` for the packing
/// @param cubes the pack of cubes
/// @param position where in space @default position
/// @param tiling how many cubes for each unit of the position @default vec3(8)
/// @param colors how many colours corners have; of a texture with the key `cubes` they are known
///   @colors_of cubes @range 2 3
/// @param period after how many cubes space repeats, along x, y and z; 0 never @default ivec3(0)
///   @range 0 65536
/// @param seed another seed gives another space @default 0
/// @param color the texture, straight alpha
/// @param tile the cube, for whatever else shall vary with it
/// @param index which cube of the set it is: its place in the pack, as column + row * columns +
///   layer * columns * rows
void corner_cubes(sampler3D cubes, vec3 position, vec3 tiling, const int colors,
                  const ivec3 period, int seed, out vec4 color, out Tile3 tile, out int index) {
  vec3 p = position * tiling;
  vec3 local = p - floor(p);
  ivec3 cell = ivec3(floor(p));
  ivec3 next = cell + 1;
  if (period.x > 0) {
    cell.x = wrap_cell(cell.x, period.x);
    next.x = wrap_cell(next.x, period.x);
  }
  if (period.y > 0) {
    cell.y = wrap_cell(cell.y, period.y);
    next.y = wrap_cell(next.y, period.y);
  }
  if (period.z > 0) {
    cell.z = wrap_cell(cell.z, period.z);
    next.z = wrap_cell(next.z, period.z);
  }
  uvec2 slices = hash(uvec2(cell.z, next.z) + hash(uint(seed)));
  uvec4 rows = hash(uvec4(cell.y, next.y, cell.y, next.y) + slices.xxyy);
  uvec4 columns = uvec4(cell.x, next.x, cell.x, next.x);
  uvec4 below = hash(columns + rows.xxyy);
  uvec4 above = hash(columns + rows.zzww);
  ivec3 place =
      corner_cube_place(ivec4(below % uint(colors)), ivec4(above % uint(colors)), colors);
  const int count = colors * colors;
  color = texture(cubes, (vec3(place) + local) / vec3(ivec3(count, count, count * count)));
  tile.cell = cell;
  tile.local = local;
  tile.size = 1.0 / tiling;
  tile.seed = hash(below.x);
  tile.right = vec3(1.0, 0.0, 0.0);
  tile.up = vec3(0.0, 1.0, 0.0);
  tile.toward = vec3(0.0, 0.0, 1.0);
  index = place.x + (place.y + place.z * count) * count;
}
