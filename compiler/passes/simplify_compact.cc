// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/simplify_compact.h"

#include <utility>
#include <vector>

#include "compiler/ir/rebuild.h"

namespace texgraph::passes {
namespace {

using ir::Op;
using ir::RegionId;
using ir::ValueId;

class Compactor {
 public:
  // `live` is the function's.
  Compactor(const ir::Liveness& live, ir::Function& function)
      : live_(live), old_(std::move(function)), new_(function) {
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
    region_of_.assign(old_.regions.size(), RegionId());
    AddRegion(old_.body);
    for (size_t i = 0; i < regions_.size(); ++i) {
      ir::Region& region = old_.regions[regions_[i].index];
      for (ValueId param : region.params) stays_[param.index] = true;
      std::erase_if(region.body, [&](ValueId v) { return !live_.Live(v); });
      for (ValueId v : region.body) {
        stays_[v.index] = true;
        Visit(v);
      }
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
        if (CarriesUnchanged(old_.regions[loop.body.index])) improvable_ = true;
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

  static bool CarriesUnchanged(const ir::Region& body) {
    for (size_t i = 0; i < body.results.size(); ++i) {
      if (body.results[i] == body.params[i + 1]) return true;
    }
    return false;
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

  const ir::Liveness& live_;
  ir::Function old_;
  ir::Function& new_;
  std::vector<bool> stays_;
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

}  // namespace

bool Compact(const ir::Module& module, ir::Function& function) {
  ir::Liveness live(module, function);
  // The next copy leaves these out; until then, everything that they name must stay.
  if (CarriesDead(function, live)) return true;
  return Compactor(live, function).Run();
}

}  // namespace texgraph::passes
