// SPDX-License-Identifier: Apache-2.0
// A block file as it is written: names are not resolved and types are words. A FileAst owns all its
// nodes; pointers between them live as long as it does, string views as long as the source.
#pragma once

#include <cstdint>
#include <deque>
#include <string_view>
#include <vector>

#include "compiler/base/source.h"
#include "compiler/blocks/lexer.h"

namespace texgraph::blocks {

struct Expr;

// "vec3", "Tile", "float[4]", "float[]".
struct TypeName {
  std::string_view name;
  SourceRange range;
  bool is_array = false;
  Expr* length = nullptr;  // null in "float[]"
};

enum class ExprKind : uint8_t {
  kLiteral,  // op: kInt, kUint, kFloat, kTrue or kFalse; bits
  kName,
  kUnary,  // op: kAdd, kSub, kNot, kTilde
  kBinary,
  kChoose,  // a ? b : c
  kCall,    // a function or a constructor; array constructors have `type`
  kMember,  // args[0].name
  kLength,  // args[0].length()
  kIndex,   // args[0][args[1]]
};

struct Expr {
  ExprKind kind = ExprKind::kLiteral;
  TokenKind op = TokenKind::kEnd;
  uint16_t depth = 1;  // of the tree below, itself counted
  uint32_t bits = 0;
  SourceRange range;
  SourceRange name_range;  // of the name, or of the operator
  std::string_view name;
  TypeName* type = nullptr;
  std::vector<Expr*> args;
};

struct Declarator {
  std::string_view name;
  SourceRange range;
  TypeName type;  // with the array suffix that follows the name
  Expr* value = nullptr;
};

enum class StmtKind : uint8_t {
  kDeclare,  // declarators, is_const
  kAssign,   // target op value; for ++ and -- the value is null
  kCall,     // value
  kIf,       // value, first, second
  kFor,      // init, value (the condition), step, first (the body)
  kReturn,   // value or null
  kBlock,    // body
};

struct Stmt {
  StmtKind kind = StmtKind::kBlock;
  TokenKind op = TokenKind::kEnd;
  bool is_const = false;
  SourceRange range;  // of the statement; of kIf, kFor and kReturn the keyword
  Expr* target = nullptr;
  Expr* value = nullptr;
  Stmt* init = nullptr;
  Stmt* step = nullptr;
  Stmt* first = nullptr;
  Stmt* second = nullptr;
  std::vector<Declarator> declarators;
  std::vector<Stmt*> body;
};

struct ParameterAst {
  bool is_const = false;
  bool is_out = false;  // "out" and "inout"
  bool is_inout = false;
  TypeName type;
  std::string_view name;  // empty if there is none
  SourceRange range;      // of the name, or of the type if there is none
};

// The documentation that stands before a declaration: lines [first, first + count) of
// FileAst::docs.
struct DocLines {
  uint32_t first = 0;
  uint32_t count = 0;
};

struct FunctionAst {
  std::string_view name;
  SourceRange range;  // of the name
  TypeName result;
  std::vector<ParameterAst> parameters;
  Stmt* body = nullptr;  // null: a prototype
  DocLines docs;
  SourceRange whole;  // from the result type to the closing brace or the semicolon
  size_t first_expr = 0,
         last_expr = 0;  // its expressions: [first_expr, last_expr) of FileAst::exprs
};

struct StructAst {
  std::string_view name;
  SourceRange range;
  std::vector<Declarator> members;
  DocLines docs;
  SourceRange whole;
};

struct ConstantAst {
  Declarator declarator;
  DocLines docs;
  SourceRange whole;  // of the statement that declares it
};

struct FileAst {
  SourceId source;
  std::vector<DocLine> docs;
  // Each in the order of the file; positions tell the order among them.
  std::deque<FunctionAst> functions;
  std::deque<StructAst> structs;
  std::deque<ConstantAst> constants;

  std::deque<Expr> exprs;
  std::deque<Stmt> stmts;
  std::deque<TypeName> types;
};

}  // namespace texgraph::blocks
