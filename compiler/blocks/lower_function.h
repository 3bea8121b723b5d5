// SPDX-License-Identifier: Apache-2.0
// One function's body in single assignment: every slot has one value at a time, branches and loops
// yield the slots that they change, an early return puts the rest of the function into the other
// branch.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "compiler/blocks/limits.h"
#include "compiler/blocks/lower.h"
#include "compiler/blocks/lower_expression.h"

namespace texgraph::blocks {

class FunctionLowering : public ExpressionLowering {
 public:
  FunctionLowering(Lowering& lowering, const TypedFunction& function, ir::Function& result,
                   ir::Builder& builder);

  // `values` of the template parameters. The builder's function is complete then, unless the
  // result's id is to stay invalid: then this is nothing.
  std::optional<Lowered> Run(std::span<const ir::ConstId> values);

 protected:
  ir::ValueId Slot(uint32_t slot) override;
  ir::ValueId Call(const TypedExpr& expr, std::span<const ir::ValueId> arguments) override;
  ir::ValueId CallField(const TypedExpr& expr, std::span<const ir::ValueId> arguments) override;
  void TooDeep(const TypedExpr& expr) override;
  void OutOfRange(const TypedExpr& expr, ir::TypeId aggregate) override;

 private:
  using List = std::vector<TypedStmt>;
  // The statements that follow: the rest of a list, then the rest of the lists around it.
  struct Rest {
    const List* list;
    size_t at;
    const Rest* next;
  };
  using Values = std::vector<ir::ValueId>;

  void Error(DiagnosticKind kind, SourceRange range, std::string message);
  SourceRange RangeOf(const TypedExpr& expr) const {
    return {function_.file->source, expr.begin, expr.end};
  }
  void AddParameters(std::span<const ir::ConstId> values);
  // Takes `units` of the depth until Leave; false, and reported, if there are no more.
  bool Enter(SourceRange range, uint32_t units = kStatementDepth);
  void Leave(uint32_t units = kStatementDepth) { depth_ -= units; }

  // Slots
  void Set(uint32_t slot, ir::ValueId value);
  ir::ValueId Get(uint32_t slot);
  void RollBack(size_t mark);
  void StorePlace(const Place& place, ir::ValueId value);
  ir::ValueId Store(ir::ValueId whole, std::span<const Place::Step> steps, ir::ValueId value);
  ir::ValueId Load(ir::ValueId whole, const Place::Step& step);

  // Statements
  void LowerStmt(const TypedStmt& stmt);
  void LowerList(const List& list);
  void LowerAssign(const TypedStmt& stmt);
  void LowerCallStmt(const TypedStmt& stmt);
  void LowerFor(const TypedStmt& stmt);
  std::optional<ir::ForLoop> Bounds(const TypedStmt& stmt);
  std::optional<int32_t> KnownInt(TypedId id, std::string_view what);
  // Runs both sides in regions of their own; what they change, an `if` yields.
  void Branch(ir::ValueId condition, const std::function<void()>& on_true,
              const std::function<void()>& on_false);

  // Returns
  Values LowerToEnd(Rest rest);
  Values LowerEarlyReturn(const TypedStmt& stmt, const Rest& rest);
  Values Join(ir::ValueId condition, const std::function<Values()>& on_true,
              const std::function<Values()>& on_false);
  void LowerFlagged(const List& list, size_t at);
  Values Results(ir::ValueId value);
  uint32_t DoneSlot() const { return static_cast<uint32_t>(function_.slots.size()); }
  uint32_t ValueSlot() const { return DoneSlot() + 1; }

  std::optional<Values> MakeCall(const TypedExpr& expr, std::span<const ir::ValueId> arguments);

  Lowering& lowering_;
  ir::Function& result_;
  const FunctionInfo& info_;
  const Signature& signature_;
  std::vector<ir::ValueId> slots_;
  std::vector<std::pair<uint32_t, ir::ValueId>> log_;  // what slots held before each Set
  std::vector<ir::ValueId> fields_;                    // by the file's fields
  uint64_t rounds_ = 1;                                // of the loops around this place
  uint64_t most_rounds_ = 1;
  bool failed_ = false;
};

}  // namespace texgraph::blocks
