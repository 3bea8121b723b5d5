// SPDX-License-Identifier: Apache-2.0
// Rules about the structure of operands: splats, choices of constants, axes, constant indices.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "compiler/ir/evaluate_op.h"
#include "compiler/passes/rules.h"
#include "compiler/passes/simplify_range.h"

namespace texgraph::passes {
namespace {

using ir::Builder;
using ir::Op;
using ir::OpShape;
using ir::TypeId;
using ir::ValueId;

using Operands = std::span<const ValueId>;

// Whether each component of the result comes from the same components of the operands.
bool IsComponentwise(Op op) {
  switch (ir::Info(op).shape) {
    case OpShape::kNumeric:
    case OpShape::kInteger:
    case OpShape::kComparison:
    case OpShape::kLogic:
    case OpShape::kTestFloat:
    case OpShape::kSelection:
    case OpShape::kConversion:
      return true;
    case OpShape::kFloating:
      return op != Op::kNormalize && op != Op::kCross && op != Op::kReflect;
    default:
      return false;
  }
}

bool HasEqualWords(std::span<const uint32_t> words) {
  return std::ranges::all_of(words, [&](uint32_t word) { return word == words[0]; });
}

// op(splat a, splat b) = splat(op(a, b)): a vector operation becomes one of scalars.
ValueId LiftSplats(Builder& builder, Op op, TypeId type, Operands operands) {
  if (!ir::IsVector(type) || ir::IsScalar(type) || !IsComponentwise(op)) return ValueId();
  bool any = false;
  for (ValueId v : operands) {
    const ir::Inst& inst = builder[v];
    if (inst.op == Op::kSplat) {
      any = true;
    } else if (!ir::IsScalar(inst.type) &&
               !(inst.op == Op::kConst && HasEqualWords(builder.ConstWords(v)))) {
      return ValueId();
    }
  }
  if (!any) return ValueId();
  std::array<ValueId, 3> scalars;
  for (size_t i = 0; i < operands.size(); ++i) {
    const ir::Inst& inst = builder[operands[i]];
    if (inst.op == Op::kSplat) {
      scalars[i] = builder.function().Operands(inst)[0];
    } else if (ir::IsScalar(inst.type)) {
      scalars[i] = operands[i];
    } else {
      TypeId scalar = ir::ScalarType(inst.type);
      uint32_t word = builder.ConstWords(operands[i])[0];
      scalars[i] = builder.Const(scalar, {&word, 1});
    }
  }
  ValueId made = builder.Emit(op, ir::ScalarType(type), Operands(scalars.data(), operands.size()));
  return builder.SplatTo(made, type);
}

// The constant that `op` gives for constant operands, if it may be folded.
std::vector<uint32_t> Folded(const Builder& builder, const ir::Types& types, Op op, TypeId type,
                             Operands operands) {
  std::array<TypeId, 3> operand_types;
  std::array<const uint32_t*, 3> words;
  for (size_t i = 0; i < operands.size(); ++i) {
    operand_types[i] = builder.TypeOf(operands[i]);
    words[i] = builder.ConstWords(operands[i]).data();
  }
  std::vector<uint32_t> result(types.Words(type));
  ir::OpArguments arguments{
      op, type, {operand_types.data(), operands.size()}, {words.data(), operands.size()}};
  if (!ir::EvaluateOp(types, arguments, result.data())) return {};
  if (!ir::MayFold(types, arguments, result.data())) return {};
  return result;
}

// op(c ? 1 : 2, 3) = c ? op(1, 3) : op(2, 3), where both can be folded.
ValueId FoldChoices(Builder& builder, Op op, TypeId type, Operands operands) {
  const OpShape shape = ir::Info(op).shape;
  if (op == Op::kSelect || ir::Info(op).cost == 0 || !ir::IsVector(type)) return ValueId();
  const bool componentwise = IsComponentwise(op);
  if (!componentwise && shape != OpShape::kDotLike && shape != OpShape::kLengthLike)
    return ValueId();
  ValueId condition;
  std::array<ValueId, 3> on_true, on_false;
  for (size_t i = 0; i < operands.size(); ++i) {
    on_true[i] = on_false[i] = operands[i];
    if (builder.IsConst(operands[i])) continue;
    const ir::Inst& inst = builder[operands[i]];
    if (inst.op != Op::kSelect) return ValueId();
    Operands parts = builder.function().Operands(inst);
    if (condition && condition != parts[0]) return ValueId();
    condition = parts[0];
    on_true[i] = parts[1];
    on_false[i] = parts[2];
    if (!builder.IsConst(parts[1]) || !builder.IsConst(parts[2])) return ValueId();
  }
  if (!condition || (!componentwise && !ir::IsScalar(builder.TypeOf(condition)))) return ValueId();
  const ir::Types& types = builder.module().types;
  std::vector<uint32_t> first = Folded(builder, types, op, type, {on_true.data(), operands.size()});
  if (first.empty()) return ValueId();
  std::vector<uint32_t> second =
      Folded(builder, types, op, type, {on_false.data(), operands.size()});
  if (second.empty()) return ValueId();
  return builder.Emit(Op::kSelect, type,
                      {condition, builder.Const(type, first), builder.Const(type, second)});
}

// A dot product with a constant that has a single component is a product.
ValueId DotWithAxis(Builder& builder, Op op, TypeId, Operands operands) {
  if (op != Op::kDot) return ValueId();
  for (int side = 0; side < 2; ++side) {
    if (!builder.IsConst(operands[side])) continue;
    std::span<const uint32_t> words = builder.ConstWords(operands[side]);
    auto nonzero = [](uint32_t word) { return std::bit_cast<float>(word) != 0; };
    if (std::ranges::count_if(words, nonzero) != 1) continue;
    auto axis = std::ranges::find_if(words, nonzero);
    float factor = std::bit_cast<float>(*axis);
    ValueId component =
        builder.Extract(operands[1 - side], static_cast<uint32_t>(axis - words.begin()));
    return builder.Op2(Op::kMul, component, builder.Float(factor));
  }
  return ValueId();
}

bool IsIdentity(const Builder& builder, ValueId v) {
  TypeId type = builder.TypeOf(v);
  if (!builder.IsConst(v) || !ir::IsMatrix(type)) return false;
  const uint32_t size = ir::MatrixSize(type);
  std::span<const uint32_t> words = builder.ConstWords(v);
  for (uint32_t i = 0; i < words.size(); ++i) {
    if (std::bit_cast<float>(words[i]) != (i / size == i % size ? 1.0f : 0.0f)) return false;
  }
  return true;
}

ValueId MatMulByIdentity(Builder& builder, Op op, TypeId, Operands operands) {
  if (op != Op::kMatMul) return ValueId();
  if (IsIdentity(builder, operands[0])) return operands[1];
  return IsIdentity(builder, operands[1]) ? operands[0] : ValueId();
}

// A constant index, clamped as ops.def says, names the element.
ValueId IndexByConstant(Builder& builder, Op op, TypeId, Operands operands) {
  if (op != Op::kIndex || !builder.IsConst(operands[1])) return ValueId();
  const TypeId aggregate = builder.TypeOf(operands[0]);
  const int64_t last = int64_t(builder.module().types.ElementCount(aggregate)) - 1;
  const uint32_t word = builder.ConstWords(operands[1])[0];
  const bool is_signed = ir::ScalarOf(builder.TypeOf(operands[1])) == ir::Scalar::kInt;
  const int64_t index = is_signed ? int64_t(static_cast<int32_t>(word)) : int64_t(word);
  return builder.Extract(operands[0], static_cast<uint32_t>(std::clamp<int64_t>(index, 0, last)));
}

// Every component of a splat is the same.
ValueId IndexOfSplat(Builder& builder, Op op, TypeId type, Operands operands) {
  if (op != Op::kIndex || !ir::IsScalar(type)) return ValueId();
  const ir::Inst& inst = builder[operands[0]];
  if (inst.op != Op::kSplat || !ir::IsVector(inst.type)) return ValueId();
  return builder.function().Operands(inst)[0];
}

// An array of whole numbers that count up by one, from 0 say, is a sum; one that holds a single
// number is that number.
ValueId IndexOfRow(Builder& builder, Op op, TypeId type, Operands operands) {
  if (op != Op::kIndex || !builder.IsConst(operands[0]) || (type != ir::kInt && type != ir::kUint))
    return ValueId();
  const std::span<const uint32_t> words = builder.ConstWords(operands[0]);
  const size_t count = words.size();
  const uint32_t first = words.front(), step = count > 1 ? words[1] - first : 0;
  if (step > 1) return ValueId();
  for (uint32_t i = 0; i < count; ++i) {
    if (words[i] != first + i * step) return ValueId();
  }
  const ValueId first_number = builder.Const(type, std::array{first});
  if (step == 0) return first_number;
  const TypeId counted = builder.TypeOf(operands[1]);
  const ValueId last = builder.Splat(counted, double(count - 1));
  const ValueId index =
      builder.Emit(Op::kClamp, counted, {operands[1], builder.Splat(counted, 0), last});
  const ValueId number = counted == type ? index : builder.Convert(index, type);
  return builder.Op2(Op::kAdd, number, first_number);
}

// Beyond so many repeats of a texture in a unit of the coordinate, samplers that count in fixed
// point may run out of bits.
constexpr float kMostRepeats = 1024;

// x * c for x * c - floor(y), where c is no more than kMostRepeats, and for a component of it: what
// a texture that repeats shows at both is the same. Else nothing.
ValueId BeforeWholePart(Builder& builder, ValueId value) {
  const ir::Inst inst = builder[value];
  std::span<const ValueId> x = std::as_const(builder).function().Operands(inst);
  if (inst.op == Op::kExtract && ir::IsVector(builder.TypeOf(x[0]))) {
    const ValueId vector = BeforeWholePart(builder, x[0]);
    return vector ? builder.Extract(vector, inst.aux) : ValueId();
  }
  if (inst.op != Op::kSub || !IsIntegral(builder, x[1]) || builder[x[0]].op != Op::kMul) {
    return ValueId();
  }
  for (ValueId factor : builder.function().Operands(x[0])) {
    if (builder[factor].op != Op::kConst) continue;
    std::span<const uint32_t> words = builder.ConstWords(factor);
    const bool is_small = std::ranges::all_of(
        words, [](uint32_t word) { return std::abs(std::bit_cast<float>(word)) <= kMostRepeats; });
    if (is_small) return x[0];
  }
  return ValueId();
}

bool Repeats(Builder& builder, ValueId sampler) {
  const ir::Inst& inst = builder[sampler];
  if (inst.op == Op::kGlobal) return builder.module().globals[inst.aux].repeats;
  return inst.op == Op::kParam && builder.function().parameters[inst.aux].repeats;
}

// texture(s, x - floor(x)) = texture(s, x) if s repeats. The coordinate no longer jumps, so that
// the sampler can take its footprint from the pixels beside this one.
ValueId RepeatedCoordinate(Builder& builder, Op op, TypeId type, Operands operands) {
  if (op != Op::kSample || !Repeats(builder, operands[0])) return ValueId();
  // The layer of an array comes last, and is no repeat.
  const bool is_array = builder.TypeOf(operands[0]) == ir::kSampler2DArray;
  const ValueId coordinate = operands[1];
  ValueId simpler = is_array ? ValueId() : BeforeWholePart(builder, coordinate);
  if (!simpler && builder[coordinate].op == Op::kConstruct) {
    std::span<const ValueId> held = builder.function().Operands(coordinate);
    std::vector<ValueId> parts(held.begin(), held.end());
    const size_t end = parts.size() - (is_array ? 1 : 0);
    for (size_t i = 0; i < end; ++i) {
      parts[i] = BeforeWholePart(builder, parts[i]);
      if (!parts[i]) return ValueId();
    }
    simpler = builder.Construct(builder.TypeOf(coordinate), parts);
  }
  if (!simpler) return ValueId();
  std::vector<ValueId> simplified(operands.begin(), operands.end());
  simplified[1] = simpler;
  return builder.Emit(op, type, simplified);
}

constexpr CodeRule kStructureRules[] = {
    {"lift_splats", kExact, LiftSplats},
    {"fold_choices", kExact, FoldChoices},
    {"dot_with_axis", kFinite | kUnsignedZero, DotWithAxis},
    {"matmul_by_identity", kFinite | kUnsignedZero, MatMulByIdentity},
    {"index_by_constant", kExact, IndexByConstant},
    {"index_of_splat", kExact, IndexOfSplat},
    {"index_of_row", kExact, IndexOfRow},
    {"repeated_coordinate", kFinite | kRounding, RepeatedCoordinate},
};

}  // namespace

std::span<const CodeRule> StructureRules() { return kStructureRules; }

}  // namespace texgraph::passes
