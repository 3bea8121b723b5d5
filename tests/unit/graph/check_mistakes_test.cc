// SPDX-License-Identifier: Apache-2.0
// What CheckGraph says about graphs that are wrong: every kind of mistake, with its place.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/unit/graph/check_testing.h"

namespace texgraph::graph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Mistake {
  std::string text;
  std::vector<std::string> places;  // notes in blocks: the place in the block's file
  std::string message;
  std::string outputs = "\"height\": 0";
};

void ExpectMistakes(const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes) {
    CheckText check(mistake.text, mistake.outputs);
    EXPECT_FALSE(check.checked) << mistake.text;
    EXPECT_EQ(check.Places(), mistake.places) << mistake.text << "\n" << check.Messages();
    EXPECT_THAT(check.Messages(), HasSubstr(mistake.message)) << mistake.text;
  }
}

// A graph whose second line is the ports of the node "n".
std::string Ports(std::string_view block, std::string_view ports) {
  return fmt::format(
      "\n\"textures\": {{\"brick\": {{\"file\": \"b\"}}, \"stack\": {{\"layers\": [\"b\"]}}}},"
      "\"parameters\": {{\"rows\": {{\"type\": \"int\", \"value\": 4}},\n"
      "\"live\": {{\"type\": \"float\", \"value\": 3, \"binding\": \"uniform\"}},\n"
      "\"late\": {{\"type\": \"int\", \"value\": 3, \"binding\": \"specialization\"}}}},\n"
      "\"functions\": {{\"fun\": {{\"inputs\": {{\"a\": \"ivec2\"}}, \"outputs\": {{\"o\": "
      "1.5}}}},\n"
      "\"odd\": {{\"inputs\": {{\"uv\": \"float\"}}, \"outputs\": {{\"o\": 1.5, \"p\": 1}}}}}},\n"
      "\"nodes\": {{\"f\": {{\"block\": \"t_one\"}}, \"grid\": {{\"block\": \"t_grid\"}},"
      "\"c\": {{\"block\": \"t_image\", \"in\": {{\"picture\": \"brick\"}}}},\n"
      "\"n\": {{\"block\": \"{}\", \"in\": {{\n{}}}}}}}",
      block, ports);
}

TEST(CheckMistakes, UnknownBlocksAndPorts) {
  ExpectMistakes({
      {Ports("t_onn", ""), {"9:16 unknown-block"}, "no block 't_onn'; did you mean 't_one'?"},
      {Ports("funn", ""), {"9:16 unknown-block"}, "no block 'funn'; did you mean 'fun'?"},
      {Ports("../t_one", ""), {"9:16 unknown-block"}, "no block '../t_one'"},
      {Ports("", ""), {"9:16 unknown-block"}, "no block ''"},
      {Ports("t_pick", "\"moed\": 1"), {"10:1 unknown-port"}, "did you mean 'mode'?"},
      {Ports("t_grid", "\"mask\": 1"),
       {"10:1 unknown-port"},
       "block 't_grid' has no port 'mask'; that is an output"},
      {Ports("t_gen", "\"a\": 1, \"c\": 1"),
       {"10:9 unknown-port"},
       "block 't_gen' has no port 'c'; it has 'a' and 'b'"},
      {Ports("fun", "\"a\": [1, 2], \"x\": 1"),
       {"10:14 unknown-port"},
       "function 'fun' has no port 'x'; it has "},
  });
}

TEST(CheckMistakes, BrokenBlocksAreReportedOnce) {
  CheckText check(R"("nodes": { "a": { "block": "t_broken" }, "b": { "block": "t_broken" },
      "c": { "block": "t_one", "in": { "x": "a" } } })");
  EXPECT_FALSE(check.checked);
  EXPECT_EQ(check.diagnostics.error_count(), 1u) << check.Messages();
  EXPECT_THAT(check.Messages(), HasSubstr("'floot'"));
}

