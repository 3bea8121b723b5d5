// SPDX-License-Identifier: Apache-2.0
// One function as GLSL: comment, signature, statements. Names are chosen on the way, in scopes.
#pragma once

#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "compiler/glsl/expressions.h"
#include "compiler/glsl/function_plan.h"
#include "compiler/glsl/line_writer.h"

namespace texgraph::glsl {

class FunctionPrinter {
 public:
  FunctionPrinter(const ir::Module& module, const ir::Function& function, const FunctionPlan& plan,
                  const ModuleNames& names, LineWriter& out);

  // A block's function, with its comment.
  void PrintBlock(std::string_view name);
  // main(), which sets the outputs.
  void PrintMain();
  // main as a function that is called `name`: `inputs` are its parameters.
  void PrintShaderFunction(const std::vector<GlobalId>& inputs);

 private:
  struct Assignment {
    VariableId to;
    ValueId from;
  };

  void ClaimParameters();
  std::string Signature(std::string_view name, std::vector<std::string> parameters);
  void PrintStatements();
  size_t PrintStatement(size_t position);
  void PrintOrigin(const Statement& statement);
  size_t PrintDefinition(size_t position);
  void PrintCall(const Statement& statement, size_t position);
  void PrintAssignments(size_t position);
  void PrintAssignment(const Assignment& assignment, size_t position);
  void PrintInOrder(std::vector<Assignment> pending, size_t position);
  size_t PrintElse(size_t position);
  void PrintLoop(const Statement& statement);
  void PrintReturn();
  std::vector<Assignment> AssignmentsAt(size_t position) const;
  bool Declares(VariableId v, size_t position) const;
  bool HasDeclarationsBefore(size_t position) const;
  void DeclareBefore(size_t position);
  void DeclareTogether(const std::vector<VariableId>& variables);
  std::string IfLine(ValueId branch) const;
  void OpenScope();
  void CloseScope();

  std::string_view NameVariable(VariableId v);
  std::string WishFor(const Variable& variable) const;
  std::string_view Claim(std::string_view wish, bool is_named);
  std::string_view ClaimIndex(const Variable& variable);

  const ir::Module& module_;
  const ir::Function& function_;
  const FunctionPlan& plan_;
  const Schedule& schedule_;
  const ModuleNames& names_;
  LineWriter& out_;
  Expressions expressions_;
  NameTable locals_;
  std::unordered_set<std::string_view>
      wished_;  // by values with names; unnamed ones leave them alone
  bool has_wishes_ = false;
  bool claiming_named_ = false;
  std::string line_;  // that is being made
  std::vector<std::string>
      targets_;               // by result: the variable that it is assigned to; empty: returned
  size_t next_declared_ = 0;  // into Variables::DeclaredBefore()
  std::vector<bool> merged_;  // by BranchId: ifs that are written as "else if"
  std::string_view node_;     // of the latest comment
};

}  // namespace texgraph::glsl
