// SPDX-License-Identifier: Apache-2.0
const float TURN = 6.28318530717958648;

/// The distance from a star, below 0 inside.
/// The plane is folded, so that one half of one point stands for all: a nearest place of the
/// outline lies there as well.
/// @param uv coordinate @default uv
/// @param center middle of the star @default vec2(0.5)
/// @param radius distance of the points from the middle @default 0.4
/// @param inner_radius distance of the notches between them @default 0.16
/// @param points how many @default 5 @range 2 64
/// @param angle how far the star is turned, counter-clockwise; at 0 a point is above the middle
///   @default 0 @unit degrees
float sdf_star(vec2 uv, vec2 center, float radius, float inner_radius, const int points,
               float angle) {
  vec2 p = uv - center;
  float step_angle = TURN / float(points);
  float start = radians(angle + 90.0);
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - start;  // atan(0, 0) is undefined
  // The direction of the nearest point: constant but for jumps.
  float toward = start + step_angle * floor(turned / step_angle + 0.5);
  vec2 ahead = vec2(cos(toward), sin(toward));
  // From the point of the star, along the axis and away from it. Not with abs(from_axis), whose
  // derivative is 0 on the axis.
  float from_axis = p.y * ahead.x - p.x * ahead.y;
  vec2 q = vec2(dot(p, ahead) - radius, from_axis * (from_axis < 0.0 ? -1.0 : 1.0));
  vec2 notch = inner_radius * vec2(cos(0.5 * step_angle), sin(0.5 * step_angle));
  vec2 edge = notch - vec2(radius, 0.0);
  float edge_length = length(edge);
  vec2 along = edge / max(edge_length, 1e-20);
  float side = q.x * along.y - q.y * along.x;
  float place = dot(q, along);
  if (place > 0.0 && place < edge_length) {
    return side;
  }
  float to_end = length(place > 0.0 ? q - edge : q);
  return side < 0.0 ? -to_end : to_end;
}
