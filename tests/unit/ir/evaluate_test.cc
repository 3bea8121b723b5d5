// SPDX-License-Identifier: Apache-2.0
// The evaluator on modules that say exactly what they mean, against values worked out here.
#include "compiler/ir/evaluate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <bit>
#include <cmath>
#include <functional>

#include "compiler/ir/verify.h"
#include "tests/unit/ir/module_text.h"

namespace texgraph::ir {
namespace {

using testing::ElementsAre;

std::vector<uint32_t> Bits(const std::vector<float>& values) {
  std::vector<uint32_t> words;
  for (float value : values) words.push_back(std::bit_cast<uint32_t>(value));
  return words;
}

std::vector<float> Floats(const std::vector<uint32_t>& words) {
  std::vector<float> values;
  for (uint32_t word : words) values.push_back(std::bit_cast<float>(word));
  return values;
}

// The first result of main with the float input "x" (the module's first global).
std::vector<float> RunOn(const Module& module, const std::vector<float>& x, uint32_t width = 1) {
  EvaluateInputs inputs;
  inputs.lanes = static_cast<uint32_t>(x.size()) / width;
  inputs.globals = {Bits(x)};
  return Floats(Evaluate(module, module.main, inputs)[0]);
}

// n lanes of a function of the lane's number.
std::vector<float> Lanes(uint32_t n, const std::function<float(uint32_t)>& value) {
  std::vector<float> lanes;
  for (uint32_t lane = 0; lane < n; ++lane) lanes.push_back(value(lane));
  return lanes;
}

// --- Lanes and batches ---------------------------------------------------------------------------

TEST(Evaluate, EveryLaneOfEveryBatch) {
  Module module = ModuleFrom(R"(input x: float
function main() -> float {
  %y = mul @x, 2.0 : float
  %z = add %y, 1.0 : float
  return %z
}
main main)");
  for (uint32_t lanes : {4u, 8u, 60u, 64u, 68u, 128u, 132u, 200u}) {
    std::vector<float> x = Lanes(lanes, [](uint32_t lane) { return static_cast<float>(lane); });
    std::vector<float> expected = Lanes(lanes, [](uint32_t lane) { return 2.0f * lane + 1.0f; });
    EXPECT_EQ(RunOn(module, x), expected) << lanes;
  }
}

TEST(Evaluate, ResultsAndVectorsLieComponentAfterComponent) {
  Module module = ModuleFrom(R"(input p: vec2
function main() -> (a: vec2, b: float) {
  %a = swizzle.yx @p : vec2
  %b = extract.1 @p : float
  return %a, %b
}
main main)");
  EvaluateInputs inputs;
  inputs.globals = {Bits({1, 2, 3, 4, 10, 20, 30, 40})};
  auto results = Evaluate(module, module.main, inputs);
  ASSERT_EQ(results.size(), 2u);
  EXPECT_THAT(Floats(results[0]), ElementsAre(10, 20, 30, 40, 1, 2, 3, 4));
  EXPECT_THAT(Floats(results[1]), ElementsAre(10, 20, 30, 40));
}

TEST(Evaluate, GlobalsTakeWhatIsGivenOrTheirDefault) {
  Module module = ModuleFrom(R"(uniform a: vec2 = vec2(1.0, 2.0)
specialization n: int = 7
uniform bare: float
function main() -> (vec2, int, float) {
  return @a, @n, @bare
}
main main)");
  EvaluateInputs inputs;
  auto results = Evaluate(module, module.main, inputs);
  EXPECT_THAT(Floats(results[0]), ElementsAre(1, 1, 1, 1, 2, 2, 2, 2));
  EXPECT_THAT(results[1], ElementsAre(7, 7, 7, 7));
  EXPECT_THAT(Floats(results[2]), ElementsAre(0, 0, 0, 0));
  inputs.globals = {Bits({5, 6}), {}, Bits({1, 2, 3, 4})};
  results = Evaluate(module, module.main, inputs);
  EXPECT_THAT(Floats(results[0]), ElementsAre(5, 5, 5, 5, 6, 6, 6, 6));
  EXPECT_THAT(results[1], ElementsAre(7, 7, 7, 7));
  EXPECT_THAT(Floats(results[2]), ElementsAre(1, 2, 3, 4));
}

TEST(Evaluate, RunsAnyFunctionWithArguments) {
  Module module = ModuleFrom(R"(struct Tile { cell: ivec2, size: float }
function f(%t: Tile, %k: float) -> (ivec2, float) {
  %cell = extract.0 %t : ivec2
  %size = extract.1 %t : float
  %r = mul %size, %k : float
  return %cell, %r
})");
  EvaluateInputs inputs;
  std::vector<std::vector<uint32_t>> arguments = {{3, 4, std::bit_cast<uint32_t>(0.5f)},
                                                  Bits({1, 2, 3, 4})};
  auto results = Evaluate(module, FunctionId(0), inputs, arguments);
  EXPECT_THAT(results[0], ElementsAre(3, 3, 3, 3, 4, 4, 4, 4));
  EXPECT_THAT(Floats(results[1]), ElementsAre(0.5f, 1, 1.5f, 2));
}

TEST(Evaluate, AggregatesKeepTheirParts) {
  Module module = ModuleFrom(R"(struct Inner { a: vec2, b: int }
struct Outer { x: float, inner: Inner, list: vec2[3] }
input x: float
function main() -> (vec2, int, vec2, float) {
  %v = construct @x, 2.0 : vec2
  %inner = construct %v, 9 : Inner
  %list = construct vec2(0.0, 1.0), %v, vec2(4.0, 5.0) : vec2[3]
  %outer = construct @x, %inner, %list : Outer
  %i = extract.1 %outer : Inner
  %a = extract.0 %i : vec2
  %b = extract.1 %i : int
  %l = extract.2 %outer : vec2[3]
  %k = convert @x : int
  %e = index %l, %k : vec2
  %m = construct %e, %a : mat2
  %c = extract.1 %m : vec2
  %s = extract.0 %c : float
  return %a, %b, %e, %s
}
main main)");
  EvaluateInputs inputs;
  inputs.globals = {Bits({0, 1, 2, 99})};
  auto results = Evaluate(module, module.main, inputs);
  EXPECT_THAT(Floats(results[0]), ElementsAre(0, 1, 2, 99, 2, 2, 2, 2));
  EXPECT_THAT(results[1], ElementsAre(9, 9, 9, 9));
  EXPECT_THAT(Floats(results[2]), ElementsAre(0, 1, 4, 4, 1, 2, 5, 5));
  EXPECT_THAT(Floats(results[3]), ElementsAre(0, 1, 2, 99));
}

// --- Branches ------------------------------------------------------------------------------------

constexpr char kNestedIfs[] = R"(input x: float
function main() -> float {
  %c = lt @x, 10.0 : bool
  %r = if %c : (float, float) {
    %c2 = lt @x, 5.0 : bool
    %inner = if %c2 : float {
      %a = neg @x : float
      yield %a
    } else {
      %b = mul @x, 100.0 : float
      yield %b
    }
    yield %inner, @x
  } else {
    %c3 = lt @x, 20.0 : bool
    %inner2 = if %c3 : float {
      yield 0.5
    } else {
      yield @x
    }
    yield 7.0, %inner2
  }
  %first = extract.0 %r : float
  %second = extract.1 %r : float
  %sum = add %first, %second : float
  return %sum
}
main main)";

float NestedIfs(float x) {
  if (x < 10) return (x < 5 ? -x : x * 100) + x;
  return 7 + (x < 20 ? 0.5f : x);
}

TEST(Evaluate, NestedIfsTakeEachLanesSide) {
  Module module = ModuleFrom(kNestedIfs);
  std::vector<float> x =
      Lanes(200, [](uint32_t lane) { return static_cast<float>(lane * 37 % 30); });
  EXPECT_EQ(RunOn(module, x), Lanes(200, [&](uint32_t lane) { return NestedIfs(x[lane]); }));
}

TEST(Evaluate, IfsWhereAllLanesAgree) {
  Module module = ModuleFrom(kNestedIfs);
  for (float value : {0.0f, 7.0f, 15.0f, 25.0f}) {
    EXPECT_EQ(RunOn(module, std::vector<float>(64, value)),
              std::vector<float>(64, NestedIfs(value)));
  }
}

// --- Loops ---------------------------------------------------------------------------------------

TEST(Evaluate, LoopsCarryValues) {
  Module module = ModuleFrom(R"(input x: float
function main() -> (float, int, int) {
  %l = for %i = 2 to 11 step 3 (%sum = @x, %last = -1) : (float, int) {
    %f = convert %i : float
    %s = add %sum, %f : float
    yield %s, %i
  }
  %sum.2 = extract.0 %l : float
  %last.2 = extract.1 %l : int
  %down = for %k = 10 to 4 step -4 (%n = 0) : int {
    %n10 = mul %n, 100 : int
    %n11 = add %n10, %k : int
    yield %n11
  }
  return %sum.2, %last.2, %down
}
main main)");
  EvaluateInputs inputs;
  inputs.globals = {Bits({0, 1, 2, 3})};
  auto results = Evaluate(module, module.main, inputs);
  EXPECT_THAT(Floats(results[0]), ElementsAre(15, 16, 17, 18));  // 2 + 5 + 8
  EXPECT_THAT(results[1], ElementsAre(8, 8, 8, 8));
  EXPECT_THAT(results[2], ElementsAre(1006, 1006, 1006, 1006));  // 10, then 6
}

TEST(Evaluate, CarriedValuesChangeAllAtOnce) {
  // (a, b) becomes (b, a + b), and a vector's components change places: each reads what the other
  // was.
  Module module = ModuleFrom(R"(input x: float
function main() -> (float, vec2) {
  %start = construct @x, 5.0 : vec2
  %l = for %i = 0 to 9 step 1 (%a = 0.0, %b = 1.0, %v = %start, %w = vec2(7.0, 8.0)) : (float, float, vec2, vec2) {
    %next = add %a, %b : float
    %vx = extract.0 %v : float
    %wy = extract.1 %w : float
    %v2 = construct %wy, %vx : vec2
    yield %b, %next, %w, %v2
  }
  %a.2 = extract.0 %l : float
  %v.2 = extract.2 %l : vec2
  return %a.2, %v.2
}
main main)");
  EvaluateInputs inputs;
  inputs.globals = {Bits({1, 2, 3, 4})};
  auto results = Evaluate(module, module.main, inputs);
  EXPECT_THAT(Floats(results[0]), ElementsAre(34, 34, 34, 34));  // the ninth Fibonacci number
  for (uint32_t lane = 0; lane < 4; ++lane) {
    std::array<float, 2> v = {lane + 1.0f, 5}, w = {7, 8};
    for (int i = 0; i < 9; ++i) {
      std::array<float, 2> next = {w[1], v[0]};
      v = w;
      w = next;
    }
    EXPECT_EQ(Floats(results[1])[lane], v[0]);
    EXPECT_EQ(Floats(results[1])[4 + lane], v[1]);
  }
}

TEST(Evaluate, LoopsOfNoRoundsGiveTheFirstValues) {
  Module module = ModuleFrom(R"(input x: float
function main() -> (float, float) {
  %l = for %i = 3 to 3 step 1 (%a = @x, %b = 2.0) : (float, float) {
    yield %b, %b
  }
  %a.2 = extract.0 %l : float
  %m = for %k = 0 to 5 step -1 (%c = %a.2) : float {
    yield 9.0
  }
  %b.2 = extract.1 %l : float
  return %m, %b.2
}
main main)");
  EvaluateInputs inputs;
  inputs.globals = {Bits({1, 2, 3, 4})};
  auto results = Evaluate(module, module.main, inputs);
  EXPECT_THAT(Floats(results[0]), ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(Floats(results[1]), ElementsAre(2, 2, 2, 2));
}

TEST(Evaluate, NestedLoopsWithBranchesInside) {
  Module module = ModuleFrom(R"(input x: float
function main() -> float {
  %l = for %i = 0 to 4 step 1 (%sum = 0.0) : float {
    %m = for %k = 0 to 3 step 1 (%s = %sum) : float {
      %fi = convert %i : float
      %fk = convert %k : float
      %c = lt %fi, @x : bool
      %d = if %c : float {
        %p = mul %fi, %fk : float
        yield %p
      } else {
        yield 1.0
      }
      %t = add %s, %d : float
      yield %t
    }
    yield %m
  }
  return %l
}
main main)");
  auto expected = [](float x) {
    float sum = 0;
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 3; ++k) sum += i < x ? i * k : 1;
    }
    return sum;
  };
  std::vector<float> x = {0, 1.5f, 2.5f, 9};
  EXPECT_EQ(RunOn(module, x), Lanes(4, [&](uint32_t lane) { return expected(x[lane]); }));
}

