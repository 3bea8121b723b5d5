// SPDX-License-Identifier: Apache-2.0
// Tiles of ground whose edges fit: whatever comes within `kBorder` of an edge depends on the two
// corners of that edge alone (grass or sand), and on nothing else of the tile. What makes tiles
// differ lies further inside.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "graphs/pictures/things.h"

namespace texgraph::pictures {

namespace {

constexpr int kTileSide = 128;
// Nothing that has its foot further inside reaches an edge.
constexpr double kBorder = 0.115;
constexpr uint32_t kShared = 2000;  // the seed of what all tiles have

struct Plan {
  uint32_t seed = 0;  // of what lies inside
  // Sand, from 0 to 1, at the corners (0, 0), (1, 0), (0, 1), (1, 1), v going up.
  double sand[4] = {0, 0, 0, 0};
  double frame_dry = 0.06;  // the share of dry blades along the edges
  double dry = 0.06;        // and inside
  double bare = 0;          // how much soil shows inside
  double clumps = 1;        // how much the grass varies
  int stones = 0;
  double stone_size = 0.030;
  int poppies = 0;
  int daisies = 0;
  int clovers = 0;
  int twigs = 0;
  int mosses = 0;
  int shells = 0;
};

double FromEdge(Point p) { return std::min(std::min(p.x, 1 - p.x), std::min(p.y, 1 - p.y)); }

class Ground {
 public:
  explicit Ground(const Plan& plan) : plan_(plan), canvas_(kTileSide, kTileSide) {}

  Picture Paint();

 private:
  // 0 in the frame, to 1.
  double Inside(Point p) const { return SmoothStep(kBorder, kBorder + 0.15, FromEdge(p)); }
  // A patch in the middle with ragged borders, from 0 to 1; another for each `kind`.
  double Patch(Point p, uint32_t kind) const {
    const Point c = p - Point{0.5, 0.5};
    const double bump = 1.25 - 2.1 * Length(c);
    const double ragged = 1.15 * Fractal(p * 3.7, 4, plan_.seed + kind);
    return SmoothStep(0.0, 0.95, bump + ragged) * SmoothStep(kBorder, kBorder + 0.16, FromEdge(p));
  }
  // Of the tile that p lies in; p may be a little outside of this one. Sand is above 0.5.
  double Sand(Point p) const {
    const double u = SmoothStep(kBorder, 1 - kBorder, p.x);
    const double v = SmoothStep(kBorder, 1 - kBorder, 1 - p.y);
    const double share =
        Mix(Mix(plan_.sand[0], plan_.sand[1], u), Mix(plan_.sand[2], plan_.sand[3], u), v);
    return share + 0.22 * Fractal(p * 4, 3, kShared + 1, 4) +
           0.30 * Inside(p) * Fractal(p * 3.3, 3, plan_.seed + 31) * 4 * share * (1 - share);
  }
  double Clump(Point p) const {
    return 0.35 * Fractal(p * 10, 2, kShared + 11, 10) +
           plan_.clumps * Inside(p) * Fractal(p * 3.1, 3, plan_.seed + 11);
  }
  double Bare(Point p) const {
    return plan_.bare * Patch(p, 41) +
           0.5 * plan_.clumps * Inside(p) * Fractal(p * 4, 2, plan_.seed + 21);
  }
  Color Soil(Point p) const;
  Color Beach(Point p) const;
  void LayBlades(int across, int layer);
  void LayBlade(Point at, int x, int y, int layer, uint32_t seed);
  void LayThings(int count, double size, uint32_t kind, double sand,
                 void (*lay)(Canvas&, Point, double, uint32_t));

