// SPDX-License-Identifier: Apache-2.0
// Values as GLSL expressions: parentheses only where precedence or clarity needs them, scalars
// beside vectors where GLSL allows them, swizzles instead of single components.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "compiler/glsl/module_names.h"
#include "compiler/glsl/variables.h"

namespace texgraph::glsl {

// GLSL's precedence levels, the strongest first.
enum class Precedence : uint8_t {
  kPrimary = 1,
  kPostfix,
  kUnary,
  kMultiplicative,
  kAdditive,
  kShift,
  kRelational,
  kEquality,
  kBitAnd,
  kBitXor,
  kBitOr,
  kAnd,
  kXor,
  kOr,
  kConditional,
  kAnything,
};

class Expressions {
 public:
  Expressions(const ir::Module& module, const ir::Function& function, const Forms& forms,
              const Variables& variables, const ModuleNames& names)
      : module_(module),
        function_(function),
        forms_(forms),
        variables_(variables),
        names_(names),
        variable_names_(variables.size()),
        parameter_names_(function.parameters.size()) {}

  void SetName(VariableId variable, std::string_view name) {
    variable_names_[variable.index] = name;
  }
  std::string_view NameOf(VariableId variable) const { return variable_names_[variable.index]; }
  void SetParameterName(size_t parameter, std::string_view name) {
    parameter_names_[parameter] = name;
  }
  std::string_view ParameterName(size_t parameter) const { return parameter_names_[parameter]; }

  // Appends an expression of `v` that binds at least as strongly as `limit`.
  void Append(ValueId v, Precedence limit, std::string& out) const;
  // Appends the expression behind a variable's value.
  void AppendDefinition(ValueId v, std::string& out) const { AppendOperation(v, out); }
  // Appends "x = ...", or "x += ..." where that says the same.
  void AppendAssignment(VariableId to, ValueId v, bool is_definition, std::string& out) const;
  // Appends what is true when `v` is not.
  void AppendNegation(ValueId v, std::string& out) const;
  // Every variable that the expression of `v` reads.
  void CollectReads(ValueId v, std::vector<VariableId>& reads) const;

 private:
  struct Infix {
    std::string_view symbol;
    Precedence precedence;
  };

  Precedence PrecedenceOf(ValueId v) const;
  Infix InfixOf(const Inst& inst) const;
  void AppendLeaf(const Inst& inst, Precedence limit, std::string& out) const;
  void AppendOperation(ValueId v, std::string& out) const;
  void AppendInfix(ValueId v, Infix infix, std::string& out) const;
  bool AppendSum(ValueId v, std::string& out) const;
  void AppendOperand(ValueId v, bool as_scalar, Precedence limit, std::string& out) const;
  void AppendCall(ValueId v, std::string_view name, std::string& out) const;
  void AppendArguments(std::span<const ValueId> operands, std::string& out) const;
  void AppendComparison(ValueId v, std::string& out) const;
  void AppendConditional(ValueId condition, ValueId then_value, ValueId else_value,
                         std::string& out) const;
  void AppendSelect(ValueId v, std::string& out) const;
  void AppendConstruct(ValueId v, std::string& out) const;
  void AppendSplat(const Inst& inst, std::string& out) const;
  void AppendAccess(ValueId v, std::string& out) const;
  void AppendBitcast(const Inst& inst, ValueId operand, std::string& out) const;
  void AppendNegative(const Inst& inst, std::string& out) const;

  bool IsInline(ValueId v) const { return forms_.Of(v) == Form::kInline; }
  // Whether a vector or matrix may be written as one scalar beside another operand.
  bool IsUniform(ValueId v) const;
  // Whether it is a constant that is negative in all components, and these are equal.
  bool IsNegativeConstant(ValueId v) const;
  std::span<const uint32_t> Words(const Inst& constant) const {
    return module_.Words(ir::ConstId(constant.aux));
  }
  ir::Scalar ScalarKind(TypeId type) const {
    return ir::IsVector(type) ? ir::ScalarOf(type) : ir::Scalar::kFloat;
  }

  const ir::Module& module_;
  const ir::Function& function_;
  const Forms& forms_;
  const Variables& variables_;
  const ModuleNames& names_;
  std::vector<std::string_view> variable_names_;
  std::vector<std::string_view> parameter_names_;
};

}  // namespace texgraph::glsl
