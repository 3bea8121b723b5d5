// SPDX-License-Identifier: Apache-2.0
// What the three hexagons around a place show: two noises with their weights, and the variances
// within the footprint with the squares of these.
vec4 blend_noise(sampler2D noise, vec2 place, vec2 right, vec2 up, vec2 scale, float exponent,
                 const ivec2 period, int seed) {
  vec3 weights;
  ivec2 first;
  ivec2 second;
  ivec2 third;
  hex_shares(place * scale, exponent, weights, first, second, third);
  weights /= length(weights);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 3; ++i) {
    if (weights[i] > 0.0) {
      vec2 from = noise_offset(i == 0 ? first : i == 1 ? second : third, textureSize(noise, 0),
                               period, seed);
      vec4 seen = textureGrad(noise, place + from, right, up);
      sum += vec4(weights[i] * seen.xy, weights[i] * weights[i] * seen.zw);
    }
  }
  return sum;
}

/// Noise by example: covers the plane with the Gaussian noise of which a texture has an exemplar,
/// and never repeats it.
/// Every hexagon of a grid shows another part of the exemplar. Where they meet they are blended so
/// that the variance stays: their weights are divided by the root of the sum of their squares. With
/// the mean of a pixel's footprint comes the standard deviation of what is in it, so that whatever
/// is made of the noise can be filtered: `color_map_2d` takes both. A point takes at most three
/// samples for each tap.
/// @source Heitz and Neyret, High-Performance By-Example Noise using a Histogram-Preserving
///   Blending Operator, HPG 2018; Grenier, Sauvage, Dischler and Thery, Color-mapped noise vector
///   fields for generating procedural micro-patterns, 2022, equations 8 to 15
/// @param noise the exemplar: a texture with the key `noise`
/// @param uv coordinate @default uv
/// @param tiling how many exemplars side by side make a unit of the coordinate, across and up
///   @default vec2(4)
/// @param scale columns of hexagons in the width of an exemplar, and rows in its height; larger
///   hexagons keep longer waves @default vec2(3.5, 4)
/// @param exponent how short transitions are: 1 is as smooth as can be, larger ones take fewer
///   samples @default 2 @range 1 64
/// @param taps into how many parts a footprint is cut along each side: 2 makes the deviation much
///   more exact, for four times the samples @default 1 @range 1 4
/// @param period after how many hexagons all repeats, columns and rows; 0 never. An odd number of
///   rows becomes the next even one @default ivec2(0) @range 0 65536
/// @param seed another seed gives another plane @default 0
/// @param value both noises, around 1/2 with a standard deviation of 1/6: nearly all of 0 to 1
/// @param deviation of both in the pixel's footprint: 0 from near, 1/6 from far away
void noise_field(sampler2D noise, vec2 uv, vec2 tiling, vec2 scale, float exponent, const int taps,
                 const ivec2 period, int seed, out vec2 value, out vec2 deviation) {
  vec2 place = uv * tiling;
  float part = 1.0 / float(taps);
  vec2 right = footprint_x(place) * part;
  vec2 up = footprint_y(place) * part;
  vec2 mean = vec2(0.0);
  vec2 squares = vec2(0.0);
  vec2 variance = vec2(0.0);
  for (int j = 0; j < taps; ++j) {
    for (int i = 0; i < taps; ++i) {
      vec2 from = place + (float(i) + 0.5 - 0.5 * float(taps)) * right +
                  (float(j) + 0.5 - 0.5 * float(taps)) * up;
      vec4 seen = blend_noise(noise, from, right, up, scale, exponent, period, seed);
      mean += seen.xy;
      squares += seen.xy * seen.xy;
      variance += seen.zw;
    }
  }
  mean *= part * part;
  variance *= part * part;
  if (taps > 1) {
    variance += max(squares * (part * part) - mean * mean, 0.0);
  }
  value = 0.5 + mean;
  deviation = sqrt(max(variance, 0.0));
}
