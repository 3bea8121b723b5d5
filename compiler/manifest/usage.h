// SPDX-License-Identifier: Apache-2.0
// Which parameters of a graph matter. For constants the printed module does not tell: they left no
// trace in it.
#pragma once

#include <vector>

#include "compiler/graph/checked_graph.h"

namespace texgraph::manifest {

// By index of the parameter: whether an output depends on it through connections.
std::vector<bool> NeededParameters(const graph::CheckedGraph& graph);

}  // namespace texgraph::manifest
