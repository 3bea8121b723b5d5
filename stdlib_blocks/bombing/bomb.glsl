// SPDX-License-Identifier: Apache-2.0
const int GRID_SQUARE = 0;
const int GRID_HEXAGON = 1;

const int MEET_RANDOM = 0;
const int MEET_KEY = 1;
const int MEET_NEAREST = 2;
const int MEET_ROWS = 3;
const int MEET_SUM = 4;
const int MEET_MAX = 5;

// So many copies are composited at a point at most.
const int MOST_LAYERS = 100;

// One copy, as seen from a point; lengths in widths of a cell.
struct Copy {
  ivec2 cell;
  int index;    // in its cell
  uint seed;
  uint luck;    // random bits that the seed does not tell
  vec2 from;    // from its centre to the point
};

// What is seen of the copies at a point.
struct View {
  vec3 light;     // of all copies together
  float through;  // what shows through them
  Copy top;       // the one of which most is seen
};

// From the middle of its cell to the centre of a copy. Positions at whole numbers of `phase` are
// drawn anew; each copy has its own beginning, so that they do not all halt at once.
vec2 offset(uvec4 bits, vec2 jitter, const bool wander, float phase, const int loop) {
  if (!wander) {
    return vec2(ivec2(bits.xy)) * (jitter * 2.3283064365386963e-10);
  }
  float time = phase + random(bits.w, -4);
  float begun = floor(time);
  int from = int(begun);
  int to = from + 1;
  if (loop > 0) {
    from = wrap_cell(from, loop);
    to = wrap_cell(to, loop);
  }
  uint path = hash(bits.w);
  float t = time - begun;
  vec2 place = mix(random2(path, from), random2(path, to), t * t * (3.0 - 2.0 * t));
  return (place - 0.5) * jitter;
}

// A cell, in its widths.
vec2 cell_size(const int grid) {
  return grid == GRID_HEXAGON ? vec2(1.0, 0.8660254037844386) : vec2(1.0);
}

// The number of a cell among those that are looked at, as the cell. `low` is the least place, in
// cells, that the middle of one in reach can have.
vec2 node_at(vec2 low, int number, const ivec2 cells, const int grid) {
  vec2 node = vec2(ivec2(number % cells.x, number / cells.x));
  if (grid == GRID_HEXAGON) {
    node.y += floor(low.y);
    node.x += floor(low.x + 0.5 * float(int(node.y) & 1));
    return node;
  }
  return floor(low) + node;
}

Copy copy_at(vec2 p, vec2 node, int index, const int grid, const ivec2 period, int seed,
             vec2 jitter, const bool wander, float phase, const int loop) {
  Copy copy;
  copy.cell = ivec2(node);
  if (period.x > 0) {
    copy.cell.x = wrap_cell(copy.cell.x, period.x);
  }
  if (period.y > 0) {
    // Every second row is moved: an even number of them closes.
    int rows = grid == GRID_HEXAGON ? period.y + (period.y & 1) : period.y;
    copy.cell.y = wrap_cell(copy.cell.y, rows);
  }
  copy.index = index;
  uvec4 bits = copy_bits(copy.cell, index, seed);
  copy.seed = bits.w;
  copy.luck = bits.z;
  vec2 middle = node;
  if (grid == GRID_HEXAGON) {
    middle.x -= 0.5 * float(int(node.y) & 1);
  }
  vec2 moved = cell_size(grid) * offset(bits, jitter, wander, phase, loop);
  copy.from = p - cell_size(grid) * middle - moved;
  return copy;
}

// How far the point is from the middle of a copy, and how far its frame goes; or if that is turned,
// the circle around it.
vec2 distance_of(Copy copy, float side, vec2 rotation, const int shape) {
  vec2 away = abs(copy.from);
  float square = dot(copy.from, copy.from);
  if (shape == SHAPE_DISC) {
    return vec2(square, 0.25 * side * side);
  }
  bool straight = rotation.x == 0.0 && rotation.y == 0.0;
  return straight ? vec2(max(away.x, away.y), 0.5 * side) : vec2(square, 0.5 * side * side);
}

// From the middle of a copy to the point, in the copy's frame.
vec2 arm_of(Copy copy, vec2 pose) {
  float c = cos(pose.y);
  float s = sin(pose.y);
  return (c * copy.from + s * vec2(copy.from.y, -copy.from.x)) / pose.x;
}

