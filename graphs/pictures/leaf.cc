// SPDX-License-Identifier: Apache-2.0
// A leaf of ivy as a camera sees it on black cloth: without alpha, its rim mixed with the black.
#include <cmath>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

constexpr Point kFoot{0.5, 0.36};  // where the lobes and the stalk meet; the tip hangs down

// A lobe from the foot outwards: `along` is its direction, of length 1.
struct Lobe {
  Point along;
  double length;
  double width;  // half of it, where it is widest
};
constexpr Lobe kLobes[5] = {{{0, 1}, 0.60, 0.185},
                            {{0.9, 0.436}, 0.44, 0.135},
                            {{-0.9, 0.436}, 0.44, 0.135},
                            {{0.72, -0.694}, 0.34, 0.125},
                            {{-0.72, -0.694}, 0.34, 0.125}};

// How deep a point lies in the leaf, and how near to a vein, both in the unit of the picture.
struct Place {
  double depth = -1;
  double vein = 1;
};

Place Find(Point p) {
  double x = p.x - kFoot.x + 0.012 * Fractal({5 * p.x, 5 * p.y}, 3, 301);
  double y = p.y - kFoot.y + 0.012 * Fractal({5 * p.x, 5 * p.y}, 3, 304);
  Place place;
  for (const Lobe& lobe : kLobes) {
    double t = (x * lobe.along.x + y * lobe.along.y) / lobe.length;
    double across = std::fabs(x * lobe.along.y - y * lobe.along.x);
    double inside = Clamp(t, 0, 1);
    double depth = 2.6 * lobe.width * std::sqrt(inside) * (1 - inside) - across;
    if (t >= 0 && t <= 1 && depth > place.depth) {
      place.depth = depth;
    }
    // Side veins leave the middle one at 45 degrees.
    double ribs = (t * lobe.length - across) / 0.075;
    double rib = std::fabs(ribs - std::floor(ribs) - 0.5) * 0.075;
    if (t >= 0 && t <= 1 && depth > -0.02) {
      double nearest = across + 0.010 * t < rib + 0.008 ? across + 0.010 * t : rib + 0.008;
      place.vein = nearest < place.vein ? nearest : place.vein;
    }
  }
  double disc = 0.10 - std::sqrt(x * x + y * y);
  place.depth = disc > place.depth ? disc : place.depth;
  return place;
}

double LeafHeight(Point p) {
  Place place = Find(p);
  double bulge = 0.030 * SmoothStep(0.0, 0.07, place.depth);
  double furrow = 0.012 * SmoothStep(0.018, 0.0, place.vein);
  return bulge - furrow + 0.010 * Fractal({7 * p.x, 7 * p.y}, 3, 311);
}

Surface LeafSurface(Point p) {
  Place place = Find(p);
  double cloud = Fractal({4 * p.x, 4 * p.y}, 4, 321);
  Color color = Mix({0.20, 0.34, 0.13}, {0.36, 0.50, 0.20}, SmoothStep(-0.6, 0.6, cloud));
  color = Mix(color, {0.47, 0.42, 0.18}, 0.5 * SmoothStep(0.05, 0.0, place.depth + 0.02 * cloud));
  color = Mix(color, {0.66, 0.72, 0.46}, 0.8 * SmoothStep(0.014, 0.003, place.vein));
  color = color * (0.95 + 0.10 * Noise({60 * p.x, 60 * p.y}, 331));
  return {color * SmoothStep(-0.008, 0.008, place.depth), 1};
}

}  // namespace

Picture MakeLeafOnBlack() { return Paint(160, 160, false, {LeafHeight, LeafSurface, 0.8}); }

}  // namespace texgraph::pictures
