// SPDX-License-Identifier: Apache-2.0
/// Brings a number into the range from 0 to 1, as gradients go on beyond their ends.
/// The exact mean over the number's footprint: jumps and kinks are antialiased.
/// @source W3C, Scalable Vector Graphics 1.1, section 13.2.2, spreadMethod
/// @param value the number
/// @param spread what is beyond: pad, 0 and 1; repeat, the same again; reflect, there and back
///   @default SPREAD_PAD
float spread_range(float value, const int spread) {
  if (spread == SPREAD_REPEAT) {
    return sawtooth_wave(value);
  }
  if (spread == SPREAD_REFLECT) {
    return triangle_wave(0.5 * value);
  }
  float width = max(footprint(value), 1e-7);
  float below = clamp(0.5 - value / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - value) / width, 0.0, 1.0);
  // Between, the mean is the middle of what is between.
  float middle = value + 0.5 * width * (below - above);
  return above + (1.0 - below - above) * clamp(middle, 0.0, 1.0);
}
