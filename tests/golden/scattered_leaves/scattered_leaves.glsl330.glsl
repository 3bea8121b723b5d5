// scattered_leaves: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Textures
uniform sampler2DArray leaves;
uniform sampler2D forest_floor;

// Types
struct scattered_leaves_Tile {
  vec2 local;
  vec2 size;
};

// cell_hash (indirection/cell_hash.glsl)
uint scattered_leaves_cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// hash (random/hash.glsl)
uint scattered_leaves_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// four_numbers, of virtual_random_map (indirection/virtual_random_map.glsl)
vec4 scattered_leaves_four_numbers(uint seed) {
  uint first = scattered_leaves_hash(seed);
  uint second = scattered_leaves_hash(first);
  float value = float(second >> 16u);
  vec4 vector = vec4(float(first & 65535u), float(first >> 16u), float(second & 65535u), value);
  return vector * 1.5258789e-5;
}

// box_share (layers/box_share.glsl)
float scattered_leaves_box_share(vec2 q, vec2 cell_in_q, vec2 q_dx, vec2 q_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 covered = clamp(share, 0.0, 1.0);
  return covered.x * covered.y;
}

// tile_transform (indirection/tile_transform.glsl)
void scattered_leaves_tile_transform(scattered_leaves_Tile tile, vec2 position, float scale,
    float rotation, vec2 tile_local_dx, vec2 tile_local_dy, out scattered_leaves_Tile inner,
    out float coverage, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  float angle = rotation * 0.017453292;
  float cosine = cos(angle);
  float sine = sin(angle);
  vec2 turn = vec2(cosine, sine);
  float size = max(scale, 1e-5);
  vec2 p = (tile.local - position) * tile.size;
  vec2 p_dx = tile_local_dx * tile.size;
  vec2 p_dy = tile_local_dy * tile.size;
  vec2 product = size * tile.size;
  bvec2 test = notEqual(product, vec2(0.0));
  vec2 ratio = vec2(dot(turn, p_dx), p_dx.y * cosine - p_dx.x * sine) / product;
  vec2 q_dx = mix(vec2(0.0), ratio, test);
  vec2 ratio2 = vec2(dot(turn, p_dy), p_dy.y * cosine - p_dy.x * sine) / product;
  vec2 q_dy = mix(vec2(0.0), ratio2, test);
  vec2 q = vec2(dot(turn, p), cosine * p.y - sine * p.x) / product + 0.5;
  float coverage2 = scattered_leaves_box_share(q, vec2(1.0 / size), q_dx, q_dy);
  inner = scattered_leaves_Tile(q, product);
  coverage = scale > 0.0 ? coverage2 : 0.0;
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// seen_at (a function of neighbour)
vec4 scattered_leaves_seen_at(ivec2 neighbour, vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 14.0;
  vec2 sum = floor(product) + vec2(neighbour);
  scattered_leaves_Tile grid = scattered_leaves_Tile(product - sum, vec2(0.071428575));
  vec2 grid_local_dx = uv_dx * 14.0;
  vec2 grid_local_dy = uv_dy * 14.0;
  // luck: virtual_random_map (indirection/virtual_random_map.glsl)
  vec4 luck = scattered_leaves_four_numbers(scattered_leaves_cell_hash(ivec2(sum)) + 1u);
  // size: remap (math/remap.glsl)
  float size = mix(0.7, 1.0, luck.z);
  // angle: multiply (math/multiply.glsl)
  float angle = luck.w * 360.0;
  // leaf: tile_transform (indirection/tile_transform.glsl)
  scattered_leaves_Tile leaf_inner;
  float leaf_coverage;
  vec2 leaf_inner_local_dx, leaf_inner_local_dy;
  scattered_leaves_tile_transform(grid, luck.xy, size, angle, grid_local_dx, grid_local_dy,
      leaf_inner, leaf_coverage, leaf_inner_local_dx, leaf_inner_local_dy);
  // painted: reference_texture (indirection/reference_texture.glsl)
  vec3 vector = vec3(leaf_inner.local, 0.0);
  vec4 painted = textureGrad(leaves, vector, leaf_inner_local_dx, leaf_inner_local_dy);
  // seen: apply_mask (layers/apply_mask.glsl)
  vec4 seen = vec4(painted.xyz, painted.w * leaf_coverage);
  return seen;
}

// overlap (indirection/overlap.glsl)
vec4 scattered_leaves_overlap(vec2 uv, scattered_leaves_Tile tile, vec2 uv_dx, vec2 uv_dy,
    vec2 tile_local_dx, vec2 tile_local_dy) {
  ivec2 first = ivec2(floor(tile.local - 0.5));
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 sum = vec4(0.0);
  for (int y = 1; y > -1; --y) {
    for (int x = 1; x > -1; --x) {
      vec4 other = scattered_leaves_seen_at(first + ivec2(x, y), uv, uv_dx, uv_dy);
      float below = other.w * (1.0 - sum.w * on);
      sum += vec4(other.xyz * below, below);
    }
  }
  return vec4(sum.xyz / max(sum.w, 1e-20), min(sum.w, 1.0));
}

vec4 scattered_leaves(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 14.0;
  scattered_leaves_Tile grid = scattered_leaves_Tile(product - floor(product), vec2(0.071428575));
  vec2 grid_local_dx = uv_dx * 14.0;
  vec2 grid_local_dy = uv_dy * 14.0;
  // scattered: overlap (indirection/overlap.glsl)
  vec4 scattered = scattered_leaves_overlap(uv, grid, uv_dx, uv_dy, grid_local_dx, grid_local_dy);
  // soil: tiled_image (images/tiled_image.glsl)
  vec4 soil = texture(forest_floor, uv * 4.0);
  // ground: over (layers/over.glsl)
  float blend = mix(soil.w, 1.0, scattered.w);
  vec4 ground = vec4(mix(soil.xyz, scattered.xyz, scattered.w / max(blend, 1e-20)), blend);
  return ground;
}
