// opening_flowers: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float time;

// Textures
uniform sampler2DArray flower;
uniform sampler2DArray meadows;

// Types
struct opening_flowers_Tile {
  vec2 local;
  vec2 size;
  vec2 right;
  vec2 up;
};

// hash (random/hash.glsl)
uint opening_flowers_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// cell_hash (indirection/cell_hash.glsl)
uint opening_flowers_cell_hash(ivec2 cell, int seed) {
  uint first = opening_flowers_hash(uint(seed));
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(first, opening_flowers_hash(first));
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// tile_center (tiles/tile_center.glsl)
vec2 opening_flowers_tile_center(opening_flowers_Tile tile, vec2 uv) {
  vec2 from_middle = (tile.local - 0.5) * tile.size;
  return uv - tile.right * from_middle.x - tile.up * from_middle.y;
}

// circle (patterns/circle.glsl)
float opening_flowers_circle(vec2 uv, vec2 center, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - center;
  float from_center = length(difference);
  float greatest = max(from_center, 1e-20);
  float from_center_dx = dot(difference, uv_dx) / greatest;
  float from_center_dy = dot(difference, uv_dy) / greatest;
  float width = max(sqrt(from_center_dx * from_center_dx + from_center_dy * from_center_dy), 1e-7);
  float near = clamp((0.03 - from_center) / width + 0.5, 0.0, 1.0);
  vec2 pixel = sqrt(uv_dx * uv_dx + uv_dy * uv_dy);
  float far = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  return mix(near, 0.0028274334, far);
}

// ball (function of the graph)
float opening_flowers_ball(vec2 uv, vec2 from, float radius, float speed, float time, vec2 uv_dx,
    vec2 uv_dy, out float disc) {
  // turn: multiply (math/multiply.glsl)
  float turn = time * speed;
  // x: cosine (math/cosine.glsl)
  float x = cos(turn);
  // y: sine (math/sine.glsl)
  float y = sin(turn);
  // way: combine2 (channels/combine2.glsl)
  vec2 way = vec2(x, y);
  // far: multiply (math/multiply.glsl)
  vec2 far = way * radius;
  // middle: add (math/add.glsl)
  vec2 middle = far + 0.5;
  // from_it: subtract (math/subtract.glsl)
  vec2 from_it = from - middle;
  // away: magnitude (math/magnitude.glsl)
  float away = length(from_it);
  disc = opening_flowers_circle(uv, middle, uv_dx, uv_dy);
  return away;
}

// four_numbers, of virtual_random_map (indirection/virtual_random_map.glsl)
vec4 opening_flowers_four_numbers(uint seed) {
  uint first = opening_flowers_hash(seed);
  uint second = opening_flowers_hash(first);
  float value = float(second >> 16u);
  vec4 vector = vec4(float(first & 65535u), float(first >> 16u), float(second & 65535u), value);
  return vector * 1.5258789e-5;
}

// box_share (layers/box_share.glsl)
float opening_flowers_box_share(vec2 q, vec2 q_dx, vec2 q_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), 1e-5, 1.0526316);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 covered = clamp(share, 0.0, 1.0);
  return covered.x * covered.y;
}

