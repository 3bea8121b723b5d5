// hallway: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec3 wall_tint;  // default vec3(1.0, 0.97, 0.9)
uniform vec3 dado_tint;  // default vec3(0.2, 0.3, 0.23)

// Textures
uniform sampler2D brick;
uniform sampler2D brick_relief;
uniform sampler2D mortar;
uniform sampler2D soot;
uniform sampler2D plaster_color;
uniform sampler2D plaster_relief;
uniform sampler2D crack;
uniform sampler2D hole;
uniform sampler2D door_color;
uniform sampler2D door_relief;
uniform sampler2D window_color;
uniform sampler2D window_relief;

// Types
struct hallway_Tile {
  vec2 local;
  vec2 size;
  uint seed;
  vec2 right;
  vec2 up;
};
struct hallway_Material {
  vec4 color;
  vec3 normal;
  float height;
  float roughness;
  float metallic;
};

// hash (random/hash.glsl)
uint hallway_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// brick_grid (tiles/brick_grid.glsl)
void hallway_brick_grid_brick_tiles(vec2 uv, int rows, int columns, float row_offset, int seed,
    vec2 uv_dx, vec2 uv_dy, out hallway_Tile tile, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 cells = vec2(float(columns), float(rows));
  vec2 p = uv * cells;
  int row = int(floor(p.y));
  uint row_bits = hallway_hash(uint(row) + hallway_hash(uint(seed)));
  p = vec2(p.x + row_offset * float(row & 1), p.y);
  vec2 corner = floor(p);
  int column = int(corner.x);
  uint hash_value = hallway_hash(uint(column) + row_bits);
  tile = hallway_Tile(p - corner, 1.0 / cells, hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * cells;
  tile_local_dy = uv_dy * cells;
}

// box_share (layers/box_share.glsl)
float hallway_box_share_brick_layer(vec2 q, vec2 cell_in_q, vec2 local, vec2 q_dx, vec2 q_dy,
    vec2 local_dx, vec2 local_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 cell_width = clamp(sqrt(local_dx * local_dx + local_dy * local_dy), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void hallway_layer_element_brick_layer(hallway_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out float alpha, out hallway_Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hallway_hash(tile.seed);
  uint hash_value = hallway_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-1.0, 1.0, pose.y) * 0.017453292;
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hallway_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.49, 0.48), vec2(0.51, 0.52), product);
  vec2 p = tile.local - center;
  vec2 point = vec2(cos(angle));
  vec2 point2 = vec2(sin(angle));
  vec2 product2 = point2 * across;
  vec2 q = point * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * point + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * point + tile_local_dy.yx * product2;
  vec2 right = point * tile.right + point2 * tile.up;
  vec2 up = point * tile.up - point2 * tile.right;
  float alpha2 = hallway_box_share_brick_layer(q, vec2(1.0), tile.local, q_dx, q_dy, tile_local_dx,
      tile_local_dy);
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 1.0, far);
  inner = hallway_Tile(q, tile.size, seed, right, up);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// normal_map (materials/normal_map.glsl)
vec3 hallway_normal_map_slope(vec3 texel, float strength) {
  vec3 n = texel * 2.0 - 1.0;
  vec2 slope = strength * n.xy;
  vec3 steep = vec3(slope, n.z);
  return steep * inversesqrt(max(dot(steep, steep), 1e-20));
}

// tile_near (tiles/tile_near.glsl)
float hallway_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// random3 (random/random3.glsl)
vec3 hallway_random3(uint seed) {
  uint bits = hallway_hash(seed + 5u);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(hallway_hash(bits) >> 8u) * 5.9604645e-8);
}

// rgb_to_hsv (color/rgb_to_hsv.glsl)
vec3 hallway_rgb_to_hsv(vec3 color) {
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
vec3 hallway_hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0);
  vec3 blend = mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
  return hsv.z * blend;
}

// hsv_adjust (color/hsv_adjust.glsl)
vec3 hallway_hsv_adjust(vec3 color, float hue, float saturation, float value) {
  float top = max(max(color.x, color.y), color.z);
  float range = top - min(min(color.x, color.y), color.z);
  float pull = 1.0;
  if (saturation != 1.0) {
    pull = min(saturation, top / max(range, 1e-20));
  }
  vec3 pulled = mix(vec3(top), color, pull);
  vec3 hsv = hallway_rgb_to_hsv(pulled);
  vec3 turned = hallway_hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? pulled : turned);
}

// varied, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 hallway_varied(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), hallway_random3(seed), near);
  vec3 one = hallway_hsv_adjust(color, mix(-6.0, 8.0, luck.x), mix(0.7, 1.1, luck.y),
      mix(0.55, 1.1, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9975142), one, near);
}

// brick_surface (function of the graph)
hallway_Material hallway_brick_surface(vec2 uv, hallway_Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // picture: image (images/image.glsl)
  vec4 picture = textureGrad(brick, uv, uv_dx, uv_dy);
  // texel: image (images/image.glsl)
  vec4 texel = textureGrad(brick_relief, uv, uv_dx, uv_dy);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = hallway_normal_map_slope(texel.xyz, 0.7);
  // surface: material (materials/material.glsl)
  vec4 vector = vec4(hallway_varied(tile.seed, hallway_tile_near(uv_dx, uv_dy), picture.xyz),
      picture.w);
  hallway_Material surface = hallway_Material(vector, slope, -0.14, 0.85, 0.0);
  return surface;
}

