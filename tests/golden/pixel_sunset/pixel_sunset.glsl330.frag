// pixel_sunset: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform float pixels;  // default 112.0
uniform float tones;  // default 12.0
uniform float sun_height;  // default 0.56

// Outputs
layout(location = 0) out vec4 out_color;

// Constants
const float stops[5] = float[5](0.0, 0.18, 0.42, 0.7, 1.0);
const vec4 colors[5] = vec4[5](vec4(1.0, 0.42, 0.1, 1.0), vec4(0.95, 0.2, 0.12, 1.0),
    vec4(0.42, 0.07, 0.2, 1.0), vec4(0.09, 0.035, 0.2, 1.0), vec4(0.018, 0.015, 0.09, 1.0));

// widen (filters/widen.glsl)
vec2 widen(vec2 place, vec2 width, vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx,
    out vec2 result_dy) {
  float area = uv_dx.x * uv_dy.y - uv_dx.y * uv_dy.x;
  float least = max(0.0001 * length(uv_dx) * length(uv_dy), 1e-30);
  float area2 = area < 0.0 ? min(area, -least) : max(area, least);
  vec2 change = uv - floor(uv * 1.0995116e12) * 9.094947e-13;
  vec2 pixels = vec2(uv_dy.y * change.x - uv_dy.x * change.y,
      uv_dx.x * change.y - uv_dx.y * change.x);
  vec2 pixels_dx = vec2(area, 0.0);
  vec2 pixels_dy = vec2(0.0, area);
  vec2 ratio = width / area2;
  result_dx = pixels_dx * ratio;
  result_dy = pixels_dy * ratio;
  return floor(place * 1.0995116e12) * 9.094947e-13 + ratio * pixels;
}

// mirror (coordinates/mirror.glsl)
vec2 mirror(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx, out vec2 result_dy) {
  vec2 p = uv - vec2(0.5, 0.36);
  vec2 away_slope = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 away = p * away_slope;
  vec2 folded = vec2(0.5, 0.36) + away;
  vec2 folded_dx = uv_dx * away_slope;
  vec2 folded_dy = uv_dy * away_slope;
  result_dx = vec2(uv_dx.x, folded_dx.y);
  result_dy = vec2(uv_dy.x, folded_dy.y);
  return vec2(uv.x, folded.y);
}

