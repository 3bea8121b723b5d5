// SPDX-License-Identifier: Apache-2.0
// Sheets whose pictures are the frames of an animation: a lamp of a board, drops that fall into
// water, a flower that opens. The message of the board is a map: a pixel for each lamp.
#include <cmath>
#include <string_view>

#include "graphs/pictures/canvas.h"

namespace texgraph::pictures {

namespace {

// Light on top of light: squares of sRGB values are close to it.
Color Lit(Color color, Color light) {
  const auto add = [](double a, double b) { return std::sqrt(Clamp(a * a + b * b, 0, 1)); };
  return {add(color.r, light.r), add(color.g, light.g), add(color.b, light.b)};
}

Color Housing(Point p) {
  const double dx = std::fabs(p.x - 0.5);
  const double dy = std::fabs(p.y - 0.5);
  const double groove = SmoothStep(0.470, 0.495, std::max(dx, dy));
  const double grain = Noise(p * 32, 5001, 32);
  return Color{0.105, 0.11, 0.12} * ((1 - 0.45 * groove) * (1 + 0.10 * grain));
}

Picture PaintLamp(double power) {
  constexpr double kRadius = 0.29;
  Canvas canvas(64, 64);
  canvas.Fill([&](Point p) {
    const Point c = p - Point{0.5, 0.5};
    const double r = Length(c);
    const double rim = SmoothStep(0.055, 0.02, std::fabs(r - 0.335));
    const double facing = 0.5 - 0.9 * (c.x + 1.2 * c.y) / (r + 1e-6) * 0.5;
    Color color = Housing(p) * (1 + rim * (1.1 * facing - 0.35));
    if (r < kRadius) {
      const double dome = std::sqrt(1 - r * r / (kRadius * kRadius));
      const Color glass = Color{0.21, 0.045, 0.045} * (0.55 + 0.6 * dome);
      color = Lit(glass, Color{1.0, 0.10, 0.06} * (power * (0.62 + 0.38 * dome)));
      const double core = SmoothStep(0.20, 0.0, r) * power;
      color = Lit(color, Color{0.55, 0.52, 0.34} * core);
      const double gleam = SmoothStep(0.085, 0.02, Length(c - Point{-0.10, -0.12}));
      color = Lit(color, Color{0.55, 0.50, 0.50} * (0.55 * gleam));
    }
    const double fade = 1 / (1 + r * r * 9) * SmoothStep(0.5, 0.24, r);
    return r < kRadius ? color : Lit(color, Color{0.80, 0.10, 0.06} * (1.1 * power * fade));
  });
  return canvas.FinishOpaque();
}

// 5 x 7 letters, each row a text of five.
struct Letter {
  char name;
  std::string_view rows[7];
};
constexpr Letter kLetters[] = {
    {'A', {" ### ", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"}},
    {'E', {"#####", "#    ", "#    ", "#### ", "#    ", "#    ", "#####"}},
    {'G', {" ### ", "#   #", "#    ", "# ###", "#   #", "#   #", " ### "}},
    {'H', {"#   #", "#   #", "#   #", "#####", "#   #", "#   #", "#   #"}},
    {'P', {"#### ", "#   #", "#   #", "#### ", "#    ", "#    ", "#    "}},
    {'R', {"#### ", "#   #", "#   #", "#### ", "# #  ", "#  # ", "#   #"}},
    {'T', {"#####", "  #  ", "  #  ", "  #  ", "  #  ", "  #  ", "  #  "}},
    {'X', {"#   #", "#   #", " # # ", "  #  ", " # # ", "#   #", "#   #"}},
};

bool IsLit(std::string_view message, int x, int y) {
  if (x < 0 || y < 0 || y >= 7 || x >= 6 * static_cast<int>(message.size()) || x % 6 == 5) {
    return false;
  }
  for (const Letter& letter : kLetters) {
    if (letter.name == message[static_cast<size_t>(x / 6)]) {
      return letter.rows[y][static_cast<size_t>(x % 6)] == '#';
    }
  }
  return false;
}

// A ring of water: up, then down, around x = 0; 0 beyond -1 and 1.
double Ring(double x) { return std::fabs(x) < 1 ? x * (1 - x * x) * (1 - x * x) : 0; }

// How steep the water is outwards, at that distance from where the drop fell.
double RippleSlope(double r, double t) {
  double slope = 0;
  for (int ring = 0; ring < 3; ++ring) {
    const double age = t - 0.14 * ring;
    if (age <= 0) continue;
    const double strength = (1 - t) * (1 - 0.28 * ring);
    slope += strength * Ring((r - 0.50 * age) / (0.055 + 0.05 * age));
  }
  return slope * SmoothStep(0.49, 0.34, r);
}

Picture PaintWater(int frame) {
  const double t = frame / 8.0;
  Canvas canvas(64, 64);
  canvas.Fill([&](Point p) {
    const Point c = p - Point{0.5, 0.5};
    const double r = Length(c);
    const Point out = Unit(c);
    // Fine and faint, so that cells of still water beside each other are one pond.
    const Point waves{Fractal(p * 8, 2, 5101, 8), Fractal(p * 8, 2, 5111, 8)};
    const Point slope = out * (frame == 0 ? 0 : 4.4 * RippleSlope(r, t)) + waves * 0.03;
    const double lit = -0.55 * slope.x - 0.75 * slope.y;
    const double depth = Fractal(p * 9 + slope * 0.05, 2, 5121, 9);
    Color color = Mix({0.108, 0.355, 0.41}, {0.120, 0.375, 0.425}, SmoothStep(-0.6, 0.6, depth));
    color = color * (1 + 0.75 * Clamp(lit, -0.75, 0.9));
    color = Lit(color, Color{0.75, 0.85, 0.88} * SmoothStep(0.32, 1.05, lit));
    if (frame == 1) {  // where it falls in
      color = Lit(color, Color{0.80, 0.90, 0.92} * SmoothStep(0.055, 0.02, r));
    }
    return color;
  });
  return canvas.FinishOpaque();
}

// A petal from the middle outwards, seen from above; `open` from 0, upright, to 1, flat.
void LayPetal(Canvas& canvas, Point along, double length, double width, double open, Color tip,
              uint32_t seed) {
  const Point middle = Point{0.5, 0.5} + along * (0.5 * length);
  canvas.Stamp(middle, 0.5 * length + width + 0.02, [&](Point p) {
    const Point local = Turned(p, along);
    const double t = local.x / length + 0.5;
    if (t <= 0 || t >= 1) return Surface{tip, 0};
    const double half = width * (1.75 * std::sqrt(t) * (1 - t) + 0.75 * t * (1 - t));
    const double across = local.y / (half + 1e-9);
    const double vein = Noise({2.0 * t, 9 * local.y / width}, seed);
    Color color = Mix(Mix({1.0, 0.88, 0.66}, tip, SmoothStep(0.05, 0.55, t)), {0.98, 0.80, 0.86},
                      0.45 * SmoothStep(0.72, 1.0, t));
    const double hollow = 1 - 0.22 * (1 - across * across) * (1 - t);
    const double side = 0.10 * (-along.y * across + along.x * across) * (along.x > 0 ? -1 : 1);
    const double light = (0.78 + 0.24 * open) * hollow * (1.0 + 0.07 * vein + side) *
                         (0.84 + 0.20 * t + 0.10 * (-0.6 * along.x - 0.8 * along.y));
    const double rim = SmoothStep(1.0, 0.80, std::fabs(across));
    return Surface{color * (light * (0.86 + 0.14 * rim)), std::fabs(across) < 1 ? 1.0 : 0.0};
  });
}

void LayWhorl(Canvas& canvas, int first, double open, double size, Color tip, uint32_t seed) {
  constexpr double kStep = 0.8660254037844386;
  Point along = first == 0 ? Point{0, -1} : Point{0.5, -kStep};
  const double length = size * (0.26 + 0.74 * open);
  const double width = size * (0.30 + 0.10 * open);
  for (int i = 0; i < 6; ++i) {
    const double own = 0.95 + 0.10 * Random(i, first, seed);
    LayPetal(canvas, along, length * own, width, open, tip * (0.96 + 0.08 * Random(i, 9, seed)),
             seed + 10 + static_cast<uint32_t>(i));
    along = Turned(along, {0.5, -kStep});
  }
}

// Half a whorl's turn between each two.
Picture PaintFlower(double t) {
  Canvas canvas(128, 128);
  const Point middle{0.5, 0.5};
  const double open = SmoothStep(0.0, 0.80, t);
  const double later = SmoothStep(0.15, 0.92, t);
  const double last = SmoothStep(0.30, 1.0, t);
  const Color sepal{0.33, 0.46, 0.17};
  constexpr double kStep = 0.8660254037844386;
  Point along{1, 0};
  for (int i = 0; i < 6; ++i, along = Turned(along, {0.5, -kStep})) {
    canvas.Stroke(middle, middle + along * (0.20 + 0.12 * open), 0.01, 0.075, sepal * 0.8, sepal);
  }
  LayWhorl(canvas, 0, open, 0.470, {0.86, 0.40, 0.58}, 5201);
  LayWhorl(canvas, 1, later, 0.400, {0.90, 0.47, 0.64}, 5211);
  LayWhorl(canvas, 0, last, 0.310, {0.94, 0.56, 0.70}, 5221);
  const double heart = 0.085 * SmoothStep(0.35, 0.9, t);
  if (heart > 0.004) {
    canvas.Spot(middle, {1, 0}, {1.15 * heart, 1.15 * heart}, {0.55, 0.33, 0.08}, 0.8, 0.5);
    for (int i = 0; i < 46; ++i) {
      const Point at = middle + Direction(i, 0, 5231) * (heart * std::sqrt(Random(i, 2, 5231)));
      const Color gold = Mix({0.90, 0.66, 0.12}, {1.0, 0.86, 0.36}, Random(i, 3, 5231));
      canvas.Spot(at + Point{0.003, 0.004}, {1, 0}, {0.15 * heart, 0.15 * heart},
                  {0.45, 0.26, 0.06}, 0.8, 0.5);
      canvas.Spot(at, {1, 0}, {0.14 * heart, 0.14 * heart}, gold, 1, 0.4);
    }
  }
  return canvas.Finish({0.80, 0.45, 0.55});
}

}  // namespace

Picture MakeLamps() {
  std::vector<Picture> frames;
  for (double power : {0.0, 0.35, 0.75, 1.0, 0.85, 0.60, 0.35, 0.15}) {
    frames.push_back(PaintLamp(power));
  }
  return Sheet(4, frames);
}

// One lamp a pixel; a row is free above and below the letters, and some columns on both sides.
Picture MakeMessage() {
  Picture picture{64, 9, false, {}};
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      const uint8_t value = IsLit("TEXGRAPH", x - 8, y - 1) ? 255 : 0;
      picture.pixels.insert(picture.pixels.end(), 3, value);
    }
  }
  return picture;
}

Picture MakeDrops() {
  std::vector<Picture> frames;
  for (int i = 0; i < 8; ++i) frames.push_back(PaintWater(i));
  return Sheet(4, frames);
}

Picture MakeOpeningFlower() {
  std::vector<Picture> frames;
  for (int i = 0; i < 16; ++i) frames.push_back(PaintFlower(i / 15.0));
  return Sheet(4, frames);
}

}  // namespace texgraph::pictures