  const Plan& plan_;
  Canvas canvas_;
  std::vector<Point> taken_;
};

Color Ground::Soil(Point p) const {
  const double crumb = Fractal(p * 24, 3, kShared + 31, 24);
  const double cloud = Fractal(p * 11, 2, kShared + 41, 11);
  const Color earth = Mix({0.45, 0.36, 0.24}, {0.66, 0.55, 0.39}, SmoothStep(-0.6, 0.7, crumb));
  const Color green = Mix({0.13, 0.17, 0.06}, {0.22, 0.25, 0.09}, SmoothStep(-0.5, 0.5, cloud));
  return Mix(green, earth, SmoothStep(0.15, 0.6, Bare(p)));
}

// Ripples of the wind, and grains.
Color Ground::Beach(Point p) const {
  const double bend = 0.30 * Noise(p * 3, kShared + 51, 3);
  const double phase =
      7 * (p.y + 0.14 * bend) + 2 * p.x + 1.1 * Inside(p) * Noise(p * 3, plan_.seed + 51);
  const double t = phase - std::floor(phase);
  const double ripple = t < 0.7 ? SmoothStep(0, 0.7, t) : SmoothStep(1, 0.7, t);
  const double grain = Noise(p * 60, kShared + 61, 60);
  const double cloud = Fractal(p * 3, 3, kShared + 71, 3) +
                       plan_.clumps * Inside(p) * Fractal(p * 2.7, 3, plan_.seed + 61);
  Color color = Mix({0.74, 0.64, 0.46}, {0.86, 0.77, 0.59}, SmoothStep(-0.6, 0.6, cloud));
  color = color * (0.965 + 0.055 * ripple + 0.07 * grain);
  const Cell speck = Cells(p * 40, kShared + 81, 40);
  return speck.value > 0.88
             ? Mix(color, {0.47, 0.38, 0.28}, 0.6 * SmoothStep(0.38, 0.2, speck.nearest))
             : color;
}

void Ground::LayBlade(Point at, int x, int y, int layer, uint32_t seed) {
  seed += static_cast<uint32_t>(100 * layer);
  const double sand = Sand(at);
  if (sand > 0.5 + 0.10 * Random(x, y, seed + 1)) return;
  if (Bare(at) > 0.25 + 0.75 * Random(x, y, seed + 2)) return;
  const Point wind{1.1 * Noise(at * 6, kShared + 91, 6) + 0.25,
                   1.1 * Noise(at * 6, kShared + 101, 6) - 0.35};
  const Point along = Unit(Direction(x, y, seed + 3) * 0.9 + wind);
  const double lush = SmoothStep(0.55, 0.25, sand);  // grass is short where it meets the sand
  const double length = (0.050 + 0.050 * Random(x, y, seed + 5)) * (0.55 + 0.45 * lush);
  const double width = 0.0042 + 0.0028 * Random(x, y, seed + 6);
  const double tone = Clamp(0.42 + 0.45 * Clump(at) + 0.55 * (Random(x, y, seed + 7) - 0.5), 0, 1);
  const double depth = 0.72 + 0.20 * layer;  // what lies deep is in the dark
  const Color green = tone < 0.5 ? Mix({0.18, 0.30, 0.09}, {0.35, 0.48, 0.15}, 2 * tone)
                                 : Mix({0.35, 0.48, 0.15}, {0.58, 0.65, 0.26}, 2 * tone - 1);
  const double straw = Mix(plan_.frame_dry, plan_.dry, Patch(at, 81)) + 0.25 * (1 - lush);
  const bool is_dry = Random(x, y, seed + 8) < straw;
  const Color yellow = Mix({0.66, 0.55, 0.27}, {0.88, 0.80, 0.50}, Random(x, y, seed + 9));
  const Color color = (is_dry ? yellow : green) * depth;
  canvas_.Stroke(at, at + along * length, 0.22 * length * (2 * Random(x, y, seed + 10) - 1), width,
                 color * 0.74, color * 1.18);
}

// One layer of grass, in an order that has nothing to do with where a blade stands. Blades of the
// tiles around reach into this one, too.
void Ground::LayBlades(int across, int layer) {
  const int count = across * across;
  for (int i = 0; i < count; ++i) {
    const int shuffled = static_cast<int>(int64_t{i} * 7919 % count);
    const int x = shuffled % across;
    const int y = shuffled / across;
    const Point cell_low{double(x) / across, double(y) / across};
    const Point cell_high{double(x + 1) / across, double(y + 1) / across};
    const bool is_shared = std::min(FromEdge(cell_low), FromEdge(cell_high)) < kBorder;
    const uint32_t seed = is_shared ? kShared + 1000 : plan_.seed + 1000;
    const uint32_t place = seed + static_cast<uint32_t>(100 * layer);
    const Point at{(x + Random(x, y, place + 20)) / across,
                   (y + Random(x, y, place + 21)) / across};
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Point moved{at.x + dx, at.y + dy};
        if (FromEdge(moved) > -kBorder) LayBlade(moved, x, y, layer, seed);
      }
    }
  }
}

