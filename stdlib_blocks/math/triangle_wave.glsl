// SPDX-License-Identifier: Apache-2.0
/// Rises from 0 to 1 in the first half of each unit of the phase, and falls back in the second.
/// The exact mean over the phase's footprint, which far away is 0.5.
/// @source Peachey, in Ebert et al., Texturing and Modeling, 3rd edition, chapter 2, "Analytic
///   prefiltering"
/// @param phase where in the wave, in periods
float triangle_wave(float phase) {
  float width = max(footprint(phase), 1e-7);
  float from_top = abs(fract(phase) - 0.5);
  if (width < 0.5) {
    // At most one kink in the pixel, at `away`. The mean of |x| over x - h to x + h is |x|, and
    // where 0 lies within, (h - |x|)^2 / 2h more.
    float away = min(from_top, 0.5 - from_top);
    float beyond = max(0.5 * width - away, 0.0);
    float rounded = away + beyond * beyond / width;
    return from_top < 0.25 ? 1.0 - 2.0 * rounded : 2.0 * rounded;
  }
  // With g from -1/2 to 1/2 the wave is 1 - 2|g|, and less its mean it has the integral
  // g (1/2 - |g|), which is 0 at both ends.
  float low = fract(phase - 0.5 * width) - 0.5;
  float high = fract(phase + 0.5 * width) - 0.5;
  vec2 place = vec2(low, high);
  vec2 integral = place * (0.5 - abs(place));
  return 0.5 + (integral.y - integral.x) / width;
}
