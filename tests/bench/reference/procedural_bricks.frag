#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/procedural_bricks as a careful person would write it: the same bricks, splashes and random bits.

layout(location = 0) in vec2 uv;

layout(location = 0) uniform vec3 clay;

layout(location = 0) out vec4 out_color;
layout(location = 1) out float out_height;

const vec2 CELLS = vec2(5.0, 10.0);

uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

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

// Smooth random hills at p, whose change over a pixel is `pixel`; they fade to their mean where a cell is no larger than a pixel.
float noise(vec2 p, vec2 pixel, uint seed) {
  vec2 base = floor(p);
  vec2 t = p - base;
  vec2 fade = t * t * t * (t * (t * 6.0 - 15.0) + 10.0);
  uvec2 cell = uvec2(ivec2(base));
  uvec2 rows = hash(uvec2(cell.y, cell.y + 1u) + hash(seed));
  uvec2 columns = uvec2(cell.x, cell.x + 1u);
  vec4 corners = vec4(hash(columns.xyxy + rows.xxyy) >> 8u) / 16777216.0;
  vec2 ends = mix(corners.xz, corners.yw, fade.x);
  float blur = clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  return mix(mix(ends.x, ends.y, fade.y), 0.5, blur);
}

vec2 random2(uint seed, int stream) {
  uint bits = hash(seed + uint(stream));
  return vec2(bits & 65535u, bits >> 16u) / 65536.0;
}

float random(uint seed) { return float(hash(seed) >> 8u) / 16777216.0; }

vec3 random3(uint seed, int stream) {
  uint bits = hash(seed + uint(stream));
  return vec3(vec2(bits & 65535u, bits >> 16u) / 65536.0, random(bits));
}

// A coordinate with its change over one pixel to the right and upwards.
struct Point {
  vec2 at, dx, dy;
};

vec2 footprint(Point p) { return sqrt(p.dx * p.dx + p.dy * p.dy); }

// How far what varies within a unit square has gone to its mean, where a pixel is about as large.
float far(vec2 pixel) { return clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0); }

// The share of a pixel that a single tile has.
float near(Point local) {
  vec2 part = 1.0 + 0.25 * (local.dx * local.dx + local.dy * local.dy);
  return 1.0 / (part.x * part.y);
}

// Where p lies in an element around `center`, turned by `angle` and `shrink` times as small as a tile; `along` and `across` are
// the columns of the tile's shape.
Point element(Point p, vec2 center, float angle, float shrink, vec2 along, vec2 across) {
  vec2 c = cos(angle) * shrink * along, s = sin(angle) * shrink * across;
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

// Rough clay within a rectangle whose edge is worn.
vec4 brick_face(vec2 p, vec2 pixel) {
  float clouds = noise(p * vec2(5.0, 3.0), pixel * vec2(5.0, 3.0), 1u);
  float grains = noise(p * vec2(48.0, 24.0), pixel * vec2(48.0, 24.0), 2u);
  float wave = noise(p * vec2(18.0, 9.0), pixel * vec2(18.0, 9.0), 3u);
  float inset = mix(0.86, 0.94, wave);
  vec2 size = vec2(inset, inset - 0.06);
  vec2 box = max(pixel, 1e-7);
  vec2 share = clamp(min((0.5 * size - abs(p - 0.5)) / box + 0.5, size / box), 0.0, 1.0);
  float alpha = mix(share.x * share.y, min(size.x * size.y, 1.0), far(pixel));
  return vec4(vec3(mix(0.55, 1.35, mix(clouds, grains, 0.45))), alpha);
}

// A splash of lime: how much of it is there.
float splash(Point p) {
  vec2 arm = p.at - 0.5;
  float from_center = length(arm);
  vec2 change = vec2(dot(arm, p.dx), dot(arm, p.dy)) / max(from_center, 1e-20);
  float radius = mix(0.08, 0.5, noise(p.at * 7.0, footprint(p) * 7.0, 9u));
  float disc = clamp((radius - from_center) / (0.08 + length(change)) + 0.5, 0.0, 1.0);
  return mix(disc, min(3.14159265 * radius * radius, 1.0), far(footprint(p)));
}

vec4 over(vec4 front, vec4 back) {
  float alpha = 1.0 - (1.0 - front.a) * (1.0 - back.a);
  return vec4(mix(back.rgb, front.rgb, front.a / max(alpha, 1e-20)), alpha);
}

void main() {
  // The brick: its cell, seed, and the place in it.
  vec2 dx = dFdx(uv), dy = dFdy(uv);
  vec2 p = uv * CELLS;
  int row = int(floor(p.y));
  uint row_bits = hash(uint(row) + hash(3u));
  p.x += 0.5 * float(row & 1) + 0.1 * random(row_bits - 1u);
  vec2 corner = floor(p);
  uint seed = hash(uint(int(corner.x)) + row_bits);
  Point local = Point(p - corner, dx * CELLS, dy * CELLS);

  // Its face.
  const vec2 shape = 1.0 / CELLS;
  const vec2 turned = vec2(shape.y / shape.x, -shape.x / shape.y);
  uint face_seed = hash(seed);
  vec2 turn = random2(face_seed, -2);
  float size = mix(0.97, 1.02, turn.x);
  Point q = element(local, vec2(0.5), radians(mix(-1.5, 1.5, turn.y)), 1.0 / size, vec2(1.0), turned);
  vec4 face = brick_face(q.at, footprint(q));
  vec3 luck3 = mix(vec3(0.5), random3(seed, 0), near(local));
  face.rgb *= mix(vec3(0.75, 0.8, 0.8), vec3(1.4, 1.05, 1.0), luck3) * clay;
  // From afar, the mean of size * size.
  face.a *= mix(coverage(q, vec2(1.0 / size), local), 0.99023324, far(footprint(local)));

  // Lime on every second brick, in the largest square of the face's frame.
  uint lime_seed = hash(face_seed + 1u);
  vec2 lime_turn = random2(lime_seed, -2);
  float lime_shrink = 1.0 / mix(0.3, 0.9, lime_turn.x);
  vec2 frame = size * shape;
  vec2 along = frame / min(frame.x, frame.y);
  Point m = element(q, mix(vec2(0.1, 0.2), vec2(0.9, 0.8), random2(lime_seed, -1)), radians(360.0) * lime_turn.y,
                    lime_shrink, along, vec2(along.y, -along.x));
  vec2 luck = random2(lime_seed, -3);
  float there = luck.y >= 0.5 ? 0.0 : mix(0.2, 0.8, luck.x) * coverage(m, along * lime_shrink, q);
  // Half of the bricks, half opaque, and the mean of the splashes' area.
  there = mix(there, 0.25 * min(0.39 / (along.x * along.y), 1.0), far(footprint(q)));
  float lime = splash(m) * there * face.a;

  float sand = noise(uv * 220.0, sqrt(dx * dx + dy * dy) * 220.0, 8u);
  vec4 bed = vec4(vec3(mix(0.22, 0.4, sand)), 1.0);
  out_color = over(over(vec4(0.62, 0.58, 0.52, lime), face), bed);
  out_height = face.a;
}
