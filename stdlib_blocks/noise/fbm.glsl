// SPDX-License-Identifier: Apache-2.0
/// Fractal Brownian motion: the same noise again and again, each time finer and weaker, as in
/// clouds, coasts and hills.
/// The sum's weights are 1 together, so the result stays in the noise's range and has its mean.
/// Each octave is the noise at another place, so that they have nothing in common. Each has faded
/// where its cells are no larger than pixels, from two pixels on; it is not computed beyond. If the
/// noise has a period, and `lacunarity` is a whole number, so has the result.
/// @source Musgrave, in Ebert et al., Texturing and Modeling, 3rd edition, chapter 16, "fBm"
/// @param noise the noise, from 0 to 1 with the mean 0.5; with one cell for each unit, that is, at
///   its `scale` of 1. It learns that its cells are faded here already. A function of the graph may
///   take `octave` as well, as a seed for example @default unit_noise
/// @param uv coordinate @default uv
/// @param scale cells of the first octave for each unit of the coordinate @default 8
/// @param octaves how many times the noise is added @default 5 @range 1 16
/// @param lacunarity how much finer each octave is than the one before @default 2 @range 1 16
/// @param gain how strong each octave is, of the one before @default 0.5 @range 0 1
float noise(genType uv, int octave, uint faded_cells);

float fbm(genType uv, genType scale, const int octaves, const float lacunarity, const float gain) {
  genType p = uv * scale;
  float width = widest(footprint(uv) * abs(scale));
  float rest = 1.0 - pow(gain, float(octaves));
  float weight = gain == 1.0 ? 1.0 / float(octaves) : (1.0 - gain) / rest;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  for (int octave = 0; octave < octaves; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      sum += weight * near * (noise(p * frequency + shift, octave, 1u) - 0.5);
    }
    frequency *= lacunarity;
    weight *= gain;
    shift += 37.7;
  }
  return sum;
}
