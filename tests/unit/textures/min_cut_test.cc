// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/min_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>
#include <random>

namespace texgraph::textures {
namespace {

struct Pair {
  uint32_t from, to;
  int64_t cost, back;
};

int64_t CostOf(uint32_t sink, const std::vector<int64_t>& nodes, const std::vector<Pair>& pairs) {
  int64_t cost = 0;
  for (uint32_t i = 0; i < nodes.size(); ++i) {
    if (sink >> i & 1) cost += nodes[i];
  }
  for (const Pair& pair : pairs) {
    const bool from = sink >> pair.from & 1;
    const bool to = sink >> pair.to & 1;
    if (!from && to) cost += pair.cost;
    if (from && !to) cost += pair.back;
  }
  return cost;
}

// Against all divisions of ten nodes.
TEST(MinCutTest, NothingIsCheaperAndOfTheCheapestNoneHasFewerAtTheSink) {
  std::mt19937 random(3);
  for (int round = 0; round < 200; ++round) {
    constexpr uint32_t kNodes = 10;
    std::vector<int64_t> nodes(kNodes);
    std::vector<Pair> pairs;
    MinCut cut(kNodes);
    for (uint32_t i = 0; i < kNodes; ++i) {
      nodes[i] = static_cast<int64_t>(random() % 13) - 6;
      // In two parts, as several terms of one node are.
      cut.AddNode(i, nodes[i] + 4);
      cut.AddNode(i, -4);
      for (uint32_t j = 0; j < 2; ++j) {
        const uint32_t to = (i + 1 + random() % (kNodes - 1)) % kNodes;
        pairs.push_back(
            {i, to, static_cast<int64_t>(random() % 5), static_cast<int64_t>(random() % 5)});
        cut.AddPair(i, to, pairs.back().cost, pairs.back().back);
      }
    }
    uint32_t found = 0;
    const std::vector<bool> sink = cut.Solve();
    for (uint32_t i = 0; i < kNodes; ++i) found |= uint32_t{sink[i]} << i;
    int64_t least = std::numeric_limits<int64_t>::max();
    int fewest = 0;
    for (uint32_t set = 0; set < 1u << kNodes; ++set) {
      const int64_t cost = CostOf(set, nodes, pairs);
      if (cost > least || (cost == least && std::popcount(set) >= fewest)) continue;
      least = cost;
      fewest = std::popcount(set);
    }
    ASSERT_EQ(CostOf(found, nodes, pairs), least) << round;
    ASSERT_EQ(std::popcount(found), fewest) << round;
  }
}

}  // namespace
}  // namespace texgraph::textures
