// SPDX-License-Identifier: Apache-2.0
// The section "parameters".
#include <fmt/format.h>

#include "compiler/graph/argument.h"
#include "compiler/graph/graph_reader.h"
#include "compiler/graph/names.h"

namespace texgraph::graph {

void GraphReader::ReadParameters(const DocumentNode* section) {
  if (!Is(section, DocumentKind::kObject, {"the graph", ""})) return;
  graph_.parameters.reserve(section->child_count);
  for (const DocumentNode& child : document_.children(*section)) ReadParameter(child);
}

void GraphReader::ReadParameter(const DocumentNode& node) {
  CheckBoundName(node.key, node.key_range, diagnostics_);
  Owner owner{"parameter", node.key};
  Parameter parameter;
  parameter.name = node.key;
  parameter.range = node.key_range;
  if (Is(&node, DocumentKind::kObject, owner)) {
    constexpr std::array<std::string_view, 7> kKeys = {"type",  "value", "range", "binding",
                                                       "label", "help",  "unit"};
    auto [type, value, range, binding, label, help, unit] = Keys(node, owner, kKeys);
    if (!type) ReportMissing(node, owner, "type");
    if (ReadText(type, owner, parameter.type)) parameter.type_range = type->range;
    if (!value) ReportMissing(node, owner, "value");
    if (value) {
      parameter.value = ReadArgument(document_, *value, diagnostics_).value_or(Argument{});
    }
    ReadRange(range, owner, parameter);
    ReadWord<Binding>(binding, owner,
                      {{"constant", Binding::kConstant},
                       {"specialization", Binding::kSpecialization},
                       {"uniform", Binding::kUniform}},
                      parameter.binding);
    ReadText(label, owner, parameter.label);
    ReadText(help, owner, parameter.help);
    ReadText(unit, owner, parameter.unit);
  }
  graph_.parameters.push_back(std::move(parameter));
}

// "range": [least, greatest].
void GraphReader::ReadRange(const DocumentNode* node, Owner owner, Parameter& parameter) {
  if (!Is(node, DocumentKind::kArray, owner)) return;
  std::optional<Argument> argument = ReadArgument(document_, *node, diagnostics_);
  if (!argument) return;
  if (argument->numbers.size() != 2) {
    return BadValue(*node, "'range' is two numbers: the least and the greatest value");
  }
  if (argument->numbers[0] > argument->numbers[1]) {
    return BadValue(*node, "the first number of 'range' is the smaller one");
  }
  parameter.minimum = argument->numbers[0];
  parameter.maximum = argument->numbers[1];
}

}  // namespace texgraph::graph
