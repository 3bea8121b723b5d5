#version 450 core
// SPDX-License-Identifier: Apache-2.0
// The wall of the chart as a careful person would write it: the same pictures, numbers and random
// bits. The benchmark defines LAYERS and TEXTURES, each from 1 to 4, below the version.

layout(location = 0) in vec2 uv;

layout(binding = 0) uniform sampler2D picture0;
#if TEXTURES > 1
layout(binding = 1) uniform sampler2D picture1;
#else
#define picture1 picture0
#endif
#if TEXTURES > 2
layout(binding = 2) uniform sampler2D picture2;
#else
#define picture2 picture0
#endif
#if TEXTURES > 3
layout(binding = 3) uniform sampler2D picture3;
#elif TEXTURES == 2
#define picture3 picture1
#else
#define picture3 picture0
#endif

layout(location = 0) out vec4 out_color;

const vec2 CELLS = vec2(4.0, 8.0);
const vec2 ACROSS = vec2(CELLS.x / CELLS.y, -CELLS.y / CELLS.x);  // of a tile's shape

uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

vec2 random2(uint seed, int stream) {
  uint bits = hash(seed + uint(stream));
  return vec2(bits & 65535u, bits >> 16u) / 65536.0;
}

// A coordinate with its change over one pixel to the right and upwards.
struct Point {
  vec2 at, dx, dy;
};

vec2 footprint(Point p) { return sqrt(p.dx * p.dx + p.dy * p.dy); }

// Where p lies in an element around `center`, turned by `angle` and `size` tiles large.
Point element(Point p, vec2 center, float angle, float size) {
  vec2 c = vec2(cos(angle) / size), s = sin(angle) / size * ACROSS;
  p.at -= center;
  return Point(c * p.at + s * p.at.yx + 0.5, c * p.dx + s * p.dx.yx, c * p.dy + s * p.dy.yx);
}

// How much of the pixel the element covers, within its cell; `mean` where a pixel holds whole cells.
float coverage(Point q, float cell_in_q, Point local, float opacity, float mean) {
  vec2 density = 1.0 / clamp(footprint(q), 1e-5, cell_in_q);
  vec2 share = min((0.5 - abs(q.at - 0.5)) * density + 0.5, density);
  vec2 width = footprint(local);
  vec2 inside = clamp((0.5 - abs(local.at - 0.5)) / clamp(width, 1e-5, 1.0) + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  float far = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(opacity * covered.x * covered.y, mean, far);
}

vec4 over(vec4 front, vec4 back) {
  float alpha = 1.0 - (1.0 - front.a) * (1.0 - back.a);
  return vec4(mix(back.rgb, front.rgb, front.a / max(alpha, 1e-20)), alpha);
}

// A smaller picture on a brick.
vec4 patch_on(sampler2D picture, Point face, uint seed) {
  vec2 turn = random2(seed, -2);
  float size = mix(0.3, 0.4, turn.x);
  Point q = element(face, mix(vec2(0.35), vec2(0.65), random2(seed, -1)),
                    radians(mix(-20.0, 20.0, turn.y)), size);
  vec4 color = textureGrad(picture, q.at, q.dx, q.dy);
  color.a *= coverage(q, 1.0 / size, face, mix(0.6, 1.0, random2(seed, -3).x), 0.8 * 0.37 / 3.0);
  return color;
}

void main() {
  vec2 p = uv * CELLS;
  int row = int(floor(p.y));
  p.x += 0.5 * float(row & 1);
  uint seed = hash(hash(uint(int(floor(p.x))) + hash(uint(row) + hash(0u))));
  Point cell = Point(fract(p), dFdx(uv) * CELLS, dFdy(uv) * CELLS);

  vec2 turn = random2(seed, -2);
  float size = mix(0.88, 0.94, turn.x);
  Point face = element(cell, mix(vec2(0.49), vec2(0.51), random2(seed, -1)),
                       radians(mix(-1.0, 1.0, turn.y)), size);
  vec4 brick = textureGrad(picture0, face.at, face.dx, face.dy);
  brick.a *= coverage(face, 1.0 / size, cell, 1.0, 0.8284);
  vec4 wall = over(brick, vec4(0.4, 0.4, 0.38, 1.0));
#if LAYERS > 1
  wall = over(patch_on(picture1, face, hash(seed + 1u)), wall);
#endif
#if LAYERS > 2
  wall = over(patch_on(picture2, face, hash(seed + 2u)), wall);
#endif
#if LAYERS > 3
  wall = over(patch_on(picture3, face, hash(seed + 3u)), wall);
#endif
  out_color = wall;
}