// --- Calls and fields ----------------------------------------------------------------------------

TEST(Evaluate, CallsGiveOneOrSeveralResults) {
  Module module = ModuleFrom(R"(input x: float
function twice(%a: float) -> float {
  %b = add %a, %a : float
  return %b
}
function both(%a: float, %c: vec2) -> (float, vec2) {
  %b = call twice(%a) : float
  %d = call twice(%b) : float
  %e = construct %b, %d : vec2
  return %b, %e
}
function main() -> (float, vec2) {
  %r = call both(@x, vec2(0.0, 0.0)) : (float, vec2)
  %a = extract.0 %r : float
  %b = extract.1 %r : vec2
  return %a, %b
}
main main)");
  EvaluateInputs inputs;
  inputs.globals = {Bits({1, 2, 3, 4})};
  auto results = Evaluate(module, module.main, inputs);
  EXPECT_THAT(Floats(results[0]), ElementsAre(2, 4, 6, 8));
  EXPECT_THAT(Floats(results[1]), ElementsAre(2, 4, 6, 8, 4, 8, 12, 16));
}

TEST(Evaluate, FieldsAreFunctionsWithTheirLastParametersCaptured) {
  Module module = ModuleFrom(R"(input x: float
function wave(%p: float, %scale: float, %shift: float) -> float {
  %a = mul %p, %scale : float
  %b = add %a, %shift : float
  return %b
}
function around(%p: float, %image: field(float) -> float) -> float {
  %l = sub %p, 1.0 : float
  %r = add %p, 1.0 : float
  %a = call_field %image(%l) : float
  %b = call_field %image(%r) : float
  %c = mul %a, %b : float
  return %c
}
function main() -> (float, float) {
  %f = field wave(10.0, @x) : field(float) -> float
  %g = field around(%f) : field(float) -> float
  %direct = call around(5.0, %f) : float
  %nested = call around(5.0, %g) : float
  return %direct, %nested
}
main main)");
  auto wave = [](float p, float shift) { return p * 10 + shift; };
  auto around = [&](float p, float shift) { return wave(p - 1, shift) * wave(p + 1, shift); };
  EvaluateInputs inputs;
  inputs.globals = {Bits({1, 2, 3, 4})};
  auto results = Evaluate(module, module.main, inputs);
  for (uint32_t lane = 0; lane < 4; ++lane) {
    float shift = lane + 1.0f;
    EXPECT_EQ(Floats(results[0])[lane], around(5, shift));
    EXPECT_EQ(Floats(results[1])[lane], around(4, shift) * around(6, shift));
  }
}

