// SPDX-License-Identifier: Apache-2.0
/// Covers the plane with what looks like a picture and never repeats it: softly blended, without
/// loss of contrast, and right from far away.
/// A mean of several pictures is grey. Here the picture was turned into Gaussian noise before,
/// which can be blended without that, and a table turns the result back to the picture's colours.
/// For what has no order and no edges: sand, grass, rust, clouds; edges are blurred where hexagons
/// meet. A point takes at most six samples: three of the noise, three of the table.
/// @source Heitz and Neyret, High-Performance By-Example Noise using a Histogram-Preserving
///   Blending Operator, HPG 2018; Deliot and Heitz, Procedural Stochastic Textures by Tiling and
///   Blending, GPU Zen 2, 2019
/// @param noise the picture as noise: a texture with the key `gaussian`
/// @param table what turns it back: a texture with the key `table`, of the same picture
/// @param uv coordinate @default uv
/// @param tiling how often the picture stands side by side in each unit of the coordinate, across
///   and up @default vec2(1)
/// @param scale columns of hexagons in the width of a picture, and rows in its height; fewer keep
///   larger things whole @default vec2(3.5, 4)
/// @param exponent how short transitions are: 1 is as smooth as can be, larger ones take fewer
///   samples @default 2 @range 1 64
/// @param period after how many hexagons all repeats, columns and rows; 0 never. An odd number of
///   rows becomes the next even one @default ivec2(0) @range 0 65536
/// @param seed another seed gives another plane @default 0
/// @return the colour, opaque
vec4 histogram_tiling(sampler2D noise, sampler2DArray table, vec2 uv, vec2 tiling, vec2 scale,
                      float exponent, const ivec2 period, int seed) {
  vec3 weights;
  ivec2 first;
  ivec2 second;
  ivec2 third;
  hex_shares(uv * tiling * scale, exponent, weights, first, second, third);
  weights /= length(weights);
  ivec2 texels = textureSize(noise, 0);
  vec2 place = uv * tiling;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 3; ++i) {
    if (weights[i] > 0.0) {
      vec2 from = noise_offset(i == 0 ? first : i == 1 ? second : third, texels, period, seed);
      sum += weights[i] * texture(noise, place + from).rgb;
    }
  }
  // The table has a row for each level, and four standard deviations of 1/6 to both sides.
  vec2 right = footprint_x(place) * vec2(texels);
  vec2 up = footprint_y(place) * vec2(texels);
  float rows = float(textureSize(table, 0).y);
  float level = 0.5 * log2(max(max(dot(right, right), dot(up, up)), 1.0));
  float row = (min(level, rows - 1.0) + 0.5) / rows;
  vec3 color = vec3(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    color += textureLod(table, vec3(0.75 * sum[axis] + 0.5, row, axis), 0.0).rgb;
  }
  return vec4(color, 1.0);
}
