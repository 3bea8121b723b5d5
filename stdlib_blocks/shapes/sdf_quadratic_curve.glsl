// SPDX-License-Identifier: Apache-2.0
const int ROUNDS = 12;

/// The distance from a curve with one control point (a quadratic Bézier), drawn as a stroke with
/// round ends; below 0 inside.
/// The squared distance from a point of the curve has a derivative of third degree. Its smallest
/// root lies before its inflection, where the derivative is concave, its largest behind it, where
/// it is convex; Newton's method comes to the one from below and to the other from above, and never
/// oversteps. What is between them is no minimum. The control point may lie anywhere, on the line
/// between the ends or on one of them as well. Where the stroke overlaps itself or bends more
/// sharply than it is wide, inside, the outline seems nearer than it is.
/// @param uv coordinate @default uv
/// @param a where the curve begins @default vec2(0.15, 0.2)
/// @param b the control point: the curve leaves `a` towards it, and comes to `c` from it
///   @default vec2(0.5, 1.2)
/// @param c where the curve ends @default vec2(0.85, 0.2)
/// @param width width of the stroke @default 0.1
float sdf_quadratic_curve(vec2 uv, vec2 a, vec2 b, vec2 c, float width) {
  // The curve from the point, (bend * t + 2 * lead) * t + from_a; its derivative is 2 * (bend * t +
  // lead); the product of both is twice `slope`.
  vec2 from_a = a - uv;
  vec2 lead = b - a;
  vec2 bend = a - 2.0 * b + c;
  float bend2 = dot(bend, bend);
  float inflection = clamp(-dot(lead, bend) / max(bend2, 1e-20), 0.0, 1.0);
  vec2 low = vec2(0.0, inflection);
  vec2 high = vec2(inflection, 1.0);
  float k0 = dot(from_a, lead);
  float k1 = 2.0 * dot(lead, lead) + dot(from_a, bend);
  float k2 = 3.0 * dot(lead, bend);
  vec2 t = vec2(0.0, 1.0);
  for (int i = 0; i < ROUNDS; i++) {
    vec2 slope = ((bend2 * t + k2) * t + k1) * t + k0;
    vec2 rise = (3.0 * bend2 * t + 2.0 * k2) * t + k1;
    t = clamp(t - slope / max(rise, 1e-20), low, high);
  }
  // Rounding to what a float can tell: at a minimum the distance does not depend on t, so its
  // derivative needs none of t's.
  t = floor(t * 16777216.0 + 0.5) / 16777216.0;
  vec2 first = (bend * t.x + 2.0 * lead) * t.x + from_a;
  vec2 last = (bend * t.y + 2.0 * lead) * t.y + from_a;
  float from_curve = min(min(length(first), length(last)), min(length(from_a), distance(uv, c)));
  return from_curve - 0.5 * width;
}
