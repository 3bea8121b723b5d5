// SPDX-License-Identifier: Apache-2.0
const int SHAPE_CUBE = 0;
const int SHAPE_BALL = 1;

const int MEET_RANDOM = 0;
const int MEET_KEY = 1;
const int MEET_NEAREST = 2;
const int MEET_ROWS = 3;
const int MEET_SUM = 4;
const int MEET_MAX = 5;
// So many copies are composited at a point at most.
const int MOST_LAYERS = 100;

// One copy, as seen from a point; lengths in cells.
struct Copy {
  ivec3 cell;
  int index;    // in its cell
  uint seed;
  uint luck;    // random bits that the seed does not tell
  float large;  // its size between the least, 0, and the greatest
  vec4 turn;    // a quaternion of length 1, the real part last
  vec3 from;    // from its centre to the point
};

// What is seen of the copies at a point.
struct View {
  vec3 light;     // of all copies together
  float through;  // what shows through them
  float most;     // how much is seen of `top`
  Copy top;       // the one of which most is seen
};

// From the middle of its cell to the centre of a copy. Positions at whole numbers of `phase` are
// drawn anew; each copy has its own beginning, so that they do not all halt at once.
vec3 offset_of(uvec3 place, uint bits, vec3 jitter, const bool wander, float phase,
               const int loop) {
  if (!wander) {
    return vec3(ivec3(place)) * (jitter * 2.3283064365386963e-10);
  }
  float time = phase + random(bits, -4);
  float begun = floor(time);
  int from = int(begun);
  int to = from + 1;
  if (loop > 0) {
    from = wrap_cell(from, loop);
    to = wrap_cell(to, loop);
  }
  uint path = hash(bits);
  float t = time - begun;
  vec3 way = mix(random3(path, from), random3(path, to), t * t * (3.0 - 2.0 * t));
  return (way - 0.5) * jitter;
}

// A copy, but for its turn.
Copy copy_at(vec3 p, vec3 node, int index, const ivec3 period, int seed, vec3 jitter,
             const bool wander, float phase, const int loop) {
  Copy copy;
  copy.cell = ivec3(node);
  if (period.x > 0) {
    copy.cell.x = wrap_cell(copy.cell.x, period.x);
  }
  if (period.y > 0) {
    copy.cell.y = wrap_cell(copy.cell.y, period.y);
  }
  if (period.z > 0) {
    copy.cell.z = wrap_cell(copy.cell.z, period.z);
  }
  copy.index = index;
  uvec3 place;
  uint luck;
  uint bits;
  copy_bits3(copy.cell, index, seed, place, luck, bits);
  copy.seed = bits;
  copy.luck = luck;
  copy.large = random(bits, -2);
  copy.from = p - node - offset_of(place, bits, jitter, wander, phase, loop);
  return copy;
}

bool is_turned(vec2 rotation, const bool tumble) {
  return tumble || rotation.x != 0.0 || rotation.y != 0.0;
}

// Any rotation, each as probable as each other: Shoemake, Uniform Random Rotations, Graphics Gems
// III, 1992. Or one about an axis, `share` of the way between the least and the greatest angle.
vec4 turned_by(uint seed, float share, vec2 rotation, vec3 axis, const bool tumble) {
  if (tumble) {
    vec3 luck = random3(seed, -5);
    vec2 angle = 6.283185307179586 * luck.yz;
    float a = sqrt(1.0 - luck.x);
    float b = sqrt(luck.x);
    return vec4(a * sin(angle.x), a * cos(angle.x), b * sin(angle.y), b * cos(angle.y));
  }
  float angle = 0.5 * radians(mix(rotation.x, rotation.y, share));
  return vec4(normalized(axis) * sin(angle), cos(angle));
}

// Sizes that only the shader knows may be too small.
float side_of(Copy copy, vec2 size) { return max(mix(size.x, size.y, copy.large), 0.000001); }

// From a copy's frame to the cells'.
vec3 turned(vec3 arm, Copy copy, vec2 rotation, const bool tumble) {
  if (!is_turned(rotation, tumble)) {
    return arm;
  }
  vec3 axis = copy.turn.xyz;
  return arm + 2.0 * cross(axis, cross(axis, arm) + copy.turn.w * arm);
}

