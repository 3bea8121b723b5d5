// tiled_floor: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float wear_amount;  // default 1.0
uniform vec3 grout;  // default vec3(0.55, 0.5, 0.44)

// Textures
uniform sampler2D glaze;
uniform sampler2D glaze_relief;
uniform sampler2D wear_mask;
uniform sampler2D grit;

// Types
struct tiled_floor_Tile {
  vec2 local;
  vec2 size;
  uint seed;
  vec2 right;
  vec2 up;
};
struct tiled_floor_Material {
  vec4 color;
  vec3 normal;
  float height;
  float roughness;
  float metallic;
};

// hash (random/hash.glsl)
uint tiled_floor_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// brick_grid (tiles/brick_grid.glsl)
void tiled_floor_brick_grid(vec2 uv, vec2 uv_dx, vec2 uv_dy, out tiled_floor_Tile tile,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 6.0;
  int row = int(floor(p.y));
  uint row_bits = tiled_floor_hash(uint(row) + 678955108u);
  vec2 corner = floor(p);
  int column = int(corner.x);
  uint hash_value = tiled_floor_hash(uint(column) + row_bits);
  tile = tiled_floor_Tile(p - corner, vec2(0.16666667), hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * 6.0;
  tile_local_dy = uv_dy * 6.0;
}

// turned_tiles, of layer_element (layers/layer_element.glsl)
vec2 tiled_floor_turned_tiles(vec2 p, uint bits, vec2 p_dx, vec2 p_dy, out vec2 result_dx,
    out vec2 result_dy) {
  bool test = (bits & 1u) != 0u;
  vec2 p2 = test ? vec2(p.y, -p.x) : p;
  vec2 p_dx2 = test ? vec2(p_dx.y, -p_dx.x) : p_dx;
  vec2 p_dy2 = test ? vec2(p_dy.y, -p_dy.x) : p_dy;
  bool test2 = (bits & 2u) != 0u;
  p2 = test2 ? -p2 : p2;
  result_dx = test2 ? -p_dx2 : p_dx2;
  result_dy = test2 ? -p_dy2 : p_dy2;
  return p2;
}

// turned_tiles, of layer_element (layers/layer_element.glsl)
vec2 tiled_floor_turned_tiles2(vec2 p, uint bits) {
  vec2 p2 = (bits & 1u) != 0u ? vec2(p.y, -p.x) : p;
  p2 = (bits & 2u) != 0u ? -p2 : p2;
  return p2;
}

// box_share (layers/box_share.glsl)
float tiled_floor_box_share(vec2 q, vec2 cell_in_q, vec2 local, vec2 q_dx, vec2 q_dy, vec2 local_dx,
    vec2 local_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 cell_width = clamp(sqrt(local_dx * local_dx + local_dy * local_dy), 1e-5, 1.0);
  vec2 inside = clamp((0.5 - abs(local - 0.5)) / cell_width + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void tiled_floor_layer_element_tiles(tiled_floor_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out float alpha, out tiled_floor_Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = tiled_floor_hash(tile.seed);
  uint hash_value = tiled_floor_hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(-0.25, 0.25, pose.y) * 0.017453292;
  uint bits = tiled_floor_hash(seed - 4u);
  float size = mix(0.96, 0.985, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = tiled_floor_hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(vec2(0.496), vec2(0.504), product);
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
  uint bits2 = bits >> 16u;
  vec2 inner_local_dx2, inner_local_dy2;
  vec2 turned_tiles_value = tiled_floor_turned_tiles(q - 0.5, bits2, q_dx, q_dy, inner_local_dx2,
      inner_local_dy2);
  vec2 product3 = size * tile.size;
  vec2 choice = (bits2 & 1u) != 0u ? product3.yx : product3;
  vec2 to_x = tiled_floor_turned_tiles2(vec2(right.x, up.x), bits2);
  vec2 to_y = tiled_floor_turned_tiles2(vec2(right.y, up.y), bits2);
  float alpha2 = tiled_floor_box_share(q, vec2(shrink), tile.local, q_dx, q_dy, tile_local_dx,
      tile_local_dy);
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 0.94580835, far);
  inner = tiled_floor_Tile(turned_tiles_value + 0.5, choice, seed, vec2(to_x.x, to_y.x),
      vec2(to_x.y, to_y.y));
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// normal_map (materials/normal_map.glsl)
vec3 tiled_floor_normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

// threshold (math/threshold.glsl)
float tiled_floor_threshold(float value, float edge) {
  return clamp((value - edge) / 1e-7 + 0.5, 0.0, 1.0);
}

// color_ramp (color/color_ramp.glsl)
vec4 tiled_floor_color_ramp(float position) {
  vec4 vector = vec4(tiled_floor_threshold(position, 0.46));
  vec4 color = mix(vec4(0.82, 0.77, 0.64, 1.0), vec4(0.16, 0.36, 0.33, 1.0), vector);
  color = mix(color, vec4(0.035, 0.11, 0.22, 1.0), tiled_floor_threshold(position, 0.74));
  return mix(color, vec4(0.62, 0.29, 0.07, 1.0), tiled_floor_threshold(position, 0.91));
}

// tile_near (tiles/tile_near.glsl)
float tiled_floor_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// random3 (random/random3.glsl)
vec3 tiled_floor_random3(uint seed) {
  uint bits = tiled_floor_hash(seed + 22u);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(tiled_floor_hash(bits) >> 8u) * 5.9604645e-8);
}

// rgb_to_hsv (color/rgb_to_hsv.glsl)
vec3 tiled_floor_rgb_to_hsv(vec3 color) {
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
vec3 tiled_floor_hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0);
  vec3 blend = mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
  return hsv.z * blend;
}

// hsv_adjust (color/hsv_adjust.glsl)
vec3 tiled_floor_hsv_adjust(vec3 color, float hue, float saturation, float value) {
  float top = max(max(color.x, color.y), color.z);
  float range = top - min(min(color.x, color.y), color.z);
  float pull = 1.0;
  if (saturation != 1.0) {
    pull = min(saturation, top / max(range, 1e-20));
  }
  vec3 pulled = mix(vec3(top), color, pull);
  vec3 hsv = tiled_floor_rgb_to_hsv(pulled);
  vec3 turned = tiled_floor_hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? pulled : turned);
}

// varied, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 tiled_floor_varied(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), tiled_floor_random3(seed), near);
  vec3 one = tiled_floor_hsv_adjust(color, mix(-7.0, 7.0, luck.x), mix(0.85, 1.1, luck.y),
      mix(0.75, 1.15, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9975142), one, near);
}

