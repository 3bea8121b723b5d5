// SPDX-License-Identifier: Apache-2.0
// Random valid graphs as texts. What blocks there are, and what their ports take, is asked of the
// library, so a new block is used without a change here. The same seed and library give the same
// text.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "compiler/graph/document.h"
#include "tests/fuzz/document_tree.h"

namespace texgraph::fuzz {

struct RandomGraphOptions {
  uint32_t nodes = 14;          // of the graph itself, at most
  uint32_t functions = 3;       // at most
  uint32_t function_nodes = 5;  // of each
};

struct RandomGraphText {
  Tree tree;
  graph::DocumentFormat format = graph::DocumentFormat::kJson;
  std::string text;
  std::set<std::string> blocks;  // that its nodes use

  std::string FileName(uint32_t seed) const;  // "graph_17.yaml"
};

RandomGraphText RandomGraph(uint32_t seed, const RandomGraphOptions& options = {});
std::string PrintTree(const Tree& tree, graph::DocumentFormat format);

// The blocks that a graph can use, by name: all but those that need what graphs have not.
std::set<std::string> UsableBlocks();

// Writes the images that the graphs name into a folder. False if that fails.
bool WriteGraphImages(const std::string& folder);

}  // namespace texgraph::fuzz
