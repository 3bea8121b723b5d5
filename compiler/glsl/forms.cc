// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/forms.h"

#include <algorithm>

namespace texgraph::glsl {
namespace {

// With more operands than this, none is an expression of its own.
constexpr size_t kManyOperands = 16;

// Nothing is computed: a component, a member, a column.
bool IsAccess(Op op) { return op == Op::kExtract || op == Op::kSwizzle; }

// So little is computed that two places may do it, as a person would write it.
bool IsCheap(Op op) {
  return op == Op::kConvert || op == Op::kBitcast || op == Op::kNeg || op == Op::kLogicalNot;
}

}  // namespace

Forms::Forms(const ir::Module& module, const ir::Function& function, const Uses& uses,
             const std::vector<bool>& implicit, bool compact)
    : module_(module),
      function_(function),
      uses_(uses),
      implicit_functions_(implicit),
      compact_(compact),
      forms_(function.insts.size(), Form::kUnused),
      free_(function.insts.size()),
      implicit_(function.insts.size()),
      lengths_(function.insts.size()),
      depths_(function.insts.size()),
      statements_(function.regions.size()) {
  for (size_t i = 0; i < function.insts.size(); ++i) Decide(ValueId(i));
}

bool Forms::IsTernary(ValueId v) const {
  return function_[v].op == Op::kIf && Of(v) != Form::kStatement;
}

void Forms::MakeVariable(ValueId v) {
  forms_[v.index] = Form::kVariable;
  depths_[v.index] = 0;
  implicit_[v.index] = false;
  lengths_[v.index] = static_cast<uint16_t>(NameLength(v));
  ++statements_[uses_.RegionOf(v).index];
  ++variable_count_;
}

void Forms::Decide(ValueId v) {
  const Inst& inst = function_[v];
  bool has_slots = uses_.FirstSlot(v) != Uses::kNoSlot;
  if (uses_.Count(v) == 0 && !has_slots) return;
  switch (inst.op) {
    case Op::kConst:
    case Op::kParam:
    case Op::kGlobal:
      return DecideLeaf(v);
    case Op::kExtract:
      if (uses_.FirstSlot(function_.Operands(inst)[0]) != Uses::kNoSlot &&
          uses_.IsTuple(function_.Operands(inst)[0])) {
        forms_[v.index] = Form::kResult;
        lengths_[v.index] = static_cast<uint16_t>(NameLength(v));
        return;
      }
      break;
    default:
      if (has_slots && !(inst.op == Op::kIf && MayBeTernary(v))) {
        forms_[v.index] = Form::kStatement;
        lengths_[v.index] = static_cast<uint16_t>(NameLength(v));
        ++statements_[uses_.RegionOf(v).index];
        for (uint32_t r = 0; r < uses_.ResultCount(v); ++r) {
          variable_count_ += uses_.SlotLive(uses_.FirstSlot(v) + r);
        }
        return;
      }
  }
  DecideExpression(v);
}

void Forms::DecideLeaf(ValueId v) {
  const Inst& inst = function_[v];
  forms_[v.index] = Form::kLeaf;
  uint32_t length = NameLength(v);
  if (inst.op == Op::kConst && ir::IsVector(inst.type)) {
    std::span<const uint32_t> words = module_.Words(ir::ConstId(inst.aux));
    bool splat = std::ranges::all_of(words, [&](uint32_t w) { return w == words[0]; });
    length = words.size() == 1 ? 4 : splat ? 9 : 4 + 6 * static_cast<uint32_t>(words.size());
  } else if (inst.op == Op::kGlobal) {
    length = static_cast<uint32_t>(module_.globals[inst.aux].name.size());
  }
  lengths_[v.index] = static_cast<uint16_t>(std::min(length, 60000u));
}

// Lets a value's operands stay inside its expression as long as it is short and flat enough.
void Forms::FitOperands(uint32_t own_length) {
  auto is_nested = [&](ValueId o) { return !IsFree(o); };
  if (operands_.size() > kManyOperands) {
    for (ValueId o : operands_) {
      if (is_nested(o)) MakeVariable(o);
    }
    return;
  }
  for (;;) {
    uint32_t length = own_length, depth = 0;
    ValueId longest, deepest;
    for (ValueId o : operands_) {
      length += lengths_[o.index];
      if (!is_nested(o)) continue;
      depth = std::max<uint32_t>(depth, depths_[o.index]);
      if (!longest || lengths_[o.index] > lengths_[longest.index]) longest = o;
      if (!deepest || depths_[o.index] > depths_[deepest.index]) deepest = o;
    }
    if (depth >= kMaxDepth) {
      MakeVariable(deepest);
    } else if (length > kMaxRoot && longest) {
      MakeVariable(longest);
    } else {
      return;
    }
  }
}

void Forms::DecideExpression(ValueId v) {
  ++operation_count_;
  const Inst& inst = function_[v];
  operands_.clear();
  ForEachOperand(function_, v, [&](ValueId o) { operands_.push_back(o); });
  uint32_t own_length = OwnLength(v);
  if (inst.op == Op::kIf) {
    // The sides stay what they are: short, or this would be a statement.
    std::vector<ValueId> all = operands_;
    operands_.resize(1);
    FitOperands(own_length + lengths_[all[1].index] + lengths_[all[2].index]);
    operands_ = all;
  } else {
    FitOperands(own_length);
  }
  uint32_t length = own_length, depth = 0;
  bool all_free = true, implicit = TakesImplicit(v);
  for (ValueId o : operands_) {
    length += lengths_[o.index];
    depth = std::max<uint32_t>(depth, depths_[o.index]);
    all_free = all_free && IsFree(o);
    implicit = implicit || implicit_[o.index];
  }
  bool named = function_.NameOf(v).valid() && !compact_;
  bool is_access = IsAccess(inst.op);
  bool cheap = IsCheap(inst.op) && !named &&
               (uses_.Count(v) == 1 || (ir::IsScalar(inst.type) && uses_.Count(v) == 2));
  free_[v.index] = all_free && (is_access || inst.op == Op::kSplat || cheap);
  implicit_[v.index] = implicit;
  depths_[v.index] = static_cast<uint8_t>(depth + !is_access);
  lengths_[v.index] = static_cast<uint16_t>(std::min(length, 60000u));
  forms_[v.index] = Form::kInline;
  // Chains of free values are free, but a person writes no long ones either.
  if (free_[v.index] && depths_[v.index] < kMaxDepth && length <= kMaxLength) return;
  free_[v.index] = false;
  if (!MayInline(v)) MakeVariable(v);
}

bool Forms::MayInline(ValueId v) const {
  const Inst& inst = function_[v];
  if (uses_.Count(v) != 1 || inst.op == Op::kDfdx || inst.op == Op::kDfdy) return false;
  if (module_.types.Kind(inst.type) == ir::TypeKind::kArray || (uses_.Flags(v) & kIndexedUse))
    return false;
  RegionId home = uses_.RegionOf(v);
  bool ends_region = (uses_.Flags(v) & kResultUse) && uses_.Place(v) == home;
  // What a region hands on, or an out parameter gets, is written straight there. What is returned
  // keeps its name.
  bool assigned = ends_region && (home != function_.body || (uses_.Flags(v) & kOutUse));
  if (!compact_ && function_.NameOf(v) && !assigned) return false;
  return (ends_region || lengths_[v.index] <= kMaxLength) && MayMove(v);
}

// Whether evaluating `v` where it is used is never more work and never without its neighbours.
bool Forms::MayMove(ValueId v) const {
  if (implicit_[v.index] && (uses_.Flags(v) & kLazyUse)) return false;
  for (RegionId r = uses_.Place(v); r != uses_.RegionOf(v); r = uses_.Info(r).parent) {
    if (uses_.Info(r).is_loop || implicit_[v.index]) return false;
  }
  return true;
}

bool Forms::MayBeTernary(ValueId v) const {
  const Inst& inst = function_[v];
  if (uses_.IsTuple(v) || ContainsArray(inst.type)) return false;
  const ir::Branch& branch = function_.branches[inst.aux];
  uint32_t length = 0;
  for (RegionId side : {branch.then_region, branch.else_region}) {
    if (HasStatements(side)) return false;
    ValueId result = function_.regions[side.index].results[0];
    length += lengths_[result.index];
    if (depths_[result.index] > 2) return false;
  }
  return length <= kMaxTernary;
}

bool Forms::ContainsArray(TypeId type) const {
  const ir::Type& t = module_.types[type];
  if (t.kind == ir::TypeKind::kArray) return true;
  return t.kind == ir::TypeKind::kStruct &&
         std::ranges::any_of(t.fields,
                             [&](const ir::StructField& f) { return ContainsArray(f.type); });
}

bool Forms::TakesImplicit(ValueId v) const {
  const Inst& inst = function_[v];
  switch (inst.op) {
    case Op::kSample:
    case Op::kDfdx:
    case Op::kDfdy:
      return true;
    case Op::kCall:
      return implicit_functions_[inst.aux];
    default:
      return false;
  }
}

uint32_t Forms::NameLength(ValueId v) const {
  if (NameId name = function_.NameOf(v)) {
    return std::min<uint32_t>(static_cast<uint32_t>(module_.Name(name).size()), 256);
  }
  return 8;
}

// What an operation adds to the length of its operands.
uint32_t Forms::OwnLength(ValueId v) const {
  const Inst& inst = function_[v];
  uint32_t commas = operands_.empty() ? 0 : 2 * (static_cast<uint32_t>(operands_.size()) - 1);
  switch (inst.op) {
    case Op::kExtract: {
      const ir::Type& from = module_.types[function_[operands_[0]].type];
      if (from.kind != ir::TypeKind::kStruct) return 2;
      return 1 + static_cast<uint32_t>(from.fields[inst.aux].name.size());
    }
    case Op::kSwizzle:
      return 5;
    case Op::kSplat:
      return 6;
    case Op::kIf:
    case Op::kSelect:
      return 6;
    case Op::kIndex:
      return 2;
    case Op::kConvert:
      return 7;
    case Op::kBitcast:
      return 17;
    case Op::kConstruct: {
      uint32_t length = 2 + commas + static_cast<uint32_t>(module_.types[inst.type].name.size());
      return length + (ir::IsVector(inst.type) ? 2 : 0);
    }
    case Op::kCall: {
      const ir::Function& callee = module_[FunctionId(inst.aux)];
      const std::string& name = callee.display_name.empty() ? callee.name : callee.display_name;
      return static_cast<uint32_t>(name.size()) + 2 + commas;
    }
    default:
      break;
  }
  std::string_view glsl = ir::Info(inst.op).glsl;
  if (glsl.ends_with('(')) return static_cast<uint32_t>(glsl.size()) + 1 + commas;
  return operands_.size() < 2 ? 1 : 2 + static_cast<uint32_t>(glsl.size());
}

}  // namespace texgraph::glsl
