// roof_tiles: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec3 tint;  // default vec3(1.0)
uniform float moss_amount;  // default 0.9

// Textures
uniform sampler2D tile_color;
uniform sampler2D tile_relief;
uniform sampler2D moss;

// Types
struct roof_tiles_Tile {
  vec2 local;
  vec2 size;
  uint seed;
  vec2 right;
  vec2 up;
};
struct roof_tiles_Material {
  vec4 color;
  vec3 normal;
  float height;
  float roughness;
};

// hash (random/hash.glsl)
uint roof_tiles_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// mean, of material_layer (materials/material_layer.glsl)
roof_tiles_Material roof_tiles_mean(roof_tiles_Material total) {
  float share = 1.0 / max(total.color.w, 1e-20);
  vec3 n = total.normal + vec3(0.0, 0.0, 1e-9);
  vec4 vector = vec4(total.color.xyz * share, total.color.w);
  vec3 product = n * inversesqrt(max(dot(n, n), 1e-20));
  return roof_tiles_Material(vector, product, total.height * share, total.roughness * share);
}

// brick_grid (tiles/brick_grid.glsl)
void roof_tiles_brick_grid(vec2 uv, ivec2 neighbour, vec2 uv_dx, vec2 uv_dy,
    out roof_tiles_Tile tile, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 8.0;
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = roof_tiles_hash(uint(row) + 2131687100u);
  p = vec2(p.x + 0.5 * float(row & 1), p.y);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  uint hash_value = roof_tiles_hash(uint(column) + row_bits);
  tile = roof_tiles_Tile(p - corner, vec2(0.125), hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * 8.0;
  tile_local_dy = uv_dy * 8.0;
}

// box_share (layers/box_share.glsl)
float roof_tiles_box_share(vec2 q, vec2 cell_in_q, vec2 q_dx, vec2 q_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 covered = clamp(share, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void roof_tiles_layer_element_tiles(roof_tiles_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out float alpha, out roof_tiles_Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = roof_tiles_hash(tile.seed);
  uint hash_value = roof_tiles_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-1.3, 1.3, pose.y) * 0.017453292;
  uint bits = roof_tiles_hash(seed - 4u);
  float size = mix(1.0, 1.03, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = roof_tiles_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.485, 0.47), vec2(0.515, 0.53), product);
  vec2 p = tile.local - center;
  float shrink = 1.0 / size;
  vec2 into = shrink * vec2(1.0, 0.5);
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
  uint hash_value3 = roof_tiles_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = roof_tiles_box_share(q, into, q_dx, q_dy);
  alpha = luck.y >= 0.985 ? 0.0 : alpha2;
  inner = roof_tiles_Tile(sum, size * vec2(1.0, 2.0) * tile.size, seed, point3, up);
  inner_local_dx = vec2(test ? -q_dx.x : q_dx.x, q_dx.y);
  inner_local_dy = vec2(test ? -q_dy.x : q_dy.x, q_dy.y);
}

// normal_map (materials/normal_map.glsl)
vec3 roof_tiles_normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  vec2 slope = 1.3 * n.xy;
  vec3 steep = vec3(slope, n.z);
  return steep * inversesqrt(max(dot(steep, steep), 1e-20));
}

// color_ramp (color/color_ramp.glsl)
vec4 roof_tiles_color_ramp(float position) {
  vec4 vector = vec4(clamp(position / 0.22, 0.0, 1.0));
  vec4 color = mix(vec4(0.42, 0.4, 0.42, 1.0), vec4(0.8, 0.66, 0.58, 1.0), vector);
  color = mix(color, vec4(1.0, 0.95, 0.9, 1.0), clamp((position - 0.22) / 0.48, 0.0, 1.0));
  return mix(color, vec4(1.25, 1.22, 1.0, 1.0), clamp((position - 0.7) / 0.3, 0.0, 1.0));
}

