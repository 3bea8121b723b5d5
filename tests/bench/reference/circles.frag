#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/circles as a careful person would write it: the same discs in the same places, each
// pixel from the topmost disc down, until it is full.

layout(location = 0) in vec2 uv;

layout(location = 0) out vec4 out_color;

const vec3 colors[8] = vec3[8](vec3(0.65, 0.04, 0.03), vec3(0.85, 0.3, 0.02), vec3(0.9, 0.65, 0.1),
                               vec3(0.1, 0.35, 0.08), vec3(0.02, 0.25, 0.3), vec3(0.03, 0.1, 0.45),
                               vec3(0.3, 0.05, 0.3), vec3(0.85, 0.8, 0.7));

// Random bits of a cell: two for the place, one for what is on top, one for the colour.
uvec4 cell_bits(uvec2 c) {
  uvec2 v = c.x * uvec2(1664525u, 389569705u) + c.y * uvec2(389569705u, 2942464162u) +
            uvec2(129708002u, 817759070u);
  v ^= v >> 16u;
  return v.x * uvec4(3266489917u, 668265263u, 374761393u, 1664525u) +
         v.y * uvec4(2246822519u, 3432918353u, 461845907u, 389569706u);
}

void main() {
  vec2 p = uv * 8.0 - 0.5;
  vec2 corner = floor(p);
  vec2 dx = dFdx(p), dy = dFdy(p);
  vec4 sum = vec4(0.0);
  uint last = 0xffffffffu;
  for (int seen = 0; seen < 4 && last > 0u && sum.a < 0.999; ++seen) {
    uint best = 0u;
    uint color = 0u;
    vec2 arm = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
      vec2 cell = corner + vec2(ivec2(i & 1, i >> 1));
      uvec4 bits = cell_bits(uvec2(ivec2(cell)));
      vec2 d = p - cell - vec2(ivec2(bits.xy)) / 4294967296.0;
      if (dot(d, d) < 0.25 && bits.z > best && bits.z < last) {
        best = bits.z;
        color = bits.w >> 29u;
        arm = d;
      }
    }
    last = best;
    if (best > 0u) {
      // (r^2 - R^2) / 2 over its change is the distance to the rim in pixels.
      float change = length(vec2(dot(arm, dx), dot(arm, dy)));
      float edge = clamp((0.125 - 0.5 * dot(arm, arm)) / max(change, 1e-9), 0.0, 1.0);
      sum += vec4(colors[color], 1.0) * (edge * (1.0 - sum.a));
    }
  }
  out_color = vec4(sum.rgb + vec3(0.02, 0.03, 0.08) * (1.0 - sum.a), 1.0);
}
