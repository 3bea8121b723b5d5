// SPDX-License-Identifier: Apache-2.0
/// A rectangle as a mask: 1 inside, 0 outside, antialiased: the exact share of a box as large as
/// the pixel's footprint. Where a pixel grows as large as the unit square it passes into the share
/// of that square, as if the square were repeated: so it is right in a tile that is small.
/// @param uv coordinate @default uv
/// @param center middle of the rectangle @default vec2(0.5)
/// @param size width and height @default vec2(1)
float rectangle(vec2 uv, vec2 center, vec2 size) {
  vec2 width = max(footprint(uv), 1e-7);
  vec2 share = min((0.5 * size - abs(uv - center)) / width + 0.5, size / width);
  share = clamp(share, 0.0, 1.0);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(share.x * share.y, min(size.x * size.y, 1.0), far);
}
