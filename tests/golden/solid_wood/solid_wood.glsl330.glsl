// solid_wood: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform float rings;  // default 9.0
uniform float bend;  // default 0.045

// Constants
const vec2 solid_wood_points[5] = vec2[5](vec2(0.0), vec2(0.55, 0.12), vec2(0.85, 0.6),
    vec2(0.97, 1.0), vec2(1.0, 0.4));

// rotate3d (coordinates/rotate3d.glsl)
vec3 solid_wood_rotate3d(vec3 vector, vec3 vector_dx, vec3 vector_dy, out vec3 result_dx,
    out vec3 result_dy) {
  vec3 sum = vector_dx * 0.9135454
      + cross(vec3(0.9438583, 0.3303504, 0.0), vector_dx) * -0.40673664;
  vec3 sum2 = vector_dy * 0.9135454
      + cross(vec3(0.9438583, 0.3303504, 0.0), vector_dy) * -0.40673664;
  vec3 product = 0.08645457 * dot(vec3(0.9438583, 0.3303504, 0.0), vector)
      * vec3(0.9438583, 0.3303504, 0.0);
  vec3 product2 = dot(vec3(0.9438583, 0.3303504, 0.0), vector_dx) * 0.08645457
      * vec3(0.9438583, 0.3303504, 0.0);
  vec3 product3 = dot(vec3(0.9438583, 0.3303504, 0.0), vector_dy) * 0.08645457
      * vec3(0.9438583, 0.3303504, 0.0);
  result_dx = sum + product2;
  result_dy = sum2 + product3;
  return 0.9135454 * vector + -0.40673664 * cross(vec3(0.9438583, 0.3303504, 0.0), vector)
      + product;
}

