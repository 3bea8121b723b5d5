// SPDX-License-Identifier: Apache-2.0
// The text form: what is printed, what is read, and that one is the inverse of the other.
#include "compiler/ir/print.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <random>

#include "compiler/ir/builder.h"
#include "compiler/ir/verify.h"
#include "tests/unit/ir/module_text.h"

namespace texgraph::ir {
namespace {

// Every construct of the form, as Print writes it.
constexpr char kEverything[] = R"(struct Tile { cell: ivec2, local: vec2, seed: uint }
struct Pair { tile: Tile, weights: float[3] }
origin #0 = "face" "layer" "layers/layer.glsl"
origin #1 = "" "noise \"x\"\\" "a\tb.glsl"
input uv: vec2
uniform tint: vec3 = vec3(1.0, 0.5, 0.1)
uniform bare: mat2
specialization rows: int = 12
texture brick: sampler2D
texture ids: sampler2DArray not smooth
texture "odd name": sampler3D
texture where: sampler2D not smooth map 2 x 1 x 1 (3, -1)
texture leaves: sampler2DArray not smooth map 16 x 8 x 2
function noise_at(%p: vec2, %scale: float) -> float {
  %0 = splat %scale : vec2
  %1 = dot %p, %0 : float
  return %1
}
function layer_2 as layer(%tile: Tile, const %blend: int, %image: field(vec2) -> float, %map: sampler2D) -> (vec4, coverage: float) #0 {
  %local = extract.1 %tile : vec2
  %scaled = mul %local, vec2(2.0, -0.0) : vec2
  %scaled.2 = add %scaled, %scaled : vec2 #1
  %0 = swizzle.yxy %scaled : vec3
  %1 = sample @brick, %scaled : vec4
  %2 = sample %map, %local, -1.5 : vec4
  %3 = lt %blend, 2 : bool
  %4 = if %3 : (float, vec2) {
    %5 = call noise_at(%local, 3.0) : float
    yield %5, %local
  } else {
    %inner = if true : vec2 {
      yield %local
    } else {
      yield vec2(1e20, 1e-45)
    }
    yield inf, %inner
  }
  %6 = for %i = 0 to 4 step 1 (%sum = 0.0, %v = %local) : (float, vec2) {
    %7 = convert %i : float
    %8 = add %sum, %7 : float
    yield %8, %v
  }
  %9 = for %i.2 = 10 to -10 step -3 (%k = 7u) : uint {
    yield %k
  }
  %10 = field noise_at(2.5) : field(vec2) -> float
  %11 = call_field %10(%local) : float
  %12 = call_field %image(%scaled) : float
  %13 = index float[3](1.0, 2.0, -inf), 1 : float
  %14 = construct %tile, float[3](nan, bits(0x7fc00001), 3.0) : Pair
  %15 = construct %11, %12 : vec2
  %16 = construct vec2(1.0, 2.0), %15 : mat2
  %17 = matmul %16, @bare : mat2
  %18 = sample_grad @"odd name", %0, %0, %0 : vec4
  return %1, %13
}
function main() -> (color: vec4, height: float) {
  %0 = convert ivec2(-2147483648, 2147483647) : vec2
  %tile = construct ivec2(1, 2), @uv, 4294967295u : Tile
  %1 = field noise_at(1.0) : field(vec2) -> float
  %face = call layer_2(%tile, @rows, %1, @brick) : (vec4, float)
  %2 = extract.0 %face : vec4
  %3 = extract.1 %face : float
  return %2, %3
}
main main
)";

TEST(Print, EverythingReadsBack) {
  Module module = ModuleFrom(kEverything);
  EXPECT_EQ(Print(module), kEverything);
}

