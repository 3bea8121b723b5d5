// SPDX-License-Identifier: Apache-2.0
// Typed 4-byte ids. An id is an index into one vector; ids of different kinds do not mix.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace texgraph {

template <class Tag>
struct Id {
  static constexpr uint32_t kNone = 0xffffffffu;
  uint32_t index = kNone;

  constexpr Id() = default;
  constexpr explicit Id(size_t i) : index(static_cast<uint32_t>(i)) {}
  constexpr bool valid() const { return index != kNone; }
  constexpr explicit operator bool() const { return valid(); }
  friend constexpr bool operator==(Id, Id) = default;
  friend constexpr auto operator<=>(Id, Id) = default;
};

}  // namespace texgraph

template <class Tag>
struct std::hash<texgraph::Id<Tag>> {
  size_t operator()(texgraph::Id<Tag> id) const { return id.index; }
};
