// SPDX-License-Identifier: Apache-2.0
/// A disc as a mask: 1 inside, 0 outside, with an edge that is one pixel wide, or softer.
/// Where a pixel grows as large as the unit square it passes into the share of that square, as if
/// the square were repeated: so it is right in a tile that is small.
/// @param uv coordinate @default uv
/// @param center middle of the disc @default vec2(0.5)
/// @param radius distance of the edge from the middle @default 0.5
/// @param softness how far the edge is spread, beside the width of a pixel @default 0
float circle(vec2 uv, vec2 center, float radius, float softness) {
  float from_center = length(uv - center);
  float width = softness + max(footprint(from_center), 1e-7);
  float near = clamp((radius - from_center) / width + 0.5, 0.0, 1.0);
  vec2 pixel = footprint(uv);
  float far = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  return mix(near, min(3.14159265 * radius * radius, 1.0), far);
}
