// lily_pond: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform vec3 water;  // default vec3(0.012, 0.05, 0.055)

// Outputs
layout(location = 0) out vec4 out_color;

// Types
struct Tile {
  uint seed;
};
struct Copy {
  ivec2 cell;
  int index;
  uint seed;
  uint luck;
  vec2 from;
};
struct View {
  vec3 light;
  float through;
};

// Constants
const vec2 points[3] = vec2[3](vec2(0.4, 0.0), vec2(0.6, 0.35), vec2(0.7, 1.0));
const vec2 points2[3] = vec2[3](vec2(0.3, 0.05), vec2(0.42, 0.7), vec2(0.52, 1.0));
const float stops[4] = float[4](0.0, 0.22, 0.34, 1.0);
const vec4 colors[4] = vec4[4](vec4(0.95, 0.65, 0.05, 1.0), vec4(0.95, 0.6, 0.1, 1.0),
    vec4(0.75, 0.2, 0.35, 1.0), vec4(0.95, 0.75, 0.82, 1.0));
const vec3 colors2[4] = vec3[4](vec3(0.09, 0.25, 0.05), vec3(0.13, 0.3, 0.04),
    vec3(0.06, 0.2, 0.06), vec3(0.2, 0.3, 0.05));

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

// gradient_noise (noise/gradient_noise.glsl)
float gradient_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
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
  uint sum2 = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = uv_dx.x * x + uv_dx.y * y;
  vec4 corners_dy = uv_dy.x * x + uv_dy.y * y;
  vec2 fade_dx = uv_dx * fade_slope;
  vec2 fade_dy = uv_dy * fade_slope;
  vec2 blend2 = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum3 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum4 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend2.y - blend2.x;
  result_dx = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dx.y) * 0.9340967;
  result_dy = (mix(sum4.x, sum4.y, fade.y) + difference3 * fade_dy.y) * 0.9340967;
  return mix(blend2.x, blend2.y, fade.y) * 0.9340967 + 0.5;
}

