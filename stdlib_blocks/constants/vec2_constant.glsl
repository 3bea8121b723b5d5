// SPDX-License-Identifier: Apache-2.0
/// Two numbers: a position, a size, or a range from the first to the second.
/// @param value the numbers @default vec2(0)
vec2 vec2_constant(vec2 value) { return value; }
