// SPDX-License-Identifier: Apache-2.0
/// A gradient from 0 in the middle, or at an inner circle, to 1 at a circle around it.
/// @param uv coordinate @default uv
/// @param center the middle @default vec2(0.5)
/// @param radius where it is 1 @default 0.5
/// @param inner_radius where it is 0; another than `radius` @default 0
/// @param spread beyond: pad, 0 and 1; repeat, the same again; reflect, there and back
///   @default SPREAD_PAD
float gradient_radial(vec2 uv, vec2 center, float radius, float inner_radius, const int spread) {
  return spread_range((length(uv - center) - inner_radius) / (radius - inner_radius), spread);
}
