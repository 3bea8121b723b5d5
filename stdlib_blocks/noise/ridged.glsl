// SPDX-License-Identifier: Apache-2.0
/// Fractal noise of sharp ridges, as in mountains, veins and lightning: of each octave
/// (1 - |2 noise - 1|)^2 counts, and `feedback` keeps the valleys smooth.
/// From 0 to 1. Each octave has gone to `far` where its cells are half as large as pixels, since
/// what is folded is twice as fine; the fading begins at a quarter. Octaves beyond are not
/// computed.
/// @source Musgrave, in Ebert et al., Texturing and Modeling, 3rd edition, chapter 16, "Ridged
///   multifractal"; here an octave is not cut off where it is strong, which keeps the mean
/// @param noise the noise, from 0 to 1 with the mean 0.5; with one cell for each unit, that is, at
///   its `scale` of 1. It learns that its cells are faded here already. A function of the graph may
///   take `octave` as well, as a seed for example @default unit_noise
/// @param uv coordinate @default uv
/// @param scale cells of the first octave for each unit of the coordinate @default 8
/// @param octaves how many times the noise is added @default 5 @range 1 16
/// @param lacunarity how much finer each octave is than the one before @default 2 @range 1 16
/// @param gain how strong each octave is, of the one before @default 0.5 @range 0 1
/// @param feedback how far an octave follows the one before it: at 0 all are equally rough
///   everywhere, at 1 an octave lies on the ridges of the one before alone @default 1 @range 0 1
/// @param far the mean of (1 - |2 noise - 1|)^2: by default that of `gradient_noise` in the plane;
///   in space it is 0.665. Of `value_noise` it is 0.448 and 0.500, of `simplex_noise` 0.423 and
///   0.637 @default 0.571 @range 0 1
float noise(genType uv, int octave, uint faded_cells);

float ridged(genType uv, genType scale, const int octaves, const float lacunarity,
             const float gain, float feedback, float far) {
  genType p = uv * scale;
  float width = widest(footprint(uv) * abs(scale));
  float rest = 1.0 - pow(gain, float(octaves));
  float weight = gain == 1.0 ? 1.0 / float(octaves) : (1.0 - gain) / rest;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.0;
  // Linear in each octave, and octaves are independent: means of octaves make the right mean.
  float carry = 1.0;
  for (int octave = 0; octave < octaves; ++octave) {
    float near = min(2.0 - 4.0 * width * frequency, 1.0);
    float ridge = far;
    if (near > 0.0) {
      float height = 1.0 - abs(2.0 * noise(p * frequency + shift, octave, 1u) - 1.0);
      ridge = mix(far, height * height, near);
    }
    ridge *= carry;
    sum += weight * ridge;
    carry = mix(1.0, ridge, feedback);
    frequency *= lacunarity;
    weight *= gain;
    shift += 37.7;
  }
  return sum;
}
