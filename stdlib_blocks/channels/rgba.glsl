// SPDX-License-Identifier: Apache-2.0
/// A colour with an opacity.
/// @param color red, green and blue
/// @param alpha opacity @default 1 @range 0 1
vec4 rgba(vec3 color, float alpha) { return vec4(color, alpha); }
