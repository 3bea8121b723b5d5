// SPDX-License-Identifier: Apache-2.0
// Turns valid graphs into texts that are most often wrong, each in its own way.
#pragma once

#include <random>
#include <string>

#include "tests/fuzz/random_graph.h"

namespace texgraph::fuzz {

// One to three random changes: members deleted, doubled, swapped, renamed, of another type or from
// elsewhere in the graph; or bytes of the text.
std::string BreakGraph(const RandomGraphText& graph, std::mt19937& random);

}  // namespace texgraph::fuzz
