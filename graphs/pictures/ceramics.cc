// SPDX-License-Identifier: Apache-2.0
// Fired clay: a glazed floor tile with what feet did to it, and a roof tile. The alpha of a relief
// is the height as a share of the tile's.
#include <cmath>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

// The distance to the border of a rectangle with round corners, positive inside.
double RoundedInside(double dx, double dy, double corner) {
  double x = corner - dx > 0 ? corner - dx : 0;
  double y = corner - dy > 0 ? corner - dy : 0;
  double inner = dx < dy ? dx : dy;
  return (x > 0 && y > 0) ? corner - std::sqrt(x * x + y * y) : inner;
}

double GlazeInside(Point p) {
  double wave = 0.0030 * Fractal({5 * p.x, 5 * p.y}, 3, 801);
  double dx = 0.5 - std::fabs(p.x - 0.5) - 0.012;
  double dy = 0.5 - std::fabs(p.y - 0.5) - 0.012;
  return RoundedInside(dx, dy, 0.035) + wave;
}

double GlazeLevel(Point p) {
  double t = Clamp(GlazeInside(p) / 0.055, 0, 1);
  return std::sqrt(t * (2 - t));
}

// A pillow edge, and the glaze flowed unevenly.
double GlazeHeight(Point p) {
  Cell pin = Cells({13 * p.x, 13 * p.y}, 811);
  double hole = pin.value > 0.90 ? SmoothStep(0.11, 0.05, pin.nearest) : 0;
  return 0.030 * GlazeLevel(p) + 0.0045 * Fractal({2.5 * p.x, 2.5 * p.y}, 3, 821) - 0.0022 * hole;
}

// Bright, to be tinted: the glaze is thin and darker at the edge, with fine crackle.
Surface GlazeSurface(Point p) {
  double cloud = Fractal({2.2 * p.x, 2.2 * p.y}, 5, 831);
  double inside = GlazeInside(p);
  Point bent{7 * p.x + 0.35 * Noise({9 * p.x, 9 * p.y}, 841),
             7 * p.y + 0.35 * Noise({9 * p.x, 9 * p.y}, 842)};
  double crackle = SmoothStep(0.030, 0.012, Cells(bent, 843).border);
  Color color = Color{0.86, 0.86, 0.85} * (1 + 0.07 * cloud);
  color = color * (1 - 0.10 * crackle * SmoothStep(-0.3, 0.4, cloud));
  color = Mix(color, {0.62, 0.57, 0.50}, 0.75 * SmoothStep(0.038, 0.004, inside + 0.006 * cloud));
  Cell pin = Cells({13 * p.x, 13 * p.y}, 811);
  color = pin.value > 0.90 ? color * (1 - 0.55 * SmoothStep(0.11, 0.05, pin.nearest)) : color;
  return {color, SmoothStep(0, 0.010, inside)};
}

// Where the glaze is dull: worn clouds and scratches in all directions.
double Wear(Point p) {
  double worn = SmoothStep(-0.10, 0.55, Fractal({2.6 * p.x, 2.6 * p.y}, 5, 851));
  double scratch = 0;
  for (int i = 0; i < 26; ++i) {
    double angle_x = 2 * Random(i, 0, 861) - 1;
    double angle_y = 2 * Random(i, 1, 861) - 1;
    double length = std::sqrt(angle_x * angle_x + angle_y * angle_y) + 1e-6;
    double dx = p.x - Random(i, 2, 861);
    double dy = p.y - Random(i, 3, 861);
    double along = (angle_x * dx + angle_y * dy) / length;
    double across = (angle_x * dy - angle_y * dx) / length + 0.3 * along * along * angle_x;
    double reach = 0.08 + 0.22 * Random(i, 4, 861);
    double line = SmoothStep(0.0045, 0.0012, std::fabs(across)) *
                  SmoothStep(reach, 0.4 * reach, std::fabs(along));
    scratch = line > scratch ? line : scratch;
  }
  double edge = 0.5 - (std::fabs(p.x - 0.5) > std::fabs(p.y - 0.5) ? std::fabs(p.x - 0.5)
                                                                   : std::fabs(p.y - 0.5));
  return Clamp(0.75 * worn + 0.7 * scratch, 0, 1) * SmoothStep(0.004, 0.05, edge);
}

