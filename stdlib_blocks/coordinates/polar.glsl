// SPDX-License-Identifier: Apache-2.0
/// The coordinate as an angle and a distance: what is drawn at it is bent around a middle.
/// x goes from 0 to 1 once around, counter-clockwise; y is 0 in the middle and 1 at the radius.
/// Where x comes round from 1 to 0 it jumps, but its footprint does not: what repeats after 1, a
/// texture with "wrap" say, has no seam. Towards the middle ever more of a turn falls into a pixel,
/// and what is filtered by its footprint goes to its mean there.
/// @source Substance 3D Designer, function nodes, "Cartesian to polar"
/// @param uv coordinate @default uv
/// @param center the middle @default vec2(0.5)
/// @param angle where x begins: 0 is to the right @default 0 @unit degrees
/// @param radius the distance from the middle where y is 1; not 0 @default 0.5
/// @return the angle as a share of the circle, and the distance in radii
vec2 polar(vec2 uv, vec2 center, float angle, float radius) {
  vec2 p = uv - center;
  float turns = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) * 0.15915494309;  // atan(0, 0) is undefined
  return vec2(fract(turns - angle / 360.0), length(p) / radius);
}
