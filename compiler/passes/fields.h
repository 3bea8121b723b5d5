// SPDX-License-Identifier: Apache-2.0
// What the functions at function ports are, before they are built: which inputs of the graph a
// prototype replaces, which fields are the same function, and what it is called in the shader.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "compiler/graph/checked_graph.h"

namespace texgraph::passes {

constexpr uint32_t kBuiltinCount = std::size(kBuiltinInputs);
constexpr uint32_t kNeighbour = 4;
static_assert(kBuiltinInputs[kNeighbour].name == "neighbour");
uint32_t BuiltinIndex(std::string_view name);  // of an input that exists
// Sets of built-in inputs, a bit each.
using BuiltinSet = uint32_t;

constexpr uint32_t kUv = 0, kPosition = 1;
static_assert(kBuiltinInputs[kUv].name == "uv" && kBuiltinInputs[kPosition].name == "position");
constexpr BuiltinSet kCoordinates = 1u << kUv | 1u << kPosition;

// Which built-in inputs a prototype's parameters replace, by parameter, -1 for none: the one of its
// name, or, where no parameter has the name, uv for the first vec2 and position for the first vec3.
std::vector<int> ReplacedBuiltins(const ir::Types& types, ir::TypeId field_type,
                                  const std::vector<std::string>& names);
BuiltinSet ReplacedSet(const std::vector<int>& replaced);

// "grid_cell", or the node's own name for what a plain reference to it means.
std::string OutputName(const graph::CheckedNode& node, uint32_t output);
// What a field stands for, as text: equal keys give one function.
std::string FieldKey(const graph::CheckedSubgraph& subgraph, const graph::BoundPort& bound,
                     const blocks::Port& port);
// The name that a field's function gets in the shader.
std::string FieldName(const graph::CheckedGraph& graph, const graph::CheckedSubgraph& subgraph,
                      const graph::BoundPort& bound, const blocks::Port& port);

}  // namespace texgraph::passes
