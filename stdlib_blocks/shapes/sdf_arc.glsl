// SPDX-License-Identifier: Apache-2.0
/// The distance from a part of a circle, drawn as a stroke with round ends; below 0 inside.
/// Where the stroke overlaps itself, inside, the outline seems nearer than it is.
/// @param uv coordinate @default uv
/// @param center middle of the circle @default vec2(0.5)
/// @param radius from the middle of the circle to the middle of the stroke @default 0.35
/// @param width width of the stroke @default 0.1
/// @param start direction of the one end from the middle: 0 is to the right, and angles go
///   counter-clockwise @default 0 @unit degrees
/// @param sweep how far the stroke goes from there @default 270 @range 0 360 @unit degrees
float sdf_arc(vec2 uv, vec2 center, float radius, float width, float start, float sweep) {
  float half_sweep = radians(0.5 * sweep);
  float middle = radians(start) + half_sweep;
  vec2 axis = vec2(cos(middle), sin(middle));
  vec2 p = uv - center;
  // Folded at the arc's axis of symmetry. Not with abs, whose derivative is 0 on the axis.
  float from_axis = p.y * axis.x - p.x * axis.y;
  vec2 q = vec2(dot(p, axis), from_axis * (from_axis < 0.0 ? -1.0 : 1.0));
  vec2 end = vec2(cos(half_sweep), sin(half_sweep));
  float outward = length(p) - radius;
  float from_circle = outward * (outward < 0.0 ? -1.0 : 1.0);
  bool beside = q.x * end.y > q.y * end.x;
  return (beside ? from_circle : length(q - radius * end)) - 0.5 * width;
}
