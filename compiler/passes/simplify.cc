// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/simplify.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "compiler/ir/rebuild.h"
#include "compiler/passes/narrow_structs.h"
#include "compiler/passes/simplify_function.h"

namespace texgraph::passes {
namespace {

using ir::ConstId;
using ir::FunctionId;
using ir::GlobalId;
using ir::Op;
using ir::ValueId;

// Each round copies what the one before has left improvable, which is little after the first. The
// bound is far beyond what calls and loops nest.
constexpr int kMaxRounds = 64;

class Simplifier {
 public:
  Simplifier(ir::Module& module, RuleFlags allowed) : module_(module), rules_(allowed) {}

  // `stale`: the functions that are not yet as Simplify leaves them.
  void Run(std::vector<bool> stale) {
    stale_ = std::move(stale);
    for (int round = 0; round < kMaxRounds; ++round) {
      FindCalls();
      DropUnreachable();
      FindUse();
      if (!CopyStale() && !NarrowStructs(module_, stale_)) break;
    }
    FindCalls();
    DropUnreachable();
    DropUnusedGlobals();
  }

 private:
  // What all calls of a function pass to one of its parameters.
  struct Argument {
    enum class Kind : uint8_t { kNone, kConst, kVaries };
    Kind kind = Kind::kNone;
    ConstId value;
    bool repeats = true;  // of a texture, ir::Parameter::repeats
  };

  void FindCalls();
  void MergeArguments(const ir::Function& caller, FunctionId caller_id, const ir::Inst& call);
  void MergeTextures(const ir::Function& caller, const ir::Inst& call);
  void SetRepeats(FunctionId id);
  void MergeTwins(std::span<const ValueId> operands, std::vector<uint32_t>& twins);
  void DropUnreachable();
  void FindUse();
  bool CopyStale();
  bool SignatureShrinks(FunctionId id) const;
  bool CallsChanged(const ir::Function& function) const;
  void DropUnusedGlobals();

