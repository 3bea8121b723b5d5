// SPDX-License-Identifier: Apache-2.0
// The rules in code: splats, choices of constants, axes, indices, and what follows from ranges.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>
#include <string>
#include <vector>

#include "compiler/passes/rules.h"
#include "compiler/passes/simplify_range.h"
#include "tests/unit/passes/value_text.h"

namespace texgraph::passes {
namespace {

using ir::Op;
using ir::TypeId;
using ir::ValueId;

class StructureRulesTest : public ::testing::Test {
 protected:
  StructureRulesTest() : builder_(module_, function_, {.fold = true, .rules = &rules_}) {
    x_ = Param("x", ir::kFloat);
    y_ = Param("y", ir::kFloat);
    v_ = Param("v", ir::kVec3);
    c_ = Param("c", ir::kBool);
    i_ = Param("i", ir::kInt);
    u_ = Param("u", ir::kUint);
  }

  ValueId Param(std::string name, TypeId type) {
    return builder_.AddParameter({name, type, false});
  }
  ValueId Floats(std::vector<float> components) {
    std::vector<uint32_t> words;
    for (float component : components) words.push_back(std::bit_cast<uint32_t>(component));
    return builder_.Const(ir::Vector(ir::Scalar::kFloat, static_cast<uint32_t>(words.size())),
                          words);
  }
  ValueId Splat(ValueId scalar, uint32_t width) {
    return builder_.SplatTo(scalar, ir::WithWidth(builder_.TypeOf(scalar), width));
  }
  ValueId Choice(float a, float b) {
    return builder_.Op3(Op::kSelect, c_, Floats({a}), Floats({b}));
  }
  ValueId Op1(Op op, ValueId a) { return builder_.Op1(op, a); }
  ValueId Op2(Op op, ValueId a, ValueId b) { return builder_.Op2(op, a, b); }
  ValueId Op3(Op op, ValueId a, ValueId b, ValueId c) { return builder_.Op3(op, a, b, c); }
  std::string Text(ValueId v) { return ValueText(builder_, v); }

