// SPDX-License-Identifier: Apache-2.0
// Which values need a derivative: those that reach the coordinate of a sample that needs an explicit gradient, or dx and dy, and
// whatever these are computed from. Everything else is left as it is.
#pragma once

#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

#include "compiler/passes/continuity.h"

namespace texgraph::passes {

// How a sample with implicit derivatives is written.
enum class SampleMode : uint8_t {
  kImplicit,  // the coordinate is plainly continuous, in uniform flow: texture()
  kGradient,  // textureGrad() with the coordinate's derivative
  kBase,      // the coordinate has no derivative: textureLod(..., 0.0)
};

struct Demand {
  const FunctionContinuity* continuity = nullptr;
  std::vector<bool> requested;   // by result leaf: the caller wants its derivative
  std::vector<bool> wanted;      // by leaf of each value, indexed as in continuity->states
  std::vector<bool> parameters;  // by parameter leaf: its derivative is passed in
  std::vector<const Demand*> calls;  // by value; shorter, or null, where there is none

  bool Wanted(ir::ValueId v, uint32_t leaf = 0) const { return wanted[continuity->first[v.index] + leaf]; }
};

class DemandTable {
 public:
  DemandTable(const std::deque<ir::Function>& functions, Leaves& leaves)
      : functions_(functions), leaves_(leaves) {}
  // `requested` by result leaf; those without a derivative are ignored.
  const Demand& Of(const FunctionContinuity& continuity, const std::vector<bool>& requested);

 private:
  friend class DemandScan;
  const std::deque<ir::Function>& functions_;
  Leaves& leaves_;
  // A function's results are asked for in few ways.
  std::unordered_map<const FunctionContinuity*, std::vector<std::unique_ptr<Demand>>> known_;
};

SampleMode ModeOfSample(const ir::Function& function, const FunctionContinuity& continuity, ir::ValueId sample);

}  // namespace texgraph::passes
