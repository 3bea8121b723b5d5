// SPDX-License-Identifier: Apache-2.0
// Each rule of module.h and op.h, broken once: by text where text can say it, else by hand.
#include "compiler/ir/verify.h"

#include <gtest/gtest.h>

#include "tests/unit/ir/module_text.h"

namespace texgraph::ir {
namespace {

constexpr char kPrelude[] = R"(struct Tile { cell: ivec2, size: float }
texture map: sampler2D
texture solid: sampler3D
texture array: sampler2DArray
function two(%a: float, %b: vec2) -> (float, vec2) {
  return %a, %b
}
function one(%a: float, %b: vec2) -> vec2 {
  return %b
}
function none() -> () {
  return
}
)";

// The message for a function with that line and parameters of many types; "" if it is accepted.
std::string MessageOf(const std::string& line) {
  std::string error =
      ErrorOf(std::string(kPrelude) +
              "function f(%f: float, %v2: vec2, %v3: vec3, %i: int, %iv: ivec2, %u: uint, "
              "%b: bool, %b2: bvec2, %m: mat2, %m3: mat3, %t: Tile, %a: float[3], "
              "%field: field(vec2) -> float, %s: sampler2D) -> float {\n" +
              line + "\n  return %f\n}\n");
  size_t message = error.find("function f: ");
  return message == std::string::npos ? error : error.substr(message + 12);
}

TEST(Verify, AcceptsEveryShape) {
  for (const char* line : {"%y = add %v3, %v3 : vec3",
                           "%y = mul %m, %m : mat2",
                           "%y = neg %u : uint",
                           "%y = abs %iv : ivec2",
                           "%y = clamp %i, 0, 5 : int",
                           "%y = mod %u, 3u : uint",
                           "%y = shl %i, 2 : int",
                           "%y = mix %v2, %v2, %v2 : vec2",
                           "%y = cross %v3, %v3 : vec3",
                           "%y = dot %f, %f : float",
                           "%y = length %v3 : float",
                           "%y = matmul %m, %m : mat2",
                           "%y = matmul %m, %v2 : vec2",
                           "%y = matmul %v3, %m3 : vec3",
                           "%y = transpose %m : mat2",
                           "%y = lt %v2, %v2 : bvec2",
                           "%y = eq %b2, %b2 : bvec2",
                           "%y = land %b, %b : bool",
                           "%y = any %b2 : bool",
                           "%y = isnan %v2 : bvec2",
                           "%y = select %b, %t, %t : Tile",
                           "%y = select %b2, %v2, %v2 : vec2",
                           "%y = select %b, %m, %m : mat2",
                           "%y = convert %i : bool",
                           "%y = convert %v2 : ivec2",
                           "%y = bitcast %iv : vec2",
                           "%y = splat %i : ivec3",
                           "%y = splat %f : mat3",
                           "%y = construct %f, %f : vec2",
                           "%y = construct %v2, %v2 : mat2",
                           "%y = construct %iv, %f : Tile",
                           "%y = construct %f, %f, 1.0 : float[3]",
                           "%y = extract.1 %t : float",
                           "%y = extract.0 %m : vec2",
                           "%y = extract.2 %a : float",
                           "%y = swizzle.xxyy %v2 : vec4",
                           "%y = index %a, %i : float",
                           "%y = index %m, %u : vec2",
                           "%y = index %v3, 1 : float",
                           "%y = sample %s, %v2 : vec4",
                           "%y = sample @map, %v2, %f : vec4",
                           "%y = sample @array, %v3 : vec4",
                           "%y = sample_grad @array, %v3, %v2, %v2 : vec4",
                           "%y = sample_grad @solid, %v3, %v3, %v3 : vec4",
                           "%y = sample_lod @solid, %v3, 0.0 : vec4",
                           "%y = fetch @map, %iv, 0 : vec4",
                           "%y = texture_size @map, 0 : ivec2",
                           "%y = texture_size @array, 0 : ivec3",
                           "%y = dx %v2 : vec2",
                           "%y = call two(%f, %v2) : (float, vec2)",
                           "%y = call one(%f, %v2) : vec2",
                           "%y = field one(%v2) : field(float) -> vec2",
                           "%y = field one() : field(float, vec2) -> vec2",
                           "%y = field one(%f, %v2) : field() -> vec2",
                           "%y = call_field %field(%v2) : float",
                           "%y = if %b : float { yield %f } else { yield 1.0 }",
                           "%y = for %k = 0 to 3 step 1 (%c = %f) : float { yield %c }"}) {
    EXPECT_EQ(MessageOf(line), "") << line;
  }
}

TEST(Verify, RefusesOperandsThatDoNotFit) {
  struct Case {
    const char* line;
    const char* message;
  };
  for (auto [line, message] : std::initializer_list<Case>{
           {"%y = add %v2, %v3 : vec3", "%y: add of vec2 and vec3 giving vec3"},
           {"%y = add %v2, %v2 : vec3", "%y: add of vec2 and vec2 giving vec3"},
           {"%y = add %f : float", "%y: add of float giving float"},
           {"%y = add %b, %b : bool", "%y: add of bool and bool giving bool"},
           {"%y = add %t, %t : Tile", "%y: add of Tile and Tile giving Tile"},
           {"%y = min %m, %m : mat2", "%y: min of mat2 and mat2 giving mat2"},
           {"%y = sign %u : uint", "%y: sign of uint giving uint"},
           {"%y = mod %f, %f : float", "%y: mod of float and float giving float"},
           {"%y = and %b, %b : bool", "%y: and of bool and bool giving bool"},
           {"%y = floor %i : int", "%y: floor of int giving int"},
           {"%y = floor %m : mat2", "%y: floor of mat2 giving mat2"},
           {"%y = mix %v2, %v2, %f : vec2", "%y: mix of vec2, vec2 and float giving vec2"},
           {"%y = cross %v2, %v2 : vec2", "%y: cross of vec2 and vec2 giving vec2"},
           {"%y = dot %v2, %v2 : vec2", "%y: dot of vec2 and vec2 giving vec2"},
           {"%y = dot %iv, %iv : float", "%y: dot of ivec2 and ivec2 giving float"},
           {"%y = dot %m, %m : float", "%y: dot of mat2 and mat2 giving float"},
           {"%y = length %iv : float", "%y: length of ivec2 giving float"},
           {"%y = matmul %m, %m3 : mat3", "%y: matmul of mat2 and mat3 giving mat3"},
           {"%y = matmul %m, %v3 : vec3", "%y: matmul of mat2 and vec3 giving vec3"},
           {"%y = matmul %v2, %v2 : vec2", "%y: matmul of vec2 and vec2 giving vec2"},
           {"%y = transpose %v2 : vec2", "%y: transpose of vec2 giving vec2"},
           {"%y = lt %b, %b : bool", "%y: lt of bool and bool giving bool"},
           {"%y = eq %v2, %v2 : bool", "%y: eq of vec2 and vec2 giving bool"},
           {"%y = land %i, %i : int", "%y: land of int and int giving int"},
           {"%y = lnot %b, %b : bool", "%y: lnot of bool and bool giving bool"},
           {"%y = all %v2 : bool", "%y: all of vec2 giving bool"},
           {"%y = isinf %i : bool", "%y: isinf of int giving bool"},
           {"%y = select %b2, %v3, %v3 : vec3", "%y: select of bvec2, vec3 and vec3 giving vec3"},
           {"%y = select %b2, %m, %m : mat2", "%y: select of bvec2, mat2 and mat2 giving mat2"},
           {"%y = select %b, %f, %i : float", "%y: select of bool, float and int giving float"},
           {"%y = select %b, %s, %s : sampler2D",
            "%y: select of bool, sampler2D and sampler2D giving sampler2D"},
           {"%y = convert %v2 : ivec3", "%y: convert of vec2 giving ivec3"},
           {"%y = convert %m : vec4", "%y: convert of mat2 giving vec4"},
           {"%y = bitcast %b : uint", "%y: bitcast of bool giving uint"},
           {"%y = splat %v2 : vec4", "%y: splat of vec2 giving vec4"},
           {"%y = splat %i : vec2", "%y: splat of int giving vec2"},
           {"%y = splat %f : float", "%y: splat of float giving float"},
           {"%y = splat %i : mat2", "%y: splat of int giving mat2"},
           {"%y = construct %v2, %f : vec3", "%y: construct of vec2 and float giving vec3"},
           {"%y = construct %f : float", "%y: construct of float giving float"},
           {"%y = construct %f, %iv : Tile", "%y: construct of float and ivec2 giving Tile"},
           {"%y = construct %f, %f : float[3]", "%y: construct of float and float giving float[3]"},
           {"%y = extract.3 %v3 : float", "%y: extract.3 of vec3 giving float"},
           {"%y = extract.0 %f : float", "%y: extract.0 of float giving float"},
           {"%y = extract.0 %t : float", "%y: extract.0 of Tile giving float"},
           {"%y = extract.0 %s : float", "%y: extract.0 of sampler2D giving float"},
           {"%y = swizzle.xz %v2 : vec2", "%y: swizzle beyond vec2"},
           {"%y = swizzle.x %v2 : float", "%y: swizzle of vec2 giving float"},
           {"%y = swizzle.xy %v2 : ivec2", "%y: swizzle of vec2 giving ivec2"},
           {"%y = index %t, %i : float", "%y: index of Tile and int giving float"},
           {"%y = index %a, %f : float", "%y: index of float[3] and float giving float"},
           {"%y = index %f, %i : float", "%y: index of float and int giving float"},
           {"%y = index %m, %i : float", "%y: index of mat2 and int giving float"}}) {
    EXPECT_EQ(MessageOf(line), message);
  }
}

TEST(Verify, RefusesTexturesAndCallsThatDoNotFit) {
  struct Case {
    const char* line;
    const char* message;
  };
  for (auto [line, message] : std::initializer_list<Case>{
           {"%y = sample %v2, %v2 : vec4", "%y: sample of vec2 and vec2 giving vec4"},
           {"%y = sample @map, %v3 : vec4", "%y: sample of sampler2D and vec3 giving vec4"},
           {"%y = sample @map, %v2 : vec3", "%y: sample of sampler2D and vec2 giving vec3"},
           {"%y = sample @map, %v2, %i : vec4",
            "%y: sample of sampler2D, vec2 and int giving vec4"},
           {"%y = sample_grad @map, %v2, %v2 : vec4",
            "%y: sample_grad of sampler2D, vec2 and vec2 giving vec4"},
           {"%y = sample_grad @array, %v3, %v3, %v3 : vec4",
            "%y: sample_grad of sampler2DArray, vec3, vec3 and vec3 giving vec4"},
           {"%y = sample_grad @solid, %v3, %v2, %v2 : vec4",
            "%y: sample_grad of sampler3D, vec3, vec2 and vec2 giving vec4"},
           {"%y = sample_lod @map, %v2 : vec4", "%y: sample_lod of sampler2D and vec2 giving vec4"},
           {"%y = fetch @map, %v2, 0 : vec4", "%y: fetch of sampler2D, vec2 and int giving vec4"},
           {"%y = texture_size @map, 0 : ivec3",
            "%y: texture_size of sampler2D and int giving ivec3"},
           {"%y = call two(%f) : (float, vec2)", "%y: call of two: 1 arguments for 2 parameters"},
           {"%y = call two(%f, %f) : (float, vec2)",
            "%y: call of two: float for parameter 1 of type vec2"},
           {"%y = call two(%f, %v2) : float", "%y: call of float and vec2 giving float"},
           {"%y = call two(%f, %v2) : (float, float)",
            "%y: call of float and vec2 giving (float, float)"},
           {"%y = call none() : float", "%y: call of none: it has no result"},
           {"%y = field two() : field(float, vec2) -> float",
            "%y: field of two: it must have one result"},
           {"%y = field one(%v2) : field() -> vec2",
            "%y: field of one: 0 parameters and 1 captured values for 2 parameters"},
           {"%y = field one(%f) : field(float) -> vec2",
            "%y: field of one: float for parameter 1 of type vec2"},
           {"%y = field one(%v2) : field(vec2) -> vec2",
            "%y: field of one: vec2 for parameter 0 of type float"},
           {"%y = field one(%v2) : field(float) -> float",
            "%y: field of one: its result is another type"},
           {"%y = field one(%v2) : float", "%y: field of vec2 giving float"},
           {"%y = call_field %field(%f) : float",
            "%y: call_field of field(vec2) -> float and float giving float"},
           {"%y = call_field %field(%v2) : vec2",
            "%y: call_field of field(vec2) -> float and vec2 giving vec2"},
           {"%y = call_field %f(%v2) : float", "%y: call_field of float and vec2 giving float"}}) {
    EXPECT_EQ(MessageOf(line), message);
  }
}

TEST(Verify, RefusesRegionsThatDoNotFit) {
  struct Case {
    const char* line;
    const char* message;
  };
  for (auto [line, message] : std::initializer_list<Case>{
           {"%y = if %f : float { yield %f } else { yield %f }", "%y: if of float giving float"},
           {"%y = if %b2 : float { yield %f } else { yield %f }", "%y: if of bvec2 giving float"},
           {"%y = if %b : vec2 { yield %f } else { yield %v2 }", "%y: then does not yield vec2"},
           {"%y = if %b : vec2 { yield %v2 } else { yield %f }", "%y: else does not yield vec2"},
           {"%y = if %b : (float, vec2) { yield %f, %v2 } else { yield %f }",
            "%y: else does not yield (float, vec2)"},
           {"%y = if %b : sampler2D { yield %s } else { yield %s }",
            "%y: then does not yield sampler2D"},
           {"%y = if %b : field(vec2) -> float { yield %field } else { yield %field }",
            "%y: then does not yield field(vec2) -> float"},
           {"%y = if %b : float { %z = neg %f : float yield %z } else { yield %z }",
            "a region yields %z, which is not in scope"},
           {"%y = if %b : float { %z = neg %f : float yield %z } else { yield %f }\n%w = neg %z : "
            "float",
            "%w: uses %z, which is not in scope"},
           {"%y = for %k = 0 to 3 step 0 (%c = %f) : float { yield %c }", "%y: a step of 0"},
           {"%y = for %k = 0 to 3 step 1 () : float { yield %f }", "%y: for giving float"},
           {"%y = for %k = 0 to 3 step 1 (%c = %f) : float { yield %v2 }",
            "%y: the body does not yield float"},
           {"%y = for %k = 0 to 3 step 1 (%c = %v2) : float { yield %f }",
            "%y: first values of another type than float"},
           {"%y = for %k = 0 to 3 step 1 (%c = %f, %d = %f) : float { yield %f }",
            "%y: first values of another type than float"},
           {"%y = for %k = 0 to 3 step 1 (%c = %f) : float { yield %c }\n%w = neg %k : int",
            "%w: uses %k, which is not in scope"}}) {
    EXPECT_EQ(MessageOf(line), message);
  }
}

TEST(Verify, RefusesGlobalsThatDoNotFit) {
  auto message = [](std::string text) {
    std::string error = ErrorOf(text);
    return error.substr(std::min(error.size(), error.find(' ') + 1));
  };
  EXPECT_EQ(message("texture a: vec2"), "global a: a texture of type vec2");
  EXPECT_EQ(message("input a: sampler2D"), "global a: an input of type sampler2D");
  EXPECT_EQ(message("uniform a: field(vec2) -> float"),
            "global a: an input of type field(vec2) -> float");
  EXPECT_EQ(message("uniform a: vec2 = 1.0"), "global a: its default is of another type");
  EXPECT_EQ(message("specialization a: vec2 = vec2(0.0)"),
            "global a: a specialization constant of type vec2");
  EXPECT_EQ(message("specialization a: int"),
            "global a: a specialization constant without a default");
}

TEST(Verify, RefusesFunctionsThatDoNotFit) {
  auto message = [](std::string text) {
    std::string error = ErrorOf(text);
    return error.substr(std::min(error.size(), error.find(' ') + 1));
  };
  EXPECT_EQ(message("function f(%x: void) -> float { return 1.0 }"),
            "function f: parameter 'x' of type void");
  EXPECT_EQ(message("function f(%x: (float, float)) -> float { return 1.0 }"),
            "function f: parameter 'x' of type (float, float)");
  EXPECT_EQ(message("function f(%x: sampler2D) -> sampler2D { return %x }"),
            "function f: result of type sampler2D");
  EXPECT_EQ(message("function f(%x: float) -> (float, float) { return %x }"),
            "function f: returns 1 values, not 2");
  EXPECT_EQ(message("function f(%x: float) -> int { return %x }"),
            "function f: returns float, not int");
  EXPECT_EQ(message("function \"\"() -> float { return 1.0 }"), "function 0: has no name");
  EXPECT_EQ(message("function f(%x: float) -> float { return %x }\nmain f"),
            "function f: main has parameters");
}

// --- What text cannot say ------------------------------------------------------------------------

class VerifyByHand : public testing::Test {
 protected:
  Module module_ = ModuleFrom(R"(input uv: vec2
function g(%x: float) -> float {
  return %x
}
function f(%x: float, %c: bool) -> float {
  %a = add %x, 1.0 : float
  %b = mul %a, %a : float
  %i = if %c : float {
    %n = neg %b : float
    yield %n
  } else {
    yield %a
  }
  %l = for %k = 0 to 4 step 1 (%s = %i) : float {
    %t = call g(%s) : float
    yield %t
  }
  return %l
})");
  Function& f_ = module_.functions[1];
  Region& Body() { return f_.regions[f_.body.index]; }
  ValueId Named(std::string_view name) {
    for (size_t i = 0; i < f_.insts.size(); ++i) {
      NameId id = f_.NameOf(ValueId(i));
      if (id && module_.Name(id) == name) return ValueId(i);
    }
    return ValueId();
  }
  Inst& At(std::string_view name) { return f_.insts[Named(name).index]; }
};

TEST_F(VerifyByHand, TheStartIsWellFormed) { EXPECT_EQ(Verify(module_), ""); }

TEST_F(VerifyByHand, OperandsComeBeforeTheirUse) {
  std::swap(Body().body[0], Body().body[1]);
  EXPECT_EQ(Verify(module_), "function f: %b: uses %?, which is not in scope");
}

TEST_F(VerifyByHand, NothingStandsTwice) {
  Body().body.push_back(Named("a"));
  EXPECT_EQ(Verify(module_), "function f: %a: stands in two places");
}

TEST_F(VerifyByHand, ConstantsAndParametersStandInNoBody) {
  Body().body.push_back(Named("x"));
  EXPECT_EQ(Verify(module_), "function f: %x: stands in two places");
  Body().body.back() = f_.Operands(Named("a"))[1];
  EXPECT_EQ(Verify(module_), "function f: %0: a constant or a parameter in a body");
}

TEST_F(VerifyByHand, RegionsAreUsedOnce) {
  f_.branches[0].else_region = f_.branches[0].then_region;
  EXPECT_EQ(Verify(module_), "function f: a region is used twice");
}

TEST_F(VerifyByHand, SidesHaveNoParameters) {
  f_.regions[f_.branches[0].then_region.index].params.push_back(Named("x"));
  EXPECT_EQ(Verify(module_), "function f: %i: a side has parameters");
}

TEST_F(VerifyByHand, LoopsHaveAnIndexAndTheirCarriedValues) {
  Region& loop = f_.regions[f_.loops[0].body.index];
  ValueId carried = loop.params.back();
  loop.params.pop_back();
  EXPECT_EQ(Verify(module_), "function f: %l: 1 first values for 1 parameters");
  loop.params.push_back(carried);
  At("k").type = kUint;
  EXPECT_EQ(Verify(module_), "function f: %k: index of type uint, not int");
  At("k").type = kInt;
  At("s").aux = 7;
  EXPECT_EQ(Verify(module_), "function f: %s: carried value 1 is another value");
}

TEST_F(VerifyByHand, ParametersMatchTheSignature) {
  f_.parameters[0].type = kVec2;
  EXPECT_EQ(Verify(module_), "function f: %x: parameter of type float, not vec2");
  f_.parameters.pop_back();
  EXPECT_EQ(Verify(module_), "function f: its region has 2 parameters, not 1");
}

TEST_F(VerifyByHand, CalleesComeBeforeCallers) {
  At("t").aux = 1;
  EXPECT_EQ(Verify(module_), "function f: %t: calls a function that does not come before it");
  At("t").aux = 99;
  EXPECT_EQ(Verify(module_), "function f: %t: calls a function that does not come before it");
}

TEST_F(VerifyByHand, ConstantsHaveTheirType) {
  Inst& constant = f_.insts[f_.Operands(Named("a"))[1].index];
  constant.aux = module_.Intern(kInt, {{1u}}).index;
  EXPECT_EQ(Verify(module_), "function f: %0: a constant of another type");
  constant.aux = 1000;
  EXPECT_EQ(Verify(module_), "function f: %0: no such constant");
  constant.type = kBool;
  constant.aux = module_.Intern(kBool, {{2u}}).index;
  EXPECT_EQ(Verify(module_), "function f: %0: a constant of another type");
}

TEST_F(VerifyByHand, GlobalsHaveTheirType) {
  At("a") = {Op::kGlobal, 0, kFloat, 0, 0};
  EXPECT_EQ(Verify(module_), "function f: %a: global giving float");
  At("a").aux = 5;
  EXPECT_NE(Verify(module_), "");
}

TEST_F(VerifyByHand, IdsAreInRange) {
  const std::string expected = "function f: an id is out of range";
  const Function good = f_;
  f_.operands[0] = ValueId(1000);
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  f_.body = RegionId();
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  Body().results[0] = ValueId();
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  At("i").aux = 9;
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  At("l").aux = 9;
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  f_.loops[0].body = RegionId(77);
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  f_.branches[0].else_region = RegionId();
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  At("a").type = TypeId(10000);
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  At("a").first_operand = 100000;
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  f_.results[0].type = TypeId();
  EXPECT_EQ(Verify(module_), expected);
  f_ = good;
  EXPECT_EQ(Verify(module_), "");
}

TEST_F(VerifyByHand, NamesAreUnique) {
  f_.name = "g";
  EXPECT_EQ(Verify(module_), "function g: a second one of that name");
  f_.name = "f";
  module_.AddGlobal({GlobalKind::kInput, "uv", kVec3, ConstId()});
  EXPECT_EQ(Verify(module_), "global uv: a second one of that name");
  module_.globals.back().name = "";
  EXPECT_EQ(Verify(module_), "global : has no name");
}

TEST_F(VerifyByHand, MainIsAFunction) {
  module_.main = FunctionId(2);
  EXPECT_EQ(Verify(module_), "main: no such function");
}

TEST_F(VerifyByHand, SaysWhichValue) {
  At("n").type = kVec2;
  std::optional<Violation> violation = FindViolation(module_);
  ASSERT_TRUE(violation);
  EXPECT_EQ(violation->function, FunctionId(1));
  EXPECT_EQ(violation->value, Named("n"));
  EXPECT_EQ(violation->message, "function f: %n: neg of float giving vec2");
}

}  // namespace
}  // namespace texgraph::ir
