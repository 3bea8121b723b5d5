// SPDX-License-Identifier: Apache-2.0
// A graph after CheckGraph: every node bound to an overload of a block or to a graph function,
// every port given a value of its type, conversions explicit, nodes in an order in which each
// follows what it needs, no cycles, no unused names left to resolve.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "compiler/blocks/block.h"
#include "compiler/graph/graph.h"

namespace texgraph::graph {

// sampler2D, sampler2DArray or sampler3D, and what such a sampler takes: a vec2 or a vec3.
constexpr ir::TypeId SamplerType(const Texture& texture) {
  return texture.is_3d ? ir::kSampler3D : texture.is_array ? ir::kSampler2DArray : ir::kSampler2D;
}
constexpr ir::TypeId CoordinateType(const Texture& texture) {
  return texture.is_3d || texture.is_array ? ir::kVec3 : ir::kVec2;
}

// Indexes into the vectors of CheckedGraph or CheckedSubgraph.
struct NodeOutput {
  uint32_t node;    // in the same subgraph
  uint32_t output;  // of its overload or function
};
struct ParameterRef {  // of the graph, uniform or specialization
  uint32_t parameter;
};
struct BuiltinRef {  // into kBuiltinInputs
  uint32_t input;
};
struct FunctionInputRef {  // of the enclosing graph function
  uint32_t input;
};
struct TextureRef {  // for a sampler port
  uint32_t texture;
};
struct ConstantValue {  // already of the port's type
  ir::ConstId value;
};

// What the port's block computes from other ports ("@computed"); known after BuildModule.
struct ComputedValue {};

// A port's default that a function port may replace: see blocks::Port::asked_at.
struct AskedValue {
  ir::ConstId otherwise;
};

// What a function port is bound to.
struct FieldOfTexture {  // texture(t, first parameter), a vec4
  uint32_t texture;
};
// A graph function. BoundPort::by_parameter[i] is the prototype's parameter for its input i, or
// none: the input's default.
struct FieldOfFunction {
  uint32_t function;  // into CheckedGraph::functions
  uint32_t output;
};
// Re-evaluated where the port asks: the prototype's parameters that are named as built-in inputs
// replace these in all that the output depends on.
struct FieldOfNode {
  NodeOutput source;
};
// A uniform or specialization parameter, or an input of the enclosing graph function: the same
// value everywhere.
struct FieldOfParameter {
  uint32_t parameter;
};
struct FieldOfFunctionInput {
  uint32_t input;
};
// A built-in input, which the prototype's parameters may replace.
struct FieldOfBuiltin {
  uint32_t input;
};
// The port's own default. BoundPort::by_parameter[i] is the prototype's parameter for input i of
// the overload, or none: the input's default, which it has.
struct FieldOfBlock {
  uint32_t block;  // into CheckedGraph::default_blocks
};
struct FieldOfConstant {  // already of the field's result type
  ir::ConstId value;
};

using Source = std::variant<ConstantValue, NodeOutput, ParameterRef, BuiltinRef, FunctionInputRef,
                            TextureRef, ComputedValue, AskedValue, FieldOfTexture, FieldOfFunction,
                            FieldOfNode, FieldOfParameter, FieldOfBuiltin, FieldOfFunctionInput,
                            FieldOfBlock, FieldOfConstant>;

struct BoundPort {
  Source source;
  ir::TypeId source_type;  // before conversion; for fields, of the value that the source gives
  ir::TypeId type;         // of the port; for fields, the field type
  std::vector<std::optional<uint32_t>> by_parameter;  // FieldOfFunction and FieldOfBlock only
  SourceRange range;  // of the argument, or of the node if the default was taken
};

struct CheckedNode {
  const Node* node = nullptr;
  const blocks::Block* block = nullptr;  // null: a graph function
  const blocks::Overload* overload = nullptr;
  uint32_t function = 0;          // into CheckedGraph::functions, if block is null
  std::vector<BoundPort> inputs;  // one per input port, in the port's order
};

struct CheckedOutput {
  std::string name;
  BoundPort value;
};

struct CheckedSubgraph {
  const Subgraph* subgraph = nullptr;
  std::vector<ir::TypeId> input_types;      // of a graph function
  std::vector<ir::ConstId> input_defaults;  // invalid: must be connected
  std::vector<CheckedNode> nodes;           // in dependency order
  std::vector<CheckedOutput> outputs;
};

struct CheckedParameter {
  const Parameter* parameter = nullptr;
  ir::TypeId type;
  ir::ConstId value;  // after --set
};

// A block that is the default of a function port.
struct DefaultBlock {
  const blocks::Block* block;
  const blocks::Overload* overload;
  friend bool operator==(const DefaultBlock&, const DefaultBlock&) = default;
};

struct CheckedGraph {
  const Graph* graph = nullptr;
  std::vector<CheckedParameter> parameters;
  std::vector<DefaultBlock> default_blocks;
  std::vector<CheckedSubgraph> functions;   // callees before callers
  std::vector<uint32_t> function_of_graph;  // by index in Graph::functions: index in `functions`
  CheckedSubgraph main;
};

// name=value of the command line, parsed as a graph's literal; `value` points into `source`.
struct Setting {
  std::string name;
  Argument value;
  SourceRange range;
};
// Reads "name=value" texts. `value` is JSON: 3, 0.5, true, [1, 0, 0], "add" or a bare word.
std::vector<Setting> ReadSettings(const std::vector<std::string>& texts, Sources& sources,
                                  Diagnostics& diagnostics);

// Reports every mistake; nothing is returned if there was any. Constants go into the library's
// module.
std::optional<CheckedGraph> CheckGraph(const Graph& graph, const std::vector<Setting>& settings,
                                       blocks::Library& library, ir::Module& module,
                                       Diagnostics& diagnostics);

// Reports every port ("@multiple_of") whose columns and rows are no multiples of its map's. The
// pictures of maps must be decoded.
void CheckMapMultiples(const CheckedGraph& graph, const ir::Module& module,
                       Diagnostics& diagnostics);
// Reports every port ("@below") that a number beyond what it counts comes to, as far as numbers can
// be followed ("@one_of"). The pictures of maps must be decoded.
void CheckPatternRanges(const CheckedGraph& graph, const ir::Module& module,
                        Diagnostics& diagnostics);

}  // namespace texgraph::graph
