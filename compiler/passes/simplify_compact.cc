// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/simplify_compact.h"

#include <algorithm>
#include <span>

#include "compiler/ir/rebuild.h"

namespace texgraph::passes {
namespace {

using ir::Op;
using ir::RegionId;
using ir::ValueId;

// Of one condition: enough for what people write, and bounded for what nobody does.
constexpr size_t kMaxFacts = 16;

class Compactor {
 public:
  // `live` is the function's; it may be asked for single values alone once the function has moved.
  Compactor(const ir::Module& module, const ir::Liveness& live, ir::Function& function)
      : types_(module.types), live_(live), old_(std::move(function)), new_(function) {
    new_ = {};
    new_.name = old_.name;
    new_.display_name = old_.display_name;
    new_.origin = old_.origin;
    new_.parameters = std::move(old_.parameters);
    new_.results = std::move(old_.results);
  }

  bool Run() {
    FindRegions();
    Number();
    MoveRegions();
    return improvable_;
  }

 private:
  // The regions that live code has, outer before inner, and which values stay.
  void FindRegions() {
    stays_.assign(old_.insts.size(), false);
    home_.assign(old_.insts.size(), RegionId());
    region_of_.assign(old_.regions.size(), RegionId());
    AddRegion(old_.body);
    for (size_t i = 0; i < regions_.size(); ++i) {
      ir::Region& region = old_.regions[regions_[i].index];
      for (ValueId param : region.params) {
        stays_[param.index] = true;
        home_[param.index] = regions_[i];
      }
      std::erase_if(region.body, [&](ValueId v) { return !live_.Live(v); });
      for (ValueId v : region.body) {
        stays_[v.index] = true;
        home_[v.index] = regions_[i];
        Visit(v);
      }
      if (!TakesResultsInOrder(region)) improvable_ = true;
    }
    for (size_t i = 0; i < old_.insts.size(); ++i) {
      if (old_.insts[i].op == Op::kConst && live_.Live(ValueId(i))) stays_[i] = true;
    }
  }

  void AddRegion(RegionId old) {
    region_of_[old.index] = RegionId(regions_.size());
    regions_.push_back(old);
  }

  void Visit(ValueId v) {
    const ir::Inst& inst = old_[v];
    if (inst.op == Op::kIf) {
      const ir::Branch& branch = old_.branches[inst.aux];
      AddRegion(branch.then_region);
      AddRegion(branch.else_region);
    } else if (inst.op == Op::kFor) {
      AddRegion(old_.loops[inst.aux].body);
    }
  }

  // Copies the values that stay, in their old order: operands stay before their users.
  void Number() {
    value_of_.assign(old_.insts.size(), ValueId());
    for (size_t i = 0; i < old_.insts.size(); ++i) {
      if (!stays_[i]) continue;
      const ValueId v(i);
      ir::Inst inst = old_.insts[i];
      std::span<const ValueId> operands = old_.Operands(inst);
      inst.first_operand = static_cast<uint32_t>(new_.operands.size());
      for (ValueId operand : operands) new_.operands.push_back(value_of_[operand.index]);
      if (inst.op == Op::kIf) {
        const ir::Branch& branch = old_.branches[inst.aux];
        inst.aux = static_cast<uint32_t>(new_.branches.size());
        new_.branches.push_back(
            {region_of_[branch.then_region.index], region_of_[branch.else_region.index]});
        if (IsChoice(branch)) improvable_ = true;
      } else if (inst.op == Op::kFor) {
        ir::ForLoop loop = old_.loops[inst.aux];
        if (CarriesKnown(loop.body, operands)) improvable_ = true;
        loop.body = region_of_[loop.body.index];
        inst.aux = static_cast<uint32_t>(new_.loops.size());
        new_.loops.push_back(loop);
      }
      value_of_[i] = ValueId(new_.insts.size());
      new_.insts.push_back(inst);
      new_.origins.push_back(old_.OriginOf(v));
      if (ir::NameId name = old_.NameOf(v)) {
        new_.names.resize(new_.insts.size());
        new_.names.back() = name;
      }
    }
  }

  bool IsChoice(const ir::Branch& branch) const {
    return old_.regions[branch.then_region.index].body.empty() &&
           old_.regions[branch.else_region.index].body.empty();
  }

  // Whether a loop carries what does not change, or what is known before it and asked for after it.
  bool CarriesKnown(RegionId id, std::span<const ValueId> initial) const {
    const ir::Region& body = old_.regions[id.index];
    for (size_t i = 0; i < body.results.size(); ++i) {
      const ValueId result = body.results[i], param = body.params[i + 1];
      if (result == param || result == initial[i]) return true;
      if (home_[result.index] != id && !live_.Live(param)) return true;
    }
    return false;
  }

