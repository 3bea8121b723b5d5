// SPDX-License-Identifier: Apache-2.0
const int ROUNDING_DOWN = 0;
const int ROUNDING_NEAREST = 1;
const int ROUNDING_UP = 2;

/// Makes a staircase of a value: so many steps for each unit, each as wide as high.
/// The exact mean over the value's footprint: edges are antialiased, and where many steps fall into
/// a pixel it is the value again, or half a step beside it.
/// @source Substance 3D Designer and Material Maker, "Quantize"; Blender, Posterize
/// @param value the value
/// @param steps how many for each unit; above 0 @default 4
/// @param rounding to which step a value goes @default ROUNDING_NEAREST
genType quantize(genType value, float steps, const int rounding) {
  float offset = rounding == ROUNDING_NEAREST ? 0.5 : rounding == ROUNDING_UP ? 1.0 : 0.0;
  genType place = value * steps + offset;
  genType width = max(footprint(value) * abs(steps), 1e-6);
  genType first = floor(place - 0.5 * width);
  genType high = place + 0.5 * width - first;
  genType jumps = floor(high);
  return (first + jumps * (high - 0.5 * (jumps + 1.0)) / width) / steps;
}
