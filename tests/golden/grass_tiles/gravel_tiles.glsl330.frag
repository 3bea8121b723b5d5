// gravel_tiles: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Textures
uniform sampler2DArray gravel_colors;
uniform sampler2DArray gravel_slopes;
uniform sampler2DArray gravel_height;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out float out_height;
layout(location = 3) out float out_roughness;

// hash (random/hash.glsl)
uvec2 hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// corner_tiles (by_example/corner_tiles.glsl)
vec4 corner_tiles(sampler2DArray tiles, vec2 uv) {
  vec2 p = uv * 8.0;
  ivec2 cell = ivec2(floor(p));
  ivec2 even = (cell + 1) & -2;
  ivec2 odd = cell | 1;
  uvec2 rows = hash(uvec2(uint(even.y), uint(odd.y)) + 129708002u);
  uvec4 sum = uvec4(uint(even.x), uint(odd.x), uint(even.x), uint(odd.x)) + rows.xxyy;
  uvec4 bits = hash(sum);
  ivec4 around = ivec4(bits % 3u);
  int layer = around.x + 3 * (around.y + 3 * (around.z + 3 * around.w));
  vec2 place = p * 0.5;
  vec4 color = texture(tiles, vec3(place, float(layer)));
  return color;
}

// normal_map (materials/normal_map.glsl)
vec3 normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

void main() {
  // stones: corner_tiles (by_example/corner_tiles.glsl)
  vec4 stones_color = corner_tiles(gravel_colors, uv);
  // relief: corner_tiles (by_example/corner_tiles.glsl)
  vec4 relief_color = corner_tiles(gravel_slopes, uv);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = normal_map(relief_color.xyz);
  // heights: corner_tiles (by_example/corner_tiles.glsl)
  vec4 heights_color = corner_tiles(gravel_height, uv);
  out_color = stones_color;
  out_normal = slope;
  out_height = heights_color.x;
  out_roughness = 0.8;
}
