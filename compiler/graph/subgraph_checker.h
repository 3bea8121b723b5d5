// SPDX-License-Identifier: Apache-2.0
// Checks one subgraph: orders its nodes, binds each to an overload of its block, and each port to
// what stands at it. Private to CheckGraph. A node or reference that is wrong has no type; what
// depends on it is not reported again.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "compiler/graph/checked_graph.h"
#include "compiler/graph/literal.h"
#include "compiler/graph/order.h"
#include "compiler/graph/scope.h"

namespace texgraph::graph {

// What the checks of all subgraphs share.
struct GraphCheck {
  const Graph& graph;
  blocks::Library& library;
  ir::Module& module;
  Diagnostics& diagnostics;
  CheckedGraph& result;
  SymbolTable globals;
  // Each graph function as if it were a block, by index in Graph::functions. The outputs' types are
  // invalid until the function was checked, and stay so if it is wrong.
  std::deque<blocks::Overload> signatures;
  bool failed = false;  // for a reason that was reported before, a wrong block, say
};

// "a -> b -> a", with the middle of a long circle left out.
std::string CircleText(const std::vector<std::string_view>& names);
// Of a circle: this many names and notes are shown.
inline constexpr size_t kShownOfCircle = 16;

// A literal, or what the text at a port means.
struct Resolved {
  enum class Kind : uint8_t { kLiteral, kSymbol, kWrong };
  enum class Problem : uint8_t { kNone, kNoSuchName, kNoSuchOutput, kSeveralOutputs, kMember };
  Kind kind = Kind::kLiteral;
  Problem problem = Problem::kNone;  // kWrong
  Symbol symbol{};                   // kSymbol
  uint32_t output = 0;               // of a node or function
  ir::TypeId type;                   // of a value; invalid if it is none, or not known
};

// The key that makes a texture what it is, for messages.
std::string_view WhatItHas(const Texture& texture);

class SubgraphChecker {
 public:
  // `signature` is the function's own; null for the graph itself.
  SubgraphChecker(GraphCheck& check, const Subgraph& subgraph, const blocks::Overload* signature)
      : check_(check),
        subgraph_(subgraph),
        signature_(signature),
        scope_(check.globals, subgraph),
        nodes_(subgraph.nodes.size()) {}

  // Finds the block of every node. Before the others, once.
  void FindBlocks();
  // The graph functions that the subgraph names, as blocks or at function ports.
  std::vector<uint32_t> CalledFunctions() const;
  // Fills all but input_types and input_defaults.
  void Check(CheckedSubgraph& result);

 private:
  struct NodeState {
    const blocks::Block* block = nullptr;
    std::optional<uint32_t> function;              // in Graph::functions
    std::span<const blocks::Overload> candidates;  // empty: the block is wrong
    const blocks::Overload* chosen = nullptr;      // null until it is bound, or if none fits
    bool certain = false;                          // the types of the outputs are known
  };

  // Something that takes a value of the port's type.
  struct Target {
    const blocks::Port& port;
    Place place;
  };

  // subgraph_checker.cc: blocks, order, outputs.
  void ReportUnknownBlock(const Node& node);
  bool MayRefer(const NodeState& state, std::string_view port) const;
  Dependencies NodeDependencies() const;
  void ReportCircle(const std::vector<uint32_t>& circle);
  SourceRange PlaceOfNeed(uint32_t node, uint32_t need) const;
  void CheckOutputs(CheckedSubgraph& result);
  std::optional<BoundPort> MainOutput(const Output& output);
  std::optional<BoundPort> FunctionOutput(const Output& output);
  void KeepUsedNodes(CheckedSubgraph& result);

  // choose_overload.cc: which overload a node means.
  CheckedNode BindNode(uint32_t index);
  const blocks::Overload* Choose(uint32_t index, const std::vector<Resolved>& arguments);
  std::optional<int> Cost(const blocks::Overload& overload, const Node& node,
                          const std::vector<Resolved>& arguments) const;
  std::optional<int> PortCost(const blocks::Port& port, const Argument& argument,
                              const Resolved& resolved) const;
  const blocks::Overload* ReportNoOverload(uint32_t index, const std::vector<Resolved>& arguments);
  bool ReportUnknownPorts(uint32_t index);
  bool ReportPortThatNeverFits(uint32_t index, const std::vector<Resolved>& arguments,
                               const std::vector<const blocks::Overload*>& named);
  bool ReportPortBesideTexture(uint32_t index, const std::vector<Resolved>& arguments,
                               const std::vector<const blocks::Overload*>& named);
  Diagnostic& ReportBesideTexture(uint32_t index, const std::vector<const blocks::Overload*>& meant,
                                  size_t input, ir::TypeId got);
  void ReportSignatures(uint32_t index, const std::vector<Resolved>& arguments);
  std::string BlockText(uint32_t index) const;

