// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/order.h"

#include <algorithm>
#include <functional>
#include <queue>

namespace texgraph::graph {
namespace {

constexpr uint32_t kNone = UINT32_MAX;

bool IsInOrder(const Dependencies& dependencies) {
  for (uint32_t i = 0; i < dependencies.size(); ++i) {
    for (uint32_t need : dependencies.Of(i)) {
      if (need >= i) return false;
    }
  }
  return true;
}

// The same the other way round: which things need this one.
Dependencies Reversed(const Dependencies& dependencies) {
  Dependencies reversed;
  reversed.first.assign(dependencies.size() + 1, 0);
  for (uint32_t need : dependencies.needs) ++reversed.first[need + 1];
  for (uint32_t i = 0; i < dependencies.size(); ++i) reversed.first[i + 1] += reversed.first[i];
  reversed.needs.resize(dependencies.needs.size());
  std::vector<uint32_t> next(reversed.first.begin(), reversed.first.end() - 1);
  for (uint32_t i = 0; i < dependencies.size(); ++i) {
    for (uint32_t need : dependencies.Of(i)) reversed.needs[next[need]++] = i;
  }
  return reversed;
}

// Kahn's algorithm with the smallest ready number first. Leaves out what circles hold up.
std::vector<uint32_t> SortedPart(const Dependencies& dependencies) {
  Dependencies users = Reversed(dependencies);
  std::vector<uint32_t> missing(dependencies.size());
  std::priority_queue<uint32_t, std::vector<uint32_t>, std::greater<>> ready;
  for (uint32_t i = 0; i < dependencies.size(); ++i) {
    missing[i] = static_cast<uint32_t>(dependencies.Of(i).size());
    if (missing[i] == 0) ready.push(i);
  }
  std::vector<uint32_t> sequence;
  sequence.reserve(dependencies.size());
  while (!ready.empty()) {
    uint32_t thing = ready.top();
    ready.pop();
    sequence.push_back(thing);
    for (uint32_t user : users.Of(thing)) {
      if (--missing[user] == 0) ready.push(user);
    }
  }
  return sequence;
}

// Tarjan's strongly connected components among the things with `in_part`, with a stack of its own:
// component[i] is equal for things that need each other.
class Components {
 public:
  Components(const Dependencies& dependencies, const std::vector<bool>& in_part)
      : dependencies_(dependencies),
        in_part_(in_part),
        component_(dependencies.size(), kNone),
        index_(dependencies.size(), kNone),
        low_(dependencies.size(), 0) {
    for (uint32_t i = 0; i < dependencies.size(); ++i) {
      if (in_part[i] && index_[i] == kNone) Visit(i);
    }
  }
  const std::vector<uint32_t>& component() const { return component_; }
  uint32_t count() const { return count_; }

 private:
  struct Frame {
    uint32_t thing;
    uint32_t next;  // among its needs
  };

  void Enter(uint32_t thing) {
    index_[thing] = low_[thing] = counter_++;
    open_.push_back(thing);
    frames_.push_back({thing, 0});
  }

  void Visit(uint32_t root) {
    Enter(root);
    while (!frames_.empty()) {
      Frame& frame = frames_.back();
      uint32_t thing = frame.thing;
      std::span<const uint32_t> needs = dependencies_.Of(thing);
      if (frame.next < needs.size()) {
        uint32_t need = needs[frame.next++];
        if (!in_part_[need]) continue;
        if (index_[need] == kNone) {
          Enter(need);
        } else if (component_[need] == kNone) {
          low_[thing] = std::min(low_[thing], index_[need]);
        }
        continue;
      }
      frames_.pop_back();
      if (!frames_.empty()) {
        uint32_t parent = frames_.back().thing;
        low_[parent] = std::min(low_[parent], low_[thing]);
      }
      if (low_[thing] == index_[thing]) Close(thing);
    }
  }

  void Close(uint32_t root) {
    while (true) {
      uint32_t thing = open_.back();
      open_.pop_back();
      component_[thing] = count_;
      if (thing == root) break;
    }
    ++count_;
  }

  const Dependencies& dependencies_;
  const std::vector<bool>& in_part_;
  std::vector<uint32_t> component_, index_, low_, open_;
  std::vector<Frame> frames_;
  uint32_t counter_ = 0, count_ = 0;
};

// A shortest circle through `start` that stays in its component; empty if there is none.
std::vector<uint32_t> ShortestCircle(const Dependencies& dependencies,
                                     const std::vector<uint32_t>& component, uint32_t start,
                                     std::vector<uint32_t>& came_from) {
  std::queue<uint32_t> queue;
  queue.push(start);
  while (!queue.empty()) {
    uint32_t thing = queue.front();
    queue.pop();
    for (uint32_t need : dependencies.Of(thing)) {
      if (need == start) {
        std::vector<uint32_t> circle{thing};
        while (circle.back() != start) circle.push_back(came_from[circle.back()]);
        std::ranges::reverse(circle);
        return circle;
      }
      if (component[need] != component[start] || came_from[need] != kNone) continue;
      came_from[need] = thing;
      queue.push(need);
    }
  }
  return {};
}

}  // namespace

Order OrderByNeed(const Dependencies& dependencies) {
  Order order;
  uint32_t size = dependencies.size();
  if (IsInOrder(dependencies)) {
    for (uint32_t i = 0; i < size; ++i) order.sequence.push_back(i);
    return order;
  }
  order.sequence = SortedPart(dependencies);
  if (order.sequence.size() == size) return order;
  std::vector<bool> held_up(size, true);
  for (uint32_t thing : order.sequence) held_up[thing] = false;
  Components components(dependencies, held_up);
  std::vector<bool> done(components.count(), false);
  std::vector<uint32_t> came_from(size, kNone);
  for (uint32_t i = 0; i < size; ++i) {
    if (!held_up[i]) continue;
    order.sequence.push_back(i);
    if (done[components.component()[i]]) continue;
    done[components.component()[i]] = true;
    std::vector<uint32_t> circle =
        ShortestCircle(dependencies, components.component(), i, came_from);
    if (!circle.empty()) order.circles.push_back(std::move(circle));
  }
  return order;
}

}  // namespace texgraph::graph
