// SPDX-License-Identifier: Apache-2.0
// The copies of a bombed plane, in double precision and from the definitions rather than from the
// blocks: pcg2d step by step, and every cell far around.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks::reference {

// Jarzynski and Olano 2020, pcg2d up to its last step, the seed added after its first product and
// the copy's number as a further coordinate; then four sums of the two words.
inline std::array<uint32_t, 4> CopyBits(int32_t x, int32_t y, int32_t copy, uint32_t seed) {
  constexpr uint32_t kA = 1664525;
  const uint32_t number = static_cast<uint32_t>(copy);
  uint32_t vx = static_cast<uint32_t>(x) * kA + 0;
  uint32_t vy = static_cast<uint32_t>(y) * kA + 0;
  vx += vy * kA;
  vy += vx * kA;
  vx += Pcg(seed) + number * 2654435769u;
  vy += Pcg(Pcg(seed)) + number * 1540483477u;
  vx ^= vx >> 16;
  vy ^= vy >> 16;
  const uint32_t last_x = vx + vy * kA;
  const uint32_t last_y = vy + last_x * kA;
  return {vx * 3266489917u + vy * 2246822519u, vx * 668265263u + vy * 3432918353u,
          vx * 374761393u + vy * 461845907u, last_y};
}

struct Plane {
  double jitter = 1;
  double size_min = 1, size_max = 1;
  double rotation_min = 0, rotation_max = 0;  // degrees
  bool is_disc = false;
  int copies = 1;
  double density = 1;
  uint32_t seed = 0;
  bool is_hexagonal = false;
  double spacing = 0;
};

struct Copy {
  Point centre;
  double side = 1, angle = 0;
  uint32_t seed = 0, rank = 0;
  int index = 0;        // in its cell
  Point q;              // the point in its image
  double edge = 0;      // how far inside the point is, in its image; below 0 outside
  double distance = 0;  // from its centre
};

inline Point CentreOf(const Plane& plane, int x, int y, const std::array<uint32_t, 4>& bits) {
  const double moved = plane.is_hexagonal && y % 2 != 0 ? 0.5 : 0;
  const double height = plane.is_hexagonal ? std::sqrt(0.75) : 1;
  return {x + 0.5 - moved + plane.jitter * static_cast<int32_t>(bits[0]) / 4294967296.0,
          height * (y + 0.5 + plane.jitter * static_cast<int32_t>(bits[1]) / 4294967296.0)};
}

// Whether another copy of at least its rank is nearer than the spacing to one of cell (x, y).
inline bool IsCrowded(const Plane& plane, int x, int y, int copy) {
  constexpr int kFar = 5;
  const auto own = CopyBits(x, y, copy, plane.seed);
  const Point centre = CentreOf(plane, x, y, own);
  for (int v = y - kFar; v <= y + kFar; ++v) {
    for (int u = x - kFar; u <= x + kFar; ++u) {
      for (int i = 0; i < plane.copies; ++i) {
        const auto bits = CopyBits(u, v, i, plane.seed);
        if ((u == x && v == y && i == copy) || bits[2] < own[2]) continue;
        const Point other = CentreOf(plane, u, v, bits);
        if (std::hypot(other.x - centre.x, other.y - centre.y) < plane.spacing) return true;
      }
    }
  }
  return false;
}

// Those at p, given in cells, in the order of rows, columns and numbers.
inline std::vector<Copy> CopiesAt(const Plane& plane, Point p) {
  constexpr int kFar = 5;
  std::vector<Copy> copies;
  const double height = plane.is_hexagonal ? std::sqrt(0.75) : 1;
  const int column = static_cast<int>(std::floor(p.x));
  const int row = static_cast<int>(std::floor(p.y / height));
  for (int y = row - kFar; y <= row + kFar; ++y) {
    for (int x = column - kFar; x <= column + kFar; ++x) {
      for (int i = 0; i < plane.copies; ++i) {
        const auto bits = CopyBits(x, y, i, plane.seed);
        Copy copy;
        copy.seed = bits[3];
        copy.rank = bits[2];
        copy.index = i;
        if (Unit24(Pcg(copy.seed - 3)) >= plane.density) continue;
        copy.centre = CentreOf(plane, x, y, bits);
        if (std::hypot(p.x - copy.centre.x, p.y - copy.centre.y) > 0.75 * plane.size_max) continue;
        if (plane.spacing > 0 && IsCrowded(plane, x, y, i)) continue;
        const uint32_t pose = Pcg(copy.seed - 2);
        copy.side = Mix(plane.size_min, plane.size_max, Low16(pose));
        copy.angle =
            Mix(plane.rotation_min, plane.rotation_max, High16(pose)) * std::numbers::pi / 180;
        const double c = std::cos(copy.angle), s = std::sin(copy.angle);
        const Point d{p.x - copy.centre.x, p.y - copy.centre.y};
        copy.q = {(c * d.x + s * d.y) / copy.side + 0.5, (c * d.y - s * d.x) / copy.side + 0.5};
        const Point arm{std::fabs(copy.q.x - 0.5), std::fabs(copy.q.y - 0.5)};
        copy.edge = 0.5 - (plane.is_disc ? std::hypot(arm.x, arm.y) : std::max(arm.x, arm.y));
        copy.distance = std::hypot(d.x, d.y);
        copies.push_back(copy);
      }
    }
  }
  return copies;
}

}  // namespace texgraph::blocks::reference
