// SPDX-License-Identifier: Apache-2.0
// Where one looks, among the cells around the corner that is nearest to it.
struct Look2 {
  ivec2 corner;
  vec2 place;  // from the corner, -0.5 to 0.5
  vec2 start;  // the same, less the part of a cell that its point leaves free
  uint now;    // what is added to a cell's bits to have its place, now and at the next step
  uint next;
  float passed;  // which share of the way to the next place has been made
};

struct Look3 {
  ivec3 corner;
  vec3 place;
  uint now;
  uint next;
  float passed;
};

// The nearest point: how far it is, in the form that the metric compares; its cell as seen from the
// corner; that cell's bits. `second`: how far the second nearest is, with its cell and bits.
struct Near2 {
  float key;
  float second;
  ivec2 offset;
  uint bits;
  ivec2 second_offset;
  uint second_bits;
};

struct Near3 {
  float key;
  float second;
  ivec3 offset;
  uint bits;
  ivec3 second_offset;
  uint second_bits;
};

// Grows with the length of `arm` in a metric, and needs no root.
float key_of(vec2 arm, const int metric, const float exponent) {
  float key = dot(arm, arm);
  if (metric == METRIC_MANHATTAN) {
    key = abs(arm.x) + abs(arm.y);
  }
  if (metric == METRIC_CHEBYSHEV) {
    key = max(abs(arm.x), abs(arm.y));
  }
  if (metric == METRIC_MINKOWSKI) {
    vec2 powers = pow(abs(arm), vec2(exponent));
    key = powers.x + powers.y;
  }
  return key;
}

float key_of(vec3 arm, const int metric, const float exponent) {
  float key = dot(arm, arm);
  if (metric == METRIC_MANHATTAN) {
    key = abs(arm.x) + abs(arm.y) + abs(arm.z);
  }
  if (metric == METRIC_CHEBYSHEV) {
    key = max(max(abs(arm.x), abs(arm.y)), abs(arm.z));
  }
  if (metric == METRIC_MINKOWSKI) {
    vec3 powers = pow(abs(arm), vec3(exponent));
    key = powers.x + powers.y + powers.z;
  }
  return key;
}

float length_of(float key, const int metric, const float exponent) {
  float result = key;
  if (metric == METRIC_EUCLIDEAN) {
    result = sqrt(key);
  }
  if (metric == METRIC_MINKOWSKI) {
    result = pow(key, 1.0 / exponent);
  }
  return result;
}

// A cell in place of which `cell` stands, no more than four cells beyond the first or the last.
int repeated(int cell, const int period) {
  int result = cell;
  if (period > 0 && period < 4) {
    result = wrap_cell(cell, period);
  }
  if (period >= 4) {
    result += cell < 0 ? period : 0;
    result -= cell >= period ? period : 0;
  }
  return result;
}

// The bits of the point's steps. `phase` is the time in steps.
void steps_at(float phase, const int steps, out uint now, out uint next, out float passed) {
  float whole = floor(phase);
  float t = phase - whole;
  passed = t * t * (3.0 - 2.0 * t);
  int step_now = int(whole);
  int step_next = step_now + 1;
  if (steps > 0) {
    step_now = wrap_cell(step_now, steps);
    step_next = wrap_cell(step_next, steps);
  }
  now = hash(uint(step_now));
  next = hash(uint(step_next));
}

ivec2 cell_at(Look2 look, ivec2 offset, const ivec2 period) {
  ivec2 cell = look.corner + offset;
  return ivec2(repeated(cell.x, period.x), repeated(cell.y, period.y));
}

ivec3 cell_at(Look3 look, ivec3 offset, const ivec3 period) {
  ivec3 cell = look.corner + offset;
  return ivec3(repeated(cell.x, period.x), repeated(cell.y, period.y), repeated(cell.z, period.z));
}

vec2 point_in(Look2 look, uint bits, const bool moves) {
  vec2 point = random2(moves ? bits + look.now : bits, -1);
  if (moves) {
    point = mix(point, random2(bits + look.next, -1), look.passed);
  }
  return point;
}

vec3 point_in(Look3 look, uint bits, const bool moves) {
  vec3 point = random3(moves ? bits + look.now : bits, -1);
  if (moves) {
    point = mix(point, random3(bits + look.next, -1), look.passed);
  }
  return point;
}

