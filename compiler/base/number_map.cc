// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/number_map.h"

#include <algorithm>

namespace texgraph {

NumberMap MapOfRows(std::span<const std::vector<int32_t>> rows) {
  NumberMap map;
  map.height = static_cast<uint32_t>(rows.size());
  map.width = rows.empty() ? 0 : static_cast<uint32_t>(rows[0].size());
  map.numbers.reserve(size_t{map.width} * map.height);
  for (size_t i = rows.size(); i-- > 0;)
    map.numbers.insert(map.numbers.end(), rows[i].begin(), rows[i].end());
  return map;
}

std::optional<NumberMap> MapOfLists(std::span<const std::vector<int32_t>> lists) {
  size_t longest = 0;
  for (const auto& list : lists) longest = std::max(longest, list.size());
  NumberMap map;
  map.width = static_cast<uint32_t>(longest);
  map.height = static_cast<uint32_t>(lists.size());
  map.numbers.reserve(longest * lists.size());
  for (const auto& list : lists) {
    if (list.empty() || longest % list.size() != 0) return std::nullopt;
    for (size_t i = 0; i < longest; ++i) map.numbers.push_back(list[i % list.size()]);
  }
  return map;
}

}  // namespace texgraph
