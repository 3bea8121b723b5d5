// herringbone_parquet: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec3 early_wood;  // default vec3(0.47, 0.27, 0.125)
uniform vec3 late_wood;  // default vec3(0.2, 0.088, 0.032)

// Types
struct herringbone_parquet_Tile {
  vec2 local;
  vec2 size;
  uint seed;
};

// wrap_cell (tiles/wrap_cell.glsl)
int herringbone_parquet_wrap_cell(int cell) {
  int flip = cell >> 31;
  return (((cell ^ flip) % 10) ^ flip) + (flip & 10);
}

// wrap_cell (tiles/wrap_cell.glsl)
ivec2 herringbone_parquet_wrap_cell(ivec2 cell) {
  ivec2 flip = cell >> 31;
  return (((cell ^ flip) % 20) ^ flip) + (flip & 20);
}

// hash (random/hash.glsl)
uint herringbone_parquet_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// herringbone_grid (tiles/herringbone_grid.glsl)
void herringbone_parquet_herringbone_grid(vec2 uv, vec2 uv_dx, vec2 uv_dy,
    out herringbone_parquet_Tile tile, out float edge, out vec2 tile_local_dx,
    out vec2 tile_local_dy, out float edge_dx, out float edge_dy) {
  vec2 p = uv * 20.0;
  vec2 corner = floor(p);
  vec2 inner = p - corner;
  ivec2 cell = ivec2(corner);
  int phase = herringbone_parquet_wrap_cell(cell.x - cell.y);
  vec2 p_dx = uv_dx * 20.0;
  vec2 p_dy = uv_dy * 20.0;
  herringbone_parquet_Tile tile2;
  ivec2 cell2;
  vec2 tile_local_dx2, tile_local_dy2;
  if (phase < 5) {
    tile2 = herringbone_parquet_Tile(vec2((float(phase) + inner.x) / 5.0, inner.y),
        vec2(0.25, 0.05), 0u);
    cell2 = ivec2(cell.x - phase, cell.y);
    tile_local_dx2 = vec2(p_dx.x / 5.0, p_dx.y);
    tile_local_dy2 = vec2(p_dy.x / 5.0, p_dy.y);
  } else {
    int step_up = 9 - phase;
    tile2 = herringbone_parquet_Tile(vec2((float(step_up) + inner.y) / 5.0, 1.0 - inner.x),
        vec2(0.25, 0.05), 0u);
    cell2 = ivec2(cell.x, cell.y - step_up);
    tile_local_dx2 = vec2(p_dx.y / 5.0, -p_dx.x);
    tile_local_dy2 = vec2(p_dy.y / 5.0, -p_dy.x);
  }
  cell2 = herringbone_parquet_wrap_cell(cell2);
  vec2 difference = tile2.local - 0.5;
  vec2 direction = sign(difference);
  vec2 product = (0.5 - abs(difference)) * tile2.size;
  vec2 negative = -tile2.size;
  vec2 product2 = tile_local_dx2 * direction * negative;
  vec2 product3 = tile_local_dy2 * direction * negative;
  float least = min(product.x, product.y);
  bool test = product.y < product.x;
  bool test2 = least < 0.0;
  tile = herringbone_parquet_Tile(tile2.local, tile2.size,
      herringbone_parquet_hash(uint(cell2.x)
      + herringbone_parquet_hash(uint(cell2.y) + 2161170183u)));
  edge = max(least, 0.0);
  tile_local_dx = tile_local_dx2;
  tile_local_dy = tile_local_dy2;
  edge_dx = test2 ? 0.0 : test ? product2.y : product2.x;
  edge_dy = test2 ? 0.0 : test ? product3.y : product3.x;
}

