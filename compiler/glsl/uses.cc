// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/uses.h"

#include "compiler/ir/builder.h"

namespace texgraph::glsl {

Parts ConstructParts(const ir::Function& function, const Inst& construct) {
  Parts parts;
  std::span<const ValueId> operands = function.Operands(construct);
  auto vector_of = [&](ValueId v) {
    const Inst& inst = function[v];
    if (inst.op != Op::kExtract) return ValueId();
    ValueId from = function.Operands(inst)[0];
    return ir::IsVector(function[from].type) ? from : ValueId();
  };
  for (size_t i = 0; i < operands.size();) {
    ValueId from = vector_of(operands[i]);
    Part part{from};
    bool whole = true;
    while (from && i + part.width < operands.size() &&
           vector_of(operands[i + part.width]) == from) {
      uint32_t component = function[operands[i + part.width]].aux;
      whole = whole && component == part.width;
      part.mask |= component << (2 * part.width++);
    }
    if (part.width < 2) {
      part = {operands[i]};
    } else if (whole && part.width == ir::Width(function[from].type)) {
      i += part.width;
      parts.list[parts.count++] = {from};
      continue;
    }
    i += part.width < 2 ? 1 : part.width;
    parts.list[parts.count++] = part;
  }
  return parts;
}

Uses::Uses(const ir::Module& module, const ir::Function& function)
    : module_(module), function_(function), live_(module, function) {
  FindRegions();
  FindSlots();
  CountUses();
}

bool Uses::IsTuple(ValueId v) const {
  return module_.types.Kind(function_[v].type) == ir::TypeKind::kTuple;
}

bool Uses::IsInside(RegionId inner, RegionId outer) const {
  while (inner.valid() && inner != outer) inner = regions_[inner.index].parent;
  return inner.valid();
}

void Uses::FindRegions() {
  regions_.resize(function_.regions.size());
  region_of_.resize(function_.insts.size());
  std::vector<RegionId> open{function_.body};
  auto enter = [&](RegionId region, RegionId parent, bool is_loop) {
    regions_[region.index] = {parent, is_loop};
    open.push_back(region);
  };
  while (!open.empty()) {
    RegionId id = open.back();
    open.pop_back();
    const ir::Region& region = function_.regions[id.index];
    for (ValueId v : region.params) region_of_[v.index] = id;
    for (ValueId v : region.body) {
      region_of_[v.index] = id;
      const Inst& inst = function_[v];
      if (inst.op == Op::kIf) {
        enter(function_.branches[inst.aux].then_region, id, false);
        enter(function_.branches[inst.aux].else_region, id, false);
      } else if (inst.op == Op::kFor) {
        enter(function_.loops[inst.aux].body, id, true);
      }
    }
  }
}

void Uses::FindSlots() {
  first_slot_.assign(function_.insts.size(), kNoSlot);
  for (size_t i = 0; i < function_.insts.size(); ++i) {
    ValueId v(i);
    Op op = function_[v].op;
    bool has_slots = op == Op::kIf || op == Op::kFor || (op == Op::kCall && IsTuple(v));
    if (!has_slots || !IsLive(v)) continue;
    first_slot_[i] = static_cast<uint32_t>(slot_live_.size());
    for (uint32_t r = 0; r < ResultCount(v); ++r) slot_live_.push_back(live_.LiveResult(v, r));
  }
}

void Uses::Use(ValueId v, RegionId place, uint8_t flags) {
  ++counts_[v.index];
  places_[v.index] = place;
  flags_[v.index] |= flags;
}

// Users come after what they use, so going backwards every count is complete when it is asked for.
void Uses::CountUses() {
  counts_.assign(function_.insts.size(), 0);
  places_.resize(function_.insts.size());
  flags_.assign(function_.insts.size(), 0);
  const std::vector<ValueId>& results = function_.Body().results;
  bool is_main = &function_ == &module_[module_.main];
  for (size_t i = 0; i < results.size(); ++i) {
    bool returned = results.size() == 1 || (i == 0 && function_.results[0].name.empty());
    Use(results[i], function_.body, is_main || returned ? kResultUse : kResultUse | kOutUse);
  }
  for (size_t i = function_.insts.size(); i-- > 0;) {
    ValueId v(i);
    bool written = first_slot_[i] != kNoSlot || counts_[i] > 0;
    if (written) CountOperands(v);
  }
}

void Uses::CountOperands(ValueId v) {
  const Inst& inst = function_[v];
  std::span<const ValueId> operands = function_.Operands(inst);
  RegionId here = region_of_[v.index];
  switch (inst.op) {
    case Op::kIf: {
      const ir::Branch& branch = function_.branches[inst.aux];
      Use(operands[0], here);
      for (uint32_t r = 0; r < ResultCount(v); ++r) {
        if (!SlotLive(first_slot_[v.index] + r)) continue;
        for (RegionId side : {branch.then_region, branch.else_region}) {
          Use(function_.regions[side.index].results[r], side, kResultUse);
        }
      }
      return;
    }
    case Op::kFor: {
      RegionId body = function_.loops[inst.aux].body;
      for (uint32_t r = 0; r < ResultCount(v); ++r) {
        if (!SlotLive(first_slot_[v.index] + r)) continue;
        Use(operands[r], here);
        Use(function_.regions[body.index].results[r], body, kResultUse);
      }
      return;
    }
    case Op::kConstruct:
      if (ir::IsVector(inst.type)) {
        Parts parts = ConstructParts(function_, inst);
        for (uint32_t i = 0; i < parts.count; ++i) Use(parts.list[i].value, here);
        return;
      }
      break;
    case Op::kSelect:
      Use(operands[0], here);
      for (int side : {1, 2})
        Use(operands[side], here,
            inst.type == ir::kBool || ir::IsScalar(function_[operands[0]].type) ? kLazyUse : 0);
      return;
    case Op::kLogicalAnd:
    case Op::kLogicalOr:
      Use(operands[0], here);
      Use(operands[1], here, kLazyUse);
      return;
    case Op::kIndex:
      Use(operands[0], here, kIndexedUse);
      Use(operands[1], here);
      return;
    default:
      break;
  }
  for (ValueId operand : operands) Use(operand, here);
}

}  // namespace texgraph::glsl
