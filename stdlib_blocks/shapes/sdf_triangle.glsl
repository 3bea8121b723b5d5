// SPDX-License-Identifier: Apache-2.0
// How far p is to the right of the way from a to b, twice the area of the triangle that they make.
float right_of(vec2 p, vec2 a, vec2 b) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// The distance from a segment.
float from_segment(vec2 p, vec2 a, vec2 b) {
  float edge_length = distance(a, b);
  vec2 along = (b - a) / max(edge_length, 1e-20);
  float place = dot(p - a, along);
  if (place > 0.0 && place < edge_length) {
    float side = (p.x - a.x) * along.y - (p.y - a.y) * along.x;
    return side * (side < 0.0 ? -1.0 : 1.0);  // not abs(side), whose derivative is 0 on the segment
  }
  return length(p - (place > 0.0 ? b : a));
}

/// The distance from a triangle, below 0 inside.
/// The corners may come in either order. Three corners on one line have no inside.
/// @param uv coordinate @default uv
/// @param a first corner @default vec2(0.1, 0.15)
/// @param b second corner @default vec2(0.9, 0.15)
/// @param c third corner @default vec2(0.5, 0.85)
float sdf_triangle(vec2 uv, vec2 a, vec2 b, vec2 c) {
  float outline = min(from_segment(uv, a, b), min(from_segment(uv, b, c), from_segment(uv, c, a)));
  float turn = right_of(c, a, b) < 0.0 ? -1.0 : 1.0;
  float inside = min(turn * right_of(uv, a, b),
                     min(turn * right_of(uv, b, c), turn * right_of(uv, c, a)));
  return inside > 0.0 ? -outline : outline;
}
