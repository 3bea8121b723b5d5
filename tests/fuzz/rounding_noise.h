// SPDX-License-Identifier: Apache-2.0
// How far two right ways of computing one thing may differ: the module is run again with every
// inexact operation disturbed by roundings of its own size, and what that does to a result is what
// it may differ by. A result at the edge of a step may fall to either side; one in the middle of a
// smooth surface has hardly any slack. (Monte Carlo arithmetic: Parker, Pierce and Eggert,
// Monte Carlo Arithmetic: How to Gamble with Floating Point and Win, CiSE 2(4), 2000.)
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/ir/evaluate.h"

namespace texgraph::fuzz {

struct NoiseOptions {
  double roundings = 2;  // so many times the bound of ops.def, at least one unit in the last place
  double texels = 0;     // a sample's components are off by so much
};

struct NoisyResults {
  std::vector<std::vector<uint32_t>> words;  // without noise, as Evaluate gives them
  std::vector<std::vector<double>> slack;    // one for each word; how much the word may differ
  // By lane: something on the way was infinite, NaN or subnormal, or what ops.def calls undefined
  // on a GPU. What the lane's results are is then not promised.
  std::vector<bool> undefined;
};

// main's results.
NoisyResults EvaluateWithNoise(const ir::Module& module, ir::EvaluateInputs inputs,
                               const NoiseOptions& options = {});

}  // namespace texgraph::fuzz
