// painted_tiles: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec3 blue;  // default vec3(0.012, 0.05, 0.26)
uniform vec3 yellow;  // default vec3(0.75, 0.42, 0.04)
uniform float unsteady;  // default 0.0005

// Types
struct painted_tiles_Tile {
  vec2 local;
  vec2 size;
  uint seed;
};

// Constants
const vec2 painted_tiles_points[4] = vec2[4](vec2(0.0, 0.8), vec2(0.85, 0.75), vec2(0.965, 0.5),
    vec2(1.0, 0.0));

// hash (random/hash.glsl)
uvec2 painted_tiles_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 painted_tiles_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// gradient_noise (noise/gradient_noise.glsl)
float painted_tiles_gradient_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
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
  uvec2 rows = painted_tiles_hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = painted_tiles_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
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
float painted_tiles_fbm(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 9.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 9.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 9.0;
  vec2 p_dy = uv_dy * 9.0;
  float weight = 0.5714286;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 3; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near;
      float result_dx2, result_dy2;
      float gradient_noise_value = painted_tiles_gradient_noise(p * frequency + shift,
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

// repeat (coordinates/repeat.glsl)
vec2 painted_tiles_repeat(vec2 uv, vec2 uv_dx, vec2 uv_dy, out vec2 result_dx, out vec2 result_dy) {
  vec2 p = uv * 4.0;
  vec2 difference = 2.0 * fract(0.5 * p) - 1.0;
  vec2 direction = sign(difference);
  result_dx = -(uv_dx * 2.0 * 2.0 * direction);
  result_dy = -(uv_dy * 2.0 * 2.0 * direction);
  return 1.0 - abs(difference);
}

// rotate2d (coordinates/rotate2d.glsl)
vec2 painted_tiles_rotate2d(vec2 vector, vec2 vector_dx, vec2 vector_dy, out vec2 result_dx,
    out vec2 result_dy) {
  result_dx = vec2(vector_dx.x * 0.70710677 - vector_dx.y * -0.70710677,
      vector_dx.x * -0.70710677 + vector_dx.y * 0.70710677);
  result_dy = vec2(vector_dy.x * 0.70710677 - vector_dy.y * -0.70710677,
      vector_dy.x * -0.70710677 + vector_dy.y * 0.70710677);
  return vec2(0.70710677 * vector.x - -0.70710677 * vector.y,
      -0.70710677 * vector.x + 0.70710677 * vector.y);
}

// sdf_smooth_union (shapes/sdf_smooth_union.glsl)
float painted_tiles_sdf_smooth_union(float a, float b, float k, float a_dx, float a_dy, float b_dx,
    float b_dy, out float result_dx, out float result_dy) {
  float greatest = max(k, 1e-12);
  float sum = 0.5 + 0.5 * (b - a) / greatest;
  float t = clamp(sum, 0.0, 1.0);
  bool test = sum < 0.0;
  bool test2 = sum > 1.0;
  float t_dx = test ? 0.0 : test2 ? 0.0 : (b_dx - a_dx) * 0.5 / greatest;
  float t_dy = test ? 0.0 : test2 ? 0.0 : (b_dy - a_dy) * 0.5 / greatest;
  float difference = a - b;
  float greatest2 = max(k, 0.0);
  float product = greatest2 * t;
  float difference2 = 1.0 - t;
  float difference3 = greatest2 * difference2 - product;
  result_dx = mix(b_dx, a_dx, t) + difference * t_dx - t_dx * difference3;
  result_dy = mix(b_dy, a_dy, t) + difference * t_dy - t_dy * difference3;
  return mix(b, a, t) - product * difference2;
}

// sdf_line (shapes/sdf_line.glsl)
float painted_tiles_sdf_line(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv - vec2(0.22, 0.0);
  float side = -p.y;
  bool test = p.x < 0.0;
  bool test2 = p.x > 0.5;
  float beyond = p.x - clamp(p.x, 0.0, 0.5);
  float beyond_dx = uv_dx.x - (test ? 0.0 : test2 ? 0.0 : uv_dx.x);
  float beyond_dy = uv_dy.x - (test ? 0.0 : test2 ? 0.0 : uv_dy.x);
  bool test3 = p.y > -0.0;
  float beside = side * (test3 ? -1.0 : 1.0);
  float beside_slope = test3 ? 1.0 : -1.0;
  float side_dx = -uv_dx.y;
  float side_dy = -uv_dy.y;
  float beside_dx = uv_dx.y * beside_slope;
  float beside_dy = uv_dy.y * beside_slope;
  if (beyond != 0.0) {
    vec2 point = vec2(beyond, side);
    beside = length(point);
    float greatest = max(beside, 1e-20);
    beside_dx = dot(point, vec2(beyond_dx, side_dx)) / greatest;
    beside_dy = dot(point, vec2(beyond_dy, side_dy)) / greatest;
  }
  result_dx = beside_dx;
  result_dy = beside_dy;
  return beside - 0.011;
}

// sdf_ring (shapes/sdf_ring.glsl)
float painted_tiles_sdf_ring_corner(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 difference = uv - 1.0;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float outward_dx = dot(difference, uv_dx) / greatest;
  float outward_dy = dot(difference, uv_dy) / greatest;
  float outward = norm - 0.3;
  float side = outward < 0.0 ? -1.0 : 1.0;
  result_dx = outward_dx * side;
  result_dy = outward_dy * side;
  return side * outward - 0.035;
}

// sdf_ring (shapes/sdf_ring.glsl)
float painted_tiles_sdf_ring_scroll_a(vec2 uv, vec2 center, vec2 uv_dx, vec2 uv_dy,
    out float result_dx, out float result_dy) {
  vec2 difference = uv - center;
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  float outward_dx = dot(difference, uv_dx) / greatest;
  float outward_dy = dot(difference, uv_dy) / greatest;
  float outward = norm - 0.13;
  float side = outward < 0.0 ? -1.0 : 1.0;
  result_dx = outward_dx * side;
  result_dy = outward_dy * side;
  return side * outward - 0.0225;
}

// sdf_fill (shapes/sdf_fill.glsl)
float painted_tiles_sdf_fill(float shape, float shape_dx, float shape_dy) {
  float width = max(sqrt(shape_dx * shape_dx + shape_dy * shape_dy), 1e-7);
  float share = 0.5 - shape / width;
  return clamp(share, 0.0, 1.0);
}

// motif (function of the graph)
vec3 painted_tiles_motif(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  // p: repeat (coordinates/repeat.glsl)
  vec2 p_dx, p_dy;
  vec2 p = painted_tiles_repeat(uv, uv_dx, uv_dy, p_dx, p_dy);
  // half_turn: rotate2d (coordinates/rotate2d.glsl)
  vec2 half_turn_dx, half_turn_dy;
  vec2 half_turn = painted_tiles_rotate2d(p, p_dx, p_dy, half_turn_dx, half_turn_dy);
  // lens_a: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference = half_turn - vec2(0.5, 0.24);
  float norm = length(difference);
  float greatest = max(norm, 1e-20);
  // lens_b: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference2 = half_turn - vec2(0.5, -0.24);
  float norm2 = length(difference2);
  float greatest2 = max(norm2, 1e-20);
  // leaf: sdf_smooth_intersection (shapes/sdf_smooth_intersection.glsl)
  float result_dx, result_dy;
  float sdf_smooth_union_value = painted_tiles_sdf_smooth_union(0.4 - norm, 0.4 - norm2, 0.02,
      -(dot(difference, half_turn_dx) / greatest), -(dot(difference, half_turn_dy) / greatest),
      -(dot(difference2, half_turn_dx) / greatest2), -(dot(difference2, half_turn_dy) / greatest2),
      result_dx, result_dy);
  float leaf = -sdf_smooth_union_value;
  // leaf_line: sdf_outline (shapes/sdf_outline.glsl)
  bool test = sdf_smooth_union_value > -0.0;
  float leaf_line_slope = test ? 1.0 : -1.0;
  float leaf_line = leaf * (test ? -1.0 : 1.0) - 0.0175;
  // vein: sdf_line (shapes/sdf_line.glsl)
  float vein_dx, vein_dy;
  float vein = painted_tiles_sdf_line(half_turn, half_turn_dx, half_turn_dy, vein_dx, vein_dy);
  // eye: sdf_circle (shapes/sdf_circle.glsl)
  float norm3 = length(p);
  float greatest3 = max(norm3, 1e-20);
  float eye_dx = dot(p, p_dx) / greatest3;
  float eye_dy = dot(p, p_dy) / greatest3;
  float eye = norm3 - 0.13;
  // corner: sdf_ring (shapes/sdf_ring.glsl)
  float corner_dx, corner_dy;
  float corner = painted_tiles_sdf_ring_corner(p, p_dx, p_dy, corner_dx, corner_dy);
  // bud: sdf_circle (shapes/sdf_circle.glsl)
  vec2 difference3 = p - 1.0;
  float norm4 = length(difference3);
  float greatest4 = max(norm4, 1e-20);
  float bud_dx = dot(difference3, p_dx) / greatest4;
  float bud_dy = dot(difference3, p_dy) / greatest4;
  float bud = norm4 - 0.15;
  // scroll_a: sdf_ring (shapes/sdf_ring.glsl)
  float scroll_a_dx, scroll_a_dy;
  float scroll_a = painted_tiles_sdf_ring_scroll_a(p, vec2(0.66, 0.16), p_dx, p_dy, scroll_a_dx,
      scroll_a_dy);
  // scroll_b: sdf_ring (shapes/sdf_ring.glsl)
  float scroll_b_dx, scroll_b_dy;
  float scroll_b = painted_tiles_sdf_ring_scroll_a(p, vec2(0.16, 0.66), p_dx, p_dy, scroll_b_dx,
      scroll_b_dy);
  // scrolls: sdf_union (shapes/sdf_union.glsl)
  float scrolls = min(scroll_a, scroll_b);
  bool test2 = scroll_b < scroll_a;
  float scrolls_dx = test2 ? scroll_b_dx : scroll_a_dx;
  float scrolls_dy = test2 ? scroll_b_dy : scroll_a_dy;
  // lines_1: sdf_union (shapes/sdf_union.glsl)
  float lines_1 = min(leaf_line, vein);
  float leaf_line_dx = result_dx * leaf_line_slope;
  float leaf_line_dy = result_dy * leaf_line_slope;
  bool test3 = vein < leaf_line;
  float lines_1_dx = test3 ? vein_dx : leaf_line_dx;
  float lines_1_dy = test3 ? vein_dy : leaf_line_dy;
  // lines_2: sdf_smooth_union (shapes/sdf_smooth_union.glsl)
  float lines_2_dx, lines_2_dy;
  float lines_2 = painted_tiles_sdf_smooth_union(scrolls, corner, 0.03, scrolls_dx, scrolls_dy,
      corner_dx, corner_dy, lines_2_dx, lines_2_dy);
  // lines: sdf_union (shapes/sdf_union.glsl)
  float lines = min(lines_1, lines_2);
  bool test4 = lines_2 < lines_1;
  float lines_dx = test4 ? lines_2_dx : lines_1_dx;
  float lines_dy = test4 ? lines_2_dy : lines_1_dy;
  // blots: sdf_union (shapes/sdf_union.glsl)
  float blots = min(eye, bud);
  bool test5 = bud < eye;
  float blots_dx = test5 ? bud_dx : eye_dx;
  float blots_dy = test5 ? bud_dy : eye_dy;
  // line_there: sdf_fill (shapes/sdf_fill.glsl)
  float line_there = painted_tiles_sdf_fill(lines, lines_dx, lines_dy);
  // leaf_there: sdf_fill (shapes/sdf_fill.glsl)
  float leaf_dx = -result_dx;
  float leaf_dy = -result_dy;
  float leaf_there = painted_tiles_sdf_fill(leaf, leaf_dx, leaf_dy);
  // blot_there: sdf_fill (shapes/sdf_fill.glsl)
  float blot_there = painted_tiles_sdf_fill(blots, blots_dx, blots_dy);
  // wash: lerp (math/lerp.glsl)
  vec3 wash = mix(vec3(0.78, 0.77, 0.7), vec3(0.2, 0.35, 0.55), leaf_there);
  // spotted: lerp (math/lerp.glsl)
  vec3 spotted = mix(wash, yellow, blot_there);
  // drawn: lerp (math/lerp.glsl)
  vec3 drawn = mix(spotted, blue, line_there);
  return drawn;
}

// warp (filters/warp.glsl)
vec3 painted_tiles_warp(vec2 uv, float amount, vec2 uv_dx, vec2 uv_dy) {
  vec2 apart = max(sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 0.0005);
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  float result_dx, result_dy;
  float fbm_value = painted_tiles_fbm(uv + across, uv_dx, uv_dy, result_dx, result_dy);
  float result_dx2, result_dy2;
  float fbm_value2 = painted_tiles_fbm(uv - across, uv_dx, uv_dy, result_dx2, result_dy2);
  float result_dx3, result_dy3;
  float fbm_value3 = painted_tiles_fbm(uv + along, uv_dx, uv_dy, result_dx3, result_dy3);
  float result_dx4, result_dy4;
  float fbm_value4 = painted_tiles_fbm(uv - along, uv_dx, uv_dy, result_dx4, result_dy4);
  vec2 rise = vec2(fbm_value - fbm_value2, fbm_value3 - fbm_value4);
  vec2 rise_dx = vec2(result_dx - result_dx2, result_dx3 - result_dx4);
  vec2 rise_dy = vec2(result_dy - result_dy2, result_dy3 - result_dy4);
  vec2 sum = uv_dx + rise_dx * amount / apart;
  return painted_tiles_motif(uv + amount * rise / apart, sum, uv_dy + rise_dy * amount / apart);
}

// hash (random/hash.glsl)
uint painted_tiles_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// brick_grid (tiles/brick_grid.glsl)
void painted_tiles_brick_grid(vec2 uv, vec2 uv_dx, vec2 uv_dy, out painted_tiles_Tile tile,
    out vec2 tile_local_dx, out vec2 tile_local_dy) {
  vec2 p = uv * 4.0;
  int row = int(floor(p.y));
  uint row_bits = painted_tiles_hash(uint(row) + 129708002u);
  vec2 corner = floor(p);
  int column = int(corner.x);
  tile = painted_tiles_Tile(p - corner, vec2(0.25), painted_tiles_hash(uint(column) + row_bits));
  tile_local_dx = uv_dx * 4.0;
  tile_local_dy = uv_dy * 4.0;
}

// brick_integral, of mortar (tiles/mortar.glsl)
vec2 painted_tiles_brick_integral(vec2 p, vec2 joint) {
  vec2 turns = floor(p);
  vec2 difference = 1.0 - 2.0 * joint;
  return turns * difference + clamp(p - turns - joint, vec2(0.0), difference);
}

// mortar (tiles/mortar.glsl)
float painted_tiles_mortar(painted_tiles_Tile tile, vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 joint = 0.0035 / tile.size;
  vec2 pixel = max(sqrt(tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy), 0.0001);
  vec2 product = 0.5 * pixel;
  vec2 difference = painted_tiles_brick_integral(tile.local + product, joint)
      - painted_tiles_brick_integral(tile.local - product, joint);
  vec2 brick = difference / pixel;
  return 1.0 - brick.x * brick.y;
}

// tile_near (tiles/tile_near.glsl)
float painted_tiles_tile_near(vec2 tile_local_dx, vec2 tile_local_dy) {
  vec2 part = 4.0 + tile_local_dx * tile_local_dx + tile_local_dy * tile_local_dy;
  return 16.0 / (part.x * part.y);
}

// random3 (random/random3.glsl)
vec3 painted_tiles_random3(uint seed) {
  uint bits = painted_tiles_hash(seed);
  vec2 product = vec2(float(bits & 65535u), float(bits >> 16u)) * 1.5258789e-5;
  return vec3(product, float(painted_tiles_hash(bits) >> 8u) * 5.9604645e-8);
}

// rgb_to_hsv (color/rgb_to_hsv.glsl)
vec3 painted_tiles_rgb_to_hsv(vec3 color) {
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
vec3 painted_tiles_hsv_to_rgb(vec3 hsv) {
  vec3 away = abs(fract(hsv.x + vec3(0.0, 0.6666667, 0.33333334)) * 6.0 - 3.0);
  vec3 blend = mix(vec3(1.0), clamp(away - 1.0, 0.0, 1.0), hsv.y);
  return hsv.z * blend;
}

// hsv_adjust (color/hsv_adjust.glsl)
vec3 painted_tiles_hsv_adjust(vec3 color, float hue, float saturation, float value) {
  float top = max(max(color.x, color.y), color.z);
  float range = top - min(min(color.x, color.y), color.z);
  float pull = 1.0;
  if (saturation != 1.0) {
    pull = min(saturation, top / max(range, 1e-20));
  }
  vec3 pulled = mix(vec3(top), color, pull);
  vec3 hsv = painted_tiles_rgb_to_hsv(pulled);
  vec3 turned = painted_tiles_hsv_to_rgb(vec3(hsv.x + hue / 360.0, hsv.yz));
  return value * (hue == 0.0 ? pulled : turned);
}

// varied, of tile_random_hsv (tiles/tile_random_hsv.glsl)
vec3 painted_tiles_varied(uint seed, float near, vec3 color) {
  vec3 luck = mix(vec3(0.5), painted_tiles_random3(seed), near);
  vec3 one = painted_tiles_hsv_adjust(color, mix(-5.0, 5.0, luck.x), mix(0.8, 1.05, luck.y),
      mix(0.85, 1.08, luck.z));
  float grey = 0.5 * (max(max(one.x, one.y), one.z) + min(min(one.x, one.y), one.z));
  return mix(mix(vec3(grey), one, 0.9987312), one, near);
}

// level, of levels (color/levels.glsl)
float painted_tiles_level(float value, float value_dx, float value_dy) {
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

// spread_range (math/spread_range.glsl)
float painted_tiles_spread_range(float value, float value_dx, float value_dy, out float result_dx,
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

// gradient_box (patterns/gradient_box.glsl)
float painted_tiles_gradient_box(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = 2.0 * (uv - 0.5);
  vec2 point = vec2(p.x < 0.0 ? -1.0 : 1.0, p.y < 0.0 ? -1.0 : 1.0);
  vec2 q = p * point;
  vec2 q_slope = 2.0 * point;
  vec2 q_dx = uv_dx * q_slope;
  vec2 q_dy = uv_dy * q_slope;
  bool test = q.x < q.y;
  float result_dx2, result_dy2;
  float spread_range_value = painted_tiles_spread_range(max(q.x, q.y), test ? q_dx.y : q_dx.x,
      test ? q_dy.y : q_dy.x, result_dx2, result_dy2);
  result_dx = result_dx2;
  result_dy = result_dy2;
  return spread_range_value;
}

// secant, of curve (math/curve.glsl)
float painted_tiles_secant(int i) {
  vec2 way = painted_tiles_points[clamp(i + 1, 0, 3)] - painted_tiles_points[clamp(i, 0, 3)];
  return way.y / max(way.x, 1e-7);
}

// slope_at, of curve (math/curve.glsl)
float painted_tiles_slope_at(int i) {
  int middle = clamp(i, 1, 2);
  int difference = middle - 1;
  float before = painted_tiles_secant(difference);
  float behind = painted_tiles_secant(middle);
  float value = painted_tiles_points[middle].x;
  float length_before = max(value - painted_tiles_points[clamp(difference, 0, 3)].x, 1e-7);
  float length_behind = max(painted_tiles_points[middle + 1].x - value, 1e-7);
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
float painted_tiles_part_mean(int i, float middle, float reach) {
  vec2 from = painted_tiles_points[clamp(i, 0, 3)];
  int sum = i + 1;
  vec2 to = painted_tiles_points[clamp(sum, 0, 3)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * painted_tiles_slope_at(i) - rise;
  float end = rise - way * painted_tiles_slope_at(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float painted_tiles_curve(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(-value / width + 0.5, 0.0, 1.0);
  float sum = 0.8 * below;
  for (int i = 0; i < 3; ++i) {
    float next = clamp((painted_tiles_points[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * painted_tiles_part_mean(i, middle, reach);
  }
  return sum;
}

void painted_tiles(vec2 uv, out vec4 color, out float height, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // hand: fbm (noise/fbm.glsl)
  float hand_dx, hand_dy;
  float hand = painted_tiles_fbm(uv, uv_dx, uv_dy, hand_dx, hand_dy);
  // painted: warp (filters/warp.glsl)
  vec3 painted = painted_tiles_warp(uv, unsteady, uv_dx, uv_dy);
  // tiles: brick_grid (tiles/brick_grid.glsl)
  painted_tiles_Tile tiles;
  vec2 tiles_local_dx, tiles_local_dy;
  painted_tiles_brick_grid(uv, uv_dx, uv_dy, tiles, tiles_local_dx, tiles_local_dy);
  // grout: mortar (tiles/mortar.glsl)
  float grout = painted_tiles_mortar(tiles, tiles_local_dx, tiles_local_dy);
  // fired: tile_random_hsv (tiles/tile_random_hsv.glsl)
  vec3 fired = painted_tiles_varied(tiles.seed,
      painted_tiles_tile_near(tiles_local_dx, tiles_local_dy), painted);
  // mottled: levels (color/levels.glsl)
  float mottled = mix(0.88, 1.06, painted_tiles_level(hand, hand_dx, hand_dy));
  // glaze: multiply (math/multiply.glsl)
  vec3 glaze = fired * mottled;
  // wall: lerp (math/lerp.glsl)
  vec3 wall = mix(glaze, vec3(0.33, 0.29, 0.24), grout);
  // color: rgba (channels/rgba.glsl)
  vec4 color2 = vec4(wall, 1.0);
  // pillow: gradient_box (patterns/gradient_box.glsl)
  float pillow_dx, pillow_dy;
  float pillow = painted_tiles_gradient_box(tiles.local, tiles_local_dx, tiles_local_dy, pillow_dx,
      pillow_dy);
  // height: curve (math/curve.glsl)
  float height2 = painted_tiles_curve(pillow, pillow_dx, pillow_dy);
  // roughness: lerp (math/lerp.glsl)
  float roughness2 = mix(0.16, 0.9, grout);
  color = color2;
  height = height2;
  roughness = roughness2;
}
