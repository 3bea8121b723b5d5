// hex_tiled_gravel: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Textures
layout(location = 0, binding = 0) uniform sampler2D gravel;
layout(location = 1, binding = 1) uniform sampler2D gravel_relief;
layout(location = 2, binding = 2) uniform sampler2D gravel_heights;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out float out_height;
layout(location = 3) out float out_roughness;

// Types
struct Tile {
  uint seed;
  vec2 right;
  vec2 up;
};

// hex_shares (by_example/hex_shares.glsl)
void hex_shares(vec2 place, out vec3 shares, out ivec2 first, out ivec2 second, out ivec2 third) {
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
  vec3 shares2 = max(pow(near / most, vec3(7.0)) - 0.01, 0.0);
  shares = shares2 / (shares2.x + shares2.y + shares2.z);
  first = ivec2(first2.x + (first2.y >> 1), first2.y);
  second = ivec2(second2.x + (second2.y >> 1), second2.y);
  third = ivec2(third2.x + (third2.y >> 1), third2.y);
}

// wrap_cell (tiles/wrap_cell.glsl)
int wrap_cell_stones(int cell) {
  int flip = cell >> 31;
  return (((cell ^ flip) % 10) ^ flip) + (flip & 10);
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hex_frame (by_example/hex_frame.glsl)
void hex_frame(vec2 uv, ivec2 node, vec2 uv_dx, vec2 uv_dy, out Tile tile, out vec2 place,
    out vec2 place_dx, out vec2 place_dy) {
  vec2 middle = vec2(float(node.x) + 0.5 * float(node.y & 1), float(node.y)) / vec2(8.0, 10.0);
  vec2 from = uv - middle;
  int bits = node.x & 7;
  int wrap_cell_stones_value = wrap_cell_stones(node.y);
  uint hash_value = hash(uint(bits) + hash(uint(wrap_cell_stones_value) + 2831084092u));
  float blend = mix(-180.0, 180.0, float(hash(hash_value - 2u) >> 8u) * 5.9604645e-8);
  float angle = blend * 0.017453292;
  float c = cos(angle);
  float s = sin(angle);
  vec2 arm = c * from + s * vec2(from.y, -from.x);
  vec2 home = vec2(float(bits) + 0.5 * float(wrap_cell_stones_value & 1),
      float(wrap_cell_stones_value)) / vec2(8.0, 10.0);
  tile = Tile(hash_value, vec2(c, s), vec2(-s, c));
  place = home + arm;
  place_dx = uv_dx * c + vec2(uv_dx.y, -uv_dx.x) * s;
  place_dy = uv_dy * c + vec2(uv_dy.y, -uv_dy.x) * s;
}

// hex_tiling (by_example/hex_tiling.glsl)
vec4 hex_tiling(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec3 shares;
  ivec2 first, second, third;
  hex_shares(uv * vec2(8.0, 10.0), shares, first, second, third);
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = 0; i < 3; ++i) {
    float item = shares[i];
    if (item > 0.0) {
      Tile tile;
      vec2 place, place_dx, place_dy;
      hex_frame(uv, i == 0 ? first : i == 1 ? second : third, uv_dx, uv_dy, tile, place, place_dx,
          place_dy);
      uint hash_value = hash(tile.seed - 1u);
      place = place * 4.0 + vec2(float(hash_value & 65535u), float(hash_value >> 16u))
          * 1.5258789e-5;
      place_dx *= 4.0;
      place_dy *= 4.0;
      vec4 texel = textureGrad(gravel, place, place_dx, place_dy);
      vec4 seen = vec4(texel.xyz * texel.w, texel.w);
      float own = pow(max(textureGrad(gravel_heights, place, place_dx, place_dy).x, 1e-37), 4.0);
      float share = item * max(own, 0.001);
      sum += share * seen;
      total += share;
    }
  }
  vec4 ratio = sum / total;
  return vec4(ratio.xyz / max(ratio.w, 1e-20), ratio.w);
}

// normal_map (materials/normal_map.glsl)
vec3 normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

// hex_tiling_normal (by_example/hex_tiling_normal.glsl)
vec3 hex_tiling_normal(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec3 shares;
  ivec2 first, second, third;
  hex_shares(uv * vec2(8.0, 10.0), shares, first, second, third);
  vec3 sum = vec3(0.0);
  for (int i = 0; i < 3; ++i) {
    float item = shares[i];
    if (item > 0.0) {
      Tile tile;
      vec2 place, place_dx, place_dy;
      hex_frame(uv, i == 0 ? first : i == 1 ? second : third, uv_dx, uv_dy, tile, place, place_dx,
          place_dy);
      uint hash_value = hash(tile.seed - 1u);
      place = place * 4.0 + vec2(float(hash_value & 65535u), float(hash_value >> 16u))
          * 1.5258789e-5;
      place_dx *= 4.0;
      place_dy *= 4.0;
      vec3 n = normal_map(textureGrad(gravel_relief, place, place_dx, place_dy).xyz);
      vec2 slope = n.xy / max(n.z, 0.01);
      float own = pow(max(textureGrad(gravel_heights, place, place_dx, place_dy).x, 1e-37), 4.0);
      vec3 vector = vec3(slope.x * tile.right + slope.y * tile.up, 1.0);
      sum += item * max(own, 0.001) * vector;
    }
  }
  return sum * inversesqrt(dot(sum, sum));
}

// hex_tiling (by_example/hex_tiling.glsl)
float hex_tiling2(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec3 shares;
  ivec2 first, second, third;
  hex_shares(uv * vec2(8.0, 10.0), shares, first, second, third);
  float sum = 0.0;
  float total = 0.0;
  for (int i = 0; i < 3; ++i) {
    float item = shares[i];
    if (item > 0.0) {
      Tile tile;
      vec2 place, place_dx, place_dy;
      hex_frame(uv, i == 0 ? first : i == 1 ? second : third, uv_dx, uv_dy, tile, place, place_dx,
          place_dy);
      uint hash_value = hash(tile.seed - 1u);
      place = place * 4.0 + vec2(float(hash_value & 65535u), float(hash_value >> 16u))
          * 1.5258789e-5;
      place_dx *= 4.0;
      place_dy *= 4.0;
      float seen = textureGrad(gravel_heights, place, place_dx, place_dy).x;
      float own = pow(max(seen, 1e-37), 4.0);
      float share = item * max(own, 0.001);
      sum += share * seen;
      total += share;
    }
  }
  return sum / total;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // stones: hex_tiling (by_example/hex_tiling.glsl)
  vec4 stones = hex_tiling(uv, uv_dx, uv_dy);
  // facing: hex_tiling_normal (by_example/hex_tiling_normal.glsl)
  vec3 facing = hex_tiling_normal(uv, uv_dx, uv_dy);
  // level_here: hex_tiling (by_example/hex_tiling.glsl)
  float level_here = hex_tiling2(uv, uv_dx, uv_dy);
  out_color = stones;
  out_normal = facing;
  out_height = level_here;
  out_roughness = 0.85;
}
