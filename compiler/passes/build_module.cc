// SPDX-License-Identifier: Apache-2.0
// BuildModule: a checked graph becomes main, one function for each graph function, and one for each
// plain output that stands at a function port. Every function but main takes the built-in inputs
// that it depends on as parameters, so a graph function inside a field sees the coordinate that the
// block asks for.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <string>
#include <vector>

#include "compiler/ir/builder.h"
#include "compiler/passes/computed_ports.h"
#include "compiler/passes/passes.h"

namespace texgraph::passes {
namespace {

using graph::BoundPort;
using graph::CheckedGraph;
using graph::CheckedNode;
using graph::CheckedSubgraph;
using ir::ValueId;

constexpr uint32_t kBuiltinCount = std::size(kBuiltinInputs);
constexpr uint32_t kNeighbour = 4;
static_assert(kBuiltinInputs[kNeighbour].name == "neighbour");
// Functions at function ports of nodes that are themselves evaluated for a function port, and so
// on.
constexpr int kMaxFieldDepth = 64;

// A value of the scope around a field that the field's function takes as a further parameter.
struct Capture {
  enum class Kind : uint8_t { kBuiltin, kFunctionInput, kNodeOutput };
  Kind kind;
  uint32_t index;   // built-in input, function input or node
  uint32_t output;  // of the node
  friend auto operator<=>(const Capture&, const Capture&) = default;
};

struct FieldFunction {
  ir::FunctionId id;
  std::vector<Capture> captures;  // in the order of the function's last parameters
  // Set where nothing but another `neighbour` is asked for: the node whose value the field has
  // where `neighbour` stays what it is around the field. See ir::Function::knows_home.
  std::optional<graph::NodeOutput> here;
};

// Sets of built-in inputs, a bit each.
using BuiltinSet = uint32_t;

class Scope;

// What the scopes of one module share.
class Program {
 public:
  Program(const CheckedGraph& graph, blocks::Library& library, ir::Module& module, bool fold,
          Diagnostics& diagnostics)
      : graph(graph),
        library(library),
        module(module),
        fold(fold),
        diagnostics(diagnostics),
        computed(library, module, graph_functions, diagnostics) {}

  bool Build();
  const FieldFunction* Field(const CheckedSubgraph& subgraph, const BoundPort& bound,
                             const blocks::Port& port);
  BuiltinSet UsedBy(const CheckedSubgraph& subgraph, uint32_t node) const {
    return node_use_.at(&subgraph)[node];
  }
  ir::GlobalId Parameter(uint32_t index);
  ir::GlobalId Texture(uint32_t index);
  ir::GlobalId BuiltinGlobal(uint32_t index);

  const CheckedGraph& graph;
  blocks::Library& library;
  ir::Module& module;
  const bool fold;
  Diagnostics& diagnostics;
  std::vector<BuiltinSet> function_use;         // likewise
  std::vector<ir::FunctionId> graph_functions;  // by index in CheckedGraph::functions
  ComputedPorts computed;
  bool failed = false;

 private:
  void DeclareGlobals();
  void FindUse(const CheckedSubgraph& subgraph);
  BuiltinSet UseOf(const CheckedSubgraph& subgraph, const BoundPort& bound,
                   const blocks::Port* port) const;
  void BuildGraphFunction(uint32_t index);
  void BuildMain();

