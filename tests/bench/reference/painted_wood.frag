#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/painted_wood as a careful person would write it: the same boards, flakes and random bits.

layout(location = 0) in vec2 uv;

layout(location = 0) uniform vec4 paint;
layout(location = 1) uniform float wear;
layout(binding = 0) uniform sampler2D wood;

layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

const vec2 CELLS = vec2(7.0, 2.0);
const vec2 JOINT = 0.004 * CELLS;  // in boards

uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

uvec2 hash(uvec2 value) {
  uvec2 state = value * 747796405u + 2891336453u;
  uvec2 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

uvec4 hash(uvec4 value) {
  uvec4 state = value * 747796405u + 2891336453u;
  uvec4 word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// Smooth random hills at p, whose change over a pixel is `pixel`; they fade to their mean where a cell is no larger than a pixel.
float noise(vec2 p, vec2 pixel, uint seed) {
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(seed));
  uvec2 columns = uvec2(cell.x, cell.x + 1u);
  vec4 corners = vec4(hash(columns.xyxy + rows.xxyy) >> 8u) / 16777216.0;
  vec2 ends = mix(corners.xz, corners.yw, fade.x);
  float blur = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  return mix(mix(ends.x, ends.y, fade.y), 0.5, blur);
}

float random(uint seed, uint stream) { return float(hash(seed + stream) >> 8u) / 16777216.0; }

// How much board lies between 0 and p, in each direction.
vec2 board_until(vec2 p) {
  vec2 turns = floor(p);
  return turns * (1.0 - JOINT) + clamp(p - turns - 0.5 * JOINT, vec2(0.0), 1.0 - JOINT);
}

float joints(vec2 p, vec2 pixel) {
  vec2 box = max(pixel, 1e-4);
  vec2 board = (board_until(p + 0.5 * box) - board_until(p - 0.5 * box)) / box;
  return 1.0 - board.x * board.y;
}

// The boards' grain, 0.4 x 0.8 large and turned by 0.6 degrees; the paint, turned by 27.
const float GRAIN_COS = cos(radians(0.6)), GRAIN_SIN = sin(radians(0.6));
const mat2 GRAIN = mat2(GRAIN_COS / 0.4, -GRAIN_SIN / 0.8, GRAIN_SIN / 0.4, GRAIN_COS / 0.8);
const float TILT_COS = cos(radians(27.0)), TILT_SIN = sin(radians(27.0));
const mat2 TILT = mat2(TILT_COS, -TILT_SIN, TILT_SIN, TILT_COS);

void main() {
  vec2 dx = dFdx(uv), dy = dFdy(uv);

  // The board, moved by 0.37 in every second row.
  vec2 p = uv * CELLS;
  int row = int(floor(p.y));
  p.x += 0.37 * float(row & 1);
  vec2 corner = floor(p);
  uint seed = hash(uint(int(corner.x)) + hash(uint(row) + hash(5u)));

  // Its wood: another part of the picture on each board.
  vec2 shift = vec2(random(seed, 1u), random(seed, 2u));
  vec3 bare = textureGrad(wood, GRAIN * (uv - 0.5) + 0.5 + shift, GRAIN * dx, GRAIN * dy).rgb;
  float fibre = dot(bare, vec3(0.2126, 0.7152, 0.0722));
  bare *= mix(0.65, 1.0, random(seed, 0u));

  // Paint, where the relief is above the wear.
  vec2 q = TILT * (uv - 0.5) + 0.5;
  vec2 qx = TILT * dx, qy = TILT * dy;
  vec2 pixel = sqrt(qx * qx + qy * qy);
  float patches = noise(q * vec2(9.0, 7.0), pixel * vec2(9.0, 7.0), 1u);
  float flakes = noise(q * vec2(42.0, 33.0), pixel * vec2(42.0, 33.0), 2u);
  float chips = noise(q * vec2(130.0, 90.0), pixel * vec2(130.0, 90.0), 3u);
  float relief = mix(mix(patches, mix(flakes, chips, 0.35), 0.45), fibre, 0.25);
  float painted = smoothstep(wear, wear + 0.03, relief);
  vec4 covered = mix(vec4(bare, 1.0), paint * mix(0.75, 1.1, fibre / 0.4), painted);

  float gap = joints(p - corner, sqrt(dx * dx + dy * dy) * CELLS);
  out_color = mix(covered, vec4(0.012, 0.01, 0.008, 1.0), gap);
  out_roughness = mix(0.85, 0.4, painted);
}
