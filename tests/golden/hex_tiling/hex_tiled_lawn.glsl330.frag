// hex_tiled_lawn: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform float tiling;  // default 4.0
uniform float contrast;  // default 0.6

// Textures
uniform sampler2D lawn;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

// Types
struct Tile {
  uint seed;
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

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hex_frame (by_example/hex_frame.glsl)
void hex_frame(vec2 uv, vec2 cells, ivec2 node, vec2 uv_dx, vec2 uv_dy, out Tile tile,
    out vec2 place, out vec2 place_dx, out vec2 place_dy) {
  vec2 middle = vec2(float(node.x) + 0.5 * float(node.y & 1), float(node.y)) / cells;
  vec2 from = uv - middle;
  uint hash_value = hash(uint(node.x) + hash(uint(node.y) + 2131687100u));
  float blend = mix(-180.0, 180.0, float(hash(hash_value - 2u) >> 8u) * 5.9604645e-8);
  float angle = blend * 0.017453292;
  float c = cos(angle);
  float s = sin(angle);
  vec2 arm = c * from + s * vec2(from.y, -from.x);
  tile = Tile(hash_value);
  place = middle + arm;
  place_dx = uv_dx * c + vec2(uv_dx.y, -uv_dx.x) * s;
  place_dy = uv_dy * c + vec2(uv_dy.y, -uv_dy.x) * s;
}

// hex_tiling (by_example/hex_tiling.glsl)
vec4 hex_tiling(vec2 uv, vec2 tiling, float contrast, vec2 uv_dx, vec2 uv_dy) {
  vec2 cells = tiling * vec2(3.5, 4.0);
  vec3 shares;
  ivec2 first, second, third;
  hex_shares(uv * cells, shares, first, second, third);
  vec4 sum = vec4(0.0);
  float total = 0.0;
  for (int i = 0; i < 3; ++i) {
    float item = shares[i];
    if (item > 0.0) {
      Tile tile;
      vec2 place, place_dx, place_dy;
      hex_frame(uv, cells, i == 0 ? first : i == 1 ? second : third, uv_dx, uv_dy, tile, place,
          place_dx, place_dy);
      uint hash_value = hash(tile.seed - 1u);
      place = place * tiling + vec2(float(hash_value & 65535u), float(hash_value >> 16u))
          * 1.5258789e-5;
      place_dx *= tiling;
      place_dy *= tiling;
      vec4 texel = textureGrad(lawn, place, place_dx, place_dy);
      vec3 product = texel.xyz * texel.w;
      vec4 seen = vec4(product, texel.w);
      float own = mix(1.0, dot(product, vec3(0.2126, 0.7152, 0.0722)), contrast);
      float share = item * max(own, 0.001);
      sum += share * seen;
      total += share;
    }
  }
  vec4 ratio = sum / total;
  return vec4(ratio.xyz / max(ratio.w, 1e-20), ratio.w);
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // everywhere: hex_tiling (by_example/hex_tiling.glsl)
  vec4 everywhere = hex_tiling(uv, vec2(tiling), contrast, uv_dx, uv_dy);
  out_color = everywhere;
  out_roughness = 0.9;
}