// glazed_tile (function of the graph)
tiled_floor_Material tiled_floor_glazed_tile(vec2 uv, tiled_floor_Tile tile, vec2 uv_dx,
    vec2 uv_dy) {
  // picture: image (images/image.glsl)
  vec4 picture = textureGrad(glaze, uv, uv_dx, uv_dy);
  // texel: image (images/image.glsl)
  vec4 texel = textureGrad(glaze_relief, uv, uv_dx, uv_dy);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = tiled_floor_normal_map(texel.xyz);
  // lot: tile_random (tiles/tile_random.glsl)
  float lot = float(tiled_floor_hash(tile.seed + 21u) >> 8u) * 5.9604645e-8;
  // palette: color_ramp (color/color_ramp.glsl)
  vec4 palette = tiled_floor_color_ramp(lot);
  // batch: tile_random_hsv (tiles/tile_random_hsv.glsl)
  vec3 batch = tiled_floor_varied(tile.seed, tiled_floor_tile_near(uv_dx, uv_dy), palette.xyz);
  // color: multiply (math/multiply.glsl)
  vec3 color = picture.xyz * batch;
  // ochre: threshold (math/threshold.glsl)
  float ochre = tiled_floor_threshold(lot, 0.91);
  // luck: tile_random (tiles/tile_random.glsl)
  float luck = float(tiled_floor_hash(tile.seed + 23u) >> 8u) * 5.9604645e-8;
  // lucky: threshold (math/threshold.glsl)
  float lucky = tiled_floor_threshold(luck, 0.94);
  // lustre: maximum (math/maximum.glsl)
  float lustre = max(ochre, lucky);
  // metallic: multiply (math/multiply.glsl)
  float metallic = lustre * 0.85;
  // gloss: tile_random (tiles/tile_random.glsl)
  float gloss = mix(0.06, 0.24, float(tiled_floor_hash(tile.seed + 24u) >> 8u) * 5.9604645e-8);
  // surface: material (materials/material.glsl)
  tiled_floor_Material surface = tiled_floor_Material(vec4(color, picture.w), slope, texel.w, gloss,
      metallic);
  return surface;
}

