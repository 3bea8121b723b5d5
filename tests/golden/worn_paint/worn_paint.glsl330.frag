// worn_paint: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform float wear;  // default 0.38
uniform vec3 paint_color;  // default vec3(0.02, 0.16, 0.19)

// Outputs
layout(location = 0) out vec4 out_color;
layout(location = 1) out vec3 out_normal;
layout(location = 2) out float out_roughness;
layout(location = 3) out float out_metallic;
layout(location = 4) out float out_height;

// Types
struct Sum {
  float least;
  float terms;
};

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

// wrap_cell (tiles/wrap_cell.glsl)
int wrap_cell(int cell, int count) {
  int flip = cell >> 31;
  return (((cell ^ flip) % count) ^ flip) + (flip & count);
}

// cell_hash (indirection/cell_hash.glsl)
uint cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(2131687100u, 3540083553u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

// hash (random/hash.glsl)
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// add_point, of smooth_voronoi (cellular/smooth_voronoi.glsl)
void add_point(float square, Sum sum, float square_dx, float square_dy, float sum_least_dx,
    float sum_least_dy, float sum_terms_dx, float sum_terms_dy, out Sum sum_out,
    out float sum_out_least_dx, out float sum_out_least_dy, out float sum_out_terms_dx,
    out float sum_out_terms_dy) {
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
  float shrink = exp2(abs(difference) / -0.08);
  float product = 0.6931472 * shrink;
  float shrink_dx = product * (difference_dx * direction / -0.08);
  float shrink_dy = product * (difference_dy * direction / -0.08);
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
  sum_out = Sum(min(sum.least, sum2), choice);
  sum_out_least_dx = test3 ? sum_least_dx + difference_dx : sum_least_dx;
  sum_out_least_dy = test3 ? sum_least_dy + difference_dy : sum_least_dy;
  sum_out_terms_dx = sum_terms_dx2;
  sum_out_terms_dy = sum_terms_dy2;
}

// smooth_voronoi (cellular/smooth_voronoi.glsl)
float smooth_voronoi(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 9.0;
  vec2 corner = floor(p + 0.5);
  vec2 start = p - corner - 0.125;
  Sum sum = Sum(4.0, 0.0);
  float sum_least_dx = 0.0;
  float sum_least_dy = 0.0;
  float sum_terms_dx = 0.0;
  float sum_terms_dy = 0.0;
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 cell = ivec2(corner) + ivec2(x, y);
      cell = ivec2(wrap_cell(cell.x, 9), wrap_cell(cell.y, 9));
      uint hash_value = hash(cell_hash(cell) - 1u);
      vec2 product = 0.75 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u))
          * 1.5258789e-5);
      vec2 arm = vec2(float(x), float(y)) - start + product;
      vec2 arm_dx = uv_dx * -9.0;
      vec2 arm_dy = uv_dy * -9.0;
      float projection = dot(arm_dx, arm);
      float projection2 = dot(arm_dy, arm);
      Sum sum2;
      float sum_least_dx2, sum_least_dy2, sum_terms_dx2, sum_terms_dy2;
      add_point(dot(arm, arm), sum, projection + projection, projection2 + projection2,
          sum_least_dx, sum_least_dy, sum_terms_dx, sum_terms_dy, sum2, sum_least_dx2,
          sum_least_dy2, sum_terms_dx2, sum_terms_dy2);
      sum = sum2;
      sum_least_dx = sum_least_dx2;
      sum_least_dy = sum_least_dy2;
      sum_terms_dx = sum_terms_dx2;
      sum_terms_dy = sum_terms_dy2;
    }
  }
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 9.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float greatest = max(sum.terms, 1e-20);
  bool test = sum.terms < 1e-20;
  float difference = sum.least - 0.08 * log2(greatest);
  bool test2 = difference < 0.0;
  float choice = test2 ? 0.0 : sum_least_dx
      - 1.442695 * (test ? 0.0 : sum_terms_dx) / greatest * 0.08;
  float choice2 = test2 ? 0.0 : sum_least_dy
      - 1.442695 * (test ? 0.0 : sum_terms_dy) / greatest * 0.08;
  float difference2 = 1.0 - blur;
  result_dx = choice * difference2;
  result_dy = choice2 * difference2;
  return mix(max(difference, 0.0), 0.4082594, blur);
}

