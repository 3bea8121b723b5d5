// SPDX-License-Identifier: Apache-2.0
// What ifs and loops pass on: assignments that happen all at once, put into an order that GLSL can
// do.
#include <algorithm>
#include <unordered_map>

#include "compiler/glsl/function_printer.h"

namespace texgraph::glsl {

using Kind = Statement::Kind;

// The assignments of a statement that change anything.
std::vector<FunctionPrinter::Assignment> FunctionPrinter::AssignmentsAt(size_t position) const {
  const Statement& statement = schedule_[position];
  ValueId v = statement.value;
  const Inst& inst = function_[v];
  std::span<const ValueId> values;
  switch (statement.kind) {
    case Kind::kIfInit: {
      const ir::Branch& branch = function_.branches[inst.aux];
      bool then_only = schedule_.StyleOf(v) == IfStyle::kThenOnly;
      values =
          function_.regions[(then_only ? branch.else_region : branch.then_region).index].results;
      break;
    }
    case Kind::kLoopInit:
      values = function_.Operands(inst);
      break;
    case Kind::kThenEnd:
    case Kind::kElseEnd:
    case Kind::kLoopNext:
      values = function_.regions[statement.region.index].results;
      break;
    default:
      return {};
  }
  std::vector<Assignment> assignments;
  for (uint32_t r = 0; r < values.size(); ++r) {
    VariableId to = plan_.variables.OfResult(v, r);
    if (to && plan_.variables.Of(values[r]) != to) assignments.push_back({to, values[r]});
  }
  return assignments;
}

void FunctionPrinter::PrintAssignments(size_t position) {
  std::vector<Assignment> pending = AssignmentsAt(position);
  if (pending.size() == 1) {
    PrintAssignment(pending[0], position);
  } else if (!pending.empty()) {
    PrintInOrder(std::move(pending), position);
  }
}

void FunctionPrinter::PrintAssignment(const Assignment& assignment, size_t position) {
  std::string line;
  if (Declares(assignment.to, position)) {
    std::string value;
    expressions_.Append(assignment.from, Precedence::kAnything, value);
    TypeId type = plan_.variables[assignment.to].type;
    line = names_.Declaration(type, NameVariable(assignment.to)) + " = " + value;
  } else {
    expressions_.AppendAssignment(assignment.to, assignment.from, false, line);
  }
  out_.Line(line + ";");
}

// A variable may be written when no other pending value reads it. Where all wait for one another,
// as in a swap, one old value is kept in a variable of its own.
void FunctionPrinter::PrintInOrder(std::vector<Assignment> pending, size_t position) {
  std::vector<std::vector<VariableId>> reads(pending.size());
  std::unordered_map<VariableId, uint32_t> readers;
  for (size_t i = 0; i < pending.size(); ++i) {
    expressions_.CollectReads(pending[i].from, reads[i]);
    std::ranges::sort(reads[i]);
    reads[i].erase(std::ranges::unique(reads[i]).begin(), reads[i].end());
    std::erase(reads[i], pending[i].to);
    for (VariableId v : reads[i]) ++readers[v];
  }
  std::vector<std::pair<VariableId, std::string_view>> renamed;
  std::vector<bool> done(pending.size());
  for (size_t left = pending.size(); left > 0;) {
    size_t chosen = pending.size(), first = pending.size();
    for (size_t i = 0; i < pending.size(); ++i) {
      if (done[i]) continue;
      first = std::min(first, i);
      if (readers[pending[i].to] == 0) {
        chosen = i;
        break;
      }
    }
    if (chosen == pending.size()) {
      VariableId kept = pending[first].to;
      std::string old(expressions_.NameOf(kept));
      std::string_view copy = Claim("previous_" + old, false);
      out_.Line(names_.Declaration(plan_.variables[kept].type, copy) + " = " + old + ";");
      renamed.emplace_back(kept, expressions_.NameOf(kept));
      expressions_.SetName(kept, copy);
      readers[kept] = 0;
      continue;
    }
    const Assignment& next = pending[chosen];
    auto old = std::ranges::find(renamed, next.to, [](const auto& r) { return r.first; });
    if (old == renamed.end()) {
      PrintAssignment(next, position);
    } else {
      std::string line = std::string(old->second) + " = ";
      expressions_.Append(next.from, Precedence::kAnything, line);
      out_.Line(line + ";");
    }
    for (VariableId v : reads[chosen]) {
      if (readers[v] > 0) --readers[v];
    }
    done[chosen] = true;
    --left;
  }
  for (auto& [variable, name] : renamed) expressions_.SetName(variable, name);
}

}  // namespace texgraph::glsl
