// SPDX-License-Identifier: Apache-2.0
// The sections "functions", "nodes" and "outputs".
#include <fmt/format.h>

#include "compiler/graph/argument.h"
#include "compiler/graph/graph_reader.h"
#include "compiler/graph/names.h"

namespace texgraph::graph {

void GraphReader::ReadFunctions(const DocumentNode* section) {
  if (!Is(section, DocumentKind::kObject, {"the graph", ""})) return;
  graph_.functions.reserve(section->child_count);
  for (const DocumentNode& child : document_.children(*section)) ReadFunction(child);
}

void GraphReader::ReadFunction(const DocumentNode& node) {
  CheckInnerName(node.key, node.key_range, diagnostics_);
  Owner owner{"function", node.key};
  Subgraph function;
  function.name = node.key;
  function.range = node.key_range;
  if (Is(&node, DocumentKind::kObject, owner)) {
    constexpr std::array<std::string_view, 4> kKeys = {"description", "inputs", "nodes", "outputs"};
    auto [description, inputs, nodes, outputs] = Keys(node, owner, kKeys);
    std::string_view for_people;
    ReadText(description, owner, for_people);
    if (Is(inputs, DocumentKind::kObject, owner)) {
      for (const DocumentNode& child : document_.children(*inputs)) {
        ReadFunctionInput(child, function);
      }
    }
    ReadNodes(nodes, owner, function);
    if (!outputs) ReportMissing(node, owner, "outputs");
    ReadOutputs(outputs, owner, true, function);
  }
  graph_.functions.push_back(std::move(function));
}

// "scale": "float", or "scale": { "type": "float", "value": 1 }.
void GraphReader::ReadFunctionInput(const DocumentNode& node, Subgraph& function) {
  CheckInnerName(node.key, node.key_range, diagnostics_);
  Owner owner{"input", node.key};
  FunctionInput input;
  input.name = node.key;
  input.range = node.key_range;
  const DocumentNode* type = &node;
  if (node.kind != DocumentKind::kString) {
    if (!Is(&node, DocumentKind::kObject, owner)) return;
    constexpr std::array<std::string_view, 3> kKeys = {"type", "value", "description"};
    auto [type_key, value, description] = Keys(node, owner, kKeys);
    if (!type_key) ReportMissing(node, owner, "type");
    type = type_key;
    if (value) input.value = ReadArgument(document_, *value, diagnostics_);
    std::string_view for_people;
    ReadText(description, owner, for_people);
  }
  if (ReadText(type, owner, input.type)) input.type_range = type->range;
  function.inputs.push_back(std::move(input));
}

void GraphReader::ReadNodes(const DocumentNode* section, Owner owner, Subgraph& subgraph) {
  if (!Is(section, DocumentKind::kObject, owner)) return;
  if (node_count_ + section->child_count > kMaxNodes) {
    diagnostics_.Error(DiagnosticKind::kSizeLimit, section->key_range,
                       fmt::format("the graph has more than {} nodes", kMaxNodes));
    return;
  }
  node_count_ += section->child_count;
  subgraph.nodes.reserve(section->child_count);
  for (const DocumentNode& child : document_.children(*section)) ReadNode(child, subgraph);
}

void GraphReader::ReadNode(const DocumentNode& node, Subgraph& subgraph) {
  CheckInnerName(node.key, node.key_range, diagnostics_);
  Owner owner{"node", node.key};
  Node& result = subgraph.nodes.emplace_back();
  result.name = node.key;
  result.range = node.key_range;
  if (!Is(&node, DocumentKind::kObject, owner)) return;
  constexpr std::array<std::string_view, 3> kKeys = {"block", "in", "description"};
  auto [block, in, description] = Keys(node, owner, kKeys);
  if (!block) ReportMissing(node, owner, "block");
  if (ReadText(block, owner, result.block)) result.block_range = block->range;
  std::string_view for_people;
  ReadText(description, owner, for_people);
  if (!Is(in, DocumentKind::kObject, owner)) return;
  result.inputs.reserve(in->child_count);
  for (const DocumentNode& child : document_.children(*in)) {
    std::optional<Argument> argument = ReadArgument(document_, child, diagnostics_);
    if (argument) result.inputs.push_back({child.key, child.key_range, std::move(*argument)});
  }
}

void GraphReader::ReadOutputs(const DocumentNode* section, Owner owner, bool check_names,
                              Subgraph& subgraph) {
  if (!Is(section, DocumentKind::kObject, owner)) return;
  if (section->child_count == 0) {
    diagnostics_.Error(DiagnosticKind::kGraphShape, section->range,
                       fmt::format("{} has at least one output", owner.Text()));
  }
  for (const DocumentNode& child : document_.children(*section)) {
    if (check_names) CheckInnerName(child.key, child.key_range, diagnostics_);
    std::optional<Argument> argument = ReadArgument(document_, child, diagnostics_);
    if (argument) subgraph.outputs.push_back({child.key, child.key_range, std::move(*argument)});
  }
}

}  // namespace texgraph::graph