// The frame of a copy, as a tile.
Tile frame_of(Copy copy, vec2 pose, vec2 size, vec2 scale) {
  float c = cos(pose.y);
  float s = sin(pose.y);
  Tile tile;
  tile.cell = copy.cell;
  tile.local = arm_of(copy, pose) + 0.5;
  tile.size = pose.x / abs(scale);
  tile.seed = copy.seed;
  tile.right = normalize(vec2(c, s) / scale);
  tile.up = normalize(vec2(-s, c) / scale);
  tile.pitch = vec2(0.0);
  tile.smallest = vec2(0.0);
  tile.largest = size.y / abs(scale);
  tile.drift = vec2(0.0);
  tile.tilt = vec2(1.0);
  return tile;
}

/// Scatters copies of an image over the plane, each at a random place, turned and sized at random:
/// flowers in a field, leaves on the ground, stars. The plane is divided into cells of `scale`,
/// each with `copies` of the image. No copy is clipped: the compiler finds out how far copies can
/// reach, and looks at the cells that can and no more; see `cells`. Lengths and angles are those of
/// the cells, which are square if `scale` has the proportions of the surface. The copies at a point
/// are composited from the topmost down, until nothing shows through, at most 100; so edges are
/// smooth where copies overlap, and mostly one image is looked up. Copies with the same key, or
/// equally near, lie on each other in the order of their cells: the later row, in a row the later
/// column, is on top. Of copies with the same random rank, one pair in 2^32, the earlier is left
/// out.
/// @source Glanville, Texture Bombing, GPU Gems, chapter 20; in place of its table of random
///   numbers an integer hash, and in place of 4 cells as many as the copies can reach
/// @param image what is scattered, from (0, 0) at the lower left corner of a copy to (1, 1);
///   straight alpha. A function of the graph may take `tile` as well, the copy's frame: its random
///   bits are the copy's own, so that no two copies need be alike
/// @param coverage how much of the copy is there, another factor of its alpha. Where it is 0 the
///   image is not asked for: so a shape that is computed costs a texture sample only where it is
///   seen @default 1
/// @param density the share of the copies that are there, at a place of the surface: a number, or a
///   map that was painted. It is asked for at the centre of each copy @default 1
/// @param size_at where a copy's size is between the least, 0, and the greatest, 1, at a place of
///   the surface: so a map says how large copies grow. It is asked for at the centre of each copy;
///   below 0 it is left to chance @default -1
/// @param rotation_at the same of its angle @default -1
/// @param key for `meet` by key: the copy with the greater number lies on the other @default 0
/// @param tint what a copy's colour is multiplied by @default vec3(1)
/// @param uv coordinate @default uv
/// @param scale cells for each unit of the coordinate @default vec2(8)
/// @param grid how cells lie: square, in columns; hexagon, every second row moved to the left by
///   half a cell, and rows sqrt(3)/2 = 0.866 of a cell's width apart, so that middles are equally
///   far from all six around them; an odd `period` up becomes the next even one
///   @default GRID_SQUARE
/// @param copies how many a cell has @default 1 @range 1 32
/// @param jitter how far from the middles of their cells the centres of copies are drawn, as the
///   width and height of that part, in cells: 0, not at all; 1, anywhere in the cell
///   @default vec2(1) @range 0 8
/// @param spacing how near the centres of two copies may be, in cells; 0, any. Of copies that are
///   nearer only one stays: a copy is left out if another of a higher rank is within this distance.
///   That is like Poisson discs, with more room between them: take several `copies`, of which most
///   are left out. Of n in each cell about (1 - exp(-n a)) / a stay, where a = pi spacing^2.
///   Copies that wander go while they are too near @default 0 @range 0 1
/// @param rivals how many cells across and up have copies that can be nearer than `spacing` to one.
///   Without a value they are as many as jitter and spacing need @default ivec2(2) @range 0 5
///   @computed bomb_rivals less spacing, or less jitter, needs fewer
/// @param size least and greatest side of a copy, in cells; above 0 @default vec2(1) @ordered
/// @param rotation least and greatest angle, counter-clockwise @default vec2(0) @unit degrees
///   @ordered
/// @param shape where copies end: at the frame of the image, or at the circle inside of it, which
///   reaches less far when it is turned @default SHAPE_SQUARE
/// @param edges whether that end is antialiased, over one pixel inside of it. Images that end by
///   themselves, with a transparent rim, can do without @default true
/// @param meet how copies meet: random, each has a random rank; key, `key` says it; nearest, the
///   one whose centre is nearest to the point is on top; rows, they lie in the order of their
///   cells; sum, their light is added; max, each channel is the greatest @default MEET_RANDOM
/// @param cells how many cells across and up are looked at. Without a value they are as many as the
///   ranges need @default ivec2(2) @range 1 8
///   @computed bomb_cells smaller sizes, or less jitter, reach less far
/// @param period after how many cells the plane repeats, across and up; 0 never @default ivec2(0)
///   @range 0 65536
/// @param seed another seed gives another plane @default 0
/// @param wander whether the copies move: each to a new place in its part of the cell, at a new
///   whole number of `phase`, without haste and without a halt that they share @default false
/// @param phase how far they have moved; their speed is at most 1.5 times the jitter for each unit,
///   wherever they are @default time
/// @param loop after how many units of `phase` the motion repeats; 0 never @default 0
///   @range 0 65536
/// @param background what lies below, straight alpha @default vec4(0)
/// @param fade whether the plane goes to `far` where cells are small: it begins where a cell has
///   two pixels, and is over where it has one @default false
/// @param far what the copies are from far away: their mean colour, and the share of the plane that
///   they cover as alpha @default vec4(0)
/// @param color the copies over the background, straight alpha
/// @param tile the frame of the copy of which most is seen at this point, as a tile
/// @param index which of the copies in its cell that is
/// @param covered how much of the pixel copies cover, from 0 to 1
vec4 image(vec2 uv, Tile tile);
float coverage(vec2 uv, Tile tile);
float density(vec2 uv);
float size_at(vec2 uv);
float rotation_at(vec2 uv);
float key(Tile tile);
vec3 tint(Tile tile);

