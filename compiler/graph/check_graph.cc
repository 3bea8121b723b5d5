// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <unordered_map>

#include "compiler/graph/checked_graph.h"
#include "compiler/graph/literal.h"
#include "compiler/graph/order.h"
#include "compiler/graph/subgraph_checker.h"

namespace texgraph::graph {

namespace {

constexpr std::array<std::string_view, 10> kValueTypes = {
    "bool", "int", "uint", "float", "vec2", "vec3", "vec4", "ivec2", "ivec3", "ivec4"};

class GraphChecker {
 public:
  GraphChecker(const Graph& graph, blocks::Library& library, ir::Module& module,
               Diagnostics& diagnostics)
      : check_{graph, library, module, diagnostics, result_, GlobalSymbols(graph), {}, false} {
    result_.graph = &graph;
  }

  // Nothing if a block is wrong; other mistakes are in the diagnostics.
  std::optional<CheckedGraph> Check(const std::vector<Setting>& settings) {
    CheckParameters(settings);
    DeclareFunctions();
    CheckFunctions();
    SubgraphChecker main(check_, check_.graph.main, nullptr);
    main.FindBlocks();
    main.Check(result_.main);
    if (check_.failed) return std::nullopt;
    return std::move(result_);
  }

 private:
  ir::TypeId TypeOf(std::string_view name, SourceRange range, bool structs);
  void CheckParameters(const std::vector<Setting>& settings);
  CheckedParameter CheckParameter(const Parameter& parameter, const Setting* setting);
  std::unordered_map<std::string_view, const Setting*> FindSettings(
      const std::vector<Setting>& settings);
  void DeclareFunctions();
  blocks::Port DeclareInput(const Subgraph& function, const FunctionInput& input);
  void CheckFunctions();
  void ReportCircle(const std::vector<uint32_t>& circle);

