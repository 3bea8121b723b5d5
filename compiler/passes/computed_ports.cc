// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/computed_ports.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <span>

#include "compiler/base/text.h"

namespace texgraph::passes {
namespace {

using blocks::Port;
using blocks::PortKind;
using graph::BoundPort;
using graph::CheckedNode;
using graph::CheckedSubgraph;
using ir::ConstId;
using ir::KnownWords;

// The node whose output a port takes, directly or as a function.
const graph::NodeOutput* SourceNode(const BoundPort& bound) {
  if (auto* output = std::get_if<graph::NodeOutput>(&bound.source)) return output;
  if (auto* field = std::get_if<graph::FieldOfNode>(&bound.source)) return &field->source;
  return nullptr;
}

std::string NameList(const std::vector<const Port*>& ports) {
  return Listed(ports, " and ", [](const Port* port) { return "'" + port->name + "'"; });
}

// Of an int or a vector of them.
std::vector<int32_t> Numbers(std::span<const uint32_t> words) {
  return {words.begin(), words.end()};
}

// "3", "(2, 3)".
std::string NumberText(const std::vector<int32_t>& numbers) {
  if (numbers.size() == 1) return fmt::format("{}", numbers[0]);
  return fmt::format("({})", fmt::join(numbers, ", "));
}

}  // namespace

ConstId ComputedPorts::TemplateValue(const CheckedSubgraph& subgraph, uint32_t node, size_t port) {
  const BoundPort& bound = subgraph.nodes[node].inputs[port];
  auto* constant = std::get_if<graph::ConstantValue>(&bound.source);
  const bool is_computed = !subgraph.nodes[node].overload->inputs[port].computed_by.empty();
  if (constant && !is_computed) return constant->value;
  auto [value, added] = values_.try_emplace({&subgraph, node, port});
  if (!added) return value->second;
  if (!constant) return value->second = Compute(subgraph, node, port);
  value->second = constant->value;
  WarnIfTooLow(subgraph, node, port, constant->value);
  return constant->value;
}

KnownWords ComputedPorts::KnownPort(const CheckedSubgraph& subgraph, const BoundPort& bound) {
  const ir::Types& types = module_.types;
  const ir::TypeId type = types.ValueOf(bound.type);
  if (auto* constant = std::get_if<graph::ConstantValue>(&bound.source)) {
    return KnownWords::All(module_.Words(constant->value));
  }
  if (auto* constant = std::get_if<graph::FieldOfConstant>(&bound.source)) {
    return KnownWords::All(module_.Words(constant->value));
  }
  const graph::NodeOutput* source = SourceNode(bound);
  if (!source || bound.source_type != type) return KnownWords::Nothing(types.Words(type));
  FindOutputs(subgraph, *source);
  return outputs_.at({&subgraph, source->node, source->output});
}

void ComputedPorts::FindOutputs(const CheckedSubgraph& subgraph, graph::NodeOutput source) {
  std::vector<graph::NodeOutput> needed, stack{source};
  while (!stack.empty()) {
    const graph::NodeOutput next = stack.back();
    stack.pop_back();
    if (!outputs_.try_emplace({&subgraph, next.node, next.output}).second) continue;
    needed.push_back(next);
    for (const BoundPort& bound : subgraph.nodes[next.node].inputs) {
      if (const graph::NodeOutput* from = SourceNode(bound)) stack.push_back(*from);
    }
  }
  // Nodes are in an order in which each follows what it needs.
  std::ranges::sort(needed, {}, &graph::NodeOutput::node);
  for (graph::NodeOutput next : needed) {
    outputs_[{&subgraph, next.node, next.output}] = OutputOf(subgraph, next);
  }
}

KnownWords ComputedPorts::OutputOf(const CheckedSubgraph& subgraph, graph::NodeOutput source) {
  const CheckedNode& node = subgraph.nodes[source.node];
  const ir::TypeId type =
      node.block ? node.overload->outputs[source.output].type
                 : module_[graph_functions_[node.function]].results[source.output].type;
  const KnownWords nothing = KnownWords::Nothing(module_.types.Words(type));
  std::vector<ConstId> template_values;
  std::vector<KnownWords> arguments;
  for (size_t i = 0; i < node.inputs.size(); ++i) {
    if (node.block && node.overload->inputs[i].kind == PortKind::kTemplate) {
      template_values.push_back(TemplateValue(subgraph, source.node, i));
      if (!template_values.back()) return nothing;
    } else {
      arguments.push_back(KnownPort(subgraph, node.inputs[i]));
    }
  }
  const ir::FunctionId function =
      node.block ? library_.Function(*node.block, *node.overload, template_values)
                 : graph_functions_[node.function];
  if (!function) return nothing;
  return ir::FindKnownResult(module_, function, std::move(arguments), source.output);
}

std::optional<ComputedPorts::Computed> ComputedPorts::Ask(const CheckedSubgraph& subgraph,
                                                          uint32_t index, const Port& port) {
  const CheckedNode& node = subgraph.nodes[index];
  const std::vector<Port>& ports = node.overload->inputs;
  const blocks::Block* block = library_.Find(port.computed_by);
  Computed computed;
  if (!block) return computed;
  const blocks::Overload& overload = block->overloads[0];
  std::vector<ConstId> template_values;
  std::vector<KnownWords> arguments;
  for (const Port& input : overload.inputs) {
    auto own = std::ranges::find(ports, input.name, &Port::name);
    if (own == ports.end()) return Computed();
    const auto i = static_cast<size_t>(own - ports.begin());
    if (own->kind == PortKind::kTemplate) {
      template_values.push_back(TemplateValue(subgraph, index, i));
      if (!template_values.back()) return std::nullopt;
      continue;
    }
    arguments.push_back(KnownPort(subgraph, node.inputs[i]));
    const bool is_value = ir::IsVector(input.type);
    if (is_value) computed.from.push_back(&*own);
    if (is_value && !arguments.back().IsWhole()) computed.unknown.push_back(&*own);
  }
  const ir::FunctionId function = library_.Function(*block, overload, template_values);
  if (!function) return std::nullopt;
  computed.is_possible = true;
  computed.words = ir::FindKnownResult(module_, function, std::move(arguments), 0);
  return computed;
}

ConstId ComputedPorts::Compute(const CheckedSubgraph& subgraph, uint32_t index, size_t port_index) {
  const CheckedNode& node = subgraph.nodes[index];
  const Port& port = node.overload->inputs[port_index];
  const std::optional<Computed> computed = Ask(subgraph, index, port);
  if (!computed) return {};
  if (!computed->is_possible) return port.default_value;
  if (computed->words.IsWhole()) {
    const ConstId value = module_.Intern(port.type, computed->words.words);
    return IsInRange(node, port, value, computed->from) ? value : ConstId();
  }
  const std::vector<const Port*>& unknown = computed->unknown;
  diagnostics_.Warn(
      DiagnosticKind::kNotComputed, node.node->range,
      fmt::format("port '{}' of node '{}' keeps its default, since {} not known when the shader is "
                  "made; give it a value",
                  port.name, node.node->name,
                  unknown.empty()       ? "the tile's grid is"
                  : unknown.size() == 1 ? NameList(unknown) + " is"
                                        : NameList(unknown) + " are"));
  return port.default_value;
}

void ComputedPorts::WarnIfTooLow(const CheckedSubgraph& subgraph, uint32_t index, size_t port_index,
                                 ConstId value) {
  const CheckedNode& node = subgraph.nodes[index];
  const Port& port = node.overload->inputs[port_index];
  if (!ir::IsVector(port.type) || ir::ScalarOf(port.type) != ir::Scalar::kInt) return;
  const std::vector<int32_t> given = Numbers(module_.Words(value));
  // Whoever asks for the least there is means it; and then nothing has to be computed.
  if (port.minimum && std::ranges::all_of(given, [&](int n) { return n <= *port.minimum; })) return;
  const std::optional<Computed> computed = Ask(subgraph, index, port);
  if (!computed || !computed->is_possible || !computed->words.IsWhole()) return;
  const std::vector<int32_t> needed = Numbers(computed->words.words);
  if (std::ranges::equal(given, needed, std::ranges::greater_equal())) return;
  Diagnostic& warning = diagnostics_.Warn(
      DiagnosticKind::kBelowComputed, node.inputs[port_index].range,
      fmt::format("port '{}' of node '{}' is {}, and would be {} without a value, which follows "
                  "from {}: what reaches further is cut off",
                  port.name, node.node->name, NumberText(given), NumberText(needed),
                  NameList(computed->from)));
  warning.AddNote(node.node->range, port.advice);
}

bool ComputedPorts::IsInRange(const CheckedNode& node, const Port& port, ConstId value,
                              const std::vector<const Port*>& from) {
  // Of a vector the greatest component.
  int32_t number = INT32_MIN;
  for (uint32_t word : module_.Words(value)) number = std::max(number, static_cast<int32_t>(word));
  if (!port.maximum || number <= *port.maximum) return true;
  diagnostics_
      .Error(
          DiagnosticKind::kComputedRange, node.node->range,
          fmt::format("port '{}' of node '{}' would have to be {}, and is at most {}; it follows "
                      "from {}",
                      port.name, node.node->name, number, *port.maximum, NameList(from)))
      .AddNote(node.node->range, port.advice)
      .AddNote(port.range, "the port is declared here");
  return false;
}

}  // namespace texgraph::passes