// The point of a cell, from the corner. It has no slope.
vec2 point_of(Look2 look, ivec2 offset, const ivec2 period, int seed, float jitter,
              const bool moves, out uint bits) {
  bits = cell_hash(cell_at(look, offset, period), seed);
  return vec2(offset) + (0.5 - 0.5 * jitter) + jitter * point_in(look, bits, moves);
}

vec3 point_of(Look3 look, ivec3 offset, const ivec3 period, int seed, float jitter,
              const bool moves, out uint bits) {
  bits = cell_hash(cell_at(look, offset, period), seed);
  return vec3(offset) + (0.5 - 0.5 * jitter) + jitter * point_in(look, bits, moves);
}

void visit(Look2 look, ivec2 offset, const ivec2 period, int seed, float jitter, const bool moves,
           const int metric, const float exponent, inout Near2 near) {
  uint bits;
  vec2 point = point_of(look, offset, period, seed, jitter, moves, bits);
  float key = key_of(point - look.place, metric, exponent);
  if (max(near.key, key) < near.second) {
    near.second_offset = key < near.key ? near.offset : offset;
    near.second_bits = key < near.key ? near.bits : bits;
  }
  near.second = min(near.second, max(near.key, key));
  if (key < near.key) {
    near.key = key;
    near.offset = offset;
    near.bits = bits;
  }
}

void visit(Look3 look, ivec3 offset, const ivec3 period, int seed, float jitter, const bool moves,
           const int metric, const float exponent, inout Near3 near) {
  uint bits;
  vec3 point = point_of(look, offset, period, seed, jitter, moves, bits);
  float key = key_of(point - look.place, metric, exponent);
  if (max(near.key, key) < near.second) {
    near.second_offset = key < near.key ? near.offset : offset;
    near.second_bits = key < near.key ? near.bits : bits;
  }
  near.second = min(near.second, max(near.key, key));
  if (key < near.key) {
    near.key = key;
    near.offset = offset;
    near.bits = bits;
  }
}

// How far a cell's points are at least, component by component; a bit less, for rounding.
vec2 gap_to(Look2 look, ivec2 offset, float jitter) {
  return max(abs(vec2(offset) + 0.5 - look.place) - 0.5 * jitter - 0.00001, 0.0);
}

vec3 gap_to(Look3 look, ivec3 offset, float jitter) {
  return max(abs(vec3(offset) + 0.5 - look.place) - 0.5 * jitter - 0.00001, 0.0);
}

// Whether a cell lies within the 2 ring x 2 ring cells around the corner.
bool within(ivec2 offset, const int ring) {
  ivec2 twice = abs(2 * offset + 1);
  return ring > 0 && max(twice.x, twice.y) < 2 * ring;
}

bool within(ivec3 offset, const int ring) {
  ivec3 twice = abs(2 * offset + 1);
  return ring > 0 && max(max(twice.x, twice.y), twice.z) < 2 * ring;
}

// The 12 cells around the corner that can have the nearest point: a square of 4 x 4 without its
// corners. Without `exact`, the four at the corner.
Near2 nearest(Look2 look, const ivec2 period, int seed, float jitter, const bool moves,
              const int metric, const float exponent, const bool exact) {
  const int WIDE = exact ? 2 : 1;
  Near2 near;
  near.key = 1e9;
  near.second = 1e9;
  for (int y = -1; y <= 0; ++y) {
    for (int x = -WIDE; x < WIDE; ++x) {
      visit(look, ivec2(x, y), period, seed, jitter, moves, metric, exponent, near);
    }
  }
  if (exact) {
    for (int y = -2; y <= 1; y += 3) {
      for (int x = -1; x <= 0; ++x) {
        visit(look, ivec2(x, y), period, seed, jitter, moves, metric, exponent, near);
      }
    }
  }
  return near;
}

// The three other cells that can have the second nearest, all on the side of the point's own cell.
Near2 second_nearest(Look2 look, Near2 near, const ivec2 period, int seed, float jitter,
                     const bool moves, const int metric, const float exponent) {
  ivec2 own = ivec2(look.place.x < 0.0 ? -1 : 0, look.place.y < 0.0 ? -1 : 0);
  ivec2 out_by_1 = ivec2(look.place.x < 0.0 ? -2 : 1, look.place.y < 0.0 ? -2 : 1);
  ivec2 out_by_2 = ivec2(look.place.x < 0.0 ? -3 : 2, look.place.y < 0.0 ? -3 : 2);
  Near2 further = near;
  visit(look, out_by_1, period, seed, jitter, moves, metric, exponent, further);
  visit(look, ivec2(out_by_2.x, own.y), period, seed, jitter, moves, metric, exponent, further);
  visit(look, ivec2(own.x, out_by_2.y), period, seed, jitter, moves, metric, exponent, further);
  return further;
}

