// SPDX-License-Identifier: Apache-2.0
// Signatures and documentation: what becomes of a file's parameters, prototypes and "///" lines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/blocks/block_testing.h"

namespace texgraph::blocks {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr std::string_view kScatter =
    "/// Scatters copies of `image` over a\n"
    "/// grid, 1.5 in each. Turned at\n"
    "/// random.\n"
    "///\n"
    "/// @source Glanville, GPU Gems, chapter 20,\n"
    "///   listing 20-2\n"
    "/// @param image the picture\n"
    "/// @param uv where to look @default uv\n"
    "/// @param copies how many\n"
    "///   @default 2 @range 1 8\n"
    "///   at most\n"
    "/// @param angle how far @default vec2(-0.5, 3) @range -180 180 @unit degrees\n"
    "/// @param blend how @default BLEND_ADD\n"
    "/// @param hit how much\n"
    "/// @return the colour\n"
    "vec4 image(vec2 uv, float level);\n"
    "const int BLEND_MIX = 0;\n"
    "const int BLEND_ADD = 1;\n"
    "const int BLEND_MODE_X = 3;\n"
    "/// Not of interest.\n"
    "float half_of(float a) { return 0.5 * a; }\n"
    "vec4 x(vec2 uv, const int copies, vec2 angle, const int blend, sampler2D map, Tile tile,\n"
    "       out float hit) { hit = 1.0; return image(uv, 0.0); }\n";

TEST(BlockSignature, Ports) {
  TestLibrary test(Files{{"scatter/x.glsl", std::string(kScatter)}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  EXPECT_EQ(block->name, "x");
  EXPECT_EQ(block->family, "scatter");
  EXPECT_EQ(block->path, "scatter/x.glsl");
  EXPECT_EQ(test.sources.Locate(block->range.source, block->range.begin).line, 22u);
  ASSERT_EQ(block->overloads.size(), 1u);
  EXPECT_FALSE(block->overloads[0].gen_type);
  std::vector<std::string> ports;
  for (const Port& port : block->overloads[0].inputs) {
    ports.push_back(test.module.types.Text(port.type) + " " + port.name + " " +
                    std::to_string(static_cast<int>(port.kind)));
  }
  EXPECT_THAT(ports, ElementsAre("field(vec2, float) -> vec4 image 3", "vec2 uv 0", "int copies 1",
                                 "vec2 angle 0", "int blend 1", "sampler2D map 2", "Tile tile 0"));
  EXPECT_THAT(block->overloads[0].inputs[0].field_parameters, ElementsAre("uv", "level"));
  ports.clear();
  for (const Port& port : block->overloads[0].outputs) {
    ports.push_back(test.module.types.Text(port.type) + " " + port.name);
  }
  EXPECT_THAT(ports, ElementsAre("vec4 result", "float hit"));
}

TEST(BlockDocs, TextsAndTags) {
  TestLibrary test(Files{{"x.glsl", std::string(kScatter)}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  EXPECT_EQ(block->summary, "Scatters copies of `image` over a grid, 1.5 in each.");
  EXPECT_EQ(block->details, "Turned at\nrandom.");
  EXPECT_EQ(block->source, "Glanville, GPU Gems, chapter 20, listing 20-2");
  const std::vector<Port>& in = block->overloads[0].inputs;
  const std::vector<Port>& out = block->overloads[0].outputs;
  EXPECT_EQ(in[0].help, "the picture");
  EXPECT_EQ(in[1].help, "where to look");
  EXPECT_EQ(in[1].default_input, "uv");
  EXPECT_FALSE(in[1].default_value);
  EXPECT_EQ(in[2].help, "how many at most");
  EXPECT_EQ(in[2].minimum, 1.0);
  EXPECT_EQ(in[2].maximum, 8.0);
  EXPECT_THAT(test.module.Words(in[2].default_value), ElementsAre(2u));
  EXPECT_EQ(in[3].unit, "degrees");
  EXPECT_EQ(in[3].minimum, -180.0);
  EXPECT_EQ(test.module.constant(in[3].default_value).type, ir::kVec2);
  EXPECT_THAT(test.module.Words(in[3].default_value), ElementsAre(Bits(-0.5f), Bits(3.0f)));
  EXPECT_THAT(test.module.Words(in[4].default_value), ElementsAre(1u));
  ASSERT_EQ(in[4].words.size(), 3u);
  EXPECT_EQ(in[4].words[0].word, "mix");
  EXPECT_EQ(in[4].words[1].word, "add");
  EXPECT_EQ(in[4].words[1].value, 1);
  EXPECT_EQ(in[4].words[2].word, "mode_x");
  EXPECT_TRUE(in[2].words.empty());
  EXPECT_EQ(out[0].help, "the colour");
  EXPECT_EQ(out[1].help, "how much");
}

TEST(BlockDocs, EachOverloadHasItsOwn) {
  TestLibrary test(Files{{"x.glsl",
                          "/// Two.\n"
                          "/// @param a the first @default 0.5\n"
                          "genType x(genType a) { return a; }\n"
                          "/// @param a a count @default 3\n"
                          "/// @param b an addend\n"
                          "int x(int a, int b) { return a + b; }\n"
                          "vec2 x(vec2 a, float b) { return a + b; }\n"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  ASSERT_EQ(block->overloads.size(), 6u);
  for (uint32_t i = 0; i < 4; ++i) {
    const Overload& overload = block->overloads[i];
    EXPECT_EQ(overload.gen_type, ir::Vector(ir::Scalar::kFloat, i + 1));
    EXPECT_EQ(overload.inputs[0].help, "the first");
    EXPECT_EQ(test.module.constant(overload.inputs[0].default_value).type, overload.gen_type);
    EXPECT_EQ(test.module.Words(overload.inputs[0].default_value)[i], Bits(0.5f));
  }
  EXPECT_EQ(block->overloads[4].inputs[0].help, "a count");
  EXPECT_EQ(test.module.Words(block->overloads[4].inputs[0].default_value)[0], 3u);
  // Where an overload says nothing, another's lines count.
  EXPECT_EQ(block->overloads[5].inputs[0].help, "the first");
  EXPECT_EQ(block->overloads[5].inputs[1].help, "an addend");
}

TEST(BlockDocs, Defaults) {
  auto default_of = [](std::string_view type, std::string_view value) {
    TestLibrary test(Files{{"x.glsl", "const float HALF = 0.5;\n/// X.\n/// @param a it @default " +
                                          std::string(value) + "\nfloat x(" + std::string(type) +
                                          " a) { return 1.0; }\n"}});
    const Block* block = test.library.Find("x");
    if (!block) return test.Report();
    const Port& port = block->overloads[0].inputs[0];
    std::string text = port.default_input;
    if (!port.default_value) return text;
    text = test.module.types.Text(test.module.constant(port.default_value).type);
    for (uint32_t word : test.module.Words(port.default_value)) text += " " + std::to_string(word);
    return text;
  };
  EXPECT_EQ(default_of("float", "1"), "float " + std::to_string(Bits(1.0f)));
  EXPECT_EQ(default_of("float", "-HALF * 2.0"), "float " + std::to_string(Bits(-1.0f)));
  EXPECT_EQ(default_of("bool", "true"), "bool 1");
  EXPECT_EQ(default_of("uint", "7"), "uint 7");
  EXPECT_EQ(default_of("ivec2", "-1"), "ivec2 4294967295 4294967295");
  EXPECT_EQ(default_of("vec3", "normal"), "normal");
  EXPECT_EQ(default_of("vec3", "time"), "time");
  EXPECT_EQ(default_of("mat2", "mat2(1.0)"),
            "mat2 " + std::to_string(Bits(1.0f)) + " 0 0 " + std::to_string(Bits(1.0f)));
  EXPECT_EQ(default_of("Tile",
                       "Tile(ivec2(1, 2), vec2(0), vec2(0), 9u, vec2(0), vec2(0), vec2(0), "
                       "vec2(0), vec2(0), vec2(0), vec2(0))"),
            "Tile 1 2 0 0 0 0 9 0 0 0 0 0 0 0 0 0 0 0 0 0 0");
  EXPECT_EQ(default_of("int", "1.5"),
            "x.glsl:3:26: the value must be int, got float [block-doc]\n");
  EXPECT_EQ(default_of("vec3", "vec2(1)"),
            "x.glsl:3:26: the value must be vec3, got vec2 [block-doc]\n");
  EXPECT_EQ(
      default_of("vec3", "uv"),
      "x.glsl:3:26: 'uv' is a vec2 that is not known when the shader is made; this port takes "
      "vec3 [block-doc]\n");
  EXPECT_EQ(
      default_of("const float", "time"),
      "x.glsl:3:26: 'time' is a float that is not known when the shader is made; this port takes "
      "float [block-doc]\n");
  EXPECT_EQ(default_of("vec2", "uw"),
            "x.glsl:3:26: there is no constant and no input 'uw' [block-doc]\n");
  EXPECT_EQ(default_of("float", "a + 1.0"), "x.glsl:3:26: there is no 'a' here [block-doc]\n");
  EXPECT_EQ(default_of("float", "1.0 +"),
            "x.glsl:3:31: expected a value, found the end [block-doc]\n");
  EXPECT_EQ(default_of("float", "1.0 2.0"),
            "x.glsl:3:30: expected one expression, found '2.0' [block-doc]\n");
  EXPECT_EQ(default_of("float", "1.0 / 0.0"),
            "x.glsl:3:26: this is not a constant, or has no finite value [block-doc]\n");
  EXPECT_EQ(default_of("sampler2D", "uv"), "x.glsl:3:17: a texture has no default [block-doc]\n");
  EXPECT_EQ(default_of("float", "0.5 @range 1 2"),
            "x.glsl:3:26: the default is outside of the range [block-doc]\n");
  EXPECT_EQ(default_of("float", "0.1 @range 0.1 2"), "float " + std::to_string(Bits(0.1f)));
}

TEST(BlockDocs, Mistakes) {
  auto report = [](std::string_view doc) {
    return ReportOf("/// X.\n" + std::string(doc) +
                    "\nfloat x(float a, out float b) { b = a; return a; }");
  };
  EXPECT_EQ(report("/// @parm a it"),
            "2:5: there is no tag '@parm'; did you mean '@param'? [block-doc]\n");
  EXPECT_EQ(report("/// @param a it @unti mm"),
            "2:17: there is no tag '@unti'; did you mean '@unit'? [block-doc]\n");
  EXPECT_EQ(report("/// @param c it"), "2:12: there is no parameter 'c' [block-doc]\n");
  EXPECT_EQ(report("/// @param"), "2:5: '@param' needs the name of a parameter [block-doc]\n");
  EXPECT_EQ(report("/// @param a it\n/// @param a again"),
            "3:12: 'a' is described twice [block-doc]\n");
  EXPECT_EQ(report("/// @default 1.0"),
            "2:5: '@default' stands in the text of a '@param' [block-doc]\n");
  EXPECT_EQ(report("/// @param a it @default"),
            "2:17: '@default' needs a value behind it [block-doc]\n");
  EXPECT_EQ(report("/// @param a it @unit m @unit cm"),
            "2:25: '@unit' stands here twice [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @default 1.0"), "2:17: an output has no default [block-doc]\n");
  constexpr std::string_view kRange =
      "a range is two numbers, the lesser first: '@range 0 1' [block-doc]\n";
  EXPECT_EQ(report("/// @param a it @range 1"), "2:24: " + std::string(kRange));
  EXPECT_EQ(report("/// @param a it @range 1 0"), "2:24: " + std::string(kRange));
  EXPECT_EQ(report("/// @param a it @range 1 x"), "2:24: " + std::string(kRange));
  EXPECT_EQ(report("/// @param a it @range 0 1 2"), "2:24: " + std::string(kRange));
  EXPECT_EQ(report("/// @param a it @range 0 inf"), "2:24: " + std::string(kRange));
  EXPECT_EQ(report("/// write to me@example.org"), "");
  EXPECT_EQ(
      ReportOf(
          "/// @param a it\nfloat f(float a) { return a; }\nfloat x(float a) { return f(a); }"),
      "1:5: tags belong to the block's function and its prototypes, not here [block-doc]\n");
  EXPECT_EQ(
      ReportOf(
          "const int MODE_A = 0;\nconst int MODE_B = 1;\n/// X.\n/// @param mode it @default 2\n"
          "int x(const int mode) { return mode; }"),
      "4:29: the default is none of the port's words [block-doc]\n");
  // Once, not for every meaning of genType.
  EXPECT_EQ(ReportOf("/// @param a it @default true\ngenType x(genType a) { return a; }"),
            "1:26: the value must be float, got bool [block-doc]\n");
}

// An input of the graph is the default of the versions that have its type.
TEST(BlockDocs, DefaultsOfGenType) {
  TestLibrary test(Files{{"x.glsl",
                          "/// X.\n/// @param a it @default uv\n/// @param b it @default time\n"
                          "genType x(genType a, genType b) { return a + b; }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  std::vector<std::string> defaults;
  for (const Overload& overload : block->overloads) {
    defaults.push_back(std::string(overload.inputs[0].default_input) + " " +
                       std::string(overload.inputs[1].default_input));
  }
  EXPECT_THAT(defaults, ElementsAre(" time", "uv time", " time", " time"));
  EXPECT_EQ(test.Report(), "");
  EXPECT_NE(ReportOf("/// @param a it @default neighbour\ngenType x(genType a) { return a; }"), "");
}

// What function ports replace, and which blocks stand at them.
TEST(BlockDocs, AskedAtAndBlocksAsDefaults) {
  TestLibrary test(Files{{"x.glsl",
                          "/// X.\n/// @param f it @default any_block\n/// @param uv where\n"
                          "/// @param a how @default 2 @asked_at uv\nfloat f(vec2 uv, int a);\n"
                          "float x(vec2 uv, int a) { return f(uv, a); }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  const std::vector<Port>& in = block->overloads[0].inputs;
  EXPECT_EQ(in[0].default_block, "any_block");
  EXPECT_EQ(in[1].asked_at, std::nullopt);
  EXPECT_EQ(in[2].asked_at, 1u);
  const std::string wrong =
      "'@asked_at' is for a value with a constant as its default, and names another input of "
      "floats [block-doc]\n";
  // No default, no coordinate, itself, known when the shader is made, and an output.
  EXPECT_EQ(ReportOf("/// @param a it @asked_at b\nfloat x(float a, vec2 b) { return a; }"),
            "1:17: " + wrong);
  EXPECT_EQ(
      ReportOf("/// @param a it @default 1 @asked_at b\nfloat x(int a, int b) { return 0.0; }"),
      "1:28: " + wrong);
  EXPECT_EQ(ReportOf("/// @param a it @default 1 @asked_at a\nfloat x(float a) { return a; }"),
            "1:28: " + wrong);
  EXPECT_EQ(ReportOf("/// @param a it @default 1 @asked_at b\n"
                     "float x(const float a, vec2 b) { return a; }"),
            "1:28: " + wrong);
  EXPECT_EQ(ReportOf("/// @param o it @asked_at b\nvoid x(vec2 b, out float o) { o = b.x; }"),
            "1:17: an output has no '@asked_at' [block-doc]\n");
}

TEST(BlockDocs, Lengths) {
  TestLibrary test(Files{{"x.glsl",
                          "const vec2 LINE[2] = vec2[](vec2(0.0), vec2(1.0));\n"
                          "/// X.\n/// @param a some @length 2 8 @default LINE\n///   or more\n"
                          "/// @param b any @range 0 1 @default float[](0.5, 1.0, 0.25)\n"
                          "/// @param c four\n"
                          "float x(const vec2 a[], const float b[], const ivec2 c[4], const int d) "
                          "{ return b[0]; }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  const std::vector<Port>& in = block->overloads[0].inputs;
  std::vector<std::string> lengths;
  for (const Port& port : in) {
    EXPECT_EQ(port.kind, PortKind::kTemplate);
    lengths.push_back(std::to_string(port.min_length) + "-" + std::to_string(port.max_length));
  }
  EXPECT_THAT(lengths, ElementsAre("2-8", "1-1024", "4-4", "0-0"));
  EXPECT_EQ(in[0].help, "some or more");
  EXPECT_THAT(test.module.Words(in[0].default_value), ElementsAre(0u, 0u, Bits(1.0f), Bits(1.0f)));
  EXPECT_THAT(test.module.Words(in[1].default_value),
              ElementsAre(Bits(0.5f), Bits(1.0f), Bits(0.25f)));
  auto report = [](std::string_view doc) {
    return ReportOf("/// X.\n" + std::string(doc) +
                    "\nfloat x(float a, const float b[], const float c[3]) { return a; }");
  };
  const std::string kLength =
      "2:25: a length is two numbers from 1 to 1024, the lesser first: '@length 3 256' "
      "[block-doc]\n";
  for (const char* wrong : {"3", "3 2", "0 2", "1 1025", "1.0 2", "1 2 3", "-1 2"}) {
    EXPECT_EQ(report(std::string("/// @param b it @length ") + wrong), kLength) << wrong;
  }
  for (const char* other : {"a", "c"}) {
    EXPECT_EQ(report("/// @param " + std::string(other) + " it @length 1 2"),
              "2:17: only an array without a length of its own has '@length' [block-doc]\n");
  }
  EXPECT_EQ(report("/// @param b it @length 2 3 @default float[](1.0)"),
            "2:38: the default is not as long as '@length' says [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @range 0 1 @default float[](0.5, 2.0)"),
            "2:37: the default is outside of the range [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @default vec2[](vec2(1))"),
            "2:26: the value must be float[], got vec2[1] [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @default 1.0"),
            "2:26: the value must be float[], got float [block-doc]\n");
  EXPECT_EQ(report("/// @param c it @default float[](1.0)"),
            "2:26: the value must be float[3], got float[1] [block-doc]\n");
}

TEST(BlockDocs, LeastAndGreatest) {
  TestLibrary test(Files{{"x.glsl",
                          "/// X.\n/// @param a the least @default 1\n"
                          "/// @param b the greatest @not_below a\n///   of all @default 1\n"
                          "/// @param c both @ordered\n///   of them @default 2\n"
                          "genType x(genType a, genType b, ivec2 c) { return a + b; }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  for (const Overload& overload : block->overloads) {
    EXPECT_EQ(overload.inputs[1].not_below, 0u);
    EXPECT_EQ(overload.inputs[1].help, "the greatest of all");
    EXPECT_TRUE(overload.inputs[2].ordered);
    EXPECT_FALSE(overload.inputs[0].ordered || overload.inputs[0].not_below);
  }
  auto report = [](std::string_view doc) {
    return ReportOf("/// X.\n" + std::string(doc) +
                    "\nfloat x(float a, vec2 b, vec2 c, bvec2 d, out vec2 e) { e = b; return a; }");
  };
  EXPECT_EQ(report("/// @param a it @ordered"),
            "2:17: only vectors of numbers are '@ordered' [block-doc]\n");
  EXPECT_EQ(report("/// @param d it @ordered"),
            "2:17: only vectors of numbers are '@ordered' [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @ordered x y"),
            "2:17: '@ordered' ends its line; it takes no value [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @ordered @ordered"),
            "2:26: '@ordered' stands here twice [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @not_below"),
            "2:17: '@not_below' needs a value behind it [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @not_below g"), "2:28: there is no input 'g' [block-doc]\n");
  for (const char* other : {"a", "b", "d"}) {
    EXPECT_EQ(report(std::string("/// @param b it @not_below ") + other),
              "2:28: '@not_below' names another input of numbers of the same type [block-doc]\n");
  }
  EXPECT_EQ(report("/// @param e it @not_below b"),
            "2:17: an output has no '@not_below' [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @ordered @default vec2(0, -1)"),
            "2:17: the defaults break '@ordered' [block-doc]\n");
  EXPECT_EQ(report("/// @param b it @not_below c @default 0\n/// @param c it @default vec2(0, 1)"),
            "2:17: the defaults break '@not_below' [block-doc]\n");
}

TEST(BlockDocs, ListsOfOneLength) {
  TestLibrary test(Files{{"x.glsl",
                          "/// X.\n/// @param a them\n/// @param b as many @as_long_as a\n"
                          "float x(const vec4 a[], const float b[]) { return a[0].x + b[0]; }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  EXPECT_EQ(block->overloads[0].inputs[1].as_long_as, 0u);
  EXPECT_FALSE(block->overloads[0].inputs[0].as_long_as);
  auto report = [](std::string_view doc) {
    return ReportOf("/// X.\n" + std::string(doc) +
                    "\nfloat x(const float a[], vec2 b, const int c[3], out float e) "
                    "{ e = b.x; return a[0]; }");
  };
  EXPECT_EQ(report("/// @param a it @as_long_as"),
            "2:17: '@as_long_as' needs a value behind it [block-doc]\n");
  EXPECT_EQ(report("/// @param a it @as_long_as g"), "2:29: there is no input 'g' [block-doc]\n");
  for (const char* text : {"a it @as_long_as a", "a it @as_long_as b", "b it @as_long_as a",
                           "a it @as_long_as c", "c it @as_long_as a"}) {
    EXPECT_EQ(report("/// @param " + std::string(text)),
              "2:17: '@as_long_as' is for a list, and names another one [block-doc]\n");
  }
  EXPECT_EQ(report("/// @param e it @as_long_as a"),
            "2:17: an output has no '@as_long_as' [block-doc]\n");
}

TEST(BlockDocs, MultiplesOfTexturesSizes) {
  TestLibrary test(Files{{"x.glsl",
                          "/// X.\n/// @param cells columns and rows @multiple_of map\n"
                          "float x(const ivec2 cells, sampler2D map, float a) { return a; }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  EXPECT_EQ(block->overloads[0].inputs[0].multiple_of, 1u);
  EXPECT_FALSE(block->overloads[0].inputs[2].multiple_of);
  auto report = [](std::string_view doc) {
    return ReportOf("/// X.\n/// @param " + std::string(doc) +
                    "\nfloat x(const ivec2 a, ivec2 b, sampler2D c, out ivec2 d) {\n"
                    "  d = b; return 1.0; }");
  };
  EXPECT_EQ(report("a it @multiple_of e"), "2:30: there is no input 'e' [block-doc]\n");
  const char* wrong =
      "2:17: '@multiple_of' is for a 'const ivec2', and names an input that is a texture "
      "[block-doc]\n";
  EXPECT_EQ(report("a it @multiple_of b"), wrong);
  EXPECT_EQ(report("b it @multiple_of c"), wrong);
  EXPECT_EQ(report("d it @multiple_of c"), "2:17: an output has no '@multiple_of' [block-doc]\n");
}

TEST(BlockDocs, GridsOfTextures) {
  TestLibrary test(Files{{"x.glsl",
                          "/// X.\n/// @param grid columns and rows @grid_of atlas\n"
                          "float x(const ivec2 grid, sampler2D atlas, float a) { return a; }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  EXPECT_EQ(block->overloads[0].inputs[0].grid_of, 1u);
  EXPECT_FALSE(block->overloads[0].inputs[2].grid_of);
  auto report = [](std::string_view doc) {
    return ReportOf("/// X.\n/// @param " + std::string(doc) +
                    "\nfloat x(const ivec2 a, ivec2 b, sampler2D c, out ivec2 d) {\n"
                    "  d = b; return 1.0; }");
  };
  EXPECT_EQ(report("a it @grid_of e"), "2:26: there is no input 'e' [block-doc]\n");
  const char* wrong =
      "2:17: '@grid_of' is for a 'const ivec2', and names an input that is a texture "
      "[block-doc]\n";
  EXPECT_EQ(report("a it @grid_of b"), wrong);
  EXPECT_EQ(report("b it @grid_of c"), wrong);
  EXPECT_EQ(report("d it @grid_of c"), "2:17: an output has no '@grid_of' [block-doc]\n");
}

TEST(BlockDocs, TransitionsOfFamilies) {
  TestLibrary test(
      Files{{"x.glsl",
             "/// X.\n/// @param tiles the patterns @transitions kinds\n"
             "int x(const int kinds[], const int tiles[], int i) { return tiles[i]; }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  EXPECT_EQ(block->overloads[0].inputs[1].transitions_of, 0u);
  EXPECT_FALSE(block->overloads[0].inputs[0].transitions_of);
  auto report = [](std::string_view doc) {
    return ReportOf(
        "/// X.\n/// @param " + std::string(doc) +
        "\nint x(const int a[], const int b[], const float c[], const int d, out int e) {"
        "\n  e = a[0]; return b[0] + int(c[0]) + d; }");
  };
  EXPECT_EQ(report("a it @transitions f"), "2:30: there is no input 'f' [block-doc]\n");
  const char* wrong =
      "2:17: '@transitions' is for a 'const int[]', and names another one [block-doc]\n";
  for (const char* doc : {"a it @transitions a", "a it @transitions c", "a it @transitions d",
                          "c it @transitions a", "d it @transitions a"}) {
    EXPECT_EQ(report(doc), wrong) << doc;
  }
  EXPECT_EQ(report("e it @transitions a"), "2:17: an output has no '@transitions' [block-doc]\n");
}

TEST(BlockDocs, WhatNumbersCount) {
  TestLibrary test(
      Files{{"x.glsl",
             "/// X.\n/// @param i which @below list\n/// @return one @one_of list i\n"
             "int x(int i, const int list[]) { return list[i]; }\n"
             "/// @param i which @below map\n/// @return one @one_of map\n"
             "int x(int i, sampler2D map) { return int(texelFetch(map, ivec2(i), 0).r); }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  EXPECT_EQ(block->overloads[0].inputs[0].below, 1u);
  EXPECT_THAT(block->overloads[0].outputs[0].one_of, ElementsAre(1u, 0u));
  EXPECT_EQ(block->overloads[1].inputs[0].below, 1u);
  EXPECT_THAT(block->overloads[1].outputs[0].one_of, ElementsAre(1u));
  auto report = [](std::string_view doc) {
    return ReportOf("/// X.\n/// " + std::string(doc) +
                    "\nint x(int a, int b, vec2 c, sampler2D d, out float e) {"
                    "\n  e = c.x; return a + b; }");
  };
  EXPECT_EQ(report("@param a it @below f"), "2:24: there is no input 'f' [block-doc]\n");
  const char* wrong =
      "2:17: '@below' is for ints and maps, and names an input that is a texture, or a 'const' "
      "int, ivec2 or int[] [block-doc]\n";
  EXPECT_EQ(report("@param a it @below b"), wrong);
  EXPECT_EQ(report("@param c it @below d"), wrong);
  EXPECT_EQ(report("@param e it @below d"), "2:17: an output has no '@below' [block-doc]\n");
  EXPECT_EQ(report("@param a it @one_of b"), "2:17: an input has no '@one_of' [block-doc]\n");
  EXPECT_EQ(report("@param e it @one_of a"), "2:17: only an int is '@one_of' [block-doc]\n");
  EXPECT_EQ(report("@return it @one_of c"),
            "2:16: '@one_of' names inputs that are ints, lists or maps [block-doc]\n");
  EXPECT_EQ(report("@return it @one_of a f"), "2:26: there is no input 'f' [block-doc]\n");
}

TEST(BlockDocs, Enumerations) {
  TestLibrary test(
      Files{{"x.glsl",
             "const int ROW_A = 5;\nconst int ROW_MODE_UP = -1;\nconst int ROW_MODE_DOWN = 1;\n"
             "const int ROW_B = 2;\nconst int SIDE_LEFT = 0;\nconst float ROW_C = 1.0;\n"
             "/// X.\n/// @param row_mode it @default up\n"
             "int x(const int row, const int row_mode, const int side) { return row; }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  const std::vector<Port>& in = block->overloads[0].inputs;
  auto words = [](const Port& port) {
    std::vector<std::string> texts;
    for (const EnumWord& word : port.words) {
      texts.push_back(word.word + "=" + std::to_string(word.value));
    }
    return texts;
  };
  EXPECT_THAT(words(in[0]), ElementsAre("b=2", "a=5"));
  EXPECT_THAT(words(in[1]), ElementsAre("up=-1", "down=1"));
  EXPECT_THAT(test.module.Words(in[1].default_value), ElementsAre(0xffffffffu));
  // A single constant makes no choice.
  EXPECT_THAT(words(in[2]), ElementsAre());
}

TEST(BlockDocs, SharedEnumerationsAreThoseThatTheFileSpeaksOf) {
  TestLibrary test(Files{{"x.glsl",
                          "/// X.\n/// @param turn it @default TURN_NONE\n"
                          "int x(const int turn) { return turn; }"},
                         {"y.glsl",
                          "/// Y.\n/// @param turn how many @default 7\n"
                          "int y(const int turn) { return turn; }"},
                         {"z.glsl",
                          "const int TURN_LEFT = 0;\nconst int TURN_RIGHT = 1;\n"
                          "/// Z.\n/// @param turn to which side @default TURN_LEFT\n"
                          "int z(const int turn) { return turn; }"}});
  const Block* x = test.library.Find("x");
  const Block* y = test.library.Find("y");
  const Block* z = test.library.Find("z");
  ASSERT_TRUE(x && y && z) << test.Report();
  EXPECT_EQ(x->overloads[0].inputs[0].words.size(), 3u);
  EXPECT_TRUE(y->overloads[0].inputs[0].words.empty());
  // Words of the file's own stand alone.
  const std::vector<EnumWord>& own = z->overloads[0].inputs[0].words;
  ASSERT_EQ(own.size(), 2u);
  EXPECT_EQ(own[0].word, "left");
  EXPECT_EQ(own[1].word, "right");
}

}  // namespace
}  // namespace texgraph::blocks
