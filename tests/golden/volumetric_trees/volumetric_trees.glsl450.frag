// volumetric_trees: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Parameters
layout(location = 0) uniform vec2 view;  // default vec2(0.2, 0.75)

// Textures
layout(location = 1, binding = 0) uniform sampler3D trees;
layout(location = 2, binding = 1) uniform sampler2DArray meadows;

// Outputs
layout(location = 0) out vec4 out_color;

// Types
struct Tile3 {
  vec3 local;
  vec3 size;
  uint seed;
};

// Constants
const int kinds[16] = int[16](0, 0, 0, 0, 1, 1, 2, -1, 1, 1, 1, 1, 2, 2, 0, -1);

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

// cell_hash (indirection/cell_hash.glsl)
uint cell_hash(ivec3 cell, int seed) {
  uint first = hash(uint(seed));
  uint second = hash(first);
  uvec3 v = uvec3(cell) * 1664525u + uvec3(first, second, hash(second));
  uint sum = v.x + v.y * v.z;
  uint sum2 = v.y + v.z * sum;
  v = uvec3(sum, sum2, v.z + sum * sum2);
  v ^= v >> 16u;
  uint sum3 = v.x + v.y * v.z;
  return v.z + sum3 * (v.y + v.z * sum3);
}

// virtual_tile_map (indirection/virtual_tile_map.glsl)
void virtual_tile_map(vec3 uv, ivec3 cells, int seed, vec3 uv_dx, vec3 uv_dy, out Tile3 tile,
    out vec3 tile_local_dx, out vec3 tile_local_dy) {
  ivec3 count = max(cells, 1);
  vec3 p_slope = vec3(count);
  vec3 p = uv * p_slope;
  vec3 corner = floor(p);
  ivec3 cell = ivec3(corner);
  tile = Tile3(p - corner, 1.0 / p_slope, cell_hash(cell, seed));
  tile_local_dx = uv_dx * p_slope;
  tile_local_dy = uv_dy * p_slope;
}

// four_numbers, of virtual_random_map (indirection/virtual_random_map.glsl)
vec4 four_numbers(uint seed) {
  uint first = hash(seed);
  uint second = hash(first);
  float value = float(second >> 16u);
  vec4 vector = vec4(float(first & 65535u), float(first >> 16u), float(second & 65535u), value);
  return vector * 1.5258789e-5;
}

