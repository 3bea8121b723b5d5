// SPDX-License-Identifier: Apache-2.0
// Small beasts seen from above, heading up: two ladybirds, a rose chafer and an ant.
#include <algorithm>
#include <cmath>

#include "graphs/pictures/canvas.h"

namespace texgraph::pictures {

namespace {

constexpr Color kBlack{0.075, 0.07, 0.075};

// Light on a smooth dome, with a gleam; p in units of its half axes.
Color Shell(Color color, Point p, double gloss) {
  const double z = std::sqrt(std::max(0.0, 1 - Dot(p, p)));
  const double light = 0.55 + 0.50 * Clamp(-0.45 * p.x - 0.55 * p.y + 0.70 * z, -0.5, 1);
  const double gleam = gloss * SmoothStep(0.30, 0.06, Length(p - Point{-0.32, -0.42}));
  return Mix(color * light, {1, 0.98, 0.95}, 0.75 * gleam);
}

void LayDome(Canvas& canvas, Point at, Point size, Color color, double gloss) {
  canvas.Stamp(at, std::max(size.x, size.y), [&](Point p) {
    const Point local{p.x / size.x, p.y / size.y};
    return Surface{Shell(color, local, gloss), Length(local) < 1 ? 1.0 : 0.0};
  });
}

// A leg with a knee, and its mirror image.
void LayLegs(Canvas& canvas, Point hip, Point knee, Point foot, double width, Color color) {
  for (double side : {-1.0, 1.0}) {
    const auto place = [&](Point p) { return Point{0.5 + side * p.x, p.y}; };
    canvas.Stroke(place(hip), place(knee) + (place(knee) - place(hip)) * 0.3, 0, width, color,
                  color);
    canvas.Stroke(place(knee), place(foot), 0, 0.75 * width, color, color);
  }
}

void LayGround(Canvas& canvas, Point size) {
  canvas.Spot({0.515, 0.545}, {1, 0}, size, {0.02, 0.02, 0.02}, 0.45, 0.6);
}

Picture PaintLadybird(Color shell, int spots) {
  Canvas canvas(128, 128);
  LayGround(canvas, {0.38, 0.44});
  for (double y : {0.36, 0.52, 0.68}) {
    LayLegs(canvas, {0.20, y}, {0.34, y - 0.03}, {0.41, y + 0.05}, 0.020, kBlack);
  }
  for (double side : {-1.0, 1.0}) {
    canvas.Stroke({0.5 + side * 0.05, 0.16}, {0.5 + side * 0.13, 0.05}, side * 0.02, 0.012, kBlack,
                  kBlack);
  }
  LayDome(canvas, {0.5, 0.19}, {0.105, 0.085}, kBlack, 0.5);
  LayDome(canvas, {0.5, 0.27}, {0.185, 0.115}, kBlack, 0.5);
  for (double side : {-1.0, 1.0}) {
    canvas.Spot({0.5 + side * 0.115, 0.245}, {1, 0}, {0.045, 0.040}, {0.93, 0.90, 0.82}, 1, 0.3);
  }
  const Point size{0.315, 0.345};
  canvas.Stamp({0.5, 0.58}, 0.35, [&](Point p) {
    const Point local{p.x / size.x, p.y / size.y};
    const bool inside = Length(local) < 1 && local.y > -0.92;
    double dark = SmoothStep(0.022, 0.010, std::fabs(local.x));  // where the wings meet
    const auto dot = [&](double x, double y, double radius) {
      const double distance = Length({std::fabs(local.x) - x, local.y - y});
      dark = std::max(dark, SmoothStep(radius, radius - 0.05, distance));
    };
    if (spots == 7) {
      dot(0.0, -0.72, 0.22);
      dot(0.44, -0.30, 0.19);
      dot(0.68, 0.18, 0.15);
      dot(0.33, 0.45, 0.20);
    } else {
      for (int i = 0; i < spots / 2; ++i) {
        constexpr Point kSpots[11] = {{0.28, -0.78}, {0.62, -0.55}, {0.25, -0.42}, {0.78, -0.18},
                                      {0.48, -0.15}, {0.20, -0.02}, {0.72, 0.22},  {0.44, 0.26},
                                      {0.20, 0.42},  {0.52, 0.58},  {0.24, 0.76}};
        dot(kSpots[i].x, kSpots[i].y, 0.115);
      }
    }
    const Color color = Mix(shell, kBlack, 0.96 * dark);
    return Surface{Shell(color, local, 0.9), inside ? 1.0 : 0.0};
  });
  return canvas.Finish(shell * 0.5);
}

Picture PaintChafer() {
  const Color green{0.26, 0.55, 0.16};
  Canvas canvas(128, 128);
  LayGround(canvas, {0.34, 0.43});
  LayLegs(canvas, {0.15, 0.33}, {0.29, 0.26}, {0.36, 0.16}, 0.024, {0.13, 0.20, 0.10});
  LayLegs(canvas, {0.20, 0.52}, {0.35, 0.52}, {0.41, 0.63}, 0.024, {0.13, 0.20, 0.10});
  LayLegs(canvas, {0.18, 0.66}, {0.32, 0.72}, {0.37, 0.87}, 0.026, {0.13, 0.20, 0.10});
  for (double side : {-1.0, 1.0}) {
    canvas.Stroke({0.5 + side * 0.07, 0.12}, {0.5 + side * 0.15, 0.05}, 0, 0.016, kBlack, kBlack);
  }
  LayDome(canvas, {0.5, 0.15}, {0.10, 0.085}, green * 0.8, 0.4);
  LayDome(canvas, {0.5, 0.27}, {0.195, 0.125}, green, 0.6);
  const Point size{0.265, 0.330};
  canvas.Stamp({0.5, 0.60}, 0.34, [&](Point p) {
    const Point local{p.x / size.x, p.y / size.y};
    const double across = std::fabs(local.x);
    const double seam = SmoothStep(0.030, 0.012, across);
    const double plate = SmoothStep(0.0, 0.05, 0.24 - across - 0.75 * (local.y + 0.95));
    const double sheen =
        SmoothStep(-0.5, 0.7, local.x * 0.8 - local.y + 0.3 * Noise(local * 3, 7001));
    Color color = Mix(green, {0.44, 0.60, 0.12}, sheen);
    color = Mix(color, {0.62, 0.50, 0.16}, 0.55 * SmoothStep(0.55, 0.95, Length(local)));
    color = color * (1 - 0.65 * seam * (1 - plate));
    const double fleck = Noise({11 * across, 11 * local.y}, 7011);
    color = Mix(color, {0.90, 0.90, 0.78},
                0.8 * SmoothStep(0.36, 0.45, fleck) * SmoothStep(0.0, 0.3, local.y));
    return Surface{Shell(color, local, 0.9), Length(local) < 1 && local.y > -0.94 ? 1.0 : 0.0};
  });
  return canvas.Finish(green * 0.5);
}

Picture PaintAnt() {
  const Color brown{0.36, 0.17, 0.08};
  const Color dark{0.17, 0.09, 0.06};
  Canvas canvas(128, 128);
  canvas.Spot({0.512, 0.70}, {1, 0}, {0.17, 0.24}, {0.02, 0.02, 0.02}, 0.40, 0.6);
  canvas.Spot({0.512, 0.36}, {1, 0}, {0.14, 0.20}, {0.02, 0.02, 0.02}, 0.35, 0.6);
  LayLegs(canvas, {0.05, 0.38}, {0.23, 0.30}, {0.33, 0.14}, 0.016, dark);
  LayLegs(canvas, {0.05, 0.43}, {0.26, 0.44}, {0.40, 0.50}, 0.016, dark);
  LayLegs(canvas, {0.05, 0.48}, {0.23, 0.62}, {0.35, 0.84}, 0.016, dark);
  for (double side : {-1.0, 1.0}) {
    canvas.Stroke({0.5 + side * 0.05, 0.17}, {0.5 + side * 0.17, 0.14}, 0, 0.013, dark, dark);
    canvas.Stroke({0.5 + side * 0.15, 0.145}, {0.5 + side * 0.20, 0.02}, 0, 0.012, dark, dark);
    canvas.Stroke({0.5 + side * 0.05, 0.13}, {0.5 + side * 0.01, 0.065}, side * 0.015, 0.020, dark,
                  dark);
  }
  LayDome(canvas, {0.5, 0.73}, {0.135, 0.20}, dark, 0.8);
  for (double y : {0.68, 0.76, 0.84}) {
    canvas.Spot({0.5, y}, {1, 0}, {0.11, 0.010}, {0.42, 0.28, 0.18}, 0.35, 0.8);
  }
  LayDome(canvas, {0.5, 0.535}, {0.042, 0.040}, brown, 0.3);
  LayDome(canvas, {0.5, 0.42}, {0.075, 0.115}, brown, 0.6);
  LayDome(canvas, {0.5, 0.21}, {0.120, 0.110}, brown, 0.7);
  for (double side : {-1.0, 1.0}) {
    LayDome(canvas, {0.5 + side * 0.088, 0.20}, {0.024, 0.030}, kBlack, 0.9);
  }
  return canvas.Finish(dark);
}

}  // namespace

Picture MakeInsects() {
  return Sheet(2, {PaintLadybird({0.86, 0.13, 0.07}, 7), PaintLadybird({0.95, 0.79, 0.16}, 22),
                   PaintChafer(), PaintAnt()});
}

}  // namespace texgraph::pictures
