// bricks: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Textures
layout(location = 0, binding = 0) uniform sampler2D brick;
layout(location = 1, binding = 1) uniform sampler2D brick_relief;
layout(location = 2, binding = 2) uniform sampler2D mortar;
layout(location = 3, binding = 3) uniform sampler2D soot;
layout(location = 4, binding = 4) uniform sampler2D moss;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out float out_roughness;

// Types
struct Tile {
  vec2 local;
  vec2 size;
  uint seed;
  vec2 right;
  vec2 up;
};
struct Material {
  vec4 color;
  vec3 normal;
  float roughness;
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
  vec2 p = uv * vec2(4.0, 8.0);
  int row = int(floor(p.y));
  uint row_bits = hash(uint(row) + 2055130248u);
  p = vec2(p.x + 0.5 * float(row & 1), p.y);
  vec2 corner = floor(p);
  int column = int(corner.x);
  uint hash_value = hash(uint(column) + row_bits);
  tile = Tile(p - corner, vec2(0.25, 0.125), hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * vec2(4.0, 8.0);
  tile_local_dy = uv_dy * vec2(4.0, 8.0);
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// random3 (random/random3.glsl)
vec3 random3(uint seed) {
  uint bits = hash(seed + 4u);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(hash(bits) >> 8u) * 5.9604645e-8);
}

// rgb_to_hsv (color/rgb_to_hsv.glsl)
vec3 rgb_to_hsv(vec3 color) {
  float value = max(max(color.x, color.y), color.z);
  float range = value - min(min(color.x, color.y), color.z);
  float part = 1.0 / max(range, 1e-20);
  float sector = (color.x - color.y) * part + 4.0;
  float sector2;
  if (color.x == value) {
    sector2 = (color.y - color.z) * part;
  } else {
    if (color.y == value) {
      sector = (color.z - color.x) * part + 2.0;
    }
    sector2 = sector;
  }
  return vec3(fract(sector2 / 6.0), range / max(value, 1e-20), value);
}

// hsv_to_rgb (color/hsv_to_rgb.glsl)
vec3 hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0);
  vec3 blend = mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
  return hsv.z * blend;
}

// hsv_adjust (color/hsv_adjust.glsl)
vec3 hsv_adjust(float hue, float saturation, float value) {
  float pull = saturation == 1.0 ? 1.0 : min(saturation, 9.999998);
  vec3 pulled = mix(vec3(1.0), vec3(1.0, 0.94, 0.9), pull);
  vec3 hsv = rgb_to_hsv(pulled);
  vec3 turned = hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? pulled : turned);
}

// varied, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 varied(uint seed, float near) {
  vec3 luck = mix(vec3(0.5), random3(seed), near);
  vec3 one = hsv_adjust(mix(-5.0, 9.0, luck.x), mix(0.65, 1.1, luck.y), mix(0.5, 1.25, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9975142), one, near);
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

// layer_element (layers/layer_element.glsl)
void layer_element_bricks(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-1.5, 1.5, pose.y) * 0.017453292;
  float size = mix(0.97, 1.03, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.485, 0.475), vec2(0.515, 0.525), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  float cosine = cos(angle);
  vec2 point = vec2(cosine * shrink);
  float sine = sin(angle);
  vec2 product2 = sine * shrink * across;
  vec2 q = point * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product2;
  vec2 right = cosine * tile.right + sine * tile.up;
  vec2 up = cosine * tile.up - sine * tile.right;
  float alpha2 = box_share(q, vec2(shrink), tile.local, q_dx, q_dy, tile_local_dx, tile_local_dy);
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 1.0, far);
  inner = Tile(q, size * tile.size, seed, right, up);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// normal_map (materials/normal_map.glsl)
vec3 normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  vec2 slope = 0.7 * n.xy;
  vec3 steep = vec3(slope, n.z);
  return steep * inversesqrt(max(dot(steep, steep), 1e-20));
}

// draw_bricks, of material_layer (materials/material_layer.glsl)
Material draw_bricks(Tile tile, vec3 tint, vec2 tile_local_dx, vec2 tile_local_dy, out Tile inner,
    out vec2 inner_local_dx, out vec2 inner_local_dy) {
  float alpha;
  Tile inner2;
  vec2 inner_local_dx2, inner_local_dy2;
  layer_element_bricks(tile, tile_local_dx, tile_local_dy, alpha, inner2, inner_local_dx2,
      inner_local_dy2);
  vec4 texel = textureGrad(brick, inner2.local, inner_local_dx2, inner_local_dy2);
  vec3 vector = textureGrad(brick_relief, inner2.local, inner_local_dx2, inner_local_dy2).xyz;
  vec3 normal_map_value = normal_map(vector);
  vec3 vector2 = vec3(normal_map_value.x * inner2.right + normal_map_value.y * inner2.up,
      normal_map_value.z);
  Material seen = Material(vec4(texel.xyz * tint, texel.w * alpha), vector2, 0.85);
  inner = inner2;
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
  return seen;
}

// layer_element (layers/layer_element.glsl)
void layer_element_sooty(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed + 1u);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-8.0, 8.0, pose.y) * 0.017453292;
  float size = mix(0.7, 1.4, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.1, 0.4), vec2(0.9, 0.7), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  float cosine = cos(angle);
  vec2 point = vec2(cosine * shrink);
  float sine = sin(angle);
  vec2 product2 = sine * shrink * across;
  vec2 q = point * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product2;
  vec2 right = cosine * tile.right + sine * tile.up;
  vec2 up = cosine * tile.up - sine * tile.right;
  uint hash_value3 = hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float box_share_value = box_share(q, vec2(shrink), tile.local, q_dx, q_dy, tile_local_dx,
      tile_local_dy);
  float alpha2 = luck.x * box_share_value;
  alpha2 = luck.y >= 0.7 ? 0.0 : alpha2;
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 0.35, far);
  inner = Tile(q, size * tile.size, seed, right, up);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// draw_sooty, of material_layer (materials/material_layer.glsl)