// box_share (layers/box_share.glsl)
float box_share(vec2 q, vec2 cell_in_q, vec2 local, vec2 q_dx, vec2 q_dy, vec2 local_dx,
    vec2 local_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 cell_width = clamp(sqrt(local_dx * local_dx + local_dy * local_dy), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

// tile_transform (indirection/tile_transform.glsl)
void tile_transform(Tile3 tile, vec3 position, float scale, float rotation, vec3 tile_local_dx,
    vec3 tile_local_dy, out Tile3 inner, out float coverage, out vec3 inner_local_dx,
    out vec3 inner_local_dy) {
  float angle = rotation * 0.017453292;
  float cosine = cos(angle);
  float sine = sin(angle);
  vec2 turn = vec2(cosine, sine);
  vec2 sum = abs(cosine) + abs(sine) * tile.size.yx / tile.size.xy;
  vec3 box = vec3(sum, 1.0);
  float size = max(scale, 1e-5);
  size = min(size, 1.0 / max(max(sum.x, sum.y), 1.0));
  vec3 half_box = 0.5 * size * box;
  vec3 middle = half_box + clamp(position, 0.0, 1.0) * (1.0 - 2.0 * half_box);
  vec3 from_middle = tile.local - middle;
  vec2 p = from_middle.xy * tile.size.xy;
  vec2 p_dx = tile_local_dx.xy * tile.size.xy;
  vec2 p_dy = tile_local_dy.xy * tile.size.xy;
  vec2 product = size * tile.size.xy;
  bvec2 test = notEqual(product, vec2(0.0));
  vec2 ratio = vec2(dot(turn, p_dx), p_dx.y * cosine - p_dx.x * sine) / product;
  vec2 q_dx = mix(vec2(0.0), ratio, test);
  vec2 ratio2 = vec2(dot(turn, p_dy), p_dy.y * cosine - p_dy.x * sine) / product;
  vec2 q_dy = mix(vec2(0.0), ratio2, test);
  vec2 q = vec2(dot(turn, p), cosine * p.y - sine * p.x) / product + 0.5;
  bool test2 = size != 0.0;
  float height_dx = test2 ? tile_local_dx.z / size : 0.0;
  float height_dy = test2 ? tile_local_dy.z / size : 0.0;
  float height = from_middle.z / size + 0.5;
  float ratio3 = 1.0 / size;
  float pixel = clamp(sqrt(height_dx * height_dx + height_dy * height_dy), 1e-5, ratio3);
  float least = min((0.5 - abs(height - 0.5)) / pixel + 0.5, 1.0 / pixel);
  float slice = clamp(least, 0.0, 1.0);
  float box_share_value = box_share(q, vec2(ratio3), tile.local.xy, q_dx, q_dy, tile_local_dx.xy,
      tile_local_dy.xy);
  float coverage2 = slice * box_share_value;
  vec2 sum2 = tile_local_dx.xy * tile_local_dx.xy + tile_local_dy.xy * tile_local_dy.xy;
  vec2 tiles = sqrt(sum2);
  float away = clamp(2.0 * max(tiles.x, tiles.y) - 1.0, 0.0, 1.0);
  coverage2 = mix(coverage2, size * size * slice, away);
  inner = Tile3(vec3(q, height), size * tile.size, tile.seed);
  coverage = scale > 0.0 ? coverage2 : 0.0;
  inner_local_dx = vec3(q_dx, height_dx);
  inner_local_dy = vec3(q_dy, height_dy);
}

// reference_texture (indirection/reference_texture.glsl)
vec4 reference_texture(sampler3D patterns, Tile3 tile, int pattern, vec3 tile_local_dx,
    vec3 tile_local_dy) {
  ivec3 texels = textureSize(patterns, 0) / ivec3(1, 1, 3);
  vec3 vector = vec3(texels);
  vec3 right = tile_local_dx * vector;
  vec3 up = tile_local_dy * vector;
  float greatest = max(0.5 * log2(max(max(dot(right, right), dot(up, up)), 1e-12)), 0.0);
  float level = min(greatest, log2(float(texels.z & -texels.z)));
  float border = min(0.5 * exp2(ceil(level)) / float(texels.z), 0.5);
  int which = clamp(pattern, 0, 2);
  float depth = float(which) + clamp(tile.local.z, border, 1.0 - border);
  vec3 place = vec3(tile.local.xy, depth / 3.0);
  vec4 color = textureLod(patterns, place, level);
  return pattern < 0 ? vec4(0.0) : color;
}

// stand (function of the graph)
vec4 stand_first(vec3 position, vec3 position_dx, vec3 position_dy) {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  Tile3 grid;
  vec3 grid_local_dx, grid_local_dy;
  virtual_tile_map(position, ivec3(13, 13, 1), 1, position_dx, position_dy, grid, grid_local_dx,
      grid_local_dy);
  // kind: materials_map (indirection/materials_map.glsl)
  int kind = kinds[int(grid.seed >> 29u)];
  // luck: virtual_random_map (indirection/virtual_random_map.glsl)
  vec4 luck = four_numbers(grid.seed + 1u);
  // ground: combine3 (channels/combine3.glsl)
  vec3 ground = vec3(luck.xy, 0.0);
  // size: remap (math/remap.glsl)
  float size = mix(0.65, 0.95, luck.z);
  // angle: remap (math/remap.glsl)
  float angle = mix(-25.0, 25.0, luck.w);
  // place: tile_transform (indirection/tile_transform.glsl)
  Tile3 place_inner;
  float place_coverage;
  vec3 place_inner_local_dx, place_inner_local_dy;
  tile_transform(grid, ground, size, angle, grid_local_dx, grid_local_dy, place_inner,
      place_coverage, place_inner_local_dx, place_inner_local_dy);
  // painted: reference_texture (indirection/reference_texture.glsl)
  vec4 painted = reference_texture(trees, place_inner, kind, place_inner_local_dx,
      place_inner_local_dy);
  // seen: apply_mask (layers/apply_mask.glsl)
  vec4 seen = vec4(painted.xyz, painted.w * place_coverage);
  return seen;
}

// stand (function of the graph)
vec4 stand_second(vec3 position, vec3 position_dx, vec3 position_dy) {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  Tile3 grid;
  vec3 grid_local_dx, grid_local_dy;
  virtual_tile_map(position, ivec3(18, 17, 1), 2, position_dx, position_dy, grid, grid_local_dx,
      grid_local_dy);
  // kind: materials_map (indirection/materials_map.glsl)
  int kind = kinds[8 + int(grid.seed >> 29u)];
  // luck: virtual_random_map (indirection/virtual_random_map.glsl)
  vec4 luck = four_numbers(grid.seed + 1u);
  // ground: combine3 (channels/combine3.glsl)
  vec3 ground = vec3(luck.xy, 0.0);
  // size: remap (math/remap.glsl)
  float size = mix(0.65, 0.95, luck.z);
  // angle: remap (math/remap.glsl)
  float angle = mix(-25.0, 25.0, luck.w);
  // place: tile_transform (indirection/tile_transform.glsl)
  Tile3 place_inner;
  float place_coverage;
  vec3 place_inner_local_dx, place_inner_local_dy;
  tile_transform(grid, ground, size, angle, grid_local_dx, grid_local_dy, place_inner,
      place_coverage, place_inner_local_dx, place_inner_local_dy);
  // painted: reference_texture (indirection/reference_texture.glsl)
  vec4 painted = reference_texture(trees, place_inner, kind, place_inner_local_dx,
      place_inner_local_dy);
  // seen: apply_mask (layers/apply_mask.glsl)
  vec4 seen = vec4(painted.xyz, painted.w * place_coverage);
  return seen;
}

// volume_slices (indirection/volume_slices.glsl)
vec4 volume_slices(vec2 uv, vec2 view, vec2 uv_dx, vec2 uv_dy) {
  vec4 sum = vec4(0.0);
  for (int i = 63; i > -1 && sum.w < 0.999; --i) {
    float level = (float(i) + 0.5) * 0.015625;
    vec3 vector = vec3(uv - view * (0.13 * level), level);
    vec3 vector2 = vec3(uv_dx, 0.0);
    vec3 vector3 = vec3(uv_dy, 0.0);
    vec4 stand_first_value = stand_first(vector, vector2, vector3);
    vec4 stand_second_value = stand_second(vector, vector2, vector3);
    float blend = mix(stand_second_value.w, 1.0, stand_first_value.w);
    vec3 blend2 = mix(stand_second_value.xyz, stand_first_value.xyz,
        stand_first_value.w / max(blend, 1e-20));
    float below = blend * (1.0 - sum.w);
    sum += vec4(blend2 * below, below);
  }
  return vec4(sum.xyz / max(sum.w, 1e-20), sum.w);
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grass_cells: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 16.0;
  // grass_pattern: virtual_indirection_map (indirection/virtual_indirection_map.glsl)
  int grass_pattern = int(cell_hash(ivec2(floor(product))) >> 28u);
  // grass: reference_texture (indirection/reference_texture.glsl)
  vec4 grass = texture(meadows, vec3(product, float(grass_pattern)));
  // towards_x: add (math/add.glsl)
  float towards_x = uv.x - 0.03;
  // towards_y: add (math/add.glsl)
  float towards_y = uv.y - 0.02;
  // towards: combine3 (channels/combine3.glsl)
  vec3 towards = vec3(towards_x, towards_y, 0.36);
  vec3 towards_dx = vec3(uv_dx, 0.0);
  vec3 towards_dy = vec3(uv_dy, 0.0);
  // crowns: forest (function of the graph)
  float value = stand_second(towards, towards_dx, towards_dy).w;
  float shade = mix(value, 1.0, stand_first(towards, towards_dx, towards_dy).w);
  // dark: multiply (math/multiply.glsl)
  float dark = shade * 0.85;
  // soil: over (layers/over.glsl)
  float blend = mix(grass.w, 1.0, dark);
  vec3 blend2 = mix(grass.xyz, vec3(0.006, 0.01, 0.006), dark / max(blend, 1e-20));
  // trees_seen: volume_slices (indirection/volume_slices.glsl)
  vec4 trees_seen = volume_slices(uv, view, uv_dx, uv_dy);
  // land: over (layers/over.glsl)
  float blend3 = mix(blend, 1.0, trees_seen.w);
  vec4 land = vec4(mix(blend2, trees_seen.xyz, trees_seen.w / max(blend3, 1e-20)), blend3);
  out_color = land;
}
