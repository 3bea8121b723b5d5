// SPDX-License-Identifier: Apache-2.0
// What docs/decisions/0007-specialisation.md says, a test for each rule: text in, functions counted
// or text out.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"
#include "compiler/passes/passes.h"
#include "tests/unit/ir/module_text.h"

namespace texgraph::passes {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

struct Result {
  std::string text;                // of the module; empty if it was refused
  std::vector<std::string> names;  // of its functions
  Diagnostics diagnostics;
};

Result Specialized(std::string text, bool fold = true) {
  Result result;
  ir::Module module = ir::ModuleFrom(std::move(text));
  if (!module.main || !Specialize(module, fold, {}, result.diagnostics)) return result;
  EXPECT_EQ(ir::Verify(module), "");
  result.text = ir::Print(module);
  for (const ir::Function& function : module.functions) result.names.push_back(function.name);
  return result;
}

// More than five operations, so that it is not copied into its caller. `%p` decides nothing.
constexpr const char* kWaves = R"(function waves(%x: float, %p: float) -> float {
  %0 = mul %x, %p : float
  %1 = sin %0 : float
  %2 = mul %1, %1 : float
  %3 = cos %2 : float
  %4 = mul %3, %x : float
  %5 = sin %4 : float
  %6 = mul %5, %3 : float
  return %6
}
)";

std::string CallsOfWaves(const std::vector<std::string>& arguments) {
  std::string text = "input x: float\n" + std::string(kWaves) + "function main() -> (";
  for (size_t i = 0; i < arguments.size(); ++i)
    text += fmt::format("{}r{}: float", i ? ", " : "", i);
  text += ") {\n";
  std::string results;
  for (size_t i = 0; i < arguments.size(); ++i) {
    text += fmt::format("  %c{} = call waves({}) : float\n", i, arguments[i]);
    results += fmt::format("{}%c{}", i ? ", " : "", i);
  }
  return text + "  return " + results + "\n}\nmain main\n";
}

// A texture of whole numbers, 4 wide and 2 high, read by a function that gets the texture.
std::string MapProgram(std::vector<int32_t> values, std::string& printed) {
  ir::Module module = ir::ModuleFrom(R"(input p: ivec2
texture where: sampler2D
texture other: sampler2D
function at(%map: sampler2D, %cell: ivec2) -> float {
  %0 = texture_size %map, 0 : ivec2
  %1 = sub %0, ivec2(1, 1) : ivec2
  %2 = min %cell, %1 : ivec2
  %3 = max %2, ivec2(0, 0) : ivec2
  %4 = fetch %map, %3, 0 : vec4
  %5 = dot %4, vec4(1.0, 10.0, 100.0, 1000.0) : float
  %6 = sin %5 : float
  return %6
}
function main() -> (a: float, b: float) {
  %0 = call at(@where, @p) : float
  %1 = call at(@other, @p) : float
  return %0, %1
}
main main
)");
  module.globals[1].map = ir::MapFacts{4, 2, 1, std::move(values)};
  Diagnostics diagnostics;
  EXPECT_TRUE(Specialize(module, true, {}, diagnostics));
  EXPECT_EQ(ir::Verify(module), "");
  printed = ir::Print(module);
  return printed.substr(0, printed.find("function \"at/2\""));
}

TEST(SpecializeTest, MapsThatNeverChangeAreConstantArrays) {
  std::string all;
  const std::string at = MapProgram({7, 6, 5, 4, 3, 2, 1, -1}, all);
  EXPECT_THAT(at, Not(HasSubstr("fetch")));
  EXPECT_THAT(at, Not(HasSubstr("texture_size")));
  EXPECT_THAT(at, HasSubstr("ivec2(3, 1)")) << "the last texel";
  EXPECT_THAT(at, HasSubstr("int[8](7, 6, 5, 4, 3, 2, 1, -1)"));
  EXPECT_THAT(all, HasSubstr("fetch %map")) << "the other texture is one";
}

TEST(SpecializeTest, MapsThatChangeHaveAKnownSize) {
  std::string all;
  const std::string at = MapProgram({}, all);
  EXPECT_THAT(at, HasSubstr("fetch @where"));
  EXPECT_THAT(at, HasSubstr("ivec2(3, 1)"));
  EXPECT_THAT(at, Not(HasSubstr("texture_size")));
}

