// SPDX-License-Identifier: Apache-2.0
// The form in which each value is written: where it is used, or in a variable of its own. A value
// gets a variable when its author named it, when it is used twice, when its expression would be too
// long or too deep, or when moving it to its use would evaluate it more often or in a place where
// implicit derivatives are undefined.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/glsl/uses.h"

namespace texgraph::glsl {

enum class Form : uint8_t {
  kUnused,
  kLeaf,       // a constant, a parameter or a global
  kResult,     // the variable of one of several results
  kInline,     // written where it is used
  kVariable,   // a variable of its own
  kStatement,  // an if, a loop, or a call with several results
};

// The values that are written inside the expression of `v`.
template <class F>
void ForEachOperand(const ir::Function& function, ValueId v, F&& f) {
  const Inst& inst = function[v];
  if (inst.op == Op::kConstruct && ir::IsVector(inst.type)) {
    Parts parts = ConstructParts(function, inst);
    for (uint32_t i = 0; i < parts.count; ++i) f(parts.list[i].value);
    return;
  }
  for (ValueId operand : function.Operands(inst)) f(operand);
  if (inst.op == Op::kIf) {
    const ir::Branch& branch = function.branches[inst.aux];
    f(function.regions[branch.then_region.index].results[0]);
    f(function.regions[branch.else_region.index].results[0]);
  }
}

class Forms {
 public:
  // `implicit`: by FunctionId, whether calling it takes implicit derivatives. `compact`: names make
  // no variables, so that there are as few as possible.
  Forms(const ir::Module& module, const ir::Function& function, const Uses& uses,
        const std::vector<bool>& implicit, bool compact);

  Form Of(ValueId v) const { return forms_[v.index]; }
  // Whether the expression costs nothing and may be written any number of times: "tile.local.x".
  bool IsFree(ValueId v) const { return Of(v) != Form::kInline || free_[v.index]; }
  // An if that is written as "c ? a : b".
  bool IsTernary(ValueId v) const;
  // Whether a region has statements of its own.
  bool HasStatements(RegionId r) const { return statements_[r.index] > 0; }
  // Whether there is exactly one, be it an if with others inside.
  bool HasOneStatement(RegionId r) const { return statements_[r.index] == 1; }
  size_t variable_count() const { return variable_count_; }
  size_t operation_count() const { return operation_count_; }

 private:
  static constexpr uint32_t kMaxLength = 72;  // of an expression inside another, in characters
  static constexpr uint32_t kMaxRoot = 92;    // of a whole expression
  static constexpr uint32_t kMaxDepth = 6;
  static constexpr uint32_t kMaxTernary = 48;  // of both sides

  void Decide(ValueId v);
  void DecideLeaf(ValueId v);
  void DecideExpression(ValueId v);
  bool MayInline(ValueId v) const;
  bool MayMove(ValueId v) const;
  bool MayBeTernary(ValueId v) const;
  bool ContainsArray(TypeId type) const;
  void FitOperands(uint32_t own_length);
  void MakeVariable(ValueId v);
  bool TakesImplicit(ValueId v) const;
  uint32_t OwnLength(ValueId v) const;
  uint32_t NameLength(ValueId v) const;

  const ir::Module& module_;
  const ir::Function& function_;
  const Uses& uses_;
  const std::vector<bool>& implicit_functions_;
  const bool compact_;
  std::vector<Form> forms_;
  std::vector<bool> free_;
  std::vector<bool> implicit_;     // inline expressions that take implicit derivatives
  std::vector<uint16_t> lengths_;  // rough, in characters
  std::vector<uint8_t> depths_;
  std::vector<uint32_t> statements_;  // by region
  std::vector<ValueId> operands_;     // of the value that is being decided
  size_t variable_count_ = 0;
  size_t operation_count_ = 0;
};

}  // namespace texgraph::glsl
