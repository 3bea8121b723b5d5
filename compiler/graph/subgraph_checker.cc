// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/subgraph_checker.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "compiler/graph/conversion.h"

namespace texgraph::graph {
namespace {

// The node of the checked subgraph that a source takes from.
NodeOutput* TakenFrom(Source& source) {
  if (auto* output = std::get_if<NodeOutput>(&source)) return output;
  if (auto* field = std::get_if<FieldOfNode>(&source)) return &field->source;
  return nullptr;
}

}  // namespace

std::string CircleText(const std::vector<std::string_view>& names) {
  std::string text;
  for (size_t i = 0; i < names.size(); ++i) {
    if (names.size() > kShownOfCircle && i == kShownOfCircle / 2) {
      size_t skipped = names.size() - kShownOfCircle;
      text += fmt::format("... {} more ... -> ", skipped);
      i += skipped;
    }
    text += fmt::format("{} -> ", names[i]);
  }
  return text + std::string(names[0]);
}

void SubgraphChecker::Check(CheckedSubgraph& result) {
  result.subgraph = &subgraph_;
  Order order = OrderByNeed(NodeDependencies());
  for (const std::vector<uint32_t>& circle : order.circles) ReportCircle(circle);
  position_.resize(nodes_.size());
  for (uint32_t i = 0; i < order.sequence.size(); ++i) position_[order.sequence[i]] = i;
  result.nodes.reserve(nodes_.size());
  for (uint32_t index : order.sequence) result.nodes.push_back(BindNode(index));
  CheckOutputs(result);
  KeepUsedNodes(result);
}

void SubgraphChecker::FindBlocks() {
  for (size_t i = 0; i < nodes_.size(); ++i) {
    const Node& node = subgraph_.nodes[i];
    NodeState& state = nodes_[i];
    const Symbol* known = check_.globals.Find(node.block);
    if (known && known->kind == Symbol::Kind::kFunction) {
      state.function = known->index;
      state.candidates = {&check_.signatures[*state.function], 1};
    } else if (const blocks::Block* block = check_.library.Find(node.block)) {
      state.block = block;
      state.candidates = block->overloads;
    } else if (check_.library.Exists(node.block)) {
      check_.failed = true;
    } else {
      ReportUnknownBlock(node);
    }
  }
}

void SubgraphChecker::ReportUnknownBlock(const Node& node) {
  std::string hint;
  if (!check_.diagnostics.full()) {
    std::vector<std::string_view> names = check_.library.Names();
    for (const Subgraph& function : check_.graph.functions) names.push_back(function.name);
    hint = DidYouMean(node.block, names);
  }
  check_.diagnostics.Error(
      DiagnosticKind::kUnknownBlock, node.block_range,
      fmt::format("there is no block '{}'{}", Printable(node.block, 64), hint));
}

// Whether text at this port may name a node or function: it may be a word or a texture instead.
bool SubgraphChecker::MayRefer(const NodeState& state, std::string_view port) const {
  for (const blocks::Overload& overload : state.candidates) {
    for (const blocks::Port& input : overload.inputs) {
      bool refers =
          input.kind == blocks::PortKind::kValue || input.kind == blocks::PortKind::kField;
      if (refers && input.name == port) return true;
    }
  }
  return false;
}

Dependencies SubgraphChecker::NodeDependencies() const {
  Dependencies dependencies;
  dependencies.first.reserve(nodes_.size() + 1);
  for (size_t i = 0; i < nodes_.size(); ++i) {
    for (const Input& input : subgraph_.nodes[i].inputs) {
      if (input.argument.kind != Argument::Kind::kString) continue;
      std::optional<Symbol> symbol = scope_.Find(SplitReference(input.argument.text).name);
      if (!symbol || symbol->kind != Symbol::Kind::kNode) continue;
      if (MayRefer(nodes_[i], input.port)) dependencies.Add(symbol->index);
    }
    dependencies.EndThing();
  }
  return dependencies;
}

std::vector<uint32_t> SubgraphChecker::CalledFunctions() const {
  std::vector<uint32_t> called;
  for (size_t i = 0; i < nodes_.size(); ++i) {
    if (nodes_[i].function) called.push_back(*nodes_[i].function);
    for (const Input& input : subgraph_.nodes[i].inputs) {
      if (input.argument.kind != Argument::Kind::kString) continue;
      std::optional<Symbol> symbol = scope_.Find(SplitReference(input.argument.text).name);
      if (!symbol || symbol->kind != Symbol::Kind::kFunction) continue;
      if (MayRefer(nodes_[i], input.port)) called.push_back(symbol->index);
    }
  }
  return called;
}

// Where `node` names `need`.
SourceRange SubgraphChecker::PlaceOfNeed(uint32_t node, uint32_t need) const {
  for (const Input& input : subgraph_.nodes[node].inputs) {
    if (input.argument.kind != Argument::Kind::kString) continue;
    std::string_view name = SplitReference(input.argument.text).name;
    if (name == subgraph_.nodes[need].name && MayRefer(nodes_[node], input.port)) {
      return input.argument.range;
    }
  }
  return subgraph_.nodes[node].range;
}

void SubgraphChecker::ReportCircle(const std::vector<uint32_t>& circle) {
  std::vector<std::string_view> names;
  for (uint32_t node : circle) names.push_back(subgraph_.nodes[node].name);
  std::string message =
      circle.size() == 1
          ? fmt::format("node '{}' needs its own output", names[0])
          : fmt::format("these nodes need each other in a circle: {}", CircleText(names));
  uint32_t second = circle.size() > 1 ? circle[1] : circle[0];
  Diagnostic& error = check_.diagnostics.Error(DiagnosticKind::kCycle,
                                               PlaceOfNeed(circle[0], second), std::move(message));
  for (size_t i = 1; i < std::min(circle.size(), kShownOfCircle); ++i) {
    uint32_t next = circle[(i + 1) % circle.size()];
    error.AddNote(PlaceOfNeed(circle[i], next),
                  fmt::format("'{}' needs '{}'", names[i], subgraph_.nodes[next].name));
  }
}

void SubgraphChecker::CheckOutputs(CheckedSubgraph& result) {
  result.outputs.reserve(subgraph_.outputs.size());
  for (const Output& output : subgraph_.outputs) {
    std::optional<BoundPort> bound = signature_ ? FunctionOutput(output) : MainOutput(output);
    if (bound) result.outputs.push_back({std::string(output.name), std::move(*bound)});
  }
}

std::optional<BoundPort> SubgraphChecker::MainOutput(const Output& output) {
  const auto* known = std::ranges::find(kBuiltinOutputs, output.name, &BuiltinOutput::name);
  if (known == std::end(kBuiltinOutputs)) {
    std::vector<std::string_view> names;
    for (const BuiltinOutput& builtin : kBuiltinOutputs) names.push_back(builtin.name);
    check_.diagnostics.Error(DiagnosticKind::kUnknownOutput, output.range,
                             fmt::format("a graph has no output '{}'{}", Printable(output.name, 64),
                                         DidYouMean(output.name, names)));
    return std::nullopt;
  }
  blocks::Port port;
  port.type = check_.module.types.Find(known->type);
  Target target{port, {"output", known->name, "", "", {}}};
  return Bind(target, output.argument, Resolve(output.argument));
}

// A function's output has the type of what stands there.
std::optional<BoundPort> SubgraphChecker::FunctionOutput(const Output& output) {
  const Argument& argument = output.argument;
  Resolved resolved = Resolve(argument);
  blocks::Port port;
  port.type = resolved.type;
  Target target{port, {"output", output.name, "function", subgraph_.name, {}}};
  if (resolved.kind == Resolved::Kind::kLiteral) {
    switch (argument.kind) {
      case Argument::Kind::kBool:
        port.type = ir::kBool;
        break;
      case Argument::Kind::kNumber:
        port.type = argument.is_integer ? ir::kInt : ir::kFloat;
        break;
      default: {
        size_t width = std::clamp<size_t>(argument.numbers.size(), 2, 4);
        port.type = ir::Vector(ir::Scalar::kFloat, static_cast<uint32_t>(width));
      }
    }
  }
  bool value =
      resolved.kind != Resolved::Kind::kSymbol || (resolved.symbol.kind != Symbol::Kind::kTexture &&
                                                   resolved.symbol.kind != Symbol::Kind::kFunction);
  if (!value) {
    ReportNoValue(target, argument, resolved, "a value");
    return std::nullopt;
  }
  return Bind(target, argument, resolved);
}

// Leaves out what no output needs, and lets the sources name the nodes that are left.
void SubgraphChecker::KeepUsedNodes(CheckedSubgraph& result) {
  std::vector<bool> used(result.nodes.size(), false);
  auto mark = [&](Source& source) {
    if (NodeOutput* output = TakenFrom(source)) used[output->node] = true;
  };
  for (CheckedOutput& output : result.outputs) mark(output.value.source);
  for (size_t i = result.nodes.size(); i-- > 0;) {
    if (!used[i]) continue;
    for (BoundPort& input : result.nodes[i].inputs) mark(input.source);
  }
  std::vector<uint32_t> kept(result.nodes.size());
  uint32_t count = 0;
  for (size_t i = 0; i < result.nodes.size(); ++i) {
    kept[i] = count;
    if (!used[i]) continue;
    for (BoundPort& input : result.nodes[i].inputs) {
      if (NodeOutput* output = TakenFrom(input.source)) output->node = kept[output->node];
    }
    if (count != i) result.nodes[count] = std::move(result.nodes[i]);
    ++count;
  }
  result.nodes.resize(count);
  for (CheckedOutput& output : result.outputs) {
    if (NodeOutput* node = TakenFrom(output.value.source)) node->node = kept[node->node];
  }
}

}  // namespace texgraph::graph
