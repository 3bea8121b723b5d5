// SPDX-License-Identifier: Apache-2.0
// The graphs and blocks of README.md and docs/ compile as they stand there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/page.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

namespace fs = std::filesystem;

const std::string kRoot = TEXGRAPH_SOURCE_DIR "/";

class Manual : public testing::Test {
 protected:
  Manual() {
    for (const auto& entry : fs::directory_iterator(kRoot + "graphs/brick_wall")) {
      if (entry.path().extension() == ".png")
        fs::copy_file(entry.path(), folder / entry.path().filename().string());
    }
    fs::create_directories(folder / "blocks/shapes");
  }

  // Compiles every whole graph of the page; returns how many there are.
  size_t Compile(const std::string& page) {
    size_t count = 0;
    for (const std::string& text : Fenced(ReadPage(page), "json")) {
      if (text.find("\"texgraph\": 1") == std::string::npos) continue;
      folder.Write("graph.json", text);
      Outcome outcome =
          Texgraphc({"-I", "blocks", "graph.json", "-o", "shader.frag"}, folder.path()).Run();
      EXPECT_EQ(outcome.exit_code, 0) << page << "\n" << text << outcome.error;
      EXPECT_EQ(outcome.error, "") << page;
      ++count;
    }
    return count;
  }

  ScratchFolder folder;
};

TEST_F(Manual, GraphsCompile) {
  for (const std::string& block : Fenced(ReadPage("docs/getting-started.md"), "glsl"))
    folder.Write("blocks/shapes/stripes.glsl", block);
  EXPECT_EQ(Compile("README.md"), 1u);
  EXPECT_EQ(Compile("docs/getting-started.md"), 5u);
  EXPECT_GE(Compile("docs/graph-format.md"), 1u);
}

// Whatever texgraphc is told in a page is understood; the files that it names need not exist.
TEST_F(Manual, OptionsOfCommandsExist) {
  size_t count = 0;
  for (const char* page : {"README.md", "docs/getting-started.md"}) {
    for (const std::string& text : Fenced(ReadPage(page), "sh")) {
      std::istringstream lines(text);
      for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("texgraphc ")) continue;
        ++count;
        Program program;
        program.path = "/bin/sh";
        program.folder = folder.path();
        program.arguments = {"-c", Texgraphc({}).path + line.substr(9)};
        Outcome outcome = program.Run();
        EXPECT_NE(outcome.exit_code, 2) << line << "\n" << outcome.error;
      }
    }
  }
  EXPECT_GE(count, 3u);
}

}  // namespace
}  // namespace texgraph
