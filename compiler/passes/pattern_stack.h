// SPDX-License-Identifier: Apache-2.0
// The stack that matching and instantiating patterns run on, in place of recursion and allocation.
#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace texgraph::passes {

// The parser refuses patterns that wait for more values than this at once.
inline constexpr size_t kMaxPending = 16;

template <class T>
class PatternStack {
 public:
  void Push(T item) { items_[size_++] = item; }
  T Pop() { return items_[--size_]; }
  std::span<T> Top(size_t count) { return {items_.data() + size_ - count, count}; }
  void Drop(size_t count) { size_ -= count; }

 private:
  std::array<T, kMaxPending> items_;
  size_t size_ = 0;
};

}  // namespace texgraph::passes
