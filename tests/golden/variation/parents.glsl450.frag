// parents: a fragment shader, compiled by texgraphc 0.1.0.
#version 450 core

// Inputs
layout(location = 0) in vec2 uv;

// Textures
layout(location = 0, binding = 0) uniform sampler2D glaze;
layout(location = 1, binding = 1) uniform sampler2D glaze_relief;

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out float out_roughness;
layout(location = 3) out float out_metallic;

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
  float metallic;
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
  vec2 p = uv * 4.0;
  int row = int(floor(p.y));
  uint row_bits = hash(uint(row) + 4048597412u);
  vec2 corner = floor(p);
  int column = int(corner.x);
  uint hash_value = hash(uint(column) + row_bits);
  tile = Tile(p - corner, vec2(0.25), hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * 4.0;
  tile_local_dy = uv_dy * 4.0;
}

// box_share (layers/box_share.glsl)
float box_share(vec2 q, vec2 cell_in_q, vec2 q_dx, vec2 q_dy) {
  vec2 density = 1.0 / clamp(sqrt(q_dx * q_dx + q_dy * q_dy), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q - 0.5)) * density + 0.5, density);
  vec2 covered = clamp(share, 0.0, 1.0);
  return covered.x * covered.y;
}

// layer_element (layers/layer_element.glsl)
void layer_element(Tile tile, vec2 position_min, vec2 position_max, vec2 scale, vec2 rotation,
    int stream, vec2 tile_local_dx, vec2 tile_local_dy, out float alpha, out Tile inner,
    out vec2 inner_local_dx, out vec2 inner_local_dy) {
  uint seed = hash(tile.seed + uint(stream));
  uint hash_value = hash(seed - 2u);
  vec2 pose = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float angle = mix(rotation.x, rotation.y, pose.y) * 0.017453292;
  float size = mix(scale.x, scale.y, pose.x);
  vec2 across = vec2(tile.size.y, -tile.size.x) / tile.size;
  uint hash_value2 = hash(seed - 1u);
  vec2 product = vec2(float(hash_value2 & 65535u), float(hash_value2 >> 16u)) * 1.5258789e-5;
  vec2 center = mix(position_min, position_max, product);
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
  alpha = box_share(q, vec2(shrink), q_dx, q_dy);
  inner = Tile(q, size * tile.size, seed, right, up);
  inner_local_dx = q_dx;
  inner_local_dy = q_dy;
}

// draw_tiles, of material_layer (materials/material_layer.glsl)
void draw_tiles(Tile tile, vec2 tile_local_dx, vec2 tile_local_dy, out vec2 inner_local_dx,
    out vec2 inner_local_dy) {
  float alpha;
  Tile inner;
  vec2 inner_local_dx2, inner_local_dy2;
  layer_element(tile, vec2(0.44), vec2(0.56), vec2(0.7, 0.9), vec2(-16.0, 16.0), 0, tile_local_dx,
      tile_local_dy, alpha, inner, inner_local_dx2, inner_local_dy2);
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// mean, of material_layer (materials/material_layer.glsl)
Material mean(Material total) {
  float share = 1.0 / max(total.color.w, 1e-20);
  vec3 n = total.normal + vec3(0.0, 0.0, 1e-9);
  vec4 vector = vec4(total.color.xyz * share, total.color.w);
  vec3 product = n * inversesqrt(max(dot(n, n), 1e-20));
  return Material(vector, product, total.roughness * share, total.metallic * share);
}

// brick_grid (tiles/brick_grid.glsl)
void brick_grid(vec2 uv, ivec2 neighbour, vec2 uv_dx, vec2 uv_dy, out Tile tile,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 4.0;
  int row = int(floor(p.y)) + neighbour.y;
  uint row_bits = hash(uint(row) + 4048597412u);
  vec2 corner = floor(p) + vec2(neighbour);
  int column = int(corner.x);
  uint hash_value = hash(uint(column) + row_bits);
  tile = Tile(p - corner, vec2(0.25), hash_value, vec2(1.0, 0.0), vec2(0.0, 1.0));
  tile_local_dx = uv_dx * 4.0;
  tile_local_dy = uv_dy * 4.0;
}

// normal_map (materials/normal_map.glsl)
vec3 normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  vec2 slope = 1.5 * n.xy;
  vec3 steep = vec3(slope, n.z);
  return steep * inversesqrt(max(dot(steep, steep), 1e-20));
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

// hsv_to_rgb (color/hsv_to_rgb.glsl)
vec3 hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0);
  vec3 blend = mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
  return hsv.z * blend;
}

