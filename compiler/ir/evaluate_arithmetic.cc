// SPDX-License-Identifier: Apache-2.0
// Float operations whose value is defined to the bit, in the order in which Mesa computes them, so
// that CPU and llvmpipe agree.
#include <cmath>

#include "compiler/ir/evaluate_families.h"

namespace texgraph::ir::families {
namespace {

// The GLSL specification's words for min, max and clamp: which operand comes back for equal values
// and NaN follows from them.
float Min(float x, float y) { return y < x ? y : x; }
float Max(float x, float y) { return x < y ? y : x; }
// 0 for both zeros and for NaN.
float Sign(float x) { return x > 0.0f ? 1.0f : x < 0.0f ? -1.0f : 0.0f; }

// GLSL's roundEven, which is how the operation is printed; round leaves halves to the driver.
float RoundEven(float x) {
  float below = std::floor(x);
  float rest = x - below;  // exact
  if (rest < 0.5f) return std::copysign(below, x);
  if (rest > 0.5f) return std::copysign(below + 1.0f, x);
  if (rest != 0.5f) return x;  // infinities and NaN
  float half = below * 0.5f;
  return std::copysign(half == std::floor(half) ? below : below + 1.0f, x);
}

bool Basic(Op op, Operands x, uint32_t n, uint32_t* r) {
  switch (op) {
    case Op::kAdd:
      Map<float>(x[0], x[1], n, r, [](float a, float b) { return a + b; });
      return true;
    case Op::kSub:
      Map<float>(x[0], x[1], n, r, [](float a, float b) { return a - b; });
      return true;
    case Op::kMul:
      Map<float>(x[0], x[1], n, r, [](float a, float b) { return a * b; });
      return true;
    case Op::kDiv:
      Map<float>(x[0], x[1], n, r, [](float a, float b) { return a / b; });
      return true;
    case Op::kNeg:
      Map<float>(x[0], n, r, [](float a) { return -a; });
      return true;
    case Op::kMin:
      Map<float>(x[0], x[1], n, r, Min);
      return true;
    case Op::kMax:
      Map<float>(x[0], x[1], n, r, Max);
      return true;
    case Op::kClamp:
      Map<float>(x[0], x[1], x[2], n, r,
                 [](float a, float low, float high) { return Min(Max(a, low), high); });
      return true;
    case Op::kAbs:
      Map<float>(x[0], n, r, [](float a) { return std::fabs(a); });
      return true;
    case Op::kSign:
      Map<float>(x[0], n, r, Sign);
      return true;
    default:
      return false;
  }
}

}  // namespace

bool Arithmetic(Op op, Operands x, uint32_t n, uint32_t* r) {
  switch (op) {
    case Op::kFmod:
      Map<float>(x[0], x[1], n, r, [](float a, float b) { return a - b * std::floor(a / b); });
      return true;
    case Op::kFloor:
      Map<float>(x[0], n, r, [](float a) { return std::floor(a); });
      return true;
    case Op::kCeil:
      Map<float>(x[0], n, r, [](float a) { return std::ceil(a); });
      return true;
    case Op::kTrunc:
      Map<float>(x[0], n, r, [](float a) { return std::trunc(a); });
      return true;
    case Op::kRound:
      Map<float>(x[0], n, r, RoundEven);
      return true;
    // Just below zero this rounds up to 1, on GPUs as well.
    case Op::kFract:
      Map<float>(x[0], n, r, [](float a) { return a - std::floor(a); });
      return true;
    case Op::kStep:
      Map<float>(x[0], x[1], n, r, [](float edge, float a) { return a < edge ? 0.0f : 1.0f; });
      return true;
    case Op::kMix:
      Map<float>(x[0], x[1], x[2], n, r,
                 [](float a, float b, float t) { return a * (1.0f - t) + b * t; });
      return true;
    case Op::kSmoothstep:
      Map<float>(x[0], x[1], x[2], n, r, [](float e0, float e1, float a) {
        float t = Min(Max((a - e0) / (e1 - e0), 0.0f), 1.0f);
        return t * (t * (3.0f - 2.0f * t));
      });
      return true;
    // Two roundings: GLSL lets an implementation choose, and dialects without fma are given a * b +
    // c.
    case Op::kFma:
      Map<float>(x[0], x[1], x[2], n, r, [](float a, float b, float c) { return a * b + c; });
      return true;
    case Op::kSqrt:
      Map<float>(x[0], n, r, [](float a) { return std::sqrt(a); });
      return true;
    case Op::kInverseSqrt:
      Map<float>(x[0], n, r, [](float a) { return 1.0f / std::sqrt(a); });
      return true;
    default:
      return Basic(op, x, n, r);
  }
}

}  // namespace texgraph::ir::families
