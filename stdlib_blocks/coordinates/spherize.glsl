// SPDX-License-Identifier: Apache-2.0
/// Bulges what is drawn within a circle as if it lay on a ball that is seen from far away, or
/// pinches it the opposite way.
/// With r, the distance from the middle in radii, the ball shows what lies at asin(r) 2 / pi: in
/// the middle it is pi / 2 times as large, at the rim as narrow as on a ball. A negative amount
/// shows what lies at sin(r pi / 2), which undoes it. Between -1 and 0, and 0 and 1, both are mixed
/// with r itself. Outside of the circle nothing is changed. The footprint is that of the result.
/// @source Material Maker, "Spherize"; the ball: orthographic projection
/// @param uv coordinate @default uv
/// @param center the middle @default vec2(0.5)
/// @param amount 1 is a ball, 0 flat, -1 the opposite of a ball @default 1 @range -1 1
/// @param radius of the circle; above 0 @default 0.5
vec2 spherize(vec2 uv, vec2 center, float amount, float radius) {
  float reach = max(radius, 1e-6);
  vec2 p = (uv - center) / reach;
  float square = clamp(dot(p, p), 1e-12, 1.0);
  float r = sqrt(square);
  // asin(r), with a slope that stays finite at the rim.
  float ball = atan(r, sqrt(max(1.0 - square, 1e-8))) * 0.63661977236758134;
  float pinched = sin(1.5707963267948966 * r);
  float share = mix(r, amount < 0.0 ? pinched : ball, abs(amount));
  return center + reach * p * (share / r);
}
