// procedural_bricks: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec3 clay;  // default vec3(0.36, 0.13, 0.075)

// Types
struct procedural_bricks_Tile {
  vec2 local;
  vec2 size;
  uint seed;
};

// hash (random/hash.glsl)
uint procedural_bricks_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// brick_grid (tiles/brick_grid.glsl)
void procedural_bricks_brick_grid(vec2 uv, vec2 uv_dx, vec2 uv_dy, out procedural_bricks_Tile tile,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * vec2(5.0, 10.0);
  int row = int(floor(p.y));
  uint row_bits = procedural_bricks_hash(uint(row) + 2131687100u);
  float product = 0.1 * (float(procedural_bricks_hash(row_bits - 1u) >> 8u) * 5.9604645e-8);
  p = vec2(p.x + (0.5 * float(row & 1) + product), p.y);
  vec2 corner = floor(p);
  int column = int(corner.x);
  tile = procedural_bricks_Tile(p - corner, vec2(0.2, 0.1),
      procedural_bricks_hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * vec2(5.0, 10.0);
  tile_local_dy = uv_dy * vec2(5.0, 10.0);
}

// random3 (random/random3.glsl)
vec3 procedural_bricks_random3(uint seed) {
  uint bits = procedural_bricks_hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(procedural_bricks_hash(bits) >> 8u) * 5.9604645e-8);
}

