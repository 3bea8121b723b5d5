// gravel_tiles: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Textures
layout(location = 0, binding = 0) uniform sampler2D gravel;
layout(location = 1, binding = 1) uniform sampler2D gravel_relief;
layout(location = 2, binding = 2) uniform sampler2D gravel_height;

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

// tile_index (by_example/tile_index.glsl)
int tile_index(int first, int second) {
  int low;
  if (second > 0) {
    low = first * first + 2 * second - 1;
  } else {
    low = first * (first + 2);
  }
  return first < second ? 2 * first + second * second : low;
}

// corner_tile_place (by_example/corner_tile_place.glsl)
ivec2 corner_tile_place(ivec4 corners) {
  int below = tile_index(corners.x, corners.y);
  int row = (tile_index(corners.z, corners.w) - below + 9) % 9;
  int column = (below - row * (row - 1) / 2 + 144) % 9;
  return ivec2(column, row);
}

// corner_tiles (by_example/corner_tiles.glsl)
vec4 corner_tiles(sampler2D tiles, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 8.0;
  vec2 whole = floor(p);
  vec2 local = p - whole;
  ivec2 cell = ivec2(whole);
  ivec2 next = cell + 1;
  uvec2 rows = hash(uvec2(uint(cell.y), uint(next.y)) + 129708002u);
  uvec4 sum = uvec4(uint(cell.x), uint(next.x), uint(cell.x), uint(next.x)) + rows.xxyy;
  uvec4 bits = hash(sum);
  ivec2 place = corner_tile_place(ivec4(bits % 3u));
  vec2 ratio = (vec2(place) + local) / 9.0;
  vec4 color = textureGrad(tiles, ratio, uv_dx * 8.0 / 9.0, uv_dy * 8.0 / 9.0);
  return color;
}

// normal_map (materials/normal_map.glsl)
vec3 normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // stones: corner_tiles (by_example/corner_tiles.glsl)
  vec4 stones_color = corner_tiles(gravel, uv, uv_dx, uv_dy);
  // relief: corner_tiles (by_example/corner_tiles.glsl)
  vec4 relief_color = corner_tiles(gravel_relief, uv, uv_dx, uv_dy);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = normal_map(relief_color.xyz);
  // heights: corner_tiles (by_example/corner_tiles.glsl)
  vec4 heights_color = corner_tiles(gravel_height, uv, uv_dx, uv_dy);
  out_color = stones_color;
  out_normal = slope;
  out_height = heights_color.x;
  out_roughness = 0.8;
}