// Whether another copy of at least this one's rank is within `spacing` of its centre, p.
bool is_crowded(Copy copy, vec2 p, const int grid, const int copies, vec2 jitter,
                const float spacing, const ivec2 rivals, const ivec2 period, int seed,
                const bool wander, float phase, const int loop) {
  // Cells that were asked for beyond those that are needed lie on both sides of them.
  ivec2 more = (rivals - bomb_rivals(grid, jitter, spacing)) / 2;
  vec2 low = p / cell_size(grid) - (0.5 * jitter + spacing / cell_size(grid) - 1.0) - vec2(more);
  bool is_near = false;
  for (int i = 0; i < rivals.x * rivals.y * copies; ++i) {
    vec2 node = node_at(low, i / copies, rivals, grid);
    Copy other = copy_at(p, node, i % copies, grid, period, seed, jitter, wander, phase, loop);
    bool is_other = other.cell != copy.cell || other.index != copy.index;
    bool is_above = other.luck >= copy.luck;
    if (is_above && is_other && dot(other.from, other.from) < spacing * spacing) {
      is_near = true;
    }
  }
  return is_near;
}

// Whether the copy is there.
bool is_there(Copy copy, vec2 p, vec2 scale, const int grid, const int copies, vec2 jitter,
              const float spacing, const ivec2 rivals, const ivec2 period, int seed,
              const bool wander, float phase, const int loop) {
  vec2 center = p - copy.from;
  float chance = density((center + 0.5 * cell_size(grid)) / scale);
  bool stays = chance >= 1.0 || random(copy.seed, -3) < chance;
  if (stays && spacing > 0.0) {
    stays = !is_crowded(copy, center, grid, copies, jitter, spacing, rivals, period, seed, wander,
                        phase, loop);
  }
  return stays;
}

// The size of a copy, and its angle.
vec2 pose_of(Copy copy, vec2 p, vec2 scale, const int grid, vec2 size, vec2 rotation) {
  vec2 place = (p - copy.from + 0.5 * cell_size(grid)) / scale;
  vec2 luck = random2(copy.seed, -2);
  vec2 told = vec2(size_at(place), rotation_at(place));
  luck.x = told.x < 0.0 ? luck.x : min(told.x, 1.0);
  luck.y = told.y < 0.0 ? luck.y : min(told.y, 1.0);
  return vec2(mix(size.x, size.y, luck.x), radians(mix(rotation.x, rotation.y, luck.y)));
}