// Scattered inside, none on another, where the ground is as sandy as asked: up to 0.3 of it wrong.
void Ground::LayThings(int count, double size, uint32_t kind, double sand,
                       void (*lay)(Canvas&, Point, double, uint32_t)) {
  const uint32_t seed = plan_.seed + kind;
  int laid = 0;
  for (int attempt = 0; attempt < 40 * count && laid < count; ++attempt) {
    const double own = size * (0.72 + 0.56 * Random(attempt, 0, seed));
    const double margin = 0.024 + kThingReach * own;
    const Point at{Mix(margin, 1 - margin, Random(attempt, 1, seed)),
                   Mix(margin, 1 - margin, Random(attempt, 2, seed))};
    const bool is_free = std::none_of(taken_.begin(), taken_.end(), [&](Point other) {
      return Length(at - other) < 1.15 * (own + size);
    });
    if (!is_free || std::fabs(Sand(at) - sand) > 0.3) continue;
    taken_.push_back(at);
    lay(canvas_, at, own, seed + static_cast<uint32_t>(100 * attempt));
    ++laid;
  }
}

Picture Ground::Paint() {
  canvas_.Fill([this](Point p) {
    const double sand = SmoothStep(0.47, 0.53, Sand(p));
    return Mix(Soil(p), Beach(p), sand);
  });
  LayBlades(31, 0);
  LayThings(plan_.stones, plan_.stone_size, 12000, 0, LayStone);
  LayBlades(31, 1);
  LayThings(plan_.mosses, 0.095, 11000, 0, LayMoss);
  LayThings(plan_.twigs, 0.085, 13000, 0, LayTwig);
  LayThings(plan_.clovers, 0.032, 14000, 0, LayClover);
  LayBlades(23, 2);
  LayThings(plan_.poppies, 0.036, 15000, 0, LayPoppy);
  LayThings(plan_.daisies, 0.028, 16000, 0, LayDaisy);
  LayThings(plan_.shells, 0.028, 17000, 1, LayShell);
  LayThings(plan_.shells, 0.018, 18000, 1, LayStone);
  return canvas_.FinishOpaque();
}

Picture PaintGround(const Plan& plan) { return Ground(plan).Paint(); }

int Pick(int low, int high, uint32_t seed) {
  return low + static_cast<int>(Random(0, 0, seed) * (high - low + 1));
}

Plan MeadowPlan(int index) {
  Plan plan;
  plan.seed = 100000 + 50000 * static_cast<uint32_t>(index);
  plan.clumps = 1.35;
  plan.stones = Pick(0, 4, plan.seed + 1);
  plan.stone_size = 0.027;
  plan.clovers = Pick(0, 6, plan.seed + 2);
  plan.twigs = Pick(0, 1, plan.seed + 3);
  plan.mosses = Pick(0, 2, plan.seed + 4);
  return plan;
}

}  // namespace

Picture MakeMeadow() {
  std::vector<Picture> tiles;
  for (int i = 0; i < 16; ++i) tiles.push_back(PaintGround(MeadowPlan(i)));
  return Sheet(4, tiles);
}

Picture MakeLandscape() {
  std::vector<Picture> tiles;
  for (int i = 0; i < 16; ++i) {
    Plan plan = MeadowPlan(20 + i);
    const int kind = i / 4;
    plan.frame_dry = 0.26;
    if (kind == 1) {
      plan.poppies = 19 + 2 * (i % 4);
      plan.daisies = 9 - 2 * (i % 4);
    } else if (kind == 2) {
      plan.dry = 0.85 + 0.04 * (i % 4);
      plan.clovers = 0;
    } else if (kind == 3) {
      plan.bare = 1.15;
      plan.stones = 14 + (i % 4);
      plan.stone_size = 0.048 - 0.004 * (i % 4);
      plan.clovers = 0;
    }
    tiles.push_back(PaintGround(plan));
  }
  return Sheet(4, tiles);
}

Picture MakeShore() {
  std::vector<Picture> tiles;
  for (int i = 0; i < 8; ++i) tiles.push_back(PaintGround(MeadowPlan(40 + i)));
  for (int i = 0; i < 22; ++i) {
    Plan plan = MeadowPlan(50 + i);
    const int index = i < 8 ? 15 : i - 7;  // bit k: sand at corner k
    for (int k = 0; k < 4; ++k) plan.sand[k] = (index >> k) & 1;
    plan.shells = Pick(i < 8 ? 0 : 1, 3, plan.seed + 5);
    tiles.push_back(PaintGround(plan));
  }
  return Sheet(6, tiles);
}

}  // namespace texgraph::pictures
