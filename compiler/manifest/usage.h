// SPDX-License-Identifier: Apache-2.0
// What of a graph is still there: in the module that is printed, and, for constants that leave no
// trace in it, in the graph.
#pragma once

#include <vector>

#include "compiler/graph/checked_graph.h"
#include "compiler/ir/module.h"

namespace texgraph::manifest {

// By GlobalId: whether main or a function that it calls uses the global's value.
std::vector<bool> UsedGlobals(const ir::Module& module);

// By index of the parameter: whether an output depends on it through connections.
std::vector<bool> NeededParameters(const graph::CheckedGraph& graph);

}  // namespace texgraph::manifest
