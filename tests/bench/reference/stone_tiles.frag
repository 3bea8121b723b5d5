#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/stone_tiles as a careful person would write it: the same tiles, wear and random bits.

layout(location = 0) in vec2 uv;

layout(location = 0) uniform vec3 grout;
layout(location = 1) uniform float wear;

layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_height;

const vec2 CELLS = vec2(4.0, 6.0);
const vec2 JOINT = 0.012 * CELLS;  // in tiles

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

// How much tile lies between 0 and p, in each direction.
vec2 tile_until(vec2 p) {
  vec2 turns = floor(p);
  return turns * (1.0 - JOINT) + clamp(p - turns - 0.5 * JOINT, vec2(0.0), 1.0 - JOINT);
}

float joints(vec2 p, vec2 pixel) {
  vec2 box = max(pixel, 1e-4);
  vec2 tile = (tile_until(p + 0.5 * box) - tile_until(p - 0.5 * box)) / box;
  return 1.0 - tile.x * tile.y;
}

void main() {
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  vec2 pixel = sqrt(dx * dx + dy * dy);

  // The tile, in a running bond.
  vec2 p = uv * CELLS;
  int row = int(floor(p.y));
  p.x += 0.5 * float(row & 1);
  vec2 corner = floor(p);
  uint seed = hash(uint(int(corner.x)) + hash(uint(row) + hash(11u)));
  vec2 local = p - corner;

  // Sandstone.
  float hue = float(hash(seed) >> 8u) / 16777216.0;
  vec3 stone = mix(vec3(0.42, 0.27, 0.15), vec3(0.58, 0.42, 0.26), clamp(2.0 * hue, 0.0, 1.0));
  stone = mix(stone, vec3(0.5, 0.36, 0.27), clamp(2.0 * hue - 1.0, 0.0, 1.0));
  float strata = noise(uv * vec2(5.0, 60.0), pixel * vec2(5.0, 60.0), 4u);
  float sand = noise(uv * 180.0, pixel * 180.0, 5u);
  float tone = mix(0.7, 1.2, mix(strata, sand, 0.5));

  // Worn at the edges.
  vec2 inward = (0.5 - abs(local - 0.5)) / CELLS;
  float depth = min(inward.x, inward.y) - wear * noise(uv * 50.0, pixel * 50.0, 6u);
  float evenness = smoothstep(-0.004, 0.012, depth);

  float joint = joints(local, pixel * CELLS);
  out_color = vec4(mix(stone * (tone * mix(0.55, 1.0, evenness)), grout, joint), 1.0);
  out_height = evenness;
}