// Which copy lies on which: the one of the higher rank; 0 is below all.
uint rank_of(Copy copy, vec2 pose, vec2 size, vec2 scale, const int meet) {
  if (meet == MEET_RANDOM) {
    return copy.luck;
  }
  if (meet == MEET_NEAREST) {
    return ~floatBitsToUint(dot(copy.from, copy.from));
  }
  // Floats in their order, those below zero too.
  uint bits = floatBitsToUint(key(frame_of(copy, pose, size, scale)));
  return bits ^ (uint(int(bits) >> 31) | 2147483648u);
}

// How much of the pixel the frame of a copy has, `arm` from its middle. For a circle by half of the
// square of the radius: near its rim this over its change is the distance in pixels, too.
float edge_of(vec2 arm, const int shape) {
  if (shape == SHAPE_DISC) {
    vec2 change = vec2(dot(arm, footprint_x(arm)), dot(arm, footprint_y(arm)));
    return clamp((0.125 - 0.5 * dot(arm, arm)) / max(length(change), 1e-9), 0.0, 1.0);
  }
  vec2 inside = clamp((0.5 - abs(arm)) / max(footprint(arm), 1e-9), 0.0, 1.0);
  return inside.x * inside.y;
}

// A copy's colour at the point, straight alpha.
vec4 paint(Copy copy, vec2 p, vec2 scale, const int grid, vec2 size, vec2 rotation,
           const int shape, const bool edges) {
  vec2 pose = pose_of(copy, p, scale, grid, size, rotation);
  Tile tile = frame_of(copy, pose, size, scale);
  float part = coverage(tile.local, tile);
  float edge = 1.0;
  if (edges) {
    edge = edge_of(arm_of(copy, pose), shape);
  }
  vec4 seen = vec4(0.0);
  // In a circle the edge never is 0: where it would be the copy was not found.
  if (part > 0.0 && (shape == SHAPE_DISC || edge > 0.0)) {
    seen = image(tile.local, tile);
    seen = vec4(seen.rgb * tint(tile), seen.a * part * edge);
  }
  return seen;
}

// The topmost copy at p with a rank below `last`, which it gets; of equal ranks the one with the
// lower number. Rank 0 if there is none.
void find_next(vec2 p, vec2 low, vec2 scale, const int grid, const int copies, vec2 jitter,
               const float spacing, const ivec2 rivals, vec2 size, vec2 rotation, const int shape,
               const int meet, const ivec2 cells, const ivec2 period, int seed, const bool wander,
               float phase, const int loop, inout uint last, inout int last_number,
               out Copy found) {
  uint best = 0u;
  int best_number = 0;
  found.from = p;
  for (int i = 0; i < cells.x * cells.y; ++i) {
    vec2 node = node_at(low, i, cells, grid);
    for (int index = 0; index < copies; ++index) {
      Copy copy = copy_at(p, node, index, grid, period, seed, jitter, wander, phase, loop);
      vec2 pose = pose_of(copy, p, scale, grid, size, rotation);
      uint rank = rank_of(copy, pose, size, scale, meet);
      int number = i * copies + index;
      // Floats that are not below zero, as distances, have the order of their bits.
      uvec2 away = floatBitsToUint(distance_of(copy, pose.x, rotation, shape));
      bool is_next = all(lessThan(uvec3(best, rank, away.x), uvec3(rank, last, away.y)));
      if (meet != MEET_RANDOM) {
        is_next = away.x < away.y && rank >= best &&
                  (rank < last || (rank == last && number < last_number));
      }
      if (is_next && is_there(copy, p, scale, grid, copies, jitter, spacing, rivals, period, seed,
                              wander, phase, loop)) {
        best = rank;
        best_number = number;
        found = copy;
      }
    }
  }
  last = best;
  last_number = best_number;
}

