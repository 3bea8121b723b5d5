// SPDX-License-Identifier: Apache-2.0
// The folds that Builder always applies: constants, and taking apart what was put together.
#include <array>
#include <vector>

#include "compiler/ir/builder.h"
#include "compiler/ir/evaluate_op.h"

namespace texgraph::ir {
namespace {

// Larger constants (arrays) are looked up, never computed.
constexpr size_t kMaxFoldedWords = 64;

}  // namespace

ValueId Builder::ConstElement(ValueId aggregate, uint32_t index) {
  TypeId type = TypeOf(aggregate);
  TypeId element = module_.types.ElementType(type, index);
  std::span<const uint32_t> words =
      ConstWords(aggregate).subspan(module_.types.ElementOffset(type, index), module_.types.Words(element));
  return Const(element, std::vector<uint32_t>(words.begin(), words.end()));
}

ValueId Builder::FoldExtract(ValueId aggregate, uint32_t index) {
  const Inst inst = (*this)[aggregate];
  std::span<const ValueId> operands = function_.Operands(inst);
  switch (inst.op) {
    case Op::kConst: return ConstElement(aggregate, index);
    case Op::kConstruct: return operands[index];
    case Op::kSplat: return IsMatrix(inst.type) ? ValueId() : operands[0];
    case Op::kSwizzle: return Extract(operands[0], SwizzleComponent(inst.aux, index));
    default: return ValueId();
  }
}

ValueId Builder::FoldSwizzle(TypeId type, ValueId vector, uint32_t mask) {
  const Inst inst = (*this)[vector];
  uint32_t width = Width(type);
  if (inst.op == Op::kSplat) return SplatTo(function_.Operands(inst)[0], type);
  if (inst.op == Op::kSwizzle) {
    uint8_t components[4];
    for (uint32_t i = 0; i < width; ++i) {
      components[i] = static_cast<uint8_t>(SwizzleComponent(inst.aux, SwizzleComponent(mask, i)));
    }
    return Swizzle(function_.Operands(inst)[0], {components, width});
  }
  if (inst.op != Op::kConstruct) return ValueId();
  std::array<ValueId, 4> parts;
  for (uint32_t i = 0; i < width; ++i) parts[i] = function_.Operands(inst)[SwizzleComponent(mask, i)];
  return Emit(Op::kConstruct, type, std::span<const ValueId>(parts.data(), width));
}

// construct(v.x, v.y, v.z) is v; construct(v.y, v.x) is a swizzle; construct(s, s, s) is a splat; the members of one struct
// put together again are the struct.
ValueId Builder::FoldConstruct(TypeId type, std::span<const ValueId> parts) {
  if (IsMatrix(type) || parts.empty()) return ValueId();
  const bool is_vector = IsVector(type);
  bool all_equal = true, from_one = true, in_order = true;
  const Inst& first = (*this)[parts[0]];
  ValueId from = first.op == Op::kExtract ? function_.Operands(first)[0] : ValueId();
  for (size_t i = 0; i < parts.size(); ++i) {
    const Inst& part = (*this)[parts[i]];
    all_equal = all_equal && parts[i] == parts[0];
    from_one = from_one && part.op == Op::kExtract && function_.Operands(part)[0] == from;
    in_order = in_order && part.aux == i;
  }
  if (is_vector && all_equal) return Emit(Op::kSplat, type, {parts[0]});
  if (!from || !from_one) return ValueId();
  if (in_order && TypeOf(from) == type) return from;
  if (!is_vector || !IsVector(TypeOf(from))) return ValueId();
  uint8_t components[4];
  for (size_t i = 0; i < parts.size(); ++i) {
    components[i] = static_cast<uint8_t>((*this)[parts[i]].aux);
  }
  return Swizzle(from, {components, parts.size()});
}

ValueId Builder::FoldStructure(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux) {
  switch (op) {
    case Op::kExtract: return FoldExtract(operands[0], aux);
    case Op::kSwizzle: return FoldSwizzle(type, operands[0], aux);
    case Op::kConstruct: return FoldConstruct(type, operands);
    case Op::kConvert:
    case Op::kBitcast: return TypeOf(operands[0]) == type ? operands[0] : ValueId();
    case Op::kSelect: {
      if (operands[1] == operands[2]) return operands[1];
      if (!IsConst(operands[0])) return ValueId();
      std::span<const uint32_t> words = ConstWords(operands[0]);
      for (uint32_t word : words) {
        if (word != words[0]) return ValueId();
      }
      return words[0] ? operands[1] : operands[2];
    }
    case Op::kLogicalAnd:
    case Op::kLogicalOr:
      // The side that decides, before its partner is known: dead branches depend on it.
      for (int side = 0; side < 2; ++side) {
        if (!IsConst(operands[side]) || type != kBool) continue;
        bool value = ConstWords(operands[side])[0] != 0;
        return value == (op == Op::kLogicalOr) ? operands[side] : operands[1 - side];
      }
      return ValueId();
    default: return ValueId();
  }
}

ValueId Builder::FoldConstants(Op op, TypeId type, std::span<const ValueId> operands, uint32_t aux) {
  if (operands.empty() || operands.size() > 16) return ValueId();
  std::array<TypeId, 16> types;
  std::array<const uint32_t*, 16> words;
  for (size_t i = 0; i < operands.size(); ++i) {
    if (!IsConst(operands[i])) return ValueId();
    types[i] = TypeOf(operands[i]);
    words[i] = ConstWords(operands[i]).data();
  }
  if (module_.types.Words(type) > kMaxFoldedWords) return ValueId();
  std::array<uint32_t, kMaxFoldedWords> result;
  OpArguments arguments{op, type, {types.data(), operands.size()}, {words.data(), operands.size()}, aux, 1};
  if (!EvaluateOp(module_.types, arguments, result.data())) return ValueId();
  if (!MayFold(module_.types, arguments, result.data())) return ValueId();
  return Const(type, {result.data(), module_.types.Words(type)});
}

}  // namespace texgraph::ir
