// SPDX-License-Identifier: Apache-2.0
// texgraph as a user runs it for frames, sweeps, contact sheets and OpenEXR. The shader gives u,
// the time and a parameter, so that every number is known.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmath>

#include "compiler/textures/image.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"
#include "tests/unit/runtime/exr_reader.h"

namespace texgraph {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const char* const kManifest = R"({
  "texgraph_manifest": 1, "name": "made", "shader": "made.frag", "dialect": "glsl330", "emit": "shader",
  "entry_point": "main",
  "inputs": [{"name": "uv", "type": "vec2", "binding": "input"}, {"name": "time", "type": "float", "binding": "uniform"}],
  "outputs": [{"name": "color", "variable": "out_color", "type": "vec4", "location": 0},
              {"name": "height", "variable": "out_height", "type": "float", "location": 1}],
  "parameters": [
    {"name": "blue", "type": "float", "binding": "uniform", "status": "uniform", "value": 0.5, "range": [0, 1]},
    {"name": "steps", "type": "int", "binding": "uniform", "status": "uniform", "value": 1},
    {"name": "on", "type": "bool", "binding": "uniform", "status": "uniform", "value": true},
    {"name": "rows", "type": "int", "binding": "constant", "status": "folded", "value": 12, "range": [1, 20]}],
  "textures": []
})";

const char* const kShader =
    "#version 330\nin vec2 uv; uniform float time; uniform float blue; uniform int steps; uniform "
    "bool on;\n"
    "layout(location = 0) out vec4 out_color; layout(location = 1) out float out_height;\n"
    "void main() { out_color = vec4(uv.x, time, blue, on ? 1.0 : 0.5); out_height = float(steps); "
    "}\n";

class SequenceProgramTest : public testing::Test {
 protected:
  SequenceProgramTest() {
    folder.Write("made.json", kManifest);
    folder.Write("made.frag", kShader);
  }

  Program Make(std::vector<std::string> arguments) const {
    Program program;
    program.path = TEXGRAPH_PROGRAM;
    program.arguments = {"render", "made.json"};
    program.arguments.insert(program.arguments.end(), arguments.begin(), arguments.end());
    program.folder = folder.path();
    return program;
  }
  Outcome Run(std::vector<std::string> arguments) const { return Make(std::move(arguments)).Run(); }

  // Fails with that exit code and message, and nothing is new.
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

  // The first pixel of a plane ("ABGR") of a file.
  float First(const std::string& name, size_t plane) const {
    return runtime::ReadExr(folder.Read(name)).planes.at(plane)[0];
  }

  ScratchFolder folder;
};

TEST_F(SequenceProgramTest, SixteenBitsAreTheNearestStep) {
  ASSERT_EQ(Run({"-o", "a.png", "--bits", "16", "--size", "64x1"}).exit_code, 0);
  const textures::Image image = Picture("a.png");
  ASSERT_EQ(image.bits, 16);
  for (uint32_t x = 0; x < 64; ++x) {
    const double linear = (x + 0.5) / 64;
    const double encoded =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    EXPECT_NEAR(image.At(x, 0, 0) / 65535.0, encoded, 0.51 / 65535) << x;
  }
  ASSERT_EQ(Run({"-o", "h.png", "--output", "height", "--bits", "16", "--size", "1"}).exit_code, 0);
  EXPECT_EQ(Picture("h.png").At(0, 0, 0), 65535u);
}

