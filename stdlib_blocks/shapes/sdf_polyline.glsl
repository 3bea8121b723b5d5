// SPDX-License-Identifier: Apache-2.0
// Of a segment, the squared distance of its nearest point from the origin.
float nearness(vec2 a, vec2 b) {
  vec2 edge = b - a;
  vec2 to_nearest = a + edge * clamp(-dot(a, edge) / max(dot(edge, edge), 1e-20), 0.0, 1.0);
  return dot(to_nearest, to_nearest);
}

/// The distance from a line with corners, drawn as a stroke with round ends; below 0 inside.
/// With a width of 0 it is the distance from the line itself, for `sdf_stroke`. The nearest part is
/// found without derivatives, by its number; only its distance has some. Where the stroke overlaps
/// itself, inside, the outline seems nearer than it is.
/// @param uv coordinate @default uv
/// @param points the corners, from one end to the other @length 2 1024
///   @default vec2[](vec2(0.15, 0.2), vec2(0.4, 0.8), vec2(0.6, 0.2), vec2(0.85, 0.8))
/// @param width width of the stroke @default 0.1
float sdf_polyline(vec2 uv, const vec2 points[], float width) {
  int nearest = 0;
  float least = 1e30;
  for (int i = 0; i < points.length() - 1; i++) {
    float found = nearness(points[i] - uv, points[i + 1] - uv);
    nearest = found < least ? i : nearest;
    least = min(found, least);
  }
  return sdf_line(uv, points[nearest], points[nearest + 1], width);
}
