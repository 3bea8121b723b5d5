// SPDX-License-Identifier: Apache-2.0
// Runs texgraphc (or another program) as a user would and says what came of it.
#pragma once

#include <sys/resource.h>

#include <functional>
#include <string>
#include <vector>

namespace texgraph {

struct Outcome {
  int exit_code = -1;  // minus the signal's number if a signal ended it
  std::string out;
  std::string error;
  double seconds = 0;
  bool timed_out = false;  // and was killed
};

struct Program {
  std::string path;
  std::vector<std::string> arguments;
  std::string folder;                    // to run in; "": the present one
  std::string input;                     // standard input
  std::vector<std::string> environment;  // "NAME=value", beside the present environment
  double time_limit = 60;
  // In the child, just before the program starts: limits, descriptors.
  std::function<void()> prepare;

  Outcome Run() const;
};

// The texgraphc of this build with these arguments.
Program Texgraphc(std::vector<std::string> arguments, std::string folder = {});

}  // namespace texgraph
