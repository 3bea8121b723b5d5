// gravel_tiles: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2DArray gravel_colors;
uniform sampler2DArray gravel_slopes;
uniform sampler2DArray gravel_height;

// hash (random/hash.glsl)
uvec2 gravel_tiles_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 gravel_tiles_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// corner_tiles (by_example/corner_tiles.glsl)
vec4 gravel_tiles_corner_tiles(sampler2DArray tiles, vec2 uv) {
  vec2 p = uv * 8.0;
  ivec2 cell = ivec2(floor(p));
  ivec2 even = (cell + 1) & -2;
  ivec2 odd = cell | 1;
  uvec2 rows = gravel_tiles_hash(uvec2(uint(even.y), uint(odd.y)) + 129708002u);
  uvec4 sum = uvec4(uint(even.x), uint(odd.x), uint(even.x), uint(odd.x)) + rows.xxyy;
  uvec4 bits = gravel_tiles_hash(sum);
  ivec4 around = ivec4(bits % 3u);
  int layer = around.x + 3 * (around.y + 3 * (around.z + 3 * around.w));
  vec2 place = p * 0.5;
  vec4 color = texture(tiles, vec3(place, float(layer)));
  return color;
}

// normal_map (materials/normal_map.glsl)
vec3 gravel_tiles_normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

void gravel_tiles(vec2 uv, out vec4 color, out vec3 normal, out float height, out float roughness) {
  // stones: corner_tiles (by_example/corner_tiles.glsl)
  vec4 stones_color = gravel_tiles_corner_tiles(gravel_colors, uv);
  // relief: corner_tiles (by_example/corner_tiles.glsl)
  vec4 relief_color = gravel_tiles_corner_tiles(gravel_slopes, uv);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = gravel_tiles_normal_map(relief_color.xyz);
  // heights: corner_tiles (by_example/corner_tiles.glsl)
  vec4 heights_color = gravel_tiles_corner_tiles(gravel_height, uv);
  color = stones_color;
  normal = slope;
  height = heights_color.x;
  roughness = 0.8;
}
