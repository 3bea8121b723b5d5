// SPDX-License-Identifier: Apache-2.0
// Points all over a square, evenly and in no order, far from whole multiples of anything: Roberts'
// sequence R2, multiples of the plastic number's reciprocal and of its square.
#pragma once

#include <cmath>
#include <vector>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {

// From `low` to `high` in both directions.
inline std::vector<Point> ScatteredPoints(int count, double low = 0, double high = 1) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double x = std::fmod(0.1234 + 0.7548776662 * i, 1);
    const double y = std::fmod(0.5678 + 0.5698402910 * i, 1);
    points.push_back({low + (high - low) * x, low + (high - low) * y});
  }
  return points;
}

}  // namespace texgraph::blocks
