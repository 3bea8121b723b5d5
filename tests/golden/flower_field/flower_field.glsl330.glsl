// flower_field: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float small;  // default 0.75
uniform float tall;  // default 0.9

// Textures
uniform sampler2DArray flowers;
uniform sampler2D beds;

// Types
struct flower_field_Tile {
  uint seed;
};
struct flower_field_Copy {
  uint seed;
  uint luck;
  vec2 from;
};
struct flower_field_View {
  vec3 light;
  float through;
};

// Constants
const float flower_field_stops[3] = float[3](0.3, 0.5, 0.7);
const vec4 flower_field_colors[3] = vec4[3](vec4(0.012, 0.03, 0.006, 1.0),
    vec4(0.03, 0.07, 0.012, 1.0), vec4(0.06, 0.075, 0.02, 1.0));

// hash (random/hash.glsl)
uvec2 flower_field_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 flower_field_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float flower_field_gradient_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 base = floor(uv);
  vec2 t = uv - base;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint number = uint(int(cell.x) & 3);
  uint choice = number == 3u ? 0u : number + 1u;
  uint number2 = uint(int(cell.y) & 3);
  uvec2 rows = flower_field_hash(uvec2(number2, number2 == 3u ? 0u : number2 + 1u) + 129708002u);
  uvec4 hash_value = flower_field_hash(uvec4(number, choice, number, choice) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = uv_dx.x * x + uv_dx.y * y;
  vec4 corners_dy = uv_dy.x * x + uv_dy.y * y;
  vec2 fade_dx = uv_dx * fade_slope;
  vec2 fade_dy = uv_dy * fade_slope;
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum2 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum3 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum2.x, sum2.y, fade.y) + difference3 * fade_dx.y) * 0.9340967;
  result_dy = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dy.y) * 0.9340967;
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// fbm (noise/fbm.glsl)
float flower_field_fbm(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 4.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 4.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 4.0;
  vec2 p_dy = uv_dy * 4.0;
  float weight = 0.53333336;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 4; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_value = flower_field_gradient_noise(p * frequency + shift,
          p_dx * frequency, p_dy * frequency, result_dx2, result_dy2);
      sum += product2 * (gradient_noise_value - 0.5);
      sum_dx += result_dx2 * product2;
      sum_dy += result_dy2 * product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// part_mean, of color_ramp (color/color_ramp.glsl)
vec4 flower_field_part_mean(vec4 from, vec4 to, float middle, float reach) {
  float square = reach * reach;
  float variance = square / 3.0;
  vec4 color = mix(from, to, middle);
  vec3 sum = color.xyz * color.w + (to.xyz - from.xyz) * ((to.w - from.w) * variance);
  return vec4(sum, color.w);
}

// color_ramp (color/color_ramp.glsl)
vec4 flower_field_color_ramp(float position, float position_dx, float position_dy) {
  float width = max(sqrt(position_dx * position_dx + position_dy * position_dy), 1e-7);
  float below = clamp((0.3 - position) / width + 0.5, 0.0, 1.0);
  vec4 sum = vec4(0.012, 0.03, 0.006, 1.0) * below;
  for (int i = 0; i < 2; ++i) {
    int sum2 = i + 1;
    float item = flower_field_stops[sum2];
    float next = clamp((item - position) / width + 0.5, 0.0, 1.0);
    float item2 = flower_field_stops[i];
    float part = 1.0 / max(item - item2, 1e-7);
    float middle = position + width * (0.5 * (below + next) - 0.5) - item2;
    float difference = next - below;
    float least = min(0.5 * difference * width * part, 0.5);
    vec4 part_mean_value = flower_field_part_mean(flower_field_colors[i], flower_field_colors[sum2],
        clamp(middle * part, 0.0, 1.0), least);
    below = next;
    sum += difference * part_mean_value;
  }
  sum += (1.0 - below) * vec4(0.06, 0.075, 0.02, 1.0);
  vec3 choice = vec3(0.06, 0.075, 0.02);
  if (sum.w > 0.0) {
    choice = sum.xyz / max(sum.w, 1e-20);
  }
  return vec4(choice, sum.w);
}

// wrap_cell (tiles/wrap_cell.glsl)
int flower_field_wrap_cell_grass(int cell, int count) {
  int flip = cell >> 31;
  return (((cell ^ flip) % count) ^ flip) + (flip & count);
}

// hash (random/hash.glsl)
uint flower_field_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// copy_bits (bombing/copy_bits.glsl)
uvec4 flower_field_copy_bits(ivec2 cell, int copy, int seed) {
  uint first = flower_field_hash(uint(seed));
  uvec2 c = uvec2(cell);
  uvec2 sum = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(first, flower_field_hash(first));
  uvec2 v = sum + uint(copy) * uvec2(2654435769u, 1540483477u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at_grass, of bomb (bombing/bomb.glsl)
flower_field_Copy flower_field_copy_at_grass(vec2 p, vec2 node, int index) {
  ivec2 numbers = ivec2(node);
  ivec2 numbers2 = ivec2(flower_field_wrap_cell_grass(numbers.x, 24),
      flower_field_wrap_cell_grass(numbers.y, 24));
  uvec4 bits = flower_field_copy_bits(numbers2, index, 1);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  flower_field_Copy copy = flower_field_Copy(bits.w, bits.z, p - node - moved);
  return copy;
}

// pose_of_grass, of bomb (bombing/bomb.glsl)
vec2 flower_field_pose_of_grass(flower_field_Copy copy) {
  uint hash_value = flower_field_hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(1.2, 2.0, luck.x), mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// find_next_grass, of bomb (bombing/bomb.glsl)
void flower_field_find_next_grass(vec2 p, vec2 low, uint last, out uint last_out,
    out flower_field_Copy found) {
  flower_field_Copy found2 = flower_field_Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 9; ++i) {
    vec2 node = floor(low) + vec2(ivec2(i % 3, i / 3));
    for (int index = 0; index < 5; ++index) {
      flower_field_Copy copy = flower_field_copy_at_grass(p, node, index);
      vec2 pose = flower_field_pose_of_grass(copy);
      uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25 * pose.x * pose.x));
      bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
      found2 = is_next ? copy : found2;
      best = is_next ? copy.luck : best;
    }
  }
  last_out = best;
  found = found2;
}

// arm_of, of bomb (bombing/bomb.glsl)
vec2 flower_field_arm_of(flower_field_Copy copy, vec2 pose, vec2 copy_from_dx, vec2 copy_from_dy,
    out vec2 result_dx, out vec2 result_dy) {
  float c = cos(pose.y);
  float s = sin(pose.y);
  vec2 sum = copy_from_dx * c + vec2(copy_from_dx.y, -copy_from_dx.x) * s;
  vec2 sum2 = copy_from_dy * c + vec2(copy_from_dy.y, -copy_from_dy.x) * s;
  bool test = pose.x != 0.0;
  result_dx = test ? sum / pose.x : vec2(0.0);
  result_dy = test ? sum2 / pose.x : vec2(0.0);
  return (c * copy.from + s * vec2(copy.from.y, -copy.from.x)) / pose.x;
}

// sdf_moon (shapes/sdf_moon.glsl)
float flower_field_sdf_moon(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - vec2(-0.37, 0.5);
  vec2 q = p - vec2(-0.35, 0.0);
  float from_middle = length(p);
  float greatest = max(from_middle, 1e-20);
  float from_middle_dx = dot(p, uv_dx) / greatest;
  float from_middle_dy = dot(p, uv_dy) / greatest;
  float from_cut = length(q);
  float greatest2 = max(from_cut, 1e-20);
  float from_cut_dx = dot(q, uv_dx) / greatest2;
  float from_cut_dy = dot(q, uv_dy) / greatest2;
  float outer = from_middle - 0.933;
  float inner = 1.2462 - from_cut;
  float side = max(outer, inner) < 0.0 ? -1.0 : 1.0;
  float beside = -p.y;
  vec2 tip = vec2(-0.8000362, p.y > -0.0 ? -0.48003244 : 0.48003244);
  vec2 point = vec2(-p.x, beside);
  float beside_dx = -uv_dx.y;
  float beside_dy = -uv_dy.y;
  float nearest = distance(point, tip);
  vec2 difference = point - tip;
  float greatest3 = max(nearest, 1e-20);
  float nearest_dx = dot(difference, vec2(-uv_dx.x, beside_dx)) / greatest3;
  float nearest_dy = dot(difference, vec2(-uv_dy.x, beside_dy)) / greatest3;
  float to_outer_slope = outer < 0.0 ? -1.0 : 1.0;
  float to_outer = outer * to_outer_slope;
  bool test = inner < 0.0;
  float to_inner = inner * (test ? -1.0 : 1.0);
  float to_inner_slope = test ? 1.0 : -1.0;
  vec2 on_outer = p * (0.933 / greatest);
  vec2 on_inner = vec2(-0.35, 0.0) + q * (1.2462 / greatest2);
  bool test2 = to_outer < nearest && distance(on_outer, vec2(-0.35, 0.0)) > 1.2462;
  nearest = test2 ? to_outer : nearest;
  float to_outer_dx = from_middle_dx * to_outer_slope;
  float to_outer_dy = from_middle_dy * to_outer_slope;
  nearest_dx = test2 ? to_outer_dx : nearest_dx;
  nearest_dy = test2 ? to_outer_dy : nearest_dy;
  bool test3 = to_inner < nearest && length(on_inner) < 0.933;
  nearest = test3 ? to_inner : nearest;
  float to_inner_dx = from_cut_dx * to_inner_slope;
  float to_inner_dy = from_cut_dy * to_inner_slope;
  nearest_dx = test3 ? to_inner_dx : nearest_dx;
  nearest_dy = test3 ? to_inner_dy : nearest_dy;
  result_dx = nearest_dx * side;
  result_dy = nearest_dy * side;
  return side * nearest;
}

// sdf_fill (shapes/sdf_fill.glsl)
float flower_field_sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// spread_range (math/spread_range.glsl)
float flower_field_spread_range(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(0.5 - value / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - value) / width, 0.0, 1.0);
  float middle = value + 0.5 * width * (below - above);
  return above + (1.0 - below - above) * clamp(middle, 0.0, 1.0);
}

