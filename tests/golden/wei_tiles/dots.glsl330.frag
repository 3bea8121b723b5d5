// dots: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Textures
uniform sampler2D dots;

// Outputs
layout(location = 0) out vec4 out_color;

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

// wang_tiles (by_example/wang_tiles.glsl)
vec4 wang_tiles(sampler2D tiles, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 6.0;
  vec2 whole = floor(p);
  vec2 local = p - whole;
  ivec2 cell = ivec2(whole);
  ivec2 next = cell + 1;
  uvec2 rows = hash(uvec2(uint(cell.y), uint(next.y)) + 2131687100u);
  uvec2 hash_value = hash(uvec2(uint(cell.x), uint(next.x)) + rows.x);
  ivec2 across = ivec2((hash_value >> 16u) & 1u);
  ivec2 upwards = ivec2(uvec2(hash_value.x, hash(uint(cell.x) + rows.y)) & 1u);
  ivec2 place = ivec2(tile_index(across.x, across.y), tile_index(upwards.x, upwards.y));
  vec4 color = textureGrad(tiles, (vec2(place) + local) * 0.25, uv_dx * 1.5, uv_dy * 1.5);
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // spots: wang_tiles (by_example/wang_tiles.glsl)
  vec4 spots_color = wang_tiles(dots, uv, uv_dx, uv_dy);
  out_color = spots_color;
}