// spread_range (math/spread_range.glsl)
float spread_range(float value, float value_dx, float value_dy, out float result_dx,
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

// gradient_linear (patterns/gradient_linear.glsl)
float gradient_linear(vec2 uv, vec2 start, vec2 end, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 way = end - start;
  float greatest = max(dot(way, way), 1e-20);
  float result_dx2, result_dy2;
  float spread_range_value = spread_range(dot(uv - start, way) / greatest,
      dot(uv_dx, way) / greatest, dot(uv_dy, way) / greatest, result_dx2, result_dy2);
  result_dx = result_dx2;
  result_dy = result_dy2;
  return spread_range_value;
}

// part_mean, of color_ramp (color/color_ramp.glsl)
vec4 part_mean(vec4 from, vec4 to, float middle, float reach, float middle_dx, float middle_dy,
    float reach_dx, float reach_dy, out vec4 result_dx, out vec4 result_dy) {
  float square = reach * reach;
  float square_slope = reach + reach;
  float variance = square / 3.0;
  float square_dx = reach_dx * square_slope;
  float square_dy = reach_dy * square_slope;
  float variance_dx = square_dx / 3.0;
  float variance_dy = square_dy / 3.0;
  vec4 color = mix(from, to, middle);
  vec4 color_slope = to - from;
  vec4 color_dx = middle_dx * color_slope;
  vec4 color_dy = middle_dy * color_slope;
  vec3 sum = color_dx.xyz * color.w + color.xyz * color_dx.w;
  vec3 sum2 = color_dy.xyz * color.w + color.xyz * color_dy.w;
  vec3 difference = to.xyz - from.xyz;
  float difference2 = to.w - from.w;
  result_dx = vec4(sum + variance_dx * difference2 * difference, color_dx.w);
  result_dy = vec4(sum2 + variance_dy * difference2 * difference, color_dy.w);
  return vec4(color.xyz * color.w + difference * (difference2 * variance), color.w);
}

// color_ramp (color/color_ramp.glsl)
vec4 color_ramp(float position, float position_dx, float position_dy, out vec4 result_dx,
    out vec4 result_dy) {
  float width = max(sqrt(position_dx * position_dx + position_dy * position_dy), 1e-7);
  float ratio = -position_dx / width;
  float ratio2 = -position_dy / width;
  float sum2 = -position / width + 0.5;
  float below = clamp(sum2, 0.0, 1.0);
  bool test = sum2 < 0.0;
  bool test2 = sum2 > 1.0;
  float below_dx = test ? 0.0 : test2 ? 0.0 : ratio;
  float below_dy = test ? 0.0 : test2 ? 0.0 : ratio2;
  vec4 sum = vec4(1.0, 0.42, 0.1, 1.0) * below;
  vec4 sum_dx = below_dx * vec4(1.0, 0.42, 0.1, 1.0);
  vec4 sum_dy = below_dy * vec4(1.0, 0.42, 0.1, 1.0);
  for (int i = 0; i < 4; ++i) {
    int sum3 = i + 1;
    float item = stops[sum3];
    float sum4 = (item - position) / width + 0.5;
    float next = clamp(sum4, 0.0, 1.0);
    bool test3 = sum4 < 0.0;
    bool test4 = sum4 > 1.0;
    float next_dx = test3 ? 0.0 : test4 ? 0.0 : ratio;
    float next_dy = test3 ? 0.0 : test4 ? 0.0 : ratio2;
    float item2 = stops[i];
    float part = 1.0 / max(item - item2, 1e-7);
    float product = width * 0.5;
    float middle_dx = position_dx + (below_dx + next_dx) * product;
    float middle_dy = position_dy + (below_dy + next_dy) * product;
    float middle = position + width * (0.5 * (below + next) - 0.5) - item2;
    float difference = next - below;
    float difference2 = next_dx - below_dx;
    float difference3 = next_dy - below_dy;
    float product2 = middle * part;
    bool test5 = product2 < 0.0;
    bool test6 = product2 > 1.0;
    float product3 = 0.5 * difference * width * part;
    float product4 = product * part;
    bool test7 = product3 > 0.5;
    vec4 result_dx2, result_dy2;
    vec4 part_mean_value = part_mean(colors[i], colors[sum3], clamp(product2, 0.0, 1.0),
        min(product3, 0.5), test5 ? 0.0 : test6 ? 0.0 : middle_dx * part,
        test5 ? 0.0 : test6 ? 0.0 : middle_dy * part, test7 ? 0.0 : difference2 * product4,
        test7 ? 0.0 : difference3 * product4, result_dx2, result_dy2);
    below = next;
    sum += difference * part_mean_value;
    below_dx = next_dx;
    below_dy = next_dy;
    sum_dx += difference2 * part_mean_value + difference * result_dx2;
    sum_dy += difference3 * part_mean_value + difference * result_dy2;
  }
  sum += (1.0 - below) * vec4(0.018, 0.015, 0.09, 1.0);
  sum_dx += -below_dx * vec4(0.018, 0.015, 0.09, 1.0);
  sum_dy += -below_dy * vec4(0.018, 0.015, 0.09, 1.0);
  vec3 choice = vec3(0.018, 0.015, 0.09);
  vec3 choice2 = vec3(0.0);
  vec3 choice3 = vec3(0.0);
  if (sum.w > 0.0) {
    bool test3 = sum.w < 1e-20;
    vec3 vector = vec3(max(sum.w, 1e-20));
    choice = sum.xyz / vector;
    choice2 = (sum_dx.xyz - choice * (test3 ? 0.0 : sum_dx.w)) / vector;
    choice3 = (sum_dy.xyz - choice * (test3 ? 0.0 : sum_dy.w)) / vector;
  }
  result_dx = vec4(choice2, sum_dx.w);
  result_dy = vec4(choice3, sum_dy.w);
  return vec4(choice, sum.w);
}

// circle (patterns/circle.glsl)
float circle(vec2 uv, vec2 center, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 difference = uv - center;
  float from_center = length(difference);
  float greatest = max(from_center, 1e-20);
  float from_center_dx = dot(difference, uv_dx) / greatest;
  float from_center_dy = dot(difference, uv_dy) / greatest;
  float width = max(sqrt(from_center_dx * from_center_dx + from_center_dy * from_center_dy), 1e-7);
  float sum = (0.11 - from_center) / width + 0.5;
  float near = clamp(sum, 0.0, 1.0);
  bool test = sum < 0.0;
  bool test2 = sum > 1.0;
  float near_dx = test ? 0.0 : test2 ? 0.0 : -from_center_dx / width;
  float near_dy = test ? 0.0 : test2 ? 0.0 : -from_center_dy / width;
  vec2 pixel = sqrt(uv_dx * uv_dx + uv_dy * uv_dy);
  float far = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  float difference2 = 1.0 - far;
  result_dx = near_dx * difference2;
  result_dy = near_dy * difference2;
  return mix(near, 0.038013272, far);
}

// square_wave (math/square_wave.glsl)
float square_wave(float phase, float phase_dx, float phase_dy, out float result_dx,
    out float result_dy) {
  float root = sqrt(phase_dx * phase_dx + phase_dy * phase_dy);
  float width = max(root, 1e-7);
  float difference = fract(phase - 0.36 + 0.5) - 0.5;
  float from_middle = abs(difference);
  float direction = sign(difference);
  float from_middle_dx = phase_dx * direction;
  float from_middle_dy = phase_dy * direction;
  float choice, choice2, choice3;
  if (width < 0.27999997) {
    float sum = (0.36 - from_middle) / width + 0.5;
    bool test = sum < 0.0;
    bool test2 = sum > 1.0;
    choice = clamp(sum, 0.0, 1.0);
    choice2 = test ? 0.0 : test2 ? 0.0 : -from_middle_dx / width;
    choice3 = test ? 0.0 : test2 ? 0.0 : -from_middle_dy / width;
  } else {
    float wide = max(root, 0.0001);
    float low = fract(phase - 0.5 * wide);
    float high = low + wide;
    float whole = floor(high);
    float difference2 = high - whole;
    bool test = difference2 > 0.72;
    bool test2 = low > 0.72;
    float covered = whole * 0.72 + min(difference2, 0.72) - min(low, 0.72);
    float covered_dx = (test ? 0.0 : phase_dx) - (test2 ? 0.0 : phase_dx);
    float covered_dy = (test ? 0.0 : phase_dy) - (test2 ? 0.0 : phase_dy);
    float ratio = covered / wide;
    bool test3 = ratio < 0.0;
    bool test4 = ratio > 1.0;
    choice = clamp(ratio, 0.0, 1.0);
    choice2 = test3 ? 0.0 : test4 ? 0.0 : covered_dx / wide;
    choice3 = test3 ? 0.0 : test4 ? 0.0 : covered_dy / wide;
  }
  result_dx = choice2;
  result_dy = choice3;
  return choice;
}

// threshold (math/threshold.glsl)
float threshold_upper(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float greatest = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float sum = value / greatest + 0.5;
  bool test = sum < 0.0;
  bool test2 = sum > 1.0;
  result_dx = test ? 0.0 : test2 ? 0.0 : value_dx / greatest;
  result_dy = test ? 0.0 : test2 ? 0.0 : value_dy / greatest;
  return clamp(sum, 0.0, 1.0);
}

// gradient_radial (patterns/gradient_radial.glsl)
float gradient_radial(vec2 uv, vec2 center, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 difference = uv - center;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float result_dx2, result_dy2;
  float spread_range_value = spread_range(norm * 2.0, dot(difference, uv_dx) / greatest * 2.0,
      dot(difference, uv_dy) / greatest * 2.0, result_dx2, result_dy2);
  result_dx = result_dx2;
  result_dy = result_dy2;
  return spread_range_value;
}

// blend (layers/blend.glsl)
vec4 blend(vec4 foreground, vec4 background, vec4 foreground_dx, vec4 foreground_dy,
    vec4 background_dx, vec4 background_dy, out vec4 result_dx, out vec4 result_dy) {
  float front = foreground.w * 0.5;
  float both = mix(background.w, 1.0, front);
  float front_dx = foreground_dx.w * 0.5;
  float front_dy = foreground_dy.w * 0.5;
  float difference = 1.0 - background.w;
  float both_dx = mix(background_dx.w, 0.0, front) + difference * front_dx;
  float both_dy = mix(background_dy.w, 0.0, front) + difference * front_dy;
  vec3 sum = background_dx.xyz * foreground.xyz + background.xyz * foreground_dx.xyz;
  vec3 sum2 = background_dy.xyz * foreground.xyz + background.xyz * foreground_dy.xyz;
  vec3 blended = background.xyz + foreground.xyz - background.xyz * foreground.xyz;
  vec3 blended_dx = background_dx.xyz + foreground_dx.xyz - sum;
  vec3 blended_dy = background_dy.xyz + foreground_dy.xyz - sum2;
  vec3 color = mix(foreground.xyz, blended, background.w);
  vec3 difference2 = blended - foreground.xyz;
  vec3 color_dx = mix(foreground_dx.xyz, blended_dx, background.w) + difference2 * background_dx.w;
  vec3 color_dy = mix(foreground_dy.xyz, blended_dy, background.w) + difference2 * background_dy.w;
  float greatest = max(both, 1e-20);
  bool test = both < 1e-20;
  float ratio = front / greatest;
  vec3 difference3 = color - background.xyz;
  vec3 product = difference3 * ((front_dx - ratio * (test ? 0.0 : both_dx)) / greatest);
  vec3 product2 = difference3 * ((front_dy - ratio * (test ? 0.0 : both_dy)) / greatest);
  result_dx = vec4(mix(background_dx.xyz, color_dx, ratio) + product, both_dx);
  result_dy = vec4(mix(background_dy.xyz, color_dy, ratio) + product2, both_dy);
  return vec4(mix(background.xyz, color, ratio), both);
}

// hash (random/hash.glsl)
uvec2 hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float gradient_noise(float uv, float uv_dx, float uv_dy, out float result_dx, out float result_dy) {
  float base = floor(uv);
  float t = uv - base;
  float product = t * t;
  float product2 = product * t;
  float product3 = t * 6.0;
  float difference = product3 - 15.0;
  float sum = t * difference + 10.0;
  float fade = product2 * sum;
  float fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cells = uvec2(uint(int(base)), uint(int(base)) + 1u);
  vec2 slopes = vec2(ivec2(hash(cells + 129708002u))) * 4.656613e-10;
  vec2 ends = slopes * vec2(t, t - 1.0);
  vec2 ends_dx = uv_dx * slopes;
  vec2 ends_dy = uv_dy * slopes;
  float fade_dx = uv_dx * fade_slope;
  float fade_dy = uv_dy * fade_slope;
  float difference2 = ends.y - ends.x;
  result_dx = mix(ends_dx.x, ends_dx.y, fade) + difference2 * fade_dx;
  result_dy = mix(ends_dy.x, ends_dy.y, fade) + difference2 * fade_dy;
  return mix(ends.x, ends.y, fade) + 0.5;
}

// fbm (noise/fbm.glsl)
float fbm(float uv, float uv_dx, float uv_dy, out float result_dx, out float result_dy) {
  float p = uv * 3.0;
  float width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 3.0;
  float p_dx = uv_dx * 3.0;
  float p_dy = uv_dy * 3.0;
  float weight = 0.516129;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 5; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_value = gradient_noise(p * frequency + shift, p_dx * frequency,
          p_dy * frequency, result_dx2, result_dy2);
      sum += product * (gradient_noise_value - 0.5);
      sum_dx += result_dx2 * product;
      sum_dy += result_dy2 * product;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// range_of_hills (function of the graph)
float range_of_hills(vec2 uv, float base, float high, float offset, vec2 uv_dx, vec2 uv_dy,
    out float result_dx, out float result_dy) {
  // moved: add (math/add.glsl)
  float moved = uv.x + offset;
  // perlin: hill_noise (function of the graph)
  float perlin_dx, perlin_dy;
  float perlin = fbm(moved, uv_dx.x, uv_dy.x, perlin_dx, perlin_dy);
  // rise: multiply (math/multiply.glsl)
  float rise = perlin * high;
  // crest: add (math/add.glsl)
  float crest = rise + base;
  // above: subtract (math/subtract.glsl)
  float above = crest - uv.y;
  float crest_dx = perlin_dx * high;
  float crest_dy = perlin_dy * high;
  float above_dx = crest_dx - uv_dx.y;
  float above_dy = crest_dy - uv_dy.y;
  // mask: threshold (math/threshold.glsl)
  float mask_dx, mask_dy;
  float mask = threshold_upper(above, above_dx, above_dy, mask_dx, mask_dy);
  result_dx = mask_dx;
  result_dy = mask_dy;
  return mask;
}

// hash (random/hash.glsl)
uvec4 hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float gradient_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * vec2(5.0, 60.0);
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * vec2(5.0, 60.0);
  vec2 t_dy = uv_dy * vec2(5.0, 60.0);
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint sum2 = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 2131687100u);
  uvec4 hash_value = hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = t_dx.x * x + t_dx.y * y;
  vec4 corners_dy = t_dy.x * x + t_dy.y * y;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * vec2(5.0, 60.0);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float amplitude = 0.9340967 * (1.0 - blur);
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  vec2 blend2 = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum3 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum4 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend2.y - blend2.x;
  result_dx = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dx.y) * amplitude;
  result_dy = (mix(sum4.x, sum4.y, fade.y) + difference3 * fade_dy.y) * amplitude;
  return mix(blend2.x, blend2.y, fade.y) * amplitude + 0.5;
}