// Looks at the cells of one ring around the corner, as far as they can have a nearer point.
void look_around(Look3 look, const int ring, const ivec3 period, int seed, float jitter,
                 const bool moves, const int metric, const float exponent, inout Near3 near) {
  for (int z = -ring - 1; z <= ring; ++z) {
    for (int y = -ring - 1; y <= ring; ++y) {
      vec3 row = gap_to(look, ivec3(0, y, z), jitter);
      if (key_of(vec3(0.0, row.yz), metric, exponent) < near.key) {
        for (int x = -ring - 1; x <= ring; ++x) {
          ivec3 offset = ivec3(x, y, z);
          vec3 gap = gap_to(look, offset, jitter);
          if (!within(offset, ring) && key_of(gap, metric, exponent) < near.key) {
            visit(look, offset, period, seed, jitter, moves, metric, exponent, near);
          }
        }
      }
    }
  }
}

Near3 nearest(Look3 look, const ivec3 period, int seed, float jitter, const bool moves,
              const int metric, const float exponent, const bool exact) {
  Near3 near;
  near.key = 1e9;
  near.second = 1e9;
  for (int z = -1; z <= 0; ++z) {
    for (int y = -1; y <= 0; ++y) {
      for (int x = -1; x <= 0; ++x) {
        visit(look, ivec3(x, y, z), period, seed, jitter, moves, metric, exponent, near);
      }
    }
  }
  if (exact) {
    look_around(look, 1, period, seed, jitter, moves, metric, exponent, near);
    // Only where a diagonal is longer than twice a side.
    if (metric == METRIC_MANHATTAN || (metric == METRIC_MINKOWSKI && exponent < 2.0)) {
      if (near.key > key_of(vec3(1.5, 0.0, 0.0), metric, exponent)) {
        look_around(look, 2, period, seed, jitter, moves, metric, exponent, near);
      }
    }
  }
  return near;
}

// As look_around, for the second nearest. The nearest is known.
void second_around(Look3 look, const int ring, const ivec3 period, int seed, float jitter,
                   const bool moves, const int metric, const float exponent, inout Near3 near) {
  for (int z = -ring - 1; z <= ring; ++z) {
    for (int y = -ring - 1; y <= ring; ++y) {
      vec3 row = gap_to(look, ivec3(0, y, z), jitter);
      if (key_of(vec3(0.0, row.yz), metric, exponent) < near.second) {
        for (int x = -ring - 1; x <= ring; ++x) {
          ivec3 offset = ivec3(x, y, z);
          vec3 gap = gap_to(look, offset, jitter);
          if (!within(offset, ring) && offset != near.offset &&
              key_of(gap, metric, exponent) < near.second) {
            uint bits;
            vec3 point = point_of(look, offset, period, seed, jitter, moves, bits);
            float key = key_of(point - look.place, metric, exponent);
            if (key < near.second) {
              near.second = key;
              near.second_offset = offset;
              near.second_bits = bits;
            }
          }
        }
      }
    }
  }
}

Near3 second_nearest(Look3 look, Near3 near, const ivec3 period, int seed, float jitter,
                     const bool moves, const int metric, const float exponent) {
  Near3 further = near;
  second_around(look, 1, period, seed, jitter, moves, metric, exponent, further);
  if (further.second > key_of(vec3(1.5, 0.0, 0.0), metric, exponent)) {
    second_around(look, 2, period, seed, jitter, moves, metric, exponent, further);
  }
  return further;
}

// The nearest border that is known: how far it is, and the point on its other side.
struct Edge2 {
  float border;
  vec2 other;
};

struct Edge3 {
  float border;
  vec3 other;
};

// How far the line is that runs half way between two points.
float half_way(Look2 look, vec2 point, vec2 other) {
  vec2 across = other - point;
  return dot(0.5 * (point + other) - look.place,
             across * inversesqrt(max(dot(across, across), 1e-12)));
}

float half_way(Look3 look, vec3 point, vec3 other) {
  vec3 across = other - point;
  return dot(0.5 * (point + other) - look.place,
             across * inversesqrt(max(dot(across, across), 1e-12)));
}

