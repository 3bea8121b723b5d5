// SPDX-License-Identifier: Apache-2.0
// BuildModule: a checked graph becomes main, one function for each graph function, and one for each
// plain output that stands at a function port. Every function but main takes the built-in inputs
// that it depends on as parameters, so a graph function inside a field sees the coordinate that the
// block asks for.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/passes/build_scope.h"
#include "compiler/passes/passes.h"

namespace texgraph::passes {
namespace {

// Functions at function ports of nodes that are themselves evaluated for a function port, and so
// on.
constexpr int kMaxFieldDepth = 64;

// What the compiler knows of a texture of numbers.
std::optional<ir::MapFacts> FactsOf(const graph::Texture& texture) {
  if (!texture.IsMap()) return std::nullopt;
  if (texture.kind == graph::TextureKind::kSprites) {
    return ir::MapFacts{texture.sprites.columns, texture.sprites.rows, texture.sprites.layers, {}};
  }
  ir::MapFacts facts{texture.map.width, texture.map.height, 1, {}};
  if (texture.is_constant) facts.values = texture.map.numbers;
  return facts;
}

bool Repeats(const graph::Texture& texture) {
  constexpr graph::TextureWrap kRepeat = graph::TextureWrap::kRepeat;
  return texture.wrap_u == kRepeat && texture.wrap_v == kRepeat &&
         (!texture.is_3d || texture.wrap_w == kRepeat);
}

// What the inputs of a port's default block have as defaults.
BuiltinSet UsedByDefault(const BoundPort& bound, const graph::DefaultBlock& source) {
  BuiltinSet use = 0;
  for (size_t i = 0; i < source.overload->inputs.size(); ++i) {
    const std::string& input = source.overload->inputs[i].default_input;
    if (!input.empty() && !bound.by_parameter[i]) use |= 1u << BuiltinIndex(input);
  }
  return use;
}

}  // namespace

void Program::DeclareGlobals() {
  parameters_.resize(graph.parameters.size());
  textures_.resize(graph.graph->textures.size());
  for (uint32_t b = 0; b < kBuiltinCount; ++b) {
    if (kBuiltinInputs[b].kind == BuiltinKind::kZero) continue;
    ir::GlobalKind kind = kBuiltinInputs[b].kind == BuiltinKind::kUniform ? ir::GlobalKind::kUniform
                                                                          : ir::GlobalKind::kInput;
    builtins_[b] = module.AddGlobal({kind,
                                     std::string(kBuiltinInputs[b].name),
                                     module.types.Find(kBuiltinInputs[b].type),
                                     {},
                                     true});
  }
  for (size_t i = 0; i < graph.parameters.size(); ++i) {
    const graph::CheckedParameter& parameter = graph.parameters[i];
    if (parameter.parameter->binding == graph::Binding::kConstant) continue;
    ir::GlobalKind kind = parameter.parameter->binding == graph::Binding::kUniform
                              ? ir::GlobalKind::kUniform
                              : ir::GlobalKind::kSpecialization;
    parameters_[i] = module.AddGlobal(
        {kind, std::string(parameter.parameter->name), parameter.type, parameter.value, true});
  }
  for (size_t i = 0; i < textures_.size(); ++i) {
    const graph::Texture& texture = graph.graph->textures[i];
    // Textures of equal files and sampler state share one sampler.
    if (uint32_t same = graph::FirstEqualTexture(*graph.graph, static_cast<uint32_t>(i));
        same < i) {
      textures_[i] = textures_[same];
      continue;
    }
    textures_[i] = module.AddGlobal({ir::GlobalKind::kTexture,
                                     std::string(texture.name),
                                     graph::SamplerType(texture),
                                     {},
                                     texture.filter == graph::TextureFilter::kLinear,
                                     Repeats(texture),
                                     FactsOf(texture)});
  }
}

ir::GlobalId Program::Parameter(uint32_t index) { return parameters_[index]; }
ir::GlobalId Program::Texture(uint32_t index) { return textures_[index]; }
ir::GlobalId Program::BuiltinGlobal(uint32_t index) { return builtins_[index]; }

BuiltinSet Program::UseOf(const CheckedSubgraph& subgraph, const BoundPort& bound,
                          const blocks::Port* port) const {
  BuiltinSet use = 0;
  const std::vector<BuiltinSet>& nodes = node_use_.at(&subgraph);
  if (auto* output = std::get_if<graph::NodeOutput>(&bound.source)) return nodes[output->node];
  if (auto* builtin = std::get_if<graph::BuiltinRef>(&bound.source)) return 1u << builtin->input;
  if (auto* node = std::get_if<graph::FieldOfNode>(&bound.source)) {
    use = nodes[node->source.node];
  } else if (auto* function = std::get_if<graph::FieldOfFunction>(&bound.source)) {
    use = function_use[function->function];
  } else if (auto* field = std::get_if<graph::FieldOfBuiltin>(&bound.source)) {
    use = 1u << field->input;
  } else if (auto* block = std::get_if<graph::FieldOfBlock>(&bound.source)) {
    use = UsedByDefault(bound, graph.default_blocks[block->block]);
  } else {
    return 0;
  }
  return use & ~ReplacedSet(ReplacedBuiltins(module.types, bound.type, port->field_parameters));
}

void Program::FindUse(const CheckedSubgraph& subgraph) {
  std::vector<BuiltinSet>& use = node_use_[&subgraph];
  use.assign(subgraph.nodes.size(), 0);
  for (size_t n = 0; n < subgraph.nodes.size(); ++n) {
    const CheckedNode& node = subgraph.nodes[n];
    if (!node.block) use[n] = function_use[node.function];
    for (size_t i = 0; i < node.inputs.size(); ++i) {
      use[n] |= UseOf(subgraph, node.inputs[i], node.block ? &node.overload->inputs[i] : nullptr);
    }
  }
}

// A noise of the plane at the port of a fractal in space, say. What depends on no coordinate at all
// is meant to be the same everywhere, and so it may be where the port draws in the frame of a tile.
void Program::WarnIfCoordinateIsIgnored(const CheckedSubgraph& subgraph, const BoundPort& bound,
                                        const blocks::Port& port, BuiltinSet replaced) {
  const std::vector<ir::TypeId> elements = module.types[bound.type].elements;
  if (elements.size() < 2 || !ir::IsVector(elements[1]) || !ir::IsFloat(elements[1])) return;
  if (!std::ranges::all_of(elements.begin() + 1, elements.end(), ir::IsVector)) return;
  BuiltinSet use = 0;
  std::string_view name;
  if (auto* node = std::get_if<graph::FieldOfNode>(&bound.source)) {
    use = UsedBy(subgraph, node->source.node);
    name = subgraph.nodes[node->source.node].node->name;
  } else if (auto* function = std::get_if<graph::FieldOfFunction>(&bound.source)) {
    if (std::ranges::count(bound.by_parameter, std::optional<uint32_t>(0))) return;
    use = function_use[function->function];
    name = graph.functions[function->function].subgraph->name;
  } else if (auto* builtin = std::get_if<graph::FieldOfBuiltin>(&bound.source)) {
    use = 1u << builtin->input;
    name = kBuiltinInputs[builtin->input].name;
  }
  use &= kCoordinates;
  if (use == 0 || (use & replaced)) return;
  const BuiltinInput& taken = kBuiltinInputs[use & 1u << kUv ? kUv : kPosition];
  const std::string asked = module.types.Text(elements[1]);
  const BuiltinSet fit = replaced & kCoordinates;
  diagnostics
      .Warn(DiagnosticKind::kIgnoredCoordinate, bound.range,
            fmt::format(
                "'{}' is the same wherever port '{}' asks: the port gives a {}, and this "
                "takes the {} '{}' of the graph; {}",
                name, port.name, asked, taken.type, taken.name,
                fit != 0
                    ? fmt::format("take '{}' there", kBuiltinInputs[fit & 1 ? kUv : kPosition].name)
                    : fmt::format("make it a function with an input of type {}", asked)))
      .AddNote(port.range, "the port is declared here");
}

const FieldFunction* Program::Field(const CheckedSubgraph& subgraph, const BoundPort& bound,
                                    const blocks::Port& port) {
  std::string key = FieldKey(subgraph, bound, port);
  if (auto known = fields_.find(key); known != fields_.end()) return &known->second;
  if (failed) return nullptr;
  if (field_depth_ >= kMaxFieldDepth) {
    diagnostics.Error(
        DiagnosticKind::kInstanceLimit, bound.range,
        fmt::format("more than {} function ports are nested in one another here", kMaxFieldDepth));
    failed = true;
    return nullptr;
  }
  ++field_depth_;
  const std::vector<std::string>& names = port.field_parameters;
  std::vector<int> replaced = ReplacedBuiltins(module.types, bound.type, names);
  WarnIfCoordinateIsIgnored(subgraph, bound, port, ReplacedSet(replaced));
  ir::Function function;
  function.display_name = FieldName(graph, subgraph, bound, port);
  function.name = fmt::format("{}.field{}", function.display_name, fields_.size());
  std::string coordinates = names.empty() ? "nothing" : names[0];
  for (size_t p = 1; p < names.size(); ++p) coordinates += ", " + names[p];
  function.origin = module.AddOrigin({"", function.display_name, "a function of " + coordinates});
  Scope scope(*this, subgraph, function, true, ReplacedSet(replaced));
  const std::vector<ir::TypeId> elements = module.types[bound.type].elements;
  std::vector<ValueId> parameters;
  for (size_t p = 0; p + 1 < elements.size(); ++p) {
    std::string name = p < names.size() ? names[p] : "p";
    parameters.push_back(scope.builder().AddParameter({name, elements[p + 1]}));
    if (replaced[p] >= 0) scope.SetBuiltin(static_cast<uint32_t>(replaced[p]), parameters.back());
  }
  scope.SetPrototype(port, std::move(parameters), replaced.empty() ? -1 : replaced[0]);
  ValueId value = scope.FieldBody(bound);
  --field_depth_;
  if (failed || !value) return nullptr;
  scope.builder().Return({{value}});
  FieldFunction field{{}, scope.captures(), {}};
  auto* node = std::get_if<graph::FieldOfNode>(&bound.source);
  if (node && ReplacedSet(replaced) == 1u << kNeighbour) {
    field.here = node->source;
    function.knows_home = true;
    scope.builder().AddParameter({"home", elements[1]});
    scope.builder().AddParameter({port.name, elements[0]});
  }
  module.functions.push_back(std::move(function));
  field.id = ir::FunctionId(module.functions.size() - 1);
  return &fields_.emplace(std::move(key), std::move(field)).first->second;
}

void Program::BuildGraphFunction(uint32_t index) {
  const CheckedSubgraph& subgraph = graph.functions[index];
  FindUse(subgraph);
  BuiltinSet use = 0;
  for (BuiltinSet node : node_use_[&subgraph]) use |= node;
  for (const graph::CheckedOutput& output : subgraph.outputs)
    use |= UseOf(subgraph, output.value, nullptr);
  function_use.push_back(use);
  ir::Function function;
  function.display_name = std::string(subgraph.subgraph->name);
  function.name = function.display_name + ".function";
  function.origin = module.AddOrigin({"", function.display_name, "function of the graph"});
  Scope scope(*this, subgraph, function, false, 0);
  for (uint32_t i = 0; i < subgraph.input_types.size(); ++i) {
    std::string name(subgraph.subgraph->inputs[i].name);
    scope.SetInput(i, scope.builder().AddParameter({name, subgraph.input_types[i]}));
  }
  for (uint32_t b = 0; b < kBuiltinCount; ++b) {
    if (!(use >> b & 1)) continue;
    ir::TypeId type = module.types.Find(kBuiltinInputs[b].type);
    scope.SetBuiltin(b, scope.builder().AddParameter({std::string(kBuiltinInputs[b].name), type}));
  }
  std::vector<AskedParameter> asks;
  scope.SetAsks(asks);
  std::vector<ValueId> values;
  for (const graph::CheckedOutput& output : subgraph.outputs) {
    values.push_back(scope.Value(output.value, nullptr));
    if (!values.back()) failed = true;
    if (failed) return;
    function.results.push_back(
        {values.size() == 1 ? "" : output.name, scope.builder().TypeOf(values.back())});
  }
  scope.builder().Return(values);
  module.functions.push_back(std::move(function));
  function_asks.push_back(std::move(asks));
  graph_functions.push_back(ir::FunctionId(module.functions.size() - 1));
}

void Program::BuildMain() {
  FindUse(graph.main);
  module.origins.reserve(module.origins.size() + graph.main.nodes.size());
  ir::Function function;
  function.name = function.display_name = "main";
  Scope scope(*this, graph.main, function, false, 0);
  std::vector<ValueId> values;
  for (const graph::CheckedOutput& output : graph.main.outputs) {
    values.push_back(scope.Value(output.value, nullptr));
    if (!values.back()) failed = true;
    if (failed) return;
    function.results.push_back({output.name, scope.builder().TypeOf(values.back())});
  }
  scope.builder().Return(values);
  module.functions.push_back(std::move(function));
  module.main = ir::FunctionId(module.functions.size() - 1);
}

bool Program::Build() {
  DeclareGlobals();
  for (uint32_t i = 0; i < graph.functions.size() && !failed; ++i) BuildGraphFunction(i);
  if (!failed) BuildMain();
  return !failed;
}

bool BuildModule(const CheckedGraph& graph, blocks::Library& library, ir::Module& module, bool fold,
                 Diagnostics& diagnostics) {
  return Program(graph, library, module, fold, diagnostics).Build();
}

}  // namespace texgraph::passes