TEST(SpecializeTest, ConstantsThatDecideNothingArePassed) {
  Result result = Specialized(CallsOfWaves({"@x, 0.5", "@x, 0.25"}));
  EXPECT_THAT(result.names, ElementsAre("waves", "main"));
  EXPECT_THAT(result.text, HasSubstr("call waves(@x, 0.5)"));
}

TEST(SpecializeTest, TheOnlyCallBindsItsConstants) {
  Result result = Specialized(CallsOfWaves({"@x, 0.5"}));
  EXPECT_THAT(result.text, HasSubstr("function waves(%x: float)"));
}

TEST(SpecializeTest, ZerosAndOnesAreBound) {
  Result result = Specialized(CallsOfWaves({"@x, 0.0", "@x, 1.0", "@x, -0.0", "@x, 2.0"}));
  // -0.0 is another constant than 0.0, and binds too.
  EXPECT_THAT(result.names, ElementsAre("waves", "waves/2", "waves/3", "waves/4", "main"));
}

TEST(SpecializeTest, CallsWithNothingButConstantsBindThemAll) {
  Result result = Specialized(CallsOfWaves({"0.5, 0.25", "@x, 0.25", "@x, 0.5"}));
  EXPECT_THAT(result.text, HasSubstr("function waves() -> float"));
  EXPECT_THAT(result.text, HasSubstr("function \"waves/2\" as waves(%x: float, %p: float)"));
  // In integers, where CPU and GPU agree, such a call is a constant.
  std::string hash = Specialized(R"(input n: uint
function hash(%v: uint) -> uint {
  %0 = mul %v, 747796405u : uint
  %1 = shr %0, 7u : uint
  %2 = xor %0, %1 : uint
  %3 = mul %2, 277803737u : uint
  %4 = shr %3, 22u : uint
  %5 = xor %3, %4 : uint
  %6 = mul %5, 3u : uint
  return %6
}
function main() -> (a: uint, b: uint, c: uint) {
  %0 = call hash(0u) : uint
  %1 = call hash(@n) : uint
  %2 = call hash(%1) : uint
  return %0, %1, %2
}
main main
)")
                         .text;
  EXPECT_THAT(hash, HasSubstr("return 0u, "));
}

TEST(SpecializeTest, WhatDecidesIsBound) {
  Result result = Specialized(R"(input x: float
function pick(%x: float, %limit: float, %scale: float) -> float {
  %0 = add %limit, 1.0 : float
  %1 = lt %x, %0 : bool
  %2 = sin %x : float
  %3 = cos %x : float
  %4 = mul %2, %scale : float
  %5 = mul %3, %2 : float
  %6 = select %1, %4, %5 : float
  %7 = mul %6, %6 : float
  return %7
}
function main() -> (a: float, b: float) {
  %0 = call pick(@x, 0.5, 3.0) : float
  %1 = call pick(@x, 0.25, 4.0) : float
  return %0, %1
}
main main
)");
  EXPECT_THAT(result.names, ElementsAre("pick", "pick/2", "main"));
  EXPECT_THAT(result.text, HasSubstr("function pick(%x: float, %scale: float)"));
}

TEST(SpecializeTest, AfterSixteenVariantsConstantsArePassed) {
  std::vector<std::string> arguments;
  // Calls with nothing but constants.
  for (int i = 0; i < 20; ++i) arguments.push_back(fmt::format("{}.5, 2.5", i));
  Result result = Specialized(CallsOfWaves(arguments));
  ASSERT_EQ(result.names.size(), 18u);  // 16, the one with parameters, main
  EXPECT_THAT(result.text, HasSubstr("as waves(%x: float, %p: float)"));
}

TEST(SpecializeTest, UnfoldedNothingIsBoundButFields) {
  Result result = Specialized(CallsOfWaves({"@x, 0.0", "0.5, 0.5"}), false);
  EXPECT_THAT(result.names, ElementsAre("waves", "main"));
}

TEST(SpecializeTest, SmallFunctionsAreCopied) {
  Result result = Specialized(R"(input x: float
function five(%x: float) -> float {
  %0 = mul %x, %x : float
  %1 = sin %0 : float
  %2 = cos %1 : float
  %3 = add %2, %1 : float
  %4 = sin %3 : float
  return %4
}
function main() -> (a: float) {
  %0 = call five(@x) : float
  %1 = call five(%0) : float
  return %1
}
main main
)");
  EXPECT_THAT(result.text, Not(HasSubstr("call")));
}