TEST(Evaluate, AFieldInALoopCapturesThatRound) {
  Module module = ModuleFrom(R"(input x: float
function add_to(%p: float, %n: int) -> float {
  %f = convert %n : float
  %s = add %p, %f : float
  return %s
}
function apply(%f: field(float) -> float, %p: float) -> float {
  %r = call_field %f(%p) : float
  return %r
}
function main() -> float {
  %l = for %i = 0 to 5 step 1 (%sum = @x) : float {
    %f = field add_to(%i) : field(float) -> float
    %s = call apply(%f, %sum) : float
    yield %s
  }
  return %l
}
main main)");
  EXPECT_THAT(RunOn(module, {0, 100, 200, 300}), ElementsAre(10, 110, 210, 310));
}

TEST(Evaluate, CallsInsideBranchesAndLoops) {
  Module module = ModuleFrom(R"(input x: float
function half(%a: float) -> float {
  %c = lt %a, 1.0 : bool
  %r = if %c : float {
    yield %a
  } else {
    %h = mul %a, 0.5 : float
    yield %h
  }
  return %r
}
function main() -> float {
  %l = for %i = 0 to 10 step 1 (%v = @x) : float {
    %h = call half(%v) : float
    yield %h
  }
  return %l
}
main main)");
  EXPECT_THAT(RunOn(module, {0.25f, 1, 3, 1024}), ElementsAre(0.25f, 0.5f, 0.75f, 1));
}