// hsv_adjust (color/hsv_adjust.glsl)
vec3 hsv_adjust(float hue, float value) {
  vec3 turned = hsv_to_rgb(vec3(0.099999994 + hue / 360.0, 0.4651163, 0.86));
  return value * (hue == 0.0 ? vec3(0.86, 0.7, 0.46) : turned);
}

// varied_tint, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 varied_tint(uint seed, float near) {
  vec3 luck = mix(vec3(0.5), random3(seed), near);
  vec3 one = hsv_adjust(mix(-22.0, 34.0, luck.x), mix(0.6, 1.15, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9606693), one, near);
}

// draw_tiles, of material_layer (materials/material_layer.glsl)
Material draw_tiles(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  brick_grid(uv, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element(tile, vec2(0.44), vec2(0.56), vec2(0.7, 0.9), vec2(-16.0, 16.0), 0, tile_local_dx,
      tile_local_dy, alpha, inner, inner_local_dx, inner_local_dy);
  Material seen = Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0);
  if (alpha > 0.0) {
    vec4 texel = textureGrad(glaze, inner.local, inner_local_dx, inner_local_dy);
    vec3 vector = textureGrad(glaze_relief, inner.local, inner_local_dx, inner_local_dy).xyz;
    vec3 normal_map_value = normal_map(vector);
    vec4 product = texel * vec4(1.05, 1.05, 1.05, 1.0);
    vec3 product2 = product.xyz * varied_tint(tile.seed, tile_near(tile_local_dx, tile_local_dy));
    vec3 vector2 = vec3(normal_map_value.x * inner.right + normal_map_value.y * inner.up,
        normal_map_value.z);
    seen = Material(vec4(product2, product.w * alpha), vector2, 0.25, 0.0);
  }
  return seen;
}

