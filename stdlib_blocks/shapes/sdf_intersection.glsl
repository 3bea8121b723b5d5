// SPDX-License-Identifier: Apache-2.0
/// What two shapes have in common.
/// Inside it is the distance. Outside the outline may be further away than it says.
/// @param a distance from the one shape, below 0 inside
/// @param b distance from the other
float sdf_intersection(float a, float b) { return max(a, b); }
