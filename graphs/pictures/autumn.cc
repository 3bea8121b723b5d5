// SPDX-License-Identifier: Apache-2.0
// Leaves in autumn, one of each of four trees, and the floor of a forest that they fall on.
#include <cmath>

#include "graphs/pictures/things.h"

namespace texgraph::pictures {

namespace {

enum class Tree { kMaple, kBirch, kOak, kBeech };

// Where a point lies in a leaf whose stalk begins at (0, 0) and whose tip is at (0, 1).
struct LeafPlace {
  double depth = -1;  // from the rim, positive inside
  double vein = 1;    // distance to the nearest
};

// From 0 to 1 and back, once a unit, smooth.
double Wave(double x) {
  const double t = x - std::floor(x);
  return SmoothStep(0, 1, t < 0.5 ? 2 * t : 2 - 2 * t);
}

// A row of teeth that point to the tip.
double Teeth(double x) { return x - std::floor(x); }

double HalfWidth(Tree tree, double t) {
  switch (tree) {
    case Tree::kBirch:
      return 0.40 * SmoothStep(-0.02, 0.22, t) * (1 - t) * (1.12 - 0.35 * t) -
             0.022 * Teeth(15 * t) * SmoothStep(0.12, 0.3, t);
    case Tree::kOak:
      return 0.56 * std::sqrt(t * (1 - t)) * SmoothStep(1.0, 0.93, t) * (0.80 + 0.55 * t) *
             (0.58 + 0.42 * Wave(4.4 * t - 0.1));
    default:
      return 0.74 * std::sqrt(t) * (1 - t) * (1.06 - 0.2 * t) - 0.010 * Teeth(13 * t);
  }
}

// Side veins leave the middle one towards the tip.
double SideVein(double along, double across, double spacing) {
  const double rib = (along - 0.85 * across) / spacing;
  return std::fabs(rib - std::floor(rib) - 0.5) * spacing * 0.75;
}

LeafPlace FindSimple(Tree tree, Point p) {
  LeafPlace place;
  if (p.y <= 0 || p.y >= 1) return place;
  const double across = std::fabs(p.x - 0.02 * Noise({0.5, 3 * p.y}, 3101));
  place.depth = HalfWidth(tree, p.y) - across;
  const double spacing = tree == Tree::kOak ? 1 / 4.4 : 0.095;
  const double rib = SideVein(p.y + 0.02, across, spacing) + 0.004 + 0.012 * across / 0.3;
  place.vein = std::min(across + 0.004 * p.y, rib);
  return place;
}

// Five pointed lobes around a point above the stalk, each with teeth.
LeafPlace FindMaple(Point p) {
  struct Finger {
    Point along;
    double length;
    double width;
  };
  constexpr Finger kFingers[5] = {{{0, 1}, 0.78, 0.165},
                                  {{0.80, 0.60}, 0.60, 0.150},
                                  {{-0.80, 0.60}, 0.60, 0.150},
                                  {{0.97, -0.243}, 0.42, 0.110},
                                  {{-0.97, -0.243}, 0.42, 0.110}};
  const Point q{p.x + 0.010 * Noise(p * 7, 3111), p.y - 0.22 + 0.010 * Noise(p * 7, 3112)};
  LeafPlace place;
  for (const Finger& finger : kFingers) {
    const double along = Dot(q, finger.along);
    const double t = along / finger.length;
    const double across = std::fabs(q.x * finger.along.y - q.y * finger.along.x);
    if (t <= 0 || t >= 1) continue;
    const double tooth = 0.055 * Teeth(3.0 * t + 0.15) * SmoothStep(0.30, 0.45, t) * (1.25 - t);
    const double half = finger.width * (1.9 * std::sqrt(t) * (1 - t) + 0.30 * (1 - t)) + tooth;
    place.depth = std::max(place.depth, half - across);
    const double rib = SideVein(along, across, 0.115) + 0.005;
    if (half - across > -0.01) place.vein = std::min({place.vein, across + 0.005 * t, rib});
  }
  place.depth = std::max(place.depth, 0.15 - Length(q));
  return place;
}

LeafPlace FindLeaf(Tree tree, Point p) {
  return tree == Tree::kMaple ? FindMaple(p) : FindSimple(tree, p);
}

struct Dye {
  Color body;
  Color patch;
  Color rim;
  Color vein;
};

Dye DyeOf(Tree tree) {
  switch (tree) {
    case Tree::kMaple:
      return {{0.83, 0.27, 0.08}, {0.93, 0.56, 0.14}, {0.58, 0.10, 0.06}, {0.95, 0.66, 0.26}};
    case Tree::kBirch:
      return {{0.91, 0.74, 0.20}, {0.70, 0.68, 0.22}, {0.66, 0.44, 0.14}, {0.97, 0.88, 0.50}};
    case Tree::kOak:
      return {{0.66, 0.43, 0.19}, {0.80, 0.60, 0.26}, {0.43, 0.26, 0.12}, {0.82, 0.66, 0.38}};
    default:
      return {{0.76, 0.42, 0.15}, {0.90, 0.62, 0.22}, {0.52, 0.24, 0.10}, {0.90, 0.66, 0.34}};
  }
}

// Of the leaf whose stalk ends at (0, -0.14).
Surface FoliageSurface(Tree tree, Point p, uint32_t seed) {
  const LeafPlace place = FindLeaf(tree, p);
  const Dye dye = DyeOf(tree);
  const double cloud = Fractal(p * 4.2, 4, seed + 1);
  Color color = Mix(dye.body, dye.patch, SmoothStep(-0.25, 0.55, cloud));
  color = Mix(color, dye.rim, 0.75 * SmoothStep(0.07, 0.0, place.depth + 0.05 * cloud));
  const double spot = Fractal(p * 15, 2, seed + 11);
  color = Mix(color, dye.rim * 0.7, 0.6 * SmoothStep(0.42, 0.62, spot));
  color = color * (1 - 0.22 * SmoothStep(0.030, 0.006, place.vein));
  color = Mix(color, dye.vein, 0.85 * SmoothStep(0.011, 0.004, place.vein));
  // The two halves stand up from the middle vein, and the blade swells between the side veins.
  const double swell = SmoothStep(0.004, 0.04, place.vein);
  const double bend = Noise(p * 2.3, seed + 21);
  color = color * (0.93 + 0.11 * swell - 0.10 * Clamp(8 * p.x, -1, 1) + 0.14 * bend);
  const double stalk = std::fabs(p.x + 0.22 * p.y * p.y);
  const bool is_stalk = p.y > -0.14 && p.y < 0.24 && stalk < 0.011;
  if (is_stalk && place.depth < 0) return {dye.rim * 1.05, 1};
  return {color, place.depth > 0 ? 1.0 : 0.0};
}

// An old leaf, withered and dark, of that size from its stalk to its tip, which points `along`.
void LayLeaf(Canvas& canvas, Point at, Point along, double size, Tree tree, uint32_t seed,
             double light) {
  const auto local = [&](Point p) {
    const Point turned = Turned(p, along) * (1 / size);
    return Point{turned.y, turned.x + 0.43};
  };
  canvas.Stamp(at, 0.75 * size, [&](Point p) {
    const Point shadow = local(p - Point{0.02 * size, 0.03 * size});
    return Surface{{0.04, 0.03, 0.02}, 0.5 * SmoothStep(-0.03, 0.02, FindLeaf(tree, shadow).depth)};
  });
  canvas.Stamp(at, 0.75 * size, [&](Point p) {
    Surface surface = FoliageSurface(tree, local(p), seed);
    surface.color = Mix(surface.color, {0.42, 0.33, 0.24}, 0.45) * light;
    return surface;
  });
}

Picture PaintLeaf(Tree tree, uint32_t seed) {
  Canvas canvas(128, 128);
  canvas.Stamp({0.5, 0.5}, 0.5, [&](Point p) {
    constexpr double kScale = 0.84;
    return FoliageSurface(tree, {p.x / kScale, (0.36 - p.y) / kScale}, seed);
  });
  return canvas.Finish(DyeOf(tree).body);
}

Color FloorColor(Point p) {
  const double crumb = Fractal(p * 28, 3, 3201, 28);
  const double cloud = Fractal(p * 3, 3, 3211, 3);
  const Color earth = Mix({0.20, 0.145, 0.10}, {0.35, 0.27, 0.19}, SmoothStep(-0.6, 0.6, crumb));
  return Mix(earth, {0.30, 0.26, 0.16}, 0.5 * SmoothStep(0, 0.6, cloud));
}

// Old leaves, one layer of them: brown, the lower the darker.
void LayLitter(Canvas& canvas, int across, double size, double light, uint32_t seed) {
  for (int i = 0; i < across * across; ++i) {
    const int shuffled = i * 7919 % (across * across);
    const int x = shuffled % across;
    const int y = shuffled / across;
    const Point at{(x + Random(x, y, seed)) / across, (y + Random(x, y, seed + 1)) / across};
    const double own = size * (0.7 + 0.6 * Random(x, y, seed + 2));
    const Tree tree = Random(x, y, seed + 3) < 0.55 ? Tree::kBeech : Tree::kOak;
    const double brown = light * (0.84 + 0.24 * Random(x, y, seed + 4));
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Point moved{at.x + dx, at.y + dy};
        const double from = std::max(std::fabs(moved.x - 0.5), std::fabs(moved.y - 0.5));
        if (from > 0.5 + own) continue;
        LayLeaf(canvas, moved, Direction(x, y, seed + 5), own, tree,
                seed + 100 + static_cast<uint32_t>(shuffled), brown);
      }
    }
  }
}

