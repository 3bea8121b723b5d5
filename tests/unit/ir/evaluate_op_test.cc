// SPDX-License-Identifier: Apache-2.0
// Every operation of values against formulas of its own: to the bit where ops.def says 0, else
// within its ulp of long double.
#include "compiler/ir/evaluate_op.h"

#include <gtest/gtest.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <vector>

namespace texgraph::ir {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr int32_t kIntMin = std::numeric_limits<int32_t>::min();
constexpr int32_t kIntMax = std::numeric_limits<int32_t>::max();

const Types& TheTypes() {
  static const Types types;
  return types;
}

// `operands`: one vector of words each, all lanes.
std::vector<uint32_t> Compute(Op op, TypeId type, std::vector<TypeId> operand_types,
                              const std::vector<std::vector<uint32_t>>& operands,
                              uint32_t lanes = 1, uint32_t aux = 0,
                              const Types& types = TheTypes()) {
  std::vector<const uint32_t*> pointers;
  for (const std::vector<uint32_t>& operand : operands) pointers.push_back(operand.data());
  std::vector<uint32_t> result(size_t{types.Words(type)} * lanes, 0xdeadbeef);
  OpArguments arguments{op, type, operand_types, pointers, aux, lanes};
  EXPECT_TRUE(EvaluateOp(types, arguments, result.data())) << Info(op).name;
  return result;
}

uint32_t Bits(float x) { return std::bit_cast<uint32_t>(x); }
float AsFloat(uint32_t word) { return std::bit_cast<float>(word); }

float F1(Op op, float x) { return AsFloat(Compute(op, kFloat, {kFloat}, {{Bits(x)}})[0]); }
float F2(Op op, float x, float y) {
  return AsFloat(Compute(op, kFloat, {kFloat, kFloat}, {{Bits(x)}, {Bits(y)}})[0]);
}
float F3(Op op, float x, float y, float z) {
  return AsFloat(
      Compute(op, kFloat, {kFloat, kFloat, kFloat}, {{Bits(x)}, {Bits(y)}, {Bits(z)}})[0]);
}
int32_t I2(Op op, int32_t x, int32_t y) {
  return static_cast<int32_t>(
      Compute(op, kInt, {kInt, kInt}, {{static_cast<uint32_t>(x)}, {static_cast<uint32_t>(y)}})[0]);
}
int32_t I1(Op op, int32_t x) {
  return static_cast<int32_t>(Compute(op, kInt, {kInt}, {{static_cast<uint32_t>(x)}})[0]);
}
uint32_t U2(Op op, uint32_t x, uint32_t y) {
  return Compute(op, kUint, {kUint, kUint}, {{x}, {y}})[0];
}

// The same bits, or both NaN.
bool Same(float a, float b) { return Bits(a) == Bits(b) || (std::isnan(a) && std::isnan(b)); }

const std::vector<float>& NastyFloats() {
  static const std::vector<float> values = [] {
    std::vector<float> v = {0.0f,
                            1.0f,
                            0.5f,
                            1.5f,
                            2.5f,
                            0.49999997f,
                            0.1f,
                            3.0f,
                            1e-45f,
                            1.1754942e-38f,
                            1.17549435e-38f,
                            1e-20f,
                            1e20f,
                            3.4028235e38f,
                            8388607.5f,
                            8388608.0f,
                            16777217.0f,
                            2147483648.0f,
                            4294967296.0f,
                            0.99999994f,
                            kInf,
                            kNan};
    for (size_t i = 0, n = v.size(); i < n; ++i) v.push_back(-v[i]);
    std::mt19937 random(5);
    for (int i = 0; i < 60; ++i) v.push_back(AsFloat(static_cast<uint32_t>(random())));
    std::uniform_real_distribution<float> small(-10.0f, 10.0f);
    for (int i = 0; i < 60; ++i) v.push_back(small(random));
    return v;
  }();
  return values;
}

const std::vector<int32_t> kNastyInts = {
    0,  1,  -1,  2,    -2,    3,          7,       -7,          31,      32,         33,
    63, 64, 100, -100, 65535, 0x12345678, kIntMax, kIntMax - 1, kIntMin, kIntMin + 1};

// --- Floats, to the bit --------------------------------------------------------------------------

TEST(EvaluateOp, FloatArithmeticIsIeeeSinglePrecision) {
  // Rounding the exact double once: a float product fits a double exactly, sums and quotients round
  // innocuously.
  for (float x : NastyFloats()) {
    for (float y : NastyFloats()) {
      EXPECT_TRUE(Same(F2(Op::kAdd, x, y), static_cast<float>(double{x} + double{y})))
          << x << " " << y;
      EXPECT_TRUE(Same(F2(Op::kSub, x, y), static_cast<float>(double{x} - double{y})))
          << x << " " << y;
      EXPECT_TRUE(Same(F2(Op::kMul, x, y), static_cast<float>(double{x} * double{y})))
          << x << " " << y;
      EXPECT_TRUE(Same(F2(Op::kDiv, x, y), static_cast<float>(double{x} / double{y})))
          << x << " " << y;
    }
    EXPECT_EQ(Bits(F1(Op::kNeg, x)), Bits(x) ^ 0x80000000u);
    EXPECT_EQ(Bits(F1(Op::kAbs, x)), Bits(x) & 0x7fffffffu);
    EXPECT_TRUE(Same(F1(Op::kSqrt, x), static_cast<float>(std::sqrt(double{x})))) << x;
    float root = static_cast<float>(std::sqrt(double{x}));
    EXPECT_TRUE(Same(F1(Op::kInverseSqrt, x), static_cast<float>(1.0 / double{root}))) << x;
  }
}

TEST(EvaluateOp, MinMaxClampAreWordedAsInGlsl) {
  for (float x : NastyFloats()) {
    for (float y : NastyFloats()) {
      EXPECT_EQ(Bits(F2(Op::kMin, x, y)), Bits(y < x ? y : x));
      EXPECT_EQ(Bits(F2(Op::kMax, x, y)), Bits(x < y ? y : x));
      EXPECT_EQ(Bits(F2(Op::kStep, x, y)), Bits(y < x ? 0.0f : 1.0f));
    }
  }
  EXPECT_EQ(F3(Op::kClamp, 5, 0, 1), 1);
  EXPECT_EQ(F3(Op::kClamp, -5, 0, 1), 0);
  EXPECT_EQ(F3(Op::kClamp, 0.25f, 0, 1), 0.25f);
  // min(max(x, low), high): with low above high, high wins.
  EXPECT_EQ(F3(Op::kClamp, 0.5f, 2, 1), 1);
}

TEST(EvaluateOp, RoundingFunctionsOfWholeAndHalfNumbers) {
  struct Case {
    float x, floor, ceil, trunc, round;
  };
  for (Case c : {Case{0.0f, 0, 0, 0, 0},
                 {-0.0f, -0.0f, -0.0f, -0.0f, -0.0f},
                 {0.5f, 0, 1, 0, 0},
                 {1.5f, 1, 2, 1, 2},
                 {2.5f, 2, 3, 2, 2},
                 {-0.5f, -1, -0.0f, -0.0f, -0.0f},
                 {-1.5f, -2, -1, -1, -2},
                 {-2.5f, -3, -2, -2, -2},
                 {0.49999997f, 0, 1, 0, 0},
                 {-0.2f, -1, -0.0f, -0.0f, -0.0f},
                 {3.7f, 3, 4, 3, 4},
                 {-3.7f, -4, -3, -3, -4},
                 {8388607.5f, 8388607, 8388608, 8388607, 8388608},
                 {16777216.0f, 16777216, 16777216, 16777216, 16777216},
                 {1e20f, 1e20f, 1e20f, 1e20f, 1e20f},
                 {kInf, kInf, kInf, kInf, kInf},
                 {-kInf, -kInf, -kInf, -kInf, -kInf},
                 {kNan, kNan, kNan, kNan, kNan}}) {
    EXPECT_TRUE(Same(F1(Op::kFloor, c.x), c.floor)) << c.x;
    EXPECT_TRUE(Same(F1(Op::kCeil, c.x), c.ceil)) << c.x;
    EXPECT_TRUE(Same(F1(Op::kTrunc, c.x), c.trunc)) << c.x;
    EXPECT_TRUE(Same(F1(Op::kRound, c.x), c.round)) << c.x;
  }
  std::fesetround(FE_TONEAREST);
  for (float x : NastyFloats()) EXPECT_TRUE(Same(F1(Op::kRound, x), std::nearbyint(x))) << x;
}

TEST(EvaluateOp, FractAndModAreWhatGlslSays) {
  EXPECT_EQ(F1(Op::kFract, 2.75f), 0.75f);
  EXPECT_EQ(F1(Op::kFract, -2.75f), 0.25f);
  EXPECT_EQ(F1(Op::kFract, -1e-10f), 1.0f);  // x - floor(x), rounded
  EXPECT_EQ(F2(Op::kFmod, 7, 3), 1);
  EXPECT_EQ(F2(Op::kFmod, -7, 3), 2);
  EXPECT_EQ(F2(Op::kFmod, 7, -3), -2);
  EXPECT_TRUE(std::isnan(F2(Op::kFmod, 1, 0)));
  for (float x : NastyFloats()) {
    float whole = std::floor(x);
    EXPECT_TRUE(Same(F1(Op::kFract, x), static_cast<float>(double{x} - double{whole}))) << x;
    for (float y : NastyFloats()) {
      volatile float quotient = x / y;
      volatile float product = y * std::floor(quotient);
      EXPECT_TRUE(Same(F2(Op::kFmod, x, y), x - product)) << x << " " << y;
    }
  }
}

TEST(EvaluateOp, MixIsExactAtItsEnds) {
  // x * (1 - t) + y * t, each step rounded: unlike x + t * (y - x) it gives y itself for t = 1.
  for (float x : {0.1f, 1e20f, -3.7f}) {
    for (float y : {0.3f, 1e-20f, 12345.678f}) {
      EXPECT_EQ(F3(Op::kMix, x, y, 0), x);
      EXPECT_EQ(F3(Op::kMix, x, y, 1), y);
      for (float t : {0.1f, 0.5f, 0.9f, -2.0f, 7.0f}) {
        float rest = static_cast<float>(1.0 - double{t});
        float a = static_cast<float>(double{x} * rest), b = static_cast<float>(double{y} * t);
        EXPECT_EQ(F3(Op::kMix, x, y, t), static_cast<float>(double{a} + double{b}));
      }
    }
  }
}

TEST(EvaluateOp, SmoothstepIsFlatOutsideAndHalfInTheMiddle) {
  EXPECT_EQ(F3(Op::kSmoothstep, 1, 3, 0), 0);
  EXPECT_EQ(F3(Op::kSmoothstep, 1, 3, 1), 0);
  EXPECT_EQ(F3(Op::kSmoothstep, 1, 3, 2), 0.5f);
  EXPECT_EQ(F3(Op::kSmoothstep, 1, 3, 3), 1);
  EXPECT_EQ(F3(Op::kSmoothstep, 1, 3, 9), 1);
  for (double x = 0; x <= 1; x += 0.01) {
    float xf = static_cast<float>(x);
    double t = xf;
    EXPECT_NEAR(F3(Op::kSmoothstep, 0, 1, xf), t * t * (3 - 2 * t), 2.4e-7);
  }
}

// t * (t * (3 - 2t)): a value at which t * t * (3 - 2t) rounds differently, as a reminder that the
// order is part of the meaning.
TEST(EvaluateOp, SmoothstepMultipliesFromTheRight) {
  int differing = 0;
  for (int i = 1; i < 1000; ++i) {
    float t = static_cast<float>(i) / 1000.0f;
    float slope = static_cast<float>(3.0 - 2.0 * double{t});
    float inner = static_cast<float>(double{t} * slope);
    EXPECT_EQ(F3(Op::kSmoothstep, 0, 1, t), static_cast<float>(double{t} * inner));
    float square = static_cast<float>(double{t} * double{t});
    if (static_cast<float>(double{square} * slope) != F3(Op::kSmoothstep, 0, 1, t)) ++differing;
  }
  EXPECT_GT(differing, 0);
}

TEST(EvaluateOp, SignIsOneOfThree) {
  EXPECT_EQ(F1(Op::kSign, 1e-45f), 1);
  EXPECT_EQ(F1(Op::kSign, -kInf), -1);
  EXPECT_EQ(Bits(F1(Op::kSign, 0.0f)), 0u);
  EXPECT_EQ(Bits(F1(Op::kSign, -0.0f)), 0u);
  EXPECT_EQ(F1(Op::kSign, kNan), 0);
}

TEST(EvaluateOp, FmaRoundsTwice) {
  float x = 1.0f + 0x1p-12f;
  // x * x = 1 + 2^-11 + 2^-24 loses its last bit before the sum.
  EXPECT_EQ(F3(Op::kFma, x, x, -1.0f), 0x1p-11f);
}

// --- Floats, within the table's ulp --------------------------------------------------------------

double UlpsApart(float got, long double exact) {
  if (std::isnan(got) && std::isnan(exact)) return 0;
  if (std::isinf(got) || std::isinf(static_cast<float>(exact)))
    return Same(got, static_cast<float>(exact)) ? 0 : 1e9;
  float magnitude = std::fabs(static_cast<float>(exact));
  float ulp = std::nextafter(magnitude, kInf) - magnitude;
  return static_cast<double>(std::fabs(got - exact) / static_cast<long double>(ulp));
}

TEST(EvaluateOp, TranscendentalsAreWithinHalfAUlpAndTheTable) {
  struct Case {
    Op op;
    long double (*function)(long double);
  };
  for (auto [op, function] : std::initializer_list<Case>{{Op::kExp, std::exp},
                                                         {Op::kLog, std::log},
                                                         {Op::kExp2, std::exp2},
                                                         {Op::kLog2, std::log2},
                                                         {Op::kSin, std::sin},
                                                         {Op::kCos, std::cos},
                                                         {Op::kTan, std::tan},
                                                         {Op::kAsin, std::asin},
                                                         {Op::kAcos, std::acos},
                                                         {Op::kAtan, std::atan},
                                                         {Op::kSinh, std::sinh},
                                                         {Op::kCosh, std::cosh},
                                                         {Op::kTanh, std::tanh},
                                                         {Op::kAsinh, std::asinh},
                                                         {Op::kAcosh, std::acosh},
                                                         {Op::kAtanh, std::atanh}}) {
    for (float x : NastyFloats()) {
      double ulps = UlpsApart(F1(op, x), function(static_cast<long double>(x)));
      EXPECT_LE(ulps, 0.5001) << Info(op).name << " of " << x;
      EXPECT_LE(ulps, Info(op).ulp) << Info(op).name << " of " << x;
    }
  }
}

TEST(EvaluateOp, TranscendentalsAtKnownPoints) {
  const float pi = 3.14159265f;
  EXPECT_EQ(F1(Op::kExp, 0), 1);
  EXPECT_EQ(F1(Op::kExp2, 10), 1024);
  EXPECT_EQ(F1(Op::kLog2, 1024), 10);
  EXPECT_FLOAT_EQ(F1(Op::kLog, 2.71828183f), 1);
  EXPECT_FLOAT_EQ(F1(Op::kSin, pi / 6), 0.5f);
  EXPECT_FLOAT_EQ(F1(Op::kCos, pi / 3), 0.5f);
  EXPECT_FLOAT_EQ(F1(Op::kTan, pi / 4), 1);
  EXPECT_FLOAT_EQ(F1(Op::kAsin, 1), pi / 2);
  EXPECT_FLOAT_EQ(F1(Op::kAcos, -1), pi);
  EXPECT_FLOAT_EQ(F1(Op::kAtan, 1), pi / 4);
  EXPECT_EQ(F1(Op::kLog, 0), -kInf);
  EXPECT_TRUE(std::isnan(F1(Op::kLog, -1)));
  EXPECT_TRUE(std::isnan(F1(Op::kAsin, 1.5f)));
  EXPECT_EQ(F1(Op::kExp, 1000), kInf);
}

TEST(EvaluateOp, Atan2KnowsTheQuadrant) {
  const float pi = 3.14159265f;
  EXPECT_FLOAT_EQ(F2(Op::kAtan2, 1, 1), pi / 4);
  EXPECT_FLOAT_EQ(F2(Op::kAtan2, 1, -1), 3 * pi / 4);
  EXPECT_FLOAT_EQ(F2(Op::kAtan2, -1, -1), -3 * pi / 4);
  EXPECT_FLOAT_EQ(F2(Op::kAtan2, -1, 0), -pi / 2);
  EXPECT_EQ(F2(Op::kAtan2, 0, 1), 0);
}

TEST(EvaluateOp, PowOfNegativeBasesIsNoNumber) {
  EXPECT_EQ(F2(Op::kPow, 2, 10), 1024);
  EXPECT_EQ(F2(Op::kPow, 4, -0.5f), 0.5f);
  EXPECT_EQ(F2(Op::kPow, 0, 3), 0);
  EXPECT_EQ(F2(Op::kPow, 9, 0), 1);
  EXPECT_TRUE(std::isnan(F2(Op::kPow, -2, 2)));
  for (float x : NastyFloats()) {
    for (float y : NastyFloats()) {
      if (x < 0) continue;
      EXPECT_LE(UlpsApart(F2(Op::kPow, x, y),
                          std::pow(static_cast<long double>(x), static_cast<long double>(y))),
                0.5001)
          << x << " " << y;
    }
  }
}

// --- Integers ------------------------------------------------------------------------------------

TEST(EvaluateOp, IntegersWrapModuloTwoToThe32) {
  auto wrap = [](int64_t x) {
    return static_cast<int32_t>(static_cast<uint32_t>(static_cast<uint64_t>(x)));
  };
  for (int32_t x : kNastyInts) {
    for (int32_t y : kNastyInts) {
      int64_t a = x, b = y;
      uint32_t ux = static_cast<uint32_t>(x), uy = static_cast<uint32_t>(y);
      EXPECT_EQ(I2(Op::kAdd, x, y), wrap(a + b));
      EXPECT_EQ(I2(Op::kSub, x, y), wrap(a - b));
      EXPECT_EQ(I2(Op::kMul, x, y), wrap(a * b));
      EXPECT_EQ(U2(Op::kMul, ux, uy), static_cast<uint32_t>(uint64_t{ux} * uy));
      EXPECT_EQ(I2(Op::kMin, x, y), std::min(x, y));
      EXPECT_EQ(I2(Op::kMax, x, y), std::max(x, y));
      EXPECT_EQ(U2(Op::kMin, ux, uy), std::min(ux, uy));
      EXPECT_EQ(U2(Op::kMax, ux, uy), std::max(ux, uy));
      EXPECT_EQ(U2(Op::kAnd, ux, uy), ux & uy);
      EXPECT_EQ(U2(Op::kOr, ux, uy), ux | uy);
      EXPECT_EQ(U2(Op::kXor, ux, uy), ux ^ uy);
      // Shifts by multiplication and division, by the distance modulo 32.
      uint32_t distance = uy % 32;
      EXPECT_EQ(U2(Op::kShl, ux, uy),
                static_cast<uint32_t>(uint64_t{ux} * (uint64_t{1} << distance)));
      EXPECT_EQ(U2(Op::kShr, ux, uy), static_cast<uint32_t>(ux / (uint64_t{1} << distance)));
      EXPECT_EQ(I2(Op::kShr, x, y),
                static_cast<int32_t>(std::floor(std::ldexp(double(x), -int(distance)))));
      if (y != 0) {
        // Truncated; INT_MIN / -1 is 2^31, which wraps nowhere: 0.
        bool overflows = x == kIntMin && y == -1;
        EXPECT_EQ(I2(Op::kDiv, x, y), overflows ? 0 : static_cast<int32_t>(a / b));
        EXPECT_EQ(I2(Op::kMod, x, y), overflows ? 0 : static_cast<int32_t>(a % b));
        EXPECT_EQ(U2(Op::kDiv, ux, uy), ux / uy);
        EXPECT_EQ(U2(Op::kMod, ux, uy), ux % uy);
      }
    }
    EXPECT_EQ(I2(Op::kDiv, x, 0), 0);
    EXPECT_EQ(I2(Op::kMod, x, 0), 0);
    EXPECT_EQ(U2(Op::kDiv, static_cast<uint32_t>(x), 0), 0u);
    EXPECT_EQ(U2(Op::kMod, static_cast<uint32_t>(x), 0), 0u);
    EXPECT_EQ(I1(Op::kNeg, x), wrap(-int64_t{x}));
    EXPECT_EQ(I1(Op::kAbs, x), wrap(std::abs(int64_t{x})));
    EXPECT_EQ(I1(Op::kSign, x), x > 0 ? 1 : x < 0 ? -1 : 0);
    EXPECT_EQ(I1(Op::kNot, x), wrap(-int64_t{x} - 1));
  }
}

// --- Conversions ---------------------------------------------------------------------------------

uint32_t Convert(TypeId from, TypeId to, uint32_t word) {
  return Compute(Op::kConvert, to, {from}, {{word}})[0];
}

TEST(EvaluateOp, FloatsBecomeIntegersByTruncationAndSaturate) {
  struct Case {
    float x;
    int32_t as_int;
    uint32_t as_uint;
  };
  for (auto [x, as_int, as_uint] :
       std::initializer_list<Case>{{0.0f, 0, 0u},
                                   {-0.0f, 0, 0u},
                                   {1.9f, 1, 1u},
                                   {-1.9f, -1, 0u},
                                   {-0.9f, 0, 0u},
                                   {2147483520.0f, 2147483520, 2147483520u},
                                   {2147483648.0f, kIntMax, 2147483648u},
                                   {-2147483648.0f, kIntMin, 0u},
                                   {-2147483904.0f, kIntMin, 0u},
                                   {4294967040.0f, kIntMax, 4294967040u},
                                   {4294967296.0f, kIntMax, 0xffffffffu},
                                   {1e20f, kIntMax, 0xffffffffu},
                                   {-1e20f, kIntMin, 0u},
                                   {kInf, kIntMax, 0xffffffffu},
                                   {-kInf, kIntMin, 0u},
                                   {kNan, 0, 0u},
                                   {1e-45f, 0, 0u}}) {
    EXPECT_EQ(static_cast<int32_t>(Convert(kFloat, kInt, Bits(x))), as_int) << x;
    EXPECT_EQ(Convert(kFloat, kUint, Bits(x)), as_uint) << x;
  }
}

TEST(EvaluateOp, OtherConversions) {
  EXPECT_EQ(AsFloat(Convert(kInt, kFloat, static_cast<uint32_t>(-7))), -7);
  EXPECT_EQ(AsFloat(Convert(kUint, kFloat, 0xffffffffu)), 4294967296.0f);
  EXPECT_EQ(AsFloat(Convert(kInt, kFloat, 16777217u)), 16777216.0f);  // to even
  EXPECT_EQ(AsFloat(Convert(kInt, kFloat, 16777219u)), 16777220.0f);
  EXPECT_EQ(Convert(kInt, kUint, static_cast<uint32_t>(-1)), 0xffffffffu);
  EXPECT_EQ(Convert(kUint, kInt, 0x80000000u), 0x80000000u);
  EXPECT_EQ(AsFloat(Convert(kBool, kFloat, 1)), 1);
  EXPECT_EQ(AsFloat(Convert(kBool, kFloat, 0)), 0);
  EXPECT_EQ(Convert(kBool, kInt, 1), 1u);
  EXPECT_EQ(Convert(kInt, kBool, 0x80000000u), 1u);
  EXPECT_EQ(Convert(kUint, kBool, 0), 0u);
  EXPECT_EQ(Convert(kFloat, kBool, Bits(-0.0f)), 0u);
  EXPECT_EQ(Convert(kFloat, kBool, Bits(1e-45f)), 1u);
  EXPECT_EQ(Convert(kFloat, kBool, Bits(kNan)), 1u);
  EXPECT_EQ(Compute(Op::kBitcast, kUint, {kFloat}, {{Bits(1.0f)}})[0], 0x3f800000u);
}

// --- Comparison and logic ------------------------------------------------------------------------

TEST(EvaluateOp, ComparisonsOfEachKind) {
  auto compare = [](Op op, TypeId type, uint32_t a, uint32_t b) {
    return Compute(op, kBool, {type, type}, {{a}, {b}})[0];
  };
  for (float x : NastyFloats()) {
    for (float y : NastyFloats()) {
      EXPECT_EQ(compare(Op::kLt, kFloat, Bits(x), Bits(y)), uint32_t(std::isless(x, y)));
      EXPECT_EQ(compare(Op::kLe, kFloat, Bits(x), Bits(y)), uint32_t(std::islessequal(x, y)));
      bool equal = std::islessequal(x, y) && std::islessequal(y, x);
      EXPECT_EQ(compare(Op::kEq, kFloat, Bits(x), Bits(y)), uint32_t(equal));
      EXPECT_EQ(compare(Op::kNe, kFloat, Bits(x), Bits(y)), uint32_t(!equal));
    }
    EXPECT_EQ(Compute(Op::kIsNan, kBool, {kFloat}, {{Bits(x)}})[0], uint32_t(std::isnan(x)));
    EXPECT_EQ(Compute(Op::kIsInf, kBool, {kFloat}, {{Bits(x)}})[0], uint32_t(std::isinf(x)));
  }
  EXPECT_EQ(compare(Op::kLt, kInt, 0xffffffffu, 0), 1u);
  EXPECT_EQ(compare(Op::kLt, kUint, 0xffffffffu, 0), 0u);
  EXPECT_EQ(compare(Op::kLe, kInt, 5, 5), 1u);
  EXPECT_EQ(compare(Op::kEq, kBool, 1, 0), 0u);
  EXPECT_EQ(compare(Op::kNe, kBool, 1, 0), 1u);
}

TEST(EvaluateOp, Logic) {
  for (uint32_t a : {0u, 1u}) {
    for (uint32_t b : {0u, 1u}) {
      std::vector<TypeId> two = {kBool, kBool};
      EXPECT_EQ(Compute(Op::kLogicalAnd, kBool, two, {{a}, {b}})[0], uint32_t(a && b));
      EXPECT_EQ(Compute(Op::kLogicalOr, kBool, two, {{a}, {b}})[0], uint32_t(a || b));
      EXPECT_EQ(Compute(Op::kLogicalXor, kBool, two, {{a}, {b}})[0], uint32_t(a != b));
      EXPECT_EQ(Compute(Op::kAny, kBool, {kBvec2}, {{a, b}})[0], uint32_t(a || b));
      EXPECT_EQ(Compute(Op::kAll, kBool, {kBvec2}, {{a, b}})[0], uint32_t(a && b));
    }
    EXPECT_EQ(Compute(Op::kLogicalNot, kBool, {kBool}, {{a}})[0], uint32_t(!a));
  }
}

// --- Vectors and matrices ------------------------------------------------------------------------

std::vector<uint32_t> Words(std::initializer_list<float> values) {
  std::vector<uint32_t> words;
  for (float value : values) words.push_back(Bits(value));
  return words;
}

TEST(EvaluateOp, VectorProducts) {
  std::vector<uint32_t> a = Words({1, 2, 3}), b = Words({4, -5, 6});
  EXPECT_EQ(Compute(Op::kDot, kFloat, {kVec3, kVec3}, {a, b}), Words({12}));
  EXPECT_EQ(Compute(Op::kCross, kVec3, {kVec3, kVec3}, {a, b}), Words({27, 6, -13}));
  EXPECT_EQ(Compute(Op::kDot, kFloat, {kFloat, kFloat}, {Words({3}), Words({-2})}), Words({-6}));
  EXPECT_EQ(Compute(Op::kLength, kFloat, {kVec2}, {Words({3, 4})}), Words({5}));
  EXPECT_EQ(Compute(Op::kLength, kFloat, {kFloat}, {Words({-1e30f})}), Words({1e30f}));
  EXPECT_EQ(Compute(Op::kDistance, kFloat, {kVec2, kVec2}, {Words({1, 1}), Words({4, 5})}),
            Words({5}));
  EXPECT_EQ(Compute(Op::kDistance, kFloat, {kFloat, kFloat}, {Words({1}), Words({4})}), Words({3}));
  EXPECT_EQ(Compute(Op::kReflect, kVec2, {kVec2, kVec2}, {Words({1, -1}), Words({0, 1})}),
            Words({1, 1}));
  std::vector<uint32_t> n = Compute(Op::kNormalize, kVec2, {kVec2}, {Words({3, 4})});
  EXPECT_FLOAT_EQ(AsFloat(n[0]), 0.6f);
  EXPECT_FLOAT_EQ(AsFloat(n[1]), 0.8f);
  EXPECT_TRUE(std::isnan(AsFloat(Compute(Op::kNormalize, kVec2, {kVec2}, {Words({0, 0})})[0])));
  EXPECT_EQ(F1(Op::kNormalize, -1e-30f), -1);
}

// 1e8 swallows 1 and 1e8 - 1e8 leaves it: the order of the sums shows.
TEST(EvaluateOp, SumsGoInMesasOrder) {
  std::vector<uint32_t> a = Words({1, 1e8f, -1e8f}), ones = Words({1, 1, 1});
  EXPECT_EQ(Compute(Op::kDot, kFloat, {kVec3, kVec3}, {a, ones}), Words({1}));
  EXPECT_EQ(Compute(Op::kDot, kFloat, {kVec3, kVec3}, {Words({1e8f, -1e8f, 1}), ones}), Words({0}));
  // A row is a dot product with each column; a column is a sum of columns, from the first.
  std::vector<uint32_t> rows = Words({1, 0, 0, 1e8f, 0, 0, -1e8f, 0, 0});
  EXPECT_EQ(Compute(Op::kMatMul, kVec3, {kMat3, kVec3}, {rows, ones}), Words({0, 0, 0}));
  std::vector<uint32_t> columns = Words({1, 1e8f, -1e8f, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(Compute(Op::kMatMul, kVec3, {kVec3, kMat3}, {ones, columns}), Words({1, 0, 0}));
}

TEST(EvaluateOp, MatrixProductsAreOfColumns) {
  // Columns (1, 2) and (3, 4); (5, 6) and (7, 8).
  std::vector<uint32_t> m = Words({1, 2, 3, 4}), n = Words({5, 6, 7, 8}), v = Words({10, 100});
  EXPECT_EQ(Compute(Op::kMatMul, kMat2, {kMat2, kMat2}, {m, n}), Words({23, 34, 31, 46}));
  EXPECT_EQ(Compute(Op::kMatMul, kVec2, {kMat2, kVec2}, {m, v}), Words({310, 420}));
  EXPECT_EQ(Compute(Op::kMatMul, kVec2, {kVec2, kMat2}, {v, m}), Words({210, 430}));
  EXPECT_EQ(Compute(Op::kTranspose, kMat2, {kMat2}, {m}), Words({1, 3, 2, 4}));
  EXPECT_EQ(Compute(Op::kAdd, kMat2, {kMat2, kMat2}, {m, n}), Words({6, 8, 10, 12}));
  EXPECT_EQ(Compute(Op::kMul, kMat2, {kMat2, kMat2}, {m, n}), Words({5, 12, 21, 32}));
  std::vector<uint32_t> cyclic = Words({0, 1, 0, 0, 0, 1, 1, 0, 0});  // x to y, y to z, z to x
  EXPECT_EQ(Compute(Op::kMatMul, kVec3, {kMat3, kVec3}, {cyclic, Words({7, 8, 9})}),
            Words({9, 7, 8}));
  EXPECT_EQ(Compute(Op::kTranspose, kMat3, {kMat3}, {cyclic}), Words({0, 0, 1, 1, 0, 0, 0, 1, 0}));
}

// --- Moving --------------------------------------------------------------------------------------

TEST(EvaluateOp, MovesWords) {
  Types types;
  TypeId inner = types.Struct("Inner", {{"a", kVec2}, {"b", kInt}});
  TypeId outer = types.Struct("Outer", {{"x", kFloat}, {"inner", inner}, {"m", kMat2}});
  TypeId array = types.Array(kVec2, 3);
  std::vector<uint32_t> whole = {1, 2, 3, 4, 5, 6, 7, 8};
  EXPECT_EQ(Compute(Op::kConstruct, outer, {kFloat, inner, kMat2}, {{1}, {2, 3, 4}, {5, 6, 7, 8}},
                    1, 0, types),
            whole);
  EXPECT_EQ(Compute(Op::kExtract, inner, {outer}, {whole}, 1, 1, types),
            (std::vector<uint32_t>{2, 3, 4}));
  EXPECT_EQ(Compute(Op::kExtract, kMat2, {outer}, {whole}, 1, 2, types),
            (std::vector<uint32_t>{5, 6, 7, 8}));
  EXPECT_EQ(Compute(Op::kExtract, kVec2, {kMat2}, {{5, 6, 7, 8}}, 1, 1),
            (std::vector<uint32_t>{7, 8}));
  EXPECT_EQ(Compute(Op::kExtract, kUint, {kUvec3}, {{5, 6, 7}}, 1, 2), (std::vector<uint32_t>{7}));
  EXPECT_EQ(Compute(Op::kSwizzle, kIvec4, {kIvec3}, {{5, 6, 7}}, 1, 2 | 0 << 2 | 1 << 4 | 2 << 6),
            (std::vector<uint32_t>{7, 5, 6, 7}));
  EXPECT_EQ(Compute(Op::kSplat, kIvec3, {kInt}, {{9}}), (std::vector<uint32_t>{9, 9, 9}));
  std::vector<uint32_t> list = {10, 11, 20, 21, 30, 31};
  auto at = [&](TypeId type, uint32_t i) {
    return Compute(Op::kIndex, kVec2, {array, type}, {list, {i}}, 1, 0, types)[0];
  };
  EXPECT_EQ(at(kInt, 0), 10u);
  EXPECT_EQ(at(kInt, 2), 30u);
  EXPECT_EQ(at(kInt, 3), 30u);
  EXPECT_EQ(at(kInt, static_cast<uint32_t>(-1)), 10u);
  EXPECT_EQ(at(kInt, 0x80000000u), 10u);
  EXPECT_EQ(at(kUint, 0x80000000u), 30u);
}

TEST(EvaluateOp, SelectsWholeValuesOrComponents) {
  std::vector<uint32_t> a = {1, 2}, b = {3, 4};
  EXPECT_EQ(Compute(Op::kSelect, kIvec2, {kBool, kIvec2, kIvec2}, {{1}, a, b}), a);
  EXPECT_EQ(Compute(Op::kSelect, kIvec2, {kBool, kIvec2, kIvec2}, {{0}, a, b}), b);
  EXPECT_EQ(Compute(Op::kSelect, kIvec2, {kBvec2, kIvec2, kIvec2}, {{0, 1}, a, b}),
            (std::vector<uint32_t>{3, 2}));
}

// Every operation, at several lanes: the same as each lane by itself.
TEST(EvaluateOp, LanesDoNotMix) {
  std::mt19937 random(9);
  struct Case {
    Op op;
    TypeId type;
    std::vector<TypeId> operands;
    uint32_t aux = 0;
  };
  std::vector<Case> cases = {{Op::kDot, kFloat, {kVec3, kVec3}},
                             {Op::kLength, kFloat, {kVec4}},
                             {Op::kDistance, kFloat, {kVec2, kVec2}},
                             {Op::kCross, kVec3, {kVec3, kVec3}},
                             {Op::kReflect, kVec4, {kVec4, kVec4}},
                             {Op::kNormalize, kVec3, {kVec3}},
                             {Op::kMatMul, kMat3, {kMat3, kMat3}},
                             {Op::kMatMul, kVec4, {kMat4, kVec4}},
                             {Op::kMatMul, kVec4, {kVec4, kMat4}},
                             {Op::kTranspose, kMat4, {kMat4}},
                             {Op::kSelect, kVec3, {kBvec3, kVec3, kVec3}},
                             {Op::kSelect, kMat2, {kBool, kMat2, kMat2}},
                             {Op::kSplat, kVec4, {kFloat}},
                             {Op::kConstruct, kMat2, {kVec2, kVec2}},
                             {Op::kExtract, kVec3, {kMat3}, 1},
                             {Op::kSwizzle, kVec2, {kVec4}, 3 | 1 << 2},
                             {Op::kIndex, kVec2, {kMat2, kInt}},
                             {Op::kAny, kBool, {kBvec4}},
                             {Op::kAll, kBool, {kBvec3}},
                             {Op::kLt, kBvec3, {kVec3, kVec3}},
                             {Op::kConvert, kIvec3, {kVec3}},
                             {Op::kBitcast, kUvec2, {kVec2}},
                             {Op::kMix, kVec3, {kVec3, kVec3, kVec3}},
                             {Op::kPow, kVec2, {kVec2, kVec2}},
                             {Op::kShr, kIvec4, {kIvec4, kIvec4}}};
  constexpr uint32_t kLanes = 12;
  for (const Case& c : cases) {
    std::vector<std::vector<uint32_t>> operands;
    for (TypeId type : c.operands) {
      std::vector<uint32_t> words(TheTypes().Words(type) * kLanes);
      for (uint32_t& word : words) {
        word =
            IsFloat(type) ? Bits(static_cast<float>(random() % 1000) / 100.0f - 3) : random() % 2;
      }
      operands.push_back(words);
    }
    std::vector<uint32_t> all = Compute(c.op, c.type, c.operands, operands, kLanes, c.aux);
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
      std::vector<std::vector<uint32_t>> one;
      for (const std::vector<uint32_t>& words : operands) {
        std::vector<uint32_t>& part = one.emplace_back();
        for (size_t i = lane; i < words.size(); i += kLanes) part.push_back(words[i]);
      }
      std::vector<uint32_t> alone = Compute(c.op, c.type, c.operands, one, 1, c.aux);
      for (size_t word = 0; word < alone.size(); ++word) {
        EXPECT_TRUE(Same(AsFloat(all[word * kLanes + lane]), AsFloat(alone[word])))
            << Info(c.op).name;
      }
    }
  }
}

TEST(EvaluateOp, LeavesTheOthersAlone) {
  for (Op op : {Op::kConst, Op::kParam, Op::kGlobal, Op::kSample, Op::kSampleGrad, Op::kSampleLod,
                Op::kFetch, Op::kTextureSize, Op::kDx, Op::kDy, Op::kDfdx, Op::kDfdy, Op::kIf,
                Op::kFor, Op::kCall, Op::kFieldRef, Op::kCallField}) {
    uint32_t x = 1, result = 77;
    const uint32_t* operands[] = {&x, &x, &x};
    TypeId types[] = {kFloat, kFloat, kFloat};
    EXPECT_FALSE(EvaluateOp(TheTypes(), {op, kFloat, types, operands, 0, 1}, &result))
        << Info(op).name;
    EXPECT_EQ(result, 77u);
  }
}

// Every operation of ops.def is either computed or one of those above.
TEST(EvaluateOp, KnowsEveryOperation) {
  for (int i = 0; i < kOpCount; ++i) {
    Op op = static_cast<Op>(i);
    OpShape shape = Info(op).shape;
    bool computed = shape != OpShape::kLeaf && shape != OpShape::kSampling &&
                    shape != OpShape::kTextureQuery && shape != OpShape::kControl &&
                    shape != OpShape::kCalling && op != Op::kDx && op != Op::kDy &&
                    op != Op::kDfdx && op != Op::kDfdy;
    if (!computed) continue;
    TypeId type = shape == OpShape::kInteger ? kIvec3 : shape == OpShape::kLogic ? kBvec3 : kVec3;
    TypeId result = type;
    if (shape == OpShape::kDotLike || shape == OpShape::kLengthLike) result = kFloat;
    if (shape == OpShape::kComparison || shape == OpShape::kTestFloat) result = kBvec3;
    if (shape == OpShape::kReduceBool) type = kBvec3, result = kBool;
    if (shape == OpShape::kMatrixProduct || shape == OpShape::kMatrixUnary) type = result = kMat3;
    std::vector<TypeId> types(3, type);
    if (shape == OpShape::kSelection) types[0] = kBool;
    if (shape == OpShape::kSplatting) types = {kFloat};
    if (shape == OpShape::kMaking) types = {kFloat, kFloat, kFloat};
    if (shape == OpShape::kTaking) result = op == Op::kExtract ? kFloat : kVec2;
    if (shape == OpShape::kIndexing) types[1] = kInt, result = kFloat;
    std::vector<std::vector<uint32_t>> operands(3, std::vector<uint32_t>(9, 1));
    if (shape == OpShape::kMaking || shape == OpShape::kSplatting) operands.resize(types.size());
    Compute(op, result, types, operands);
  }
}

// --- Folding -------------------------------------------------------------------------------------

bool Folds(Op op, TypeId type, std::vector<TypeId> operand_types,
           const std::vector<std::vector<uint32_t>>& operands) {
  std::vector<uint32_t> result = Compute(op, type, operand_types, operands);
  std::vector<const uint32_t*> pointers;
  for (const std::vector<uint32_t>& operand : operands) pointers.push_back(operand.data());
  return MayFold(TheTypes(), {op, type, operand_types, pointers, 0, 1}, result.data());
}
bool Folds1(Op op, float x) { return Folds(op, kFloat, {kFloat}, {{Bits(x)}}); }
bool Folds2(Op op, float x, float y) {
  return Folds(op, kFloat, {kFloat, kFloat}, {{Bits(x)}, {Bits(y)}});
}
bool Folds3(Op op, float x, float y, float z) {
  return Folds(op, kFloat, {kFloat, kFloat, kFloat}, {{Bits(x)}, {Bits(y)}, {Bits(z)}});
}
bool FoldsInt(Op op, int32_t x, int32_t y) {
  return Folds(op, kInt, {kInt, kInt}, {{static_cast<uint32_t>(x)}, {static_cast<uint32_t>(y)}});
}

TEST(MayFold, OrdinaryValuesFold) {
  EXPECT_TRUE(Folds2(Op::kAdd, 1, 2));
  EXPECT_TRUE(Folds2(Op::kMul, 1e-30f, 1e-30f));  // 0 everywhere
  EXPECT_TRUE(Folds2(Op::kDiv, -0.0f, 5));
  EXPECT_TRUE(Folds1(Op::kSqrt, 2));
  EXPECT_TRUE(Folds1(Op::kRound, 2.5f));
  EXPECT_TRUE(Folds2(Op::kPow, 0, 2));
  EXPECT_TRUE(Folds2(Op::kAtan2, 0, 1));
  EXPECT_TRUE(Folds3(Op::kClamp, 5, 1, 1));
  EXPECT_TRUE(Folds3(Op::kSmoothstep, 0, 1, 5));
  EXPECT_TRUE(FoldsInt(Op::kAdd, kIntMax, 1));
  EXPECT_TRUE(FoldsInt(Op::kDiv, -7, 2));
  EXPECT_TRUE(FoldsInt(Op::kMod, 7, 2));
  EXPECT_TRUE(FoldsInt(Op::kShl, 1, 31));
  EXPECT_TRUE(Folds(Op::kConvert, kInt, {kFloat}, {{Bits(-2147483648.0f)}}));
  EXPECT_TRUE(Folds(Op::kConvert, kUint, {kFloat}, {{Bits(-0.0f)}}));
  EXPECT_TRUE(
      Folds(Op::kSelect, kVec2, {kBool, kVec2, kVec2}, {{1}, Words({1, 2}), Words({3, 4})}));
  EXPECT_TRUE(Folds(Op::kConstruct, kVec2, {kFloat, kFloat}, {Words({1e-45f}), Words({2})}));
  EXPECT_TRUE(Folds(Op::kNormalize, kVec2, {kVec2}, {Words({3, 4})}));
}

TEST(MayFold, NothingFoldsIntoInfinitiesOrNan) {
  EXPECT_FALSE(Folds2(Op::kDiv, 1, 0));
  EXPECT_FALSE(Folds2(Op::kDiv, 0, 0));
  EXPECT_FALSE(Folds2(Op::kMul, 1e30f, 1e30f));
  EXPECT_FALSE(Folds1(Op::kSqrt, -1));
  EXPECT_FALSE(Folds1(Op::kInverseSqrt, 0));
  EXPECT_FALSE(Folds1(Op::kLog, 0));
  EXPECT_FALSE(Folds1(Op::kExp, 100));
  EXPECT_FALSE(Folds2(Op::kFmod, 1, 0));
  EXPECT_FALSE(Folds2(Op::kPow, -1, 0.5f));
  EXPECT_FALSE(Folds1(Op::kAcos, 2));
  EXPECT_FALSE(Folds(Op::kNormalize, kVec3, {kVec3}, {Words({0, 0, 0})}));
  EXPECT_FALSE(Folds(Op::kConstruct, kVec2, {kFloat, kFloat}, {Words({kInf}), Words({2})}));
  EXPECT_FALSE(Folds(Op::kBitcast, kFloat, {kUint}, {{0x7f800000u}}));
  EXPECT_FALSE(Folds(Op::kAdd, kVec2, {kVec2, kVec2}, {Words({0, 1e38f}), Words({0, 3e38f})}));
  EXPECT_FALSE(Folds2(Op::kMin, kNan, 1));
  EXPECT_FALSE(Folds(Op::kIsNan, kBool, {kFloat}, {Words({kNan})}));
}

TEST(MayFold, NothingFoldsWhereGlslIsUndefined) {
  EXPECT_FALSE(FoldsInt(Op::kDiv, 1, 0));
  EXPECT_FALSE(FoldsInt(Op::kMod, 5, 0));
  EXPECT_FALSE(FoldsInt(Op::kDiv, kIntMin, -1));
  EXPECT_FALSE(FoldsInt(Op::kMod, -7, 2));
  EXPECT_FALSE(FoldsInt(Op::kMod, 7, -2));
  EXPECT_FALSE(FoldsInt(Op::kShl, 1, 32));
  EXPECT_FALSE(FoldsInt(Op::kShr, 1, -1));
  EXPECT_FALSE(Folds(Op::kDiv, kUvec2, {kUvec2, kUvec2}, {{1, 1}, {1, 0}}));
  EXPECT_FALSE(Folds(Op::kConvert, kInt, {kFloat}, {{Bits(1e20f)}}));
  EXPECT_FALSE(Folds(Op::kConvert, kInt, {kFloat}, {{Bits(2147483648.0f)}}));
  EXPECT_FALSE(Folds(Op::kConvert, kUint, {kFloat}, {{Bits(-1.0f)}}));
  EXPECT_FALSE(Folds3(Op::kClamp, 0, 2, 1));
  EXPECT_FALSE(Folds3(Op::kSmoothstep, 1, 1, 2));
  EXPECT_FALSE(Folds2(Op::kPow, -2, 2));
  EXPECT_FALSE(Folds2(Op::kPow, 0, 0));
  EXPECT_FALSE(Folds2(Op::kAtan2, 0, 0));
  EXPECT_FALSE(Folds1(Op::kNormalize, 0));
}

TEST(MayFold, NothingFoldsWhereSubnormalNumbersMayBeFlushed) {
  EXPECT_FALSE(Folds2(Op::kMul, 1e-30f, 1e-10f));
  EXPECT_FALSE(Folds2(Op::kAdd, 1e-40f, 1));
  EXPECT_FALSE(Folds(Op::kEq, kBool, {kFloat, kFloat}, {Words({1e-40f}), Words({0})}));
}

}  // namespace
}  // namespace texgraph::ir
