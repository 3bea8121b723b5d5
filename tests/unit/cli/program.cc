// SPDX-License-Identifier: Apache-2.0
#include "tests/unit/cli/program.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace texgraph {
namespace {

// A file without a name.
int Unnamed() {
  std::string name = testing::TempDir() + "texgraph-output-XXXXXX";
  int descriptor = mkostemp(name.data(), O_CLOEXEC);
  unlink(name.c_str());
  return descriptor;
}

std::string Contents(int descriptor) {
  std::string out;
  char buffer[65536];
  lseek(descriptor, 0, SEEK_SET);
  for (ssize_t got; (got = read(descriptor, buffer, sizeof buffer)) > 0;)
    out.append(buffer, static_cast<size_t>(got));
  close(descriptor);
  return out;
}

// Waits for the child at most `limit` seconds, then kills it.
int Wait(pid_t child, double limit, bool& timed_out) {
  auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit);
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) {
      timed_out = true;
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      break;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(300));
  }
  return status;
}

}  // namespace

Outcome Program::Run() const {
  std::vector<char*> argv{const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  int in = Unnamed(), out = Unnamed(), error = Unnamed();
  for (size_t at = 0; at < input.size();) {
    ssize_t written = write(in, input.data() + at, input.size() - at);
    if (written <= 0) break;
    at += static_cast<size_t>(written);
  }
  lseek(in, 0, SEEK_SET);
  auto start = std::chrono::steady_clock::now();
  pid_t child = fork();
  if (child == 0) {
    for (const std::string& setting : environment) putenv(const_cast<char*>(setting.c_str()));
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(error, STDERR_FILENO);
    if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
    if (prepare) prepare();
    execv(path.c_str(), argv.data());
    _exit(127);
  }
  Outcome outcome;
  int status = Wait(child, time_limit, outcome.timed_out);
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  outcome.out = Contents(out);
  outcome.error = Contents(error);
  close(in);
  return outcome;
}

Program Texgraphc(std::vector<std::string> arguments, std::string folder) {
  Program program;
  program.path = TEXGRAPHC_PROGRAM;
  program.arguments = std::move(arguments);
  program.folder = std::move(folder);
  return program;
}

}  // namespace texgraph
