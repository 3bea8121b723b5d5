// SPDX-License-Identifier: Apache-2.0
/// Turns a vector of the plane counter-clockwise, or a place about a pivot.
/// `uv_transform` turns what is drawn at a coordinate; this turns the vector itself.
/// @source MaterialX 1.39, Standard Nodes, rotate2d
/// @param vector a direction or a place
/// @param angle how far, counter-clockwise @default 0 @unit degrees
/// @param pivot the place that stays where it is; of no use for directions @default vec2(0)
vec2 rotate2d(vec2 vector, float angle, vec2 pivot) {
  float c = cos(radians(angle));
  float s = sin(radians(angle));
  vec2 p = vector - pivot;
  return vec2(c * p.x - s * p.y, s * p.x + c * p.y) + pivot;
}
