// SPDX-License-Identifier: Apache-2.0
/// The colour that a picture has at a tile, the mean over about the tile's frame: a painted map
/// that says something of each tile. Give a channel of it to `chance` of `layer`, and the picture
/// is a mask of where elements are; to `scale` or `tint`, and it is a map of these.
/// @param picture the texture; it covers the surface from (0, 0) to (1, 1)
/// @param tile the tile, as seen from `uv`
/// @param uv the coordinate that the tile's grid took @default uv
vec4 tile_image(sampler2D picture, Tile tile, vec2 uv) {
  return textureGrad(picture, tile_center(tile, uv), tile.right * tile.size.x,
                     tile.up * tile.size.y);
}
