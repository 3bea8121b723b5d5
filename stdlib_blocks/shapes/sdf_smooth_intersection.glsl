// SPDX-License-Identifier: Apache-2.0
/// What two shapes have in common, with a corner that is rounded off where they meet.
/// The intersection where the distances differ by k or more, and at most k/4 above it: minus
/// `sdf_smooth_union` of what is outside.
/// @param a distance from the one shape, below 0 inside
/// @param b distance from the other
/// @param k how much the distances may differ where the shapes flow together; at 0 they don't
///   @default 0.1
float sdf_smooth_intersection(float a, float b, float k) { return -sdf_smooth_union(-a, -b, k); }