TEST(CheckMistakes, ReferencesToNothing) {
  ExpectMistakes({
      {Ports("t_one", "\"x\": \"grit\""),
       {"10:6 unknown-reference"},
       "nothing is called 'grit' here; did you mean 'grid'?"},
      {Ports("t_one", "\"x\": \"grid\""),
       {"10:6 unknown-reference"},
       "node 'grid' has several outputs; write 'grid.tile' or 'grid.mask'"},
      {Ports("t_one", "\"x\": \"grid.mast\""),
       {"10:6 unknown-reference"},
       "node 'grid' has no output 'mast'; did you mean 'mask'?"},
      {Ports("t_one", "\"x\": \"f.output\""),
       {"10:6 unknown-reference"},
       "node 'f' has no output 'output'; write 'f'"},
      {Ports("t_one", "\"x\": \"uv.x\""),
       {"10:6 unknown-reference"},
       "built-in input 'uv' has no output 'x'; the block 'separate' gives single components"},
      {Ports("t_one", "\"x\": \"rows.y\""), {"10:6 unknown-reference"}, "parameter 'rows'"},
      {Ports("t_one", "\"x\": \"grid.tile.local\""),
       {"10:6 unknown-reference"},
       "a graph cannot reach the members of a struct; connect 'grid.tile'"},
      {Ports("t_one", "\"x\": \"t_need\""),
       {"10:6 unknown-reference"},
       "nothing is called 't_need' here; the block 't_need' needs a node"},
      {Ports("t_one", "\"x\": \"\""), {"10:6 unknown-reference"}, "nothing is called ''"},
      {Ports("t_one", "\"x\": \".\""), {"10:6 unknown-reference"}, "nothing is called ''"},
      {Ports("t_one", "\"x\": \"f.\""), {"10:6 unknown-reference"}, "has no output ''"},
      {Ports("t_warp", "\"image\": \"odd\""),
       {"10:10 unknown-reference"},
       "function 'odd' has several outputs; write 'odd.o' or 'odd.p'"},
      {Ports("t_image", "\"picture\": \"brik\""),
       {"10:12 unknown-reference"},
       "did you mean 'brick'?"},
      {Ports("t_one", "\"x\": \"\\u001b]0;\\u202e\""), {"10:6 unknown-reference"}, "\\x1b"},
      {"\"nodes\": {\"out\": 1}", {"2:18 graph-shape"}, ""},
      {"\"functions\": {\"g\": {\"outputs\": {\"o\": \"n\"}}}, \"nodes\": {\"n\": {\"block\": "
       "\"t_one\"}}",
       {"2:38 unknown-reference"},
       "node 'n' is outside of function 'g', which could have an input for it"},
  });
}

// What is text for YAML's core schema, but numbers and bools for other loaders.
TEST(CheckMistakes, NumbersAndBoolsInQuotes) {
  ExpectMistakes({
      {Ports("t_one", "\"x\": \"010\""),
       {"10:6 unknown-reference"},
       "nothing is called '010' here; numbers are decimal"},
      {Ports("t_one", "\"x\": \"yes\""),
       {"10:6 unknown-reference"},
       "nothing is called 'yes' here; write true"},
      {"\"parameters\": {\"p\": {\"type\": \"int\", \"value\": \"010\"}}",
       {"2:46 bad-value"},
       "parameter 'p' takes int, got the text '010'; numbers are decimal"},
      {"\"parameters\": {\"p\": {\"type\": \"bool\", \"value\": \"yes\"}}",
       {"2:47 bad-value"},
       "parameter 'p' takes bool, got the text 'yes'; write true"},
      {"\"parameters\": {\"p\": {\"type\": \"bool\", \"value\": \"off\"}}",
       {"2:47 bad-value"},
       "write false"},
      {"\"parameters\": {\"p\": {\"type\": \"bool\", \"value\": 1}}",
       {"2:47 bad-value"},
       "parameter 'p' takes bool, got 1; write true or false"},
  });
}

