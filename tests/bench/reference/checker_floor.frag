#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/checker_floor as a careful person would write it: the same slabs, joints and random bits.

layout(location = 0) in vec2 uv;

layout(location = 0) uniform vec4 light;
layout(location = 1) uniform vec4 dark;

layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

const float SLABS = 8.0;
const float JOINT = 0.004 * SLABS;  // in slabs

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

// The share of a box `pixel` large around p that light squares take: the integral of a square wave is a triangle wave.
float checker(vec2 p, vec2 pixel) {
  p *= 0.5;
  vec2 box = max(0.5 * pixel, 5e-5);
  vec2 wave = (abs(fract(p - 0.5 * box) - 0.5) - abs(fract(p + 0.5 * box) - 0.5)) / box;
  return 0.5 + 0.5 * wave.x * wave.y;
}

// How much slab lies between 0 and p, in each direction.
vec2 slab_until(vec2 p) {
  vec2 turns = floor(p);
  return turns * (1.0 - JOINT) + clamp(p - turns - 0.5 * JOINT, 0.0, 1.0 - JOINT);
}

float joints(vec2 p, vec2 pixel) {
  vec2 box = max(pixel, 1e-4);
  vec2 slab = (slab_until(p + 0.5 * box) - slab_until(p - 0.5 * box)) / box;
  return 1.0 - slab.x * slab.y;
}

void main() {
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  vec2 pixel = SLABS * sqrt(dx * dx + dy * dy);

  // The slab: its colour, and a tone of its own.
  vec2 p = uv * SLABS;
  vec2 corner = floor(p);
  uvec2 cell = uvec2(ivec2(corner));
  uint seed = hash(cell.x + hash(cell.y + hash(0u)));
  float tone = mix(0.75, 1.1, float(hash(seed) >> 8u) / 16777216.0);
  vec3 slab = mix(dark.rgb, light.rgb, checker(p, pixel));

  // Grain, turned against the slabs.
  const float c = cos(radians(33.0)), s = sin(radians(33.0));
  const mat2 turn = mat2(c, -s, s, c);
  vec2 q = turn * (uv - 0.5) + 0.5;
  vec2 qx = turn * dx, qy = turn * dy;
  vec2 grain_pixel = sqrt(qx * qx + qy * qy);
  float grain = mix(noise(q * 34.0, grain_pixel * 34.0, 3u), noise(q * 110.0, grain_pixel * 110.0, 4u), 0.4);

  float gap = joints(p - corner, pixel);
  out_color = vec4(mix(slab * (tone * mix(0.85, 1.1, grain)), vec3(0.16, 0.15, 0.14), gap), 1.0);
  out_roughness = mix(0.25, 0.9, gap);
}
