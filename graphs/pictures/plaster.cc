// SPDX-License-Identifier: Apache-2.0
// An old plastered wall: the plaster itself, which repeats, and what happens to it: cracks, and
// holes where it fell off.
#include <cmath>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

// Strokes of the trowel, long and slightly bent, and sand.
double PlasterHeight(Point p) {
  double bend = 0.10 * Noise({3 * p.x, 3 * p.y}, 401, 3);
  double strokes = Fractal({2 * p.x, 9 * (p.y + bend)}, 3, 402, {2, 9});
  double waves = Fractal({3 * p.x, 3 * p.y}, 3, 411, 3);
  double sand = Noise({96 * p.x, 96 * p.y}, 421, 96);
  return 0.010 * strokes + 0.016 * waves + 0.0007 * sand;
}

// Layers of paint of about one tone, yellowed in clouds.
Surface PlasterSurface(Point p) {
  double cloud = Fractal({2 * p.x, 2 * p.y}, 5, 431, 2);
  double spots = Fractal({9 * p.x, 9 * p.y}, 4, 441, 9);
  Color color = Mix({0.80, 0.77, 0.70}, {0.72, 0.665, 0.565}, SmoothStep(-0.5, 0.7, cloud));
  color = Mix(color, {0.60, 0.545, 0.455}, 0.35 * SmoothStep(0.15, 0.9, spots + 0.3 * cloud));
  color = color * (0.985 + 0.05 * Noise({110 * p.x, 110 * p.y}, 451, 110));
  return {color, 1};
}

// A crack along x, from `from` to `to`: y = fall x + noise of its seed, moved so that it goes
// through its first point.
struct Path {
  Point from;
  double to = 0;
  double fall = 0;
  double width = 0;
  uint32_t seed = 0;

  double At(double x) const {
    double wander = Fractal({1.7 * x, 0.5}, 6, seed) - Fractal({1.7 * from.x, 0.5}, 6, seed);
    return from.y + fall * (x - from.x) + 0.30 * wander;
  }
};

// The distance from a crack in units of its width there, which tapers off.
double FromPath(Point p, const Path& path) {
  double t = (p.x - path.from.x) / (path.to - path.from.x);
  if (t <= 0 || t >= 1) {
    return 1e9;
  }
  double slope = (path.At(p.x + 0.004) - path.At(p.x - 0.004)) / 0.008;
  double distance = std::fabs(p.y - path.At(p.x)) / std::sqrt(1 + slope * slope);
  double ragged = 1 + 0.9 * Noise({26 * p.x, 26 * p.y}, path.seed + 20);
  double taper = SmoothStep(1, 0.4, t) * SmoothStep(0, 0.03, t);
  return distance / (path.width * ragged * taper + 1e-6);
}

// The crack is widest at one end and branches on its way; branches leave it forwards.
double Crack(Point p) {
  const Path trunk{{0.06, 0.40}, 1.95, 0.03, 0.0085, 501};
  double nearest = FromPath(p, trunk);
  auto branch = [&](const Path& path) {
    double distance = FromPath(p, path);
    nearest = distance < nearest ? distance : nearest;
  };
  branch({{0.48, trunk.At(0.48)}, 1.12, 0.42, 0.0060, 511});
  branch({{0.95, trunk.At(0.95)}, 1.52, -0.50, 0.0055, 521});
  branch({{0.26, trunk.At(0.26)}, 0.62, -0.55, 0.0048, 531});
  branch({{1.32, trunk.At(1.32)}, 1.74, 0.60, 0.0042, 541});
  return nearest;
}

double CrackCover(Point p) { return SmoothStep(1.7, 0.55, Crack(p)); }

double CrackHeight(Point p) { return -0.006 * SmoothStep(2.4, 0.6, Crack(p)); }

// How deep in a hole a point lies: 0 on the plaster, to 1 in the middle.
double HoleDepth(Point p) {
  double dx = (p.x - 0.5) / 0.49;
  double dy = (p.y - 0.5) / 0.48;
  double inside = 1 - std::sqrt(dx * dx + dy * dy);
  double coarse = Fractal({2.6 * p.x, 2.6 * p.y}, 2, 601);
  double ragged = Fractal({10 * p.x, 10 * p.y}, 4, 611);
  return Clamp(1.9 * (inside - 0.12 + 0.34 * coarse + 0.085 * ragged), 0, 1) *
         SmoothStep(0.0, 0.10, inside);
}

// The finish breaks off first, then the coat below it; behind that is the wall.
double HoleHeight(Point p) {
  double depth = HoleDepth(p);
  return -0.012 * SmoothStep(0.20, 0.28, depth) - 0.020 * SmoothStep(0.50, 0.60, depth) -
         0.006 * SmoothStep(0.0, 0.2, depth);
}

}  // namespace

Picture MakePlaster() {
  return Paint(256, 256, false, {[](Point) { return 0.0; }, PlasterSurface, 0});
}

Picture MakePlasterRelief() { return PaintRelief(256, 256, {PlasterHeight, nullptr}); }

Picture MakeCrack() { return PaintRelief(512, 256, {CrackHeight, CrackCover}); }

Picture MakeHole() { return PaintRelief(256, 256, {HoleHeight, HoleDepth}); }

}  // namespace texgraph::pictures
