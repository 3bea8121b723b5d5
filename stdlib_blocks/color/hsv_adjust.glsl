// SPDX-License-Identifier: Apache-2.0
/// Turns a colour's hue, and strengthens or weakens its saturation and value.
/// It works on linear light: a value of 2 doubles the light, and a saturation of 0 leaves the grey
/// of the greatest component. Saturation stops at 1, value does not. Greys have no hue and stay
/// grey.
/// @source Smith, Color Gamut Transform Pairs, SIGGRAPH 1978
/// @param color linear light, not negative; alpha, straight, stays
/// @param hue how far round the circle: 120 makes green of red @default 0 @unit degrees
/// @param saturation the factor of the saturation @default 1 @range 0 1000
/// @param value the factor of the value @default 1 @range 0 1000
vec3 hsv_adjust(vec3 color, float hue, float saturation, float value) {
  vec3 hsv = rgb_to_hsv(color);
  return hsv_to_rgb(vec3(hsv.x + hue / 360.0, min(hsv.y * saturation, 1.0), hsv.z * value));
}

/// @param color linear light, not negative; alpha, straight, stays
/// @param hue how far round the circle: 120 makes green of red @default 0 @unit degrees
/// @param saturation the factor of the saturation @default 1 @range 0 1000
/// @param value the factor of the value @default 1 @range 0 1000
vec4 hsv_adjust(vec4 color, float hue, float saturation, float value) {
  vec3 hsv = rgb_to_hsv(color.rgb);
  return vec4(
      hsv_to_rgb(vec3(hsv.x + hue / 360.0, min(hsv.y * saturation, 1.0), hsv.z * value)), color.a);
}
