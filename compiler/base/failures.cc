// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/failures.h"

#include <signal.h>
#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/base/output_files.h"

namespace texgraph {
namespace {

// Everything below may run when there is no memory left or inside a signal handler: no allocation.
[[noreturn]] void End(ExitCode code, std::string_view what, std::string_view name,
                      std::string_view more = {}) {
  for (std::string_view part :
       {std::string_view("error: "), what, std::string_view(more.empty() ? "" : ": "), more,
        std::string_view(" ["), name, std::string_view("]\n")}) {
    (void)WriteAll(STDERR_FILENO, part);
  }
  EndProcess(static_cast<int>(code));
}

void OnNoMemory() { End(ExitCode::kLimit, "out of memory", "out-of-memory"); }

void OnTerminate() {
  if (std::exception_ptr exception = std::current_exception()) {
    try {
      std::rethrow_exception(exception);
    } catch (const std::bad_alloc&) {
      OnNoMemory();
    } catch (const std::exception& e) {
      End(ExitCode::kInternal, "internal error: uncaught exception", "internal", e.what());
    } catch (...) {
    }
  }
  End(ExitCode::kInternal, "internal error: terminated", "internal");
}

#if !defined(__SANITIZE_ADDRESS__)
void OnCrash(int number) {
  std::string_view what = "internal error: crashed";
  switch (number) {
    case SIGSEGV:
      what = "internal error: invalid memory access or stack used up";
      break;
    case SIGBUS:
      what = "internal error: bus error";
      break;
    case SIGFPE:
      what = "internal error: arithmetic exception";
      break;
    case SIGILL:
      what = "internal error: illegal instruction";
      break;
    case SIGABRT:
      what = "internal error: aborted";
      break;
    default:
      break;
  }
  End(ExitCode::kInternal, what, "internal");
}

void CatchCrashes() {
  // A used-up stack leaves no room for the handler.
  static char stack[16384];
  stack_t alternative = {};
  alternative.ss_sp = stack;
  alternative.ss_size = sizeof stack;
  sigaltstack(&alternative, nullptr);
  struct sigaction action = {};
  action.sa_handler = OnCrash;
  action.sa_flags = SA_ONSTACK | SA_RESETHAND;
  for (int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) sigaction(number, &action, nullptr);
}
#endif

}  // namespace

void PrepareFailures() {
  std::set_new_handler(OnNoMemory);
  std::set_terminate(OnTerminate);
#if !defined(__SANITIZE_ADDRESS__)
  CatchCrashes();  // the sanitizer has handlers of its own, which say more
#endif
}

}  // namespace texgraph
