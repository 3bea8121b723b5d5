// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/usage.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "compiler/graph/scope.h"

namespace texgraph::manifest {

namespace {

// A word of the port's enumeration goes before anything of that name.
bool IsWordOfPort(const graph::CheckedNode& node, const graph::Input& input) {
  if (node.overload == nullptr) return false;
  for (const blocks::Port& port : node.overload->inputs) {
    if (port.name != input.port) continue;
    return std::ranges::any_of(port.words,
                               [&](const auto& word) { return word.word == input.argument.text; });
  }
  return false;
}

// Walks the connections backwards, one subgraph at a time. Constants left no trace in the ports, so
// the names in the graph say where a parameter went.
class Walk {
 public:
  explicit Walk(const graph::CheckedGraph& graph)
      : graph_(graph),
        globals_(graph::GlobalSymbols(*graph.graph)),
        parameters_(graph.parameters.size()),
        functions_(graph.functions.size()) {}

  std::vector<bool> Run() {
    Visit(graph_.main);
    // Callers come after their callees, so all that need a function were seen before it.
    for (size_t f = functions_.size(); f-- > 0;) {
      if (functions_[f]) Visit(graph_.functions[f]);
    }
    return std::move(parameters_);
  }

 private:
  void Visit(const graph::CheckedSubgraph& subgraph) {
    graph::Scope scope(globals_, *subgraph.subgraph);
    nodes_.assign(subgraph.nodes.size(), false);
    for (const graph::CheckedOutput& output : subgraph.outputs) MarkSource(output.value);
    for (const graph::Output& output : subgraph.subgraph->outputs) MarkName(scope, output.argument);
    for (size_t n = nodes_.size(); n-- > 0;) {
      const graph::CheckedNode& node = subgraph.nodes[n];
      if (!nodes_[n]) continue;
      if (node.block == nullptr) functions_[node.function] = true;
      for (const graph::BoundPort& port : node.inputs) MarkSource(port);
      for (const graph::Input& input : node.node->inputs) {
        if (!IsWordOfPort(node, input)) MarkName(scope, input.argument);
      }
    }
  }

  void MarkSource(const graph::BoundPort& port) {
    if (auto* output = std::get_if<graph::NodeOutput>(&port.source)) nodes_[output->node] = true;
    if (auto* field = std::get_if<graph::FieldOfNode>(&port.source))
      nodes_[field->source.node] = true;
    if (auto* field = std::get_if<graph::FieldOfFunction>(&port.source))
      functions_[field->function] = true;
  }

  void MarkName(const graph::Scope& scope, const graph::Argument& argument) {
    if (argument.kind != graph::Argument::Kind::kString) return;
    std::optional<graph::Symbol> symbol = scope.Find(graph::SplitReference(argument.text).name);
    if (symbol && symbol->kind == graph::Symbol::Kind::kParameter)
      parameters_[symbol->index] = true;
  }

  const graph::CheckedGraph& graph_;
  const graph::SymbolTable globals_;
  std::vector<bool> parameters_;
  std::vector<bool> functions_;
  std::vector<bool> nodes_;  // of the subgraph that is visited
};

}  // namespace

std::vector<bool> NeededParameters(const graph::CheckedGraph& graph) {
  if (graph.parameters.empty()) return {};
  return Walk(graph).Run();
}

}  // namespace texgraph::manifest
