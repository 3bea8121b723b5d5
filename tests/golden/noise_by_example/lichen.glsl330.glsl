// lichen: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec2 lichen_tiling;  // default vec2(1.5)

// Textures
uniform sampler2D growth;
uniform sampler2DArray lichen_map;

// hex_shares (by_example/hex_shares.glsl)
void lichen_hex_shares(vec2 place, out vec3 shares, out ivec2 first, out ivec2 second,
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
uint lichen_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// noise_offset (by_example/noise_offset.glsl)
vec2 lichen_noise_offset(ivec2 node, ivec2 texels) {
  vec2 size = vec2(texels);
  uint difference = lichen_hash(uint(node.x) + lichen_hash(uint(node.y) + 129708002u)) - 1u;
  uint hash_value = lichen_hash(difference);
  vec2 product = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5 * size;
  return floor(product) / size;
}

// blend_noise, of noise_field (by_example/noise_field.glsl)
vec4 lichen_blend_noise(sampler2D noise, vec2 place, vec2 right, vec2 up) {
  vec3 weights;
  ivec2 first, second, third;
  lichen_hex_shares(place * vec2(3.5, 4.0), weights, first, second, third);
  weights /= length(weights);
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 3; ++i) {
    float item = weights[i];
    if (item > 0.0) {
      vec2 from = lichen_noise_offset(i == 0 ? first : i == 1 ? second : third,
          textureSize(noise, 0));
      vec4 seen = textureGrad(noise, place + from, right, up);
      vec4 vector = vec4(item * seen.xy, item * item * seen.zw);
      sum += vector;
    }
  }
  return sum;
}

// noise_field (by_example/noise_field.glsl)
void lichen_noise_field(sampler2D noise, vec2 uv, vec2 tiling, vec2 uv_dx, vec2 uv_dy,
    out vec2 value, out vec2 deviation) {
  vec2 place = uv * tiling;
  vec2 place_dx = uv_dx * tiling;
  vec2 place_dy = uv_dy * tiling;
  vec4 seen = lichen_blend_noise(noise, place, place_dx, place_dy);
  value = 0.5 + seen.xy;
  deviation = sqrt(max(seen.zw, 0.0));
}

// deviation_layer, of color_map_2d (by_example/color_map_2d.glsl)
vec2 lichen_deviation_layer(float deviation, int layers) {
  float least = exp2(-float(layers));
  float index = clamp(floor(log2(max(deviation / least, 0.5))) + 1.0, 0.0, float(layers - 2));
  float low = index > 0.0 ? least * exp2(index - 1.0) : 0.0;
  float high = least * exp2(index);
  float product = low * low;
  float share = (deviation * deviation - product) / (high * high - product);
  return vec2(index, clamp(share, 0.0, 1.0));
}

// color_map_2d (by_example/color_map_2d.glsl)
vec4 lichen_color_map_2d(sampler2DArray map, vec2 value, vec2 deviation) {
  int side = int(sqrt(float(textureSize(map, 0).z)) + 0.5);
  vec2 x = lichen_deviation_layer(deviation.x, side);
  vec2 y = lichen_deviation_layer(deviation.y, side);
  float first = y.x * float(side) + x.x;
  vec4 sum = vec4(0.0);
  for (int i = 0; i < 4; ++i) {
    int bits = i & 1;
    float share = bits == 1 ? x.y : 1.0 - x.y;
    share *= i > 1 ? y.y : 1.0 - y.y;
    if (share > 0.0) {
      vec3 vector = vec3(value, first + float(bits) + float(i >> 1) * float(side));
      vec4 seen = textureLod(map, vector, 0.0);
      sum += share * vec4(seen.xyz * seen.w, seen.w);
    }
  }
  return vec4(sum.xyz / max(sum.w, 1e-20), sum.w);
}

void lichen(vec2 uv, out vec4 color, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grown: noise_field (by_example/noise_field.glsl)
  vec2 grown_value, grown_deviation;
  lichen_noise_field(growth, uv, lichen_tiling, uv_dx, uv_dy, grown_value, grown_deviation);
  // lichen: color_map_2d (by_example/color_map_2d.glsl)
  vec4 lichen2 = lichen_color_map_2d(lichen_map, grown_value, grown_deviation);
  color = lichen2;
  roughness = 0.95;
}