TEST(CheckMistakes, TypesThatDoNotFit) {
  ExpectMistakes({
      {Ports("t_one", "\"x\": \"uv\""),
       {"10:6 port-type (3:19)"},
       "port 'x' of node 'n' takes float, got vec2; the blocks 'magnitude' and 'dot_product' "
       "convert"},
      {Ports("t_one", "\"x\": \"c\""),
       {"10:6 port-type (3:19)"},
       "takes float, got vec4; the blocks 'channel' and 'luminance' convert"},
      {Ports("t_one", "\"x\": [1, 2]"), {"10:6 port-type (3:19)"}, "takes float, got 2 numbers"},
      {Ports("t_one", "\"x\": true"), {"10:6 port-type (3:19)"}, "takes float, got true"},
      {Ports("t_one", "\"x\": \"brick\""),
       {"10:6 port-type (3:19)"},
       "takes float, got the texture 'brick'; a node with the block 'image' reads it"},
      {Ports("t_one", "\"x\": \"fun\""),
       {"10:6 port-type (3:19)"},
       "got the function 'fun'; make a node with \"block\": \"fun\""},
      {Ports("t_cell", "\"tile\": 3"), {"10:9 port-type (3:19)"}, "takes Tile, got 3"},
      {Ports("t_cell", "\"tile\": \"f\""), {"10:9 port-type (3:19)"}, "takes Tile, got float"},
      {Ports("t_one", "\"x\": \"grid.tile\""),
       {"10:6 port-type (3:19)"},
       "got Tile; the blocks 'tile_random' and 'tile_distance' convert"},
      {Ports("t_whole", "\"v\": [1, 2.5]"),
       {"10:6 port-type (5:21)"},
       "takes ivec2, got 2 numbers with fractions"},
      {Ports("t_whole", "\"v\": [1, 2, 3]"), {"10:6 port-type (5:21)"}, "got 3 numbers"},
      {Ports("t_whole", "\"v\": \"uv\""), {"10:6 port-type (5:21)"}, "takes ivec2, got vec2"},
      {Ports("t_whole", "\"u\": \"rows\""), {"10:6 port-type (5:29)"}, "takes uint, got int"},
      {Ports("t_whole", "\"u\": 1.0"), {"10:6 port-type (5:29)"}, "takes uint, got 1.0"},
      {Ports("t_whole", "\"b\": 1"), {"10:6 port-type (5:37)"}, "takes bool, got 1; write true"},
      {Ports("t_count", "\"n\": 1.5"), {"10:6 port-type (3:25)"}, "takes int, got 1.5"},
      {Ports("fun", "\"a\": \"uv\""), {"10:6 port-type (6:34)"}, "takes ivec2, got vec2"},
  });
}

TEST(CheckMistakes, TexturePorts) {
  ExpectMistakes({
      {Ports("t_image", "\"picture\": \"stack\""),
       {"10:12 port-type (4:24)"},
       "takes a texture with one \"file\", but 'stack' has \"layers\""},
      {Ports("t_layers", "\"picture\": \"brick\", \"where\": \"normal\""),
       {"10:12 port-type (4:30)"},
       "takes a texture with \"layers\", but 'brick' has one \"file\""},
      {Ports("t_image", "\"picture\": 3"), {"10:12 port-type (4:24)"}, "takes a texture, got 3"},
      {Ports("t_image", "\"picture\": \"c\""),
       {"10:12 port-type (4:24)"},
       "takes a texture, got the node 'c'"},
  });
}

TEST(CheckMistakes, FunctionPorts) {
  ExpectMistakes({
      {Ports("t_warp", "\"image\": \"uv\""),
       {"10:10 port-type (4:6)"},
       "takes field(vec2) -> vec4, got vec2; the block 'combine4' converts"},
      {Ports("t_slope", "\"height\": \"c\""),
       {"10:11 port-type (4:7)"},
       "takes field(vec2, float) -> float, got vec4; the blocks 'channel'"},
      {Ports("t_slope", "\"height\": \"brick\""), {"10:11 port-type (4:7)"}, "got vec4"},
      {Ports("t_warp", "\"image\": \"stack\""),
       {"10:10 port-type (4:6)"},
       "the texture 'stack' is a function of vec3"},
      {Ports("t_warp", "\"image\": [1, 2]"), {"10:10 port-type (4:6)"}, "takes vec4, got 2"},
      {Ports("t_warp", "\"image\": \"fun\""),
       {"10:10 missing-input (6:34) (4:6)"},
       "function 'fun' needs 'a', which port 'image' of node 'n' does not give"},
      {Ports("t_warp", "\"image\": \"odd.o\""),
       {"10:10 port-type (7:20) (4:6)"},
       "port 'image' of node 'n' gives 'uv' as vec2, but function 'odd' takes float"},
      {Ports("t_warp", ""),
       {"9:1 missing-input (4:6)"},
       "port 'image' of node 'n' is not connected"},
  });
}