// Looks for a nearer border among the cells of one ring around the corner. A point that is further
// away than the nearest, plus twice the border, has none.
void border_around(Look2 look, Near2 near, vec2 point, const int ring, const ivec2 period, int seed,
                   float jitter, const bool moves, inout Edge2 edge) {
  float first = distance(point, look.place);
  for (int y = -ring - 1; y <= ring; ++y) {
    for (int x = -ring - 1; x <= ring; ++x) {
      ivec2 offset = ivec2(x, y);
      vec2 gap = gap_to(look, offset, jitter);
      float reach = first + 2.0 * edge.border;
      if (!within(offset, ring) && offset != near.offset && dot(gap, gap) < reach * reach) {
        uint bits;
        vec2 other = point_of(look, offset, period, seed, jitter, moves, bits);
        float border = half_way(look, point, other);
        if (border < edge.border) {
          edge.border = border;
          edge.other = other;
        }
      }
    }
  }
}

void border_around(Look3 look, Near3 near, vec3 point, const int ring, const ivec3 period, int seed,
                   float jitter, const bool moves, inout Edge3 edge) {
  float first = distance(point, look.place);
  for (int z = -ring - 1; z <= ring; ++z) {
    for (int y = -ring - 1; y <= ring; ++y) {
      for (int x = -ring - 1; x <= ring; ++x) {
        ivec3 offset = ivec3(x, y, z);
        vec3 gap = gap_to(look, offset, jitter);
        float reach = first + 2.0 * edge.border;
        if (!within(offset, ring) && offset != near.offset && dot(gap, gap) < reach * reach) {
          uint bits;
          vec3 other = point_of(look, offset, period, seed, jitter, moves, bits);
          float border = half_way(look, point, other);
          if (border < edge.border) {
            edge.border = border;
            edge.other = other;
          }
        }
      }
    }
  }
}

float border_of(Look2 look, Near2 near, vec2 point, const ivec2 period, int seed, float jitter,
                const bool moves, const bool exact) {
  Edge2 edge = Edge2(1e3, vec2(0.0));
  border_around(look, near, point, 0, period, seed, jitter, moves, edge);
  border_around(look, near, point, 1, period, seed, jitter, moves, edge);
  if (exact && distance(point, look.place) + 2.0 * edge.border > 1.5) {
    border_around(look, near, point, 2, period, seed, jitter, moves, edge);
  }
  return max(half_way(look, point, edge.other), 0.0);
}

float border_of(Look3 look, Near3 near, vec3 point, const ivec3 period, int seed, float jitter,
                const bool moves, const bool exact) {
  Edge3 edge = Edge3(1e3, vec3(0.0));
  border_around(look, near, point, 0, period, seed, jitter, moves, edge);
  border_around(look, near, point, 1, period, seed, jitter, moves, edge);
  if (exact) {
    float first = distance(point, look.place);
    if (first + 2.0 * edge.border > 1.5) {
      border_around(look, near, point, 2, period, seed, jitter, moves, edge);
    }
    if (first + 2.0 * edge.border > 2.5) {
      border_around(look, near, point, 3, period, seed, jitter, moves, edge);
    }
  }
  return max(half_way(look, point, edge.other), 0.0);
}

