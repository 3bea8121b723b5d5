// SPDX-License-Identifier: Apache-2.0
/// A rectangle as a mask: 1 inside, 0 outside, antialiased: the exact share of a box as large as the pixel's footprint.
/// @param uv coordinate @default uv
/// @param center middle of the rectangle @default vec2(0.5)
/// @param size width and height @default vec2(1)
float rectangle(vec2 uv, vec2 center, vec2 size) {
  vec2 width = max(footprint(uv), 1e-7);
  vec2 from_center = abs(uv - center);
  vec2 share = (min(from_center + 0.5 * width, 0.5 * size) - max(from_center - 0.5 * width, -0.5 * size)) / width;
  share = max(share, 0.0);
  return share.x * share.y;
}
