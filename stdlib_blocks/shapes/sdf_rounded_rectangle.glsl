// SPDX-License-Identifier: Apache-2.0
/// The distance from a rectangle, below 0 inside, with corners that may be rounded, each on its
/// own.
/// @param uv coordinate @default uv
/// @param center middle of the rectangle @default vec2(0.5)
/// @param size width and height @default vec2(0.8)
/// @param corner_radius radius of the corners: one number for all, or lower left, lower right,
///   upper right, upper left; what is above half of the shorter side counts as that
///   @default vec4(0.1)
float sdf_rounded_rectangle(vec2 uv, vec2 center, vec2 size, vec4 corner_radius) {
  vec2 p = uv - center;
  vec2 left_right = p.y < 0.0 ? corner_radius.xy : corner_radius.wz;
  float corner = p.x < 0.0 ? left_right.x : left_right.y;
  float radius = clamp(corner, 0.0, 0.5 * min(size.x, size.y));
  // From the middle of the corner's circle. Not with abs(p), whose derivative is 0 on the axes.
  vec2 quarter = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 q = p * quarter - 0.5 * size + radius;
  float outward = q.x > 0.0 && q.y > 0.0 ? length(q) : max(q.x, q.y);
  return outward - radius;
}
