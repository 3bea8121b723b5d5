// SPDX-License-Identifier: Apache-2.0
/// The joints between tiles of any shape: 1 in a joint, 0 on the tiles, from the distance that a
/// grid gives.
/// A joint is as wide everywhere, in texture space; half of it belongs to each of the tiles that it
/// parts. Filtered analytically: near by it is the share that a straight joint has of a box as
/// large as the distance's footprint, raised by what the other joints of the tile add in the mean.
/// Where the footprint grows to half the spacing it begins to pass into the share of the whole
/// surface that is joints, 1 - (1 - width / spacing)^2, and has become that at the spacing itself.
/// There it is an estimate: off by at most 0.9 width / spacing in the mean.
/// For rectangles, `mortar` does the same from the tile alone and is more exact.
/// @param edge distance to the border of the tile, in texture space
/// @param width width of a joint, in texture space; at most the spacing @default 0.01 @range 0 1
/// @param spacing how far joints are from each other, in texture space, as the grid gives it: four
///   times the area of a tile over its perimeter
float joint(float edge, float width, float spacing) {
  float pixel = max(footprint(edge), 1e-7);
  float low = max(edge - 0.5 * pixel, -0.5 * width);
  float high = min(edge + 0.5 * pixel, 0.5 * width);
  float line = max(high - low, 0.0) / pixel;
  float far = clamp(2.0 * pixel / spacing - 1.0, 0.0, 1.0);
  // Over a whole tile the nearest joint alone would give 1 - pixel / (2 spacing) of the mean.
  line = min(line / (1.0 - 0.5 * min(pixel / spacing, 1.0)), 1.0);
  float brick = max(1.0 - width / spacing, 0.0);
  return mix(line, 1.0 - brick * brick, far);
}
