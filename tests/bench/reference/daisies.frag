#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/daisies as a careful person would write it: the same flowers in the same places, each
// pixel from the topmost daisy down, until it is full.

layout(location = 0) in vec2 uv;

layout(location = 0, binding = 0) uniform sampler2D daisy;

layout(location = 0) out vec4 out_color;

// Random bits of a cell: two for the place, one for what is on top.
uvec3 cell_bits(uvec2 c) {
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u) +
            uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  return v.x * uvec3(3266489917u, 668265263u, 374761393u) +
         v.y * uvec3(2246822519u, 3432918353u, 461845907u);
}

void main() {
  vec2 p = uv * 8.0 - 0.5;
  vec2 corner = floor(p);
  vec2 dx = dFdx(p), dy = dFdy(p);
  vec4 sum = vec4(0.0);
  uint last = 0xffffffffu;
  for (int seen = 0; seen < 4 && last > 0u && sum.a < 0.999; ++seen) {
    uint best = 0u;
    vec2 arm = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
      vec2 cell = corner + vec2(ivec2(i & 1, i >> 1));
      uvec3 bits = cell_bits(uvec2(ivec2(cell)));
      vec2 d = p - cell - vec2(ivec2(bits.xy)) / 4294967296.0;
      if (dot(d, d) < 0.25 && bits.z > best && bits.z < last) {
        best = bits.z;
        arm = d;
      }
    }
    last = best;
    if (best > 0u) {
      vec4 flower = textureGrad(daisy, arm + 0.5, dx, dy);
      sum += vec4(flower.rgb, 1.0) * (flower.a * (1.0 - sum.a));
    }
  }
  out_color = vec4(sum.rgb + vec3(0.07, 0.2, 0.03) * (1.0 - sum.a), 1.0);
}