  // The results of a call, an if or a loop are taken at once, in order. Where equal calls were
  // merged they are not yet.
  bool TakesResultsInOrder(const ir::Region& region) const {
    ValueId from;
    uint32_t next = 0;
    for (ValueId v : region.body) {
      const ir::Inst& inst = old_[v];
      if (HasSeveralResults(v)) {
        from = v;
        next = 0;
        continue;
      }
      const bool takes = inst.op == Op::kExtract && HasSeveralResults(old_.Operands(inst)[0]);
      if (takes && (old_.Operands(inst)[0] != from || inst.aux < next)) return false;
      if (takes) {
        next = inst.aux;
      } else {
        from = ValueId();
      }
    }
    return true;
  }

  void MoveRegions() {
    new_.body = region_of_[old_.body.index];
    for (RegionId id : regions_) {
      ir::Region region = std::move(old_.regions[id.index]);
      for (std::vector<ValueId>* values : {&region.params, &region.body, &region.results}) {
        for (ValueId& v : *values) v = value_of_[v.index];
      }
      new_.regions.push_back(std::move(region));
    }
  }

  bool HasSeveralResults(ValueId v) const {
    const ir::Inst& inst = old_[v];
    return (inst.op == Op::kCall || inst.op == Op::kIf || inst.op == Op::kFor) &&
           types_.Kind(inst.type) == ir::TypeKind::kTuple;
  }

  const ir::Types& types_;
  const ir::Liveness& live_;
  ir::Function old_;
  ir::Function& new_;
  std::vector<bool> stays_;
  std::vector<RegionId> home_;       // of values in bodies and parameters; invalid for constants
  std::vector<RegionId> regions_;    // old ones, by new id
  std::vector<RegionId> region_of_;  // new ones, by old id
  std::vector<ValueId> value_of_;
  bool improvable_ = false;
};

// Whether an if or a loop carries values that nothing uses.
bool CarriesDead(const ir::Function& function, const ir::Liveness& live) {
  for (size_t i = 0; i < function.insts.size(); ++i) {
    const ValueId v(i);
    const Op op = function[v].op;
    if ((op != Op::kIf && op != Op::kFor) || !live.Live(v)) continue;
    for (uint32_t r = 0; r < live.ResultCount(v); ++r) {
      if (!live.LiveResult(v, r)) return true;
    }
  }
  return false;
}

// Looks for uses of conditions where they are known. Regions nest at most kMaxRegionDepth deep.
class KnownUses {
 public:
  explicit KnownUses(const ir::Function& function)
      : function_(function), known_(function.insts.size(), 0) {}

  bool In(RegionId id) {
    const ir::Region& region = function_.regions[id.index];
    for (ValueId v : region.body) {
      const ir::Inst& inst = function_[v];
      if (AnyKnown(function_.Operands(inst))) return true;
      if (inst.op == Op::kFor && In(function_.loops[inst.aux].body)) return true;
      if (inst.op != Op::kIf) continue;
      const ir::Branch& branch = function_.branches[inst.aux];
      const ValueId condition = function_.Operands(inst)[0];
      if (OnSide(branch.then_region, condition, true)) return true;
      if (OnSide(branch.else_region, condition, false)) return true;
    }
    return AnyKnown(region.results);
  }

 private:
  bool OnSide(RegionId side, ValueId condition, bool taken) {
    const auto facts = KnownOnSide(function_, condition, taken);
    for (const auto& [v, is] : facts) ++known_[v.index];
    const bool found = In(side);
    for (const auto& [v, is] : facts) --known_[v.index];
    return found;
  }

  bool AnyKnown(std::span<const ValueId> values) const {
    return std::ranges::any_of(values, [&](ValueId v) { return known_[v.index] > 0; });
  }

  const ir::Function& function_;
  std::vector<uint32_t> known_;  // in how many enclosing sides
};

}  // namespace

std::vector<std::pair<ValueId, bool>> KnownOnSide(const ir::Function& function, ValueId condition,
                                                  bool taken) {
  std::vector<std::pair<ValueId, bool>> facts;
  std::vector<std::pair<ValueId, bool>> work{{condition, taken}};
  while (!work.empty()) {
    auto [v, is] = work.back();
    work.pop_back();
    const ir::Inst& inst = function[v];
    if (inst.op == Op::kConst || inst.type != ir::kBool || facts.size() >= kMaxFacts) continue;
    if (std::ranges::find(facts, std::pair(v, is)) != facts.end()) continue;
    facts.emplace_back(v, is);
    if (inst.op == Op::kLogicalNot) {
      work.emplace_back(function.Operands(inst)[0], !is);
    } else if (inst.op == (is ? Op::kLogicalAnd : Op::kLogicalOr)) {
      for (ValueId operand : function.Operands(inst)) work.emplace_back(operand, is);
    }
  }
  return facts;
}

bool Compact(const ir::Module& module, ir::Function& function) {
  ir::Liveness live(module, function);
  // The next copy leaves these out; until then, everything that they name must stay.
  if (CarriesDead(function, live)) return true;
  const bool improvable = Compactor(module, live, function).Run();
  return improvable || (!function.branches.empty() && KnownUses(function).In(function.body));
}

}  // namespace texgraph::passes
