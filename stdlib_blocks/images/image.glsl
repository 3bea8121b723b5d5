// SPDX-License-Identifier: Apache-2.0
/// A picture: its colour at a coordinate. The picture fills the square from (0, 0), lower left, to
/// (1, 1).
/// The alpha is straight: the colour is not multiplied by it.
/// @param picture the texture
/// @param uv coordinate @default uv
vec4 image(sampler2D picture, vec2 uv) { return texture(picture, uv); }
