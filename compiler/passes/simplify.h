// SPDX-License-Identifier: Apache-2.0
// Simplify, with the choice of rules that tests need.
#pragma once

#include "compiler/passes/passes.h"
#include "compiler/passes/rules.h"

namespace texgraph::passes {

// Simplify with rules whose flags are among `allowed` alone: with kExact, every result keeps its
// bits.
void Simplify(ir::Module& module, RuleFlags allowed);

}  // namespace texgraph::passes
