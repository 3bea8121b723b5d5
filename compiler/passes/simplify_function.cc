// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/simplify_function.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "compiler/passes/simplify_compact.h"

namespace texgraph::passes {
namespace {

using ir::ConstId;
using ir::FunctionId;
using ir::Op;
using ir::TypeId;
using ir::ValueId;

// A function of straight code that costs no more is copied to where it is called.
constexpr int kMaxInlinedCost = 4;
// Operations of one that is copied because something that it gets is nothing.
constexpr size_t kMaxInlinedForNothing = 64;

// Copies a body; calls follow the new signatures, and the sides of an if know its condition.
class SimplifyRebuilder : public ir::Rebuilder {
 public:
  SimplifyRebuilder(ir::Module& module, const ir::Function& from, const ir::Liveness& live,
                    ir::Builder& to, const std::vector<CopiedFunction>& copies)
      : Rebuilder(module, from, live, to), copies_(copies) {}

 protected:
  void CopyCall(ValueId old, std::span<ValueId> results) override;
  void EnterSide(ValueId old_if, bool taken) override;
  void LeaveSide(ValueId old_if, bool taken) override;

 private:
  bool IsConstantCall(const ir::Function& callee);
  bool IsCallWithNothing(const ir::Function& callee);

  const std::vector<CopiedFunction>& copies_;
  std::vector<ValueId> arguments_;  // of one call at a time
  // What Get gave before a side was entered; one list for each open side.
  std::vector<std::vector<std::pair<ValueId, ValueId>>> hidden_;
};

void SimplifyRebuilder::CopyCall(ValueId old, std::span<ValueId> results) {
  const FunctionId callee(from_[old].aux);
  const CopiedFunction& copy = copies_[callee.index];
  const std::span<const ValueId> old_arguments = from_.Operands(old);
  const uint32_t count = static_cast<uint32_t>(results.size());
  bool calls = false;
  for (uint32_t i = 0; i < count; ++i) {
    if (!live_.LiveResult(old, i)) continue;
    const CopiedFunction::Forward& forward = copy.forwards[i];
    switch (forward.kind) {
      case CopiedFunction::Forward::Kind::kConst:
        results[i] = to_.Const(ConstId(forward.id));
        break;
      case CopiedFunction::Forward::Kind::kArgument:
        results[i] = Get(old_arguments[forward.id]);
        break;
      case CopiedFunction::Forward::Kind::kNone:
        calls = true;
        break;
    }
  }
  if (!calls) return;
  arguments_.clear();
  for (size_t i = 0; i < old_arguments.size(); ++i) {
    if (copy.keeps_parameter[i]) arguments_.push_back(Get(old_arguments[i]));
  }
  const ir::Function& function = module_[callee];
  const uint32_t new_count = static_cast<uint32_t>(function.results.size());
  std::vector<ValueId> inlined;
  ValueId call;
  const bool is_inlined =
      copy.is_inlined || IsConstantCall(function) || IsCallWithNothing(function);
  if (is_inlined) {
    inlined.resize(new_count);
    CopyInline(function, arguments_, to_, inlined);
  } else {
    call = to_.Call(callee, arguments_);
  }
  for (uint32_t i = 0; i < count; ++i) {
    if (results[i] || !live_.LiveResult(old, i)) continue;
    const uint32_t index = copy.result_index[i];
    results[i] = is_inlined ? inlined[index] : to_.Result(call, index, new_count);
  }
}

// Code without branches and fields, of arguments alone; `calls`: other functions may be called.
bool IsPlain(const ir::Function& function, bool calls) {
  return std::ranges::all_of(function.Body().body, [&](ValueId v) {
    const Op op = function[v].op;
    const ir::OpShape shape = ir::Info(op).shape;
    return (calls && op == Op::kCall) ||
           (shape != ir::OpShape::kControl && shape != ir::OpShape::kCalling &&
            shape != ir::OpShape::kLeaf);
  });
}

// With nothing but constants, most of the callee folds.
bool SimplifyRebuilder::IsConstantCall(const ir::Function& callee) {
  auto is_constant = [&](ValueId argument) { return to_.IsConst(argument); };
  return !arguments_.empty() && std::ranges::all_of(arguments_, is_constant) &&
         IsPlain(callee, false);
}

// With a vector of which a component is known to be 0, an alpha say, products in the callee vanish,
// and whatever else they are made of.
bool SimplifyRebuilder::IsCallWithNothing(const ir::Function& callee) {
  auto has_zero = [&](ValueId argument) {
    const TypeId type = to_.TypeOf(argument);
    const Op op = to_[argument].op;
    if (!ir::IsVector(type) || ir::IsScalar(type) || ir::ScalarOf(type) != ir::Scalar::kFloat ||
        (op != Op::kCall && op != Op::kExtract && op != Op::kConstruct)) {
      return false;
    }
    for (uint32_t i = 0; i < ir::Width(type); ++i) {
      const ValueId part = to_.Extract(argument, i);
      if (to_.IsConst(part) && std::bit_cast<float>(to_.ConstWords(part)[0]) == 0) return true;
    }
    return false;
  };
  return callee.Body().body.size() <= kMaxInlinedForNothing &&
         std::ranges::any_of(arguments_, has_zero) && IsPlain(callee, true);
}

void SimplifyRebuilder::EnterSide(ValueId old_if, bool taken) {
  hidden_.emplace_back();
  for (const auto& [v, is] : KnownOnSide(from_, from_.Operands(old_if)[0], taken)) {
    hidden_.back().emplace_back(v, Get(v));
    Set(v, to_.Bool(is));
  }
}

void SimplifyRebuilder::LeaveSide(ValueId, bool) {
  for (auto it = hidden_.back().rbegin(); it != hidden_.back().rend(); ++it)
    Set(it->first, it->second);
  hidden_.pop_back();
}

bool IsSmall(const ir::Function& function) {
  int cost = 0;
  for (ValueId v : function.Body().body) {
    const Op op = function[v].op;
    if (op == Op::kIf || op == Op::kFor || op == Op::kCall || op == Op::kCallField ||
        op == Op::kFieldRef) {
      return false;
    }
    cost += ir::Info(op).cost;
    if (cost > kMaxInlinedCost) return false;
  }
  return true;
}

CopiedFunction::Forward ForwardOf(const ir::Function& function, ValueId result,
                                  const std::vector<uint32_t>& old_index) {
  using Kind = CopiedFunction::Forward::Kind;
  const ir::Inst& inst = function[result];
  if (inst.op == Op::kConst) return {Kind::kConst, inst.aux};
  // Of the function, not of a loop: a loop's parameters are out of scope here.
  if (inst.op == Op::kParam) return {Kind::kArgument, old_index[inst.aux]};
  return {};
}

}  // namespace

bool CopiedFunction::ConcernsCallers() const {
  if (is_inlined || std::ranges::find(keeps_parameter, false) != keeps_parameter.end()) return true;
  if (std::ranges::find(result_index, kGone) != result_index.end()) return true;
  return std::ranges::any_of(forwards,
                             [](const Forward& f) { return f.kind != Forward::Kind::kNone; });
}

bool FunctionSimplifier::Run(FunctionId id, const FunctionPlan& plan, bool may_inline) {
  const ir::Function& from = module_[id];
  CopiedFunction& copy = copies_[id.index];
  ir::Function made;
  made.name = from.name;
  made.display_name = from.display_name;
  made.origin = from.origin;
  std::vector<uint32_t> old_index;  // by new parameter
  {
    ir::Builder builder(module_, made, {.fold = true, .rules = &rules_});
    ir::Liveness live(module_, from, id, &plan.use);
    SimplifyRebuilder rebuilder(module_, from, live, builder, copies_);
    for (size_t i = 0; i < from.parameters.size(); ++i) {
      const ValueId param = from.Body().params[i];
      copy.keeps_parameter[i] = plan.use.Parameter(id, i);
      if (copy.keeps_parameter[i]) {
        rebuilder.Set(param, builder.AddParameter(from.parameters[i]));
        old_index.push_back(static_cast<uint32_t>(i));
      } else if (plan.constants[i]) {
        rebuilder.Set(param, builder.Const(plan.constants[i]));
      } else if (i < plan.twins.size() && plan.twins[i] != i) {
        const ValueId twin = from.Body().params[plan.twins[i]];
        if (plan.use.Parameter(id, plan.twins[i])) rebuilder.Set(param, rebuilder.Get(twin));
      }
    }
    rebuilder.CopyRegion(from.body);
    std::vector<ValueId> results;
    for (size_t i = 0; i < from.results.size(); ++i) {
      copy.result_index[i] = CopiedFunction::kGone;
      if (!plan.use.Result(id, i)) continue;
      copy.result_index[i] = static_cast<uint32_t>(results.size());
      made.results.push_back(from.results[i]);
      results.push_back(rebuilder.Get(from.Body().results[i]));
    }
    builder.Return(results);
  }
  const bool again = Compact(module_, made);
  for (size_t i = 0; i < copy.forwards.size(); ++i) {
    copy.forwards[i] = {};
    const uint32_t index = copy.result_index[i];
    if (may_inline && index != CopiedFunction::kGone) {
      copy.forwards[i] = ForwardOf(made, made.Body().results[index], old_index);
    }
  }
  copy.is_inlined = may_inline && IsSmall(made);
  module_[id] = std::move(made);
  return again;
}

}  // namespace texgraph::passes
