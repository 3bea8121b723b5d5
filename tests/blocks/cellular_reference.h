// SPDX-License-Identifier: Apache-2.0
// Scattered points and distances to them by brute force, in double precision: what the blocks of
// stdlib_blocks/cellular are compared with. No cell is left out that is within four of a place.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "tests/blocks/reference.h"

namespace texgraph::blocks::reference {

// y of pcg2d and z of pcg3d, without the last xor of shifts, as the library's cell_hash.
template <int kDimensions>
uint32_t CellBits(std::array<int32_t, kDimensions> cell, int32_t seed) {
  uint32_t v[kDimensions], bits = static_cast<uint32_t>(seed);
  for (int i = 0; i < kDimensions; ++i) {
    bits = Pcg(bits);
    v[i] = static_cast<uint32_t>(cell[i]) * 1664525u + (kDimensions == 3 ? bits : 0);
  }
  if constexpr (kDimensions == 2) {
    const uint32_t first = Pcg(static_cast<uint32_t>(seed));
    v[0] += v[1] * 1664525u;
    v[1] += v[0] * 1664525u;
    v[0] += first;
    v[1] += Pcg(first);
    for (uint32_t& word : v) word ^= word >> 16;
    v[0] += v[1] * 1664525u;
    v[1] += v[0] * 1664525u;
    return v[1];
  } else {
    auto round = [&v] {
      for (int i = 0; i < 3; ++i) v[i] += v[(i + 1) % 3] * v[(i + 2) % 3];
    };
    round();
    for (uint32_t& word : v) word ^= word >> 16;
    round();
    return v[2];
  }
}

// Where the point of a cell with these bits is, in the cell, if it may be anywhere.
template <int kDimensions>
std::array<double, kDimensions> PointOf(uint32_t bits) {
  const uint32_t two = Pcg(bits - 1);
  std::array<double, kDimensions> point{Low16(two), High16(two)};
  if constexpr (kDimensions == 3) point[2] = Unit24(Pcg(two));
  return point;
}

template <int kDimensions>
class Scattered {
 public:
  using Place = std::array<double, kDimensions>;
  using Cell = std::array<int32_t, kDimensions>;
  static constexpr int kReach = 4;
  static constexpr int kSides = 2 * kReach + 1;

  // All cells that are within kReach of cells from `low` to `high`.
  Scattered(int low, int high, int32_t seed, double jitter)
      : low_(low - kReach), side_(high - low + 1 + 2 * kReach) {
    size_t count = 1;
    for (int i = 0; i < kDimensions; ++i) count *= static_cast<size_t>(side_);
    for (size_t n = 0; n < count; ++n) {
      Cell cell;
      size_t rest = n;
      for (int i = 0; i < kDimensions; ++i) {
        cell[i] = low_ + static_cast<int>(rest % static_cast<size_t>(side_));
        rest /= static_cast<size_t>(side_);
      }
      Place point = PointOf<kDimensions>(CellBits<kDimensions>(cell, seed));
      for (int i = 0; i < kDimensions; ++i) point[i] = cell[i] + 0.5 + jitter * (point[i] - 0.5);
      points_.push_back(point);
      cells_.push_back(cell);
    }
  }

  struct Found {
    double f1 = 1e9, f2 = 1e9, f3 = 1e9;
    double border = 1e9;  // for straight distances
    Cell cell{}, second_cell{};
    Place point{}, second_point{};
  };

  // An exponent of infinity stands for the greatest component.
  static double Length(const Place& arm, double exponent) {
    double sum = 0;
    for (double part : arm) {
      sum = std::isinf(exponent) ? std::max(sum, std::fabs(part))
            : exponent == 1      ? sum + std::fabs(part)
            : exponent == 2      ? sum + part * part
                                 : sum + std::pow(std::fabs(part), exponent);
    }
    return std::isinf(exponent) || exponent == 1 ? sum
           : exponent == 2                       ? std::sqrt(sum)
                                                 : std::pow(sum, 1 / exponent);
  }

  Found At(const Place& place, double exponent, bool with_border) const {
    Found found;
    size_t nearest = 0, second = 0;
    ForEach(place, [&](size_t n) {
      double length = Length(Minus(points_[n], place), exponent);
      if (length < found.f1) {
        found.f3 = found.f2;
        found.f2 = found.f1;
        found.f1 = length;
        second = nearest;
        nearest = n;
      } else if (length < found.f2) {
        found.f3 = found.f2;
        found.f2 = length;
        second = n;
      } else {
        found.f3 = std::min(found.f3, length);
      }
    });
    found.second_cell = cells_[second];
    found.second_point = points_[second];
    found.cell = cells_[nearest];
    found.point = points_[nearest];
    if (!with_border) return found;
    const Place mine = Minus(points_[nearest], place);
    ForEach(place, [&](size_t n) {
      if (n == nearest) return;
      const Place other = Minus(points_[n], place);
      double half_way = 0, square = 0;
      for (int i = 0; i < kDimensions; ++i) {
        const double across = other[i] - mine[i];
        half_way += 0.5 * (other[i] + mine[i]) * across;
        square += across * across;
      }
      found.border = std::min(found.border, half_way / std::sqrt(square));
    });
    return found;
  }

 private:
  static Place Minus(const Place& a, const Place& b) {
    Place difference;
    for (int i = 0; i < kDimensions; ++i) difference[i] = a[i] - b[i];
    return difference;
  }

  template <typename Function>
  void ForEach(const Place& place, Function function) const {
    size_t first = 0, stride = 1, strides[kDimensions];
    for (int i = 0; i < kDimensions; ++i) {
      int corner = static_cast<int>(std::floor(place[i])) - kReach - low_;
      first += stride * static_cast<size_t>(corner);
      strides[i] = stride;
      stride *= static_cast<size_t>(side_);
    }
    for (size_t z = 0; z < (kDimensions == 3 ? kSides : 1); ++z) {
      for (size_t y = 0; y < kSides; ++y) {
        for (size_t x = 0; x < kSides; ++x) {
          function(first + x + y * strides[1] + z * strides[kDimensions - 1]);
        }
      }
    }
  }

  int low_, side_;
  std::vector<Place> points_;
  std::vector<Cell> cells_;
};

}  // namespace texgraph::blocks::reference
