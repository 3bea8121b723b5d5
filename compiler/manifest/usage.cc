// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/usage.h"

#include <utility>
#include <variant>

#include "compiler/ir/rebuild.h"

namespace texgraph::manifest {

std::vector<bool> UsedGlobals(const ir::Module& module) {
  std::vector<bool> globals(module.globals.size()), reached(module.functions.size());
  std::vector<ir::FunctionId> work{module.main};
  reached[module.main.index] = true;
  while (!work.empty()) {
    const ir::Function& function = module[work.back()];
    work.pop_back();
    ir::Liveness live(module, function);
    for (size_t i = 0; i < function.insts.size(); ++i) {
      const ir::Inst& inst = function.insts[i];
      if (!live.Live(ir::ValueId(i))) continue;
      if (inst.op == ir::Op::kGlobal) globals[inst.aux] = true;
      bool calls = inst.op == ir::Op::kCall || inst.op == ir::Op::kFieldRef;
      if (!calls || reached[inst.aux]) continue;
      reached[inst.aux] = true;
      work.push_back(ir::FunctionId(inst.aux));
    }
  }
  return globals;
}

namespace {

// Walks the connections backwards, one subgraph at a time.
class Walk {
 public:
  explicit Walk(const graph::CheckedGraph& graph)
      : graph_(graph), parameters_(graph.parameters.size()), functions_(graph.functions.size()) {}

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
    nodes_.assign(subgraph.nodes.size(), false);
    for (const graph::CheckedOutput& output : subgraph.outputs) Mark(output.value);
    for (size_t n = nodes_.size(); n-- > 0;) {
      const graph::CheckedNode& node = subgraph.nodes[n];
      if (!nodes_[n]) continue;
      if (node.block == nullptr) functions_[node.function] = true;
      for (const graph::BoundPort& port : node.inputs) Mark(port);
    }
  }

  void Mark(const graph::BoundPort& port) {
    if (auto* output = std::get_if<graph::NodeOutput>(&port.source)) nodes_[output->node] = true;
    if (auto* field = std::get_if<graph::FieldOfNode>(&port.source))
      nodes_[field->source.node] = true;
    if (auto* parameter = std::get_if<graph::ParameterRef>(&port.source))
      parameters_[parameter->parameter] = true;
    if (auto* field = std::get_if<graph::FieldOfParameter>(&port.source))
      parameters_[field->parameter] = true;
    if (auto* field = std::get_if<graph::FieldOfFunction>(&port.source))
      functions_[field->function] = true;
  }

  const graph::CheckedGraph& graph_;
  std::vector<bool> parameters_;
  std::vector<bool> functions_;
  std::vector<bool> nodes_;  // of the subgraph that is visited
};

}  // namespace

std::vector<bool> NeededParameters(const graph::CheckedGraph& graph) { return Walk(graph).Run(); }

}  // namespace texgraph::manifest