// land_at (a function of uv)
vec4 land_at(vec2 uv, vec2 sun_place, vec2 uv_dx, vec2 uv_dy, out vec4 result_dx,
    out vec4 result_dy) {
  // shore: mirror (coordinates/mirror.glsl)
  vec2 shore_dx, shore_dy;
  vec2 shore = mirror(uv, uv_dx, uv_dy, shore_dx, shore_dy);
  // height: gradient_linear (patterns/gradient_linear.glsl)
  float height_dx, height_dy;
  float height = gradient_linear(shore, vec2(0.0, 0.36), vec2(0.0, 1.0), shore_dx, shore_dy,
      height_dx, height_dy);
  // sky: color_ramp (color/color_ramp.glsl)
  vec4 sky_dx, sky_dy;
  vec4 sky = color_ramp(height, height_dx, height_dy, sky_dx, sky_dy);
  // sun: circle (patterns/circle.glsl)
  float sun_dx, sun_dy;
  float sun = circle(shore, sun_place, shore_dx, shore_dy, sun_dx, sun_dy);
  // stripe_phase: multiply (math/multiply.glsl)
  float stripe_phase = shore.y * 34.0;
  // stripes: square_wave (math/square_wave.glsl)
  float stripe_phase_dx = shore_dx.y * 34.0;
  float stripe_phase_dy = shore_dy.y * 34.0;
  float stripes_dx, stripes_dy;
  float stripes = square_wave(stripe_phase, stripe_phase_dx, stripe_phase_dy, stripes_dx,
      stripes_dy);
  // high_up: subtract (math/subtract.glsl)
  float high_up = shore.y - sun_height;
  // upper: threshold (math/threshold.glsl)
  float upper_dx, upper_dy;
  float upper = threshold_upper(high_up, shore_dx.y, shore_dy.y, upper_dx, upper_dy);
  // bands: maximum (math/maximum.glsl)
  float bands = max(stripes, upper);
  bool test = stripes < upper;
  float bands_dx = test ? upper_dx : stripes_dx;
  float bands_dy = test ? upper_dy : stripes_dy;
  // disc: multiply (math/multiply.glsl)
  float disc = sun * bands;
  float disc_dx = sun_dx * bands + sun * bands_dx;
  float disc_dy = sun_dy * bands + sun * bands_dy;
  // sun_shade: gradient_linear (patterns/gradient_linear.glsl)
  float sun_shade_dx, sun_shade_dy;
  float sun_shade = gradient_linear(shore, vec2(0.0, 0.45), vec2(0.0, 0.67), shore_dx, shore_dy,
      sun_shade_dx, sun_shade_dy);
  // sun_color: lerp (math/lerp.glsl)
  vec4 sun_color = mix(vec4(1.0, 0.16, 0.12, 1.0), vec4(1.0, 0.86, 0.28, 1.0), sun_shade);
  // glow: gradient_radial (patterns/gradient_radial.glsl)
  float glow_dx, glow_dy;
  float glow = gradient_radial(shore, sun_place, shore_dx, shore_dy, glow_dx, glow_dy);
  // near: invert (math/invert.glsl)
  float near = 1.0 - glow;
  // haze: power (math/power.glsl)
  float greatest = max(near, 1e-37);
  float near_dx = -glow_dx;
  float near_dy = -glow_dy;
  bool test2 = near < 1e-37;
  float haze = pow(greatest, 3.0);
  float product = 3.0 * (haze / greatest);
  float haze_dx = product * (test2 ? 0.0 : near_dx);
  float haze_dy = product * (test2 ? 0.0 : near_dy);
  // haze_color: rgba (channels/rgba.glsl)
  vec4 haze_color = vec4(1.0, 0.35, 0.12, haze);
  vec4 haze_color_dx = vec4(0.0, 0.0, 0.0, haze_dx);
  vec4 haze_color_dy = vec4(0.0, 0.0, 0.0, haze_dy);
  // hazy: blend (layers/blend.glsl)
  vec4 hazy_dx, hazy_dy;
  vec4 hazy = blend(haze_color, sky, haze_color_dx, haze_color_dy, sky_dx, sky_dy, hazy_dx,
      hazy_dy);
  // sunny: lerp (math/lerp.glsl)
  vec4 sunny = mix(hazy, sun_color, disc);
  vec4 sun_color_dx = sun_shade_dx * vec4(0.0, 0.70000005, 0.16, 0.0);
  vec4 sun_color_dy = sun_shade_dy * vec4(0.0, 0.70000005, 0.16, 0.0);
  vec4 difference = sun_color - hazy;
  vec4 sunny_dx = mix(hazy_dx, sun_color_dx, disc) + difference * disc_dx;
  vec4 sunny_dy = mix(hazy_dy, sun_color_dy, disc) + difference * disc_dy;
  // far_hills: range_of_hills (function of the graph)
  float far_hills_dx, far_hills_dy;
  float far_hills = range_of_hills(shore, 0.31, 0.34, 7.0, shore_dx, shore_dy, far_hills_dx,
      far_hills_dy);
  // near_hills: range_of_hills (function of the graph)
  float near_hills_dx, near_hills_dy;
  float near_hills = range_of_hills(shore, 0.2, 0.38, 1.5, shore_dx, shore_dy, near_hills_dx,
      near_hills_dy);
  // behind: lerp (math/lerp.glsl)
  vec4 behind = mix(sunny, vec4(0.17, 0.035, 0.12, 1.0), far_hills);
  vec4 difference2 = vec4(0.17, 0.035, 0.12, 1.0) - sunny;
  vec4 behind_dx = mix(sunny_dx, vec4(0.0), far_hills) + difference2 * far_hills_dx;
  vec4 behind_dy = mix(sunny_dy, vec4(0.0), far_hills) + difference2 * far_hills_dy;
  // land: lerp (math/lerp.glsl)
  vec4 land = mix(behind, vec4(0.03, 0.012, 0.05, 1.0), near_hills);
  vec4 difference3 = vec4(0.03, 0.012, 0.05, 1.0) - behind;
  result_dx = mix(behind_dx, vec4(0.0), near_hills) + difference3 * near_hills_dx;
  result_dy = mix(behind_dy, vec4(0.0), near_hills) + difference3 * near_hills_dy;
  return land;
}

