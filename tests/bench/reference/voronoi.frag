#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/voronoi as a careful person would write it: the same points, colours and random bits. The
// nearest point is in one of 12 cells: the 4 x 4 around the nearest corner of the grid, without
// their corners.

layout(location = 0) in vec2 uv;

layout(location = 0) uniform float darkness;

layout(location = 0) out vec4 out_color;

uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// y of pcg2d, whose first linear steps are put together; the addends are the bits of the seed.
uint cell_bits(ivec2 cell) {
  uvec2 c = uvec2(cell);
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u) +
            uvec2(2161170183u, 2614696773u);
  v ^= v >> 16u;
  v *= uvec2(1664525u, 389569706u);
  return v.x + v.y;
}

vec2 two(uint bits) { return vec2(bits & 65535u, bits >> 16u) / 65536.0; }

void visit(ivec2 corner, vec2 place, ivec2 offset, inout float square, inout uint nearest) {
  uint bits = cell_bits(corner + offset);
  vec2 arm = vec2(offset) + two(hash(bits - 1u)) - place;
  float d = dot(arm, arm);
  if (d < square) {
    square = d;
    nearest = bits;
  }
}

void main() {
  const float SCALE = 12.0;
  vec2 p = uv * SCALE;
  vec2 corner = floor(p + 0.5);
  vec2 place = p - corner;
  ivec2 cell = ivec2(corner);

  float square = 1e9;
  uint bits = 0u;
  for (int y = -1; y <= 0; ++y) {
    for (int x = -2; x <= 1; ++x) {
      visit(cell, place, ivec2(x, y), square, bits);
    }
  }
  for (int y = -2; y <= 1; y += 3) {
    for (int x = -1; x <= 0; ++x) {
      visit(cell, place, ivec2(x, y), square, bits);
    }
  }

  // Where a pixel holds whole cells, the means.
  vec2 dx = dFdx(p), dy = dFdy(p);
  vec2 lengths = dx * dx + dy * dy;
  float pixel = sqrt(max(lengths.x, lengths.y));
  float f1 = mix(sqrt(square), 0.4298, clamp(2.0 * pixel - 1.0, 0.0, 1.0));
  vec2 part = 1.0 + 0.25 * lengths;
  float near = 1.0 / (part.x * part.y);

  uint color_bits = hash(bits);
  vec3 luck = vec3(two(color_bits), float(hash(color_bits) >> 8u) / 16777216.0);
  vec3 region = mix(vec3(0.35, 0.2, 0.1), vec3(1.0, 0.9, 0.6), mix(vec3(0.5), luck, near));
  out_color = vec4(region * (1.0 - darkness * f1 * f1), 1.0);
}
