// SPDX-License-Identifier: Apache-2.0
/// Rises from 0 to 1 in each unit of the phase, and falls back to 0 at whole numbers.
/// The exact mean over the phase's footprint: the jump is antialiased, and far away it is 0.5.
/// @source Peachey, in Ebert et al., Texturing and Modeling, 3rd edition, chapter 2, "Analytic
///   prefiltering"
/// @param phase where in the wave, in periods
float sawtooth_wave(float phase) {
  float width = max(footprint(phase), 1e-7);
  float low = fract(phase - 0.5 * width);
  float high = low + width;
  // The mean of low to high, less the mean of the whole numbers that are below: jumps gives their
  // number, and their sum's integral has no difference of nearly equal numbers.
  float jumps = floor(high);
  return low + 0.5 * width - jumps * (high - 0.5 * (jumps + 1.0)) / width;
}
