// SPDX-License-Identifier: Apache-2.0
// The place without its derivative: steps have none, and these, of 2^-40, are finer than a float of
// 2^-17 or more. Below they move it by less than 1e-12.
vec2 still(vec2 place) { return floor(place * 1.099511627776e12) * 9.094947017729282e-13; }

/// The same place, seen by a pixel of another size: what is drawn at it is filtered as if the pixel
/// had that width and height. Textures take a coarser or finer level, and all blocks that filter
/// themselves follow.
/// With J, the change of `uv` over the pixel, it is place + M (uv - uv), where M is
/// diag(width) J^-1 and the second uv counts as constant: the sum is the place, and its change is
/// diag(width).
/// @param place where @default uv
/// @param width width and height of the pixel, in the units of the place @default vec2(0)
/// @param uv any coordinate that changes from pixel to pixel @default uv
vec2 widen(vec2 place, vec2 width, vec2 uv) {
  vec2 right = footprint_x(uv);
  vec2 up = footprint_y(uv);
  float area = right.x * up.y - right.y * up.x;
  float least = max(1e-4 * length(right) * length(up), 1e-30);
  area = area < 0.0 ? min(area, -least) : max(area, least);
  vec2 change = uv - still(uv);
  vec2 pixels = vec2(up.y * change.x - up.x * change.y, right.x * change.y - right.y * change.x);
  return still(place) + width / area * pixels;
}
