// SPDX-License-Identifier: Apache-2.0
/// How bright a colour is: the grey of the same luminance, from linear light with the primaries of
/// sRGB.
/// @source Recommendation ITU-R BT.709-6, item 3.2
/// @param color the colour, in linear light; opacity does not matter
float luminance(vec3 color) { return dot(color, vec3(0.2126, 0.7152, 0.0722)); }
float luminance(vec4 color) { return dot(color.rgb, vec3(0.2126, 0.7152, 0.0722)); }
