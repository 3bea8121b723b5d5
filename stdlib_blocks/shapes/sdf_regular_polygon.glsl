// SPDX-License-Identifier: Apache-2.0
const float TURN = 6.28318530717958648;

/// The distance from a polygon with equal sides and angles, below 0 inside.
/// The plane is folded, so that one half of one side stands for all: a nearest point lies there as
/// well.
/// @param uv coordinate @default uv
/// @param center middle of the polygon @default vec2(0.5)
/// @param radius distance of the corners from the middle, before they are rounded @default 0.4
/// @param sides how many @default 6 @range 3 64
/// @param angle how far the polygon is turned, counter-clockwise; at 0 a corner is above the middle
///   @default 0 @unit degrees
/// @param rounding radius of the corners; the sides stay where they are. At most the distance of
///   the sides from the middle, which makes a circle @default 0
float sdf_regular_polygon(vec2 uv, vec2 center, float radius, const int sides, float angle,
                          float rounding) {
  vec2 p = uv - center;
  float step_angle = TURN / float(sides);
  float start = radians(angle + 90.0);
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - start;  // atan(0, 0) is undefined
  // The direction of the nearest side's middle: constant but for jumps.
  float side = start + step_angle * (floor(turned / step_angle) + 0.5);
  vec2 outward = vec2(cos(side), sin(side));
  vec2 q = vec2(dot(p, outward), abs(p.y * outward.x - p.x * outward.y));
  float apothem = radius * cos(0.5 * step_angle);
  float corner = clamp(rounding, 0.0, apothem);
  float inner = apothem - corner;
  vec2 beyond = q - vec2(inner, inner * tan(0.5 * step_angle));
  return (beyond.y > 0.0 && beyond.x > 0.0 ? length(beyond) : beyond.x) - corner;
}