// hash (random/hash.glsl)
uint solid_wood_hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec2 solid_wood_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 solid_wood_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// directions3 (noise/directions3.glsl)
void solid_wood_directions3(uvec4 bits, out vec4 x, out vec4 y, out vec4 z) {
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
float solid_wood_gradient_noise_x(vec3 uv, int seed, vec3 uv_dx, vec3 uv_dy, out float result_dx,
    out float result_dy) {
  vec3 p = uv * vec3(1.3, 1.3, 0.5);
  vec3 base = floor(p);
  vec3 t = p - base;
  vec3 t_dx = uv_dx * vec3(1.3, 1.3, 0.5);
  vec3 t_dy = uv_dy * vec3(1.3, 1.3, 0.5);
  vec3 product = t * t;
  vec3 product2 = product * t;
  vec3 product3 = t * 6.0;
  vec3 difference = product3 - 15.0;
  vec3 sum = t * difference + 10.0;
  vec3 fade = product2 * sum;
  vec3 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec3 cell = uvec3(ivec3(base));
  uint sum2 = cell.x + 1u;
  uvec4 columns = uvec4(cell.x, sum2, cell.x, sum2);
  uvec2 slices = solid_wood_hash(uvec2(cell.z, cell.z + 1u) + solid_wood_hash(uint(seed)));
  uint sum3 = cell.y + 1u;
  uvec4 rows = solid_wood_hash(uvec4(cell.y, sum3, cell.y, sum3) + slices.xxyy);
  vec4 x0, y0, z0;
  solid_wood_directions3(solid_wood_hash(columns + rows.xxyy), x0, y0, z0);
  vec4 x1, y1, z1;
  solid_wood_directions3(solid_wood_hash(columns + rows.zzww), x1, y1, z1);
  vec3 u = t - 1.0;
  vec4 tx = vec4(t.x, u.x, t.x, u.x);
  vec4 ty = vec4(t.yy, u.yy);
  vec4 front = x0 * tx + y0 * ty + z0 * t.z;
  vec4 front_dx = t_dx.x * x0 + t_dx.y * y0 + t_dx.z * z0;
  vec4 front_dy = t_dy.x * x0 + t_dy.y * y0 + t_dy.z * z0;
  vec4 back = x1 * tx + y1 * ty + z1 * u.z;
  vec4 back_dx = t_dx.x * x1 + t_dx.y * y1 + t_dx.z * z1;
  vec4 back_dy = t_dy.x * x1 + t_dy.y * y1 + t_dy.z * z1;
  vec3 fade_dx = t_dx * fade_slope;
  vec3 fade_dy = t_dy * fade_slope;
  vec4 face = mix(front, back, fade.z);
  vec4 difference2 = back - front;
  vec4 face_dx = mix(front_dx, back_dx, fade.z) + difference2 * fade_dx.z;
  vec4 face_dy = mix(front_dy, back_dy, fade.z) + difference2 * fade_dy.z;
  vec3 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * vec3(1.3, 1.3, 0.5);
  float blur = clamp(2.0 * max(max(width.x, width.y), width.z) - 1.0, 0.0, 1.0);
  float amplitude = 0.8882547 * (1.0 - blur);
  vec2 blend = mix(face.xz, face.yw, fade.x);
  vec2 difference3 = face.yw - face.xz;
  vec2 sum4 = mix(face_dx.xz, face_dx.yw, fade.x) + difference3 * fade_dx.x;
  vec2 sum5 = mix(face_dy.xz, face_dy.yw, fade.x) + difference3 * fade_dy.x;
  float difference4 = blend.y - blend.x;
  result_dx = (mix(sum4.x, sum4.y, fade.y) + difference4 * fade_dx.y) * amplitude;
  result_dy = (mix(sum5.x, sum5.y, fade.y) + difference4 * fade_dy.y) * amplitude;
  return mix(blend.x, blend.y, fade.y) * amplitude + 0.5;
}

// curl3 (noise/curl3.glsl)
vec3 solid_wood_curl3(vec3 uv, vec3 uv_dx, vec3 uv_dy, out vec3 result_dx, out vec3 result_dy) {
  vec3 way = max(0.5 * sqrt(uv_dx * uv_dx + uv_dy * uv_dy), 0.001);
  vec3 x = vec3(way.x, 0.0, 0.0);
  vec3 y = vec3(0.0, way.y, 0.0);
  vec3 z = vec3(0.0, 0.0, way.z);
  vec3 sum = uv + x;
  float result_dx2, result_dy2;
  float gradient_noise_x_value = solid_wood_gradient_noise_x(sum, 1, uv_dx, uv_dy, result_dx2,
      result_dy2);
  float result_dx3, result_dy3;
  float gradient_noise_x_value2 = solid_wood_gradient_noise_x(sum, 2, uv_dx, uv_dy, result_dx3,
      result_dy3);
  float result_dx4, result_dy4;
  float gradient_noise_x_value3 = solid_wood_gradient_noise_x(sum, 3, uv_dx, uv_dy, result_dx4,
      result_dy4);
  vec3 difference = uv - x;
  float result_dx5, result_dy5;
  float gradient_noise_x_value4 = solid_wood_gradient_noise_x(difference, 1, uv_dx, uv_dy,
      result_dx5, result_dy5);
  float result_dx6, result_dy6;
  float gradient_noise_x_value5 = solid_wood_gradient_noise_x(difference, 2, uv_dx, uv_dy,
      result_dx6, result_dy6);
  float result_dx7, result_dy7;
  float gradient_noise_x_value6 = solid_wood_gradient_noise_x(difference, 3, uv_dx, uv_dy,
      result_dx7, result_dy7);
  vec3 difference2 = vec3(gradient_noise_x_value, gradient_noise_x_value2, gradient_noise_x_value3)
      - vec3(gradient_noise_x_value4, gradient_noise_x_value5, gradient_noise_x_value6);
  vec3 difference3 = vec3(result_dx2, result_dx3, result_dx4)
      - vec3(result_dx5, result_dx6, result_dx7);
  vec3 difference4 = vec3(result_dy2, result_dy3, result_dy4)
      - vec3(result_dy5, result_dy6, result_dy7);
  vec3 along_x = difference2 * 0.5 / way.x;
  vec3 along_x_dx = difference3 * 0.5 / way.x;
  vec3 along_x_dy = difference4 * 0.5 / way.x;
  vec3 sum2 = uv + y;
  float result_dx8, result_dy8;
  float gradient_noise_x_value7 = solid_wood_gradient_noise_x(sum2, 1, uv_dx, uv_dy, result_dx8,
      result_dy8);
  float result_dx9, result_dy9;
  float gradient_noise_x_value8 = solid_wood_gradient_noise_x(sum2, 2, uv_dx, uv_dy, result_dx9,
      result_dy9);
  float result_dx10, result_dy10;
  float gradient_noise_x_value9 = solid_wood_gradient_noise_x(sum2, 3, uv_dx, uv_dy, result_dx10,
      result_dy10);
  vec3 difference5 = uv - y;
  float result_dx11, result_dy11;
  float gradient_noise_x_value10 = solid_wood_gradient_noise_x(difference5, 1, uv_dx, uv_dy,
      result_dx11, result_dy11);
  float result_dx12, result_dy12;
  float gradient_noise_x_value11 = solid_wood_gradient_noise_x(difference5, 2, uv_dx, uv_dy,
      result_dx12, result_dy12);
  float result_dx13, result_dy13;
  float gradient_noise_x_value12 = solid_wood_gradient_noise_x(difference5, 3, uv_dx, uv_dy,
      result_dx13, result_dy13);
  vec3 difference6 = vec3(gradient_noise_x_value7, gradient_noise_x_value8, gradient_noise_x_value9)
      - vec3(gradient_noise_x_value10, gradient_noise_x_value11, gradient_noise_x_value12);
  vec3 difference7 = vec3(result_dx8, result_dx9, result_dx10)
      - vec3(result_dx11, result_dx12, result_dx13);
  vec3 difference8 = vec3(result_dy8, result_dy9, result_dy10)
      - vec3(result_dy11, result_dy12, result_dy13);
  vec3 along_y = difference6 * 0.5 / way.y;
  vec3 along_y_dx = difference7 * 0.5 / way.y;
  vec3 along_y_dy = difference8 * 0.5 / way.y;
  vec3 sum3 = uv + z;
  float result_dx14, result_dy14;
  float gradient_noise_x_value13 = solid_wood_gradient_noise_x(sum3, 1, uv_dx, uv_dy, result_dx14,
      result_dy14);
  float result_dx15, result_dy15;
  float gradient_noise_x_value14 = solid_wood_gradient_noise_x(sum3, 2, uv_dx, uv_dy, result_dx15,
      result_dy15);
  float result_dx16, result_dy16;
  float gradient_noise_x_value15 = solid_wood_gradient_noise_x(sum3, 3, uv_dx, uv_dy, result_dx16,
      result_dy16);
  vec3 difference9 = uv - z;
  float result_dx17, result_dy17;
  float gradient_noise_x_value16 = solid_wood_gradient_noise_x(difference9, 1, uv_dx, uv_dy,
      result_dx17, result_dy17);
  float result_dx18, result_dy18;
  float gradient_noise_x_value17 = solid_wood_gradient_noise_x(difference9, 2, uv_dx, uv_dy,
      result_dx18, result_dy18);
  float result_dx19, result_dy19;
  float gradient_noise_x_value18 = solid_wood_gradient_noise_x(difference9, 3, uv_dx, uv_dy,
      result_dx19, result_dy19);
  vec3 difference10 = vec3(gradient_noise_x_value13, gradient_noise_x_value14,
      gradient_noise_x_value15) - vec3(gradient_noise_x_value16, gradient_noise_x_value17,
      gradient_noise_x_value18);
  vec3 difference11 = vec3(result_dx14, result_dx15, result_dx16)
      - vec3(result_dx17, result_dx18, result_dx19);
  vec3 difference12 = vec3(result_dy14, result_dy15, result_dy16)
      - vec3(result_dy17, result_dy18, result_dy19);
  vec3 along_z = difference10 * 0.5 / way.z;
  vec3 along_z_dx = difference11 * 0.5 / way.z;
  vec3 along_z_dy = difference12 * 0.5 / way.z;
  float difference13 = along_y_dx.z - along_z_dx.y;
  float difference14 = along_y_dy.z - along_z_dy.y;
  result_dx = vec3(difference13, along_z_dx.x - along_x_dx.z, along_x_dx.y - along_y_dx.x);
  result_dy = vec3(difference14, along_z_dy.x - along_x_dy.z, along_x_dy.y - along_y_dy.x);
  return vec3(along_y.z - along_z.y, along_z.x - along_x.z, along_x.y - along_y.x);
}

// sawtooth_wave (math/sawtooth_wave.glsl)
float solid_wood_sawtooth_wave(float phase, float phase_dx, float phase_dy, out float result_dx,
    out float result_dy) {
  float width = max(sqrt(phase_dx * phase_dx + phase_dy * phase_dy), 1e-7);
  float product = 0.5 * width;
  float low = fract(phase - product);
  float high = low + width;
  float jumps = floor(high);
  result_dx = phase_dx - phase_dx * jumps / width;
  result_dy = phase_dy - phase_dy * jumps / width;
  return low + product - jumps * (high - 0.5 * (jumps + 1.0)) / width;
}

// triangle_wave (math/triangle_wave.glsl)
float solid_wood_triangle_wave(float phase, float phase_dx, float phase_dy) {
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

// secant, of curve (math/curve.glsl)
float solid_wood_secant(int i) {
  vec2 way = solid_wood_points[clamp(i + 1, 0, 4)] - solid_wood_points[clamp(i, 0, 4)];
  return way.y / max(way.x, 1e-7);
}

// slope_at, of curve (math/curve.glsl)
float solid_wood_slope_at(int i) {
  int middle = clamp(i, 1, 3);
  int difference = middle - 1;
  float before = solid_wood_secant(difference);
  float behind = solid_wood_secant(middle);
  float value = solid_wood_points[middle].x;
  float length_before = max(value - solid_wood_points[clamp(difference, 0, 4)].x, 1e-7);
  float length_behind = max(solid_wood_points[middle + 1].x - value, 1e-7);
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
float solid_wood_part_mean(int i, float middle, float reach) {
  vec2 from = solid_wood_points[clamp(i, 0, 4)];
  int sum = i + 1;
  vec2 to = solid_wood_points[clamp(sum, 0, 4)];
  float way = max(to.x - from.x, 1e-7);
  float t = clamp((middle - from.x) / way, 0.0, 1.0);
  float rise = to.y - from.y;
  float start = way * solid_wood_slope_at(i) - rise;
  float end = rise - way * solid_wood_slope_at(sum);
  float product = 6.0 * t;
  float bend = (product - 4.0) * start + (2.0 - product) * end;
  float part = reach / way;
  return from.y + rise * t + t * (1.0 - t) * mix(start, end, t) + bend * part * part / 6.0;
}

// curve (math/curve.glsl)
float solid_wood_curve(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp(-value / width + 0.5, 0.0, 1.0);
  float sum = 0.0;
  for (int i = 0; i < 4; ++i) {
    float next = clamp((solid_wood_points[i + 1].x - value) / width + 0.5, 0.0, 1.0);
    float middle = value + width * (0.5 * (below + next) - 0.5);
    float difference = next - below;
    float reach = 0.5 * difference * width;
    below = next;
    sum += difference * solid_wood_part_mean(i, middle, reach);
  }
  return sum + (1.0 - below) * 0.4;
}

// gradient_noise (noise/gradient_noise.glsl)
float solid_wood_gradient_noise_value(vec3 uv, vec3 uv_dx, vec3 uv_dy, out float result_dx,
    out float result_dy) {
  vec3 base = floor(uv);
  vec3 t = uv - base;
  vec3 product = t * t;
  vec3 product2 = product * t;
  vec3 product3 = t * 6.0;
  vec3 difference = product3 - 15.0;
  vec3 sum = t * difference + 10.0;
  vec3 fade = product2 * sum;
  vec3 fade_slope = ((t + t) * t + product) * sum + product2 * (difference + product3);
  uvec3 cell = uvec3(ivec3(base));
  uint sum2 = cell.x + 1u;
  uvec4 columns = uvec4(cell.x, sum2, cell.x, sum2);
  uvec2 slices = solid_wood_hash(uvec2(cell.z, cell.z + 1u) + 129708002u);
  uint sum3 = cell.y + 1u;
  uvec4 rows = solid_wood_hash(uvec4(cell.y, sum3, cell.y, sum3) + slices.xxyy);
  vec4 x0, y0, z0;
  solid_wood_directions3(solid_wood_hash(columns + rows.xxyy), x0, y0, z0);
  vec4 x1, y1, z1;
  solid_wood_directions3(solid_wood_hash(columns + rows.zzww), x1, y1, z1);
  vec3 u = t - 1.0;
  vec4 tx = vec4(t.x, u.x, t.x, u.x);
  vec4 ty = vec4(t.yy, u.yy);
  vec4 front = x0 * tx + y0 * ty + z0 * t.z;
  vec4 front_dx = uv_dx.x * x0 + uv_dx.y * y0 + uv_dx.z * z0;
  vec4 front_dy = uv_dy.x * x0 + uv_dy.y * y0 + uv_dy.z * z0;
  vec4 back = x1 * tx + y1 * ty + z1 * u.z;
  vec4 back_dx = uv_dx.x * x1 + uv_dx.y * y1 + uv_dx.z * z1;
  vec4 back_dy = uv_dy.x * x1 + uv_dy.y * y1 + uv_dy.z * z1;
  vec3 fade_dx = uv_dx * fade_slope;
  vec3 fade_dy = uv_dy * fade_slope;
  vec4 face = mix(front, back, fade.z);
  vec4 difference2 = back - front;
  vec4 face_dx = mix(front_dx, back_dx, fade.z) + difference2 * fade_dx.z;
  vec4 face_dy = mix(front_dy, back_dy, fade.z) + difference2 * fade_dy.z;
  vec2 blend = mix(face.xz, face.yw, fade.x);
  vec2 difference3 = face.yw - face.xz;
  vec2 sum4 = mix(face_dx.xz, face_dx.yw, fade.x) + difference3 * fade_dx.x;
  vec2 sum5 = mix(face_dy.xz, face_dy.yw, fade.x) + difference3 * fade_dy.x;
  float difference4 = blend.y - blend.x;
  result_dx = (mix(sum4.x, sum4.y, fade.y) + difference4 * fade_dx.y) * 0.8882547;
  result_dy = (mix(sum5.x, sum5.y, fade.y) + difference4 * fade_dy.y) * 0.8882547;
  return mix(blend.x, blend.y, fade.y) * 0.8882547 + 0.5;
}

// fbm (noise/fbm.glsl)
float solid_wood_fbm_fibres(vec3 uv, vec3 uv_dx, vec3 uv_dy, out float result_dx,
    out float result_dy) {
  vec3 p = uv * vec3(38.0, 38.0, 2.5);
  vec3 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * vec3(38.0, 38.0, 2.5);
  float width = max(max(product.x, product.y), product.z);
  vec3 p_dx = uv_dx * vec3(38.0, 38.0, 2.5);
  vec3 p_dy = uv_dy * vec3(38.0, 38.0, 2.5);
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
      float gradient_noise_value_value = solid_wood_gradient_noise_value(p * frequency + shift,
          p_dx * frequency, p_dy * frequency, result_dx2, result_dy2);
      sum += product2 * (gradient_noise_value_value - 0.5);
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

// level_fibre_tone, of levels (color/levels.glsl)
float solid_wood_level_fibre_tone(float value, float value_dx, float value_dy) {
  float t = (value - 0.3) * 2.5000002;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 2.5000002, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// turbulence (noise/turbulence.glsl)
float solid_wood_turbulence(vec3 uv, vec3 uv_dx, vec3 uv_dy, out float result_dx,
    out float result_dy) {
  vec3 p = uv * vec3(70.0, 70.0, 5.0);
  vec3 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * vec3(70.0, 70.0, 5.0);
  float width = max(max(product.x, product.y), product.z);
  vec3 p_dx = uv_dx * vec3(70.0, 70.0, 5.0);
  vec3 p_dy = uv_dy * vec3(70.0, 70.0, 5.0);
  float weight = 0.6666667;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.196;
  float sum_dx = 0.0;
  float sum_dy = 0.0;
  for (int octave = 0; octave < 2; ++octave) {
    float near = min(2.0 - 4.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float result_dx2, result_dy2;
      float gradient_noise_value_value = solid_wood_gradient_noise_value(p * frequency + shift,
          p_dx * frequency, p_dy * frequency, result_dx2, result_dy2);
      float difference = 2.0 * gradient_noise_value_value - 1.0;
      float folded = abs(difference);
      float direction = sign(difference);
      float folded_dx = result_dx2 * 2.0 * direction;
      float folded_dy = result_dy2 * 2.0 * direction;
      float product2 = weight * near;
      sum += product2 * (folded - 0.196);
      sum_dx += folded_dx * product2;
      sum_dy += folded_dy * product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  result_dx = sum_dx;
  result_dy = sum_dy;
  return sum;
}

// level_pore_tone, of levels (color/levels.glsl)
float solid_wood_level_pore_tone(float value, float value_dx, float value_dy) {
  float t = (value - 0.01) * 9.090909;
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy) * 9.090909, 1e-7);
  float product = 0.5 * width;
  float low = clamp(t - product, 0.0, 1.0);
  float high = clamp(t + product, 0.0, 1.0);
  float below = clamp(0.5 - t / width, 0.0, 1.0);
  float above = clamp(0.5 - (1.0 - t) / width, 0.0, 1.0);
  float inside = 0.5 * (low + high);
  return above + (1.0 - below - above) * inside;
}

// gradient_noise (noise/gradient_noise.glsl)
float solid_wood_gradient_noise_value2(vec3 uv) {
  vec3 base = floor(uv);
  vec3 t = uv - base;
  vec3 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec3 cell = uvec3(ivec3(base));
  uint sum = cell.x + 1u;
  uvec4 columns = uvec4(cell.x, sum, cell.x, sum);
  uvec2 slices = solid_wood_hash(uvec2(cell.z, cell.z + 1u) + 129708002u);
  uint sum2 = cell.y + 1u;
  uvec4 rows = solid_wood_hash(uvec4(cell.y, sum2, cell.y, sum2) + slices.xxyy);
  vec4 x0, y0, z0;
  solid_wood_directions3(solid_wood_hash(columns + rows.xxyy), x0, y0, z0);
  vec4 x1, y1, z1;
  solid_wood_directions3(solid_wood_hash(columns + rows.zzww), x1, y1, z1);
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
float solid_wood_fbm_patches(vec3 uv, vec3 uv_dx, vec3 uv_dy) {
  vec3 p = uv * vec3(2.0, 2.0, 0.6);
  vec3 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * vec3(2.0, 2.0, 0.6);
  float width = max(max(product.x, product.y), product.z);
  float weight = 0.5714286;
  float frequency = 1.0;
  float shift = 0.0;
  float sum = 0.5;
  for (int octave = 0; octave < 3; ++octave) {
    float near = min(2.0 - 2.0 * width * frequency, 1.0);
    if (near > 0.0) {
      float product2 = weight * near * (solid_wood_gradient_noise_value2(p * frequency + shift)
          - 0.5);
      sum += product2;
    }
    weight *= 0.5;
    frequency *= 2.0;
    shift += 37.7;
  }
  return sum;
}

void solid_wood(vec3 position, out vec4 color, out float roughness) {
  vec3 position_dx = dFdx(position), position_dy = dFdy(position);
  // trunk: position_transform (coordinates/position_transform.glsl)
  vec3 trunk_dx, trunk_dy;
  vec3 trunk = solid_wood_rotate3d(position - vec3(0.9, 0.55, 0.0), position_dx, position_dy,
      trunk_dx, trunk_dy);
  // flow: curl3 (noise/curl3.glsl)
  vec3 flow_dx, flow_dy;
  vec3 flow = solid_wood_curl3(trunk, trunk_dx, trunk_dy, flow_dx, flow_dy);
  // drift: multiply (math/multiply.glsl)
  vec3 drift = flow * bend;
  // place: add (math/add.glsl)
  vec3 place = trunk + drift;
  vec3 drift_dx = flow_dx * bend;
  vec3 drift_dy = flow_dy * bend;
  vec3 place_dx = trunk_dx + drift_dx;
  vec3 place_dy = trunk_dy + drift_dy;
  // radius: magnitude (math/magnitude.glsl)
  float radius = length(place.xy);
  float greatest = max(radius, 1e-20);
  float radius_dx = dot(place.xy, place_dx.xy) / greatest;
  float radius_dy = dot(place.xy, place_dy.xy) / greatest;
  // years: multiply (math/multiply.glsl)
  float years = radius * rings;
  // year: sawtooth_wave (math/sawtooth_wave.glsl)
  float years_dx = radius_dx * rings;
  float years_dy = radius_dy * rings;
  float year_dx, year_dy;
  float year = solid_wood_sawtooth_wave(years, years_dx, years_dy, year_dx, year_dy);
  // season: triangle_wave (math/triangle_wave.glsl)
  float season = solid_wood_triangle_wave(years, years_dx, years_dy);
  // late: curve (math/curve.glsl)
  float late = solid_wood_curve(year, year_dx, year_dy);
  // ring: lerp (math/lerp.glsl)
  float ring = mix(late, season, 0.25);
  // fibres: fbm (noise/fbm.glsl)
  float fibres_dx, fibres_dy;
  float fibres = solid_wood_fbm_fibres(place, place_dx, place_dy, fibres_dx, fibres_dy);
  // fibre_tone: levels (color/levels.glsl)
  float fibre_tone = mix(0.72, 1.15, solid_wood_level_fibre_tone(fibres, fibres_dx, fibres_dy));
  // pores: turbulence (noise/turbulence.glsl)
  float pores_dx, pores_dy;
  float pores = solid_wood_turbulence(place, place_dx, place_dy, pores_dx, pores_dy);
  // pore_tone: levels (color/levels.glsl)
  float pore_tone = mix(0.55, 1.0, solid_wood_level_pore_tone(pores, pores_dx, pores_dy));
  // patches: fbm (noise/fbm.glsl)
  float patches = solid_wood_fbm_patches(place, place_dx, place_dy);
  // body: lerp (math/lerp.glsl)
  vec3 body = mix(vec3(0.5, 0.28, 0.115), vec3(0.62, 0.4, 0.2), patches);
  // wood: lerp (math/lerp.glsl)
  vec3 wood = mix(body, vec3(0.24, 0.095, 0.032), ring);
  // tone: multiply (math/multiply.glsl)
  float tone = fibre_tone * pore_tone;
  // toned: multiply (math/multiply.glsl)
  vec3 toned = wood * tone;
  // color: rgba (channels/rgba.glsl)
  vec4 color2 = vec4(toned, 1.0);
  // roughness: remap (math/remap.glsl)
  float roughness2 = mix(0.3, 0.55, fibres);
  color = color2;
  roughness = roughness2;
}