// fbm (noise/fbm.glsl)
float fbm_waves(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * vec2(3.0, 9.0);
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * vec2(3.0, 9.0);
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * vec2(3.0, 9.0);
  vec2 p_dy = uv_dy * vec2(3.0, 9.0);
  float weight = 0.516129;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 5; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_value = gradient_noise(p * frequency + shift, p_dx * frequency,
          p_dy * frequency, result_dx2, result_dy2);
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

// slope_at_sky, of curve (math/curve.glsl)
float slope_at_sky(int i) {
  return i == 1 ? 3.4999995 : i == 0 ? 0.0 : 8.083336;
}

// part_mean_sky, of curve (math/curve.glsl)
float part_mean_sky(int i, float middle, float reach) {
  vec2 from = points[clamp(i, 0, 2)];
  int sum = i + 1;
  vec2 to = points[clamp(sum, 0, 2)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * slope_at_sky(i) - rise;
  float end = rise - way * slope_at_sky(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float curve_sky(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp((0.4 - value) / width + 0.5, 0.0, 1.0);
  float sum = 0.0;
  for (int i = 0; i < 2; ++i) {
    float next = clamp((points[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * part_mean_sky(i, middle, reach);
  }
  return sum + (1.0 - below);
}

// node_at_pads, of bomb (bombing/bomb.glsl)
vec2 node_at_pads(vec2 low, int number) {
  vec2 node = vec2(ivec2(number % 2, number / 2));
  float sum = node.y + floor(low.y);
  float whole = floor(low.x + 0.5 * float(int(sum) & 1));
  node = vec2(node.x + whole, sum);
  return node;
}

// copy_bits (bombing/copy_bits.glsl)
uvec4 copy_bits(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(2055130248u, 2047839475u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at, of bomb (bombing/bomb.glsl)
Copy copy_at(vec2 p, vec2 node) {
  ivec2 numbers = ivec2(node);
  uvec4 bits = copy_bits(numbers);
  vec2 middle = vec2(node.x - 0.5 * float(int(node.y) & 1), node.y);
  vec2 moved = vec2(1.0, 0.8660254) * (vec2(ivec2(bits.xy)) * 1.8626452e-10);
  Copy copy = Copy(numbers, 0, bits.w, bits.z, p - vec2(1.0, 0.8660254) * middle - moved);
  return copy;
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// fbm (noise/fbm.glsl)
float fbm_hills(vec2 uv, out float result_dx, out float result_dy) {
  vec2 p = uv * 2.5;
  float weight = 0.6666667;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 2; ++octave) {
    float result_dx2, result_dy2;
    float gradient_noise_value = gradient_noise(p * frequency + shift, vec2(0.0), vec2(0.0),
        result_dx2, result_dy2);
    frequency *= 2.0;
    shift += 37.7;
    sum += weight * (gradient_noise_value - 0.5);
    sum_dx += result_dx2 * weight;
    sum_dy += result_dy2 * weight;
    weight *= 0.5;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// slope_at_depth, of curve (math/curve.glsl)
float slope_at_depth(int i) {
  return i == 1 ? 4.0984855 : i == 0 ? 6.7348495 : 1.901515;
}

// part_mean_depth, of curve (math/curve.glsl)
float part_mean_depth(int i, float middle, float reach) {
  vec2 from = points2[clamp(i, 0, 2)];
  int sum = i + 1;
  vec2 to = points2[clamp(sum, 0, 2)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * slope_at_depth(i) - rise;
  float end = rise - way * slope_at_depth(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float curve_depth(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp((0.3 - value) / width + 0.5, 0.0, 1.0);
  float sum = 0.05 * below;
  for (int i = 0; i < 2; ++i) {
    float next = clamp((points2[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * part_mean_depth(i, middle, reach);
  }
  return sum + (1.0 - below);
}

// pose_of, of bomb (bombing/bomb.glsl)
vec2 pose_of(Copy copy, vec2 p) {
  vec2 place = (p - copy.from + vec2(0.5, 0.4330127)) / 9.0;
  uint hash_value = hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float result_dx, result_dy;
  float fbm_hills_value = fbm_hills(place, result_dx, result_dy);
  float curve_depth_value = curve_depth(fbm_hills_value, result_dx, result_dy);
  float blend2 = mix(0.3, 0.84, curve_depth_value < 0.0 ? luck.x : min(curve_depth_value, 1.0));
  return vec2(blend2, mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// node_at_pads, of bomb (bombing/bomb.glsl)
vec2 node_at_pads2(vec2 low, int number) {
  vec2 node = vec2(ivec2(number % 3, number / 3));
  float sum = node.y + floor(low.y);
  float whole = floor(low.x + 0.5 * float(int(sum) & 1));
  node = vec2(node.x + whole, sum);
  return node;
}

// copy_at, of bomb (bombing/bomb.glsl)
Copy copy_at2(vec2 p, vec2 node) {
  ivec2 numbers = ivec2(node);
  uvec4 bits = copy_bits(numbers);
  vec2 middle = vec2(node.x - 0.5 * float(int(node.y) & 1), node.y);
  vec2 moved = vec2(1.0, 0.8660254) * (vec2(ivec2(bits.xy)) * 1.8626452e-10);
  Copy copy = Copy(numbers, 0, bits.w, bits.z, p - vec2(1.0, 0.8660254) * middle - moved);
  return copy;
}

// is_crowded, of bomb (bombing/bomb.glsl)
bool is_crowded(Copy copy, vec2 p) {
  vec2 low = p / vec2(1.0, 0.8660254) - vec2(0.24000001, 0.3699484);
  bool is_near = false;
  for (int i = 0; i < 9; ++i) {
    vec2 node = node_at_pads2(low, i);
    Copy other = copy_at2(p, node);
    bool is_other = any(notEqual(other.cell, copy.cell)) || 0 != copy.index;
    bool is_above = copy.luck <= other.luck;
    is_near = (is_above && is_other && dot(other.from, other.from) < 0.70559996) || is_near;
  }
  return is_near;
}

// is_there, of bomb (bombing/bomb.glsl)
bool is_there(Copy copy, vec2 p) {
  vec2 center = p - copy.from;
  float result_dx, result_dy;
  float fbm_hills_value = fbm_hills((center + vec2(0.5, 0.4330127)) / 9.0, result_dx, result_dy);
  float chance = curve_depth(fbm_hills_value, result_dx, result_dy);
  bool test = float(hash(copy.seed - 3u) >> 8u) * 5.9604645e-8 < chance;
  bool stays = chance >= 1.0 || test;
  stays = stays ? !is_crowded(copy, center) : false;
  return stays;
}

// find_next, of bomb (bombing/bomb.glsl)
void find_next(vec2 p, vec2 low, uint last, out uint last_out, out Copy found) {
  Copy found2 = Copy(ivec2(0), 0, 0u, 0u, p);
  uint best = 0u;
  for (int i = 0; i < 4; ++i) {
    vec2 node = node_at_pads(low, i);
    Copy copy = copy_at(p, node);
    vec2 pose = pose_of(copy, p);
    uvec2 away = floatBitsToUint(vec2(dot(copy.from, copy.from), 0.25 * pose.x * pose.x));
    bool is_next = all(lessThan(uvec3(best, copy.luck, away.x), uvec3(copy.luck, last, away.y)));
    bool test = is_next && is_there(copy, p);
    found2 = test ? copy : found2;
    best = test ? copy.luck : best;
  }
  last_out = best;
  found = found2;
}

// part_mean_depth, of curve (math/curve.glsl)
float part_mean_depth2(int i, float middle, float reach, float middle_dx, float middle_dy,
    float reach_dx, float reach_dy, out float result_dx, out float result_dy) {
  vec2 from = points2[clamp(i, 0, 2)];
  int sum = i + 1;
  vec2 to = points2[clamp(sum, 0, 2)];
  float way = max(to.x - from.x, 1e-7);
  float ratio = (middle - from.x) / way;
  float t = clamp(ratio, 0.0, 1.0);
  bool test = ratio < 0.0;
  bool test2 = ratio > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : middle_dx / way;
  float t_dy = test ? 0.0 : test2 ? 0.0 : middle_dy / way;
  float rise = to.y - from.y;
  float start = way * slope_at_depth(i) - rise;
  float product = way * slope_at_depth(sum);
  float end = rise - product;
  float product2 = 6.0 * t;
  float bend = (product2 - 4.0) * start + (2.0 - product2) * end;
  float bend_slope = start + (product - rise);
  float part = reach / way;
  float part_dx = reach_dx / way;
  float part_dy = reach_dy / way;
  float difference = 1.0 - t;
  float product3 = t * difference;
  float blend2 = mix(start, end, t);
  float sum2 = rise + ((difference - t) * blend2 + product3 * (end - start));
  float product4 = bend * part;
  float bend_dx = t_dx * 6.0 * bend_slope;
  float bend_dy = t_dy * 6.0 * bend_slope;
  result_dx = t_dx * sum2 + ((bend_dx * part + bend * part_dx) * part + product4 * part_dx) / 6.0;
  result_dy = t_dy * sum2 + ((bend_dy * part + bend * part_dy) * part + product4 * part_dy) / 6.0;
  return from.y + rise * t + product3 * blend2 + product4 * part / 6.0;
}

// curve (math/curve.glsl)
float curve_depth2(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float ratio = -value_dx / width;
  float ratio2 = -value_dy / width;
  float sum2 = (0.3 - value) / width + 0.5;
  float below = clamp(sum2, 0.0, 1.0);
  bool test = sum2 < 0.0;
  bool test2 = sum2 > 1.0;
  float below_dx = test ? 0.0 : test2 ? 0.0 : ratio;
  float below_dy = test ? 0.0 : test2 ? 0.0 : ratio2;
  float sum = 0.05 * below;
  float sum_dx = below_dx * 0.05;
  float sum_dy = below_dy * 0.05;
  for (int i = 0; i < 2; ++i) {
    float sum3 = (points2[i + 1].x - value) / width + 0.5;
    float next = clamp(sum3, 0.0, 1.0);
    bool test3 = sum3 < 0.0;
    bool test4 = sum3 > 1.0;
    float next_dx = test3 ? 0.0 : test4 ? 0.0 : ratio;
    float next_dy = test3 ? 0.0 : test4 ? 0.0 : ratio2;
    float reach_slope = width * 0.5;
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float middle_dx = value_dx + (below_dx + next_dx) * reach_slope;
    float middle_dy = value_dy + (below_dy + next_dy) * reach_slope;
    float difference = next - below;
    float difference2 = next_dx - below_dx;
    float difference3 = next_dy - below_dy;
    float reach = 0.5 * difference * width;
    float reach_dx = difference2 * reach_slope;
    float reach_dy = difference3 * reach_slope;
    float result_dx2, result_dy2;
    float part_mean_depth_value = part_mean_depth2(i, middle, reach, middle_dx, middle_dy, reach_dx,
        reach_dy, result_dx2, result_dy2);
    below = next;
    sum += difference * part_mean_depth_value;
    below_dx = next_dx;
    below_dy = next_dy;
    sum_dx += difference2 * part_mean_depth_value + difference * result_dx2;
    sum_dy += difference3 * part_mean_depth_value + difference * result_dy2;
  }
  result_dx = sum_dx - below_dx;
  result_dy = sum_dy - below_dy;
  return sum + (1.0 - below);
}

// pose_of, of bomb (bombing/bomb.glsl)
vec2 pose_of2(Copy copy, vec2 p, out vec2 result_dx, out vec2 result_dy) {
  vec2 place = (p - copy.from + vec2(0.5, 0.4330127)) / 9.0;
  uint hash_value = hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  float result_dx2, result_dy2;
  float fbm_hills_value = fbm_hills(place, result_dx2, result_dy2);
  float result_dx3, result_dy3;
  float curve_depth_value = curve_depth2(fbm_hills_value, result_dx2, result_dy2, result_dx3,
      result_dy3);
  bool test = curve_depth_value < 0.0;
  bool test2 = curve_depth_value > 1.0;
  float blend2 = mix(0.3, 0.84, test ? luck.x : min(curve_depth_value, 1.0));
  result_dx = vec2((test ? 0.0 : test2 ? 0.0 : result_dx3) * 0.53999996, 0.0);
  result_dy = vec2((test ? 0.0 : test2 ? 0.0 : result_dy3) * 0.53999996, 0.0);
  return vec2(blend2, mix(-180.0, 180.0, luck.y) * 0.017453292);
}

// from_segment, of sdf_triangle (shapes/sdf_triangle.glsl)
float from_segment(vec2 p, vec2 a, vec2 b, vec2 p_dx, vec2 p_dy, out float result_dx,
    out float result_dy) {
  float edge_length = distance(a, b);
  vec2 along = (b - a) / max(edge_length, 1e-20);
  float place = dot(p - a, along);
  bool test = place > 0.0;
  float choice, choice2, choice3;
  if (test && place < edge_length) {
    float side = (p.x - a.x) * along.y - (p.y - a.y) * along.x;
    float side_dx = p_dx.x * along.y - p_dx.y * along.x;
    float side_dy = p_dy.x * along.y - p_dy.y * along.x;
    float choice4 = side < 0.0 ? -1.0 : 1.0;
    choice = side * choice4;
    choice2 = side_dx * choice4;
    choice3 = side_dy * choice4;
  } else {
    vec2 difference = p - (test ? b : a);
    choice = length(difference);
    float greatest = max(choice, 1e-20);
    choice2 = dot(difference, p_dx) / greatest;
    choice3 = dot(difference, p_dy) / greatest;
  }
  result_dx = choice2;
  result_dy = choice3;
  return choice;
}

// right_of, of sdf_triangle (shapes/sdf_triangle.glsl)
float right_of(vec2 p, vec2 a, vec2 b) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// sdf_triangle (shapes/sdf_triangle.glsl)
float sdf_triangle(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  float result_dx2, result_dy2;
  float from_segment_value = from_segment(uv, vec2(0.5, 0.47), vec2(0.4, -0.1), uv_dx, uv_dy,
      result_dx2, result_dy2);
  float result_dx3, result_dy3;
  float from_segment_value2 = from_segment(uv, vec2(0.4, -0.1), vec2(0.6, -0.1), uv_dx, uv_dy,
      result_dx3, result_dy3);
  float result_dx4, result_dy4;
  float from_segment_value3 = from_segment(uv, vec2(0.6, -0.1), vec2(0.5, 0.47), uv_dx, uv_dy,
      result_dx4, result_dy4);
  float least = min(from_segment_value2, from_segment_value3);
  bool test = from_segment_value3 < from_segment_value2;
  float outline = min(from_segment_value, least);
  bool test2 = least < from_segment_value;
  float outline_dx = test2 ? (test ? result_dx4 : result_dx3) : result_dx2;
  float outline_dy = test2 ? (test ? result_dy4 : result_dy3) : result_dy2;
  float negative = -right_of(uv, vec2(0.4, -0.1), vec2(0.6, -0.1));
  float least2 = min(negative, -right_of(uv, vec2(0.6, -0.1), vec2(0.5, 0.47)));
  float inside = min(-right_of(uv, vec2(0.5, 0.47), vec2(0.4, -0.1)), least2);
  bool test3 = inside > 0.0;
  result_dx = test3 ? -outline_dx : outline_dx;
  result_dy = test3 ? -outline_dy : outline_dy;
  return test3 ? -outline : outline;
}

// sdf_smooth_union (shapes/sdf_smooth_union.glsl)
float sdf_smooth_union(float a, float b, float a_dx, float a_dy, float b_dx, float b_dy,
    out float result_dx, out float result_dy) {
  float sum = 0.5 + 0.5 * (b - a) / 0.04;
  float t = clamp(sum, 0.0, 1.0);
  bool test = sum < 0.0;
  bool test2 = sum > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : (b_dx - a_dx) * 0.5 / 0.04;
  float t_dy = test ? 0.0 : test2 ? 0.0 : (b_dy - a_dy) * 0.5 / 0.04;
  float difference = a - b;
  float difference2 = 1.0 - t;
  float sum2 = 0.04 * difference2 + t * -0.04;
  result_dx = mix(b_dx, a_dx, t) + difference * t_dx - t_dx * sum2;
  result_dy = mix(b_dy, a_dy, t) + difference * t_dy - t_dy * sum2;
  return mix(b, a, t) - 0.04 * t * difference2;
}

// sdf_fill (shapes/sdf_fill.glsl)
float sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// spread_range (math/spread_range.glsl)
float spread_range(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(0.5 - value / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - value) / width, 0.0, 1.0);
  float middle = value + 0.5 * width * (below - above);
  return above + (1.0 - below - above) * clamp(middle, 0.0, 1.0);
}

// gradient_radial (patterns/gradient_radial.glsl)
float gradient_radial(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - 0.5;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float ratio = dot(difference, uv_dx) / greatest / 0.47;
  return spread_range(norm / 0.47, ratio, dot(difference, uv_dy) / greatest / 0.47);
}

// triangle_wave (math/triangle_wave.glsl)
float triangle_wave(float phase, float phase_dx, float phase_dy) {
  float width = max(sqrt(phase_dx * phase_dx + phase_dy * phase_dy), 1e-7);
  float from_top = abs(fract(phase) - 0.5);
  float choice;
  if (width < 0.5) {
    float away = min(from_top, 0.5 - from_top);
    float beyond = max(0.5 * width - away, 0.0);
    float rounded = away + beyond * beyond / width;
    float product = 2.0 * rounded;
    choice = from_top < 0.25 ? 1.0 - product : product;
  } else {
    float product = 0.5 * width;
    float low = fract(phase - product) - 0.5;
    float high = fract(phase + product) - 0.5;
    vec2 place = vec2(low, high);
    vec2 integral = place * (0.5 - abs(place));
    choice = 0.5 + (integral.y - integral.x) / width;
  }
  return choice;
}

// gradient_angular (patterns/gradient_angular.glsl)
float gradient_angular(vec2 uv, int count, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv - 0.5;
  bool test = p.x == 0.0;
  float choice = test ? 1e-20 : p.x;
  float greatest = max(p.y * p.y + choice * choice, 1e-20);
  float turns = atan(p.y, choice) * 0.15915494;
  float phase = turns * float(count);
  float phase_slope = 0.15915494 * float(count);
  float phase_dx = (choice * uv_dx.y - p.y * (test ? 0.0 : uv_dx.x)) / greatest * phase_slope;
  float phase_dy = (choice * uv_dy.y - p.y * (test ? 0.0 : uv_dy.x)) / greatest * phase_slope;
  return triangle_wave(phase, phase_dx, phase_dy);
}

// smooth_step (math/smooth_step.glsl)
float smooth_step_vein(float value) {
  float t = clamp(value / 0.22, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// smooth_step (math/smooth_step.glsl)
float smooth_step_rim(float value) {
  float t = clamp((value + 0.035) / 0.030000001, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// sdf_star (shapes/sdf_star.glsl)
float sdf_star(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv - 0.5;
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - 1.5707964;
  float toward = 1.5707964 + 0.7853982 * floor(turned / 0.7853982 + 0.5);
  float cosine = cos(toward);
  float sine = sin(toward);
  vec2 ahead = vec2(cosine, sine);
  float from_axis = p.y * cosine - p.x * sine;
  float from_axis_dx = uv_dx.y * cosine - uv_dx.x * sine;
  float from_axis_dy = uv_dy.y * cosine - uv_dy.x * sine;
  float projection = dot(uv_dx, ahead);
  float projection2 = dot(uv_dy, ahead);
  float difference = dot(p, ahead) - 0.24;
  float choice = from_axis < 0.0 ? -1.0 : 1.0;
  float product = from_axis * choice;
  vec2 q = vec2(difference, product);
  float product2 = from_axis_dx * choice;
  float product3 = from_axis_dy * choice;
  vec2 q_dx = vec2(projection, product2);
  vec2 q_dy = vec2(projection2, product3);
  float side = difference * 0.3832517 - product * -0.9236438;
  float side_dx = projection * 0.3832517 - product2 * -0.9236438;
  float side_dy = projection2 * 0.3832517 - product3 * -0.9236438;
  float place = dot(q, vec2(-0.9236438, 0.3832517));
  bool test = place > 0.0;
  if (!(test && place < 0.12980725)) {
    vec2 choice2 = test ? q - vec2(-0.11989567, 0.04974885) : q;
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

// spread_range (math/spread_range.glsl)
float spread_range2(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float difference = 0.5 - value / width;
  float below = clamp(difference, 0.0, 1.0);
  bool test = difference < 0.0;
  bool test2 = difference > 1.0;
  float below_dx = test ? 0.0 : test2 ? 0.0 : -(value_dx / width);
  float below_dy = test ? 0.0 : test2 ? 0.0 : -(value_dy / width);
  float difference2 = 0.5 - (1.0 - value) / width;
  float above = clamp(difference2, 0.0, 1.0);
  bool test3 = difference2 < 0.0;
  bool test4 = difference2 > 1.0;
  float above_dx = test3 ? 0.0 : test4 ? 0.0 : -(-value_dx / width);
  float above_dy = test3 ? 0.0 : test4 ? 0.0 : -(-value_dy / width);
  float product = 0.5 * width;
  float middle = value + product * (below - above);
  float middle_dx = value_dx + (below_dx - above_dx) * product;
  float middle_dy = value_dy + (below_dy - above_dy) * product;
  float difference3 = 1.0 - below - above;
  float clamped = clamp(middle, 0.0, 1.0);
  bool test5 = middle < 0.0;
  bool test6 = middle > 1.0;
  float sum = (-below_dx - above_dx) * clamped
      + difference3 * (test5 ? 0.0 : test6 ? 0.0 : middle_dx);
  float sum2 = (-below_dy - above_dy) * clamped
      + difference3 * (test5 ? 0.0 : test6 ? 0.0 : middle_dy);
  result_dx = above_dx + sum;
  result_dy = above_dy + sum2;
  return above + difference3 * clamped;
}

// gradient_radial (patterns/gradient_radial.glsl)
float gradient_radial2(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 difference = uv - 0.5;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float result_dx2, result_dy2;
  float spread_range_value = spread_range2(norm / 0.24, dot(difference, uv_dx) / greatest / 0.24,
      dot(difference, uv_dy) / greatest / 0.24, result_dx2, result_dy2);
  result_dx = result_dx2;
  result_dy = result_dy2;
  return spread_range_value;
}

// part_mean, of color_ramp (color/color_ramp.glsl)
vec4 part_mean(vec4 from, vec4 to, float middle, float reach) {
  float square = reach * reach;
  float variance = square / 3.0;
  vec4 color = mix(from, to, middle);
  vec3 sum = color.xyz * color.w + (to.xyz - from.xyz) * ((to.w - from.w) * variance);
  return vec4(sum, color.w);
}

// color_ramp (color/color_ramp.glsl)
vec4 color_ramp(float position, float position_dx, float position_dy) {
  float width = max(sqrt(position_dx * position_dx + position_dy * position_dy), 1e-7);
  float below = clamp(-position / width + 0.5, 0.0, 1.0);
  vec4 sum = vec4(0.95, 0.65, 0.05, 1.0) * below;
  for (int i = 0; i < 3; ++i) {
    int sum2 = i + 1;
    float item = stops[sum2];
    float next = clamp((item - position) / width + 0.5, 0.0, 1.0);
    float item2 = stops[i];
    float part = 1.0 / max(item - item2, 1e-7);
    float middle = position + width * (0.5 * (below + next) - 0.5) - item2;
    float difference = next - below;
    float least = min(0.5 * difference * width * part, 0.5);
    vec4 part_mean_value = part_mean(colors[i], colors[sum2], clamp(middle * part, 0.0, 1.0),
        least);
    below = next;
    sum += difference * part_mean_value;
  }
  sum += (1.0 - below) * vec4(0.95, 0.75, 0.82, 1.0);
  vec3 choice = vec3(0.95, 0.75, 0.82);
  if (sum.w > 0.0) {
    choice = sum.xyz / max(sum.w, 1e-20);
  }
  return vec4(choice, sum.w);
}

// threshold (math/threshold.glsl)
float threshold(float value) {
  return clamp((value - 0.72) / 1e-7 + 0.5, 0.0, 1.0);
}

// blend (layers/blend.glsl)
vec4 blend(vec4 foreground, vec4 background, float opacity) {
  float front = foreground.w * opacity;
  float both = mix(background.w, 1.0, front);
  return vec4(mix(background.xyz, foreground.xyz, front / max(both, 1e-20)), both);
}

// pad (function of the graph)
vec4 pad(vec2 uv, Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // disc: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference = uv - 0.5;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  // notch: sdf_triangle (shapes/sdf_triangle.glsl)
  float notch_dx, notch_dy;
  float notch = sdf_triangle(uv, uv_dx, uv_dy, notch_dx, notch_dy);
  // leaf: sdf_smooth_difference (shapes/sdf_smooth_difference.glsl)
  float result_dx, result_dy;
  float sdf_smooth_union_value = sdf_smooth_union(0.47 - norm, notch,
      -(dot(difference, uv_dx) / greatest), -(dot(difference, uv_dy) / greatest), notch_dx,
      notch_dy, result_dx, result_dy);
  float leaf = -sdf_smooth_union_value;
  // inside: sdf_fill (shapes/sdf_fill.glsl)
  float leaf_dx = -result_dx;
  float leaf_dy = -result_dy;
  float inside = sdf_fill(leaf, leaf_dx, leaf_dy);
  // middle: gradient_radial (patterns/gradient_radial.glsl)
  float middle = gradient_radial(uv, uv_dx, uv_dy);
  // rays: gradient_angular (patterns/gradient_angular.glsl)
  float rays = gradient_angular(uv, 11, uv_dx, uv_dy);
  // vein: smooth_step (math/smooth_step.glsl)
  float vein = smooth_step_vein(rays);
  // green: tile_palette (tiles/tile_palette.glsl)
  vec3 green = colors2[int(tile.seed >> 30u)];
  // light: remap (math/remap.glsl)
  float light = mix(1.35, 0.75, middle);
  // lit: multiply (math/multiply.glsl)
  vec3 lit = green * light;
  // veined: lerp (math/lerp.glsl)
  vec3 veined = mix(vec3(0.32, 0.42, 0.16), lit, vein);
  // rim: smooth_step (math/smooth_step.glsl)
  float rim = smooth_step_rim(leaf);
  // leaf_color: lerp (math/lerp.glsl)
  vec3 leaf_color = mix(veined, vec3(0.22, 0.1, 0.05), rim);
  // leaf_part: rgba (channels/rgba.glsl)
  vec4 leaf_part = vec4(leaf_color, inside);
  // star: sdf_star (shapes/sdf_star.glsl)
  float star_dx, star_dy;
  float star = sdf_star(uv, uv_dx, uv_dy, star_dx, star_dy);
  // petals: sdf_fill (shapes/sdf_fill.glsl)
  float petals = sdf_fill(star, star_dx, star_dy);
  // petal_rays: gradient_angular (patterns/gradient_angular.glsl)
  float petal_rays = gradient_angular(uv, 8, uv_dx, uv_dy);
  // petal_from: gradient_radial (patterns/gradient_radial.glsl)
  float petal_from_dx, petal_from_dy;
  float petal_from = gradient_radial2(uv, uv_dx, uv_dy, petal_from_dx, petal_from_dy);
  // petal_tone: color_ramp (color/color_ramp.glsl)
  vec4 petal_tone = color_ramp(petal_from, petal_from_dx, petal_from_dy);
  // petal_edge: remap (math/remap.glsl)
  float petal_edge = mix(0.7, 1.0, petal_rays);
  // petal_shade: brightness_contrast (color/brightness_contrast.glsl)
  vec4 petal_shade = vec4(petal_tone.xyz * petal_edge, petal_tone.w);
  // luck: tile_random (tiles/tile_random.glsl)
  float luck = float(hash(tile.seed + 7u) >> 8u) * 5.9604645e-8;
  // blooms: threshold (math/threshold.glsl)
  float blooms = threshold(luck);
  // shown: multiply (math/multiply.glsl)
  float shown = petals * blooms;
  // whole: blend (layers/blend.glsl)
  vec4 whole = blend(petal_shade, leaf_part, shown);
  return whole;
}

// paint, of bomb (bombing/bomb.glsl)
vec4 paint(Copy copy, vec2 p, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose_dx, pose_dy;
  vec2 pose = pose_of2(copy, p, pose_dx, pose_dy);
  vec2 point = vec2(cos(pose.y));
  vec2 point2 = vec2(sin(pose.y));
  vec2 sum = point * copy_from_dx + point2 * vec2(copy_from_dx.y, -copy_from_dx.x);
  vec2 sum2 = point * copy_from_dy + point2 * vec2(copy_from_dy.y, -copy_from_dy.x);
  vec2 ratio = (point * copy.from + point2 * vec2(copy.from.y, -copy.from.x)) / pose.x;
  bool test = pose.x != 0.0;
  vec2 choice = test ? (sum - ratio * pose_dx.x) / pose.x : vec2(0.0);
  vec2 choice2 = test ? (sum2 - ratio * pose_dy.x) / pose.x : vec2(0.0);
  Tile tile = Tile(copy.seed);
  vec4 seen = pad(ratio + 0.5, tile, choice, choice2);
  return seen;
}

// by_rank, of bomb (bombing/bomb.glsl)
View by_rank(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec4 sum = vec4(0.0);
  float open = 1.0;
  float through = 1.0;
  uint last = 4294967295u;
  for (int layer = 0; layer < 100 && open > 0.001; ++layer) {
    uint last2;
    Copy copy;
    find_next(p, low, last, last2, copy);
    open = 0.0;
    if (last2 > 0u) {
      vec4 seen = paint(copy, p, p_dx, p_dy);
      float part = seen.w * through;
      sum += vec4(seen.xyz, 1.0) * part;
      open = 1.0 - sum.w;
      through = open;
    }
    last = last2;
  }
  return View(sum.xyz, through);
}

// bomb (bombing/bomb.glsl)
vec4 bomb(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 9.0 - vec2(0.5, 0.4330127);
  vec2 low = p / vec2(1.0, 0.8660254) + vec2(0.18, 0.11502576);
  vec2 p_dx = uv_dx * 9.0;
  vec2 p_dy = uv_dy * 9.0;
  View view = by_rank(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // waves: fbm (noise/fbm.glsl)
  float waves_dx, waves_dy;
  float waves = fbm_waves(uv, uv_dx, uv_dy, waves_dx, waves_dy);
  // sky: curve (math/curve.glsl)
  float sky = curve_sky(waves, waves_dx, waves_dy);
  // bright: lerp (math/lerp.glsl)
  vec3 bright = mix(water, vec3(0.16, 0.27, 0.3), sky);
  // surface: rgba (channels/rgba.glsl)
  vec4 surface = vec4(bright, 1.0);
  // pads: bomb (bombing/bomb.glsl)
  vec4 pads_color = bomb(uv, surface, uv_dx, uv_dy);
  out_color = pads_color;
}
