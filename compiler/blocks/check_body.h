// SPDX-License-Identifier: Apache-2.0
// Checks the body of one function for one meaning of genType, and makes a typed function of it
// (typed.h). Functions that return a TypedId return an invalid one after a mistake, which has then
// been reported.
#pragma once

#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "compiler/blocks/builtins.h"
#include "compiler/blocks/check.h"
#include "compiler/blocks/limits.h"

namespace texgraph::blocks {

class BodyChecker {
 public:
  // `function` says which file, and what genType stands for; the rest of it is filled here.
  // `anywhere`: constants may be named that the file declares below.
  BodyChecker(Program& program, TypedFunction& function, bool anywhere = false);

  void CheckFunction(const FunctionInfo& info, const Signature& signature);

  TypedId Check(const Expr& expr);
  // An error says that `what` ("the condition") must be of that type.
  TypedId CheckAs(const Expr& expr, ir::TypeId type, std::string_view what);
  // What GLSL converts without being asked; else an error that says what `what` must be.
  TypedId Coerce(TypedId value, ir::TypeId type, std::string_view what);
  ir::TypeId TypeOf(TypedId id) const { return function_.exprs[id.index].type; }
  TypedId SplatTo(TypedId scalar, ir::TypeId vector);

 private:
  // check_body.cc
  Diagnostic& Error(DiagnosticKind kind, SourceRange range, std::string message);
  std::string Text(ir::TypeId type) const { return types_.Text(type); }
  SourceRange RangeOf(TypedId id) const;
  TypedId Add(TypedExpr expr, std::span<const TypedId> children, SourceRange range);
  TypedId AddOp(ir::Op op, ir::TypeId type, std::initializer_list<TypedId> children,
                SourceRange range, uint32_t aux = 0);
  TypedId AddComposite(Composite composite, ir::TypeId type, std::span<const TypedId> children,
                       SourceRange range, ir::Op op = ir::Op::kConst);
  TypedId AddConstant(ir::TypeId type, std::span<const uint32_t> words, SourceRange range);
  TypedId AddScalar(ir::TypeId type, uint32_t word, SourceRange range);
  TypedId AddConstruct(ir::TypeId type, std::span<const TypedId> parts, SourceRange range);
  TypedId ConvertTo(TypedId value, ir::TypeId type);  // asked for: any scalar kind, the same width
  TypedId Prefix(TypedId vector, uint32_t width);
  TypedId ElementOf(TypedId aggregate, uint32_t index);

  // check_body.cc: scopes
  struct Hidden {
    std::string_view name;
    uint32_t slot;  // what the name meant before, or kNoSlot
  };
  static constexpr uint32_t kNoSlot = 0xffffffffu;
  uint32_t AddSlot(std::string_view name, ir::TypeId type, SourceRange range, bool is_fixed);
  uint32_t FindSlot(std::string_view name) const;
  void OpenScope() { scopes_.push_back(hidden_.size()); }
  void CloseScope();

  // check_statement.cc
  using Stmts = std::vector<TypedStmt>;
  void CheckInto(const Stmt& stmt, Stmts& list);
  void CheckScoped(const Stmt* stmt, Stmts& list);
  void CheckDeclare(const Stmt& stmt);
  void CheckDeclarator(const Declarator& declarator, bool is_const);
  void CheckAssign(const Stmt& stmt);
  void CheckCallStatement(const Stmt& stmt);
  void CheckIf(const Stmt& stmt);
  void CheckFor(const Stmt& stmt);
  bool CheckIndex(const Stmt& stmt, TypedStmt& loop);
  bool CheckBound(const Stmt& stmt, TypedStmt& loop);
  bool CheckStep(const Stmt& stmt, TypedStmt& loop);
  void CheckReturn(const Stmt& stmt);
  std::optional<Place> CheckPlace(const Expr& expr, ir::TypeId& type);
  bool AddMemberStep(const Expr& expr, Place& place, ir::TypeId& type);
  bool AddIndexStep(const Expr& expr, Place& place, ir::TypeId& type);
  void Assign(Place place, TypedId value, SourceRange range);
  TypedId CheckWhole(const Expr& expr);  // if it is a call, that may have out parameters

  // check_expression.cc
  TypedId CheckLiteral(const Expr& expr);
  TypedId CheckName(const Expr& expr);
  TypedId CheckChoose(const Expr& expr);
  TypedId CheckMember(const Expr& expr);
  TypedId CheckIndex(const Expr& expr);
  TypedId CheckLength(const Expr& expr);
  // The components that letters name, 2 bits each from the low end; reported if they name none of
  // `type`.
  std::optional<uint32_t> SwizzleMask(const Expr& expr, ir::TypeId type);
  std::optional<uint32_t> MemberIndex(const Expr& expr, ir::TypeId type);
  // An index: `constant` is set if it is known here, and then in range.
  TypedId CheckElementIndex(const Expr& index, ir::TypeId aggregate,
                            std::optional<uint32_t>& constant);