// hash (random/hash.glsl)
uvec2 roof_tiles_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 roof_tiles_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float roof_tiles_value_noise(vec2 uv, vec2 scale, int seed, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * scale;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = roof_tiles_hash(uvec2(cell.y, cell.y + 1u) + roof_tiles_hash(uint(seed)));
  uvec4 bits = roof_tiles_hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// smooth_step (math/smooth_step.glsl)
float roof_tiles_smooth_step(float value, float low, float high) {
  float span = high - low;
  float t = clamp((value - low) / (abs(span) < 1e-7 ? 1e-7 : span), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// roof_tile (function of the graph)
roof_tiles_Material roof_tiles_roof_tile(vec2 uv, roof_tiles_Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // picture: image (images/image.glsl)
  vec4 picture = textureGrad(tile_color, uv, uv_dx, uv_dy);
  // texel: image (images/image.glsl)
  vec4 texel = textureGrad(tile_relief, uv, uv_dx, uv_dy);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = roof_tiles_normal_map(texel.xyz);
  // firing: tile_random (tiles/tile_random.glsl)
  float firing = float(roof_tiles_hash(tile.seed + 11u) >> 8u) * 5.9604645e-8;
  // clay: color_ramp (color/color_ramp.glsl)
  vec4 clay = roof_tiles_color_ramp(firing);
  // light: tile_random (tiles/tile_random.glsl)
  float light = mix(0.75, 1.1, float(roof_tiles_hash(tile.seed + 12u) >> 8u) * 5.9604645e-8);
  // shade: multiply (math/multiply.glsl)
  vec3 shade = clay.xyz * light;
  // fired: multiply (math/multiply.glsl)
  vec3 fired = picture.xyz * shade;
  // away: tile_random (tiles/tile_random.glsl)
  float away = 90.0 * (float(roof_tiles_hash(tile.seed + 13u) >> 8u) * 5.9604645e-8);
  // place: add (math/add.glsl)
  vec2 place = uv + away;
  // blots: value_noise (noise/value_noise.glsl)
  float blots = roof_tiles_value_noise(place, vec2(4.0, 7.0), 1, uv_dx, uv_dy);
  // specks: value_noise (noise/value_noise.glsl)
  float specks = roof_tiles_value_noise(place, vec2(19.0, 37.0), 2, uv_dx, uv_dy);
  // crumbs: value_noise (noise/value_noise.glsl)
  float crumbs = roof_tiles_value_noise(place, vec2(53.0, 101.0), 4, uv_dx, uv_dy);
  // rim: lerp (math/lerp.glsl)
  float rim = mix(specks, crumbs, 0.4);
  // growth: lerp (math/lerp.glsl)
  float growth = mix(blots, rim, 0.45);
  // age: tile_random (tiles/tile_random.glsl)
  float age = mix(0.45, 0.8, float(roof_tiles_hash(tile.seed + 14u) >> 8u) * 5.9604645e-8);
  // old: add (math/add.glsl)
  float old = age + 0.25;
  // grown: smooth_step (math/smooth_step.glsl)
  float grown = roof_tiles_smooth_step(growth, age, old);
  // tone: luminance (channels/luminance.glsl)
  float tone = dot(picture.xyz, vec3(0.2126, 0.7152, 0.0722));
  // lichen: multiply (math/multiply.glsl)
  vec3 lichen = vec3(1.0, 0.86, 0.46) * tone;
  // weathered: lerp (math/lerp.glsl)
  vec3 weathered = mix(fired, lichen, grown);
  // smoothness: tile_random (tiles/tile_random.glsl)
  float smoothness = mix(0.6, 0.85, float(roof_tiles_hash(tile.seed + 15u) >> 8u) * 5.9604645e-8);
  // roughness: lerp (math/lerp.glsl)
  float roughness = mix(smoothness, 0.97, grown);
  // surface: material (materials/material.glsl)
  roof_tiles_Material surface = roof_tiles_Material(vec4(weathered, picture.w), slope, texel.w,
      roughness);
  return surface;
}

// draw_tiles, of material_layer (materials/material_layer.glsl)
roof_tiles_Material roof_tiles_draw_tiles(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  roof_tiles_Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  roof_tiles_brick_grid(uv, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  roof_tiles_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  roof_tiles_layer_element_tiles(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  roof_tiles_Material seen = roof_tiles_Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0);
  if (alpha > 0.0) {
    seen = roof_tiles_roof_tile(inner.local, inner, inner_local_dx, inner_local_dy);
    vec4 vector = vec4(seen.color.xyz * tint, seen.color.w * alpha);
    vec3 vector2 = vec3(seen.normal.x * inner.right + seen.normal.y * inner.up, seen.normal.z);
    seen = roof_tiles_Material(vector, vector2, seen.height, seen.roughness);
  }
  return seen;
}

// material_layer (materials/material_layer.glsl)
roof_tiles_Material roof_tiles_material_layer_tiles(vec2 uv, vec2 uv_dx, vec2 uv_dy,
    vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  roof_tiles_Material total = roof_tiles_Material(vec4(0.0), vec3(0.0), 0.0, 0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && total.color.w < 0.999; --x) {
      roof_tiles_Material other = roof_tiles_draw_tiles(uv, ivec2(x, y), uv_dx, uv_dy);
      float product = other.color.w * (1.0 - total.color.w * on);
      vec4 sum = total.color + vec4(other.color.xyz * product, product);
      vec3 sum2 = total.normal + product * other.normal;
      float sum3 = total.roughness + product * other.roughness;
      total = roof_tiles_Material(sum, sum2, total.height + product * other.height, sum3);
    }
  }
  roof_tiles_Material surface = roof_tiles_mean(total);
  vec4 vector = vec4(surface.color.xyz, min(surface.color.w, 1.0));
  surface = roof_tiles_Material(vector, surface.normal, surface.height, surface.roughness);
  return surface;
}

// material_over (materials/material_over.glsl)
roof_tiles_Material roof_tiles_material_over_roof(roof_tiles_Material foreground) {
  vec3 blend = mix(vec3(0.012, 0.009, 0.007), foreground.color.xyz, foreground.color.w);
  vec3 n = mix(vec3(0.0, 0.0, 1.0), foreground.normal, foreground.color.w);
  vec3 product = n * inversesqrt(max(dot(n, n), 1e-20));
  float blend2 = mix(0.95, foreground.roughness, foreground.color.w);
  roof_tiles_Material seen = roof_tiles_Material(vec4(blend, 1.0), product,
      foreground.height * foreground.color.w, blend2);
  return seen;
}

// brick_grid (tiles/brick_grid.glsl)
void roof_tiles_brick_grid_moss_grid(vec2 uv, ivec2 neighbour, vec2 uv_dx, vec2 uv_dy,
    out roof_tiles_Tile tile, out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 5.0;
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = roof_tiles_hash(uint(row) + 460041413u);
  float sum = 0.37 * float(row & 1) + float(roof_tiles_hash(row_bits - 1u) >> 8u) * 5.9604645e-8;
  p = vec2(p.x + sum, p.y);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  uint hash_value = roof_tiles_hash(uint(column) + row_bits);
  tile = roof_tiles_Tile(p - corner, vec2(0.2), hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * 5.0;
  tile_local_dy = uv_dy * 5.0;
}

// layer_element (layers/layer_element.glsl)
void roof_tiles_layer_element_moss_layer(roof_tiles_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy, out float alpha, out roof_tiles_Tile inner, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  uint seed = roof_tiles_hash(tile.seed);
  uint hash_value = roof_tiles_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-35.0, 35.0, pose.y) * 0.017453292;
  uint bits = roof_tiles_hash(seed - 4u);
  float ratio = mix(0.5, 0.9, float(bits & 65535u) * 1.5258789e-5);
  float size = mix(0.35, 1.0, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = roof_tiles_hash(seed - 1u);
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
  uint hash_value3 = roof_tiles_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value3 & 65535u), float(hash_value3 >> 16u)) * 1.5258789e-5;
  float alpha2 = roof_tiles_box_share(q, into, q_dx, q_dy);
  alpha = luck.y >= 0.4 ? 0.0 : alpha2;
  inner = roof_tiles_Tile(q, size * vec2(1.0, ratio) * tile.size, seed, right, up);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// draw_moss_layer, of material_layer (materials/material_layer.glsl)
roof_tiles_Material roof_tiles_draw_moss_layer(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  roof_tiles_Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  roof_tiles_brick_grid_moss_grid(uv, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  roof_tiles_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  roof_tiles_layer_element_moss_layer(tile, tile_local_dx, tile_local_dy, alpha, inner,
      inner_local_dx, inner_local_dy);
  roof_tiles_Material seen = roof_tiles_Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0);
  if (alpha > 0.0) {
    vec4 texel = textureGrad(moss, inner.local, inner_local_dx, inner_local_dy);
    seen = roof_tiles_Material(vec4(texel.xyz, texel.w * alpha), vec3(0.0, 0.0, 1.0), 0.15, 1.0);
  }
  return seen;
}

// material_layer (materials/material_layer.glsl)
roof_tiles_Material roof_tiles_material_layer_moss_layer(vec2 uv, vec2 uv_dx, vec2 uv_dy,
    vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  roof_tiles_Material total = roof_tiles_Material(vec4(0.0), vec3(0.0), 0.0, 0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && total.color.w < 0.999; --x) {
      roof_tiles_Material other = roof_tiles_draw_moss_layer(uv, ivec2(x, y), uv_dx, uv_dy);
      float product = other.color.w * (1.0 - total.color.w * on);
      vec4 sum = total.color + vec4(other.color.xyz * product, product);
      vec3 sum2 = total.normal + product * other.normal;
      float sum3 = total.roughness + product * other.roughness;
      total = roof_tiles_Material(sum, sum2, total.height + product * other.height, sum3);
    }
  }
  roof_tiles_Material surface = roof_tiles_mean(total);
  vec4 vector = vec4(surface.color.xyz, min(surface.color.w, 1.0));
  surface = roof_tiles_Material(vector, surface.normal, surface.height, surface.roughness);
  return surface;
}

// combine_normals (materials/combine_normals.glsl)
vec3 roof_tiles_combine_normals(vec3 base, vec3 detail, float strength) {
  vec2 ratio = strength * detail.xy / max(detail.z, 0.01);
  vec3 n = vec3(base.xy / max(base.z, 0.01) + ratio, 1.0);
  return n * inversesqrt(dot(n, n));
}

// material_over (materials/material_over.glsl)
roof_tiles_Material roof_tiles_material_over_overgrown(roof_tiles_Material foreground,
    roof_tiles_Material background, float opacity) {
  float front = foreground.color.w * opacity;
  float alpha = mix(background.color.w, 1.0, front);
  float share = front / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 combine_normals_value = roof_tiles_combine_normals(background.normal, foreground.normal,
      share);
  float blend = mix(background.roughness, foreground.roughness, share);
  roof_tiles_Material seen = roof_tiles_Material(vector, combine_normals_value,
      background.height + share * foreground.height, blend);
  return seen;
}

void roof_tiles(vec2 uv, out vec4 color, out vec3 normal, out float roughness, out float height) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  vec2 grid_local_dx = uv_dx * 8.0;
  vec2 grid_local_dy = uv_dy * 8.0;
  // tiles: material_layer (materials/material_layer.glsl)
  roof_tiles_Material tiles_surface = roof_tiles_material_layer_tiles(uv, uv_dx, uv_dy,
      grid_local_dx, grid_local_dy);
  // roof: material_over (materials/material_over.glsl)
  roof_tiles_Material roof = roof_tiles_material_over_roof(tiles_surface);
  // moss_grid: brick_grid (tiles/brick_grid.glsl)
  vec2 moss_grid_local_dx = uv_dx * 5.0;
  vec2 moss_grid_local_dy = uv_dy * 5.0;
  // moss_layer: material_layer (materials/material_layer.glsl)
  roof_tiles_Material moss_layer_surface = roof_tiles_material_layer_moss_layer(uv, uv_dx, uv_dy,
      moss_grid_local_dx, moss_grid_local_dy);
  // overgrown: material_over (materials/material_over.glsl)
  roof_tiles_Material overgrown = roof_tiles_material_over_overgrown(moss_layer_surface, roof,
      moss_amount);
  color = overgrown.color;
  normal = overgrown.normal;
  roughness = overgrown.roughness;
  height = overgrown.height;
}
