#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/aperiodic_tiling as a careful person would write it: the same patterns in the same cells.

layout(location = 0) in vec2 uv;

layout(location = 0, binding = 0) uniform sampler2DArray grounds;

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

// The patterns repeat, so that the coordinate need not jump from cell to cell.
void main() {
  vec2 p = uv * 64.0;
  uint pattern = cell_bits(ivec2(floor(p))) >> 28u;
  out_color = texture(grounds, vec3(p, float(pattern)));
}
