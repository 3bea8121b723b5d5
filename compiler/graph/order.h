// SPDX-License-Identifier: Apache-2.0
// Puts things that need each other into an order in which each follows what it needs, or finds the
// circles that make this impossible. Linear but for a heap, and without recursion: chains may have
// any length.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace texgraph::graph {

// Thing i needs needs[first[i]] to needs[first[i + 1] - 1]; repetitions are allowed.
struct Dependencies {
  std::vector<uint32_t> first{0};
  std::vector<uint32_t> needs;

  uint32_t size() const { return static_cast<uint32_t>(first.size() - 1); }
  std::span<const uint32_t> Of(uint32_t thing) const {
    return {needs.data() + first[thing], first[thing + 1] - first[thing]};
  }
  void Add(uint32_t need) { needs.push_back(need); }
  void EndThing() { first.push_back(static_cast<uint32_t>(needs.size())); }
};

struct Order {
  // All things. Those that no circle holds up come first, in the order of their numbers where there
  // is a choice; then the others.
  std::vector<uint32_t> sequence;
  // For each group of things that need each other one shortest circle through the first of them:
  // each thing needs the next, and the last one the first.
  std::vector<std::vector<uint32_t>> circles;
};

Order OrderByNeed(const Dependencies& dependencies);

}  // namespace texgraph::graph