// --- Quads ---------------------------------------------------------------------------------------

TEST(Evaluate, DerivativesAreDifferencesInTheQuad) {
  Module module = ModuleFrom(R"(input x: float
function main() -> (float, float, float, float) {
  %a = dfdx @x : float
  %b = dfdy @x : float
  %c = dx @x : float
  %d = dy @x : float
  return %a, %b, %c, %d
}
main main)");
  EvaluateInputs inputs;
  inputs.lanes = 8;
  // Left bottom, right bottom, left top, right top.
  inputs.globals = {Bits({1, 3, 11, 18, 0, 0, 5, 6})};
  auto results = Evaluate(module, module.main, inputs);
  for (int i : {0, 2}) {
    EXPECT_THAT(Floats(results[i]), ElementsAre(2, 2, 7, 7, 0, 0, 1, 1));
    EXPECT_THAT(Floats(results[i + 1]), ElementsAre(10, 15, 10, 15, 5, 6, 5, 6));
  }
}

TEST(Evaluate, DerivativesInABranchAreThoseOfTheWholeQuad) {
  // Only the first pixel takes the branch; its neighbours run it as helpers, in the nested branch
  // as well.
  Module module = ModuleFrom(R"(input x: float
function main() -> float {
  %c = lt @x, 2.0 : bool
  %r = if %c : float {
    %square = mul @x, @x : float
    %c2 = lt @x, 4.0 : bool
    %v = if %c2 : float {
      %twice = add %square, %square : float
      yield %twice
    } else {
      %other = neg %square : float
      yield %other
    }
    %d = dx %v : float
    yield %d
  } else {
    yield 0.0
  }
  return %r
}
main main)");
  // 2 * 1 and -(5 * 5): the right pixel takes the other side of the inner branch.
  EXPECT_THAT(RunOn(module, {1, 5, 7, 8}), ElementsAre(-27, 0, 0, 0));
  // Beside other quads the same.
  std::vector<float> many = {9, 9, 9, 9, 1, 5, 7, 8, 3, 3, 3, 3, 1, 1, 1, 1};
  EXPECT_THAT(RunOn(module, many), ElementsAre(0, 0, 0, 0, -27, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0));
}

