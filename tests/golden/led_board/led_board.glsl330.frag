// led_board: a fragment shader, compiled by texgraphc 0.1.0.
#version 330

// Inputs
in vec2 uv;

// Parameters
uniform float time;
uniform float quiet;  // default 1.0

// Textures
uniform sampler2DArray lamps;
uniform sampler2D message;

// Outputs
layout(location = 0) out vec4 out_color;

// Constants
const int patterns[8] = int[8](3, 4, 4, 4, 4, 4, 4, 3);

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

// wrap_cell (tiles/wrap_cell.glsl)
ivec2 wrap_cell(ivec2 cell) {
  ivec2 flip = cell >> 31;
  return (((cell ^ flip) % ivec2(64, 9)) ^ flip) + (flip & ivec2(64, 9));
}

// animation_sequence (indirection/animation_sequence.glsl)
int animation_sequence_glow_step(float time, float phase) {
  float run = mod(time + phase, 8.0);
  return clamp(int(run), 0, 7);
}

// animation_sequence (indirection/animation_sequence.glsl)
int animation_sequence_flash(float time, float phase, float rest) {
  float still = max(rest, 0.0);
  float run = mod(time + phase, 8.0 + still) - still;
  return clamp(int(run), 0, 7);
}

void main() {
  // board: virtual_tile_map (indirection/virtual_tile_map.glsl)
  vec2 product = uv * vec2(48.0, 9.0);
  // luck: virtual_random_map (indirection/virtual_random_map.glsl)
  vec4 luck = four_numbers(cell_hash(ivec2(floor(product))));
  // pictures: multiply (math/multiply.glsl)
  float pictures = time * 16.0;
  // phase: multiply (math/multiply.glsl)
  float phase = luck.x * 600.0;
  // ticks: multiply (math/multiply.glsl)
  float ticks = time * 8.0;
  // steps: round_down (math/round_down.glsl)
  float steps = floor(ticks);
  // shift: divide (math/divide.glsl)
  float shift = steps * 0.015625;
  // offset: combine2 (channels/combine2.glsl)
  vec2 offset = vec2(shift, 0.0);
  // stretched: multiply (math/multiply.glsl)
  vec2 stretched = uv * vec2(0.75, 1.0);
  // scrolled: add (math/add.glsl)
  vec2 scrolled = stretched + offset;
  // is_text: explicit_indirection_map (indirection/explicit_indirection_map.glsl)
  vec4 texel = texelFetch(message, wrap_cell(ivec2(floor(scrolled * vec2(64.0, 9.0)))), 0);
  int is_text = int(texel.x);
  // glow_step: animation_sequence (indirection/animation_sequence.glsl)
  int glow_step = animation_sequence_glow_step(pictures, phase);
  // glow_number: to_float (channels/to_float.glsl)
  float glow_number = float(glow_step);
  // glow_place: divide (math/divide.glsl)
  float glow_place = glow_number * 0.125;
  // glow: probability_map (indirection/probability_map.glsl)
  int glow = patterns[clamp(int(clamp(glow_place, 0.0, 1.0) * 8.0), 0, 7)];
  // rest: remap (math/remap.glsl)
  float rest = mix(150.0, 600.0, luck.y);
  // long_rest: multiply (math/multiply.glsl)
  float long_rest = rest * quiet;
  // flash: animation_sequence (indirection/animation_sequence.glsl)
  int flash = animation_sequence_flash(pictures, phase, long_rest);
  // bright: reference_texture (indirection/reference_texture.glsl)
  vec4 bright = texture(lamps, vec3(product, float(glow)));
  // dark: reference_texture (indirection/reference_texture.glsl)
  vec4 texel2 = texture(lamps, vec3(product, float(flash)));
  vec4 dark = flash < 0 ? vec4(0.0) : texel2;
  // share: to_float (channels/to_float.glsl)
  float share = float(is_text);
  // panel: lerp (math/lerp.glsl)
  vec4 panel = mix(dark, bright, share);
  out_color = panel;
}
