// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/loop_end.h"

#include <algorithm>
#include <vector>

namespace texgraph::ir {
namespace {

constexpr uint32_t kRoundsOfEnding = 2;

// Whether `v` is the same in every round for which the carried values are the same.
bool DependsOnCarriedOnly(const Function& function, const Region& body, ValueId v) {
  std::vector<bool> varies(function.insts.size());
  varies[body.params[0].index] = true;
  for (ValueId value : body.body) {
    const Inst& inst = function[value];
    for (ValueId operand : function.Operands(inst)) {
      if (varies[operand.index]) varies[value.index] = true;
    }
    if (inst.op == Op::kIf || inst.op == Op::kFor) varies[value.index] = true;
  }
  return !varies[v.index];
}

}  // namespace

ValueId EndingIf(const Function& function, const ForLoop& loop) {
  const Region& body = function.regions[loop.body.index];
  ValueId branch;
  for (ValueId v : body.body) {
    if (function[v].op != Op::kIf) continue;
    if (branch) return {};
    branch = v;
  }
  if (!branch) return {};
  const RegionId other = function.branches[function[branch].aux].else_region;
  const std::vector<ValueId>& kept = function.regions[other.index].results;
  for (size_t r = 0; r < body.results.size(); ++r) {
    const ValueId carried = body.params[r + 1];
    ValueId next = body.results[r];
    if (next == branch) {
      next = kept[0];
    } else if (function[next].op == Op::kExtract && function.Operands(next)[0] == branch &&
               kept.size() > 1) {
      next = kept[function[next].aux];
    }
    if (next != carried) return {};
  }
  return DependsOnCarriedOnly(function, body, function.Operands(branch)[0]) ? branch : ValueId();
}

uint32_t TypicalRounds(const Function& function, const ForLoop& loop) {
  return EndingIf(function, loop) ? std::min(loop.Trips(), kRoundsOfEnding) : loop.Trips();
}

}  // namespace texgraph::ir
