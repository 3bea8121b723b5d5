// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/lower_expression.h"

#include <array>

#include "compiler/blocks/limits.h"
#include "compiler/blocks/lower.h"
#include "compiler/ir/evaluate_op.h"

namespace texgraph::blocks {

using ir::ConstId;
using ir::Op;
using ir::TypeId;
using ir::ValueId;

ValueId ExpressionLowering::Lower(TypedId id) {
  const TypedExpr& expr = function_[id];
  if (expr.kind == TypedKind::kConstant) return builder_.Const(ConstId(expr.aux));
  if (expr.kind == TypedKind::kSlot) return Slot(expr.aux);
  if (depth_ >= kMaxLoweringDepth) {
    TooDeep(expr);
    return {};
  }
  ++depth_;
  ValueId value = expr.kind == TypedKind::kChoose ? LowerChoose(expr) : LowerWhole(expr);
  --depth_;
  return value;
}

ValueId ExpressionLowering::LowerWhole(const TypedExpr& expr) {
  std::vector<ValueId> args;
  args.reserve(expr.child_count);
  for (uint32_t i = 0; i < expr.child_count; ++i) {
    args.push_back(Lower(function_.children[expr.first_child + i]));
    if (!args.back()) return {};
  }
  switch (expr.kind) {
    case TypedKind::kConstruct:
      return builder_.Construct(expr.type, args);
    case TypedKind::kSwizzle:
      return LowerSwizzle(expr, args[0]);
    case TypedKind::kComposite:
      return LowerComposite(expr, args);
    case TypedKind::kCall:
      return Call(expr, args);
    case TypedKind::kCallField:
      return CallField(expr, args);
    case TypedKind::kLength:
      return builder_.Int(
          static_cast<int32_t>(builder_.module().types.ElementCount(builder_.TypeOf(args[0]))));
    default:
      return expr.op == Op::kIndex ? LowerIndex(expr, args)
                                   : builder_.Emit(expr.op, expr.type, args, expr.aux);
  }
}

// An index that follows from template values is checked as one that is written.
ValueId ExpressionLowering::LowerIndex(const TypedExpr& expr, std::span<const ValueId> args) {
  TypeId aggregate = builder_.TypeOf(args[0]);
  ConstId index = Known(args[1]);
  // A negative one is large as well.
  if (index &&
      builder_.module().Words(index)[0] >= builder_.module().types.ElementCount(aggregate)) {
    OutOfRange(expr, aggregate);
    return {};
  }
  return builder_.Emit(Op::kIndex, expr.type, args);
}

ValueId ExpressionLowering::LowerSwizzle(const TypedExpr& expr, ValueId vector) {
  std::array<uint8_t, 4> components;
  uint32_t width = ir::Width(expr.type);
  for (uint32_t i = 0; i < width; ++i) {
    components[i] = static_cast<uint8_t>(ir::SwizzleComponent(expr.aux, i));
  }
  return builder_.Swizzle(vector, {components.data(), width});
}

// A few operations without calls and samples, which cost less than a branch.
bool ExpressionLowering::IsCheap(TypedId id) const {
  constexpr size_t kMost = 12;
  std::array<TypedId, kMost> open;
  size_t count = 1, seen = 0;
  open[0] = id;
  while (count > 0) {
    const TypedExpr& expr = function_[open[--count]];
    bool plain = expr.kind != TypedKind::kCall && expr.kind != TypedKind::kCallField &&
                 expr.kind != TypedKind::kComposite;
    if (expr.kind == TypedKind::kOp) {
      ir::OpShape shape = ir::Info(expr.op).shape;
      plain = shape != ir::OpShape::kSampling && ir::Info(expr.op).cost <= 4;
    }
    seen += 1 + expr.child_count;
    if (!plain || seen > kMost) return false;
    for (uint32_t i = 0; i < expr.child_count; ++i) {
      open[count++] = function_.children[expr.first_child + i];
    }
  }
  return true;
}

ValueId ExpressionLowering::LowerChoose(const TypedExpr& expr) {
  TypedId on_true = function_.children[expr.first_child + 1];
  TypedId on_false = function_.children[expr.first_child + 2];
  ValueId condition = Lower(function_.children[expr.first_child]);
  if (!condition) return {};
  if (std::optional<bool> known = KnownBool(condition)) return Lower(*known ? on_true : on_false);
  if (IsCheap(on_true) && IsCheap(on_false)) {
    ValueId a = Lower(on_true), b = Lower(on_false);
    return a && b ? builder_.Emit(Op::kSelect, expr.type, {condition, a, b}) : ValueId();
  }
  ir::RegionId then_region = builder_.BeginRegion();
  ValueId a = Lower(on_true);
  builder_.EndRegion({{a}});
  ir::RegionId else_region = builder_.BeginRegion();
  ValueId b = Lower(on_false);
  builder_.EndRegion({{b}});
  return a && b ? builder_.If(condition, then_region, else_region) : ValueId();
}

// --- Known values
// ------------------------------------------------------------------------------------------------

ConstId ExpressionLowering::Known(ValueId value) {
  if (!value) return {};
  if (builder_.IsConst(value)) return ConstId(builder_[value].aux);
  if (builder_.folds()) return {};
  // Instructions follow their operands, so one look at each is enough.
  for (; learned_ < builder_.function().insts.size(); ++learned_) Learn(ValueId(learned_));
  auto found = known_.find(value);
  return found == known_.end() ? ConstId() : found->second;
}

void ExpressionLowering::Learn(ValueId value) {
  constexpr size_t kMost = 64;
  const ir::Inst inst = builder_[value];
  if (inst.operand_count == 0 || inst.operand_count > kMost) return;
  ir::Module& module = builder_.module();
  std::array<TypeId, kMost> types;
  std::array<const uint32_t*, kMost> words;
  for (uint32_t i = 0; i < inst.operand_count; ++i) {
    ValueId operand = builder_.function().Operands(inst)[i];
    ConstId constant;
    if (builder_.IsConst(operand)) {
      constant = ConstId(builder_[operand].aux);
    } else if (auto found = known_.find(operand); found != known_.end()) {
      constant = found->second;
    }
    if (!constant) return;
    types[i] = builder_.TypeOf(operand);
    words[i] = module.Words(constant).data();
  }
  std::vector<uint32_t> result(module.types.Words(inst.type));
  ir::OpArguments arguments{
      inst.op,  inst.type, {types.data(), inst.operand_count}, {words.data(), inst.operand_count},
      inst.aux, 1};
  if (!ir::EvaluateOp(module.types, arguments, result.data())) return;
  if (!ir::MayFold(module.types, arguments, result.data())) return;
  known_[value] = module.Intern(inst.type, result);
}

std::optional<bool> ExpressionLowering::KnownBool(ValueId value) {
  ConstId constant = Known(value);
  if (!constant) return std::nullopt;
  return builder_.module().Words(constant)[0] != 0;
}

// --- Constants
// ---------------------------------------------------------------------------------------------------

namespace {

class ConstantLowering : public ExpressionLowering {
 public:
  using ExpressionLowering::ExpressionLowering;

