// SPDX-License-Identifier: Apache-2.0
// What the text at a port names.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/graph/literal.h"
#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {
namespace {

using Kind = Symbol::Kind;

std::string ListOfPorts(std::string_view node, const std::vector<blocks::Port>& ports) {
  return Listed(ports, " or ",
                [&](const blocks::Port& port) { return fmt::format("'{}.{}'", node, port.name); });
}

bool AreComponents(std::string_view text) {
  return !text.empty() && text.size() <= 4 &&
         text.find_first_not_of("xyzwrgba") == std::string_view::npos;
}

}  // namespace

const std::vector<blocks::Port>* SubgraphChecker::OutputsOf(Symbol symbol) const {
  if (symbol.kind == Kind::kFunction) return &check_.signatures[symbol.index].outputs;
  const NodeState& state = nodes_[symbol.index];
  return state.chosen == nullptr ? nullptr : &state.chosen->outputs;
}

ir::TypeId SubgraphChecker::ParameterType(uint32_t parameter) const {
  return check_.result.parameters[parameter].type;
}

bool SubgraphChecker::IsConstantParameter(const Resolved& resolved) const {
  return resolved.kind == Resolved::Kind::kSymbol && resolved.symbol.kind == Kind::kParameter &&
         check_.graph.parameters[resolved.symbol.index].binding == Binding::kConstant;
}

uint32_t SubgraphChecker::CheckedFunction(uint32_t function) const {
  return check_.result.function_of_graph[function];
}

Resolved SubgraphChecker::Resolve(const Argument& argument) const {
  if (argument.kind != Argument::Kind::kString) return {};
  Reference reference = SplitReference(argument.text);
  Resolved wrong;
  wrong.kind = Resolved::Kind::kWrong;
  std::optional<Symbol> symbol = scope_.Find(reference.name);
  if (!symbol) {
    wrong.problem = Resolved::Problem::kNoSuchName;
    return wrong;
  }
  if (reference.has_member) {
    wrong.problem = Resolved::Problem::kMember;
    return wrong;
  }
  if (symbol->kind == Kind::kNode || symbol->kind == Kind::kFunction) {
    return ResolveOutput(*symbol, reference.port);
  }
  if (reference.port) {
    wrong.problem = Resolved::Problem::kNoSuchOutput;
    return wrong;
  }
  Resolved resolved;
  resolved.kind = Resolved::Kind::kSymbol;
  resolved.symbol = *symbol;
  if (symbol->kind == Kind::kBuiltin) {
    resolved.type = check_.module.types.Find(kBuiltinInputs[symbol->index].type);
  } else if (symbol->kind == Kind::kParameter) {
    resolved.type = ParameterType(symbol->index);
  } else if (symbol->kind == Kind::kFunctionInput) {
    resolved.type = signature_->inputs[symbol->index].type;
  }
  return resolved;
}

// A plain name means the only output, or the return value.
Resolved SubgraphChecker::ResolveOutput(Symbol symbol,
                                        const std::optional<std::string_view>& port) const {
  Resolved resolved;
  resolved.kind = Resolved::Kind::kSymbol;
  resolved.symbol = symbol;
  const std::vector<blocks::Port>* outputs = OutputsOf(symbol);
  if (!outputs || outputs->empty()) return resolved;  // not known
  if (!port) {
    if (outputs->size() > 1 && outputs->front().name != "result") {
      resolved.kind = Resolved::Kind::kWrong;
      resolved.problem = Resolved::Problem::kSeveralOutputs;
      return resolved;
    }
  } else {
    while (resolved.output < outputs->size() && (*outputs)[resolved.output].name != *port) {
      ++resolved.output;
    }
    if (resolved.output == outputs->size()) {
      resolved.kind = Resolved::Kind::kWrong;
      resolved.problem = Resolved::Problem::kNoSuchOutput;
      return resolved;
    }
  }
  if (symbol.kind == Kind::kFunction || nodes_[symbol.index].certain) {
    resolved.type = (*outputs)[resolved.output].type;
  }
  return resolved;
}

void SubgraphChecker::ReportReference(const Argument& argument, const Resolved& resolved) {
  Reference reference = SplitReference(argument.text);
  switch (resolved.problem) {
    case Resolved::Problem::kNone:
      return;
    case Resolved::Problem::kNoSuchName:
      return ReportUnknownName(argument, reference.name);
    case Resolved::Problem::kNoSuchOutput:
      return ReportUnknownOutput(argument, reference);
    case Resolved::Problem::kMember:
      check_.diagnostics.Error(
          DiagnosticKind::kUnknownReference, argument.range,
          fmt::format("'{}' has two dots: a graph cannot reach the members of a struct; connect "
                      "'{}.{}' to a block that reads it",
                      Printable(argument.text, 64), reference.name,
                      Printable(*reference.port, 64)));
      return;
    case Resolved::Problem::kSeveralOutputs: {
      Symbol symbol = *scope_.Find(reference.name);
      check_.diagnostics.Error(
          DiagnosticKind::kUnknownReference, argument.range,
          fmt::format("{} '{}' has several outputs; write {}", KindText(symbol.kind),
                      reference.name, ListOfPorts(reference.name, *OutputsOf(symbol))));
      return;
    }
  }
}

void SubgraphChecker::ReportUnknownName(const Argument& argument, std::string_view name) {
  std::string hint;
  if (!check_.diagnostics.full()) {
    hint = DidYouMean(name, scope_.Names());
    bool in_main = &subgraph_ != &check_.graph.main &&
                   std::ranges::any_of(check_.graph.main.nodes,
                                       [&](const Node& node) { return node.name == name; });
    if (in_main) {
      hint =
          fmt::format("; node '{}' is outside of function '{}', which could have an input for it",
                      name, subgraph_.name);
    } else if (std::string_view text_hint = TextHint(argument.text); !text_hint.empty()) {
      hint = text_hint;
    } else if (hint.empty() && IsIdentifier(name) && check_.library.Exists(name)) {
      hint = fmt::format("; the block '{}' needs a node", name);
    }
  }
  check_.diagnostics.Error(DiagnosticKind::kUnknownReference, argument.range,
                           fmt::format("nothing is called '{}' here{}", Printable(name, 64), hint));
}

void SubgraphChecker::ReportUnknownOutput(const Argument& argument, const Reference& reference) {
  Symbol symbol = *scope_.Find(reference.name);
  std::string hint;
  if (symbol.kind == Kind::kNode || symbol.kind == Kind::kFunction) {
    std::vector<std::string_view> names;
    for (const blocks::Port& port : *OutputsOf(symbol)) names.push_back(port.name);
    hint = DidYouMean(*reference.port, names);
    if (hint.empty() && names.size() == 1) hint = fmt::format("; write '{}'", reference.name);
  }
  if (AreComponents(*reference.port) && check_.library.Exists("separate")) {
    hint = "; the block 'separate' gives single components";
  }
  check_.diagnostics.Error(DiagnosticKind::kUnknownReference, argument.range,
                           fmt::format("{} '{}' has no output '{}'{}", KindText(symbol.kind),
                                       reference.name, Printable(*reference.port, 64), hint));
}

}  // namespace texgraph::graph
