// desert: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform vec3 sand;  // default vec3(0.62, 0.42, 0.24)

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

// value_noise (noise/value_noise.glsl)
float value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * scale;
  vec2 t_dy = uv_dy * scale;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(uint(seed)));
  uvec4 bits = hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  float low = mix(corners.x, corners.y, fade.x);
  float low_slope = corners.y - corners.x;
  float high = mix(corners.z, corners.w, fade.x);
  float high_slope = corners.w - corners.z;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float blend = mix(low_slope, high_slope, fade.y);
  float difference2 = high - low;
  result_dx = mix(fade_dx.x * blend + fade_dx.y * difference2, 0.0, blur);
  result_dy = mix(fade_dy.x * blend + fade_dy.y * difference2, 0.0, blur);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// value_noise (noise/value_noise.glsl)
float value_noise2(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(uint(seed)));
  uvec4 bits = hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// brick_grid (tiles/brick_grid.glsl)
void brick_grid_stone_grid(vec2 uv, int rows, int columns, int seed, ivec2 neighbour, vec2 uv_dx,
    vec2 uv_dy, out Tile tile, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 cells = vec2(float(columns), float(rows));
  vec2 p = uv * cells;
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = hash(uint(row) + hash(uint(seed)));
  float sum = 0.5 * float(row & 1) + float(hash(row_bits - 1u) >> 8u) * 5.9604645e-8;
  p = vec2(p.x + sum, p.y);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  tile = Tile(p - corner, 1.0 / cells, hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * cells;
  tile_local_dy = uv_dy * cells;
}

// box_share (layers/box_share.glsl)
float box_share(vec2 q, vec2 cell_in_q, vec2 q_dx, vec2 q_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 covered = clamp(share, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void layer_element_stones(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-20.0, 20.0, pose.y) * 0.017453292;
  uint bits = hash(seed - 4u);
  float ratio = mix(0.7, 1.2, float(bits & 65535u) * 1.5258789e-5);
  float size = mix(0.15, 0.7, pose.x);
  float side = min(tile.size.x, tile.size.y);
  vec2 along = tile.size / side;
  vec2 across = vec2(tile.size.y, -tile.size.x) / side;
  uint hash_value2 = hash(seed - 1u);
  vec2 center = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 into = shrink * vec2(1.0, 1.0 / ratio);
  vec2 product = cos(angle) * into * along;
  vec2 product2 = sin(angle) * into * across;
  vec2 q = product * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * product + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * product + tile_local_dy.yx * product2;
  uint hash_value3 = hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = box_share(q, along * into, q_dx, q_dy);
  alpha = luck.y >= 0.4 ? 0.0 : alpha2;
  inner = Tile(q, size * vec2(1.0, ratio) * side, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// circle (patterns/circle.glsl)
float circle_shape(vec2 uv, float radius, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - vec2(0.47, 0.53);
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

// circle (patterns/circle.glsl)
float circle_lit(vec2 uv, vec2 center, float radius, float softness, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - center;
  float from_center = length(difference);
  float greatest = max(from_center, 1e-20);
  float from_center_dx = dot(difference, uv_dx) / greatest;
  float from_center_dy = dot(difference, uv_dy) / greatest;
  float greatest2 = max(sqrt(from_center_dx * from_center_dx + from_center_dy * from_center_dy),
      1e-7);
  float width = softness + greatest2;
  float near = clamp((radius - from_center) / width + 0.5, 0.0, 1.0);
  vec2 pixel = sqrt(uv_dx * uv_dx + uv_dy * uv_dy);
  float far = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  return mix(near, min(3.1415927 * radius * radius, 1.0), far);
}

// rock (function of the graph)
vec4 rock(vec2 uv, Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // x: tile_random (tiles/tile_random.glsl)
  float x = 40.0 * (float(hash(tile.seed + 7u) >> 8u) * 5.9604645e-8);
  // y: tile_random (tiles/tile_random.glsl)
  float y = 40.0 * (float(hash(tile.seed + 8u) >> 8u) * 5.9604645e-8);
  // piece: combine2 (channels/combine2.glsl)
  vec2 piece = vec2(x, y);
  // here: add (math/add.glsl)
  vec2 here = uv + piece;
  // bumps: value_noise (noise/value_noise.glsl)
  float bumps = value_noise2(here, vec2(5.0), 11, uv_dx, uv_dy);
  // grains: value_noise (noise/value_noise.glsl)
  float grains = value_noise2(here, vec2(34.0), 12, uv_dx, uv_dy);
  // radius: remap (math/remap.glsl)
  float radius = mix(0.24, 0.42, bumps);
  // shape: circle (patterns/circle.glsl)
  float shape = circle_shape(uv, radius, uv_dx, uv_dy);
  // lit: circle (patterns/circle.glsl)
  float lit = circle_lit(uv, vec2(0.37, 0.64), 0.02, 0.5, uv_dx, uv_dy);
  // shadow: circle (patterns/circle.glsl)
  float shadow = circle_lit(uv, vec2(0.55, 0.45), radius, 0.1, uv_dx, uv_dy);
  // shadow_alpha: multiply (math/multiply.glsl)
  float shadow_alpha = shadow * 0.55;
  // rough: lerp (math/lerp.glsl)
  float rough = mix(bumps, grains, 0.55);
  // dark: remap (math/remap.glsl)
  float dark = mix(0.12, 0.34, rough);
  // light: lerp (math/lerp.glsl)
  float light = mix(0.65, 1.9, lit);
  // tone: multiply (math/multiply.glsl)
  float tone = dark * light;
  // stone_rgb: multiply (math/multiply.glsl)
  vec3 stone_rgb = tone * vec3(1.0, 0.86, 0.74);
  // whole: over (layers/over.glsl)
  float blend = mix(shadow_alpha, 1.0, shape);
  vec3 blend2 = mix(vec3(0.07, 0.045, 0.03), stone_rgb, shape / max(blend, 1e-20));
  vec4 whole = vec4(blend2, blend);
  return whole;
}

// brick_grid (tiles/brick_grid.glsl)
Tile brick_grid_stone_grid(vec2 uv, ivec2 neighbour) {
  vec2 p = uv * vec2(16.0, 17.0);
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = hash(uint(row) + 2161170183u);
  float sum = 0.5 * float(row & 1) + float(hash(row_bits - 1u) >> 8u) * 5.9604645e-8;
  p = vec2(p.x + sum, p.y);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  Tile tile = Tile(p - corner, vec2(0.0625, 0.05882353), hash(uint(column) + row_bits));
  return tile;
}

// stone_tint_at (a function of neighbour)
vec3 stone_tint_at(ivec2 neighbour, vec2 uv) {
  // stone_grid: brick_grid (tiles/brick_grid.glsl)
  Tile stone_grid = brick_grid_stone_grid(uv, neighbour);
  // stone_tone: tile_random (tiles/tile_random.glsl)
  float stone_tone = mix(0.8, 1.7, float(hash(stone_grid.seed) >> 8u) * 5.9604645e-8);
  // stone_tint: multiply (math/multiply.glsl)
  vec3 stone_tint = stone_tone * vec3(1.0, 0.9, 0.8);
  return stone_tint;
}

// draw_stones, of layer (layers/layer.glsl)
vec4 draw_stones(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  brick_grid_stone_grid(uv, 17, 16, 5, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_stones(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 color = vec4(0.0);
  if (alpha > 0.0) {
    color = rock(inner.local, inner, inner_local_dx, inner_local_dy);
    color = vec4(color.xyz * stone_tint_at(which, uv), color.w * alpha);
  }
  return color;
}

// layer (layers/layer.glsl)
vec4 layer_stones(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 color = vec4(0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && color.w < 0.999; --x) {
      vec4 other = draw_stones(uv, ivec2(x, y), uv_dx, uv_dy);
      float below = other.w * (1.0 - color.w * on);
      color += vec4(other.xyz * below, below);
    }
  }
  color = vec4(color.xyz / max(color.w, 1e-20), min(color.w, 1.0));
  return color;
}

// turned, of layer_element (layers/layer_element.glsl)
vec2 turned(vec2 p, uint bits, vec2 p_dx, vec2 p_dy, out vec2 result_dx, out vec2 result_dy) {
  bool test = (bits & 1u) != 0u;
  vec2 p2 = test ? vec2(p.y, -p.x) : p;
  vec2 p_dx2 = test ? vec2(p_dx.y, -p_dx.x) : p_dx;
  vec2 p_dy2 = test ? vec2(p_dy.y, -p_dy.x) : p_dy;
  bool test2 = (bits & 2u) != 0u;
  p2 = test2 ? -p2 : p2;
  p_dx2 = test2 ? -p_dx2 : p_dx2;
  p_dy2 = test2 ? -p_dy2 : p_dy2;
  bool test3 = (bits & 4u) != 0u;
  bool test4 = (bits & 8u) != 0u;
  p2 = vec2(test3 ? -p2.x : p2.x, test4 ? -p2.y : p2.y);
  result_dx = vec2(test3 ? -p_dx2.x : p_dx2.x, test4 ? -p_dx2.y : p_dx2.y);
  result_dy = vec2(test3 ? -p_dy2.x : p_dy2.x, test4 ? -p_dy2.y : p_dy2.y);
  return p2;
}

// layer_element (layers/layer_element.glsl)
void layer_element_tufts(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = 360.0 * pose.y * 0.017453292;
  uint bits = hash(seed - 4u);
  float size = mix(0.45, 1.0, pose.x);
  float side = min(tile.size.x, tile.size.y);
  vec2 along = tile.size / side;
  vec2 across = vec2(tile.size.y, -tile.size.x) / side;
  uint hash_value2 = hash(seed - 1u);
  vec2 center = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 product = cos(angle) * shrink * along;
  vec2 product2 = sin(angle) * shrink * across;
  vec2 q = product * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * product + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * product + tile_local_dy.yx * product2;
  vec2 inner_local_dx2, inner_local_dy2;
  vec2 turned_value = turned(q - 0.5, bits >> 16u, q_dx, q_dy, inner_local_dx2, inner_local_dy2);
  uint hash_value3 = hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = box_share(q, along * shrink, q_dx, q_dy);
  alpha = luck.y >= 0.55 ? 0.0 : alpha2;
  inner = Tile(turned_value + 0.5, vec2(size * side), seed);
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// threshold (math/threshold.glsl)
float threshold(float value, float value_dx, float value_dy) {
  float sum = value / max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7) + 0.5;
  return clamp(sum, 0.0, 1.0);
}

// color_ramp (color/color_ramp.glsl)
vec4 color_ramp(float position) {
  vec4 vector = vec4(clamp(position / 0.2, 0.0, 1.0));
  vec4 color = mix(vec4(0.05, 0.07, 0.015, 1.0), vec4(0.2, 0.21, 0.05, 1.0), vector);
  return mix(color, vec4(0.5, 0.42, 0.16, 1.0), clamp((position - 0.2) / 0.24999999, 0.0, 1.0));
}

// tuft (function of the graph)
vec4 tuft(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  // from_foot: subtract (math/subtract.glsl)
  vec2 from_foot = uv - 0.5;
  // far: magnitude (math/magnitude.glsl)
  float far = length(from_foot);
  float projection = dot(from_foot, uv_dx);
  float greatest = max(far, 1e-20);
  float far_dx = projection / greatest;
  float projection2 = dot(from_foot, uv_dy);
  float far_dy = projection2 / greatest;
  // way: normalized (math/normalized.glsl)
  float projection3 = dot(from_foot, from_foot);
  float greatest2 = max(projection3, 1e-30);
  bool test = projection3 < 1e-30;
  float inverse_root = inversesqrt(greatest2);
  float ratio = inverse_root / greatest2;
  vec2 way = from_foot * inverse_root;
  vec2 product = from_foot * (-0.5 * (test ? 0.0 : projection + projection) * ratio);
  vec2 way_dx = uv_dx * inverse_root + product;
  vec2 product2 = from_foot * (-0.5 * (test ? 0.0 : projection2 + projection2) * ratio);
  vec2 way_dy = uv_dy * inverse_root + product2;
  // blades: value_noise (noise/value_noise.glsl)
  float blades_dx, blades_dy;
  float blades = value_noise(way, vec2(9.0), 4, way_dx, way_dy, blades_dx, blades_dy);
  // fine: value_noise (noise/value_noise.glsl)
  float fine_dx, fine_dy;
  float fine = value_noise(way, vec2(23.0), 5, way_dx, way_dy, fine_dx, fine_dy);
  // both: lerp (math/lerp.glsl)
  float both = mix(blades, fine, 0.5);
  float both_dx = mix(blades_dx, fine_dx, 0.5);
  float both_dy = mix(blades_dy, fine_dy, 0.5);
  // reach: remap (math/remap.glsl)
  float reach = mix(0.06, 0.5, (both - 0.25) / 0.55);
  // left: subtract (math/subtract.glsl)
  float left = reach - far;
  float reach_dx = both_dx / 0.55 * 0.44;
  float reach_dy = both_dy / 0.55 * 0.44;
  float left_dx = reach_dx - far_dx;
  float left_dy = reach_dy - far_dy;
  // there: threshold (math/threshold.glsl)
  float there = threshold(left, left_dx, left_dy);
  // green: color_ramp (color/color_ramp.glsl)
  vec4 green = color_ramp(far);
  // grown: rgba (channels/rgba.glsl)
  vec4 grown = vec4(green.xyz, there);
  return grown;
}

// random3 (random/random3.glsl)
vec3 random3(uint seed) {
  uint bits = hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(hash(bits) >> 8u) * 5.9604645e-8);
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// draw_tufts, of layer (layers/layer.glsl)
vec4 draw_tufts(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  brick_grid_stone_grid(uv, 7, 6, 6, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_tufts(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 color = vec4(0.0);
  if (alpha > 0.0) {
    color = tuft(inner.local, inner_local_dx, inner_local_dy);
    vec3 blend = mix(vec3(0.5), random3(tile.seed), tile_near(tile_local_dx, tile_local_dy));
    vec3 product = color.xyz * mix(vec3(0.75, 0.8, 0.6), vec3(1.3, 1.15, 1.0), blend);
    color = vec4(product, color.w * alpha);
  }
  return color;
}

// layer (layers/layer.glsl)
vec4 layer_tufts(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 color = vec4(0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && color.w < 0.999; --x) {
      vec4 other = draw_tufts(uv, ivec2(x, y), uv_dx, uv_dy);
      float below = other.w * (1.0 - color.w * on);
      color += vec4(other.xyz * below, below);
    }
  }
  color = vec4(color.xyz / max(color.w, 1e-20), min(color.w, 1.0));
  return color;
}

// layer_element (layers/layer_element.glsl)
void layer_element_rocks(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed + 1u);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-25.0, 25.0, pose.y) * 0.017453292;
  uint bits = hash(seed - 4u);
  float ratio = mix(0.75, 1.1, float(bits & 65535u) * 1.5258789e-5);
  float size = mix(0.45, 1.25, pose.x);
  float side = min(tile.size.x, tile.size.y);
  vec2 along = tile.size / side;
  vec2 across = vec2(tile.size.y, -tile.size.x) / side;
  uint hash_value2 = hash(seed - 1u);
  vec2 center = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 into = shrink * vec2(1.0, 1.0 / ratio);
  vec2 product = cos(angle) * into * along;
  vec2 product2 = sin(angle) * into * across;
  vec2 q = product * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * product + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * product + tile_local_dy.yx * product2;
  uint hash_value3 = hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = box_share(q, along * into, q_dx, q_dy);
  alpha = luck.y >= 0.45 ? 0.0 : alpha2;
  inner = Tile(q, size * vec2(1.0, ratio) * side, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// draw_rocks, of layer (layers/layer.glsl)
vec4 draw_rocks(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  brick_grid_stone_grid(uv, 4, 4, 9, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_rocks(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 color = vec4(0.0);
  if (alpha > 0.0) {
    color = rock(inner.local, inner, inner_local_dx, inner_local_dy);
    vec3 blend = mix(vec3(0.5), random3(tile.seed), tile_near(tile_local_dx, tile_local_dy));
    vec3 product = color.xyz * mix(vec3(1.0, 0.92, 0.8), vec3(1.4, 1.1, 0.9), blend);
    color = vec4(product, color.w * alpha);
  }
  return color;
}

// layer (layers/layer.glsl)
vec4 layer_rocks(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 color = vec4(0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && color.w < 0.999; --x) {
      vec4 other = draw_rocks(uv, ivec2(x, y), uv_dx, uv_dy);
      float below = other.w * (1.0 - color.w * on);
      color += vec4(other.xyz * below, below);
    }
  }
  color = vec4(color.xyz / max(color.w, 1e-20), min(color.w, 1.0));
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // dunes: value_noise (noise/value_noise.glsl)
  float dunes_dx, dunes_dy;
  float dunes = value_noise(uv, vec2(3.0, 2.0), 1, uv_dx, uv_dy, dunes_dx, dunes_dy);
  // bends: value_noise (noise/value_noise.glsl)
  float bends_dx, bends_dy;
  float bends = value_noise(uv, vec2(7.0, 6.0), 2, uv_dx, uv_dy, bends_dx, bends_dy);
  // slope: lerp (math/lerp.glsl)
  float slope = mix(dunes, bends, 0.4);
  float slope_dx = mix(dunes_dx, bends_dx, 0.4);
  float slope_dy = mix(dunes_dy, bends_dy, 0.4);
  // shift: multiply (math/multiply.glsl)
  float shift = slope * 0.55;
  // along: add (math/add.glsl)
  float along = uv.y + shift;
  float shift_dx = slope_dx * 0.55;
  float shift_dy = slope_dy * 0.55;
  float along_dx = uv_dx.y + shift_dx;
  float along_dy = uv_dy.y + shift_dy;
  // ripple_uv: combine2 (channels/combine2.glsl)
  vec2 ripple_uv = vec2(uv.x, along);
  vec2 ripple_uv_dx = vec2(uv_dx.x, along_dx);
  vec2 ripple_uv_dy = vec2(uv_dy.x, along_dy);
  // ripples: value_noise (noise/value_noise.glsl)
  float ripples = value_noise2(ripple_uv, vec2(5.0, 70.0), 3, ripple_uv_dx, ripple_uv_dy);
  // grains: value_noise (noise/value_noise.glsl)
  float grains = value_noise2(uv, vec2(300.0), 4, uv_dx, uv_dy);
  // relief: lerp (math/lerp.glsl)
  float relief = mix(ripples, grains, 0.35);
  // sand_tone: remap (math/remap.glsl)
  float sand_tone = mix(0.68, 1.22, relief);
  // far_tone: remap (math/remap.glsl)
  float far_tone = mix(0.85, 1.12, dunes);
  // light: multiply (math/multiply.glsl)
  float light = sand_tone * far_tone;
  // sand_rgb: multiply (math/multiply.glsl)
  vec3 sand_rgb = sand * light;
  // stone_grid: brick_grid (tiles/brick_grid.glsl)
  vec2 stone_grid_local_dx = uv_dx * vec2(16.0, 17.0);
  vec2 stone_grid_local_dy = uv_dy * vec2(16.0, 17.0);
  // stones: layer (layers/layer.glsl)
  vec4 stones_color = layer_stones(uv, uv_dx, uv_dy, stone_grid_local_dx, stone_grid_local_dy);
  // grass_grid: brick_grid (tiles/brick_grid.glsl)
  vec2 grass_grid_local_dx = uv_dx * vec2(6.0, 7.0);
  vec2 grass_grid_local_dy = uv_dy * vec2(6.0, 7.0);
  // tufts: layer (layers/layer.glsl)
  vec4 tufts_color = layer_tufts(uv, uv_dx, uv_dy, grass_grid_local_dx, grass_grid_local_dy);
  // rock_grid: brick_grid (tiles/brick_grid.glsl)
  vec2 rock_grid_local_dx = uv_dx * 4.0;
  vec2 rock_grid_local_dy = uv_dy * 4.0;
  // rocks: layer (layers/layer.glsl)
  vec4 rocks_color = layer_rocks(uv, uv_dx, uv_dy, rock_grid_local_dx, rock_grid_local_dy);
  // with_stones: over (layers/over.glsl)
  vec3 blend = mix(sand_rgb, stones_color.xyz, stones_color.w);
  // with_grass: over (layers/over.glsl)
  vec3 blend2 = mix(blend, tufts_color.xyz, tufts_color.w);
  // desert: over (layers/over.glsl)
  vec4 desert = vec4(mix(blend2, rocks_color.xyz, rocks_color.w), 1.0);
  out_color = desert;
}