// --- Textures ------------------------------------------------------------------------------------

// Level l is everywhere 10 l.
Texture Staircase(uint32_t size) {
  Texture texture;
  float red = 0;
  for (; size > 0; size /= 2, red += 10) {
    texture.levels.push_back({size, size, 1, std::vector<Texel>(size * size, Texel{red, 0, 0, 1})});
  }
  return texture;
}

TEST(Evaluate, ImplicitSamplesTakeTheLevelOfTheQuad) {
  Module module = ModuleFrom(R"(input uv: vec2
texture map: sampler2D
function main() -> (vec4, vec4) {
  %a = sample @map, @uv : vec4
  %b = sample @map, @uv, 1.5 : vec4
  return %a, %b
}
main main)");
  Texture texture = Staircase(16);
  EvaluateInputs inputs;
  inputs.lanes = 8;
  // First quad: 4 texels a pixel along x, 1 along y. Second: 2 texels along y.
  inputs.globals = {Bits({0, 0.25f, 0, 0.25f, 0, 0, 0, 0,  //
                          0, 0, 0.0625f, 0.0625f, 0, 0, 0.125f, 0.125f})};
  inputs.textures = {nullptr, &texture};
  auto results = Evaluate(module, module.main, inputs);
  std::vector<float> red = Floats(results[0]);
  EXPECT_THAT(std::vector<float>(red.begin(), red.begin() + 8),
              ElementsAre(20, 20, 20, 20, 10, 10, 10, 10));
  red = Floats(results[1]);
  EXPECT_THAT(std::vector<float>(red.begin(), red.begin() + 8),
              ElementsAre(35, 35, 35, 35, 25, 25, 25, 25));
}

TEST(Evaluate, ExplicitSamplesFetchesAndSizes) {
  Module module = ModuleFrom(R"(input x: float
texture map: sampler2D
function look(%s: sampler2D, %x: float) -> (vec4, vec4, vec4, ivec2) {
  %uv = splat %x : vec2
  %a = sample_grad %s, %uv, vec2(0.25, 0.0), vec2(0.0, 0.5) : vec4
  %b = sample_lod %s, %uv, %x : vec4
  %i = convert %x : int
  %c = fetch %s, ivec2(0, 0), %i : vec4
  %d = texture_size %s, %i : ivec2
  return %a, %b, %c, %d
}
function main() -> (vec4, vec4, vec4, ivec2) {
  %r = call look(@map, @x) : (vec4, vec4, vec4, ivec2)
  %a = extract.0 %r : vec4
  %b = extract.1 %r : vec4
  %c = extract.2 %r : vec4
  %d = extract.3 %r : ivec2
  return %a, %b, %c, %d
}
main main)");
  Texture texture = Staircase(16);
  EvaluateInputs inputs;
  inputs.globals = {Bits({0, 1, 2.5f, 99})};
  inputs.textures = {nullptr, &texture};
  auto results = Evaluate(module, module.main, inputs);
  auto red = [&](int i) {
    std::vector<float> values = Floats(results[i]);
    return std::vector<float>(values.begin(), values.begin() + 4);
  };
  EXPECT_THAT(red(0), ElementsAre(30, 30, 30, 30));  // 8 texels along y
  EXPECT_THAT(red(1), ElementsAre(0, 10, 25, 40));
  EXPECT_THAT(red(2), ElementsAre(0, 10, 20, 0));
  EXPECT_THAT(results[3], ElementsAre(16, 8, 4, 0, 16, 8, 4, 0));
}

