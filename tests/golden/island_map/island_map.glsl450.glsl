// island_map: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float sea_level;  // default 0.36
uniform float relief;  // default 0.28
uniform float lines;  // default 0.45

// Types
struct island_map_Sum {
  float least;
  float terms;
};

// Constants
const vec2 island_map_points[4] = vec2[4](vec2(0.0, 0.75), vec2(0.45, 0.6), vec2(0.8, 0.2),
    vec2(1.0, 0.0));
const float island_map_stops[6] = float[6](0.19, 0.22, 0.48, 0.68, 0.84, 0.96);
const vec4 island_map_colors[6] = vec4[6](vec4(0.62, 0.52, 0.32, 1.0), vec4(0.2, 0.28, 0.07, 1.0),
    vec4(0.09, 0.17, 0.04, 1.0), vec4(0.24, 0.19, 0.1, 1.0), vec4(0.34, 0.31, 0.28, 1.0),
    vec4(0.85, 0.87, 0.9, 1.0));

// hash (random/hash.glsl)
uvec2 island_map_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 island_map_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float island_map_gradient_noise_coast_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * 3.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * 3.0;
  vec2 t_dy = uv_dy * 3.0;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = island_map_hash(uvec2(cell.y, cell.y + 1u) + 1133566046u);
  uvec4 hash_value = island_map_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = t_dx.x * x + t_dx.y * y;
  vec4 corners_dy = t_dy.x * x + t_dy.y * y;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 3.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float amplitude = 0.9340967 * (1.0 - blur);
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum3 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum4 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dx.y) * amplitude;
  result_dy = (mix(sum4.x, sum4.y, fade.y) + difference3 * fade_dy.y) * amplitude;
  return mix(blend.x, blend.y, fade.y) * amplitude + 0.5;
}

// domain_warp (noise/domain_warp.glsl)
vec2 island_map_domain_warp(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx,
    out vec2 result_dy) {
  float result_dx2, result_dy2;
  float gradient_noise_coast_noise_value = island_map_gradient_noise_coast_noise(uv, uv_dx, uv_dy,
      result_dx2, result_dy2);
  float result_dx3, result_dy3;
  float gradient_noise_coast_noise_value2 = island_map_gradient_noise_coast_noise(uv + 37.7, uv_dx,
      uv_dy, result_dx3, result_dy3);
  vec2 place = uv + 0.2 * (2.0 * vec2(gradient_noise_coast_noise_value,
      gradient_noise_coast_noise_value2) - 1.0);
  result_dx = uv_dx + vec2(result_dx2, result_dx3) * 0.4;
  result_dy = uv_dy + vec2(result_dy2, result_dy3) * 0.4;
  return place;
}