TEST(CheckMistakes, MissingInputs) {
  ExpectMistakes({
      {Ports("t_need", ""),
       {"9:1 missing-input (3:20)"},
       "port 'x' of node 'n' is not connected and has no default"},
      {Ports("fun", ""), {"9:1 missing-input (6:34)"}, "port 'a' of node 'n' is not connected"},
      {Ports("t_gen", "\"a\": 1"), {"9:1 missing-input (4:34)"}, "port 'b' of node 'n'"},
  });
}

TEST(CheckMistakes, TemplatePortsNeedConstants) {
  ExpectMistakes({
      {Ports("t_count", "\"n\": \"f\""),
       {"10:6 not-constant (3:25)"},
       "port 'n' of node 'n' must be known when the shader is made; 'f' is a node"},
      {Ports("t_count", "\"n\": \"live\""),
       {"10:6 not-constant (4:1) (3:25)"},
       "parameter 'live' is a uniform"},
      {Ports("t_count", "\"n\": \"late\""),
       {"10:6 not-constant (5:1) (3:25)"},
       "parameter 'late' is a specialization constant"},
      {Ports("t_count", "\"n\": \"time\""), {"10:6 not-constant (3:25)"}, "'time' is a built-in"},
      {Ports("t_pick", "\"mode\": \"addd\""),
       {"10:9 unknown-reference (6:33)"},
       "port 'mode' of node 'n' takes 'mix' or 'add', got 'addd'; did you mean 'add'?"},
      {Ports("t_count", "\"n\": \"rowz\""), {"10:6 unknown-reference"}, "did you mean 'rows'?"},
      {Ports("t_pick", "\"mode\": \"rows\""),
       {"10:9 value-range (6:33)"},
       "takes 'mix' or 'add', got 4"},
      {Ports("t_pick", "\"mode\": 1"), {"10:9 value-range (6:33)"}, "takes 'mix' or 'add', got 1"},
  });
}

TEST(CheckMistakes, ValuesOutOfRange) {
  ExpectMistakes({
      {Ports("t_one", "\"x\": 10.5"),
       {"10:6 value-range (3:19)"},
       "port 'x' of node 'n' takes values from 0 to 10, got 10.5"},
      {Ports("t_one", "\"x\": -1"), {"10:6 value-range (3:19)"}, "from 0 to 10, got -1"},
      {Ports("t_count", "\"n\": 9"), {"10:6 value-range (3:25)"}, "from 1 to 8, got 9"},
      {Ports("t_one", "\"x\": 1e39"), {"10:6 number-range (3:19)"}, "takes float; 1e+39 is out"},
      {Ports("t_whole", "\"v\": [1, 2147483648]"),
       {"10:6 number-range (5:21)"},
       "takes ivec2; 2147483648 is out of its range"},
      {Ports("t_count", "\"n\": 9223372036854775808"), {"10:6 number-range (3:25)"}, "out of its"},
      {Ports("t_whole", "\"u\": -1"), {"10:6 number-range (5:29)"}, "takes uint; -1 is out"},
      {Ports("t_whole", "\"u\": 4294967296"), {"10:6 number-range (5:29)"}, "takes uint"},
      {"\"parameters\": {\"p\": {\"type\": \"int\", \"value\": 7, \"range\": [1, 6]}}",
       {"2:46 value-range"},
       "parameter 'p' takes values from 1 to 6, got 7"},
      {"\"parameters\": {\"p\": {\"type\": \"vec2\", \"value\": [0.1, 2], \"range\": [0.1, 1]}}",
       {"2:47 value-range"},
       "from 0.1 to 1, got 2"},
  });
}

