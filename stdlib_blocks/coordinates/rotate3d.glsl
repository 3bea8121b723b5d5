// SPDX-License-Identifier: Apache-2.0
/// Turns a vector of space about an axis, or a place about an axis through a pivot.
/// Seen from the tip of the axis it turns counter-clockwise.
/// @source Rodrigues, Des lois geometriques, Journal de mathematiques 5, 1840; MaterialX 1.39,
///   Standard Nodes, rotate3d
/// @param vector a direction or a place
/// @param angle how far @default 0 @unit degrees
/// @param axis about which, of any length above 0 @default vec3(0, 1, 0)
/// @param pivot a place on the axis; of no use for directions @default vec3(0)
vec3 rotate3d(vec3 vector, float angle, vec3 axis, vec3 pivot) {
  vec3 k = axis * inversesqrt(max(dot(axis, axis), 1e-30));
  float c = cos(radians(angle));
  float s = sin(radians(angle));
  vec3 p = vector - pivot;
  return c * p + s * cross(k, p) + ((1.0 - c) * dot(k, p)) * k + pivot;
}