  CheckedGraph result_;
  GraphCheck check_;
  std::deque<SubgraphChecker> functions_;  // by index in Graph::functions
};

// The type of a parameter or of a function's input; invalid, and reported, if there is none.
ir::TypeId GraphChecker::TypeOf(std::string_view name, SourceRange range, bool structs) {
  if (std::ranges::find(kValueTypes, name) != kValueTypes.end()) {
    return check_.module.types.Find(name);
  }
  if (structs) {
    ir::TypeId type = check_.library.FindType(name);
    if (type.valid() && check_.module.types.Kind(type) == ir::TypeKind::kStruct) return type;
  }
  std::vector<std::string_view> names(kValueTypes.begin(), kValueTypes.end());
  std::string hint = DidYouMean(name, names);
  if (hint.empty()) hint = "; types are bool, int, uint, float, vec2 to vec4 and ivec2 to ivec4";
  check_.diagnostics.Error(DiagnosticKind::kBadValue, range,
                           fmt::format("'{}' is no type of {}{}", Printable(name, 64),
                                       structs ? "a function's input" : "a parameter", hint));
  return {};
}

// The last setting of each name, after those that name nothing were reported.
std::unordered_map<std::string_view, const Setting*> GraphChecker::FindSettings(
    const std::vector<Setting>& settings) {
  std::unordered_map<std::string_view, const Setting*> by_name;
  for (const Setting& setting : settings) {
    const Symbol* known = check_.globals.Find(setting.name);
    if (known && known->kind == Symbol::Kind::kParameter) {
      by_name[setting.name] = &setting;
      continue;
    }
    std::vector<std::string_view> names;
    for (const Parameter& parameter : check_.graph.parameters) names.push_back(parameter.name);
    check_.diagnostics.Error(
        DiagnosticKind::kUnknownParameter, setting.range,
        fmt::format("the graph has no parameter '{}'{}", Printable(setting.name, 64),
                    DidYouMean(setting.name, names)));
  }
  return by_name;
}

void GraphChecker::CheckParameters(const std::vector<Setting>& settings) {
  auto by_name = FindSettings(settings);
  result_.parameters.reserve(check_.graph.parameters.size());
  for (const Parameter& parameter : check_.graph.parameters) {
    auto setting = by_name.find(parameter.name);
    result_.parameters.push_back(
        CheckParameter(parameter, setting == by_name.end() ? nullptr : setting->second));
  }
}

CheckedParameter GraphChecker::CheckParameter(const Parameter& parameter, const Setting* setting) {
  CheckedParameter checked{&parameter, TypeOf(parameter.type, parameter.type_range, false), {}};
  if (!checked.type.valid()) return checked;
  if (parameter.binding == Binding::kSpecialization && !ir::IsScalar(checked.type)) {
    check_.diagnostics.Error(
        DiagnosticKind::kBadValue, parameter.type_range,
        fmt::format("specialization constants are scalars; parameter '{}' is {}", parameter.name,
                    parameter.type));
  }
  if (parameter.minimum && ir::IsBool(checked.type)) {
    check_.diagnostics.Error(
        DiagnosticKind::kBadValue, parameter.range,
        fmt::format("parameter '{}' is bool and has no range", parameter.name));
  }
  Place place{"parameter", parameter.name, "", "", {}, DiagnosticKind::kBadValue};
  ValueLimits limits{parameter.minimum, parameter.maximum};
  auto read = [&](const Argument& argument) -> ir::ConstId {
    auto value = MakeLiteral(argument, checked.type, place, check_.module, check_.diagnostics);
    if (!value) return {};
    bool good =
        CheckLimits(*value, limits, argument.range, place, check_.module, check_.diagnostics);
    // Without a value, the ports where it stands don't complain of it once more.
    return good ? *value : ir::ConstId();
  };
  checked.value = read(parameter.value);
  if (setting) {
    place.declared = parameter.range;
    checked.value = read(setting->value);
  }
  return checked;
}

blocks::Port GraphChecker::DeclareInput(const Subgraph& function, const FunctionInput& input) {
  blocks::Port port;
  port.name = input.name;
  port.range = input.range;
  port.type = TypeOf(input.type, input.type_range, true);
  if (input.value && port.type.valid()) {
    Place place{"input", input.name, "function", function.name, {}, DiagnosticKind::kBadValue};
    auto value = MakeLiteral(*input.value, port.type, place, check_.module, check_.diagnostics);
    // A wrong value, which was reported, is not a missing one.
    std::vector<uint32_t> zeros(check_.module.types.Words(port.type), 0);
    port.default_value = value ? *value : check_.module.Intern(port.type, zeros);
  }
  return port;
}

// Afterwards every function has its signature, with the types of its inputs.
void GraphChecker::DeclareFunctions() {
  for (const Subgraph& function : check_.graph.functions) {
    blocks::Overload& signature = check_.signatures.emplace_back();
    for (const FunctionInput& input : function.inputs) {
      signature.inputs.push_back(DeclareInput(function, input));
    }
    for (const Output& output : function.outputs) {
      blocks::Port port;
      port.name = output.name;
      port.range = output.range;
      signature.outputs.push_back(std::move(port));
    }
  }
}

void GraphChecker::ReportCircle(const std::vector<uint32_t>& circle) {
  std::vector<std::string_view> names;
  for (uint32_t function : circle) names.push_back(check_.graph.functions[function].name);
  Diagnostic& error = check_.diagnostics.Error(
      DiagnosticKind::kCycle, check_.graph.functions[circle[0]].range,
      circle.size() == 1
          ? fmt::format("function '{}' calls itself", names[0])
          : fmt::format("these functions call each other in a circle: {}", CircleText(names)));
  for (size_t i = 1; i < std::min(circle.size(), kShownOfCircle); ++i) {
    error.AddNote(check_.graph.functions[circle[i]].range,
                  fmt::format("function '{}' is here", names[i]));
  }
}

void GraphChecker::CheckFunctions() {
  size_t count = check_.graph.functions.size();
  Dependencies calls;
  for (size_t i = 0; i < count; ++i) {
    SubgraphChecker& checker =
        functions_.emplace_back(check_, check_.graph.functions[i], &check_.signatures[i]);
    checker.FindBlocks();
    for (uint32_t callee : checker.CalledFunctions()) calls.Add(callee);
    calls.EndThing();
  }
  Order order = OrderByNeed(calls);
  for (const std::vector<uint32_t>& circle : order.circles) ReportCircle(circle);
  result_.function_of_graph.resize(count);
  for (uint32_t i = 0; i < count; ++i) result_.function_of_graph[order.sequence[i]] = i;
  for (uint32_t index : order.sequence) {
    blocks::Overload& signature = check_.signatures[index];
    CheckedSubgraph& checked = result_.functions.emplace_back();
    for (const blocks::Port& port : signature.inputs) {
      checked.input_types.push_back(port.type);
      checked.input_defaults.push_back(port.default_value);
    }
    functions_[index].Check(checked);
    for (const CheckedOutput& output : checked.outputs) {
      auto port = std::ranges::find(signature.outputs, output.name, &blocks::Port::name);
      port->type = output.value.type;
    }
  }
}

// Every port and output has its source.
bool IsWhole(const CheckedGraph& graph, const CheckedSubgraph& subgraph) {
  if (subgraph.outputs.size() != subgraph.subgraph->outputs.size()) return false;
  return std::ranges::all_of(subgraph.nodes, [&](const CheckedNode& node) {
    size_t ports = node.block ? node.overload->inputs.size()
                              : graph.functions[node.function].input_types.size();
    return node.inputs.size() == ports;
  });
}

}  // namespace

std::optional<CheckedGraph> CheckGraph(const Graph& graph, const std::vector<Setting>& settings,
                                       blocks::Library& library, ir::Module& module,
                                       Diagnostics& diagnostics) {
  size_t errors_before = diagnostics.error_count();
  auto checked = GraphChecker(graph, library, module, diagnostics).Check(settings);
  if (diagnostics.error_count() > errors_before) return std::nullopt;
  // A block that was reported before this call stops it as well.
  if (!checked && diagnostics.HasErrors()) return std::nullopt;
  auto is_whole = [&](const CheckedSubgraph& subgraph) { return IsWhole(*checked, subgraph); };
  if (!checked || !is_whole(checked->main) || !std::ranges::all_of(checked->functions, is_whole)) {
    diagnostics.Error(DiagnosticKind::kInternal, graph.range, "a mistake of this graph got lost");
    return std::nullopt;
  }
  return checked;
}

}  // namespace texgraph::graph
