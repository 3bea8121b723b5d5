// SPDX-License-Identifier: Apache-2.0
/// The colour of a hue, a saturation and a value.
/// The three describe linear light, and the result is linear light: a value of 0.5 is half the
/// light, which a screen shows with an sRGB value of 188 of 255.
/// @source Smith, Color Gamut Transform Pairs, SIGGRAPH 1978
/// @param hsv hue, as a share of the circle, red at 0, green at 1/3, blue at 2/3, and round again;
///   saturation from 0 to 1; value from 0, also above 1
vec3 hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 2.0 / 3.0, 1.0 / 3.0)) * 6.0 - 3.0);
  return hsv.z * mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
}
