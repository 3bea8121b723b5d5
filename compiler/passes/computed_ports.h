// SPDX-License-Identifier: Apache-2.0
// The values of template ports: what the graph gives, or, for "@computed" ports, what a block of
// the library makes of the node's other ports, as far as these are known when the shader is made. A
// part of BuildModule.
#pragma once

#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/graph/checked_graph.h"
#include "compiler/ir/known_words.h"

namespace texgraph::passes {

class ComputedPorts {
 public:
  // `graph_functions`: the IR of the graph's functions so far, by CheckedGraph::functions.
  ComputedPorts(blocks::Library& library, ir::Module& module,
                const std::vector<ir::FunctionId>& graph_functions, Diagnostics& diagnostics)
      : library_(library),
        module_(module),
        graph_functions_(graph_functions),
        diagnostics_(diagnostics) {}

  // The value of template port `port` of a node with a block. Invalid after an error: the computed
  // value is out of the port's range. Warns where the default stands in for an unknown value, and
  // where the graph gives less than the known one; the least of the port's range is taken at its
  // word.
  ir::ConstId TemplateValue(const graph::CheckedSubgraph& subgraph, uint32_t node, size_t port);

 private:
  using Subgraph = graph::CheckedSubgraph;
  using OutputKey = std::tuple<const Subgraph*, uint32_t, uint32_t>;  // node, output
  using PortKey = std::tuple<const Subgraph*, uint32_t, size_t>;      // node, port

  struct Computed {
    bool is_possible = false;               // there is such a block, with inputs that the node has
    ir::KnownWords words;                   // not whole: not known
    std::vector<const blocks::Port*> from;  // the values that it follows from
    std::vector<const blocks::Port*> unknown;  // of these
  };
  // What the port's block gives. None after an error.
  std::optional<Computed> Ask(const Subgraph& subgraph, uint32_t node, const blocks::Port& port);
  ir::ConstId Compute(const Subgraph& subgraph, uint32_t node, size_t port);
  void WarnIfTooLow(const Subgraph& subgraph, uint32_t node, size_t port, ir::ConstId value);
  // What is known of a value port, or of the results of a function port.
  ir::KnownWords KnownPort(const Subgraph& subgraph, const graph::BoundPort& bound);
  // Makes what is known of an output and of those that it needs; without recursion, chains may be
  // long.
  void FindOutputs(const Subgraph& subgraph, graph::NodeOutput source);
  ir::KnownWords OutputOf(const Subgraph& subgraph, graph::NodeOutput source);
  bool IsInRange(const graph::CheckedNode& node, const blocks::Port& port, ir::ConstId value,
                 const std::vector<const blocks::Port*>& from);

  blocks::Library& library_;
  ir::Module& module_;
  const std::vector<ir::FunctionId>& graph_functions_;
  Diagnostics& diagnostics_;
  std::map<OutputKey, ir::KnownWords> outputs_;
  std::map<PortKey, ir::ConstId> values_;
};

}  // namespace texgraph::passes
