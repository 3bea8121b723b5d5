// SPDX-License-Identifier: Apache-2.0
// What stands at a function port becomes a function: a texture, a graph function, or any value.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/graph/conversion.h"
#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {
namespace {

using Kind = Symbol::Kind;

// The types of the prototype's parameters.
std::span<const ir::TypeId> ParameterTypes(const ir::Types& types, ir::TypeId field) {
  return std::span(types[field].elements).subspan(1);
}

// The prototype's parameters for the inputs of a block that is a port's default, by their names.
// Nothing if it does not fit: the first parameter, the coordinate, must have its input, and every
// other input a parameter or a default.
std::optional<std::vector<std::optional<uint32_t>>> MapBlock(const blocks::Port& port,
                                                             const blocks::Overload& overload,
                                                             const ir::Types& types) {
  std::span<const ir::TypeId> given = ParameterTypes(types, port.type);
  std::vector<std::optional<uint32_t>> by_parameter(overload.inputs.size());
  bool has_coordinate = false;
  for (size_t i = 0; i < overload.inputs.size(); ++i) {
    const blocks::Port& input = overload.inputs[i];
    auto named = std::ranges::find(port.field_parameters, input.name);
    if (named != port.field_parameters.end()) {
      const auto parameter = static_cast<uint32_t>(named - port.field_parameters.begin());
      if (input.kind != blocks::PortKind::kValue || input.type != given[parameter]) return {};
      by_parameter[i] = parameter;
      has_coordinate = has_coordinate || parameter == 0;
    } else if (input.kind == blocks::PortKind::kField || !input.computed_by.empty() ||
               (!input.default_value.valid() && input.default_input.empty())) {
      return {};
    }
  }
  if (!has_coordinate) return {};
  return by_parameter;
}

}  // namespace

std::optional<BoundPort> SubgraphChecker::BindField(const Target& target, const Argument& argument,
                                                    const Resolved& resolved) {
  const blocks::Port& port = target.port;
  ir::TypeId result = check_.module.types.ValueOf(port.type);
  if (resolved.kind == Resolved::Kind::kWrong) {
    ReportReference(argument, resolved);
    return std::nullopt;
  }
  if (resolved.kind == Resolved::Kind::kLiteral || IsConstantParameter(resolved)) {
    // The same value everywhere.
    blocks::Port value_port = port;
    value_port.kind = blocks::PortKind::kValue;
    value_port.type = result;
    std::optional<BoundPort> bound = BindValue({value_port, target.place}, argument, resolved);
    if (!bound) return std::nullopt;
    ir::ConstId value = std::get<ConstantValue>(bound->source).value;
    return BoundPort{FieldOfConstant{value}, result, port.type, {}, argument.range};
  }
  uint32_t index = resolved.symbol.index;
  Source source;
  switch (resolved.symbol.kind) {
    case Kind::kTexture:
      return BindFieldOfTexture(target, argument, index);
    case Kind::kFunction:
      return BindFieldOfFunction(target, argument, resolved);
    case Kind::kBuiltin:
      source = FieldOfBuiltin{index};
      break;
    case Kind::kParameter:
      source = FieldOfParameter{index};
      break;
    case Kind::kFunctionInput:
      source = FieldOfFunctionInput{index};
      break;
    case Kind::kNode:
      source = FieldOfNode{{position_[index], resolved.output}};
      break;
  }
  if (!resolved.type.valid()) return std::nullopt;  // the reason was reported
  if (!ConversionCost(resolved.type, result)) {
    ReportType(target, argument, resolved.type);
    return std::nullopt;
  }
  return BoundPort{source, resolved.type, port.type, {}, argument.range};
}

// texture(t, first parameter)
std::optional<BoundPort> SubgraphChecker::BindFieldOfTexture(const Target& target,
                                                             const Argument& argument,
                                                             uint32_t texture) {
  const ir::Types& types = check_.module.types;
  ir::TypeId type = target.port.type;
  ir::TypeId coordinate = CoordinateType(check_.graph.textures[texture]);
  std::span<const ir::TypeId> parameters = ParameterTypes(types, type);
  if (parameters.empty() || parameters[0] != coordinate) {
    target.place.AddNote(check_.diagnostics.Error(
        DiagnosticKind::kPortType, argument.range,
        fmt::format("{} takes {}, but the texture '{}' is a function of {}", target.place.Text(),
                    types.Text(type), check_.graph.textures[texture].name,
                    types.Text(coordinate))));
    return std::nullopt;
  }
  if (!ConversionCost(ir::kVec4, types.ValueOf(type))) {
    ReportType(target, argument, ir::kVec4);
    return std::nullopt;
  }
  return BoundPort{FieldOfTexture{texture}, ir::kVec4, type, {}, argument.range};
}

// A prototype's parameter goes to the function's input of its name, else to the first free one of
// its type. Inputs that get none keep their defaults.
SubgraphChecker::FieldMapping SubgraphChecker::MapFunction(const blocks::Port& port,
                                                           uint32_t function) const {
  const std::vector<blocks::Port>& inputs = check_.signatures[function].inputs;
  std::span<const ir::TypeId> types = ParameterTypes(check_.module.types, port.type);
  FieldMapping mapping;
  mapping.by_parameter.resize(inputs.size());
  std::vector<bool> taken(types.size(), false);
  for (uint32_t i = 0; i < inputs.size(); ++i) {
    auto named = std::ranges::find(port.field_parameters, inputs[i].name);
    if (named == port.field_parameters.end()) continue;
    auto parameter = static_cast<uint32_t>(named - port.field_parameters.begin());
    if (inputs[i].type.valid() && !ConversionCost(types[parameter], inputs[i].type)) {
      mapping.unfit = i;
    }
    mapping.by_parameter[i] = parameter;
    taken[parameter] = true;
  }
  for (uint32_t p = 0; p < types.size(); ++p) {
    if (taken[p]) continue;
    for (uint32_t i = 0; i < inputs.size(); ++i) {
      if (mapping.by_parameter[i] || inputs[i].type != types[p]) continue;
      mapping.by_parameter[i] = p;
      break;
    }
  }
  for (uint32_t i = 0; i < inputs.size() && !mapping.missing; ++i) {
    bool needed = inputs[i].type.valid() && !inputs[i].default_value.valid();
    if (needed && !mapping.by_parameter[i]) mapping.missing = i;
  }
  return mapping;
}

