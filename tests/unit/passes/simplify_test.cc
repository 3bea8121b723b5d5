// SPDX-License-Identifier: Apache-2.0
// Simplify on whole modules, text in and text out.
#include "compiler/passes/simplify.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>

#include <string>
#include <utility>
#include <vector>

#include "compiler/ir/builder.h"
#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"
#include "tests/unit/ir/module_text.h"

namespace texgraph::passes {
namespace {

std::string Simplified(std::string text) {
  ir::Module module = ir::ModuleFrom(std::move(text));
  if (!module.main) return "no module";
  Simplify(module);
  EXPECT_EQ(ir::Verify(module), "");
  return ir::Print(module);
}

TEST(Simplify, DropsWhatNothingUses) {
  EXPECT_EQ(Simplified(R"(input uv: vec2
input position: vec3
uniform tint: vec3 = vec3(1.0, 1.0, 1.0)
texture brick: sampler2D
texture stain: sampler2D
function unused(%p: vec2) -> vec4 {
  %0 = sample @brick, %p : vec4
  return %0
}
function main() -> (color: vec4) {
  %0 = call unused(@uv) : vec4
  %1 = sample @stain, @uv : vec4
  %2 = mul @tint, vec3(2.0, 2.0, 2.0) : vec3
  return %1
}
main main
)"),
            R"(input uv: vec2
texture stain: sampler2D
function main() -> (color: vec4) {
  %0 = sample @stain, @uv : vec4
  return %0
}
main main
)");
}

// Differentiate says which functions it changed; only these are looked at again.
TEST(Simplify, AfterDifferentiateOnlyWhatChanged) {
  constexpr const char* kText = R"(input uv: vec2
texture brick: sampler2D
function plain(%p: vec2) -> vec4 {
  %0 = mul %p, vec2(3.0, 3.0) : vec2
  %1 = sample @brick, %0 : vec4
  %2 = sin %1 : vec4
  %3 = cos %2 : vec4
  return %3
}
function rough(%p: vec2) -> vec4 {
  %0 = fract %p : vec2
  %1 = sample @brick, %0 : vec4
  %2 = sin %1 : vec4
  %3 = cos %2 : vec4
  return %3
}
function main() -> (color: vec4) {
  %0 = call plain(@uv) : vec4
  %1 = call rough(@uv) : vec4
  %2 = add %0, %1 : vec4
  return %2
}
main main
)";
  ir::Module some = ir::ModuleFrom(kText), all = ir::ModuleFrom(kText);
  Simplify(some);
  Simplify(all);
  const std::vector<bool> changed = Differentiate(some, true);
  Differentiate(all, true);
  ASSERT_EQ(changed.size(), some.functions.size());
  for (size_t f = 0; f < changed.size(); ++f) {
    EXPECT_EQ(changed[f], some.functions[f].display_name != "plain") << some.functions[f].name;
  }
  Simplify(some, changed);
  Simplify(all);
  EXPECT_EQ(ir::Verify(some), "");
  EXPECT_EQ(ir::Print(some), ir::Print(all));
}

TEST(Simplify, RulesLeaveNoDeadOperands) {
  EXPECT_EQ(Simplified(R"(input a: float
input b: float
function main() -> (x: float, y: float) {
  %n = neg @b : float
  %sum = add @a, %n : float
  %m = neg @a : float
  %same = neg %m : float
  return %sum, %same
}
main main
)"),
            R"(input a: float
input b: float
function main() -> (x: float, y: float) {
  %sum = sub @a, @b : float
  return %sum, @a
}
main main
)");
}

TEST(Simplify, UnusedParametersAndResultsGo) {
  EXPECT_EQ(Simplified(R"(input uv: vec2
input time: float
function deep(%p: vec2, %t: float, %q: vec2) -> (vec2, float) {
  %0 = sin %p : vec2
  %1 = cos %0 : vec2
  %2 = sin %t : float
  return %1, %2
}
function shallow(%p: vec2, %t: float, %q: vec2) -> (vec2, height: float) {
  %0 = call deep(%p, %t, %q) : (vec2, float)
  %1 = extract.0 %0 : vec2
  %2 = extract.1 %0 : float
  %3 = tan %1 : vec2
  return %3, %2
}
function main() -> (color: vec2) {
  %0 = cos @uv : vec2
  %1 = call shallow(@uv, @time, %0) : (vec2, float)
  %2 = extract.0 %1 : vec2
  return %2
}
main main
)"),
            R"(input uv: vec2
function deep(%p: vec2) -> vec2 {
  %0 = sin %p : vec2
  %1 = cos %0 : vec2
  return %1
}
function shallow(%p: vec2) -> vec2 {
  %0 = call deep(%p) : vec2
  %1 = tan %0 : vec2
  return %1
}
function main() -> (color: vec2) {
  %0 = call shallow(@uv) : vec2
  return %0
}
main main
)");
}

TEST(Simplify, ConstantThatEveryCallPassesMovesIn) {
  EXPECT_EQ(Simplified(R"(input uv: vec2
function wave(%p: vec2, %scale: float, %by: float) -> vec2 {
  %0 = splat %scale : vec2
  %1 = mul %p, %0 : vec2
  %2 = sin %1 : vec2
  %3 = splat %by : vec2
  %4 = mul %2, %3 : vec2
  return %4
}
function twice(%p: vec2, %scale: float) -> vec2 {
  %0 = call wave(%p, %scale, 3.0) : vec2
  %1 = call wave(%0, 5.0, 2.0) : vec2
  return %1
}
function main() -> (color: vec2) {
  %0 = call twice(@uv, 5.0) : vec2
  return %0
}
main main
)"),
            R"(input uv: vec2
function wave(%p: vec2, %by: float) -> vec2 {
  %0 = mul %p, vec2(5.0, 5.0) : vec2
  %1 = sin %0 : vec2
  %2 = splat %by : vec2
  %3 = mul %1, %2 : vec2
  return %3
}
function twice(%p: vec2) -> vec2 {
  %0 = call wave(%p, 3.0) : vec2
  %1 = call wave(%0, 2.0) : vec2
  return %1
}
function main() -> (color: vec2) {
  %0 = call twice(@uv) : vec2
  return %0
}
main main
)");
}

// Two parameters that always get one value are one; where one call tells them apart they stay.
TEST(Simplify, ParametersThatAreAlwaysTheSameBecomeOne) {
  const std::string text = R"(input uv: vec2
input time: float
function wave(%p: vec2, %t: float, %q: vec2) -> vec2 {
  %0 = sin %p : vec2
  %1 = sin %q : vec2
  %2 = mul %0, %1 : vec2
  %3 = splat %t : vec2
  %4 = atan2 %2, %3 : vec2
  %5 = cos %4 : vec2
  %6 = exp %5 : vec2
  return %6
}
function main() -> (color: vec2) {
  %0 = cos @uv : vec2
  %1 = call wave(@uv, @time, @uv) : vec2
  %2 = call wave(%0, @time, OTHER) : vec2
  %3 = add %1, %2 : vec2
  return %3
}
main main
)";
  auto with = [&](std::string_view other) {
    std::string changed = text;
    return Simplified(changed.replace(changed.find("OTHER"), 5, other));
  };
  EXPECT_THAT(with("%0"), testing::HasSubstr("function wave(%p: vec2, %t: float) -> vec2 {"));
  EXPECT_THAT(with("%0"), testing::HasSubstr("mul %0, %0"));
  EXPECT_THAT(with("@uv"), testing::HasSubstr("function wave(%p: vec2, %t: float, %q: vec2)"));
}