constexpr const char* kBlur = R"(input x: float
function wave(%scale: float, %p: float) -> float {
  %0 = mul %scale, %p : float
  %1 = sin %0 : float
  %2 = mul %1, %1 : float
  %3 = cos %2 : float
  %4 = mul %3, %1 : float
  %5 = sin %4 : float
  return %5
}
function blur(%p: float, %image: field(float) -> float) -> float {
  %0 = add %p, 0.1 : float
  %1 = sub %p, 0.1 : float
  %2 = call_field %image(%0) : float
  %3 = call_field %image(%1) : float
  %4 = call_field %image(%p) : float
  %5 = add %2, %3 : float
  %6 = add %5, %4 : float
  %7 = mul %6, %6 : float
  %8 = sin %7 : float
  return %8
}
)";

TEST(SpecializeTest, AFunctionForEachBindingOfAFieldNotForEachUse) {
  Result result =
      Specialized(std::string(kBlur) + R"(function main() -> (a: float, b: float, c: float) {
  %s = sin @x : float
  %f = field wave(%s) : field(float) -> float
  %g = field wave(@x) : field(float) -> float
  %0 = call blur(@x, %f) : float
  %1 = call blur(%0, %f) : float
  %2 = call blur(%1, %g) : float
  return %0, %1, %2
}
main main
)");
  // What a field captures is an argument: both fields are one function.
  EXPECT_THAT(result.names, ElementsAre("wave", "blur", "main"));
  EXPECT_THAT(result.text, Not(HasSubstr("field")));
  EXPECT_THAT(result.text, HasSubstr("function blur(%p: float, %p.2: float)"));
}

TEST(SpecializeTest, RefusesChainsOfCallsThatAreTooDeep) {
  std::string text = "input x: float\n";
  std::string name = "leaf";
  text += "function leaf(%p: float) -> float {\n  return %p\n}\n";
  for (int i = 0; i < 70; ++i) {
    text += fmt::format(
        "function f{0}(%p: float) -> float {{\n  %0 = call {1}(%p) : float\n  return %0\n}}\n", i,
        name);
    name = fmt::format("f{}", i);
  }
  text += fmt::format(
      "function main() -> (a: float) {{\n  %0 = call {}(@x) : float\n  return %0\n}}\nmain main\n",
      name);
  Result result = Specialized(text);
  EXPECT_EQ(result.text, "");
  ASSERT_EQ(result.diagnostics.all().size(), 1u);
  const Diagnostic& error = result.diagnostics.all().front();
  EXPECT_EQ(error.kind, DiagnosticKind::kInstanceLimit);
  EXPECT_THAT(error.message, HasSubstr("more than 64 deep"));
  ASSERT_EQ(error.notes.size(), 1u);
  EXPECT_THAT(error.notes.front().message, HasSubstr("main -> f69 -> f68"));
}

// Each function calls the one before twice: 2^40 operations in 40 functions.
TEST(SpecializeTest, RefusesShadersThatRunTooLong) {
  std::string text = "input x: float\n" + std::string(kWaves);
  std::string name = "waves";
  for (int i = 0; i < 40; ++i) {
    text += fmt::format(
        "function f{0}(%x: float, %p: float) -> float {{\n  %0 = call {1}(%x, %p) : float\n"
        "  %1 = call {1}(%0, %p) : float\n  %2 = sin %1 : float\n  %3 = cos %2 : float\n"
        "  %4 = mul %2, %3 : float\n  %5 = sin %4 : float\n  return %5\n}}\n",
        i, name);
    name = fmt::format("f{}", i);
  }
  text += fmt::format(
      "function main() -> (a: float) {{\n  %0 = call {}(@x, @x) : float\n  return %0\n}}\nmain "
      "main\n",
      name);
  Result result = Specialized(text);
  EXPECT_EQ(result.text, "");
  ASSERT_EQ(result.diagnostics.all().size(), 1u);
  EXPECT_EQ(result.diagnostics.all().front().kind, DiagnosticKind::kCostLimit);
  EXPECT_THAT(result.diagnostics.all().front().notes.front().message,
              HasSubstr("main -> f39 -> f38"));
}

}  // namespace
}  // namespace texgraph::passes
