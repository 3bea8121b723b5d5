// brick_wall: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec3 tint;  // default vec3(1.0)
uniform float soot_amount;  // default 0.85
uniform float moss_amount;  // default 0.9

// Textures
uniform sampler2D brick;
uniform sampler2D mortar;
uniform sampler2D soot;
uniform sampler2D moss;

// Types
struct brick_wall_Tile {
  vec2 local;
  vec2 size;
  uint seed;
};

// wrap_cell (tiles/wrap_cell.glsl)
int brick_wall_wrap_cell(int cell, int count) {
  int flip = cell >> 31;
  return (((cell ^ flip) % count) ^ flip) + (flip & count);
}

// hash (random/hash.glsl)
uint brick_wall_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// brick_grid (tiles/brick_grid.glsl)
void brick_wall_brick_grid(vec2 uv, vec2 uv_dx, vec2 uv_dy, out brick_wall_Tile tile,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * vec2(5.0, 10.0);
  int row = int(floor(p.y));
  row = brick_wall_wrap_cell(row, 10);
  uint row_bits = brick_wall_hash(uint(row) + 129708002u);
  float product = 0.08 * (float(brick_wall_hash(row_bits - 1u) >> 8u) * 5.9604645e-8);
  p = vec2(p.x + (0.5 * float(row & 1) + product), p.y);
  vec2 corner = floor(p);
  int column = int(corner.x);
  column = brick_wall_wrap_cell(column, 5);
  tile = brick_wall_Tile(p - corner, vec2(0.2, 0.1), brick_wall_hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * vec2(5.0, 10.0);
  tile_local_dy = uv_dy * vec2(5.0, 10.0);
}

// color_ramp (color/color_ramp.glsl)
vec4 brick_wall_color_ramp(float position) {
  vec4 vector = vec4(clamp(position / 0.2, 0.0, 1.0));
  vec4 color = mix(vec4(0.38, 0.36, 0.4, 1.0), vec4(0.85, 0.75, 0.7, 1.0), vector);
  color = mix(color, vec4(1.25, 1.0, 0.8, 1.0), clamp((position - 0.2) / 0.40000004, 0.0, 1.0));
  return mix(color, vec4(1.5, 1.5, 1.3, 1.0), clamp((position - 0.6) / 0.39999998, 0.0, 1.0));
}

// box_share (layers/box_share.glsl)
float brick_wall_box_share(vec2 q, vec2 cell_in_q, vec2 local, vec2 q_dx, vec2 q_dy, vec2 local_dx,
    vec2 local_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 cell_width = clamp(sqrt(local_dx * local_dx + local_dy * local_dy), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void brick_wall_layer_element_brick_layer(brick_wall_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy, out float alpha, out brick_wall_Tile inner, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  uint seed = brick_wall_hash(tile.seed);
  uint hash_value = brick_wall_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-1.2, 1.2, pose.y) * 0.017453292;
  float size = mix(0.97, 1.03, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = brick_wall_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.485, 0.48), vec2(0.515, 0.52), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 point = vec2(cos(angle) * shrink);
  vec2 product2 = sin(angle) * shrink * across;
  vec2 q = point * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product2;
  float alpha2 = brick_wall_box_share(q, vec2(shrink), tile.local, q_dx, q_dy, tile_local_dx,
      tile_local_dy);
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 1.0, far);
  inner = brick_wall_Tile(q, size * tile.size, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// layer_element (layers/layer_element.glsl)
void brick_wall_layer_element_soot_layer(brick_wall_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy, out float alpha, out brick_wall_Tile inner, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  uint seed = brick_wall_hash(tile.seed + 1u);
  uint hash_value = brick_wall_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-8.0, 8.0, pose.y) * 0.017453292;
  float size = mix(0.8, 1.5, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = brick_wall_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.1, 0.4), vec2(0.9, 0.7), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 point = vec2(cos(angle) * shrink);
  vec2 product2 = sin(angle) * shrink * across;
  vec2 q = point * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product2;
  uint hash_value3 = brick_wall_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float box_share_value = brick_wall_box_share(q, vec2(shrink), tile.local, q_dx, q_dy,
      tile_local_dx, tile_local_dy);
  float alpha2 = luck.x * box_share_value;
  alpha2 = luck.y >= 0.7 ? 0.0 : alpha2;
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 0.35, far);
  inner = brick_wall_Tile(q, size * tile.size, seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// layer_element (layers/layer_element.glsl)
void brick_wall_layer_element_moss_layer(brick_wall_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy, out float alpha, out brick_wall_Tile inner, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  uint seed = brick_wall_hash(tile.seed + 2u);
  uint hash_value = brick_wall_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-180.0, 180.0, pose.y) * 0.017453292;
  float size = mix(0.4, 1.0, pose.x);
  float side = min(tile.size.x, tile.size.y);
  vec2 along = tile.size / side;
  vec2 across = vec2(tile.size.y, -tile.size.x) / side;
  uint hash_value2 = brick_wall_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.1, 0.3), vec2(0.9, 0.55), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 product2 = cos(angle) * shrink * along;
  vec2 product3 = sin(angle) * shrink * across;
  vec2 q = product2 * p + (product3 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * product2 + tile_local_dx.yx * product3;
  vec2 q_dy = tile_local_dy * product2 + tile_local_dy.yx * product3;
  uint hash_value3 = brick_wall_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float box_share_value = brick_wall_box_share(q, along * shrink, tile.local, q_dx, q_dy,
      tile_local_dx, tile_local_dy);
  float alpha2 = mix(0.6, 1.0, luck.x) * box_share_value;
  alpha2 = luck.y >= 0.35 ? 0.0 : alpha2;
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float area = min(0.52 / (along.x * along.y), 1.0);
  alpha = mix(alpha2, 0.28 * area, far);
  inner = brick_wall_Tile(q, vec2(size * side), seed);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// blend (layers/blend.glsl)
vec4 brick_wall_blend_sooty_brick(vec4 foreground, vec4 background, float opacity, float mask) {
  float front = foreground.w * opacity * mask;
  float both = mix(background.w, 1.0, front);
  return vec4(mix(background.xyz, foreground.xyz, front / max(both, 1e-20)), both);
}

// blend (layers/blend.glsl)
vec4 brick_wall_blend_mossy_wall(vec4 foreground, vec4 background, float opacity) {
  float front = foreground.w * opacity;
  float both = mix(background.w, 1.0, front);
  return vec4(mix(background.xyz, foreground.xyz, front / max(both, 1e-20)), both);
}

void brick_wall(vec2 uv, out vec4 color, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  brick_wall_Tile grid;
  vec2 grid_local_dx, grid_local_dy;
  brick_wall_brick_grid(uv, uv_dx, uv_dy, grid, grid_local_dx, grid_local_dy);
  // bed: tiled_image (images/tiled_image.glsl)
  vec4 bed = texture(mortar, uv * 3.0);
  // firing: tile_random (tiles/tile_random.glsl)
  float firing = float(brick_wall_hash(grid.seed) >> 8u) * 5.9604645e-8;
  // clay: color_ramp (color/color_ramp.glsl)
  vec4 clay = brick_wall_color_ramp(firing);
  // brightness: tile_random (tiles/tile_random.glsl)
  float brightness = mix(0.7, 1.15, float(brick_wall_hash(grid.seed + 1u) >> 8u) * 5.9604645e-8);
  // shade: multiply (math/multiply.glsl)
  vec3 shade = clay.xyz * brightness;
  // brick_tint: multiply (math/multiply.glsl)
  vec3 brick_tint = shade * tint;
  // brick_layer: layer (layers/layer.glsl)
  float alpha;
  brick_wall_Tile brick_layer_inner;
  vec2 brick_layer_inner_local_dx, brick_layer_inner_local_dy;
  brick_wall_layer_element_brick_layer(grid, grid_local_dx, grid_local_dy, alpha, brick_layer_inner,
      brick_layer_inner_local_dx, brick_layer_inner_local_dy);
  vec4 texel = textureGrad(brick, brick_layer_inner.local, brick_layer_inner_local_dx,
      brick_layer_inner_local_dy);
  float brick_mask = texel.w * alpha;
  vec4 brick_layer_color = vec4(texel.xyz * brick_tint, brick_mask);
  // soot_layer: layer (layers/layer.glsl)
  float alpha2;
  brick_wall_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  brick_wall_layer_element_soot_layer(brick_layer_inner, brick_layer_inner_local_dx,
      brick_layer_inner_local_dy, alpha2, inner, inner_local_dx, inner_local_dy);
  vec4 texel2 = textureGrad(soot, inner.local, inner_local_dx, inner_local_dy);
  vec4 soot_layer_color = vec4(texel2.xyz, texel2.w * alpha2);
  // moss_layer: layer (layers/layer.glsl)
  float alpha3;
  brick_wall_Tile inner2;
  vec2 inner_local_dx2, inner_local_dy2;
  brick_wall_layer_element_moss_layer(brick_layer_inner, brick_layer_inner_local_dx,
      brick_layer_inner_local_dy, alpha3, inner2, inner_local_dx2, inner_local_dy2);
  vec4 texel3 = textureGrad(moss, inner2.local, inner_local_dx2, inner_local_dy2);
  vec4 moss_layer_color = vec4(texel3.xyz, texel3.w * alpha3);
  // sooty_brick: blend (layers/blend.glsl)
  vec4 sooty_brick = brick_wall_blend_sooty_brick(soot_layer_color, brick_layer_color, soot_amount,
      brick_mask);
  // wall: over (layers/over.glsl)
  vec4 wall = vec4(mix(bed.xyz, sooty_brick.xyz, sooty_brick.w), 1.0);
  // mossy_wall: blend (layers/blend.glsl)
  vec4 mossy_wall = brick_wall_blend_mossy_wall(moss_layer_color, wall, moss_amount);
  // roughness: lerp (math/lerp.glsl)
  float roughness2 = mix(0.95, 0.8, brick_mask);
  color = mossy_wall;
  roughness = roughness2;
}
