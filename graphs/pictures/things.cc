// SPDX-License-Identifier: Apache-2.0
#include "graphs/pictures/things.h"

#include <algorithm>
#include <cmath>

namespace texgraph::pictures {

namespace {

constexpr Point kShadow{0.5547, 0.8321};  // away from the light

void LayShadow(Canvas& canvas, Point at, double size, double alpha) {
  canvas.Spot(at + kShadow * (0.22 * size), {1, 0}, {1.15 * size, 1.15 * size}, {0.05, 0.06, 0.03},
              alpha, 0.55);
}

// A round thing's brightness where its surface has the slope of a dome.
double Dome(Point p, double radius) {
  const double z = std::sqrt(std::max(0.0, 1 - Dot(p, p) / (radius * radius)));
  return 0.62 + 0.38 * Clamp((-0.48 * p.x - 0.62 * p.y) / radius + 0.62 * z, -0.6, 1);
}

// The direction after `along`, by a fraction 1 / count of a full turn. Two fixed angles do for all
// flowers; no machine has to agree with another about a cosine.
Point NextOf5(Point along) { return Turned(along, {0.30901699437, -0.95105651630}); }
Point NextOf11(Point along) { return Turned(along, {0.84125353283, -0.54064081745}); }
Point NextOf3(Point along) { return Turned(along, {-0.5, -0.86602540378}); }

}  // namespace

void LayStone(Canvas& canvas, Point at, double size, uint32_t seed) {
  LayShadow(canvas, at, size, 0.55);
  const Point along = Direction(0, 0, seed);
  const double flat = 0.68 + 0.27 * Random(1, 0, seed);
  const Color warm = Mix({0.52, 0.50, 0.46}, {0.64, 0.57, 0.47}, Random(2, 0, seed));
  const Color body =
      Mix(warm, {0.50, 0.48, 0.45}, Random(3, 0, seed)) * (0.85 + 0.3 * Random(4, 0, seed));
  canvas.Stamp(at, 1.2 * size, [&](Point p) {
    const Point turned = Turned(p, along);
    const Point local{turned.x / size, turned.y / (size * flat)};
    const double rough = Fractal({2.1 * local.x + 7, 2.1 * local.y + 3}, 3, seed + 11);
    const double radius = 0.92 + 0.16 * rough;
    const double distance = Length(local);
    const double grain = Fractal({9 * local.x, 9 * local.y}, 3, seed + 21);
    const double light = Dome(p, 1.08 * size) * (1 + 0.12 * rough + 0.10 * grain);
    const double speckle = SmoothStep(0.35, 0.6, Noise({14 * local.x, 14 * local.y}, seed + 31));
    return Surface{Mix(body, {0.78, 0.76, 0.70}, 0.25 * speckle) * (1.12 * light),
                   distance < radius ? 1.0 : 0.0};
  });
}

void LayPoppy(Canvas& canvas, Point at, double size, uint32_t seed) {
  LayShadow(canvas, at, size, 0.40);
  Point along = Direction(0, 0, seed);
  const Color red = Mix({0.76, 0.10, 0.07}, {0.88, 0.25, 0.10}, Random(1, 0, seed));
  for (int i = 0; i < 5; ++i, along = NextOf5(along)) {
    const double reach = size * (0.9 + 0.2 * Random(2, i, seed));
    const Point middle = at + along * (0.48 * reach);
    canvas.Stamp(middle, reach, [&](Point p) {
      const Point local = Turned(p, along);
      const double distance = Length({local.x / (0.52 * reach), local.y / (0.54 * reach)});
      const double t = Clamp(0.5 + local.x / reach, 0, 1);
      const double crease = Noise({5 * local.x / reach, 16 * local.y / reach}, seed + 41 + i);
      const double light = 0.60 + 0.48 * t + 0.16 * crease - 0.18 * Dot(p, kShadow) / reach;
      return Surface{red * light, distance < 0.95 + 0.12 * crease ? 1.0 : 0.0};
    });
  }
  canvas.Spot(at, {1, 0}, {0.30 * size, 0.30 * size}, {0.13, 0.07, 0.08}, 0.95, 0.5);
  canvas.Spot(at, {1, 0}, {0.13 * size, 0.13 * size}, {0.45, 0.48, 0.20}, 1, 0.4);
}

void LayDaisy(Canvas& canvas, Point at, double size, uint32_t seed) {
  LayShadow(canvas, at, size, 0.35);
  Point along = Direction(0, 0, seed);
  for (int i = 0; i < 11; ++i, along = NextOf11(along)) {
    const double reach = size * (0.88 + 0.22 * Random(2, i, seed));
    const double shade = 0.86 + 0.12 * Random(3, i, seed);
    canvas.Stamp(at + along * (0.58 * reach), 0.45 * reach, [&](Point p) {
      const Point local = Turned(p, along);
      const double distance = Length({local.x / (0.42 * reach), local.y / (0.155 * reach)});
      const double light = shade * (1.02 - 0.10 * std::fabs(local.y) / (0.15 * reach));
      return Surface{Color{0.97, 0.96, 0.92} * light, distance < 1 ? 1.0 : 0.0};
    });
  }
  canvas.Stamp(at, 0.32 * size, [&](Point p) {
    return Surface{Color{0.95, 0.76, 0.16} * Dome(p, 0.34 * size),
                   Length(p) < 0.30 * size ? 1.0 : 0.0};
  });
}

void LayClover(Canvas& canvas, Point at, double size, uint32_t seed) {
  LayShadow(canvas, at, size, 0.35);
  Point along = Direction(0, 0, seed);
  const Color green = Mix({0.17, 0.37, 0.12}, {0.28, 0.47, 0.17}, Random(1, 0, seed));
  for (int i = 0; i < 3; ++i, along = NextOf3(along)) {
    canvas.Stamp(at + along * (0.52 * size), 0.55 * size, [&](Point p) {
      const Point local = Turned(p, along) * (1 / size);
      const double notch = 0.10 * SmoothStep(0.14, 0.0, std::fabs(local.y));
      const bool inside = Length(local) < 0.49 - (local.x > 0 ? notch : 0);
      const double ring = SmoothStep(0.09, 0.03, std::fabs(Length(local) - 0.24));
      const double light = Dome(p, 0.6 * size) + 0.06;
      return Surface{Mix(green, {0.60, 0.70, 0.48}, 0.35 * ring) * light, inside ? 1.0 : 0.0};
    });
  }
}

void LayTwig(Canvas& canvas, Point at, double size, uint32_t seed) {
  const Point along = Direction(0, 0, seed);
  const Point side = Unit(along + Point{-along.y, along.x} * 0.9);
  const double bend = 0.16 * size * (2 * Random(1, 0, seed) - 1);
  const double width = 0.045 * size;
  const Color dark{0.20, 0.14, 0.09};
  const Color light{0.52, 0.42, 0.31};
  const Point offsets[2] = {kShadow * (0.10 * size), {0, 0}};
  for (int i = 0; i < 2; ++i) {
    const Point foot = at - along * size + offsets[i];
    const Color from = i == 0 ? Color{0.07, 0.07, 0.04} : dark;
    const Color to = i == 0 ? from : light;
    canvas.Stroke(foot, at + along * size + offsets[i], bend, width, from, to);
    canvas.Stroke(at + offsets[i], at + side * (0.62 * size) + offsets[i], 0.3 * bend, 0.7 * width,
                  from, to);
  }
}

void LayMoss(Canvas& canvas, Point at, double size, uint32_t seed) {
  canvas.Stamp(at, 1.3 * size, [&](Point p) {
    const double edge = Fractal({1.7 * p.x / size, 1.7 * p.y / size}, 3, seed + 51);
    const double depth = 1 - Length(p) / size + 0.45 * edge;
    const Cell tuft = Cells({34 * (at.x + p.x), 34 * (at.y + p.y)}, seed + 61);
    Color color = Mix({0.24, 0.30, 0.09}, {0.50, 0.53, 0.16}, tuft.value);
    color = color * (1.12 - 0.65 * SmoothStep(0.1, 0.8, tuft.nearest));
    return Surface{color, SmoothStep(0.05, 0.25, depth - 0.45 * tuft.nearest)};
  });
}

void LayShell(Canvas& canvas, Point at, double size, uint32_t seed) {
  LayShadow(canvas, at, size, 0.30);
  const Point along = Direction(0, 0, seed);
  const Color body = Mix({0.90, 0.82, 0.72}, {0.80, 0.62, 0.52}, Random(1, 0, seed));
  canvas.Stamp(at, 1.1 * size, [&](Point p) {
    const Point local = Turned(p, along) * (1 / size);
    const double fan = local.x + 0.9;  // from the hinge
    const double across = local.y / (0.25 + fan * 0.75);
    const bool inside = fan > 0 && Length({local.x * 0.95, local.y}) < 0.9;
    const double rib = 7 * across - std::floor(7 * across);
    const double light = (0.86 + 0.2 * std::fabs(rib - 0.5)) * Dome(p, 1.2 * size);
    const double band = 0.5 + 0.5 * Noise({3.2 * fan, 0.3 * across}, seed + 71);
    return Surface{Mix(body, {0.66, 0.46, 0.38}, 0.35 * band) * (1.12 * light), inside ? 1.0 : 0.0};
  });
}

}  // namespace texgraph::pictures
