// SPDX-License-Identifier: Apache-2.0
/// Multiplies red, green and blue by alpha: from straight to premultiplied.
/// The colour is linear light, and the product is light as well: what really arrives from a surface
/// that covers that share of the pixel. Products of encoded values would be too bright.
/// Blocks take straight colours unless they say otherwise.
/// @source Porter and Duff, Compositing Digital Images, SIGGRAPH 1984, section 3
/// @param color straight alpha
vec4 premultiply(vec4 color) { return vec4(color.rgb * color.a, color.a); }