TEST(CheckMistakes, MinimumAboveMaximum) {
  ExpectMistakes({
      {Ports("t_limits", "\"low\": [0, 0.7],\n\"high\": [0.4, 0.5]"),
       {"11:9 value-range (10:8) (7:30)"},
       "port 'high' of node 'n' must not be below port 'low', but 0.5 is below 0.7 in y"},
      // Against a default the caret is at what the graph says.
      {Ports("t_limits", "\"low\": [0, 3]"),
       {"10:8 value-range (7:30) (7:20)"},
       "port 'low' of node 'n' must not be above port 'high', but 3 is above 1 in y"},
      {Ports("t_limits", "\"high\": -0.5"),
       {"10:9 value-range (7:20) (7:30)"},
       "must not be below port 'low', but -0.5 is below 0 in x"},
      {Ports("t_limits", "\"size\": [2, 1]"),
       {"10:9 value-range (7:41)"},
       "port 'size' of node 'n' takes its least value first, got 2 before 1"},
      // Whole numbers are signed here, and parameters count as their value.
      {Ports("t_limits", "\"last\": -4"), {"10:9 value-range (7:57) (7:68)"}, "but -4 is below -3"},
      {Ports("t_limits", "\"first\": \"rows\", \"last\": -3"),
       {"10:26 value-range (10:10) (7:68)"},
       "but -3 is below 4"},
  });
  for (const char* ports : {"\"low\": 0.5, \"high\": 0.5, \"size\": [-2, -2], \"last\": -3",
                            "\"size\": 2", "\"low\": 1", "\"last\": -2",
                            // Known only while the shader runs.
                            "\"low\": [5, 5], \"high\": \"live\""}) {
    CheckText check(Ports("t_limits", ports));
    EXPECT_TRUE(check.checked) << ports << "\n" << check.Messages();
  }
}

TEST(CheckMistakes, MinimumAboveMaximumBySetting) {
  const char* text =
      "\"parameters\": {\"a\": {\"type\": \"float\", \"value\": 0.25}},\n"
      "\"nodes\": {\"n\": {\"block\": \"t_limits\", \"in\": {\"low\": \"a\", \"high\": 0.5}}}";
  CheckText good(text);
  EXPECT_TRUE(good.checked) << good.Messages();
  CheckText bad(text, "\"height\": 0", {"a=0.75"});
  EXPECT_FALSE(bad.checked);
  EXPECT_THAT(bad.Messages(), HasSubstr("0.5 is below 0.75 in x"));
}

TEST(CheckMistakes, SmallFloatsBecomeZeroWithAWarning) {
  CheckText check(R"("nodes": {"n": {"block": "t_one", "in": {"x": 1e-50}}})", "\"height\": \"n\"");
  EXPECT_EQ(check.NodeText("n"), "x=0.0:float");
  EXPECT_THAT(check.Places(), ElementsAre("warning: 2:47 number-underflow"));
  CheckText denormal(R"("nodes": {"n": {"block": "t_one", "in": {"x": 1e-40}}})",
                     "\"height\": \"n\"");
  EXPECT_EQ(denormal.NodeText("n"), "x=1e-40:float");
  EXPECT_THAT(denormal.Places(), IsEmpty());
}

TEST(CheckMistakes, OverloadsThatDoNotFit) {
  ExpectMistakes({
      {Ports("t_gen", "\"a\": \"position\", \"b\": \"uv\""),
       {"9:16 no-overload (4:23) (4:23) (4:23) (4:23)"},
       "no overload of block 't_gen' takes a: vec3, b: vec2; the block 'xy' converts"},
      {Ports("t_gen", "\"a\": \"grid.tile\", \"b\": 1"),
       {"10:6 port-type (4:23)"},
       "port 'a' of node 'n' takes float, vec2, vec3 or vec4, got Tile"},
      {Ports("t_gen", "\"a\": \"brick\", \"b\": 1"),
       {"10:6 port-type (4:23)"},
       "got the texture 'brick'"},
      {Ports("t_gen", "\"a\": true, \"b\": 1"), {"10:6 port-type (4:23)"}, "got true"},
      {Ports("t_gen", "\"a\": \"brik\", \"b\": \"uw\""),
       {"10:6 unknown-reference", "10:19 unknown-reference"},
       "nothing is called 'brik'"},
  });
}

