#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/areas_tiling as a careful person would write it: the same grounds in the same cells.

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

// How much of a pixel is the tile in its middle, for a pixel of that many tiles.
float nearness(vec2 right, vec2 up) {
  vec2 part = 4.0 + right * right + up * up;
  return 16.0 / (part.x * part.y);
}

// The patterns repeat, so that the coordinate need not jump from cell to cell.
void main() {
  vec2 p = uv * 64.0;
  vec2 right = dFdx(p), up = dFdy(p);
  ivec2 cell = ivec2(floor(p));
  int kind = int(texelFetch(areas, (cell & 63) >> 3, 0).r);
  int pattern = 4 * clamp(kind, 0, 3) + int(cell_bits(cell) >> 30u);
  if (kind < 0) pattern = -1;
  vec4 mean = texture(far, uv);
  vec4 close = texture(grounds, vec3(p, float(pattern)));
  if (pattern < 0) close = vec4(0.0);
  out_color = mix(mean, close, nearness(right, up));
}