  // bind_port.cc: values at ports.
  std::optional<BoundPort> Bind(const Target& target, const Argument& argument,
                                const Resolved& resolved);
  std::optional<BoundPort> BindValue(const Target& target, const Argument& argument,
                                     const Resolved& resolved);
  std::optional<BoundPort> BindLiteral(const Target& target, const Argument& argument);
  std::optional<BoundPort> BindTemplate(const Target& target, const Argument& argument,
                                        const Resolved& resolved);
  std::optional<BoundPort> BindTexture(const Target& target, const Argument& argument,
                                       const Resolved& resolved);
  std::optional<BoundPort> BindConstantParameter(const Target& target, const Argument& argument,
                                                 uint32_t parameter);
  std::optional<BoundPort> BindDefault(const Target& target, SourceRange range);
  bool CheckWords(const Target& target, SourceRange range, ir::ConstId value);
  void ReportWord(const Target& target, const Argument& argument);
  void ReportType(const Target& target, const Argument& argument, ir::TypeId got);
  void ReportNoValue(const Target& target, const Argument& argument, const Resolved& resolved,
                     std::string_view takes);

  // bind_field.cc: functions at function ports.
  std::optional<BoundPort> BindField(const Target& target, const Argument& argument,
                                     const Resolved& resolved);
  std::optional<BoundPort> BindFieldOfTexture(const Target& target, const Argument& argument,
                                              uint32_t texture);
  std::optional<BoundPort> BindFieldOfFunction(const Target& target, const Argument& argument,
                                               const Resolved& resolved);
  std::optional<BoundPort> BindFieldOfBlock(const Target& target, SourceRange range);
  struct FieldMapping {
    std::vector<std::optional<uint32_t>> by_parameter;
    std::optional<uint32_t>
        unfit;  // a function input whose parameter of the same name does not fit
    std::optional<uint32_t> missing;  // one without parameter and default
    bool ok() const { return !unfit && !missing; }
  };
  FieldMapping MapFunction(const blocks::Port& port, uint32_t function) const;
  std::optional<int> FieldCost(const blocks::Port& port, const Argument& argument,
                               const Resolved& resolved) const;

  // port_order.cc: least and greatest values, lists of one length.
  void CheckPortOrder(const CheckedNode& checked, const blocks::Overload& overload);
  void CheckNotBelow(const CheckedNode& checked, const blocks::Overload& overload, uint32_t most);
  void CheckSameLength(const CheckedNode& checked, const blocks::Overload& overload,
                       uint32_t index);

  // pattern_grids.cc: columns and rows that a texture says.
  std::optional<BoundPort> BindGrid(const Target& target, const blocks::Overload& overload,
                                    const Node& node);
  void CheckGrids(const CheckedNode& checked, const blocks::Overload& overload);
  // The texture that the node has at an input, and where it says so; null if there is none, which
  // was reported.
  struct NamedTexture {
    const Texture* texture = nullptr;
    SourceRange range;
  };
  NamedTexture TextureAt(const Node& node, std::string_view input) const;
  // tile_colors.cc
  std::optional<BoundPort> BindColors(const Target& target, const blocks::Overload& overload,
                                      const Node& node);
  void CheckColors(const CheckedNode& checked, const blocks::Overload& overload);
  void CheckCorners(const CheckedNode& checked, size_t tiles);

  // transition_sets.cc: patterns for all corners that differ.
  void CheckTransitions(const CheckedNode& checked, const blocks::Overload& overload,
                        uint32_t index);

  // resolve.cc: names.
  Resolved Resolve(const Argument& argument) const;
  Resolved ResolveOutput(Symbol symbol, const std::optional<std::string_view>& port) const;
  void ReportReference(const Argument& argument, const Resolved& resolved);
  void ReportUnknownName(const Argument& argument, std::string_view name);
  void ReportUnknownOutput(const Argument& argument, const Reference& reference);
  // The outputs of a node or function; null if they are not known.
  const std::vector<blocks::Port>* OutputsOf(Symbol symbol) const;
  ir::TypeId ParameterType(uint32_t parameter) const;
  bool IsConstantParameter(const Resolved& resolved) const;
  uint32_t CheckedFunction(uint32_t function) const;  // index in CheckedGraph::functions

  GraphCheck& check_;
  const Subgraph& subgraph_;
  const blocks::Overload* signature_;
  Scope scope_;
  std::vector<NodeState> nodes_;
  // Where node i of the subgraph stands in the checked subgraph.
  std::vector<uint32_t> position_;
  std::vector<Resolved> arguments_;  // of the node that is being bound
};

}  // namespace texgraph::graph
