// SPDX-License-Identifier: Apache-2.0
/// 1 in the first part of each unit of the phase, 0 in the rest: stripes.
/// The exact mean over the phase's footprint: edges are antialiased, and far away it is the share.
/// @source Peachey, in Ebert et al., Texturing and Modeling, 3rd edition, chapter 2, "Analytic
///   prefiltering"
/// @param phase where in the wave, in periods
/// @param share how much of each period is 1 @default 0.5 @range 0 1
float square_wave(float phase, float share) {
  float width = max(footprint(phase), 1e-7);
  float from_middle = abs(fract(phase - 0.5 * share + 0.5) - 0.5);
  if (width < min(share, 1.0 - share)) {
    return clamp((0.5 * share - from_middle) / width + 0.5, 0.0, 1.0);
  }
  float wide = max(width, 1e-4);
  float low = fract(phase - 0.5 * wide);
  float high = low + wide;
  float whole = floor(high);
  float covered = whole * share + min(high - whole, share) - min(low, share);
  return clamp(covered / wide, 0.0, 1.0);
}
