// SPDX-License-Identifier: Apache-2.0
// Three trees as a volume: 48 slices across each, from the ground up; an oak, a spruce and a birch.
// Alpha is how much of a place is wood or leaves; there is air all around. The light is painted in:
// it comes from above and the lower left, and little of it gets through leaves.
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "graphs/pictures/canvas.h"

namespace texgraph::pictures {

namespace {

constexpr int kSlices = 48;

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

Space operator-(Space a, Space b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Space Moved(Space p, Space by, double t) {
  return {p.x + t * by.x, p.y + t * by.y, p.z + t * by.z};
}
double Dot3(Space a, Space b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

constexpr Space kToLight{-0.50, 0.34, 0.80};

// A ball of leaves at the end of a branch.
struct Ball {
  Space at;
  double size;
};

struct Species {
  uint32_t seed;
  std::vector<Ball> balls;  // none: a spruce
  double trunk;             // its radius at the ground
  double gaps;              // how ragged the crown is
  Color shade, leaf, gleam;
  Color bark, bark_light;
};

Species Oak() {
  return {6000,
          {{{0.50, 0.50, 0.76}, 0.190},
           {{0.35, 0.41, 0.66}, 0.170},
           {{0.63, 0.36, 0.68}, 0.175},
           {{0.65, 0.62, 0.64}, 0.170},
           {{0.39, 0.65, 0.66}, 0.175},
           {{0.24, 0.52, 0.52}, 0.140},
           {{0.50, 0.23, 0.52}, 0.150},
           {{0.78, 0.48, 0.50}, 0.145},
           {{0.55, 0.77, 0.51}, 0.150},
           {{0.29, 0.29, 0.46}, 0.125},
           {{0.73, 0.72, 0.45}, 0.125},
           {{0.50, 0.50, 0.58}, 0.200}},
          0.052,
          0.62,
          {0.075, 0.125, 0.050},
          {0.25, 0.37, 0.11},
          {0.55, 0.62, 0.22},
          {0.24, 0.155, 0.085},
          {0.44, 0.31, 0.19}};
}

Species Spruce() {
  return {7000,
          {},
          0.034,
          0.50,
          {0.045, 0.090, 0.065},
          {0.16, 0.30, 0.17},
          {0.40, 0.54, 0.28},
          {0.23, 0.135, 0.085},
          {0.40, 0.25, 0.16}};
}

Species Birch() {
  return {8000,
          {{{0.50, 0.50, 0.84}, 0.115},
           {{0.43, 0.45, 0.74}, 0.125},
           {{0.58, 0.46, 0.70}, 0.125},
           {{0.52, 0.59, 0.66}, 0.130},
           {{0.38, 0.54, 0.59}, 0.115},
           {{0.63, 0.56, 0.55}, 0.115},
           {{0.46, 0.37, 0.55}, 0.115},
           {{0.55, 0.63, 0.47}, 0.100},
           {{0.41, 0.45, 0.44}, 0.095}},
          0.024,
          0.70,
          {0.15, 0.19, 0.055},
          {0.43, 0.50, 0.14},
          {0.75, 0.76, 0.33},
          {0.46, 0.43, 0.38},
          {0.86, 0.84, 0.78}};
}

// Tiers of branches, each a little wider than the one above and hanging at its rim.
double SpruceDepth(Space p) {
  const Point c{p.x - 0.5, p.y - 0.5};
  const double r = Length(c);
  const double t = (0.97 - p.z - 0.35 * r) / 0.80;
  if (t <= 0 || p.z < 0.10) return -1;
  const double tier = 8 * t - std::floor(8 * t);
  const Point out = Unit(c);
  const double arms = Noise({3.1 * out.x, 3.1 * out.y + 5 * std::floor(8 * t)}, 7001);
  const double radius = 0.37 * std::min(t, 1.0) * (0.72 + 0.28 * tier) * (1 + 0.40 * arms) + 0.02;
  return 1 - r / radius;
}

// 1 in the middle of the nearest ball, 0 at its border.
double CrownDepth(const Species& species, Space p) {
  if (species.balls.empty()) return SpruceDepth(p);
  double depth = -1;
  for (const Ball& ball : species.balls) {
    Space d = p - ball.at;
    d.z *= 1.15;
    depth = std::max(depth, 1 - std::sqrt(Dot3(d, d)) / ball.size);
  }
  return depth;
}

Point TrunkAt(const Species& species, double z) {
  const double bend = species.balls.empty() ? 0.004 : 0.020;
  return {0.5 + bend * Noise({3 * z, 0.5}, species.seed + 1),
          0.5 + bend * Noise({3 * z, 2.5}, species.seed + 1)};
}

double TrunkDepth(const Species& species, Space p) {
  const Point axis = TrunkAt(species, p.z);
  const Point c{p.x - axis.x, p.y - axis.y};
  const Point out = Unit(c);
  const double foot = SmoothStep(0.12, 0, p.z);
  const double ribs =
      1 + (0.10 + 0.35 * foot) * Noise({2.2 * out.x, 2.2 * out.y}, species.seed + 11);
  const double radius = species.trunk * (1 - 0.75 * p.z + 0.65 * foot * foot) * ribs;
  return p.z > 0.85 ? -1 : radius - Length(c);
}

// Branches leave the trunk at two thirds of the height of their balls.
double BranchDepth(const Species& species, Space p) {
  double depth = -1;
  for (const Ball& ball : species.balls) {
    const double low = 0.10 + 0.55 * ball.at.z;
    const Point axis = TrunkAt(species, low);
    const Space foot{axis.x, axis.y, low};
    const Space branch = ball.at - foot;
    const Space from = p - foot;
    const double t = Clamp(Dot3(from, branch) / Dot3(branch, branch), 0, 1);
    const Space off = Moved(from, branch, -t);
    depth = std::max(depth, 0.32 * species.trunk - 0.009 * t - std::sqrt(Dot3(off, off)));
  }
  return depth;
}

// How much light comes through the crown, from 0 to 1.
double Light(const Species& species, Space p) {
  double leaves = 0;
  for (double away : {0.05, 0.11, 0.19, 0.30}) {
    leaves += SmoothStep(-0.05, 0.35, CrownDepth(species, Moved(p, kToLight, away)));
  }
  return 1 / (1 + 0.9 * leaves * leaves);
}

Surface Wood(const Species& species, Space p, double depth) {
  const double bark = Noise3({40 * p.x, 40 * p.y, 12 * p.z}, species.seed + 101);
  const Color color = Mix(species.bark, species.bark_light, SmoothStep(-0.35, 0.35, bark));
  const double side = 1 + 2.2 * ((0.5 - p.x) - (0.5 - p.y)) / (species.trunk / 0.05);
  return {color * (Clamp(side, 0.45, 1.25) * (0.55 + 0.45 * Light(species, p))),
          SmoothStep(-0.004, 0.006, depth)};
}

Surface Leaves(const Species& species, Space p) {
  const double clump = Fractal3({12 * p.x, 12 * p.y, 12 * p.z}, 3, species.seed + 201);
  const double depth = CrownDepth(species, p) + species.gaps * clump;
  const double leaf = Noise3({30 * p.x, 30 * p.y, 30 * p.z}, species.seed + 301);
  const double alpha = SmoothStep(0.06, 0.22, depth + 0.15 * leaf);
  if (alpha <= 0) return {species.shade, 0};
  // Inside and below it is dark.
  const double outside = SmoothStep(0.60, 0.0, depth - 0.2 * clump);
  const double high = SmoothStep(0.20, 0.90, p.z);
  const double light = Light(species, p) * (0.35 + 0.65 * outside) * (0.55 + 0.45 * high);
  const Color color = Mix(species.leaf, species.gleam, SmoothStep(0.0, 0.75, 0.5 * clump + leaf));
  return {Mix(species.shade, color, Clamp(1.45 * light, 0, 1)), alpha};
}

Picture PaintSlice(const Species& species, int slice) {
  const double z = (slice + 0.5) / kSlices;
  Canvas canvas(64, 64);
  bool has_leaves = false;
  canvas.Stamp({0.5, 0.5}, 0.47, [&](Point c) {
    const Space p{c.x + 0.5, c.y + 0.5, z};
    const double wood = std::max(TrunkDepth(species, p), BranchDepth(species, p));
    if (wood > -0.004) return Wood(species, p, wood);
    if (CrownDepth(species, p) < -0.6) return Surface{species.shade, 0};
    const Surface surface = Leaves(species, p);
    has_leaves = has_leaves || surface.alpha > 0;
    return surface;
  });
  return canvas.Finish(has_leaves ? species.shade : Mix(species.bark, species.bark_light, 0.4));
}

}  // namespace

Picture MakeTrees() {
  std::vector<Picture> slices;
  for (const Species& species : {Oak(), Spruce(), Birch()}) {
    for (int i = 0; i < kSlices; ++i) slices.push_back(PaintSlice(species, i));
  }
  return Coarse(Sheet(12, slices));
}

}  // namespace texgraph::pictures