// tile_near (tiles/tile_near.glsl)
float flower_field_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// random3 (random/random3.glsl)
vec3 flower_field_random3(uint seed) {
  uint bits = flower_field_hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(flower_field_hash(bits) >> 8u) * 5.9604645e-8);
}

// rgb_to_hsv (color/rgb_to_hsv.glsl)
vec3 flower_field_rgb_to_hsv(vec3 color) {
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
vec3 flower_field_hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0);
  vec3 blend = mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
  return hsv.z * blend;
}

// hsv_adjust (color/hsv_adjust.glsl)
vec3 flower_field_hsv_adjust(vec3 color, float hue, float saturation, float value) {
  float top = max(max(color.x, color.y), color.z);
  float range = top - min(min(color.x, color.y), color.z);
  float pull = 1.0;
  if (saturation != 1.0) {
    pull = min(saturation, top / max(range, 1e-20));
  }
  vec3 pulled = mix(vec3(top), color, pull);
  vec3 hsv = flower_field_rgb_to_hsv(pulled);
  vec3 turned = flower_field_hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? pulled : turned);
}

// varied_own, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 flower_field_varied_own(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), flower_field_random3(seed), near);
  vec3 one = flower_field_hsv_adjust(color, mix(-14.0, 10.0, luck.x), mix(0.7, 1.0, luck.y),
      mix(0.6, 1.4, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9927052), one, near);
}

