// checker_floor: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec4 light;  // default vec4(0.62, 0.58, 0.5, 1.0)
uniform vec4 dark;  // default vec4(0.07, 0.075, 0.085, 1.0)

// Types
struct checker_floor_Tile {
  vec2 local;
  vec2 size;
  uint seed;
};

// checker (patterns/checker.glsl)
vec4 checker_floor_checker(vec2 uv, vec4 a, vec4 b, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 4.0;
  vec2 width = max(sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 4.0, 5e-5);
  vec2 product = 0.5 * width;
  vec2 near = abs(fract(p - product) - 0.5);
  vec2 far = abs(fract(p + product) - 0.5);
  vec2 wave = (near - far) / width;
  return mix(a, b, 0.5 - 0.5 * wave.x * wave.y);
}

// hash (random/hash.glsl)
uint checker_floor_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// brick_grid (tiles/brick_grid.glsl)
void checker_floor_brick_grid(vec2 uv, vec2 uv_dx, vec2 uv_dy, out checker_floor_Tile tile,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 8.0;
  int row = int(floor(p.y));
  uint row_bits = checker_floor_hash(uint(row) + 129708002u);
  vec2 corner = floor(p);
  int column = int(corner.x);
  tile = checker_floor_Tile(p - corner, vec2(0.125), checker_floor_hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * 8.0;
  tile_local_dy = uv_dy * 8.0;
}

// hash (random/hash.glsl)
uvec2 checker_floor_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 checker_floor_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float checker_floor_value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = checker_floor_hash(uvec2(cell.y, cell.y + 1u) + checker_floor_hash(uint(seed)));
  uvec4 bits = checker_floor_hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// brick_integral, of mortar (tiles/mortar.glsl)
vec2 checker_floor_brick_integral(vec2 p, vec2 joint) {
  vec2 turns = floor(p);
  vec2 difference = 1.0 - 2.0 * joint;
  return turns * difference + clamp(p - turns - joint, vec2(0.0), difference);
}

// mortar (tiles/mortar.glsl)
float checker_floor_mortar(checker_floor_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 joint = 0.002 / tile.size;
  vec2 pixel = max(sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy), 0.0001);
  vec2 product = 0.5 * pixel;
  vec2 difference = checker_floor_brick_integral(tile.local + product, joint)
      - checker_floor_brick_integral(tile.local - product, joint);
  vec2 brick = difference / pixel;
  return 1.0 - brick.x * brick.y;
}

void checker_floor(vec2 uv, out vec4 color, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // slab: checker (patterns/checker.glsl)
  vec4 slab = checker_floor_checker(uv, light, dark, uv_dx, uv_dy);
  // grid: brick_grid (tiles/brick_grid.glsl)
  checker_floor_Tile grid;
  vec2 grid_local_dx, grid_local_dy;
  checker_floor_brick_grid(uv, uv_dx, uv_dy, grid, grid_local_dx, grid_local_dy);
  // tone: tile_random (tiles/tile_random.glsl)
  float tone = mix(0.75, 1.1, float(checker_floor_hash(grid.seed) >> 8u) * 5.9604645e-8);
  // tilted: uv_transform (images/uv_transform.glsl)
  vec2 tilted_dx = mat2(0.83867055, -0.54463905, 0.54463905, 0.83867055) * uv_dx;
  vec2 tilted_dy = mat2(0.83867055, -0.54463905, 0.54463905, 0.83867055) * uv_dy;
  vec2 tilted = mat2(0.83867055, -0.54463905, 0.54463905, 0.83867055) * (uv - 0.5) + 0.5;
  // coarse: value_noise (noise/value_noise.glsl)
  float coarse = checker_floor_value_noise(tilted, vec2(34.0), 3, tilted_dx, tilted_dy);
  // fine: value_noise (noise/value_noise.glsl)
  float fine = checker_floor_value_noise(tilted, vec2(110.0), 4, tilted_dx, tilted_dy);
  // clouds: lerp (math/lerp.glsl)
  float clouds = mix(coarse, fine, 0.4);
  // grain: remap (math/remap.glsl)
  float grain = mix(0.85, 1.1, clouds);
  // shade: multiply (math/multiply.glsl)
  float shade = tone * grain;
  // shaded: multiply (math/multiply.glsl)
  vec3 shaded = slab.xyz * shade;
  // gap: mortar (tiles/mortar.glsl)
  float gap = checker_floor_mortar(grid, grid_local_dx, grid_local_dy);
  // jointed: lerp (math/lerp.glsl)
  vec3 jointed = mix(shaded, vec3(0.16, 0.15, 0.14), gap);
  // floor_color: rgba (channels/rgba.glsl)
  vec4 floor_color = vec4(jointed, 1.0);
  // polish: lerp (math/lerp.glsl)
  float polish = mix(0.25, 0.9, gap);
  color = floor_color;
  roughness = polish;
}