TEST(CheckMistakes, Circles) {
  ExpectMistakes({
      {"\"nodes\": {\"a\": {\"block\": \"t_one\", \"in\": {\"x\": \"a\"}}}",
       {"2:47 cycle"},
       "node 'a' needs its own output"},
      {"\"nodes\": {\"a\": {\"block\": \"t_one\", \"in\": {\"x\": \"b\"}},\n"
       "\"b\": {\"block\": \"t_one\", \"in\": {\"x\": \"c\"}},\n"
       "\"c\": {\"block\": \"t_one\", \"in\": {\"x\": \"a\"}},\n"
       "\"d\": {\"block\": \"t_one\", \"in\": {\"x\": \"a\"}}}",
       {"2:47 cycle (3:37) (4:37)"},
       "these nodes need each other in a circle: a -> b -> c -> a\n  'b' needs 'c'\n  'c' needs "
       "'a'"},
      // Through a function port as well.
      {"\"nodes\": {\"a\": {\"block\": \"t_warp\", \"in\": {\"image\": \"a\"}}}",
       {"2:52 cycle"},
       "needs its own output"},
      // Other mistakes of nodes in a circle are reported, too.
      {"\"nodes\": {\"a\": {\"block\": \"t_gen\", \"in\": {\"a\": \"a\", \"b\": \"nothing\"}}}",
       {"2:47 cycle", "2:57 unknown-reference"},
       "nothing is called 'nothing'"},
  });
}

TEST(CheckMistakes, WordsAreNoCircles) {
  // "add" is a word at "mode" and the node itself elsewhere.
  CheckText check(R"("nodes": {"add": {"block": "t_pick", "in": {"mode": "add"}}})",
                  "\"height\": \"add\"");
  EXPECT_EQ(check.NodeText("add"), "x=0.0:float mode=3:int");
}

