// SPDX-License-Identifier: Apache-2.0
// texgraph as a user runs it: outputs, messages, exit codes; and what it leaves alone when
// something fails.
#include "tests/unit/cli/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "cli/texgraph/help.h"
#include "compiler/textures/image.h"
#include "compiler/textures/srgb.h"
#include "tests/unit/base/scratch_folder.h"

namespace texgraph {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const char* const kGraph = R"({
  "texgraph": 1, "name": "plain",
  "parameters": {
    "tint": { "type": "vec4", "value": [1, 0.5, 0.25, 1], "binding": "uniform" },
    "level": { "type": "float", "value": 0.5, "range": [0, 1] }
  },
  "nodes": { "shade": { "block": "multiply", "in": { "a": "tint", "b": "level" } } },
  "outputs": { "color": "shade", "height": "level" }
})";

const char* const kManifest = R"({
  "texgraph_manifest": 1, "name": "made", "shader": "made.frag", "dialect": "glsl330", "emit": "shader",
  "entry_point": "main",
  "inputs": [{"name": "uv", "type": "vec2", "binding": "input"}, {"name": "time", "type": "float", "binding": "uniform"}],
  "outputs": [{"name": "color", "variable": "out_color", "type": "vec4", "location": 0}],
  "parameters": [
    {"name": "blue", "type": "float", "binding": "uniform", "status": "uniform", "value": 0.5, "range": [0, 1]},
    {"name": "rows", "type": "int", "binding": "constant", "status": "folded", "value": 12}],
  "textures": []
})";

const char* const kShader =
    "#version 330\nin vec2 uv; uniform float time; uniform float blue; layout(location = 0) out "
    "vec4 out_color;\n"
    "void main() { out_color = vec4(uv.x, time, blue, 1.0); }\n";

class TexgraphTest : public testing::Test {
 protected:
  TexgraphTest() {
    folder.Write("plain.json", kGraph);
    folder.Write("made.json", kManifest);
    folder.Write("made.frag", kShader);
  }

  Program Make(std::vector<std::string> arguments) const {
    Program program;
    program.path = TEXGRAPH_PROGRAM;
    program.arguments = std::move(arguments);
    program.folder = folder.path();
    return program;
  }
  Outcome Run(std::vector<std::string> arguments) const { return Make(std::move(arguments)).Run(); }

  textures::Image Picture(const std::string& name) const {
    Diagnostics diagnostics;
    auto image = textures::ReadImage(folder / name, {}, diagnostics);
    EXPECT_TRUE(image) << name;
    return image ? *image : textures::Image();
  }

  // Fails with that exit code and message, and an output that was there stays as it was.
  void ExpectFailure(const std::vector<std::string>& arguments, int exit_code,
                     const std::string& message) {
    folder.Write("old.png", "old");
    std::vector<std::string> all = {"render"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    all.insert(all.end(), {"-o", "old.png"});
    const Outcome outcome = Run(all);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr(message));
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(folder.Read("old.png"), "old");
  }

  static uint32_t Srgb(double linear) {
    return static_cast<uint32_t>(std::lround(255 * textures::SrgbEncode(linear)));
  }

  ScratchFolder folder;
};

TEST_F(TexgraphTest, DrawsAGraph) {
  const Outcome outcome = Run({"render", "plain.json", "-o", "a.png", "--size", "20x10"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("a.png: color of 20 x 10 pixels"),
                                   HasSubstr("EGL (surfaceless)"), HasSubstr("OpenGL 4.5")));
  const textures::Image image = Picture("a.png");
  EXPECT_EQ(image.width, 20u);
  EXPECT_EQ(image.height, 10u);
  EXPECT_EQ(image.channels, 4);
  EXPECT_EQ(image.At(3, 4, 0), Srgb(0.5));
  EXPECT_EQ(image.At(3, 4, 1), Srgb(0.25));
  EXPECT_EQ(image.At(3, 4, 2), Srgb(0.125));
  EXPECT_EQ(image.At(3, 4, 3), 128u);
  EXPECT_THAT(folder.Names(), ElementsAre("a.png", "made.frag", "made.json", "plain.json"));
}

