// SPDX-License-Identifier: Apache-2.0
/// A disc as a mask: 1 inside, 0 outside, with an edge that is one pixel wide, or softer.
/// @param uv coordinate @default uv
/// @param center middle of the disc @default vec2(0.5)
/// @param radius distance of the edge from the middle @default 0.5
/// @param softness how far the edge is spread, beside the width of a pixel @default 0
float circle(vec2 uv, vec2 center, float radius, float softness) {
  float from_center = length(uv - center);
  float width = softness + max(footprint(from_center), 1e-7);
  return clamp((radius - from_center) / width + 0.5, 0.0, 1.0);
}
