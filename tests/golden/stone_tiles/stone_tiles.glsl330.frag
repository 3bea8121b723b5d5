// stone_tiles: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform vec3 grout;  // default vec3(0.3, 0.27, 0.24)
uniform float wear;  // default 0.02

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_height;

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
  vec2 p = uv * vec2(4.0, 6.0);
  int row = int(floor(p.y));
  uint row_bits = hash(uint(row) + 1170772408u);
  p = vec2(p.x + 0.5 * float(row & 1), p.y);
  vec2 corner = floor(p);
  int column = int(corner.x);
  tile = Tile(p - corner, vec2(0.25, 0.16666667), hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * vec2(4.0, 6.0);
  tile_local_dy = uv_dy * vec2(4.0, 6.0);
}

// color_ramp (color/color_ramp.glsl)
vec4 color_ramp(float position) {
  vec4 vector = vec4(clamp(position * 2.0, 0.0, 1.0));
  vec4 color = mix(vec4(0.42, 0.27, 0.15, 1.0), vec4(0.58, 0.42, 0.26, 1.0), vector);
  return mix(color, vec4(0.5, 0.36, 0.27, 1.0), clamp((position - 0.5) * 2.0, 0.0, 1.0));
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
float smooth_step(float value) {
  float t = clamp((value + 0.004) / 0.016, 0.0, 1.0);
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
  vec2 joint = 0.006 / tile.size;
  vec2 pixel = max(sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy), 0.0001);
  vec2 product = 0.5 * pixel;
  vec2 difference = brick_integral(tile.local + product, joint)
      - brick_integral(tile.local - product, joint);
  vec2 brick = difference / pixel;
  return 1.0 - brick.x * brick.y;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  Tile grid;
  vec2 grid_local_dx, grid_local_dy;
  brick_grid(uv, uv_dx, uv_dy, grid, grid_local_dx, grid_local_dy);
  // hue: tile_random (tiles/tile_random.glsl)
  float hue = float(hash(grid.seed) >> 8u) * 5.9604645e-8;
  // stone: color_ramp (color/color_ramp.glsl)
  vec4 stone = color_ramp(hue);
  // strata: value_noise (noise/value_noise.glsl)
  float strata = value_noise(uv, vec2(5.0, 60.0), 4, uv_dx, uv_dy);
  // sand: value_noise (noise/value_noise.glsl)
  float sand = value_noise(uv, vec2(180.0), 5, uv_dx, uv_dy);
  // grain: lerp (math/lerp.glsl)
  float grain = mix(strata, sand, 0.5);
  // tone: remap (math/remap.glsl)
  float tone = mix(0.7, 1.2, grain);
  // toned: multiply (math/multiply.glsl)
  vec3 toned = stone.xyz * tone;
  // depth: tile_distance (tiles/tile_distance.glsl)
  vec2 product = (0.5 - abs(grid.local - 0.5)) * vec2(0.25, 0.16666667);
  float depth = min(product.x, product.y);
  // bites: value_noise (noise/value_noise.glsl)
  float bites = value_noise(uv, vec2(50.0), 6, uv_dx, uv_dy);
  // eaten: multiply (math/multiply.glsl)
  float eaten = bites * wear;
  // inner_depth: subtract (math/subtract.glsl)
  float inner_depth = depth - eaten;
  // evenness: smooth_step (math/smooth_step.glsl)
  float evenness = smooth_step(inner_depth);
  // worn: remap (math/remap.glsl)
  float worn = mix(0.55, 1.0, evenness);
  // worn_color: multiply (math/multiply.glsl)
  vec3 worn_color = toned * worn;
  // joint: mortar (tiles/mortar.glsl)
  float joint = mortar(grid, grid_local_dx, grid_local_dy);
  // grouted: lerp (math/lerp.glsl)
  vec3 grouted = mix(worn_color, grout, joint);
  // floor_color: rgba (channels/rgba.glsl)
  vec4 floor_color = vec4(grouted, 1.0);
  out_color = floor_color;
  out_height = evenness;
}
