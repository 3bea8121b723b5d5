// SPDX-License-Identifier: Apache-2.0
/// The distance from an ellipse, below 0 inside.
/// The nearest point is looked for with the circle that fits the ellipse best at the point so far:
/// each step goes to that circle's nearest point. Eight of them are exact, to what a float can
/// hold, for ellipses up to 50 times as long as wide. The distance is that from the tangent there.
/// @source the centre of curvature of an ellipse is ((a^2 - b^2) cos^3 t / a,
///   (b^2 - a^2) sin^3 t / b)
/// @param uv coordinate @default uv
/// @param center middle of the ellipse @default vec2(0.5)
/// @param size width and height; above 0 @default vec2(0.8, 0.5)
float sdf_ellipse(vec2 uv, vec2 center, vec2 size) {
  vec2 p = uv - center;
  // In the first quarter. Not with abs(p), whose derivative is 0 on the axes.
  vec2 q = p * vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 axes = 0.5 * size;
  vec2 focal = vec2(axes.x * axes.x - axes.y * axes.y, axes.y * axes.y - axes.x * axes.x) / axes;
  vec2 t = vec2(0.70710678);  // cosine and sine of the angle in (a cos, b sin)
  for (int i = 0; i < 8; i++) {
    vec2 middle = focal * t * t * t;
    vec2 away = q - middle;
    float radius = distance(axes * t, middle);
    t = clamp((middle + radius * away / max(length(away), 1e-20)) / axes, 1e-7, 1.0);
    t *= inversesqrt(dot(t, t));
  }
  // That the nearest point moves does not change the distance, so its derivative need not be
  // carried through the loop: steps have none. These, of 2^-24, are as fine as t.
  vec2 nearest = floor(t * 16777216.0 + 0.5) * 5.9604644775390625e-8;
  return dot(q - axes * nearest, normalize(axes.yx * nearest));
}