// draw_brick_layer, of material_layer (materials/material_layer.glsl)
hallway_Material hallway_draw_brick_layer(hallway_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  float alpha;
  hallway_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  hallway_layer_element_brick_layer(tile, tile_local_dx, tile_local_dy, alpha, inner,
      inner_local_dx, inner_local_dy);
  hallway_Material seen = hallway_brick_surface(inner.local, inner, inner_local_dx, inner_local_dy);
  vec3 vector = vec3(seen.normal.x * inner.right + seen.normal.y * inner.up, seen.normal.z);
  seen = hallway_Material(vec4(seen.color.xyz, seen.color.w * alpha), vector, -0.14, 0.85, 0.0);
  return seen;
}

// material_over (materials/material_over.glsl)
hallway_Material hallway_material_over_bricks(hallway_Material foreground,
    hallway_Material background) {
  float alpha = mix(background.color.w, 1.0, foreground.color.w);
  float share = foreground.color.w / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 n = mix(background.normal, foreground.normal, share);
  vec3 product = n * inversesqrt(max(dot(n, n), 1e-20));
  float blend = mix(background.height, foreground.height, share);
  float blend2 = mix(background.roughness, foreground.roughness, share);
  float blend3 = mix(background.metallic, foreground.metallic, share);
  hallway_Material seen = hallway_Material(vector, product, blend, blend2, blend3);
  return seen;
}

// hash (random/hash.glsl)
uvec2 hallway_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 hallway_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float hallway_value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = hallway_hash(uvec2(cell.y, cell.y + 1u) + hallway_hash(uint(seed)));
  uvec4 bits = hallway_hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// smooth_step (math/smooth_step.glsl)
