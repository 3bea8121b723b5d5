// SPDX-License-Identifier: Apache-2.0
// Samples for tiling by example: a lawn, and gravel with its relief. They repeat without a seam,
// and each has a few things that everybody notices, so that a plain repetition is seen at once.
// Grass, dry grass and earth have nothing that stands out: of them tiles are made.
#include <cmath>
#include <functional>

#include "graphs/pictures/things.h"

namespace texgraph::pictures {

namespace {

constexpr uint32_t kLawn = 700000;
constexpr uint32_t kGravel = 710000;
constexpr uint32_t kEarth = 730000;

constexpr Color kDarkSoil{0.13, 0.15, 0.06};
constexpr Color kLightSoil{0.27, 0.23, 0.12};

// Lays a thing, and what of it comes in again on the other side.
template <typename Lay>
void LayAround(Point at, double reach, const Lay& lay) {
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const Point moved{at.x + dx, at.y + dy};
      if (moved.x > -reach && moved.x < 1 + reach && moved.y > -reach && moved.y < 1 + reach) {
        lay(moved);
      }
    }
  }
}

// Where the grass is dry: one large spot and some small ones.
double Dryness(Point p) {
  const double clouds = Fractal(p * 4, 4, kLawn + 11, 4);
  const Point from{p.x - 0.30, p.y - 0.62};
  const double spot = SmoothStep(0.21, 0.06, Length(from) + 0.06 * clouds);
  return Clamp(0.95 * spot + 0.75 * SmoothStep(0.28, 0.75, clouds), 0, 1);
}

void LaySoil(Canvas& canvas, Color dark, Color light) {
  canvas.Fill([=](Point p) {
    const double crumb = Fractal(p * 24, 3, kLawn + 1, 24);
    return Mix(dark, light, SmoothStep(-0.5, 0.6, crumb));
  });
}

struct Turf {
  std::function<double(Point)> dryness;
  double straw = 0;   // the share of blades that are dry anywhere
  double clumps = 1;  // how much lighter and darker parts differ
};

void LayBlades(Canvas& canvas, int across, int layer, const Turf& turf) {
  const uint32_t seed = kLawn + 1000 + static_cast<uint32_t>(100 * layer);
  for (int i = 0; i < across * across; ++i) {
    const int shuffled = static_cast<int>(int64_t{i} * 7919 % (across * across));
    const int x = shuffled % across;
    const int y = shuffled / across;
    const Point at{(x + Random(x, y, seed)) / across, (y + Random(x, y, seed + 1)) / across};
    const double dry = turf.dryness(at);
    const double length = (0.030 + 0.040 * Random(x, y, seed + 2)) * (1 - 0.35 * dry);
    const Point along = Direction(x, y, seed + 3);
    const double bend = 0.25 * length * (2 * Random(x, y, seed + 4) - 1);
    const double width = 0.0032 + 0.0024 * Random(x, y, seed + 5);
    const double clump = Fractal(at * 7, 3, kLawn + 21, 7);
    const double tone =
        Clamp(0.45 + 0.5 * turf.clumps * clump + 0.6 * (Random(x, y, seed + 6) - 0.5), 0, 1);
    const Color green = Mix({0.15, 0.30, 0.08}, {0.47, 0.62, 0.20}, tone);
    const Color straw = Mix({0.55, 0.48, 0.22}, {0.83, 0.76, 0.46}, Random(x, y, seed + 7));
    const bool is_dry = Random(x, y, seed + 8) < turf.straw + 0.85 * dry;
    const Color color = (is_dry ? straw : green) * (0.70 + 0.15 * layer);
    LayAround(at, 0.08, [&](Point foot) {
      canvas.Stroke(foot, foot + along * length, bend, width, color * 0.70, color * 1.18);
    });
  }
}

// Flowers in one corner of the lawn, and a clover here and there.
void LayFlowers(Canvas& canvas) {
  for (int i = 0; i < 9; ++i) {
    const Point away = Direction(i, 0, kLawn + 31) * (0.17 * std::sqrt(Random(i, 1, kLawn + 31)));
    const double size = 0.020 + 0.010 * Random(i, 2, kLawn + 31);
    const uint32_t seed = kLawn + 40000 + static_cast<uint32_t>(100 * i);
    LayAround(Point{0.76, 0.27} + away, 0.05, [&](Point at) { LayDaisy(canvas, at, size, seed); });
  }
  for (int i = 0; i < 14; ++i) {
    const Point place{Random(i, 0, kLawn + 41), Random(i, 1, kLawn + 41)};
    if (Dryness(place) > 0.4) continue;
    const uint32_t seed = kLawn + 50000 + static_cast<uint32_t>(100 * i);
    LayAround(place, 0.05, [&](Point at) { LayClover(canvas, at, 0.024, seed); });
  }
}

