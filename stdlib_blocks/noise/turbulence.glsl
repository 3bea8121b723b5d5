// SPDX-License-Identifier: Apache-2.0
/// Fractal noise with sharp creases, as in marble, flames and smoke: of each octave the distance
/// from its mean, |2 noise - 1|, counts.
/// From 0 to 1. Each octave has gone to `far` where its cells are half as large as pixels, since
/// what is folded is twice as fine; the fading begins at a quarter. Octaves beyond are not
/// computed.
/// @source Perlin, An Image Synthesizer, SIGGRAPH 1985, "turbulence"
/// @param noise the noise, from 0 to 1 with the mean 0.5; with one cell for each unit, that is, at
///   its `scale` of 1. It learns that its cells are faded here already. A function of the graph may
///   take `octave` as well, as a seed for example @default unit_noise
/// @param uv coordinate @default uv
/// @param scale cells of the first octave for each unit of the coordinate @default 8
/// @param octaves how many times the noise is added @default 5 @range 1 16
/// @param lacunarity how much finer each octave is than the one before @default 2 @range 1 16
/// @param gain how strong each octave is, of the one before @default 0.5 @range 0 1
/// @param far the mean of |2 noise - 1|, which is also the result's: by default that of
///   `gradient_noise` in the plane; in space it is 0.196. Of `value_noise` it is 0.378 and 0.330,
///   of `simplex_noise` 0.391 and 0.220 @default 0.269 @range 0 1
float noise(genType uv, int octave, uint faded_cells);

float turbulence(genType uv, genType scale, const int octaves, const float lacunarity,
                 const float gain, float far) {
  genType p = uv * scale;
  float width = widest(footprint(uv) * abs(scale));
  float rest = 1.0 - pow(gain, float(octaves));
  float weight = gain == 1.0 ? 1.0 / float(octaves) : (1.0 - gain) / rest;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = far;
  for (int octave = 0; octave < octaves; ++octave) {
    float near = min(2.0 - 4.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float folded = abs(2.0 * noise(p * frequency + shift, octave, 1u) - 1.0);
      sum += weight * near * (folded - far);
    }
    frequency *= lacunarity;
    weight *= gain;
    shift += 37.7;
  }
  return sum;
}
