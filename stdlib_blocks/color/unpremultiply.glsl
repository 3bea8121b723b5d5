// SPDX-License-Identifier: Apache-2.0
/// Divides red, green and blue by alpha: from premultiplied to straight.
/// The colour is linear light before and after. Where alpha is 0 the result is black: no colour is
/// known there.
/// @source Porter and Duff, Compositing Digital Images, SIGGRAPH 1984, section 3
/// @param color premultiplied alpha
vec4 unpremultiply(vec4 color) {
  return vec4(color.a > 0.0 ? color.rgb / max(color.a, 1e-20) : vec3(0.0), color.a);
}