// ---- Earth: clods and crumbs, small stones, a blade here and there.

void LayCrumbs(Canvas& canvas) {
  canvas.Fill([](Point p) {
    const double clod = Fractal(p * 22, 3, kEarth + 1, 22);
    const double crumb = Fractal(p * 38, 3, kEarth + 2, 38);
    const double tone = Clamp(0.5 + 0.45 * clod + 0.55 * crumb, 0, 1);
    return Mix({0.23, 0.17, 0.11}, {0.53, 0.42, 0.29}, tone);
  });
}

void LayStones(Canvas& canvas) {
  for (int i = 0; i < 1000; ++i) {
    const auto random = [&](int which) { return Random(i, which, kEarth + 11); };
    const Point place{random(0), random(1)};
    const double size = 0.0030 + 0.0150 * random(2) * random(2) * random(3);
    const Point along = Direction(i, 4, kEarth + 11);
    const Point sizes{size, size * (0.6 + 0.35 * random(5))};
    const Color color = Mix({0.36, 0.31, 0.25}, {0.66, 0.60, 0.52}, random(6));
    const Point away{0.0013 + 0.1 * size, 0.0016 + 0.12 * size};
    LayAround(place, 0.03, [&](Point at) {
      canvas.Spot(at + away, along, sizes * 1.12, {0.12, 0.09, 0.06}, 0.7, 0.4);
      canvas.Spot(at, along, sizes, color * 0.85, 1, 0.15);
      canvas.Spot(at - away * 0.6, along, sizes * 0.6, color * 1.15, 0.8, 0.8);
    });
  }
}

void LayTufts(Canvas& canvas) {
  for (int i = 0; i < 170; ++i) {
    const Point place{Random(i, 0, kEarth + 21), Random(i, 1, kEarth + 21)};
    const Point along = Direction(i, 2, kEarth + 21);
    const double length = 0.02 + 0.035 * Random(i, 3, kEarth + 21);
    const double bend = 0.3 * length * (2 * Random(i, 4, kEarth + 21) - 1);
    const Color color = Mix({0.33, 0.38, 0.15}, {0.70, 0.61, 0.36}, Random(i, 5, kEarth + 21));
    LayAround(place, 0.06, [&](Point foot) {
      canvas.Stroke(foot, foot + along * length, bend, 0.0026, color * 0.75, color);
    });
  }
}

// ---- Gravel: pebbles of two sizes, the large ones here and there over the small ones.

struct Pebble {
  double height = 0;
  double value = 0;   // a random number of its own
  double rim = 0;     // 0 at its rim and outside, to 1 well inside
  double hollow = 0;  // 0 on top of it, to 1 between pebbles
  bool is_large = false;
};

// Of a pattern with `across` pebbles in a row, each round where its neighbours leave it room.
// `radius` is in the unit of the pattern.
Pebble PebbleAt(Point p, int across, double radius, uint32_t seed) {
  p = p + Point{0.142, 0.098};  // few rims of pebbles lie on the picture's border
  const Point fine = p * (2.0 * across);
  const Point q{across * p.x + 0.16 * Noise(fine, seed + 7, 2 * across),
                across * p.y + 0.16 * Noise(fine, seed + 8, 2 * across)};
  const Cell cell = Cells(q, seed, across);
  // A rounded minimum of the distances to the neighbour and to the circle.
  const double border = Clamp(cell.border, 0, 1);
  const double circle = Clamp(1.3 * (radius - cell.nearest), 0, 1);
  const double inside = border * circle / std::sqrt(border * border + circle * circle + 1e-12);
  const double rim = Clamp(inside / 0.30, 0, 1);
  const double dome = std::sqrt(1 - (1 - rim) * (1 - rim));
  return {0.34 * dome / across, cell.value, rim, 1 - SmoothStep(0.0, 0.45, rim), false};
}

