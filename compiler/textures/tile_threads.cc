// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_threads.h"

#include <algorithm>
#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace texgraph::textures {

void TileWork::Add(uint64_t done) {
  if (!progress_) return;
  const std::lock_guard lock(mutex_);
  done_ = std::min(done_ + done, total_);
  progress_(static_cast<double>(done_) / static_cast<double>(total_));
}

void ForEachTile(uint32_t count, uint32_t threads, const std::function<void(uint32_t)>& work) {
  if (threads == 0) threads = std::max(std::thread::hardware_concurrency(), 1u);
  std::atomic<uint32_t> next{0};
  std::atomic<bool> no_memory{false};
  const auto run = [&] {
    try {
      for (uint32_t i = next++; i < count && !no_memory; i = next++) work(i);
    } catch (const std::bad_alloc&) {
      no_memory = true;
    }
  };
  std::vector<std::thread> others;
  others.reserve(std::min(threads, count));
  for (uint32_t i = 1; i < std::min(threads, count); ++i) {
    try {
      others.emplace_back(run);
    } catch (const std::system_error&) {
      break;  // no more threads to be had; this one does their work
    }
  }
  run();
  for (std::thread& other : others) other.join();
  if (no_memory) throw std::bad_alloc();
}

}  // namespace texgraph::textures
