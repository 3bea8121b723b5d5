// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/build_scope.h"

#include <algorithm>

namespace texgraph::passes {

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

ValueId Scope::OfPrototype(const AskedParameter& asked) {
  const std::vector<std::string>& names = prototype_->field_parameters;
  auto named = std::ranges::find(names, asked.name);
  if (named != names.end()) {
    ValueId value = parameters_[static_cast<size_t>(named - names.begin())];
    if (builder_.TypeOf(value) == asked.type) return value;
  }
  return builder_.Const(asked.otherwise);
}

ValueId Scope::AskedAt(const BoundPort& coordinate, AskedParameter asked) {
  if (auto* builtin = std::get_if<graph::BuiltinRef>(&coordinate.source)) {
    if (prototype_ && static_cast<int>(builtin->input) == coordinate_) return OfPrototype(asked);
  } else if (auto* input = std::get_if<graph::FunctionInputRef>(&coordinate.source);
             input && asks_) {
    asked.input = input->input;
    auto known = std::ranges::find(*asks_, asked);
    const auto index = static_cast<size_t>(known - asks_->begin());
    if (known == asks_->end()) {
      asked_.push_back(builder_.AddParameter({asked.name, asked.type}));
      asks_->push_back(std::move(asked));
    }
    return asked_[index];
  }
  return builder_.Const(asked.otherwise);
}

ValueId Scope::BodyOfFunction(const BoundPort& bound, const graph::FieldOfFunction& source) {
  const CheckedSubgraph& callee = program_.graph.functions[source.function];
  std::vector<ValueId> arguments, asked;
  for (size_t i = 0; i < callee.input_types.size(); ++i) {
    arguments.push_back(bound.by_parameter[i]
                            ? Convert(parameters_[*bound.by_parameter[i]], callee.input_types[i])
                            : builder_.Const(callee.input_defaults[i]));
  }
  for (const AskedParameter& what : program_.function_asks[source.function]) {
    const bool is_coordinate = bound.by_parameter[what.input] == 0u;
    asked.push_back(is_coordinate ? OfPrototype(what) : builder_.Const(what.otherwise));
  }
  return CallGraphFunction(source.function, std::move(arguments), asked)[source.output];
}

ValueId Scope::BodyOfBlock(const BoundPort& bound, const graph::DefaultBlock& source) {
  std::vector<ir::ConstId> template_values;
  std::vector<ValueId> arguments;
  for (size_t i = 0; i < source.overload->inputs.size(); ++i) {
    const blocks::Port& port = source.overload->inputs[i];
    if (port.kind == blocks::PortKind::kTemplate) {
      template_values.push_back(port.default_value);
    } else if (bound.by_parameter[i]) {
      arguments.push_back(parameters_[*bound.by_parameter[i]]);
    } else if (port.default_value.valid()) {
      arguments.push_back(builder_.Const(port.default_value));
    } else {
      arguments.push_back(Convert(Builtin(BuiltinIndex(port.default_input)), port.type));
    }
  }
  ir::FunctionId callee =
      program_.library.Function(*source.block, *source.overload, template_values);
  if (!callee) program_.failed = true;
  if (program_.failed) return ValueId();
  const auto count = static_cast<uint32_t>(source.overload->outputs.size());
  return builder_.Result(builder_.Call(callee, arguments), 0, count);
}

ValueId Scope::FieldBody(const BoundPort& bound) {
  ValueId value;
  if (auto* texture = std::get_if<graph::FieldOfTexture>(&bound.source)) {
    ValueId sampler = builder_.Global(program_.Texture(texture->texture));
    value = builder_.Emit(ir::Op::kSample, ir::kVec4, {sampler, parameters_[0]});
  } else if (auto* function = std::get_if<graph::FieldOfFunction>(&bound.source)) {
    value = BodyOfFunction(bound, *function);
  } else if (auto* block = std::get_if<graph::FieldOfBlock>(&bound.source)) {
    value = BodyOfBlock(bound, program_.graph.default_blocks[block->block]);
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
    if (auto* asked = std::get_if<graph::AskedValue>(&node.inputs[i].source)) {
      const bool may_be_asked = prototype_ || asks_;
      arguments.push_back(may_be_asked ? AskedAt(node.inputs[*port.asked_at],
                                                 {0, port.name, port.type, asked->otherwise})
                                       : builder_.Const(asked->otherwise));
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
  std::vector<ValueId> asked;
  for (const AskedParameter& what : program_.function_asks[node.function]) {
    asked.push_back(AskedAt(node.inputs[what.input], what));
  }
  const std::vector<ValueId> results =
      CallGraphFunction(node.function, std::move(arguments), asked);
  for (uint32_t i = 0; i < results.size(); ++i) AddOutput(node, index, i, results[i]);
}

std::vector<ValueId> Scope::CallGraphFunction(uint32_t function, std::vector<ValueId> arguments,
                                              std::span<const ValueId> asked) {
  for (uint32_t b = 0; b < kBuiltinCount; ++b) {
    if (program_.function_use[function] >> b & 1) arguments.push_back(Builtin(b));
  }
  arguments.insert(arguments.end(), asked.begin(), asked.end());
  ir::FunctionId callee = program_.graph_functions[function];
  ValueId call = builder_.Call(callee, arguments);
  uint32_t count = static_cast<uint32_t>(program_.module[callee].results.size());
  std::vector<ValueId> results;
  for (uint32_t i = 0; i < count; ++i) results.push_back(builder_.Result(call, i, count));
  return results;
}

}  // namespace texgraph::passes
