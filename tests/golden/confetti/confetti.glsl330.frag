// confetti: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform vec4 ground;  // default vec4(0.86, 0.84, 0.8, 1.0)

// Outputs
layout(location = 0) out vec4 out_color;

// Types
struct Tile {
  ivec2 cell;
  vec2 local;
  vec2 size;
  uint seed;
};

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// brick_grid (tiles/brick_grid.glsl)
void brick_grid_grid_1(vec2 uv, vec2 uv_dx, vec2 uv_dy, out Tile tile, out vec2 tile_local_dx,
    out vec2 tile_local_dy) {
  vec2 p = uv * 9.0;
  int row = int(floor(p.y));
  uint row_bits = hash(uint(row) + hash(1u));
  p = vec2(p.x + 0.5 * float(row & 1), p.y);
  vec2 corner = floor(p);
  int column = int(corner.x);
  tile = Tile(ivec2(column, row), p - corner, vec2(0.11111111), hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * 9.0;
  tile_local_dy = uv_dy * 9.0;
}

// brick_grid (tiles/brick_grid.glsl)
void brick_grid_grid_2(vec2 uv, int rows, int columns, int seed, vec2 uv_dx, vec2 uv_dy,
    out Tile tile, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 cells = vec2(float(columns), float(rows));
  vec2 p = uv * cells;
  int row = int(floor(p.y));
  uint row_bits = hash(uint(row) + hash(uint(seed)));
  float sum = 0.5 * float(row & 1) + float(hash(row_bits - 1u) >> 8u) * 5.9604645e-8;
  p = vec2(p.x + sum, p.y);
  vec2 corner = floor(p);
  int column = int(corner.x);
  tile = Tile(ivec2(column, row), p - corner, 1.0 / cells, hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * cells;
  tile_local_dy = uv_dy * cells;
}

// random3 (random/random3.glsl)
vec3 random3(uint seed) {
  uint bits = hash(seed + 4u);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(hash(bits) >> 8u) * 5.9604645e-8);
}

// circle (patterns/circle.glsl)
float circle(vec2 uv, float radius, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - 0.5;
  float from_center = length(difference);
  float greatest = max(from_center, 1e-20);
  float from_center_dx = dot(difference, uv_dx) / greatest;
  float from_center_dy = dot(difference, uv_dy) / greatest;
  float width = max(sqrt(from_center_dx * from_center_dx + from_center_dy * from_center_dy), 1e-7);
  return clamp((radius - from_center) / width + 0.5, 0.0, 1.0);
}

// coverage, of layer (layers/layer.glsl)
float coverage(vec2 q, vec2 cell_in_q, vec2 local, vec2 q_dx, vec2 q_dy, vec2 local_dx,
    vec2 local_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 cell_width = clamp(sqrt(local_dx * local_dx + local_dy * local_dy), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer (layers/layer.glsl)
vec4 layer_sheet_1(Tile tile, vec3 tint, vec2 tile_local_dx, vec2 tile_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = 360.0 * pose.y * 0.017453292;
  float size = mix(0.5, 0.75, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.4), vec2(0.6), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 point = vec2(cos(angle) * shrink);
  vec2 product2 = sin(angle) * shrink * across;
  vec2 q = point * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product2;
  float coverage_value = coverage(q, vec2(shrink), tile.local, q_dx, q_dy, tile_local_dx,
      tile_local_dy);
  float product3 = (circle(q, 0.45, q_dx, q_dy) - circle(q, 0.12, q_dx, q_dy)) * coverage_value;
  vec4 color = vec4(mix(0.75, 1.0, clamp(q.y, 0.0, 1.0)) * tint, product3);
  return color;
}

// layer (layers/layer.glsl)
vec4 layer_sheet_2(Tile tile, vec2 position_min, vec2 position_max, vec2 scale, vec3 tint,
    vec2 tile_local_dx, vec2 tile_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = 360.0 * pose.y * 0.017453292;
  float size = mix(scale.x, scale.y, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(position_min, position_max, product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 point = vec2(cos(angle) * shrink);
  vec2 product2 = sin(angle) * shrink * across;
  vec2 q = point * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product2;
  float difference = circle(q, 0.45, q_dx, q_dy) - circle(q, 0.12, q_dx, q_dy);
  vec3 product3 = mix(0.75, 1.0, clamp(q.y, 0.0, 1.0)) * tint;
  uint hash_value3 = hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float coverage_value = coverage(q, vec2(shrink), tile.local, q_dx, q_dy, tile_local_dx,
      tile_local_dy);
  vec4 color = vec4(product3, difference * (mix(0.4, 1.0, luck.x) * coverage_value));
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid_1: brick_grid (tiles/brick_grid.glsl)
  Tile grid_1;
  vec2 grid_1_local_dx, grid_1_local_dy;
  brick_grid_grid_1(uv, uv_dx, uv_dy, grid_1, grid_1_local_dx, grid_1_local_dy);
  // grid_2: brick_grid (tiles/brick_grid.glsl)
  Tile grid_2;
  vec2 grid_2_local_dx, grid_2_local_dy;
  brick_grid_grid_2(uv, 14, 14, 2, uv_dx, uv_dy, grid_2, grid_2_local_dx, grid_2_local_dy);
  // grid_3: brick_grid (tiles/brick_grid.glsl)
  Tile grid_3;
  vec2 grid_3_local_dx, grid_3_local_dy;
  brick_grid_grid_2(uv, 20, 20, 3, uv_dx, uv_dy, grid_3, grid_3_local_dx, grid_3_local_dy);
  // color_1: tile_random_color (tiles/tile_random_color.glsl)
  vec3 color_1 = mix(vec3(0.5, 0.05, 0.02), vec3(1.0, 0.55, 0.2), random3(grid_1.seed));
  // color_2: tile_random_color (tiles/tile_random_color.glsl)
  vec3 color_2 = mix(vec3(0.02, 0.2, 0.35), vec3(0.2, 0.6, 0.9), random3(grid_2.seed));
  // color_3: tile_random_color (tiles/tile_random_color.glsl)
  vec3 color_3 = mix(vec3(0.25, 0.4, 0.02), vec3(0.75, 0.8, 0.15), random3(grid_3.seed));
  // sheet_1: layer (layers/layer.glsl)
  vec4 sheet_1_color = layer_sheet_1(grid_1, color_1, grid_1_local_dx, grid_1_local_dy);
  // sheet_2: layer (layers/layer.glsl)
  vec4 sheet_2_color = layer_sheet_2(grid_2, vec2(0.35), vec2(0.65), vec2(0.4, 0.65), color_2,
      grid_2_local_dx, grid_2_local_dy);
  // sheet_3: layer (layers/layer.glsl)
  vec4 sheet_3_color = layer_sheet_2(grid_3, vec2(0.3), vec2(0.7), vec2(0.3, 0.6), color_3,
      grid_3_local_dx, grid_3_local_dy);
  // lower: over (layers/over.glsl)
  float blend = mix(ground.w, 1.0, sheet_3_color.w);
  vec3 blend2 = mix(ground.xyz, sheet_3_color.xyz, sheet_3_color.w / max(blend, 1e-20));
  // middle: over (layers/over.glsl)
  float blend3 = mix(blend, 1.0, sheet_2_color.w);
  vec3 blend4 = mix(blend2, sheet_2_color.xyz, sheet_2_color.w / max(blend3, 1e-20));
  // upper: over (layers/over.glsl)
  float blend5 = mix(blend3, 1.0, sheet_1_color.w);
  vec3 blend6 = mix(blend4, sheet_1_color.xyz, sheet_1_color.w / max(blend5, 1e-20));
  vec4 upper = vec4(blend6, blend5);
  out_color = upper;
}
