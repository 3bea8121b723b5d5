// SPDX-License-Identifier: Apache-2.0
// A node means the overload of its block that has the ports which it names, needs no others, and
// takes what stands at them with the fewest conversions; the first of equals.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/graph/conversion.h"
#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {
namespace {

using Kind = Symbol::Kind;
using blocks::Overload;
using blocks::Port;

constexpr size_t kMaxSignatures = 8;  // shown in notes

const Port* FindPort(const std::vector<Port>& ports, std::string_view name) {
  auto found = std::ranges::find(ports, name, &Port::name);
  return found == ports.end() ? nullptr : &*found;
}

const Input* FindInput(const Node& node, std::string_view port) {
  auto found = std::ranges::find(node.inputs, port, &Input::port);
  return found == node.inputs.end() ? nullptr : &*found;
}

bool MustBeConnected(const Port& port) {
  return !port.default_value.valid() && port.default_input.empty() && port.default_block.empty() &&
         !port.grid_of && !port.colors_of;
}

bool HasAllNames(const Overload& overload, const Node& node) {
  return std::ranges::all_of(
      node.inputs, [&](const Input& input) { return FindPort(overload.inputs, input.port); });
}

bool IsComplete(const Overload& overload, const Node& node) {
  return std::ranges::all_of(overload.inputs, [&](const Port& port) {
    return !MustBeConnected(port) || FindInput(node, port.name);
  });
}

std::string ListOfTypes(const std::vector<std::string>& types, std::string_view last) {
  return Listed(types, last, [](std::string_view type) { return type; });
}

// "; it has 'a', 'b' and 'c'", if there are not too many to read.
std::string ListOfInputs(const std::vector<std::string_view>& names) {
  constexpr size_t kMostShown = 12;
  if (names.empty()) return "; it has none";
  if (names.size() > kMostShown) return {};
  return "; it has " + ListedQuoted(names, " and ");
}

}  // namespace

std::string SubgraphChecker::BlockText(uint32_t index) const {
  return fmt::format("{} '{}'", nodes_[index].function ? "function" : "block",
                     Printable(subgraph_.nodes[index].block, 64));
}

CheckedNode SubgraphChecker::BindNode(uint32_t index) {
  const Node& node = subgraph_.nodes[index];
  NodeState& state = nodes_[index];
  CheckedNode checked;
  checked.node = &node;
  checked.block = state.block;
  if (state.function) checked.function = CheckedFunction(*state.function);
  if (state.candidates.empty()) return checked;
  std::vector<Resolved>& arguments = arguments_;
  arguments.clear();
  for (const Input& input : node.inputs) arguments.push_back(Resolve(input.argument));
  const Overload* overload = Choose(index, arguments);
  if (!overload) return checked;
  state.chosen = overload;
  if (state.block) checked.overload = overload;
  checked.inputs.reserve(overload->inputs.size());
  for (const Port& port : overload->inputs) {
    Target target{port, {"port", port.name, "node", node.name, port.range}};
    const Input* input = FindInput(node, port.name);
    std::optional<BoundPort> bound =
        input            ? Bind(target, input->argument, arguments[input - node.inputs.data()])
        : port.grid_of   ? BindGrid(target, *overload, node)
        : port.colors_of ? BindColors(target, *overload, node)
                         : BindDefault(target, node.range);
    if (bound) checked.inputs.push_back(std::move(*bound));
  }
  CheckPortOrder(checked, *overload);
  CheckGrids(checked, *overload);
  CheckColors(checked, *overload);
  // With a port that is wrong another overload may have been meant.
  state.certain = state.candidates.size() == 1 || checked.inputs.size() == overload->inputs.size();
  return checked;
}

const Overload* SubgraphChecker::Choose(uint32_t index, const std::vector<Resolved>& arguments) {
  const Node& node = subgraph_.nodes[index];
  std::span<const Overload> candidates = nodes_[index].candidates;
  if (candidates.size() == 1) {
    if (!HasAllNames(candidates[0], node)) ReportUnknownPorts(index);
    return &candidates[0];
  }
  const Overload* best = nullptr;
  int best_cost = 0;
  for (const Overload& overload : candidates) {
    std::optional<int> cost = Cost(overload, node, arguments);
    if (!cost || (best && *cost >= best_cost)) continue;
    best = &overload;
    best_cost = *cost;
  }
  return best ? best : ReportNoOverload(index, arguments);
}

std::optional<int> SubgraphChecker::Cost(const Overload& overload, const Node& node,
                                         const std::vector<Resolved>& arguments) const {
  if (!IsComplete(overload, node)) return std::nullopt;
  int total = 0;
  for (size_t i = 0; i < node.inputs.size(); ++i) {
    const Port* port = FindPort(overload.inputs, node.inputs[i].port);
    if (!port) return std::nullopt;
    std::optional<int> cost = PortCost(*port, node.inputs[i].argument, arguments[i]);
    if (!cost) return std::nullopt;
    total += *cost;
  }
  return total;
}

