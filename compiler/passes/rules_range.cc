// SPDX-License-Identifier: Apache-2.0
// Rules that follow from the ranges of the operands: comparisons that are settled, bounds that do
// not bind.
#include "compiler/passes/rules.h"
#include "compiler/passes/simplify_range.h"

namespace texgraph::passes {
namespace {

using ir::Builder;
using ir::Op;
using ir::TypeId;
using ir::ValueId;

using Operands = std::span<const ValueId>;

ValueId SettledComparison(Builder& builder, Op op, TypeId type, Operands operands) {
  if (op != Op::kLt && op != Op::kLe && op != Op::kEq && op != Op::kNe) return ValueId();
  const Range a = RangeOf(builder, operands[0]), b = RangeOf(builder, operands[1]);
  const bool below = a.high<b.low, above = a.low> b.high;
  switch (op) {
    case Op::kLt:
      if (below) return builder.Splat(type, true);
      return a.low >= b.high ? builder.Splat(type, false) : ValueId();
    case Op::kLe:
      if (a.high <= b.low) return builder.Splat(type, true);
      return above ? builder.Splat(type, false) : ValueId();
    default:
      return below || above ? builder.Splat(type, op == Op::kNe) : ValueId();
  }
}

ValueId IdleMinMax(Builder& builder, Op op, TypeId, Operands operands) {
  if (op != Op::kMin && op != Op::kMax) return ValueId();
  const Range a = RangeOf(builder, operands[0]), b = RangeOf(builder, operands[1]);
  if (a.high <= b.low) return operands[op == Op::kMin ? 0 : 1];
  if (b.high <= a.low) return operands[op == Op::kMin ? 1 : 0];
  return ValueId();
}

ValueId IdleClamp(Builder& builder, Op op, TypeId, Operands operands) {
  if (op != Op::kClamp) return ValueId();
  const Range a = RangeOf(builder, operands[0]), low = RangeOf(builder, operands[1]),
              high = RangeOf(builder, operands[2]);
  const bool low_idle = a.low >= low.high, high_idle = a.high <= high.low;
  if (low_idle && high_idle) return operands[0];
  if (a.high <= low.low && low.high <= high.low) return operands[1];

  if (a.low >= high.high) return operands[2];
  if (low_idle) return builder.Op2(Op::kMin, operands[0], operands[2]);
  if (high_idle && low.high <= high.low) return builder.Op2(Op::kMax, operands[0], operands[1]);
  return ValueId();
}

ValueId KnownSign(Builder& builder, Op op, TypeId type, Operands operands) {
  if (op != Op::kAbs && op != Op::kSign) return ValueId();
  const Range a = RangeOf(builder, operands[0]);
  if (op == Op::kSign) {
    if (a.low > 0) return builder.Splat(type, 1);
    return a.high < 0 ? builder.Splat(type, -1) : ValueId();
  }
  if (a.low >= 0) return operands[0];
  return a.high <= 0 ? builder.Op1(Op::kNeg, operands[0]) : ValueId();
}

ValueId SettledStep(Builder& builder, Op op, TypeId type, Operands operands) {
  if (op != Op::kStep) return ValueId();
  const Range edge = RangeOf(builder, operands[0]), x = RangeOf(builder, operands[1]);
  if (x.low >= edge.high) return builder.Splat(type, 1);
  return x.high < edge.low ? builder.Splat(type, 0) : ValueId();
}

constexpr CodeRule kRangeRules[] = {
    {"settled_comparison", kFinite, SettledComparison},
    {"idle_min_max", kFinite | kUnsignedZero, IdleMinMax},
    {"idle_clamp", kFinite | kUnsignedZero, IdleClamp},
    {"known_sign", kFinite | kUnsignedZero, KnownSign},
    {"settled_step", kFinite, SettledStep},
};

}  // namespace

std::span<const CodeRule> RangeRules() { return kRangeRules; }

}  // namespace texgraph::passes
