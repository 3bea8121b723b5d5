// SPDX-License-Identifier: Apache-2.0
/// Hue, saturation and value of a colour.
/// They are those of linear light: value is the greatest of the three components, saturation how
/// far the least lies below it, as a share. A colour picker takes them from encoded values: its
/// value is larger, its saturation smaller, and its hues lie elsewhere between the six pure ones.
/// Greys have the hue 0, black has the saturation 0. Values above 1 are kept.
/// @source Smith, Color Gamut Transform Pairs, SIGGRAPH 1978
/// @param color linear light, not negative
/// @return hue, as a share of the circle, saturation and value: red is at 0, green at 1/3, blue at
///   2/3
vec3 rgb_to_hsv(vec3 color) {
  float value = max(max(color.r, color.g), color.b);
  float range = value - min(min(color.r, color.g), color.b);
  float part = 1.0 / max(range, 1e-20);
  float sector = (color.r - color.g) * part + 4.0;
  if (color.r == value) {
    sector = (color.g - color.b) * part;
  } else if (color.g == value) {
    sector = (color.b - color.r) * part + 2.0;
  }
  return vec3(fract(sector / 6.0), range / max(value, 1e-20), value);
}
