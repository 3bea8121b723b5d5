// SPDX-License-Identifier: Apache-2.0
#include "runtime/child.h"

#include <errno.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "compiler/base/files.h"

namespace texgraph::runtime {
namespace {

constexpr size_t kPrintedBytes = 8192;

using Work = std::function<void(const std::function<void()>& notify)>;

struct ChildTask {
  const Work* work;
  int notifications;
};

void* RunTask(void* argument) {
  const ChildTask& task = *static_cast<ChildTask*>(argument);
  (*task.work)([&task] {
    const char byte = 1;
    while (write(task.notifications, &byte, 1) < 0 && errno == EINTR) {
    }
  });
  return nullptr;
}

void SetLimit(__rlimit_resource resource, rlim_t most) {
  rlimit limit;
  if (getrlimit(resource, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_max, most);
  setrlimit(resource, &limit);
}

// What the child does before it trusts itself to a driver.
void PrepareChild(pid_t parent, int printed, uint64_t memory_limit) {
  for (int number :
       {SIGHUP, SIGINT, SIGTERM, SIGPIPE, SIGXFSZ, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) {
    signal(number, SIG_DFL);
  }
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);  // it ended before the line above
  SetLimit(RLIMIT_CORE, 0);
#ifdef __SANITIZE_ADDRESS__
  (void)memory_limit;  // the sanitizer's shadow alone is larger
#else
  SetLimit(RLIMIT_DATA, memory_limit);
#endif
  const int null = open("/dev/null", O_RDONLY | O_CLOEXEC);
  if (null >= 0) dup2(null, STDIN_FILENO);
  if (printed >= 0) {
    dup2(printed, STDOUT_FILENO);
    dup2(printed, STDERR_FILENO);
  }
}

[[noreturn]] void RunChild(const Work& work, int notifications) {
  ChildTask task{&work, notifications};
  pthread_attr_t attributes;
  pthread_t thread;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, kChildStackBytes);
  if (pthread_create(&thread, &attributes, RunTask, &task) == 0) {
    pthread_join(thread, nullptr);
  } else {
    RunTask(&task);  // better a small stack than no picture
  }
  _exit(0);  // no destructors: the driver's may hang, and the parent's are not the child's to run
}

std::string SignalName(int number) {
  const char* name = sigabbrev_np(number);
  return name ? fmt::format("SIG{}", name) : fmt::format("signal {}", number);
}

}  // namespace

bool Child::Start(uint64_t memory_limit, const Work& work, std::string& why_not) {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) {
    why_not = ErrorText(errno);
    return false;
  }
  printed_ = memfd_create("texgraph-driver", MFD_CLOEXEC);
  fflush(nullptr);
  const pid_t parent = getpid();
  pid_ = fork();
  if (pid_ == 0) {
    close(ends[0]);
    PrepareChild(parent, printed_, memory_limit);
    RunChild(work, ends[1]);
  }
  const int error = errno;
  close(ends[1]);
  notifications_ = ends[0];
  if (pid_ > 0) return true;
  End();
  why_not = ErrorText(error);
  return false;
}

Child::Event Child::Wait(double seconds) {
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
  for (;;) {
    const double left = std::chrono::duration<double>(deadline - Clock::now()).count();
    if (left <= 0) break;
    pollfd poll_for{notifications_, POLLIN, 0};
    const int ready = poll(&poll_for, 1, static_cast<int>(std::min(left * 1000 + 1, 1e6)));
    if (ready <= 0) continue;  // interrupted, or a part of a long wait
    char byte;
    const ssize_t size = read(notifications_, &byte, 1);
    if (size == 1) return Event::kNotified;
    if (size < 0 && errno == EINTR) continue;
    Reap();
    return Event::kEnded;
  }
  kill(pid_, SIGKILL);
  Reap();
  return Event::kTimedOut;
}

void Child::Reap() {
  if (pid_ <= 0) return;
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  ending_ = WIFSIGNALED(status) ? SignalName(WTERMSIG(status))
                                : fmt::format("exit code {}", WEXITSTATUS(status));
}

std::string Child::Printed() const {
  if (printed_ < 0) return "";
  const off_t size = lseek(printed_, 0, SEEK_END);
  if (size <= 0) return "";
  std::string text(std::min(static_cast<size_t>(size), kPrintedBytes), '\0');
  const ssize_t read =
      pread(printed_, text.data(), text.size(), size - static_cast<off_t>(text.size()));
  text.resize(read > 0 ? static_cast<size_t>(read) : 0);
  return text;
}

void Child::End() {
  if (pid_ > 0) {
    kill(pid_, SIGKILL);
    Reap();
  }
  for (int* descriptor : {&notifications_, &printed_}) {
    if (*descriptor >= 0) close(*descriptor);
    *descriptor = -1;
  }
}

}  // namespace texgraph::runtime