// draw_tiles, of material_layer (materials/material_layer.glsl)
tiled_floor_Material tiled_floor_draw_tiles(tiled_floor_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy, out tiled_floor_Tile inner, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  float alpha;
  tiled_floor_Tile inner2;
  vec2 inner_local_dx2, inner_local_dy2;
  tiled_floor_layer_element_tiles(tile, tile_local_dx, tile_local_dy, alpha, inner2,
      inner_local_dx2, inner_local_dy2);
  tiled_floor_Material seen = tiled_floor_glazed_tile(inner2.local, inner2, inner_local_dx2,
      inner_local_dy2);
  vec4 vector = vec4(seen.color.xyz, seen.color.w * alpha);
  vec3 vector2 = vec3(seen.normal.x * inner2.right + seen.normal.y * inner2.up, seen.normal.z);
  seen = tiled_floor_Material(vector, vector2, seen.height, seen.roughness, seen.metallic);
  inner = inner2;
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
  return seen;
}

// turned_worn, of layer_element (layers/layer_element.glsl)
vec2 tiled_floor_turned_worn(vec2 p, uint bits, vec2 p_dx, vec2 p_dy, out vec2 result_dx,
    out vec2 result_dy) {
  bool test = (bits & 1u) != 0u;
  vec2 p2 = test ? vec2(p.y, -p.x) : p;
  vec2 p_dx2 = test ? vec2(p_dx.y, -p_dx.x) : p_dx;
  vec2 p_dy2 = test ? vec2(p_dy.y, -p_dy.x) : p_dy;
  bool test2 = (bits & 2u) != 0u;
  p2 = test2 ? -p2 : p2;
  p_dx2 = test2 ? -p_dx2 : p_dx2;
  p_dy2 = test2 ? -p_dy2 : p_dy2;
  bool test3 = (bits & 4u) != 0u;
  p2 = vec2(test3 ? -p2.x : p2.x, p2.y);
  result_dx = vec2(test3 ? -p_dx2.x : p_dx2.x, p_dx2.y);
  result_dy = vec2(test3 ? -p_dy2.x : p_dy2.x, p_dy2.y);
  return p2;
}

// turned_worn, of layer_element (layers/layer_element.glsl)
vec2 tiled_floor_turned_worn2(vec2 p, uint bits) {
  vec2 p2 = (bits & 1u) != 0u ? vec2(p.y, -p.x) : p;
  p2 = (bits & 2u) != 0u ? -p2 : p2;
  p2 = vec2((bits & 4u) != 0u ? -p2.x : p2.x, p2.y);
  return p2;
}

