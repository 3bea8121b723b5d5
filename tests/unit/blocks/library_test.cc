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
    ir::TypeId type = ValueType(module, port);
    if (ir::IsFloat(type) && bits) bits = Bits(1.0f);
    values.push_back(module.Intern(type, std::vector<uint32_t>(module.types.Words(type), bits)));
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

// A block that no test of tests/blocks names is one that nobody compared with anything.
TEST(EmbeddedLibrary, EveryBlockHasATest) {
  std::string tests;
  for (const fs::directory_entry& entry :
       fs::directory_iterator(TEXGRAPH_SOURCE_DIR "/tests/blocks")) {
    if (entry.path().extension() != ".cc") continue;
    std::ifstream stream(entry.path(), std::ios::binary);
    tests.append((std::istreambuf_iterator<char>(stream)), {});
  }
  for (const EmbeddedFile& file : EmbeddedFiles()) {
    if (file.name == "types") continue;
    std::string quoted = "\"" + std::string(file.name);
    EXPECT_TRUE(tests.find(quoted + "\"") != tests.npos ||
                tests.find(quoted + "\\\"") != tests.npos)
        << file.path;
  }
}

TEST(EmbeddedLibrary, EveryBlockAndPortIsDescribed) {
  TestLibrary test({}, true);
  for (std::string_view name : test.library.Names()) {
    const Block* block = test.library.Find(name);
    ASSERT_NE(block, nullptr) << name;
    EXPECT_NE(block->summary, "") << name;
    EXPECT_NE(block->family, "") << name;
    for (const Overload& overload : block->overloads) {
      for (const Port& port : overload.inputs) EXPECT_NE(port.help, "") << name << " " << port.name;
      if (overload.outputs.size() < 2) continue;
      for (const Port& port : overload.outputs)
        EXPECT_NE(port.help, "") << name << " " << port.name;
    }
  }
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

TEST(UserFolders, ShadowTheLibraryAndEachOther) {
  TemporaryFolder first, second;
  std::string own =
      first.Write("mine/deep/add.glsl", "float add(float a, float b) { return a - b; }\n");
  first.Write("twice.glsl", "float twice(float a) { return 2.0 * a; }\n");
  second.Write("twice.glsl", "float twice(float a) { return 3.0 * a; }\n");
  second.Write("mine/thrice.glsl", "float thrice(float a) { return 3.0 * a; }\n");
  second.Write("mine/not_asked_for.glsl", "float (");
  second.Write("mine/1abc.glsl", "float x() { return 1.0; }");
  second.Write("mine/notes.txt", "none");
  ir::Module module;
  Sources sources;
  Diagnostics diagnostics;
  Library library(module, sources, diagnostics, {first.path(), second.path()});
  EXPECT_TRUE(library.Exists("add"));
  EXPECT_TRUE(library.Exists("subtract"));
  EXPECT_TRUE(library.Exists("thrice"));
  EXPECT_FALSE(library.Exists("types"));
  EXPECT_FALSE(library.Exists("1abc"));
  EXPECT_FALSE(library.Exists("../twice"));
  EXPECT_EQ(library.Find("nothing"), nullptr);
  EXPECT_EQ(library.Find("types"), nullptr);
  EXPECT_THAT(library.FilesRead(), IsEmpty());
  const Block* add = library.Find("add");
  ASSERT_NE(add, nullptr);
  EXPECT_EQ(add->overloads.size(), 1u);
  EXPECT_EQ(add->path, "mine/deep/add.glsl");
  EXPECT_EQ(add->family, "mine/deep");
  EXPECT_EQ(sources.Name(add->range.source), own);
  ir::FunctionId twice =
      library.Function(*library.Find("twice"), library.Find("twice")->overloads[0], {});
  EXPECT_EQ(RunFunction(module, twice, {{Bits(1.0f)}})[0][0], Bits(2.0f));
  ASSERT_NE(library.Find("thrice"), nullptr);
  EXPECT_EQ(library.Find("thrice"), library.Find("thrice"));
  ASSERT_NE(library.Find("subtract"), nullptr);
  EXPECT_EQ(library.Find("subtract")->path, "math/subtract.glsl");
  EXPECT_THAT(library.FilesRead(),
              ElementsAre(own, first.path() + "/twice.glsl", second.path() + "/mine/thrice.glsl"));
  std::vector<std::string_view> names = library.Names();
  EXPECT_TRUE(std::ranges::is_sorted(names));
  EXPECT_EQ(std::ranges::count(names, "add"), 1);
  EXPECT_EQ(std::ranges::count(names, "types"), 0);
  EXPECT_EQ(std::ranges::count(names, "thrice"), 1);
  EXPECT_EQ(diagnostics.all().size(), 0u);
  // What is wrong is reported once.
  EXPECT_EQ(library.Find("not_asked_for"), nullptr);
  size_t errors = diagnostics.error_count();
  EXPECT_GT(errors, 0u);
  EXPECT_EQ(library.Find("not_asked_for"), nullptr);
  EXPECT_EQ(diagnostics.error_count(), errors);
}

// Links, pipes and folders with a block's name are not opened; neither is what is too large.
TEST(UserFolders, HoldPlainFilesOnly) {
  TemporaryFolder folder, elsewhere;
  std::string text = "float away(float a) { return a; }\n";
  fs::create_symlink(elsewhere.Write("away.glsl", text), folder.path() + "/away.glsl");
  fs::create_directory_symlink(elsewhere.path(), folder.path() + "/linked");
  fs::create_directory_symlink(folder.path(), folder.path() + "/loop");
  ASSERT_EQ(mkfifo((folder.path() + "/pipe.glsl").c_str(), 0600), 0);
  fs::create_directory(folder.path() + "/folder.glsl");
  folder.Write("large.glsl", "float large(float a) { return a; } //" + std::string(1 << 20, ' '));
  folder.Write("a/same.glsl", text);
  folder.Write("b/same.glsl", text);
  std::string deep = folder.path();
  for (int i = 0; i < 30; ++i) deep += "/d";
  fs::create_directories(deep);
  std::ofstream(deep + "/deep.glsl") << text;
  ir::Module module;
  Sources sources;
  Diagnostics diagnostics;
  Library library(module, sources, diagnostics, {folder.path()});
  for (std::string_view name : {"away", "pipe", "folder", "deep"}) {
    EXPECT_FALSE(library.Exists(name)) << name;
    EXPECT_EQ(library.Find(name), nullptr) << name;
  }
  EXPECT_EQ(diagnostics.all().size(), 0u);
  EXPECT_EQ(library.Find("large"), nullptr);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kSizeLimit);
  EXPECT_EQ(library.Find("same"), nullptr);
  ASSERT_EQ(diagnostics.all().size(), 2u);
  EXPECT_EQ(diagnostics.all()[1].kind, DiagnosticKind::kBlockName);
  EXPECT_THAT(diagnostics.all()[1].message,
              HasSubstr("block 'same' is in two files of one folder"));
}

TEST(UserFolders, ThatAreNotThereAreReported) {
  ir::Module module;
  Sources sources;
  Diagnostics diagnostics;
  Library library(module, sources, diagnostics, {"/no/such\x1b/folder"});
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].severity, Severity::kWarning);
  EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kCannotRead);
  EXPECT_THAT(diagnostics.all()[0].message, Not(HasSubstr("\x1b")));
  EXPECT_NE(library.Find("add"), nullptr);
}

}  // namespace
}  // namespace texgraph::blocks