Pebble GravelAt(Point p) {
  Pebble small = PebbleAt(p, 17, 0.72, kGravel);
  const Pebble large = PebbleAt(p, 6, 0.53, kGravel + 100);
  if (large.value < 0.70) return small;
  // The large ones are sunk in a little; the small ones beside them lie lower, and in the dark.
  constexpr double kSunk = 0.30;
  if (large.rim > kSunk) {
    const double height = large.height - 0.6 * 0.34 / 6 * std::sqrt(1 - (1 - kSunk) * (1 - kSunk));
    return {height, large.value, large.rim, 0.45 * SmoothStep(0.55, kSunk, large.rim), true};
  }
  const double beside = SmoothStep(0.0, kSunk, large.rim);
  small.hollow = Clamp(small.hollow + 0.7 * beside, 0, 1);
  small.height *= 1 - 0.6 * beside;
  return small;
}

double GravelHeight(Point p) {
  return GravelAt(p).height + 0.0012 * Fractal(p * 40, 2, kGravel + 21, 40);
}

Surface GravelSurface(Point p) {
  const Pebble pebble = GravelAt(p);
  const double grain = Fractal(p * 48, 3, kGravel + 31, 48);
  const double vein = Fractal(p * 13, 3, kGravel + 41, 13);
  const double hue = pebble.value * 7 - std::floor(pebble.value * 7);
  const double tone = pebble.value * 31 - std::floor(pebble.value * 31);
  Color color = Mix({0.50, 0.48, 0.46}, {0.63, 0.55, 0.45}, hue) * (0.75 + 0.45 * tone);
  if (pebble.is_large) color = Mix(color, {0.62, 0.36, 0.27}, pebble.value > 0.86 ? 0.85 : 0.15);
  // One stone is white.
  if (pebble.is_large && pebble.value > 0.955) color = {0.93, 0.91, 0.86};
  color = Mix(color, {0.80, 0.77, 0.71}, 0.35 * SmoothStep(0.10, 0.45, vein));
  color = color * (1 + 0.14 * grain);
  return {Mix(color, {0.13, 0.115, 0.10}, 0.85 * pebble.hollow), 1};
}

}  // namespace

Picture MakeLawn() {
  Canvas canvas(256, 256);
  LaySoil(canvas, kDarkSoil, kLightSoil);
  for (int layer = 0; layer < 3; ++layer) LayBlades(canvas, 44, layer, {Dryness, 0.05});
  LayFlowers(canvas);
  return Coarse(canvas.FinishOpaque());
}

Picture MakeGrass() {
  Canvas canvas(256, 256);
  LaySoil(canvas, kDarkSoil, kLightSoil);
  const Turf turf{[](Point) { return 0.0; }, 0, 0};
  for (int layer = 0; layer < 3; ++layer) LayBlades(canvas, 44, layer, turf);
  return Coarse(canvas.FinishOpaque());
}

Picture MakeDryGrass() {
  Canvas canvas(256, 256);
  LaySoil(canvas, {0.29, 0.26, 0.13}, {0.44, 0.39, 0.21});
  const Turf turf{[](Point) { return 0.9; }, 0.04, 0};
  for (int layer = 0; layer < 3; ++layer) LayBlades(canvas, 40, layer, turf);
  return Coarse(canvas.FinishOpaque());
}

Picture MakeEarth() {
  Canvas canvas(256, 256);
  LayCrumbs(canvas);
  LayStones(canvas);
  LayTufts(canvas);
  return Coarse(canvas.FinishOpaque());
}

// Red, green and blue, side by side: what is of the first, second and third kind.
Picture MakeKinds() {
  return Paint(12, 4, false,
               {[](Point) { return 0.0; },
                [](Point p) {
                  return Surface{
                      {p.x < 1 ? 1.0 : 0.0, p.x >= 1 && p.x < 2 ? 1.0 : 0.0, p.x >= 2 ? 1.0 : 0.0}};
                },
                0});
}

Picture MakeGravel() {
  return Paint(256, 256, false, {[](Point) { return 0.0; }, GravelSurface, 0});
}

// From 0, the lowest place, to 1.
Picture MakeGravelHeight() {
  const auto grey = [](Point p) {
    const double height = Clamp(GravelHeight(p) / 0.035, 0, 1);
    return Surface{{height, height, height}, 1};
  };
  return Paint(256, 256, false, {[](Point) { return 0.0; }, grey, 0});
}

Picture MakeGravelRelief() { return PaintRelief(256, 256, {GravelHeight, nullptr}); }

}  // namespace texgraph::pictures
