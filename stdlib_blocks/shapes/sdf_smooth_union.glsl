// SPDX-License-Identifier: Apache-2.0
/// Two shapes in one that flow together where they meet.
/// With t = clamp(1/2 + (b - a) / (2 k), 0, 1) it is t a + (1 - t) b - k t (1 - t): the union where
/// the distances differ by k or more, and at most k/4 below it. Its slope has no jump where the
/// shapes meet. The outline is at least as far away as it says.
/// @param a distance from the one shape, below 0 inside
/// @param b distance from the other
/// @param k how much the distances may differ where the shapes flow together; at 0 they don't
///   @default 0.1
float sdf_smooth_union(float a, float b, float k) {
  float t = clamp(0.5 + 0.5 * (b - a) / max(k, 1e-12), 0.0, 1.0);
  return mix(b, a, t) - max(k, 0.0) * t * (1.0 - t);
}