TEST(Print, WhatIsReadIsWhatTheTextSays) {
  Module module = ModuleFrom(kEverything);
  ASSERT_EQ(module.functions.size(), 3u);
  const Function& layer = module.functions[1];
  EXPECT_EQ(layer.name, "layer_2");
  EXPECT_EQ(layer.display_name, "layer");
  EXPECT_EQ(layer.origin, OriginId(0));
  EXPECT_EQ(module.origins[1].block, "noise \"x\"\\");
  EXPECT_EQ(module.origins[1].source, "a\tb.glsl");
  ASSERT_EQ(layer.parameters.size(), 4u);
  EXPECT_EQ(layer.parameters[1].name, "blend");
  EXPECT_TRUE(layer.parameters[1].is_template);
  EXPECT_FALSE(layer.parameters[0].is_template);
  EXPECT_EQ(layer.results[0].name, "");
  EXPECT_EQ(layer.results[1].name, "coverage");
  // The second value named "scaled": the same name in the side table, another origin.
  ValueId second = layer.Body().body[2];
  EXPECT_EQ(module.Name(layer.NameOf(second)), "scaled");
  EXPECT_EQ(layer.OriginOf(second), OriginId(1));
  EXPECT_EQ(layer.OriginOf(layer.Body().body[0]), OriginId(0));
  ASSERT_EQ(layer.loops.size(), 2u);
  EXPECT_EQ(layer.loops[1].first, 10);
  EXPECT_EQ(layer.loops[1].last, -10);
  EXPECT_EQ(layer.loops[1].step, -3);
  EXPECT_FALSE(module.globals[5].is_smooth);
  EXPECT_EQ(module.globals[6].name, "odd name");
  EXPECT_FALSE(module.globals[6].map);
  ASSERT_TRUE(module.globals[7].map);
  EXPECT_EQ(module.globals[7].map->width, 2u);
  EXPECT_EQ(module.globals[7].map->height, 1u);
  EXPECT_EQ(module.globals[7].map->values, (std::vector<int32_t>{3, -1}));
  ASSERT_TRUE(module.globals[8].map);
  EXPECT_EQ(module.globals[8].map->layers, 2u);
  EXPECT_TRUE(module.globals[8].map->values.empty());
  EXPECT_FALSE(module.globals[2].value.valid());
  ASSERT_TRUE(module.globals[3].value.valid());
  EXPECT_EQ(module.Words(module.globals[3].value)[0], 12u);
  EXPECT_EQ(module.main, FunctionId(2));
}

TEST(Print, EveryFloatReadsBackAsItsBits) {
  std::mt19937 random(3);
  std::vector<uint32_t> words = {0,          0x80000000, 1,          0x007fffff,
                                 0x00800000, 0x7f7fffff, 0x7f800000, 0xff800000,
                                 0x7fc00000, 0xffc00000, 0x7f800001, 0x3dcccccd};
  for (int i = 0; i < 2000; ++i) words.push_back(static_cast<uint32_t>(random()));
  for (uint32_t word : words) {
    Module module;
    ConstId id = module.Intern(kFloat, {{word}});
    module.AddGlobal({GlobalKind::kUniform, "x", kFloat, id});
    Module again = ModuleFrom(Print(module));
    ASSERT_EQ(again.globals.size(), 1u);
    EXPECT_EQ(again.Words(again.globals[0].value)[0], word) << Print(module);
  }
}

TEST(Print, ShortestLiterals) {
  Module module;
  auto literal = [&](float value) {
    Module m;
    ConstId id = m.Intern(kFloat, {{std::bit_cast<uint32_t>(value)}});
    m.AddGlobal({GlobalKind::kUniform, "x", kFloat, id});
    return Print(m);
  };
  EXPECT_EQ(literal(0.1f), "uniform x: float = 0.1\n");
  EXPECT_EQ(literal(1.0f), "uniform x: float = 1.0\n");
  EXPECT_EQ(literal(-1.0f / 3.0f), "uniform x: float = -0.33333334\n");
}

TEST(Print, UnnamedValuesAreNumberedAndEqualNamesToldApart) {
  Module module;
  Function& function = module.functions.emplace_back();
  function.name = "f";
  Builder builder(module, function, {.fold = false});
  ValueId x = builder.AddParameter({"x", kFloat});
  ValueId y = builder.AddParameter({"x", kFloat});
  ValueId sum = builder.Op2(Op::kAdd, x, y);
  ValueId product = builder.Op2(Op::kMul, sum, sum);
  builder.Name(product, "x");
  ValueId bad = builder.Op2(Op::kMul, sum, product);
  builder.Name(bad, "no name at all");
  ValueId last = builder.Op2(Op::kSub, bad, builder.Float(2));
  builder.Return({{last}});
  EXPECT_EQ(Verify(module), "");
  const char* text =
      "function f(%x: float, %x.2: float) -> float {\n"
      "  %0 = add %x, %x.2 : float\n"
      "  %x.3 = mul %0, %0 : float\n"
      "  %1 = mul %0, %x.3 : float\n"
      "  %2 = sub %1, 2.0 : float\n"
      "  return %2\n"
      "}\n";
  EXPECT_EQ(Print(module, module.functions[0]), text);
  EXPECT_EQ(Print(ModuleFrom(text)), text);
}