// hash (random/hash.glsl)
uvec2 herringbone_parquet_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 herringbone_parquet_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float herringbone_parquet_value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy,
    out float result_dx, out float result_dy) {
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
  uvec2 rows = herringbone_parquet_hash(uvec2(cell.y, cell.y + 1u)
      + herringbone_parquet_hash(uint(seed)));
  uvec4 bits = herringbone_parquet_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy) >> 8u;
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
float herringbone_parquet_value_noise2(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = herringbone_parquet_hash(uvec2(cell.y, cell.y + 1u)
      + herringbone_parquet_hash(uint(seed)));
  uvec4 bits = herringbone_parquet_hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// smooth_step (math/smooth_step.glsl)
float herringbone_parquet_smooth_step_pores(float value) {
  float t = clamp((value - 0.72) / 0.22999996, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// smooth_step (math/smooth_step.glsl)
float herringbone_parquet_smooth_step_amount(float value) {
  float t = clamp((value - 0.2) / 0.65000004, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// joint (tiles/joint.glsl)
float herringbone_parquet_joint(float edge, float width, float edge_dx, float edge_dy) {
  float pixel = max(sqrt(edge_dx * edge_dx + edge_dy * edge_dy), 1e-7);
  float product = 0.5 * pixel;
  float low = max(edge - product, -0.5 * width);
  float high = min(edge + product, 0.5 * width);
  float line = max(high - low, 0.0) / pixel;
  float far = clamp(2.0 * pixel / 0.083333336 - 1.0, 0.0, 1.0);
  line = min(line / (1.0 - 0.5 * min(pixel / 0.083333336, 1.0)), 1.0);
  float brick = max(1.0 - width / 0.083333336, 0.0);
  return mix(line, 1.0 - brick * brick, far);
}

void herringbone_parquet(vec2 uv, out vec4 color, out float roughness, out float height) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: herringbone_grid (tiles/herringbone_grid.glsl)
  herringbone_parquet_Tile grid_tile;
  float grid_edge, grid_edge_dx, grid_edge_dy;
  vec2 grid_tile_local_dx, grid_tile_local_dy;
  herringbone_parquet_herringbone_grid(uv, uv_dx, uv_dy, grid_tile, grid_edge, grid_tile_local_dx,
      grid_tile_local_dy, grid_edge_dx, grid_edge_dy);
  // inside: multiply (math/multiply.glsl)
  vec2 inside = grid_tile.local * vec2(5.0, 1.0);
  // cut_x: tile_random (tiles/tile_random.glsl)
  float cut_x = 60.0 * (float(herringbone_parquet_hash(grid_tile.seed + 1u) >> 8u) * 5.9604645e-8);
  // cut_y: tile_random (tiles/tile_random.glsl)
  float cut_y = 60.0 * (float(herringbone_parquet_hash(grid_tile.seed + 2u) >> 8u) * 5.9604645e-8);
  // cut: combine2 (channels/combine2.glsl)
  vec2 cut = vec2(cut_x, cut_y);
  // place: add (math/add.glsl)
  vec2 place = inside + cut;
  // bend: value_noise (noise/value_noise.glsl)
  vec2 place_dx = grid_tile_local_dx * vec2(5.0, 1.0);
  vec2 place_dy = grid_tile_local_dy * vec2(5.0, 1.0);
  float bend_dx, bend_dy;
  float bend = herringbone_parquet_value_noise(place, vec2(0.3, 1.1), 1, place_dx, place_dy,
      bend_dx, bend_dy);
  // waver: value_noise (noise/value_noise.glsl)
  float waver_dx, waver_dy;
  float waver = herringbone_parquet_value_noise(place, vec2(1.3, 3.5), 2, place_dx, place_dy,
      waver_dx, waver_dy);
  // bow: multiply (math/multiply.glsl)
  float bow = bend * 5.5;
  // ripple: multiply (math/multiply.glsl)
  float ripple = waver * 0.7;
  // across: multiply (math/multiply.glsl)
  float across = place.y * 3.2;
  // bent: add (math/add.glsl)
  float bent = across + bow;
  float across_dx = place_dx.y * 3.2;
  float across_dy = place_dy.y * 3.2;
  float bow_dx = bend_dx * 5.5;
  float bow_dy = bend_dy * 5.5;
  float bent_dx = across_dx + bow_dx;
  float bent_dy = across_dy + bow_dy;
  // depth: add (math/add.glsl)
  float depth = bent + ripple;
  float ripple_dx = waver_dx * 0.7;
  float ripple_dy = waver_dy * 0.7;
  float depth_dx = bent_dx + ripple_dx;
  float depth_dy = bent_dy + ripple_dy;
  // sheet: combine2 (channels/combine2.glsl)
  vec2 sheet = vec2(0.5, depth);
  vec2 sheet_dx = vec2(0.0, depth_dx);
  vec2 sheet_dy = vec2(0.0, depth_dy);
  // rings: value_noise (noise/value_noise.glsl)
  vec2 product = sheet * vec2(1.0, 2.6);
  vec2 whole = floor(product);
  vec2 difference = product - whole;
  vec2 product2 = difference * difference * difference
      * (difference * (difference * 6.0 - 15.0) + 10.0);
  uvec2 numbers = uvec2(ivec2(whole));
  uint sum = numbers.x + 1u;
  uvec4 numbers2 = herringbone_parquet_hash(uvec2(numbers.y, numbers.y + 1u)
      + herringbone_parquet_hash(3u)).xxyy;
  uvec4 bits = herringbone_parquet_hash(uvec4(numbers.x, sum, numbers.x, sum) + numbers2) >> 8u;
  vec4 product3 = vec4(bits) * 5.9604645e-8;
  float blend = mix(product3.x, product3.y, product2.x);
  vec2 product4 = sqrt(sheet_dx * sheet_dx + sheet_dy * sheet_dy) * vec2(1.0, 2.6);
  float blend2 = mix(blend, mix(product3.z, product3.w, product2.x), product2.y);
  float rings = mix(blend2, 0.5, clamp(2.0 * max(product4.x, product4.y) - 1.0, 0.0, 1.0));
  // fibre: value_noise (noise/value_noise.glsl)
  float fibre = herringbone_parquet_value_noise2(place, vec2(1.4, 44.0), 4, place_dx, place_dy);
  // strands: value_noise (noise/value_noise.glsl)
  float strands = herringbone_parquet_value_noise2(place, vec2(0.7, 13.0), 5, place_dx, place_dy);
  // pore_noise: value_noise (noise/value_noise.glsl)
  float pore_noise = herringbone_parquet_value_noise2(place, vec2(3.2, 64.0), 6, place_dx,
      place_dy);
  // pores: smooth_step (math/smooth_step.glsl)
  float pores = herringbone_parquet_smooth_step_pores(pore_noise);
  // figure: lerp (math/lerp.glsl)
  float figure = mix(rings, strands, 0.35);
  // grain: lerp (math/lerp.glsl)
  float grain = mix(figure, fibre, 0.28);
  // amount: smooth_step (math/smooth_step.glsl)
  float amount = herringbone_parquet_smooth_step_amount(grain);
  // wood: lerp (math/lerp.glsl)
  vec3 wood = mix(early_wood, late_wood, amount);
  // pore_tone: remap (math/remap.glsl)
  float pore_tone = mix(1.0, 0.62, pores);
  // wood_color: multiply (math/multiply.glsl)
  vec3 wood_color = wood * pore_tone;
  // brightness: tile_random (tiles/tile_random.glsl)
  float brightness = mix(0.62, 1.2,
      float(herringbone_parquet_hash(grid_tile.seed + 3u) >> 8u) * 5.9604645e-8);
  // redness: tile_random (tiles/tile_random.glsl)
  float redness = float(herringbone_parquet_hash(grid_tile.seed + 4u) >> 8u) * 5.9604645e-8;
  // warmth: lerp (math/lerp.glsl)
  vec3 warmth = mix(vec3(0.98, 1.02, 1.0), vec3(1.06, 0.93, 0.82), redness);
  // tone: multiply (math/multiply.glsl)
  vec3 tone = warmth * brightness;
  // stained: multiply (math/multiply.glsl)
  vec3 stained = wood_color * tone;
  // joint: joint (tiles/joint.glsl)
  float joint = herringbone_parquet_joint(grid_edge, 0.0022, grid_edge_dx, grid_edge_dy);
  // bevel: joint (tiles/joint.glsl)
  float bevel = herringbone_parquet_joint(grid_edge, 0.0077, grid_edge_dx, grid_edge_dy);
  // bevel_tone: remap (math/remap.glsl)
  float bevel_tone = mix(1.0, 0.72, bevel);
  // worn: multiply (math/multiply.glsl)
  vec3 worn = stained * bevel_tone;
  // jointed: lerp (math/lerp.glsl)
  vec3 jointed = mix(worn, vec3(0.03, 0.018, 0.01), joint);
  // floor_color: rgba (channels/rgba.glsl)
  vec4 floor_color = vec4(jointed, 1.0);
  // open: maximum (math/maximum.glsl)
  float open = max(pores, joint);
  // roughness: remap (math/remap.glsl)
  float roughness2 = mix(0.28, 0.75, open);
  // height: invert (math/invert.glsl)
  float height2 = 1.0 - bevel;
  color = floor_color;
  roughness = roughness2;
  height = height2;
}
