// animated_tiles: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform float time;
uniform float rate;  // default 0.2
uniform float old_rate;  // default 1.0
uniform float change_time;  // default 32.0

// Textures
uniform sampler2DArray drops;

// Outputs
layout(location = 0) out vec4 out_color;

// cell_hash (indirection/cell_hash.glsl)
uint cell_hash(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u)
      + uvec2(129708002u, 817759070u);
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

// four_numbers, of virtual_random_map (indirection/virtual_random_map.glsl)
vec4 four_numbers(uint seed) {
  uint first = hash(seed);
  uint second = hash(first);
  float value = float(second >> 16u);
  vec4 vector = vec4(float(first & 65535u), float(first >> 16u), float(second & 65535u), value);
  return vector * 1.5258789e-5;
}

// animation_map (indirection/animation_map.glsl)
int animation_map(float time, float phase, float rest, float rate, float old_rate,
    float change_time) {
  float still = max(rest * rate, 0.0);
  float old_still = max(rest * old_rate, 0.0);
  float at_change = max(mod(change_time + phase, 8.0 + old_still) - old_still, 0.0);
  float old_end = change_time + (at_change > 0.0 ? 8.0 - at_change : 0.0);
  float at_end = max(mod(old_end + phase, 8.0 + still) - still, 0.0);
  float start = old_end + (at_end > 0.0 ? 8.0 - at_end : 0.0);
  float choice = time < old_end ? old_still : still;
  float place = max(mod(time + phase, 8.0 + choice) - choice, 0.0);
  float shown = old_end <= time && time < start ? 0.0 : place;
  return clamp(int(shown), 0, 7);
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

// value_noise (noise/value_noise.glsl)
float value_noise(vec2 uv, vec2 uv_dx, vec2 uv_dy) {
  vec2 p = uv * vec2(5.3, 4.7);
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uint sum = cell.x + 1u;
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 2161170183u);
  uvec4 bits = hash(uvec4(cell.x, sum, cell.x, sum) + rows.xxyy) >> 8u;
  vec4 corners = vec4(bits) * 5.9604645e-8;
  float low = mix(corners.x, corners.y, fade.x);
  float high = mix(corners.z, corners.w, fade.x);
  vec2 width = sqrt(uv_dx * uv_dx + uv_dy * uv_dy) * vec2(5.3, 4.7);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(mix(low, high, fade.y), 0.5, blur);
}

void main() {
  vec2 uv_dx = dFdx(uv), uv_dy = dFdy(uv);
  // grid: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * 12.0;
  // luck: virtual_random_map (indirection/virtual_random_map.glsl)
  vec4 luck = four_numbers(cell_hash(ivec2(floor(product))));
  // pictures: multiply (math/multiply.glsl)
  float pictures = time * 16.0;
  // phase: multiply (math/multiply.glsl)
  float phase = luck.x * 200.0;
  // rest: remap (math/remap.glsl)
  float rest = mix(8.0, 48.0, luck.y);
  // picture: animation_map (indirection/animation_map.glsl)
  int picture = animation_map(pictures, phase, rest, rate, old_rate, change_time);
  // water: reference_texture (indirection/reference_texture.glsl)
  vec4 texel = texture(drops, vec3(product, float(picture)));
  vec4 water = picture < 0 ? vec4(0.0) : texel;
  // depth: value_noise (noise/value_noise.glsl)
  float depth = value_noise(uv, uv_dx, uv_dy);
  // light: remap (math/remap.glsl)
  float light = mix(0.88, 1.1, depth);
  // tinted: multiply (math/multiply.glsl)
  vec4 tinted = water * light;
  // pond: rgba (channels/rgba.glsl)
  vec4 pond = vec4(tinted.xyz, 1.0);
  out_color = pond;
}
