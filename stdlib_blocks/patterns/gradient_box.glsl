// SPDX-License-Identifier: Apache-2.0
/// A gradient from 0 in the middle to 1 at the sides of a box: a pyramid, seen from above.
/// @source Substance 3D Designer, "Shape", pyramid
/// @param uv coordinate @default uv
/// @param center the middle @default vec2(0.5)
/// @param size width and height of the box where it is 1; not 0 @default vec2(1)
/// @param spread beyond: pad, 1; repeat, the same again; reflect, there and back
///   @default SPREAD_PAD
float gradient_box(vec2 uv, vec2 center, vec2 size, const int spread) {
  vec2 p = 2.0 * (uv - center) / size;
  // Not with abs(p), whose derivative is 0 on the axes.
  vec2 q = p * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  return spread_range(max(q.x, q.y), spread);
}
