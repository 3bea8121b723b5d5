// terrazzo: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec3 position;

// Parameters
uniform float amount;  // default 0.9
uniform vec3 cement;  // default vec3(0.62, 0.585, 0.53)

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

// Types
struct Tile3 {
  uint seed;
};
struct Copy {
  uint seed;
  uint luck;
  float large;
  vec4 turn;
  vec3 from;
};
struct View {
  vec3 light;
  float through;
};

// Constants
const vec3 colors[10] = vec3[10](vec3(0.8, 0.76, 0.7), vec3(0.66, 0.6, 0.52),
    vec3(0.055, 0.055, 0.06), vec3(0.2, 0.195, 0.19), vec3(0.42, 0.17, 0.1), vec3(0.5, 0.33, 0.15),
    vec3(0.3, 0.3, 0.29), vec3(0.09, 0.145, 0.115), vec3(0.72, 0.7, 0.67), vec3(0.58, 0.36, 0.28));

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
float value_noise(vec3 uv, vec3 uv_dx, vec3 uv_dy) {
  vec3 p = uv * 110.0;
  vec3 base = floor(p);
  vec3 t = p - base;
  vec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec3 cell = uvec3(ivec3(base));
  uint sum = cell.x + 1u;
  uvec4 columns = uvec4(cell.x, sum, cell.x, sum);
  uvec2 slices = hash(uvec2(cell.z, cell.z + 1u) + 678955108u);
  uint sum2 = cell.y + 1u;
  uvec4 rows = hash(uvec4(cell.y, sum2, cell.y, sum2) + slices.xxyy);
  vec4 front = vec4(hash(columns + rows.xxyy) >> 8u) * 5.9604645e-8;
  vec4 back = vec4(hash(columns + rows.zzww) >> 8u) * 5.9604645e-8;
  vec3 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 110.0;
  float blur = clamp(2.0 * max(max(width.x, width.y), width.z) - 1.0, 0.0, 1.0);
  vec4 face = mix(front, back, fade.z);
  vec2 blend = mix(face.xz, face.yw, fade.x);
  return mix(mix(blend.x, blend.y, fade.y), 0.5, blur);
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// directions3 (noise/directions3.glsl)
void directions3(uvec4 bits, out vec4 x, out vec4 y, out vec4 z) {
  vec4 x2 = vec4(ivec4(bits)) * 4.656613e-10;
  vec4 y2 = vec4(ivec4(bits << 16u)) * 4.656613e-10;
  vec4 difference = 1.0 - abs(x2);
  vec4 magnitude = abs(y2);
  vec4 under = max(magnitude - difference, 0.0);
  x = x2 - sign(x2) * under;
  y = y2 - sign(y2) * under;
  z = difference - magnitude;
}

// gradient_noise (noise/gradient_noise.glsl)
float gradient_noise_patches(vec3 uv, vec3 scale, int seed, vec3 uv_dx, vec3 uv_dy) {
  vec3 p = uv * scale;
  vec3 base = floor(p);
  vec3 t = p - base;
  vec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec3 cell = uvec3(ivec3(base));
  uint sum = cell.x + 1u;
  uvec4 columns = uvec4(cell.x, sum, cell.x, sum);
  uvec2 slices = hash(uvec2(cell.z, cell.z + 1u) + hash(uint(seed)));
  uint sum2 = cell.y + 1u;
  uvec4 rows = hash(uvec4(cell.y, sum2, cell.y, sum2) + slices.xxyy);
  vec4 x0, y0, z0;
  directions3(hash(columns + rows.xxyy), x0, y0, z0);
  vec4 x1, y1, z1;
  directions3(hash(columns + rows.zzww), x1, y1, z1);
  vec3 u = t - 1.0;
  vec4 tx = vec4(t.x, u.x, t.x, u.x);
  vec4 ty = vec4(t.yy, u.yy);
  vec4 front = x0 * tx + y0 * ty + z0 * t.z;
  vec4 back = x1 * tx + y1 * ty + z1 * u.z;
  vec4 face = mix(front, back, fade.z);
  vec3 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * abs(scale);
  float blur = clamp(2.0 * max(max(width.x, width.y), width.z) - 1.0, 0.0, 1.0);
  float amplitude = 0.8882547 * (1.0 - blur);
  vec2 blend = mix(face.xz, face.yw, fade.x);
  return mix(blend.x, blend.y, fade.y) * amplitude + 0.5;
}

// copy_bits3 (bombing/copy_bits3.glsl)
void copy_bits3(ivec3 cell, int copy, int seed, out uvec3 place, out uint luck, out uint bits) {
  uint first = hash(uint(seed));
  uint second = hash(first);
  uvec3 sum = uvec3(cell) * 1664525u + uvec3(first, second, hash(second));
  uvec3 v = sum + uint(copy) * uvec3(2654435769u, 1540483477u, 2246822519u);
  uint sum2 = v.x + v.y * v.z;
  uint sum3 = v.y + v.z * sum2;
  v = uvec3(sum2, sum3, v.z + sum2 * sum3);
  v ^= v >> 16u;
  uint sum4 = v.x + v.y * v.z;
  uint sum5 = v.y + v.z * sum4;
  uint bits2 = v.z + sum4 * sum5;
  place = uvec3(sum4, sum5, sum4 * 3266489917u + sum5 * 668265263u + bits2 * 374761393u);
  luck = sum4 * 1597334677u + sum5 * 3432918353u + bits2 * 461845907u;
  bits = bits2;
}

// copy_at, of bomb3 (bombing/bomb3.glsl)
Copy copy_at(vec3 p, vec3 node, int index, int seed) {
  uvec3 place;
  uint luck, bits;
  copy_bits3(ivec3(node), index, seed, place, luck, bits);
  vec3 difference = p - node - vec3(ivec3(place)) * 2.3283064e-10;
  Copy copy = Copy(bits, luck, float(hash(bits - 2u) >> 8u) * 5.9604645e-8, vec4(0.0), difference);
  return copy;
}

// is_near, of bomb3 (bombing/bomb3.glsl)
bool is_near(Copy copy, vec2 size) {
  float side = max(mix(size.x, size.y, copy.large), 1e-6);
  float square = dot(copy.from, copy.from);
  return square < 0.75 * side * side;
}

// random3 (random/random3.glsl)
vec3 random3(uint seed, int stream) {
  uint bits = hash(seed + uint(stream));
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(hash(bits) >> 8u) * 5.9604645e-8);
}

