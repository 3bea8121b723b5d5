// SPDX-License-Identifier: Apache-2.0
// The passes, in the order in which compile.cc runs them. Each takes a whole module and leaves a whole module; a pass that can
// refuse returns false with the reason in `diagnostics`.
#pragma once

#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/graph/checked_graph.h"
#include "compiler/ir/module.h"

namespace texgraph::passes {

// Appends `main`: one call for each node that an output needs; its results are the graph's outputs, by name. Plain outputs at
// function ports, and graph functions, become functions of their own. `fold` is off only in tests.
bool BuildModule(const graph::CheckedGraph& graph, blocks::Library& library, ir::Module& module, bool fold,
                 Diagnostics& diagnostics);

// Afterwards no function takes a field, and no call passes a constant to a template parameter: one function for each distinct
// combination, the small ones inlined. What main does not reach is gone. Refuses with kInstanceLimit or kCostLimit.
// at `where`, the graph.
bool Specialize(ir::Module& module, bool fold, SourceRange where, Diagnostics& diagnostics);

// What kCostLimit bounds: the operations that main runs for one pixel, both sides of ifs counted, and two rounds of loops that
// end themselves. Of a specialised module.
uint64_t OperationsForAPixel(const ir::Module& module);

// The same meaning with never more operations: folds, applies the algebraic rules, merges equal values and parameters that
// always get the same, drops what nothing uses, globals, parameters and results of functions, and members of structs included.
// Functions and globals get new ids. Idempotent.
void Simplify(ir::Module& module);
// The same for a module of which only the functions of `changed` differ, by FunctionId, from what Simplify left.
void Simplify(ir::Module& module, const std::vector<bool>& changed);

// Replaces dx and dy, and gives every sample whose coordinate is not plainly continuous an explicit gradient. Afterwards dfdx
// and dfdy occur only at the top of main. Says by FunctionId which functions are not as they were before.
std::vector<bool> Differentiate(ir::Module& module, bool fold);

}  // namespace texgraph::passes
