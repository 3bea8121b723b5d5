// SPDX-License-Identifier: Apache-2.0
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
  uvec2 cell = uvec2(ivec2(base));
  uvec2 columns = uvec2(cell.x, cell.x + 1u);
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(uint(seed)));
  vec4 corners = vec4(hash(columns.xyxy + rows.xxyy) >> 8u) * 5.9604644775390625e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = footprint(uv) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}