// Where all textures that a function gets repeat, so does its own; one that does not takes that away
// again.
TEST(Simplify, WhatRepeatsIsKnownInFunctions) {
  const std::string text = R"(input uv: vec2
texture brick: sampler2D repeats
texture leaf: sampler2D
function shown(%s: sampler2D, %p: vec2) -> vec4 {
  %0 = mul %p, vec2(8.0, 8.0) : vec2
  %1 = floor %0 : vec2
  %2 = sub %0, %1 : vec2
  %3 = sample %s, %2 : vec4
  %4 = sin %3 : vec4
  %5 = exp %4 : vec4
  return %5
}
function inner(%s: sampler2D, %p: vec2) -> vec4 {
  %0 = call shown(%s, %p) : vec4
  %1 = cos %p : vec2
  %2 = call shown(%s, %1) : vec4
  %3 = mul %0, %2 : vec4
  return %3
}
function main() -> (color: vec4) {
  %0 = cos @uv : vec2
  %1 = call inner(@brick, @uv) : vec4
  %2 = call inner(OTHER, %0) : vec4
  %3 = mul %1, %2 : vec4
  return %3
}
main main
)";
  auto with = [&](std::string_view other) {
    std::string changed = text;
    return Simplified(changed.replace(changed.find("OTHER"), 5, other));
  };
  const std::string known = with("@brick");
  EXPECT_THAT(known, testing::HasSubstr("function shown(%s: sampler2D repeats, %p: vec2)"));
  EXPECT_THAT(known, testing::Not(testing::HasSubstr("floor")));
  EXPECT_EQ(Simplified(known), known);
  const std::string unknown = with("@leaf");
  EXPECT_THAT(unknown, testing::HasSubstr("function shown(%s: sampler2D, %p: vec2)"));
  EXPECT_THAT(unknown, testing::HasSubstr("floor"));
}

