// SPDX-License-Identifier: Apache-2.0
// Returns. A function has one end in the IR, so `if (c) return a; rest` becomes `if (c) a else
// rest`. Where both sides may go on, a flag remembers who has returned.
#include <algorithm>

#include "compiler/blocks/lower_function.h"

namespace texgraph::blocks {

using ir::ValueId;

namespace {

bool Ends(const std::vector<TypedStmt>& list) {
  return std::ranges::any_of(list, [](const TypedStmt& stmt) { return stmt.ends; });
}

}  // namespace

// The returned value, if there is one, and what the out parameters hold.
FunctionLowering::Values FunctionLowering::Results(ValueId value) {
  Values results;
  if (signature_.result != ir::kVoid) results.push_back(value);
  for (uint32_t slot = 0; slot < signature_.parameters.size(); ++slot) {
    if (signature_.parameters[slot].is_out) results.push_back(Get(slot));
  }
  return results;
}

FunctionLowering::Values FunctionLowering::LowerToEnd(Rest rest) {
  while (!failed_) {
    if (rest.at == rest.list->size()) {
      if (!rest.next) return Results({});
      rest = *rest.next;
      continue;
    }
    const TypedStmt& stmt = (*rest.list)[rest.at++];
    if (stmt.kind == TypedStmtKind::kReturn) {
      ValueId value = stmt.value ? Lower(stmt.value) : ValueId();
      if (stmt.value && !value) failed_ = true;
      return Results(value);
    }
    if (!stmt.returns) {
      LowerStmt(stmt);
      continue;
    }
    if (!Enter(stmt.range)) return {};
    Values results = LowerEarlyReturn(stmt, rest);
    Leave();
    return results;
  }
  return {};
}

FunctionLowering::Values FunctionLowering::LowerEarlyReturn(const TypedStmt& stmt,
                                                            const Rest& rest) {
  ValueId condition = Lower(stmt.value);
  if (!condition) {
    failed_ = true;
    return {};
  }
  bool first_ends = Ends(stmt.first), second_ends = Ends(stmt.second);
  if (std::optional<bool> known = KnownBool(condition)) {
    bool ends = *known ? first_ends : second_ends;
    return LowerToEnd({*known ? &stmt.first : &stmt.second, 0, ends ? nullptr : &rest});
  }
  if (first_ends || second_ends) {
    return Join(
        condition,
        [&] {
          return LowerToEnd({&stmt.first, 0, first_ends ? nullptr : &rest});
        },
        [&] {
          return LowerToEnd({&stmt.second, 0, second_ends ? nullptr : &rest});
        });
  }
  Set(DoneSlot(), builder_.Bool(false));
  if (signature_.result != ir::kVoid) Set(ValueSlot(), builder_.Zero(signature_.result));
  Branch(
      condition, [&] { LowerFlagged(stmt.first, 0); }, [&] { LowerFlagged(stmt.second, 0); });
  if (failed_) return {};
  return Join(
      Get(DoneSlot()), [&] { return Results(Get(ValueSlot())); }, [&] { return LowerToEnd(rest); });
}

// Both sides lead to the end of the function.
FunctionLowering::Values FunctionLowering::Join(ValueId condition,
                                                const std::function<Values()>& on_true,
                                                const std::function<Values()>& on_false) {
  ir::RegionId regions[2];
  uint32_t count = 0;
  for (int side = 0; side < 2; ++side) {
    size_t mark = log_.size();
    regions[side] = builder_.BeginRegion();
    Values results = (side == 0 ? on_true : on_false)();
    for (ValueId value : results) failed_ = failed_ || !value;
    builder_.EndRegion(results);
    RollBack(mark);
    count = static_cast<uint32_t>(results.size());
    if (failed_) return {};
  }
  ValueId value = builder_.If(condition, regions[0], regions[1]);
  Values results;
  for (uint32_t i = 0; i < count; ++i) results.push_back(builder_.Result(value, i, count));
  return results;
}

// From statement `at` on, with a return written into the flag and the value.
void FunctionLowering::LowerFlagged(const List& list, size_t at) {
  for (; at < list.size() && !failed_; ++at) {
    const TypedStmt& stmt = list[at];
    if (stmt.kind == TypedStmtKind::kReturn) {
      ValueId value = stmt.value ? Lower(stmt.value) : ValueId();
      if (stmt.value && !value) failed_ = true;
      if (value) Set(ValueSlot(), value);
      Set(DoneSlot(), builder_.Bool(true));
      return;
    }
    if (!stmt.returns) {
      LowerStmt(stmt);
      continue;
    }
    if (!Enter(stmt.range)) return;
    ValueId condition = Lower(stmt.value);
    if (!condition) failed_ = true;
    if (condition) {
      Branch(
          condition, [&] { LowerFlagged(stmt.first, 0); }, [&] { LowerFlagged(stmt.second, 0); });
    }
    if (!failed_ && !stmt.ends && at + 1 < list.size()) {
      Branch(
          Get(DoneSlot()), [] {}, [&] { LowerFlagged(list, at + 1); });
    }
    Leave();
    return;
  }
}

}  // namespace texgraph::blocks