TEST(Print, ValuesNamedLikeNumberedOnesStayApart) {
  const char* text =
      "function f(%a: float) -> float {\n"
      "  %a.2 = neg %a : float\n"
      "  %a.3 = neg %a.2 : float\n"
      "  return %a.3\n"
      "}\n";
  EXPECT_EQ(Print(ModuleFrom(text)), text);
}

TEST(Parse, TakesSplatLiteralsCommentsAndAnySpacing) {
  Module module = ModuleFrom(
      "// first\nfunction f ( %x :vec3 )->vec3{ // here\n%y=add %x,vec3( 2.0 ) :vec3 return "
      "%y}//end");
  EXPECT_EQ(Print(module),
            "function f(%x: vec3) -> vec3 {\n"
            "  %y = add %x, vec3(2.0, 2.0, 2.0) : vec3\n"
            "  return %y\n"
            "}\n");
}

TEST(Parse, DoesNotMergeOrFold) {
  Module module = ModuleFrom(R"(function f(%x: float) -> float {
  %a = add 1.0, 2.0 : float
  %b = add 1.0, 2.0 : float
  %c = mul %a, %b : float
  return %c
})");
  EXPECT_EQ(module.functions[0].Body().body.size(), 3u);
}

TEST(Parse, AGlobalIsOneInstructionInAScope) {
  Module module = ModuleFrom(R"(input uv: vec2
function f() -> vec2 {
  %a = add @uv, @uv : vec2
  %b = add %a, @uv : vec2
  return %b
})");
  EXPECT_EQ(module.functions[0].Body().body.size(), 3u);
}

TEST(Parse, ReportsWhatIsWrongAndWhere) {
  auto in_function = [](const std::string& line) {
    return ErrorOf("function f(%x: vec2, %c: bool) -> vec2 {\n" + line + "\n  return %x\n}\n");
  };
  EXPECT_EQ(
      ErrorOf("wrong"),
      "1:1: expected struct, origin, input, uniform, specialization, texture, function or main");
  EXPECT_EQ(ErrorOf("input uv vec2"), "1:10: expected ':'");
  EXPECT_EQ(ErrorOf("input uv: vec5"), "1:11: unknown type 'vec5'");
  EXPECT_EQ(ErrorOf("input uv: vec2\ninput uv: vec2"), "2:7: a second 'uv'");
  EXPECT_EQ(ErrorOf("struct S { a: float }\nstruct S { a: vec2 }"), "2:8: a second type 'S'");
  EXPECT_EQ(ErrorOf("origin #1 = \"\" \"\" \"\""), "1:8: expected #0");
  EXPECT_EQ(ErrorOf("origin #0 = \"a"), "1:13: expected the node in quotes");
  EXPECT_EQ(ErrorOf("main f"), "1:6: no function 'f'");
  EXPECT_EQ(ErrorOf("uniform a: float[0]"), "1:18: expected a whole number from 1 to 65536");
  EXPECT_EQ(ErrorOf("uniform a: float[65536][65536]"), "1:12: a type too large");
  EXPECT_EQ(ErrorOf("uniform a: int = 3000000000"), "1:18: no number, or one out of range");
  EXPECT_EQ(ErrorOf("uniform a: float = 1e39"), "1:20: no number, or one out of range");
  EXPECT_EQ(ErrorOf("uniform a: float = 1.0.0"), "1:20: no number, or one out of range");
  EXPECT_EQ(ErrorOf("uniform a: float = bits(7)"), "1:25: expected 0x and up to eight digits");
  EXPECT_EQ(ErrorOf("uniform a: vec3 = vec3(1.0, 2.0)"),
            "1:24: a literal of type vec3 has 3 components");
  EXPECT_EQ(ErrorOf("uniform a: vec2 = vec2(1.0, 2)"),
            "1:29: a literal of type vec2 does not take this");
  EXPECT_EQ(ErrorOf("uniform a: vec2 = vec2(1.0, 2.0, 3.0)"),
            "1:34: a literal of type vec2 does not take this");
  EXPECT_EQ(in_function("  %y = plus %x, %x : vec2"), "2:8: unknown operation 'plus'");
  EXPECT_EQ(in_function("  %y = const : vec2"), "2:8: unknown operation 'const'");
  EXPECT_EQ(in_function("  %y = neg %z : vec2"), "2:12: no value 'z' before this");
  EXPECT_EQ(in_function("  %x = neg %x : vec2"), "2:3: a second value named 'x'");
  EXPECT_EQ(in_function("  %y = neg @z : vec2"), "2:12: no input, uniform or texture 'z'");
  EXPECT_EQ(in_function("  %y = swizzle.xr %x : vec2"), "2:16: components are x, y, z and w");
  EXPECT_EQ(in_function("  %y = swizzle.xyx %x : vec2"),
            "2:16: as many components as the result has");
  EXPECT_EQ(in_function("  %y = swizzle.xyxyx %x : vec2"), "2:16: more than four components");
  EXPECT_EQ(in_function("  %y = call g(%x) : vec2"), "2:13: no function 'g' before this one");
  EXPECT_EQ(in_function("  %y = call f(%x, %c) : vec2"), "2:13: no function 'f' before this one");
  EXPECT_EQ(in_function("  %y = neg %x : vec2 #4"), "2:22: no such origin");
  EXPECT_EQ(in_function("  %y = if %c : vec2 { yield %x }"), "3:3: expected 'else'");
  EXPECT_EQ(in_function("  $"), "2:3: expected a value, 'yield' or 'return'");
}

