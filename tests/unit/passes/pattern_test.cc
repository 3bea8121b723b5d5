// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/pattern.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/passes/value_text.h"

namespace texgraph::passes {
namespace {

using ir::Op;
using ir::TypeId;
using ir::ValueId;

// A function to make values in, and their text, for short comparisons.
class PatternTest : public ::testing::Test {
 protected:
  PatternTest() : builder_(module_, function_) {}

  ValueId Param(std::string name, TypeId type) {
    return builder_.AddParameter({name, type, false});
  }

  std::string Text(ValueId v) { return ValueText(builder_, v); }

  bool Matches(std::string_view pattern, ValueId v, bool signed_zero = false) {
    bindings_ = {};
    const ir::Inst& inst = builder_[v];
    return Match(ParsePattern(pattern), builder_, inst.op, inst.type, function_.Operands(inst),
                 signed_zero, bindings_);
  }

  std::string Derivative(Op op, std::vector<ValueId> x, std::vector<ValueId> d, ValueId r) {
    std::optional<ValueId> made = InstantiateDerivative(op, builder_, x, d, r);
    return made ? Text(*made) : "zero";
  }

  ir::Module module_;
  ir::Function function_;
  ir::Builder builder_;
  Bindings bindings_;
};

TEST_F(PatternTest, BindsVariablesInPlace) {
  ValueId p = Param("p", ir::kVec3), q = Param("q", ir::kVec3);
  ValueId v = builder_.Op2(Op::kAdd, builder_.Op1(Op::kNeg, p), q);
  ASSERT_TRUE(Matches("(add (neg a) b)", v));
  EXPECT_EQ(bindings_.values[0], p);
  EXPECT_EQ(bindings_.values[1], q);
  EXPECT_FALSE(Matches("(add a (neg b))", v)) << "commuting is the table's business";
  EXPECT_FALSE(Matches("(sub (neg a) b)", v));
}

TEST_F(PatternTest, RepeatedVariableIsOneValue) {
  ValueId p = Param("p", ir::kFloat), q = Param("q", ir::kFloat);
  EXPECT_TRUE(
      Matches("(min (max a b) a)", builder_.Op2(Op::kMin, builder_.Op2(Op::kMax, p, q), p)));
  EXPECT_FALSE(
      Matches("(min (max a b) a)", builder_.Op2(Op::kMin, builder_.Op2(Op::kMax, p, q), q)));
}

TEST_F(PatternTest, LiteralsMatchEveryComponent) {
  ValueId p = Param("p", ir::kVec3), i = Param("i", ir::kInt), u = Param("u", ir::kUint);
  auto three = [&](float x, float y, float z) {
    uint32_t words[] = {std::bit_cast<uint32_t>(x), std::bit_cast<uint32_t>(y),
                        std::bit_cast<uint32_t>(z)};
    return builder_.Const(ir::kVec3, words);
  };
  EXPECT_TRUE(Matches("(mul a 0.5)", builder_.Op2(Op::kMul, p, three(0.5f, 0.5f, 0.5f))));
  EXPECT_FALSE(Matches("(mul a 0.5)", builder_.Op2(Op::kMul, p, three(0.5f, 0.5f, 0.25f))));
  EXPECT_TRUE(Matches("(mul a 0)", builder_.Op2(Op::kMul, p, three(0, -0.0f, 0))));
  EXPECT_FALSE(Matches("(mul a 0)", builder_.Op2(Op::kMul, p, three(0, -0.0f, 0)), true));
  EXPECT_TRUE(Matches("(mul a -0)", builder_.Op2(Op::kMul, p, three(-0.0f, -0.0f, -0.0f)), true));
  EXPECT_TRUE(Matches("(mul a -1)", builder_.Op2(Op::kMul, i, builder_.Int(-1))));
  EXPECT_TRUE(Matches("(mul a ones)", builder_.Op2(Op::kMul, i, builder_.Int(-1))));
  EXPECT_TRUE(Matches("(mul a ones)", builder_.Op2(Op::kMul, u, builder_.Uint(0xffffffffu))));
  EXPECT_FALSE(Matches("(mul a -1)", builder_.Op2(Op::kMul, u, builder_.Uint(0xffffffffu))));
  EXPECT_FALSE(Matches("(mul a ones)", builder_.Op2(Op::kMul, p, three(-1, -1, -1))));
}

TEST_F(PatternTest, ScalarsAndTests) {
  ValueId p = Param("p", ir::kVec2), i = Param("i", ir::kInt), u = Param("u", ir::kUint);
  EXPECT_TRUE(Matches("(convert.float a.int)", builder_.Convert(i, ir::kFloat)));
  EXPECT_FALSE(Matches("(convert.float a.uint)", builder_.Convert(i, ir::kFloat)));
  EXPECT_FALSE(Matches("(convert.uint a.int)", builder_.Convert(i, ir::kFloat)));
  auto two = [&](float x, float y) {
    uint32_t words[] = {std::bit_cast<uint32_t>(x), std::bit_cast<uint32_t>(y)};
    return builder_.Const(ir::kVec2, words);
  };
  auto passes = [&](ValueTest test, ValueId v) { return Passes(test, builder_, v); };
  EXPECT_TRUE(passes(ValueTest::kReciprocal, two(2, -0.25f)));
  EXPECT_FALSE(passes(ValueTest::kReciprocal, two(2, 3)));
  EXPECT_FALSE(passes(ValueTest::kReciprocal, two(2, 0)));
  EXPECT_FALSE(passes(ValueTest::kReciprocal, two(2, 0x1p127f))) << "its reciprocal is subnormal";
  EXPECT_FALSE(passes(ValueTest::kReciprocal, two(2, INFINITY)));
  EXPECT_TRUE(passes(ValueTest::kConst, two(0, 3)));
  EXPECT_FALSE(passes(ValueTest::kConst, two(0, 1e-40f)));
  EXPECT_FALSE(passes(ValueTest::kConst, p));
  EXPECT_TRUE(passes(ValueTest::kPowerOfTwo, builder_.Uint(64)));
  EXPECT_FALSE(passes(ValueTest::kPowerOfTwo, builder_.Uint(0)));
  EXPECT_TRUE(passes(ValueTest::kPowerOfTwo, builder_.Int(64)));
  EXPECT_FALSE(passes(ValueTest::kPowerOfTwo, builder_.Int(-64)));
  EXPECT_FALSE(passes(ValueTest::kPowerOfTwo, builder_.Int(INT32_MIN)));
  EXPECT_TRUE(passes(ValueTest::kNegative, builder_.Int(-7)));
  EXPECT_FALSE(passes(ValueTest::kNegative, builder_.Int(INT32_MIN))) << "it is its own negative";
  EXPECT_FALSE(passes(ValueTest::kNegative, two(-1, 0)));
  EXPECT_TRUE(passes(ValueTest::kWrapping, builder_.Uint(0xffffffffu)));
  EXPECT_FALSE(passes(ValueTest::kWrapping, builder_.Uint(0x9e3779b9u))) << "a hash's constant";
  EXPECT_TRUE(passes(ValueTest::kShift, builder_.Int(15)));
  EXPECT_FALSE(passes(ValueTest::kShift, builder_.Int(16)));
  EXPECT_FALSE(passes(ValueTest::kShift, builder_.Int(-1)));
  EXPECT_TRUE(passes(ValueTest::kNonnegative, builder_.Op1(Op::kAbs, p)));
  EXPECT_TRUE(passes(ValueTest::kNonnegative, u));
  EXPECT_FALSE(passes(ValueTest::kNonnegative, i));
  EXPECT_TRUE(passes(ValueTest::kIntegral, builder_.Op1(Op::kFloor, p)));
  EXPECT_FALSE(passes(ValueTest::kIntegral, builder_.Op1(Op::kSqrt, p)));
  EXPECT_TRUE(passes(ValueTest::kFloatInteger, builder_.Op2(Op::kAnd, i, builder_.Int(255))));
  EXPECT_FALSE(passes(ValueTest::kFloatInteger, i));
}

TEST_F(PatternTest, LiteralsTakeTheTypeOfTheirPlace) {
  ValueId p = Param("p", ir::kVec3), i = Param("i", ir::kIvec2), c = Param("c", ir::kBool);
  auto make = [&](std::string_view pattern, TypeId type, std::vector<ValueId> values) {
    Bindings bindings;
    for (size_t k = 0; k < values.size(); ++k) bindings.values[k] = values[k];
    ValueId v = Instantiate(ParsePattern(pattern), builder_, bindings, type);
    EXPECT_EQ(builder_.TypeOf(v), type) << pattern;
    return Text(v);
  };
  EXPECT_EQ(make("(mul a 2)", ir::kVec3, {p}), "(mul p 2,2,2)");
  EXPECT_EQ(make("(sub 7 a)", ir::kIvec2, {i}), "(sub 7,7 i)");
  EXPECT_EQ(make("ones", ir::kUvec2, {}), "4294967295,4294967295");
  EXPECT_EQ(make("true", ir::kBvec2, {}), "1,1");
  EXPECT_EQ(make("(select a 1 0)", ir::kFloat, {c}), "(select c 1 0)");
  EXPECT_EQ(make("(lt 0 a)", ir::kBvec3, {p}), "(lt 0,0,0 p)");
  EXPECT_EQ(make("a", ir::kBvec3, {c}), "(splat c)");
  EXPECT_EQ(make("(convert.float a)", ir::kVec2, {i}), "(convert i)");
  EXPECT_EQ(make("(bitcast a)", ir::kUvec2, {i}), "(bitcast i)");
  EXPECT_EQ(make("(dot a 0.5)", ir::kFloat, {p}), "(dot p 0.5,0.5,0.5)");
}

TEST_F(PatternTest, ZeroDerivativesVanish) {
  ValueId x = Param("x", ir::kVec2), y = Param("y", ir::kVec2), dx = Param("dx", ir::kVec2),
          dy = Param("dy", ir::kVec2), none;
  ValueId product = builder_.Op2(Op::kMul, x, y), quotient = builder_.Op2(Op::kDiv, x, y);
  EXPECT_EQ(Derivative(Op::kMul, {x, y}, {dx, dy}, product), "(add (mul dx y) (mul x dy))");
  EXPECT_EQ(Derivative(Op::kMul, {x, y}, {dx, none}, product), "(mul dx y)");
  EXPECT_EQ(Derivative(Op::kMul, {x, y}, {none, dy}, product), "(mul x dy)");
  EXPECT_EQ(Derivative(Op::kMul, {x, y}, {none, none}, product), "zero");
  EXPECT_EQ(Derivative(Op::kSub, {x, y}, {none, dy}, product), "(neg dy)");
  EXPECT_EQ(Derivative(Op::kDiv, {x, y}, {dx, none}, quotient),
            "(select (ne y 0,0) (div dx y) 0,0)");
  EXPECT_EQ(Derivative(Op::kDiv, {x, y}, {none, none}, quotient), "zero");
  EXPECT_EQ(Derivative(Op::kFloor, {x}, {dx}, product), "zero");
  ValueId c = Param("c", ir::kBool), chosen = builder_.Op3(Op::kSelect, c, x, y);
  EXPECT_EQ(Derivative(Op::kSelect, {c, x, y}, {none, dx}, chosen), "(select c dx 0,0)");
  EXPECT_EQ(Derivative(Op::kSelect, {c, x, y}, {}, chosen), "zero");
  ValueId m = Param("m", ir::kMat2), dm = Param("dm", ir::kMat2);
  ValueId moved = builder_.Op2(Op::kMatMul, m, x);
  EXPECT_EQ(Derivative(Op::kMatMul, {m, x}, {none, dx}, moved), "(matmul m dx)");
  EXPECT_EQ(Derivative(Op::kMatMul, {m, x}, {dm, none}, moved), "(matmul dm x)");
}

TEST_F(PatternTest, DerivativesOfScalarsAndVectorsHaveTheResultsType) {
  for (int i = 0; i < ir::kOpCount; ++i) {
    Op op = static_cast<Op>(i);
    if (DerivativeOf(op) != DerivativeKind::kRule || op == Op::kSelect) continue;
    ir::OpShape shape = ir::Info(op).shape;
    if (shape == ir::OpShape::kMatrixProduct || shape == ir::OpShape::kMatrixUnary) continue;
    for (TypeId type : {ir::kFloat, ir::kVec3}) {
      if (op == Op::kCross && type == ir::kFloat) continue;
      if (op == Op::kSplat && type != ir::kFloat) continue;
      std::vector<ValueId> x, d;
      for (int k = 0; k < 3; ++k) {
        x.push_back(Param("x" + std::to_string(k), type));
        d.push_back(Param("d" + std::to_string(k), type));
      }
      TypeId result =
          shape == ir::OpShape::kDotLike || shape == ir::OpShape::kLengthLike ? ir::kFloat : type;
      if (op == Op::kSplat) result = ir::kVec3;
      ValueId r = Param("r", result);
      std::optional<ValueId> made = InstantiateDerivative(op, builder_, x, d, r);
      ASSERT_TRUE(made) << ir::Info(op).name;
      EXPECT_EQ(builder_.TypeOf(*made), result) << ir::Info(op).name;
    }
  }
}

using PatternDeathTest = PatternTest;
TEST_F(PatternDeathTest, MalformedTextAborts) {
  for (const char* text :
       {"", "(add a", "(add a b))", "(plus a b)", "(add a q)", "(add a:odd b)", "a b",
        "(convert.half a)", "()", "(construct a b)", ")", "(add a 1.5x)"}) {
    EXPECT_DEATH(ParsePattern(text), "malformed pattern") << text;
  }
}

}  // namespace
}  // namespace texgraph::passes