// From the middle of a copy to the point, in the copy's frame.
vec3 arm_of(Copy copy, vec2 size, vec2 rotation, const bool tumble) {
  vec3 arm = copy.from / side_of(copy, size);
  if (!is_turned(rotation, tumble)) {
    return arm;
  }
  vec3 axis = copy.turn.xyz;
  return arm + 2.0 * cross(axis, cross(axis, arm) - copy.turn.w * arm);
}

// Whether the point may be in a copy; if that is no turned cube, it is.
bool is_near(Copy copy, vec2 size, vec2 rotation, const bool tumble, const int shape) {
  float side = side_of(copy, size);
  float square = dot(copy.from, copy.from);
  if (shape == SHAPE_BALL) {
    return square < 0.25 * side * side;
  }
  if (is_turned(rotation, tumble)) {
    return square < 0.75 * side * side;
  }
  vec3 away = abs(copy.from);
  return max(max(away.x, away.y), away.z) < 0.5 * side;
}

// Whether the point is in a copy that is near.
bool holds(Copy copy, vec2 size, vec2 rotation, const bool tumble, const int shape) {
  if (shape == SHAPE_BALL || !is_turned(rotation, tumble)) {
    return true;
  }
  vec3 away = abs(arm_of(copy, size, rotation, tumble));
  return max(max(away.x, away.y), away.z) < 0.5;
}

// The frame of a copy, as a tile.
Tile3 frame_of(Copy copy, vec3 scale, vec2 size, vec2 rotation, const bool tumble) {
  vec3 right = turned(vec3(1.0, 0.0, 0.0), copy, rotation, tumble) / scale;
  vec3 up = turned(vec3(0.0, 1.0, 0.0), copy, rotation, tumble) / scale;
  vec3 toward = turned(vec3(0.0, 0.0, 1.0), copy, rotation, tumble) / scale;
  Tile3 tile;
  tile.cell = copy.cell;
  tile.local = arm_of(copy, size, rotation, tumble) + 0.5;
  tile.size = side_of(copy, size) * vec3(length(right), length(up), length(toward));
  tile.seed = copy.seed;
  tile.right = normalize(right);
  tile.up = normalize(up);
  tile.toward = normalize(toward);
  return tile;
}

// The direction in which the point leaves the shape of a copy, in the coordinate's space.
vec3 normal_of(Copy copy, vec3 scale, vec2 size, vec2 rotation, const bool tumble,
               const int shape) {
  vec3 out_of = copy.from;
  if (shape == SHAPE_CUBE) {
    vec3 arm = arm_of(copy, size, rotation, tumble);
    vec3 away = abs(arm);
    float most = max(max(away.x, away.y), away.z);
    out_of = turned(sign(arm) * vec3(equal(away, vec3(most))), copy, rotation, tumble);
  }
  vec3 slope = out_of * scale;
  return slope * inversesqrt(max(dot(slope, slope), 1e-20));
}

