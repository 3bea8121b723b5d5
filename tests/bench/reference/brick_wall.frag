#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/brick_wall as a careful person would write it: the same pictures, numbers and random bits.

layout(location = 0) in vec2 uv;

layout(location = 0) uniform vec3 tint;
layout(location = 1) uniform float soot_amount;
layout(location = 2) uniform float moss_amount;
layout(binding = 0) uniform sampler2D brick;
layout(binding = 1) uniform sampler2D mortar;
layout(binding = 2) uniform sampler2D soot;
layout(binding = 3) uniform sampler2D moss;

layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_roughness;

const ivec2 CELLS = ivec2(5, 10);

uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

vec2 random2(uint seed, int stream) {
  uint bits = hash(seed + uint(stream));
  return vec2(bits & 65535u, bits >> 16u) / 65536.0;
}

float random(uint seed, int stream) {
  return float(hash(seed + uint(stream)) >> 8u) / 16777216.0;
}

// Modulo that is right for negative numbers.
int wrap(int i, int count) {
  int flip = i >> 31;
  return (((i ^ flip) % count) ^ flip) + (flip & count);
}

// A coordinate with its change over one pixel to the right and upwards.
struct Point {
  vec2 at, dx, dy;
};

vec2 footprint(Point p) { return sqrt(p.dx * p.dx + p.dy * p.dy); }

// Where p lies in an element around `center`, turned by `angle` and `size` tiles large; `along` and `across` are the columns of
// the tile's shape.
Point element(Point p, vec2 center, float angle, float size, vec2 along, vec2 across) {
  vec2 c = cos(angle) / size * along, s = sin(angle) / size * across;
  p.at -= center;
  return Point(c * p.at + s * p.at.yx + 0.5, c * p.dx + s * p.dx.yx, c * p.dy + s * p.dy.yx);
}

// How much of the pixel the element covers, within its cell.
float coverage(Point q, vec2 cell_in_q, Point local) {
  vec2 density = 1.0 / clamp(footprint(q), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q.at - 0.5)) * density + 0.5, density);
  vec2 inside = clamp((0.5 - abs(local.at - 0.5)) / clamp(footprint(local), 1e-5, 1.0) + 0.5, 0.5, 1.0);
  vec2 covered = clamp(share / inside, 0.0, 1.0);
  return covered.x * covered.y;
}

vec4 over(vec4 front, vec4 back) {
  float alpha = 1.0 - (1.0 - front.a) * (1.0 - back.a);
  return vec4(mix(back.rgb, front.rgb, front.a / max(alpha, 1e-20)), alpha);
}

void main() {
  // The brick: its cell, seed, and the place in it.
  vec2 scale = vec2(CELLS);
  float y = uv.y * scale.y;
  int row = wrap(int(floor(y)), CELLS.y);
  uint row_bits = hash(uint(row) + hash(0u));
  float x = uv.x * scale.x + 0.5 * float(row & 1) + 0.08 * random(row_bits, -1);
  uint seed = hash(uint(wrap(int(floor(x)), CELLS.x)) + row_bits);
  Point cell = Point(fract(vec2(x, y)), dFdx(uv) * scale, dFdy(uv) * scale);

  // Its face.
  const vec2 shape = 1.0 / vec2(CELLS);
  const vec2 turned = vec2(shape.y / shape.x, -shape.x / shape.y);
  uint face_seed = hash(seed);
  vec2 turn = random2(face_seed, -2);
  float size = mix(0.97, 1.03, turn.x);
  Point q = element(cell, mix(vec2(0.485, 0.48), vec2(0.515, 0.52), random2(face_seed, -1)),
                    radians(mix(-1.2, 1.2, turn.y)), size, vec2(1.0), turned);
  vec4 face = textureGrad(brick, q.at, q.dx, q.dy);
  float firing = random(seed, 0);
  vec3 clay = mix(vec3(0.38, 0.36, 0.4), vec3(0.85, 0.75, 0.7), clamp(firing / 0.2, 0.0, 1.0));
  clay = mix(clay, vec3(1.25, 1.0, 0.8), clamp((firing - 0.2) / 0.4, 0.0, 1.0));
  clay = mix(clay, vec3(1.5, 1.5, 1.3), clamp((firing - 0.6) / 0.4, 0.0, 1.0));
  face.rgb *= clay * mix(0.7, 1.15, random(seed, 1)) * tint;
  face.a *= coverage(q, vec2(1.0 / size), cell);

  // Soot, in the frame of the face.
  vec2 frame = size * shape;
  uint soot_seed = hash(face_seed + 1u);
  vec2 soot_turn = random2(soot_seed, -2);
  float soot_size = mix(0.8, 1.5, soot_turn.x);
  Point s = element(q, mix(vec2(0.1, 0.4), vec2(0.9, 0.7), random2(soot_seed, -1)),
                    radians(mix(-8.0, 8.0, soot_turn.y)), soot_size, vec2(1.0), turned);
  vec4 stain = textureGrad(soot, s.at, s.dx, s.dy);
  vec2 soot_luck = random2(soot_seed, -3);
  stain.a = soot_luck.y >= 0.7 ? 0.0
                               : stain.a * soot_luck.x * coverage(s, vec2(1.0 / soot_size), q) * soot_amount * face.a;

  // Moss, in the largest square of that frame, on a third of the bricks.
  uint moss_seed = hash(face_seed + 2u);
  vec2 moss_turn = random2(moss_seed, -2);
  float moss_size = mix(0.4, 1.0, moss_turn.x);
  float side = min(frame.x, frame.y);
  vec2 along = frame / side;
  Point m = element(q, mix(vec2(0.1, 0.3), vec2(0.9, 0.55), random2(moss_seed, -1)),
                    radians(mix(-180.0, 180.0, moss_turn.y)), moss_size, along, vec2(along.y, -along.x));
  vec4 growth = textureGrad(moss, m.at, m.dx, m.dy);
  vec2 luck = random2(moss_seed, -3);
  growth.a = luck.y >= 0.35 ? 0.0
                            : growth.a * mix(0.6, 1.0, luck.x) * coverage(m, along / moss_size, q) * moss_amount;

  vec3 bed = texture(mortar, uv * 3.0).rgb;
  out_color = over(growth, over(over(stain, face), vec4(bed, 1.0)));
  out_roughness = mix(0.95, 0.8, face.a);
}
