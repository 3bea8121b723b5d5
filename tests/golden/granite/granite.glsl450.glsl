// granite: a function for a shader of #version 450 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec3 granite_scale;  // default vec3(8.0)

// Textures
uniform sampler3D granite_cubes;

// rotate3d (coordinates/rotate3d.glsl)
vec3 granite_rotate3d(vec3 vector, vec3 vector_dx, vec3 vector_dy, out vec3 result_dx,
    out vec3 result_dy) {
  vec3 sum = vector_dx * 0.81915206
      + cross(vec3(0.83045477, 0.49827287, 0.24913643), vector_dx) * -0.57357645;
  vec3 sum2 = vector_dy * 0.81915206
      + cross(vec3(0.83045477, 0.49827287, 0.24913643), vector_dy) * -0.57357645;
  vec3 product = 0.18084794 * dot(vec3(0.83045477, 0.49827287, 0.24913643), vector)
      * vec3(0.83045477, 0.49827287, 0.24913643);
  vec3 product2 = dot(vec3(0.83045477, 0.49827287, 0.24913643), vector_dx) * 0.18084794
      * vec3(0.83045477, 0.49827287, 0.24913643);
  vec3 product3 = dot(vec3(0.83045477, 0.49827287, 0.24913643), vector_dy) * 0.18084794
      * vec3(0.83045477, 0.49827287, 0.24913643);
  result_dx = sum + product2;
  result_dy = sum2 + product3;
  return 0.81915206 * vector + -0.57357645 * cross(vec3(0.83045477, 0.49827287, 0.24913643), vector)
      + product;
}

// hash (random/hash.glsl)
uvec2 granite_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 granite_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// corner_tile_place (by_example/corner_tile_place.glsl)
ivec2 granite_corner_tile_place(ivec4 corners) {
  int bit = 2 * (corners.x + 2 * corners.y + 4 * corners.z + 8 * corners.w);
  return ivec2(uvec2(825968358u >> uint(bit), 259139418u >> uint(bit)) & 3u);
}

// corner_cube_place (by_example/corner_cube_place.glsl)
ivec3 granite_corner_cube_place(ivec4 below, ivec4 above) {
  uvec2 window = uvec2(granite_corner_tile_place(below));
  uvec2 ij = (uvec2(granite_corner_tile_place(above)) + 4u - window) & 3u;
  uvec2 moved = uvec2(((ij.x * (ij.x - 1u)) >> 1u) + ij.y * 6u, ij.x * ij.y);
  uvec3 numbers = uvec3((window + 4u - (moved & 3u)) & 3u, ij.x + ij.y * 4u);
  return ivec3(numbers);
}

// corner_cubes (by_example/corner_cubes.glsl)
vec4 granite_corner_cubes(sampler3D cubes, vec3 position, vec3 tiling, vec3 position_dx,
    vec3 position_dy) {
  vec3 p = position * tiling;
  vec3 whole = floor(p);
  vec3 local = p - whole;
  ivec3 cell = ivec3(whole);
  ivec3 next = cell + 1;
  uvec2 slices = granite_hash(uvec2(uint(cell.z), uint(next.z)) + 129708002u);
  uvec4 sum = uvec4(uint(cell.y), uint(next.y), uint(cell.y), uint(next.y)) + slices.xxyy;
  uvec4 rows = granite_hash(sum);
  uvec4 columns = uvec4(uint(cell.x), uint(next.x), uint(cell.x), uint(next.x));
  uvec4 below = granite_hash(columns + rows.xxyy);
  uvec4 above = granite_hash(columns + rows.zzww);
  ivec3 place = granite_corner_cube_place(ivec4(below & 1u), ivec4(above & 1u));
  vec3 product = (vec3(place) + local) * vec3(0.25, 0.25, 0.0625);
  vec3 product2 = tiling * vec3(0.25, 0.25, 0.0625);
  vec4 color = textureGrad(cubes, product, position_dx * product2, position_dy * product2);
  return color;
}

// directions3 (noise/directions3.glsl)
void granite_directions3(uvec4 bits, out vec4 x, out vec4 y, out vec4 z) {
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
float granite_gradient_noise(vec3 uv, vec3 uv_dx, vec3 uv_dy, out float result_dx,
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
  uvec2 slices = granite_hash(uvec2(cell.z, cell.z + 1u) + 129708002u);
  uint sum3 = cell.y + 1u;
  uvec4 rows = granite_hash(uvec4(cell.y, sum3, cell.y, sum3) + slices.xxyy);
  vec4 x0, y0, z0;
  granite_directions3(granite_hash(columns + rows.xxyy), x0, y0, z0);
  vec4 x1, y1, z1;
  granite_directions3(granite_hash(columns + rows.zzww), x1, y1, z1);
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
float granite_fbm(vec3 uv, vec3 uv_dx, vec3 uv_dy, out float result_dx, out float result_dy) {
  vec3 p = uv * 1.6;
  vec3 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 1.6;
  float width = max(max(product.x, product.y), product.z);
  vec3 p_dx = uv_dx * 1.6;
  vec3 p_dy = uv_dy * 1.6;
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
      float gradient_noise_value = granite_gradient_noise(p * frequency + shift, p_dx * frequency,
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

// part_mean, of curve (math/curve.glsl)
float granite_part_mean(float middle) {
  float t = clamp((middle - 0.35) / 0.29999998, 0.0, 1.0);
  return 0.82 + 0.26000005 * t;
}

// curve (math/curve.glsl)
float granite_curve(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp((0.35 - value) / width + 0.5, 0.0, 1.0);
  float sum = 0.82 * below;
  float next = clamp((0.65 - value) / width + 0.5, 0.0, 1.0);
  float middle = value + width * (0.5 * (below + next) - 0.5);
  sum += (next - below) * granite_part_mean(middle);
  return sum + (1.0 - next) * 1.08;
}

void granite(vec3 position, out vec4 color, out float roughness) {
  vec3 position_dx = dFdx(position), position_dy = dFdy(position);
  // block_of_stone: position_transform (coordinates/position_transform.glsl)
  vec3 block_of_stone_dx, block_of_stone_dy;
  vec3 block_of_stone = granite_rotate3d(position, position_dx, position_dy, block_of_stone_dx,
      block_of_stone_dy);
  // stone: corner_cubes (by_example/corner_cubes.glsl)
  vec4 stone_color = granite_corner_cubes(granite_cubes, block_of_stone, granite_scale,
      block_of_stone_dx, block_of_stone_dy);
  // stains: fbm (noise/fbm.glsl)
  float stains_dx, stains_dy;
  float stains = granite_fbm(position, position_dx, position_dy, stains_dx, stains_dy);
  // weathered: curve (math/curve.glsl)
  float weathered = granite_curve(stains, stains_dx, stains_dy);
  // color: brightness_contrast (color/brightness_contrast.glsl)
  vec4 color2 = vec4(stone_color.xyz * weathered, stone_color.w);
  // light: luminance (channels/luminance.glsl)
  float light = dot(stone_color.xyz, vec3(0.2126, 0.7152, 0.0722));
  // roughness: remap (math/remap.glsl)
  float roughness2 = mix(0.2, 0.45, light);
  color = color2;
  roughness = roughness2;
}
