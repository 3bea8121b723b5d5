// SPDX-License-Identifier: Apache-2.0
#include "graphs/pictures/noise.h"

#include <cmath>

namespace texgraph::pictures {

namespace {

uint32_t Hash(uint32_t x) {
  uint32_t state = x * 747796405u + 2891336453u;
  uint32_t word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}

// The random bits of a row of cells, and of the cells in it.
uint32_t RowBits(int y, uint32_t seed) { return Hash(static_cast<uint32_t>(y) + Hash(seed)); }
uint32_t CellBits(int x, uint32_t row) { return Hash(static_cast<uint32_t>(x) + row); }

// Most values are in the period already, and a division takes long.
int Wrap(int value, int period) {
  if (period == 0 || (value >= 0 && value < period)) return value;
  return ((value % period) + period) % period;
}

// Without a call of the library, which pictures would spend a quarter of their time in.
int Floor(double value) {
  const int whole = static_cast<int>(value);
  return whole - (value < whole);
}

double Fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

// The dot product of (dx, dy) with one of 16 directions.
double Slope(uint32_t bits, double dx, double dy) {
  static constexpr double kDirections[8][2] = {{1, 0},          {0.924, 0.383}, {0.707, 0.707},
                                               {0.383, 0.924},  {0, 1},         {-0.383, 0.924},
                                               {-0.707, 0.707}, {-0.924, 0.383}};
  const double* direction = kDirections[(bits >> 8) & 7];
  double slope = direction[0] * dx + direction[1] * dy;
  return (bits >> 16) & 1 ? -slope : slope;
}

}  // namespace

double Clamp(double value, double low, double high) {
  return value < low ? low : value > high ? high : value;
}

double Mix(double a, double b, double t) { return a + (b - a) * t; }

double SmoothStep(double low, double high, double value) {
  double t = Clamp((value - low) / (high - low), 0, 1);
  return t * t * (3 - 2 * t);
}

double Random(int x, int y, uint32_t seed) {
  return static_cast<double>(CellBits(x, RowBits(y, seed))) / 4294967296.0;
}

double Noise(Point p, uint32_t seed, Period period) {
  const int x = Floor(p.x), y = Floor(p.y);
  const double dx = p.x - x, dy = p.y - y, fade = Fade(dx);
  const int left = Wrap(x, period.x), right = Wrap(x + 1, period.x);
  const auto along = [&](int row, double to_row) {
    const uint32_t bits = RowBits(Wrap(row, period.y), seed);
    return Mix(Slope(CellBits(left, bits), dx, to_row),
               Slope(CellBits(right, bits), dx - 1, to_row), fade);
  };
  return Mix(along(y, dy), along(y + 1, dy - 1), Fade(dy));
}

double Fractal(Point p, int octaves, uint32_t seed, Period period) {
  double sum = 0;
  double strength = 1;
  for (int i = 0; i < octaves; ++i) {
    sum += strength * Noise(p, seed + static_cast<uint32_t>(i), period);
    p = {2 * p.x, 2 * p.y};
    period = {2 * period.x, 2 * period.y};
    strength *= 0.5;
  }
  return sum;
}

Cell Cells(Point p, uint32_t seed, Period period) {
  const int x0 = Floor(p.x), y0 = Floor(p.y);
  double first = 1e9;
  double second = 1e9;
  Cell cell;
  for (int y = y0 - 1; y <= y0 + 1; ++y) {
    for (int x = x0 - 1; x <= x0 + 1; ++x) {
      int wx = Wrap(x, period.x);
      int wy = Wrap(y, period.y);
      double dx = p.x - (x + Random(wx, wy, seed));
      double dy = p.y - (y + Random(wx, wy, seed + 1));
      double square = dx * dx + dy * dy;
      if (square < first) {
        second = first;
        first = square;
        cell.value = Random(wx, wy, seed + 2);
        cell.offset = {dx, dy};
      } else if (square < second) {
        second = square;
      }
    }
  }
  cell.nearest = std::sqrt(first);
  cell.border = std::sqrt(second) - cell.nearest;
  return cell;
}

}  // namespace texgraph::pictures