// tile_transform (indirection/tile_transform.glsl)
void opening_flowers_tile_transform(opening_flowers_Tile tile, vec2 position, float rotation,
    vec2 tile_local_dx, vec2 tile_local_dy, out opening_flowers_Tile inner, out float coverage,
    out vec2 inner_local_dx, out vec2 inner_local_dy) {
  float angle = rotation * 0.017453292;
  float cosine = cos(angle);
  float sine = sin(angle);
  vec2 turn = vec2(cosine, sine);
  vec2 p = (tile.local - position) * tile.size;
  vec2 p_dx = tile_local_dx * tile.size;
  vec2 p_dy = tile_local_dy * tile.size;
  vec2 product = 0.95 * tile.size;
  bvec2 test = notEqual(product, vec2(0.0));
  vec2 ratio = vec2(dot(turn, p_dx), p_dx.y * cosine - p_dx.x * sine) / product;
  vec2 q_dx = mix(vec2(0.0), ratio, test);
  vec2 ratio2 = vec2(dot(turn, p_dy), p_dy.y * cosine - p_dy.x * sine) / product;
  vec2 q_dy = mix(vec2(0.0), ratio2, test);
  vec2 q = vec2(dot(turn, p), cosine * p.y - sine * p.x) / product + 0.5;
  vec2 sum = cosine * tile.right + sine * tile.up;
  inner = opening_flowers_Tile(q, product, sum, cosine * tile.up - sine * tile.right);
  coverage = opening_flowers_box_share(q, q_dx, q_dy);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// seen_at (a function of neighbour)
vec4 opening_flowers_seen_at(ivec2 neighbour, vec2 uv, float time, vec2 uv_dx, vec2 uv_dy) {
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 12.0;
  vec2 sum = floor(product) + vec2(neighbour);
  opening_flowers_Tile grid = opening_flowers_Tile(product - sum, vec2(0.083333336), vec2(1.0, 0.0),
      vec2(0.0, 1.0));
  vec2 grid_local_dx = uv_dx * 12.0;
  vec2 grid_local_dy = uv_dy * 12.0;
  // middle: tile_center (tiles/tile_center.glsl)
  vec2 middle = opening_flowers_tile_center(grid, uv);
  // red: ball (function of the graph)
  float disc;
  float red = opening_flowers_ball(uv, middle, 0.34, 1.5707964, time, uv_dx, uv_dy, disc);
  // blue: ball (function of the graph)
  float disc2;
  float blue = opening_flowers_ball(uv, middle, 0.16, -3.1415927, time, uv_dx, uv_dy, disc2);
  // nearest: minimum (math/minimum.glsl)
  float nearest = min(red, blue);
  // stage: remap (math/remap.glsl)
  float stage = mix(15.5, 0.0, clamp((nearest - 0.06) / 0.17999999, 0.0, 1.0));
  // picture: to_int (channels/to_int.glsl)
  int picture = int(stage);
  // luck: virtual_random_map (indirection/virtual_random_map.glsl)
  vec4 luck = opening_flowers_four_numbers(opening_flowers_cell_hash(ivec2(sum), 0));
  // angle: multiply (math/multiply.glsl)
  float angle = luck.z * 360.0;
  // flower_place: tile_transform (indirection/tile_transform.glsl)
  opening_flowers_Tile flower_place_inner;
  float flower_place_coverage;
  vec2 flower_place_inner_local_dx, flower_place_inner_local_dy;
  opening_flowers_tile_transform(grid, luck.xy, angle, grid_local_dx, grid_local_dy,
      flower_place_inner, flower_place_coverage, flower_place_inner_local_dx,
      flower_place_inner_local_dy);
  // painted: reference_texture (indirection/reference_texture.glsl)
  vec3 vector = vec3(flower_place_inner.local, float(picture));
  vec4 texel = textureGrad(flower, vector, flower_place_inner_local_dx,
      flower_place_inner_local_dy);
  vec4 painted = picture < 0 ? vec4(0.0) : texel;
  // seen: apply_mask (layers/apply_mask.glsl)
  vec4 seen = vec4(painted.xyz, painted.w * flower_place_coverage);
  return seen;
}

// overlap (indirection/overlap.glsl)
vec4 opening_flowers_overlap(vec2 uv, float time, opening_flowers_Tile tile, vec2 uv_dx, vec2 uv_dy,
    vec2 tile_local_dx, vec2 tile_local_dy) {
  ivec2 first = ivec2(floor(tile.local - 0.5));
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 sum = vec4(0.0);
  for (int y = 1; y > -1; --y) {
    for (int x = 1; x > -1; --x) {
      vec4 other = opening_flowers_seen_at(first + ivec2(x, y), uv, time, uv_dx, uv_dy);
      float below = other.w * (1.0 - sum.w * on);
      sum += vec4(other.xyz * below, below);
    }
  }
  return vec4(sum.xyz / max(sum.w, 1e-20), min(sum.w, 1.0));
}

vec4 opening_flowers(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grass_cells: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 6.0;
  // grass_pattern: virtual_indirection_map (indirection/virtual_indirection_map.glsl)
  int grass_pattern = int(opening_flowers_cell_hash(ivec2(floor(product)), 7) >> 28u);
  // grass: reference_texture (indirection/reference_texture.glsl)
  vec4 grass = texture(meadows, vec3(product, float(grass_pattern)));
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product2 = uv * 12.0;
  opening_flowers_Tile grid = opening_flowers_Tile(product2 - floor(product2), vec2(0.083333336),
      vec2(1.0, 0.0), vec2(0.0, 1.0));
  vec2 grid_local_dx = uv_dx * 12.0;
  vec2 grid_local_dy = uv_dy * 12.0;
  // middle: tile_center (tiles/tile_center.glsl)
  vec2 middle = opening_flowers_tile_center(grid, uv);
  // red: ball (function of the graph)
  float red;
  opening_flowers_ball(uv, middle, 0.34, 1.5707964, time, uv_dx, uv_dy, red);
  // blue: ball (function of the graph)
  float blue;
  opening_flowers_ball(uv, middle, 0.16, -3.1415927, time, uv_dx, uv_dy, blue);
  // flowers: overlap (indirection/overlap.glsl)
  vec4 flowers = opening_flowers_overlap(uv, time, grid, uv_dx, uv_dy, grid_local_dx,
      grid_local_dy);
  // bed: over (layers/over.glsl)
  float blend = mix(grass.w, 1.0, flowers.w);
  vec3 blend2 = mix(grass.xyz, flowers.xyz, flowers.w / max(blend, 1e-20));
  // with_red: over (layers/over.glsl)
  float blend3 = mix(blend, 1.0, red);
  vec3 blend4 = mix(blend2, vec3(0.7, 0.02, 0.02), red / max(blend3, 1e-20));
  // garden: over (layers/over.glsl)
  float blend5 = mix(blend3, 1.0, blue);
  vec4 garden = vec4(mix(blend4, vec3(0.02, 0.08, 0.6), blue / max(blend5, 1e-20)), blend5);
  return garden;
}
