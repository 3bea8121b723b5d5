// SPDX-License-Identifier: Apache-2.0
/// The distance from a straight stroke with round ends, below 0 inside.
/// @param uv coordinate @default uv
/// @param a where the stroke begins @default vec2(0.2)
/// @param b where it ends @default vec2(0.8)
/// @param width width of the stroke @default 0.1
float sdf_line(vec2 uv, vec2 a, vec2 b, float width) {
  vec2 p = uv - a;
  float line_length = distance(a, b);
  vec2 along = line_length > 0.0 ? (b - a) / line_length : vec2(1.0, 0.0);
  float place = dot(p, along);
  float side = p.x * along.y - p.y * along.x;
  float beyond = place - clamp(place, 0.0, line_length);
  // Not abs(side), whose derivative is 0 on the axis.
  float beside = side * (side < 0.0 ? -1.0 : 1.0);
  return (beyond != 0.0 ? length(vec2(beyond, side)) : beside) - 0.5 * width;
}
