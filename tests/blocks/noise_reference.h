// SPDX-License-Identifier: Apache-2.0
// The noises in double precision and any number of dimensions, each as the sum over the corners
// around a point that the papers have. One function for all dimensions: no formula is a block's.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "tests/blocks/reference.h"

namespace texgraph::blocks::reference {

using Place = std::vector<double>;

enum class Noise { kValue, kGradient, kSimplex };

// Nested from the last coordinate to the first.
inline uint32_t CornerHash(const std::vector<int64_t>& cell, uint32_t seed) {
  uint32_t bits = Pcg(seed);
  for (size_t i = cell.size(); i-- > 0;) bits = Pcg(static_cast<uint32_t>(cell[i]) + bits);
  return bits;
}

inline double Signed(uint32_t bits) { return static_cast<int32_t>(bits) / 2147483648.0; }

// The slope that belongs to a corner's bits.
inline Place SlopeOf(uint32_t bits, size_t dimensions) {
  const double x = Signed(bits);
  if (dimensions == 1) return {x};
  if (dimensions == 2) {
    const double y = 1 - std::fabs(x);
    return {x, bits % 2 ? -y : y};
  }
  if (dimensions == 3) {
    const double y = Signed(bits << 16);
    const double z = 1 - std::fabs(x) - std::fabs(y);
    if (z >= 0) return {x, y, z};
    return {std::copysign(1 - std::fabs(y), x), std::copysign(1 - std::fabs(x), y), z};
  }
  Place slope(4);
  for (uint32_t i = 0; i < 4; ++i) slope[i] = bits / (1u << (29 - i)) % 2 ? -1 : 1;
  slope[bits / (1u << 30)] = 0;
  return slope;
}

// One over the greatest sum, by dimensions. Found by search over the places, each corner with the
// slope that is the worst there.
inline double Amplitude(Noise noise, size_t dimensions) {
  constexpr double kGradient[] = {2.0, 1.868193567, 1.776509413, 0.650794935};
  constexpr double kSimplex[] = {3.160493827, 102.3366518, 108.2249133, 62.77770716};
  return noise == Noise::kValue      ? 1
         : noise == Noise::kGradient ? kGradient[dimensions - 1]
                                     : kSimplex[dimensions - 1];
}

struct Corner {
  std::vector<int64_t> cell;
  Place way;  // from the corner to the place
  double weight;
};

inline std::vector<Corner> LatticeCorners(const Place& p) {
  std::vector<Corner> corners;
  for (uint32_t which = 0; which < 1u << p.size(); ++which) {
    Corner corner{{}, {}, 1};
    for (size_t i = 0; i < p.size(); ++i) {
      const bool far = which >> i & 1;
      const double t = p[i] - std::floor(p[i]);
      const double fade = 6 * std::pow(t, 5) - 15 * std::pow(t, 4) + 10 * std::pow(t, 3);
      corner.cell.push_back(static_cast<int64_t>(std::floor(p[i])) + far);
      corner.way.push_back(t - far);
      corner.weight *= far ? fade : 1 - fade;
    }
    corners.push_back(corner);
  }
  return corners;
}

inline std::vector<Corner> SimplexCorners(const Place& p) {
  const size_t n = p.size();
  // A line's simplices are its cells.
  const double root = n == 1 ? 1 : std::sqrt(n + 1.0);
  const double skew = (root - 1) / n, back = (1 - 1 / root) / n;
  const double sum = std::accumulate(p.begin(), p.end(), 0.0);
  Corner corner{std::vector<int64_t>(n), Place(n), 0};
  for (size_t i = 0; i < n; ++i) {
    corner.cell[i] = static_cast<int64_t>(std::floor(p[i] + sum * skew));
  }
  const double cells =
      static_cast<double>(std::accumulate(corner.cell.begin(), corner.cell.end(), int64_t{0}));
  for (size_t i = 0; i < n; ++i) corner.way[i] = p[i] - (corner.cell[i] - cells * back);
  std::vector<size_t> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, [&](size_t a, size_t b) { return corner.way[a] > corner.way[b]; });
  std::vector<Corner> corners;
  for (size_t k = 0; k <= n; ++k) {
    if (k > 0) {
      ++corner.cell[order[k - 1]];
      corner.way[order[k - 1]] -= 1;
      for (double& way : corner.way) way += back;
    }
    double r = n == 1 ? 1 : 0.5;
    for (double way : corner.way) r -= way * way;
    corner.weight = std::pow(std::max(r, 0.0), 4);
    corners.push_back(corner);
  }
  return corners;
}

inline std::vector<Corner> CornersOf(Noise noise, const Place& p) {
  return noise == Noise::kSimplex ? SimplexCorners(p) : LatticeCorners(p);
}

// From 0 to 1, at a place in cells. A period of 0 is none.
inline double NoiseAt(Noise noise, const Place& p, uint32_t seed,
                      const std::vector<int64_t>& period = {}) {
  double sum = 0;
  for (Corner& corner : CornersOf(noise, p)) {
    for (size_t i = 0; i < period.size(); ++i) {
      if (period[i] > 0) corner.cell[i] = (corner.cell[i] % period[i] + period[i]) % period[i];
    }
    const uint32_t bits = CornerHash(corner.cell, seed);
    if (noise == Noise::kValue) {
      sum += corner.weight * (2 * Unit24(bits) - 1);
      continue;
    }
    const Place slope = SlopeOf(bits, p.size());
    sum += corner.weight * std::inner_product(slope.begin(), slope.end(), corner.way.begin(), 0.0);
  }
  return 0.5 + 0.5 * Amplitude(noise, p.size()) * sum;
}

// What the noise's variance is in the mean over all slopes, at a place.
inline double VarianceAt(Noise noise, const Place& p) {
  constexpr double kSlopes[] = {1 / 3.0, 1 / 3.0, 1 / 6.0, 3 / 4.0};
  double sum = 0;
  for (const Corner& corner : CornersOf(noise, p)) {
    const double square =
        noise == Noise::kValue
            ? 1 / 3.0
            : kSlopes[p.size() - 1] *
                  std::inner_product(corner.way.begin(), corner.way.end(), corner.way.begin(), 0.0);
    sum += corner.weight * corner.weight * square;
  }
  return 0.25 * std::pow(Amplitude(noise, p.size()), 2) * sum;
}

}  // namespace texgraph::blocks::reference
