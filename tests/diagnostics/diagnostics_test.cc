// SPDX-License-Identifier: Apache-2.0
// Runs texgraphc on each case of this folder and compares what it says, to the byte. A case is a
// file NAME.expected:
//
//   $ texgraphc --set rows=x unknown_setting.json
//   exit 1
//   unknown_setting.json:...
//
// The command runs in this folder, its outputs go elsewhere, and a command that fails must write
// none. With TEXGRAPH_UPDATE=1 in the environment the expectation is written anew, after the
// command that the file has; every graph without a case gets one. Read the difference before it is
// committed.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

namespace fs = std::filesystem;

const fs::path kFolder = TEXGRAPH_SOURCE_DIR "/tests/diagnostics";
constexpr std::string_view kPrompt = "$ texgraphc ";

std::string ReadText(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream out;
  out << file.rdbuf();
  return out.str();
}

bool IsGraph(const fs::path& path) {
  static const std::set<std::string> kExtensions = {".json", ".jsonc", ".yaml", ".yml"};
  return kExtensions.contains(path.extension());
}

std::vector<std::string> Words(const std::string& line) {
  std::istringstream in(line);
  return {std::istream_iterator<std::string>(in), {}};
}

bool Updating() {
  const char* update = std::getenv("TEXGRAPH_UPDATE");
  return update != nullptr && *update != '\0' && std::string_view(update) != "0";
}

class Case : public testing::Test {
 public:
  explicit Case(fs::path path) : path_(std::move(path)) {}

  void TestBody() override {
    std::string expected = ReadText(path_), command = expected.substr(0, expected.find('\n'));
    ASSERT_TRUE(command.starts_with(kPrompt)) << path_;
    ScratchFolder scratch;
    std::vector<std::string> arguments = Words(command.substr(kPrompt.size()));
    arguments.insert(arguments.begin(), {"-o", scratch.path() + "/"});
    Program program = Texgraphc(arguments, kFolder);
    program.time_limit = 20;
    Outcome outcome = program.Run();
    EXPECT_FALSE(outcome.timed_out);
    if (outcome.exit_code != 0) {
      EXPECT_TRUE(scratch.Names().empty());
    }
    std::string seen =
        command + "\nexit " + std::to_string(outcome.exit_code) + "\n" + outcome.error;
    if (Updating()) {
      std::ofstream(path_, std::ios::binary) << seen;
    } else {
      EXPECT_EQ(seen, expected);
    }
  }

 private:
  fs::path path_;
};

bool RegisterCases() {
  std::set<fs::path> cases;
  for (const auto& entry : fs::directory_iterator(kFolder)) {
    fs::path path = entry.path();
    if (path.extension() == ".expected") cases.insert(path);
    fs::path expected = fs::path(path).replace_extension(".expected");
    if (!IsGraph(path) || fs::exists(expected)) continue;
    if (Updating()) std::ofstream(expected) << kPrompt << path.filename().string() << "\n";
    cases.insert(expected);
  }
  for (const fs::path& path : cases) {
    testing::RegisterTest("Diagnostics", path.stem().c_str(), nullptr, nullptr, __FILE__, __LINE__,
                          [path]() -> testing::Test* { return new Case(path); });
  }
  return true;
}

const bool registered = RegisterCases();

}  // namespace
}  // namespace texgraph
