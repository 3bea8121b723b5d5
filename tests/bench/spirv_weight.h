// SPDX-License-Identifier: Apache-2.0
// How heavy a fragment shader is: what is left of its SPIR-V after spirv-opt -O.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace texgraph::bench {

struct Weight {
  int instructions = 0;  // in functions, without labels and variables
  // Of these, what computes: no loads, stores, addresses, moves of components, bits seen as another
  // type, merges, phis, jumps or returns. Conditional branches count.
  int computing = 0;
  int samples = 0;  // and fetches
};

// Nothing if the optimizer refuses the module.
std::optional<Weight> WeightOf(const std::vector<uint32_t>& spirv);

}  // namespace texgraph::bench
