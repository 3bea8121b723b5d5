// SPDX-License-Identifier: Apache-2.0
// Leaves in a function only what its results need: builders that simplify leave behind operands
// that nothing uses any more, and regions of folded ifs.
#pragma once

#include <utility>
#include <vector>

#include "compiler/ir/module.h"

namespace texgraph::passes {

// What is known on one side of an if beside its condition being `taken`: values of type bool, the
// condition among them, and what they are.
std::vector<std::pair<ir::ValueId, bool>> KnownOnSide(const ir::Function& function,
                                                      ir::ValueId condition, bool taken);

// Whether something is left that building the function again would make simpler: a branch that has
// become a choice, values that an if or a loop carries for nothing, a side of an if that asks what
// is known there.
bool Compact(const ir::Module& module, ir::Function& function);

}  // namespace texgraph::passes