  // check_operator.cc
  TypedId CheckUnary(const Expr& expr);
  TypedId CheckBinary(const Expr& expr);
  TypedId Binary(TokenKind op, TypedId a, TypedId b, SourceRange range);
  TypedId Arithmetic(TokenKind op, TypedId a, TypedId b, SourceRange range);
  TypedId MatrixArithmetic(TokenKind op, TypedId a, TypedId b, SourceRange range);
  TypedId Shift(TokenKind op, TypedId a, TypedId b, SourceRange range);
  TypedId Logic(TokenKind op, TypedId a, TypedId b, SourceRange range);
  TypedId Comparison(TokenKind op, TypedId a, TypedId b, SourceRange range);
  TypedId Equality(TokenKind op, TypedId a, TypedId b, SourceRange range);
  TypedId NoOperator(TokenKind op, TypedId a, TypedId b, SourceRange range,
                     std::string_view advice = "");
  bool Unify(TypedId& a, TypedId& b);  // to one scalar kind

  // check_constructor.cc
  TypedId CheckConstructor(const Expr& expr, ir::TypeId type);
  TypedId ConstructScalar(const Expr& expr, ir::TypeId type, TypedId arg);
  TypedId ConstructVector(const Expr& expr, ir::TypeId type, std::vector<TypedId>& args);
  TypedId ConstructMatrix(const Expr& expr, ir::TypeId type, std::vector<TypedId>& args);
  TypedId ConstructElements(const Expr& expr, ir::TypeId type, std::span<const TypedId> args);
  bool Flatten(const Expr& expr, std::vector<TypedId>& args);
  bool CheckArguments(const Expr& expr, std::vector<TypedId>& args);

  // check_builtin.cc
  TypedId CheckBuiltin(const Expr& expr, const Builtin& builtin);
  TypedId CheckFamily(const Expr& expr, const Builtin& builtin, std::vector<TypedId>& args);
  bool UnifyAll(const Expr& expr, std::vector<TypedId>& args, ir::Scalar least, ir::Scalar most,
                uint8_t scalars);
  bool CheckFloats(const Expr& expr, std::vector<TypedId>& args, uint8_t scalars = 0);
  TypedId CheckMix(const Expr& expr, std::vector<TypedId>& args);
  TypedId CheckComparisonFunction(const Expr& expr, const Builtin& builtin,
                                  std::vector<TypedId>& args);
  TypedId CheckBits(const Expr& expr, TypedId arg);
  TypedId CheckSampling(const Expr& expr, const Builtin& builtin, std::vector<TypedId>& args);
  TypedId CheckMatrixFunction(const Expr& expr, const Builtin& builtin, std::vector<TypedId>& args);
  TypedId WrongArguments(const Expr& expr, std::span<const TypedId> args, std::string_view wanted);
  bool IsSineHash(const Expr& expr) const;

  // check_call.cc
  struct Candidate {
    File* file;
    uint32_t function;
    ir::TypeId gen_type;
    const Signature* signature;
  };
  // `whole`: the call stands alone, so it may have out parameters.
  TypedId CheckCall(const Expr& expr, bool whole);
  TypedId CheckFieldCall(const Expr& expr, uint32_t field);
  TypedId CheckFunctionCall(const Expr& expr, bool whole);
  std::vector<Candidate> FindCandidates(const Expr& expr);
  void AddCandidates(File& file, uint32_t function, std::vector<Candidate>& candidates);
  const Candidate* Choose(const Expr& expr, std::span<const Candidate> candidates,
                          std::span<const TypedId> args);
  void NoCandidate(const Expr& expr, std::span<const Candidate> candidates,
                   std::span<const TypedId> args);
  const FieldInfo* MissingField(const File& other, const FunctionInfo& info,
                                ir::TypeId gen_type) const;
  bool CheckFieldsOf(const Expr& expr, const Candidate& candidate);
  TypedId MakeCall(const Expr& expr, const Candidate& candidate, std::span<const TypedId> args,
                   bool whole);

  Program& program_;
  File& file_;
  ir::Types& types_;
  TypedFunction& function_;
  const Signature* signature_ = nullptr;
  std::unordered_map<std::string_view, uint32_t> names_;
  std::vector<Hidden> hidden_;
  std::vector<size_t> scopes_;         // into hidden_
  std::vector<uint32_t> slot_scopes_;  // the number of scopes that were open when the slot was made
  std::vector<uint32_t> assigned_;     // slots in the order of their assignments
  Stmts* list_ = nullptr;              // where statements go
  uint32_t loops_ = 0;                 // open around this place
  bool anywhere_;
  bool failed_ = false;
};

}  // namespace texgraph::blocks