/// Cells around scattered points: each place belongs to the point that is nearest to it.
/// There is one point in each cell of a grid, at random within it. Distances are measured in cells
/// of that grid. `exact` finds the nearest point always, in 12 cells of the plane or at most 56 of
/// space. Without it only 4 and 8 are looked at: with a jitter of 1, 0.9 % of places of the plane
/// and 1.9 % of space then get a point that is not the nearest, with steps in `f1` there, and 13 %
/// and 12 % a wrong `f2`.
/// Where a cell is no larger than a pixel, `f1` and `f2` have faded to their means; this begins
/// where a cell is two pixels large. `border` is not faded: `joint`, which filters it, needs its
/// slope.
/// @source Worley, A Cellular Texture Basis Function, SIGGRAPH 1996; Glanville, GPU Gems, chapter
///   20, section 20.3.5; the border: Quilez, Voronoi Borders, 2012; which cells: the library's note
///   0021
/// @param uv coordinate @default uv
/// @param scale cells for each unit of the coordinate @default vec2(8)
/// @param metric how distances are measured: euclidean; manhattan, the sum of the components;
///   chebyshev, the greatest of them; minkowski, between these @default METRIC_EUCLIDEAN
/// @param exponent of the metric minkowski: 1 is manhattan, 2 euclidean @default 3 @range 1 16
/// @param jitter how far points lie from the middle of their grid cell: 0, not at all; 1, anywhere
///   in it @default 1 @range 0 1
/// @param exact whether the nearest point is found always @default true
/// @param period after how many grid cells the pattern repeats in each direction; 0 never
///   @default ivec2(0) @range 0 1048576
/// @param seed another seed gives another pattern @default 0
/// @param time when @default time @unit seconds
/// @param interval how long a point takes from one random place to the next, in a smooth movement
///   at 1.5 / interval cells a second at most; 0: points stand still @default 0 @range 0 86400
///   @unit seconds
/// @param steps after how many intervals the movement repeats; 0 never @default 0 @range 0 1048576
/// @param f1 distance to the nearest point, in grid cells
/// @param f2 distance to the second nearest point
/// @param difference f2 - f1: 0 on the borders of cells
/// @param border distance to the border of the cell, in grid cells; exact for the euclidean metric
///   alone. For the others half of f2 - f1, which is not above the distance as they measure it;
///   lines along it are not as wide everywhere
/// @param spacing how far borders are from each other in the mean, in grid cells, for `joint`: 1,
///   within 3 % for each jitter
/// @param center the nearest point, in the coordinate's space
/// @param tile the cell. Its frame is as large as a grid cell, with the point in its middle
/// @param neighbor the cell of the second nearest point, as seen from here
/// @param share how much of the pixel the neighbour has: 0.5 on the border, 0 from half a pixel on;
///   exact where the border is straight. `blend_tiles` mixes both cells by it
void voronoi(vec2 uv, vec2 scale, const int metric, const float exponent, float jitter,
             const bool exact, const ivec2 period, int seed, float time, const float interval,
             const int steps, out float f1, out float f2, out float difference, out float border,
             out float spacing, out vec2 center, out Tile tile, out Tile neighbor,
             out float share) {
  const bool MOVES = interval > 0.0;
  vec2 p = uv * scale;
  vec2 corner = floor(p + 0.5);
  Look2 look;
  look.corner = ivec2(corner);
  if (period.x > 0) {
    look.corner.x = wrap_cell(look.corner.x, period.x);
  }
  if (period.y > 0) {
    look.corner.y = wrap_cell(look.corner.y, period.y);
  }
  look.place = p - corner;
  if (MOVES) {
    steps_at(time / interval, steps, look.now, look.next, look.passed);
  }
  Near2 near = nearest(look, period, seed, jitter, MOVES, metric, exponent, exact);
  vec2 point = vec2(near.offset) + (0.5 - 0.5 * jitter) + jitter * point_in(look, near.bits, MOVES);
  Near2 both = near;
  if (exact) {
    both = second_nearest(look, near, period, seed, jitter, MOVES, metric, exponent);
  }
  float near_1 = length_of(near.key, metric, exponent);
  float near_2 = length_of(both.second, metric, exponent);

  vec2 width = footprint(uv) * abs(scale);
  float blur = clamp(2.0 * max(width.x, width.y) - 1.0, 0.0, 1.0);
  vec2 means = voronoi_means(2, metric, exponent, jitter);
  f1 = mix(near_1, means.x, blur);
  f2 = mix(near_2, means.y, blur);
  difference = f2 - f1;
  border = 0.5 * (near_2 - near_1);
  if (metric == METRIC_EUCLIDEAN) {
    border = border_of(look, near, point, period, seed, jitter, MOVES, exact);
  }
  spacing = 1.0;
  vec2 size = 1.0 / max(abs(scale), vec2(1e-20));

  center = (corner + point) * sign(scale) * size;
  tile.cell = cell_at(look, near.offset, period);
  tile.local = 0.5 + (look.place - point) * sign(scale);
  tile.size = size;
  tile.seed = near.bits;
  tile.right = vec2(1.0, 0.0);
  tile.up = vec2(0.0, 1.0);
  tile.largest = size;
  tile.tilt = vec2(1.0, 0.0);

  vec2 next = vec2(both.second_offset) + (0.5 - 0.5 * jitter) +
              jitter * point_in(look, both.second_bits, MOVES);
  neighbor = tile;
  neighbor.cell = cell_at(look, both.second_offset, period);
  neighbor.local = 0.5 + (look.place - next) * sign(scale);
  neighbor.seed = both.second_bits;
  float edge = near_2 - near_1;
  if (metric == METRIC_EUCLIDEAN) {
    edge = half_way(look, point, next);
  }
  share = clamp(0.5 - max(edge, 0.0) / max(footprint(edge), 1e-7), 0.0, 0.5);
}

