// SPDX-License-Identifier: Apache-2.0
// Divides a square of texels among labels so that the borders between labels cost as little as
// possible: alpha expansion (Boykov, Veksler and Zabih 2001), each move an exact minimum cut.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace texgraph::textures {

struct TileCut {
  uint32_t side = 0;
  // For each texel, x fastest: its label, and the set of labels that it may have, a bit each. The
  // label is one of them. A texel with one bit stays.
  std::vector<uint8_t> labels;
  std::vector<uint8_t> allowed;
  // What it costs that the texel could be of either label; a border between two texels of labels a
  // and b costs the sum for both. Metric in the labels, at most 2^24.
  std::function<int32_t(uint32_t x, uint32_t y, uint32_t a, uint32_t b)> cost;

  // Of all borders.
  int64_t Energy() const;
  // Moves labels until no expansion of one label makes the borders cheaper. Never dearer than
  // before.
  void Improve();
};

}  // namespace texgraph::textures
