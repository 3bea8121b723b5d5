// SPDX-License-Identifier: Apache-2.0
// The face of a board: growth rings cut lengthwise, fibres and pores, a knot.
#include <cmath>

#include "graphs/pictures/picture.h"

namespace texgraph::pictures {

namespace {

// Noise of `across` by `down` cells to a picture, which repeats: the grain runs down, so patterns
// are stretched.
double Strands(Point p, int across, int down, int octaves, uint32_t seed) {
  return Fractal({across * p.x, down * p.y}, octaves, seed, {across, down});
}

// Where in the growth rings a point lies, one unit a year.
double Years(Point p) {
  double bend = 0.16 * Strands(p, 1, 2, 2, 311);
  double x = p.x - 0.62 + bend;
  double kx = (p.x - 0.33) / 0.085;
  double ky = (p.y - 0.5) / 0.16;
  double knot = Clamp(1.1 / (1 + kx * kx + ky * ky) - 0.1, 0, 1);
  // The heart of the tree is at x = 0; half a board away, the next board begins.
  double distance = std::fabs(x - std::floor(x + 0.5));
  return 19 * distance * (1.25 - 0.5 * distance) + 6.5 * knot * knot +
         0.25 * Strands(p, 8, 2, 3, 321);
}

double Knot(Point p) {
  double kx = (p.x - 0.33) / 0.042 + 0.5 * Noise({20 * p.x, 20 * p.y}, 331);
  double ky = (p.y - 0.5) / 0.060 + 0.5 * Noise({20 * p.x, 20 * p.y}, 332);
  return SmoothStep(1.3, 0.6, std::sqrt(kx * kx + ky * ky));
}

// Wood of one year: light in spring, darker towards a sharp edge in autumn.
double Autumn(double years) {
  double t = years - std::floor(years);
  return t < 0.86 ? SmoothStep(0.15, 0.86, t) : SmoothStep(1.0, 0.88, t);
}

double Fibre(Point p) { return Strands(p, 80, 4, 3, 341); }

// Short dark vessels, in the wood of spring more than in that of autumn.
double Pore(Point p) {
  Cell cell = Cells({96 * p.x, 12 * p.y}, 351, {96, 12});
  double dx = cell.offset.x / 0.22;
  double dy = cell.offset.y / 0.34;
  return cell.value > 0.70 ? SmoothStep(1.0, 0.3, std::sqrt(dx * dx + dy * dy)) : 0;
}

double WoodHeight(Point p) {
  return 0.0016 * Autumn(Years(p)) + 0.0012 * Fibre(p) - 0.0012 * Pore(p);
}

Surface WoodSurface(Point p) {
  double autumn = Autumn(Years(p));
  double cloud = Strands(p, 3, 1, 3, 361);
  Color color = Mix({0.78, 0.60, 0.41}, {0.56, 0.37, 0.215}, 0.75 * autumn);
  color = Mix(color, {0.68, 0.45, 0.27}, 0.4 * SmoothStep(-0.5, 0.6, cloud));
  color = Mix(color, {0.27, 0.15, 0.085}, 0.9 * Knot(p) * (0.55 + 0.45 * autumn));
  color = color * (1 + 0.11 * Fibre(p)) * (1 - 0.28 * Pore(p));
  return {color, 1};
}

}  // namespace

Picture MakeWood() { return Paint(256, 256, false, {WoodHeight, WoodSurface, 1.0}); }

}  // namespace texgraph::pictures
