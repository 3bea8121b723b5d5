// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/rebuild.h"

#include <algorithm>
#include <array>
#include <utility>

namespace texgraph::ir {

// --- Liveness
// ----------------------------------------------------------------------------------------------------

Liveness::Liveness(const Module& module, const Function& function, FunctionId self,
                   const SignatureUse* use)
    : module_(module), function_(function), use_(use), live_(function.insts.size()) {
  Index();
  seen_from_ = function.insts.size();
  const std::vector<ValueId>& results = function.Body().results;
  for (size_t i = 0; i < results.size(); ++i) {
    if (!use || !self || use->Result(self, i)) Mark(results[i]);
  }
  VisitAll();
}

void Liveness::VisitAll() {
  while (seen_from_-- > 0) {
    const ValueId v(seen_from_);
    if (!live_[v.index]) continue;
    if (first_result_[v.index] == kSingle) {
      Visit(v);
    } else {
      for (uint32_t i = 0; i < ResultCount(v); ++i) {
        if (LiveResult(v, i)) VisitResult(v, i);
      }
    }
    while (!work_.empty()) {
      auto [value, index] = work_.back();
      work_.pop_back();
      if (index == kSingle) {
        Visit(value);
      } else {
        VisitResult(value, index);
      }
    }
  }
}

void Liveness::Index() {
  first_result_.assign(function_.insts.size(), kSingle);
  for (size_t i = 0; i < function_.insts.size(); ++i) {
    const Inst& inst = function_.insts[i];
    if (inst.op != Op::kIf && inst.op != Op::kFor && inst.op != Op::kCall) continue;
    if (module_.types.Kind(inst.type) == TypeKind::kTuple) {
      first_result_[i] = static_cast<uint32_t>(result_live_.size());
      result_live_.resize(result_live_.size() + module_.types.ElementCount(inst.type));
    }
    if (inst.op != Op::kFor) continue;
    const Region& body = function_.regions[function_.loops[inst.aux].body.index];
    for (size_t p = 1; p < body.params.size(); ++p) {
      carried_[body.params[p]] = {ValueId(i), static_cast<uint32_t>(p - 1)};
    }
  }
}

uint32_t Liveness::ResultCount(ValueId v) const {
  return first_result_[v.index] == kSingle ? 1 : module_.types.ElementCount(function_[v].type);
}

void Liveness::Mark(ValueId v) {
  if (first_result_[v.index] != kSingle) {
    // A tuple that is used whole.
    for (uint32_t i = 0; i < ResultCount(v); ++i) MarkResult(v, i);
    return;
  }
  if (live_[v.index]) return;
  live_[v.index] = true;
  if (v.index >= seen_from_) work_.emplace_back(v, kSingle);
}

void Liveness::MarkResult(ValueId v, uint32_t i) {
  if (first_result_[v.index] == kSingle) return Mark(v);
  live_[v.index] = true;
  if (result_live_[first_result_[v.index] + i]) return;
  result_live_[first_result_[v.index] + i] = true;
  if (v.index >= seen_from_) work_.emplace_back(v, i);
}

void Liveness::Visit(ValueId v) {
  const Inst& inst = function_[v];
  switch (inst.op) {
    case Op::kConst:
      return;
    case Op::kParam:
      if (auto carried = carried_.find(v); carried != carried_.end()) {
        MarkResult(carried->second.first, carried->second.second);
      }
      return;
    case Op::kExtract: {
      ValueId from = function_.Operands(inst)[0];
      if (first_result_[from.index] != kSingle) return MarkResult(from, inst.aux);
      return Mark(from);
    }
    case Op::kIf:
    case Op::kFor:
    case Op::kCall:
      return VisitResult(v, 0);
    default:
      for (ValueId operand : function_.Operands(inst)) Mark(operand);
  }
}

void Liveness::VisitResult(ValueId v, uint32_t i) {
  const Inst& inst = function_[v];
  std::span<const ValueId> operands = function_.Operands(inst);
  if (inst.op == Op::kIf) {
    const Branch& branch = function_.branches[inst.aux];
    Mark(operands[0]);
    Mark(function_.regions[branch.then_region.index].results[i]);
    Mark(function_.regions[branch.else_region.index].results[i]);
  } else if (inst.op == Op::kFor) {
    Mark(operands[i]);
    Mark(function_.regions[function_.loops[inst.aux].body.index].results[i]);
  } else {
    FunctionId callee(inst.aux);
    for (size_t a = 0; a < operands.size(); ++a) {
      if (!use_ || use_->Parameter(callee, a)) Mark(operands[a]);
    }
  }
}

// --- Rebuilder
// ---------------------------------------------------------------------------------------------------

Rebuilder::Rebuilder(Module& module, const Function& from, const Liveness& live, Builder& to)
    : module_(module), from_(from), live_(live), to_(to), map_(from.insts.size()) {}

void Rebuilder::CopyParameters() {
  for (size_t i = 0; i < from_.parameters.size(); ++i) {
    Set(from_.Body().params[i], to_.AddParameter(from_.parameters[i]));
  }
}

void Rebuilder::CopyFunction() {
  CopyParameters();
  CopyRegion(from_.body);
  to_.function().results = from_.results;
  to_.Return(GetAll(from_.Body().results));
}

void Rebuilder::CopyRegion(RegionId region) {
  for (ValueId v : from_.regions[region.index].body) {
    if (live_.Live(v)) CopyOne(v);
  }
}

ValueId Rebuilder::Get(ValueId old) {
  ValueId& now = map_[old.index];
  if (!now && from_[old].op == Op::kConst) now = to_.Const(ConstId(from_[old].aux));
  return now;
}

std::vector<ValueId> Rebuilder::GetAll(std::span<const ValueId> old) {
  std::vector<ValueId> now;
  now.reserve(old.size());
  for (ValueId v : old) now.push_back(Get(v));
  return now;
}

void Rebuilder::SetResults(ValueId old, std::span<const ValueId> results) {
  if (results.size() == 1) return Set(old, results[0]);
  first_result_[old] = static_cast<uint32_t>(results_.size());
  results_.insert(results_.end(), results.begin(), results.end());
}

void Rebuilder::SetOrigin(ValueId old) { to_.SetOrigin(from_.OriginOf(old)); }

void Rebuilder::CopyOne(ValueId old) {
  const Inst& inst = from_[old];
  SetOrigin(old);
  switch (inst.op) {
    case Op::kIf:
      SetResults(old, CopyIf(old));
      break;
    case Op::kFor:
      SetResults(old, CopyFor(old));
      break;
    case Op::kCall:
      CopyCallResults(old);
      break;
    case Op::kExtract: {
      auto many = first_result_.find(from_.Operands(inst)[0]);
      if (many == first_result_.end()) {
        Set(old, Copy(old));
        break;
      }
      Set(old, results_[many->second + inst.aux]);
      TookResult(old);
      break;
    }
    default:
      Set(old, Copy(old));
      break;
  }
  if (Get(old)) to_.Name(Get(old), from_.NameOf(old));
}

ValueId Rebuilder::Copy(ValueId old) {
  const Inst& inst = from_[old];
  std::span<const ValueId> operands = from_.Operands(inst);
  std::array<ValueId, 8> few;
  if (operands.size() > few.size()) return to_.Emit(inst.op, inst.type, GetAll(operands), inst.aux);
  for (size_t i = 0; i < operands.size(); ++i) few[i] = Get(operands[i]);
  return to_.Emit(inst.op, inst.type, std::span<const ValueId>(few.data(), operands.size()),
                  inst.aux);
}

void Rebuilder::CopyCallResults(ValueId old) {
  std::array<ValueId, 8> few;
  const uint32_t count = live_.ResultCount(old);
  std::vector<ValueId> many(count > few.size() ? count : 0);
  const std::span<ValueId> results(many.empty() ? few.data() : many.data(), count);
  CopyCall(old, results);
  SetResults(old, results);
}

void Rebuilder::CopyCall(ValueId old, std::span<ValueId> results) {
  const Inst& inst = from_[old];
  TakeResults(old, to_.Call(FunctionId(inst.aux), GetAll(from_.Operands(inst))), results);
}

void Rebuilder::TakeResults(ValueId old, ValueId call, std::span<ValueId> results) {
  const uint32_t count = static_cast<uint32_t>(results.size());
  for (uint32_t i = 0; i < count; ++i) {
    if (live_.LiveResult(old, i)) results[i] = to_.Result(call, i, count);
  }
}

std::vector<ValueId> Rebuilder::CopyIf(ValueId old) {
  const Inst& inst = from_[old];
  const Branch branch = from_.branches[inst.aux];
  ValueId condition = Get(from_.Operands(inst)[0]);
  std::vector<uint32_t> kept;
  for (uint32_t i = 0; i < live_.ResultCount(old); ++i) {
    if (live_.LiveResult(old, i)) kept.push_back(i);
  }
  auto copy_side = [&](RegionId side) {
    CopyRegion(side);
    std::vector<ValueId> results;
    for (uint32_t i : kept) results.push_back(Get(from_.regions[side.index].results[i]));
    return results;
  };
  std::vector<ValueId> results(live_.ResultCount(old));
  std::vector<ValueId> found;
  if (to_.folds() && to_.IsConst(condition)) {
    found = copy_side(to_.ConstWords(condition)[0] ? branch.then_region : branch.else_region);
  } else {
    auto copy_open = [&](RegionId side, bool taken) {
      RegionId copy = to_.BeginRegion();
      EnterSide(old, taken);
      std::vector<ValueId> yielded = copy_side(side);
      LeaveSide(old, taken);
      to_.EndRegion(yielded);
      return copy;
    };
    RegionId then_region = copy_open(branch.then_region, true);
    RegionId else_region = copy_open(branch.else_region, false);
    SetOrigin(old);
    ValueId merged = to_.If(condition, then_region, else_region);
    for (uint32_t i = 0; i < kept.size(); ++i) {
      found.push_back(to_.Result(merged, i, static_cast<uint32_t>(kept.size())));
    }
  }
  for (size_t i = 0; i < kept.size(); ++i) results[kept[i]] = found[i];
  return results;
}

// Whether `value`, of a loop's body, is `param` or a value from outside whose copy is `first`,
// whichever branches are taken; loops inside that begin with these and go on with them count, too.
bool Rebuilder::StaysAs(ValueId value, ValueId param, ValueId first) {
  constexpr size_t kMostLooked = 32;  // choices of choices may be many
  std::vector<ValueId> same{param}, open{value};
  for (size_t looked = 0; !open.empty(); ++looked) {
    const ValueId v = open.back();
    open.pop_back();
    if (std::ranges::find(same, v) != same.end() || Get(v) == first) continue;
    if (looked == kMostLooked) return false;
    const bool is_part = from_[v].op == Op::kExtract;
    const ValueId whole = is_part ? from_.Operands(from_[v])[0] : v;
    const Inst& inst = from_[whole];
    const bool is_tuple = module_.types.Kind(inst.type) == TypeKind::kTuple;
    const uint32_t i = is_part ? from_[v].aux : 0;
    if (is_part != is_tuple) {
      return false;
    } else if (inst.op == Op::kSelect) {
      open.insert(open.end(), {from_.Operands(inst)[1], from_.Operands(inst)[2]});
    } else if (inst.op == Op::kIf) {
      const Branch& branch = from_.branches[inst.aux];
      open.push_back(from_.regions[branch.then_region.index].results[i]);
      open.push_back(from_.regions[branch.else_region.index].results[i]);
    } else if (inst.op == Op::kFor) {
      const Region& body = from_.regions[from_.loops[inst.aux].body.index];
      same.push_back(body.params[i + 1]);
      open.insert(open.end(), {from_.Operands(inst)[i], body.results[i]});
    } else {
      return false;
    }
  }
  return true;
}

std::vector<ValueId> Rebuilder::CopyFor(ValueId old) {
  const Inst& inst = from_[old];
  ForLoop loop = from_.loops[inst.aux];
  const Region& body = from_.regions[loop.body.index];
  std::vector<ValueId> results(live_.ResultCount(old)), initial;
  std::vector<uint32_t> kept;
  for (uint32_t i = 0; i < results.size(); ++i) {
    if (!live_.LiveResult(old, i)) continue;
    const ValueId param = body.params[i + 1], result = body.results[i];
    ValueId first = Get(from_.Operands(inst)[i]);
    // A value from outside of the loop: nothing inside has a copy yet.
    const ValueId outside = to_.folds() ? Get(result) : ValueId();
    if (to_.folds() && (outside == first || StaysAs(result, param, first))) {
      // Carried unchanged.
      Set(param, first);
      results[i] = first;
      continue;
    }
    if (outside && !live_.Live(param) && loop.Trips() > 0) {
      results[i] = outside;
      continue;
    }
    kept.push_back(i);
    initial.push_back(first);
  }
  if (kept.empty()) return results;
  std::vector<ValueId> found;
  const uint32_t trips = loop.Trips();
  if (to_.folds() && trips <= 1) {
    if (trips == 1) {
      Set(body.params[0], to_.Int(loop.first));
      for (size_t i = 0; i < kept.size(); ++i) Set(body.params[kept[i] + 1], initial[i]);
      CopyRegion(loop.body);
      for (uint32_t i : kept) found.push_back(Get(body.results[i]));
    } else {
      found = initial;
    }
  } else {
    loop.body = to_.BeginRegion();
    Set(body.params[0], to_.AddRegionParameter(kInt));
    to_.Name(Get(body.params[0]), from_.NameOf(body.params[0]));
    for (uint32_t i : kept) {
      ValueId param = body.params[i + 1];
      Set(param, to_.AddRegionParameter(from_[param].type));
      to_.Name(Get(param), from_.NameOf(param));
    }
    CopyRegion(from_.loops[inst.aux].body);
    std::vector<ValueId> next;
    for (uint32_t i : kept) next.push_back(Get(body.results[i]));
    to_.EndRegion(next);
    SetOrigin(old);
    ValueId merged = to_.For(loop, initial);
    for (uint32_t i = 0; i < kept.size(); ++i) {
      found.push_back(to_.Result(merged, i, static_cast<uint32_t>(kept.size())));
    }
  }
  for (size_t i = 0; i < kept.size(); ++i) results[kept[i]] = found[i];
  return results;
}

void CopyInline(const Function& callee, std::span<const ValueId> arguments, Builder& to,
                std::span<ValueId> results) {
  const Region& body = callee.Body();
  // Small functions are what is copied so: their values fit here.
  std::array<ValueId, 64> few;
  std::vector<ValueId> many(callee.insts.size() > few.size() ? callee.insts.size() : 0);
  ValueId* const map = many.empty() ? few.data() : many.data();
  std::array<ValueId, 8> few_operands;
  std::vector<ValueId> many_operands;
  for (size_t i = 0; i < arguments.size(); ++i) map[body.params[i].index] = arguments[i];
  auto get = [&](ValueId old) {
    ValueId& now = map[old.index];
    if (!now) now = to.Const(ConstId(callee[old].aux));
    return now;
  };
  for (ValueId v : body.body) {
    const Inst& inst = callee[v];
    many_operands.resize(inst.operand_count > few_operands.size() ? inst.operand_count : 0);
    const std::span<ValueId> operands(
        many_operands.empty() ? few_operands.data() : many_operands.data(), inst.operand_count);
    for (size_t i = 0; i < operands.size(); ++i) operands[i] = get(callee.Operands(inst)[i]);
    map[v.index] = to.Emit(inst.op, inst.type, operands, inst.aux);
  }
  for (size_t i = 0; i < results.size(); ++i) results[i] = get(body.results[i]);
}

Function TakeFunction(Module& module, FunctionId id) {
  Function old = std::move(module[id]);
  Function fresh;
  fresh.name = old.name;
  fresh.display_name = old.display_name;
  fresh.origin = old.origin;
  module[id] = std::move(fresh);
  return old;
}

}  // namespace texgraph::ir
