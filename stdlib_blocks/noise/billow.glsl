// SPDX-License-Identifier: Apache-2.0
/// Fractal noise of round lumps with creases between them, as in cumulus clouds and boulders: of
/// each octave |2 noise - 1| counts, and `feedback` keeps the creases clean.
/// From 0 to 1. Each octave has gone to `far` where its cells are half as large as pixels, since
/// what is folded is twice as fine; the fading begins at a quarter. Octaves beyond are not
/// computed.
/// @source Musgrave, in Ebert et al., Texturing and Modeling, 3rd edition, chapter 16, "Hybrid
///   multifractal", on the folded noise of Perlin, An Image Synthesizer, SIGGRAPH 1985
/// @param noise the noise, from 0 to 1 with the mean 0.5; with one cell for each unit, that is, at
///   its `scale` of 1. It learns that its cells are faded here already. A function of the graph may
///   take `octave` as well, as a seed for example @default unit_noise
/// @param uv coordinate @default uv
/// @param scale cells of the first octave for each unit of the coordinate @default 8
/// @param octaves how many times the noise is added @default 5 @range 1 16
/// @param lacunarity how much finer each octave is than the one before @default 2 @range 1 16
/// @param gain how strong each octave is, of the one before @default 0.5 @range 0 1
/// @param feedback how far an octave follows the one before it: at 0 all are equally rough
///   everywhere, at 1 an octave vanishes in the creases of the one before @default 0.7 @range 0 1
/// @param far the mean of |2 noise - 1|: by default that of `gradient_noise` in the plane; in space
///   it is 0.196. Of `value_noise` it is 0.378 and 0.330, of `simplex_noise` 0.391 and 0.220
///   @default 0.269 @range 0 1
float noise(genType uv, int octave, uint faded_cells);

float billow(genType uv, genType scale, const int octaves, const float lacunarity,
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
    float lump = far;
    if (near > 0.0) {
      lump = mix(far, abs(2.0 * noise(p * frequency + shift, octave, 1u) - 1.0), near);
    }
    lump *= carry;
    sum += weight * lump;
    carry = mix(1.0, lump, feedback);
    frequency *= lacunarity;
    weight *= gain;
    shift += 37.7;
  }
  return sum;
}