TEST_F(TexgraphTest, ChoosesTheOutputAndSetsParameters) {
  const Outcome outcome =
      Run({"render", "plain.json", "-o", "h.png", "--size", "2", "--output", "height", "--set",
           "level=0.2", "--bits", "16", "-q", "--context", "osmesa", "--target", "glsl450"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  const textures::Image image = Picture("h.png");
  EXPECT_EQ(image.channels, 1);
  EXPECT_EQ(image.bits, 16);
  EXPECT_EQ(image.At(0, 0, 0), 13107u);  // 0.2 of 65535
}

TEST_F(TexgraphTest, DrawsAManifest) {
  const Outcome outcome = Run({"render", "made.json", "-o", "m.png", "--size", "4x2", "--uv",
                               "-1,0,1,1", "--time", "0.25", "--set", "blue=0.75"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const textures::Image image = Picture("m.png");
  EXPECT_EQ(image.At(0, 0, 0), 0u);
  EXPECT_EQ(image.At(2, 0, 0), Srgb(0.25));
  EXPECT_EQ(image.At(3, 0, 0), Srgb(0.75));
  EXPECT_EQ(image.At(0, 0, 1), Srgb(0.25));
  EXPECT_EQ(image.At(0, 0, 2), Srgb(0.75));
}

// What texgraphc writes is what texgraph reads, and both give one picture.
TEST_F(TexgraphTest, TheGraphAndItsShaderGiveOnePicture) {
  Program compile = Texgraphc({"plain.json", "-o", "out.frag"}, folder.path());
  ASSERT_EQ(compile.Run().exit_code, 0);
  ASSERT_EQ(Run({"render", "out.json", "-o", "1.png", "--size", "8"}).exit_code, 0);
  ASSERT_EQ(Run({"render", "plain.json", "-o", "2.png", "--size", "8"}).exit_code, 0);
  EXPECT_FALSE(folder.Read("1.png").empty());
  EXPECT_EQ(folder.Read("1.png"), folder.Read("2.png"));
}

TEST_F(TexgraphTest, RootHoldsImagesAndShadersIn) {
  std::filesystem::create_directory(folder / "in");
  std::filesystem::create_directory(folder / "else");
  auto write = [&](const std::string& name, std::string text, const std::string& from,
                   const std::string& to) {
    text.replace(text.find(from), from.size(), to);
    folder.Write(name, text);
  };
  const std::string textured =
      R"({"texgraph": 1, "textures": {"t": {"file": "PLACE"}}, "nodes": {"n": {"block": "image",
          "in": {"picture": "t"}}}, "outputs": {"color": "n"}})";
  std::filesystem::copy_file(TEXGRAPH_SOURCE_DIR "/tests/diagnostics/white.png",
                             folder / "else/white.png");
  write("in/graph.json", textured, "PLACE", "../else/white.png");
  write("in/made.json", kManifest, "made.frag", "../made.frag");
  ExpectFailure({"in/graph.json", "--root", "in"}, 1, "[outside-root]");
  ExpectFailure({"in/made.json", "--root", "in"}, 1, "[outside-root]");
  ExpectFailure({"in/made.json", "--root", "missing"}, 3, "[cannot-read]");
  write("in/textured.json", kManifest, "\"textures\": []",
        R"("textures": [{"name": "t", "type": "sampler2D", "status": "used", "variable": "t",
        "files": ["../else/white.png"], "color_space": "srgb", "filter": "linear",
        "wrap": ["clamp", "clamp"], "mipmaps": true}])");
  folder.Write("in/made.frag", kShader);
  ExpectFailure({"in/textured.json", "--root", "in"}, 1, "[outside-root]");
  for (const char* input : {"in/graph.json", "in/made.json"}) {
    EXPECT_EQ(Run({"render", input, "--root", ".", "-o", "a.png", "--size", "2"}).exit_code, 0);
  }
}

