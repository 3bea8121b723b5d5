// SPDX-License-Identifier: Apache-2.0
// The IR functions that blocks become: names, parameters, one for each combination of template
// values, fields, footprints, samples, and calls from block to block.
#include "compiler/blocks/lower.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "compiler/ir/builder.h"
#include "compiler/ir/evaluate.h"
#include "compiler/ir/print.h"
#include "tests/unit/blocks/block_testing.h"

namespace texgraph::blocks {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string Printed(std::string_view text, bool fold = true,
                    const std::vector<uint32_t>& words = {}) {
  TestLibrary test(Files{{"x.glsl", std::string(text)}}, fold);
  ir::FunctionId id = test.Function("x", 0, words);
  return id ? ir::Print(test.module, test.module[id]) : test.Report();
}

TEST(BlockLowering, KeepsTheAuthorsNames) {
  EXPECT_EQ(
      Printed("float x(vec2 uv, float width, out float edge) {\n"
              "  float d = length(uv) - width; edge = d * 2.0;\n"
              "  float shade = sqrt(d); if (d > 0.0) { shade = cos(shade); } return shade; }"),
      "function x(%uv: vec2, %width: float) -> (float, edge: float) #0 {\n"
      "  %0 = length %uv : float\n"
      "  %d = sub %0, %width : float\n"
      "  %edge = mul %d, 2.0 : float\n"
      "  %shade = sqrt %d : float\n"
      "  %1 = lt 0.0, %d : bool\n"
      "  %shade.2 = if %1 : float {\n"
      "    %shade.3 = cos %shade : float\n"
      "    yield %shade.3\n"
      "  } else {\n"
      "    yield %shade\n"
      "  }\n"
      "  return %shade.2, %edge\n"
      "}\n");
}

TEST(BlockLowering, DecidesByTemplateValues) {
  constexpr std::string_view kText =
      "float x(float a, const int n) { if (n > 1) { a *= 2.0; } for (int i = 0; i < n * 2; i++) a "
      "+= 1.0; return a; }";
  // Without folding, bounds and branches are known all the same, but nothing else is computed.
  EXPECT_EQ(Printed(kText, true, {2}),
            "function x(%a: float) -> float #0 {\n"
            "  %a.2 = mul %a, 2.0 : float\n"
            "  %a.3 = for %i = 0 to 4 step 1 (%a.4 = %a.2) : float {\n"
            "    %a.5 = add %a.4, 1.0 : float\n"
            "    yield %a.5\n"
            "  }\n"
            "  return %a.3\n"
            "}\n");
  EXPECT_THAT(Printed(kText, false, {2}), HasSubstr("to 4 step 1"));
  EXPECT_EQ(Printed(kText, true, {0}), "function x(%a: float) -> float #0 {\n  return %a\n}\n");
  EXPECT_THAT(
      Printed(kText, true, {40000}),
      HasSubstr("this loop makes 80000 rounds; llvmpipe ends all loops after 65535 [loop-limit]"));
}

TEST(BlockLowering, MakesEachCombinationOnce) {
  TestLibrary test(
      Files{{"x.glsl",
             "float f(float a, const int n) { return a * float(n); }\n"
             "float x(float a, const int n) { return f(a, n) + f(a, 3) + f(a, n + 1); }"}});
  ir::FunctionId two = test.Function("x", 0, {2});
  ir::FunctionId three = test.Function("x", 0, {3});
  EXPECT_EQ(test.Function("x", 0, {2}), two);
  EXPECT_NE(two, three);
  std::vector<std::string> names, display_names;
  for (const ir::Function& function : test.module.functions) {
    names.push_back(function.name);
    display_names.push_back(function.display_name);
    EXPECT_EQ(function.parameters.size(), 1u);
    EXPECT_EQ(test.module.origins[function.origin.index].block, "x");
    EXPECT_EQ(test.module.origins[function.origin.index].source, "x.glsl");
  }
  EXPECT_THAT(names, ElementsAre("x.f", "x.f.2", "x", "x.f.3", "x.2"));
  EXPECT_THAT(display_names, ElementsAre("f", "f", "x", "f", "x"));
  EXPECT_EQ(RunFunction(test.module, two, {{Bits(1.0f)}})[0][0], Bits(2.0f + 3 + 3));
  EXPECT_EQ(RunFunction(test.module, three, {{Bits(1.0f)}})[0][0], Bits(3.0f + 3 + 4));
}

// One function for each content of an array, and for each length.
TEST(BlockLowering, ArraysOfAnyLength) {
  TestLibrary test(Files{
      {"sum.glsl",
       "float sum(const vec2 p[], float a) {\n"
       "  for (int i = 0; i < p.length(); i++) { a += p[i].x * p[p.length() - 1 - i].y; }\n"
       "  return a; }"},
      {"x.glsl",
       "const vec2 KNOWN[3] = vec2[](vec2(1.0, 2.0), vec2(3.0, 4.0), vec2(5.0, 6.0));\n"
       "float twice(const vec2 q[], const float f) { return sum(q, f) * float(q.length()); }\n"
       "float x(const vec2 p[]) { return twice(p, 0.5) + sum(KNOWN, 0.0); }"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  const Port& port = block->overloads[0].inputs[0];
  EXPECT_EQ(test.module.types.Text(port.type), "vec2[]");
  auto function = [&](const std::vector<float>& numbers) {
    ir::TypeId type = test.module.types.Array(ir::kVec2, static_cast<uint32_t>(numbers.size() / 2));
    ir::ConstId points = test.module.Intern(type, Bits(numbers));
    return test.library.Function(*block, block->overloads[0], {{points}});
  };
  auto expected = [](const std::vector<float>& p) {
    float sum = 0.5f, known = 1 * 6 + 3 * 4 + 5 * 2;
    for (size_t i = 0; i < p.size(); i += 2) sum += p[i] * p[p.size() - 1 - i];
    return Bits(sum * static_cast<float>(p.size() / 2) + known);
  };
  const std::vector<float> one = {7, 8}, two = {1, 2, 3, 4}, other = {1, 2, 3, 5};
  for (const std::vector<float>& numbers : {one, two, other}) {
    ir::FunctionId id = function(numbers);
    ASSERT_TRUE(id.valid()) << test.Report();
    EXPECT_EQ(RunFunction(test.module, id, {})[0][0], expected(numbers));
  }
  EXPECT_EQ(function(two), function(two));
  EXPECT_NE(function(two), function(other));
  // sum(KNOWN) is made once; x, twice and sum(p) once for each content.
  EXPECT_EQ(test.module.functions.size(), 1u + 3 * 3);
  // Shaders name it as the block does.
  ir::ConstId points = test.module.Intern(test.module.types.Array(ir::kVec2, 2), Bits(two));
  ASSERT_TRUE(test.module.constant_names.contains(points));
  EXPECT_EQ(test.module.Name(test.module.constant_names.at(points)), "p");
}

TEST(BlockLowering, ChoosesBetweenCheapValuesAndBranchesOtherwise) {
  EXPECT_THAT(Printed("float x(float a) { return a > 0.0 ? a * 2.0 : -a; }"), HasSubstr("select"));
  EXPECT_THAT(
      Printed("float x(float a, sampler2D s) { return a > 0.0 ? texture(s, vec2(a)).x : -a; }"),
      HasSubstr("= if "));
  EXPECT_THAT(
      Printed(
          "float f(float a) { return sin(a); }\nfloat x(float a) { return a > 0.0 ? f(a) : -a; }"),
      HasSubstr("= if "));
  EXPECT_THAT(Printed("float x(float a, const bool b) { return b ? a * 2.0 : -a; }", false, {1}),
              Not(HasSubstr("neg")));
}

TEST(BlockLowering, Samples) {
  EXPECT_THAT(
      Printed("vec4 x(sampler2D s, sampler2DArray a, sampler3D v, vec2 p) {\n"
              "  return texture(s, p) + texture(s, p, 1.0) + textureLod(a, vec3(p, 2), 0)\n"
              "    + textureGrad(a, vec3(p, 0), p, p) + textureGrad(v, vec3(p, 0), vec3(1), "
              "vec3(p, 1))\n"
              "    + texelFetch(s, ivec2(p), 0) + texelFetch(v, ivec3(1), 0) + vec4(textureSize(a, "
              "0), 1); }"),
      testing::AllOf(HasSubstr("sample %s, %p : vec4"), HasSubstr("sample %s, %p, 1.0 : vec4"),
                     HasSubstr("sample_lod %a"), HasSubstr("sample_grad %a"),
                     HasSubstr("sample_grad %v"), HasSubstr("fetch %s"), HasSubstr("fetch %v"),
                     HasSubstr("texture_size %a, 0 : ivec3")));
}

// A field's function, for calls from tests.
ir::FunctionId MakeField(ir::Module& module) {
  ir::Function function;
  function.name = function.display_name = "the_field";
  ir::Builder builder(module, function);
  ir::ValueId uv = builder.AddParameter({"uv", ir::kVec2, false});
  ir::ValueId scaled = builder.Op2(ir::Op::kMul, uv, builder.Float(10));
  builder.Return({{builder.Op2(ir::Op::kAdd, builder.Extract(scaled, 0), builder.Extract(uv, 1))}});
  module.functions.push_back(std::move(function));
  return ir::FunctionId(module.functions.size() - 1);
}

// Calls `callee`, whose first parameter is a field, with the rest of its parameters.
ir::FunctionId WithField(ir::Module& module, ir::FunctionId callee) {
  ir::FunctionId field = MakeField(module);
  ir::Function function;
  function.name = function.display_name = "main";
  ir::Builder builder(module, function);
  const std::vector<ir::Parameter> parameters = module[callee].parameters;
  std::vector<ir::ValueId> arguments{builder.Emit(ir::Op::kFieldRef, parameters[0].type,
                                                  std::span<const ir::ValueId>(), field.index)};
  for (size_t i = 1; i < parameters.size(); ++i)
    arguments.push_back(builder.AddParameter(parameters[i]));
  builder.Return({{builder.Call(callee, arguments)}});
  module.functions.push_back(std::move(function));
  return ir::FunctionId(module.functions.size() - 1);
}

TEST(BlockLowering, HandsFieldsOn) {
  // Through a private function, through one that calls it, and through another block.
  TestLibrary test(
      Files{{"x.glsl",
             "float image(vec2 uv);\n"
             "float plain(vec2 p) { return p.x; }\n"
             "float near(vec2 p) { return image(p + 1.0); }\n"
             "float around(vec2 p) { return near(p) + near(-p) + plain(p); }\n"
             "float x(vec2 p) { float s = around(p) + twice(p); return s + image(p); }\n"},
            {"twice.glsl",
             "float image(vec2 uv);\nfloat twice(vec2 p) { return 2.0 * image(2.0 * p); }\n"}});
  ir::FunctionId id = test.Function("x");
  ASSERT_TRUE(id.valid()) << test.Report();
  for (const ir::Function& function : test.module.functions) {
    bool plain = function.display_name == "plain";
    EXPECT_EQ(function.parameters[0].name, plain ? "p" : "image");
  }
  auto f = [](float u, float v) { return 10 * u + v; };
  float u = 3, v = 5;
  float expected = f(u + 1, v + 1) + f(1 - u, 1 - v) + u + 2 * f(2 * u, 2 * v) + f(u, v);
  EXPECT_EQ(RunFunction(test.module, WithField(test.module, id), {Bits({u, v})})[0][0],
            Bits(expected));
}

TEST(BlockLowering, GenericFieldsFollowTheBlock) {
  TestLibrary test(
      Files{{"x.glsl",
             "genType image(vec2 uv);\n"
             "genType at(vec2 p, float k) { return image(p) * k; }\n"
             "genType half_of(genType a) { return 0.5 * a; }\n"
             "genType x(vec2 p) { return half_of(at(p, 4.0)) + genType(half_of(2.0)); }\n"}});
  const Block* block = test.library.Find("x");
  ASSERT_NE(block, nullptr) << test.Report();
  ASSERT_EQ(block->overloads.size(), 4u);
  EXPECT_EQ(test.module.types.Text(block->overloads[2].inputs[0].type), "field(vec2) -> vec3");
  EXPECT_EQ(block->overloads[2].outputs[0].type, ir::kVec3);
  for (size_t i = 0; i < 4; ++i) EXPECT_TRUE(test.Function("x", i).valid()) << test.Report();
  ir::FunctionId main = WithField(test.module, test.Function("x", 0));
  EXPECT_EQ(RunFunction(test.module, main, {Bits({1, 2})})[0][0], Bits(0.5f * (12 * 4) + 1));
}

TEST(BlockLowering, FieldsOfOtherBlocksMustBeThere) {
  TestLibrary test(
      Files{{"x.glsl", "float x(vec2 p) { return twice(p); }\n"},
            {"y.glsl", "vec3 image(vec2 uv);\nfloat y(vec2 p) { return twice(p); }\n"},
            {"twice.glsl", "float image(vec2 uv);\nfloat twice(vec2 p) { return image(p); }\n"}});
  EXPECT_FALSE(test.Function("x").valid());
  EXPECT_FALSE(test.Function("y").valid());
  constexpr std::string_view kMessage =
      "block 'twice' needs the field 'image', field(vec2) -> float; declare the same prototype "
      "here to "
      "hand it on [block-type]\n  twice.glsl:1:7: the field is declared here\n";
  EXPECT_EQ(test.Report(),
            "x.glsl:1:26: " + std::string(kMessage) + "y.glsl:2:26: " + std::string(kMessage));
}

TEST(BlockLowering, BlocksCallBlocks) {
  TestLibrary test(Files{
      {"a/x.glsl",
       "const float K = 2.0;\n"
       "float help(float a) { return a * K; }\n"
       "float x(vec2 p, const int n) { return help(other(p.x, n + 1)) + other(p).y; }\n"},
      {"b/other.glsl",
       "const float K = 100.0;\n"
       "genType help(genType a) { return a + K; }\n"
       "float other(float a, const int n) { for (int i = 0; i < n; i++) a = help(a); return a; }\n"
       "vec2 other(vec2 a) { return help(a); }\n"}});
  ir::FunctionId id = test.Function("x", 0, {1});
  ASSERT_TRUE(id.valid()) << test.Report();
  EXPECT_EQ(RunFunction(test.module, id, {Bits({1, 2})})[0][0], Bits((1 + 200) * 2 + 102));
  // Private functions of other blocks are not there.
  TestLibrary wrong(
      Files{{"x.glsl", "float x(float a) { return help(a); }\n"},
            {"other.glsl",
             "float help(float a) { return a; }\nfloat other(float a) { return help(a); }\n"}});
  EXPECT_FALSE(wrong.Function("x").valid());
  EXPECT_EQ(wrong.Report(), "x.glsl:1:27: there is no function or block 'help' [block-name]\n");
}

TEST(BlockLowering, StructsOfOtherFiles) {
  TestLibrary test(Files{{"x.glsl", "struct P { vec2 a; };\nfloat x(P p) { return y(p); }\n"},
                         {"y.glsl", "struct P { vec2 a; };\nfloat y(P p) { return p.a.x; }\n"},
                         {"z.glsl", "struct P { float b; };\nfloat z(P p) { return p.b; }\n"}});
  // Equal ones are one type; an unequal one is another, with a name of its own.
  EXPECT_TRUE(test.Function("x").valid()) << test.Report();
  ASSERT_TRUE(test.Function("z").valid()) << test.Report();
  EXPECT_EQ(test.module.types.Text(test.library.Find("y")->overloads[0].inputs[0].type), "P");
  EXPECT_EQ(test.module.types.Text(test.library.Find("z")->overloads[0].inputs[0].type), "z_P");
  EXPECT_FALSE(test.library.FindType("P").valid());
  EXPECT_TRUE(test.library.FindType("Tile").valid());
  EXPECT_EQ(test.library.FindType("mat3"), ir::kMat3);
}

TEST(BlockLowering, Recursion) {
  TestLibrary test(
      Files{{"x.glsl", "float x(float a) { return y(a); }\n"},
            {"y.glsl", "float y(float a) { return z(a); }\n"},
            {"z.glsl", "float z(float a) { return x(a); }\n"},
            {"ok.glsl", "float ok(vec2 a) { return ok(a.x); }\nfloat ok(float a) { return a; }\n"},
            {"t.glsl", "float t(const int n) { return n > 0 ? t(n - 1) : 1.0; }\n"}});
  EXPECT_FALSE(test.Function("x").valid());
  EXPECT_EQ(
      test.Report(),
      "z.glsl:1:27: 'x' calls itself through 'y', 'z', and GLSL has no recursion; use a counted "
      "loop [block-recursion]\n");
  // Once is enough.
  EXPECT_FALSE(test.Function("x").valid());
  EXPECT_EQ(test.diagnostics.error_count(), 1u);
  EXPECT_FALSE(test.Function("t", 0, {3}).valid());
  EXPECT_THAT(test.Report(), HasSubstr("t.glsl:1:39: 't' calls itself, and"));
}

// A linear function of the pixel's place has a footprint everywhere: the length of its two slopes.
TEST(BlockLowering, Footprint) {
  TestLibrary test(Files{{"x.glsl",
                          "vec2 x(vec2 p) { return footprint(p) + 100.0 * footprint_x(p) + 10000.0 "
                          "* footprint_y(p); }"}});
  ir::FunctionId id = test.Function("x");
  ASSERT_TRUE(id.valid()) << test.Report();
  std::vector<uint32_t> p;
  for (int component = 0; component < 2; ++component) {
    for (int lane = 0; lane < 4; ++lane) {
      float across = static_cast<float>(lane & 1), up = static_cast<float>(lane >> 1);
      p.push_back(Bits(component == 0 ? 3 * across + 4 * up : 5 * across - 12 * up));
    }
  }
  ir::EvaluateInputs inputs;
  std::vector<std::vector<uint32_t>> results = ir::Evaluate(test.module, id, inputs, {{p}});
  for (size_t lane = 0; lane < 4; ++lane) {
    EXPECT_FLOAT_EQ(std::bit_cast<float>(results[0][lane]), 5 + 300 + 40000);
    EXPECT_FLOAT_EQ(std::bit_cast<float>(results[0][4 + lane]), 13 + 500 - 120000);
  }
}

// The flag of early returns nests; the depth of the recursion is bounded, and what is beyond is
// reported.
TEST(BlockLowering, ManyEarlyReturns) {
  auto text = [](int count) {
    std::string text = "float x(float a) {\n";
    for (int i = 0; i < count; ++i) {
      text += "if (a < " + std::to_string(i) + ".0) return " + std::to_string(i) + ".0;\n";
    }
    return text + "return -1.0; }";
  };
  TestLibrary test(Files{{"x.glsl", text(150)}, {"y.glsl", "float y(float a) { return a; }"}});
  ir::FunctionId id = test.Function("x");
  ASSERT_TRUE(id.valid()) << test.Report();
  EXPECT_EQ(RunFunction(test.module, id, {{Bits(98.5f)}})[0][0], Bits(99.0f));
  EXPECT_EQ(RunFunction(test.module, id, {{Bits(1e9f)}})[0][0], Bits(-1.0f));
  EXPECT_THAT(Printed(text(5000)), HasSubstr("nest too deeply [nesting-limit]"));
}

// A chain of many statements takes time in proportion.
TEST(BlockLowering, LongBodies) {
  std::string text = "float x(float a) { float b = a;\n";
  for (int i = 0; i < 20000; ++i) text += "if (a > b) { b = b * a + 1.0; } else b -= a;\n";
  TestLibrary test(Files{{"x.glsl", text + "return b; }"}});
  EXPECT_TRUE(test.Function("x").valid()) << test.Report();
}

}  // namespace
}  // namespace texgraph::blocks
