// SPDX-License-Identifier: Apache-2.0
/// Where the middle of a tile's frame is, in texture space: the same for all points of the tile.
/// What is looked up there is one value for each tile.
/// @param tile the tile, as seen from `uv`
/// @param uv the coordinate that the tile's grid took @default uv
vec2 tile_center(Tile tile, vec2 uv) {
  vec2 from_middle = (tile.local - 0.5) * tile.size;
  return uv - tile.right * from_middle.x - tile.up * from_middle.y;
}

/// @param tile the cell in space, as seen from `uv`
/// @param uv the coordinate that the tile's grid took @default position
vec3 tile_center(Tile3 tile, vec3 uv) {
  vec3 from_middle = (tile.local - 0.5) * tile.size;
  return uv - tile.right * from_middle.x - tile.up * from_middle.y - tile.toward * from_middle.z;
}
