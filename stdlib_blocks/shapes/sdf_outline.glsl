// SPDX-License-Identifier: Apache-2.0
/// The outline of a shape as a shape of its own: a band along it.
/// `sdf_stroke` paints it, and does so better from far away.
/// @param shape distance from the shape, below 0 inside
/// @param width width of the band, one half of it inside of the shape @default 0.05
float sdf_outline(float shape, float width) {
  // Not abs(shape), whose derivative is 0 in the middle of the band.
  return shape * (shape < 0.0 ? -1.0 : 1.0) - 0.5 * width;
}