TEST_F(SequenceProgramTest, ExrHoldsTheShadersNumbers) {
  const Outcome outcome = Run({"-o", "a.EXR", "--bits", "32", "--size", "64x3", "--uv", "-1,0,1,1",
                               "--time", "7.1", "--set", "blue=0.3", "--set", "on=false"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const runtime::ExrFile exr = runtime::ReadExr(folder.Read("a.EXR"));
  EXPECT_EQ(exr.type, Imf::FLOAT);
  ASSERT_EQ(exr.channels, "ABGR");
  ASSERT_EQ(exr.width, 64);
  ASSERT_EQ(exr.height, 3);
  for (size_t i = 0; i < 64 * 3; ++i) {
    ASSERT_EQ(exr.planes[3][i], -1 + (static_cast<float>(i % 64) + 0.5f) / 32);  // below 0 too
    ASSERT_EQ(exr.planes[2][i], 7.1f);
    ASSERT_EQ(exr.planes[1][i], 0.3f);
    ASSERT_EQ(exr.planes[0][i], 0.5f);  // not multiplied in
  }
}

TEST_F(SequenceProgramTest, ExrIsHalfUnlessToldOtherwise) {
  const Outcome outcome = Run(
      {"-o", "-", "--format", "exr", "--output", "height", "--set", "steps=2049", "--size", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const runtime::ExrFile exr = runtime::ReadExr(outcome.out);
  EXPECT_EQ(exr.type, Imf::HALF);
  EXPECT_EQ(exr.channels, "Y");
  EXPECT_EQ(exr.planes[0], std::vector<float>(4, 2048));  // 2049 lies between two halves
}

TEST_F(SequenceProgramTest, FramesOfATimeRange) {
  const Outcome outcome = Run({"-o", "t.exr", "--frames", "4", "--time", "-1,1", "--size", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(folder.Names(), ElementsAre("made.frag", "made.json", "t.0001.exr", "t.0002.exr",
                                          "t.0003.exr", "t.0004.exr"));
  EXPECT_EQ(First("t.0001.exr", 2), -1);
  EXPECT_EQ(First("t.0002.exr", 2), -0.5);
  EXPECT_EQ(First("t.0003.exr", 2), 0);
  EXPECT_EQ(First("t.0004.exr", 2), 0.5);
  EXPECT_THAT(outcome.error, HasSubstr("t.0001.exr to t.0004.exr: color, 4 frames,"));
}

TEST_F(SequenceProgramTest, MoreFramesThanOneProcessDraws) {
  const Outcome outcome =
      Run({"-o", "m.exr", "--bits", "32", "--frames", "130", "--sweep", "blue", "--size", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  for (int i = 0; i < 130; ++i) {
    char name[16];
    snprintf(name, sizeof name, "m.%04d.exr", i + 1);
    EXPECT_EQ(First(name, 1), static_cast<float>(i / 129.0));
  }
}

TEST_F(SequenceProgramTest, Sweeps) {
  ASSERT_EQ(Run({"-o", "s.exr", "--frames", "3", "--sweep", "blue", "--size", "1"}).exit_code, 0);
  EXPECT_EQ(First("s.0001.exr", 1), 0);
  EXPECT_EQ(First("s.0002.exr", 1), 0.5);
  EXPECT_EQ(First("s.0003.exr", 1), 1);
  ASSERT_EQ(
      Run({"-o", "s.exr", "--frames", "2", "--sweep", "blue=0.75,0.25", "--size", "1"}).exit_code,
      0);
  EXPECT_EQ(First("s.0001.exr", 1), 0.75);
  EXPECT_EQ(First("s.0002.exr", 1), 0.25);
  ASSERT_EQ(Run({"-o", "i.exr", "--output", "height", "--frames", "4", "--sweep", "steps=0,2",
                 "--size", "1"})
                .exit_code,
            0);
  EXPECT_EQ(First("i.0002.exr", 0), 1);  // 2/3, rounded
  EXPECT_EQ(First("i.0004.exr", 0), 2);
  ASSERT_EQ(
      Run({"-o", "one.exr", "--frames", "1", "--sweep", "blue=0.25,1", "--size", "1"}).exit_code,
      0);
  EXPECT_EQ(First("one.0001.exr", 1), 0.25);
}

TEST_F(SequenceProgramTest, SweepsThatCannotBe) {
  const auto fails = [&](const char* sweep, int exit_code, const char* message) {
    ExpectFailure({"-o", "s.png", "--frames", "3", "--sweep", sweep}, exit_code, message);
  };
  fails("rows", 1, "'rows' is no uniform of this shader (folded), so it cannot be swept");
  fails("bleu", 1, "no parameter 'bleu'; did you mean 'blue'?");
  fails("on=0,1", 1, "'on' is a bool");
  fails("steps", 2, "'steps' has no range; --sweep steps=A,B gives one");
  fails("blue=0,2", 1, "'blue' is from 0 to 1");
  fails("blue=nan,1", 1, "'blue' is from 0 to 1");
  fails("steps=0,1e10", 1, "[value-range]");
  fails("blue=0", 2, "--sweep takes NAME or NAME=A,B");
  fails("blue=0,1,2", 2, "--sweep takes NAME or NAME=A,B");
  fails("=0,1", 2, "--sweep takes NAME or NAME=A,B");
}

TEST_F(SequenceProgramTest, OptionsThatDoNotFit) {
  ExpectFailure({"-o", "a.tga"}, 2, "'a.tga': pictures are .png or .exr files");
  ExpectFailure({"-o", "a.png", "--format", "tga"}, 2, "--format takes png or exr");
  ExpectFailure({"-o", "a.exr", "--bits", "8"}, 2, "OpenEXR files have 16 or 32 bits");
  ExpectFailure({"-o", "a.png", "--bits", "32"}, 2, "PNG files have 8 or 16 bits");
  ExpectFailure({"-o", "a.png", "--bits", "12"}, 2, "--bits takes 8, 16 or 32");
  ExpectFailure({"-o", "a.png", "--frames", "3"}, 2, "says what differs");
  ExpectFailure({"-o", "a.png", "--sweep", "blue"}, 2, "--sweep needs --frames N");
  ExpectFailure({"-o", "a.png", "--time", "0,1"}, 2, "--time T0,T1 needs --frames N");
  ExpectFailure({"-o", "a.png", "--time", "0,"}, 2, "--time takes T or T0,T1");
  ExpectFailure({"-o", "a.png", "--time", "0,inf", "--frames", "2"}, 2, "finite");
  ExpectFailure({"-o", "-", "--time", "0,1", "--frames", "3"}, 2, "standard output is none");
  ExpectFailure({"-o", "a.png", "--contact-sheet", "--output", "color"}, 2, "takes no --output");
  for (const char* frames : {"0", "-1", "10000", "9223372036854775807"}) {
    ExpectFailure({"-o", "a.png", "--time", "0,1", "--frames", frames}, 4,
                  "1 to 9999 frames can be drawn");
  }
  ExpectFailure({"-o", "a.png", "--time", "0,1", "--frames", "3.5"}, 2, "--frames takes a number");
}

TEST_F(SequenceProgramTest, AllFramesOrNone) {
  folder.Write("f.0001.png", "old");
  ASSERT_EQ(mkdir((folder / "f.0003.png").c_str(), 0777), 0);
  ExpectFailure({"-o", "f.png", "--time", "0,1", "--frames", "4", "--size", "4"}, 3,
                "cannot write 'f.0003.png': it is a folder");
  EXPECT_EQ(folder.Read("f.0001.png"), "old");
  ExpectFailure({"-o", "no/such/f.exr", "--time", "0,1", "--frames", "4", "--size", "4"}, 3,
                "[cannot-write]");
  ExpectFailure({"-o", "/dev/full", "--format", "exr"}, 3, "[cannot-write]");
}

TEST_F(SequenceProgramTest, ASignalLeavesNothing) {
  Program program = Make({});
  program.path = "/bin/sh";
  // Waits until frames are being drawn; there is nothing to see of them but temporary files.
  program.arguments = {"-c", TEXGRAPH_PROGRAM
                       " render made.json -o f.png --time 0,1 --frames 9999 --size 64 & child=$!\n"
                       "for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20; do\n"
                       "  ls -A | grep -q tmp && break; sleep 0.1\n"
                       "done\n"
                       "ls -A | grep -q tmp && echo drawing; kill -TERM $child; wait $child"};
  const Outcome outcome = program.Run();
  EXPECT_EQ(outcome.out, "drawing\n");
  EXPECT_EQ(outcome.exit_code, 143);
  EXPECT_THAT(folder.Names(), ElementsAre("made.frag", "made.json"));
}

TEST_F(SequenceProgramTest, FramesNeverReplaceInputs) {
  folder.Write("in.0002.json", kManifest);
  Program program = Make({"-o", "in.json", "--format", "png", "--time", "0,1", "--frames", "3"});
  program.arguments[1] = "in.0002.json";
  const Outcome outcome = program.Run();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, HasSubstr("'in.0002.json': it is one of the files that are read"));
  EXPECT_THAT(folder.Names(), ElementsAre("in.0002.json", "made.frag", "made.json"));
}

TEST_F(SequenceProgramTest, NanFramesAreOneWarning) {
  folder.Write("made.frag",
               "#version 330\nuniform float time; layout(location = 0) out vec4 out_color;\n"
               "void main() { out_color = vec4(time / time); }\n");
  const Outcome outcome =
      Run({"-o", "n.exr", "--time", "0,0", "--frames", "5", "--size", "2", "--output", "color"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("4 of 4 pixels of output 'color' are NaN"));
  EXPECT_THAT(outcome.error, HasSubstr("5 of 5 frames have NaN pixels"));
  EXPECT_TRUE(std::isnan(First("n.0005.exr", 3)));
}

TEST_F(SequenceProgramTest, ContactSheetOfASweep) {
  const Outcome outcome = Run({"-o", "c.png", "--contact-sheet", "--sweep", "blue", "--frames", "3",
                               "--size", "8x6", "--bits", "16"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const textures::Image sheet = Picture("c.png");
  ASSERT_EQ(sheet.width, 20u);
  ASSERT_EQ(sheet.height, 16u);
  EXPECT_EQ(sheet.At(0, 0, 2), 0u);
  EXPECT_NEAR(sheet.At(12, 0, 2), 65535 * (1.055 * std::pow(0.5, 1 / 2.4) - 0.055), 1);
  EXPECT_EQ(sheet.At(0, 10, 2), 65535u);
  EXPECT_EQ(sheet.At(8, 10, 2), 0u);  // the gap
  EXPECT_EQ(sheet.At(8, 10, 3), 65535u);
  EXPECT_EQ(sheet.At(12, 10, 2), 0u);  // no fourth cell
  ASSERT_EQ(Run({"-o", "c.exr", "--contact-sheet", "--sweep", "blue", "--size", "8"}).exit_code, 0);
  const runtime::ExrFile exr = runtime::ReadExr(folder.Read("c.exr"));
  ASSERT_EQ(exr.width, 32);  // 9 cells unless told otherwise
  EXPECT_EQ(exr.planes[1][0], 0);
  EXPECT_EQ(exr.planes[1][12], 0.125);
  EXPECT_EQ(exr.planes[1][12 * 32], 0.375);
  EXPECT_EQ(exr.planes[1][31 * 32 + 31], 1);
}

TEST_F(SequenceProgramTest, ContactSheetOfAllOutputs) {
  const Outcome outcome =
      Run({"-o", "c.png", "--contact-sheet", "--size", "8", "--set", "steps=1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("c.png: color, height in 2 columns and 1 rows"));
  const textures::Image sheet = Picture("c.png");
  ASSERT_EQ(sheet.width, 20u);
  ASSERT_EQ(sheet.height, 8u);
  ASSERT_EQ(sheet.channels, 4);
  for (uint32_t c = 0; c < 4; ++c) EXPECT_EQ(sheet.At(12, 3, c), 255u);
  EXPECT_EQ(sheet.At(3, 3, 1), 0u);
  ExpectFailure({"-o", "d.png", "--contact-sheet", "--size", "40000"}, 4,
                "a contact sheet of 2 x 1");
}

// What a terminal gets while three frames are drawn.
std::string OnTerminal(Program program, const char* term) {
  const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
  EXPECT_EQ(grantpt(terminal), 0);
  EXPECT_EQ(unlockpt(terminal), 0);
  // Open here too, so that what was written stays readable when the program has ended.
  const int end = open(ptsname(terminal), O_RDWR | O_NOCTTY);
  program.environment = {std::string("TERM=") + term};
  program.prepare = [end] { dup2(end, STDERR_FILENO); };
  EXPECT_EQ(program.Run().exit_code, 0);
  fcntl(terminal, F_SETFL, O_NONBLOCK);
  std::string text;
  char buffer[4096];
  for (ssize_t got; (got = read(terminal, buffer, sizeof buffer)) > 0;)
    text.append(buffer, static_cast<size_t>(got));
  close(end);
  close(terminal);
  return text;
}

TEST_F(SequenceProgramTest, ProgressOnTerminalsOnly) {
  const std::vector<std::string> frames = {"-o",       "p.png", "--time", "0,1",
                                           "--frames", "3",     "--size", "4"};
  const std::string shown = OnTerminal(Make(frames), "xterm");
  EXPECT_THAT(shown, HasSubstr("\r[..............................] 0 of 3 frames\x1b[K"));
  EXPECT_THAT(shown, HasSubstr("\r[##############################] 3 of 3 frames\x1b[K\r\x1b[K"));
  EXPECT_THAT(shown, HasSubstr("\x1b[Kp.0001.png to p.0003.png"));
  EXPECT_THAT(OnTerminal(Make(frames), "dumb"), Not(HasSubstr("\x1b")));
  EXPECT_THAT(OnTerminal(Make({"-o", "p.png", "--size", "4"}), "xterm"), Not(HasSubstr("\x1b")));
  std::vector<std::string> quiet = frames;
  quiet.push_back("-q");
  EXPECT_EQ(OnTerminal(Make(quiet), "xterm"), "");
  EXPECT_THAT(Run(frames).error, Not(HasSubstr("\x1b")));
}

}  // namespace
}  // namespace texgraph
