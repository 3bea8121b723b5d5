// SPDX-License-Identifier: Apache-2.0
/// A shape as a mask: 1 inside, 0 outside, with an edge that is one pixel wide, or softer.
/// The share of the pixel that is inside, for a straight edge, box filtered over the footprint of
/// the distance. A convex shape gets the area of a quarter of a pixel too much, whatever its size,
/// as long as it is larger than a pixel. A distance does not tell how large a shape is: one that is
/// smaller than a pixel remains a dot, or a line, unless `thickness` says how thick it is. A stripe
/// then has its share at every size of pixel.
/// @param shape distance from the shape, below 0 inside
/// @param softness how far the edge is spread, beside the width of a pixel @default 0
/// @param thickness how thick the shape is, if it is a stripe or a stroke; from a million on it
///   does not matter @default 1e6
float sdf_fill(float shape, float softness, float thickness) {
  float width = max(softness, 0.0) + max(footprint(shape), 1e-7);
  float share = 0.5 - shape / width;
  if (thickness < 1e6) {
    share = min(share, thickness / width);
  }
  return clamp(share, 0.0, 1.0);
}