TEST_F(TexgraphTest, UsesStandardStreams) {
  Program program = Make({"render", "-", "-o", "-", "--size", "2"});
  program.input = kGraph;
  const Outcome outcome = program.Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.out.substr(0, 4), "\x89PNG");
}

TEST_F(TexgraphTest, PicturesOfTexturesLieBesideTheGraph) {
  textures::Image image;
  image.width = image.height = 2;
  image.channels = 3;
  image.pixels.assign(12, 128);
  mkdir((folder / "sub").c_str(), 0777);
  folder.Write("sub/grey.png", *textures::EncodePng(image));
  folder.Write("sub/g.json", R"({"texgraph": 1, "textures": {"grey": {"file": "grey.png"}},
    "nodes": {"i": {"block": "image", "in": {"picture": "grey"}}}, "outputs": {"color": "i"}})");
  const Outcome outcome = Run({"render", "sub/g.json", "-o", "t.png", "--size", "4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_NEAR(Picture("t.png").At(1, 1, 0), 128, 1);
  unlink((folder / "sub/grey.png").c_str());
  ExpectFailure({"sub/g.json"}, 3, "sub/g.json:1:");
}

TEST_F(TexgraphTest, HelpAndVersion) {
  EXPECT_THAT(Run({"--help"}).out, HasSubstr("usage: texgraph"));
  EXPECT_THAT(Run({"render", "--help"}).out, HasSubstr("usage: texgraph render"));
  EXPECT_THAT(Run({"--version"}).out, testing::StartsWith("texgraph "));
  EXPECT_EQ(Run({"--version"}).exit_code, 0);
}

TEST_F(TexgraphTest, HelpAndDocumentsNameTheSameOptions) {
  const std::string help(cli::kRenderHelp);
  std::ifstream file(TEXGRAPH_SOURCE_DIR "/docs/rendering.md");
  const std::string document((std::istreambuf_iterator<char>(file)), {});
  const std::regex option("--[a-z]+(-[a-z]+)*|-[a-zA-Z]\\b");
  const auto options = [&](const std::string& text, const std::string& from,
                           const std::string& to) {
    const size_t begin = text.find(from);
    const std::string part = text.substr(begin, text.find(to, begin) - begin);
    return std::set<std::string>(std::sregex_token_iterator(part.begin(), part.end(), option), {});
  };
  std::set<std::string> in_help = options(help, "Picture", "Exit codes");
  in_help.erase("--help");
  in_help.erase("-h");
  EXPECT_GT(in_help.size(), 10u);
  EXPECT_EQ(options(document, "| option |", "With a graph"), in_help);
}

TEST_F(TexgraphTest, SizesOutsideTheLimits) {
  for (const char* size :
       {"0", "-1", "65536", "16x0", "-1x-1", "65536x65536", "9223372036854775807"}) {
    ExpectFailure({"plain.json", "--size", size}, 4, "a picture has 1 to 65535 pixels each way");
  }
  ExpectFailure({"plain.json", "--size", "65535x65535"}, 4, "[size-limit]");
}

TEST_F(TexgraphTest, WrongCommandLines) {
  EXPECT_EQ(Run({}).exit_code, 2);
  EXPECT_THAT(Run({"rendr"}).error, HasSubstr("did you mean 'render'"));
  EXPECT_EQ(Run({"render", "plain.json"}).exit_code, 2);
  EXPECT_EQ(Run({"render", "-o", "a.png"}).exit_code, 2);
  ExpectFailure({"plain.json", "--sice", "4"}, 2, "did you mean '--size'");
  ExpectFailure({"plain.json", "made.json"}, 2, "one graph or manifest at a time");
  for (const char* size : {"big", "4x", "x4", "4x4x4", "4.5", ""}) {
    ExpectFailure({"plain.json", "--size", size}, 2, "--size takes WxH or N");
  }
  for (const char* window :
       {"0,0,1", "0,0,1,1,1", "a,b,c,d", "0,0,0,1", "nan,0,1,1", "0,0,inf,1", "0,0,1e9,1"}) {
    ExpectFailure({"plain.json", "--uv", window}, 2, "uv");
  }
  ExpectFailure({"plain.json", "--context", "glx"}, 2, "--context takes auto, egl or osmesa");
  ExpectFailure({"plain.json", "--target", "spirv"}, 2, "--target takes glsl330 or glsl450");
  ExpectFailure({"plain.json", "--bits", "12"}, 2, "--bits takes 8, 16 or 32");
  ExpectFailure({"plain.json", "--timeout", "0"}, 2, "the time limit");
  ExpectFailure({"plain.json", "--timeout", "soon"}, 2, "--timeout takes a number of seconds");
  ExpectFailure({"plain.json", "--time", "inf"}, 2, "the time is a finite number");
}

TEST_F(TexgraphTest, WrongInputs) {
  ExpectFailure({"missing.json"}, 3, "missing.json");
  ExpectFailure({"."}, 3, "[cannot-read]");
  folder.Write("broken.json", "{\"texgraph\": 1");
  ExpectFailure({"broken.json"}, 1, "broken.json:1:");
  folder.Write("broken.manifest.json", "{\"texgraph_manifest\": 1");
  ExpectFailure({"broken.manifest.json"}, 1, "broken.manifest.json:1:");
  ExpectFailure({"plain.json", "--output", "colour"}, 1, "the shader has no output 'colour'");
  ExpectFailure({"plain.json", "--set", "levl=1"}, 1, "did you mean 'level'");
  ExpectFailure({"made.json", "--set", "blu=1"}, 1, "did you mean 'blue'");
  ExpectFailure({"made.json", "--set", "blue=2"}, 1, "parameter 'blue' is from 0 to 1");
  ExpectFailure({"made.json", "--set", "blue=[1,2]"}, 1, "parameter 'blue' takes float");
  ExpectFailure({"made.json", "--set", "rows=3"}, 1, "parameter 'rows' is fixed in this shader");
  unlink((folder / "made.frag").c_str());
  ExpectFailure({"made.json"}, 3, "made.frag");
}

TEST_F(TexgraphTest, FunctionsAndModulesAreNotRendered) {
  for (const auto& [from, to] : {std::pair{"\"emit\": \"shader\"", "\"emit\": \"function\""},
                                 std::pair{"\"glsl330\"", "\"spirv\""}}) {
    std::string manifest = kManifest;
    manifest.replace(manifest.find(from), std::string(from).size(), to);
    folder.Write("other.json", manifest);
    ExpectFailure({"other.json"}, 1, "cannot be rendered");
  }
}

TEST_F(TexgraphTest, NeverWritesOverItsInputs) {
  for (const char* output : {"made.json", "made.frag", "./made.json"}) {
    const Outcome outcome = Run({"render", "made.json", "-o", output, "--format", "png"});
    EXPECT_EQ(outcome.exit_code, 2) << output;
    EXPECT_THAT(outcome.error, HasSubstr("it is one of the files that are read"));
  }
  EXPECT_EQ(folder.Read("made.frag"), kShader);
  ASSERT_EQ(symlink("made.json", (folder / "link").c_str()), 0);
  EXPECT_EQ(Run({"render", "made.json", "-o", "link"}).exit_code, 2);
  EXPECT_EQ(folder.Read("made.json"), kManifest);
}

TEST_F(TexgraphTest, UnwritablePlaces) {
  EXPECT_EQ(Run({"render", "made.json", "-o", "no/such/folder/a.png"}).exit_code, 3);
  mkdir((folder / "folder.png").c_str(), 0777);
  EXPECT_EQ(Run({"render", "made.json", "-o", "folder.png"}).exit_code, 3);
  EXPECT_EQ(Run({"render", "made.json", "-o", "/dev/full"}).exit_code, 3);
}

TEST_F(TexgraphTest, TheDriverRefusesTheShader) {
  folder.Write("made.frag",
               "#version 330\nout vec4 out_color;\nvoid main() { out_color = wrong; }\n");
  ExpectFailure({"made.json"}, 5, "[driver-compile]");
  EXPECT_THAT(folder.Read("old.failed.frag"), HasSubstr("out_color = wrong"));
  const Outcome outcome = Run({"render", "made.json", "-o", "old.png"});
  EXPECT_THAT(outcome.error,
              AllOf(HasSubstr("wrong"), HasSubstr("the shader was kept in 'old.failed.frag'")));
}

TEST_F(TexgraphTest, NoDriver) {
  Program program = Make({"render", "made.json", "-o", "a.png", "--context", "egl"});
  program.environment = {"LIBGL_DRIVERS_PATH=/no/such/folder"};
  const Outcome outcome = program.Run();
  EXPECT_EQ(outcome.exit_code, 5) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("[no-context]"));
  program.arguments.back() = "auto";
  const Outcome other = program.Run();
  EXPECT_EQ(other.exit_code, 0) << other.error;
  EXPECT_THAT(other.error,
              AllOf(HasSubstr("OSMesa"), HasSubstr("EGL without a window system gives")));
}