// The number of conversions, nothing if they do not lead there. What is wrong whatever the overload
// costs nothing here and is reported when it is bound.
std::optional<int> SubgraphChecker::PortCost(const Port& port, const Argument& argument,
                                             const Resolved& resolved) const {
  if (port.kind == blocks::PortKind::kField) return FieldCost(port, argument, resolved);
  // A port's own words go before what has the same name in the graph.
  if (argument.kind == Argument::Kind::kString && !port.words.empty()) return 0;
  if (resolved.kind == Resolved::Kind::kWrong) return 0;
  if (resolved.kind == Resolved::Kind::kLiteral) {
    return LiteralCost(argument, port.type, check_.module.types);
  }
  if (port.kind == blocks::PortKind::kTexture) {
    if (resolved.symbol.kind != Kind::kTexture) return std::nullopt;
    bool fits = port.type == SamplerType(check_.graph.textures[resolved.symbol.index]);
    return fits ? std::optional<int>(0) : std::nullopt;
  }
  if (port.kind == blocks::PortKind::kTemplate && !IsConstantParameter(resolved)) return 0;
  if (resolved.symbol.kind == Kind::kTexture || resolved.symbol.kind == Kind::kFunction) {
    return std::nullopt;
  }
  return resolved.type.valid() ? ConversionCost(resolved.type, port.type) : 0;
}

const Overload* SubgraphChecker::ReportNoOverload(uint32_t index,
                                                  const std::vector<Resolved>& arguments) {
  if (ReportUnknownPorts(index)) return nullptr;
  const Node& node = subgraph_.nodes[index];
  std::vector<const Overload*> named, complete;
  for (const Overload& overload : nodes_[index].candidates) {
    if (!HasAllNames(overload, node)) continue;
    named.push_back(&overload);
    if (IsComplete(overload, node)) complete.push_back(&overload);
  }
  if (!complete.empty()) {
    if (!ReportPortThatNeverFits(index, arguments, complete) &&
        !ReportPortBesideTexture(index, arguments, complete)) {
      ReportSignatures(index, arguments);
    }
    return nullptr;
  }
  if (named.empty()) {
    ReportSignatures(index, arguments);
    return nullptr;
  }
  // A port that all of them need and that is not there, else the first that the first one needs.
  auto missing_everywhere = [&](const Port& port) {
    return std::ranges::all_of(named, [&](const Overload* overload) {
      const Port* same = FindPort(overload->inputs, port.name);
      return same && MustBeConnected(*same) && !FindInput(node, port.name);
    });
  };
  const std::vector<Port>& ports = named[0]->inputs;
  auto missing = std::ranges::find_if(ports, missing_everywhere);
  if (missing == ports.end()) {
    missing = std::ranges::find_if(ports, [&](const Port& port) {
      return MustBeConnected(port) && !FindInput(node, port.name);
    });
  }
  BindDefault({*missing, {"port", missing->name, "node", node.name, missing->range}}, node.range);
  return nullptr;
}

// The ports that no overload has.
bool SubgraphChecker::ReportUnknownPorts(uint32_t index) {
  const Node& node = subgraph_.nodes[index];
  bool found = false;
  for (const Input& input : node.inputs) {
    std::vector<std::string_view> names;
    bool known = false, is_output = false;
    for (const Overload& overload : nodes_[index].candidates) {
      for (const Port& port : overload.inputs) {
        known = known || port.name == input.port;
        if (std::ranges::find(names, port.name) == names.end()) names.push_back(port.name);
      }
      is_output = is_output || FindPort(overload.outputs, input.port);
    }
    if (known) continue;
    found = true;
    std::string hint;
    if (is_output) {
      hint = "; that is an output";
    } else if (!check_.diagnostics.full()) {
      hint = DidYouMean(input.port, names);
      if (hint.empty()) hint = ListOfInputs(names);
    }
    check_.diagnostics.Error(
        DiagnosticKind::kUnknownPort, input.port_range,
        fmt::format("{} has no port '{}'{}", BlockText(index), Printable(input.port, 64), hint));
  }
  return found;
}

// Reports each port that none of these overloads lets take what stands there.
bool SubgraphChecker::ReportPortThatNeverFits(uint32_t index,
                                              const std::vector<Resolved>& arguments,
                                              const std::vector<const Overload*>& named) {
  const Node& node = subgraph_.nodes[index];
  bool found = false;
  for (size_t i = 0; i < node.inputs.size(); ++i) {
    const Input& input = node.inputs[i];
    std::vector<const Port*> ports;
    std::vector<std::string> types;
    for (const Overload* overload : named) {
      ports.push_back(FindPort(overload->inputs, input.port));
      std::string type = check_.module.types.Text(ports.back()->type);
      if (std::ranges::find(types, type) == types.end()) types.push_back(std::move(type));
    }
    bool fits = std::ranges::any_of(ports, [&](const Port* port) {
      return PortCost(*port, input.argument, arguments[i]).has_value();
    });
    if (fits) continue;
    found = true;
    Target target{*ports[0], {"port", input.port, "node", node.name, ports[0]->range}};
    bool textures = std::ranges::all_of(
        ports, [](const Port* port) { return port->kind == blocks::PortKind::kTexture; });
    if (types.size() == 1 || textures) {
      Bind(target, input.argument, arguments[i]);
      continue;
    }
    ir::TypeId got = arguments[i].type;
    if (!got.valid()) {
      ReportNoValue(target, input.argument, arguments[i], ListOfTypes(types, " or "));
      continue;
    }
    target.place.AddNote(check_.diagnostics.Error(
        DiagnosticKind::kPortType, input.argument.range,
        fmt::format("{} takes {}, got {}", target.place.Text(), ListOfTypes(types, " or "),
                    check_.module.types.Text(got))));
  }
  return found;
}

