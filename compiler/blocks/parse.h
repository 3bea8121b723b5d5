// SPDX-License-Identifier: Apache-2.0
// The recursive-descent parser behind parser.h. Functions that read an expression or a statement
// return null after a mistake, which has then been reported; statements and declarations go on
// behind it. All nesting counts in one counter.
#pragma once

#include <initializer_list>
#include <string>

#include "compiler/blocks/ast.h"
#include "compiler/blocks/limits.h"

namespace texgraph::blocks {

class Parser {
 public:
  Parser(FileAst& file, std::string_view text, Tokens tokens, Diagnostics& diagnostics)
      : file_(file), text_(text), tokens_(std::move(tokens)), diagnostics_(diagnostics) {}

  void ParseDeclarations();  // parser.cc
  Expr* ParseOnlyExpression();

 private:
  // One level of nesting; false if there are too many, then reading ends.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) { fits_ = parser_.Enter(); }
    ~Level() { --parser_.nesting_; }
    explicit operator bool() const { return fits_; }

   private:
    Parser& parser_;
    bool fits_;
  };

  // parser.cc: tokens
  const Token& Now() const { return tokens_.tokens[at_]; }
  TokenKind Kind(size_t ahead = 0) const;
  bool At(TokenKind kind) const { return Kind() == kind; }
  bool Accept(TokenKind kind);
  bool Expect(TokenKind kind, std::string_view where);
  std::string_view Text(const Token& token) const {
    return text_.substr(token.begin, token.end - token.begin);
  }
  std::string_view Text() const { return Text(Now()); }
  SourceRange Range() const { return {file_.source, Now().begin, Now().end}; }
  SourceRange RangeFrom(uint32_t begin) const;  // up to the last token that was read
  std::string Seen() const;                     // "found 'x'"
  // Null once reading was given up: what follows would only confuse.
  Diagnostic* Error(DiagnosticKind kind, SourceRange range, std::string message);
  bool Enter();
  void GiveUp(SourceRange range, std::string message);
  void SkipBalanced();   // a bracket and what it holds, or one token
  void SkipStatement();  // to behind the next ';', or before '}'

  // parser.cc: declarations
  void ParseDeclaration();
  void ParseStruct(DocLines docs);
  void ParseConstants(DocLines docs);
  void ParseFunctionOrVariable(DocLines docs);
  bool ParseParameters(FunctionAst& function);
  bool ParseParameter(FunctionAst& function);
  DocLines TakeDocs();
  bool ParseType(TypeName& type);
  bool ParseArraySuffix(TypeName& type);
  bool ParseDeclarators(const TypeName& type, std::vector<Declarator>& declarators);
  bool ParseName(std::string_view what, std::string_view& name, SourceRange& range);
  bool RefusedQualifier();

  // parse_statement.cc
  Stmt* ParseStatement();
  Stmt* ParseBlock();
  Stmt* ParseIf();
  Stmt* ParseFor();
  bool ParseForHeader(Stmt& stmt);
  void SkipHeader(size_t open);
  Stmt* ParseReturn();
  Stmt* ParseDeclare();
  Stmt* ParseAssignOrCall();
  Stmt* ParseRefused();
  bool AtDeclaration() const;
  Stmt* NewStmt(StmtKind kind);

  // parse_expression.cc
  Expr* ParseExpression();
  Expr* ParseBinary(int least);
  Expr* ParseUnary();
  Expr* ParsePostfix();
  Expr* ParsePrimary();
  Expr* ParseCall(uint32_t begin, TypeName* type);
  Expr* ParseMember(Expr* base);
  Expr* ParseElement(Expr* base);
  bool AtArrayConstructor() const;
  Expr* NewExpr(ExprKind kind, uint32_t begin, std::initializer_list<Expr*> args);
  Expr* Finish(Expr* expr, uint32_t begin);

  FileAst& file_;
  std::string_view text_;
  Tokens tokens_;
  Diagnostics& diagnostics_;
  size_t at_ = 0;
  size_t next_doc_ = 0;
  uint32_t nesting_ = 0;
  bool gave_up_ = false;
};

}  // namespace texgraph::blocks
