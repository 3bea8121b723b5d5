// SPDX-License-Identifier: Apache-2.0
/// Makes a vector of two numbers.
/// @param x first component @default 0
/// @param y second component @default 0
vec2 combine2(float x, float y) { return vec2(x, y); }
