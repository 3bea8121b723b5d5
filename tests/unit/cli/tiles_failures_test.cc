// SPDX-License-Identifier: Apache-2.0
// texgraph tiles where something is wrong: it says what, ends with the right code, and no file has
// changed.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/unit/cli/tiles_testing.h"

namespace texgraph {
namespace {

using testing::HasSubstr;

class TilesFailures : public TilesCommand {
 protected:
  TilesFailures() { folder.Write("old.png", "old"); }

  // Runs with a small set, so that what is wrong is only what is given.
  void ExpectFailure(std::vector<std::string> arguments, int exit_code, const std::string& message,
                     const std::function<void()>& prepare = {}) {
    arguments.insert(arguments.begin(), {"--tile-size", "8", "--candidates", "8"});
    const std::vector<std::string> before = folder.Names();
    Program program = Make(arguments);
    program.prepare = prepare;
    const Outcome outcome = program.Run();
    EXPECT_EQ(outcome.exit_code, exit_code) << message << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.Names(), before);
    EXPECT_EQ(folder.Read("old.png"), "old");
  }
};

TEST_F(TilesFailures, WrongCommandLines) {
  ExpectFailure({}, 2, "no map given");
  ExpectFailure({"grass.png", "--tile-sice", "8"}, 2, "did you mean '--tile-size'");
  ExpectFailure({"grass.png", "--corners", "3", "--edges", "2,2"}, 2, "one of them is made");
  for (const char* corners : {"two", "2,2", "-2"})
    ExpectFailure({"grass.png", "--corners", corners}, 2, "--corners takes 2 to 4");
  for (const char* edges : {"2", "2,", "2,2,2", "a,b", "-1,2"})
    ExpectFailure({"grass.png", "--edges", edges}, 2, "--edges takes H,V");
  for (const char* seed : {"-1", "4294967296", "0.5", "x"})
    ExpectFailure({"grass.png", "--seed", seed}, 2, "--seed takes a whole number");
  for (const char* weights : {"0", "-1", "nan", "inf", "1e10", "1,", "x"})
    ExpectFailure({"grass.png", "--weights", weights}, 2, "--weights takes numbers");
  ExpectFailure({"grass.png", "--corners", ""}, 2, "--corners needs a value");
  ExpectFailure({"grass.png", "--weights", "1,1"}, 2, "--weights has 2 for 1 maps");
  ExpectFailure({"grass.png", "--corner-pack"}, 2, "--corner-pack needs --edges");
  ExpectFailure({"grass.png", "--tiling-size", "4"}, 2, "--tiling-size needs --tiling");
  for (const char* size : {"0", "4x0", "4x", "x4", "-4", "4,4"}) {
    ExpectFailure({"grass.png", "--tiling", "t.png", "--tiling-size", size}, 2,
                  "--tiling-size takes CxR");
  }
  ExpectFailure({"grass.png", "-o", "a.jpg"}, 2, "tiles are written to .png files");
  ExpectFailure({"grass.png", "height.png", "-o", "a.png"}, 2, "-o names 1 of the 2 packs");
  ExpectFailure({"grass.png", "--color", "green"}, 2, "'texgraph tiles --help' lists the options");
}

TEST_F(TilesFailures, OutputsThatAreInputsOrEachOther) {
  folder.Write("set.tiles.png", folder.Read("grass.png"));
  ASSERT_EQ(symlink("grass.png", (folder / "link.png").c_str()), 0);
  const std::string grass = folder.Read("grass.png");
  for (const char* output : {"grass.png", "./grass.png", "link.png"}) {
    ExpectFailure({"grass.png", "-o", output}, 2, "it is one of the files that are read");
    ExpectFailure({"grass.png", "--view", output}, 2, "it is one of the files that are read");
  }
  ExpectFailure({"set.tiles.png", "grass.png", "-o", "a.png", "-o", "set.tiles.png"}, 2,
                "it is one of the files that are read");
  ExpectFailure({"grass.png", "--json", "grass.png"}, 2, "it is one of the files that are read");
  EXPECT_EQ(folder.Read("grass.png"), grass);
  ExpectFailure({"grass.png", "--view", "a.png", "--tiling", "a.png"}, 2,
                "two outputs would be written to 'a.png'");
  ExpectFailure({"grass.png", "grass.png"}, 2, "two outputs would be written");
  ExpectFailure(
      {"grass.png", "--edges", "2,2", "--corner-pack", "-o", "a.png", "--view", "a.corners.png"}, 2,
      "two outputs would be written");
  ExpectFailure({"grass.png", "-o", "-", "--report"}, 2, "two outputs go to standard output");
  ExpectFailure({"grass.png", "-o", "-", "--edges", "2,2", "--corner-pack"}, 2,
                "--corner-pack writes beside the pack");
}

TEST_F(TilesFailures, WrongMaps) {
  ExpectFailure({"missing.png", "-o", "old.png"}, 3, "[missing-file]");
  ExpectFailure({"grass.png", "missing.png"}, 3, "missing.png");
  ExpectFailure({".", "-o", "old.png"}, 3, "[cannot-read]");
  ASSERT_EQ(mkfifo((folder / "pipe.png").c_str(), 0600), 0);
  ExpectFailure({"pipe.png", "-o", "old.png"}, 3, "[cannot-read]");
  const std::string grass = folder.Read("grass.png");
  folder.Write("cut.png", grass.substr(0, grass.size() / 2));
  folder.Write("text.png", "{}");
  ExpectFailure({"cut.png", "-o", "old.png"}, 1, "[bad-image]");
  ExpectFailure({"text.png", "-o", "old.png"}, 1, "[bad-image]");
  folder.Write("small.png", *textures::EncodePng(textures::test::StrokesImage(43, 40, 3, 8, 1)));
  ExpectFailure({"grass.png", "small.png"}, 1, "differ in size: 44 x 40 and 43 x 40");
  ExpectFailure({"grass.png", "--tile-size", "21", "-o", "old.png"}, 1,
                "tiles of 20 texels would do");
}

TEST_F(TilesFailures, Limits) {
  ExpectFailure({"grass.png", "--corners", "5", "-o", "old.png"}, 4, "5 corner colours");
  ExpectFailure({"grass.png", "--corners", "1"}, 4, "2 to 4 are possible");
  ExpectFailure({"grass.png", "--edges", "0,2"}, 4, "1 to 4 of each are possible");
  ExpectFailure({"grass.png", "--edges", "2,4294967295"}, 4, "[size-limit]");
  ExpectFailure({"grass.png", "--tile-size", "3"}, 4, "[size-limit]");
  ExpectFailure({"grass.png", "--tile-size", "0", "--tiling", "t.png"}, 4, "[size-limit]");
  ExpectFailure({"grass.png", "--tile-size", "4294967295"}, 4, "[size-limit]");
  // Three packs of 4 x 4 tiles of 1183 pixels are more than 2^26 pixels.
  ExpectFailure({"grass.png", "grass.png", "grass.png", "--tile-size", "1183", "-o", "a.png", "-o",
                 "b.png", "-o", "c.png"},
                4, "4 to 1182 are possible where a pack has 16 tiles and there are 3 packs");
  ExpectFailure({"grass.png", "--candidates", "7"}, 4, "8 to 1024 are possible");
  ExpectFailure({"grass.png", "--candidates", "1025"}, 4, "8 to 1024 are possible");
  // 1025 x 1024 tiles of 64 pixels are more than 2^26 pixels.
  ExpectFailure({"grass.png", "--tiling", "t.png", "--tiling-size", "1025x1024"}, 4,
                "a tiling of 1025 x 1024 tiles");
  ExpectFailure({"grass.png", "--tiling", "t.png", "--tiling-size", "4294967295"}, 4,
                "[size-limit]");
}

// The pack is staged before the last output fails.
TEST_F(TilesFailures, PlacesThatCannotBeWritten) {
  ASSERT_EQ(mkdir((folder / "sub").c_str(), 0700), 0);
  for (const char* output : {"no/such.png", "sub", "/dev/full"}) {
    ExpectFailure({"grass.png", "-o", output}, 3, "[cannot-write]");
    ExpectFailure({"grass.png", "-o", "old.png", "--view", output}, 3, "[cannot-write]");
    ExpectFailure({"grass.png", "-o", "old.png", "--json", output}, 3, "[cannot-write]");
  }
  const auto full = [] { dup2(open("/dev/full", O_WRONLY), STDOUT_FILENO); };
  ExpectFailure({"grass.png", "-o", "old.png", "--report"}, 3, "standard output", full);
}

}  // namespace
}  // namespace texgraph
