// SPDX-License-Identifier: Apache-2.0
// How every value of a function changes over the surface, as far as texture filtering cares. A function is looked at once for
// each combination of its parameters' states and of the flow that it is called in.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <vector>

#include "compiler/ir/module.h"
#include "compiler/passes/leaves.h"

namespace texgraph::passes {

enum class Continuity : uint8_t {
  kUniform,  // the same at every pixel
  kPlain,    // continuous in the inputs: differences between neighbouring pixels are its derivative
  kStepped,  // constant but for jumps: its derivative is zero (a cell id, a hash)
  kRough,    // has a derivative, and jumps: differences between pixels are wrong at the jumps
};

struct FunctionContinuity {
  ir::FunctionId function;
  std::vector<Continuity> states;   // by leaf: leaf l of value v is states[first[v] + l]
  std::vector<uint32_t> first;      // by value
  std::vector<Continuity> results;  // the leaves of all results, in order
  std::vector<bool> uniform_flow;   // by value, for samples and calls: every pixel of a quad comes here, once
  std::vector<const FunctionContinuity*> calls;  // by value; shorter, or null, where there is none
};

class ContinuityTable {
 public:
  // `functions` is what ids refer to; the module gives types and globals.
  ContinuityTable(const ir::Module& module, const std::deque<ir::Function>& functions, Leaves& leaves)
      : module_(module), functions_(functions), leaves_(leaves) {}

  // `parameters`: the states of the leaves of all parameters, in order.
  const FunctionContinuity& Of(ir::FunctionId function, const std::vector<Continuity>& parameters,
                               bool uniform_flow);

 private:
  friend class ContinuityScan;
  const ir::Module& module_;
  const std::deque<ir::Function>& functions_;
  Leaves& leaves_;
  std::map<std::vector<uint8_t>, std::unique_ptr<FunctionContinuity>> known_;
  std::vector<uint8_t> key_;  // of what is asked for
};

}  // namespace texgraph::passes