// turned_by, of bomb3 (bombing/bomb3.glsl)
vec4 turned_by(uint seed) {
  vec3 luck = random3(seed, -5);
  vec2 angle = 6.2831855 * luck.yz;
  float a = sqrt(1.0 - luck.x);
  float b = sqrt(luck.x);
  return vec4(a * sin(angle.x), a * cos(angle.x), b * sin(angle.y), b * cos(angle.y));
}

// turn_of, of bomb3 (bombing/bomb3.glsl)
vec4 turn_of(Copy copy) {
  return turned_by(copy.seed);
}

// arm_of, of bomb3 (bombing/bomb3.glsl)
vec3 arm_of(Copy copy, vec2 size) {
  vec3 arm = copy.from / max(mix(size.x, size.y, copy.large), 1e-6);
  vec3 perpendicular = cross(copy.turn.xyz, cross(copy.turn.xyz, arm) - copy.turn.w * arm);
  return arm + 2.0 * perpendicular;
}

// is_there, of bomb3 (bombing/bomb3.glsl)
bool is_there(Copy copy) {
  bool test = float(hash(copy.seed - 3u) >> 8u) * 5.9604645e-8 < amount;
  bool stays = amount >= 1.0 || test;
  return stays;
}

// find_next_small, of bomb3 (bombing/bomb3.glsl)
void find_next_small(vec3 p, vec3 corner, uint last, out uint last_out, out Copy found) {
  Copy found2 = Copy(0u, 0u, 0.0, vec4(0.0), p);
  uint best = 0u;
  for (int i = 0; i < 8; ++i) {
    vec3 node = corner + vec3(ivec3(i % 2, i / 2 % 2, i / 4));
    for (int index = 0; index < 2; ++index) {
      Copy copy = copy_at(p, node, index, 3);
      bool is_next = best < copy.luck && copy.luck < last;
      if (is_next && is_near(copy, vec2(0.35, 0.57))) {
        Copy copy2 = Copy(copy.seed, copy.luck, copy.large, turn_of(copy), copy.from);
        vec3 magnitude = abs(arm_of(copy2, vec2(0.35, 0.57)));
        bool test = max(max(magnitude.x, magnitude.y), magnitude.z) < 0.5 && is_there(copy2);
        found2 = test ? copy2 : found2;
        best = test ? copy.luck : best;
      }
    }
  }
  last_out = best;
  found = found2;
}

