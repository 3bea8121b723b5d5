// painted_wood: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Parameters
layout(location = 0) uniform vec4 paint;  // default vec4(0.11, 0.31, 0.33, 1.0)
layout(location = 1) uniform float wear;  // default 0.45

// Textures
layout(location = 2, binding = 0) uniform sampler2D wood;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

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
void brick_grid(vec2 uv, vec2 uv_dx, vec2 uv_dy, out Tile tile, out vec2 tile_local_dx,
    out vec2 tile_local_dy) {
  vec2 p = uv * vec2(7.0, 2.0);
  int row = int(floor(p.y));
  uint row_bits = hash(uint(row) + 2161170183u);
  p = vec2(p.x + 0.37 * float(row & 1), p.y);
  vec2 corner = floor(p);
  int column = int(corner.x);
  tile = Tile(p - corner, vec2(0.14285715, 0.5), hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * vec2(7.0, 2.0);
  tile_local_dy = uv_dy * vec2(7.0, 2.0);
}

// uv_transform (images/uv_transform.glsl)
vec2 uv_transform_turned(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx, out vec2 result_dy) {
  result_dx = mat2(2.499863, -0.0130897295, 0.026179459, 1.2499315) * uv_dx;
  result_dy = mat2(2.499863, -0.0130897295, 0.026179459, 1.2499315) * uv_dy;
  return mat2(2.499863, -0.0130897295, 0.026179459, 1.2499315) * (uv - 0.5) + 0.5;
}

// uv_transform (images/uv_transform.glsl)
vec2 uv_transform_tilted(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx, out vec2 result_dy) {
  result_dx = mat2(0.8910065, -0.4539905, 0.4539905, 0.8910065) * uv_dx;
  result_dy = mat2(0.8910065, -0.4539905, 0.4539905, 0.8910065) * uv_dy;
  return mat2(0.8910065, -0.4539905, 0.4539905, 0.8910065) * (uv - 0.5) + 0.5;
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
float value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
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

// smooth_step (math/smooth_step.glsl)
float smooth_step(float value, float low, float high) {
  float span = high - low;
  float t = clamp((value - low) / (abs(span) < 1e-7 ? 1e-7 : span), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// brick_integral, of mortar (tiles/mortar.glsl)
vec2 brick_integral(vec2 p, vec2 joint) {
  vec2 turns = floor(p);
  vec2 difference = 1.0 - 2.0 * joint;
  return turns * difference + clamp(p - turns - joint, vec2(0.0), difference);
}

// mortar (tiles/mortar.glsl)
float mortar(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 joint = 0.002 / tile.size;
  vec2 pixel = max(sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy), 0.0001);
  vec2 product = 0.5 * pixel;
  vec2 difference = brick_integral(tile.local + product, joint)
      - brick_integral(tile.local - product, joint);
  vec2 brick = difference / pixel;
  return 1.0 - brick.x * brick.y;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // board: brick_grid (tiles/brick_grid.glsl)
  Tile board;
  vec2 board_local_dx, board_local_dy;
  brick_grid(uv, uv_dx, uv_dy, board, board_local_dx, board_local_dy);
  // shift_x: tile_random (tiles/tile_random.glsl)
  float shift_x = float(hash(board.seed + 1u) >> 8u) * 5.9604645e-8;
  // shift_y: tile_random (tiles/tile_random.glsl)
  float shift_y = float(hash(board.seed + 2u) >> 8u) * 5.9604645e-8;
  // shift: combine2 (channels/combine2.glsl)
  vec2 shift = vec2(shift_x, shift_y);
  // turned: uv_transform (images/uv_transform.glsl)
  vec2 turned_dx, turned_dy;
  vec2 turned = uv_transform_turned(uv, uv_dx, uv_dy, turned_dx, turned_dy);
  // board_uv: add (math/add.glsl)
  vec2 board_uv = turned + shift;
  // wood_color: tiled_image (images/tiled_image.glsl)
  vec4 wood_color = textureGrad(wood, board_uv, turned_dx, turned_dy);
  // tone: tile_random (tiles/tile_random.glsl)
  float tone = mix(0.65, 1.0, float(hash(board.seed) >> 8u) * 5.9604645e-8);
  // board_rgb: multiply (math/multiply.glsl)
  vec3 board_rgb = wood_color.xyz * tone;
  // bare: rgba (channels/rgba.glsl)
  vec4 bare = vec4(board_rgb, 1.0);
  // fibre: luminance (channels/luminance.glsl)
  float fibre = dot(wood_color.xyz, vec3(0.2126, 0.7152, 0.0722));
  // paint_tone: remap (math/remap.glsl)
  float paint_tone = mix(0.75, 1.1, fibre / 0.4);
  // paint_color: multiply (math/multiply.glsl)
  vec4 paint_color = paint * paint_tone;
  // tilted: uv_transform (images/uv_transform.glsl)
  vec2 tilted_dx, tilted_dy;
  vec2 tilted = uv_transform_tilted(uv, uv_dx, uv_dy, tilted_dx, tilted_dy);
  // patches: value_noise (noise/value_noise.glsl)
  float patches = value_noise(tilted, vec2(9.0, 7.0), 1, tilted_dx, tilted_dy);
  // flakes: value_noise (noise/value_noise.glsl)
  float flakes = value_noise(tilted, vec2(42.0, 33.0), 2, tilted_dx, tilted_dy);
  // chips: value_noise (noise/value_noise.glsl)
  float chips = value_noise(tilted, vec2(130.0, 90.0), 3, tilted_dx, tilted_dy);
  // edges: lerp (math/lerp.glsl)
  float edges = mix(flakes, chips, 0.35);
  // relief: lerp (math/lerp.glsl)
  float relief = mix(patches, edges, 0.45);
  // raised: lerp (math/lerp.glsl)
  float raised = mix(relief, fibre, 0.25);
  // wear_end: add (math/add.glsl)
  float wear_end = wear + 0.03;
  // painted: smooth_step (math/smooth_step.glsl)
  float painted = smooth_step(raised, wear, wear_end);
  // covered: lerp (math/lerp.glsl)
  vec4 covered = mix(bare, paint_color, painted);
  // gap: mortar (tiles/mortar.glsl)
  float gap = mortar(board, board_local_dx, board_local_dy);
  // wall: lerp (math/lerp.glsl)
  vec4 wall = mix(covered, vec4(0.012, 0.01, 0.008, 1.0), gap);
  // gloss: lerp (math/lerp.glsl)
  float gloss = mix(0.85, 0.4, painted);
  out_color = wall;
  out_roughness = gloss;
}