  ir::Module module_;
  ir::Function function_;
  SimplifyRules rules_;
  ir::Builder builder_;
  ValueId x_, y_, v_, c_, i_, u_;
};

TEST_F(StructureRulesTest, SplatsAreLifted) {
  EXPECT_EQ(Text(Op2(Op::kAdd, Splat(x_, 3), Splat(y_, 3))), "(splat (add x y))");
  EXPECT_EQ(Text(Op2(Op::kMul, Splat(x_, 3), Floats({3, 3, 3}))), "(splat (mul x 3))");
  EXPECT_EQ(Text(Op2(Op::kMul, Splat(x_, 3), Floats({3, 3, 2}))), "(mul (splat x) 3,3,2)");
  EXPECT_EQ(Text(Op2(Op::kLt, Splat(x_, 2), Splat(y_, 2))), "(splat (lt x y))");
  EXPECT_EQ(Text(Op3(Op::kSelect, c_, Splat(x_, 2), Floats({3, 3}))), "(splat (select c x 3))");
  EXPECT_EQ(Text(builder_.Convert(Splat(i_, 4), ir::kVec4)), "(splat (convert i))");
  EXPECT_EQ(Text(Op1(Op::kSin, Splat(x_, 4))), "(splat (sin x))");
  EXPECT_EQ(Text(Op1(Op::kNormalize, Splat(x_, 3))), "(normalize (splat x))");
  EXPECT_EQ(Text(Op2(Op::kAdd, Splat(x_, 3), v_)), "(add (splat x) v)");
}

TEST_F(StructureRulesTest, ChoicesOfConstantsAreFoldedThrough) {
  EXPECT_EQ(Text(Op2(Op::kAdd, Choice(1, 2), Floats({3}))), "(select c 4 5)");
  EXPECT_EQ(Text(Op2(Op::kMul, Choice(1, 2), Choice(5, 7))), "(select c 5 14)");
  EXPECT_EQ(Text(Op1(Op::kFloor, Choice(1.5, 2.5))), "(select c 1 2)");
  EXPECT_EQ(Text(Op2(Op::kLt, Choice(1, 2), Floats({1.5}))), "c");
  EXPECT_EQ(Text(Op2(Op::kEq, Choice(1, 2), Floats({2}))), "(lnot c)");
  EXPECT_EQ(Text(Op2(Op::kEq, Choice(1, 2), Floats({3}))), "0");
  EXPECT_EQ(Text(builder_.Convert(Choice(1, 2), ir::kInt)), "(select c 1 2)");
  // One side is not foldable.
  EXPECT_EQ(Text(Op2(Op::kDiv, Floats({3}), Choice(1, 0))), "(div 3 (select c 1 0))");
  // Another condition, and a value.
  ValueId d = Param("d", ir::kBool);
  EXPECT_EQ(Text(Op2(Op::kAdd, Choice(1, 2), Op3(Op::kSelect, d, Floats({3}), Floats({4})))),
            "(add (select c 1 2) (select d 3 4))");
  EXPECT_EQ(Text(Op2(Op::kAdd, Choice(1, 2), x_)), "(add (select c 1 2) x)");
  // The length of a choice by component is no choice of lengths.
  ValueId each = Param("each", ir::kBvec2);
  ValueId mixed = Op3(Op::kSelect, each, Floats({3, 4}), Floats({6, 8}));
  EXPECT_EQ(Text(Op1(Op::kLength, mixed)), "(length (select each 3,4 6,8))");
  EXPECT_EQ(Text(Op1(Op::kLength, Op3(Op::kSelect, c_, Floats({3, 4}), Floats({6, 8})))),
            "(select c 5 10)");
}

TEST_F(StructureRulesTest, AxesIdentitiesAndIndices) {
  EXPECT_EQ(Text(Op2(Op::kDot, v_, Floats({0, 0, 1}))), "(extract.2 v)");
  EXPECT_EQ(Text(Op2(Op::kDot, Floats({0, -1, 0}), v_)), "(neg (extract.1 v))");
  EXPECT_EQ(Text(Op2(Op::kDot, v_, Floats({3, 0, 0}))), "(mul (extract.0 v) 3)");
  EXPECT_EQ(Text(Op2(Op::kDot, v_, Floats({3, 0, 1}))), "(dot v 3,0,1)");
  ValueId m = Param("m", ir::kMat2), w = Param("w", ir::kVec2);
  auto matrix = [&](std::array<float, 4> e) {
    return builder_.Const(ir::kMat2, std::bit_cast<std::array<uint32_t, 4>>(e));
  };
  EXPECT_EQ(Text(Op2(Op::kMatMul, matrix({1, 0, 0, 1}), w)), "w");
  EXPECT_EQ(Text(Op2(Op::kMatMul, w, matrix({1, 0, 0, 1}))), "w");
  EXPECT_EQ(Text(Op2(Op::kMatMul, m, matrix({1, 0, 0, 1}))), "m");
  EXPECT_EQ(Text(Op2(Op::kMatMul, m, matrix({1, 0, 1, 1}))), "(matmul m 1,0,1,1)");
  auto index = [&](ValueId aggregate, int at) {
    TypeId element = module_.types.ElementType(builder_.TypeOf(aggregate), 0);
    return Text(builder_.Emit(Op::kIndex, element, {aggregate, builder_.Int(at)}));
  };
  EXPECT_EQ(index(v_, 1), "(extract.1 v)");
  EXPECT_EQ(index(v_, 7), "(extract.2 v)");
  EXPECT_EQ(index(v_, -1), "(extract.0 v)");
  EXPECT_EQ(index(m, 1), "(extract.1 m)");
  EXPECT_EQ(Text(builder_.Emit(Op::kIndex, ir::kFloat, {Splat(x_, 3), i_})), "x");
  EXPECT_EQ(Text(Op2(Op::kDiv, u_, builder_.Uint(8))), "(shr u 3)");
  EXPECT_EQ(Text(Op2(Op::kDiv, i_, builder_.Int(8))), "(div i 8)");
}

TEST_F(StructureRulesTest, ArraysThatCountAreSums) {
  auto index = [&](TypeId element, std::vector<uint32_t> words, ValueId at) {
    const TypeId array = module_.types.Array(element, static_cast<uint32_t>(words.size()));
    return Text(builder_.Emit(Op::kIndex, element, {builder_.Const(array, words), at}));
  };
  EXPECT_EQ(index(ir::kInt, {0, 1, 2, 3}, i_), "(clamp i 0 3)");
  EXPECT_EQ(index(ir::kInt, {0, 1, 2, 3}, Op2(Op::kAnd, i_, builder_.Int(3))), "(and i 3)");
  EXPECT_EQ(index(ir::kInt, {0, 1, 2, 3}, Op2(Op::kAnd, i_, builder_.Int(1))), "(and i 1)");
  EXPECT_EQ(index(ir::kInt, {~0u, 0, 1}, i_), "(sub (clamp i 0 2) 1)");
  EXPECT_EQ(index(ir::kInt, {7, 7, 7}, i_), "7");
  EXPECT_EQ(index(ir::kInt, {7}, i_), "7");
  EXPECT_EQ(index(ir::kUint, {0, 1, 2}, u_), "(min u 2)");
  EXPECT_EQ(index(ir::kInt, {0, 1, 2, 4}, i_), "(index 0,1,2,4 i)");
  EXPECT_EQ(index(ir::kInt, {0, 2, 4}, i_), "(index 0,2,4 i)");
  EXPECT_EQ(index(ir::kInt, {1, 0}, i_), "(index 1,0 i)");
}

TEST_F(StructureRulesTest, FlooredRemaindersOfPowersOfTwoAreMasks) {
  auto wrapped = [&](ValueId v, int count) {
    ValueId flip = Op2(Op::kShr, v, builder_.Int(31));
    ValueId rest = Op2(Op::kMod, Op2(Op::kXor, v, flip), builder_.Int(count));
    return Text(Op2(Op::kAdd, Op2(Op::kXor, rest, flip), Op2(Op::kAnd, flip, builder_.Int(count))));
  };
  EXPECT_EQ(wrapped(i_, 8), "(and i 7)");
  EXPECT_EQ(wrapped(i_, 6), "(add (xor (mod (xor i (shr i 31)) 6) (shr i 31)) (and (shr i 31) 6))");
  EXPECT_EQ(wrapped(Op2(Op::kAnd, i_, builder_.Int(255)), 6), "(mod (and i 255) 6)");
}

TEST_F(StructureRulesTest, SamplingWithoutBias) {
  ir::GlobalId texture = module_.AddGlobal({ir::GlobalKind::kTexture, "brick", ir::kSampler2D, {}});
  ValueId sampler = builder_.Global(texture), uv = Param("uv", ir::kVec2);
  EXPECT_EQ(Text(builder_.Emit(Op::kSample, ir::kVec4, {sampler, uv, Floats({0})})),
            "(sample @brick uv)");
  EXPECT_EQ(Text(builder_.Emit(Op::kSample, ir::kVec4, {sampler, uv, Floats({1})})),
            "(sample @brick uv 1)");
}

TEST_F(StructureRulesTest, WholeNumbersDoNotMatterToWhatRepeats) {
  ir::Global picture{ir::GlobalKind::kTexture, "brick", ir::kSampler2D, {}};
  ir::Global patterns{ir::GlobalKind::kTexture, "patterns", ir::kSampler2DArray, {}};
  const ir::GlobalId once = module_.AddGlobal(picture);
  picture.repeats = patterns.repeats = true;
  const ir::GlobalId again = module_.AddGlobal(picture), array = module_.AddGlobal(patterns);
  ValueId uv = Param("uv", ir::kVec2);
  auto local = [&](float cells) {
    ValueId p = Op2(Op::kMul, uv, Floats({cells, cells}));
    return Op2(Op::kSub, p, Op1(Op::kFloor, p));
  };
  auto sampled = [&](ir::GlobalId texture, ValueId at) {
    return Text(builder_.Emit(Op::kSample, ir::kVec4, {builder_.Global(texture), at}));
  };
  EXPECT_EQ(sampled(again, local(64)), "(sample @brick (mul uv 64,64))");
  EXPECT_EQ(sampled(array, builder_.Construct(ir::kVec3, {{local(64), x_}})),
            "(sample @patterns (construct (extract.0 (mul uv 64,64)) (extract.1 (mul uv 64,64)) "
            "x))");
  // It ends at its border; it has too many repeats; the layer is none.
  const std::string kept = "(sub (mul uv 64,64) (floor (mul uv 64,64)))";
  EXPECT_EQ(sampled(once, local(64)), "(sample @brick " + kept + ")");
  EXPECT_NE(sampled(again, local(4096)), "(sample @brick (mul uv 4096,4096))");
  ValueId half = Op2(Op::kSub, Op2(Op::kMul, uv, Floats({4, 4})), Floats({0.5, 0.5}));
  EXPECT_EQ(sampled(again, half), "(sample @brick (sub (mul uv 4,4) 0.5,0.5))");
}

TEST_F(StructureRulesTest, DivisionsByPowersOfTwoBecomeShifts) {
  auto u = [&](uint32_t number) { return builder_.Uint(number); };
  auto i = [&](int32_t number) { return builder_.Int(number); };
  EXPECT_EQ(Text(Op2(Op::kDiv, u_, u(8))), "(shr u 3)");
  EXPECT_EQ(Text(Op2(Op::kDiv, u_, u(0x80000000u))), "(shr u 31)");
  EXPECT_EQ(Text(Op2(Op::kDiv, u_, u(12))), "(div u 12)");
  EXPECT_EQ(Text(Op2(Op::kDiv, i_, i(8))), "(div i 8)") << "-1 / 8 is 0, -1 >> 3 is -1";
  EXPECT_EQ(Text(Op2(Op::kMod, i_, i(8))), "(mod i 8)");
  ValueId low = Op2(Op::kAnd, i_, i(63));
  EXPECT_EQ(Text(Op2(Op::kDiv, low, i(8))), "(shr (and i 63) 3)");
  EXPECT_EQ(Text(Op2(Op::kMod, low, i(8))), "(and i 7)");
  EXPECT_EQ(Text(Op2(Op::kDiv, low, i(-2147483647 - 1))), "(div (and i 63) -2147483648)");
  ValueId both = builder_.Emit(Op::kConstruct, ir::kUvec2, {u_, Op2(Op::kAdd, u_, u(1))});
  const uint32_t powers[] = {4, 16};
  EXPECT_EQ(Text(Op2(Op::kDiv, both, builder_.Const(ir::kUvec2, powers))),
            "(shr (construct u (add u 1)) 2,4)");
}

TEST_F(StructureRulesTest, ShiftsOfShiftsAreOne) {
  auto u = [&](uint32_t number) { return builder_.Uint(number); };
  auto shifted = [&](ValueId v, uint32_t by) { return Op2(Op::kShr, v, u(by)); };
  EXPECT_EQ(Text(shifted(shifted(u_, 20), 4)), "(shr u 24)");
  EXPECT_EQ(Text(shifted(shifted(u_, 20), 20)), "0");
  EXPECT_EQ(Text(Op2(Op::kShr, Op2(Op::kShr, i_, builder_.Int(20)), builder_.Int(20))),
            "(shr i 31)");
  // One of 16 by the upper half of the bits.
  EXPECT_EQ(Text(shifted(Op2(Op::kMul, shifted(u_, 16), u(16)), 16)), "(shr u 28)");
  EXPECT_EQ(Text(shifted(Op2(Op::kMul, shifted(u_, 16), u(12)), 16)),
            "(shr (mul (shr u 16) 12) 16)");
  EXPECT_EQ(Text(shifted(Op2(Op::kMul, shifted(u_, 3), u(16)), 16)), "(shr (mul (shr u 3) 16) 16)")
      << "the product loses a bit";
}

TEST_F(StructureRulesTest, RangesSettleComparisons) {
  ValueId unit = Op1(Op::kFract, x_), magnitude = Op1(Op::kAbs, x_);
  EXPECT_EQ(Text(Op2(Op::kLt, unit, Floats({2}))), "1");
  EXPECT_EQ(Text(Op2(Op::kLe, unit, Floats({1}))), "1");
  EXPECT_EQ(Text(Op2(Op::kLt, unit, Floats({1}))), "(lt (fract x) 1)") << "fract may round up to 1";
  EXPECT_EQ(Text(Op2(Op::kLt, magnitude, Floats({0}))), "0");
  EXPECT_EQ(Text(Op2(Op::kLe, magnitude, Floats({0}))), "(le (abs x) 0)");
  EXPECT_EQ(Text(Op2(Op::kLt, u_, builder_.Uint(0))), "0");
  EXPECT_EQ(Text(Op2(Op::kEq, unit, Floats({3}))), "0");
  EXPECT_EQ(Text(Op2(Op::kNe, unit, Floats({-3}))), "1");
  EXPECT_EQ(Text(Op2(Op::kLt, builder_.Uint(255), Op2(Op::kAnd, u_, builder_.Uint(255)))), "0");
  EXPECT_EQ(Text(Op2(Op::kLt, x_, Floats({3}))), "(lt x 3)");
  EXPECT_EQ(Text(Op2(Op::kStep, Floats({-1}), unit)), "1");
  EXPECT_EQ(Text(Op2(Op::kStep, Floats({2}), unit)), "0");
}

TEST_F(StructureRulesTest, BoundsThatDoNotBindGo) {
  ValueId unit = Op1(Op::kFract, x_), magnitude = Op1(Op::kAbs, x_);
  auto clamp = [&](ValueId v, float low, float high) {
    return Text(Op3(Op::kClamp, v, Floats({low}), Floats({high})));
  };
  EXPECT_EQ(clamp(unit, 0, 1), "(fract x)");
  EXPECT_EQ(clamp(unit, -1, 2), "(fract x)");
  EXPECT_EQ(clamp(magnitude, 0, 1), "(min (abs x) 1)");
  EXPECT_EQ(clamp(unit, 0.5, 2), "(max (fract x) 0.5)");
  EXPECT_EQ(clamp(unit, 2, 3), "2");
  EXPECT_EQ(clamp(unit, -3, -2), "-2");
  EXPECT_EQ(clamp(x_, 0, 1), "(clamp x 0 1)");
  EXPECT_EQ(Text(Op2(Op::kMin, unit, Floats({1}))), "(fract x)");
  EXPECT_EQ(Text(Op2(Op::kMax, unit, Floats({1}))), "1");
  EXPECT_EQ(Text(Op2(Op::kMax, magnitude, Floats({0}))), "(abs x)");
  EXPECT_EQ(Text(Op2(Op::kMin, magnitude, Floats({1}))), "(min (abs x) 1)");
  EXPECT_EQ(Text(Op1(Op::kAbs, unit)), "(fract x)");
  EXPECT_EQ(Text(Op1(Op::kAbs, Op1(Op::kNeg, Op1(Op::kExp, x_)))), "(exp x)");
  EXPECT_EQ(Text(Op1(Op::kSign, Op2(Op::kAdd, unit, Floats({1})))), "1");
}

class RangeTest : public StructureRulesTest {
 protected:
  void ExpectRange(ValueId v, double low, double high) {
    Range range = RangeOf(builder_, v);
    EXPECT_EQ(range.low, low) << Text(v);
    EXPECT_EQ(range.high, high) << Text(v);
  }
};

TEST_F(RangeTest, FollowsOperations) {
  ValueId unit = Op1(Op::kFract, x_), other = Op1(Op::kFract, y_);
  const double infinity = std::numeric_limits<double>::infinity();
  ExpectRange(x_, -infinity, infinity);
  ExpectRange(Floats({3, -2, 1}), -2, 3);
  ExpectRange(Op2(Op::kAdd, unit, other), 0, 2);
  ExpectRange(Op2(Op::kSub, unit, other), -1, 1);
  ExpectRange(Op2(Op::kMul, Op2(Op::kSub, unit, other), Floats({-3})), -3, 3);
  ExpectRange(Op1(Op::kNeg, unit), -1, 0);
  ExpectRange(Op1(Op::kFloor, Op2(Op::kMul, unit, Floats({2.5}))), 0, 2);
  ExpectRange(Op1(Op::kCeil, Op2(Op::kMul, unit, Floats({2.5}))), 0, 3);
  ExpectRange(Op3(Op::kSelect, c_, unit, Floats({7})), 0, 7);
  ExpectRange(Op3(Op::kMix, unit, other, unit), 0, infinity);
  ExpectRange(Op3(Op::kMix, unit, other, x_), -infinity, infinity);
  ExpectRange(Op2(Op::kMul, x_, x_), 0, infinity);
  ExpectRange(Op2(Op::kMul, Op1(Op::kExp, x_), unit), 0, infinity);
  ExpectRange(Splat(unit, 3), 0, 1);
  ExpectRange(Op2(Op::kDot, v_, v_), 0, infinity);
}

TEST_F(RangeTest, IntegersWrap) {
  ExpectRange(i_, -0x1p31, 0x1p31 - 1);
  ExpectRange(u_, 0, 0x1p32 - 1);
  ExpectRange(Op2(Op::kAdd, i_, builder_.Int(1)), -0x1p31, 0x1p31 - 1);
  ValueId byte = Op2(Op::kAnd, i_, builder_.Int(255));
  ExpectRange(byte, 0, 255);
  ExpectRange(Op2(Op::kAdd, byte, builder_.Int(7)), 7, 262);
  ExpectRange(Op2(Op::kSub, byte, builder_.Int(256)), -256, -1);
  ValueId small = Op2(Op::kAnd, u_, builder_.Uint(15));
  ExpectRange(Op2(Op::kSub, small, builder_.Uint(16)), 0, 0x1p32 - 1);
  ExpectRange(Op2(Op::kMod, u_, builder_.Uint(10)), 0, 9);
  ExpectRange(Op2(Op::kMod, i_, builder_.Int(10)), -0x1p31, 0x1p31 - 1);
  ExpectRange(Op2(Op::kMod, byte, builder_.Int(10)), 0, 9);
  ExpectRange(Op2(Op::kDiv, Op2(Op::kAdd, byte, builder_.Int(20)), builder_.Int(10)), 2, 27);
  ExpectRange(Op2(Op::kDiv, byte, Op2(Op::kAnd, i_, builder_.Int(3))), 0, 255);
  ExpectRange(Op2(Op::kShr, u_, builder_.Uint(24)), 0, 255);
  ExpectRange(builder_.Convert(Op2(Op::kShr, u_, builder_.Uint(24)), ir::kFloat), 0, 255);
  ExpectRange(builder_.Convert(u_, ir::kFloat), 0, 0x1p32);
  ExpectRange(builder_.Convert(u_, ir::kInt), -0x1p31, 0x1p31 - 1);
  ExpectRange(builder_.Convert(c_, ir::kInt), 0, 1);
  ExpectRange(builder_.Convert(Op2(Op::kMul, Op1(Op::kFract, x_), Floats({9.5})), ir::kInt), 0, 9);
}

}  // namespace
}  // namespace texgraph::passes
