// SPDX-License-Identifier: Apache-2.0
// A door with four panels in its casing, and a window with six panes. The alpha of a relief is the
// height: 0 is the wall, about 0.4 the wood, and what stands out further is metal. Glass is the
// lowest.
#include <cmath>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

struct Box {
  Point low;
  Point high;
};

// The distance to the border of a box, positive inside.
double Inside(Point p, const Box& box) {
  double dx = p.x - box.low.x < box.high.x - p.x ? p.x - box.low.x : box.high.x - p.x;
  double dy = p.y - box.low.y < box.high.y - p.y ? p.y - box.low.y : box.high.y - p.y;
  return dx < dy ? dx : dy;
}

double Larger(double a, double b) { return a > b ? a : b; }

// A door is 0.5 wide and 1 high; the casing ends where the picture does, but for a margin.
constexpr Box kCasing{{0.012, 0.012}, {0.488, 0.988}};
constexpr Box kOpening{{0.060, 0.055}, {0.440, 1.2}};
constexpr Box kPanels[4] = {{{0.105, 0.100}, {0.238, 0.480}},
                            {{0.262, 0.100}, {0.395, 0.480}},
                            {{0.105, 0.590}, {0.238, 0.925}},
                            {{0.262, 0.590}, {0.395, 0.925}}};
constexpr Point kKnob{0.083, 0.540};

double FromKnob(Point p) {
  double dx = p.x - kKnob.x;
  double dy = p.y - kKnob.y;
  return std::sqrt(dx * dx + dy * dy);
}

// As a share of the relief's whole height. The foot of the door stands on the floor.
double DoorLevel(Point p) {
  double casing = Inside(p, kCasing);
  if (casing <= 0) {
    return 0;
  }
  double opening = Inside(p, kOpening);
  if (opening < 0) {  // the casing, with a step in its moulding
    return 0.46 * SmoothStep(0, 0.008, casing) - 0.10 * SmoothStep(0.018, 0.024, casing) +
           0.06 * SmoothStep(0.028, 0.036, casing) - 0.12 * SmoothStep(-0.008, 0, opening);
  }
  double level = 0.22 + 0.08 * SmoothStep(0.002, 0.006, opening);
  for (const Box& panel : kPanels) {
    double inside = Inside(p, panel);
    level += -0.16 * SmoothStep(0, 0.010, inside) + 0.12 * SmoothStep(0.016, 0.034, inside);
  }
  double knob = FromKnob(p) / 0.017;
  double rose = FromKnob(p) / 0.024;
  level = rose < 1 ? Larger(level, 0.62) : level;
  return knob < 1 ? 0.66 + 0.34 * std::sqrt(1 - knob * knob) : level;
}

double Brush(Point p) { return Fractal({70 * p.x, 5 * p.y}, 3, 701); }

double DoorHeight(Point p) { return 0.045 * DoorLevel(p) + 0.0003 * Brush(p); }

Surface DoorSurface(Point p) {
  double worn = Fractal({7 * p.x, 5 * p.y}, 4, 711);
  double level = DoorLevel(p);
  Color color = Color{0.60, 0.60, 0.58} * (1 + 0.05 * Brush(p));
  // Paint is rubbed off at the foot and around the knob, dust lies where nobody wipes.
  double foot = SmoothStep(0.80, 1.0, p.y + 0.10 * worn);
  double grip = SmoothStep(0.13, 0.03, FromKnob(p) + 0.05 * worn);
  color = Mix(color, {0.40, 0.36, 0.31}, 0.55 * Larger(foot, 0.8 * grip));
  double groove = SmoothStep(0.24, 0.13, level);
  color = color * (1 - 0.35 * groove);
  double gap = Inside(p, kOpening);
  color = color * (1 - 0.85 * SmoothStep(0.0035, 0.0015, std::fabs(gap - 0.002)));
  if (FromKnob(p) < 0.024) {
    color = Color{0.80, 0.66, 0.42} * (1 + 0.1 * worn);
  }
  return {color, SmoothStep(0, 0.003, Inside(p, kCasing))};
}

// A window is as wide as 0.8 of its height; a sill stands out below it.
constexpr Box kFrame{{0.040, 0.020}, {0.760, 0.920}};
constexpr Box kSill{{0.012, 0.905}, {0.788, 0.980}};

// How far inside its pane a point lies; negative on the bars.
double Pane(Point p) {
  double x = (p.x - 0.105) / 0.295;
  double y = (p.y - 0.090) / 0.2567;
  double column = std::floor(Clamp(x, 0, 1.999));
  double row = std::floor(Clamp(y, 0, 2.999));
  return Inside(p, {{0.105 + 0.295 * column + 0.014, 0.090 + 0.2567 * row + 0.014},
                    {0.105 + 0.295 * (column + 1) - 0.014, 0.090 + 0.2567 * (row + 1) - 0.014}});
}

double WindowLevel(Point p) {
  double frame = Inside(p, kFrame);
  double sill = Inside(p, kSill);
  if (sill > 0) {
    return 0.80 * SmoothStep(0, 0.012, sill);
  }
  if (frame <= 0) {
    return 0;
  }
  double level = 0.50 * SmoothStep(0, 0.008, frame) - 0.10 * SmoothStep(0.034, 0.042, frame);
  double pane = Pane(p);
  return pane > -0.010 ? Mix(level, 0.14, SmoothStep(-0.010, 0, pane)) : level;
}

// Old glass is not quite flat.
double WindowHeight(Point p) {
  double ripple = Pane(p) > 0 ? 0.0016 * Fractal({4 * p.x, 7 * p.y}, 2, 731) : 0;
  return 0.045 * WindowLevel(p) + 0.0003 * Brush(p) + ripple;
}

Surface WindowSurface(Point p) {
  double worn = Fractal({6 * p.x, 6 * p.y}, 4, 741);
  Color color = Color{0.78, 0.765, 0.72} * (1 + 0.05 * Brush(p));
  color = Mix(color, {0.52, 0.46, 0.38}, 0.5 * SmoothStep(0.2, 0.8, worn));
  double pane = Pane(p);
  double sill = Inside(p, kSill);
  if (sill <= 0 && pane > -0.004) {
    double rim = SmoothStep(0.0, 0.04, pane + 0.02 * worn);
    Color glass =
        Mix({0.20, 0.24, 0.25}, {0.30, 0.35, 0.36}, SmoothStep(0.9, 0.1, p.y + 0.3 * worn));
    color = Mix(color, Mix({0.30, 0.29, 0.25}, glass, rim), SmoothStep(-0.004, 0.0, pane));
  }
  // Rain leaves stains below the bars and on the sill.
  color = color * (1 - 0.25 * SmoothStep(0.88, 0.92, p.y) * SmoothStep(-0.3, 0.7, worn));
  double cover = Larger(SmoothStep(0, 0.004, Inside(p, kFrame)), SmoothStep(0, 0.004, sill));
  return {color, cover};
}

}  // namespace

Picture MakeDoor() {
  return Paint(256, 512, true, {[](Point) { return 0.0; }, DoorSurface, 0});
}

Picture MakeDoorRelief() { return PaintRelief(256, 512, {DoorHeight, DoorLevel}); }

Picture MakeWindow() {
  return Paint(256, 320, true, {[](Point) { return 0.0; }, WindowSurface, 0});
}

Picture MakeWindowRelief() { return PaintRelief(256, 320, {WindowHeight, WindowLevel}); }

}  // namespace texgraph::pictures
