// SPDX-License-Identifier: Apache-2.0
// Leaves in a function only what its results need: builders that simplify leave behind operands
// that nothing uses any more, and regions of folded ifs.
#pragma once

#include "compiler/ir/module.h"

namespace texgraph::passes {

// Whether something is left that building the function again would make simpler: a branch that has
// become a choice, values that an if or a loop carries for nothing.
bool Compact(const ir::Module& module, ir::Function& function);

}  // namespace texgraph::passes
