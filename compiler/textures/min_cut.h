// SPDX-License-Identifier: Apache-2.0
// A minimum cut: nodes are divided between a source's side and a sink's so that what that costs is
// the least there is. Of several such cuts it is the one with the fewest nodes on the sink's side,
// on every machine.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

namespace texgraph::textures {

class MinCut {
 public:
  explicit MinCut(uint32_t nodes) : to_source_(nodes), to_sink_(nodes) {}

  // What it costs that the node is on the sink's side; negative: on the source's side.
  void AddNode(uint32_t node, int64_t cost) {
    (cost > 0 ? to_source_ : to_sink_)[node] += std::abs(cost);
  }
  // What it costs that `from` is on the source's side and `to` on the sink's, and the other way.
  // Neither is negative.
  void AddPair(uint32_t from, uint32_t to, int64_t cost, int64_t back = 0) {
    if (cost > 0 || back > 0) pairs_.push_back({from, to, cost, back});
  }
  // True for the nodes that have to be on the sink's side.
  std::vector<bool> Solve() const;

 private:
  struct Pair {
    uint32_t from;
    uint32_t to;
    int64_t cost;
    int64_t back;
  };
  struct Arcs {
    std::vector<std::pair<uint32_t, uint32_t>> ends;
    std::vector<int64_t> costs;
    std::vector<uint32_t> reverse;
  };
  Arcs SortedArcs() const;

  std::vector<int64_t> to_source_;
  std::vector<int64_t> to_sink_;
  std::vector<Pair> pairs_;
};

}  // namespace texgraph::textures