// arm_of, of bomb3 (bombing/bomb3.glsl)
vec3 arm_of2(Copy copy, vec2 size, vec3 copy_from_dx, vec3 copy_from_dy, out vec3 result_dx,
    out vec3 result_dy) {
  vec3 vector = vec3(max(mix(size.x, size.y, copy.large), 1e-6));
  vec3 arm = copy.from / vector;
  vec3 arm_dx = copy_from_dx / vector;
  vec3 arm_dy = copy_from_dy / vector;
  vec3 perpendicular = cross(copy.turn.xyz, cross(copy.turn.xyz, arm) - copy.turn.w * arm);
  vec3 perpendicular2 = cross(copy.turn.xyz, cross(copy.turn.xyz, arm_dx) - arm_dx * copy.turn.w);
  vec3 perpendicular3 = cross(copy.turn.xyz, cross(copy.turn.xyz, arm_dy) - arm_dy * copy.turn.w);
  result_dx = arm_dx + perpendicular2 * 2.0;
  result_dy = arm_dy + perpendicular3 * 2.0;
  return arm + 2.0 * perpendicular;
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec3 tile_local_dx, vec3 tile_local_dy) {
  vec3 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 64.0 / (part.x * part.y * part.z);
}

// threshold (math/threshold.glsl)
float threshold(float value, float value_dx, float value_dy) {
  float sum = value / max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7) + 0.5;
  return clamp(sum, 0.0, 1.0);
}