TEST(Simplify, TrivialFunctionsStandWhereTheyAreCalled) {
  EXPECT_EQ(Simplified(R"(input uv: vec2
input time: float
function first(%a: vec2, %b: vec2) -> vec2 {
  return %a
}
function constant(%a: vec2) -> (vec2, vec2) {
  %0 = sin %a : vec2
  %1 = cos %0 : vec2
  return vec2(1.0, 2.0), %1
}
function small(%a: vec2, %b: float) -> vec2 {
  %0 = splat %b : vec2
  %1 = mul %a, %0 : vec2
  %2 = add %1, vec2(0.5, 0.5) : vec2
  return %2
}
function main() -> (x: vec2, y: vec2, z: vec2, w: vec2) {
  %0 = call first(@uv, @uv) : vec2
  %1 = call constant(%0) : (vec2, vec2)
  %2 = extract.0 %1 : vec2
  %3 = extract.1 %1 : vec2
  %4 = call small(@uv, @time) : vec2
  return %0, %2, %3, %4
}
main main
)"),
            R"(input uv: vec2
input time: float
function constant(%a: vec2) -> vec2 {
  %0 = sin %a : vec2
  %1 = cos %0 : vec2
  return %1
}
function main() -> (x: vec2, y: vec2, z: vec2, w: vec2) {
  %0 = call constant(@uv) : vec2
  %1 = splat @time : vec2
  %2 = mul @uv, %1 : vec2
  %3 = add %2, vec2(0.5, 0.5) : vec2
  return @uv, vec2(1.0, 2.0), %0, %3
}
main main
)");
}

TEST(Simplify, FunctionsUsedAsValuesKeepTheirSignatures) {
  constexpr char kText[] = R"(input uv: vec2
function noise(%p: vec2, %unused: float) -> float {
  %0 = sin %p : vec2
  %1 = length %0 : float
  return %1
}
function main() -> (x: float) {
  %0 = field noise(2.0) : field(vec2) -> float
  %1 = call_field %0(@uv) : float
  return %1
}
main main
)";
  EXPECT_EQ(Simplified(kText), kText);
}

TEST(Simplify, SidesOfAnIfKnowItsCondition) {
  EXPECT_EQ(Simplified(R"(input a: float
input b: float
function main() -> (x: float) {
  %p = lt @a, 1.0 : bool
  %q = lt @b, 2.0 : bool
  %both = land %p, %q : bool
  %0 = if %both : float {
    %1 = select %p, @a, @b : float
    %2 = sin %1 : float
    %not = lnot %q : bool
    %3 = select %not, 3.0, %2 : float
    yield %3
  } else {
    %4 = cos @a : float
    %5 = select %both, %4, @b : float
    %6 = tan %5 : float
    yield %6
  }
  return %0
}
main main
)"),
            R"(input a: float
input b: float
function main() -> (x: float) {
  %p = lt @a, 1.0 : bool
  %q = lt @b, 2.0 : bool
  %both = land %p, %q : bool
  %0 = if %both : float {
    %1 = sin @a : float
    yield %1
  } else {
    %2 = tan @b : float
    yield %2
  }
  return %0
}
main main
)");
}

// Both sides are empty once the rules have run: it is a select, and of these values a minimum.
TEST(Simplify, BranchesWithoutWorkBecomeChoices) {
  EXPECT_EQ(Simplified(R"(input a: float
input b: float
function main() -> (x: float, y: float) {
  %p = lt @a, @b : bool
  %0 = if %p : (float, float) {
    %1 = mul @a, 1.0 : float
    yield %1, @b
  } else {
    %2 = add @b, -0.0 : float
    yield %2, @b
  }
  %3 = extract.0 %0 : float
  %4 = extract.1 %0 : float
  return %3, %4
}
main main
)"),
            R"(input a: float
input b: float
function main() -> (x: float, y: float) {
  %0 = min @b, @a : float
  return %0, @b
}
main main
)");
}

