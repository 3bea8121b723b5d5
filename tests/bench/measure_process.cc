// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>

#include "tests/bench/measure.h"

extern char** environ;

namespace texgraph::bench {

ProcessFigures MeasureProcess(const std::vector<std::string>& command, int runs) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  ProcessFigures figures;
  std::vector<double> times;
  figures.ok = true;
  for (int i = 0; i < runs && figures.ok; ++i) {
    auto start = std::chrono::steady_clock::now();
    pid_t child = 0;
    if (posix_spawn(&child, arguments[0], &actions, nullptr, arguments.data(), environ) != 0) {
      figures.ok = false;
      break;
    }
    int status = 0;
    rusage usage{};
    wait4(child, &status, 0, &usage);
    std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
    figures.ok = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    times.push_back(time.count());
    figures.peak_kib = std::max(figures.peak_kib, usage.ru_maxrss);
  }
  posix_spawn_file_actions_destroy(&actions);
  if (times.empty()) return figures;
  std::ranges::sort(times);
  figures.fastest_ms = times.front();
  figures.median_ms = times[times.size() / 2];
  return figures;
}

}  // namespace texgraph::bench
