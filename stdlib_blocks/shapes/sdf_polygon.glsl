// SPDX-License-Identifier: Apache-2.0
const int RULE_EVEN_ODD = 0;
const int RULE_NON_ZERO = 1;

// Of a segment, the squared distance of its nearest point from the origin.
float nearness(vec2 a, vec2 b) {
  vec2 edge = b - a;
  vec2 to_nearest = a + edge * clamp(-dot(a, edge) / max(dot(edge, edge), 1e-20), 0.0, 1.0);
  return dot(to_nearest, to_nearest);
}

// +1 if the way from the origin to the right is crossed upwards, -1 if downwards. What lies at the
// height of the origin is below it, so a corner is not crossed twice.
int crossing(vec2 a, vec2 b) {
  float side = a.x * b.y - a.y * b.x;
  int up = a.y <= 0.0 && b.y > 0.0 && side > 0.0 ? 1 : 0;
  int down = a.y > 0.0 && b.y <= 0.0 && side < 0.0 ? 1 : 0;
  return up - down;
}

/// The distance from a polygon of any form, below 0 inside; its corners are points of the graph.
/// The nearest side is found without derivatives, by its number; only its distance has some. Inside
/// is what the sides turn around, counted by how often they cross the way to the right.
/// @source Sunday, Inclusion of a Point in a Polygon
/// @param uv coordinate @default uv
/// @param points the corners, one after the other; the last is joined to the first @length 3 1024
///   @default vec2[](vec2(0.1, 0.1), vec2(0.5, 0.3), vec2(0.9, 0.1), vec2(0.5, 0.9))
/// @param rule what is inside where the outline crosses itself: with `even_odd` a crossing is an
///   edge of the shape; with `non_zero` all that the outline turns around belongs to it, but a side
///   that lies in the shape keeps its distance of 0 @default RULE_EVEN_ODD
float sdf_polygon(vec2 uv, const vec2 points[], const int rule) {
  int nearest = 0;
  float least = 1e30;
  int winding = 0;
  for (int i = 0; i < points.length(); i++) {
    vec2 a = points[i] - uv;
    vec2 b = points[i + 1 < points.length() ? i + 1 : 0] - uv;
    float found = nearness(a, b);
    nearest = found < least ? i : nearest;
    least = min(found, least);
    winding += crossing(a, b);
  }
  int next = nearest + 1 < points.length() ? nearest + 1 : 0;
  float outline = sdf_line(uv, points[nearest], points[next], 0.0);
  bool inside = rule == RULE_EVEN_ODD ? (winding & 1) != 0 : winding != 0;
  return inside ? -outline : outline;
}