// A folder in which libEGL.so.1 is a driver that fails.
class FailingDriverProgramTest : public TexgraphTest {
 protected:
  Outcome RunWith(const char* driver, std::vector<std::string> arguments) {
    mkdir((folder / "lib").c_str(), 0777);
    EXPECT_EQ(symlink(driver, (folder / "lib/libEGL.so.1").c_str()), 0);
    Program program = Make(std::move(arguments));
    program.environment = {"LD_LIBRARY_PATH=" + (folder / "lib")};
    return program.Run();
  }
};

TEST_F(FailingDriverProgramTest, CrashIsExitCode5) {
  folder.Write("old.png", "old");
  const Outcome outcome = RunWith(CRASH_AT_OPENING_LIBRARY,
                                  {"render", "made.json", "-o", "old.png", "--context", "egl"});
  EXPECT_EQ(outcome.exit_code, 5) << outcome.error;
  EXPECT_THAT(outcome.error, AllOf(HasSubstr("[driver-failure]"), HasSubstr("SIGSEGV")));
  EXPECT_EQ(folder.Read("old.png"), "old");
}

TEST_F(FailingDriverProgramTest, HangIsExitCode5InTime) {
  const Outcome outcome =
      RunWith(HANG_AT_OPENING_LIBRARY,
              {"render", "made.json", "-o", "a.png", "--context", "egl", "--timeout", "0.5"});
  EXPECT_EQ(outcome.exit_code, 5) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("[time-limit]"));
  EXPECT_LT(outcome.seconds, 10);
}

