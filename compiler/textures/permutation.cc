// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/permutation.h"

#include <utility>

#include "compiler/textures/tile_patches.h"

namespace texgraph::textures {

// Fisher and Yates, from the last number on.
NumberMap MakePermutation(uint32_t size, uint32_t seed) {
  NumberMap map;
  map.width = size;
  map.height = 1;
  for (uint32_t i = 0; i < size; ++i) map.numbers.push_back(static_cast<int32_t>(i));
  for (uint32_t i = size; i > 1; --i) {
    const auto other = static_cast<uint32_t>(uint64_t{TileHash(seed, i)} * i >> 32);
    std::swap(map.numbers[i - 1], map.numbers[other]);
  }
  return map;
}

}  // namespace texgraph::textures