TEST(CheckMistakes, LongCirclesAreCutInTheMiddle) {
  std::string nodes = "\"nodes\": {";
  for (int i = 0; i < 10'000; ++i) {
    nodes += fmt::format("{}\"n{}\": {{\"block\": \"t_one\", \"in\": {{\"x\": \"n{}\"}}}}",
                         i ? ",\n" : "", i, (i + 1) % 10'000);
  }
  CheckText check(nodes + "}");
  ASSERT_EQ(check.diagnostics.all().size(), 1u);
  EXPECT_THAT(
      check.Messages(),
      HasSubstr("n0 -> n1 -> n2 -> n3 -> n4 -> n5 -> n6 -> n7 -> ... 9984 more ... -> n9992"));
  EXPECT_THAT(check.Messages(), HasSubstr("-> n9999 -> n0"));
  EXPECT_EQ(check.diagnostics.all()[0].notes.size(), 15u);
}

TEST(CheckMistakes, FunctionsThatCallEachOther) {
  ExpectMistakes({
      {"\"functions\": {\"f\": {\"nodes\": {\"n\": {\"block\": \"f\"}}, \"outputs\": {\"o\": "
       "\"n\"}}}",
       {"2:15 cycle"},
       "function 'f' calls itself"},
      {"\"functions\": {\"f\": {\"nodes\": {\"n\": {\"block\": \"g\"}}, \"outputs\": {\"o\": "
       "\"n\"}},\n"
       "\"g\": {\"nodes\": {\"n\": {\"block\": \"t_warp\", \"in\": {\"image\": \"f\"}}}, "
       "\"outputs\": {\"o\": \"n\"}}}",
       {"2:15 cycle (3:1)"},
       "these functions call each other in a circle: f -> g -> f"},
  });
}

TEST(CheckMistakes, ParametersAndFunctionInputs) {
  ExpectMistakes({
      {"\"parameters\": {\"p\": {\"type\": \"flot\", \"value\": 1}}",
       {"2:30 bad-value"},
       "'flot' is no type of a parameter; did you mean 'float'?"},
      {"\"parameters\": {\"p\": {\"type\": \"mat2\", \"value\": 1}}",
       {"2:30 bad-value"},
       "no type"},
      {"\"parameters\": {\"p\": {\"type\": \"Tile\", \"value\": 1}}",
       {"2:30 bad-value"},
       "no type"},
      {"\"parameters\": {\"p\": {\"type\": \"vec3\", \"value\": [1, 2]}}",
       {"2:47 bad-value"},
       "parameter 'p' takes vec3, got 2 numbers"},
      {"\"parameters\": {\"p\": {\"type\": \"vec2\", \"value\": 1, \"binding\": "
       "\"specialization\"}}",
       {"2:30 bad-value"},
       "specialization constants are scalars; parameter 'p' is vec2"},
      {"\"parameters\": {\"p\": {\"type\": \"bool\", \"value\": true, \"range\": [0, 1]}}",
       {"2:16 bad-value"},
       "parameter 'p' is bool and has no range"},
      {"\"functions\": {\"f\": {\"inputs\": {\"a\": \"sampler2D\"}, \"outputs\": {\"o\": 1}}}",
       {"2:37 bad-value"},
       "'sampler2D' is no type of a function's input"},
      // A wrong type or value is reported where it stands, and nowhere else.
      {"\"functions\": {\"f\": {\"inputs\": {\"a\": \"flaot\"}, \"outputs\": {\"o\": \"a\"}}},\n"
       "\"nodes\": {\"n\": {\"block\": \"f\", \"in\": {\"a\": 1}}, \"m\": {\"block\": \"f\"},\n"
       "\"w\": {\"block\": \"t_warp\", \"in\": {\"image\": \"f\"}}}",
       {"2:37 bad-value"},
       "did you mean 'float'?"},
      {"\"functions\": {\"f\": {\"inputs\": {\"a\": {\"type\": \"float\", \"value\": true}}, "
       "\"outputs\": {\"o\": \"a\"}}},\n"
       "\"nodes\": {\"n\": {\"block\": \"f\"}}",
       {"2:64 bad-value"},
       "input 'a' of function 'f' takes float, got true"},
      {"\"textures\": {\"t\": {\"file\": \"x\"}}, \"functions\": {\"f\": {\"outputs\": {\"o\": "
       "\"t\"}}}",
       {"2:72 port-type"},
       "output 'o' of function 'f' takes a value, got the texture 't'"},
      {"\"functions\": {\"f\": {\"outputs\": {\"o\": [1, 2, 3, 4, 5]}}}",
       {"2:38 port-type"},
       "5 numbers"},
  });
}

TEST(CheckMistakes, Outputs) {
  ExpectMistakes({
      {"\"nodes\": {}",
       {"1:29 unknown-output"},
       "no output 'colour'; did you mean 'color'?",
       "\"colour\": 1"},
      {"\"nodes\": {}",
       {"1:38 port-type"},
       "output 'color' takes vec4, got vec3; the block 'rgba' converts",
       "\"color\": \"position\""},
      {"\"nodes\": {}",
       {"1:38 port-type"},
       "output 'color' takes vec4, got 3 numbers",
       "\"color\": [1, 2, 3]"},
      {"\"nodes\": {}", {"1:39 unknown-reference"}, "nothing is called 'n'", "\"height\": \"n\""},
      {"\"nodes\": {}",
       {"1:29 unknown-output", "1:51 unknown-reference", "1:72 port-type"},
       "",
       "\"depth\": 1, \"height\": \"nothing\", \"normal\": true"},
  });
}

TEST(CheckMistakes, Settings) {
  constexpr std::string_view kText =
      "\"parameters\": {\"rows\": {\"type\": \"int\", \"value\": 4, \"range\": [1, 9]}}";
  struct Case {
    std::string setting, place, message;
  };
  for (const Case& c : std::vector<Case>{
           {"row=3", "1:1 unknown-parameter", "no parameter 'row'; did you mean 'rows'?"},
           {"uv=3", "1:1 unknown-parameter", "no parameter 'uv'"},
           {"rows=3.5", "1:6 bad-value (2:16)", "parameter 'rows' takes int, got 3.5"},
           {"rows=many", "1:6 bad-value (2:16)", "got the text 'many'"},
           {"rows=10", "1:6 value-range (2:16)", "from 1 to 9, got 10"},
           {"rows=", "1:6 empty-document", "empty"},
           {"rows=[1", "1:8 syntax (1:6)", "ends inside an array"},
           {"rows=1 2", "1:8 syntax", "nothing may follow"},
           {"rows=null", "1:6 bad-value", "null"},
           {"rows=\xff", "1:6 encoding", "UTF-8"},
           {"rows", "1:1 usage", "'rows' is not of the form name=value"},
           {"=3", "1:1 usage", "name=value"},
       }) {
    CheckText check(kText, "\"height\": 0", {c.setting});
    EXPECT_TRUE(check.diagnostics.HasErrors()) << c.setting;
    EXPECT_THAT(check.Places(), ElementsAre(c.place)) << c.setting << check.Messages();
    EXPECT_THAT(check.Messages(), HasSubstr(c.message)) << c.setting;
  }
}

// A value outside of its parameter's range is one mistake, also where it is outside of a port's.
TEST(CheckMistakes, AValueOutOfRangeIsReportedOnce) {
  const std::string text =
      "\"parameters\": {\"n\": {\"type\": \"int\", \"value\": 4, \"range\": [1, 8]}},\n"
      "\"nodes\": {\"g\": {\"block\": \"t_count\", \"in\": {\"n\": \"n\"}}}";
  CheckText setting(text, "\"height\": 0", {"n=100"});
  EXPECT_THAT(setting.Places(), ElementsAre("1:3 value-range (2:16)")) << setting.Messages();
  std::string wrong = text;
  wrong.replace(wrong.find("4,"), 1, "99");
  CheckText own(wrong, "\"height\": 0");
  EXPECT_THAT(own.Places(), ElementsAre("2:46 value-range")) << own.Messages();
}

TEST(CheckMistakes, AllAtOnceAndNoneTwice) {
  CheckText check(
      "\"parameters\": {\"p\": {\"type\": \"int\", \"value\": 1.5}},\n"
      "\"functions\": {\"f\": {\"nodes\": {\"m\": {\"block\": \"no_such\"}}, \"outputs\": {\"o\": "
      "\"m\"}}},\n"
      "\"nodes\": {\n"
      "\"a\": {\"block\": \"f\"},\n"
      "\"b\": {\"block\": \"t_gen\", \"in\": {\"a\": \"a\", \"b\": \"p\"}},\n"
      "\"c\": {\"block\": \"t_gen\", \"in\": {\"a\": \"b\", \"b\": \"nothing\"}},\n"
      "\"d\": {\"block\": \"t_one\", \"in\": {\"x\": \"c\", \"y\": 1}},\n"
      "\"e\": {\"block\": \"t_need\", \"in\": {}},\n"
      "\"g\": {\"block\": \"t_count\", \"in\": {\"n\": 100}}}",
      "\"color\": \"c\", \"heigt\": \"e\"");
  EXPECT_FALSE(check.checked);
  EXPECT_THAT(check.Places(),
              ElementsAre("2:46 bad-value", "3:46 unknown-block", "7:47 unknown-reference",
                          "8:42 unknown-port", "9:1 missing-input (3:20)",
                          "10:39 value-range (3:25)", "1:43 unknown-output"));
}

// Ten thousand mistakes take no longer than reading them.
TEST(CheckMistakes, ManyMistakesAreFast) {
  std::string nodes = "\"nodes\": {";
  for (int i = 0; i < 10'000; ++i) {
    nodes += fmt::format(
        "{}\"n{}\": {{\"block\": \"t_onf\", \"in\": {{\"x\": \"m{}\"}}}},\n"
        "\"k{}\": {{\"block\": \"t_one\", \"in\": {{\"x\": \"m{}\"}}}}",
        i ? ",\n" : "", i, i, i, i);
  }
  CheckText check(nodes + "}");
  EXPECT_EQ(check.diagnostics.error_count(), 20'000u);
  EXPECT_EQ(check.diagnostics.all().size(), Diagnostics::kMaxErrors);
}

}  // namespace
}  // namespace texgraph::graph
