// SPDX-License-Identifier: Apache-2.0
/// How much of what a pixel shows is a single tile: 1 near by, and less the more tiles a pixel
/// holds; 1/16 where it holds 64 of them.
/// What varies from tile to tile shimmers from far away, where a pixel has to choose one tile of
/// many. Mixed with its mean by this number it doesn't: near by it is what it was, far away the
/// mean. `tile_random_color` and `tile_random_hsv` do that by themselves.
/// It estimates the share of a pixel that its middle's tile covers, for pixels as large as the
/// footprint that lie anywhere: 1 / (1 + f^2 / 4) in each direction, for f tiles a pixel, and
/// is off by up to an eighth.
/// @param tile the tile
float tile_near(Tile tile) {
  vec2 right = footprint_x(tile.local);
  vec2 up = footprint_y(tile.local);
  vec2 part = 4.0 + right * right + up * up;
  return 16.0 / (part.x * part.y);
}

/// Of cells in space it is the share of a pixel of a surface, along all three axes.
/// @param tile the cell in space
float tile_near(Tile3 tile) {
  vec3 right = footprint_x(tile.local);
  vec3 up = footprint_y(tile.local);
  vec3 part = 4.0 + right * right + up * up;
  return 64.0 / (part.x * part.y * part.z);
}
