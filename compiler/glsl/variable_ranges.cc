// SPDX-License-Identifier: Apache-2.0
// The live ranges behind Variables: reads are where the expression stands that contains them, not
// where the value was computed.
#include <algorithm>
#include <map>
#include <queue>

#include "compiler/glsl/variables.h"

namespace texgraph::glsl {
namespace {

using Kind = Statement::Kind;
constexpr uint32_t kNoRange = 0xffffffffu;

}  // namespace

void Variables::FindRanges() {
  range_of_.assign(list_.size(), kNoRange);
  uint32_t count = 0;
  auto want = [&](uint32_t v) {
    if (range_of_[v] == kNoRange) range_of_[v] = count++;
  };
  for (const Pair& pair : pairs_) {
    want(pair.a);
    want(pair.b);
  }
  for (uint32_t v = 0; reuse_ && v < list_.size(); ++v) {
    if (!list_[v].is_index) want(v);
  }
  ranges_.resize(count);
  last_read_.assign(count, 0);
  last_param_read_.assign(count, 0);
  for (size_t position = 0; position < schedule_.size(); ++position) ReadAt(position);
  for (size_t position = 0; position < schedule_.size(); ++position) RangeOf(position);
  for (LiveRange& range : ranges_) {
    std::ranges::sort(range.writes, {}, &LiveRange::Write::position);
  }
}

// Notes every variable that the expression of `v`, written at `position` in the region `place`,
// reads.
void Variables::Read(ValueId v, uint32_t position, RegionId place) {
  if (VariableId variable = of_value_[v.index]) {
    uint32_t range = range_of_[variable.index];
    if (range == kNoRange) return;
    bool is_param = function_[v].op == Op::kParam;
    RegionId defined = is_param ? uses_.RegionOf(v) : list_[variable.index].home;
    // What a loop reads but does not write is needed until its last round is over.
    for (RegionId r = place; r != defined; r = uses_.Info(r).parent) {
      if (uses_.Info(r).is_loop) position = schedule_.LoopEnd(r);
    }
    uint32_t& last = (is_param ? last_param_read_ : last_read_)[range];
    last = std::max(last, position);
    return;
  }
  if (forms_.Of(v) != Form::kInline) return;
  ForEachOperand(function_, v, [&](ValueId operand) { Read(operand, position, place); });
}

void Variables::ReadAt(size_t position) {
  const Statement& statement = schedule_[position];
  uint32_t at = static_cast<uint32_t>(position);
  ValueId v = statement.value;
  auto read_all = [&](std::span<const ValueId> values) {
    for (size_t r = 0; r < values.size(); ++r) {
      if (uses_.SlotLive(uses_.FirstSlot(v) + static_cast<uint32_t>(r)))
        Read(values[r], at, statement.region);
    }
  };
  switch (statement.kind) {
    case Kind::kDefine:
      ForEachOperand(function_, v, [&](ValueId o) { Read(o, at, statement.region); });
      return;
    case Kind::kCall:
      // One later, so that no argument shares the variable of an out parameter.
      for (ValueId o : function_.Operands(v)) Read(o, at + 1, statement.region);
      return;
    case Kind::kIf:
      Read(function_.Operands(v)[0], at, statement.region);
      return;
    case Kind::kIfInit: {
      const ir::Branch& branch = function_.branches[function_[v].aux];
      bool then_only = schedule_.StyleOf(v) == IfStyle::kThenOnly;
      RegionId idle = then_only ? branch.else_region : branch.then_region;
      return read_all(function_.regions[idle.index].results);
    }
    case Kind::kThenEnd:
    case Kind::kElseEnd:
      return read_all(function_.regions[statement.region.index].results);
    case Kind::kLoopInit:
      return read_all(function_.Operands(v));
    case Kind::kLoopNext:
      return read_all(function_.regions[statement.region.index].results);
    case Kind::kReturn:
      for (ValueId o : function_.Body().results) Read(o, at, statement.region);
      return;
    default:
      return;
  }
}

void Variables::AddWrite(VariableId v, size_t position, ValueId source) {
  VariableId from = source ? of_value_[source.index] : VariableId();
  ranges_[range_of_[v.index]].writes.push_back(
      {static_cast<uint32_t>(position), from ? from.index : LiveRange::kNoSource});
}

// Adds the writes of a statement, and the lives that begin with them.
void Variables::RangeOf(size_t position) {
  const Statement& statement = schedule_[position];
  ValueId v = statement.value;
  uint32_t at = static_cast<uint32_t>(position);
  if (statement.kind == Kind::kDefine) {
    VariableId variable = of_value_[v.index];
    uint32_t range = range_of_[variable.index];
    if (range == kNoRange) return;
    AddWrite(variable, position);
    ranges_[range].AddInterval(at + 1, last_read_[range]);
    return;
  }
  bool writes = statement.kind == Kind::kCall || statement.kind == Kind::kIfInit ||
                statement.kind == Kind::kThenEnd || statement.kind == Kind::kElseEnd ||
                statement.kind == Kind::kLoopInit || statement.kind == Kind::kLoopNext;
  if (!writes) return;
  for (uint32_t r = 0; r < uses_.ResultCount(v); ++r) {
    VariableId variable = of_slot_[uses_.FirstSlot(v) + r];
    if (!variable || range_of_[variable.index] == kNoRange) continue;
    uint32_t range = range_of_[variable.index];
    LiveRange& live = ranges_[range];
    switch (statement.kind) {
      case Kind::kCall:
        AddWrite(variable, position);
        live.AddInterval(at + 1, std::max(at + 1, last_read_[range]));
        break;
      case Kind::kIfInit: {
        const ir::Branch& branch = function_.branches[function_[v].aux];
        bool then_only = schedule_.StyleOf(v) == IfStyle::kThenOnly;
        RegionId idle = then_only ? branch.else_region : branch.then_region;
        AddWrite(variable, position, function_.regions[idle.index].results[r]);
        live.AddInterval(at + 1, at + 1);  // the kIf, where the other way is taken
        break;
      }
      case Kind::kThenEnd:
      case Kind::kElseEnd:
        AddWrite(variable, position, function_.regions[statement.region.index].results[r]);
        if (schedule_[position + 1].kind == Kind::kElse) {
          live.AddInterval(at + 1, at + 1);
        } else {
          live.AddInterval(at + 1, std::max(at + 1, last_read_[range]));
        }
        break;
      case Kind::kLoopInit:
        AddWrite(variable, position, function_.Operands(v)[r]);
        live.AddInterval(at + 1, std::max(at + 1, last_param_read_[range]));
        break;
      default:
        AddWrite(variable, position, function_.regions[statement.region.index].results[r]);
        live.AddInterval(at + 1, std::max(at + 1, last_read_[range]));
        break;
    }
  }
}

// A linear scan over the hulls of the ranges: the variable that has been free the longest is used
// next.
void Variables::Reuse() {
  struct Free {
    uint32_t since;
    uint32_t variable;
    bool operator>(const Free& other) const {
      return since != other.since ? since > other.since : variable > other.variable;
    }
  };
  std::map<TypeId, std::priority_queue<Free, std::vector<Free>, std::greater<>>> free;
  std::vector<uint32_t> order;
  for (uint32_t v = 0; v < list_.size(); ++v) {
    if (parents_[v] == v && !list_[v].is_index) order.push_back(v);
  }
  auto start = [&](uint32_t v) { return ranges_[range_of_[v]].writes.front().position; };
  std::ranges::stable_sort(order, {}, start);
  for (uint32_t v : order) {
    const LiveRange& range = ranges_[range_of_[v]];
    uint32_t begin = range.writes.front().position;
    uint32_t end =
        std::max(range.writes.back().position + 1, range.live.empty() ? 0 : range.live.back().end);
    auto& pool = free[list_[v].type];
    if (!pool.empty() && pool.top().since <= begin) {
      parents_[v] = pool.top().variable;
      pool.pop();
    }
    list_[v].name = NameId();
    pool.push({end, FindRoot(v)});
  }
}

}  // namespace texgraph::glsl
