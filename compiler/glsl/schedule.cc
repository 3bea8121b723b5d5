// SPDX-License-Identifier: Apache-2.0
#include "compiler/glsl/schedule.h"

#include "compiler/ir/loop_end.h"

namespace texgraph::glsl {

using Kind = Statement::Kind;

Schedule::Schedule(const ir::Function& function, const Uses& uses, const Forms& forms)
    : function_(function),
      uses_(uses),
      forms_(forms),
      styles_(function.branches.size(), IfStyle::kBoth),
      conditions_(function.regions.size()),
      if_ends_(function.branches.size()),
      loop_ends_(function.regions.size()),
      starts_(function.regions.size()) {
  frames_.push_back({function.body, 0, {}});
  while (!frames_.empty()) {
    Frame& frame = frames_.back();
    const ir::Region& region = function.regions[frame.region.index];
    if (frame.next == region.body.size()) {
      Frame done = frame;
      frames_.pop_back();
      if (done.owner) LeaveSide(done.owner, done.region);
      continue;
    }
    ValueId v = region.body[frame.next++];
    if (forms.Of(v) == Form::kVariable) {
      Add(Kind::kDefine, v, frame.region);
    } else if (forms.Of(v) == Form::kStatement) {
      Enter(v, frame.region);
    }
  }
  Add(Kind::kReturn, ValueId(), function.body);
}

// Whether a side of an if only passes on what is there anyway.
bool Schedule::IsIdle(ValueId branch, RegionId side) const {
  if (forms_.HasStatements(side)) return false;
  for (uint32_t r = 0; r < uses_.ResultCount(branch); ++r) {
    if (!uses_.SlotLive(uses_.FirstSlot(branch) + r)) continue;
    if (!forms_.IsFree(function_.regions[side.index].results[r])) return false;
  }
  return true;
}

// Whether an if is all that the second side of another does, and ends with constants: then it reads
// best as "else if ... else".
bool Schedule::ContinuesElse(ValueId v, RegionId region) const {
  ValueId owner = frames_.back().owner;
  if (!owner || function_[owner].op != Op::kIf || !forms_.HasOneStatement(region)) return false;
  if (function_.branches[function_[owner].aux].else_region != region) return false;
  RegionId last = function_.branches[function_[v].aux].else_region;
  for (ValueId result : function_.regions[last.index].results) {
    if (function_[result].op != Op::kConst) return false;
  }
  return true;
}

// Whether an if is the condition of its loop, and can be written as such.
bool Schedule::EndsLoop(ValueId v, RegionId region) const {
  ValueId loop = frames_.back().owner;
  if (!loop || function_[loop].op != Op::kFor || !forms_.HasOneStatement(region)) return false;
  return ir::EndingIf(function_, function_.loops[function_[loop].aux]) == v;
}

void Schedule::Enter(ValueId v, RegionId region) {
  const Inst& inst = function_[v];
  if (inst.op == Op::kCall) return Add(Kind::kCall, v, region);
  has_control_ = true;
  uint32_t start = static_cast<uint32_t>(statements_.size());
  if (inst.op == Op::kFor) {
    starts_[function_.loops[inst.aux].body.index] = start;
    Add(Kind::kLoopInit, v, region);
    Add(Kind::kLoop, v, region);
    frames_.push_back({function_.loops[inst.aux].body, 0, v});
    return;
  }
  const ir::Branch& branch = function_.branches[inst.aux];
  starts_[branch.then_region.index] = starts_[branch.else_region.index] = start;
  IfStyle& style = styles_[inst.aux];
  if (ContinuesElse(v, region)) {
    style = IfStyle::kBoth;
  } else if (IsIdle(v, branch.else_region)) {
    const bool ends_loop = EndsLoop(v, region);
    style = ends_loop ? IfStyle::kLoopCondition : IfStyle::kThenOnly;
    if (ends_loop) conditions_[region.index] = v;
  } else if (IsIdle(v, branch.then_region)) {
    style = IfStyle::kElseOnly;
  }
  if (StartsIdle(v)) Add(Kind::kIfInit, v, region);
  Add(Kind::kIf, v, region);
  bool starts_with_else = style == IfStyle::kElseOnly;
  frames_.push_back({starts_with_else ? branch.else_region : branch.then_region, 0, v});
}

void Schedule::LeaveSide(ValueId v, RegionId side) {
  const Inst& inst = function_[v];
  RegionId outer = uses_.RegionOf(v);
  if (inst.op == Op::kFor) {
    Add(Kind::kLoopNext, v, side);
    loop_ends_[side.index] = static_cast<uint32_t>(statements_.size());
    return Add(Kind::kLoopEnd, v, outer);
  }
  const ir::Branch& branch = function_.branches[inst.aux];
  bool is_then = side == branch.then_region;
  Add(is_then ? Kind::kThenEnd : Kind::kElseEnd, v, side);
  if (is_then && StyleOf(v) == IfStyle::kBoth) {
    Add(Kind::kElse, v, outer);
    frames_.push_back({branch.else_region, 0, v});
  } else {
    if_ends_[inst.aux] = static_cast<uint32_t>(statements_.size());
    Add(Kind::kIfEnd, v, outer);
  }
}

}  // namespace texgraph::glsl