// blade (function of the graph)
vec4 flower_field_blade(vec2 uv, flower_field_Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // leaf: sdf_moon (shapes/sdf_moon.glsl)
  float leaf_dx, leaf_dy;
  float leaf = flower_field_sdf_moon(uv, uv_dx, uv_dy, leaf_dx, leaf_dy);
  // shape: sdf_fill (shapes/sdf_fill.glsl)
  float shape = flower_field_sdf_fill(leaf, leaf_dx, leaf_dy);
  // along: gradient_linear (patterns/gradient_linear.glsl)
  float ratio = (uv - vec2(0.0, 0.1)).y * 0.84999996 / 0.72249997;
  float along = flower_field_spread_range(ratio, uv_dx.y * 0.84999996 / 0.72249997,
      uv_dy.y * 0.84999996 / 0.72249997);
  // green: lerp (math/lerp.glsl)
  vec3 green = mix(vec3(0.012, 0.045, 0.006), vec3(0.16, 0.32, 0.045), along);
  // own: tile_random_hsv (tiles/tile_random_hsv.glsl)
  vec3 own = flower_field_varied_own(tile.seed, flower_field_tile_near(uv_dx, uv_dy), green);
  // color: rgba (channels/rgba.glsl)
  vec4 color = vec4(own, shape);
  return color;
}

