// SPDX-License-Identifier: Apache-2.0
// A bar on standard error while several pictures are drawn or something else takes its time. It is
// drawn only on a terminal that can go back in its line, and nothing of it is left when it ends.
#pragma once

#include <cstdint>
#include <string>

namespace texgraph::cli {

enum class ProgressUnit : uint8_t { kFrames, kPercent };

// The line without what moves the cursor: "[#####.....] 12 of 24 frames, 3 s left" or
// "[#####.....] 50 %, 3 s left". The bar takes what `columns` leave, at most 30.
std::string ProgressLine(uint32_t done, uint32_t total, double seconds, uint32_t columns,
                         ProgressUnit unit = ProgressUnit::kFrames);

class Progress {
 public:
  // Nothing is drawn if `wanted` is false, for a single picture, or without such a terminal.
  Progress(uint32_t total, bool wanted, ProgressUnit unit = ProgressUnit::kFrames);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();
  // One more is done.
  void Advance() { Reach(done_ + 1); }
  // So much is done; never falls.
  void Reach(uint32_t done);

 private:
  void Draw();

  uint32_t total_;
  ProgressUnit unit_;
  uint32_t done_ = 0;
  bool is_shown_;
  double start_;
  double drawn_ = 0;
};

}  // namespace texgraph::cli