// threshold (math/threshold.glsl)
float threshold_is_land(float value, float value_dx, float value_dy, out float result_dx,
    out float result_dy) {
  float greatest = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float sum = (value - 0.36) / greatest + 0.5;
  bool test = sum < 0.0;
  bool test2 = sum > 1.0;
  result_dx = test ? 0.0 : test2 ? 0.0 : value_dx / greatest;
  result_dy = test ? 0.0 : test2 ? 0.0 : value_dy / greatest;
  return clamp(sum, 0.0, 1.0);
}

// view_at (a function of uv)
vec4 view_at(vec2 uv, vec2 sun_place, vec2 uv_dx, vec2 uv_dy, out vec4 result_dx,
    out vec4 result_dy) {
  // shore: mirror (coordinates/mirror.glsl)
  vec2 shore_dx, shore_dy;
  vec2 shore = mirror(uv, uv_dx, uv_dy, shore_dx, shore_dy);
  // height: gradient_linear (patterns/gradient_linear.glsl)
  float height_dx, height_dy;
  float height = gradient_linear(shore, vec2(0.0, 0.36), vec2(0.0, 1.0), shore_dx, shore_dy,
      height_dx, height_dy);
  // sky: color_ramp (color/color_ramp.glsl)
  vec4 sky_dx, sky_dy;
  vec4 sky = color_ramp(height, height_dx, height_dy, sky_dx, sky_dy);
  // sun: circle (patterns/circle.glsl)
  float sun_dx, sun_dy;
  float sun = circle(shore, sun_place, shore_dx, shore_dy, sun_dx, sun_dy);
  // stripe_phase: multiply (math/multiply.glsl)
  float stripe_phase = shore.y * 34.0;
  // stripes: square_wave (math/square_wave.glsl)
  float stripe_phase_dx = shore_dx.y * 34.0;
  float stripe_phase_dy = shore_dy.y * 34.0;
  float stripes_dx, stripes_dy;
  float stripes = square_wave(stripe_phase, stripe_phase_dx, stripe_phase_dy, stripes_dx,
      stripes_dy);
  // high_up: subtract (math/subtract.glsl)
  float high_up = shore.y - sun_height;
  // upper: threshold (math/threshold.glsl)
  float upper_dx, upper_dy;
  float upper = threshold_upper(high_up, shore_dx.y, shore_dy.y, upper_dx, upper_dy);
  // bands: maximum (math/maximum.glsl)
  float bands = max(stripes, upper);
  bool test = stripes < upper;
  float bands_dx = test ? upper_dx : stripes_dx;
  float bands_dy = test ? upper_dy : stripes_dy;
  // disc: multiply (math/multiply.glsl)
  float disc = sun * bands;
  float disc_dx = sun_dx * bands + sun * bands_dx;
  float disc_dy = sun_dy * bands + sun * bands_dy;
  // sun_shade: gradient_linear (patterns/gradient_linear.glsl)
  float sun_shade_dx, sun_shade_dy;
  float sun_shade = gradient_linear(shore, vec2(0.0, 0.45), vec2(0.0, 0.67), shore_dx, shore_dy,
      sun_shade_dx, sun_shade_dy);
  // sun_color: lerp (math/lerp.glsl)
  vec4 sun_color = mix(vec4(1.0, 0.16, 0.12, 1.0), vec4(1.0, 0.86, 0.28, 1.0), sun_shade);
  // glow: gradient_radial (patterns/gradient_radial.glsl)
  float glow_dx, glow_dy;
  float glow = gradient_radial(shore, sun_place, shore_dx, shore_dy, glow_dx, glow_dy);
  // near: invert (math/invert.glsl)
  float near = 1.0 - glow;
  // haze: power (math/power.glsl)
  float greatest = max(near, 1e-37);
  float near_dx = -glow_dx;
  float near_dy = -glow_dy;
  bool test2 = near < 1e-37;
  float haze = pow(greatest, 3.0);
  float product = 3.0 * (haze / greatest);
  float haze_dx = product * (test2 ? 0.0 : near_dx);
  float haze_dy = product * (test2 ? 0.0 : near_dy);
  // haze_color: rgba (channels/rgba.glsl)
  vec4 haze_color = vec4(1.0, 0.35, 0.12, haze);
  vec4 haze_color_dx = vec4(0.0, 0.0, 0.0, haze_dx);
  vec4 haze_color_dy = vec4(0.0, 0.0, 0.0, haze_dy);
  // hazy: blend (layers/blend.glsl)
  vec4 hazy_dx, hazy_dy;
  vec4 hazy = blend(haze_color, sky, haze_color_dx, haze_color_dy, sky_dx, sky_dy, hazy_dx,
      hazy_dy);
  // sunny: lerp (math/lerp.glsl)
  vec4 sunny = mix(hazy, sun_color, disc);
  vec4 sun_color_dx = sun_shade_dx * vec4(0.0, 0.70000005, 0.16, 0.0);
  vec4 sun_color_dy = sun_shade_dy * vec4(0.0, 0.70000005, 0.16, 0.0);
  vec4 difference = sun_color - hazy;
  vec4 sunny_dx = mix(hazy_dx, sun_color_dx, disc) + difference * disc_dx;
  vec4 sunny_dy = mix(hazy_dy, sun_color_dy, disc) + difference * disc_dy;
  // far_hills: range_of_hills (function of the graph)
  float far_hills_dx, far_hills_dy;
  float far_hills = range_of_hills(shore, 0.31, 0.34, 7.0, shore_dx, shore_dy, far_hills_dx,
      far_hills_dy);
  // near_hills: range_of_hills (function of the graph)
  float near_hills_dx, near_hills_dy;
  float near_hills = range_of_hills(shore, 0.2, 0.38, 1.5, shore_dx, shore_dy, near_hills_dx,
      near_hills_dy);
  // behind: lerp (math/lerp.glsl)
  vec4 behind = mix(sunny, vec4(0.17, 0.035, 0.12, 1.0), far_hills);
  vec4 difference2 = vec4(0.17, 0.035, 0.12, 1.0) - sunny;
  vec4 behind_dx = mix(sunny_dx, vec4(0.0), far_hills) + difference2 * far_hills_dx;
  vec4 behind_dy = mix(sunny_dy, vec4(0.0), far_hills) + difference2 * far_hills_dy;
  // land: lerp (math/lerp.glsl)
  vec4 land = mix(behind, vec4(0.03, 0.012, 0.05, 1.0), near_hills);
  vec4 difference3 = vec4(0.03, 0.012, 0.05, 1.0) - behind;
  vec4 land_dx = mix(behind_dx, vec4(0.0), near_hills) + difference3 * near_hills_dx;
  vec4 land_dy = mix(behind_dy, vec4(0.0), near_hills) + difference3 * near_hills_dy;
  // swell: gradient_noise (noise/gradient_noise.glsl)
  float swell_dx, swell_dy;
  float swell = gradient_noise(uv, uv_dx, uv_dy, swell_dx, swell_dy);
  // waving: directional_warp (filters/directional_warp.glsl)
  vec4 waving_dx, waving_dy;
  vec4 waving = land_at(uv + 0.07 * (swell - 0.5) * vec2(1.0, 0.0), sun_place,
      uv_dx + swell_dx * 0.07 * vec2(1.0, 0.0), uv_dy + swell_dy * 0.07 * vec2(1.0, 0.0), waving_dx,
      waving_dy);
  // below: brightness_contrast (color/brightness_contrast.glsl)
  vec4 below = vec4((waving.xyz - 0.02) * 0.62 + 0.02, waving.w);
  vec4 below_dx = vec4(waving_dx.xyz * 0.62, waving_dx.w);
  vec4 below_dy = vec4(waving_dy.xyz * 0.62, waving_dy.w);
  // is_land: threshold (math/threshold.glsl)
  float is_land_dx, is_land_dy;
  float is_land = threshold_is_land(uv.y, uv_dx.y, uv_dy.y, is_land_dx, is_land_dy);
  // view: lerp (math/lerp.glsl)
  vec4 view = mix(below, land, is_land);
  vec4 difference4 = land - below;
  result_dx = mix(below_dx, land_dx, is_land) + difference4 * is_land_dx;
  result_dy = mix(below_dy, land_dy, is_land) + difference4 * is_land_dy;
  return view;
}

