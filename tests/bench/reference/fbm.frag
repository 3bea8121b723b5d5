#version 450 core
// SPDX-License-Identifier: Apache-2.0
// Five octaves of Perlin's noise as a careful person would write them: the random bits and slopes of gradient_noise, the
// derivatives taken once, octaves finer than a pixel left out.

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 out_color;

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
// From -1 to 1.
float noise(vec2 p) {
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + 129708002u);
  uvec2 columns = uvec2(cell.x, cell.x + 1u);
  uvec4 bits = hash(columns.xyxy + rows.xxyy);
  vec4 x = vec4(ivec4(bits)) / 2147483648.0;
  vec4 y = uintBitsToFloat(floatBitsToUint(1.0 - abs(x)) ^ (bits << 31u));
  vec2 u = t - 1.0;
  vec4 corners = x * vec4(t.x, u.x, t.x, u.x) + y * vec4(t.yy, u.yy);
  vec2 ends = mix(corners.xz, corners.yw, fade.x);
  return mix(ends.x, ends.y, fade.y);
}
void main() {
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  vec2 pixel = 8.0 * sqrt(dx * dx + dy * dy);
  float width = max(pixel.x, pixel.y);
  vec2 p = uv * 8.0;
  float weight = 0.93409677 * 16.0 / 31.0;
  float sum = 0.5;
  float scale = 1.0;
  float shift = 0.0;
  for (int i = 0; i < 5; ++i) {
    float w = width * scale;
    if (w < 1.0) {
      sum += weight * clamp(2.0 - 2.0 * w, 0.0, 1.0) * noise(p * scale + shift);
    }
    scale *= 2.0;
    weight *= 0.5;
    shift += 37.7;
  }
  out_color = vec4(vec3(sum), 1.0);
}