// A roof tile is 0.5 wide and 1 high, with a round lower end. The picture's top lies under the next
// row of tiles.
double RoofInside(Point p) {
  constexpr double kHalf = 0.237;
  double dx = kHalf - std::fabs(p.x - 0.25);
  double wave = 0.0025 * Fractal({6 * p.x, 6 * p.y}, 3, 901);
  constexpr double kRound = 0.30;  // radius of the lower end; its middle lies on the axis
  double top = p.y - 0.012;
  double ox = p.x - 0.25;
  double oy = p.y - (0.988 - kRound);
  double end = oy > 0 ? kRound - std::sqrt(ox * ox + oy * oy) : 1;
  double inside = dx < top ? dx : top;
  return (end < inside ? end : inside) + wave;
}

// The tile lies aslant, its lower end on the row below: higher towards the eye.
double RoofLevel(Point p) {
  double t = Clamp(RoofInside(p) / 0.016, 0, 1);
  return (0.12 + 0.80 * p.y) * std::sqrt(t * (2 - t));
}

double RoofHeight(Point p) {
  double x = (p.x - 0.25) / 0.25;
  double grain = Fractal({14 * p.x, 14 * p.y}, 4, 911);
  double strokes = Fractal({42 * p.x, 2.5 * p.y}, 2, 921);
  Cell pit = Cells({24 * p.x, 24 * p.y}, 931);
  double hole = pit.value > 0.86 ? SmoothStep(0.28, 0.10, pit.nearest) : 0;
  return 0.050 * RoofLevel(p) - 0.010 * x * x + 0.0022 * grain + 0.0009 * strokes - 0.0024 * hole;
}

Surface RoofSurface(Point p) {
  double cloud = Fractal({3.5 * p.x, 3.5 * p.y}, 5, 941);
  double strokes = Fractal({42 * p.x, 2.5 * p.y}, 2, 921);
  double dust = Fractal({30 * p.x, 30 * p.y}, 3, 951);
  Color color = Mix({0.66, 0.36, 0.24}, {0.78, 0.49, 0.34}, SmoothStep(-0.5, 0.6, cloud));
  color = Mix(color, {0.42, 0.25, 0.20}, 0.5 * SmoothStep(0.1, 0.8, dust - 0.4 * cloud));
  color = color * (1 + 0.06 * strokes);
  Cell lichen = Cells({15 * p.x + 0.4 * dust, 15 * p.y}, 961);
  if (lichen.value > 0.90) {
    double radius = 0.15 + 2.2 * (lichen.value - 0.90);
    color = Mix(color, {0.66, 0.64, 0.54}, 0.6 * SmoothStep(radius, 0.5 * radius, lichen.nearest));
  }
  // The rain washes the middle of what is seen; dirt stays along the sides.
  double inside = RoofInside(p);
  color = color * (1 - 0.30 * SmoothStep(0.05, 0.005, inside + 0.02 * cloud));
  // The two tiles of the row above keep the light from what lies close below their round ends.
  double ox = std::fabs(p.x - 0.25) - 0.25;
  double oy = p.y - 0.188;
  double from_above = std::sqrt(ox * ox + (oy > 0 ? oy * oy : 0)) - 0.30;
  color = color * (0.34 + 0.66 * SmoothStep(-0.01, 0.085, from_above + 0.01 * cloud));
  return {color, SmoothStep(0, 0.006, inside)};
}

double Flat(Point) { return 0; }

}  // namespace

Picture MakeGlaze() { return Paint(256, 256, true, {Flat, GlazeSurface, 0}); }

Picture MakeGlazeRelief() { return PaintRelief(256, 256, {GlazeHeight, GlazeLevel}); }

Picture MakeWear() {
  auto surface = [](Point p) { return Surface{{0.30, 0.27, 0.23}, Wear(p)}; };
  return Paint(256, 256, true, {Flat, surface, 0});
}

Picture MakeRoofTile() { return Paint(256, 512, true, {Flat, RoofSurface, 0}); }

Picture MakeRoofTileRelief() { return PaintRelief(256, 512, {RoofHeight, RoofLevel}); }

}  // namespace texgraph::pictures
