// SPDX-License-Identifier: Apache-2.0
// What BuildModule works with: the program that is being built, and the values of one subgraph
// inside one IR function. Private to BuildModule.
#pragma once

#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "compiler/ir/builder.h"
#include "compiler/passes/computed_ports.h"
#include "compiler/passes/fields.h"

namespace texgraph::passes {

using graph::BoundPort;
using graph::CheckedGraph;
using graph::CheckedNode;
using graph::CheckedSubgraph;
using ir::ValueId;

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

// A parameter of a graph function beside its inputs and the built-in ones: what a node in it has as
// a default that function ports replace ("@asked_at"), where its coordinate is that input.
struct AskedParameter {
  uint32_t input;
  std::string name;
  ir::TypeId type;
  ir::ConstId otherwise;
  friend bool operator==(const AskedParameter&, const AskedParameter&) = default;
};

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
  // By index in CheckedGraph::functions: the built-in inputs that the function depends on, and its
  // last parameters.
  std::vector<BuiltinSet> function_use;
  std::vector<ir::FunctionId> graph_functions;
  std::vector<std::vector<AskedParameter>> function_asks;
  ComputedPorts computed;
  bool failed = false;

 private:
  void DeclareGlobals();
  void FindUse(const CheckedSubgraph& subgraph);
  BuiltinSet UseOf(const CheckedSubgraph& subgraph, const BoundPort& bound,
                   const blocks::Port* port) const;
  void WarnIfCoordinateIsIgnored(const CheckedSubgraph& subgraph, const BoundPort& bound,
                                 const blocks::Port& port, BuiltinSet replaced);
  void BuildGraphFunction(uint32_t index);
  void BuildMain();

  std::map<const CheckedSubgraph*, std::vector<BuiltinSet>> node_use_;
  std::map<std::string, FieldFunction> fields_;
  std::vector<ir::GlobalId> parameters_, textures_;
  std::array<ir::GlobalId, kBuiltinCount> builtins_;
  int field_depth_ = 0;
};

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
  // In a field: the prototype's parameters, and the built-in input that the first of them, the
  // coordinate, replaces, or -1.
  void SetPrototype(const blocks::Port& port, std::vector<ValueId> parameters, int coordinate) {
    prototype_ = &port;
    parameters_ = std::move(parameters);
    coordinate_ = coordinate;
  }
  // In a graph function: where its further parameters are listed.
  void SetAsks(std::vector<AskedParameter>& asks) { asks_ = &asks; }
  std::vector<Capture> captures() const { return captures_; }

  ValueId Builtin(uint32_t index);
  // The value of a port; `port` is null for the ports of graph functions and for outputs. Invalid
  // after an error.
  ValueId Value(const BoundPort& bound, const blocks::Port* port);
  // The value that a field's source gives here, after SetPrototype.
  ValueId FieldBody(const BoundPort& bound);

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
  ValueId BodyOfFunction(const BoundPort& bound, const graph::FieldOfFunction& source);
  ValueId BodyOfBlock(const BoundPort& bound, const graph::DefaultBlock& source);
  // The prototype's parameter of that name, else the default.
  ValueId OfPrototype(const AskedParameter& asked);
  // The same, if `coordinate` is the very one that the function port asks at.
  ValueId AskedAt(const BoundPort& coordinate, AskedParameter asked);
  // `asked`: the values of the function's AskedParameters.
  std::vector<ValueId> CallGraphFunction(uint32_t function, std::vector<ValueId> arguments,
                                         std::span<const ValueId> asked);

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
  const blocks::Port* prototype_ = nullptr;
  std::vector<ValueId> parameters_;
  int coordinate_ = -1;
  std::vector<AskedParameter>* asks_ = nullptr;
  std::vector<ValueId> asked_;  // by index in *asks_
};

}  // namespace texgraph::passes
