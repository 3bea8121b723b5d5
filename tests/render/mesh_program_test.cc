// SPDX-License-Identifier: Apache-2.0
// texgraph render --mesh as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "compiler/textures/image.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"
#include "tests/unit/runtime/exr_reader.h"
#include "tests/unit/runtime/glb_file.h"

namespace texgraph {
namespace {

using testing::HasSubstr;

// Something of each kind of output, a parameter and the time.
const char* const kGraph = R"({
  "texgraph": 1,
  "parameters": { "shine": { "type": "float", "value": 0.5, "range": [0, 1], "binding": "uniform" } },
  "nodes": {
    "squares": { "block": "checker", "in": { "scale": 4 } },
    "glow": { "block": "combine3", "in": { "x": "time" } }
  },
  "outputs": { "color": [0.8, 0.4, 0.2, 1], "roughness": "shine", "metallic": 0, "height": "squares", "emission": "glow" }
})";

class MeshProgramTest : public testing::Test {
 protected:
  MeshProgramTest() {
    folder.Write("g.json", kGraph);
    folder.Write("a.glb", runtime::GlbFile(runtime::TriangleJson(), runtime::TriangleBinary()));
  }

  Outcome Run(std::vector<std::string> arguments) const {
    Program program;
    program.path = TEXGRAPH_PROGRAM;
    program.arguments = {"render", "g.json", "--size", "32"};
    program.arguments.insert(program.arguments.end(), arguments.begin(), arguments.end());
    program.folder = folder.path();
    return program.Run();
  }

  void ExpectSuccess(std::vector<std::string> arguments) const {
    const Outcome outcome = Run(std::move(arguments));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  }

  void ExpectFailure(const std::vector<std::string>& arguments, int exit_code,
                     const std::string& message) {
    const std::vector<std::string> before = folder.Names();
    const Outcome outcome = Run(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr(message));
    EXPECT_EQ(folder.Names(), before);
  }

  textures::Image Picture(const std::string& name) const {
    Diagnostics diagnostics;
    auto image = textures::ReadImage(folder / name, {}, diagnostics);
    EXPECT_TRUE(image) << name;
    return image ? *image : textures::Image();
  }

  ScratchFolder folder;
};

TEST_F(MeshProgramTest, DrawsEveryShapeAndAFile) {
  for (const char* mesh : {"plane", "wall", "sphere", "cube", "cylinder", "a.glb"}) {
    const Outcome outcome = Run({"--mesh", mesh, "-o", "a.png"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr("lit of 32 x 32 pixels"));
    const textures::Image image = Picture("a.png");
    EXPECT_EQ(image.channels, 3);
    // Orange in the middle, grey in the corner.
    EXPECT_GT(image.At(16, 16, 0), image.At(16, 16, 2) + 30u) << mesh;
    EXPECT_NEAR(image.At(0, 0, 0), image.At(0, 0, 2), 4) << mesh;
  }
}

// Frame i of a turntable is the picture from i / N of the way round, and what would follow the last
// is the first.
TEST_F(MeshProgramTest, ATurntableGoesOnceAround) {
  const std::vector<std::string> cube = {"--mesh", "cube", "-q"};
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), cube.begin(), cube.end());
    ExpectSuccess(more);
  };
  run({"--turntable", "--frames", "4", "--camera", "20,15,7", "-o", "t.png"});
  for (int i = 0; i <= 4; ++i) {
    run({"--camera", std::to_string(20 + 90 * i) + ",15,7", "-o", "s.png"});
    const std::string frame = "t.000" + std::to_string(i % 4 + 1) + ".png";
    const textures::Image a = Picture(frame);
    const textures::Image b = Picture("s.png");
    ASSERT_EQ(a.pixels.size(), b.pixels.size());
    for (size_t p = 0; p < a.pixels.size(); ++p) ASSERT_NEAR(a.pixels[p], b.pixels[p], 1) << i;
  }
  EXPECT_NE(folder.Read("t.0001.png"), folder.Read("t.0002.png"));
}

// The time and a parameter vary while the camera turns.
TEST_F(MeshProgramTest, FramesOfEveryKindGoTogether) {
  ExpectSuccess({"--mesh", "wall", "--turntable", "--time", "0,4", "--sweep", "shine", "--frames",
                 "2", "-o", "f.exr", "--bits", "32", "--output", "emission"});
  const runtime::ExrFile first = runtime::ReadExr(folder.Read("f.0001.exr"));
  const runtime::ExrFile second = runtime::ReadExr(folder.Read("f.0002.exr"));
  ASSERT_EQ(first.channels, "BGR");
  EXPECT_EQ(first.planes[2][16 * 32 + 16], 0);
  EXPECT_EQ(second.planes[2][16 * 32 + 16], 2);
  ExpectSuccess({"--mesh", "wall", "--turntable", "--contact-sheet", "-o", "sheet.png"});
  EXPECT_EQ(Picture("sheet.png").width, 3 * 32u + 2 * 4);
}

