// SPDX-License-Identifier: Apache-2.0
/// A picture: its colour at a coordinate. The picture fills the square from (0, 0), lower left, to
/// (1, 1).
/// The alpha is straight: the colour is not multiplied by it.
/// @param picture the texture
/// @param uv coordinate @default uv
vec4 image(sampler2D picture, vec2 uv) { return texture(picture, uv); }

/// Of a texture with layers, an array, one layer is shown; `tile_choice` gives each tile one of its
/// own.
/// @param picture the texture
/// @param uv coordinate @default uv
/// @param layer which layer, from 0; beyond the last it is the last @default 0 @range 0 2047
vec4 image(sampler2DArray picture, vec2 uv, int layer) {
  return texture(picture, vec3(uv, layer));
}
