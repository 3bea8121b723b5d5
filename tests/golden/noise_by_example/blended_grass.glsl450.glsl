// blended_grass: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2D grass_noise;
uniform sampler2DArray grass_table;

// hex_shares (by_example/hex_shares.glsl)
void blended_grass_hex_shares(vec2 place, out vec3 shares, out ivec2 first, out ivec2 second,
    out ivec2 third) {
  vec2 skewed = vec2(place.x - 0.5 * place.y, place.y);
  vec2 corner = floor(skewed);
  vec2 b = skewed - corner;
  float difference = 1.0 - b.x;
  float rest = difference - b.y;
  bool test = rest > 0.0;
  int upper = test ? 0 : 1;
  vec3 near;
  if (rest <= 0.0) {
    near = vec3(b.y - difference, 1.0 - b.y, difference);
  } else {
    near = vec3(rest, b.yx);
  }
  ivec2 base = ivec2(corner);
  ivec2 first2 = base + upper;
  int choice = test ? 1 : 0;
  ivec2 second2 = base + ivec2(upper, choice);
  ivec2 third2 = base + ivec2(choice, upper);
  float most = max(near.x, max(near.y, near.z));
  vec3 ratio = near / most;
  vec3 shares2 = max(ratio * ratio - 0.01, 0.0);
  shares = shares2 / (shares2.x + shares2.y + shares2.z);
  first = ivec2(first2.x + (first2.y >> 1), first2.y);
  second = ivec2(second2.x + (second2.y >> 1), second2.y);
  third = ivec2(third2.x + (third2.y >> 1), third2.y);
}

// hash (random/hash.glsl)
uint blended_grass_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// noise_offset (by_example/noise_offset.glsl)
vec2 blended_grass_noise_offset(ivec2 node, ivec2 texels) {
  vec2 size = vec2(texels);
  uint difference = blended_grass_hash(uint(node.x) + blended_grass_hash(uint(node.y) + 129708002u))
      - 1u;
  uint hash_value = blended_grass_hash(difference);
  vec2 product = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5 * size;
  return floor(product) / size;
}

// histogram_tiling (by_example/histogram_tiling.glsl)
vec4 blended_grass_histogram_tiling(sampler2D noise, sampler2DArray table, vec2 uv, vec2 uv_dx,
    vec2 uv_dy) {
  vec2 place = uv * 2.0;
  vec3 weights;
  ivec2 first, second, third;
  blended_grass_hex_shares(place * vec2(3.5, 4.0), weights, first, second, third);
  weights /= length(weights);
  ivec2 texels = textureSize(noise, 0);
  vec2 place_dx = uv_dx * 2.0;
  vec2 place_dy = uv_dy * 2.0;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 3; ++i) {
    float item = weights[i];
    if (item > 0.0) {
      vec2 from = blended_grass_noise_offset(i == 0 ? first : i == 1 ? second : third, texels);
      vec3 product = item * textureGrad(noise, place + from, place_dx, place_dy).xyz;
      sum += product;
    }
  }
  vec2 point = vec2(texels);
  vec2 right = place_dx * point;
  vec2 up = place_dy * point;
  float rows = float(textureSize(table, 0).y);
  float level = 0.5 * log2(max(max(dot(right, right), dot(up, up)), 1.0));
  float row = (min(level, rows - 1.0) + 0.5) / rows;
  vec3 color = vec3(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    vec4 texel = textureLod(table, vec3(0.75 * sum[axis] + 0.5, row, float(axis)), 0.0);
    color += texel.xyz;
  }
  return vec4(color, 1.0);
}

void blended_grass(vec2 uv, out vec4 color, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grass: histogram_tiling (by_example/histogram_tiling.glsl)
  vec4 grass = blended_grass_histogram_tiling(grass_noise, grass_table, uv, uv_dx, uv_dy);
  color = grass;
  roughness = 0.9;
}