std::optional<BoundPort> SubgraphChecker::BindFieldOfFunction(const Target& target,
                                                              const Argument& argument,
                                                              const Resolved& resolved) {
  const ir::Types& types = check_.module.types;
  uint32_t function = resolved.symbol.index;
  const blocks::Overload& signature = check_.signatures[function];
  FieldMapping mapping = MapFunction(target.port, function);
  std::string_view name = check_.graph.functions[function].name;
  if (mapping.unfit) {
    const blocks::Port& input = signature.inputs[*mapping.unfit];
    ir::TypeId given =
        ParameterTypes(types, target.port.type)[*mapping.by_parameter[*mapping.unfit]];
    check_.diagnostics
        .Error(DiagnosticKind::kPortType, argument.range,
               fmt::format("{} gives '{}' as {}, but function '{}' takes {}", target.place.Text(),
                           input.name, types.Text(given), name, types.Text(input.type)))
        .AddNote(input.range, "the function's input is declared here")
        .AddNote(target.port.range, "the port is declared here");
    return std::nullopt;
  }
  if (mapping.missing) {
    const blocks::Port& input = signature.inputs[*mapping.missing];
    check_.diagnostics
        .Error(
            DiagnosticKind::kMissingInput, argument.range,
            fmt::format("function '{}' needs '{}', which {} does not give; a \"value\" of its own "
                        "would do",
                        name, input.name, target.place.Text()))
        .AddNote(input.range, "the function's input is declared here")
        .AddNote(target.port.range, "the port is declared here");
    return std::nullopt;
  }
  if (!resolved.type.valid()) return std::nullopt;  // the reason was reported
  if (!ConversionCost(resolved.type, types.ValueOf(target.port.type))) {
    ReportType(target, argument, resolved.type);
    return std::nullopt;
  }
  FieldOfFunction source{CheckedFunction(function), resolved.output};
  return BoundPort{source, resolved.type, target.port.type, std::move(mapping.by_parameter),
                   argument.range};
}

// The block that is the port's default.
std::optional<BoundPort> SubgraphChecker::BindFieldOfBlock(const Target& target,
                                                           SourceRange range) {
  const blocks::Port& port = target.port;
  const ir::Types& types = check_.module.types;
  const blocks::Block* block = check_.library.Find(port.default_block);
  if (!block && check_.library.Exists(port.default_block)) {
    check_.failed = true;  // it is wrong, which was reported
    return std::nullopt;
  }
  const ir::TypeId result = types.ValueOf(port.type);
  for (const blocks::Overload& overload :
       block ? std::span(block->overloads) : std::span<const blocks::Overload>()) {
    const ir::TypeId given = overload.outputs[0].type;
    if (!ConversionCost(given, result)) continue;
    if (auto by_parameter = MapBlock(port, overload, types)) {
      std::vector<DefaultBlock>& known = check_.result.default_blocks;
      const DefaultBlock meant{block, &overload};
      const auto index = static_cast<uint32_t>(std::ranges::find(known, meant) - known.begin());
      if (index == known.size()) known.push_back(meant);
      return BoundPort{FieldOfBlock{index}, given, port.type, std::move(*by_parameter), range};
    }
  }
  const std::string which =
      fmt::format("'{}', the default of '{}'", Printable(port.default_block, 64), port.name);
  check_.diagnostics
      .Error(
          DiagnosticKind::kBlockDoc, port.range,
          block ? fmt::format("{}, does not take what this gives: {}", which, types.Text(port.type))
                : fmt::format("there is no block {}", which))
      .AddNote(range, fmt::format("{} is not connected", target.place.Text()));
  return std::nullopt;
}

std::optional<int> SubgraphChecker::FieldCost(const blocks::Port& port, const Argument& argument,
                                              const Resolved& resolved) const {
  const ir::Types& types = check_.module.types;
  ir::TypeId result = types.ValueOf(port.type);
  if (resolved.kind == Resolved::Kind::kLiteral) return LiteralCost(argument, result, types);
  if (resolved.kind == Resolved::Kind::kWrong) return 0;  // reported when it is bound
  if (resolved.symbol.kind == Kind::kTexture) {
    ir::TypeId coordinate = CoordinateType(check_.graph.textures[resolved.symbol.index]);
    std::span<const ir::TypeId> parameters = ParameterTypes(types, port.type);
    bool fits = !parameters.empty() && parameters[0] == coordinate;
    return fits ? ConversionCost(ir::kVec4, result) : std::nullopt;
  }
  bool function = resolved.symbol.kind == Kind::kFunction;
  if (function && !MapFunction(port, resolved.symbol.index).ok()) return std::nullopt;
  return resolved.type.valid() ? ConversionCost(resolved.type, result) : 0;
}

}  // namespace texgraph::graph
