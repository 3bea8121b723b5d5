// SPDX-License-Identifier: Apache-2.0
/// A colour without its opacity.
/// @param color the colour
vec3 rgb(vec4 color) { return color.rgb; }
