// SPDX-License-Identifier: Apache-2.0
// Runs texgraphc on one text from a stranger and checks what holds for all of them: it ends in
// time, with an expected exit code, says something if it fails, prints nothing that a terminal
// would obey, and writes nothing on failure.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"

namespace texgraph {

class Hostile : public testing::Test {
 protected:
  struct Result {
    Outcome outcome;
    std::string shader;
  };

  Result Run(const std::string& text, const std::string& name = "graph.json",
             double time_limit = 20) {
    folder.Write(name, text);
    Program program = Texgraphc({name, "-o", "out/x.frag"}, folder.path());
    program.time_limit = time_limit;
    std::filesystem::remove_all(folder / "out");
    std::filesystem::create_directory(folder / "out");
    Result result;
    result.outcome = program.Run();
    EXPECT_FALSE(result.outcome.timed_out) << text.substr(0, 200);
    result.shader = folder.Read("out/x.frag");
    EXPECT_EQ(result.outcome.exit_code == 0, !result.shader.empty()) << result.outcome.error;
    if (result.outcome.exit_code != 0) {
      EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
      EXPECT_THAT(result.outcome.error, testing::HasSubstr("error: "));
    }
    for (unsigned char c : result.outcome.error) {
      if (c < 0x20 && c != '\n')
        ADD_FAILURE() << "control character " << int(c) << " in " << result.outcome.error;
    }
    return result;
  }

  // The name in brackets must be among the messages.
  void ExpectRefused(const std::string& text, int exit_code, const std::string& diagnostic,
                     const std::string& name = "graph.json") {
    Result result = Run(text, name);
    EXPECT_EQ(result.outcome.exit_code, exit_code) << text.substr(0, 300) << "\n"
                                                   << result.outcome.error.substr(0, 2000);
    EXPECT_THAT(result.outcome.error, testing::HasSubstr("[" + diagnostic + "]"))
        << text.substr(0, 300);
  }

  // Nothing on standard error, and a shader.
  std::string ExpectAccepted(const std::string& text, const std::string& name = "graph.json") {
    Result result = Run(text, name);
    EXPECT_EQ(result.outcome.exit_code, 0) << text.substr(0, 300) << "\n"
                                           << result.outcome.error.substr(0, 2000);
    return result.shader;
  }

  ScratchFolder folder;
};

}  // namespace texgraph