TEST(Evaluate, WhatHasNoTextureIsBlack) {
  Module module = ModuleFrom(R"(texture map: sampler2D
function main() -> vec4 {
  %a = sample @map, vec2(0.0, 0.0) : vec4
  return %a
}
main main)");
  EvaluateInputs inputs;
  EXPECT_THAT(Floats(Evaluate(module, module.main, inputs)[0]),
              ElementsAre(0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1));
}

// Each call needs 8 kB for 64 lanes: 60,000 of them would take 480 MB if they kept it.
TEST(Evaluate, CallsGiveTheirMemoryBack) {
  Module module = ModuleFrom(R"(input x: float
function f(%a: float) -> float {
  %v = splat %a : mat4
  %w = add %v, %v : mat4
  %c = extract.1 %w : vec4
  %r = extract.2 %c : float
  return %r
}
function main() -> float {
  %l = for %i = 0 to 60000 step 1 (%s = @x) : float {
    %r = call f(1.5) : float
    yield %r
  }
  return %l
}
main main)");
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  EXPECT_EQ(RunOn(module, std::vector<float>(64, 0.0f)), std::vector<float>(64, 3.0f));
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 100 * 1024);  // in kB
}

// --- Limits --------------------------------------------------------------------------------------

std::string ChainOfCalls(uint32_t length) {
  std::string text = "function f0(%x: float) -> float { return %x }\n";
  for (uint32_t i = 1; i < length; ++i) {
    std::string n = std::to_string(i), before = std::to_string(i - 1);
    text += "function f" + n + "(%x: float) -> float { %y = call f" + before +
            "(%x) : float %z = add %y, 1.0 : float return %z }\n";
  }
  return text;
}

TEST(Evaluate, CallsNestToTheLimit) {
  Module module = ModuleFrom(ChainOfCalls(kMaxCallDepth));
  EvaluateInputs inputs;
  std::vector<std::vector<uint32_t>> arguments = {Bits({1, 2, 3, 4})};
  auto results = Evaluate(module, FunctionId(kMaxCallDepth - 1), inputs, arguments);
  EXPECT_THAT(Floats(results[0]), ElementsAre(256, 257, 258, 259));
}

TEST(EvaluateDeathTest, DeeperCallsEndWithAMessage) {
  Module module = ModuleFrom(ChainOfCalls(kMaxCallDepth + 1));
  EvaluateInputs inputs;
  std::vector<std::vector<uint32_t>> arguments = {Bits({1, 2, 3, 4})};
  EXPECT_DEATH(Evaluate(module, FunctionId(kMaxCallDepth), inputs, arguments),
               "nest deeper than 256");
}

TEST(EvaluateDeathTest, WrongInputsEndWithAMessage) {
  Module module = ModuleFrom("input x: vec2\nfunction f(%y: float) -> float { return %y }");
  EvaluateInputs inputs;
  std::vector<std::vector<uint32_t>> arguments = {Bits({1, 2, 3, 4})};
  EXPECT_DEATH(Evaluate(module, FunctionId(0), inputs), "arguments of the wrong number for f");
  std::vector<std::vector<uint32_t>> short_arguments = {Bits({1, 2})};
  EXPECT_DEATH(Evaluate(module, FunctionId(0), inputs, short_arguments),
               "words of the wrong number for y");
  inputs.globals = {Bits({1})};
  EXPECT_DEATH(Evaluate(module, FunctionId(0), inputs, arguments),
               "words of the wrong number for x");
  inputs.globals = {};
  inputs.lanes = 5;
  EXPECT_DEATH(Evaluate(module, FunctionId(0), inputs, arguments), "no whole quads");
}

}  // namespace
}  // namespace texgraph::ir
