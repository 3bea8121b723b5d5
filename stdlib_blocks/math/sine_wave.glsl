// SPDX-License-Identifier: Apache-2.0
/// A sine that goes from 0 to 1 and back once in each unit of the phase; at 0 it is 0.5, and rises.
/// The exact mean over the phase's footprint, which far away is 0.5.
/// @source the box filter of a sine is sin(pi w) / (pi w) times the sine
/// @param phase where in the wave, in periods
float sine_wave(float phase) {
  float width = 3.14159265359 * max(footprint(phase), 1e-4);
  return 0.5 + 0.5 * sin(6.28318530718 * fract(phase)) * sin(width) / width;
}
