// SPDX-License-Identifier: Apache-2.0
// Promise P4 and the file names of HOSTILE.md: what a stranger's graph may make texgraphc read.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

namespace fs = std::filesystem;

class HostileFiles : public testing::Test {
 protected:
  HostileFiles() {
    for (const char* name : {"graphs", "graphs/sub", "private", "out"})
      fs::create_directory(folder / name);
    for (const char* name : {"graphs/a.png", "graphs/sub/b.png", "private/c.png"})
      fs::copy_file(TEXGRAPH_SOURCE_DIR "/tests/diagnostics/white.png", folder / name);
    fs::create_symlink("../private/c.png", folder / "graphs/link.png");
    fs::create_directory_symlink("../private", folder / "graphs/door");
    fs::create_symlink("loop.png", folder / "graphs/loop.png");
    fs::create_symlink("sub/b.png", folder / "graphs/good.png");
  }

  Outcome Run(const std::string& image, std::vector<std::string> options = {"--root", "graphs"}) {
    return RunTexture("\"file\": \"" + image + "\"", std::move(options));
  }

  Outcome RunTexture(const std::string& texture,
                     std::vector<std::string> options = {"--root", "graphs"}) {
    folder.Write("graphs/g.json",
                 "{ \"texgraph\": 1, \"textures\": { \"t\": { " + texture +
                     " } }, \"nodes\": { \"n\": { \"block\": \"image\", \"in\": { \"picture\": "
                     "\"t\" } } }, \"outputs\": { \"color\": \"n\" } }");
    fs::remove_all(folder / "out");
    fs::create_directory(folder / "out");
    options.insert(options.end(), {"graphs/g.json", "-o", "out/x.frag"});
    Outcome outcome = Texgraphc(options, folder.path()).Run();
    EXPECT_EQ(fs::is_empty(folder / "out"), outcome.exit_code != 0);
    return outcome;
  }

  void ExpectOutside(const std::string& image) {
    Outcome outcome = Run(image);
    EXPECT_EQ(outcome.exit_code, 1) << image << outcome.error;
    EXPECT_THAT(outcome.error, testing::HasSubstr("[outside-root]")) << image;
    EXPECT_THAT(outcome.error, testing::StartsWith("graphs/g.json:1:")) << image;
  }

  ScratchFolder folder;
};

TEST_F(HostileFiles, RootHoldsImagesIn) {
  for (const char* image : {"a.png", "./sub/../a.png", "sub/b.png", "good.png"})
    EXPECT_EQ(Run(image).exit_code, 0) << image;
  EXPECT_EQ(Run(folder / "graphs/a.png").exit_code, 0);
  for (const char* image :
       {"../private/c.png", "sub/../../private/c.png", "/etc/passwd", "link.png", "door/c.png",
        "../../../../../../../../etc/passwd", "../private/nothing.png", "door/nothing.png"}) {
    ExpectOutside(image);
  }
  ExpectOutside(folder / "private/c.png");
}

TEST_F(HostileFiles, RootHoldsMasksIn) {
  EXPECT_EQ(RunTexture(R"("file": "a.png", "mask": "sub/b.png")").exit_code, 0);
  for (const char* mask : {"../private/c.png", "link.png", "door/c.png"}) {
    Outcome outcome = RunTexture(std::string(R"("file": "a.png", "mask": ")") + mask + "\"");
    EXPECT_EQ(outcome.exit_code, 1) << mask << outcome.error;
    EXPECT_THAT(outcome.error, testing::HasSubstr("[outside-root]")) << mask;
  }
}

// What is left of white without white, and of a picture cut off behind its header.
TEST_F(HostileFiles, PicturesThatLeaveNothingAndBrokenOnes) {
  Outcome outcome = RunTexture(R"("file": "a.png", "key": { "color": [1, 1, 1] })");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, testing::HasSubstr("warning: nothing is left of image"));
  const std::string whole = folder.Read("graphs/a.png");
  for (size_t size = 0; size < whole.size(); size += 7) {
    folder.Write("graphs/cut.png", whole.substr(0, size));
    for (const char* texture :
         {R"("file": "cut.png", "key": {})", R"("file": "a.png", "mask": "cut.png")"}) {
      outcome = RunTexture(texture);
      EXPECT_EQ(outcome.exit_code, 1) << size << outcome.error;
      EXPECT_THAT(outcome.error, testing::HasSubstr("[bad-image]"));
    }
  }
}

TEST_F(HostileFiles, SeveralRootsAndNone) {
  EXPECT_EQ(Run("../private/c.png", {"--root", "graphs", "--root=private"}).exit_code, 0);
  EXPECT_EQ(Run("../private/c.png", {}).exit_code, 0);
  Outcome outcome = Run("a.png", {"--root", "missing"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, testing::HasSubstr("[cannot-read]"));
}

TEST_F(HostileFiles, NamesAreNamesAndNothingElse) {
  for (const char* image :
       {"file://a.png", "http://example.com/a.png", "data:image/png;base64,AAAA", "`touch X`.png",
        "$(touch X).png", "~/a.png", "%2e%2e/private/c.png", "nothing.png"}) {
    Outcome outcome = Run(image);
    EXPECT_EQ(outcome.exit_code, 3) << image;
    EXPECT_THAT(outcome.error, testing::HasSubstr("[missing-file]")) << image;
    EXPECT_FALSE(fs::exists(folder / "X") || fs::exists(folder / "graphs/X"));
  }
  Outcome loop = Run("loop.png");
  EXPECT_EQ(loop.exit_code, 3);
  EXPECT_THAT(loop.error, testing::HasSubstr("[cannot-read]"));
}

}  // namespace
}  // namespace texgraph
