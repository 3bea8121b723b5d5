// SPDX-License-Identifier: Apache-2.0
const int NAME_R = 0;
const int NAME_G = 1;
const int NAME_B = 2;
const int NAME_A = 3;

/// One channel of a colour, as a number.
/// @param color the colour
/// @param name which channel @default NAME_R
float channel(vec4 color, const int name) {
  return name == NAME_R ? color.r : name == NAME_G ? color.g : name == NAME_B ? color.b : color.a;
}
