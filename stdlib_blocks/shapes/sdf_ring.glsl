// SPDX-License-Identifier: Apache-2.0
/// The distance from a ring, below 0 in its band.
/// A band that is wider than the circle fills it.
/// @param uv coordinate @default uv
/// @param center middle of the ring @default vec2(0.5)
/// @param radius from the middle of the ring to the middle of its band @default 0.35
/// @param width width of the band @default 0.1
float sdf_ring(vec2 uv, vec2 center, float radius, float width) {
  float outward = length(uv - center) - radius;
  // Not abs(outward), whose derivative is 0 in the middle of the band.
  float side = outward < 0.0 && 2.0 * radius > width ? -1.0 : 1.0;
  return side * outward - 0.5 * width;
}
