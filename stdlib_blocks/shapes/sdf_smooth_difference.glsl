// SPDX-License-Identifier: Apache-2.0
/// A shape without what is in another one, with a rim that is rounded off.
/// The difference where the distances differ by k or more, and at most k/4 above it.
/// @param a distance from the shape, below 0 inside
/// @param b distance from what is taken away
/// @param k how much the distances may differ where the shapes flow together; at 0 they don't
///   @default 0.1
float sdf_smooth_difference(float a, float b, float k) { return -sdf_smooth_union(-a, b, k); }
