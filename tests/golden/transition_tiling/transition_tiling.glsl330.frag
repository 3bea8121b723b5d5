// transition_tiling: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Textures
uniform sampler2DArray grounds;
uniform sampler2D areas;
uniform sampler2D far;

// Outputs
layout(location = 0) out vec4 out_color;

// Constants
const int transitions[16] = int[16](-1, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, -1);

// cell_hash (indirection/cell_hash.glsl)
uint cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// dithered_area (indirection/dithered_area.glsl)
ivec2 dithered_area(ivec2 cell, uint seed) {
  ivec2 middle = 2 * (cell & 63) + 9;
  ivec2 last = middle >> 4;
  ivec2 share = middle & 15;
  uint bits = hash(seed + 1u);
  uvec2 numbers = uvec2(bits & 65535u, bits >> 16u);
  uvec2 luck = numbers >> 12u;
  return last - ivec2(lessThanEqual(share, ivec2(luck)));
}

// kind_at (a function of neighbour)
int kind_at_shore(vec2 uv) {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  ivec2 numbers = ivec2(floor(uv * 64.0) + vec2(1.0, 0.0));
  // kind: dithered_areas_map (indirection/dithered_areas_map.glsl)
  vec4 texel = texelFetch(areas, dithered_area(numbers, cell_hash(numbers)) & 7, 0);
  int kind = int(texel.x);
  return kind;
}

// kind_at (a function of neighbour)
int kind_at_shore2(vec2 uv) {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  ivec2 numbers = ivec2(floor(uv * 64.0) + vec2(0.0, 1.0));
  // kind: dithered_areas_map (indirection/dithered_areas_map.glsl)
  vec4 texel = texelFetch(areas, dithered_area(numbers, cell_hash(numbers)) & 7, 0);
  int kind = int(texel.x);
  return kind;
}

// kind_at (a function of neighbour)
int kind_at_shore3(vec2 uv) {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  ivec2 numbers = ivec2(floor(uv * 64.0) + 1.0);
  // kind: dithered_areas_map (indirection/dithered_areas_map.glsl)
  vec4 texel = texelFetch(areas, dithered_area(numbers, cell_hash(numbers)) & 7, 0);
  int kind = int(texel.x);
  return kind;
}

// transition_tiles (indirection/transition_tiles.glsl)
int transition_tiles(vec2 uv, int material) {
  int here = clamp(material, 0, 1);
  int right = clamp(kind_at_shore(uv), 0, 1);
  int up = clamp(kind_at_shore2(uv), 0, 1);
  int both = clamp(kind_at_shore3(uv), 0, 1);
  int number = here + 2 * (right + 2 * (up + 2 * both));
  bool plain = number == here * 15;
  int transition = plain ? -1 : transitions[number];
  return transition;
}

// drawn, of materials_map (indirection/materials_map.glsl)
int drawn(int material, uint seed) {
  int place = int(seed >> 29u);
  int row = clamp(material, 0, 1);
  int pattern = row * 8 + place;
  return material < 0 ? -1 : pattern;
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 64.0;
  vec2 whole = floor(product);
  ivec2 numbers = ivec2(whole);
  uint cell_hash_value = cell_hash(numbers);
  vec2 grid_local_dx = uv_dx * 64.0;
  vec2 grid_local_dy = uv_dy * 64.0;
  // kind: dithered_areas_map (indirection/dithered_areas_map.glsl)
  int kind = int(texelFetch(areas, dithered_area(numbers, cell_hash_value) & 7, 0).x);
  // shore: transition_tiles (indirection/transition_tiles.glsl)
  int shore_transition = transition_tiles(uv, kind);
  // plain: materials_map (indirection/materials_map.glsl)
  int plain = drawn(kind, cell_hash_value);
  // pattern: transition_pattern (indirection/transition_pattern.glsl)
  int pattern = shore_transition < 0 ? plain : shore_transition;
  // close: reference_texture (indirection/reference_texture.glsl)
  vec3 vector = vec3(product - whole, float(pattern));
  vec4 close = pattern < 0 ? vec4(0.0) : textureGrad(grounds, vector, grid_local_dx, grid_local_dy);
  // mean: image (images/image.glsl)
  vec4 mean = texture(far, uv);
  // near: tile_near (tiles/tile_near.glsl)
  float near = tile_near(grid_local_dx, grid_local_dy);
  // land: lerp (math/lerp.glsl)
  vec4 land = mix(mean, close, near);
  out_color = land;
}