// pixelate (filters/pixelate.glsl)
vec4 pixelate(vec2 sun_place, vec2 uv, vec2 scale, vec2 uv_dx, vec2 uv_dy, out vec4 result_dx,
    out vec4 result_dy) {
  vec2 p = uv * scale;
  vec2 pixel = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * scale;
  vec2 seen = clamp(pixel, 1e-6, 1.0);
  vec2 product = 0.5 * seen;
  vec2 low = floor(p - product);
  vec2 ratio = (p + product - low - 1.0) / seen;
  vec2 p_dx = uv_dx * scale;
  vec2 p_dy = uv_dy * scale;
  vec2 next = clamp(ratio, 0.0, 1.0);
  bvec2 test = lessThan(ratio, vec2(0.0));
  bvec2 test2 = lessThan(vec2(1.0), ratio);
  vec2 next_dx = mix(mix(p_dx / seen, vec2(0.0), test2), vec2(0.0), test);
  vec2 next_dy = mix(mix(p_dy / seen, vec2(0.0), test2), vec2(0.0), test);
  vec2 width = max(pixel, 1.0) / scale;
  vec4 sum = vec4(0.0);
  vec4 sum_dx = vec4(0.0);
  vec4 sum_dy = vec4(0.0);
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 2; ++x) {
      bool test3 = x == 0;
      float choice = test3 ? 1.0 - next.x : next.x;
      bool test4 = y == 0;
      float choice2 = test4 ? 1.0 - next.y : next.y;
      vec2 place = (low + vec2(float(x), float(y)) + 0.5) / scale;
      float sum2 = (test3 ? -next_dx.x : next_dx.x) * choice2
          + choice * (test4 ? -next_dx.y : next_dx.y);
      float sum3 = (test3 ? -next_dy.x : next_dy.x) * choice2
          + choice * (test4 ? -next_dy.y : next_dy.y);
      vec4 vector = vec4(choice * choice2);
      vec2 result_dx2, result_dy2;
      vec2 widen_value = widen(place, width, uv, uv_dx, uv_dy, result_dx2, result_dy2);
      vec4 result_dx3, result_dy3;
      vec4 view_at_value = view_at(widen_value, sun_place, result_dx2, result_dy2, result_dx3,
          result_dy3);
      vec4 vector2 = vec4(view_at_value.xyz * view_at_value.w, view_at_value.w);
      vec4 vector3 = vec4(result_dx3.xyz * view_at_value.w + view_at_value.xyz * result_dx3.w,
          result_dx3.w);
      vec4 vector4 = vec4(result_dy3.xyz * view_at_value.w + view_at_value.xyz * result_dy3.w,
          result_dy3.w);
      sum += vector * vector2;
      sum_dx += sum2 * vector2 + vector * vector3;
      sum_dy += sum3 * vector2 + vector * vector4;
    }
  }
  bool test3 = sum.w < 1e-20;
  vec3 vector = vec3(max(sum.w, 1e-20));
  vec3 ratio2 = sum.xyz / vector;
  result_dx = vec4((sum_dx.xyz - ratio2 * (test3 ? 0.0 : sum_dx.w)) / vector, sum_dx.w);
  result_dy = vec4((sum_dy.xyz - ratio2 * (test3 ? 0.0 : sum_dy.w)) / vector, sum_dy.w);
  return vec4(ratio2, sum.w);
}