TEST(Parse, ReportsViolationsAtTheirValue) {
  EXPECT_EQ(ErrorOf("function f(%x: vec2) -> vec2 {\n  %y = add %x, 1.0 : vec2\n  return %y\n}"),
            "2:3: function f: %y: add of vec2 and float giving vec2");
  EXPECT_EQ(ErrorOf("input a: float\nfunction f(%x: vec2) -> vec3 {\n  return %x\n}"),
            "2:10: function f: returns vec2, not vec3");
  EXPECT_EQ(ErrorOf("function f(%x: float) -> float {\n  return %x\n}\n"
                    "function f(%x: float) -> float {\n  return %x\n}\n"),
            "4:10: a second function 'f'");
}

TEST(Parse, BoundsNesting) {
  std::string open, close;
  for (uint32_t i = 0; i < 300; ++i) {
    open += "%v" + std::to_string(i) + " = if %c : bool {\n";
    close += "yield %c } else { yield %c }\n";
  }
  std::string error = ErrorOf("function f(%c: bool) -> bool {\n" + open + close + "return %c }");
  EXPECT_NE(error.find("regions nest deeper than 256"), std::string::npos) << error;
  std::string type(10000, '(');
  EXPECT_NE(ErrorOf("input x: " + type).find("nested too deep"), std::string::npos);
  std::string literal;
  for (int i = 0; i < 10000; ++i) literal += "vec2(";
  EXPECT_NE(ErrorOf("uniform x: float = " + literal).find("too deep"), std::string::npos);
}

TEST(Parse, EveryTruncationIsAnErrorOrAModule) {
  std::string text = kEverything;
  for (size_t length = 0; length < text.size(); ++length) {
    Sources sources;
    Diagnostics diagnostics;
    SourceId source = sources.Add("test.ir", text.substr(0, length));
    bool parsed = Parse(source, sources, diagnostics).has_value();
    EXPECT_EQ(parsed, !diagnostics.HasErrors()) << length;
  }
}

TEST(Parse, SurvivesRandomDamage) {
  std::mt19937 random(1);
  const std::string text = kEverything;
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = text;
    for (int k = 0; k < 3; ++k) {
      size_t at = random() % damaged.size();
      switch (random() % 3) {
        case 0:
          damaged[at] = static_cast<char>(random());
          break;
        case 1:
          damaged.erase(at, random() % 9);
          break;
        default:
          damaged.insert(at, damaged.substr(random() % damaged.size(), random() % 12));
          break;
      }
    }
    Sources sources;
    Diagnostics diagnostics;
    SourceId source = sources.Add("test.ir", damaged);
    std::optional<Module> module = Parse(source, sources, diagnostics);
    EXPECT_EQ(module.has_value(), !diagnostics.HasErrors());
    if (!module) continue;
    std::string printed = Print(*module);
    EXPECT_EQ(Print(ModuleFrom(printed)), printed);
  }
}

}  // namespace
}  // namespace texgraph::ir
