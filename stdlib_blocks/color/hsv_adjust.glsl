// SPDX-License-Identifier: Apache-2.0
/// Turns a colour's hue, and strengthens or weakens its saturation and value.
/// It works on linear light: a value of 2 doubles the light, and a saturation of 0 leaves the grey
/// of the greatest component. Saturation stops at 1, value does not. Greys have no hue and stay
/// grey. What is constant and changes nothing costs nothing.
/// @source Smith, Color Gamut Transform Pairs, SIGGRAPH 1978
/// @param color linear light, not negative
/// @param hue how far round the circle: 120 makes green of red @default 0 @unit degrees
/// @param saturation the factor of the saturation @default 1 @range 0 1000
/// @param value the factor of the value @default 1 @range 0 1000
vec3 hsv_adjust(vec3 color, float hue, float saturation, float value) {
  // Saturation draws the components towards the greatest, or away until the least is 0.
  float top = max(max(color.r, color.g), color.b);
  float range = top - min(min(color.r, color.g), color.b);
  float pull = saturation == 1.0 ? 1.0 : min(saturation, top / max(range, 1e-20));
  vec3 pulled = mix(vec3(top), color, pull);
  vec3 hsv = rgb_to_hsv(pulled);
  vec3 turned = hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? pulled : turned);
}

/// @param color linear light, not negative; alpha, straight, stays
/// @param hue how far round the circle: 120 makes green of red @default 0 @unit degrees
/// @param saturation the factor of the saturation @default 1 @range 0 1000
/// @param value the factor of the value @default 1 @range 0 1000
vec4 hsv_adjust(vec4 color, float hue, float saturation, float value) {
  return vec4(hsv_adjust(color.rgb, hue, saturation, value), color.a);
}