// material_layer (materials/material_layer.glsl)
void material_layer_tiles(vec2 uv, Tile tile, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx,
    vec2 tile_local_dy, out Material surface, out vec2 inner_local_dx, out vec2 inner_local_dy) {
  vec2 inner_local_dx2, inner_local_dy2;
  draw_tiles(tile, tile_local_dx, tile_local_dy, inner_local_dx2, inner_local_dy2);
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  Material total = Material(vec4(0.0), vec3(0.0), 0.0, 0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && total.color.w < 0.999; --x) {
      Material other = draw_tiles(uv, ivec2(x, y), uv_dx, uv_dy);
      float product = other.color.w * (1.0 - total.color.w * on);
      vec4 sum = total.color + vec4(other.color.xyz * product, product);
      vec3 sum2 = total.normal + product * other.normal;
      float sum3 = total.roughness + product * other.roughness;
      total = Material(sum, sum2, sum3, total.metallic + product * other.metallic);
    }
  }
  Material surface2 = mean(total);
  vec4 vector = vec4(surface2.color.xyz, min(surface2.color.w, 1.0));
  surface = Material(vector, surface2.normal, surface2.roughness, surface2.metallic);
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// draw_tiles, of material_layer (materials/material_layer.glsl)
void draw_tiles2(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy, out Tile inner,
    out vec2 inner_local_dx, out vec2 inner_local_dy) {
  Tile tile;
  vec2 tile_local_dx, tile_local_dy;
  brick_grid(uv, which, uv_dx, uv_dy, tile, tile_local_dx, tile_local_dy);
  float alpha;
  Tile inner2;
  vec2 inner_local_dx2, inner_local_dy2;
  layer_element(tile, vec2(0.44), vec2(0.56), vec2(0.7, 0.9), vec2(-16.0, 16.0), 0, tile_local_dx,
      tile_local_dy, alpha, inner2, inner_local_dx2, inner_local_dy2);
  inner = inner2;
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// material_layer (materials/material_layer.glsl)
void material_layer_tiles(vec2 uv, ivec2 home, vec2 uv_dx, vec2 uv_dy, out Tile inner,
    out vec2 inner_local_dx, out vec2 inner_local_dy) {
  Tile inner2;
  vec2 inner_local_dx2, inner_local_dy2;
  draw_tiles2(uv, home, uv_dx, uv_dy, inner2, inner_local_dx2, inner_local_dy2);
  inner = inner2;
  inner_local_dx = inner_local_dx2;
  inner_local_dy = inner_local_dy2;
}

// sdf_star (shapes/sdf_star.glsl)
float sdf_star(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv - 0.5;
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - 1.5707964;
  float toward = 1.5707964 + 1.2566371 * floor(turned / 1.2566371 + 0.5);
  float cosine = cos(toward);
  float sine = sin(toward);
  vec2 ahead = vec2(cosine, sine);
  float from_axis = p.y * cosine - p.x * sine;
  float from_axis_dx = uv_dx.y * cosine - uv_dx.x * sine;
  float from_axis_dy = uv_dy.y * cosine - uv_dy.x * sine;
  float projection = dot(uv_dx, ahead);
  float projection2 = dot(uv_dy, ahead);
  float difference = dot(p, ahead) - 0.46;
  float choice = from_axis < 0.0 ? -1.0 : 1.0;
  float product = from_axis * choice;
  vec2 q = vec2(difference, product);
  float product2 = from_axis_dx * choice;
  float product3 = from_axis_dy * choice;
  vec2 q_dx = vec2(projection, product2);
  vec2 q_dy = vec2(projection2, product3);
  float side = difference * 0.36675584 - product * -0.9303173;
  float side_dx = projection * 0.36675584 - product2 * -0.9303173;
  float side_dy = projection2 * 0.36675584 - product3 * -0.9303173;
  float place = dot(q, vec2(-0.9303173, 0.36675584));
  bool test = place > 0.0;
  if (!(test && place < 0.32053217)) {
    vec2 choice2 = test ? q - vec2(-0.2981966, 0.11755705) : q;
    float to_end = length(choice2);
    float greatest = max(to_end, 1e-20);
    float to_end_dx = dot(choice2, q_dx) / greatest;
    float to_end_dy = dot(choice2, q_dy) / greatest;
    bool test2 = side < 0.0;
    side = test2 ? -to_end : to_end;
    side_dx = test2 ? -to_end_dx : to_end_dx;
    side_dy = test2 ? -to_end_dy : to_end_dy;
  }
  result_dx = side_dx;
  result_dy = side_dy;
  return side;
}

// sdf_fill (shapes/sdf_fill.glsl)
float sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// sdf_stroke (shapes/sdf_stroke.glsl)
float sdf_stroke(float shape, float shape_dx, float shape_dy) {
  float pixel = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float center = shape + 0.04;
  float product = 0.5 * pixel;
  float low = max(center - product, -0.025);
  float high = min(center + product, 0.025);
  return clamp((high - low) / pixel, 0.0, 1.0);
}

// draw_stars, of material_layer (materials/material_layer.glsl)
Material draw_stars(vec2 uv, ivec2 which, vec2 uv_dx, vec2 uv_dy) {
  Tile inner2;
  vec2 inner_local_dx2, inner_local_dy2;
  material_layer_tiles(uv, which, uv_dx, uv_dy, inner2, inner_local_dx2, inner_local_dy2);
  float alpha;
  Tile inner;
  vec2 inner_local_dx, inner_local_dy;
  layer_element(inner2, vec2(0.36), vec2(0.64), vec2(0.4, 0.85), vec2(-60.0, 60.0), 1,
      inner_local_dx2, inner_local_dy2, alpha, inner, inner_local_dx, inner_local_dy);
  Material seen = Material(vec4(0.0), vec3(0.0, 0.0, 1.0), 0.0, 0.0);
  if (alpha > 0.0) {
    float result_dx, result_dy;
    float sdf_star_value = sdf_star(inner.local, inner_local_dx, inner_local_dy, result_dx,
        result_dy);
    float sdf_stroke_value = sdf_stroke(sdf_star_value, result_dx, result_dy);
    vec4 blend = mix(vec4(0.03, 0.13, 0.3, 1.0), vec4(0.72, 0.5, 0.14, 1.0), sdf_stroke_value);
    vec4 vector = vec4(blend.xyz, blend.w * sdf_fill(sdf_star_value, result_dx, result_dy) * alpha);
    seen = Material(vector, vec3(0.0, 0.0, 1.0), 0.2, sdf_stroke_value);
  }
  return seen;
}

// material_layer (materials/material_layer.glsl)
Material material_layer_stars(vec2 uv, vec2 uv_dx, vec2 uv_dy, vec2 tile_local_dx,
    vec2 tile_local_dy) {
  vec2 tiles = sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy);
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  Material total = Material(vec4(0.0), vec3(0.0), 0.0, 0.0);
  for (int y = 1; y > -2; --y) {
    for (int x = 1; x > -2 && total.color.w < 0.999; --x) {
      Material other = draw_stars(uv, ivec2(x, y), uv_dx, uv_dy);
      float product = other.color.w * (1.0 - total.color.w * on);
      vec4 sum = total.color + vec4(other.color.xyz * product, product);
      vec3 sum2 = total.normal + product * other.normal;
      float sum3 = total.roughness + product * other.roughness;
      total = Material(sum, sum2, sum3, total.metallic + product * other.metallic);
    }
  }
  Material surface = mean(total);
  vec4 vector = vec4(surface.color.xyz, min(surface.color.w, 1.0));
  surface = Material(vector, surface.normal, surface.roughness, surface.metallic);
  return surface;
}

