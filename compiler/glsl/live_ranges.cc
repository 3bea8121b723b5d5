// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/live_ranges.h"

#include <algorithm>

namespace texgraph::glsl {

bool LiveRange::LiveAt(uint32_t position) const {
  auto after = std::ranges::upper_bound(live, position, {}, &Interval::begin);
  return after != live.begin() && std::prev(after)->end >= position;
}

size_t FirstWriteFrom(const LiveRange& range, uint32_t position) {
  auto found = std::ranges::lower_bound(range.writes, position, {}, &LiveRange::Write::position);
  return static_cast<size_t>(found - range.writes.begin());
}

void Merge(LiveRange& into, LiveRange& from) {
  if (into.live.size() + into.writes.size() < from.live.size() + from.writes.size()) {
    std::swap(into, from);
  }
  for (const LiveRange::Write& write : from.writes) {
    // As a rule behind all others.
    auto place =
        std::ranges::upper_bound(into.writes, write.position, {}, &LiveRange::Write::position);
    into.writes.insert(place, write);
  }
  for (const LiveRange::Interval& added : from.live) {
    auto at = std::ranges::lower_bound(into.live, added.begin, {}, &LiveRange::Interval::begin);
    if (at != into.live.begin() && std::prev(at)->end + 1 >= added.begin) --at;
    if (at == into.live.end() || added.end + 1 < at->begin) {
      into.live.insert(at, added);
      continue;
    }
    at->begin = std::min(at->begin, added.begin);
    at->end = std::max(at->end, added.end);
    auto next = std::next(at);
    while (next != into.live.end() && next->begin <= at->end + 1) {
      at->end = std::max(at->end, next->end);
      next = into.live.erase(next);
    }
  }
  from = {};
}

}  // namespace texgraph::glsl
