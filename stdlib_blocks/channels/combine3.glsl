// SPDX-License-Identifier: Apache-2.0
/// Makes a vector, or a colour without opacity, of three numbers.
/// @param x first component, red @default 0
/// @param y second component, green @default 0
/// @param z third component, blue @default 0
vec3 combine3(float x, float y, float z) { return vec3(x, y, z); }
