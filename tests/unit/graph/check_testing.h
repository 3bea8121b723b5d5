// SPDX-License-Identifier: Apache-2.0
// A graph's text checked against a handful of small blocks, and the result as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compiler/graph/checked_graph.h"
#include "tests/unit/graph/graph_testing.h"

namespace texgraph::graph {

struct CheckText {
  // `text` is the inside of the graph's root object but for the version and the outputs; it begins
  // on line 2. `outputs` is the inside of "outputs", from line 1, column 29 on.
  explicit CheckText(std::string_view text, std::string_view outputs = "\"height\": 0",
                     const std::vector<std::string>& settings = {});

  std::vector<std::string> Places() const { return graph::Places(diagnostics, sources); }
  std::string Messages() const { return graph::Messages(diagnostics); }
  // "scale=2.0:float uv=uv:vec2" for the node of that name: ports with their sources. A source of
  // another type than the port's: "noise.0:float->vec3". "none" if there is no such node.
  std::string NodeText(std::string_view name) const;
  std::string NodeText(const CheckedSubgraph& subgraph, std::string_view name) const;
  std::string OutputText(std::string_view name) const;
  // The nodes that are left, in their order.
  std::vector<std::string> NodeNames() const;

  Sources sources;
  Diagnostics diagnostics;
  ir::Module module;
  std::optional<blocks::Library> library;
  std::optional<Graph> graph;
  std::optional<CheckedGraph> checked;

 private:
  std::string PortText(const CheckedSubgraph& subgraph, const BoundPort& port) const;
  std::string SourceText(const CheckedSubgraph& subgraph, const BoundPort& port) const;
};

}  // namespace texgraph::graph