// spread_range (math/spread_range.glsl)
float island_map_spread_range(float value, float value_dx, float value_dy, out float result_dx,
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
float island_map_gradient_radial(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 difference = uv - vec2(0.48, 0.52);
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float result_dx2, result_dy2;
  float spread_range_value = island_map_spread_range(norm / 0.46,
      dot(difference, uv_dx) / greatest / 0.46, dot(difference, uv_dy) / greatest / 0.46,
      result_dx2, result_dy2);
  result_dx = result_dx2;
  result_dy = result_dy2;
  return spread_range_value;
}

// secant, of curve (math/curve.glsl)
float island_map_secant(int i) {
  vec2 way = island_map_points[clamp(i + 1, 0, 3)] - island_map_points[clamp(i, 0, 3)];
  return way.y / max(way.x, 1e-7);
}

// slope_at, of curve (math/curve.glsl)
float island_map_slope_at(int i) {
  int middle = clamp(i, 1, 2);
  int difference = middle - 1;
  float before = island_map_secant(difference);
  float behind = island_map_secant(middle);
  float value = island_map_points[middle].x;
  float length_before = max(value - island_map_points[clamp(difference, 0, 3)].x, 1e-7);
  float length_behind = max(island_map_points[middle + 1].x - value, 1e-7);
  float all2 = length_before + length_behind;
  float choice;
  if (i == middle) {
    float parabola = (before * length_behind + behind * length_before) / all2;
    float flatter = min(abs(before), abs(behind));
    choice = (sign(before) + sign(behind)) * min(flatter, 0.5 * abs(parabola));
  } else {
    bool test = i == 0;
    float own = test ? before : behind;
    float share = (test ? length_before : length_behind) / all2;
    float parabola = own + share * (own - (test ? behind : before));
    choice = 0.0;
    if (!(parabola * own <= 0.0)) {
      choice = 2.0 * abs(own) < abs(parabola) ? 2.0 * own : parabola;
    }
  }
  return choice;
}

// part_mean, of curve (math/curve.glsl)
float island_map_part_mean(int i, float middle, float reach, float middle_dx, float middle_dy,
    float reach_dx, float reach_dy, out float result_dx, out float result_dy) {
  vec2 from = island_map_points[clamp(i, 0, 3)];
  int sum = i + 1;
  vec2 to = island_map_points[clamp(sum, 0, 3)];
  float way = max(to.x - from.x, 1e-7);
  float ratio = (middle - from.x) / way;
  float t = clamp(ratio, 0.0, 1.0);
  bool test = ratio < 0.0;
  bool test2 = ratio > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : middle_dx / way;
  float t_dy = test ? 0.0 : test2 ? 0.0 : middle_dy / way;
  float rise = to.y - from.y;
  float start = way * island_map_slope_at(i) - rise;
  float product = way * island_map_slope_at(sum);
  float end = rise - product;
  float product2 = 6.0 * t;
  float bend = (product2 - 4.0) * start + (2.0 - product2) * end;
  float bend_slope = start + (product - rise);
  float part = reach / way;
  float part_dx = reach_dx / way;
  float part_dy = reach_dy / way;
  float difference = 1.0 - t;
  float product3 = t * difference;
  float blend = mix(start, end, t);
  float sum2 = rise + ((difference - t) * blend + product3 * (end - start));
  float product4 = bend * part;
  float bend_dx = t_dx * 6.0 * bend_slope;
  float bend_dy = t_dy * 6.0 * bend_slope;
  result_dx = t_dx * sum2 + ((bend_dx * part + bend * part_dx) * part + product4 * part_dx) / 6.0;
  result_dy = t_dy * sum2 + ((bend_dy * part + bend * part_dy) * part + product4 * part_dy) / 6.0;
  return from.y + rise * t + product3 * blend + product4 * part / 6.0;
}

// curve (math/curve.glsl)
float island_map_curve(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float ratio = -value_dx / width;
  float ratio2 = -value_dy / width;
  float sum2 = -value / width + 0.5;
  float below = clamp(sum2, 0.0, 1.0);
  bool test = sum2 < 0.0;
  bool test2 = sum2 > 1.0;
  float below_dx = test ? 0.0 : test2 ? 0.0 : ratio;
  float below_dy = test ? 0.0 : test2 ? 0.0 : ratio2;
  float sum = 0.75 * below;
  float sum_dx = below_dx * 0.75;
  float sum_dy = below_dy * 0.75;
  for (int i = 0; i < 3; ++i) {
    float sum3 = (island_map_points[i + 1].x - value) / width + 0.5;
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
    float part_mean_value = island_map_part_mean(i, middle, reach, middle_dx, middle_dy, reach_dx,
        reach_dy, result_dx2, result_dy2);
    below = next;
    sum += difference * part_mean_value;
    below_dx = next_dx;
    below_dy = next_dy;
    sum_dx += difference2 * part_mean_value + difference * result_dx2;
    sum_dy += difference3 * part_mean_value + difference * result_dy2;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// gradient_noise (noise/gradient_noise.glsl)
float island_map_gradient_noise_perlin(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
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
  uint sum2 = cell.x + 1u;
  uvec2 rows = island_map_hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = island_map_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
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
  vec2 sum3 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum4 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dx.y) * 0.9340967;
  result_dy = (mix(sum4.x, sum4.y, fade.y) + difference3 * fade_dy.y) * 0.9340967;
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// fbm (noise/fbm.glsl)
float island_map_fbm(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 5.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 5.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 5.0;
  vec2 p_dy = uv_dy * 5.0;
  float weight = 0.50793654;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 6; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_perlin_value = island_map_gradient_noise_perlin(p * frequency + shift,
          p_dx * frequency, p_dy * frequency, result_dx2, result_dy2);
      sum += product2 * (gradient_noise_perlin_value - 0.5);
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

// ridged (noise/ridged.glsl)
float island_map_ridged(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 4.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 4.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 4.0;
  vec2 p_dy = uv_dy * 4.0;
  float weight = 0.50793654;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.0;
  float carry = 1.0;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  float carry_dx = 0.0;
  float carry_dy = 0.0;
  for (int octave = 0; octave < 6; ++octave) {
    float near = min(2.0 - 4.0 * width * frequency, 1.0);
    float ridge = 0.571;
    float ridge_dx = 0.0;
    float ridge_dy = 0.0;
    if (near > 0.0) {
      float result_dx2, result_dy2;
      float gradient_noise_perlin_value = island_map_gradient_noise_perlin(p * frequency + shift,
          p_dx * frequency, p_dy * frequency, result_dx2, result_dy2);
      float difference = 2.0 * gradient_noise_perlin_value - 1.0;
      float direction = sign(difference);
      float height = 1.0 - abs(difference);
      float height_dx = -(result_dx2 * 2.0 * direction);
      float height_dy = -(result_dy2 * 2.0 * direction);
      float ridge_slope = (height + height) * near;
      ridge = mix(0.571, height * height, near);
      ridge_dx = height_dx * ridge_slope;
      ridge_dy = height_dy * ridge_slope;
    }
    float ridge2 = ridge * carry;
    carry_dx = ridge_dx * carry + ridge * carry_dx;
    carry_dy = ridge_dy * carry + ridge * carry_dy;
    frequency *= 2.0;
    shift += 37.7;
    sum += weight * ridge2;
    carry = ridge2;
    sum_dx += carry_dx * weight;
    sum_dy += carry_dy * weight;
    weight *= 0.5;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// smooth_step (math/smooth_step.glsl)
float island_map_smooth_step(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float product = (value - 0.25) * 2.0;
  float t = clamp(product, 0.0, 1.0);
  bool test = product < 0.0;
  bool test2 = product > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : value_dx * 2.0;
  float t_dy = test ? 0.0 : test2 ? 0.0 : value_dy * 2.0;
  float product2 = t * t;
  float difference = 3.0 - 2.0 * t;
  float sum = (t + t) * difference + product2 * -2.0;
  result_dx = t_dx * sum;
  result_dy = t_dy * sum;
  return product2 * difference;
}

// height_at (a function of uv)
float island_map_height_at(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  // coast: domain_warp (noise/domain_warp.glsl)
  vec2 coast_dx, coast_dy;
  vec2 coast = island_map_domain_warp(uv, uv_dx, uv_dy, coast_dx, coast_dy);
  // from_middle: gradient_radial (patterns/gradient_radial.glsl)
  float from_middle_dx, from_middle_dy;
  float from_middle = island_map_gradient_radial(coast, coast_dx, coast_dy, from_middle_dx,
      from_middle_dy);
  // body: curve (math/curve.glsl)
  float body_dx, body_dy;
  float body = island_map_curve(from_middle, from_middle_dx, from_middle_dy, body_dx, body_dy);
  // hills: fbm (noise/fbm.glsl)
  float hills_dx, hills_dy;
  float hills = island_map_fbm(uv, uv_dx, uv_dy, hills_dx, hills_dy);
  // crests: ridged (noise/ridged.glsl)
  float crests_dx, crests_dy;
  float crests = island_map_ridged(uv, uv_dx, uv_dy, crests_dx, crests_dy);
  // inland: smooth_step (math/smooth_step.glsl)
  float inland_dx, inland_dy;
  float inland = island_map_smooth_step(body, body_dx, body_dy, inland_dx, inland_dy);
  // mountains: multiply (math/multiply.glsl)
  float mountains = crests * inland;
  float mountains_dx = crests_dx * inland + crests * inland_dx;
  float mountains_dy = crests_dy * inland + crests * inland_dy;
  // rough: multiply (math/multiply.glsl)
  float rough = hills * 0.5;
  // ground: add (math/add.glsl)
  float ground = body + rough;
  float rough_dx = hills_dx * 0.5;
  float rough_dy = hills_dy * 0.5;
  float ground_dx = body_dx + rough_dx;
  float ground_dy = body_dy + rough_dy;
  // peaks: multiply (math/multiply.glsl)
  float peaks = mountains * 0.55;
  // sum: add (math/add.glsl)
  float sum = ground + peaks;
  float peaks_dx = mountains_dx * 0.55;
  float peaks_dy = mountains_dy * 0.55;
  // height: subtract (math/subtract.glsl)
  float height = sum - sea_level;
  result_dx = ground_dx + peaks_dx;
  result_dy = ground_dy + peaks_dy;
  return height;
}

// height_to_normal (filters/height_to_normal.glsl)
vec3 island_map_height_to_normal(vec2 uv, float strength, vec2 uv_dx, vec2 uv_dy,
    out vec3 result_dx, out vec3 result_dy) {
  vec2 apart = max(sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 0.0005);
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  float result_dx2, result_dy2;
  float height_at_value = island_map_height_at(uv + across, uv_dx, uv_dy, result_dx2, result_dy2);
  float result_dx3, result_dy3;
  float height_at_value2 = island_map_height_at(uv - across, uv_dx, uv_dy, result_dx3, result_dy3);
  float result_dx4, result_dy4;
  float height_at_value3 = island_map_height_at(uv + along, uv_dx, uv_dy, result_dx4, result_dy4);
  float result_dx5, result_dy5;
  float height_at_value4 = island_map_height_at(uv - along, uv_dx, uv_dy, result_dx5, result_dy5);
  vec2 rise = vec2(height_at_value - height_at_value2, height_at_value3 - height_at_value4);
  vec2 rise_dx = vec2(result_dx2 - result_dx3, result_dx4 - result_dx5);
  vec2 rise_dy = vec2(result_dy2 - result_dy3, result_dy4 - result_dy5);
  vec3 normal = vec3(-strength * rise / apart, 1.0);
  vec3 normal_dx = vec3(rise_dx * -strength / apart, 0.0);
  vec3 normal_dy = vec3(rise_dy * -strength / apart, 0.0);
  float projection = dot(normal, normal);
  float projection2 = dot(normal_dx, normal);
  float projection3 = dot(normal_dy, normal);
  float inverse_root = inversesqrt(projection);
  bool test = projection > 0.0;
  float ratio = inverse_root / projection;
  vec3 product = normal * (test ? -0.5 * (projection2 + projection2) * ratio : 0.0);
  vec3 product2 = normal * (test ? -0.5 * (projection3 + projection3) * ratio : 0.0);
  result_dx = normal_dx * inverse_root + product;
  result_dy = normal_dy * inverse_root + product2;
  return normal * inverse_root;
}

// level_shade, of levels (color/levels.glsl)
float island_map_level_shade(float value, float value_dx, float value_dy) {
  float t = (value - 0.05) * 1.1111112;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 1.1111112, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// part_mean, of color_ramp (color/color_ramp.glsl)
vec4 island_map_part_mean(vec4 from, vec4 to, float middle, float reach) {
  float square = reach * reach;
  float variance = square / 3.0;
  vec4 color = mix(from, to, middle);
  vec3 sum = color.xyz * color.w + (to.xyz - from.xyz) * ((to.w - from.w) * variance);
  return vec4(sum, color.w);
}

// color_ramp (color/color_ramp.glsl)
vec4 island_map_color_ramp(float position, float position_dx, float position_dy) {
  float width = max(sqrt(position_dx * position_dx + position_dy * position_dy), 1e-7);
  float below = clamp((0.19 - position) / width + 0.5, 0.0, 1.0);
  vec4 sum = vec4(0.62, 0.52, 0.32, 1.0) * below;
  for (int i = 0; i < 5; ++i) {
    int sum2 = i + 1;
    float item = island_map_stops[sum2];
    float next = clamp((item - position) / width + 0.5, 0.0, 1.0);
    float item2 = island_map_stops[i];
    float part = 1.0 / max(item - item2, 1e-7);
    float middle = position + width * (0.5 * (below + next) - 0.5) - item2;
    float difference = next - below;
    float least = min(0.5 * difference * width * part, 0.5);
    vec4 part_mean_value = island_map_part_mean(island_map_colors[i], island_map_colors[sum2],
        clamp(middle * part, 0.0, 1.0), least);
    below = next;
    sum += difference * part_mean_value;
  }
  sum += (1.0 - below) * vec4(0.85, 0.87, 0.9, 1.0);
  vec3 choice = vec3(0.85, 0.87, 0.9);
  if (sum.w > 0.0) {
    choice = sum.xyz / max(sum.w, 1e-20);
  }
  return vec4(choice, sum.w);
}

// square_wave (math/square_wave.glsl)
float island_map_square_wave(float phase, float phase_dx, float phase_dy) {
  float root = sqrt(phase_dx * phase_dx + phase_dy * phase_dy);
  float width = max(root, 1e-7);
  float from_middle = abs(fract(phase - 0.05 + 0.5) - 0.5);
  float choice;
  if (width < 0.1) {
    choice = clamp((0.05 - from_middle) / width + 0.5, 0.0, 1.0);
  } else {
    float wide = max(root, 0.0001);
    float low = fract(phase - 0.5 * wide);
    float high = low + wide;
    float whole = floor(high);
    float covered = whole * 0.1 + min(high - whole, 0.1) - min(low, 0.1);
    choice = clamp(covered / wide, 0.0, 1.0);
  }
  return choice;
}

// level_depth, of levels (color/levels.glsl)
float island_map_level_depth(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float t = (value + 0.25) * 2.2727273;
  float t_dx = value_dx * 2.2727273;
  float t_dy = value_dy * 2.2727273;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 2.2727273, 1e-7);
  float product = 0.5 * width;
  float difference = t - product;
  float low = clamp(difference, 0.0, 1.0);
  bool test = difference < 0.0;
  bool test2 = difference > 1.0;
  float low_dx = test ? 0.0 : test2 ? 0.0 : t_dx;
  float low_dy = test ? 0.0 : test2 ? 0.0 : t_dy;
  float sum = t + product;
  float high = clamp(sum, 0.0, 1.0);
  bool test3 = sum < 0.0;
  bool test4 = sum > 1.0;
  float high_dx = test3 ? 0.0 : test4 ? 0.0 : t_dx;
  float high_dy = test3 ? 0.0 : test4 ? 0.0 : t_dy;
  float difference2 = 0.5 - t / width;
  float below = clamp(difference2, 0.0, 1.0);
  bool test5 = difference2 < 0.0;
  bool test6 = difference2 > 1.0;
  float below_dx = test5 ? 0.0 : test6 ? 0.0 : -(t_dx / width);
  float below_dy = test5 ? 0.0 : test6 ? 0.0 : -(t_dy / width);
  float difference3 = 0.5 - (1.0 - t) / width;
  float above = clamp(difference3, 0.0, 1.0);
  bool test7 = difference3 < 0.0;
  bool test8 = difference3 > 1.0;
  float above_dx = test7 ? 0.0 : test8 ? 0.0 : -(value_dx * -2.2727273 / width);
  float above_dy = test7 ? 0.0 : test8 ? 0.0 : -(value_dy * -2.2727273 / width);
  float inside = 0.5 * (low + high);
  float difference4 = 1.0 - below - above;
  float inside_dx = (low_dx + high_dx) * 0.5;
  float inside_dy = (low_dy + high_dy) * 0.5;
  result_dx = above_dx + ((-below_dx - above_dx) * inside + difference4 * inside_dx);
  result_dy = above_dy + ((-below_dy - above_dy) * inside + difference4 * inside_dy);
  return above + difference4 * inside;
}

// simplex_noise (noise/simplex_noise.glsl)
float island_map_simplex_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * 4.0;
  vec2 base = floor(p + (p.x + p.y) * 0.36602542);
  vec2 a = p - base + (base.x + base.y) * 0.21132487;
  vec2 a_dx = uv_dx * 4.0;
  vec2 a_dy = uv_dy * 4.0;
  bool lower = a.y < a.x;
  vec2 b = a - (lower ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) + 0.21132487;
  vec2 c = a - 1.0 + 0.42264974;
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 columns = uvec2(cell.x, sum);
  uvec2 rows = island_map_hash(uvec2(cell.y, cell.y + 1u) + 2131687100u);
  uint middle = lower ? sum + rows.x : cell.x + rows.y;
  uvec2 ends = columns + rows;
  uvec4 hash_value = island_map_hash(uvec4(ends.x, middle, ends.yy));
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec3 dx = vec3(a.x, b.x, c.x);
  vec3 dy = vec3(a.y, b.y, c.y);
  vec3 negative = -(dx + dx);
  vec3 sum2 = dy + dy;
  vec3 difference = 0.5 - dx * dx - dy * dy;
  vec3 r = max(difference, 0.0);
  bvec3 test = lessThan(difference, vec3(0.0));
  vec3 r_dx = mix(a_dx.x * negative - a_dx.y * sum2, vec3(0.0), test);
  vec3 r_dy = mix(a_dy.x * negative - a_dy.y * sum2, vec3(0.0), test);
  vec3 r2 = r * r;
  vec3 r2_slope = r + r;
  vec3 reach = r2 * r2;
  vec3 product = r2_slope * r2;
  vec3 reach_slope = product + product;
  vec3 along = x.xyz * dx + y.xyz * dy;
  vec3 along_dx = a_dx.x * x.xyz + a_dx.y * y.xyz;
  vec3 along_dy = a_dy.x * x.xyz + a_dy.y * y.xyz;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 4.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float amplitude = 51.16832 * (1.0 - blur);
  vec3 reach_dx = r_dx * reach_slope;
  vec3 reach_dy = r_dy * reach_slope;
  result_dx = (dot(reach_dx, along) + dot(reach, along_dx)) * amplitude;
  result_dy = (dot(reach_dy, along) + dot(reach, along_dy)) * amplitude;
  return dot(reach, along) * amplitude + 0.5;
}

// curl (noise/curl.glsl)
vec2 island_map_curl(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx, out vec2 result_dy) {
  vec2 way = max(0.5 * sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 0.001);
  vec2 point = vec2(way.x, 0.0);
  float result_dx2, result_dy2;
  float simplex_noise_value = island_map_simplex_noise(uv + point, uv_dx, uv_dy, result_dx2,
      result_dy2);
  float result_dx3, result_dy3;
  float simplex_noise_value2 = island_map_simplex_noise(uv - point, uv_dx, uv_dy, result_dx3,
      result_dy3);
  vec2 point2 = vec2(0.0, way.y);
  float result_dx4, result_dy4;
  float simplex_noise_value3 = island_map_simplex_noise(uv + point2, uv_dx, uv_dy, result_dx4,
      result_dy4);
  float result_dx5, result_dy5;
  float simplex_noise_value4 = island_map_simplex_noise(uv - point2, uv_dx, uv_dy, result_dx5,
      result_dy5);
  float rise_y = simplex_noise_value3 - simplex_noise_value4;
  float rise_y_dx = result_dx4 - result_dx5;
  float rise_y_dy = result_dy4 - result_dy5;
  result_dx = vec2(rise_y_dx, result_dx3 - result_dx2) * 0.5 / way.yx;
  result_dy = vec2(rise_y_dy, result_dy3 - result_dy2) * 0.5 / way.yx;
  return vec2(rise_y, simplex_noise_value2 - simplex_noise_value) * 0.5 / way.yx;
}

// cell_hash (indirection/cell_hash.glsl)
uint island_map_cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// hash (random/hash.glsl)
uint island_map_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// add_point, of smooth_voronoi (cellular/smooth_voronoi.glsl)
void island_map_add_point(float square, island_map_Sum sum, float square_dx, float square_dy,
    float sum_least_dx, float sum_least_dy, float sum_terms_dx, float sum_terms_dy,
    out island_map_Sum sum_out, out float sum_out_least_dx, out float sum_out_least_dy,
    out float sum_out_terms_dx, out float sum_out_terms_dy) {
  float difference2 = 1.0 - square / 2.25;
  float rest = max(difference2, 0.0);
  bool test = difference2 < 0.0;
  float rest_dx = test ? 0.0 : -(square_dx / 2.25);
  float rest_dy = test ? 0.0 : -(square_dy / 2.25);
  float root = sqrt(square);
  bool test2 = square > 0.0;
  float greatest = max(root, 1e-20);
  float difference = root - sum.least;
  float difference_dx = (test2 ? 0.5 * square_dx / greatest : 0.0) - sum_least_dx;
  float difference_dy = (test2 ? 0.5 * square_dy / greatest : 0.0) - sum_least_dy;
  float direction = sign(difference);
  float shrink = exp2(abs(difference) / -0.15);
  float product = 0.6931472 * shrink;
  float shrink_dx = product * (difference_dx * direction / -0.15);
  float shrink_dy = product * (difference_dy * direction / -0.15);
  bool nearer = difference < 0.0;
  float choice, sum_terms_dx2, sum_terms_dy2;
  if (nearer) {
    float sum2 = rest + rest;
    choice = sum.terms * shrink + rest * rest;
    sum_terms_dx2 = sum_terms_dx * shrink + sum.terms * shrink_dx + rest_dx * sum2;
    sum_terms_dy2 = sum_terms_dy * shrink + sum.terms * shrink_dy + rest_dy * sum2;
  } else {
    float product2 = rest * rest;
    float sum2 = rest + rest;
    choice = sum.terms + product2 * shrink;
    sum_terms_dx2 = sum_terms_dx + (rest_dx * sum2 * shrink + product2 * shrink_dx);
    sum_terms_dy2 = sum_terms_dy + (rest_dy * sum2 * shrink + product2 * shrink_dy);
  }
  float sum2 = sum.least + difference;
  bool test3 = sum2 < sum.least;
  sum_out = island_map_Sum(min(sum.least, sum2), choice);
  sum_out_least_dx = test3 ? sum_least_dx + difference_dx : sum_least_dx;
  sum_out_least_dy = test3 ? sum_least_dy + difference_dy : sum_least_dy;
  sum_out_terms_dx = sum_terms_dx2;
  sum_out_terms_dy = sum_terms_dy2;
}

// smooth_voronoi (cellular/smooth_voronoi.glsl)
float island_map_smooth_voronoi(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * 26.0;
  vec2 corner = floor(p + 0.5);
  vec2 start = p - corner;
  island_map_Sum sum = island_map_Sum(4.0, 0.0);
  float sum_least_dx = 0.0;
  float sum_least_dy = 0.0;
  float sum_terms_dx = 0.0;
  float sum_terms_dy = 0.0;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 cell = ivec2(corner) + ivec2(x, y);
      uint hash_value = island_map_hash(island_map_cell_hash(cell) - 1u);
      vec2 product = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
      vec2 arm = vec2(float(x), float(y)) - start + product;
      vec2 arm_dx = uv_dx * -26.0;
      vec2 arm_dy = uv_dy * -26.0;
      float projection = dot(arm_dx, arm);
      float projection2 = dot(arm_dy, arm);
      island_map_Sum sum2;
      float sum_least_dx2, sum_least_dy2, sum_terms_dx2, sum_terms_dy2;
      island_map_add_point(dot(arm, arm), sum, projection + projection, projection2 + projection2,
          sum_least_dx, sum_least_dy, sum_terms_dx, sum_terms_dy, sum2, sum_least_dx2,
          sum_least_dy2, sum_terms_dx2, sum_terms_dy2);
      sum = sum2;
      sum_least_dx = sum_least_dx2;
      sum_least_dy = sum_least_dy2;
      sum_terms_dx = sum_terms_dx2;
      sum_terms_dy = sum_terms_dy2;
    }
  }
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 26.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float greatest = max(sum.terms, 1e-20);
  bool test = sum.terms < 1e-20;
  float difference = sum.least - 0.15 * log2(greatest);
  bool test2 = difference < 0.0;
  float choice = test2 ? 0.0 : sum_least_dx
      - 1.442695 * (test ? 0.0 : sum_terms_dx) / greatest * 0.15;
  float choice2 = test2 ? 0.0 : sum_least_dy
      - 1.442695 * (test ? 0.0 : sum_terms_dy) / greatest * 0.15;
  float difference2 = 1.0 - blur;
  result_dx = choice * difference2;
  result_dy = choice2 * difference2;
  return mix(max(difference, 0.0), 0.3913427, blur);
}

// level_sparkle, of levels (color/levels.glsl)
float island_map_level_sparkle(float value, float value_dx, float value_dy) {
  float t = (value - 0.3) * 1.8181818;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 1.8181818, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// soft_light, of blend (layers/blend.glsl)
vec3 island_map_soft_light(vec3 back) {
  vec3 low = min(back, 0.25);
  vec3 lighter = ((16.0 * low - 12.0) * low + 4.0) * low + (sqrt(max(back, 0.25)) - 0.5);
  return back + vec3(0.20000005, 0.79999995, 0.79999995) * (lighter - back);
}

// blend (layers/blend.glsl)
vec4 island_map_blend(vec4 background, float opacity) {
  float both = mix(background.w, 1.0, opacity);
  vec3 blended = island_map_soft_light(background.xyz);
  vec3 color = mix(vec3(0.6, 0.9, 0.9), blended, background.w);
  return vec4(mix(background.xyz, color, opacity / max(both, 1e-20)), both);
}

// sawtooth_wave (math/sawtooth_wave.glsl)
float island_map_sawtooth_wave(float phase, float phase_dx, float phase_dy) {
  float width = max(sqrt(phase_dx * phase_dx + phase_dy * phase_dy), 1e-7);
  float product = 0.5 * width;
  float low = fract(phase - product);
  float high = low + width;
  float jumps = floor(high);
  return low + product - jumps * (high - 0.5 * (jumps + 1.0)) / width;
}

// level_surf_there, of levels (color/levels.glsl)
float island_map_level_surf_there(float value, float value_dx, float value_dy) {
  float t = (value - 0.6) * 2.5000002;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 2.5000002, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// threshold (math/threshold.glsl)
float island_map_threshold(float value, float value_dx, float value_dy) {
  float ratio = (value - 0.19) / max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  return clamp(ratio + 0.5, 0.0, 1.0);
}

// sdf_star (shapes/sdf_star.glsl)
float island_map_sdf_star_needle(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - vec2(0.87, 0.13);
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - 1.5707964;
  float toward = 1.5707964 + 1.5707964 * floor(turned / 1.5707964 + 0.5);
  float cosine = cos(toward);
  float sine = sin(toward);
  vec2 ahead = vec2(cosine, sine);
  float from_axis = p.y * cosine - p.x * sine;
  float from_axis_dx = uv_dx.y * cosine - uv_dx.x * sine;
  float from_axis_dy = uv_dy.y * cosine - uv_dy.x * sine;
  float projection = dot(uv_dx, ahead);
  float projection2 = dot(uv_dy, ahead);
  float difference = dot(p, ahead) - 0.085;
  float choice = from_axis < 0.0 ? -1.0 : 1.0;
  float product = from_axis * choice;
  vec2 q = vec2(difference, product);
  float product2 = from_axis_dx * choice;
  float product3 = from_axis_dy * choice;
  vec2 q_dx = vec2(projection, product2);
  vec2 q_dy = vec2(projection2, product3);
  float side = difference * 0.19572435 - product * -0.9806589;
  float side_dx = projection * 0.19572435 - product2 * -0.9806589;
  float side_dy = projection2 * 0.19572435 - product3 * -0.9806589;
  float place = dot(q, vec2(-0.9806589, 0.19572435));
  bool test = place > 0.0;
  if (!(test && place < 0.072255366)) {
    vec2 choice2 = test ? q - vec2(-0.07085787, 0.014142135) : q;
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

// sdf_star (shapes/sdf_star.glsl)
float island_map_sdf_star_points_between(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - vec2(0.87, 0.13);
  float turned = atan(p.y, p.x == 0.0 ? 1e-20 : p.x) - 2.3561945;
  float toward = 2.3561945 + 1.5707964 * floor(turned / 1.5707964 + 0.5);
  float cosine = cos(toward);
  float sine = sin(toward);
  vec2 ahead = vec2(cosine, sine);
  float from_axis = p.y * cosine - p.x * sine;
  float from_axis_dx = uv_dx.y * cosine - uv_dx.x * sine;
  float from_axis_dy = uv_dy.y * cosine - uv_dy.x * sine;
  float projection = dot(uv_dx, ahead);
  float projection2 = dot(uv_dy, ahead);
  float difference = dot(p, ahead) - 0.055;
  float choice = from_axis < 0.0 ? -1.0 : 1.0;
  float product = from_axis * choice;
  vec2 q = vec2(difference, product);
  float product2 = from_axis_dx * choice;
  float product3 = from_axis_dy * choice;
  vec2 q_dx = vec2(projection, product2);
  vec2 q_dy = vec2(projection2, product3);
  float side = difference * 0.28830987 - product * -0.9575372;
  float side_dx = projection * 0.28830987 - product2 * -0.9575372;
  float side_dy = projection2 * 0.28830987 - product3 * -0.9575372;
  float place = dot(q, vec2(-0.9575372, 0.28830987));
  bool test = place > 0.0;
  if (!(test && place < 0.044146672)) {
    vec2 choice2 = test ? q - vec2(-0.04227208, 0.012727921) : q;
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

// sdf_smooth_union (shapes/sdf_smooth_union.glsl)
float island_map_sdf_smooth_union(float a, float b, float a_dx, float a_dy, float b_dx, float b_dy,
    out float result_dx, out float result_dy) {
  float sum = 0.5 + 0.5 * (b - a) / 0.008;
  float t = clamp(sum, 0.0, 1.0);
  bool test = sum < 0.0;
  bool test2 = sum > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : (b_dx - a_dx) * 0.5 / 0.008;
  float t_dy = test ? 0.0 : test2 ? 0.0 : (b_dy - a_dy) * 0.5 / 0.008;
  float difference = a - b;
  float difference2 = 1.0 - t;
  float sum2 = 0.008 * difference2 + t * -0.008;
  result_dx = mix(b_dx, a_dx, t) + difference * t_dx - t_dx * sum2;
  result_dy = mix(b_dy, a_dy, t) + difference * t_dy - t_dy * sum2;
  return mix(b, a, t) - 0.008 * t * difference2;
}

// sdf_fill (shapes/sdf_fill.glsl)
float island_map_sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

void island_map(vec2 uv, out vec4 color, out float height) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // coast: domain_warp (noise/domain_warp.glsl)
  vec2 coast_dx, coast_dy;
  vec2 coast = island_map_domain_warp(uv, uv_dx, uv_dy, coast_dx, coast_dy);
  // from_middle: gradient_radial (patterns/gradient_radial.glsl)
  float from_middle_dx, from_middle_dy;
  float from_middle = island_map_gradient_radial(coast, coast_dx, coast_dy, from_middle_dx,
      from_middle_dy);
  // body: curve (math/curve.glsl)
  float body_dx, body_dy;
  float body = island_map_curve(from_middle, from_middle_dx, from_middle_dy, body_dx, body_dy);
  // hills: fbm (noise/fbm.glsl)
  float hills_dx, hills_dy;
  float hills = island_map_fbm(uv, uv_dx, uv_dy, hills_dx, hills_dy);
  // crests: ridged (noise/ridged.glsl)
  float crests_dx, crests_dy;
  float crests = island_map_ridged(uv, uv_dx, uv_dy, crests_dx, crests_dy);
  // inland: smooth_step (math/smooth_step.glsl)
  float inland_dx, inland_dy;
  float inland = island_map_smooth_step(body, body_dx, body_dy, inland_dx, inland_dy);
  // mountains: multiply (math/multiply.glsl)
  float mountains = crests * inland;
  float mountains_dx = crests_dx * inland + crests * inland_dx;
  float mountains_dy = crests_dy * inland + crests * inland_dy;
  // rough: multiply (math/multiply.glsl)
  float rough = hills * 0.5;
  // ground: add (math/add.glsl)
  float ground = body + rough;
  float rough_dx = hills_dx * 0.5;
  float rough_dy = hills_dy * 0.5;
  float ground_dx = body_dx + rough_dx;
  float ground_dy = body_dy + rough_dy;
  // peaks: multiply (math/multiply.glsl)
  float peaks = mountains * 0.55;
  // sum: add (math/add.glsl)
  float sum = ground + peaks;
  float peaks_dx = mountains_dx * 0.55;
  float peaks_dy = mountains_dy * 0.55;
  float sum_dx = ground_dx + peaks_dx;
  float sum_dy = ground_dy + peaks_dy;
  // height: subtract (math/subtract.glsl)
  float height2 = sum - sea_level;
  // slope: height_to_normal (filters/height_to_normal.glsl)
  vec3 slope_dx, slope_dy;
  vec3 slope = island_map_height_to_normal(uv, relief, uv_dx, uv_dy, slope_dx, slope_dy);
  // facing: dot_product (math/dot_product.glsl)
  float facing = dot(slope, vec3(-0.5, 0.6, 0.62));
  float facing_dx = dot(slope_dx, vec3(-0.5, 0.6, 0.62));
  float facing_dy = dot(slope_dy, vec3(-0.5, 0.6, 0.62));
  // shade: levels (color/levels.glsl)
  float shade = mix(0.35, 1.45, island_map_level_shade(facing, facing_dx, facing_dy));
  // tints: color_ramp (color/color_ramp.glsl)
  vec4 tints = island_map_color_ramp(height2, sum_dx, sum_dy);
  // lit: brightness_contrast (color/brightness_contrast.glsl)
  vec4 lit = vec4(tints.xyz * shade, tints.w);
  // contour_phase: multiply (math/multiply.glsl)
  float contour_phase = height2 * 16.0;
  // contour: square_wave (math/square_wave.glsl)
  float contour_phase_dx = sum_dx * 16.0;
  float contour_phase_dy = sum_dy * 16.0;
  float contour = island_map_square_wave(contour_phase, contour_phase_dx, contour_phase_dy);
  // inked: multiply (math/multiply.glsl)
  float inked = contour * lines;
  // land: lerp (math/lerp.glsl)
  vec4 land = mix(lit, vec4(0.09, 0.05, 0.025, 1.0), inked);
  // deep: ramp4 (patterns/ramp4.glsl)
  vec2 clamped = clamp(uv, 0.0, 1.0);
  vec4 blend = mix(vec4(0.01, 0.05, 0.13, 1.0), vec4(0.008, 0.06, 0.15, 1.0), clamped.x);
  vec4 blend2 = mix(vec4(0.012, 0.09, 0.17, 1.0), vec4(0.006, 0.035, 0.1, 1.0), clamped.x);
  vec4 deep = mix(blend, blend2, clamped.y);
  // depth: levels (color/levels.glsl)
  float depth_dx, depth_dy;
  float depth = island_map_level_depth(height2, sum_dx, sum_dy, depth_dx, depth_dy);
  // shallow: lerp (math/lerp.glsl)
  vec4 shallow = mix(deep, vec4(0.1, 0.42, 0.4, 1.0), depth);
  // flow: curl (noise/curl.glsl)
  vec2 flow_dx, flow_dy;
  vec2 flow = island_map_curl(uv, uv_dx, uv_dy, flow_dx, flow_dy);
  // drifting: vector_warp (filters/vector_warp.glsl)
  float drifting_dx, drifting_dy;
  float drifting = island_map_smooth_voronoi(uv + 0.02 * flow, uv_dx + flow_dx * 0.02,
      uv_dy + flow_dy * 0.02, drifting_dx, drifting_dy);
  // sparkle: levels (color/levels.glsl)
  float sparkle = 0.16 * island_map_level_sparkle(drifting, drifting_dx, drifting_dy);
  // sea: blend (layers/blend.glsl)
  vec4 sea = island_map_blend(shallow, sparkle);
  // surf_phase: multiply (math/multiply.glsl)
  float surf_phase = depth * 6.0;
  // surf: sawtooth_wave (math/sawtooth_wave.glsl)
  float surf_phase_dx = depth_dx * 6.0;
  float surf_phase_dy = depth_dy * 6.0;
  float surf = island_map_sawtooth_wave(surf_phase, surf_phase_dx, surf_phase_dy);
  // surf_there: levels (color/levels.glsl)
  float surf_there = 0.3 * island_map_level_surf_there(depth, depth_dx, depth_dy);
  // foam: multiply (math/multiply.glsl)
  float foam = surf * surf_there;
  // water: lerp (math/lerp.glsl)
  vec4 water = mix(sea, vec4(0.75, 0.85, 0.82, 1.0), foam);
  // dry: threshold (math/threshold.glsl)
  float dry = island_map_threshold(height2, sum_dx, sum_dy);
  // chart: lerp (math/lerp.glsl)
  vec4 chart = mix(water, land, dry);
  // needle: sdf_star (shapes/sdf_star.glsl)
  float needle_dx, needle_dy;
  float needle = island_map_sdf_star_needle(uv, uv_dx, uv_dy, needle_dx, needle_dy);
  // points_between: sdf_star (shapes/sdf_star.glsl)
  float points_between_dx, points_between_dy;
  float points_between = island_map_sdf_star_points_between(uv, uv_dx, uv_dy, points_between_dx,
      points_between_dy);
  // rose: sdf_smooth_union (shapes/sdf_smooth_union.glsl)
  float rose_dx, rose_dy;
  float rose = island_map_sdf_smooth_union(needle, points_between, needle_dx, needle_dy,
      points_between_dx, points_between_dy, rose_dx, rose_dy);
  // hoop: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference = uv - vec2(0.87, 0.13);
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float hoop_dx = dot(difference, uv_dx) / greatest;
  float hoop_dy = dot(difference, uv_dy) / greatest;
  float hoop = norm - 0.06;
  // hoop_line: sdf_outline (shapes/sdf_outline.glsl)
  float hoop_line_slope = hoop < 0.0 ? -1.0 : 1.0;
  float hoop_line = hoop * hoop_line_slope - 0.002;
  // compass: sdf_union (shapes/sdf_union.glsl)
  float compass = min(rose, hoop_line);
  float hoop_line_dx = hoop_dx * hoop_line_slope;
  float hoop_line_dy = hoop_dy * hoop_line_slope;
  bool test = hoop_line < rose;
  float compass_dx = test ? hoop_line_dx : rose_dx;
  float compass_dy = test ? hoop_line_dy : rose_dy;
  // compass_there: sdf_fill (shapes/sdf_fill.glsl)
  float compass_there = island_map_sdf_fill(compass, compass_dx, compass_dy);
  // drawn: lerp (math/lerp.glsl)
  vec4 drawn = mix(chart, vec4(0.9, 0.82, 0.62, 1.0), compass_there);
  color = drawn;
  height = height2;
}