// broken (function of the graph)
float broken(vec3 position, Tile3 tile, vec3 position_dx, vec3 position_dy) {
  // arm: subtract (math/subtract.glsl)
  vec3 arm = position - 0.5;
  // way_1: tile_random_color (tiles/tile_random_color.glsl)
  vec3 vector = vec3(tile_near(position_dx, position_dy));
  vec3 way_1 = mix(vec3(-1.0), vec3(1.0), mix(vec3(0.5), random3(tile.seed, 11), vector));
  // way_2: tile_random_color (tiles/tile_random_color.glsl)
  vec3 way_2 = mix(vec3(-1.0), vec3(1.0), mix(vec3(0.5), random3(tile.seed, 12), vector));
  // way_3: tile_random_color (tiles/tile_random_color.glsl)
  vec3 way_3 = mix(vec3(-1.0), vec3(1.0), mix(vec3(0.5), random3(tile.seed, 13), vector));
  // way_4: tile_random_color (tiles/tile_random_color.glsl)
  vec3 way_4 = mix(vec3(-1.0), vec3(1.0), mix(vec3(0.5), random3(tile.seed, 14), vector));
  // way_5: tile_random_color (tiles/tile_random_color.glsl)
  vec3 way_5 = mix(vec3(-1.0), vec3(1.0), mix(vec3(0.5), random3(tile.seed, 15), vector));
  // side_1: normalized (math/normalized.glsl)
  vec3 side_1 = way_1 * inversesqrt(max(dot(way_1, way_1), 1e-30));
  // side_2: normalized (math/normalized.glsl)
  vec3 side_2 = way_2 * inversesqrt(max(dot(way_2, way_2), 1e-30));
  // side_3: normalized (math/normalized.glsl)
  vec3 side_3 = way_3 * inversesqrt(max(dot(way_3, way_3), 1e-30));
  // side_4: normalized (math/normalized.glsl)
  vec3 side_4 = way_4 * inversesqrt(max(dot(way_4, way_4), 1e-30));
  // side_5: normalized (math/normalized.glsl)
  vec3 side_5 = way_5 * inversesqrt(max(dot(way_5, way_5), 1e-30));
  // out_1: dot_product (math/dot_product.glsl)
  float out_1 = dot(arm, side_1);
  float out_1_dx = dot(position_dx, side_1);
  float out_1_dy = dot(position_dy, side_1);
  // out_2: dot_product (math/dot_product.glsl)
  float out_2 = dot(arm, side_2);
  float out_2_dx = dot(position_dx, side_2);
  float out_2_dy = dot(position_dy, side_2);
  // out_3: dot_product (math/dot_product.glsl)
  float out_3 = dot(arm, side_3);
  float out_3_dx = dot(position_dx, side_3);
  float out_3_dy = dot(position_dy, side_3);
  // out_4: dot_product (math/dot_product.glsl)
  float out_4 = dot(arm, side_4);
  float out_4_dx = dot(position_dx, side_4);
  float out_4_dy = dot(position_dy, side_4);
  // out_5: dot_product (math/dot_product.glsl)
  float out_5 = dot(arm, side_5);
  float out_5_dx = dot(position_dx, side_5);
  float out_5_dy = dot(position_dy, side_5);
  // most_12: maximum (math/maximum.glsl)
  float most_12 = max(out_1, out_2);
  bool test = out_1 < out_2;
  float most_12_dx = test ? out_2_dx : out_1_dx;
  float most_12_dy = test ? out_2_dy : out_1_dy;
  // most_34: maximum (math/maximum.glsl)
  float most_34 = max(out_3, out_4);
  bool test2 = out_3 < out_4;
  float most_34_dx = test2 ? out_4_dx : out_3_dx;
  float most_34_dy = test2 ? out_4_dy : out_3_dy;
  // most_1234: maximum (math/maximum.glsl)
  float most_1234 = max(most_12, most_34);
  bool test3 = most_12 < most_34;
  float most_1234_dx = test3 ? most_34_dx : most_12_dx;
  float most_1234_dy = test3 ? most_34_dy : most_12_dy;
  // most: maximum (math/maximum.glsl)
  float most = max(most_1234, out_5);
  bool test4 = most_1234 < out_5;
  float most_dx = test4 ? out_5_dx : most_1234_dx;
  float most_dy = test4 ? out_5_dy : most_1234_dy;
  // inside: subtract (math/subtract.glsl)
  float inside = 0.27 - most;
  // there: threshold (math/threshold.glsl)
  float inside_dx = -most_dx;
  float inside_dy = -most_dy;
  float there = threshold(inside, inside_dx, inside_dy);
  return there;
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
vec3 hsv_adjust(vec3 color, float hue, float value) {
  vec3 hsv = rgb_to_hsv(color);
  vec3 turned = hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? color : turned);
}

// varied, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 varied(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), random3(seed, 1), near);
  vec3 one = hsv_adjust(color, mix(-6.0, 6.0, luck.x), mix(0.75, 1.15, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9981733), one, near);
}