TEST(Simplify, LoopsCarryOnlyWhatChanges) {
  EXPECT_EQ(Simplified(R"(input a: float
input b: vec2
function main() -> (x: float, y: vec2, z: float, w: float) {
  %0 = for %i = 0 to 4 step 1 (%sum = 0.0, %kept = @b, %dead = @a, %last = 1.0) : (float, vec2, float, float) {
    %1 = convert %i : float
    %2 = dot %kept, vec2(3.0, 4.0) : float
    %3 = mul %1, %2 : float
    %4 = add %sum, %3 : float
    %5 = add %kept, vec2(-0.0, -0.0) : vec2
    %6 = sin %dead : float
    yield %4, %5, %6, @a
  }
  %7 = extract.0 %0 : float
  %8 = extract.1 %0 : vec2
  %9 = extract.3 %0 : float
  %10 = for %j = 3 to 3 step 1 (%none = @a) : float {
    %11 = sin %none : float
    yield %11
  }
  return %7, %8, %9, %10
}
main main
)"),
            R"(input a: float
input b: vec2
function main() -> (x: float, y: vec2, z: float, w: float) {
  %0 = for %i = 0 to 4 step 1 (%sum = 0.0) : float {
    %1 = convert %i : float
    %2 = dot @b, vec2(3.0, 4.0) : float
    %3 = mul %1, %2 : float
    %4 = add %sum, %3 : float
    yield %4
  }
  return %0, @b, @a, @a
}
main main
)");
}

// Choices of what it was before the loop and of what it is; a loop inside that goes on with it.
TEST(Simplify, LoopsDoNotCarryWhatChoicesLeaveAlone) {
  EXPECT_EQ(Simplified(R"(input b: vec2
function main() -> (x: float, y: vec2, z: vec2) {
  %0 = for %i = 0 to 4 step 1 (%best = 0.0, %slope = @b, %other = @b) : (float, vec2, vec2) {
    %1 = for %j = 0 to 3 step 1 (%inner = %best, %same = %slope, %new = %other) : (float, vec2, vec2) {
      %2 = convert %j : float
      %3 = sin %inner : float
      %4 = lt %3, %2 : bool
      %5 = select %4, %2, %3 : float
      %6 = select %4, @b, %same : vec2
      %7 = select %4, vec2(1.0, 2.0), %new : vec2
      yield %5, %6, %7
    }
    %8 = extract.0 %1 : float
    %9 = extract.1 %1 : vec2
    %10 = extract.2 %1 : vec2
    yield %8, %9, %10
  }
  %11 = extract.0 %0 : float
  %12 = extract.1 %0 : vec2
  %13 = extract.2 %0 : vec2
  return %11, %12, %13
}
main main
)"),
            R"(input b: vec2
function main() -> (x: float, y: vec2, z: vec2) {
  %0 = for %i = 0 to 4 step 1 (%best = 0.0, %other = @b) : (float, vec2) {
    %1 = for %j = 0 to 3 step 1 (%inner = %best, %new = %other) : (float, vec2) {
      %2 = convert %j : float
      %3 = sin %inner : float
      %4 = lt %3, %2 : bool
      %5 = max %3, %2 : float
      %6 = select %4, vec2(1.0, 2.0), %new : vec2
      yield %5, %6
    }
    %7 = extract.0 %1 : float
    %8 = extract.1 %1 : vec2
    yield %7, %8
  }
  %9 = extract.0 %0 : float
  %10 = extract.1 %0 : vec2
  return %9, @b, %10
}
main main
)");
}

