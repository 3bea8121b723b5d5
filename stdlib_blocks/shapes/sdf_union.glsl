// SPDX-License-Identifier: Apache-2.0
/// Two shapes in one: what is in either.
/// Outside it is the distance. Inside, where they overlap, the outline may be further away than it
/// says.
/// @param a distance from the one shape, below 0 inside
/// @param b distance from the other
float sdf_union(float a, float b) { return min(a, b); }