/// Scatters copies of a body through space, each at a random place, turned and sized at random, and
/// shows where a surface cuts them: the stones in terrazzo, bubbles in amber, the grains of
/// granite. It is `bomb` in space. Space is divided into cells of `scale`, each with `copies` of
/// the body. No copy is clipped: the compiler finds out how far copies can reach, and looks at the
/// cells that can and no more; see `cells`. Lengths and angles are those of the cells, which are
/// cubes if `scale` is the same along all axes. The copies at a point are composited from the
/// topmost down, until nothing shows through; so edges are smooth, and mostly one image is looked
/// up. Copies with the same key, or equally near, lie on each other in the order of their cells:
/// the later slice is on top, in a slice the later row, in a row the later column. Of copies with
/// the same random rank, one pair in 2^32, the earlier is left out. Of copies that light goes
/// through at most 100 are composited at a point, and fewer where drivers would end the loop: 81 of
/// 800 in the cells that are looked at.
/// @source Glanville, Texture Bombing, GPU Gems, chapter 20, section 20.3.3
/// @param image what is scattered: the colour at a place of the body, from (0, 0, 0) to (1, 1, 1);
///   straight alpha. A function of the graph may take `tile` as well, the copy's frame: its random
///   bits are the copy's own, so that no two copies need be alike
/// @param coverage how much of the copy is there, another factor of its alpha. Where it is 0 the
///   image is not asked for @default 1
/// @param density the share of the copies that are there, at a place in space: a number or a
///   function. It is asked for at the centre of each copy @default 1
/// @param size_at where a copy's size is between the least, 0, and the greatest, 1, at a place in
///   space, asked for at the centre of each copy; below 0 it is left to chance @default -1
/// @param rotation_at the same of its angle about `axis` @default -1
/// @param key for `meet` by key: the copy with the greater number is in front of the other
///   @default 0
/// @param tint what a copy's colour is multiplied by @default vec3(1)
/// @param uv coordinate @default position
/// @param scale cells for each unit of the coordinate @default vec3(8)
/// @param copies how many a cell has @default 1 @range 1 32
/// @param jitter how far from the middles of their cells the centres of copies are drawn, as the
///   sides of that part, in cells: 0, not at all; 1, anywhere in the cell @default vec3(1)
///   @range 0 4
/// @param spacing how near the centres of two copies may be, in cells; 0, any. Of copies that are
///   nearer only one stays: a copy is left out if another of a higher rank is within this distance.
///   Take several `copies`, of which most are left out: of n in each cell about
///   (1 - exp(-n a)) / a stay, where a = 4/3 pi spacing^3. Copies that wander go while they are too
///   near @default 0 @range 0 1
/// @param rivals how many cells across, up and away have copies that can be nearer than `spacing`
///   to one. Without a value they are as many as jitter and spacing need @default ivec3(2)
///   @range 0 3 @computed bomb3_rivals less spacing, or less jitter, needs fewer
/// @param size least and greatest side of a copy, in cells @default vec2(1) @ordered
///   @range 0.001 64
/// @param rotation least and greatest angle about `axis`, counter-clockwise as seen from its end
///   @default vec2(0) @unit degrees @ordered
/// @param axis what copies turn about, of any length above 0 @default vec3(0, 0, 1)
/// @param tumble whether they are turned in any way instead, each as probable as each other
///   @default false
/// @param shape where copies end: at the cube of the image, or at the ball inside of it, which
///   reaches less far when it is turned @default SHAPE_CUBE
/// @param edges whether that end is antialiased, over one pixel inside of it. Bodies that end by
///   themselves can do without @default true
/// @param meet how copies meet: random, each has a random rank; key, `key` says it; nearest, the
///   one whose centre is nearest to the point is in front, so that they part as drops or grains do;
///   rows, in the order of their cells; sum, their light is added; max, each channel is the
///   greatest @default MEET_RANDOM
/// @param cells how many cells across, up and away are looked at. Without a value they are as many
///   as the ranges need @default ivec3(2) @range 1 6
///   @computed bomb3_cells smaller sizes, or less jitter, reach less far
/// @param period after how many cells space repeats, across, up and away; 0 never
///   @default ivec3(0) @range 0 65536
/// @param seed another seed gives another space @default 0
/// @param wander whether the copies move: each to a new place in its part of the cell, at a new
///   whole number of `phase`, without haste and without a halt that they share @default false
/// @param phase how far they have moved; along each axis their speed is at most 1.5 times the
///   jitter for each unit, wherever they are @default time
/// @param loop after how many units of `phase` the motion repeats; 0 never @default 0
///   @range 0 65536
/// @param background what is around them, straight alpha @default vec4(0)
/// @param fade whether space goes to `far` where cells are small: it begins where a cell has two
///   pixels, and is over where it has one @default false
/// @param far what the copies are from far away: their mean colour, and the share of space that
///   they fill as alpha @default vec4(0)
/// @param color the copies in the background, straight alpha
/// @param tile the frame of the copy of which most is seen at this point, as a tile
/// @param index which of the copies in its cell that is
/// @param covered how much of the pixel copies cover, from 0 to 1
/// @param offset from the centre of that copy to the point, in cells; 0 where there is none
/// @param normal the direction in which the point leaves that copy's shape, of length 1, in the
///   coordinate's space: from the centre of a ball, out of the nearest side of a cube; 0 where
///   there is none
vec4 image(vec3 position, Tile3 tile);
float coverage(vec3 position, Tile3 tile);
float density(vec3 position);
float size_at(vec3 position);
float rotation_at(vec3 position);
float key(Tile3 tile);
vec3 tint(Tile3 tile);

// The cell with a number.
vec3 node_at(vec3 corner, int number, const ivec3 cells) {
  return corner + vec3(ivec3(number % cells.x, number / cells.x % cells.y,
                             number / (cells.x * cells.y)));
}