TEST_F(TexgraphTest, WarnsOfNan) {
  folder.Write("made.frag",
               "#version 330\nuniform float time; out vec4 out_color;\nvoid main() { out_color = "
               "vec4(time / time); }\n");
  const Outcome outcome = Run({"render", "made.json", "-o", "nan.png", "--size", "3"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("9 of 9 pixels of output 'color' are NaN [nan-pixels]"));
}

TEST_F(TexgraphTest, SmallStacksWillDo) {
  Program program = Make({"render", "plain.json", "-o", "s.png", "--size", "8"});
  program.prepare = [] {
    const rlimit limit{256 << 10, 256 << 10};
    setrlimit(RLIMIT_STACK, &limit);
  };
  const Outcome outcome = program.Run();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
}

TEST_F(TexgraphTest, SameBytesInEveryLocale) {
  ASSERT_EQ(Run({"render", "made.json", "-o", "1.png", "--size", "16", "--time", "0.5"}).exit_code,
            0);
  Program program = Make({"render", "made.json", "-o", "2.png", "--size", "16", "--time", "0.5"});
  program.environment = {"LC_ALL=de_DE.UTF-8", "LANG=tr_TR.UTF-8"};
  ASSERT_EQ(program.Run().exit_code, 0);
  EXPECT_EQ(folder.Read("1.png"), folder.Read("2.png"));
}

}  // namespace
}  // namespace texgraph
