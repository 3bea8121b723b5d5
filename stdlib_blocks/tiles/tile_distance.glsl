// SPDX-License-Identifier: Apache-2.0
/// How far a point of a tile is from the tile's border, in texture space: 0 at the border, negative
/// outside.
/// @param tile the tile
float tile_distance(Tile tile) {
  vec2 inward = (0.5 - abs(tile.local - 0.5)) * tile.size;
  return min(inward.x, inward.y);
}