// Whether another copy of at least this one's rank is within `spacing` of its centre, p.
bool is_crowded(Copy copy, vec3 p, const int copies, vec3 jitter, const float spacing,
                const ivec3 rivals, const ivec3 period, int seed, const bool wander, float phase,
                const int loop) {
  // Cells that were asked for beyond those that are needed lie on both sides of them.
  ivec3 more = (rivals - bomb3_rivals(jitter, spacing)) / 2;
  vec3 corner = floor(p - (0.5 * jitter + spacing - 1.0)) - vec3(more);
  bool is_near = false;
  for (int i = 0; i < rivals.x * rivals.y * rivals.z * copies; ++i) {
    vec3 node = node_at(corner, i / copies, rivals);
    Copy other = copy_at(p, node, i % copies, period, seed, jitter, wander, phase, loop);
    bool is_other = other.cell != copy.cell || other.index != copy.index;
    bool is_above = other.luck >= copy.luck;
    if (is_above && is_other && dot(other.from, other.from) < spacing * spacing) {
      is_near = true;
    }
  }
  return is_near;
}

// Whether the copy is there.
bool is_there(Copy copy, vec3 p, vec3 scale, const int copies, vec3 jitter, const float spacing,
              const ivec3 rivals, const ivec3 period, int seed, const bool wander, float phase,
              const int loop) {
  vec3 center = p - copy.from;
  float chance = density((center + 0.5) / scale);
  bool stays = chance >= 1.0 || random(copy.seed, -3) < chance;
  if (stays && spacing > 0.0) {
    stays = !is_crowded(copy, center, copies, jitter, spacing, rivals, period, seed, wander, phase,
                        loop);
  }
  return stays;
}

// A copy's size between the least and the greatest.
float large_of(Copy copy, vec3 p, vec3 scale) {
  float told = size_at((p - copy.from + 0.5) / scale);
  return told < 0.0 ? copy.large : min(told, 1.0);
}

// How a copy is turned.
vec4 turn_of(Copy copy, vec3 p, vec3 scale, vec2 rotation, vec3 axis, const bool tumble) {
  float told = rotation_at((p - copy.from + 0.5) / scale);
  float share = told < 0.0 ? random(copy.seed, -5) : min(told, 1.0);
  return turned_by(copy.seed, share, rotation, axis, tumble);
}

// Which copy is in front: the one of the higher rank; 0 is behind all.
uint rank_of(Copy copy, vec3 scale, vec2 size, vec2 rotation, const bool tumble,
             const int meet) {
  if (meet == MEET_RANDOM) {
    return copy.luck;
  }
  if (meet == MEET_NEAREST) {
    return ~floatBitsToUint(dot(copy.from, copy.from));
  }
  // Floats in their order, those below zero too.
  uint bits = floatBitsToUint(key(frame_of(copy, scale, size, rotation, tumble)));
  return bits ^ (uint(int(bits) >> 31) | 2147483648u);
}

// How much of the pixel the shape of a copy has, `arm` from its middle. For a ball, of which `arm`
// need not be turned, by half of the square of the radius: near its rim this over its change is the
// distance in pixels, too. Where a surface only touches a ball it does not change; there it is the
// area of a disc in the pixel.
float edge_of(vec3 arm, const int shape) {
  vec3 right = footprint_x(arm);
  vec3 up = footprint_y(arm);
  if (shape == SHAPE_BALL) {
    vec2 change = vec2(dot(arm, right), dot(arm, up));
    float pixel = 0.0253303 * dot(right, right) * dot(up, up);
    float width = sqrt(max(max(dot(change, change), pixel), 1e-18));
    return clamp((0.125 - 0.5 * dot(arm, arm)) / width, 0.0, 1.0);
  }
  vec3 inside = clamp((0.5 - abs(arm)) / max(footprint(arm), 1e-9), 0.0, 1.0);
  return inside.x * inside.y * inside.z;
}

// A copy's colour at the point, straight alpha.
vec4 paint(Copy copy, vec3 scale, vec2 size, vec2 rotation, const bool tumble, const int shape,
           const bool edges) {
  Tile3 tile = frame_of(copy, scale, size, rotation, tumble);
  float part = coverage(tile.local, tile);
  float edge = 1.0;
  if (edges) {
    edge = edge_of(shape == SHAPE_BALL ? copy.from / side_of(copy, size)
                                       : arm_of(copy, size, rotation, tumble), shape);
  }
  vec4 seen = vec4(0.0);
  if (part > 0.0) {
    seen = image(tile.local, tile);
    seen = vec4(seen.rgb * tint(tile), seen.a * part * edge);
  }
  return seen;
}

