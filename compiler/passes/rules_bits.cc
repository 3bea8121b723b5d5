// SPDX-License-Identifier: Apache-2.0
// Divisions, remainders and products by powers of two, as shifts and masks.
#include <bit>
#include <optional>
#include <vector>

#include "compiler/passes/rules.h"
#include "compiler/passes/simplify_range.h"

namespace texgraph::passes {
namespace {

using ir::Builder;
using ir::Op;
using ir::TypeId;
using ir::ValueId;

using Operands = std::span<const ValueId>;

// The one number that all components of a constant have.
std::optional<uint32_t> OneNumber(const Builder& builder, ValueId value) {
  if (builder[value].op != Op::kConst) return std::nullopt;
  std::span<const uint32_t> words = builder.ConstWords(value);
  for (uint32_t word : words) {
    if (word != words[0]) return std::nullopt;
  }
  return words[0];
}

ValueId Number(Builder& builder, TypeId type, uint32_t number) {
  const std::vector<uint32_t> words(ir::Width(type), number);
  return builder.Const(type, words);
}

ValueId ShiftRight(Builder& builder, ValueId value, uint32_t count) {
  return builder.Op2(Op::kShr, value, Number(builder, builder.TypeOf(value), count));
}

// The exponents of a constant of powers of two; bit 31 of an int is its sign.
std::optional<std::vector<uint32_t>> Exponents(const Builder& builder, ValueId value) {
  if (builder[value].op != Op::kConst) return std::nullopt;
  const bool is_int = ir::ScalarOf(builder.TypeOf(value)) == ir::Scalar::kInt;
  std::vector<uint32_t> exponents;
  for (uint32_t word : builder.ConstWords(value)) {
    if (!std::has_single_bit(word) || (is_int && word >> 31 != 0)) return std::nullopt;
    exponents.push_back(static_cast<uint32_t>(std::countr_zero(word)));
  }
  return exponents;
}

// a / 2^n = a >> n and a % 2^n = a & (2^n - 1), for what is never below zero.
ValueId DivisionByPowerOfTwo(Builder& builder, Op op, TypeId type, Operands operands) {
  if ((op != Op::kDiv && op != Op::kMod) || !ir::IsInteger(type)) return ValueId();
  if (builder.TypeOf(operands[1]) != type) return ValueId();
  std::optional<std::vector<uint32_t>> exponents = Exponents(builder, operands[1]);
  if (!exponents || RangeOf(builder, operands[0]).low < 0) return ValueId();
  if (op == Op::kDiv) {
    return builder.Op2(Op::kShr, operands[0], builder.Const(type, *exponents));
  }
  std::vector<uint32_t> masks;
  for (uint32_t exponent : *exponents) masks.push_back((uint32_t{1} << exponent) - 1);
  return builder.Op2(Op::kAnd, operands[0], builder.Const(type, masks));
}

// (a * 2^n) >> m = a >> (m - n), where the product loses no bits; (a >> n) >> m = a >> (n + m).
ValueId ShiftOfShift(Builder& builder, Op op, TypeId type, Operands operands) {
  if (op != Op::kShr || !ir::IsInteger(type)) return ValueId();
  const ir::Inst& inner = builder[operands[0]];
  if (inner.op != Op::kMul && inner.op != Op::kShr) return ValueId();
  const ValueId a = builder.function().Operands(inner)[0];
  const ValueId b = builder.function().Operands(inner)[1];
  const std::optional<uint32_t> by = OneNumber(builder, b), shift = OneNumber(builder, operands[1]);
  if (!by || !shift || *shift > 31 || builder.TypeOf(a) != type) return ValueId();
  if (inner.op == Op::kShr) {
    if (*by > 31) return ValueId();
    if (*by + *shift <= 31) return ShiftRight(builder, a, *by + *shift);
    const bool is_int = ir::ScalarOf(type) == ir::Scalar::kInt;
    return is_int ? ShiftRight(builder, a, 31) : Number(builder, type, 0);
  }
  if (!std::has_single_bit(*by)) return ValueId();
  const Range range = RangeOf(builder, a);
  const double limit = ir::ScalarOf(type) == ir::Scalar::kInt ? 0x1p31 : 0x1p32;
  const uint32_t exponent = static_cast<uint32_t>(std::countr_zero(*by));
  if (range.low < 0 || range.high * *by >= limit || exponent > *shift) return ValueId();
  return ShiftRight(builder, a, *shift - exponent);
}

constexpr CodeRule kBitRules[] = {
    {"division_by_power_of_two", kExact, DivisionByPowerOfTwo},
    {"shift_of_shift", kExact, ShiftOfShift},
};

}  // namespace

std::span<const CodeRule> BitRules() { return kBitRules; }

}  // namespace texgraph::passes
