// SPDX-License-Identifier: Apache-2.0
/// Makes a colour of four numbers.
/// @param x first component, red @default 0
/// @param y second component, green @default 0
/// @param z third component, blue @default 0
/// @param w fourth component, alpha @default 1
vec4 combine4(float x, float y, float z, float w) { return vec4(x, y, z, w); }