// quantize (math/quantize.glsl)
vec4 quantize(vec4 value, float steps, vec4 value_dx, vec4 value_dy) {
  vec4 place = value * steps + 0.5;
  vec4 width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * abs(steps), 1e-6);
  vec4 product = 0.5 * width;
  vec4 first = floor(place - product);
  vec4 high = place + product - first;
  vec4 jumps = floor(high);
  vec4 sum = first + jumps * (high - 0.5 * (jumps + 1.0)) / width;
  return sum / steps;
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // sun_place: combine2 (channels/combine2.glsl)
  vec2 sun_place = vec2(0.5, sun_height);
  // coarse: pixelate (filters/pixelate.glsl)
  vec4 coarse_dx, coarse_dy;
  vec4 coarse = pixelate(sun_place, uv, vec2(pixels), uv_dx, uv_dy, coarse_dx, coarse_dy);
  // light: square_root (math/square_root.glsl)
  vec4 greatest = max(coarse, 0.0);
  bvec4 test = lessThan(coarse, vec4(0.0));
  vec4 light = sqrt(greatest);
  bvec4 test2 = lessThan(vec4(0.0), greatest);
  vec4 greatest2 = max(light, 1e-20);
  vec4 light_dx = mix(vec4(0.0), 0.5 * mix(coarse_dx, vec4(0.0), test) / greatest2, test2);
  vec4 light_dy = mix(vec4(0.0), 0.5 * mix(coarse_dy, vec4(0.0), test) / greatest2, test2);
  // steps: quantize (math/quantize.glsl)
  vec4 steps = quantize(light, tones, light_dx, light_dy);
  // back: multiply (math/multiply.glsl)
  vec4 back = steps * steps;
  out_color = back;
}
