// fish_scales: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform vec3 back;  // default vec3(0.01, 0.085, 0.1)
uniform vec3 belly;  // default vec3(0.75, 0.66, 0.46)
uniform float spots;  // default 0.85

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_height;
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
struct Copy {
  uint seed;
  vec2 from;
};
struct View {
  Copy top;
};

// Constants
const vec2 points[4] = vec2[4](vec2(0.0), vec2(0.3, 0.12), vec2(0.62, 0.75), vec2(1.0));
const vec2 points2[4] = vec2[4](vec2(0.0, 1.0), vec2(0.6, 0.86), vec2(0.9, 0.5), vec2(1.0, 0.0));

// node_at, of bomb (bombing/bomb.glsl)
vec2 node_at(vec2 low, int number) {
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
      + uvec2(2131687100u, 3540083553u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u)
      + v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

// copy_at, of bomb (bombing/bomb.glsl)
Copy copy_at(vec2 p, vec2 node) {
  uvec4 bits = copy_bits(ivec2(node));
  vec2 middle = vec2(node.x - 0.5 * float(int(node.y) & 1), node.y);
  Copy copy = Copy(bits.w, p - vec2(1.0, 0.8660254) * middle);
  return copy;
}

// sdf_ellipse (shapes/sdf_ellipse.glsl)
float sdf_ellipse(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv - 0.5;
  vec2 q_slope = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 q = p * q_slope;
  vec2 q_dx = uv_dx * q_slope;
  vec2 q_dy = uv_dy * q_slope;
  vec2 t = vec2(0.70710677);
  for (int i = 0; i < 8; ++i) {
    vec2 middle = vec2(-0.30066743, 0.21248582) * t * t * t;
    vec2 away = q - middle;
    float radius = distance(vec2(0.3, 0.4245) * t, middle);
    vec2 ratio = (middle + radius * away / max(length(away), 1e-20)) / vec2(0.3, 0.4245);
    t = clamp(ratio, 1e-7, 1.0);
    t *= inversesqrt(dot(t, t));
  }
  vec2 nearest = floor(t * 16777216.0 + 0.5) * 5.9604645e-8;
  vec2 unit = normalize(vec2(0.4245, 0.3) * nearest);
  result_dx = dot(q_dx, unit);
  result_dy = dot(q_dy, unit);
  return dot(q - vec2(0.3, 0.4245) * nearest, unit);
}

// sdf_fill (shapes/sdf_fill.glsl)
float sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// paint, of bomb (bombing/bomb.glsl)
vec4 paint(Copy copy, vec2 copy_from_dx, vec2 copy_from_dy) {
  float result_dx, result_dy;
  float sdf_ellipse_value = sdf_ellipse(copy.from * 0.5 + 0.5, copy_from_dx * 0.5,
      copy_from_dy * 0.5, result_dx, result_dy);
  vec4 seen = vec4(1.0, 1.0, 1.0, sdf_fill(sdf_ellipse_value, result_dx, result_dy));
  return seen;
}

// in_order, of bomb (bombing/bomb.glsl)
View in_order(vec2 p, vec2 low, vec2 p_dx, vec2 p_dy) {
  Copy top = Copy(0u, p);
  float through = 1.0;
  float most = 0.0;
  for (int i = 5; i > -1 && through > 0.001; --i) {
    vec2 node = node_at(low, i);
    Copy copy = copy_at(p, node);
    vec2 magnitude = abs(copy.from);
    if (max(magnitude.x, magnitude.y) < 1.0) {
      vec4 seen = paint(copy, p_dx, p_dy);
      float part = seen.w * through;
      through -= part;
      top = most < part ? copy : top;
      most = max(most, part);
    }
  }
  return View(top);
}

// bomb (bombing/bomb.glsl)
void bomb(vec2 uv, vec2 uv_dx, vec2 uv_dy, out Tile tile, out vec2 tile_local_dx,
    out vec2 tile_local_dy) {
  vec2 p = uv * vec2(14.0, 18.187) - vec2(0.5, 0.4330127);
  vec2 low = p / vec2(1.0, 0.8660254) - vec2(0.0, 0.15470052);
  vec2 p_dx = uv_dx * vec2(14.0, 18.187);
  vec2 p_dy = uv_dy * vec2(14.0, 18.187);
  View view = in_order(p, low, p_dx, p_dy);
  vec2 sum = view.top.from * 0.5 + 0.5;
  tile = Tile(sum, vec2(0.14285715, 0.109968655), view.top.seed, vec2(1.0, 0.0), vec2(-0.0, 1.0));
  tile_local_dx = p_dx * 0.5;
  tile_local_dy = p_dy * 0.5;
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

// sine_wave (math/sine_wave.glsl)
float sine_wave(float phase, float phase_dx, float phase_dy) {
  float width = 3.1415927 * max(sqrt(phase_dx * phase_dx + phase_dy * phase_dy), 0.0001);
  float ratio = 0.5 * sin(6.2831855 * fract(phase)) * sin(width) / width;
  return 0.5 + ratio;
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
float gradient_angular(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv - vec2(0.5, 0.85);
  bool test = p.x == 0.0;
  float choice = test ? 1e-20 : p.x;
  float greatest = max(p.y * p.y + choice * choice, 1e-20);
  float turns = atan(p.y, choice) * 0.15915494;
  float phase = turns * 40.0;
  float phase_dx = (choice * uv_dx.y - p.y * (test ? 0.0 : uv_dx.x)) / greatest * 6.3661976;
  float phase_dy = (choice * uv_dy.y - p.y * (test ? 0.0 : uv_dy.x)) / greatest * 6.3661976;
  return triangle_wave(phase, phase_dx, phase_dy);
}

// tile_center (tiles/tile_center.glsl)
vec2 tile_center(Tile tile, vec2 uv, vec2 tile_local_dx, vec2 tile_local_dy, vec2 uv_dx, vec2 uv_dy,
    out vec2 result_dx, out vec2 result_dy) {
  vec2 from_middle = (tile.local - 0.5) * tile.size;
  vec2 from_middle_dx = tile_local_dx * tile.size;
  vec2 from_middle_dy = tile_local_dy * tile.size;
  result_dx = uv_dx - from_middle_dx.x * tile.right - from_middle_dx.y * tile.up;
  result_dy = uv_dy - from_middle_dy.x * tile.right - from_middle_dy.y * tile.up;
  return uv - tile.right * from_middle.x - tile.up * from_middle.y;
}

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

// simplex_noise (noise/simplex_noise.glsl)
float simplex_noise(vec2 uv) {
  vec2 p = uv * 5.0;
  vec2 base = floor(p + (p.x + p.y) * 0.36602542);
  vec2 a = p - base + (base.x + base.y) * 0.21132487;
  bool lower = a.y < a.x;
  vec2 b = a - (lower ? vec2(1.0, 0.0) : vec2(0.0, 1.0)) + 0.21132487;
  vec2 c = a - 1.0 + 0.42264974;
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 columns = uvec2(cell.x, sum);
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 1301776676u);
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

// smooth_step (math/smooth_step.glsl)
float smooth_step(float value) {
  float t = clamp((value - 0.7) / 0.100000024, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// secant_up, of curve (math/curve.glsl)
float secant_up(int i) {
  vec2 way = points[clamp(i + 1, 0, 3)] - points[clamp(i, 0, 3)];
  return way.y / max(way.x, 1e-7);
}

// slope_at_up, of curve (math/curve.glsl)
float slope_at_up(int i) {
  int middle = clamp(i, 1, 2);
  int difference = middle - 1;
  float before = secant_up(difference);
  float behind = secant_up(middle);
  float value = points[middle].x;
  float length_before = max(value - points[clamp(difference, 0, 3)].x, 1e-7);
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

// part_mean_up, of curve (math/curve.glsl)
float part_mean_up(int i, float middle, float reach) {
  vec2 from = points[clamp(i, 0, 3)];
  int sum = i + 1;
  vec2 to = points[clamp(sum, 0, 3)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * slope_at_up(i) - rise;
  float end = rise - way * slope_at_up(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float curve_up(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(-value / width + 0.5, 0.0, 1.0);
  float sum = 0.0;
  for (int i = 0; i < 3; ++i) {
    float next = clamp((points[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * part_mean_up(i, middle, reach);
  }
  return sum + (1.0 - below);
}

// tile_near (tiles/tile_near.glsl)
float tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// random3 (random/random3.glsl)
vec3 random3(uint seed) {
  uint bits = hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(hash(bits) >> 8u) * 5.9604645e-8);
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
  vec3 luck = mix(vec3(0.5), random3(seed), near);
  vec3 one = hsv_adjust(color, mix(-16.0, 16.0, luck.x), mix(0.7, 1.25, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9870536), one, near);
}

// level, of levels (color/levels.glsl)
float level(float value, float value_dx, float value_dy) {
  float t = (value - 0.75) * 4.0;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 4.0, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// secant_dome, of curve (math/curve.glsl)
float secant_dome(int i) {
  vec2 way = points2[clamp(i + 1, 0, 3)] - points2[clamp(i, 0, 3)];
  return way.y / max(way.x, 1e-7);
}

// slope_at_dome, of curve (math/curve.glsl)
float slope_at_dome(int i) {
  int middle = clamp(i, 1, 2);
  int difference = middle - 1;
  float before = secant_dome(difference);
  float behind = secant_dome(middle);
  float value = points2[middle].x;
  float length_before = max(value - points2[clamp(difference, 0, 3)].x, 1e-7);
  float length_behind = max(points2[middle + 1].x - value, 1e-7);
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

// part_mean_dome, of curve (math/curve.glsl)
float part_mean_dome(int i, float middle, float reach) {
  vec2 from = points2[clamp(i, 0, 3)];
  int sum = i + 1;
  vec2 to = points2[clamp(sum, 0, 3)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * slope_at_dome(i) - rise;
  float end = rise - way * slope_at_dome(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float curve_dome(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(-value / width + 0.5, 0.0, 1.0);
  float sum = below;
  for (int i = 0; i < 3; ++i) {
    float next = clamp((points2[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * part_mean_dome(i, middle, reach);
  }
  return sum;
}

// spread_range (math/spread_range.glsl)
float spread_range2(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(0.5 - value / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - value) / width, 0.0, 1.0);
  float middle = value + 0.5 * width * (below - above);
  return above + (1.0 - below - above) * clamp(middle, 0.0, 1.0);
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // rows: bomb (bombing/bomb.glsl)
  Tile rows_tile;
  vec2 rows_tile_local_dx, rows_tile_local_dy;
  bomb(uv, uv_dx, uv_dy, rows_tile, rows_tile_local_dx, rows_tile_local_dy);
  // place_wide: uv_transform (images/uv_transform.glsl)
  vec2 place_wide_dx = mat2(1.4144272, -0.0, 0.0, 1.0) * rows_tile_local_dx;
  vec2 place_wide_dy = mat2(1.4144272, -0.0, 0.0, 1.0) * rows_tile_local_dy;
  vec2 place_wide = mat2(1.4144272, -0.0, 0.0, 1.0) * (rows_tile.local - 0.5) + 0.5;
  // radius: gradient_radial (patterns/gradient_radial.glsl)
  vec2 difference = place_wide - 0.5;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float radius_dx, radius_dy;
  float radius = spread_range(norm / 0.4245, dot(difference, place_wide_dx) / greatest / 0.4245,
      dot(difference, place_wide_dy) / greatest / 0.4245, radius_dx, radius_dy);
  // ring_phase: multiply (math/multiply.glsl)
  float ring_phase = radius * 6.0;
  // rings: sine_wave (math/sine_wave.glsl)
  float ring_phase_dx = radius_dx * 6.0;
  float ring_phase_dy = radius_dy * 6.0;
  float rings = sine_wave(ring_phase, ring_phase_dx, ring_phase_dy);
  // rays: gradient_angular (patterns/gradient_angular.glsl)
  float rays = gradient_angular(rows_tile.local, rows_tile_local_dx, rows_tile_local_dy);
  // ribs: lerp (math/lerp.glsl)
  float ribs = mix(rings, rays, 0.5);
  // middle: tile_center (tiles/tile_center.glsl)
  vec2 middle_dx, middle_dy;
  vec2 middle = tile_center(rows_tile, uv, rows_tile_local_dx, rows_tile_local_dy, uv_dx, uv_dy,
      middle_dx, middle_dy);
  // hills: simplex_noise (noise/simplex_noise.glsl)
  float hills = simplex_noise(middle);
  // spotted: smooth_step (math/smooth_step.glsl)
  float spotted = smooth_step(hills);
  // dark: multiply (math/multiply.glsl)
  float dark = spotted * spots;
  // up: curve (math/curve.glsl)
  float up = curve_up(middle.y, middle_dx.y, middle_dy.y);
  // skin: lerp (math/lerp.glsl)
  vec3 skin = mix(belly, back, up);
  // own: tile_random_hsv (tiles/tile_random_hsv.glsl)
  vec3 own = varied(rows_tile.seed, tile_near(rows_tile_local_dx, rows_tile_local_dy), skin);
  // flecked: lerp (math/lerp.glsl)
  vec3 flecked = mix(own, vec3(0.008, 0.009, 0.012), dark);
  // rim: levels (color/levels.glsl)
  float rim = mix(1.0, 0.35, level(radius, radius_dx, radius_dy));
  // rib_tone: remap (math/remap.glsl)
  float rib_tone = mix(0.8, 1.1, ribs);
  // tone: multiply (math/multiply.glsl)
  float tone = rim * rib_tone;
  // shaded: multiply (math/multiply.glsl)
  vec3 shaded = flecked * tone;
  // color: rgba (channels/rgba.glsl)
  vec4 color = vec4(shaded, 1.0);
  // dome: curve (math/curve.glsl)
  float dome = curve_dome(radius, radius_dx, radius_dy);
  // lifted: gradient_linear (patterns/gradient_linear.glsl)
  float ratio = (rows_tile.local - vec2(0.0, 0.93)).y * -0.86 / 0.7396;
  float ratio2 = rows_tile_local_dx.y * -0.86 / 0.7396;
  float lifted = spread_range2(ratio, ratio2, rows_tile_local_dy.y * -0.86 / 0.7396);
  // tip: multiply (math/multiply.glsl)
  float tip = lifted * 1.1;
  // raised: add (math/add.glsl)
  float raised = dome + tip;
  // fine: multiply (math/multiply.glsl)
  float fine = ribs * 0.02;
  // height: add (math/add.glsl)
  float height = raised + fine;
  // roughness: remap (math/remap.glsl)
  float roughness = mix(0.28, 0.4, ribs);
  out_color = color;
  out_height = height;
  out_roughness = roughness;
  out_metallic = 0.15;
}