TEST(Simplify, NamesAndOriginsStay) {
  EXPECT_EQ(Simplified(R"(origin #0 = "face" "layer" "layers/layer.glsl"
origin #1 = "grid" "brick_grid" "tiling/brick_grid.glsl"
input uv: vec2
function layer(%p: vec2) -> vec2 #0 {
  %scaled = mul %p, vec2(3.0, 4.0) : vec2
  %wave = sin %scaled : vec2 #1
  %curl = cos %wave : vec2
  return %curl
}
function main() -> (color: vec2) {
  %face = call layer(@uv) : vec2 #0
  return %face
}
main main
)"),
            R"(origin #0 = "face" "layer" "layers/layer.glsl"
origin #1 = "grid" "brick_grid" "tiling/brick_grid.glsl"
input uv: vec2
function layer(%p: vec2) -> vec2 #0 {
  %scaled = mul %p, vec2(3.0, 4.0) : vec2
  %wave = sin %scaled : vec2 #1
  %curl = cos %wave : vec2
  return %curl
}
function main() -> (color: vec2) {
  %face = call layer(@uv) : vec2 #0
  return %face
}
main main
)");
}

TEST(Simplify, ExactRulesLeaveTheRest) {
  constexpr char kText[] = R"(input a: float
function main() -> (x: float, y: float) {
  %0 = mul @a, 0.0 : float
  %1 = neg @a : float
  %2 = neg %1 : float
  return %0, %2
}
main main
)";
  ir::Module module = ir::ModuleFrom(kText);
  Simplify(module, kExact);
  EXPECT_EQ(ir::Print(module), R"(input a: float
function main() -> (x: float, y: float) {
  %0 = mul @a, 0.0 : float
  return %0, @a
}
main main
)");
}

// Constants reach the end of a long chain of calls, and unused results its beginning.
TEST(Simplify, FixPointThroughManyCalls) {
  std::string text = "input a: float\n";
  text +=
      "function f0(%p: float, %k: float) -> (float, float) {\n"
      "  %0 = sin %p : float\n  %1 = mul %0, %k : float\n  %2 = cos %p : float\n  return %1, "
      "%2\n}\n";
  for (int i = 1; i < 50; ++i) {
    std::string number = std::to_string(i);
    text +=
        "function f" + number +
        "(%p: float, %k: float) -> (float, float) {\n  %0 = sin %p : float\n" +
        "  %1 = mul %k, 1.0 : float\n" + "  %2 = call f" + std::to_string(i - 1) +
        "(%0, %1) : (float, float)\n  %3 = extract.0 %2 : float\n  %4 = extract.1 %2 : float\n" +
        "  %5 = tan %4 : float\n  %6 = cos %3 : float\n  return %6, %5\n}\n";
  }
  text +=
      "function main() -> (x: float) {\n  %0 = call f49(@a, 0.0) : (float, float)\n"
      "  %1 = extract.0 %0 : float\n  return %1\n}\nmain main\n";
  std::string once = Simplified(text);
  EXPECT_EQ(once.find("%k"), std::string::npos);
  EXPECT_EQ(once.find("tan"), std::string::npos);
  EXPECT_EQ(Simplified(once), once);
}

// A chain of 50,000 operations, on a stack of 256 kB: nothing recurses along it. Every second
// operation can be simplified away, and the last rule applies only when those before it did.
ir::Module LongChain() {
  ir::Module module;
  ir::GlobalId input = module.AddGlobal({ir::GlobalKind::kInput, "a", ir::kFloat, {}});
  ir::Function function;
  function.name = "main";
  {
    ir::Builder builder(module, function, {.fold = false});
    ir::ValueId v = builder.Global(input);
    for (int i = 0; i < 25000; ++i) {
      v = builder.Op2(ir::Op::kMul, v, builder.Float(1));
      v = i % 2 ? builder.Op1(ir::Op::kSin, v)
                : builder.Op1(ir::Op::kNeg, builder.Op1(ir::Op::kNeg, v));
    }
    builder.Return({{v}});
  }
  module.functions.push_back(std::move(function));
  module.main = ir::FunctionId(0);
  return module;
}

TEST(Simplify, LongChainsNeedNoStack) {
  ir::Module module = LongChain();
  pthread_attr_t attributes;
  ASSERT_EQ(pthread_attr_init(&attributes), 0);
  ASSERT_EQ(pthread_attr_setstacksize(&attributes, 256 * 1024), 0);
  pthread_t thread;
  auto run = [](void* data) -> void* {
    Simplify(*static_cast<ir::Module*>(data));
    return nullptr;
  };
  ASSERT_EQ(pthread_create(&thread, &attributes, run, &module), 0);
  ASSERT_EQ(pthread_join(thread, nullptr), 0);
  pthread_attr_destroy(&attributes);
  EXPECT_EQ(module[module.main].Body().body.size(), 12501u);  // the input, and the sines
}

}  // namespace
}  // namespace texgraph::passes
