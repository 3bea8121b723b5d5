// grass_wang_tiles: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Textures
layout(location = 0, binding = 0) uniform sampler2DArray grass;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

// hash (random/hash.glsl)
uvec2 hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// wang_tiles (by_example/wang_tiles.glsl)
vec4 wang_tiles(sampler2DArray tiles, vec2 uv) {
  vec2 p = uv * 8.0;
  ivec2 cell = ivec2(floor(p));
  ivec2 next = cell + 1;
  bvec2 is_odd = equal(cell & 1, ivec2(1));
  uvec2 rows = hash(uvec2(uint(cell.y), uint(next.y)) + 129708002u);
  uvec2 hash_value = hash(uvec2(uint(cell.x), uint(next.x)) + rows.x);
  ivec2 across = ivec2((hash_value >> 16u) & 1u);
  ivec2 upwards = ivec2(uvec2(hash_value.x, hash(uint(cell.x) + rows.y)) & 1u);
  ivec2 stand = is_odd.x ? across.yx : across;
  ivec2 lie = is_odd.y ? upwards.yx : upwards;
  int layer = stand.x + 2 * (stand.y + 2 * (lie.x + 2 * lie.y));
  vec2 place = p * 0.5;
  vec4 color = texture(tiles, vec3(place, float(layer)));
  return color;
}

void main() {
  // blades: wang_tiles (by_example/wang_tiles.glsl)
  vec4 blades_color = wang_tiles(grass, uv);
  out_color = blades_color;
  out_roughness = 0.9;
}