  std::map<const CheckedSubgraph*, std::vector<BuiltinSet>> node_use_;
  std::map<std::string, FieldFunction> fields_;
  std::vector<ir::GlobalId> parameters_, textures_;
  std::array<ir::GlobalId, kBuiltinCount> builtins_;
  int field_depth_ = 0;
};

// Which built-in inputs a prototype's parameters replace, by parameter: the one of its name, or,
// where no parameter has the name, uv for the first vec2 and position for the first vec3.
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
  for (int b : {0, 1}) {
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

// The values of one subgraph as they are inside one IR function.
class Scope {
 public:
  // `replaced`: with `is_field`, the built-in inputs whose values are given; the rest is captured.
  Scope(Program& program, const CheckedSubgraph& subgraph, ir::Function& function, bool is_field,
        BuiltinSet replaced)
      : program_(program),
        subgraph_(subgraph),
        builder_(program.module, function, {program.fold, nullptr}),
        is_field_(is_field),
        replaced_(replaced),
        inputs_(subgraph.input_types.size()),
        first_output_(subgraph.nodes.size(), kNotEmitted) {}

  ir::Builder& builder() { return builder_; }
  void SetBuiltin(uint32_t index, ValueId value) { builtins_[index] = value; }
  void SetInput(uint32_t index, ValueId value) { inputs_[index] = value; }
  std::vector<Capture> captures() const { return captures_; }

  ValueId Builtin(uint32_t index);
  // The value of a port; `port` is null for the ports of graph functions and for outputs. Invalid
  // after an error.
  ValueId Value(const BoundPort& bound, const blocks::Port* port);
  // The value that a field's source gives here; `parameters` are the prototype's.
  ValueId FieldBody(const BoundPort& bound, std::span<const ValueId> parameters);

 private:
  bool IsCaptured(uint32_t node) const {
    return is_field_ && !(program_.UsedBy(subgraph_, node) & replaced_);
  }
  ValueId CaptureValue(Capture capture, ir::TypeId type, std::string_view name);
  ValueId Input(uint32_t index);
  ValueId Output(graph::NodeOutput source);
  ValueId Resolve(const Capture& capture);
  ValueId Field(const BoundPort& bound, const blocks::Port& port);
  ValueId Convert(ValueId value, ir::TypeId type);
  void EmitWithNeeds(uint32_t node);
  void PushNeeds(uint32_t node, std::vector<uint32_t>& stack);
  void Emit(uint32_t node);
  void EmitBlock(const CheckedNode& node, uint32_t index);
  void EmitGraphFunction(const CheckedNode& node, uint32_t index);
  void AddOutput(const CheckedNode& node, uint32_t index, uint32_t output, ValueId value);
  std::vector<ValueId> CallGraphFunction(uint32_t function, std::vector<ValueId> arguments);

  Program& program_;
  const CheckedSubgraph& subgraph_;
  ir::Builder builder_;
  const bool is_field_;
  const BuiltinSet replaced_;
  std::array<ValueId, kBuiltinCount> builtins_;
  std::vector<ValueId> inputs_;
  static constexpr uint32_t kNotEmitted = 0xffffffffu;
  std::vector<uint32_t> first_output_;  // by node: where its outputs begin
  std::vector<ValueId> outputs_;
  std::vector<bool> needed_;  // by node: it will be emitted, or was
  std::vector<Capture> captures_;
  std::map<Capture, ValueId> captured_;
};

ValueId Scope::CaptureValue(Capture capture, ir::TypeId type, std::string_view name) {
  auto [known, added] = captured_.try_emplace(capture);
  if (added) {
    captures_.push_back(capture);
    known->second = builder_.AddParameter({std::string(name), type});
  }
  return known->second;
}

ValueId Scope::Builtin(uint32_t index) {
  if (builtins_[index]) return builtins_[index];
  const BuiltinInput& input = kBuiltinInputs[index];
  if (is_field_) {
    ir::TypeId type = program_.module.types.Find(input.type);
    return CaptureValue({Capture::Kind::kBuiltin, index, 0}, type, input.name);
  }
  return builtins_[index] = input.kind == BuiltinKind::kZero
                                ? builder_.Zero(program_.module.types.Find(input.type))
                                : builder_.Global(program_.BuiltinGlobal(index));
}

ValueId Scope::Input(uint32_t index) {
  if (!is_field_) return inputs_[index];
  return CaptureValue({Capture::Kind::kFunctionInput, index, 0}, subgraph_.input_types[index],
                      subgraph_.subgraph->inputs[index].name);
}

// "grid_cell", or the node's own name for what a plain reference to it means.
std::string OutputName(const CheckedNode& node, uint32_t output) {
  std::string name(node.node->name);
  if (node.block && output > 0) return name + "_" + node.overload->outputs[output].name;
  if (node.block && node.overload->outputs[0].name != "result" &&
      node.overload->outputs.size() > 1) {
    return name + "_" + node.overload->outputs[0].name;
  }
  return name;
}

ValueId Scope::Output(graph::NodeOutput source) {
  const CheckedNode& node = subgraph_.nodes[source.node];
  if (IsCaptured(source.node)) {
    ir::TypeId type =
        node.block
            ? node.overload->outputs[source.output].type
            : program_.module[program_.graph_functions[node.function]].results[source.output].type;
    return CaptureValue({Capture::Kind::kNodeOutput, source.node, source.output}, type,
                        OutputName(node, source.output));
  }
  if (first_output_[source.node] == kNotEmitted) EmitWithNeeds(source.node);
  return program_.failed ? ValueId() : outputs_[first_output_[source.node] + source.output];
}

ValueId Scope::Resolve(const Capture& capture) {
  switch (capture.kind) {
    case Capture::Kind::kBuiltin:
      return Builtin(capture.index);
    case Capture::Kind::kFunctionInput:
      return Input(capture.index);
    default:
      return Output({capture.index, capture.output});
  }
}

ValueId Scope::Convert(ValueId value, ir::TypeId type) {
  if (!value || builder_.TypeOf(value) == type) return value;
  ir::TypeId from = builder_.TypeOf(value);
  value = builder_.Convert(value, ir::Vector(ir::ScalarOf(type), ir::Width(from)));
  return builder_.SplatTo(value, type);
}

ValueId Scope::Field(const BoundPort& bound, const blocks::Port& port) {
  const FieldFunction* field = program_.Field(subgraph_, bound, port);
  if (!field) return ValueId();
  std::vector<ValueId> captured;
  for (const Capture& capture : field->captures) captured.push_back(Resolve(capture));
  if (field->here) {
    captured.push_back(Builtin(kNeighbour));
    ValueId here = Output(*field->here);
    if (program_.failed) return ValueId();
    captured.push_back(Convert(here, program_.module.types.ValueOf(bound.type)));
  }
  return builder_.Emit(ir::Op::kFieldRef, bound.type, captured, field->id.index);
}

ValueId Scope::Value(const BoundPort& bound, const blocks::Port* port) {
  ValueId value;
  if (auto* constant = std::get_if<graph::ConstantValue>(&bound.source)) {
    value = builder_.Const(constant->value);
  } else if (auto* output = std::get_if<graph::NodeOutput>(&bound.source)) {
    value = Output(*output);
  } else if (auto* parameter = std::get_if<graph::ParameterRef>(&bound.source)) {
    value = builder_.Global(program_.Parameter(parameter->parameter));
  } else if (auto* builtin = std::get_if<graph::BuiltinRef>(&bound.source)) {
    value = Builtin(builtin->input);
  } else if (auto* input = std::get_if<graph::FunctionInputRef>(&bound.source)) {
    value = Input(input->input);
  } else if (auto* texture = std::get_if<graph::TextureRef>(&bound.source)) {
    return builder_.Global(program_.Texture(texture->texture));
  } else {
    return Field(bound, *port);
  }
  return Convert(value, bound.type);
}

ValueId Scope::FieldBody(const BoundPort& bound, std::span<const ValueId> parameters) {
  ValueId value;
  if (auto* texture = std::get_if<graph::FieldOfTexture>(&bound.source)) {
    ValueId sampler = builder_.Global(program_.Texture(texture->texture));
    value = builder_.Emit(ir::Op::kSample, ir::kVec4, {sampler, parameters[0]});
  } else if (auto* function = std::get_if<graph::FieldOfFunction>(&bound.source)) {
    const CheckedSubgraph& callee = program_.graph.functions[function->function];
    std::vector<ValueId> arguments;
    for (size_t i = 0; i < callee.input_types.size(); ++i) {
      arguments.push_back(bound.by_parameter[i]
                              ? Convert(parameters[*bound.by_parameter[i]], callee.input_types[i])
                              : builder_.Const(callee.input_defaults[i]));
    }
    value = CallGraphFunction(function->function, std::move(arguments))[function->output];
  } else if (auto* node = std::get_if<graph::FieldOfNode>(&bound.source)) {
    value = Output(node->source);
  } else if (auto* parameter = std::get_if<graph::FieldOfParameter>(&bound.source)) {
    value = builder_.Global(program_.Parameter(parameter->parameter));
  } else if (auto* builtin = std::get_if<graph::FieldOfBuiltin>(&bound.source)) {
    value = Builtin(builtin->input);
  } else if (auto* input = std::get_if<graph::FieldOfFunctionInput>(&bound.source)) {
    value = Input(input->input);
  } else {
    value = builder_.Const(std::get<graph::FieldOfConstant>(bound.source).value);
  }
  return Convert(value, program_.module.types.ValueOf(bound.type));
}

// The nodes whose values `node` takes directly, and those that its fields capture.
void Scope::PushNeeds(uint32_t node, std::vector<uint32_t>& stack) {
  const CheckedNode& checked = subgraph_.nodes[node];
  for (size_t i = 0; i < checked.inputs.size(); ++i) {
    const BoundPort& bound = checked.inputs[i];
    if (auto* output = std::get_if<graph::NodeOutput>(&bound.source)) {
      stack.push_back(output->node);
    } else if (checked.block && checked.overload->inputs[i].kind == blocks::PortKind::kField) {
      const FieldFunction* field = program_.Field(subgraph_, bound, checked.overload->inputs[i]);
      if (!field) return;
      for (const Capture& capture : field->captures) {
        if (capture.kind == Capture::Kind::kNodeOutput) stack.push_back(capture.index);
      }
      if (field->here) stack.push_back(field->here->node);
    }
  }
}

// Emits a node after all that it needs, in the graph's order, without recursion: chains may be
// long.
void Scope::EmitWithNeeds(uint32_t node) {
  std::vector<uint32_t> needed;
  std::vector<uint32_t> stack{node};
  needed_.resize(subgraph_.nodes.size());
  while (!stack.empty()) {
    uint32_t next = stack.back();
    stack.pop_back();
    if (needed_[next] || IsCaptured(next)) continue;
    needed_[next] = true;
    needed.push_back(next);
    PushNeeds(next, stack);
  }
  std::ranges::sort(needed);
  for (uint32_t next : needed) Emit(next);
}

void Scope::Emit(uint32_t index) {
  const CheckedNode& node = subgraph_.nodes[index];
  ir::OriginId outer = builder_.origin();
  if (!program_.failed) {
    ir::Origin origin{node.node->name, {}, "function of the graph"};
    if (node.block) {
      origin.block = node.block->name;
      origin.source = node.block->path;
    } else {
      origin.block = program_.graph.functions[node.function].subgraph->name;
    }
    builder_.SetOrigin(program_.module.AddOrigin(origin));
    if (node.block) {
      EmitBlock(node, index);
    } else {
      EmitGraphFunction(node, index);
    }
  }
  builder_.SetOrigin(outer);
}

// Outputs are added in their order, all of one node at once.
void Scope::AddOutput(const CheckedNode& node, uint32_t index, uint32_t output, ValueId value) {
  if (output == 0) first_output_[index] = static_cast<uint32_t>(outputs_.size());
  outputs_.push_back(value);
  builder_.Name(value, OutputName(node, output));
}

void Scope::EmitBlock(const CheckedNode& node, uint32_t index) {
  std::vector<ir::ConstId> template_values;
  std::vector<ValueId> arguments;
  arguments.reserve(node.inputs.size());
  for (size_t i = 0; i < node.inputs.size(); ++i) {
    const blocks::Port& port = node.overload->inputs[i];
    if (port.kind == blocks::PortKind::kTemplate) {
      template_values.push_back(program_.computed.TemplateValue(subgraph_, index, i));
      if (!template_values.back()) program_.failed = true;
      continue;
    }
    arguments.push_back(Value(node.inputs[i], &port));
    if (!arguments.back()) program_.failed = true;
  }
  if (program_.failed) return;
  ir::FunctionId callee = program_.library.Function(*node.block, *node.overload, template_values);
  if (!callee) program_.failed = true;
  if (program_.failed) return;
  ValueId call = builder_.Call(callee, arguments);
  uint32_t count = static_cast<uint32_t>(node.overload->outputs.size());
  for (uint32_t i = 0; i < count; ++i) AddOutput(node, index, i, builder_.Result(call, i, count));
}

void Scope::EmitGraphFunction(const CheckedNode& node, uint32_t index) {
  std::vector<ValueId> arguments;
  for (const BoundPort& bound : node.inputs) {
    arguments.push_back(Value(bound, nullptr));
    if (!arguments.back()) program_.failed = true;
  }
  if (program_.failed) return;
  const std::vector<ValueId> results = CallGraphFunction(node.function, std::move(arguments));
  for (uint32_t i = 0; i < results.size(); ++i) AddOutput(node, index, i, results[i]);
}

std::vector<ValueId> Scope::CallGraphFunction(uint32_t function, std::vector<ValueId> arguments) {
  for (uint32_t b = 0; b < kBuiltinCount; ++b) {
    if (program_.function_use[function] >> b & 1) arguments.push_back(Builtin(b));
  }
  ir::FunctionId callee = program_.graph_functions[function];
  ValueId call = builder_.Call(callee, arguments);
  uint32_t count = static_cast<uint32_t>(program_.module[callee].results.size());
  std::vector<ValueId> results;
  for (uint32_t i = 0; i < count; ++i) results.push_back(builder_.Result(call, i, count));
  return results;
}

// --- Program
// -----------------------------------------------------------------------------------------------------

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

// What a field stands for, as text: equal keys give one function.
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

// The name that a field's function gets in the shader.
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
  return port.name + "_at";
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
  ValueId value = scope.FieldBody(bound, parameters);
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

}  // namespace

bool BuildModule(const CheckedGraph& graph, blocks::Library& library, ir::Module& module, bool fold,
                 Diagnostics& diagnostics) {
  return Program(graph, library, module, fold, diagnostics).Build();
}

}  // namespace texgraph::passes
