// SPDX-License-Identifier: Apache-2.0
/// 1 where the value is above the edge, 0 where it is below, antialiased: a pixel that the edge
/// crosses gets its share.
/// The share is that of a straight edge, box filtered over the value's footprint: clamp((value -
/// edge) / width + 1/2).
/// @param value the value
/// @param edge where the result jumps @default 0.5
float threshold(float value, float edge) {
  return clamp((value - edge) / max(footprint(value), 1e-7) + 0.5, 0.0, 1.0);
}
