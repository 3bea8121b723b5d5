// SPDX-License-Identifier: Apache-2.0
// Tiles of ground whose edges fit: the outermost texels depend on the two corners of their edge
// alone (grass or sand), and on nothing else of the tile. Of two meadows that are equally dense,
// one that all tiles share and the tile's own, a tile has those blades of the first that reach over
// an edge, and those of the second that reach none: every place is as dense as every other, and no
// margin is to be seen.
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "graphs/pictures/things.h"

namespace texgraph::pictures {

namespace {

constexpr int kTileSide = 128;
// What comes nearer to an edge than this may touch the outermost texels.
constexpr double kRim = 1.5 / kTileSide;
// No blade that has its foot further inside reaches an edge.
constexpr double kBorder = 0.125;
// The seed of what all tiles have: one of those whose edges are as bright and as lively as the
// rest.
constexpr uint32_t kShared = 206000;

struct Plan {
  uint32_t seed = 0;  // of what lies inside
  // Sand, from 0 to 1, at the corners (0, 0), (1, 0), (0, 1), (1, 1), v going up.
  double sand[4] = {0, 0, 0, 0};
  double straw = 0.06;  // the share of dry blades, over the edges and everywhere
  double dry = 0;       // how much of the tile is covered with dry tufts
  double bare = 0;      // how much of it with spots of soil
  double clumps = 1;    // how much the grass varies
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
  // 0 at the edges, to 1: for what the outermost texels must not have.
  static double Inside(Point p) { return SmoothStep(kRim, 0.045, FromEdge(p)); }
  // Spots of the tile's own, from 0 to 1, that cover about `share`; others for each `kind`.
  double Spots(Point p, double share, uint32_t kind) const {
    if (share <= 0) return 0;
    const double hills = Fractal(p * 6.1, 3, plan_.seed + kind);
    return SmoothStep(-0.12, 0.20, hills + 0.9 * (share - 0.5));
  }
  // Of the tile that p lies in; p may be a little outside of this one. Sand is above 0.5.
  double Sand(Point p, bool is_shared = false) const {
    const double u = SmoothStep(kBorder, 1 - kBorder, p.x);
    const double v = SmoothStep(kBorder, 1 - kBorder, 1 - p.y);
    const double share =
        Mix(Mix(plan_.sand[0], plan_.sand[1], u), Mix(plan_.sand[2], plan_.sand[3], u), v);
    const double common = share + 0.26 * Fractal(p * 4, 3, kShared + 1, 4);
    // Most tiles have no sand, and noise takes long.
    if (is_shared || share == 0) return common;
    return common +
           0.62 * Inside(p) * Fractal(p * 3.3, 4, plan_.seed + 31) * 4 * share * (1 - share);
  }
  double Clump(Point p, bool is_shared) const {
    const double common = 0.35 * Fractal(p * 10, 2, kShared + 11, 10);
    if (is_shared) return common;
    const double own = Fractal(p * 4.3, 3, plan_.seed + 11);
    return common + plan_.clumps * Mix(0.45, 1, Inside(p)) * own;
  }
  double Bare(Point p) const {
    return Inside(p) * (1.1 * Spots(p, plan_.bare, 41) +
                        0.4 * plan_.clumps * Fractal(p * 4, 2, plan_.seed + 21));
  }
  Color Soil(Point p) const;
  Color Beach(Point p) const;
  void LayBlades(int across, int layer);
  void LayBlade(Point at, int x, int y, int layer, bool is_shared);
  void LayThings(int count, double size, uint32_t kind, double sand,
                 void (*lay)(Canvas&, Point, double, uint32_t));

