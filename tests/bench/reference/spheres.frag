#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/spheres as a careful person would write it: the same balls in the same places, each
// pixel from the topmost ball down, until it is full.

layout(location = 0) in vec3 position;

layout(location = 0) out vec4 out_color;

const vec3 colors[8] = vec3[8](vec3(0.65, 0.04, 0.03), vec3(0.85, 0.3, 0.02), vec3(0.9, 0.65, 0.1),
                               vec3(0.1, 0.35, 0.08), vec3(0.02, 0.25, 0.3), vec3(0.03, 0.1, 0.45),
                               vec3(0.3, 0.05, 0.3), vec3(0.85, 0.8, 0.7));

// Three random words of a cell: pcg3d, without its last shift.
uvec3 cell_bits(uvec3 cell) {
  uvec3 v = cell * 1664525u + uvec3(129708002u, 817759070u, 2145236065u);
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  v ^= v >> 16u;
  v.x += v.y * v.z;
  v.y += v.z * v.x;
  v.z += v.x * v.y;
  return v;
}

void main() {
  vec3 p = position * 8.0 - 0.5;
  vec3 corner = floor(p);
  vec3 dx = dFdx(p), dy = dFdy(p);
  // So that a ball that is only touched has its area in the pixel.
  float touch = 0.0253303 * dot(dx, dx) * dot(dy, dy);
  vec4 sum = vec4(0.0);
  uint last = 0xffffffffu;
  for (int seen = 0; seen < 8 && last > 0u && sum.a < 0.999; ++seen) {
    uint best = 0u;
    uint color = 0u;
    vec3 arm = vec3(0.0);
    for (int i = 0; i < 8; ++i) {
      vec3 cell = corner + vec3(ivec3(i & 1, (i >> 1) & 1, i >> 2));
      uvec3 v = cell_bits(uvec3(ivec3(cell)));
      uint third = v.x * 3266489917u + v.y * 668265263u + v.z * 374761393u;
      uint rank = v.x * 1597334677u + v.y * 3432918353u + v.z * 461845907u;
      vec3 d = p - cell - vec3(ivec3(v.xy, third)) / 4294967296.0;
      if (dot(d, d) < 0.25 && rank > best && rank < last) {
        best = rank;
        color = v.z >> 29u;
        arm = d;
      }
    }
    last = best;
    if (best > 0u) {
      // (r^2 - R^2) / 2 over its change is the distance to the rim in pixels.
      vec2 change = vec2(dot(arm, dx), dot(arm, dy));
      float width = sqrt(max(max(dot(change, change), touch), 1e-18));
      float edge = clamp((0.125 - 0.5 * dot(arm, arm)) / width, 0.0, 1.0);
      vec3 lit = colors[color] * (0.3 + 0.7 * dot(arm, vec3(0.5, 0.75, 0.3)));
      sum += vec4(lit, 1.0) * (edge * (1.0 - sum.a));
    }
  }
  out_color = vec4(sum.rgb, 1.0);
}
