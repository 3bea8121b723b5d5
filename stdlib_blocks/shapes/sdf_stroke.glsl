// SPDX-License-Identifier: Apache-2.0
/// The outline of a shape as a mask: 1 on a band along it, 0 elsewhere, antialiased.
/// The share of the pixel that is on the band, box filtered over the footprint of the distance:
/// exact for a straight outline, however thin it is. So a hairline fades from far away, and does
/// not break, as long as the pixel is smaller than the shape.
/// @param shape distance from the shape, below 0 inside
/// @param width width of the band @default 0.02
/// @param offset how far outside of the outline the middle of the band is; below 0 it is inside
///   @default 0
float sdf_stroke(float shape, float width, float offset) {
  float pixel = max(footprint(shape), 1e-7);
  float center = shape - offset;
  float low = max(center - 0.5 * pixel, -0.5 * width);
  float high = min(center + 0.5 * pixel, 0.5 * width);
  return clamp((high - low) / pixel, 0.0, 1.0);
}
