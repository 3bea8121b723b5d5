// SPDX-License-Identifier: Apache-2.0
// Brick and mortar.
#include <cmath>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

// The brick lies in a picture of 2 to 1. Its coordinates: 1 is the picture's height.
constexpr double kBrickWidth = 2.0;
constexpr double kMargin = 0.075;  // half a joint
constexpr double kCorner = 0.06;

// How deep a point lies inside the face, negative outside: a rounded rectangle with a worn and
// chipped edge.
double Depth(Point p) {
  double dx = std::fabs(p.x - kBrickWidth / 2) - (kBrickWidth / 2 - kMargin - kCorner);
  double dy = std::fabs(p.y - 0.5) - (0.5 - kMargin - kCorner);
  double ox = dx > 0 ? dx : 0;
  double oy = dy > 0 ? dy : 0;
  double inner = dx > dy ? dx : dy;
  double distance = std::sqrt(ox * ox + oy * oy) + (inner < 0 ? inner : 0) - kCorner;
  double wear =
      0.020 * Fractal({4 * p.x, 4 * p.y}, 4, 11) + 0.006 * Noise({40 * p.x, 40 * p.y}, 15);
  Cell chip = Cells({3.2 * p.x + 0.3, 3.2 * p.y}, 21);
  double bite = chip.value < 0.35 ? 0.035 * SmoothStep(0.42, 0.1, chip.nearest) : 0;
  return -distance + wear - bite;
}

// Holes of different size where grains fell out, most of them small.
double Pits(Point p) {
  double depth = 0;
  for (int i = 0; i < 2; ++i) {
    double scale = i == 0 ? 6.5 : 24;
    Point q{scale * p.x + 0.30 * Noise({3 * scale * p.x, 3 * scale * p.y}, 33),
            1.5 * scale * p.y + 0.30 * Noise({3 * scale * p.x, 3 * scale * p.y}, 34)};
    Cell pit = Cells(q, 40 + 10 * static_cast<uint32_t>(i));
    double radius = pit.value < 0.78 ? 0 : 0.08 + 0.9 * (pit.value - 0.78);
    if (radius > 0) {
      depth += SmoothStep(radius, 0.3 * radius, pit.nearest) * radius / scale;
    }
  }
  return depth;
}

// Marks of the wire that cut the clay: long across, short up.
double Drag(Point p) {
  return Fractal({1.6 * p.x + 0.6 * p.y, 26 * p.y + 2.5 * Noise({2 * p.x, 2 * p.y}, 51)}, 3, 52);
}

double Bevel(double depth) {
  double t = Clamp(depth / 0.07, 0, 1);
  return 0.035 * t * (2 - t);
}

double BrickHeight(Point p) {
  double rough =
      0.016 * Fractal({5 * p.x, 5 * p.y}, 4, 61) + 0.0045 * Fractal({48 * p.x, 48 * p.y}, 2, 66);
  return Bevel(Depth(p)) + rough + 0.0040 * Drag(p) - 0.75 * Pits(p);
}

Surface BrickSurface(Point p) {
  double cloud = Fractal({1.7 * p.x + 5, 1.7 * p.y}, 4, 71);
  double blotch = Fractal({7 * p.x, 7 * p.y + 3}, 3, 76);
  Color color = Mix({0.575, 0.305, 0.235}, {0.72, 0.435, 0.325}, SmoothStep(-0.6, 0.6, cloud));
  color = Mix(color, {0.43, 0.225, 0.19}, 0.75 * SmoothStep(0.05, 0.8, blotch + 0.5 * Drag(p)));
  color = Mix(color, {0.76, 0.57, 0.46},
              0.5 * SmoothStep(0.15, 0.9, -blotch - 0.5 * Drag(p) - 0.3 * cloud));
  // One end lay nearer to the fire.
  color = Mix(color, {0.36, 0.205, 0.19},
              0.65 * SmoothStep(1.15, 1.95, p.x + 0.45 * cloud + 0.15 * blotch));
  Cell grain = Cells({60 * p.x, 60 * p.y}, 81);
  color = color * (0.92 + 0.16 * grain.value);
  Cell lime = Cells({30 * p.x + 0.4 * blotch, 30 * p.y}, 84);
  if (lime.value > 0.93) {
    double radius = 0.10 + 3 * (lime.value - 0.93);
    color = Mix(color, {0.82, 0.74, 0.65}, 0.65 * SmoothStep(radius, 0.4 * radius, lime.nearest));
  }
  Cell iron = Cells({19 * p.x, 19 * p.y}, 86);
  if (iron.value > 0.86) {
    double radius = 0.10 + 1.0 * (iron.value - 0.86);
    color = Mix(color, {0.21, 0.14, 0.13}, 0.8 * SmoothStep(radius, 0.4 * radius, iron.nearest));
  }
  double depth = Depth(p);
  color = color * (1 - 18 * Clamp(Pits(p), 0, 0.03));
  double cement = SmoothStep(0.06, -0.01, depth + 0.03 * blotch);
  color = Mix(color, {0.66, 0.60, 0.53}, 0.55 * cement);
  color = color * (0.96 + 0.08 * Noise({90 * p.x, 90 * p.y}, 91));
  return {color, SmoothStep(-0.006, 0.010, depth)};
}