void LayNeedles(Canvas& canvas, int across, uint32_t seed) {
  for (int i = 0; i < across * across; ++i) {
    const int x = i % across;
    const int y = i / across;
    const Point at{(x + Random(x, y, seed)) / across, (y + Random(x, y, seed + 1)) / across};
    const Point half = Direction(x, y, seed + 2) * (0.012 + 0.012 * Random(x, y, seed + 4));
    const Color color = Mix({0.36, 0.25, 0.15}, {0.62, 0.48, 0.30}, Random(x, y, seed + 5));
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const Point moved{at.x + dx, at.y + dy};
        canvas.Stroke(moved - half, moved + half, 0.003, 0.0022, color * 0.8, color);
      }
    }
  }
}

}  // namespace

Picture MakeLeaves() {
  return Sheet(2, {PaintLeaf(Tree::kMaple, 3301), PaintLeaf(Tree::kBirch, 3401),
                   PaintLeaf(Tree::kOak, 3501), PaintLeaf(Tree::kBeech, 3601)});
}

Picture MakeForestFloor() {
  Canvas canvas(256, 256);
  canvas.Fill(FloorColor);
  LayLitter(canvas, 9, 0.13, 0.48, 4001);
  LayNeedles(canvas, 26, 4101);
  LayLitter(canvas, 8, 0.12, 0.68, 4201);
  LayNeedles(canvas, 18, 4301);
  return canvas.FinishOpaque();
}

}  // namespace texgraph::pictures
