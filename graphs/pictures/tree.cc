// SPDX-License-Identifier: Apache-2.0
// A tree as a volume: 64 slices across it, from the ground up. Alpha is how much of a place is wood
// or leaves; there is air all around.
#include <algorithm>
#include <cmath>

#include "graphs/pictures/canvas.h"

namespace texgraph::pictures {

namespace {

constexpr int kSlices = 64;

struct Space {
  double x;
  double y;
  double z;  // up
};

double Noise3(Space p, uint32_t seed) {
  const double layer = std::floor(p.z);
  const uint32_t below = seed + static_cast<uint32_t>(static_cast<int>(layer) + 1000);
  return Mix(Noise({p.x, p.y}, below), Noise({p.x, p.y}, below + 1), SmoothStep(0, 1, p.z - layer));
}

double Fractal3(Space p, int octaves, uint32_t seed) {
  double sum = 0;
  double strength = 1;
  for (int i = 0; i < octaves; ++i, strength *= 0.5) {
    sum += strength * Noise3(p, seed + static_cast<uint32_t>(5000 * i));
    p = {2 * p.x, 2 * p.y, 2 * p.z};
  }
  return sum;
}

// The crown is made of balls of leaves, each at the end of a branch.
struct Ball {
  Space at;
  double size;
};
constexpr Ball kBalls[] = {
    {{0.50, 0.50, 0.80}, 0.170}, {{0.36, 0.42, 0.70}, 0.160}, {{0.62, 0.38, 0.71}, 0.165},
    {{0.64, 0.61, 0.68}, 0.160}, {{0.40, 0.64, 0.69}, 0.165}, {{0.27, 0.52, 0.55}, 0.140},
    {{0.50, 0.26, 0.55}, 0.150}, {{0.75, 0.48, 0.54}, 0.145}, {{0.55, 0.75, 0.54}, 0.150},
    {{0.31, 0.31, 0.50}, 0.115}, {{0.71, 0.70, 0.49}, 0.115}, {{0.50, 0.50, 0.62}, 0.180}};

Space operator-(Space a, Space b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double Dot3(Space a, Space b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// 1 in the middle of the nearest ball, 0 at its border.
double CrownDepth(Space p) {
  double depth = -1;
  for (const Ball& ball : kBalls) {
    Space d = p - ball.at;
    d.z *= 1.2;
    depth = std::max(depth, 1 - std::sqrt(Dot3(d, d)) / ball.size);
  }
  return depth;
}

Point TrunkAt(double z) {
  return {0.5 + 0.020 * Noise({3 * z, 0.5}, 6001), 0.5 + 0.020 * Noise({3 * z, 2.5}, 6001)};
}

double TrunkDepth(Space p) {
  const Point axis = TrunkAt(p.z);
  const Point c{p.x - axis.x, p.y - axis.y};
  const Point out = Unit(c);
  const double foot = SmoothStep(0.12, 0, p.z);
  const double ribs = 1 + (0.10 + 0.35 * foot) * Noise({2.2 * out.x, 2.2 * out.y}, 6011);
  const double radius = (0.052 - 0.040 * p.z + 0.035 * foot * foot) * ribs;
  return p.z > 0.85 ? -1 : radius - Length(c);
}

// Branches leave the trunk at half the height of their balls.
double BranchDepth(Space p) {
  double depth = -1;
  for (const Ball& ball : kBalls) {
    const double low = 0.20 + 0.45 * ball.at.z;
    const Point axis = TrunkAt(low);
    const Space foot{axis.x, axis.y, low};
    const Space branch = ball.at - foot;
    const Space from = p - foot;
    const double t = Clamp(Dot3(from, branch) / Dot3(branch, branch), 0, 1);
    const Space off{from.x - t * branch.x, from.y - t * branch.y, from.z - t * branch.z};
    depth = std::max(depth, 0.017 - 0.009 * t - std::sqrt(Dot3(off, off)));
  }
  return depth;
}

Surface Wood(Space p, double depth) {
  const double bark = Noise3({40 * p.x, 40 * p.y, 9 * p.z}, 6101);
  const Color color = Mix({0.27, 0.20, 0.14}, {0.46, 0.37, 0.28}, SmoothStep(-0.4, 0.4, bark));
  const double side = 1 + 1.6 * ((0.5 - p.x) + (0.5 - p.y));
  return {color * Clamp(side * (0.8 + 0.2 * SmoothStep(0.6, 0.2, p.z)), 0.5, 1.2),
          SmoothStep(-0.004, 0.006, depth)};
}

Surface Leaves(Space p) {
  const double clump = Fractal3({11 * p.x, 11 * p.y, 11 * p.z}, 3, 6201);
  const double depth = CrownDepth(p) + 0.55 * clump;
  const double leaf = Noise3({34 * p.x, 34 * p.y, 34 * p.z}, 6301);
  Color color =
      Mix({0.15, 0.26, 0.07}, {0.40, 0.52, 0.16}, SmoothStep(-0.5, 0.5, leaf + 0.5 * clump));
  color = Mix(color, {0.62, 0.66, 0.24}, 0.5 * SmoothStep(0.2, 0.6, leaf));
  // Inside and below it is dark; the light comes from above and the upper left.
  const double outside = SmoothStep(0.75, 0.05, depth);
  const double high = SmoothStep(0.38, 0.90, p.z + 0.25 * ((0.5 - p.x) + (0.5 - p.y)));
  return {color * (0.45 + 0.35 * outside + 0.42 * high),
          SmoothStep(0.06, 0.22, depth + 0.12 * leaf)};
}

Picture PaintSlice(int slice) {
  const double z = (slice + 0.5) / kSlices;
  Canvas canvas(64, 64);
  canvas.Stamp({0.5, 0.5}, 0.47, [&](Point c) {
    const Space p{c.x + 0.5, c.y + 0.5, z};
    const double wood = std::max(TrunkDepth(p), BranchDepth(p));
    if (wood > -0.004) return Wood(p, wood);
    return CrownDepth(p) > -0.6 ? Leaves(p) : Surface{{0, 0, 0}, 0};
  });
  return canvas.Finish(z < 0.3 ? Color{0.36, 0.28, 0.20} : Color{0.27, 0.37, 0.12});
}

}  // namespace

Picture MakeTree() {
  std::vector<Picture> slices;
  for (int i = 0; i < kSlices; ++i) slices.push_back(PaintSlice(i));
  return Sheet(8, slices);
}

}  // namespace texgraph::pictures
