// SPDX-License-Identifier: Apache-2.0
/// A straight gradient from 0 at one place to 1 at another, for `color_ramp` or as a mask.
/// @param uv coordinate @default uv
/// @param start where it is 0 @default vec2(0)
/// @param end where it is 1; another place @default vec2(1, 0)
/// @param spread beyond: pad, 0 and 1; repeat, the same again; reflect, there and back
///   @default SPREAD_PAD
float gradient_linear(vec2 uv, vec2 start, vec2 end, const int spread) {
  vec2 way = end - start;
  return spread_range(dot(uv - start, way) / max(dot(way, way), 1e-20), spread);
}