// gradient_noise (noise/gradient_noise.glsl)
float gradient_noise_n(vec3 uv, int seed) {
  vec3 base = floor(uv);
  vec3 t = uv - base;
  vec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec3 cell = uvec3(ivec3(base));
  uint sum = cell.x + 1u;
  uvec4 columns = uvec4(cell.x, sum, cell.x, sum);
  uvec2 slices = hash(uvec2(cell.z, cell.z + 1u) + hash(uint(seed)));
  uint sum2 = cell.y + 1u;
  uvec4 rows = hash(uvec4(cell.y, sum2, cell.y, sum2) + slices.xxyy);
  vec4 x0, y0, z0;
  directions3(hash(columns + rows.xxyy), x0, y0, z0);
  vec4 x1, y1, z1;
  directions3(hash(columns + rows.zzww), x1, y1, z1);
  vec3 u = t - 1.0;
  vec4 tx = vec4(t.x, u.x, t.x, u.x);
  vec4 ty = vec4(t.yy, u.yy);
  vec4 front = x0 * tx + y0 * ty + z0 * t.z;
  vec4 back = x1 * tx + y1 * ty + z1 * u.z;
  vec4 face = mix(front, back, fade.z);
  vec2 blend = mix(face.xz, face.yw, fade.x);
  return mix(blend.x, blend.y, fade.y) * 0.8882547 + 0.5;
}

