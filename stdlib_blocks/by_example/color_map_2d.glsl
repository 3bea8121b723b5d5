// SPDX-License-Identifier: Apache-2.0
// Between which layers along one axis a standard deviation lies: the index of the first, and the
// share of the second. Shares are those of squares, so that the mix has the variance asked for.
vec2 deviation_layer(float deviation, int layers) {
  // The second layer's deviation; the last one's is 1/4.
  float least = exp2(-float(layers));
  float index = clamp(floor(log2(max(deviation / least, 0.5))) + 1.0, 0.0, float(layers - 2));
  float low = index > 0.0 ? least * exp2(index - 1.0) : 0.0;
  float high = least * exp2(index);
  float share = (deviation * deviation - low * low) / (high * high - low * low);
  return vec2(index, clamp(share, 0.0, 1.0));
}

/// The colour that a map gives to two numbers, and its mean where the numbers are noise: of known
/// mean and deviation in each pixel.
/// From near the map's own colours are seen. From far away `noise_field` says how the noise varies
/// in a pixel, and the map has been filtered for that: what is small, or sharp, does not flicker.
/// One sample from near, four at most.
/// @source Grenier, Sauvage, Dischler and Thery, Color-mapped noise vector fields for generating
///   procedural micro-patterns, 2022, equations 5 and 6, with seven deviations, and mixed by their
///   squares
/// @param map a texture with the key `color_map`
/// @param value the two numbers, across and up in the map: 0 to 1
/// @param deviation the standard deviation of each in the pixel @default vec2(0) @range 0 1
/// @return the colour, straight alpha
vec4 color_map_2d(sampler2DArray map, vec2 value, vec2 deviation) {
  int side = int(sqrt(float(textureSize(map, 0).z)) + 0.5);
  vec2 x = deviation_layer(deviation.x, side);
  vec2 y = deviation_layer(deviation.y, side);
  float first = y.x * float(side) + x.x;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    vec2 step = vec2(float(i & 1), float(i >> 1));
    float share = (i & 1) == 1 ? x.y : 1.0 - x.y;
    share *= i > 1 ? y.y : 1.0 - y.y;
    if (share > 0.0) {
      vec4 seen = textureLod(map, vec3(value, first + step.x + step.y * float(side)), 0.0);
      sum += share * vec4(seen.rgb * seen.a, seen.a);
    }
  }
  return vec4(sum.rgb / max(sum.a, 1e-20), sum.a);
}
