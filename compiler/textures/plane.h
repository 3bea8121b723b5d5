// SPDX-License-Identifier: Apache-2.0
// One channel of numbers, as prepared textures are computed: row 0 is v = 0, x fastest.
#pragma once

#include <cstdint>
#include <vector>

namespace texgraph::textures {

struct Plane {
  uint32_t width = 1;
  uint32_t height = 1;
  std::vector<float> values;

  float At(uint32_t x, uint32_t y) const { return values[size_t{y} * width + x]; }
};

}  // namespace texgraph::textures
