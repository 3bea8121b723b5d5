// grass_with_corners: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Textures
layout(location = 0, binding = 0) uniform sampler2D grass_atlas;
layout(location = 1, binding = 1) uniform sampler2D grass_corners;

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
  vec2 p = uv * 16.0;
  vec2 whole = floor(p);
  vec2 local = p - whole;
  ivec2 cell = ivec2(whole);
  ivec2 next = cell + 1;
  uvec2 rows = hash(uvec2(uint(cell.y), uint(next.y)) + 129708002u);
  uvec2 hash_value = hash(uvec2(uint(cell.x), uint(next.x)) + rows.x);
  ivec2 across = ivec2((hash_value >> 16u) & 1u);
  ivec2 upwards = ivec2(uvec2(hash_value.x, hash(uint(cell.x) + rows.y)) & 1u);
  ivec2 place = ivec2(tile_index(across.x, across.y), tile_index(upwards.x, upwards.y));
  vec4 color = textureGrad(tiles, (vec2(place) + local) * 0.25, uv_dx * 4.0, uv_dy * 4.0);
  return color;
}

// wang_corners (by_example/wang_corners.glsl)
void wang_corners(sampler2D corners, vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec4 color,
    out float weight) {
  vec2 p = uv * 16.0;
  ivec2 corner = ivec2(floor(p + 0.5));
  vec2 away = p - vec2(corner);
  ivec2 before = corner - 1;
  vec2 texel = 4.0 / vec2(textureSize(corners, 0));
  vec2 p_dx = uv_dx * 16.0;
  vec2 p_dy = uv_dy * 16.0;
  vec2 within = min(max(texel, sqrt(p_dx * p_dx + p_dy * p_dy)), 0.0625);
  vec2 near = clamp(2.0 - abs(away) / within, 0.0, 1.0);
  uvec2 rows = hash(uvec2(uint(before.y), uint(corner.y)) + 129708002u);
  uint own = hash(uint(corner.x) + rows.y);
  int right = int(own & 1u);
  int left = int(hash(uint(before.x) + rows.y) & 1u);
  int top = int((own >> 16u) & 1u);
  int bottom = int((hash(uint(corner.x) + rows.x) >> 16u) & 1u);
  ivec2 place = ivec2(tile_index(left, right), tile_index(bottom, top));
  vec2 product = (vec2(place) + (away + 1.0)) * 0.25;
  color = textureGrad(corners, product, uv_dx * 4.0, uv_dy * 4.0);
  weight = min(near.x, near.y);
}

// wang_tiles_with_corners (by_example/wang_tiles_with_corners.glsl)
vec4 wang_tiles_with_corners(sampler2D tiles, sampler2D corners, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec4 edges = wang_tiles(tiles, uv, uv_dx, uv_dy);
  vec4 around;
  float weight;
  wang_corners(corners, uv, uv_dx, uv_dy, around, weight);
  float alpha = mix(edges.w, around.w, weight);
  vec3 light = mix(edges.xyz * edges.w, around.xyz * around.w, weight);
  vec4 color = vec4(light / max(alpha, 1e-20), alpha);
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // meadow: wang_tiles_with_corners (by_example/wang_tiles_with_corners.glsl)
  vec4 meadow_color = wang_tiles_with_corners(grass_atlas, grass_corners, uv, uv_dx, uv_dy);
  out_color = meadow_color;
  out_roughness = 0.9;
}
