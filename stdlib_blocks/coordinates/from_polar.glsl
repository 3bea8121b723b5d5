// SPDX-License-Identifier: Apache-2.0
/// The place of an angle and a distance: the inverse of `polar`.
/// What is drawn at it is unrolled: a ring becomes a band.
/// @source Substance 3D Designer, function nodes, "Polar to Cartesian"
/// @param polar the angle as a share of the circle, counter-clockwise, and the distance in radii
///   @default uv
/// @param center the middle @default vec2(0.5)
/// @param angle where the angle 0 is: 0 is to the right @default 0 @unit degrees
/// @param radius the distance that counts as 1 @default 0.5
vec2 from_polar(vec2 polar, vec2 center, float angle, float radius) {
  float direction = polar.x * 6.28318530718 + radians(angle);
  return center + (radius * polar.y) * vec2(cos(direction), sin(direction));
}
