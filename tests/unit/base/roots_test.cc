// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/roots.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "tests/unit/base/scratch_folder.h"

namespace texgraph {
namespace {

namespace fs = std::filesystem;

class RootsTest : public testing::Test {
 protected:
  RootsTest() {
    fs::create_directories(folder / "in/deep");
    fs::create_directories(folder / "inside");
    folder.Write("in/a", "a");
    folder.Write("in/deep/b", "b");
    folder.Write("out", "secret");
    folder.Write("inside/c", "c");
  }
  Roots Make(const std::vector<std::string>& folders) { return Roots(folders, diagnostics); }

  ScratchFolder folder;
  Diagnostics diagnostics;
};

TEST_F(RootsTest, WithoutFoldersEverythingIsInside) {
  Roots roots;
  EXPECT_TRUE(roots.Contain("/etc/passwd"));
  EXPECT_TRUE(roots.Contain(folder / "nothing"));
  EXPECT_TRUE(roots.ContainFile(0));
}

TEST_F(RootsTest, PathsInsideAndOutside) {
  Roots roots = Make({folder / "in"});
  EXPECT_FALSE(diagnostics.HasErrors());
  EXPECT_TRUE(roots.Contain(folder / "in/a"));
  EXPECT_TRUE(roots.Contain(folder / "in/deep/../a"));
  EXPECT_TRUE(roots.Contain(folder / "in/nothing"));
  EXPECT_FALSE(roots.Contain(folder / "out"));
  EXPECT_FALSE(roots.Contain(folder / "nothing"));
  EXPECT_FALSE(roots.Contain(folder / "in/../out"));
  EXPECT_FALSE(roots.Contain(folder / "in/../nothing"));
  EXPECT_FALSE(roots.Contain(folder / "inside/c")) << "a name that only begins alike";
  EXPECT_FALSE(roots.Contain(std::string("in/a\0b", 6)));
}

TEST_F(RootsTest, LinksCountWhereTheyLead) {
  fs::create_symlink("../out", folder / "in/link");
  fs::create_symlink("deep/b", folder / "in/good");
  fs::create_directory_symlink("../inside", folder / "in/folder");
  fs::create_symlink("loop", folder / "in/loop");
  fs::create_symlink("in/a", folder / "way_in");
  fs::create_directory_symlink("in", folder / "alias");
  Roots roots = Make({folder / "alias"});
  EXPECT_FALSE(roots.Contain(folder / "in/link"));
  EXPECT_FALSE(roots.Contain(folder / "in/folder/c"));
  EXPECT_FALSE(roots.Contain(folder / "in/folder/nothing"));
  EXPECT_TRUE(roots.Contain(folder / "in/good"));
  EXPECT_TRUE(roots.Contain(folder / "in/loop"));  // opening it fails
  EXPECT_TRUE(roots.Contain(folder / "way_in"));
  EXPECT_TRUE(roots.Contain(folder / "alias/deep/b"));
}

TEST_F(RootsTest, OpenFilesCountWhereTheyAre) {
  Roots roots = Make({folder / "in", folder / "inside"});
  for (auto [name, inside] : {std::pair("in/a", true), {"inside/c", true}, {"out", false}}) {
    int descriptor = open((folder / name).c_str(), O_RDONLY);
    EXPECT_EQ(roots.ContainFile(descriptor), inside) << name;
    close(descriptor);
  }
}

TEST_F(RootsTest, AFolderThatIsNotThereIsAnErrorAndHoldsNothing) {
  for (const std::string& name : {folder / "missing", folder / "out", std::string()}) {
    Diagnostics errors;
    Roots roots({name}, errors);
    EXPECT_EQ(errors.error_count(), 1u);
    EXPECT_EQ(errors.all().front().kind, DiagnosticKind::kCannotRead);
    EXPECT_FALSE(roots.Contain(folder / "in/a"));
  }
}

TEST_F(RootsTest, TheRootHoldsEverything) { EXPECT_TRUE(Make({"/"}).Contain(folder / "out")); }

}  // namespace
}  // namespace texgraph
