// SPDX-License-Identifier: Apache-2.0
// What settles on walls: moss in tufts, and soot that the rain has washed down.
#include <cmath>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

// How thick the moss is: patches that end before the picture does.
double MossDepth(Point p) {
  double dx = (p.x - 0.5) / 0.44;
  double dy = (p.y - 0.5) / 0.44;
  double inside = 1 - (dx * dx + dy * dy);
  return inside - 0.32 + 0.85 * Fractal({4.3 * p.x, 4.3 * p.y}, 4, 211);
}

double MossHeight(Point p) {
  Cell tuft = Cells({26 * p.x + 0.5 * Noise({20 * p.x, 20 * p.y}, 221), 26 * p.y}, 222);
  Cell leaf = Cells({62 * p.x, 62 * p.y}, 231);
  double dome = 1 - tuft.nearest * tuft.nearest;
  return 0.020 * dome + 0.004 * (1 - leaf.nearest) + 0.02 * Clamp(MossDepth(p), 0, 0.6);
}

Surface MossSurface(Point p) {
  Cell tuft = Cells({26 * p.x + 0.5 * Noise({20 * p.x, 20 * p.y}, 221), 26 * p.y}, 222);
  Cell leaf = Cells({62 * p.x, 62 * p.y}, 231);
  double depth = MossDepth(p);
  Color color = Mix({0.19, 0.24, 0.10}, {0.42, 0.47, 0.17}, tuft.value);
  color = Mix(color, {0.55, 0.53, 0.22}, 0.55 * SmoothStep(0.6, 1.0, leaf.value));
  color = Mix(color, {0.30, 0.25, 0.13}, 0.6 * SmoothStep(0.22, 0.0, depth));  // dry at the rim
  color = color * (1.08 - 0.55 * SmoothStep(0.25, 0.75, tuft.nearest));
  double ragged = depth + 0.22 * (0.55 - tuft.nearest) + 0.10 * (0.4 - leaf.nearest);
  return {color, 0.94 * SmoothStep(0.0, 0.10, ragged)};
}

double SootHeight(Point) { return 0; }

Surface SootSurface(Point p) {
  double across = (p.x - 0.5) / 0.46;
  double inside = SmoothStep(1, 0.35, std::fabs(across)) * SmoothStep(0.0, 0.16, p.y) *
                  SmoothStep(1.0, 0.35, p.y);
  double streak = Fractal({11 * p.x + 0.8 * Noise({3 * p.x, 3 * p.y}, 251), 1.2 * p.y}, 4, 252);
  double cloud = Fractal({3 * p.x, 3 * p.y}, 5, 261);
  double dust = Fractal({34 * p.x, 34 * p.y}, 3, 271);
  double alpha = inside * Clamp(0.60 + 0.62 * streak + 0.55 * cloud + 0.20 * dust, 0, 1);
  Color color =
      Mix({0.09, 0.08, 0.075}, {0.20, 0.175, 0.15}, SmoothStep(-0.6, 0.6, cloud + 0.4 * dust));
  return {color, 0.94 * alpha};
}

}  // namespace

Picture MakeMoss(int height) { return Paint(height, height, true, {MossHeight, MossSurface, 0.7}); }

Picture MakeSoot() { return Paint(256, 256, true, {SootHeight, SootSurface, 0}); }

}  // namespace texgraph::pictures
