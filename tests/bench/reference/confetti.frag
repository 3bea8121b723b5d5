#version 450 core
// SPDX-License-Identifier: Apache-2.0
// graphs/confetti as a careful person would write it: the same papers, colours and random bits.

layout(location = 0) in vec2 uv;

layout(location = 0) uniform vec4 ground;

layout(location = 0) out vec4 out_color;

uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
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

struct Cell {
  Point local;
  uint seed;
};

// The cell that is `which` columns and rows from that of the point, in a square grid whose rows are moved, every second one by
// half and all of them at random by up to `jitter`.
Cell grid(Point p, ivec2 which, float cells, float jitter, uint seed) {
  p.at *= cells;
  int row = int(floor(p.at.y)) + which.y;
  uint row_bits = hash(uint(row) + hash(seed));
  p.at.x += 0.5 * float(row & 1) + jitter * random(row_bits - 1u);
  vec2 corner = floor(p.at) + vec2(which);
  return Cell(Point(p.at - corner, p.dx * cells, p.dy * cells), hash(uint(int(corner.x)) + row_bits));
}

// How far what varies within a unit square has gone to its mean, where a pixel is about as large.
float far(vec2 pixel) { return clamp(2.0 * max(pixel.x, pixel.y) - 1.0, 0.0, 1.0); }

// The share of a pixel that a single tile has.
float near(Point local) {
  vec2 part = 1.0 + 0.25 * (local.dx * local.dx + local.dy * local.dy);
  return 1.0 / (part.x * part.y);
}

// A disc with a hole, antialiased; from afar, its area.
float ring(Point p) {
  vec2 arm = p.at - 0.5;
  float radius = length(arm);
  vec2 change = vec2(dot(arm, p.dx), dot(arm, p.dy)) / max(radius, 1e-20);
  float pixel = max(length(change), 1e-7);
  vec2 discs = clamp((vec2(0.45, 0.12) - radius) / pixel + 0.5, 0.0, 1.0);
  return mix(discs.x - discs.y, 3.14159265 * (0.45 * 0.45 - 0.12 * 0.12), far(footprint(p)));
}

// How much of the pixel the element covers.
float coverage(Point q, vec2 cell_in_q) {
  vec2 density = 1.0 / clamp(footprint(q), vec2(1e-5), cell_in_q);
  vec2 share = min((0.5 - abs(q.at - 0.5)) * density + 0.5, density);
  vec2 covered = clamp(share, 0.0, 1.0);
  return covered.x * covered.y;
}

// The paper of a cell: anywhere in it, turned, between `least` and `most` large.
vec4 paper(Cell cell, float least, float most, float opacity, vec3 low, vec3 high) {
  uint seed = hash(cell.seed);
  vec2 turn = random2(seed, -2);
  float angle = radians(360.0) * turn.y;
  float shrink = 1.0 / mix(least, most, turn.x);
  vec2 arm = cell.local.at - random2(seed, -1);
  vec2 c = vec2(cos(angle) * shrink), s = sin(angle) * shrink * vec2(1.0, -1.0);
  Point q = Point(c * arm + s * arm.yx + 0.5, c * cell.local.dx + s * cell.local.dx.yx,
                  c * cell.local.dy + s * cell.local.dy.yx);
  float alpha = coverage(q, vec2(shrink));
  if (alpha <= 0.0) return vec4(0.0);
  vec3 color = mix(low, high, mix(vec3(0.5), random3(cell.seed, 4), near(cell.local))) * mix(0.75, 1.0, clamp(q.at.y, 0.0, 1.0));
  alpha *= ring(q);
  if (opacity < 1.0) alpha *= mix(opacity, 1.0, random2(seed, -3).x);
  return vec4(color, alpha);
}

// The papers of a grid, later cells over earlier ones; they reach into the next cell, and no further.
vec4 sheet(Point p, float cells, float jitter, uint seed, float least, float most, float opacity, vec3 low, vec3 high) {
  vec4 seen = vec4(0.0);
  // Where a pixel holds whole cells, papers lie beside each other in it, not on each other.
  vec2 tiles = footprint(p) * cells;
  float on = clamp(2.0 - 2.0 * max(tiles.x, tiles.y), 0.0, 1.0);
  for (int y = 1; y >= -1; --y) {
    for (int x = 1; x >= -1; --x) {
      if (seen.a < 0.999) {
        vec4 next = paper(grid(p, ivec2(x, y), cells, jitter, seed), least, most, opacity, low, high);
        next.a *= 1.0 - seen.a * on;
        seen += vec4(next.rgb * next.a, next.a);
      }
    }
  }
  return vec4(seen.rgb / max(seen.a, 1e-20), min(seen.a, 1.0));
}

vec4 over(vec4 front, vec4 back) {
  float alpha = 1.0 - (1.0 - front.a) * (1.0 - back.a);
  return vec4(mix(back.rgb, front.rgb, front.a / max(alpha, 1e-20)), alpha);
}

void main() {
  Point p = Point(uv, dFdx(uv), dFdy(uv));
  vec4 lower = sheet(p, 20.0, 1.0, 3u, 0.4, 0.9, 0.4, vec3(0.25, 0.4, 0.02), vec3(0.75, 0.8, 0.15));
  vec4 middle = sheet(p, 14.0, 1.0, 2u, 0.5, 0.95, 0.4, vec3(0.02, 0.2, 0.35), vec3(0.2, 0.6, 0.9));
  vec4 upper = sheet(p, 9.0, 0.0, 1u, 0.6, 1.1, 1.0, vec3(0.5, 0.05, 0.02), vec3(1.0, 0.55, 0.2));
  out_color = over(upper, over(middle, over(lower, ground)));
}
