// SPDX-License-Identifier: Apache-2.0
/// A rectangle as a mask: 1 inside, 0 outside, antialiased: the exact share of a box as large as
/// the pixel's footprint.
/// @param uv coordinate @default uv
/// @param center middle of the rectangle @default vec2(0.5)
/// @param size width and height @default vec2(1)
float rectangle(vec2 uv, vec2 center, vec2 size) {
  vec2 width = max(footprint(uv), 1e-7);
  vec2 share = min((0.5 * size - abs(uv - center)) / width + 0.5, size / width);
  share = clamp(share, 0.0, 1.0);
  return share.x * share.y;
}
