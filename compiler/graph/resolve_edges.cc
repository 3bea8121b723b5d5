// SPDX-License-Identifier: Apache-2.0
// Which patterns of a texture fit beside each other: what its key "edges" says.
#include <algorithm>
#include <numeric>

#include "compiler/graph/graph_reader.h"

namespace texgraph::graph {
namespace {

constexpr std::string_view kMatchAll = "match";

// Sets of patterns that grow together; each is known by its first pattern.
class PatternSets {
 public:
  explicit PatternSets(uint32_t count) : parents_(count) {
    std::iota(parents_.begin(), parents_.end(), 0u);
  }

  uint32_t FirstOf(uint32_t pattern) {
    while (parents_[pattern] != pattern) {
      parents_[pattern] = parents_[parents_[pattern]];  // halves the way for the next time
      pattern = parents_[pattern];
    }
    return pattern;
  }

  void Join(uint32_t a, uint32_t b) {
    a = FirstOf(a);
    b = FirstOf(b);
    parents_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<uint32_t> parents_;  // none is above its child
};

// Patterns of one list are of one group, and so are those that share a list with one of it.
std::vector<uint32_t> GroupsOf(const NumberMap& lists, uint32_t count) {
  PatternSets sets(count);
  for (uint32_t y = 0; y < lists.height; ++y) {
    std::optional<uint32_t> first;
    for (uint32_t x = 0; x < lists.width; ++x) {
      const int32_t number = lists.At(x, y);
      if (number < 0 || static_cast<uint32_t>(number) >= count) continue;
      const auto pattern = static_cast<uint32_t>(number);
      if (!first) first = pattern;
      sets.Join(*first, pattern);
    }
  }
  std::vector<uint32_t> groups(count);
  for (uint32_t i = 0; i < count; ++i) groups[i] = sets.FirstOf(i);
  return groups;
}

}  // namespace

void GraphReader::ResolveEdges(uint32_t index) {
  Texture& texture = graph_.textures[index];
  const DocumentNode* node = texture_keys_[index][static_cast<size_t>(TextureKey::kEdges)];
  if (!node || !texture.HasPatterns() || !texture.is_array) return;
  const Owner owner{"texture", texture.name};
  std::string_view text;
  if (!ReadText(node, owner, text)) return;
  texture.match_edges = true;
  if (text == kMatchAll) return;
  const NumberMap* lists = FindLists(*node, owner, index, {&kMatchAll, 1});
  if (!lists) return;
  texture.edge_groups = GroupsOf(*lists, texture.PatternCount());
  // One group of all says no more than the word.
  if (std::ranges::all_of(texture.edge_groups, [](uint32_t first) { return first == 0; })) {
    texture.edge_groups.clear();
  }
}

}  // namespace texgraph::graph
