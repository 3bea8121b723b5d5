// SPDX-License-Identifier: Apache-2.0
/// The channels of a colour, as numbers.
/// @param color the colour
/// @param r red
/// @param g green
void separate(vec2 color, out float r, out float g) {
  r = color.r;
  g = color.g;
}

/// @param b blue
void separate(vec3 color, out float r, out float g, out float b) {
  r = color.r;
  g = color.g;
  b = color.b;
}

/// @param a alpha
void separate(vec4 color, out float r, out float g, out float b, out float a) {
  r = color.r;
  g = color.g;
  b = color.b;
  a = color.a;
}