 protected:
  ValueId Slot(uint32_t) override { return {}; }
  ValueId Call(const TypedExpr&, std::span<const ValueId>) override { return {}; }
  ValueId CallField(const TypedExpr&, std::span<const ValueId>) override { return {}; }
  void TooDeep(const TypedExpr&) override {}
  void OutOfRange(const TypedExpr&, TypeId) override {}
};

// Arrays and structs are put together from their elements' words: they may be larger than what is
// folded.
bool AppendWords(ir::Module& module, ConstantLowering& lowering, const TypedFunction& function,
                 TypedId id, std::vector<uint32_t>& words) {
  const TypedExpr& expr = function[id];
  if (expr.kind == TypedKind::kConstruct && !ir::IsVector(expr.type)) {
    for (uint32_t i = 0; i < expr.child_count; ++i) {
      if (!AppendWords(module, lowering, function, function.Child(id, i), words)) return false;
    }
    return true;
  }
  ConstId constant = lowering.Known(lowering.Lower(id));
  if (!constant) return false;
  std::span<const uint32_t> more = module.Words(constant);
  words.insert(words.end(), more.begin(), more.end());
  return true;
}

}  // namespace

ConstId EvaluateConstant(ir::Module& module, const TypedFunction& function, TypedId expr) {
  const TypedExpr& whole = function[expr];
  if (whole.kind == TypedKind::kConstant) return ConstId(whole.aux);
  if (whole.kind == TypedKind::kSlot) return {};
  ir::Function scratch;
  ir::Builder builder(module, scratch);
  uint32_t depth = 0;
  ConstantLowering lowering(builder, function, depth);
  std::vector<uint32_t> words;
  if (!AppendWords(module, lowering, function, expr, words)) return {};
  return module.Intern(whole.type, words);
}

}  // namespace texgraph::blocks