// paint_grass, of bomb (bombing/bomb.glsl)
vec4 flower_field_paint_grass(flower_field_Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = flower_field_pose_of_grass(copy);
  vec2 tile_local_dx, tile_local_dy;
  vec2 arm_of_value = flower_field_arm_of(copy, pose, copy_from_dx, copy_from_dy, tile_local_dx,
      tile_local_dy);
  flower_field_Tile tile = flower_field_Tile(copy.seed);
  vec4 seen = flower_field_blade(arm_of_value + 0.5, tile, tile_local_dx, tile_local_dy);
  return seen;
}

// by_rank_grass, of bomb (bombing/bomb.glsl)
flower_field_View flower_field_by_rank_grass(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    flower_field_Copy copy;
    flower_field_find_next_grass(p, low, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = flower_field_paint_grass(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return flower_field_View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 flower_field_bomb_grass(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 24.0 - 0.5;
  vec2 low = p - 0.5;
  vec2 p_dx = uv_dx * 24.0;
  vec2 p_dy = uv_dy * 24.0;
  flower_field_View view = flower_field_by_rank_grass(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

// copy_at_low, of bomb (bombing/bomb.glsl)
flower_field_Copy flower_field_copy_at_low(vec2 p, vec2 node, int index) {
  ivec2 numbers = ivec2(node);
  ivec2 numbers2 = ivec2(flower_field_wrap_cell_grass(numbers.x, 15),
      flower_field_wrap_cell_grass(numbers.y, 15));
  uvec4 bits = flower_field_copy_bits(numbers2, index, 2);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  flower_field_Copy copy = flower_field_Copy(bits.w, bits.z, p - node - moved);
  return copy;
}

// pose_of_low, of bomb (bombing/bomb.glsl)
vec2 flower_field_pose_of_low(flower_field_Copy copy) {
  uint hash_value = flower_field_hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(0.5, 0.85, luck.x), mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// is_there_low, of bomb (bombing/bomb.glsl)
bool flower_field_is_there_low(flower_field_Copy copy, vec2 p) {
  vec2 center = p - copy.from;
  float value = textureGrad(beds, (center + 0.5) / 15.0, vec2(0.0), vec2(0.0)).x;
  float chance = value * small;
  bool test = float(flower_field_hash(copy.seed - 3u) >> 8u) * 5.9604645e-8 < chance;
  bool stays = chance >= 1.0 || test;
  return stays;
}

// find_next_low, of bomb (bombing/bomb.glsl)
void flower_field_find_next_low(vec2 p, vec2 low, uint last, out uint last_out,
    out flower_field_Copy found) {
  flower_field_Copy found2 = flower_field_Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 4; ++i) {
    vec2 node = floor(low) + vec2(ivec2(i % 2, i / 2));
    for (int index = 0; index < 2; ++index) {
      flower_field_Copy copy = flower_field_copy_at_low(p, node, index);
      vec2 pose = flower_field_pose_of_low(copy);
      uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25 * pose.x * pose.x));
      bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
      bool test = is_next && flower_field_is_there_low(copy, p);
      found2 = test ? copy : found2;
      best = test ? copy.luck : best;
    }
  }
  last_out = best;
  found = found2;
}

// choice, of tile_weighted_choice (tiles/tile_weighted_choice.glsl)
int flower_field_choice(uint seed) {
  float place = float(flower_field_hash(seed) >> 8u) * 5.9604645e-8 * 7.0;
  return int(place >= 5.0);
}

// paint_low, of bomb (bombing/bomb.glsl)
vec4 flower_field_paint_low(flower_field_Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = flower_field_pose_of_low(copy);
  vec2 result_dx, result_dy;
  vec2 arm_of_value = flower_field_arm_of(copy, pose, copy_from_dx, copy_from_dy, result_dx,
      result_dy);
  vec3 vector = vec3(arm_of_value + 0.5, float(flower_field_choice(copy.seed)));
  vec4 seen = textureGrad(flowers, vector, result_dx, result_dy);
  return seen;
}

// by_rank_low, of bomb (bombing/bomb.glsl)
flower_field_View flower_field_by_rank_low(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    flower_field_Copy copy;
    flower_field_find_next_low(p, low, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = flower_field_paint_low(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return flower_field_View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 flower_field_bomb_low(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 15.0 - 0.5;
  vec2 low = p + 0.07499999;
  vec2 p_dx = uv_dx * 15.0;
  vec2 p_dy = uv_dy * 15.0;
  flower_field_View view = flower_field_by_rank_low(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

// copy_at_middle, of bomb (bombing/bomb.glsl)
flower_field_Copy flower_field_copy_at_middle(vec2 p, vec2 node, int index) {
  ivec2 numbers = ivec2(node);
  ivec2 numbers2 = ivec2(flower_field_wrap_cell_grass(numbers.x, 12),
      flower_field_wrap_cell_grass(numbers.y, 12));
  uvec4 bits = flower_field_copy_bits(numbers2, index, 3);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  flower_field_Copy copy = flower_field_Copy(bits.w, bits.z, p - node - moved);
  return copy;
}

// pose_of_middle, of bomb (bombing/bomb.glsl)
vec2 flower_field_pose_of_middle(flower_field_Copy copy) {
  uint hash_value = flower_field_hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(0.7, 1.0, luck.x), mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// is_there_middle, of bomb (bombing/bomb.glsl)
bool flower_field_is_there_middle(flower_field_Copy copy, vec2 p) {
  vec2 center = p - copy.from;
  float value = textureGrad(beds, (center + 0.5) / 12.0, vec2(0.0), vec2(0.0)).z;
  float chance = value * tall;
  bool test = float(flower_field_hash(copy.seed - 3u) >> 8u) * 5.9604645e-8 < chance;
  bool stays = chance >= 1.0 || test;
  return stays;
}

// find_next_middle, of bomb (bombing/bomb.glsl)
void flower_field_find_next_middle(vec2 p, uint last, out uint last_out,
    out flower_field_Copy found) {
  flower_field_Copy found2 = flower_field_Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 4; ++i) {
    vec2 node = floor(p) + vec2(ivec2(i % 2, i / 2));
    for (int index = 0; index < 2; ++index) {
      flower_field_Copy copy = flower_field_copy_at_middle(p, node, index);
      vec2 pose = flower_field_pose_of_middle(copy);
      uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25 * pose.x * pose.x));
      bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
      bool test = is_next && flower_field_is_there_middle(copy, p);
      found2 = test ? copy : found2;
      best = test ? copy.luck : best;
    }
  }
  last_out = best;
  found = found2;
}

// varied_own, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 flower_field_varied_own2(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), flower_field_random3(seed), near);
  vec3 one = flower_field_hsv_adjust(color, mix(-12.0, 14.0, luck.x), 1.0, mix(0.8, 1.2, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.99144197), one, near);
}

// paint_middle, of bomb (bombing/bomb.glsl)
vec4 flower_field_paint_middle(flower_field_Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = flower_field_pose_of_middle(copy);
  vec2 tile_local_dx, tile_local_dy;
  vec2 arm_of_value = flower_field_arm_of(copy, pose, copy_from_dx, copy_from_dy, tile_local_dx,
      tile_local_dy);
  vec4 texel = textureGrad(flowers, vec3(arm_of_value + 0.5, 3.0), tile_local_dx, tile_local_dy);
  vec3 varied_own_value = flower_field_varied_own2(copy.seed,
      flower_field_tile_near(tile_local_dx, tile_local_dy), texel.xyz);
  vec4 seen = vec4(varied_own_value, texel.w);
  return seen;
}

// by_rank_middle, of bomb (bombing/bomb.glsl)
flower_field_View flower_field_by_rank_middle(vec2 p, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    flower_field_Copy copy;
    flower_field_find_next_middle(p, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = flower_field_paint_middle(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return flower_field_View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 flower_field_bomb_middle(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 12.0 - 0.5;
  vec2 p_dx = uv_dx * 12.0;
  vec2 p_dy = uv_dy * 12.0;
  flower_field_View view = flower_field_by_rank_middle(p, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

// copy_at_high, of bomb (bombing/bomb.glsl)
flower_field_Copy flower_field_copy_at_high(vec2 p, vec2 node, int index) {
  ivec2 numbers = ivec2(node);
  ivec2 numbers2 = ivec2(flower_field_wrap_cell_grass(numbers.x, 10),
      flower_field_wrap_cell_grass(numbers.y, 10));
  uvec4 bits = flower_field_copy_bits(numbers2, index, 4);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  flower_field_Copy copy = flower_field_Copy(bits.w, bits.z, p - node - moved);
  return copy;
}

// pose_of_high, of bomb (bombing/bomb.glsl)
vec2 flower_field_pose_of_high(flower_field_Copy copy) {
  uint hash_value = flower_field_hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(0.7, 1.1, luck.x), mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// is_there_high, of bomb (bombing/bomb.glsl)
bool flower_field_is_there_high(flower_field_Copy copy, vec2 p) {
  vec2 center = p - copy.from;
  float value = textureGrad(beds, (center + 0.5) / 10.0, vec2(0.0), vec2(0.0)).y;
  float chance = value * tall;
  bool test = float(flower_field_hash(copy.seed - 3u) >> 8u) * 5.9604645e-8 < chance;
  bool stays = chance >= 1.0 || test;
  return stays;
}

// find_next_high, of bomb (bombing/bomb.glsl)
void flower_field_find_next_high(vec2 p, vec2 low, uint last, out uint last_out,
    out flower_field_Copy found) {
  flower_field_Copy found2 = flower_field_Copy(0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 9; ++i) {
    vec2 node = floor(low) + vec2(ivec2(i % 3, i / 3));
    for (int index = 0; index < 2; ++index) {
      flower_field_Copy copy = flower_field_copy_at_high(p, node, index);
      vec2 pose = flower_field_pose_of_high(copy);
      uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25 * pose.x * pose.x));
      bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
      bool test = is_next && flower_field_is_there_high(copy, p);
      found2 = test ? copy : found2;
      best = test ? copy.luck : best;
    }
  }
  last_out = best;
  found = found2;
}

// varied_own, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 flower_field_varied_own3(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), flower_field_random3(seed), near);
  vec3 one = flower_field_hsv_adjust(color, mix(-5.0, 4.0, luck.x), 1.0, mix(0.75, 1.15, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.99897224), one, near);
}

// paint_high, of bomb (bombing/bomb.glsl)
vec4 flower_field_paint_high(flower_field_Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = flower_field_pose_of_high(copy);
  vec2 tile_local_dx, tile_local_dy;
  vec2 arm_of_value = flower_field_arm_of(copy, pose, copy_from_dx, copy_from_dy, tile_local_dx,
      tile_local_dy);
  vec4 texel = textureGrad(flowers, vec3(arm_of_value + 0.5, 2.0), tile_local_dx, tile_local_dy);
  vec3 varied_own_value = flower_field_varied_own3(copy.seed,
      flower_field_tile_near(tile_local_dx, tile_local_dy), texel.xyz);
  vec4 seen = vec4(varied_own_value, texel.w);
  return seen;
}

// by_rank_high, of bomb (bombing/bomb.glsl)
flower_field_View flower_field_by_rank_high(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    flower_field_Copy copy;
    flower_field_find_next_high(p, low, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = flower_field_paint_high(copy, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return flower_field_View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 flower_field_bomb_high(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 10.0 - 0.5;
  vec2 low = p - 0.049999952;
  vec2 p_dx = uv_dx * 10.0;
  vec2 p_dy = uv_dy * 10.0;
  flower_field_View view = flower_field_by_rank_high(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

vec4 flower_field(vec2 uv) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // clouds: fbm (noise/fbm.glsl)
  float clouds_dx, clouds_dy;
  float clouds = flower_field_fbm(uv, uv_dx, uv_dy, clouds_dx, clouds_dy);
  // soil: color_ramp (color/color_ramp.glsl)
  vec4 soil = flower_field_color_ramp(clouds, clouds_dx, clouds_dy);
  // grass: bomb (bombing/bomb.glsl)
  vec4 grass_color = flower_field_bomb_grass(uv, soil, uv_dx, uv_dy);
  // low: bomb (bombing/bomb.glsl)
  vec4 low_color = flower_field_bomb_low(uv, grass_color, uv_dx, uv_dy);
  // middle: bomb (bombing/bomb.glsl)
  vec4 middle_color = flower_field_bomb_middle(uv, low_color, uv_dx, uv_dy);
  // high: bomb (bombing/bomb.glsl)
  vec4 high_color = flower_field_bomb_high(uv, middle_color, uv_dx, uv_dy);
  return high_color;
}
