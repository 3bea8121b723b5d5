// gravel_tiles: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2D gravel;
uniform sampler2D gravel_relief;
uniform sampler2D gravel_height;

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

// tile_index (by_example/tile_index.glsl)
int gravel_tiles_tile_index(int first, int second) {
  int low;
  if (second > 0) {
    low = first * first + 2 * second - 1;
  } else {
    low = first * (first + 2);
  }
  return first < second ? 2 * first + second * second : low;
}

// corner_tile_place (by_example/corner_tile_place.glsl)
ivec2 gravel_tiles_corner_tile_place(ivec4 corners) {
  int below = gravel_tiles_tile_index(corners.x, corners.y);
  int row = (gravel_tiles_tile_index(corners.z, corners.w) - below + 9) % 9;
  int column = (below - row * (row - 1) / 2 + 144) % 9;
  return ivec2(column, row);
}

// corner_tiles (by_example/corner_tiles.glsl)
vec4 gravel_tiles_corner_tiles(sampler2D tiles, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 8.0;
  vec2 whole = floor(p);
  vec2 local = p - whole;
  ivec2 cell = ivec2(whole);
  ivec2 next = cell + 1;
  uvec2 rows = gravel_tiles_hash(uvec2(uint(cell.y), uint(next.y)) + 129708002u);
  uvec4 sum = uvec4(uint(cell.x), uint(next.x), uint(cell.x), uint(next.x)) + rows.xxyy;
  uvec4 bits = gravel_tiles_hash(sum);
  ivec2 place = gravel_tiles_corner_tile_place(ivec4(bits % 3u));
  vec2 ratio = (vec2(place) + local) / 9.0;
  vec4 color = textureGrad(tiles, ratio, uv_dx * 8.0 / 9.0, uv_dy * 8.0 / 9.0);
  return color;
}

// normal_map (materials/normal_map.glsl)
vec3 gravel_tiles_normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

void gravel_tiles(vec2 uv, out vec4 color, out vec3 normal, out float height, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // stones: corner_tiles (by_example/corner_tiles.glsl)
  vec4 stones_color = gravel_tiles_corner_tiles(gravel, uv, uv_dx, uv_dy);
  // relief: corner_tiles (by_example/corner_tiles.glsl)
  vec4 relief_color = gravel_tiles_corner_tiles(gravel_relief, uv, uv_dx, uv_dy);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = gravel_tiles_normal_map(relief_color.xyz);
  // heights: corner_tiles (by_example/corner_tiles.glsl)
  vec4 heights_color = gravel_tiles_corner_tiles(gravel_height, uv, uv_dx, uv_dy);
  color = stones_color;
  normal = slope;
  height = heights_color.x;
  roughness = 0.8;
}
