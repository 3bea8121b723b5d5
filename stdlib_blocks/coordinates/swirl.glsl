// SPDX-License-Identifier: Apache-2.0
/// Stirs what is drawn around a middle: most in the middle, less and less up to the radius.
/// The angle falls off as 3t^2 - 2t^3, so it has no kink in the middle nor at the radius. The
/// footprint is that of the stirred coordinate.
/// @source Material Maker, "Swirl"
/// @param uv coordinate @default uv
/// @param center the middle @default vec2(0.5)
/// @param angle how far the middle is turned, counter-clockwise @default 180 @unit degrees
/// @param radius the distance from the middle beyond which nothing is turned; above 0
///   @default 0.5
vec2 swirl(vec2 uv, vec2 center, float angle, float radius) {
  vec2 p = uv - center;
  float t = clamp(1.0 - length(p) / radius, 0.0, 1.0);
  float turn = -radians(angle) * (t * t * (3.0 - 2.0 * t));
  float c = cos(turn);
  float s = sin(turn);
  return center + vec2(c * p.x - s * p.y, s * p.x + c * p.y);
}