float hallway_smooth_step_smoke(float value) {
  float t = clamp((value - 0.7) / 0.45, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// mean, of material_layer (materials/material_layer.glsl)
hallway_Material hallway_mean(hallway_Material total) {
  float share = 1.0 / max(total.color.w, 1e-20);
  vec3 n = total.normal + vec3(0.0, 0.0, 1e-9);
  vec4 vector = vec4(total.color.xyz * share, total.color.w);
  vec3 product = n * inversesqrt(max(dot(n, n), 1e-20));
  float product2 = total.roughness * share;
  return hallway_Material(vector, product, total.height * share, product2, total.metallic * share);
}

// brick_grid (tiles/brick_grid.glsl)
void hallway_brick_grid_hole_tiles(vec2 uv, ivec2 neighbour, vec2 uv_dx, vec2 uv_dy,
    out hallway_Tile tile, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 2.0;
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = hallway_hash(uint(row) + 1133566046u);
  float sum = 0.5 * float(row & 1) + float(hallway_hash(row_bits - 1u) >> 8u) * 5.9604645e-8;
  p = vec2(p.x + sum, p.y);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  uint hash_value = hallway_hash(uint(column) + row_bits);
  tile = hallway_Tile(p - corner, vec2(0.5), hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * 2.0;
  tile_local_dy = uv_dy * 2.0;
}

// box_share (layers/box_share.glsl)
float hallway_box_share_holes(vec2 q, vec2 cell_in_q, vec2 q_dx, vec2 q_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 covered = clamp(share, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void hallway_layer_element_holes(hallway_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out float alpha, out hallway_Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hallway_hash(tile.seed);
  uint hash_value = hallway_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-180.0, 180.0, pose.y) * 0.017453292;
  uint bits = hallway_hash(seed - 4u);
  float ratio = mix(0.7, 1.2, float(bits & 65535u) * 1.5258789e-5);
  float size = mix(0.3, 0.95, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hallway_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.1), vec2(0.9), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 into = shrink * vec2(1.0, 1.0 / ratio);
  vec2 point = vec2(cos(angle));
  vec2 product2 = point * into;
  vec2 point2 = vec2(sin(angle));
  vec2 product3 = point2 * into * across;
  vec2 q = product2 * p + (product3 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * product2 + tile_local_dx.yx * product3;
  vec2 q_dy = tile_local_dy * product2 + tile_local_dy.yx * product3;
  vec2 right = point * tile.right + point2 * tile.up;
  vec2 up = point * tile.up - point2 * tile.right;
  vec2 difference = q - 0.5;
  bool test = ((bits >> 16u) & 4u) != 0u;
  vec2 sum = vec2(test ? -difference.x : difference.x, difference.y) + 0.5;
  vec2 point3 = vec2(test ? -right.x : right.x, test ? -right.y : right.y);
  uint hash_value3 = hallway_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = hallway_box_share_holes(q, into, q_dx, q_dy);
  alpha = luck.y >= 0.3 ? 0.0 : alpha2;
  inner = hallway_Tile(sum, size * vec2(1.0, ratio) * tile.size, seed, point3, up);
  inner_local_dx = vec2(test ? -q_dx.x : q_dx.x, q_dx.y);
  inner_local_dy = vec2(test ? -q_dy.x : q_dy.x, q_dy.y);
}

// normal_map (materials/normal_map.glsl)
vec3 hallway_normal_map_slope2(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

// draw_holes, of material_layer (materials/material_layer.glsl)
hallway_Material hallway_draw_holes(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  hallway_Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  hallway_brick_grid_hole_tiles(uv, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  hallway_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  hallway_layer_element_holes(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  hallway_Material seen = hallway_Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0, 0.0);
  if (alpha > 0.0) {
    vec4 texel = textureGrad(hole, inner.local, inner_local_dx, inner_local_dy);
    vec3 normal_map_slope_value = hallway_normal_map_slope2(texel.xyz);
    vec3 vector = vec3(normal_map_slope_value.x * inner.right + normal_map_slope_value.y * inner.up,
        normal_map_slope_value.z);
    seen = hallway_Material(vec4(0.5, 0.5, 0.5, texel.w * alpha), vector, 0.0, 0.6, 0.0);
  }
  return seen;
}

// material_layer (materials/material_layer.glsl)
hallway_Material hallway_material_layer_holes(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  hallway_Material total = hallway_Material(vec4(0.0), vec3(0.0), 0.0, 0.0, 0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && total.color.w < 0.999; --x) {
      hallway_Material other = hallway_draw_holes(uv, ivec2(x, y), uv_dx, uv_dy);
      float product = other.color.w * (1.0 - total.color.w * on);
      vec4 sum = total.color + vec4(other.color.xyz * product, product);
      vec3 sum2 = total.normal + product * other.normal;
      float sum3 = total.roughness + product * other.roughness;
      float sum4 = total.metallic + product * other.metallic;
      total = hallway_Material(sum, sum2, total.height + product * other.height, sum3, sum4);
    }
  }
  hallway_Material surface = hallway_mean(total);
  vec4 vector = vec4(surface.color.xyz, min(surface.color.w, 1.0));
  surface = hallway_Material(vector, surface.normal, surface.height, surface.roughness,
      surface.metallic);
  return surface;
}

// smooth_step (math/smooth_step.glsl)
float hallway_smooth_step_no_finish(float value) {
  float t = clamp((value - 0.2) / 0.11999999, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// smooth_step (math/smooth_step.glsl)
float hallway_smooth_step_no_coat(float value) {
  float t = clamp((value - 0.5) / 0.13, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// combine_normals (materials/combine_normals.glsl)
vec3 hallway_combine_normals_coat_slope(vec3 base, vec3 detail) {
  vec2 sum = base.xy / max(base.z, 0.01) + detail.xy / max(detail.z, 0.01);
  vec3 n = vec3(sum, 1.0);
  return n * inversesqrt(dot(n, n));
}

// material_over (materials/material_over.glsl)
hallway_Material hallway_material_over_coated(hallway_Material foreground,
    hallway_Material background, float mask) {
  float front = foreground.color.w * mask;
  float alpha = mix(background.color.w, 1.0, front);
  float share = front / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 n = mix(background.normal, foreground.normal, share);
  vec3 product = n * inversesqrt(max(dot(n, n), 1e-20));
  float blend = mix(background.height, foreground.height, share);
  float blend2 = mix(background.roughness, foreground.roughness, share);
  float blend3 = mix(background.metallic, foreground.metallic, share);
  hallway_Material seen = hallway_Material(vector, product, blend, blend2, blend3);
  return seen;
}

// brick_grid (tiles/brick_grid.glsl)
void hallway_brick_grid_crack_tiles(vec2 uv, ivec2 neighbour, vec2 uv_dx, vec2 uv_dy,
    out hallway_Tile tile, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 2.0;
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = hallway_hash(uint(row) + 1237737413u);
  p = vec2(p.x + 0.37 * float(row & 1), p.y);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  uint hash_value = hallway_hash(uint(column) + row_bits);
  tile = hallway_Tile(p - corner, vec2(0.5), hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * 2.0;
  tile_local_dy = uv_dy * 2.0;
}

// turned, of layer_element (layers/layer_element.glsl)
vec2 hallway_turned(vec2 p, uint bits, vec2 p_dx, vec2 p_dy, out vec2 result_dx,
    out vec2 result_dy) {
  bool test = (bits & 2u) != 0u;
  vec2 p2 = test ? -p : p;
  vec2 p_dx2 = test ? -p_dx : p_dx;
  vec2 p_dy2 = test ? -p_dy : p_dy;
  bool test2 = (bits & 8u) != 0u;
  p2 = vec2(p2.x, test2 ? -p2.y : p2.y);
  result_dx = vec2(p_dx2.x, test2 ? -p_dx2.y : p_dx2.y);
  result_dy = vec2(p_dy2.x, test2 ? -p_dy2.y : p_dy2.y);
  return p2;
}

// turned, of layer_element (layers/layer_element.glsl)
vec2 hallway_turned2(vec2 p, uint bits) {
  vec2 p2 = (bits & 2u) != 0u ? -p : p;
  p2 = vec2(p2.x, (bits & 8u) != 0u ? -p2.y : p2.y);
  return p2;
}

// layer_element (layers/layer_element.glsl)
void hallway_layer_element_cracks(hallway_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out float alpha, out hallway_Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hallway_hash(tile.seed + 1u);
  uint hash_value = hallway_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-75.0, 75.0, pose.y) * 0.017453292;
  uint bits = hallway_hash(seed - 4u);
  float ratio = mix(0.4, 0.6, float(bits & 65535u) * 1.5258789e-5);
  float size = mix(0.7, 1.8, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hallway_hash(seed - 1u);
  vec2 center = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 into = shrink * vec2(1.0, 1.0 / ratio);
  vec2 point = vec2(cos(angle));
  vec2 product = point * into;
  vec2 point2 = vec2(sin(angle));
  vec2 product2 = point2 * into * across;
  vec2 q = product * p + (product2 * p.yx + 0.5);
  vec2 q_dx = tile_local_dx * product + tile_local_dx.yx * product2;
  vec2 q_dy = tile_local_dy * product + tile_local_dy.yx * product2;
  vec2 right = point * tile.right + point2 * tile.up;
  vec2 up = point * tile.up - point2 * tile.right;
  uint bits2 = bits >> 16u;
  vec2 inner_local_dx2, inner_local_dy2;
  vec2 turned_value = hallway_turned(q - 0.5, bits2, q_dx, q_dy, inner_local_dx2, inner_local_dy2);
  vec2 product3 = size * vec2(1.0, ratio) * tile.size;
  vec2 to_x = hallway_turned2(vec2(right.x, up.x), bits2);
  vec2 to_y = hallway_turned2(vec2(right.y, up.y), bits2);
  uint hash_value3 = hallway_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = mix(0.6, 1.0, luck.x) * hallway_box_share_holes(q, into, q_dx, q_dy);
  alpha = luck.y >= 0.62 ? 0.0 : alpha2;
  inner = hallway_Tile(turned_value + 0.5, product3, seed, vec2(to_x.x, to_y.x),
      vec2(to_x.y, to_y.y));
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// draw_cracks, of material_layer (materials/material_layer.glsl)
hallway_Material hallway_draw_cracks(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  hallway_Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  hallway_brick_grid_crack_tiles(uv, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  hallway_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  hallway_layer_element_cracks(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  hallway_Material seen = hallway_Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0, 0.0);
  if (alpha > 0.0) {
    vec4 texel = textureGrad(crack, inner.local, inner_local_dx, inner_local_dy);
    vec3 normal_map_slope_value = hallway_normal_map_slope2(texel.xyz);
    vec3 vector = vec3(normal_map_slope_value.x * inner.right + normal_map_slope_value.y * inner.up,
        normal_map_slope_value.z);
    seen = hallway_Material(vec4(0.035, 0.03, 0.025, texel.w * alpha), vector, -0.1, 0.9, 0.0);
  }
  return seen;
}

// material_layer (materials/material_layer.glsl)
hallway_Material hallway_material_layer_cracks(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  hallway_Material total = hallway_Material(vec4(0.0), vec3(0.0), 0.0, 0.0, 0.0);
  for (int y = 2; y > -3; --y) {
    for (int x = 2; x > -3 && total.color.w < 0.999; --x) {
      hallway_Material other = hallway_draw_cracks(uv, ivec2(x, y), uv_dx, uv_dy);
      float product = other.color.w * (1.0 - total.color.w * on);
      vec4 sum = total.color + vec4(other.color.xyz * product, product);
      vec3 sum2 = total.normal + product * other.normal;
      float sum3 = total.roughness + product * other.roughness;
      float sum4 = total.metallic + product * other.metallic;
      total = hallway_Material(sum, sum2, total.height + product * other.height, sum3, sum4);
    }
  }
  hallway_Material surface = hallway_mean(total);
  vec4 vector = vec4(surface.color.xyz, min(surface.color.w, 1.0));
  surface = hallway_Material(vector, surface.normal, surface.height, surface.roughness,
      surface.metallic);
  return surface;
}

// combine_normals (materials/combine_normals.glsl)
vec3 hallway_combine_normals_cracked(vec3 base, vec3 detail, float strength) {
  vec2 ratio = strength * detail.xy / max(detail.z, 0.01);
  vec3 n = vec3(base.xy / max(base.z, 0.01) + ratio, 1.0);
  return n * inversesqrt(dot(n, n));
}

// material_over (materials/material_over.glsl)
hallway_Material hallway_material_over_cracked(hallway_Material foreground,
    hallway_Material background) {
  float alpha = mix(background.color.w, 1.0, foreground.color.w);
  float share = foreground.color.w / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 combine_normals_cracked_value = hallway_combine_normals_cracked(background.normal,
      foreground.normal, share);
  float sum = background.height + share * foreground.height;
  float blend = mix(background.roughness, foreground.roughness, share);
  float blend2 = mix(background.metallic, foreground.metallic, share);
  hallway_Material seen = hallway_Material(vector, combine_normals_cracked_value, sum, blend,
      blend2);
  return seen;
}

// smooth_step (math/smooth_step.glsl)
float hallway_smooth_step_board_bend(float value) {
  float t = clamp((value - 0.065) / 0.025000006, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// brick_grid (tiles/brick_grid.glsl)
hallway_Tile hallway_brick_grid_window_tiles(vec2 uv) {
  int row = int(floor(uv.y));
  uint row_bits = hallway_hash(uint(row) + 4210537740u);
  vec2 corner = floor(uv);
  int column = int(corner.x);
  uint hash_value = hallway_hash(uint(column) + row_bits);
  hallway_Tile tile = hallway_Tile(uv - corner, vec2(1.0), hash_value, vec2(1.0, 0.0),
      vec2(0.0, 1.0));
  return tile;
}

// layer_element (layers/layer_element.glsl)
void hallway_layer_element_windows(hallway_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out float alpha, out hallway_Tile inner, out float present, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  uint seed = hallway_hash(tile.seed + 2u);
  uint hash_value = hallway_hash(seed - 1u);
  vec2 product = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.46, 0.615), vec2(0.54, 0.625), product);
  vec2 p = tile.local - center;
  vec2 q = vec2(2.9411764, 2.3529413) * p + 0.5;
  vec2 q_dx = tile_local_dx * vec2(2.9411764, 2.3529413);
  vec2 q_dy = tile_local_dy * vec2(2.9411764, 2.3529413);
  uint hash_value2 = hallway_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  float alpha2 = hallway_box_share_brick_layer(q, vec2(2.9411764, 2.3529413), tile.local, q_dx,
      q_dy, tile_local_dx, tile_local_dy);
  bool test = luck.y >= 0.6;
  alpha2 = test ? 0.0 : alpha2;
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 0.086700015, far);
  inner = hallway_Tile(q, vec2(0.34, 0.425) * tile.size, seed, tile.right, tile.up);
  present = test ? 0.0 : 1.0;
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// smooth_step (math/smooth_step.glsl)
float hallway_smooth_step_wood(float value) {
  float t = clamp((value - 0.15) * 4.0, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// window_surface (function of the graph)
hallway_Material hallway_window_surface(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  // picture: image (images/image.glsl)
  vec4 picture = textureGrad(window_color, uv, uv_dx, uv_dy);
  // texel: image (images/image.glsl)
  vec4 texel = textureGrad(window_relief, uv, uv_dx, uv_dy);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = hallway_normal_map_slope2(texel.xyz);
  // wood: smooth_step (math/smooth_step.glsl)
  float wood = hallway_smooth_step_wood(texel.w);
  // roughness: lerp (math/lerp.glsl)
  float roughness = mix(0.06, 0.5, wood);
  // surface: material (materials/material.glsl)
  hallway_Material surface = hallway_Material(picture, slope, texel.w, roughness, 0.0);
  return surface;
}

// draw_windows, of material_layer (materials/material_layer.glsl)
hallway_Material hallway_draw_windows(hallway_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out vec2 inner_local_dx, out vec2 inner_local_dy) {
  float alpha, present;
  hallway_Tile inner;
  vec2 inner_local_dx2, inner_local_dy2;
  hallway_layer_element_windows(tile, tile_local_dx, tile_local_dy, alpha, inner, present,
      inner_local_dx2, inner_local_dy2);
  hallway_Material seen = hallway_window_surface(inner.local, inner_local_dx2, inner_local_dy2);
  vec4 vector = vec4(seen.color.xyz, seen.color.w * alpha);
  vec3 vector2 = vec3(seen.normal.x * inner.right + seen.normal.y * inner.up, seen.normal.z);
  seen = hallway_Material(vector, vector2, seen.height, seen.roughness, 0.0);
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
  return seen;
}

// brick_grid (tiles/brick_grid.glsl)
hallway_Tile hallway_brick_grid_window_tiles2(vec2 uv, int seed, ivec2 neighbour) {
  int row = int(floor(uv.y)) + neighbour.y;
  uint row_bits = hallway_hash(uint(row) + hallway_hash(uint(seed)));
  vec2 corner = floor(uv) + vec2(neighbour);
  int column = int(corner.x);
  uint hash_value = hallway_hash(uint(column) + row_bits);
  hallway_Tile tile = hallway_Tile(uv - corner, vec2(1.0), hash_value, vec2(1.0, 0.0),
      vec2(0.0, 1.0));
  return tile;
}

// draw_windows, of material_layer (materials/material_layer.glsl)
void hallway_draw_windows(vec2 between, ivec2 home, vec2 between_dx, vec2 between_dy,
    out hallway_Tile inner, out float present, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  float alpha, present2;
  hallway_Tile inner2;
  vec2 inner_local_dx2, inner_local_dy2;
  hallway_layer_element_windows(hallway_brick_grid_window_tiles2(between, 31, home), between_dx,
      between_dy, alpha, inner2, present2, inner_local_dx2, inner_local_dy2);
  inner = inner2;
  present = present2;
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// layer_element (layers/layer_element.glsl)
void hallway_layer_element_runs(hallway_Tile tile, float chance, vec2 tile_local_dx,
    vec2 tile_local_dy, out float alpha, out hallway_Tile inner, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  uint seed = hallway_hash(tile.seed);
  uint hash_value = hallway_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  uint bits = hallway_hash(seed - 4u);
  float ratio = mix(0.6, 0.7, float(bits & 65535u) * 1.5258789e-5);
  float size = mix(0.8, 1.05, pose.x);
  uint hash_value2 = hallway_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.35, -0.28), vec2(0.65, -0.2), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 into = shrink * vec2(1.0, 1.0 / ratio);
  vec2 q = into * p + 0.5;
  vec2 difference = q - 0.5;
  bool test = ((bits >> 16u) & 4u) != 0u;
  vec2 q_dx = tile_local_dx * into;
  vec2 q_dy = tile_local_dy * into;
  vec2 sum = vec2(test ? -difference.x : difference.x, difference.y) + 0.5;
  vec2 point = vec2(test ? -tile.right.x : tile.right.x, test ? -tile.right.y : tile.right.y);
  uint hash_value3 = hallway_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = mix(0.5, 1.0, luck.x) * hallway_box_share_holes(q, into, q_dx, q_dy);
  alpha = chance < 1.0 && chance <= luck.y ? 0.0 : alpha2;
  inner = hallway_Tile(sum, size * vec2(1.0, ratio) * tile.size, seed, point, tile.up);
  inner_local_dx = vec2(test ? -q_dx.x : q_dx.x, q_dx.y);
  inner_local_dy = vec2(test ? -q_dy.x : q_dy.x, q_dy.y);
}

// draw_runs, of layer (layers/layer.glsl)
vec4 hallway_draw_runs(vec2 between, ivec2 which, vec2 between_dx, vec2 between_dy) {
  hallway_Tile inner2;
  float present;
  vec2 inner_local_dx2, inner_local_dy2;
  hallway_draw_windows(between, which, between_dx, between_dy, inner2, present, inner_local_dx2,
      inner_local_dy2);
  float alpha;
  hallway_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  hallway_layer_element_runs(inner2, present, inner_local_dx2, inner_local_dy2, alpha, inner,
      inner_local_dx, inner_local_dy);
  vec4 color = vec4(0.0);
  if (alpha > 0.0) {
    color = textureGrad(soot, inner.local, inner_local_dx, inner_local_dy);
    color = vec4(color.xyz, color.w * alpha);
  }
  return color;
}

// layer (layers/layer.glsl)
vec4 hallway_layer(vec2 between, vec2 between_dx, vec2 between_dy, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  vec4 color = vec4(0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && color.w < 0.999; --x) {
      vec4 other = hallway_draw_runs(between, ivec2(x, y), between_dx, between_dy);
      float below = other.w * (1.0 - color.w * on);
      color += vec4(other.xyz * below, below);
    }
  }
  color = vec4(color.xyz / max(color.w, 1e-20), min(color.w, 1.0));
  return color;
}

// layer_element (layers/layer_element.glsl)
void hallway_layer_element_doors(hallway_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out float alpha, out hallway_Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hallway_hash(tile.seed + 3u);
  uint bits = hallway_hash(seed - 4u);
  uint hash_value = hallway_hash(seed - 1u);
  vec2 product = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.43, 0.365), vec2(0.57, 0.365), product);
  vec2 p = tile.local - center;
  vec2 q = vec2(2.7027028, 1.3513514) * p + 0.5;
  vec2 difference = q - 0.5;
  bool test = ((bits >> 16u) & 4u) != 0u;
  vec2 q_dx = tile_local_dx * vec2(2.7027028, 1.3513514);
  vec2 q_dy = tile_local_dy * vec2(2.7027028, 1.3513514);
  vec2 sum = vec2(test ? -difference.x : difference.x, difference.y) + 0.5;
  vec2 point = vec2(test ? -tile.right.x : tile.right.x, test ? -tile.right.y : tile.right.y);
  uint hash_value2 = hallway_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  float alpha2 = hallway_box_share_holes(q, vec2(2.7027028, 1.3513514), q_dx, q_dy);
  alpha = luck.y >= 0.62 ? 0.0 : alpha2;
  inner = hallway_Tile(sum, vec2(0.37, 0.74) * tile.size, seed, point, tile.up);
  inner_local_dx = vec2(test ? -q_dx.x : q_dx.x, q_dx.y);
  inner_local_dy = vec2(test ? -q_dy.x : q_dy.x, q_dy.y);
}

// smooth_step (math/smooth_step.glsl)
float hallway_smooth_step_brass(float value) {
  float t = clamp((value - 0.52) / 0.08000004, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// threshold (math/threshold.glsl)
float hallway_threshold(float value, float edge) {
  return clamp((value - edge) / 1e-7 + 0.5, 0.0, 1.0);
}

// color_ramp (color/color_ramp.glsl)
vec4 hallway_color_ramp(float position) {
  vec4 vector = vec4(hallway_threshold(position, 0.4));
  vec4 color = mix(vec4(0.42, 0.2, 0.1, 1.0), vec4(0.8, 0.72, 0.55, 1.0), vector);
  color = mix(color, vec4(0.25, 0.42, 0.42, 1.0), hallway_threshold(position, 0.7));
  return mix(color, vec4(0.62, 0.16, 0.11, 1.0), hallway_threshold(position, 0.9));
}

// door_surface (function of the graph)
hallway_Material hallway_door_surface(vec2 uv, hallway_Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // picture: image (images/image.glsl)
  vec4 picture = textureGrad(door_color, uv, uv_dx, uv_dy);
  // texel: image (images/image.glsl)
  vec4 texel = textureGrad(door_relief, uv, uv_dx, uv_dy);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = hallway_normal_map_slope2(texel.xyz);
  // brass: smooth_step (math/smooth_step.glsl)
  float brass = hallway_smooth_step_brass(texel.w);
  // shade: tile_random (tiles/tile_random.glsl)
  float shade = float(hallway_hash(tile.seed + 6u) >> 8u) * 5.9604645e-8;
  // paint: color_ramp (color/color_ramp.glsl)
  vec4 paint = hallway_color_ramp(shade);
  // tint: lerp (math/lerp.glsl)
  vec4 tint = mix(paint, vec4(1.0), brass);
  // color: multiply (math/multiply.glsl)
  vec4 color = picture * tint;
  // roughness: lerp (math/lerp.glsl)
  float roughness = mix(0.42, 0.22, brass);
  // surface: material (materials/material.glsl)
  hallway_Material surface = hallway_Material(color, slope, texel.w, roughness, brass);
  return surface;
}

// draw_doors, of material_layer (materials/material_layer.glsl)
hallway_Material hallway_draw_doors(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  float alpha;
  hallway_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  hallway_layer_element_doors(hallway_brick_grid_window_tiles2(uv, 45, which), uv_dx, uv_dy, alpha,
      inner, inner_local_dx, inner_local_dy);
  hallway_Material seen = hallway_Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0, 0.0);
  if (alpha > 0.0) {
    seen = hallway_door_surface(inner.local, inner, inner_local_dx, inner_local_dy);
    vec4 vector = vec4(seen.color.xyz, seen.color.w * alpha);
    vec3 vector2 = vec3(seen.normal.x * inner.right + seen.normal.y * inner.up, seen.normal.z);
    seen = hallway_Material(vector, vector2, seen.height, seen.roughness, seen.metallic);
  }
  return seen;
}

// material_layer (materials/material_layer.glsl)
hallway_Material hallway_material_layer_doors(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 tiles = sqrt(uv_dx * uv_dx + uv_dy * uv_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  hallway_Material total = hallway_Material(vec4(0.0), vec3(0.0), 0.0, 0.0, 0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && total.color.w < 0.999; --x) {
      hallway_Material other = hallway_draw_doors(uv, ivec2(x, y), uv_dx, uv_dy);
      float product = other.color.w * (1.0 - total.color.w * on);
      vec4 sum = total.color + vec4(other.color.xyz * product, product);
      vec3 sum2 = total.normal + product * other.normal;
      float sum3 = total.roughness + product * other.roughness;
      float sum4 = total.metallic + product * other.metallic;
      total = hallway_Material(sum, sum2, total.height + product * other.height, sum3, sum4);
    }
  }
  hallway_Material surface = hallway_mean(total);
  vec4 vector = vec4(surface.color.xyz, min(surface.color.w, 1.0));
  surface = hallway_Material(vector, surface.normal, surface.height, surface.roughness,
      surface.metallic);
  return surface;
}

void hallway(vec2 uv, out vec4 color, out vec3 normal, out float roughness, out float metallic,
    out float height) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // brick_tiles: brick_grid (tiles/brick_grid.glsl)
  hallway_Tile brick_tiles;
  vec2 brick_tiles_local_dx, brick_tiles_local_dy;
  hallway_brick_grid_brick_tiles(uv, 18, 9, 0.5, 1, uv_dx, uv_dy, brick_tiles, brick_tiles_local_dx,
      brick_tiles_local_dy);
  // brick_layer: material_layer (materials/material_layer.glsl)
  hallway_Material brick_layer_surface = hallway_draw_brick_layer(brick_tiles, brick_tiles_local_dx,
      brick_tiles_local_dy);
  // mortar_color: tiled_image (images/tiled_image.glsl)
  vec4 mortar_color = texture(mortar, uv * 4.0);
  // mortar_surface: material (materials/material.glsl)
  hallway_Material mortar_surface = hallway_Material(mortar_color, vec3(0.0, 0.0, 1.0), -0.16, 0.95,
      0.0);
  // bricks: material_over (materials/material_over.glsl)
  hallway_Material bricks = hallway_material_over_bricks(brick_layer_surface, mortar_surface);
  // level: fraction (math/fraction.glsl)
  float level = fract(uv.y);
  // upright: combine2 (channels/combine2.glsl)
  vec2 upright = vec2(0.5, level);
  vec2 upright_dx = vec2(0.0, uv_dx.y);
  vec2 upright_dy = vec2(0.0, uv_dy.y);
  // finish_color: tiled_image (images/tiled_image.glsl)
  vec4 finish_color = texture(plaster_color, uv * 1.4);
  // finish_texel: tiled_image (images/tiled_image.glsl)
  vec4 finish_texel = texture(plaster_relief, uv * 1.9);
  // finish_slope: normal_map (materials/normal_map.glsl)
  vec3 finish_slope = hallway_normal_map_slope(finish_texel.xyz, 0.35);
  // dado: rectangle (patterns/rectangle.glsl)
  vec2 greatest = max(sqrt(upright_dx * upright_dx + upright_dy * upright_dy), 1e-7);
  vec2 sum = (vec2(2.0, 0.24) - abs(upright - vec2(0.5, 0.1))) / greatest + 0.5;
  vec2 clamped = clamp(min(sum, vec2(4.0, 0.48) / greatest), 0.0, 1.0);
  float clamped2 = clamp(2.0 * max(greatest.x, greatest.y) - 1.0, 0.0, 1.0);
  float dado = mix(clamped.x * clamped.y, 1.0, clamped2);
  // paint: lerp (math/lerp.glsl)
  vec3 paint = mix(wall_tint, dado_tint, dado);
  // painted: multiply (math/multiply.glsl)
  vec3 painted = finish_color.xyz * paint;
  // damp_coarse: value_noise (noise/value_noise.glsl)
  float damp_coarse = hallway_value_noise(uv, vec2(2.3, 1.7), 1, uv_dx, uv_dy);
  // damp_fine: value_noise (noise/value_noise.glsl)
  float damp_fine = hallway_value_noise(uv, vec2(9.0, 5.0), 2, uv_dx, uv_dy);
  // damp_edge: value_noise (noise/value_noise.glsl)
  float damp_edge = hallway_value_noise(uv, vec2(31.0, 23.0), 3, uv_dx, uv_dy);
  // damp_half: lerp (math/lerp.glsl)
  float damp_half = mix(damp_coarse, damp_fine, 0.35);
  // damp: lerp (math/lerp.glsl)
  float damp = mix(damp_half, damp_edge, 0.15);
  // smoke: smooth_step (math/smooth_step.glsl)
  float smoke = hallway_smooth_step_smoke(level);
  // dim: lerp (math/lerp.glsl)
  float dim = mix(damp, 1.0, smoke);
  // tone: remap (math/remap.glsl)
  float tone = mix(1.02, 0.5, (dim - 0.35) / 0.65);
  // aged: multiply (math/multiply.glsl)
  vec3 aged = painted * tone;
  // aged_rgba: rgba (channels/rgba.glsl)
  vec4 aged_rgba = vec4(aged, 1.0);
  // gloss: lerp (math/lerp.glsl)
  float gloss = mix(0.8, 0.5, dado);
  // hole_tiles: brick_grid (tiles/brick_grid.glsl)
  vec2 hole_tiles_local_dx = uv_dx * 2.0;
  vec2 hole_tiles_local_dy = uv_dy * 2.0;
  // holes: material_layer (materials/material_layer.glsl)
  hallway_Material holes_surface = hallway_material_layer_holes(uv, uv_dx, uv_dy,
      hole_tiles_local_dx, hole_tiles_local_dy);
  // no_finish: smooth_step (math/smooth_step.glsl)
  float no_finish = hallway_smooth_step_no_finish(holes_surface.color.w);
  // no_coat: smooth_step (math/smooth_step.glsl)
  float no_coat = hallway_smooth_step_no_coat(holes_surface.color.w);
  // coat_rgb: multiply (math/multiply.glsl)
  vec3 coat_rgb = finish_color.xyz * vec3(0.5, 0.43, 0.36);
  // coat_rgba: rgba (channels/rgba.glsl)
  vec4 coat_rgba = vec4(coat_rgb, 1.0);
  // coat_slope: combine_normals (materials/combine_normals.glsl)
  vec3 coat_slope = hallway_combine_normals_coat_slope(finish_slope, holes_surface.normal);
  // coat: material (materials/material.glsl)
  hallway_Material coat = hallway_Material(coat_rgba, coat_slope, -0.05, 0.88, 0.0);
  // finish: material (materials/material.glsl)
  hallway_Material finish = hallway_Material(aged_rgba, coat_slope, 0.0, gloss, 0.0);
  // keep_coat: invert (math/invert.glsl)
  float keep_coat = 1.0 - no_coat;
  // keep_finish: invert (math/invert.glsl)
  float keep_finish = 1.0 - no_finish;
  // coated: material_over (materials/material_over.glsl)
  hallway_Material coated = hallway_material_over_coated(coat, bricks, keep_coat);
  // plastered: material_over (materials/material_over.glsl)
  hallway_Material plastered = hallway_material_over_coated(finish, coated, keep_finish);
  // crack_tiles: brick_grid (tiles/brick_grid.glsl)
  hallway_Tile tile;
  vec2 crack_tiles_local_dx, crack_tiles_local_dy;
  hallway_brick_grid_brick_tiles(uv, 2, 2, 0.37, 12, uv_dx, uv_dy, tile, crack_tiles_local_dx,
      crack_tiles_local_dy);
  // cracks: material_layer (materials/material_layer.glsl)
  hallway_Material cracks_surface = hallway_material_layer_cracks(uv, uv_dx, uv_dy,
      crack_tiles_local_dx, crack_tiles_local_dy);
  // cracked: material_over (materials/material_over.glsl)
  hallway_Material cracked = hallway_material_over_cracked(cracks_surface, plastered);
  // rail: rectangle (patterns/rectangle.glsl)
  vec2 sum2 = (vec2(2.0, 0.015) - abs(upright - vec2(0.5, 0.35))) / greatest + 0.5;
  vec2 clamped3 = clamp(min(sum2, vec2(4.0, 0.03) / greatest), 0.0, 1.0);
  float rail = mix(clamped3.x * clamped3.y, 0.12, clamped2);
  // board: rectangle (patterns/rectangle.glsl)
  vec2 sum3 = (vec2(2.0, 0.05) - abs(upright - vec2(0.5, 0.04))) / greatest + 0.5;
  vec2 clamped4 = clamp(min(sum3, vec2(4.0, 0.1) / greatest), 0.0, 1.0);
  float board = mix(clamped4.x * clamped4.y, 0.4, clamped2);
  // rail_bend: remap (math/remap.glsl)
  float rail_bend = mix(-1.0, 1.0, (level - 0.335) / 0.030000001);
  // board_bend: smooth_step (math/smooth_step.glsl)
  float board_bend = hallway_smooth_step_board_bend(level);
  // bend: lerp (math/lerp.glsl)
  float bend = mix(rail_bend, board_bend, board);
  // bend_up: combine3 (channels/combine3.glsl)
  vec3 bend_up = vec3(0.0, bend, 1.0);
  // wood_slope: normalized (math/normalized.glsl)
  vec3 wood_slope = bend_up * inversesqrt(max(dot(bend_up, bend_up), 1e-30));
  // wood_mask: maximum (math/maximum.glsl)
  float wood_mask = max(rail, board);
  // streaks: value_noise (noise/value_noise.glsl)
  float streaks = hallway_value_noise(uv, vec2(6.0, 90.0), 7, uv_dx, uv_dy);
  // wood_tone: remap (math/remap.glsl)
  float wood_tone = mix(0.75, 1.1, streaks);
  // wood_rgb: multiply (math/multiply.glsl)
  vec3 wood_rgb = vec3(0.12, 0.052, 0.024) * wood_tone;
  // wood_rgba: rgba (channels/rgba.glsl)
  vec4 wood_rgba = vec4(wood_rgb, 1.0);
  // wood: material (materials/material.glsl)
  hallway_Material wood = hallway_Material(wood_rgba, wood_slope, 0.5, 0.35, 0.0);
  // between: add (math/add.glsl)
  vec2 between = uv + vec2(0.5, 0.0);
  // window_tiles: brick_grid (tiles/brick_grid.glsl)
  hallway_Tile window_tiles = hallway_brick_grid_window_tiles(between);
  // windows: material_layer (materials/material_layer.glsl)
  vec2 windows_inner_local_dx, windows_inner_local_dy;
  hallway_Material windows_surface = hallway_draw_windows(window_tiles, uv_dx, uv_dy,
      windows_inner_local_dx, windows_inner_local_dy);
  // runs: layer (layers/layer.glsl)
  vec4 runs_color = hallway_layer(between, uv_dx, uv_dy, windows_inner_local_dx,
      windows_inner_local_dy);
  // runs_surface: material (materials/material.glsl)
  hallway_Material runs_surface = hallway_Material(runs_color, vec3(0.0, 0.0, 1.0), 0.0, 0.95, 0.0);
  // stained: material_over (materials/material_over.glsl)
  hallway_Material stained = hallway_material_over_cracked(runs_surface, cracked);
  // boarded: material_over (materials/material_over.glsl)
  hallway_Material boarded = hallway_material_over_coated(wood, stained, wood_mask);
  // doors: material_layer (materials/material_layer.glsl)
  hallway_Material doors_surface = hallway_material_layer_doors(uv, uv_dx, uv_dy);
  // glazed: material_over (materials/material_over.glsl)
  hallway_Material glazed = hallway_material_over_bricks(windows_surface, boarded);
  // hall: material_over (materials/material_over.glsl)
  hallway_Material hall = hallway_material_over_bricks(doors_surface, glazed);
  color = hall.color;
  normal = hall.normal;
  roughness = hall.roughness;
  metallic = hall.metallic;
  height = hall.height;
}
