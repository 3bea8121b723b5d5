// starry_sky: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform float milky_way;  // default 0.75
uniform float starlight;  // default 1.0
uniform float moonlight;  // default 1.0

// Outputs
layout(location = 0) out vec4 out_color;

// Types
struct Tile {
  uint seed;
};
struct Copy {
  uint seed;
  vec2 from;
};
struct View {
  vec3 light;
  float through;
};

// Constants
const vec2 points[5] = vec2[5](vec2(0.0), vec2(0.25, 0.3), vec2(0.5, 1.0), vec2(0.75, 0.3),
    vec2(1.0, 0.0));
const float stops[5] = float[5](0.0, 0.2, 0.5, 0.8, 1.0);
const vec4 colors[5] = vec4[5](vec4(1.0, 0.42, 0.16, 1.0), vec4(1.0, 0.72, 0.45, 1.0),
    vec4(1.0, 0.93, 0.84, 1.0), vec4(0.8, 0.88, 1.0, 1.0), vec4(0.5, 0.66, 1.0, 1.0));

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
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 2161170183u);
  uvec4 hash_value = hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
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
  vec2 blend2 = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum3 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum4 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend2.y - blend2.x;
  result_dx = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dx.y) * amplitude;
  result_dy = (mix(sum4.x, sum4.y, fade.y) + difference3 * fade_dy.y) * amplitude;
  return mix(blend2.x, blend2.y, fade.y) * amplitude + 0.5;
}

