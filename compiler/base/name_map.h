// SPDX-License-Identifier: Apache-2.0
// A hash table from names to small values, for the symbol tables of the compiler: entries lie in
// one vector, in the order in which they were added, and that is the order of going through them.
// Names are views: their text must outlive the map.
#pragma once

#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>
#include <vector>

namespace texgraph {

inline uint64_t HashName(std::string_view name) {
  constexpr uint64_t kFactor = 0x9e3779b97f4a7c15ull;
  uint64_t hash = name.size() * kFactor;
  const char* at = name.data();
  size_t left = name.size();
  auto mix = [&](uint64_t word) {
    hash = (hash ^ word) * kFactor;
    hash ^= hash >> 29;
  };
  for (; left >= 8; at += 8, left -= 8) {
    uint64_t word;
    std::memcpy(&word, at, 8);
    mix(word);
  }
  uint64_t rest = 0;
  for (; left > 0; --left) rest = rest << 8 | static_cast<unsigned char>(at[left - 1]);
  mix(rest);
  return hash ^ hash >> 32;
}

template <class T>
class NameMap {
 public:
  struct Entry {
    std::string_view name;
    T value;
    uint32_t hash;
  };

  // The value of a name, null if it has none. Good until the next Add.
  const T* Find(std::string_view name) const {
    if (entries_.empty()) return nullptr;
    const uint32_t found = slots_[SlotOf(name, static_cast<uint32_t>(HashName(name)))];
    return found == kFree ? nullptr : &entries_[found].value;
  }
  T* Find(std::string_view name) { return const_cast<T*>(std::as_const(*this).Find(name)); }
  bool Contains(std::string_view name) const { return Find(name) != nullptr; }

  // The name's value, and whether it is this one because there was none yet.
  std::pair<T*, bool> Add(std::string_view name, T value) {
    if (2 * (entries_.size() + 1) > slots_.size()) Grow(entries_.size() + 1);
    const uint32_t hash = static_cast<uint32_t>(HashName(name));
    uint32_t& slot = slots_[SlotOf(name, hash)];
    if (slot != kFree) return {&entries_[slot].value, false};
    slot = static_cast<uint32_t>(entries_.size());
    entries_.push_back({name, std::move(value), hash});
    return {&entries_.back().value, true};
  }

  void Clear() {
    entries_.clear();
    slots_.clear();
  }
  void Reserve(size_t count) {
    entries_.reserve(count);
    if (2 * count > slots_.size()) Grow(count);
  }
  const std::vector<Entry>& entries() const { return entries_; }

 private:
  static constexpr uint32_t kFree = 0xffffffffu;

  // Where the name is, or the free slot for it.
  size_t SlotOf(std::string_view name, uint32_t hash) const {
    const size_t mask = slots_.size() - 1;
    size_t slot = hash & mask;
    while (slots_[slot] != kFree &&
           (entries_[slots_[slot]].hash != hash || entries_[slots_[slot]].name != name)) {
      slot = (slot + 1) & mask;
    }
    return slot;
  }

  void Grow(size_t count) {
    size_t size = 16;
    while (size < 2 * count) size *= 2;
    slots_.assign(size, kFree);
    for (uint32_t i = 0; i < entries_.size(); ++i) {
      size_t slot = entries_[i].hash & (size - 1);
      while (slots_[slot] != kFree) slot = (slot + 1) & (size - 1);
      slots_[slot] = i;
    }
  }

  std::vector<Entry> entries_;
  std::vector<uint32_t> slots_;  // a power of two, at most half full: indices of entries
};

}  // namespace texgraph
