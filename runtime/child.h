// SPDX-License-Identifier: Apache-2.0
// A forked process for code that may crash, hang or eat the machine's memory. It has a big stack
// and no more memory than allowed, dumps no core, dies with its parent, and what it prints is kept
// from the terminal.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <string>

namespace texgraph::runtime {

inline constexpr size_t kChildStackBytes = size_t{64} << 20;

class Child {
 public:
  enum class Event : uint8_t { kNotified, kEnded, kTimedOut };

  Child() = default;
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;
  ~Child() { End(); }

  // Runs `work` in the child; each call of its argument is one kNotified in the parent. False, with
  // the reason in `why_not`, if no process could be made.
  bool Start(uint64_t memory_limit,
             const std::function<void(const std::function<void()>& notify)>& work,
             std::string& why_not);
  // The next event; after kTimedOut the child has been ended.
  Event Wait(double seconds);
  // After kEnded: "SIGSEGV", or "exit code 3".
  const std::string& ending() const { return ending_; }
  // The last part of what it printed so far.
  std::string Printed() const;
  // Kills it if it still runs.
  void End();

 private:
  void Reap();

  pid_t pid_ = -1;
  int notifications_ = -1;
  int printed_ = -1;
  std::string ending_;
};

}  // namespace texgraph::runtime