// fbm (noise/fbm.glsl)
float fbm(vec3 uv, vec3 uv_dx, vec3 uv_dy) {
  vec3 p = uv * 3.0;
  vec3 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 3.0;
  float width = max(max(product.x, product.y), product.z);
  float weight = 0.5714286;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  for (int octave = 0; octave < 3; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near * (gradient_noise_n(p * frequency + shift, octave) - 0.5);
      sum += product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  return sum;
}

// marble (function of the graph)
vec4 marble(vec3 position, Tile3 tile, vec3 position_dx, vec3 position_dy) {
  // kind: tile_palette (tiles/tile_palette.glsl)
  vec3 kind = colors[int(((tile.seed >> 16u) * 10u) >> 16u)];
  // stone: tile_random_hsv (tiles/tile_random_hsv.glsl)
  float tile_near_value = tile_near(position_dx, position_dy);
  vec3 stone = varied(tile.seed, tile_near_value, kind);
  // elsewhere: tile_random_color (tiles/tile_random_color.glsl)
  vec3 elsewhere = 64.0 * mix(vec3(0.5), random3(tile.seed, 2), tile_near_value);
  // place: add (math/add.glsl)
  vec3 place = position + elsewhere;
  // clouds: fbm (noise/fbm.glsl)
  float clouds = fbm(place, position_dx, position_dy);
  // tone: remap (math/remap.glsl)
  float tone = mix(0.72, 1.2, (clouds - 0.3) / 0.39999998);
  // shaded: multiply (math/multiply.glsl)
  vec3 shaded = stone * tone;
  // wave: gradient_noise (noise/gradient_noise.glsl)
  float wave = gradient_noise_patches(place, vec3(1.1), 3, position_dx, position_dy);
  // bent: add (math/add.glsl)
  float bent = wave + clouds;
  // middle: subtract (math/subtract.glsl)
  float middle = bent - 1.0;
  // from_vein: absolute (math/absolute.glsl)
  float from_vein = abs(middle);
  // vein: remap (math/remap.glsl)
  float vein = clamp((from_vein - 0.016) / -0.016, 0.0, 1.0);
  // strength: multiply (math/multiply.glsl)
  float strength = vein * 0.3;
  // veined: lerp (math/lerp.glsl)
  vec3 veined = mix(shaded, vec3(0.75, 0.71, 0.65), strength);
  // opaque: rgba (channels/rgba.glsl)
  vec4 opaque = vec4(veined, 1.0);
  return opaque;
}

// paint, of bomb3 (bombing/bomb3.glsl)
vec4 paint(Copy copy, vec2 size, vec3 copy_from_dx, vec3 copy_from_dy) {
  vec3 tile_local_dx, tile_local_dy;
  vec3 arm_of_value = arm_of2(copy, size, copy_from_dx, copy_from_dy, tile_local_dx, tile_local_dy);
  vec3 sum = arm_of_value + 0.5;
  Tile3 tile = Tile3(copy.seed);
  float part = broken(sum, tile, tile_local_dx, tile_local_dy);
  vec4 seen = vec4(0.0);
  if (part > 0.0) {
    seen = marble(sum, tile, tile_local_dx, tile_local_dy);
    seen = vec4(seen.xyz, part);
  }
  return seen;
}

// by_rank_small, of bomb3 (bombing/bomb3.glsl)
View by_rank_small(vec3 p, vec3 corner, float near, vec3 p_dx, vec3 p_dy) {
  vec4 sum = vec4(0.0);
  float open = near;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    Copy copy;
    find_next_small(p, corner, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = paint(copy, vec2(0.35, 0.57), p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return View(sum.xyz, through);
}

// bomb3 (bombing/bomb3.glsl)
void bomb3_small(vec3 uv, vec4 background, vec3 uv_dx, vec3 uv_dy, out vec4 color,
    out float covered) {
  vec3 p = uv * 21.2 - 0.5;
  vec3 corner = floor(p + 0.0063655376);
  vec3 p_dx = uv_dx * 21.2;
  vec3 p_dy = uv_dy * 21.2;
  vec3 pixel = sqrt(p_dx * p_dx + p_dy * p_dy);
  float near = clamp(2.0 - 2.0 * max(max(pixel.x, pixel.y), pixel.z), 0.0, 1.0);
  View view = by_rank_small(p, corner, near, p_dx, p_dy);
  float blend = mix(0.925, view.through, near);
  float covered2 = 1.0 - blend;
  float alpha = mix(background.w, 1.0, covered2);
  vec3 below = background.xyz * (background.w * blend);
  vec3 ratio = (mix(vec3(0.029625002, 0.025125002, 0.021525001), view.light, near) + below)
      / max(alpha, 1e-20);
  color = vec4(ratio, alpha);
  covered = covered2;
}

// bomb3_cells (bombing/bomb3_cells.glsl)
ivec3 bomb3_cells(vec2 size) {
  int number = int(ceil(1.0 + 2.0 * (0.8660254 * size.y) - 2e-6));
  return ivec3(max(number, 1));
}

// can_reach, of bomb3 (bombing/bomb3.glsl)
bool can_reach(vec3 p, vec3 node, vec2 size) {
  vec3 gap = max(abs(p - node) - 0.50001, 0.0);
  return dot(gap, gap) < 0.75 * size.y * size.y;
}

// find_next_medium, of bomb3 (bombing/bomb3.glsl)
void find_next_medium(vec3 p, vec3 corner, vec2 size, int seed, uint last, out uint last_out,
    out Copy found) {
  Copy found2 = Copy(0u, 0u, 0.0, vec4(0.0), p);
  uint best = 0u;
  for (int i = 0; i < 27; ++i) {
    vec3 node = corner + vec3(ivec3(i % 3, i / 3 % 3, i / 9));
    if (can_reach(p, node, size)) {
      for (int index = 0; index < 2; ++index) {
        Copy copy = copy_at(p, node, index, seed);
        bool is_next = best < copy.luck && copy.luck < last;
        if (is_next && is_near(copy, size)) {
          Copy copy2 = Copy(copy.seed, copy.luck, copy.large, turn_of(copy), copy.from);
          vec3 magnitude = abs(arm_of(copy2, size));
          bool test = max(max(magnitude.x, magnitude.y), magnitude.z) < 0.5 && is_there(copy2);
          found2 = test ? copy2 : found2;
          best = test ? copy.luck : best;
        }
      }
    }
  }
  last_out = best;
  found = found2;
}

// by_rank_medium, of bomb3 (bombing/bomb3.glsl)
View by_rank_medium(vec3 p, vec3 corner, vec2 size, int seed, float near, vec3 p_dx, vec3 p_dy) {
  vec4 sum = vec4(0.0);
  float open = near;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    Copy copy;
    find_next_medium(p, corner, size, seed, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = paint(copy, size, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return View(sum.xyz, through);
}

// bomb3 (bombing/bomb3.glsl)
void bomb3_medium(vec3 uv, vec3 scale, vec2 size, int seed, vec4 background, vec4 far, vec3 uv_dx,
    vec3 uv_dy, out vec4 color, out float covered) {
  vec3 p = uv * scale - 0.5;
  ivec3 more = (3 - bomb3_cells(size)) / 2;
  vec3 whole = floor(p - (0.5 + 0.8660254 * size.y - 1.0));
  vec3 corner = whole - vec3(more);
  vec3 p_dx = uv_dx * scale;
  vec3 p_dy = uv_dy * scale;
  vec3 pixel = sqrt(p_dx * p_dx + p_dy * p_dy);
  float near = clamp(2.0 - 2.0 * max(max(pixel.x, pixel.y), pixel.z), 0.0, 1.0);
  View view = by_rank_medium(p, corner, size, seed, near, p_dx, p_dy);
  float blend = mix(1.0 - far.w, view.through, near);
  float covered2 = 1.0 - blend;
  float alpha = mix(background.w, 1.0, covered2);
  vec3 below = background.xyz * (background.w * blend);
  vec3 ratio = (mix(far.xyz * far.w, view.light, near) + below) / max(alpha, 1e-20);
  color = vec4(ratio, alpha);
  covered = covered2;
}

void main() {
  vec3 position_dx = dFdx(position), position_dy = dFdy(position);
  // sand: value_noise (noise/value_noise.glsl)
  float sand = value_noise(position, position_dx, position_dy);
  // patches: gradient_noise (noise/gradient_noise.glsl)
  float patches = gradient_noise_patches(position, vec3(7.0), 6, position_dx, position_dy);
  // grain: remap (math/remap.glsl)
  float grain = mix(0.86, 1.1, sand);
  // stain: remap (math/remap.glsl)
  float stain = mix(0.8, 1.2, patches);
  // tones: multiply (math/multiply.glsl)
  float tones = grain * stain;
  // ground: multiply (math/multiply.glsl)
  vec3 ground = cement * tones;
  // filler: rgba (channels/rgba.glsl)
  vec4 filler = vec4(ground, 1.0);
  // small: bomb3 (bombing/bomb3.glsl)
  vec4 small_color;
  float small_covered;
  bomb3_small(position, filler, position_dx, position_dy, small_color, small_covered);
  // medium: bomb3 (bombing/bomb3.glsl)
  vec4 medium_color;
  float medium_covered;
  bomb3_medium(position, vec3(8.4), vec2(0.4, 0.8), 2, small_color, vec4(0.395, 0.335, 0.287, 0.16),
      position_dx, position_dy, medium_color, medium_covered);
  // large: bomb3 (bombing/bomb3.glsl)
  vec4 large_color;
  float large_covered;
  bomb3_medium(position, vec3(4.0), vec2(0.6, 1.1), 1, medium_color,
      vec4(0.395, 0.335, 0.287, 0.385), position_dx, position_dy, large_color, large_covered);
  // polish_1: lerp (math/lerp.glsl)
  float polish_1 = mix(0.42, 0.2, small_covered);
  // polish_2: lerp (math/lerp.glsl)
  float polish_2 = mix(polish_1, 0.2, medium_covered);
  // polish_3: lerp (math/lerp.glsl)
  float polish_3 = mix(polish_2, 0.2, large_covered);
  out_color = large_color;
  out_roughness = polish_3;
}
