// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>

#include "compiler/passes/pattern.h"
#include "compiler/passes/pattern_stack.h"
#include "compiler/passes/simplify_range.h"

namespace texgraph::passes {
namespace {

using ir::Builder;
using ir::Op;
using ir::Scalar;
using ir::TypeId;
using ir::ValueId;

bool Folds(TypeId type, uint32_t word) {
  if (!ir::IsFloat(type)) return true;
  float value = std::bit_cast<float>(word);
  return value == 0 || std::isnormal(value);
}

bool WordPasses(ValueTest test, TypeId type, uint32_t word) {
  switch (test) {
    case ValueTest::kConst:
      return Folds(type, word);
    case ValueTest::kReciprocal: {
      if (!ir::IsFloat(type)) return false;
      float value = std::bit_cast<float>(word);
      int exponent = 0;
      return std::isnormal(value) && std::isnormal(1.0f / value) &&
             std::fabs(std::frexp(value, &exponent)) == 0.5f;
    }
    case ValueTest::kNegative:
      if (ir::IsFloat(type)) return Folds(type, word) && std::bit_cast<float>(word) < 0;
      return ir::IsInteger(type) && ir::ScalarOf(type) == Scalar::kInt && word > 0x80000000u;
    case ValueTest::kWrapping:
      return ir::IsInteger(type) && ir::ScalarOf(type) == Scalar::kUint && word >= 0xffff0000u;
    case ValueTest::kPowerOfTwo:
      return ir::IsInteger(type) && std::has_single_bit(word) &&
             (ir::ScalarOf(type) == Scalar::kUint || word < 0x80000000u);
    case ValueTest::kShift:
      return ir::IsInteger(type) && word < 16;
    default:
      return false;
  }
}

bool LiteralIs(const PatternNode& node, TypeId type, uint32_t word, bool signed_zero) {
  if (ir::IsFloat(type)) {
    const float literal = node.literal;
    if (node.all_ones) return false;
    if (signed_zero) return word == std::bit_cast<uint32_t>(literal);
    return std::bit_cast<float>(word) == literal;
  }
  if (ir::IsBool(type)) return !node.all_ones && word == uint32_t(node.literal != 0);
  if (node.all_ones) return word == 0xffffffffu;
  return ir::ScalarOf(type) == Scalar::kInt ? static_cast<int32_t>(word) == node.literal
                                            : word == node.literal;
}

bool IsLiteral(const PatternNode& node, const Builder& builder, ValueId value, bool signed_zero) {
  if (!builder.IsConst(value)) return false;
  TypeId type = builder.TypeOf(value);
  if (!ir::IsVector(type) && !ir::IsMatrix(type)) return false;
  for (uint32_t word : builder.ConstWords(value)) {
    if (!LiteralIs(node, type, word, signed_zero)) return false;
  }
  return true;
}

bool HasScalar(TypeId type, uint8_t scalar) {
  if (scalar == PatternNode::kAnyScalar) return true;
  return ir::IsVector(type) && ir::ScalarOf(type) == static_cast<Scalar>(scalar);
}

}  // namespace

bool Passes(ValueTest test, const Builder& builder, ValueId value) {
  TypeId type = builder.TypeOf(value);
  switch (test) {
    case ValueTest::kAny:
      return true;
    case ValueTest::kNonnegative:
      return ir::IsVector(type) && RangeOf(builder, value).low >= 0;
    case ValueTest::kIntegral:
      return ir::IsVector(type) && ir::IsFloat(type) && IsIntegral(builder, value);
    case ValueTest::kFloatInteger: {
      if (!ir::IsInteger(type)) return false;
      Range range = RangeOf(builder, value);
      return range.low >= -0x1p24 && range.high <= 0x1p24;
    }
    default:
      break;
  }
  if (!builder.IsConst(value) || !(ir::IsVector(type) || ir::IsMatrix(type))) return false;
  for (uint32_t word : builder.ConstWords(value)) {
    if (!WordPasses(test, type, word)) return false;
  }
  return true;
}

bool Match(Pattern pattern, const Builder& builder, Op op, TypeId type,
           std::span<const ValueId> operands, bool signed_zero, Bindings& bindings) {
  const PatternNode& root = pattern.back();
  if (root.op != op || root.operand_count != operands.size() || !HasScalar(type, root.scalar))
    return false;
  PatternStack<ValueId> pending;
  for (ValueId operand : operands) pending.Push(operand);
  // From the root down: the last operand comes first, above as here.
  for (size_t i = pattern.size() - 1; i-- > 0;) {
    const PatternNode& node = pattern[i];
    ValueId value = pending.Pop();
    const ir::Inst& inst = builder[value];
    switch (node.kind) {
      case PatternNode::Kind::kLiteral:
        if (!IsLiteral(node, builder, value, signed_zero)) return false;
        break;
      case PatternNode::Kind::kVariable: {
        ValueId& bound = bindings.values[node.variable];
        if (bound && bound != value) return false;
        if (!HasScalar(inst.type, node.scalar) || !Passes(node.test, builder, value)) return false;
        bound = value;
        break;
      }
      case PatternNode::Kind::kOp:
        if (inst.op != node.op || inst.operand_count != node.operand_count) return false;
        if (!HasScalar(inst.type, node.scalar)) return false;
        for (ValueId operand : builder.function().Operands(inst)) pending.Push(operand);
        break;
    }
  }
  return true;
}

}  // namespace texgraph::passes
