// SPDX-License-Identifier: Apache-2.0
// Random modules for comparing two ways of running or transforming them: unsimplified against
// simplified, CPU against GPU. The same seed and options give the same module everywhere.
#pragma once

#include <cstdint>

#include "compiler/ir/evaluate.h"
#include "compiler/ir/module.h"

namespace texgraph::fuzz {

struct RandomModuleOptions {
  uint32_t functions = 3;  // beside main
  uint32_t values = 24;    // operations of a body, more or less
  uint32_t depth = 2;      // of ifs and loops in one another
  // Every operation is defined for the values that it gets, no integer is divided by zero, no float
  // becomes infinite, NaN, or larger than about 10^6. Without it anything goes, which only the CPU
  // defines.
  bool tame = true;
  // Only operations that CPU and GPU compute to the bit (ops.def: ulp 0).
  bool exact = true;
  bool matrices = true;
  bool aggregates = true;    // structs and arrays
  bool textures = false;     // samplers with explicit levels and texel fetches
  bool derivatives = false;  // dx and dy, outside of branches and loops alone
};

// A well-formed module with inputs, uniforms and, if asked for, textures. It was built without
// folding, so there is plenty to simplify. main's results are floats, vectors and integers.
ir::Module RandomModule(uint32_t seed, const RandomModuleOptions& options);

// Values for the globals of a module. They depend on the names of the globals and the seed alone,
// so that modules with some globals left out get the same ones. Tame floats lie between -4 and 4.
ir::EvaluateInputs RandomInputs(const ir::Module& module, uint32_t seed, uint32_t lanes, bool tame);

// What running main costs: the costs of ops.def for each component, calls and loops run through,
// both sides of every if.
uint64_t CostOfMain(const ir::Module& module);

}  // namespace texgraph::fuzz
