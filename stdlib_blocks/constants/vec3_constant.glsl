// SPDX-License-Identifier: Apache-2.0
/// Three numbers: a direction, or a colour without opacity.
/// @param value the numbers @default vec3(0)
vec3 vec3_constant(vec3 value) { return value; }