// Whether a copy of the cell may reach the point. Of 8 cells that costs more than it saves, and
// cubes that are not turned fill the box of cells that are looked at.
bool can_reach(vec3 p, vec3 node, vec3 jitter, vec2 size, vec2 rotation, const bool tumble,
               const int shape, const ivec3 cells) {
  bool is_round = shape == SHAPE_BALL || is_turned(rotation, tumble);
  if (cells.x * cells.y * cells.z <= 8 || !is_round) {
    return true;
  }
  vec3 gap = max(abs(p - node) - (0.5 * jitter + 0.00001), 0.0);
  return dot(gap, gap) < (shape == SHAPE_BALL ? 0.25 : 0.75) * size.y * size.y;
}

// The topmost copy with a rank below `last`, which it gets; of equal ranks the one with the lower
// number. Rank 0 if there is none.
void find_next(vec3 p, vec3 corner, vec3 scale, const int copies, vec3 jitter, const float spacing,
               const ivec3 rivals, vec2 size, vec2 rotation, vec3 axis, const bool tumble,
               const int shape, const int meet, const ivec3 cells, const ivec3 period, int seed,
               const bool wander, float phase, const int loop, inout uint last,
               inout int last_number, out Copy found) {
  uint best = 0u;
  int best_number = 0;
  found.from = p;
  for (int i = 0; i < cells.x * cells.y * cells.z; ++i) {
    vec3 node = node_at(corner, i, cells);
    if (can_reach(p, node, jitter, size, rotation, tumble, shape, cells)) {
      for (int index = 0; index < copies; ++index) {
        Copy copy = copy_at(p, node, index, period, seed, jitter, wander, phase, loop);
        copy.large = large_of(copy, p, scale);
        if (meet == MEET_KEY) {
          copy.turn = turn_of(copy, p, scale, rotation, axis, tumble);
        }
        uint rank = rank_of(copy, scale, size, rotation, tumble, meet);
        int number = i * copies + index;
        bool is_next = rank > best && rank < last;
        if (meet != MEET_RANDOM) {
          is_next = rank >= best && (rank < last || (rank == last && number < last_number));
        }
        if (is_next && is_near(copy, size, rotation, tumble, shape)) {
          if (shape == SHAPE_CUBE && meet != MEET_KEY) {
            copy.turn = turn_of(copy, p, scale, rotation, axis, tumble);
          }
          if (holds(copy, size, rotation, tumble, shape) &&
              is_there(copy, p, scale, copies, jitter, spacing, rivals, period, seed, wander, phase,
                       loop)) {
            best = rank;
            best_number = number;
            found = copy;
          }
        }
      }
    }
  }
  last = best;
  last_number = best_number;
}

// From the topmost copy down.
View by_rank(vec3 p, vec3 corner, vec3 scale, const int copies, vec3 jitter, const float spacing,
             const ivec3 rivals, vec2 size, vec2 rotation, vec3 axis, const bool tumble,
             const int shape, const bool edges, const int meet, const ivec3 cells,
             const ivec3 period, int seed, const bool wander, float phase, const int loop,
             float near) {
  vec4 sum = vec4(0.0);
  float most = 0.0;
  Copy top;
  top.from = p;
  float open = near;
  float through = 1.0;
  uint last = 4294967295u;
  int last_number = 2147483647;
  // It ends when no copy is left. Drivers unroll loops of a few rounds, and then some of them run
  // all rounds everywhere; so the number of copies is not told unless it is one.
  const int count = cells.x * cells.y * cells.z;
  const int checked = rivals.x * rivals.y * rivals.z * copies;
  const int rounds = 1 + count + count * copies * (1 + checked);
  const int layers = count * copies > 1 ? clamp(65535 / rounds, 1, MOST_LAYERS) : 1;
  for (int layer = 0; layer < layers; ++layer) {
    if (open > 0.001) {
      open = 0.0;
      Copy copy;
      find_next(p, corner, scale, copies, jitter, spacing, rivals, size, rotation, axis, tumble,
                shape, meet, cells, period, seed, wander, phase, loop, last, last_number, copy);
      if (last > 0u) {
        if (shape == SHAPE_BALL && meet != MEET_KEY) {
          copy.turn = turn_of(copy, p, scale, rotation, axis, tumble);
        }
        vec4 seen = paint(copy, scale, size, rotation, tumble, shape, edges);
        float part = seen.a * through;
        sum += vec4(seen.rgb, 1.0) * part;
        through = 1.0 - sum.a;
        open = through;
        if (part > most) {
          most = part;
          top = copy;
        }
      }
    }
  }
  return View(sum.rgb, through, most, top);
}