  const Plan& plan_;
  Canvas canvas_;
  std::vector<Point> taken_;
};

Color Ground::Soil(Point p) const {
  const double crumb = Fractal(p * 24, 3, kShared + 31, 24);
  const double cloud = Fractal(p * 11, 2, kShared + 41, 11);
  const Color earth = Mix({0.375, 0.295, 0.235}, {0.56, 0.465, 0.40}, SmoothStep(-0.6, 0.7, crumb));
  const Color green = Mix({0.13, 0.17, 0.06}, {0.22, 0.25, 0.09}, SmoothStep(-0.5, 0.5, cloud));
  return Mix(green, earth, SmoothStep(0.15, 0.6, Bare(p)));
}

// Ripples of the wind, and grains.
Color Ground::Beach(Point p) const {
  const double bend = 0.30 * Noise(p * 3, kShared + 51, 3);
  const double phase =
      7 * (p.y + 0.14 * bend) + 2 * p.x + 1.6 * Inside(p) * Noise(p * 3, plan_.seed + 51);
  const double t = phase - std::floor(phase);
  const double ripple = t < 0.7 ? SmoothStep(0, 0.7, t) : SmoothStep(1, 0.7, t);
  const double grain = Noise(p * 60, kShared + 61, 60);
  const double cloud = 0.3 * Fractal(p * 8, 2, kShared + 71, 8) +
                       0.8 * plan_.clumps * Inside(p) * Fractal(p * 4.1, 3, plan_.seed + 61);
  Color color = Mix({0.74, 0.64, 0.46}, {0.86, 0.77, 0.59}, SmoothStep(-0.9, 0.9, cloud));
  // Here and there the wind has left no ripples.
  const double calm = Inside(p) * SmoothStep(-0.3, 0.4, Fractal(p * 3.7, 2, plan_.seed + 71));
  color = color * (0.965 + 0.055 * Mix(ripple, 0.5, 0.8 * calm) + 0.07 * grain);
  const Cell speck = Cells(p * 40, kShared + 81, 40);
  return speck.value > 0.88
             ? Mix(color, {0.47, 0.38, 0.28}, 0.6 * SmoothStep(0.38, 0.2, speck.nearest))
             : color;
}

// Of the shared meadow if it reaches over an edge of the tile, of the tile's own if not.
void Ground::LayBlade(Point at, int x, int y, int layer, bool is_shared) {
  const uint32_t seed =
      (is_shared ? kShared : plan_.seed) + 1000 + static_cast<uint32_t>(100 * layer);
  const Point wind{1.1 * Noise(at * 6, kShared + 91, 6) + 0.25,
                   1.1 * Noise(at * 6, kShared + 101, 6) - 0.35};
  const Point along = Unit(Direction(x, y, seed + 3) * 0.9 + wind);
  const double sand = Sand(at, is_shared);
  const double lush = SmoothStep(0.55, 0.25, sand);  // grass is short where it meets the sand
  const double length = (0.042 + 0.043 * Random(x, y, seed + 5)) * (0.55 + 0.45 * lush);
  const double width = 0.0042 + 0.0028 * Random(x, y, seed + 6);
  const Point tip = at + along * length;
  const double bend = 0.22 * length * (2 * Random(x, y, seed + 10) - 1);
  const double reach = std::min(FromEdge(at), FromEdge(tip)) - width - std::fabs(bend);
  if ((reach < kRim) != is_shared) return;
  if (sand > 0.5 + 0.10 * Random(x, y, seed + 1)) return;
  if (!is_shared && Bare(at) > 0.25 + 0.75 * Random(x, y, seed + 2)) return;
  const double tone =
      Clamp(0.42 + 0.45 * Clump(at, is_shared) + 0.55 * (Random(x, y, seed + 7) - 0.5), 0, 1);
  const double depth = 0.72 + 0.20 * layer;  // what lies deep is in the dark
  const Color green = tone < 0.5 ? Mix({0.18, 0.30, 0.09}, {0.35, 0.48, 0.15}, 2 * tone)
                                 : Mix({0.35, 0.48, 0.15}, {0.58, 0.65, 0.26}, 2 * tone - 1);
  const double tuft = is_shared ? 0 : Spots(at, plan_.dry, 81);
  const double straw = Mix(plan_.straw, 0.82, tuft) + 0.25 * (1 - lush);
  const bool is_dry = Random(x, y, seed + 8) < straw;
  const Color yellow = Mix({0.58, 0.52, 0.23}, {0.82, 0.75, 0.42}, Random(x, y, seed + 9));
  const Color color = (is_dry ? yellow : green) * depth;
  canvas_.Stroke(at, tip, bend, width, color * 0.74, color * 1.18);
}

// One layer of grass, in an order that has nothing to do with where a blade stands. Shared blades
// of the tiles around reach into this one, too.
void Ground::LayBlades(int across, int layer) {
  const int count = across * across;
  for (int i = 0; i < count; ++i) {
    const int shuffled = static_cast<int>(int64_t{i} * 7919 % count);
    const int x = shuffled % across;
    const int y = shuffled / across;
    const auto place = [&](uint32_t seed) {
      seed += 1000 + static_cast<uint32_t>(100 * layer);
      return Point{(x + Random(x, y, seed + 20)) / across, (y + Random(x, y, seed + 21)) / across};
    };
    const Point common = place(kShared);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Point moved{common.x + dx, common.y + dy};
        if (FromEdge(moved) > -kBorder) LayBlade(moved, x, y, layer, true);
      }
    }
    LayBlade(place(plan_.seed), x, y, layer, false);
  }
}

