#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/transition_tiling as a careful person would write it: the same grounds and shores in the same cells.

layout(location = 0) in vec2 uv;

layout(location = 0, binding = 0) uniform sampler2DArray grounds;
layout(location = 1, binding = 1) uniform sampler2D areas;
layout(location = 2, binding = 2) uniform sampler2D far;

layout(location = 0) out vec4 out_color;

// Random bits of a cell, the upper ones are the good ones: pcg2d's y, its linear steps taken together.
uint cell_bits(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u) +
            uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// The area whose middle is near the tile's, one of four, as often as bilinear weights say. The map
// may change while it is looked at: it may say anything.
int dithered_area(ivec2 cell, uint seed) {
  ivec2 middle = 2 * (cell & 63) + 9;
  uint luck = hash(seed + 1u);
  ivec2 steps = ivec2(uvec2(luck & 65535u, luck >> 16u) >> 12u);
  ivec2 area = (middle >> 4) - ivec2(lessThanEqual(middle & 15, steps));
  return int(texelFetch(areas, area & 7, 0).r);
}

// How much of a pixel is the tile in its middle, for a pixel of that many tiles.
float nearness(vec2 right, vec2 up) {
  vec2 part = 4.0 + right * right + up * up;
  return 16.0 / (part.x * part.y);
}

// Materials are their own families.
int family(ivec2 cell) { return clamp(dithered_area(cell, cell_bits(cell)), 0, 1); }

// The edges of a shore differ, so that patterns are clamped: the coordinate jumps from cell to cell.
void main() {
  vec2 p = uv * 64.0;
  vec2 right = dFdx(p), up = dFdy(p);
  vec2 whole = floor(p);
  ivec2 cell = ivec2(whole);
  uint seed = cell_bits(cell);
  int kind = dithered_area(cell, seed);
  int here = clamp(kind, 0, 1);
  int shore = here + 2 * family(cell + ivec2(1, 0)) + 4 * family(cell + ivec2(0, 1)) +
              8 * family(cell + ivec2(1, 1));
  int pattern = 8 * here + int(seed >> 29u);
  if (kind < 0) pattern = -1;
  if (shore != 0 && shore != 15) pattern = 15 + shore;
  vec4 mean = texture(far, uv);
  vec4 close = pattern < 0 ? vec4(0.0)
                           : textureGrad(grounds, vec3(p - whole, float(pattern)), right, up);
  out_color = mix(mean, close, nearness(right, up));
}
