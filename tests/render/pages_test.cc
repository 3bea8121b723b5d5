// SPDX-License-Identifier: Apache-2.0
// The commands of docs/patterns.md, docs/bombing.md, docs/by_example.md and docs/rendering.md do
// what the pages say, in pictures that are smaller.
#include <gtest/gtest.h>

#include <algorithm>
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

// The words of each command, lines that end in \ taken together, without the quotes around words.
std::vector<std::vector<std::string>> CommandsOf(const std::string& page) {
  std::vector<std::vector<std::string>> commands;
  for (std::string text : Fenced(ReadPage(page), "")) {
    for (size_t at; (at = text.find("\\\n")) != std::string::npos;) text.replace(at, 2, " ");
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::erase(line, '\'');
      std::istringstream words(line);
      std::vector<std::string> command;
      for (std::string word; words >> word;) command.push_back(word);
      if (!command.empty()) commands.push_back(command);
    }
  }
  return commands;
}

class Pages : public testing::Test {
 protected:
  Pages() {
    fs::create_directory_symlink(fs::path(TEXGRAPH_SOURCE_DIR) / "graphs", folder / "graphs");
    // What "wall.json" is on the page, which does not say how it is made.
    const Outcome made =
        Texgraphc({"graphs/brick_wall/brick_wall.json", "-o", "wall.frag"}, folder.path()).Run();
    EXPECT_EQ(made.exit_code, 0) << made.error;
  }

  static std::string ProgramOf(const std::string& name) {
    if (name == "texgraph") return TEXGRAPH_PROGRAM;
    if (name == "texgraphc") return Texgraphc({}).path;
    return name == "move_sprites" ? MOVE_SPRITES_PROGRAM : "";
  }

  // Fewer and smaller frames; what the command does is the same.
  static void Shorten(std::vector<std::string>& command) {
    const auto value = [&](const std::string& option) {
      const auto at = std::ranges::find(command, option);
      return at == command.end() ? nullptr : &*(at + 1);
    };
    if (std::string* frames = value("--frames")) *frames = "3";
    if (std::string* size = value("--size")) *size = "24";
    if (command[0] == "move_sprites") command[3] = "3";
    if (command[0] != "texgraph") return;
    if (command[1] == "tiles") {
      if (std::string* size = value("--tile-size")) *size = "16";
      command.insert(command.begin() + 2, {"--candidates", "8"});
    } else if (!value("--size")) {
      command.insert(command.end(), {"--size", "24"});
    }
  }

  bool WasWritten(const std::string& file) const {
    const fs::path path = folder / file;
    return fs::exists(path) || fs::exists(path.parent_path() / (path.stem().string() + ".0003" +
                                                                path.extension().string()));
  }

  // Returns how many commands there are; what needs a file of the reader's own is left out.
  size_t Run(const std::string& page, const std::string& without = "-") {
    size_t count = 0;
    for (std::vector<std::string> command : CommandsOf(page)) {
      if (std::ranges::find(command, without) != command.end()) continue;
      ++count;
      Shorten(command);
      std::string text;
      for (const std::string& word : command) text += word + " ";
      Program program;
      program.path = ProgramOf(command[0]);
      EXPECT_NE(program.path, "") << text;
      program.arguments.assign(command.begin() + 1, command.end());
      program.folder = folder.path();
      const Outcome outcome = program.Run();
      EXPECT_EQ(outcome.exit_code, 0) << text << "\n" << outcome.error;
      const auto output = std::ranges::find(command, "-o");
      EXPECT_TRUE(WasWritten(output == command.end() ? command.back() : *(output + 1))) << text;
    }
    return count;
  }

  ScratchFolder folder;
};

TEST_F(Pages, Patterns) { EXPECT_GE(Run("docs/patterns.md"), 19u); }

TEST_F(Pages, Bombing) { EXPECT_GE(Run("docs/bombing.md"), 2u); }

TEST_F(Pages, ByExample) { EXPECT_GE(Run("docs/by_example.md"), 3u); }

TEST_F(Pages, Rendering) { EXPECT_GE(Run("docs/rendering.md", "thing.glb"), 11u); }

}  // namespace
}  // namespace texgraph