// layer_element (layers/layer_element.glsl)
void tiled_floor_layer_element_worn(tiled_floor_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy,
    out float alpha, out tiled_floor_Tile inner, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = tiled_floor_hash(tile.seed + 1u);
  uint bits = tiled_floor_hash(seed - 4u);
  vec2 p = tile.local - 0.5;
  vec2 q = p + 0.5;
  uint bits2 = bits >> 16u;
  vec2 inner_local_dx2, inner_local_dy2;
  vec2 turned_worn_value = tiled_floor_turned_worn(q - 0.5, bits2, tile_local_dx, tile_local_dy,
      inner_local_dx2, inner_local_dy2);
  vec2 choice = (bits2 & 1u) != 0u ? tile.size.yx : tile.size;
  vec2 to_x = tiled_floor_turned_worn2(vec2(tile.right.x, tile.up.x), bits2);
  vec2 to_y = tiled_floor_turned_worn2(vec2(tile.right.y, tile.up.y), bits2);
  uint hash_value = tiled_floor_hash(seed - 3u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float box_share_value = tiled_floor_box_share(q, vec2(1.0), tile.local, tile_local_dx,
      tile_local_dy, tile_local_dx, tile_local_dy);
  float alpha2 = luck.x * box_share_value;
  vec2 width = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  alpha = mix(alpha2, 0.5, far);
  inner = tiled_floor_Tile(turned_worn_value + 0.5, choice, seed, vec2(to_x.x, to_y.x),
      vec2(to_x.y, to_y.y));
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// draw_worn, of material_layer (materials/material_layer.glsl)
tiled_floor_Material tiled_floor_draw_worn(tiled_floor_Tile tile, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  float alpha;
  tiled_floor_Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  tiled_floor_layer_element_worn(tile, tile_local_dx, tile_local_dy, alpha, inner, inner_local_dx,
      inner_local_dy);
  vec4 texel = textureGrad(wear_mask, inner.local, inner_local_dx, inner_local_dy);
  tiled_floor_Material seen = tiled_floor_Material(vec4(texel.xyz, texel.w * alpha),
      vec3(0.0, 0.0, 1.0), 0.0, 0.8, 0.0);
  return seen;
}

// hash (random/hash.glsl)
uvec2 tiled_floor_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 tiled_floor_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// value_noise (noise/value_noise.glsl)
float tiled_floor_value_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 5.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = tiled_floor_hash(uvec2(cell.y, cell.y + 1u) + 2131687100u);
  uvec4 bits = tiled_floor_hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 5.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// material_over (materials/material_over.glsl)
tiled_floor_Material tiled_floor_material_over_laid(tiled_floor_Material foreground,
    tiled_floor_Material background) {
  float alpha = mix(background.color.w, 1.0, foreground.color.w);
  float share = foreground.color.w / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 n = mix(background.normal, foreground.normal, share);
  vec3 product = n * inversesqrt(max(dot(n, n), 1e-20));
  float blend = mix(background.height, foreground.height, share);
  float blend2 = mix(background.roughness, foreground.roughness, share);
  float blend3 = mix(background.metallic, foreground.metallic, share);
  tiled_floor_Material seen = tiled_floor_Material(vector, product, blend, blend2, blend3);
  return seen;
}

// combine_normals (materials/combine_normals.glsl)
vec3 tiled_floor_combine_normals(vec3 base, vec3 detail, float strength) {
  vec2 ratio = strength * detail.xy / max(detail.z, 0.01);
  vec3 n = vec3(base.xy / max(base.z, 0.01) + ratio, 1.0);
  return n * inversesqrt(dot(n, n));
}

// material_over (materials/material_over.glsl)
tiled_floor_Material tiled_floor_material_over_trodden(tiled_floor_Material foreground,
    tiled_floor_Material background, float opacity, float mask) {
  float front = foreground.color.w * opacity * mask;
  float alpha = mix(background.color.w, 1.0, front);
  float share = front / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 combine_normals_value = tiled_floor_combine_normals(background.normal, foreground.normal,
      share);
  float sum = background.height + share * foreground.height;
  float blend = mix(background.roughness, foreground.roughness, share);
  float blend2 = mix(background.metallic, foreground.metallic, share);
  tiled_floor_Material seen = tiled_floor_Material(vector, combine_normals_value, sum, blend,
      blend2);
  return seen;
}

void tiled_floor(vec2 uv, out vec4 color, out vec3 normal, out float roughness, out float metallic,
    out float height) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  tiled_floor_Tile grid;
  vec2 grid_local_dx, grid_local_dy;
  tiled_floor_brick_grid(uv, uv_dx, uv_dy, grid, grid_local_dx, grid_local_dy);
  // tiles: material_layer (materials/material_layer.glsl)
  tiled_floor_Tile tiles_inner;
  vec2 tiles_inner_local_dx, tiles_inner_local_dy;
  tiled_floor_Material tiles_surface = tiled_floor_draw_tiles(grid, grid_local_dx, grid_local_dy,
      tiles_inner, tiles_inner_local_dx, tiles_inner_local_dy);
  // worn: material_layer (materials/material_layer.glsl)
  tiled_floor_Material worn_surface = tiled_floor_draw_worn(tiles_inner, tiles_inner_local_dx,
      tiles_inner_local_dy);
  // sand_color: tiled_image (images/tiled_image.glsl)
  vec4 sand_color = texture(grit, uv * 3.0);
  // dirt_noise: value_noise (noise/value_noise.glsl)
  float dirt_noise = tiled_floor_value_noise(uv, uv_dx, uv_dy);
  // dirt: remap (math/remap.glsl)
  float dirt = mix(0.45, 1.1, dirt_noise);
  // grout_tone: multiply (math/multiply.glsl)
  vec3 grout_tone = grout * dirt;
  // grout_rgb: multiply (math/multiply.glsl)
  vec3 grout_rgb = sand_color.xyz * grout_tone;
  // grout_rgba: rgba (channels/rgba.glsl)
  vec4 grout_rgba = vec4(grout_rgb, 1.0);
  // grout_surface: material (materials/material.glsl)
  tiled_floor_Material grout_surface = tiled_floor_Material(grout_rgba, vec3(0.0, 0.0, 1.0), 0.05,
      0.95, 0.0);
  // laid: material_over (materials/material_over.glsl)
  tiled_floor_Material laid = tiled_floor_material_over_laid(tiles_surface, grout_surface);
  // trodden: material_over (materials/material_over.glsl)
  tiled_floor_Material trodden = tiled_floor_material_over_trodden(worn_surface, laid, wear_amount,
      tiles_surface.color.w);
  // color: lerp (math/lerp.glsl)
  vec4 color2 = mix(laid.color, trodden.color, 0.22);
  color = color2;
  normal = trodden.normal;
  roughness = trodden.roughness;
  metallic = trodden.metallic;
  height = trodden.height;
}