// Mortar repeats: all its patterns have a whole number of cells across the picture.

// A layer of grains: how much of a point one covers, and its random number.
struct Grain {
  double cover = 0;
  double value = 0;
};

Grain Grains(Point p, int cells, double share, uint32_t seed) {
  double scale = cells;
  Point q{scale * p.x + 0.25 * Noise({2 * scale * p.x, 2 * scale * p.y}, seed + 5, 2 * cells),
          scale * p.y + 0.25 * Noise({2 * scale * p.x, 2 * scale * p.y}, seed + 6, 2 * cells)};
  Cell cell = Cells(q, seed, cells);
  if (cell.value > share) {
    return {};
  }
  double t = cell.value / share;
  double radius = 0.18 + 0.30 * t;
  return {SmoothStep(radius, 0.7 * radius, cell.nearest), t};
}

double MortarHeight(Point p) {
  double rough = 0.020 * Fractal({8 * p.x, 8 * p.y}, 5, 111, 8) +
                 0.0030 * Noise({128 * p.x, 128 * p.y}, 117, 128);
  double sand = 0.0035 * Grains(p, 56, 0.5, 121).cover + 0.008 * Grains(p, 23, 0.22, 131).cover;
  return rough + sand - 0.010 * Grains(p, 19, 0.16, 141).cover;
}

Surface MortarSurface(Point p) {
  double cloud = Fractal({3 * p.x, 3 * p.y}, 5, 151, 3);
  double dust = Fractal({32 * p.x, 32 * p.y}, 3, 161, 32);
  Color color =
      Mix({0.55, 0.525, 0.49}, {0.73, 0.705, 0.66}, SmoothStep(-0.6, 0.6, cloud + 0.3 * dust));
  static constexpr Color kSand[6] = {{0.40, 0.36, 0.33}, {0.67, 0.57, 0.46}, {0.83, 0.80, 0.75},
                                     {0.52, 0.44, 0.37}, {0.60, 0.58, 0.56}, {0.75, 0.68, 0.58}};
  Grain fine = Grains(p, 56, 0.5, 121);
  color = Mix(color, kSand[static_cast<int>(fine.value * 37) % 6], 0.6 * fine.cover);
  Grain coarse = Grains(p, 23, 0.22, 131);
  color = Mix(color, kSand[static_cast<int>(coarse.value * 41) % 6], 0.75 * coarse.cover);
  color = color * (1 - 0.30 * Grains(p, 19, 0.16, 141).cover);
  color = color * (0.95 + 0.10 * Noise({160 * p.x, 160 * p.y}, 171, 160));
  return {color, 1};
}

}  // namespace

Picture MakeBrick(int height) {
  return Paint(2 * height, height, true, {BrickHeight, BrickSurface, 1.0});
}

Picture MakeBrickRelief() { return PaintRelief(256, 128, {BrickHeight, nullptr}); }

Picture MakeMortar(int height) {
  return Paint(height, height, false, {MortarHeight, MortarSurface, 1.0});
}

}  // namespace texgraph::pictures
