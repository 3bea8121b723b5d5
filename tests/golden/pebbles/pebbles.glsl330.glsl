// pebbles: a function for a shader of #version 330 or later, compiled by texgraphc 0.1.0.
// Call it in the main part of a fragment shader, outside branches and loops: textures are
// sampled with derivatives, which neighbouring pixels have to compute together.

// Parameters
uniform vec2 pebble_tiles;  // default vec2(6.0)
uniform float damp;  // default 0.5

// Textures
uniform sampler2DArray pebbles;
uniform sampler2DArray pebbles_relief;
uniform sampler2DArray pebbles_height;
uniform sampler2DArray pebbles_roughness;

// hash (random/hash.glsl)
uvec2 pebbles2_hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// hash (random/hash.glsl)
uvec4 pebbles2_hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// corner_tiles (by_example/corner_tiles.glsl)
vec4 pebbles2_corner_tiles(sampler2DArray tiles, vec2 uv, vec2 tiling) {
  vec2 p = uv * tiling;
  ivec2 cell = ivec2(floor(p));
  ivec2 even = (cell + 1) & -2;
  ivec2 odd = cell | 1;
  uvec2 rows = pebbles2_hash(uvec2(uint(even.y), uint(odd.y)) + 129708002u);
  uvec4 sum = uvec4(uint(even.x), uint(odd.x), uint(even.x), uint(odd.x)) + rows.xxyy;
  uvec4 bits = pebbles2_hash(sum);
  ivec4 around = ivec4(bits & 1u);
  int layer = around.x + 2 * (around.y + 2 * (around.z + 2 * around.w));
  vec2 place = p * 0.5;
  vec4 color = texture(tiles, vec3(place, float(layer)));
  return color;
}

// gradient_noise (noise/gradient_noise.glsl)
float pebbles2_gradient_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx,
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
  uvec2 rows = pebbles2_hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec4 hash_value = pebbles2_hash(uvec4(cell.x, sum2, cell.x, sum2) + rows.xxyy);
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
float pebbles2_fbm(vec2 uv, vec2 uv_dx, vec2 uv_dy, out float result_dx, out float result_dy) {
  vec2 p = uv * 2.5;
  vec2 product = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * 2.5;
  float width = max(product.x, product.y);
  vec2 p_dx = uv_dx * 2.5;
  vec2 p_dy = uv_dy * 2.5;
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
      float gradient_noise_value = pebbles2_gradient_noise(p * frequency + shift, p_dx * frequency,
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
float pebbles2_part_mean(float middle) {
  float t = clamp((middle - 0.45) / 0.17000002, 0.0, 1.0);
  return t;
}

// curve (math/curve.glsl)
float pebbles2_curve(float value, float value_dx, float value_dy) {
  float width = max(sqrt(value_dx * value_dx + value_dy * value_dy), 1e-7);
  float below = clamp((0.45 - value) / width + 0.5, 0.0, 1.0);
  float next = clamp((0.62 - value) / width + 0.5, 0.0, 1.0);
  float middle = value + width * (0.5 * (below + next) - 0.5);
  float sum = (next - below) * pebbles2_part_mean(middle);
  return sum + (1.0 - next);
}

// normal_map (materials/normal_map.glsl)
vec3 pebbles2_normal_map(vec3 texel) {
  vec3 n = texel * 2.0 - 1.0;
  return n * inversesqrt(max(dot(n, n), 1e-20));
}

void pebbles2(vec2 uv, out vec4 color, out vec3 normal, out float height, out float roughness) {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // stones: corner_tiles (by_example/corner_tiles.glsl)
  vec4 stones_color = pebbles2_corner_tiles(pebbles, uv, pebble_tiles);
  // weather: fbm (noise/fbm.glsl)
  float weather_dx, weather_dy;
  float weather = pebbles2_fbm(uv, uv_dx, uv_dy, weather_dx, weather_dy);
  // wet_here: curve (math/curve.glsl)
  float wet_here = pebbles2_curve(weather, weather_dx, weather_dy);
  // wetness: multiply (math/multiply.glsl)
  float wetness = wet_here * damp;
  // darkening: remap (math/remap.glsl)
  float darkening = mix(1.0, 0.5, wetness);
  // color: brightness_contrast (color/brightness_contrast.glsl)
  vec4 color2 = vec4(stones_color.xyz * darkening, stones_color.w);
  // facing: corner_tiles (by_example/corner_tiles.glsl)
  vec4 facing_color = pebbles2_corner_tiles(pebbles_relief, uv, pebble_tiles);
  // slope: normal_map (materials/normal_map.glsl)
  vec3 slope = pebbles2_normal_map(facing_color.xyz);
  // levels: corner_tiles (by_example/corner_tiles.glsl)
  vec4 levels_color = pebbles2_corner_tiles(pebbles_height, uv, pebble_tiles);
  // rough: corner_tiles (by_example/corner_tiles.glsl)
  vec4 rough_color = pebbles2_corner_tiles(pebbles_roughness, uv, pebble_tiles);
  // smoothing: remap (math/remap.glsl)
  float smoothing = mix(1.0, 0.35, wetness);
  // roughness: multiply (math/multiply.glsl)
  float roughness2 = rough_color.x * smoothing;
  color = color2;
  normal = slope;
  height = levels_color.x;
  roughness = roughness2;
}