// All copies as they come, from the last cell to the first.
View in_order(vec3 p, vec3 corner, vec3 scale, const int copies, vec3 jitter, const float spacing,
              const ivec3 rivals, vec2 size, vec2 rotation, vec3 axis, const bool tumble,
              const int shape, const bool edges, const int meet, const ivec3 cells,
              const ivec3 period, int seed, const bool wander, float phase, const int loop,
              float near) {
  vec3 light = vec3(0.0);
  float through = 1.0;
  float most = 0.0;
  Copy top;
  top.from = p;
  for (int i = cells.x * cells.y * cells.z - 1; i >= 0; --i) {
    vec3 node = node_at(corner, i, cells);
    if (near > 0.0 && can_reach(p, node, jitter, size, rotation, tumble, shape, cells)) {
      for (int index = copies - 1; index >= 0; --index) {
        Copy copy = copy_at(p, node, index, period, seed, jitter, wander, phase, loop);
        copy.large = large_of(copy, p, scale);
        bool is_open = meet != MEET_ROWS || through > 0.001;
        if (is_open && is_near(copy, size, rotation, tumble, shape)) {
          copy.turn = turn_of(copy, p, scale, rotation, axis, tumble);
          if (holds(copy, size, rotation, tumble, shape) &&
              is_there(copy, p, scale, copies, jitter, spacing, rivals, period, seed, wander, phase,
                       loop)) {
            vec4 seen = paint(copy, scale, size, rotation, tumble, shape, edges);
            float part = meet == MEET_ROWS ? seen.a * through : seen.a;
            vec3 own = seen.rgb * part;
            light = meet == MEET_MAX ? max(light, own) : light + own;
            through = meet == MEET_MAX ? min(through, 1.0 - part) : through - part;
            if (part > most) {
              most = part;
              top = copy;
            }
          }
        }
      }
    }
  }
  return View(light, max(through, 0.0), most, top);
}

void bomb3(vec3 uv, vec3 scale, const int copies, vec3 jitter, const float spacing,
           const ivec3 rivals, vec2 size, vec2 rotation, vec3 axis, const bool tumble,
           const int shape, const bool edges, const int meet, const ivec3 cells, const ivec3 period,
           int seed, const bool wander, float phase, const int loop, vec4 background,
           const bool fade, vec4 far, out vec4 color, out Tile3 tile, out int index,
           out float covered, out vec3 offset, out vec3 normal) {
  vec3 p = uv * scale - 0.5;
  vec3 reach = bomb3_reach(size, rotation, axis, tumble, shape);
  // Cells that were asked for beyond those that are needed lie on both sides of them.
  ivec3 more = (cells - bomb3_cells(jitter, size, rotation, axis, tumble, shape)) / 2;
  vec3 corner = floor(p - (0.5 * jitter + reach - 1.0)) - vec3(more);
  float near = 1.0;
  if (fade) {
    vec3 pixel = footprint(p);
    near = clamp(2.0 - 2.0 * max(max(pixel.x, pixel.y), pixel.z), 0.0, 1.0);
  }
  View view;
  if (meet == MEET_ROWS || meet == MEET_SUM || meet == MEET_MAX) {
    view = in_order(p, corner, scale, copies, jitter, spacing, rivals, size, rotation, axis, tumble,
                    shape, edges, meet, cells, period, seed, wander, phase, loop, near);
  } else {
    view = by_rank(p, corner, scale, copies, jitter, spacing, rivals, size, rotation, axis, tumble,
                   shape, edges, meet, cells, period, seed, wander, phase, loop, near);
  }
  if (fade) {
    view.light = mix(far.rgb * far.a, view.light, near);
    view.through = mix(1.0 - far.a, view.through, near);
  }
  covered = 1.0 - view.through;
  float alpha = mix(background.a, 1.0, covered);
  vec3 below = background.rgb * (background.a * view.through);
  color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  tile = frame_of(view.top, scale, size, rotation, tumble);
  index = view.top.index;
  bool is_seen = view.most > 0.0;
  offset = is_seen ? view.top.from : vec3(0.0);
  normal = is_seen ? normal_of(view.top, scale, size, rotation, tumble, shape) : vec3(0.0);
}