// From the topmost copy down.
View by_rank(vec2 p, vec2 low, vec2 scale, const int grid, const int copies, vec2 jitter,
             const float spacing, const ivec2 rivals, vec2 size, vec2 rotation, const int shape,
             const bool edges, const int meet, const ivec2 cells, const ivec2 period, int seed,
             const bool wander, float phase, const int loop, float near) {
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
  const int in_reach = cells.x * cells.y * copies;
  const int rounds = in_reach * (1 + rivals.x * rivals.y * copies);
  const int layers = in_reach > 1 ? clamp(65535 / rounds, 1, MOST_LAYERS) : 1;
  for (int layer = 0; layer < layers; ++layer) {
    if (open > 0.001) {
      open = 0.0;
      Copy copy;
      find_next(p, low, scale, grid, copies, jitter, spacing, rivals, size, rotation, shape, meet,
                cells, period, seed, wander, phase, loop, last, last_number, copy);
      if (last > 0u) {
        vec4 seen = paint(copy, p, scale, grid, size, rotation, shape, edges);
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
  return View(sum.rgb, through, top);
}

// All copies as they come, from the last cell to the first.
View in_order(vec2 p, vec2 low, vec2 scale, const int grid, const int copies, vec2 jitter,
              const float spacing, const ivec2 rivals, vec2 size, vec2 rotation, const int shape,
              const bool edges, const int meet, const ivec2 cells, const ivec2 period, int seed,
              const bool wander, float phase, const int loop, float near) {
  vec3 light = vec3(0.0);
  float through = 1.0;
  float most = 0.0;
  Copy top;
  top.from = p;
  for (int i = cells.x * cells.y * copies - 1; i >= 0; --i) {
    if (near > 0.0 && (meet != MEET_ROWS || through > 0.001)) {
      vec2 node = node_at(low, i / copies, cells, grid);
      Copy copy = copy_at(p, node, i % copies, grid, period, seed, jitter, wander, phase, loop);
      vec2 pose = pose_of(copy, p, scale, grid, size, rotation);
      vec2 away = distance_of(copy, pose.x, rotation, shape);
      if (away.x < away.y && is_there(copy, p, scale, grid, copies, jitter, spacing, rivals, period,
                                      seed, wander, phase, loop)) {
        vec4 seen = paint(copy, p, scale, grid, size, rotation, shape, edges);
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
  return View(light, max(through, 0.0), top);
}

void bomb(vec2 uv, vec2 scale, const int grid, const int copies, vec2 jitter, const float spacing,
          const ivec2 rivals, vec2 size, vec2 rotation, const int shape, const bool edges,
          const int meet, const ivec2 cells, const ivec2 period, int seed, const bool wander,
          float phase, const int loop, vec4 background, const bool fade, vec4 far, out vec4 color,
          out Tile tile, out int index, out float covered) {
  // From the middle of the first cell, in widths of a cell.
  vec2 p = uv * scale - 0.5 * cell_size(grid);
  float reach = bomb_reach(size, rotation, shape);
  // Cells that were asked for beyond those that are needed lie on both sides of them.
  ivec2 more = (cells - bomb_cells(grid, jitter, size, rotation, shape)) / 2;
  vec2 low = p / cell_size(grid) - (0.5 * jitter + reach / cell_size(grid) - 1.0) - vec2(more);
  float near = 1.0;
  if (fade) {
    vec2 pixel = footprint(p);
    near = clamp(2.0 - 2.0 * max(pixel.x, pixel.y), 0.0, 1.0);
  }
  View view;
  if (meet == MEET_ROWS || meet == MEET_SUM || meet == MEET_MAX) {
    view = in_order(p, low, scale, grid, copies, jitter, spacing, rivals, size, rotation, shape,
                    edges, meet, cells, period, seed, wander, phase, loop, near);
  } else {
    view = by_rank(p, low, scale, grid, copies, jitter, spacing, rivals, size, rotation, shape,
                   edges, meet, cells, period, seed, wander, phase, loop, near);
  }
  if (fade) {
    view.light = mix(far.rgb * far.a, view.light, near);
    view.through = mix(1.0 - far.a, view.through, near);
  }
  covered = 1.0 - view.through;
  float alpha = mix(background.a, 1.0, covered);
  vec3 below = background.rgb * (background.a * view.through);
  color = vec4((view.light + below) / max(alpha, 1e-20), alpha);
  tile = frame_of(view.top, pose_of(view.top, p, scale, grid, size, rotation), size, scale);
  index = view.top.index;
}
