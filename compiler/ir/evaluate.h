// SPDX-License-Identifier: Apache-2.0
// Runs a module on the CPU, many pixels at a time. Pixels lie in quads of 2 x 2, so that hardware derivatives (dfdx, dfdy and the
// level of implicit samples) are the differences that a GPU takes. It runs any module: before Specialize (fields and template
// parameters), before Differentiate (dx, dy as quad differences) and after.
//
// The sides of an if run where a pixel of a quad takes them, and then for the whole quad, as helper pixels do on a GPU. So what a
// pixel gets depends on its quad alone, and a difference inside a branch is what it would be in uniform control flow. Implicit
// samples have one level a quad, from its left bottom pixel's differences.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/ir/texture.h"

namespace texgraph::ir {

// Lane l of quad q is pixel 4q + l: 0 left bottom, 1 right bottom, 2 left top, 3 right top (y up, as in GL).

// Sees each operation's value when it has been computed, and may change it: for tests that ask what
// roundings do to a result, or whether something was not finite on the way.
class EvaluateObserver {
 public:
  virtual ~EvaluateObserver() = default;
  // Word w of lane l of the batch, whose lanes start at `first_lane`, is at [w * lanes + l], of the
  // operands as well (of samples: without the sampler). Lanes that are not `active` hold anything.
  virtual void OnValue(const Function& function, ValueId v,
                       std::span<const uint32_t* const> operands, uint32_t first_lane,
                       uint32_t lanes, uint64_t active, uint32_t* words) = 0;
};

struct EvaluateInputs {
  uint32_t lanes = 4;                              // a multiple of 4
  std::vector<std::vector<uint32_t>> globals;      // by GlobalId; word w of lane l at [w * lanes + l]; uniforms may hold one lane
                                                   // (Types::Words words); empty: the default, or zeros. Textures: empty
  std::vector<const Texture*> textures;            // by GlobalId; null where the global is no texture. What has no texture samples
                                                   // as (0, 0, 0, 1)
  EvaluateObserver* observer = nullptr;            // of arithmetic and samples; not of calls, ifs and loops themselves
};

// Calls nest no deeper; deeper ones end the program with a message.
inline constexpr uint32_t kMaxCallDepth = 256;

// The results of `function` (module.main as a rule), one vector each, laid out as above. `arguments` are its parameters', none
// for main; they may hold one lane too. A sampler is the GlobalId of its texture; fields cannot be passed. The module must be well
// formed (verify.h), and the vectors of the sizes said: anything else ends the program with a message.
std::vector<std::vector<uint32_t>> Evaluate(const Module& module, FunctionId function,
                                            const EvaluateInputs& inputs,
                                            std::span<const std::vector<uint32_t>> arguments = {});

}  // namespace texgraph::ir
