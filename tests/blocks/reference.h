// SPDX-License-Identifier: Apache-2.0
// References for the tests of blocks, in double precision and from the papers' formulas rather than
// from the blocks.
#pragma once

#include <cmath>
#include <cstdint>

namespace texgraph::blocks::reference {

// PCG RXS-M-XS with 32 bits of state and output, one step from `value` (O'Neill 2014,
// section 6.3.4), in 64-bit arithmetic.
inline uint32_t Pcg(uint32_t value) {
  constexpr uint64_t kModulus = uint64_t{1} << 32;
  uint64_t state = (uint64_t{value} * 747796405u + 2891336453u) % kModulus;
  uint64_t shift = 4 + state / (uint64_t{1} << 28);
  uint64_t word = ((state / (uint64_t{1} << shift)) ^ state) * 277803737u % kModulus;
  return static_cast<uint32_t>((word / (uint64_t{1} << 22)) ^ word);
}

inline uint32_t CellHash(int32_t x, int32_t y, uint32_t seed) {
  return Pcg(static_cast<uint32_t>(x) + Pcg(static_cast<uint32_t>(y) + Pcg(seed)));
}

inline double Unit24(uint32_t bits) { return (bits >> 8) / 16777216.0; }
inline double Low16(uint32_t bits) { return (bits & 0xffff) / 65536.0; }
inline double High16(uint32_t bits) { return (bits >> 16) / 65536.0; }

inline double Mix(double a, double b, double t) { return a + (b - a) * t; }
inline double Clamp(double x, double low, double high) {
  return x < low ? low : x > high ? high : x;
}

// The length of [low, high] that lies in the set of all [n + first, n + last] for whole numbers n;
// 0 <= first <= last <= 1.
inline double OverlapWithCells(double low, double high, double first, double last) {
  double sum = 0;
  for (double n = std::floor(low); n <= high; n += 1) {
    double a = std::fmax(low, n + first);
    double b = std::fmin(high, n + last);
    sum += b > a ? b - a : 0;
  }
  return sum;
}

}  // namespace texgraph::blocks::reference
