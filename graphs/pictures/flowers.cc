// SPDX-License-Identifier: Apache-2.0
// Single flowers, to be scattered, and a map of where they grow. All flowers lie inside of the
// circle in the picture, their shadows too, so that they may be turned.
#include <algorithm>
#include <cmath>

#include "graphs/pictures/canvas.h"
#include "graphs/pictures/things.h"

namespace texgraph::pictures {

namespace {

constexpr Point kMiddle{0.5, 0.5};

void LayFlowerShadow(Canvas& canvas, double size) {
  canvas.Spot({0.53, 0.55}, {1, 0}, {size, size}, {0.05, 0.06, 0.03}, 0.4, 0.55);
}

// Eight funnels with toothed rims around a dark heart of threads.
void LayCornflower(Canvas& canvas, double size) {
  LayFlowerShadow(canvas, 0.97 * size);
  Point along{0.98, 0.2};
  for (int i = 0; i < 8; ++i, along = Turned(Unit(along), {0.70710678, -0.70710678})) {
    const double reach = size * (0.94 + 0.12 * Random(i, 0, 5101));
    const double shade = 0.84 + 0.2 * Random(i, 1, 5101);
    canvas.Stamp(kMiddle, 1.1 * reach, [&](Point p) {
      const Point local = Turned(p, Unit(along)) * (1 / reach);
      const double half = 0.045 + 0.33 * SmoothStep(0.35, 1.0, local.x);
      const double tooth = std::fabs(4.5 * local.y - std::floor(4.5 * local.y) - 0.5);
      const bool inside = local.x > 0.15 && std::fabs(local.y) < half &&
                          local.x < 1.0 - 0.34 * tooth - 0.5 * local.y * local.y;
      const double rib = Noise({2 * local.x, 22 * local.y}, 5111 + static_cast<uint32_t>(i));
      const Color color = Mix({0.16, 0.17, 0.62}, {0.36, 0.47, 0.95}, local.x);
      return Surface{color * (shade + 0.14 * rib - 0.12 * Dot(p, {0.55, 0.83}) / reach),
                     inside ? 1.0 : 0.0};
    });
  }
  for (int i = 0; i < 26; ++i) {
    const Point way = Direction(i, 3, 5121) * (size * (0.2 + 0.28 * Random(i, 4, 5121)));
    canvas.Stroke(kMiddle, kMiddle + way, 0.01, 0.012, {0.22, 0.08, 0.34}, {0.55, 0.25, 0.66});
  }
}

// Five round glossy petals, and threads around a green middle.
void LayButtercup(Canvas& canvas, double size) {
  LayFlowerShadow(canvas, 1.02 * size);
  Point along{0.2, 0.98};
  for (int i = 0; i < 5; ++i, along = Turned(Unit(along), {0.30901699437, -0.95105651630})) {
    canvas.Stamp(kMiddle + Unit(along) * (0.53 * size), 0.55 * size, [&](Point p) {
      const Point local = Turned(p, Unit(along)) * (1 / size);
      const double distance = Length({local.x / 0.47, local.y / 0.46});
      const double gloss = SmoothStep(0.2, 0.05, Length(local - Point{0.12, 0.1}));
      const double vein = Noise({2 * local.x, 18 * local.y}, 5201 + static_cast<uint32_t>(i));
      const double light = 0.86 + 0.1 * local.x + 0.06 * vein - 0.2 * Dot(p, {0.55, 0.83}) / size;
      return Surface{Mix(Color{0.98, 0.80, 0.06} * light, {1.0, 0.95, 0.62}, 0.3 * gloss),
                     distance < 1 ? 1.0 : 0.0};
    });
  }
  for (int i = 0; i < 30; ++i) {
    const Point way = Direction(i, 5, 5221) * (size * (0.22 + 0.16 * Random(i, 6, 5221)));
    canvas.Stroke(kMiddle, kMiddle + way, 0.004, 0.006, {0.72, 0.55, 0.05}, {0.93, 0.75, 0.15});
    canvas.Spot(kMiddle + way, {1, 0}, {0.014, 0.014}, {0.86, 0.62, 0.06}, 1);
  }
  canvas.Spot(kMiddle, {1, 0}, {0.17 * size, 0.17 * size}, {0.48, 0.56, 0.12}, 1, 0.4);
}

// From 0 to 1 and back, once a unit.
double Winding(double x) {
  const double t = x - std::floor(x);
  return SmoothStep(0, 1, t < 0.5 ? 2 * t : 2 - 2 * t);
}

uint8_t ShareByte(double value) { return static_cast<uint8_t>(255 * Clamp(value, 0, 1) + 0.5); }

}  // namespace

Picture MakeDaisy() {
  Canvas canvas(128, 128);
  LayDaisy(canvas, kMiddle, 0.36, 3);
  return canvas.Finish({0.05, 0.06, 0.03});
}

Picture MakeFlowers() {
  const Color backdrop{0.05, 0.06, 0.03};
  Canvas daisy(96, 96), buttercup(96, 96), poppy(96, 96), cornflower(96, 96);
  LayDaisy(daisy, kMiddle, 0.36, 7);
  LayButtercup(buttercup, 0.37);
  LayPoppy(poppy, kMiddle, 0.36, 12);
  LayCornflower(cornflower, 0.44);
  return Sheet(4, {daisy.Finish(backdrop), buttercup.Finish(backdrop), poppy.Finish(backdrop),
                   cornflower.Finish(backdrop)});
}

// Red: small flowers; green: poppies; blue: cornflowers. Nothing grows on a path from the lower to
// the upper side. The map repeats.
Picture MakeFlowerBeds() {
  constexpr int kSide = 64;
  Picture map{kSide, kSide, false, {}};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const Point p{(x + 0.5) / kSide, (y + 0.5) / kSide};
      const double middle = 0.34 + 0.32 * Winding(p.y) + 0.02 * Noise(p * 8, 5301, 8);
      const double free = SmoothStep(0.06, 0.10, std::fabs(p.x - middle));
      const double cloud = Fractal(p * 3, 3, 5311, 3);
      const double other = Fractal(p * 4, 3, 5321, 4);
      map.pixels.push_back(ShareByte(free * SmoothStep(-0.35, 0.1, -cloud)));
      map.pixels.push_back(ShareByte(free * SmoothStep(-0.02, 0.3, cloud)));
      map.pixels.push_back(ShareByte(free * SmoothStep(0.0, 0.25, other)));
    }
  }
  return map;
}

}  // namespace texgraph::pictures