// Where a texture at a port says which overloads are meant: reports the first port that none of
// these lets take what stands there.
bool SubgraphChecker::ReportPortBesideTexture(uint32_t index,
                                              const std::vector<Resolved>& arguments,
                                              const std::vector<const Overload*>& named) {
  const std::vector<Input>& inputs = subgraph_.nodes[index].inputs;
  auto port_of = [&](const Overload* overload, size_t i) -> const Port& {
    return *FindPort(overload->inputs, inputs[i].port);
  };
  auto fits = [&](const Overload* overload, size_t i) {
    return PortCost(port_of(overload, i), inputs[i].argument, arguments[i]).has_value();
  };
  for (size_t t = 0; t < inputs.size(); ++t) {
    if (arguments[t].kind != Resolved::Kind::kSymbol ||
        arguments[t].symbol.kind != Kind::kTexture) {
      continue;
    }
    std::vector<const Overload*> meant;
    std::ranges::copy_if(named, std::back_inserter(meant),
                         [&](const Overload* overload) { return fits(overload, t); });
    for (size_t i = 0; i < inputs.size(); ++i) {
      const ir::TypeId got = arguments[i].type;
      if (!got.valid() || meant.empty() ||
          std::ranges::any_of(meant, [&](const Overload* overload) { return fits(overload, i); })) {
        continue;
      }
      ReportBesideTexture(index, meant, i, got)
          .AddNote(inputs[t].argument.range,
                   fmt::format("beside '{}', which has {}", Printable(inputs[t].argument.text, 64),
                               WhatItHas(check_.graph.textures[arguments[t].symbol.index])));
      return true;
    }
  }
  return false;
}

Diagnostic& SubgraphChecker::ReportBesideTexture(uint32_t index,
                                                 const std::vector<const Overload*>& meant,
                                                 size_t input, ir::TypeId got) {
  const Node& node = subgraph_.nodes[index];
  const ir::Types& types = check_.module.types;
  std::vector<std::string> takes;
  for (const Overload* overload : meant) {
    std::string type = types.Text(FindPort(overload->inputs, node.inputs[input].port)->type);
    if (std::ranges::find(takes, type) == takes.end()) takes.push_back(std::move(type));
  }
  const Port& port = *FindPort(meant[0]->inputs, node.inputs[input].port);
  const Place place{"port", port.name, "node", node.name, port.range};
  Diagnostic& error = check_.diagnostics.Error(
      DiagnosticKind::kPortType, node.inputs[input].argument.range,
      fmt::format(
          "{} takes {}, got {}{}", place.Text(), ListOfTypes(takes, " or "), types.Text(got),
          takes.size() == 1 ? ConvertingBlocks(got, types.ValueOf(port.type), types, check_.library)
                            : ""));
  place.AddNote(error);
  return error;
}

// Every port fits some overload, but no overload fits them all.
void SubgraphChecker::ReportSignatures(uint32_t index, const std::vector<Resolved>& arguments) {
  const Node& node = subgraph_.nodes[index];
  const ir::Types& types = check_.module.types;
  std::vector<std::string> given;
  std::string hint;
  for (size_t i = 0; i < node.inputs.size(); ++i) {
    ir::TypeId type = arguments[i].type;
    given.push_back(
        fmt::format("{}: {}", Printable(node.inputs[i].port, 64),
                    type.valid() ? types.Text(type) : ArgumentText(node.inputs[i].argument)));
    for (size_t j = 0; j < node.inputs.size() && hint.empty() && type.valid(); ++j) {
      ir::TypeId other = arguments[j].type;
      if (!other.valid() || !ir::IsVector(type) || !ir::IsVector(other)) continue;
      if (ir::Width(type) > ir::Width(other)) {
        hint = ConvertingBlocks(type, other, types, check_.library);
      }
    }
  }
  Diagnostic& error =
      check_.diagnostics.Error(DiagnosticKind::kNoOverload, node.block_range,
                               fmt::format("no overload of {} takes {}{}", BlockText(index),
                                           ListOfTypes(given, ", "), hint));
  size_t shown = 0;
  for (const Overload& overload : nodes_[index].candidates) {
    if (++shown > kMaxSignatures) break;
    std::vector<std::string> ports;
    for (const Port& port : overload.inputs) {
      ports.push_back(fmt::format("{}: {}", port.name, types.Text(port.type)));
    }
    SourceRange range = overload.inputs.empty() ? SourceRange{} : overload.inputs[0].range;
    error.AddNote(range, fmt::format("it takes {}", ListOfTypes(ports, ", ")));
  }
}

}  // namespace texgraph::graph
