// SPDX-License-Identifier: Apache-2.0
// When a variable's value is needed, in positions of a Schedule, and whether two variables can be
// one. A value that is written at position w is live at w + 1 and on, up to its last read. Two
// cannot be one if either is written while the other is live, unless what is written is the other's
// own value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace texgraph::glsl {

struct LiveRange {
  struct Interval {
    uint32_t begin, end;  // both ends included
  };
  struct Write {
    uint32_t position;
    uint32_t source;  // the variable that is copied, or kNoSource
  };
  static constexpr uint32_t kNoSource = 0xffffffffu;

  std::vector<Interval> live;  // sorted, apart
  std::vector<Write> writes;   // sorted

  void AddInterval(uint32_t begin, uint32_t end) {
    if (begin <= end) live.push_back({begin, end});
  }
  bool LiveAt(uint32_t position) const;
};

// Whether a write of `a` falls into the life of `b`. `is_b`: whether a source is `b`'s variable.
template <class IsB>
bool WritesInto(const LiveRange& a, const LiveRange& b, IsB&& is_b);

// Makes `into` the range of both.
void Merge(LiveRange& into, LiveRange& from);

// The index of the first write at `position` or later.
size_t FirstWriteFrom(const LiveRange& range, uint32_t position);

template <class IsB>
bool WritesInto(const LiveRange& a, const LiveRange& b, IsB&& is_b) {
  if (b.live.empty()) return false;
  // Only writes within the hull of b matter: chains of many writes are merged with short lives.
  uint32_t first = b.live.front().begin - 1, last = b.live.back().end;
  for (size_t i = FirstWriteFrom(a, first); i < a.writes.size(); ++i) {
    const LiveRange::Write& write = a.writes[i];
    if (write.position > last) break;
    if (b.LiveAt(write.position + 1) &&
        !(write.source != LiveRange::kNoSource && is_b(write.source))) {
      return true;
    }
  }
  return false;
}

}  // namespace texgraph::glsl
