// SPDX-License-Identifier: Apache-2.0
/// Divides the surface into equal cells: every point learns in which cell it lies, where in it, and
/// random bits that are the cell's own.
/// The random bits are `cell_hash` of the cell.
/// @source Lefebvre and Neyret, Pattern Based Procedural Textures, 2003, section 3.2, Virtual Tile
///   Map; below 0 the paper's remainder has to be a floored one
/// @param uv coordinate @default uv
/// @param cells how many cells each unit of the coordinate has, across and up; below 1 it counts as
///   1 @default ivec2(8) @range 1 1048576
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the cells repeat with each unit of the coordinate, as the paper's do;
///   else their random bits go on without end @default false
/// @param neighbour the cell that many columns and rows further is given, instead of the one that
///   the point is in @default neighbour
/// @param tile the cell
void virtual_tile_map(vec2 uv, ivec2 cells, int seed, const bool toroidal, ivec2 neighbour,
                      out Tile tile) {
  ivec2 count = max(cells, 1);
  vec2 p = uv * vec2(count);
  vec2 corner = floor(p) + vec2(neighbour);
  ivec2 cell = ivec2(corner);
  if (toroidal) {
    cell = wrap_cell(cell, count);
  }
  tile.cell = cell;
  tile.local = p - corner;
  tile.size = 1.0 / vec2(count);
  tile.seed = cell_hash(cell, seed);
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  tile.pitch = tile.size;
  tile.smallest = tile.size;
  tile.largest = tile.size;
  tile.drift = vec2(0.0);
  tile.tilt = vec2(1.0, 0.0);
}

/// Of a line there are cells side by side, in space there are boxes; for patterns that are lines or
/// volumes.
/// @param uv coordinate
/// @param cells how many cells each unit of the coordinate has; below 1 it counts as 1 @default 8
///   @range 1 1048576
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the cells repeat with each unit of the coordinate @default false
/// @param tile the cell
void virtual_tile_map(float uv, int cells, int seed, const bool toroidal, out Tile1 tile) {
  int count = max(cells, 1);
  float p = uv * float(count);
  float corner = floor(p);
  int cell = int(corner);
  if (toroidal) {
    cell = wrap_cell(cell, count);
  }
  tile.cell = cell;
  tile.local = p - corner;
  tile.size = 1.0 / float(count);
  tile.seed = cell_hash(cell, seed);
}

/// @param uv coordinate
/// @param cells how many cells each unit of the coordinate has, across, up and away; below 1 it
///   counts as 1 @default ivec3(8) @range 1 1048576
/// @param seed another seed gives other random bits @default 0
/// @param toroidal whether the cells repeat with each unit of the coordinate @default false
/// @param tile the cell
void virtual_tile_map(vec3 uv, ivec3 cells, int seed, const bool toroidal, out Tile3 tile) {
  ivec3 count = max(cells, 1);
  vec3 p = uv * vec3(count);
  vec3 corner = floor(p);
  ivec3 cell = ivec3(corner);
  if (toroidal) {
    cell = wrap_cell(cell, count);
  }
  tile.cell = cell;
  tile.local = p - corner;
  tile.size = 1.0 / vec3(count);
  tile.seed = cell_hash(cell, seed);
  tile.right = vec3(1.0, 0.0, 0.0);
  tile.up = vec3(0.0, 1.0, 0.0);
  tile.toward = vec3(0.0, 0.0, 1.0);
}
