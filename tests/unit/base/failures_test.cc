// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/failures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>

#include <cstdlib>
#include <new>
#include <stdexcept>

#include "compiler/base/output_files.h"

namespace texgraph {
namespace {

using testing::ExitedWithCode;

#if defined(__SANITIZE_ADDRESS__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

void Prepare() {
  PrepareProcess();
  PrepareFailures();
}

[[noreturn]] void UseUpMemory() {
  Prepare();
  rlimit limit = {256 << 20, 256 << 20};
  setrlimit(RLIMIT_AS, &limit);
  for (;;) static_cast<char volatile*>(::operator new(1 << 20))[0] = 1;
}

TEST(FailuresDeathTest, MemoryThatRunsOut) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer has an allocator of its own";
  EXPECT_EXIT(UseUpMemory(), ExitedWithCode(4), "error: out of memory \\[out-of-memory\\]");
}

void Throw() { throw std::runtime_error("the reason"); }

TEST(FailuresDeathTest, ExceptionsThatNobodyCatches) {
  auto fail = []() noexcept {
    Prepare();
    Throw();
  };
  EXPECT_EXIT(fail(), ExitedWithCode(70),
              "internal error: uncaught exception: the reason \\[internal\\]");
}

TEST(FailuresDeathTest, Crashes) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer has handlers of its own";
  for (int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    EXPECT_EXIT(
        {
          Prepare();
          raise(number);
        },
        ExitedWithCode(70), "error: internal error: .* \\[internal\\]");
  }
}

int Deeper(volatile int* depth) {
  volatile char room[4096];
  *depth = *depth + 1;
  room[0] = static_cast<char>(*depth);
  // Never so deep; but a compiler that knew it would warn.
  return *depth == 0 ? 0 : Deeper(depth) + room[0];
}

TEST(FailuresDeathTest, AStackThatIsUsedUp) {
  if (kSanitized) GTEST_SKIP() << "the sanitizer has handlers of its own";
  EXPECT_EXIT(
      {
        Prepare();
        volatile int depth = 0;
        _exit(Deeper(&depth));
      },
      ExitedWithCode(70), "stack used up \\[internal\\]");
}

}  // namespace
}  // namespace texgraph