TEST_F(MeshProgramTest, AContactSheetHasTheLitMeshAndAllOutputs) {
  const Outcome outcome =
      Run({"--mesh", "sphere", "--contact-sheet", "-o", "sheet.png", "--background", "none"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("lit, color, roughness, metallic, height, emission"));
  EXPECT_EQ(Picture("sheet.png").width, 3 * 32u + 2 * 4);
}

TEST_F(MeshProgramTest, SixteenBitsAndAlpha) {
  ExpectSuccess({"--mesh", "cube", "--bits", "16", "--background", "none", "-o", "a.png"});
  const textures::Image image = Picture("a.png");
  EXPECT_EQ(image.bits, 16);
  EXPECT_EQ(image.channels, 4);
  EXPECT_EQ(image.At(0, 0, 3), 0u);
  EXPECT_EQ(image.At(16, 16, 3), 65535u);
}

// With the output of texgraphc --emit=function, as with the graph itself.
TEST_F(MeshProgramTest, TakesTheManifestOfAFunction) {
  ASSERT_EQ(Texgraphc({"g.json", "--emit=function", "-o", "f.glsl"}, folder.path()).Run().exit_code,
            0);
  ASSERT_EQ(Texgraphc({"g.json", "-o", "w.frag"}, folder.path()).Run().exit_code, 0);
  Program program;
  program.path = TEXGRAPH_PROGRAM;
  program.folder = folder.path();
  program.arguments = {"render", "f.json", "--size", "32", "--mesh", "cube", "-o", "a.png"};
  const Outcome outcome = program.Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  ExpectSuccess({"--mesh", "cube", "-o", "b.png"});
  EXPECT_EQ(folder.Read("a.png"), folder.Read("b.png"));
  program.arguments[1] = "w.json";
  const Outcome refused = program.Run();
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_THAT(refused.error, HasSubstr("a whole shader cannot be put on a mesh"));
}

// A graph that is called like one of its uniforms: the function has another name then.
TEST_F(MeshProgramTest, TakesAGraphThatIsCalledLikeItsParameter) {
  folder.Write("shine.json", kGraph);
  Program program;
  program.path = TEXGRAPH_PROGRAM;
  program.folder = folder.path();
  program.arguments = {"render", "shine.json", "--size", "32", "--mesh", "cube", "-o", "a.png"};
  const Outcome outcome = program.Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  ExpectSuccess({"--mesh", "cube", "-o", "b.png"});
  EXPECT_EQ(folder.Read("a.png"), folder.Read("b.png"));
}

TEST_F(MeshProgramTest, SaysWhatIsWrongWithAMesh) {
  folder.Write("bad.glb", "not a mesh");
  folder.Write("empty.glb", "");
  ExpectFailure({"--mesh", "bad.glb", "-o", "a.png"}, 1,
                "'bad.glb' is no binary glTF file (.glb) [bad-mesh]");
  ExpectFailure({"--mesh", "empty.glb", "-o", "a.png"}, 1, "[bad-mesh]");
  ExpectFailure({"--mesh", "none.glb", "-o", "a.png"}, 3, "[cannot-read]");
  ExpectFailure({"--mesh", "/", "-o", "a.png"}, 3, "[cannot-read]");
  ExpectFailure({"--mesh", "", "-o", "a.png"}, 2, "--mesh takes a shape");
  ExpectFailure({"--mesh", "spere", "-o", "a.png"}, 2, "did you mean 'sphere'?");
  ExpectFailure({"--mesh", "a.glb", "-o", "a.glb", "--format", "png"}, 2, "cannot write 'a.glb'");
}

TEST_F(MeshProgramTest, ChecksItsOptions) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"--camera", "10"},   {"--camera", "10,91"}, {"--camera", "10,20,0"}, {"--camera", "1,2,3,4"},
      {"--camera", "a,b"},  {"--fov", "0"},        {"--fov", "151"},        {"--light", "10"},
      {"--light", "0,nan"}, {"--tile", "0"},       {"--tile", "1,2,3"},     {"--tile", "-1"},
      {"--samples", "3"},   {"--samples", "256"},  {"--background", "red"}, {"--background", "#12"},
      {"--relief", "a"},    {"--relief", "1e9"}};
  for (const auto& [option, value] : wrong)
    ExpectFailure({"--mesh", "cube", option, value, "-o", "a.png"}, 2, option + " takes");
  for (const char* option :
       {"--camera", "--fov", "--light", "--tile", "--relief", "--samples", "--background"})
    ExpectFailure({option, "1", "-o", "a.png"}, 2, std::string(option) + " needs --mesh");
  ExpectFailure({"--turntable", "--frames", "3", "-o", "a.png"}, 2, "--turntable needs --mesh");
  ExpectFailure({"--mesh", "cube", "--turntable", "-o", "a.png"}, 2,
                "--turntable needs --frames N");
  ExpectFailure({"--mesh", "cube", "--uv", "0,0,2,2", "-o", "a.png"}, 2, "--uv draws no mesh");
}

}  // namespace
}  // namespace texgraph
