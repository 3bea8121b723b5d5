// SPDX-License-Identifier: Apache-2.0
/// Cuts a mask out of a grey picture: the higher the position, the more of it becomes white, the
/// brightest first.
/// What is above the edge 1 - position is white, what is below black; with less contrast a ramp of
/// the width 1 - contrast lies between them. At position 0 all is black, at 1 all white, whatever
/// the contrast. Filtered exactly for the value's footprint: a pixel shows the mean of what its
/// values become.
/// @source Substance 3D Designer, "Histogram Scan"
/// @param value from 0 to 1
/// @param position how much becomes white @default 0.5 @range 0 1
/// @param contrast 0 is a ramp as wide as all values, 1 an edge @default 0.8 @range 0 1
/// @return from 0 to 1
float histogram_scan(float value, float position, float contrast) {
  float ramp = max(1.0 - contrast, 1e-4);
  float pixel = max(footprint(value), 1e-5 * ramp);
  // The ends of the pixel, if the ramp goes from 0 to 1.
  float middle = (value - (1.0 - position) * (1.0 + ramp)) / ramp + 1.0;
  float low = middle - 0.5 * pixel / ramp;
  float high = middle + 0.5 * pixel / ramp;
  float from = clamp(low, 0.0, 1.0);
  float to = clamp(high, 0.0, 1.0);
  float sum = 0.5 * (to - from) * (to + from) + max(high - max(low, 1.0), 0.0);
  return sum / max(high - low, 1e-20);
}