  ir::Module& module_;
  SimplifyRules rules_;
  std::vector<bool> stale_;    // by function: copying it may make it simpler
  std::vector<bool> reached_;  // by function: from main
  std::vector<bool>
      pinned_;  // by function: main, and what is used as a value: signatures that stay
  std::vector<std::vector<Argument>> arguments_;  // by function and parameter
  // By function and parameter: the first parameter that gets the same value in every call, itself
  // perhaps. Empty without calls.
  std::vector<std::vector<uint32_t>> twins_;
  ir::SignatureUse use_;
  std::vector<CopiedFunction> copies_;
};

void Simplifier::MergeArguments(const ir::Function& caller, FunctionId caller_id,
                                const ir::Inst& call) {
  std::span<const ValueId> operands = caller.Operands(call);
  for (size_t i = 0; i < operands.size(); ++i) {
    Argument& known = arguments_[call.aux][i];
    if (known.kind == Argument::Kind::kVaries) continue;
    Argument passed{Argument::Kind::kVaries, ConstId()};
    const ir::Inst& operand = caller[operands[i]];
    if (operand.op == Op::kConst) passed = {Argument::Kind::kConst, ConstId(operand.aux)};
    // The caller's own parameter, unless it is a loop's, may be a constant that is passed on.
    if (operand.op == Op::kParam && operand.aux < caller.Body().params.size() &&
        caller.Body().params[operand.aux] == operands[i] && !pinned_[caller_id.index]) {
      passed = arguments_[caller_id.index][operand.aux];
    }
    if (known.kind == Argument::Kind::kNone) {
      known = passed;
    } else if (passed.kind == Argument::Kind::kVaries || passed.value != known.value) {
      known = {Argument::Kind::kVaries, ConstId()};
    }
  }
}

void Simplifier::MergeTextures(const ir::Function& caller, const ir::Inst& call) {
  const std::span<const ValueId> operands = caller.Operands(call);
  for (size_t i = 0; i < operands.size(); ++i) {
    const ir::Inst& operand = caller[operands[i]];
    if (!ir::IsSampler(operand.type)) continue;
    const bool repeats = operand.op == Op::kGlobal
                             ? module_.globals[operand.aux].repeats
                             : operand.op == Op::kParam && caller.parameters[operand.aux].repeats;
    Argument& known = arguments_[call.aux][i];
    known.repeats = known.repeats && repeats;
  }
}

// Once all callers were seen.
void Simplifier::SetRepeats(FunctionId id) {
  ir::Function& function = module_.functions[id.index];
  for (size_t i = 0; i < function.parameters.size(); ++i) {
    ir::Parameter& parameter = function.parameters[i];
    const bool repeats =
        ir::IsSampler(parameter.type) && !pinned_[id.index] && arguments_[id.index][i].repeats;
    if (repeats == parameter.repeats) continue;
    parameter.repeats = repeats;
    stale_[id.index] = true;
  }
}

void Simplifier::MergeTwins(std::span<const ValueId> operands, std::vector<uint32_t>& twins) {
  const bool is_first = twins.empty();
  for (uint32_t i = 0; i < operands.size(); ++i) {
    if (is_first) {
      const auto same = std::ranges::find(operands.first(i), operands[i]);
      twins.push_back(static_cast<uint32_t>(same - operands.begin()));
    } else if (operands[twins[i]] != operands[i]) {
      twins[i] = i;
    }
  }
}

// From main down: callers come after callees.
void Simplifier::FindCalls() {
  const size_t count = module_.functions.size();
  reached_.assign(count, false);
  pinned_.assign(count, false);
  arguments_.assign(count, {});
  twins_.assign(count, {});
  for (size_t f = 0; f < count; ++f) arguments_[f].resize(module_.functions[f].parameters.size());
  reached_[module_.main.index] = pinned_[module_.main.index] = true;
  for (const ir::Function& function : module_.functions) {
    for (const ir::Inst& inst : function.insts) {
      if (inst.op == Op::kFieldRef) pinned_[inst.aux] = true;
    }
  }
  for (size_t f = count; f-- > 0;) {
    if (!reached_[f]) continue;
    SetRepeats(FunctionId(f));
    const ir::Function& function = module_.functions[f];
    for (const ir::Inst& inst : function.insts) {
      if (inst.op != Op::kCall && inst.op != Op::kFieldRef) continue;
      reached_[inst.aux] = true;
      if (inst.op != Op::kCall) continue;
      MergeArguments(function, FunctionId(f), inst);
      MergeTextures(function, inst);
      MergeTwins(function.Operands(inst), twins_[inst.aux]);
    }
  }
}

template <class T>
void KeepWhere(std::vector<T>& items, const std::vector<bool>& keep) {
  size_t next = 0;
  for (size_t i = 0; i < items.size(); ++i) {
    if (keep[i]) std::swap(items[next++], items[i]);
  }
  items.resize(next);
}

void Simplifier::DropUnreachable() {
  if (std::ranges::find(reached_, false) == reached_.end()) return;
  std::vector<uint32_t> new_index(reached_.size());
  size_t next = 0;
  for (size_t f = 0; f < reached_.size(); ++f) {
    if (!reached_[f]) continue;
    new_index[f] = static_cast<uint32_t>(next);
    if (f != next) {
      module_.functions[next] = std::move(module_.functions[f]);
      arguments_[next] = std::move(arguments_[f]);
      twins_[next] = std::move(twins_[f]);
      stale_[next] = stale_[f];
      pinned_[next] = pinned_[f];
    }
    ++next;
  }
  module_.functions.resize(next);
  stale_.resize(next);
  pinned_.resize(next);
  arguments_.resize(next);
  twins_.resize(next);
  module_.main = FunctionId(new_index[module_.main.index]);
  for (ir::Function& function : module_.functions) {
    for (ir::Inst& inst : function.insts) {
      if (inst.op == Op::kCall || inst.op == Op::kFieldRef) inst.aux = new_index[inst.aux];
    }
  }
}

// Results first, from the callers down; then parameters, from the callees up.
void Simplifier::FindUse() {
  const size_t count = module_.functions.size();
  use_.parameters.assign(count, {});
  use_.results.assign(count, {});
  bool several_results = false;
  for (size_t f = 0; f < count; ++f) {
    const ir::Function& function = module_.functions[f];
    use_.parameters[f].assign(function.parameters.size(), true);
    several_results = several_results || (!pinned_[f] && function.results.size() > 1);
    use_.results[f].assign(function.results.size(), pinned_[f] || function.results.size() == 1);
  }
  for (size_t f = count; several_results && f-- > 0;) {
    const ir::Function& function = module_.functions[f];
    ir::Liveness live(module_, function, FunctionId(f), &use_);
    for (size_t i = 0; i < function.insts.size(); ++i) {
      const ValueId v(i);
      if (function[v].op != Op::kCall || !live.Live(v)) continue;
      std::vector<bool>& results = use_.results[function[v].aux];
      for (uint32_t r = 0; r < live.ResultCount(v); ++r) {
        if (live.LiveResult(v, r)) results[r] = true;
      }
    }
  }
  for (size_t f = 0; f < count; ++f) {
    const ir::Function& function = module_.functions[f];
    if (pinned_[f] || function.parameters.empty()) continue;
    ir::Liveness live(module_, function, FunctionId(f), &use_);
    for (size_t i = 0; i < function.parameters.size(); ++i) {
      bool is_constant = arguments_[f][i].kind == Argument::Kind::kConst;
      use_.parameters[f][i] = !is_constant && live.Live(function.Body().params[i]);
    }
    for (size_t i = 0; i < twins_[f].size(); ++i) {
      if (twins_[f][i] == i || !use_.parameters[f][i]) continue;
      use_.parameters[f][twins_[f][i]] = true;
      use_.parameters[f][i] = false;
    }
  }
}

bool Simplifier::SignatureShrinks(FunctionId id) const {
  const std::vector<bool>& parameters = use_.parameters[id.index];
  const std::vector<bool>& results = use_.results[id.index];
  return std::ranges::find(parameters, false) != parameters.end() ||
         std::ranges::find(results, false) != results.end();
}

bool Simplifier::CallsChanged(const ir::Function& function) const {
  return std::ranges::any_of(function.insts, [&](const ir::Inst& inst) {
    return inst.op == Op::kCall && copies_[inst.aux].ConcernsCallers();
  });
}

// Whether anything was copied.
bool Simplifier::CopyStale() {
  const size_t count = module_.functions.size();
  copies_.assign(count, {});
  for (size_t f = 0; f < count; ++f) {
    const ir::Function& function = module_.functions[f];
    CopiedFunction& copy = copies_[f];
    copy.keeps_parameter.assign(function.parameters.size(), true);
    copy.forwards.resize(function.results.size());
    for (uint32_t i = 0; i < function.results.size(); ++i) copy.result_index.push_back(i);
  }
  FunctionSimplifier simplifier(module_, rules_, copies_);
  bool any = false;
  for (size_t f = 0; f < count; ++f) {
    const FunctionId id(f);
    if (!stale_[f] && !SignatureShrinks(id) && !CallsChanged(module_[id])) continue;
    FunctionPlan plan{{}, twins_[f], use_};
    for (const Argument& argument : arguments_[f]) {
      plan.constants.push_back(argument.kind == Argument::Kind::kConst ? argument.value
                                                                       : ConstId());
    }
    stale_[f] = simplifier.Run(id, plan, !pinned_[f]);
    any = true;
  }
  return any;
}

void Simplifier::DropUnusedGlobals() {
  std::vector<bool> used(module_.globals.size(), false);
  for (const ir::Function& function : module_.functions) {
    for (const ir::Inst& inst : function.insts) {
      if (inst.op == Op::kGlobal) used[inst.aux] = true;
    }
  }
  std::vector<uint32_t> new_index;
  uint32_t next = 0;
  for (bool is_used : used) new_index.push_back(is_used ? next++ : 0);
  KeepWhere(module_.globals, used);
  for (ir::Function& function : module_.functions) {
    for (ir::Inst& inst : function.insts) {
      if (inst.op == Op::kGlobal) inst.aux = new_index[inst.aux];
    }
  }
}

}  // namespace

void Simplify(ir::Module& module, RuleFlags allowed) {
  Simplifier(module, allowed).Run(std::vector<bool>(module.functions.size(), true));
}

void Simplify(ir::Module& module) { Simplify(module, kAllRules); }

void Simplify(ir::Module& module, const std::vector<bool>& changed) {
  Simplifier(module, kAllRules).Run(changed);
}

}  // namespace texgraph::passes