// domain_warp (noise/domain_warp.glsl)
vec2 domain_warp(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx, out vec2 result_dy) {
  float result_dx2, result_dy2;
  float gradient_noise_value = gradient_noise(uv, uv_dx, uv_dy, result_dx2, result_dy2);
  float result_dx3, result_dy3;
  float gradient_noise_value2 = gradient_noise(uv + 37.7, uv_dx, uv_dy, result_dx3, result_dy3);
  vec2 place = uv + 0.1 * (2.0 * vec2(gradient_noise_value, gradient_noise_value2) - 1.0);
  result_dx = uv_dx + vec2(result_dx2, result_dx3) * 0.2;
  result_dy = uv_dy + vec2(result_dy2, result_dy3) * 0.2;
  return place;
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
float gradient_linear(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  float result_dx2, result_dy2;
  float spread_range_value = spread_range(dot(uv - vec2(0.24, 0.97), vec2(0.65999997, -0.66))
      / 0.87119997, dot(uv_dx, vec2(0.65999997, -0.66)) / 0.87119997,
      dot(uv_dy, vec2(0.65999997, -0.66)) / 0.87119997, result_dx2, result_dy2);
  result_dx = result_dx2;
  result_dy = result_dy2;
  return spread_range_value;
}

// secant, of curve (math/curve.glsl)
float secant(int i) {
  vec2 way = points[clamp(i + 1, 0, 4)] - points[clamp(i, 0, 4)];
  return way.y / max(way.x, 1e-7);
}

// slope_at, of curve (math/curve.glsl)
float slope_at(int i) {
  int middle = clamp(i, 1, 3);
  int difference = middle - 1;
  float before = secant(difference);
  float behind = secant(middle);
  float value = points[middle].x;
  float length_before = max(value - points[clamp(difference, 0, 4)].x, 1e-7);
  float length_behind = max(points[middle + 1].x - value, 1e-7);
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
float part_mean(int i, float middle, float reach) {
  vec2 from = points[clamp(i, 0, 4)];
  int sum = i + 1;
  vec2 to = points[clamp(sum, 0, 4)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * slope_at(i) - rise;
  float end = rise - way * slope_at(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float curve(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(-value / width + 0.5, 0.0, 1.0);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    float next = clamp((points[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * part_mean(i, middle, reach);
  }
  return sum;
}

// simplex_noise (noise/simplex_noise.glsl)
float simplex_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 base = floor(uv + (uv.x + uv.y) * 0.36602542);
  vec2 a = uv - base + (base.x + base.y) * 0.21132487;
  bool lower = a.y < a.x;
  vec2 b = a - (lower ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) + 0.21132487;
  vec2 c = a - 1.0 + 0.42264974;
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 columns = uvec2(cell.x, sum);
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uint middle = lower ? sum + rows.x : cell.x + rows.y;
  uvec2 ends = columns + rows;
  uvec4 hash_value = hash(uvec4(ends.x, middle, ends.yy));
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec3 dx = vec3(a.x, b.x, c.x);
  vec3 dy = vec3(a.y, b.y, c.y);
  vec3 negative = -(dx + dx);
  vec3 sum2 = dy + dy;
  vec3 difference = 0.5 - dx * dx - dy * dy;
  vec3 r = max(difference, 0.0);
  bvec3 test = lessThan(difference, vec3(0.0));
  vec3 r_dx = mix(uv_dx.x * negative - uv_dx.y * sum2, vec3(0.0), test);
  vec3 r_dy = mix(uv_dy.x * negative - uv_dy.y * sum2, vec3(0.0), test);
  vec3 r2 = r * r;
  vec3 r2_slope = r + r;
  vec3 reach = r2 * r2;
  vec3 product = r2_slope * r2;
  vec3 reach_slope = product + product;
  vec3 along = x.xyz * dx + y.xyz * dy;
  vec3 along_dx = uv_dx.x * x.xyz + uv_dx.y * y.xyz;
  vec3 along_dy = uv_dy.x * x.xyz + uv_dy.y * y.xyz;
  vec3 reach_dx = r_dx * reach_slope;
  vec3 reach_dy = r_dy * reach_slope;
  result_dx = (dot(reach_dx, along) + dot(reach, along_dx)) * 51.16832;
  result_dy = (dot(reach_dy, along) + dot(reach, along_dy)) * 51.16832;
  return dot(reach, along) * 51.16832 + 0.5;
}

// fbm (noise/fbm.glsl)
float fbm_clouds(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 7.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 7.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 7.0;
  vec2 p_dy = uv_dy * 7.0;
  float weight = 0.4195757;
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
      float simplex_noise_value = simplex_noise(p * frequency + shift, p_dx * frequency,
          p_dy * frequency, result_dx2, result_dy2);
      sum += product2 * (simplex_noise_value - 0.5);
      sum_dx += result_dx2 * product2;
      sum_dy += result_dy2 * product2;
    }
    weight *= 0.6;
    frequency *= 2.0;
    shift += 37.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// level_glow, of levels (color/levels.glsl)
float level_glow(float value, float value_dx, float value_dy) {
  float t = (value - 0.25) * 2.0;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 2.0, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// ridged (noise/ridged.glsl)
float ridged(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
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
    float ridge = 0.423;
    float ridge_dx = 0.0;
    float ridge_dy = 0.0;
    if (near > 0.0) {
      float result_dx2, result_dy2;
      float simplex_noise_value = simplex_noise(p * frequency + shift, p_dx * frequency,
          p_dy * frequency, result_dx2, result_dy2);
      float difference = 2.0 * simplex_noise_value - 1.0;
      float direction = sign(difference);
      float height = 1.0 - abs(difference);
      float height_dx = -(result_dx2 * 2.0 * direction);
      float height_dy = -(result_dy2 * 2.0 * direction);
      float ridge_slope = (height + height) * near;
      ridge = mix(0.423, height * height, near);
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

// level_lanes, of levels (color/levels.glsl)
float level_lanes(float value, float value_dx, float value_dy) {
  float t = (value - 0.45) * 2.4999998;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 2.4999998, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// blend (layers/blend.glsl)
vec4 blend(vec4 foreground, vec4 background) {
  float both = mix(background.w, 1.0, foreground.w);
  vec3 blended = background.xyz + foreground.xyz;
  vec3 color = mix(foreground.xyz, blended, background.w);
  return vec4(mix(background.xyz, color, foreground.w / max(both, 1e-20)), both);
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// copy_bits (bombing/copy_bits.glsl)
uvec4 copy_bits(ivec2 cell, int copy, int seed) {
  uint first = hash(uint(seed));
  uvec2 c = uvec2(cell);
  uvec2 sum = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(first, hash(first));
  uvec2 v = sum + uint(copy) * uvec2(2654435769u, 1540483477u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at_dust_stars, of bomb (bombing/bomb.glsl)
Copy copy_at_dust_stars(vec2 p, vec2 node, int index) {
  uvec4 bits = copy_bits(ivec2(node), index, 1);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  Copy copy = Copy(bits.w, p - node - moved);
  return copy;
}

// pose_of_dust_stars, of bomb (bombing/bomb.glsl)
vec2 pose_of_dust_stars(Copy copy) {
  uint hash_value = hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(0.5, 1.0, luck.x), 0.0);
}

// crowd_at (a function of uv)
float crowd_at(vec2 uv) {
  // bent: domain_warp (noise/domain_warp.glsl)
  vec2 bent_dx, bent_dy;
  vec2 bent = domain_warp(uv, vec2(0.0), vec2(0.0), bent_dx, bent_dy);
  // across: gradient_linear (patterns/gradient_linear.glsl)
  float across_dx, across_dy;
  float across = gradient_linear(bent, bent_dx, bent_dy, across_dx, across_dy);
  // band: curve (math/curve.glsl)
  float band = curve(across, across_dx, across_dy);
  // core: power (math/power.glsl)
  float greatest = max(band, 1e-37);
  float core = greatest * greatest;
  // clouds: fbm (noise/fbm.glsl)
  float clouds_dx, clouds_dy;
  float clouds = fbm_clouds(bent, bent_dx, bent_dy, clouds_dx, clouds_dy);
  // glow: levels (color/levels.glsl)
  float glow = level_glow(clouds, clouds_dx, clouds_dy);
  // dust: ridged (noise/ridged.glsl)
  float dust_dx, dust_dy;
  float dust = ridged(bent, bent_dx, bent_dy, dust_dx, dust_dy);
  // lanes: levels (color/levels.glsl)
  float lanes = mix(1.0, 0.1, level_lanes(dust, dust_dx, dust_dy));
  // thinned: multiply (math/multiply.glsl)
  float thinned = glow * lanes;
  // shine: multiply (math/multiply.glsl)
  float shine = thinned * core;
  // crowd: remap (math/remap.glsl)
  float crowd = mix(0.4, 1.2, clamp(shine, 0.0, 1.0));
  return crowd;
}

// is_there_dust_stars, of bomb (bombing/bomb.glsl)
bool is_there_dust_stars(Copy copy, vec2 p) {
  vec2 center = p - copy.from;
  float chance = crowd_at((center + 0.5) / 90.0);
  bool test = float(hash(copy.seed - 3u) >> 8u) * 5.9604645e-8 < chance;
  bool stays = chance >= 1.0 || test;
  return stays;
}

// spread_range (math/spread_range.glsl)
float spread_range2(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(0.5 - value / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - value) / width, 0.0, 1.0);
  float middle = value + 0.5 * width * (below - above);
  return above + (1.0 - below - above) * clamp(middle, 0.0, 1.0);
}

// gradient_radial (patterns/gradient_radial.glsl)
float gradient_radial_radius(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - 0.5;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float product = dot(difference, uv_dx) / greatest * 2.0;
  return spread_range2(norm * 2.0, product, dot(difference, uv_dy) / greatest * 2.0);
}

// color_ramp (color/color_ramp.glsl)
vec4 color_ramp(float position) {
  vec4 color = vec4(1.0, 0.42, 0.16, 1.0);
  for (int i = 0; i < 4; ++i) {
    float item = stops[i];
    int sum = i + 1;
    float t = clamp((position - item) / max(stops[sum] - item, 1e-7), 0.0, 1.0);
    color = mix(color, colors[sum], t);
  }
  return color;
}

// star (function of the graph)
vec4 star(vec2 uv, Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // radius: gradient_radial (patterns/gradient_radial.glsl)
  float radius = gradient_radial_radius(uv, uv_dx, uv_dy);
  // near: invert (math/invert.glsl)
  float near = 1.0 - radius;
  // halo: power (math/power.glsl)
  float halo = pow(max(near, 1e-37), 9.0);
  // luck: tile_random (tiles/tile_random.glsl)
  float luck = float(hash(tile.seed + 1u) >> 8u) * 5.9604645e-8;
  // magnitude: power (math/power.glsl)
  float magnitude = pow(max(luck, 1e-37), 6.0);
  // light: multiply (math/multiply.glsl)
  float light = halo * magnitude;
  // heat: tile_random (tiles/tile_random.glsl)
  float heat = float(hash(tile.seed + 2u) >> 8u) * 5.9604645e-8;
  // color: color_ramp (color/color_ramp.glsl)
  vec4 color = color_ramp(heat);
  // seen: rgba (channels/rgba.glsl)
  vec4 seen = vec4(color.xyz, light);
  return seen;
}

// paint_dust_stars, of bomb (bombing/bomb.glsl)
vec4 paint_dust_stars(Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = pose_of_dust_stars(copy);
  bool test = pose.x != 0.0;
  vec2 choice = test ? copy_from_dx / pose.x : vec2(0.0);
  vec2 choice2 = test ? copy_from_dy / pose.x : vec2(0.0);
  Tile tile = Tile(copy.seed);
  vec4 seen = star(copy.from / pose.x + 0.5, tile, choice, choice2);
  seen = vec4(seen.xyz * starlight, seen.w);
  return seen;
}

// in_order_dust_stars, of bomb (bombing/bomb.glsl)
View in_order_dust_stars(vec2 p, vec2 p_dx, vec2 p_dy) {
  vec3 light = vec3(0.0);
  float through = 1.0;
  for (int i = 7; i > -1; --i) {
    int ratio = i / 2;
    vec2 node = floor(p) + vec2(ivec2(ratio % 2, ratio / 2));
    Copy copy = copy_at_dust_stars(p, node, i % 2);
    vec2 pose = pose_of_dust_stars(copy);
    bool test = dot(copy.from, copy.from) < 0.25 * pose.x * pose.x && is_there_dust_stars(copy, p);
    if (test) {
      vec4 seen = paint_dust_stars(copy, p_dx, p_dy);
      vec3 own = seen.xyz * seen.w;
      light += own;
      through -= seen.w;
    }
  }
  return View(light, max(through, 0.0));
}

// bomb (bombing/bomb.glsl)
vec4 bomb_dust_stars(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 90.0 - 0.5;
  vec2 p_dx = uv_dx * 90.0;
  vec2 p_dy = uv_dy * 90.0;
  View view = in_order_dust_stars(p, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

// copy_at_stars, of bomb (bombing/bomb.glsl)
Copy copy_at_stars(vec2 p, vec2 node, int index) {
  uvec4 bits = copy_bits(ivec2(node), index, 2);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  Copy copy = Copy(bits.w, p - node - moved);
  return copy;
}

// pose_of_stars, of bomb (bombing/bomb.glsl)
vec2 pose_of_stars(Copy copy) {
  uint hash_value = hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(0.3, 0.75, luck.x), 0.0);
}

// paint_stars, of bomb (bombing/bomb.glsl)
vec4 paint_stars(Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = pose_of_stars(copy);
  bool test = pose.x != 0.0;
  vec2 choice = test ? copy_from_dx / pose.x : vec2(0.0);
  vec2 choice2 = test ? copy_from_dy / pose.x : vec2(0.0);
  Tile tile = Tile(copy.seed);
  vec4 seen = star(copy.from / pose.x + 0.5, tile, choice, choice2);
  seen = vec4(seen.xyz * starlight, seen.w);
  return seen;
}

// in_order_stars, of bomb (bombing/bomb.glsl)
View in_order_stars(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec3 light = vec3(0.0);
  float through = 1.0;
  for (int i = 7; i > -1; --i) {
    int ratio = i / 2;
    vec2 node = floor(low) + vec2(ivec2(ratio % 2, ratio / 2));
    Copy copy = copy_at_stars(p, node, i % 2);
    vec2 pose = pose_of_stars(copy);
    if (dot(copy.from, copy.from) < 0.25 * pose.x * pose.x) {
      vec4 seen = paint_stars(copy, p_dx, p_dy);
      vec3 own = seen.xyz * seen.w;
      light += own;
      through -= seen.w;
    }
  }
  return View(light, max(through, 0.0));
}

// bomb (bombing/bomb.glsl)
vec4 bomb_stars(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 26.0 - 0.5;
  vec2 low = p + 0.125;
  vec2 p_dx = uv_dx * 26.0;
  vec2 p_dy = uv_dy * 26.0;
  View view = in_order_stars(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

// copy_at_bright, of bomb (bombing/bomb.glsl)
Copy copy_at_bright(vec2 p, vec2 node) {
  uvec4 bits = copy_bits(ivec2(node), 0, 3);
  vec2 moved = vec2(ivec2(bits.xy)) * 2.3283064e-10;
  Copy copy = Copy(bits.w, p - node - moved);
  return copy;
}

// pose_of_bright, of bomb (bombing/bomb.glsl)
vec2 pose_of_bright(Copy copy) {
  uint hash_value = hash(copy.seed - 2u);
  vec2 luck = vec2(float(hash_value & 65535u), float(hash_value >> 16u)) * 1.5258789e-5;
  return vec2(mix(0.35, 0.6, luck.x), 0.0);
}

// is_there_bright, of bomb (bombing/bomb.glsl)
bool is_there_bright(Copy copy) {
  bool stays = float(hash(copy.seed - 3u) >> 8u) * 5.9604645e-8 < 0.6;
  return stays;
}

// level_thin, of levels (color/levels.glsl)
float level_thin(float value, float value_dx, float value_dy) {
  float t = (value - 0.012) * -83.333336;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 83.333336, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// bright_star (function of the graph)
vec4 bright_star(vec2 uv, Tile tile, vec2 uv_dx, vec2 uv_dy) {
  // body: star (function of the graph)
  vec4 body = star(uv, tile, uv_dx, uv_dy);
  // arm: add (math/add.glsl)
  vec2 arm = uv - 0.5;
  // away: absolute (math/absolute.glsl)
  vec2 away = abs(arm);
  vec2 direction = sign(arm);
  vec2 away_dx = uv_dx * direction;
  vec2 away_dy = uv_dy * direction;
  // from_axis: minimum (math/minimum.glsl)
  float from_axis = min(away.x, away.y);
  bool test = away.y < away.x;
  float from_axis_dx = test ? away_dx.y : away_dx.x;
  float from_axis_dy = test ? away_dy.y : away_dy.x;
  // thin: levels (color/levels.glsl)
  float thin = level_thin(from_axis, from_axis_dx, from_axis_dy);
  // radius: gradient_radial (patterns/gradient_radial.glsl)
  float radius = gradient_radial_radius(uv, uv_dx, uv_dy);
  // near: invert (math/invert.glsl)
  float near = 1.0 - radius;
  // fall: power (math/power.glsl)
  float fall = pow(max(near, 1e-37), 3.0);
  // rays: multiply (math/multiply.glsl)
  float rays = thin * fall;
  // faint: multiply (math/multiply.glsl)
  float faint = rays * 0.35;
  // light: add (math/add.glsl)
  float light = body.w + faint;
  // seen: rgba (channels/rgba.glsl)
  vec4 seen = vec4(body.xyz, light);
  return seen;
}

// paint_bright, of bomb (bombing/bomb.glsl)
vec4 paint_bright(Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  vec2 pose = pose_of_bright(copy);
  bool test = pose.x != 0.0;
  vec2 choice = test ? copy_from_dx / pose.x : vec2(0.0);
  vec2 choice2 = test ? copy_from_dy / pose.x : vec2(0.0);
  Tile tile = Tile(copy.seed);
  vec4 seen = bright_star(copy.from / pose.x + 0.5, tile, choice, choice2);
  seen = vec4(seen.xyz * starlight, seen.w);
  return seen;
}

// in_order_bright, of bomb (bombing/bomb.glsl)
View in_order_bright(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  vec3 light = vec3(0.0);
  float through = 1.0;
  for (int i = 3; i > -1; --i) {
    vec2 node = floor(low) + vec2(ivec2(i % 2, i / 2));
    Copy copy = copy_at_bright(p, node);
    vec2 pose = pose_of_bright(copy);
    bool test = dot(copy.from, copy.from) < 0.25 * pose.x * pose.x && is_there_bright(copy);
    if (test) {
      vec4 seen = paint_bright(copy, p_dx, p_dy);
      vec3 own = seen.xyz * seen.w;
      light += own;
      through -= seen.w;
    }
  }
  return View(light, max(through, 0.0));
}

// bomb (bombing/bomb.glsl)
vec4 bomb_bright(vec2 uv, vec4 background, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 6.0 - 0.5;
  vec2 low = p + 0.19999999;
  vec2 p_dx = uv_dx * 6.0;
  vec2 p_dy = uv_dy * 6.0;
  View view = in_order_bright(p, low, p_dx, p_dy);
  float covered = 1.0 - view.through;
  float alpha = mix(background.w, 1.0, covered);
  vec3 below = background.xyz * (background.w * view.through);
  vec4 color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  return color;
}

// sdf_moon (shapes/sdf_moon.glsl)
float sdf_moon(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv - vec2(0.78, 0.82);
  vec2 q = p - vec2(-0.024, 0.014);
  float from_middle = length(p);
  float greatest = max(from_middle, 1e-20);
  float from_middle_dx = dot(p, uv_dx) / greatest;
  float from_middle_dy = dot(p, uv_dy) / greatest;
  float from_cut = length(q);
  float greatest2 = max(from_cut, 1e-20);
  float from_cut_dx = dot(q, uv_dx) / greatest2;
  float from_cut_dy = dot(q, uv_dy) / greatest2;
  float outer = from_middle - 0.055;
  float inner = 0.05 - from_cut;
  float side = max(outer, inner) < 0.0 ? -1.0 : 1.0;
  float beside = p.y * -0.8637788 - p.x * 0.503871;
  float beside_dx = uv_dx.y * -0.8637788 - uv_dx.x * 0.503871;
  float beside_dy = uv_dy.y * -0.8637788 - uv_dy.x * 0.503871;
  vec2 tip = vec2(0.023340022, beside < 0.0 ? -0.049802043 : 0.049802043);
  vec2 point = vec2(dot(p, vec2(-0.8637788, 0.503871)), beside);
  float nearest = distance(point, tip);
  vec2 difference = point - tip;
  float greatest3 = max(nearest, 1e-20);
  float nearest_dx = dot(difference, vec2(dot(uv_dx, vec2(-0.8637788, 0.503871)), beside_dx))
      / greatest3;
  float nearest_dy = dot(difference, vec2(dot(uv_dy, vec2(-0.8637788, 0.503871)), beside_dy))
      / greatest3;
  float to_outer_slope = outer < 0.0 ? -1.0 : 1.0;
  float to_outer = outer * to_outer_slope;
  bool test = inner < 0.0;
  float to_inner = inner * (test ? -1.0 : 1.0);
  float to_inner_slope = test ? 1.0 : -1.0;
  vec2 on_outer = p * (0.055 / greatest);
  vec2 on_inner = vec2(-0.024, 0.014) + q * (0.05 / greatest2);
  bool test2 = to_outer < nearest && distance(on_outer, vec2(-0.024, 0.014)) > 0.05;
  nearest = test2 ? to_outer : nearest;
  float to_outer_dx = from_middle_dx * to_outer_slope;
  float to_outer_dy = from_middle_dy * to_outer_slope;
  nearest_dx = test2 ? to_outer_dx : nearest_dx;
  nearest_dy = test2 ? to_outer_dy : nearest_dy;
  bool test3 = to_inner < nearest && length(on_inner) < 0.055;
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
float sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = 0.004 + max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// simplex_noise (noise/simplex_noise.glsl)
float simplex_noise2(vec2 uv) {
  vec2 base = floor(uv + (uv.x + uv.y) * 0.36602542);
  vec2 a = uv - base + (base.x + base.y) * 0.21132487;
  bool lower = a.y < a.x;
  vec2 b = a - (lower ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) + 0.21132487;
  vec2 c = a - 1.0 + 0.42264974;
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 columns = uvec2(cell.x, sum);
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uint middle = lower ? sum + rows.x : cell.x + rows.y;
  uvec2 ends = columns + rows;
  uvec4 hash_value = hash(uvec4(ends.x, middle, ends.yy));
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec3 dx = vec3(a.x, b.x, c.x);
  vec3 dy = vec3(a.y, b.y, c.y);
  vec3 r = max(0.5 - dx * dx - dy * dy, 0.0);
  vec3 r2 = r * r;
  vec3 reach = r2 * r2;
  vec3 along = x.xyz * dx + y.xyz * dy;
  return dot(reach, along) * 51.16832 + 0.5;
}

// fbm (noise/fbm.glsl)
float fbm_seas(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 30.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 30.0;
  float width = max(product.x, product.y);
  float weight = 0.5714286;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  for (int octave = 0; octave < 3; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near * (simplex_noise2(p * frequency + shift) - 0.5);
      sum += product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  return sum;
}

// circle (patterns/circle.glsl)
float circle(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - vec2(0.78, 0.82);
  float from_center = length(difference);
  float greatest = max(from_center, 1e-20);
  float from_center_dx = dot(difference, uv_dx) / greatest;
  float from_center_dy = dot(difference, uv_dy) / greatest;
  float width = max(sqrt(from_center_dx * from_center_dx + from_center_dy * from_center_dy), 1e-7);
  float near = clamp((0.055 - from_center) / width + 0.5, 0.0, 1.0);
  vec2 pixel = sqrt(uv_dx * uv_dx + uv_dy * uv_dy);
  float far = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  return mix(near, 0.009503318, far);
}

// gradient_radial (patterns/gradient_radial.glsl)
float gradient_radial_aura(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 difference = uv - vec2(0.78, 0.82);
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float ratio = dot(difference, uv_dx) / greatest / 0.27;
  return spread_range2((norm - 0.03) / 0.27, ratio, dot(difference, uv_dy) / greatest / 0.27);
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // bent: domain_warp (noise/domain_warp.glsl)
  vec2 bent_dx, bent_dy;
  vec2 bent = domain_warp(uv, uv_dx, uv_dy, bent_dx, bent_dy);
  // across: gradient_linear (patterns/gradient_linear.glsl)
  float across_dx, across_dy;
  float across = gradient_linear(bent, bent_dx, bent_dy, across_dx, across_dy);
  // band: curve (math/curve.glsl)
  float band = curve(across, across_dx, across_dy);
  // core: power (math/power.glsl)
  float greatest = max(band, 1e-37);
  float core = greatest * greatest;
  // clouds: fbm (noise/fbm.glsl)
  float clouds_dx, clouds_dy;
  float clouds = fbm_clouds(bent, bent_dx, bent_dy, clouds_dx, clouds_dy);
  // glow: levels (color/levels.glsl)
  float glow = level_glow(clouds, clouds_dx, clouds_dy);
  // dust: ridged (noise/ridged.glsl)
  float dust_dx, dust_dy;
  float dust = ridged(bent, bent_dx, bent_dy, dust_dx, dust_dy);
  // lanes: levels (color/levels.glsl)
  float lanes = mix(1.0, 0.1, level_lanes(dust, dust_dx, dust_dy));
  // thinned: multiply (math/multiply.glsl)
  float thinned = glow * lanes;
  // shine: multiply (math/multiply.glsl)
  float shine = thinned * core;
  // milk: multiply (math/multiply.glsl)
  float milk = shine * milky_way;
  // milk_color: lerp (math/lerp.glsl)
  vec3 milk_color = mix(vec3(0.05, 0.07, 0.17), vec3(0.3, 0.2, 0.17), milk);
  // milk_light: multiply (math/multiply.glsl)
  vec3 milk_light = milk_color * milk;
  // night: ramp (patterns/ramp.glsl)
  vec4 vector = vec4(clamp(uv.y, 0.0, 1.0));
  vec4 night = mix(vec4(0.012, 0.02, 0.05, 1.0), vec4(0.002, 0.003, 0.011, 1.0), vector);
  // milk_opaque: rgba (channels/rgba.glsl)
  vec4 milk_opaque = vec4(milk_light, 1.0);
  // sky: blend (layers/blend.glsl)
  vec4 sky = blend(milk_opaque, night);
  // dust_stars: bomb (bombing/bomb.glsl)
  vec4 dust_stars_color = bomb_dust_stars(uv, sky, uv_dx, uv_dy);
  // stars: bomb (bombing/bomb.glsl)
  vec4 stars_color = bomb_stars(uv, dust_stars_color, uv_dx, uv_dy);
  // bright: bomb (bombing/bomb.glsl)
  vec4 bright_color = bomb_bright(uv, stars_color, uv_dx, uv_dy);
  // crescent: sdf_moon (shapes/sdf_moon.glsl)
  float crescent_dx, crescent_dy;
  float crescent = sdf_moon(uv, uv_dx, uv_dy, crescent_dx, crescent_dy);
  // lit: sdf_fill (shapes/sdf_fill.glsl)
  float lit = sdf_fill(crescent, crescent_dx, crescent_dy);
  // seas: fbm (noise/fbm.glsl)
  float seas = fbm_seas(uv, uv_dx, uv_dy);
  // moon_tone: remap (math/remap.glsl)
  float moon_tone = mix(0.75, 1.1, seas);
  // moon_shine: multiply (math/multiply.glsl)
  float moon_shine = moon_tone * moonlight;
  // moon_color: multiply (math/multiply.glsl)
  vec3 moon_color = vec3(1.0, 0.95, 0.82) * moon_shine;
  // disc: circle (patterns/circle.glsl)
  float disc = circle(uv, uv_dx, uv_dy);
  // aura: gradient_radial (patterns/gradient_radial.glsl)
  float aura = gradient_radial_aura(uv, uv_dx, uv_dy);
  // aura_near: invert (math/invert.glsl)
  float aura_near = 1.0 - aura;
  // aura_fall: power (math/power.glsl)
  float aura_fall = pow(max(aura_near, 1e-37), 4.0);
  // aura_light: multiply (math/multiply.glsl)
  float aura_light = aura_fall * moonlight;
  // aura_color: multiply (math/multiply.glsl)
  vec3 aura_color = vec3(0.05, 0.06, 0.08) * aura_light;
  // aura_opaque: rgba (channels/rgba.glsl)
  vec4 aura_opaque = vec4(aura_color, 1.0);
  // hazy: blend (layers/blend.glsl)
  vec4 hazy = blend(aura_opaque, bright_color);
  // behind: over (layers/over.glsl)
  float blend2 = mix(hazy.w, 1.0, disc);
  vec3 blend3 = mix(hazy.xyz, vec3(0.012, 0.016, 0.032), disc / max(blend2, 1e-20));
  // seen: over (layers/over.glsl)
  float blend4 = mix(blend2, 1.0, lit);
  vec4 seen = vec4(mix(blend3, moon_color, lit / max(blend4, 1e-20)), blend4);
  out_color = seen;
}
