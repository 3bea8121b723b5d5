// SPDX-License-Identifier: Apache-2.0
// Random patterns for the pictures of the example graphs. Only + - * / sqrt and floor of doubles,
// and integer hashes: every machine draws the same pixels. Patterns with a period repeat after that
// many cells in each direction; 0 means never.
#pragma once

#include <cstdint>

namespace texgraph::pictures {

struct Point {
  double x = 0;
  double y = 0;
};

// After how many cells a pattern repeats, across and down; 0: never.
struct Period {
  Period(int both = 0) : x(both), y(both) {}
  Period(int across, int down) : x(across), y(down) {}
  int x;
  int y;
};

double Clamp(double value, double low, double high);
double Mix(double a, double b, double t);
double SmoothStep(double low, double high, double value);

// In [0, 1).
double Random(int x, int y, uint32_t seed);

// Gradient noise with one cell per unit, about -0.7 to 0.7, mean 0.
double Noise(Point p, uint32_t seed, Period period = {});
// A sum of `octaves` of it, each twice as fine and half as strong; about -1 to 1.
double Fractal(Point p, int octaves, uint32_t seed, Period period = {});

// The nearest of random points, one in each cell.
struct Cell {
  double nearest = 0;  // distance to the nearest point
  double border = 0;   // distance to the second nearest minus distance to the nearest
  double value = 0;    // the nearest point's own random number, in [0, 1)
  Point offset;        // from the point to p
};
Cell Cells(Point p, uint32_t seed, Period period = {});

}  // namespace texgraph::pictures
