// SPDX-License-Identifier: Apache-2.0
// Where GLSL leaves a value undefined, or lets implementations differ, the operation must stay in
// the shader.
#include <bit>
#include <cmath>
#include <cstdint>

#include "compiler/ir/evaluate_op.h"

namespace texgraph::ir {
namespace {

constexpr uint32_t kExponent = 0x7f800000u, kMantissa = 0x007fffffu;

bool IsFinite(uint32_t word) { return (word & kExponent) != kExponent; }
// Zero or normal: GPUs may flush subnormal numbers to zero, so nothing folds from or into one.
bool IsPlain(uint32_t word) {
  uint32_t exponent = word & kExponent;
  return exponent == 0 ? (word & kMantissa) == 0 : exponent != kExponent;
}

// Every float among the words of a value; `test` is false for one that is not wanted.
template <class Test>
bool AllFloats(const Types& types, TypeId type, const uint32_t* words, Test test) {
  if (IsVector(type) || IsMatrix(type)) {
    if (!IsFloat(type)) return true;
    for (uint32_t i = 0, n = types.Words(type); i < n; ++i) {
      if (!test(words[i])) return false;
    }
    return true;
  }
  for (uint32_t i = 0, n = types.ElementCount(type); i < n; ++i) {
    TypeId element = types.ElementType(type, i);
    if (!AllFloats(types, element, words, test)) return false;
    words += types.Words(element);
  }
  return true;
}

bool MovesOnly(OpShape shape) {
  return shape == OpShape::kSelection || shape == OpShape::kSplatting ||
         shape == OpShape::kMaking || shape == OpShape::kTaking || shape == OpShape::kIndexing;
}

// Component `i` of the operands of a float operation.
bool FloatDefined(Op op, std::span<const uint32_t* const> x, uint32_t i) {
  auto at = [&](uint32_t operand) { return std::bit_cast<float>(x[operand][i]); };
  switch (op) {
    case Op::kClamp:
      return at(1) <= at(2);
    case Op::kSmoothstep:
      return at(0) < at(1);
    case Op::kPow:
      return at(0) > 0.0f || (at(0) == 0.0f && at(1) > 0.0f);
    case Op::kAtan2:
      return at(0) != 0.0f || at(1) != 0.0f;
    case Op::kAsin:
    case Op::kAcos:
      return std::fabs(at(0)) <= 1.0f;
    default:
      return true;
  }
}

bool IntegerDefined(Op op, bool is_signed, std::span<const uint32_t* const> x, uint32_t i) {
  auto at = [&](uint32_t operand) { return x[operand][i]; };
  auto signed_at = [&](uint32_t operand) { return std::bit_cast<int32_t>(x[operand][i]); };
  switch (op) {
    case Op::kDiv:
      return at(1) != 0 && !(is_signed && at(0) == 0x80000000u && at(1) == 0xffffffffu);
    // GLSL: undefined if either operand is negative, and drivers do differ.
    case Op::kMod:
      return at(1) != 0 && !(is_signed && (signed_at(0) < 0 || signed_at(1) < 0));
    case Op::kShl:
    case Op::kShr:
      return at(1) < 32;
    case Op::kClamp:
      return is_signed ? signed_at(1) <= signed_at(2) : at(1) <= at(2);
    default:
      return true;
  }
}

bool ConversionDefined(const OpArguments& arguments, uint32_t i) {
  if (arguments.op != Op::kConvert || !IsFloat(arguments.operand_types[0])) return true;
  float x = std::bit_cast<float>(arguments.operands[0][i]);
  switch (ScalarOf(arguments.type)) {
    case Scalar::kInt:
      return x >= -2147483648.0f && x < 2147483648.0f;
    case Scalar::kUint:
      return x >= 0.0f && x < 4294967296.0f;
    default:
      return true;
  }
}

bool Defined(const OpArguments& arguments) {
  TypeId type = arguments.operand_types[0];
  if (!IsVector(type)) return true;
  bool is_float = IsFloat(type);
  bool is_signed = ScalarOf(type) == Scalar::kInt;
  for (uint32_t i = 0, n = Width(type); i < n; ++i) {
    if (!ConversionDefined(arguments, i)) return false;
    if (is_float ? !FloatDefined(arguments.op, arguments.operands, i)
                 : !IntegerDefined(arguments.op, is_signed, arguments.operands, i)) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool MayFold(const Types& types, const OpArguments& arguments, const uint32_t* result) {
  if (MovesOnly(Info(arguments.op).shape)) {
    return AllFloats(types, arguments.type, result, IsFinite);
  }
  for (size_t i = 0; i < arguments.operands.size(); ++i) {
    if (!AllFloats(types, arguments.operand_types[i], arguments.operands[i], IsPlain)) return false;
  }
  if (!AllFloats(types, arguments.type, result, IsPlain)) return false;
  if (arguments.op == Op::kNormalize && Width(arguments.type) == 1 && (result[0] << 1) == 0) {
    return false;
  }
  return Defined(arguments);
}

}  // namespace texgraph::ir
