// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/fields.h"

#include <fmt/format.h>

#include <algorithm>

namespace texgraph::passes {

using graph::BoundPort;
using graph::CheckedGraph;
using graph::CheckedNode;
using graph::CheckedSubgraph;

uint32_t BuiltinIndex(std::string_view name) {
  const auto* input = std::ranges::find(kBuiltinInputs, name, &BuiltinInput::name);
  return static_cast<uint32_t>(input - std::begin(kBuiltinInputs));
}

std::vector<int> ReplacedBuiltins(const ir::Types& types, ir::TypeId field_type,
                                  const std::vector<std::string>& names) {
  const std::vector<ir::TypeId>& elements = types[field_type].elements;
  std::vector<int> replaced(names.size(), -1);
  auto type_of = [&](uint32_t builtin) { return types.Find(kBuiltinInputs[builtin].type); };
  for (size_t p = 0; p < names.size(); ++p) {
    for (uint32_t b = 0; b < kBuiltinCount; ++b) {
      if (kBuiltinInputs[b].name == names[p] && type_of(b) == elements[p + 1])
        replaced[p] = static_cast<int>(b);
    }
  }
  for (int b : {int{kUv}, int{kPosition}}) {
    if (std::ranges::count(replaced, b)) continue;
    for (size_t p = 0; p < names.size(); ++p) {
      if (replaced[p] >= 0 || elements[p + 1] != type_of(static_cast<uint32_t>(b))) continue;
      replaced[p] = b;
      break;
    }
  }
  return replaced;
}

BuiltinSet ReplacedSet(const std::vector<int>& replaced) {
  BuiltinSet set = 0;
  for (int b : replaced) {
    if (b >= 0) set |= 1u << b;
  }
  return set;
}

std::string OutputName(const CheckedNode& node, uint32_t output) {
  std::string name(node.node->name);
  if (node.block && output > 0) return name + "_" + node.overload->outputs[output].name;
  if (node.block && node.overload->outputs[0].name != "result" &&
      node.overload->outputs.size() > 1) {
    return name + "_" + node.overload->outputs[0].name;
  }
  return name;
}

std::string FieldKey(const CheckedSubgraph& subgraph, const BoundPort& bound,
                     const blocks::Port& port) {
  std::string key = fmt::format("{} {} {}", static_cast<const void*>(&subgraph),
                                bound.source.index(), bound.type.index);
  if (auto* node = std::get_if<graph::FieldOfNode>(&bound.source)) {
    key += fmt::format(" {}.{}", node->source.node, node->source.output);
  } else if (auto* texture = std::get_if<graph::FieldOfTexture>(&bound.source)) {
    key += fmt::format(" {}", texture->texture);
  } else if (auto* function = std::get_if<graph::FieldOfFunction>(&bound.source)) {
    key += fmt::format(" {}.{}", function->function, function->output);
    for (const std::optional<uint32_t>& p : bound.by_parameter)
      key += fmt::format(" {}", p ? int(*p) : -1);
  } else if (auto* parameter = std::get_if<graph::FieldOfParameter>(&bound.source)) {
    key += fmt::format(" {}", parameter->parameter);
  } else if (auto* block = std::get_if<graph::FieldOfBlock>(&bound.source)) {
    key += fmt::format(" {}", block->block);
  } else if (auto* builtin = std::get_if<graph::FieldOfBuiltin>(&bound.source)) {
    key += fmt::format(" {}", builtin->input);
  } else if (auto* input = std::get_if<graph::FieldOfFunctionInput>(&bound.source)) {
    key += fmt::format(" {}", input->input);
  } else {
    key += fmt::format(" {}", std::get<graph::FieldOfConstant>(bound.source).value.index);
  }
  for (const std::string& name : port.field_parameters) key += " " + name;
  return key;
}

std::string FieldName(const CheckedGraph& graph, const CheckedSubgraph& subgraph,
                      const BoundPort& bound, const blocks::Port& port) {
  if (auto* node = std::get_if<graph::FieldOfNode>(&bound.source)) {
    return OutputName(subgraph.nodes[node->source.node], node->source.output) + "_at";
  }
  if (auto* texture = std::get_if<graph::FieldOfTexture>(&bound.source)) {
    return std::string(graph.graph->textures[texture->texture].name) + "_at";
  }
  if (auto* function = std::get_if<graph::FieldOfFunction>(&bound.source)) {
    return std::string(graph.functions[function->function].subgraph->name) + "_at";
  }
  if (auto* block = std::get_if<graph::FieldOfBlock>(&bound.source)) {
    return graph.default_blocks[block->block].block->name + "_at";
  }
  return port.name + "_at";
}

}  // namespace texgraph::passes
