// SPDX-License-Identifier: Apache-2.0
/// A picture, repeated over the surface.
/// The coordinate is uv * tiling - offset.
/// @source MaterialX 1.38, Standard Nodes, tiledimage
/// @param picture the texture; it should repeat ("wrap")
/// @param uv coordinate @default uv
/// @param tiling how often the picture stands side by side in each unit of the coordinate, across
///   and up @default vec2(1)
/// @param offset how far the pictures are moved to the right and up, in pictures @default vec2(0)
vec4 tiled_image(sampler2D picture, vec2 uv, vec2 tiling, vec2 offset) {
  return texture(picture, uv * tiling - offset);
}
