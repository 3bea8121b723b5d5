// SPDX-License-Identifier: Apache-2.0
/// Repeats what is drawn from 0 to 1: so many copies for each unit of the coordinate.
/// The coordinate jumps from copy to copy, or turns back there, and its footprint does neither. So
/// textures are filtered right, but a shape that touches the border of its copy is cut there
/// without antialiasing.
/// @source MaterialX 1.39, Standard Nodes, image, the address modes "periodic" and "mirror"
/// @param value coordinate
/// @param scale copies for each unit of the coordinate @default 1
/// @param mirrored whether every second copy is mirrored, so that copies always fit
///   @default false
float repeat(float value, float scale, const bool mirrored) {
  float p = value * scale;
  return mirrored ? 1.0 - abs(2.0 * fract(0.5 * p) - 1.0) : fract(p);
}

/// @param uv coordinate @default uv
/// @param scale copies for each unit of the coordinate, across and up @default vec2(1)
/// @param mirrored whether every second copy is mirrored, so that copies always fit
///   @default false
vec2 repeat(vec2 uv, vec2 scale, const bool mirrored) {
  vec2 p = uv * scale;
  return mirrored ? 1.0 - abs(2.0 * fract(0.5 * p) - 1.0) : fract(p);
}

/// @param position coordinate @default position
/// @param scale copies for each unit of the coordinate, along each axis @default vec3(1)
/// @param mirrored whether every second copy is mirrored, so that copies always fit
///   @default false
vec3 repeat(vec3 position, vec3 scale, const bool mirrored) {
  vec3 p = position * scale;
  return mirrored ? 1.0 - abs(2.0 * fract(0.5 * p) - 1.0) : fract(p);
}
