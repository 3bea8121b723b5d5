// SPDX-License-Identifier: Apache-2.0
// Work that is independent, on several cores.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>

#include "compiler/textures/tile_set.h"

namespace texgraph::textures {

// Counts what is done and tells it as shares.
class TileWork {
 public:
  TileWork(const TileProgress& progress, uint64_t total) : progress_(progress), total_(total) {}

  void Add(uint64_t done);

 private:
  const TileProgress& progress_;
  uint64_t total_;
  uint64_t done_ = 0;
  std::mutex mutex_;
};

// Calls `work` for 0 to count - 1, in any order, on up to `threads` threads (0: as many as there
// are cores), this one included. After std::bad_alloc in one of them no further calls begin, and it
// is thrown here.
void ForEachTile(uint32_t count, uint32_t threads, const std::function<void(uint32_t)>& work);

}  // namespace texgraph::textures
