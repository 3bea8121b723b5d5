// SPDX-License-Identifier: Apache-2.0
// The embedded library as a whole, and the folders of a user's blocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "compiler/blocks/plain_glsl.h"
#include "compiler/ir/verify.h"
#include "tests/unit/blocks/block_testing.h"

namespace texgraph::blocks {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

// Template values for a port: its default, or the words of its enumeration, or a few plain ones.
std::vector<ir::ConstId> ValuesOf(ir::Module& module, const Port& port) {
  std::vector<ir::ConstId> values;
  if (port.default_value) values.push_back(port.default_value);
  for (const EnumWord& word : port.words) {
    uint32_t bits = static_cast<uint32_t>(word.value);
    values.push_back(module.Intern(port.type, {&bits, 1}));
  }
  if (!values.empty()) return values;
  for (uint32_t bits : {0u, 1u}) {
    if (ir::IsFloat(port.type) && bits) bits = Bits(1.0f);
    values.push_back(
        module.Intern(port.type, std::vector<uint32_t>(module.types.Words(port.type), bits)));
  }
  return values;
}

TEST(EmbeddedLibrary, ListsEveryFile) {
  std::set<std::string> there, listed;
  fs::path root = fs::path(TEXGRAPH_SOURCE_DIR) / "stdlib_blocks";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() == ".glsl") {
      there.insert(entry.path().lexically_relative(root).generic_string());
    }
  }
  for (const EmbeddedFile& file : EmbeddedFiles()) {
    listed.emplace(file.path);
    std::ifstream stream(root / file.path, std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(stream)), {});
    EXPECT_EQ(file.text, text) << file.path;
  }
  EXPECT_EQ(there, listed) << "stdlib_blocks/blocks.cmake lists the files of the library";
  EXPECT_TRUE(std::ranges::is_sorted(EmbeddedFiles(), {}, &EmbeddedFile::name));
}

// Every block, every overload, every value of every template port, in both ways of lowering.
TEST(EmbeddedLibrary, LowersEveryBlock) {
  for (bool fold : {true, false}) {
    TestLibrary test({}, fold);
    for (std::string_view name : test.library.Names()) {
      const Block* block = test.library.Find(name);
      ASSERT_NE(block, nullptr) << name << "\n" << test.Report();
      EXPECT_FALSE(block->summary.empty()) << name << " has no summary";
      for (const Overload& overload : block->overloads) {
        std::vector<std::vector<ir::ConstId>> choices;
        size_t most = 1;
        for (const Port& port : overload.inputs) {
          if (port.kind != PortKind::kTemplate) continue;
          choices.push_back(ValuesOf(test.module, port));
          most = std::max(most, choices.back().size());
        }
        for (size_t i = 0; i < most; ++i) {
          std::vector<ir::ConstId> values;
          for (const auto& choice : choices) values.push_back(choice[i % choice.size()]);
          EXPECT_TRUE(test.library.Function(*block, overload, values).valid()) << name << "\n"
                                                                               << test.Report();
        }
      }
    }
    EXPECT_EQ(test.Report(), "");
    EXPECT_EQ(ir::Verify(test.module), "");
  }
}

TEST(EmbeddedLibrary, IsPlainGlsl) {
  if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) {
    GTEST_SKIP() << "glslangValidator is not installed";
  }
  TestLibrary test({});
  TemporaryFolder folder;
  std::set<std::string> seen;
  // One run over all: a file's mistakes are listed behind its name.
  std::string command = "cd " + folder.path() + " && glslangValidator -t";
  for (std::string_view name : test.library.Names()) {
    const Block* block = test.library.Find(name);
    ASSERT_NE(block, nullptr) << test.Report();
    for (const Overload& overload : block->overloads) {
      std::string text = PlainGlsl(test.library, test.sources, *block, overload);
      // Many overloads of one block are one text.
      if (!seen.insert(text).second) continue;
      std::string file = std::string(name) + "_" + std::to_string(seen.size()) + ".frag";
      folder.Write(file, text);
      command += " " + file;
    }
  }
  EXPECT_GT(seen.size(), test.library.Names().size());
  if (std::system((command + " > log 2>&1").c_str()) == 0) return;
  std::ifstream log(folder.path() + "/log");
  ADD_FAILURE() << std::string((std::istreambuf_iterator<char>(log)), {});
}

}  // namespace
}  // namespace texgraph::blocks
