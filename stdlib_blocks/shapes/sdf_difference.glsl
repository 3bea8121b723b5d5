// SPDX-License-Identifier: Apache-2.0
/// A shape without what is in another one.
/// Inside it is the distance. Outside the outline may be further away than it says.
/// @param a distance from the shape, below 0 inside
/// @param b distance from what is taken away
float sdf_difference(float a, float b) { return max(a, -b); }
