// SPDX-License-Identifier: Apache-2.0
/// Brings a normal from a tile's frame to texture space: turns and mirrors it as the tile is.
/// For what is drawn with a tile's `local`, bricks that stand or lie, say. `material_layer` does it
/// by itself. A relief that is stretched or scaled with its frame keeps its slopes.
/// @param normal in the frame: x along local x, y along local y, z out of the surface
/// @param tile whose frame it is
vec3 turn_normal(vec3 normal, Tile tile) {
  return vec3(normal.x * tile.right + normal.y * tile.up, normal.z);
}

/// Of a body in space all of the direction turns.
/// @param normal in the frame, along its three axes
/// @param tile whose frame it is
vec3 turn_normal(vec3 normal, Tile3 tile) {
  return normal.x * tile.right + normal.y * tile.up + normal.z * tile.toward;
}
