// SPDX-License-Identifier: Apache-2.0
// A sum of exp2(-length / smoothness), divided by the largest of its terms so that none is too
// small for a float.
struct Sum {
  float least;
  float terms;
};

// Beyond 1.5 cells a point does not count, so that the 4 x 4 cells around the nearest corner are
// all that can; up to there its part goes to nothing without a kink.
void add_point(float square, float smoothness, inout Sum sum) {
  float rest = max(1.0 - square / 2.25, 0.0);
  float difference = sqrt(square) - sum.least;
  float shrink = exp2(-abs(difference) / smoothness);
  bool nearer = difference < 0.0;
  sum.terms = nearer ? sum.terms * shrink + rest * rest : sum.terms + rest * rest * shrink;
  sum.least = min(sum.least, sum.least + difference);
}

// The bits of the points' steps; how far they have come from one to the next.
struct Steps {
  uint now;
  uint next;
  float passed;
};

Steps steps_at(float phase, const int steps) {
  float whole = floor(phase);
  float t = phase - whole;
  int now = int(whole);
  int next = now + 1;
  if (steps > 0) {
    now = wrap_cell(now, steps);
    next = wrap_cell(next, steps);
  }
  return Steps(hash(uint(now)), hash(uint(next)), t * t * (3.0 - 2.0 * t));
}

vec2 point_in2(uint bits, Steps steps, const bool moves) {
  vec2 point = random2(moves ? bits + steps.now : bits, -1);
  if (moves) {
    point = mix(point, random2(bits + steps.next, -1), steps.passed);
  }
  return point;
}

vec3 point_in3(uint bits, Steps steps, const bool moves) {
  vec3 point = random3(moves ? bits + steps.now : bits, -1);
  if (moves) {
    point = mix(point, random3(bits + steps.next, -1), steps.passed);
  }
  return point;
}

float value_of(Sum sum, float smoothness) {
  return max(sum.least - smoothness * log2(max(sum.terms, 1e-20)), 0.0);
}

/// The distance to the nearest of scattered points, without creases between the cells: hills that
/// flow into each other.
/// It is -s log2(sum of w(d) 2^(-d / s)) over the distances d to the points around, not below 0,
/// with the smoothness s and w(d) = (1 - (d / 1.5)^2)^2. The smaller s, the nearer to f1 of
/// `voronoi`, whose points are the same, also while they move. Where a cell is no larger than a
/// pixel, it has faded to its mean; this begins where a cell is two pixels large.
/// @source Quilez, Smooth Voronoi, 2014; the window w is the library's, so that nothing jumps at
///   the border of a grid cell
/// @param uv coordinate @default uv
/// @param scale cells for each unit of the coordinate @default vec2(8)
/// @param smoothness by how much points count that are further away: one that is so many cells
///   further has half the weight @default 0.1 @range 0.001 0.4
/// @param jitter how far points lie from the middle of their grid cell: 0, not at all; 1, anywhere
///   in it @default 1 @range 0 1
/// @param period after how many grid cells the pattern repeats in each direction; 0 never
///   @default ivec2(0) @range 0 1048576
/// @param seed another seed gives another pattern @default 0
/// @param time when @default time @unit seconds
/// @param interval how long a point takes from one random place to the next, in the same movement
///   as that of `voronoi`; 0: points stand still @default 0 @range 0 86400 @unit seconds
/// @param steps after how many intervals the movement repeats; 0 never @default 0 @range 0 1048576
/// @return in grid cells
float smooth_voronoi(vec2 uv, vec2 scale, float smoothness, float jitter, const ivec2 period,
                     int seed, float time, const float interval, const int steps) {
  const bool MOVES = interval > 0.0;
  Steps moved;
  if (MOVES) {
    moved = steps_at(time / interval, steps);
  }
  vec2 p = uv * scale;
  vec2 corner = floor(p + 0.5);
  vec2 start = p - corner - (0.5 - 0.5 * jitter);
  Sum sum = Sum(4.0, 0.0);
  for (int y = -2; y <= 1; ++y) {
    for (int x = -2; x <= 1; ++x) {
      ivec2 cell = ivec2(corner) + ivec2(x, y);
      cell.x = period.x > 0 ? wrap_cell(cell.x, max(period.x, 1)) : cell.x;
      cell.y = period.y > 0 ? wrap_cell(cell.y, max(period.y, 1)) : cell.y;
      vec2 arm = vec2(x, y) - start + jitter * point_in2(cell_hash(cell, seed), moved, MOVES);
      add_point(dot(arm, arm), smoothness, sum);
    }
  }
  vec2 width = footprint(uv) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  return mix(value_of(sum, smoothness), smooth_voronoi_mean(2, smoothness, jitter), blur);
}

/// @param uv coordinate @default position
/// @param scale cells for each unit of the coordinate @default vec3(8)
/// @param smoothness by how much points count that are further away @default 0.1 @range 0.001 0.4
/// @param jitter how far points lie from the middle of their grid cell @default 1 @range 0 1
/// @param period after how many grid cells the pattern repeats in each direction; 0 never
///   @default ivec3(0) @range 0 1048576
/// @param seed another seed gives another pattern @default 0
/// @param time when @default time @unit seconds
/// @param interval how long a point takes from one random place to the next, in the same movement
///   as that of `voronoi`; 0: points stand still @default 0 @range 0 86400 @unit seconds
/// @param steps after how many intervals the movement repeats; 0 never @default 0 @range 0 1048576
float smooth_voronoi(vec3 uv, vec3 scale, float smoothness, float jitter, const ivec3 period,
                     int seed, float time, const float interval, const int steps) {
  const bool MOVES = interval > 0.0;
  Steps moved;
  if (MOVES) {
    moved = steps_at(time / interval, steps);
  }
  vec3 p = uv * scale;
  vec3 corner = floor(p + 0.5);
  vec3 start = p - corner - (0.5 - 0.5 * jitter);
  Sum sum = Sum(4.0, 0.0);
  for (int z = -2; z <= 1; ++z) {
    for (int y = -2; y <= 1; ++y) {
      for (int x = -2; x <= 1; ++x) {
        ivec3 cell = ivec3(corner) + ivec3(x, y, z);
        cell.x = period.x > 0 ? wrap_cell(cell.x, max(period.x, 1)) : cell.x;
        cell.y = period.y > 0 ? wrap_cell(cell.y, max(period.y, 1)) : cell.y;
        cell.z = period.z > 0 ? wrap_cell(cell.z, max(period.z, 1)) : cell.z;
        vec3 arm = vec3(x, y, z) - start + jitter * point_in3(cell_hash(cell, seed), moved, MOVES);
        add_point(dot(arm, arm), smoothness, sum);
      }
    }
  }
  vec3 width = footprint(uv) * abs(scale);
  float blur = clamp(2.0 * max(max(width.x, width.y), width.z) - 1.0, 0.0, 1.0);
  return mix(value_of(sum, smoothness), smooth_voronoi_mean(3, smoothness, jitter), blur);
}