// tile_near (tiles/tile_near.glsl)
float procedural_bricks_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// box_share (layers/box_share.glsl)
float procedural_bricks_box_share(vec2 q, vec2 cell_in_q, vec2 local, vec2 q_dx, vec2 q_dy,
    vec2 local_dx, vec2 local_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 cell_width = clamp(sqrt(local_dx * local_dx + local_dy * local_dy), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void procedural_bricks_layer_element_brick(procedural_bricks_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy, out float alpha, out procedural_bricks_Tile inner, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  uint seed = procedural_bricks_hash(tile.seed);
  uint hash_value = procedural_bricks_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-1.5, 1.5, pose.y) * 0.017453292;
  float size = mix(0.97, 1.02, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  vec2 p = tile.local - 0.5;
  float shrink = 1.0 / size;
  vec2 point = vec2(cos(angle) * shrink);
  vec2 product = sin(angle) * shrink * across;
  vec2 q = point * p + (product * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product;
  float alpha2 = procedural_bricks_box_share(q, vec2(shrink), tile.local, q_dx, q_dy, tile_local_dx,
      tile_local_dy);
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 0.99023324, far);
  inner = procedural_bricks_Tile(q, size * tile.size, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// hash (random/hash.glsl)
uvec2 procedural_bricks_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 procedural_bricks_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float procedural_bricks_value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = procedural_bricks_hash(uvec2(cell.y, cell.y + 1u)
      + procedural_bricks_hash(uint(seed)));
  uvec4 bits = procedural_bricks_hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// rectangle (patterns/rectangle.glsl)
float procedural_bricks_rectangle(vec2 uv, vec2 size, vec2 uv_dx, vec2 uv_dy) {
  vec2 width = max(sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 1e-7);
  vec2 share = min((0.5 * size - abs(uv - 0.5)) / width + 0.5, size / width);
  share = clamp(share, 0.0, 1.0);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(share.x * share.y, min(size.x * size.y, 1.0), far);
}

// brick_face (function of the graph)
vec4 procedural_bricks_brick_face(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  // clouds: value_noise (noise/value_noise.glsl)
  float clouds = procedural_bricks_value_noise(uv, vec2(5.0, 3.0), 1, uv_dx, uv_dy);
  // grains: value_noise (noise/value_noise.glsl)
  float grains = procedural_bricks_value_noise(uv, vec2(48.0, 24.0), 2, uv_dx, uv_dy);
  // rough: lerp (math/lerp.glsl)
  float rough = mix(clouds, grains, 0.45);
  // tone: remap (math/remap.glsl)
  float tone = mix(0.55, 1.35, rough);
  // wave: value_noise (noise/value_noise.glsl)
  float wave = procedural_bricks_value_noise(uv, vec2(18.0, 9.0), 3, uv_dx, uv_dy);
  // inset: remap (math/remap.glsl)
  float inset = mix(0.86, 0.94, wave);
  // slim: subtract (math/subtract.glsl)
  float slim = inset - 0.06;
  // size: combine2 (channels/combine2.glsl)
  vec2 size = vec2(inset, slim);
  // shape: rectangle (patterns/rectangle.glsl)
  float shape = procedural_bricks_rectangle(uv, size, uv_dx, uv_dy);
  // face: rgba (channels/rgba.glsl)
  vec4 face = vec4(tone, tone, tone, shape);
  return face;
}

// layer_element (layers/layer_element.glsl)
void procedural_bricks_layer_element_lime(procedural_bricks_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy, out float alpha, out procedural_bricks_Tile inner, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  uint seed = procedural_bricks_hash(tile.seed + 1u);
  uint hash_value = procedural_bricks_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = 360.0 * pose.y * 0.017453292;
  float size = mix(0.3, 0.9, pose.x);
  float side = min(tile.size.x, tile.size.y);
  vec2 along = tile.size / side;
  vec2 across = vec2(tile.size.y, -tile.size.x) / side;
  uint hash_value2 = procedural_bricks_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.1, 0.2), vec2(0.9, 0.8), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 product2 = cos(angle) * shrink * along;
  vec2 product3 = sin(angle) * shrink * across;
  vec2 q = product2 * p + (product3 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * product2 + tile_local_dx.yx * product3;
  vec2 q_dy = tile_local_dy * product2 + tile_local_dy.yx * product3;
  uint hash_value3 = procedural_bricks_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float box_share_value = procedural_bricks_box_share(q, along * shrink, tile.local, q_dx, q_dy,
      tile_local_dx, tile_local_dy);
  float alpha2 = mix(0.2, 0.8, luck.x) * box_share_value;
  alpha2 = luck.y >= 0.5 ? 0.0 : alpha2;
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float area = min(0.39 / (along.x * along.y), 1.0);
  alpha = mix(alpha2, 0.25 * area, far);
  inner = procedural_bricks_Tile(q, vec2(size * side), seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// circle (patterns/circle.glsl)
float procedural_bricks_circle(vec2 uv, float radius, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - 0.5;
  float from_center = length(difference);
  float greatest = max(from_center, 1e-20);
  float from_center_dx = dot(difference, uv_dx) / greatest;
  float from_center_dy = dot(difference, uv_dy) / greatest;
  float greatest2 = max(sqrt(from_center_dx * from_center_dx + from_center_dy * from_center_dy),
      1e-7);
  float width = 0.08 + greatest2;
  float near = clamp((radius - from_center) / width + 0.5, 0.0, 1.0);
  vec2 pixel = sqrt(uv_dx * uv_dx + uv_dy * uv_dy);
  float far = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  return mix(near, min(3.1415927 * radius * radius, 1.0), far);
}

// draw, of layer (layers/layer.glsl)
vec4 procedural_bricks_draw(procedural_bricks_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  float alpha;
  procedural_bricks_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  procedural_bricks_layer_element_lime(tile, tile_local_dx, tile_local_dy, alpha, inner,
      inner_local_dx, inner_local_dy);
  float value_noise_value = procedural_bricks_value_noise(inner.local, vec2(7.0), 9, inner_local_dx,
      inner_local_dy);
  float circle_value = procedural_bricks_circle(inner.local, mix(0.08, 0.5, value_noise_value),
      inner_local_dx, inner_local_dy);
  vec4 color = vec4(0.62, 0.58, 0.52, circle_value * alpha);
  return color;
}

// blend (layers/blend.glsl)
vec4 procedural_bricks_blend(vec4 foreground, vec4 background, float mask) {
  float front = foreground.w * mask;
  float both = mix(background.w, 1.0, front);
  return vec4(mix(background.xyz, foreground.xyz, front / max(both, 1e-20)), both);
}

void procedural_bricks(vec2 uv, out vec4 color, out float height) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  procedural_bricks_Tile grid;
  vec2 grid_local_dx, grid_local_dy;
  procedural_bricks_brick_grid(uv, uv_dx, uv_dy, grid, grid_local_dx, grid_local_dy);
  // shade: tile_random_color (tiles/tile_random_color.glsl)
  vec3 blend = mix(vec3(0.5), procedural_bricks_random3(grid.seed),
      procedural_bricks_tile_near(grid_local_dx, grid_local_dy));
  vec3 shade = mix(vec3(0.75, 0.8, 0.8), vec3(1.4, 1.05, 1.0), blend);
  // tint: multiply (math/multiply.glsl)
  vec3 tint = shade * clay;
  // brick: layer (layers/layer.glsl)
  float alpha;
  procedural_bricks_Tile brick_inner;
  vec2 brick_inner_local_dx, brick_inner_local_dy;
  procedural_bricks_layer_element_brick(grid, grid_local_dx, grid_local_dy, alpha, brick_inner,
      brick_inner_local_dx, brick_inner_local_dy);
  vec4 brick_face_value = procedural_bricks_brick_face(brick_inner.local, brick_inner_local_dx,
      brick_inner_local_dy);
  float mask = brick_face_value.w * alpha;
  vec4 brick_color = vec4(brick_face_value.xyz * tint, mask);
  // lime: layer (layers/layer.glsl)
  vec4 lime_color = procedural_bricks_draw(brick_inner, brick_inner_local_dx, brick_inner_local_dy);
  // face: blend (layers/blend.glsl)
  vec4 face = procedural_bricks_blend(lime_color, brick_color, mask);
  // sand: value_noise (noise/value_noise.glsl)
  float sand = procedural_bricks_value_noise(uv, vec2(220.0), 8, uv_dx, uv_dy);
  // mortar_tone: remap (math/remap.glsl)
  float mortar_tone = mix(0.22, 0.4, sand);
  // wall: over (layers/over.glsl)
  vec4 wall = vec4(mix(vec3(mortar_tone), face.xyz, face.w), 1.0);
  color = wall;
  height = mask;
}
