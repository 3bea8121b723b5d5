// SPDX-License-Identifier: Apache-2.0
// What is known of a function's results when only a part of its arguments is: a grid's tile has a
// size that follows from constants, and a place that does not. Every word of a value is known or
// not, for all pixels alike.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "compiler/ir/module.h"

namespace texgraph::ir {

struct KnownWords {
  std::vector<uint32_t> words;  // floats as their bits, bools as 0 or 1; 0 where not known
  std::vector<bool> known;      // by word

  static KnownWords Nothing(uint32_t count) {
    return {std::vector<uint32_t>(count), std::vector<bool>(count)};
  }
  static KnownWords All(std::span<const uint32_t> words) {
    return {{words.begin(), words.end()}, std::vector<bool>(words.size(), true)};
  }
  bool IsWhole() const;
};

// Result number `result`. `arguments`: one for each parameter; of a field, what is known of its
// results wherever it is asked; missing ones are not known. Globals, samples and derivatives are
// not known. Gives up, with nothing known, after kMostSteps operations.
inline constexpr uint32_t kMostSteps = 200'000;
KnownWords FindKnownResult(const Module& module, FunctionId function,
                           std::vector<KnownWords> arguments, uint32_t result);

}  // namespace texgraph::ir