// Scattered inside, none on another, small ones more often, here denser and there, where the ground
// is as sandy as asked: up to 0.3 of it wrong.
void Ground::LayThings(int count, double size, uint32_t kind, double sand,
                       void (*lay)(Canvas&, Point, double, uint32_t)) {
  const uint32_t seed = plan_.seed + kind;
  int laid = 0;
  for (int attempt = 0; attempt < 40 * count && laid < count; ++attempt) {
    const double large = Random(attempt, 0, seed);
    const double own = size * (0.60 + 0.75 * large * large);
    const double margin = kRim + kThingReach * own;
    const Point at{Mix(margin, 1 - margin, Random(attempt, 1, seed)),
                   Mix(margin, 1 - margin, Random(attempt, 2, seed))};
    const bool is_free = std::none_of(taken_.begin(), taken_.end(), [&](Point other) {
      return Length(at - other) < 0.9 * (own + size);
    });
    const double crowd = SmoothStep(-0.35, 0.25, Fractal(at * 3.1, 2, plan_.seed + 91));
    if (!is_free || std::fabs(Sand(at) - sand) > 0.3) continue;
    if (Random(attempt, 3, seed) > 0.15 + 0.85 * crowd) continue;
    taken_.push_back(at);
    lay(canvas_, at, own, seed + static_cast<uint32_t>(100 * attempt));
    ++laid;
  }
}

Picture Ground::Paint() {
  canvas_.Fill([this](Point p) {
    const double sand = SmoothStep(0.47, 0.53, Sand(p));
    return sand > 0 ? Mix(Soil(p), Beach(p), sand) : Soil(p);
  });
  LayBlades(31, 0);
  LayThings(plan_.stones, plan_.stone_size, 12000, 0, LayStone);
  LayBlades(31, 1);
  LayThings(plan_.mosses, 0.095, 11000, 0, LayMoss);
  LayThings(plan_.twigs, 0.085, 13000, 0, LayTwig);
  LayThings(plan_.clovers, 0.032, 14000, 0, LayClover);
  LayBlades(23, 2);
  LayThings(plan_.poppies, 0.031, 15000, 0, LayPoppy);
  LayThings(plan_.daisies, 0.024, 16000, 0, LayDaisy);
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
  plan.clumps = 1.1;
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
  return Coarse(Sheet(4, tiles));
}

Picture MakeLandscape() {
  std::vector<Picture> tiles;
  for (int i = 0; i < 16; ++i) {
    Plan plan = MeadowPlan(20 + i);
    const int kind = i / 4;
    plan.straw = 0.27;
    if (kind == 1) {
      plan.poppies = 36 + 2 * (i % 4);
      plan.daisies = 9 - 2 * (i % 4);
    } else if (kind == 2) {
      plan.dry = 0.50 + 0.05 * (i % 4);
      plan.clovers = 0;
    } else if (kind == 3) {
      plan.bare = 0.34 + 0.03 * (i % 4);
      plan.stones = 48 + 2 * (i % 4);
      plan.stone_size = 0.040 - 0.002 * (i % 4);
      plan.clovers = 0;
    }
    tiles.push_back(PaintGround(plan));
  }
  return Coarse(Sheet(4, tiles));
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
  return Coarse(Sheet(6, tiles));
}

}  // namespace texgraph::pictures
