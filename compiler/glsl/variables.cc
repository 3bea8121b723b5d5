// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/variables.h"

#include <algorithm>
#include <unordered_map>

namespace texgraph::glsl {

using Kind = Statement::Kind;

Variables::Variables(const ir::Module& module, const ir::Function& function, const Uses& uses,
                     const Forms& forms, const Schedule& schedule, bool reuse)
    : module_(module),
      function_(function),
      uses_(uses),
      forms_(forms),
      schedule_(schedule),
      reuse_(reuse),
      of_value_(function.insts.size()),
      of_slot_(uses.slot_count()) {
  NameResults();
  Create();
  Pairs();
  if (reuse_ || !pairs_.empty()) {
    FindRanges();
    Coalesce();
  }
  PlaceDeclarations();
}

uint32_t Variables::FindRoot(uint32_t v) const {
  while (parents_[v] != v) v = parents_[v] = parents_[parents_[v]];
  return v;
}

VariableId Variables::OfIndex(ValueId loop) const {
  RegionId body = function_.loops[function_[loop].aux].body;
  return Of(function_.regions[body.index].params[0]);
}

// --- Creation ----------------------------------------------------------------------------------

// Results of tuples are named where they are taken out.
void Variables::NameResults() {
  slot_names_.resize(uses_.slot_count());
  for (size_t i = 0; i < function_.insts.size(); ++i) {
    ValueId v(i);
    if (forms_.Of(v) != Form::kResult || !function_.NameOf(v)) continue;
    const Inst& inst = function_[v];
    slot_names_[uses_.FirstSlot(function_.Operands(inst)[0]) + inst.aux] = function_.NameOf(v);
  }
}

NameId Variables::NameOfResult(ValueId v, uint32_t result) const {
  if (NameId name = slot_names_[uses_.FirstSlot(v) + result]) return name;
  const Inst& inst = function_[v];
  if (inst.op == Op::kCall) {
    bool returned = result == 0 && module_[FunctionId(inst.aux)].results[0].name.empty();
    return returned ? function_.NameOf(v) : NameId();
  }
  if (!uses_.IsTuple(v) && function_.NameOf(v)) return function_.NameOf(v);
  if (inst.op == Op::kFor) {
    const ir::Region& body = function_.regions[function_.loops[inst.aux].body.index];
    if (NameId name = function_.NameOf(body.params[result + 1])) return name;
    return function_.NameOf(body.results[result]);
  }
  const ir::Branch& branch = function_.branches[inst.aux];
  NameId name = function_.NameOf(function_.regions[branch.then_region.index].results[result]);
  if (name) return name;
  return function_.NameOf(function_.regions[branch.else_region.index].results[result]);
}

VariableId Variables::Add(TypeId type, NameId name, ValueId example, uint32_t result, RegionId home,
                          size_t position) {
  Variable variable{type, name, example, result, home, static_cast<uint32_t>(position)};
  list_.push_back(variable);
  parents_.push_back(static_cast<uint32_t>(list_.size() - 1));
  return VariableId(list_.size() - 1);
}

void Variables::Create() {
  for (size_t position = 0; position < schedule_.size(); ++position) {
    const Statement& statement = schedule_[position];
    ValueId v = statement.value;
    switch (statement.kind) {
      case Kind::kDefine:
        of_value_[v.index] =
            Add(function_[v].type, function_.NameOf(v), v, 0, statement.region, position);
        break;
      case Kind::kCall:
      case Kind::kIfInit:
      case Kind::kLoopInit:
        CreateResults(v, statement, position);
        break;
      case Kind::kIf:
        if (!schedule_.StartsIdle(v)) CreateResults(v, statement, position);
        break;
      default:
        break;
    }
  }
  for (size_t i = 0; i < function_.insts.size(); ++i) {
    ValueId v(i);
    if (forms_.Of(v) != Form::kResult) continue;
    const Inst& inst = function_[v];
    of_value_[i] = of_slot_[uses_.FirstSlot(function_.Operands(inst)[0]) + inst.aux];
  }
}

void Variables::CreateResults(ValueId v, const Statement& statement, size_t position) {
  const Inst& inst = function_[v];
  const ir::Region* body = nullptr;
  if (inst.op == Op::kFor) {
    RegionId id = function_.loops[inst.aux].body;
    body = &function_.regions[id.index];
    ValueId index = body->params[0];
    of_value_[index.index] = Add(ir::kInt, function_.NameOf(index), index, 0, id, position + 1);
    list_.back().is_index = true;
  }
  for (uint32_t r = 0; r < uses_.ResultCount(v); ++r) {
    uint32_t slot = uses_.FirstSlot(v) + r;
    // An out parameter needs a variable even if nothing reads it. Only the first result is
    // returned.
    bool is_out =
        inst.op == Op::kCall && (r > 0 || !module_[FunctionId(inst.aux)].results[0].name.empty());
    if (!uses_.SlotLive(slot) && !is_out) continue;
    TypeId type = uses_.IsTuple(v) ? module_.types.ElementType(inst.type, r) : inst.type;
    of_slot_[slot] = Add(type, NameOfResult(v, r), v, r, statement.region, position);
    if (body) of_value_[body->params[r + 1].index] = of_slot_[slot];
  }
  if (!uses_.IsTuple(v)) of_value_[v.index] = of_slot_[uses_.FirstSlot(v)];
}

// --- Pairs that would like to be one
// ---------------------------------------------------------------

void Variables::AddPair(VariableId a, ValueId b) {
  VariableId other = of_value_[b.index];
  if (a && other && a != other && !list_[other.index].is_index) {
    pairs_.push_back({a.index, other.index, false});
  }
}

void Variables::PairResults(ValueId v) {
  const Inst& inst = function_[v];
  for (uint32_t r = 0; r < uses_.ResultCount(v); ++r) {
    VariableId variable = of_slot_[uses_.FirstSlot(v) + r];
    if (inst.op == Op::kFor) {
      RegionId body = function_.loops[inst.aux].body;
      AddPair(variable, function_.regions[body.index].results[r]);
      AddPair(variable, function_.Operands(inst)[r]);
    } else {
      const ir::Branch& branch = function_.branches[inst.aux];
      AddPair(variable, function_.regions[branch.then_region.index].results[r]);
      AddPair(variable, function_.regions[branch.else_region.index].results[r]);
    }
  }
}

// Values with one name and one type, each with the one before: an author's assignments to a
// variable.
void Variables::PairNames() {
  std::unordered_map<NameId, uint32_t> latest;
  for (uint32_t i = 0; i < list_.size(); ++i) {
    if (!list_[i].name || list_[i].is_index) continue;
    auto [known, added] = latest.try_emplace(list_[i].name, i);
    if (added) continue;
    const Variable& before = list_[known->second];
    if (before.type == list_[i].type && uses_.IsInside(list_[i].home, before.home)) {
      pairs_.push_back({known->second, i, true});
    }
    // An inner scope's variable is gone where the scope ends.
    if (!(uses_.IsInside(list_[i].home, before.home) && list_[i].home != before.home)) {
      known->second = i;
    }
  }
}

void Variables::Pairs() {
  if (schedule_.has_control()) {
    for (const Statement& statement : schedule_.statements()) {
      if (statement.kind == Kind::kIfEnd || statement.kind == Kind::kLoopEnd) {
        PairResults(statement.value);
      }
    }
  }
  if (!reuse_) PairNames();
}

bool Variables::Interfere(uint32_t a, uint32_t b) const {
  const LiveRange& range_a = ranges_[range_of_[a]];
  const LiveRange& range_b = ranges_[range_of_[b]];
  return WritesInto(range_a, range_b, [&](uint32_t source) { return FindRoot(source) == b; }) ||
         WritesInto(range_b, range_a, [&](uint32_t source) { return FindRoot(source) == a; });
}

RegionId Variables::CommonRegion(RegionId a, RegionId b) const {
  while (!uses_.IsInside(b, a)) a = uses_.Info(a).parent;
  return a;
}

void Variables::Join(uint32_t a, uint32_t b) {
  uint32_t first = std::min(a, b), second = std::max(a, b);
  // The one that is written first gives the name, so that it reads as the author's.
  if (list_[second].declared_at < list_[first].declared_at) std::swap(first, second);
  Variable& kept = list_[first];
  if (!kept.name) {
    kept.name = list_[second].name;
    if (kept.name) kept.example = list_[second].example;
  }
  kept.home = CommonRegion(kept.home, list_[second].home);
  Merge(ranges_[range_of_[first]], ranges_[range_of_[second]]);
  parents_[second] = first;
}

void Variables::Coalesce() {
  for (const Pair& pair : pairs_) {
    uint32_t a = FindRoot(pair.a), b = FindRoot(pair.b);
    if (a == b || list_[a].type != list_[b].type) continue;
    if (pair.by_name && list_[a].home != CommonRegion(list_[a].home, list_[b].home)) continue;
    if (!Interfere(a, b)) Join(a, b);
  }
  if (reuse_) Reuse();
}

void Variables::PlaceDeclarations() {
  for (uint32_t i = 0; i < list_.size(); ++i) {
    if (parents_[i] != i) continue;
    Variable& variable = list_[i];
    if (variable.is_index) continue;
    const Statement& first = schedule_[variable.declared_at];
    if (!reuse_ && first.region == variable.home && first.kind != Kind::kIf) continue;
    variable.declared_before = true;
    if (reuse_) {
      variable.declared_at = 0;
      variable.home = function_.body;
    } else if (first.region != variable.home) {
      RegionId r = first.region;
      while (uses_.Info(r).parent != variable.home) r = uses_.Info(r).parent;
      variable.declared_at = schedule_.StartOf(r);
    }
    declared_before_.push_back(VariableId(i));
  }
  std::ranges::stable_sort(declared_before_, {},
                           [&](VariableId v) { return list_[v.index].declared_at; });
}

}  // namespace texgraph::glsl