/// @param uv coordinate @default position
/// @param scale cells for each unit of the coordinate @default vec3(8)
/// @param metric how distances are measured @default METRIC_EUCLIDEAN
/// @param exponent of the metric minkowski @default 3 @range 1 16
/// @param jitter how far points lie from the middle of their grid cell @default 1 @range 0 1
/// @param exact whether the nearest point is found always @default true
/// @param period after how many grid cells the pattern repeats in each direction; 0 never
///   @default ivec3(0) @range 0 1048576
/// @param seed another seed gives another pattern @default 0
/// @param time when @default time @unit seconds
/// @param interval how long a point takes from one random place to the next; 0: points stand still
///   @default 0 @range 0 86400 @unit seconds
/// @param steps after how many intervals the movement repeats; 0 never @default 0 @range 0 1048576
/// @param f1 distance to the nearest point, in grid cells
/// @param f2 distance to the second nearest point
/// @param difference f2 - f1: 0 on the borders of cells
/// @param border distance to the border of the cell, in grid cells; exact for the euclidean metric
///   alone
/// @param spacing how far borders are from each other in the mean, in grid cells, for `joint`:
///   0.69, within 3 % for each jitter
/// @param center the nearest point, in the coordinate's space
/// @param tile the cell
/// @param neighbor the cell of the second nearest point
/// @param share how much of the pixel the neighbour has
void voronoi(vec3 uv, vec3 scale, const int metric, const float exponent, float jitter,
             const bool exact, const ivec3 period, int seed, float time, const float interval,
             const int steps, out float f1, out float f2, out float difference, out float border,
             out float spacing, out vec3 center, out Tile3 tile, out Tile3 neighbor,
             out float share) {
  const bool MOVES = interval > 0.0;
  vec3 p = uv * scale;
  vec3 corner = floor(p + 0.5);
  Look3 look;
  look.corner = ivec3(corner);
  if (period.x > 0) {
    look.corner.x = wrap_cell(look.corner.x, period.x);
  }
  if (period.y > 0) {
    look.corner.y = wrap_cell(look.corner.y, period.y);
  }
  if (period.z > 0) {
    look.corner.z = wrap_cell(look.corner.z, period.z);
  }
  look.place = p - corner;
  if (MOVES) {
    steps_at(time / interval, steps, look.now, look.next, look.passed);
  }
  Near3 near = nearest(look, period, seed, jitter, MOVES, metric, exponent, exact);
  vec3 point = vec3(near.offset) + (0.5 - 0.5 * jitter) + jitter * point_in(look, near.bits, MOVES);
  Near3 both = near;
  if (exact) {
    both = second_nearest(look, near, period, seed, jitter, MOVES, metric, exponent);
  }
  float near_1 = length_of(near.key, metric, exponent);
  float near_2 = length_of(both.second, metric, exponent);

  vec3 width = footprint(uv) * abs(scale);
  float blur = clamp(2.0 * max(max(width.x, width.y), width.z) - 1.0, 0.0, 1.0);
  vec2 means = voronoi_means(3, metric, exponent, jitter);
  f1 = mix(near_1, means.x, blur);
  f2 = mix(near_2, means.y, blur);
  difference = f2 - f1;
  border = 0.5 * (near_2 - near_1);
  if (metric == METRIC_EUCLIDEAN) {
    border = border_of(look, near, point, period, seed, jitter, MOVES, exact);
  }
  spacing = 0.69;
  vec3 size = 1.0 / max(abs(scale), vec3(1e-20));

  center = (corner + point) * sign(scale) * size;
  tile.cell = cell_at(look, near.offset, period);
  tile.local = 0.5 + (look.place - point) * sign(scale);
  tile.size = size;
  tile.seed = near.bits;
  tile.right = vec3(1.0, 0.0, 0.0);
  tile.up = vec3(0.0, 1.0, 0.0);
  tile.toward = vec3(0.0, 0.0, 1.0);

  vec3 next = vec3(both.second_offset) + (0.5 - 0.5 * jitter) +
              jitter * point_in(look, both.second_bits, MOVES);
  neighbor = tile;
  neighbor.cell = cell_at(look, both.second_offset, period);
  neighbor.local = 0.5 + (look.place - next) * sign(scale);
  neighbor.seed = both.second_bits;
  float edge = near_2 - near_1;
  if (metric == METRIC_EUCLIDEAN) {
    edge = half_way(look, point, next);
  }
  share = clamp(0.5 - max(edge, 0.0) / max(footprint(edge), 1e-7), 0.0, 0.5);
}
