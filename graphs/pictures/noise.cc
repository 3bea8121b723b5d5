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

uint32_t Hash(int x, int y, uint32_t seed) {
  return Hash(static_cast<uint32_t>(x) + Hash(static_cast<uint32_t>(y) + Hash(seed)));
}

int Wrap(int value, int period) {
  return period == 0 ? value : ((value % period) + period) % period;
}

double Fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

// The dot product of p with one of 16 directions.
double Slope(int x, int y, uint32_t seed, Period period, double dx, double dy) {
  static constexpr double kDirections[8][2] = {{1, 0},          {0.924, 0.383}, {0.707, 0.707},
                                               {0.383, 0.924},  {0, 1},         {-0.383, 0.924},
                                               {-0.707, 0.707}, {-0.924, 0.383}};
  uint32_t bits = Hash(Wrap(x, period.x), Wrap(y, period.y), seed);
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
  return static_cast<double>(Hash(x, y, seed)) / 4294967296.0;
}

double Noise(Point p, uint32_t seed, Period period) {
  int x = static_cast<int>(std::floor(p.x));
  int y = static_cast<int>(std::floor(p.y));
  double dx = p.x - x;
  double dy = p.y - y;
  double low =
      Mix(Slope(x, y, seed, period, dx, dy), Slope(x + 1, y, seed, period, dx - 1, dy), Fade(dx));
  double high = Mix(Slope(x, y + 1, seed, period, dx, dy - 1),
                    Slope(x + 1, y + 1, seed, period, dx - 1, dy - 1), Fade(dx));
  return Mix(low, high, Fade(dy));
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
  int x0 = static_cast<int>(std::floor(p.x));
  int y0 = static_cast<int>(std::floor(p.y));
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
