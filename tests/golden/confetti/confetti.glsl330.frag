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
void brick_grid_grid_1(vec2 uv, ivec2 neighbour, vec2 uv_dx, vec2 uv_dy, out Tile tile,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 9.0;
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = hash(uint(row) + 2831084092u);
  p = vec2(p.x + 0.5 * float(row & 1), p.y);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  tile = Tile(p - corner, vec2(0.11111111), hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * 9.0;
  tile_local_dy = uv_dy * 9.0;
}

// box_share (layers/box_share.glsl)
float box_share(vec2 q, vec2 cell_in_q, vec2 q_dx, vec2 q_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 covered = clamp(share, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void layer_element_sheet_1(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = 360.0 * pose.y * 0.017453292;
  float size = mix(0.6, 1.1, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hash(seed - 1u);
  vec2 center = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 point = vec2(cos(angle) * shrink);
  vec2 product = sin(angle) * shrink * across;
  vec2 q = point * p + (product * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product;
  alpha = box_share(q, vec2(shrink), q_dx, q_dy);
  inner = Tile(q, size * tile.size, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// circle (patterns/circle.glsl)
float circle(vec2 uv, float radius, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - 0.5;
  float from_center = length(difference);
  float greatest = max(from_center, 1e-20);
  float from_center_dx = dot(difference, uv_dx) / greatest;
  float from_center_dy = dot(difference, uv_dy) / greatest;
  float width = max(sqrt(from_center_dx * from_center_dx + from_center_dy * from_center_dy), 1e-7);
  float near = clamp((radius - from_center) / width + 0.5, 0.0, 1.0);
  vec2 pixel = sqrt(uv_dx * uv_dx + uv_dy * uv_dy);
  float far = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  return mix(near, min(3.1415927 * radius * radius, 1.0), far);
}

// random3 (random/random3.glsl)
vec3 random3(uint seed) {
  uint bits = hash(seed + 4u);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(hash(bits) >> 8u) * 5.9604645e-8);
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// draw_sheet_1, of layer (layers/layer.glsl)
vec4 draw_sheet_1(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  brick_grid_grid_1(uv, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_sheet_1(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 color = vec4(0.0);
  if (alpha > 0.0) {
    float circle_value = circle(inner.local, 0.45, inner_local_dx, inner_local_dy);
    vec3 blend = mix(vec3(0.5), random3(tile.seed), tile_near(tile_local_dx, tile_local_dy));
    vec3 blend2 = mix(vec3(0.5, 0.05, 0.02), vec3(1.0, 0.55, 0.2), blend);
    float product = (circle_value - circle(inner.local, 0.12, inner_local_dx, inner_local_dy))
        * alpha;
    color = vec4(mix(0.75, 1.0, clamp(inner.local.y, 0.0, 1.0)) * blend2, product);
  }
  return color;
}

// layer (layers/layer.glsl)
vec4 layer_sheet_1(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 color = vec4(0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && color.w < 0.999; --x) {
      vec4 other = draw_sheet_1(uv, ivec2(x, y), uv_dx, uv_dy);
      float below = other.w * (1.0 - color.w * on);
      color += vec4(other.xyz * below, below);
    }
  }
  color = vec4(color.xyz / max(color.w, 1e-20), min(color.w, 1.0));
  return color;
}

// brick_grid (tiles/brick_grid.glsl)
void brick_grid_grid_2(vec2 uv, int rows, int seed, ivec2 neighbour, vec2 uv_dx, vec2 uv_dy,
    out Tile tile, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * float(rows);
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = hash(uint(row) + hash(uint(seed)));
  float sum = 0.5 * float(row & 1) + float(hash(row_bits - 1u) >> 8u) * 5.9604645e-8;
  p = vec2(p.x + sum, p.y);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  tile = Tile(p - corner, vec2(1.0 / float(rows)), hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * float(rows);
  tile_local_dy = uv_dy * float(rows);
}

// layer_element (layers/layer_element.glsl)
void layer_element_sheet_2(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = 360.0 * pose.y * 0.017453292;
  float size = mix(0.5, 0.95, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hash(seed - 1u);
  vec2 center = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 point = vec2(cos(angle) * shrink);
  vec2 product = sin(angle) * shrink * across;
  vec2 q = point * p + (product * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product;
  uint hash_value3 = hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  alpha = mix(0.4, 1.0, luck.x) * box_share(q, vec2(shrink), q_dx, q_dy);
  inner = Tile(q, size * tile.size, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// draw_sheet_2, of layer (layers/layer.glsl)
vec4 draw_sheet_2(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  brick_grid_grid_2(uv, 14, 2, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_sheet_2(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 color = vec4(0.0);
  if (alpha > 0.0) {
    float circle_value = circle(inner.local, 0.45, inner_local_dx, inner_local_dy);
    vec3 blend = mix(vec3(0.5), random3(tile.seed), tile_near(tile_local_dx, tile_local_dy));
    vec3 blend2 = mix(vec3(0.02, 0.2, 0.35), vec3(0.2, 0.6, 0.9), blend);
    float product = (circle_value - circle(inner.local, 0.12, inner_local_dx, inner_local_dy))
        * alpha;
    color = vec4(mix(0.75, 1.0, clamp(inner.local.y, 0.0, 1.0)) * blend2, product);
  }
  return color;
}

// layer (layers/layer.glsl)
vec4 layer_sheet_2(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 color = vec4(0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && color.w < 0.999; --x) {
      vec4 other = draw_sheet_2(uv, ivec2(x, y), uv_dx, uv_dy);
      float below = other.w * (1.0 - color.w * on);
      color += vec4(other.xyz * below, below);
    }
  }
  color = vec4(color.xyz / max(color.w, 1e-20), min(color.w, 1.0));
  return color;
}

// layer_element (layers/layer_element.glsl)
void layer_element_sheet_3(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = 360.0 * pose.y * 0.017453292;
  float size = mix(0.4, 0.9, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hash(seed - 1u);
  vec2 center = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 point = vec2(cos(angle) * shrink);
  vec2 product = sin(angle) * shrink * across;
  vec2 q = point * p + (product * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product;
  uint hash_value3 = hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  alpha = mix(0.4, 1.0, luck.x) * box_share(q, vec2(shrink), q_dx, q_dy);
  inner = Tile(q, size * tile.size, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// draw_sheet_3, of layer (layers/layer.glsl)
vec4 draw_sheet_3(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  brick_grid_grid_2(uv, 20, 3, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_sheet_3(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 color = vec4(0.0);
  if (alpha > 0.0) {
    float circle_value = circle(inner.local, 0.45, inner_local_dx, inner_local_dy);
    vec3 blend = mix(vec3(0.5), random3(tile.seed), tile_near(tile_local_dx, tile_local_dy));
    vec3 blend2 = mix(vec3(0.25, 0.4, 0.02), vec3(0.75, 0.8, 0.15), blend);
    float product = (circle_value - circle(inner.local, 0.12, inner_local_dx, inner_local_dy))
        * alpha;
    color = vec4(mix(0.75, 1.0, clamp(inner.local.y, 0.0, 1.0)) * blend2, product);
  }
  return color;
}

// layer (layers/layer.glsl)
vec4 layer_sheet_3(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 color = vec4(0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && color.w < 0.999; --x) {
      vec4 other = draw_sheet_3(uv, ivec2(x, y), uv_dx, uv_dy);
      float below = other.w * (1.0 - color.w * on);
      color += vec4(other.xyz * below, below);
    }
  }
  color = vec4(color.xyz / max(color.w, 1e-20), min(color.w, 1.0));
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid_1: brick_grid (tiles/brick_grid.glsl)
  vec2 grid_1_local_dx = uv_dx * 9.0;
  vec2 grid_1_local_dy = uv_dy * 9.0;
  // grid_2: brick_grid (tiles/brick_grid.glsl)
  vec2 grid_2_local_dx = uv_dx * 14.0;
  vec2 grid_2_local_dy = uv_dy * 14.0;
  // grid_3: brick_grid (tiles/brick_grid.glsl)
  vec2 grid_3_local_dx = uv_dx * 20.0;
  vec2 grid_3_local_dy = uv_dy * 20.0;
  // sheet_1: layer (layers/layer.glsl)
  vec4 sheet_1_color = layer_sheet_1(uv, uv_dx, uv_dy, grid_1_local_dx, grid_1_local_dy);
  // sheet_2: layer (layers/layer.glsl)
  vec4 sheet_2_color = layer_sheet_2(uv, uv_dx, uv_dy, grid_2_local_dx, grid_2_local_dy);
  // sheet_3: layer (layers/layer.glsl)
  vec4 sheet_3_color = layer_sheet_3(uv, uv_dx, uv_dy, grid_3_local_dx, grid_3_local_dy);
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
