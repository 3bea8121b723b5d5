// SPDX-License-Identifier: Apache-2.0
// The numbers below a size in random order, as Perlin's hash is a table of them (An Image
// Synthesizer, 1985). The same on all machines.
#pragma once

#include <cstdint>

#include "compiler/base/number_map.h"

namespace texgraph::textures {

// One row of `size` numbers, each of 0 to size - 1 once.
NumberMap MakePermutation(uint32_t size, uint32_t seed);

}  // namespace texgraph::textures
