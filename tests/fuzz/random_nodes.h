// SPDX-License-Identifier: Apache-2.0
// Random nodes of one subgraph, the part of random_graph.h below textures, parameters and
// functions.
#pragma once

#include <deque>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/fuzz/block_catalog.h"
#include "tests/fuzz/document_tree.h"

namespace texgraph::fuzz {

// A graph function that can be used: as a node's block, or at a function port.
struct GraphFunction {
  std::string name;
  blocks::Overload signature;
};

class RandomNodes {
 public:
  // `functions`: those that may be used; `shadowed`: blocks that may not. All must outlive this.
  RandomNodes(std::mt19937& random, const std::deque<GraphFunction>& functions,
              const std::set<std::string>& shadowed, std::set<std::string>& used_blocks)
      : random_(random), functions_(functions), shadowed_(shadowed), used_blocks_(used_blocks) {}

  // Something that may stand at ports from now on.
  void AddThing(Thing thing) { things_.push_back(std::move(thing)); }
  // The outputs of a node or function; what they have in common is in `like`.
  void AddOutputs(const std::string& node, const std::vector<blocks::Port>& outputs,
                  const Thing& like);
  // One more node of that name, if one could be made.
  std::optional<Tree> MakeNode(const std::string& name);
  // Something to stand at a port: connected to it in `connected` of ten cases, if that can be.
  std::optional<Tree> MakeArgument(const blocks::Port& port, uint32_t connected,
                                   PortArgument& argument);
  // A literal for the port. None if its type has none.
  std::optional<graph::Argument> Literal(const blocks::Port& port);
  graph::Argument List(const blocks::Port& port, uint32_t length);
  // The value of a port that goes by another one's; nothing if the port does not, or that one is
  // not known.
  std::optional<graph::Argument> Following(const blocks::Overload& overload,
                                           const blocks::Port& port,
                                           std::span<const PortArgument> arguments);
  std::optional<graph::Argument> Transitions(const blocks::Port& families,
                                             std::span<const PortArgument> arguments);
  // `is_list`: of numbers in one row, not a matrix, however many they are.
  Tree TreeOf(const graph::Argument& literal, bool is_list = false);
  const std::deque<Thing>& things() const { return things_; }

  uint32_t Below(uint32_t n) { return static_cast<uint32_t>(random_() % n); }
  bool OneIn(uint32_t n) { return Below(n) == 0; }

 private:
  const Thing* Pick(const blocks::Port& port);
  // By chance alone a tile would seldom meet a block that takes one, and few blocks look at
  // textures or call functions.
  enum class Wish { kAny, kStructs, kPictures };
  bool Fulfils(const blocks::Overload& overload, Wish wish) const;
  std::optional<Tree> Attempt(const std::string& name, Wish wish);
  bool MayStand(const blocks::Port& port, const Thing& thing);
  double Number(const blocks::Port& port, ir::Scalar scalar, size_t component);
  // The node's ports. `result`: what its outputs have in common.
  std::optional<Tree> Bind(std::span<const blocks::Overload> overloads,
                           const blocks::Overload& meant, const blocks::Overload** chosen,
                           Thing& result);

  std::mt19937& random_;
  const std::deque<GraphFunction>& functions_;
  const std::set<std::string>& shadowed_;
  std::set<std::string>& used_blocks_;
  BlockCatalog& catalog_ = BlockCatalog::Instance();
  std::deque<Thing> things_;
};

}  // namespace texgraph::fuzz