// material_over (materials/material_over.glsl)
Material material_over_tiled(Material foreground) {
  vec3 blend = mix(vec3(0.05, 0.052, 0.056), foreground.color.xyz, foreground.color.w);
  vec3 n = mix(vec3(0.0, 0.0, 1.0), foreground.normal, foreground.color.w);
  vec3 product = n * inversesqrt(max(dot(n, n), 1e-20));
  float blend2 = mix(0.9, foreground.roughness, foreground.color.w);
  float product2 = foreground.metallic * foreground.color.w;
  Material seen = Material(vec4(blend, 1.0), product, blend2, product2);
  return seen;
}

// combine_normals (materials/combine_normals.glsl)
vec3 combine_normals(vec3 base, vec3 detail, float strength) {
  vec2 ratio = strength * detail.xy / max(detail.z, 0.01);
  vec3 n = vec3(base.xy / max(base.z, 0.01) + ratio, 1.0);
  return n * inversesqrt(dot(n, n));
}

// material_over (materials/material_over.glsl)
Material material_over_starred(Material foreground, Material background) {
  float alpha = mix(background.color.w, 1.0, foreground.color.w);
  float share = foreground.color.w / max(alpha, 1e-20);
  vec4 vector = vec4(mix(background.color.xyz, foreground.color.xyz, share), alpha);
  vec3 combine_normals_value = combine_normals(background.normal, foreground.normal, share);
  float blend = mix(background.roughness, foreground.roughness, share);
  Material seen = Material(vector, combine_normals_value, blend,
      mix(background.metallic, foreground.metallic, share));
  return seen;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: brick_grid (tiles/brick_grid.glsl)
  Tile grid;
  vec2 grid_local_dx, grid_local_dy;
  brick_grid(uv, uv_dx, uv_dy, grid, grid_local_dx, grid_local_dy);
  // tiles: material_layer (materials/material_layer.glsl)
  Material tiles_surface;
  vec2 tiles_inner_local_dx, tiles_inner_local_dy;
  material_layer_tiles(uv, grid, uv_dx, uv_dy, grid_local_dx, grid_local_dy, tiles_surface,
      tiles_inner_local_dx, tiles_inner_local_dy);
  // stars: material_layer (materials/material_layer.glsl)
  Material stars_surface = material_layer_stars(uv, uv_dx, uv_dy, tiles_inner_local_dx,
      tiles_inner_local_dy);
  // tiled: material_over (materials/material_over.glsl)
  Material tiled = material_over_tiled(tiles_surface);
  // starred: material_over (materials/material_over.glsl)
  Material starred = material_over_starred(stars_surface, tiled);
  out_color = starred.color;
  out_normal = starred.normal;
  out_roughness = starred.roughness;
  out_metallic = starred.metallic;
}
