// SPDX-License-Identifier: Apache-2.0
/// The distance from a circle, below 0 inside.
/// @param uv coordinate @default uv
/// @param center middle of the circle @default vec2(0.5)
/// @param radius distance of the outline from the middle @default 0.4
float sdf_circle(vec2 uv, vec2 center, float radius) { return length(uv - center) - radius; }