Material draw_sooty(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_sooty(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 texel = textureGrad(soot, inner.local, inner_local_dx, inner_local_dy);
  Material seen = Material(vec4(texel.xyz, texel.w * alpha), vec3(0.0, 0.0, 1.0), 0.95);
  return seen;
}

// layer_element (layers/layer_element.glsl)
void layer_element_mossy(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha,
    out Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed + 2u);
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-180.0, 180.0, pose.y) * 0.017453292;
  float size = mix(0.35, 0.95, pose.x);
  float side = min(tile.size.x, tile.size.y);
  vec2 along = tile.size / side;
  vec2 across = vec2(tile.size.y, -tile.size.x) / side;
  uint hash_value2 = hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.1, 0.2), vec2(0.9, 0.6), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  float cosine = cos(angle);
  vec2 product2 = cosine * shrink * along;
  float sine = sin(angle);
  vec2 product3 = sine * shrink * across;
  vec2 q = product2 * p + (product3 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * product2 + tile_local_dx.yx * product3;
  vec2 q_dy = tile_local_dy * product2 + tile_local_dy.yx * product3;
  vec2 right = cosine * tile.right + sine * tile.up;
  vec2 up = cosine * tile.up - sine * tile.right;
  uint hash_value3 = hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = box_share(q, along * shrink, tile.local, q_dx, q_dy, tile_local_dx, tile_local_dy);
  alpha2 = luck.y >= 0.4 ? 0.0 : alpha2;
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float area = min(0.4525 / (along.x * along.y), 1.0);
  alpha = mix(alpha2, 0.4 * area, far);
  inner = Tile(q, vec2(size * side), seed, right, up);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// draw_mossy, of material_layer (materials/material_layer.glsl)
Material draw_mossy(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element_mossy(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 texel = textureGrad(moss, inner.local, inner_local_dx, inner_local_dy);
  Material seen = Material(vec4(texel.xyz, texel.w * alpha), vec3(0.0, 0.0, 1.0), 1.0);
  return seen;
}

// material_over (materials/material_over.glsl)
Material material_over_laid(Material foreground, Material background) {
  float alpha = mix(background.color.w, 1.0, foreground.color.w);
  float share = foreground.color.w / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 n = mix(background.normal, foreground.normal, share);
  float blend = mix(background.roughness, foreground.roughness, share);
  Material seen = Material(vector, n * inversesqrt(max(dot(n, n), 1e-20)), blend);
  return seen;
}

// combine_normals (materials/combine_normals.glsl)
vec3 combine_normals(vec3 base, vec3 detail, float strength) {
  vec2 ratio = strength * detail.xy / max(detail.z, 0.01);
  vec3 n = vec3(base.xy / max(base.z, 0.01) + ratio, 1.0);
  return n * inversesqrt(dot(n, n));
}

// material_over (materials/material_over.glsl)
Material material_over_smoked(Material foreground, Material background, float mask) {
  float front = foreground.color.w * 0.85 * mask;
  float alpha = mix(background.color.w, 1.0, front);
  float share = front / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 combine_normals_value = combine_normals(background.normal, foreground.normal, share);
  Material seen = Material(vector, combine_normals_value,
      mix(background.roughness, foreground.roughness, share));
  return seen;
}

// material_over (materials/material_over.glsl)
Material material_over_grown(Material foreground, Material background) {
  float alpha = mix(background.color.w, 1.0, foreground.color.w);
  float share = foreground.color.w / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 combine_normals_value = combine_normals(background.normal, foreground.normal, share);
  Material seen = Material(vector, combine_normals_value,
      mix(background.roughness, foreground.roughness, share));
  return seen;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  Tile grid;
  vec2 grid_local_dx, grid_local_dy;
  brick_grid(uv, uv_dx, uv_dy, grid, grid_local_dx, grid_local_dy);
  // tint: tile_random_hsv (tiles/tile_random_hsv.glsl)
  vec3 tint = varied(grid.seed, tile_near(grid_local_dx, grid_local_dy));
  // bricks: material_layer (materials/material_layer.glsl)
  Tile bricks_inner;
  vec2 bricks_inner_local_dx, bricks_inner_local_dy;
  Material bricks_surface = draw_bricks(grid, tint, grid_local_dx, grid_local_dy, bricks_inner,
      bricks_inner_local_dx, bricks_inner_local_dy);
  // sooty: material_layer (materials/material_layer.glsl)
  Material sooty_surface = draw_sooty(bricks_inner, bricks_inner_local_dx, bricks_inner_local_dy);
  // mossy: material_layer (materials/material_layer.glsl)
  Material mossy_surface = draw_mossy(bricks_inner, bricks_inner_local_dx, bricks_inner_local_dy);
  // mortar_color: tiled_image (images/tiled_image.glsl)
  vec4 mortar_color = texture(mortar, uv * 2.0);
  // bed: material (materials/material.glsl)
  Material bed = Material(mortar_color, vec3(0.0, 0.0, 1.0), 0.95);
  // laid: material_over (materials/material_over.glsl)
  Material laid = material_over_laid(bricks_surface, bed);
  // smoked: material_over (materials/material_over.glsl)
  Material smoked = material_over_smoked(sooty_surface, laid, bricks_surface.color.w);
  // grown: material_over (materials/material_over.glsl)
  Material grown = material_over_grown(mossy_surface, smoked);
  out_color = grown.color;
  out_normal = grown.normal;
  out_roughness = grown.roughness;
}
