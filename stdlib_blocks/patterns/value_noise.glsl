// SPDX-License-Identifier: Apache-2.0
float corner(int x, uint row) { return float(hash(uint(x) + row) >> 8u) * 5.9604644775390625e-8; }

/// Smooth random hills: a random number from 0 to 1 at each corner of a square grid, and between
/// them a curve without kinks.
/// The curve is 6t^5 - 15t^4 + 10t^3. Where a cell is no larger than a pixel, the result has faded
/// to its mean, 0.5; the fading begins where a cell is two pixels large.
/// @source Ebert et al., Texturing and Modeling, 3rd edition, chapter 2, "Lattice noises"; the
///   curve: Perlin, Improving Noise, SIGGRAPH 2002; the fading: Apodaca and Gritz, Advanced
///   RenderMan, chapter 11
/// @param uv coordinate @default uv
/// @param scale cells for each unit of the coordinate @default vec2(8)
/// @param seed another seed gives another pattern @default 0
float value_noise(vec2 uv, vec2 scale, int seed) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  ivec2 cell = ivec2(base);
  uint stream = hash(uint(seed));
  uint row0 = hash(uint(cell.y) + stream);
  uint row1 = hash(uint(cell.y + 1) + stream);
  float low = mix(corner(cell.x, row0), corner(cell.x + 1, row0), fade.x);
  float high = mix(corner(cell.x, row1), corner(cell.x + 1, row1), fade.x);
  vec2 width = footprint(p);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}
