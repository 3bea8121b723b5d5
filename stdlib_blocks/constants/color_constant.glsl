// SPDX-License-Identifier: Apache-2.0
/// One colour with its opacity, in linear light, straight alpha.
/// @param value red, green, blue and alpha @default vec4(1)
vec4 color_constant(vec4 value) { return value; }