// curvature (filters/curvature.glsl)
float curvature(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 apart = max(sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 0.006);
  vec2 x = vec2(apart.x, 0.0);
  vec2 y = vec2(0.0, apart.y);
  vec2 result_dx2, result_dy2;
  vec2 widen_value = widen(uv, apart, uv, uv_dx, uv_dy, result_dx2, result_dy2);
  float result_dx3, result_dy3;
  float smooth_voronoi_value = smooth_voronoi(widen_value, result_dx2, result_dy2, result_dx3,
      result_dy3);
  float middle = smooth_voronoi_value * smooth_voronoi_value * 0.05;
  float middle_slope = (smooth_voronoi_value + smooth_voronoi_value) * 0.05;
  vec2 sum2 = uv + x;
  vec2 result_dx4, result_dy4;
  vec2 widen_value2 = widen(sum2, apart, uv, uv_dx, uv_dy, result_dx4, result_dy4);
  float result_dx5, result_dy5;
  float smooth_voronoi_value2 = smooth_voronoi(widen_value2, result_dx4, result_dy4, result_dx5,
      result_dy5);
  float product = (smooth_voronoi_value2 + smooth_voronoi_value2) * 0.05;
  float east = smooth_voronoi_value2 * smooth_voronoi_value2 * 0.05 - middle;
  float middle_dx = result_dx3 * middle_slope;
  float middle_dy = result_dy3 * middle_slope;
  float east_dx = result_dx5 * product - middle_dx;
  float east_dy = result_dy5 * product - middle_dy;
  vec2 difference = uv - x;
  vec2 result_dx6, result_dy6;
  vec2 widen_value3 = widen(difference, apart, uv, uv_dx, uv_dy, result_dx6, result_dy6);
  float result_dx7, result_dy7;
  float smooth_voronoi_value3 = smooth_voronoi(widen_value3, result_dx6, result_dy6, result_dx7,
      result_dy7);
  float product2 = (smooth_voronoi_value3 + smooth_voronoi_value3) * 0.05;
  float west = smooth_voronoi_value3 * smooth_voronoi_value3 * 0.05 - middle;
  float west_dx = result_dx7 * product2 - middle_dx;
  float west_dy = result_dy7 * product2 - middle_dy;
  vec2 result_dx8, result_dy8;
  vec2 widen_value4 = widen(uv + y, apart, uv, uv_dx, uv_dy, result_dx8, result_dy8);
  float result_dx9, result_dy9;
  float smooth_voronoi_value4 = smooth_voronoi(widen_value4, result_dx8, result_dy8, result_dx9,
      result_dy9);
  float product3 = (smooth_voronoi_value4 + smooth_voronoi_value4) * 0.05;
  float north = smooth_voronoi_value4 * smooth_voronoi_value4 * 0.05 - middle;
  float north_dx = result_dx9 * product3 - middle_dx;
  float north_dy = result_dy9 * product3 - middle_dy;
  vec2 result_dx10, result_dy10;
  vec2 widen_value5 = widen(uv - y, apart, uv, uv_dx, uv_dy, result_dx10, result_dy10);
  float result_dx11, result_dy11;
  float smooth_voronoi_value5 = smooth_voronoi(widen_value5, result_dx10, result_dy10, result_dx11,
      result_dy11);
  float product4 = (smooth_voronoi_value5 + smooth_voronoi_value5) * 0.05;
  float south = smooth_voronoi_value5 * smooth_voronoi_value5 * 0.05 - middle;
  float south_dx = result_dx11 * product4 - middle_dx;
  float south_dy = result_dy11 * product4 - middle_dy;
  vec2 result_dx12, result_dy12;
  vec2 widen_value6 = widen(sum2 + y, apart, uv, uv_dx, uv_dy, result_dx12, result_dy12);
  float result_dx13, result_dy13;
  float smooth_voronoi_value6 = smooth_voronoi(widen_value6, result_dx12, result_dy12, result_dx13,
      result_dy13);
  float product5 = (smooth_voronoi_value6 + smooth_voronoi_value6) * 0.05;
  vec2 result_dx14, result_dy14;
  vec2 widen_value7 = widen(sum2 - y, apart, uv, uv_dx, uv_dy, result_dx14, result_dy14);
  float result_dx15, result_dy15;
  float smooth_voronoi_value7 = smooth_voronoi(widen_value7, result_dx14, result_dy14, result_dx15,
      result_dy15);
  float product6 = (smooth_voronoi_value7 + smooth_voronoi_value7) * 0.05;
  vec2 result_dx16, result_dy16;
  vec2 widen_value8 = widen(difference + y, apart, uv, uv_dx, uv_dy, result_dx16, result_dy16);
  float result_dx17, result_dy17;
  float smooth_voronoi_value8 = smooth_voronoi(widen_value8, result_dx16, result_dy16, result_dx17,
      result_dy17);
  float product7 = (smooth_voronoi_value8 + smooth_voronoi_value8) * 0.05;
  float difference2 = smooth_voronoi_value6 * smooth_voronoi_value6 * 0.05
      - smooth_voronoi_value7 * smooth_voronoi_value7 * 0.05
      - smooth_voronoi_value8 * smooth_voronoi_value8 * 0.05;
  vec2 result_dx18, result_dy18;
  vec2 widen_value9 = widen(difference - y, apart, uv, uv_dx, uv_dy, result_dx18, result_dy18);
  float result_dx19, result_dy19;
  float smooth_voronoi_value9 = smooth_voronoi(widen_value9, result_dx18, result_dy18, result_dx19,
      result_dy19);
  float product8 = (smooth_voronoi_value9 + smooth_voronoi_value9) * 0.05;
  float twist = difference2 + smooth_voronoi_value9 * smooth_voronoi_value9 * 0.05;
  float twist_dx = result_dx13 * product5 - result_dx15 * product6 - result_dx17 * product7
      + result_dx19 * product8;
  float twist_dy = result_dy13 * product5 - result_dy15 * product6 - result_dy17 * product7
      + result_dy19 * product8;
  vec2 slope = 0.5 * vec2(east - west, north - south) / apart;
  vec2 slope_dx = vec2(east_dx - west_dx, north_dx - south_dx) * 0.5 / apart;
  vec2 slope_dy = vec2(east_dy - west_dy, north_dy - south_dy) * 0.5 / apart;
  vec2 slope2 = clamp(slope, -10000.0, 10000.0);
  bvec2 test = lessThan(slope, vec2(-10000.0));
  bvec2 test2 = lessThan(vec2(10000.0), slope);
  slope_dx = mix(mix(slope_dx, vec2(0.0), test2), vec2(0.0), test);
  slope_dy = mix(mix(slope_dy, vec2(0.0), test2), vec2(0.0), test);
  vec2 product9 = apart * apart;
  vec2 bend = vec2(east + west, north + south) / product9;
  bvec2 test3 = notEqual(product9, vec2(0.0));
  vec2 bend_dx = mix(vec2(0.0), vec2(east_dx + west_dx, north_dx + south_dx) / product9, test3);
  vec2 bend_dy = mix(vec2(0.0), vec2(east_dy + west_dy, north_dy + south_dy) / product9, test3);
  float product10 = apart.x * apart.y;
  float shear = 0.25 * twist / product10;
  float shear_dx = twist_dx * 0.25 / product10;
  float shear_dy = twist_dy * 0.25 / product10;
  float projection = dot(slope_dx, slope2);
  float root_dx = projection + projection;
  float projection2 = dot(slope_dy, slope2);
  float root_dy = projection2 + projection2;
  float root = 1.0 + dot(slope2, slope2);
  vec2 sum3 = slope2 + slope2;
  vec2 part = (1.0 + slope2 * slope2) / root;
  vec2 part_dx = (slope_dx * sum3 - part * root_dx) / root;
  vec2 part_dy = (slope_dy * sum3 - part * root_dy) / root;
  float sum4 = part_dx.y * bend.x + part.y * bend_dx.x + (part_dx.x * bend.y + part.x * bend_dx.y);
  float sum5 = part_dy.y * bend.x + part.y * bend_dy.x + (part_dy.x * bend.y + part.x * bend_dy.y);
  float ratio = slope2.x * slope2.y / root;
  float product11 = 2.0 * ratio;
  float product12 = (slope_dx.x * slope2.y + slope2.x * slope_dx.y - ratio * root_dx) / root * 2.0;
  float product13 = (slope_dy.x * slope2.y + slope2.x * slope_dy.y - ratio * root_dy) / root * 2.0;
  float sum = part.y * bend.x + part.x * bend.y - product11 * shear;
  float sum_dx = sum4 - (product12 * shear + product11 * shear_dx);
  float sum_dy = sum5 - (product13 * shear + product11 * shear_dy);
  float product14 = -0.015 * sum;
  float inverse_root = inversesqrt(root);
  float ratio2 = inverse_root / root;
  result_dx = sum_dx * -0.015 * inverse_root + product14 * (-0.5 * root_dx * ratio2);
  result_dy = sum_dy * -0.015 * inverse_root + product14 * (-0.5 * root_dy * ratio2);
  return product14 * inverse_root;
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

// gradient_noise (noise/gradient_noise.glsl)
float gradient_noise_perlin(vec2 uv) {
  vec2 base = floor(uv);
  vec2 t = uv - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  return mix(blend.x, blend.y, fade.y) * 0.9340967 + 0.5;
}

// fbm (noise/fbm.glsl)
float fbm(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 16.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 16.0;
  float width = max(product.x, product.y);
  float weight = 0.516129;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  for (int octave = 0; octave < 5; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near * (gradient_noise_perlin(p * frequency + shift) - 0.5);
      sum += product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  return sum;
}

// gradient_noise (noise/gradient_noise.glsl)
float gradient_noise_perlin2(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
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
float fbm2(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 16.0;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 16.0;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 16.0;
  vec2 p_dy = uv_dy * 16.0;
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
      float gradient_noise_perlin_value = gradient_noise_perlin2(p * frequency + shift,
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

// gradient_noise (noise/gradient_noise.glsl)
float gradient_noise_flow(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
    out float result_dy) {
  vec2 p = uv * 40.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * 40.0;
  vec2 t_dy = uv_dy * 40.0;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint number = uint(wrap_cell(int(cell.x), 40));
  uint choice = number == 39u ? 0u : number + 1u;
  uint number2 = uint(wrap_cell(int(cell.y), 40));
  uvec2 rows = hash(uvec2(number2, number2 == 39u ? 0u : number2 + 1u) + 460041413u);
  uvec4 hash_value = hash(uvec4(number, choice, number, choice) + rows.xxyy);
  vec4 x = vec4(ivec4(hash_value)) * 4.656613e-10;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (hash_value << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec4 corners_dx = t_dx.x * x + t_dx.y * y;
  vec4 corners_dy = t_dy.x * x + t_dy.y * y;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 40.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float amplitude = 0.9340967 * (1.0 - blur);
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  vec2 blend = mix(corners.xz, corners.yw, fade.x);
  vec2 difference2 = corners.yw - corners.xz;
  vec2 sum2 = mix(corners_dx.xz, corners_dx.yw, fade.x) + difference2 * fade_dx.x;
  vec2 sum3 = mix(corners_dy.xz, corners_dy.yw, fade.x) + difference2 * fade_dy.x;
  float difference3 = blend.y - blend.x;
  result_dx = (mix(sum2.x, sum2.y, fade.y) + difference3 * fade_dx.y) * amplitude;
  result_dy = (mix(sum3.x, sum3.y, fade.y) + difference3 * fade_dy.y) * amplitude;
  return mix(blend.x, blend.y, fade.y) * amplitude + 0.5;
}

// widen (filters/widen.glsl)
vec2 widen2(vec2 place, vec2 width, vec2 uv, vec2 width_dx, vec2 width_dy, vec2 uv_dx, vec2 uv_dy,
    out vec2 result_dx, out vec2 result_dy) {
  float area = uv_dx.x * uv_dy.y - uv_dx.y * uv_dy.x;
  float least = max(0.0001 * length(uv_dx) * length(uv_dy), 1e-30);
  float area2 = area < 0.0 ? min(area, -least) : max(area, least);
  vec2 change = uv - floor(uv * 1.0995116e12) * 9.094947e-13;
  vec2 pixels = vec2(uv_dy.y * change.x - uv_dy.x * change.y,
      uv_dx.x * change.y - uv_dx.y * change.x);
  vec2 pixels_dx = vec2(area, 0.0);
  vec2 pixels_dy = vec2(0.0, area);
  vec2 ratio = width / area2;
  bool test = area2 != 0.0;
  result_dx = (test ? width_dx / area2 : vec2(0.0)) * pixels + ratio * pixels_dx;
  result_dy = (test ? width_dy / area2 : vec2(0.0)) * pixels + ratio * pixels_dy;
  return floor(place * 1.0995116e12) * 9.094947e-13 + ratio * pixels;
}

// slope_blur (filters/slope_blur.glsl)
float slope_blur(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 pixel = sqrt(uv_dx * uv_dx + uv_dy * uv_dy);
  vec2 apart = max(pixel, 0.0005);
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  float sum_dx, sum_dy;
  float sum = fbm2(uv, uv_dx, uv_dy, sum_dx, sum_dy);
  vec2 place = uv;
  for (int i = 0; i < 4; ++i) {
    vec2 result_dx2, result_dy2;
    vec2 widen_value = widen(place + across, pixel, uv, uv_dx, uv_dy, result_dx2, result_dy2);
    float result_dx3, result_dy3;
    float gradient_noise_flow_value = gradient_noise_flow(widen_value, result_dx2, result_dy2,
        result_dx3, result_dy3);
    vec2 result_dx4, result_dy4;
    vec2 widen_value2 = widen(place - across, pixel, uv, uv_dx, uv_dy, result_dx4, result_dy4);
    float result_dx5, result_dy5;
    float gradient_noise_flow_value2 = gradient_noise_flow(widen_value2, result_dx4, result_dy4,
        result_dx5, result_dy5);
    vec2 result_dx6, result_dy6;
    vec2 widen_value3 = widen(place + along, pixel, uv, uv_dx, uv_dy, result_dx6, result_dy6);
    float result_dx7, result_dy7;
    float gradient_noise_flow_value3 = gradient_noise_flow(widen_value3, result_dx6, result_dy6,
        result_dx7, result_dy7);
    vec2 result_dx8, result_dy8;
    vec2 widen_value4 = widen(place - along, pixel, uv, uv_dx, uv_dy, result_dx8, result_dy8);
    float result_dx9, result_dy9;
    float gradient_noise_flow_value4 = gradient_noise_flow(widen_value4, result_dx8, result_dy8,
        result_dx9, result_dy9);
    vec2 rise = vec2(gradient_noise_flow_value - gradient_noise_flow_value2,
        gradient_noise_flow_value3 - gradient_noise_flow_value4);
    vec2 rise_dx = vec2(result_dx3 - result_dx5, result_dx7 - result_dx9);
    vec2 rise_dy = vec2(result_dy3 - result_dy5, result_dy7 - result_dy9);
    vec2 way = 7.5e-5 * rise / apart;
    vec2 way_dx = rise_dx * 7.5e-5 / apart;
    vec2 way_dy = rise_dy * 7.5e-5 / apart;
    place += way;
    vec2 sum2 = way + way;
    vec2 sum3 = pixel * pixel + way * way;
    vec2 root = sqrt(sum3);
    bvec2 test = lessThan(vec2(0.0), sum3);
    vec2 greatest = max(root, 1e-20);
    vec2 result_dx10, result_dy10;
    vec2 widen_value5 = widen2(place, root, uv,
        mix(vec2(0.0), 0.5 * (way_dx * sum2) / greatest, test),
        mix(vec2(0.0), 0.5 * (way_dy * sum2) / greatest, test), uv_dx, uv_dy, result_dx10,
        result_dy10);
    float seen_dx, seen_dy;
    float seen = fbm2(widen_value5, result_dx10, result_dy10, seen_dx, seen_dy);
    sum += seen;
    sum_dx += seen_dx;
    sum_dy += seen_dy;
  }
  result_dx = sum_dx / 5.0;
  result_dy = sum_dy / 5.0;
  return sum / 5.0;
}

// histogram_scan (color/histogram_scan.glsl)
float histogram_scan(float value, float position, float value_dx, float value_dy) {
  float pixel = max(sqrt(value_dx * value_dx + value_dy * value_dy), 2.999997e-7);
  float middle = (value - (1.0 - position) * 1.03) / 0.029999971 + 1.0;
  float ratio = 0.5 * pixel / 0.029999971;
  float low = middle - ratio;
  float high = middle + ratio;
  float from = clamp(low, 0.0, 1.0);
  float to = clamp(high, 0.0, 1.0);
  float sum = 0.5 * (to - from) * (to + from) + max(high - max(low, 1.0), 0.0);
  return sum / max(high - low, 1e-20);
}

// value_noise (noise/value_noise.glsl)
float value_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 110.0;
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 t_dx = uv_dx * 110.0;
  vec2 t_dy = uv_dy * 110.0;
  vec2 product = t * t;
  vec2 product2 = product * t;
  vec2 product3 = t * 6.0;
  vec2 difference = product3 - 15.0;
  vec2 sum = t * difference + 10.0;
  vec2 fade = product2 * sum;
  vec2 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec2 cell = uvec2(ivec2(base));
  uint number = uint(wrap_cell(int(cell.x), 110));
  uint choice = number == 109u ? 0u : number + 1u;
  uint number2 = uint(wrap_cell(int(cell.y), 110));
  uvec2 rows = hash(uvec2(number2, number2 == 109u ? 0u : number2 + 1u) + 678955108u);
  uvec4 bits = hash(uvec4(number, choice, number, choice) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  vec2 fade_dx = t_dx * fade_slope;
  vec2 fade_dy = t_dy * fade_slope;
  float low = mix(corners.x, corners.y, fade.x);
  float low_slope = corners.y - corners.x;
  float high = mix(corners.z, corners.w, fade.x);
  float high_slope = corners.w - corners.z;
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 110.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  float blend = mix(low_slope, high_slope, fade.y);
  float difference2 = high - low;
  result_dx = mix(fade_dx.x * blend + fade_dx.y * difference2, 0.0, blur);
  result_dy = mix(fade_dy.x * blend + fade_dy.y * difference2, 0.0, blur);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

// directional_blur (filters/directional_blur.glsl)
float directional_blur(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  float difference = 0.9781476 * uv.y - 0.2079117 * uv.x;
  vec2 p_dx = vec2(uv_dx.x * 0.9781476 + uv_dx.y * 0.2079117,
      uv_dx.y * 0.9781476 - uv_dx.x * 0.2079117);
  vec2 p_dy = vec2(uv_dy.x * 0.9781476 + uv_dy.y * 0.2079117,
      uv_dy.y * 0.9781476 - uv_dy.x * 0.2079117);
  vec2 pixel = sqrt(p_dx * p_dx + p_dy * p_dy);
  vec2 width = vec2(sqrt(0.0012 + pixel.x * pixel.x), pixel.y);
  float first = 0.9781476 * uv.x + 0.2079117 * uv.y - 0.13856407;
  float weight = 1.0;
  for (int i = 1; i < 9; ++i) {
    weight *= 0.5;
  }
  float sum = 0.0;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int i = 0; i < 9; ++i) {
    vec2 place = vec2(first + 0.034641016 * float(i), difference);
    vec2 result_dx2, result_dy2;
    vec2 widen_value = widen(place, width, uv, uv_dx, uv_dy, result_dx2, result_dy2);
    float result_dx3, result_dy3;
    float value_noise_value = value_noise(mat2(0.9781476, 0.2079117, -0.2079117, 0.9781476)
        * widen_value, mat2(0.9781476, 0.2079117, -0.2079117, 0.9781476) * result_dx2,
        mat2(0.9781476, 0.2079117, -0.2079117, 0.9781476) * result_dy2, result_dx3, result_dy3);
    sum += weight * value_noise_value;
    sum_dx += result_dx3 * weight;
    sum_dy += result_dy3 * weight;
    weight *= float(8 - i) / float(i + 1);
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// color_ramp (color/color_ramp.glsl)
vec4 color_ramp(float position, float position_dx, float position_dy) {
  float width = max(sqrt(position_dx * position_dx + position_dy * position_dy), 1e-7);
  float below = clamp((0.38 - position) / width + 0.5, 0.0, 1.0);
  vec4 sum = vec4(0.3, 0.29, 0.27, 1.0) * below;
  float next = clamp((0.62 - position) / width + 0.5, 0.0, 1.0);
  float middle = position + width * (0.5 * (below + next) - 0.5) - 0.38;
  vec4 vector = vec4(clamp(middle * 4.1666665, 0.0, 1.0));
  vec4 blend = mix(vec4(0.3, 0.29, 0.27, 1.0), vec4(0.62, 0.6, 0.56, 1.0), vector);
  vec4 product = (next - below) * vec4(blend.xyz * blend.w, blend.w);
  sum += product;
  sum += (1.0 - next) * vec4(0.62, 0.6, 0.56, 1.0);
  vec3 choice = vec3(0.62, 0.6, 0.56);
  if (sum.w > 0.0) {
    choice = sum.xyz / max(sum.w, 1e-20);
  }
  return vec4(choice, sum.w);
}

// add_point, of smooth_voronoi (cellular/smooth_voronoi.glsl)
Sum add_point2(float square, Sum sum) {
  float rest = max(1.0 - square / 2.25, 0.0);
  float difference = sqrt(square) - sum.least;
  float shrink = exp2(abs(difference) / -0.08);
  bool nearer = difference < 0.0;
  float choice;
  if (nearer) {
    choice = sum.terms * shrink + rest * rest;
  } else {
    choice = sum.terms + rest * rest * shrink;
  }
  Sum sum2 = Sum(min(sum.least, sum.least + difference), choice);
  return sum2;
}

// smooth_voronoi (cellular/smooth_voronoi.glsl)
float smooth_voronoi2(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * 9.0;
  vec2 corner = floor(p + 0.5);
  vec2 start = p - corner - 0.125;
  Sum sum = Sum(4.0, 0.0);
  for (int y = -2; y < 2; ++y) {
    for (int x = -2; x < 2; ++x) {
      ivec2 cell = ivec2(corner) + ivec2(x, y);
      cell = ivec2(wrap_cell(cell.x, 9), wrap_cell(cell.y, 9));
      uint hash_value = hash(cell_hash(cell) - 1u);
      vec2 product = 0.75 * (vec2(float(hash_value & 65535u), float(hash_value >> 16u))
          * 1.5258789e-5);
      vec2 arm = vec2(float(x), float(y)) - start + product;
      sum = add_point2(dot(arm, arm), sum);
    }
  }
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 9.0;
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(max(sum.least - 0.08 * log2(max(sum.terms, 1e-20)), 0.0), 0.4082594, blur);
}

// height_to_normal (filters/height_to_normal.glsl)
vec3 height_to_normal_big(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 apart = max(sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 0.0005);
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  float smooth_voronoi_value = smooth_voronoi2(uv + across, uv_dx, uv_dy);
  float smooth_voronoi_value2 = smooth_voronoi2(uv - across, uv_dx, uv_dy);
  float difference = smooth_voronoi_value * smooth_voronoi_value * 0.05
      - smooth_voronoi_value2 * smooth_voronoi_value2 * 0.05;
  float smooth_voronoi_value3 = smooth_voronoi2(uv + along, uv_dx, uv_dy);
  float smooth_voronoi_value4 = smooth_voronoi2(uv - along, uv_dx, uv_dy);
  vec2 rise = vec2(difference, smooth_voronoi_value3 * smooth_voronoi_value3 * 0.05
      - smooth_voronoi_value4 * smooth_voronoi_value4 * 0.05);
  vec3 normal = vec3(-rise / apart, 1.0);
  return normal * inversesqrt(dot(normal, normal));
}

// height_to_normal (filters/height_to_normal.glsl)
vec3 height_to_normal_small(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 apart = max(sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 0.0005);
  vec2 across = vec2(0.5 * apart.x, 0.0);
  vec2 along = vec2(0.0, 0.5 * apart.y);
  float difference = fbm(uv + across, uv_dx, uv_dy) - fbm(uv - across, uv_dx, uv_dy);
  vec2 rise = vec2(difference, fbm(uv + along, uv_dx, uv_dy) - fbm(uv - along, uv_dx, uv_dy));
  vec3 normal = vec3(-0.008 * rise / apart, 1.0);
  return normal * inversesqrt(dot(normal, normal));
}

// reorient_normal (materials/reorient_normal.glsl)
vec3 reorient_normal(vec3 base, vec3 detail) {
  float greatest = max(base.z + 1.0, 0.0001);
  vec3 t = vec3(base.xy, greatest);
  vec3 u = detail * vec3(-1.0, -1.0, 1.0);
  vec3 n = t * (dot(t, u) / greatest) - u;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // bulge: curvature (filters/curvature.glsl)
  float bulge_dx, bulge_dy;
  float bulge = curvature(uv, uv_dx, uv_dy, bulge_dx, bulge_dy);
  // grain: fbm (noise/fbm.glsl)
  float grain = fbm(uv, uv_dx, uv_dy);
  // torn: slope_blur (filters/slope_blur.glsl)
  float torn_dx, torn_dy;
  float torn = slope_blur(uv, uv_dx, uv_dy, torn_dx, torn_dy);
  // by_bulge: multiply (math/multiply.glsl)
  float by_bulge = bulge * 0.35;
  // gone: add (math/add.glsl)
  float gone = torn + by_bulge;
  float by_bulge_dx = bulge_dx * 0.35;
  float by_bulge_dy = bulge_dy * 0.35;
  float gone_dx = torn_dx + by_bulge_dx;
  float gone_dy = torn_dy + by_bulge_dy;
  // bare: histogram_scan (color/histogram_scan.glsl)
  float bare = histogram_scan(gone, wear, gone_dx, gone_dy);
  // brushed: directional_blur (filters/directional_blur.glsl)
  float brushed_dx, brushed_dy;
  float brushed = directional_blur(uv, uv_dx, uv_dy, brushed_dx, brushed_dy);
  // steel: color_ramp (color/color_ramp.glsl)
  vec4 steel = color_ramp(brushed, brushed_dx, brushed_dy);
  // shade: remap (math/remap.glsl)
  float shade = mix(0.75, 1.2, (grain - 0.2) / 0.6);
  // coat: multiply (math/multiply.glsl)
  vec3 coat = paint_color * shade;
  // coat_color: rgba (channels/rgba.glsl)
  vec4 coat_color = vec4(coat, 1.0);
  // seen: lerp (math/lerp.glsl)
  vec4 seen = mix(coat_color, steel, bare);
  // big: height_to_normal (filters/height_to_normal.glsl)
  vec3 big = height_to_normal_big(uv, uv_dx, uv_dy);
  // small: height_to_normal (filters/height_to_normal.glsl)
  vec3 small = height_to_normal_small(uv, uv_dx, uv_dy);
  // looks: reorient_normal (materials/reorient_normal.glsl)
  vec3 looks = reorient_normal(big, small);
  // rough: lerp (math/lerp.glsl)
  float rough = mix(0.32, 0.35, bare);
  // reach: smooth_voronoi (cellular/smooth_voronoi.glsl)
  float reach = smooth_voronoi2(uv, uv_dx, uv_dy);
  // square: multiply (math/multiply.glsl)
  float square = reach * reach;
  // relief: multiply (math/multiply.glsl)
  float relief = square * 0.05;
  out_color = seen;
  out_normal = looks;
  out_roughness = rough;
  out_metallic = bare;
  out_height = relief;
}
