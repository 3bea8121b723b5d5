// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/parse.h"

namespace texgraph::blocks {
namespace {

bool IsAssignment(TokenKind kind) {
  switch (kind) {
    case TokenKind::kAssign:
    case TokenKind::kAddAssign:
    case TokenKind::kSubAssign:
    case TokenKind::kMulAssign:
    case TokenKind::kDivAssign:
    case TokenKind::kModAssign:
    case TokenKind::kAndAssign:
    case TokenKind::kOrAssign:
    case TokenKind::kXorAssign:
    case TokenKind::kShlAssign:
    case TokenKind::kShrAssign:
      return true;
    default:
      return false;
  }
}

bool IsStep(TokenKind kind) {
  return kind == TokenKind::kIncrement || kind == TokenKind::kDecrement;
}

// What to do instead of a statement that blocks don't have; "" for any other token.
std::string_view Advice(TokenKind kind) {
  switch (kind) {
    case TokenKind::kWhile:
    case TokenKind::kDo:
      return "write 'for (int i = 0; i < n; i++)' with a bound that is known when the shader is "
             "made";
    case TokenKind::kBreak:
    case TokenKind::kContinue:
      return "put what may be skipped into an 'if' in the loop's body";
    case TokenKind::kSwitch:
      return "write 'if' and 'else', or choose from a constant array";
    case TokenKind::kDiscard:
      return "give an opacity of 0 instead";
    default:
      return "";
  }
}

}  // namespace

Stmt* Parser::NewStmt(StmtKind kind) {
  Stmt& stmt = file_.stmts.emplace_back();
  stmt.kind = kind;
  stmt.range = Range();
  return &stmt;
}

// "Tile t", "float[3] w"; an element ("w[3] =") is no declaration.
bool Parser::AtDeclaration() const {
  if (At(TokenKind::kConst)) return true;
  if (!At(TokenKind::kIdentifier)) return false;
  size_t ahead = 1;
  if (Kind(ahead) == TokenKind::kLeftBracket) {
    for (uint32_t depth = 0; Kind(ahead) != TokenKind::kEnd; ++ahead) {
      if (Kind(ahead) == TokenKind::kLeftBracket) ++depth;
      if (Kind(ahead) == TokenKind::kSemicolon) return false;
      if (Kind(ahead) == TokenKind::kRightBracket && --depth == 0) break;
    }
    ++ahead;
  }
  return Kind(ahead) == TokenKind::kIdentifier;
}

Stmt* Parser::ParseStatement() {
  Level level(*this);
  if (!level) return nullptr;
  switch (Kind()) {
    case TokenKind::kLeftBrace:
      return ParseBlock();
    case TokenKind::kIf:
      return ParseIf();
    case TokenKind::kFor:
      return ParseFor();
    case TokenKind::kReturn:
      return ParseReturn();
    case TokenKind::kSemicolon: {
      Stmt* empty = NewStmt(StmtKind::kBlock);
      ++at_;
      return empty;
    }
    default:
      break;
  }
  if (Stmt* refused = ParseRefused()) return refused;
  if (RefusedQualifier()) return nullptr;
  if (At(TokenKind::kElse) || At(TokenKind::kStruct)) {
    Error(DiagnosticKind::kBlockSyntax, Range(),
          At(TokenKind::kElse) ? "this 'else' has no 'if'" : "structs stand outside functions");
    return nullptr;
  }
  Stmt* stmt = AtDeclaration() ? ParseDeclare() : ParseAssignOrCall();
  if (!stmt || !Expect(TokenKind::kSemicolon, "after the statement")) return nullptr;
  return stmt;
}

// Reads over what blocks don't have, so that one mistake is one diagnostic. Null if there is
// nothing of the kind here.
Stmt* Parser::ParseRefused() {
  std::string_view advice = Advice(Kind());
  if (advice.empty()) return nullptr;
  Error(DiagnosticKind::kBlockSubset, Range(),
        "blocks have no " + std::string(TokenText(Kind())) + "; " + std::string(advice));
  Stmt* stmt = NewStmt(StmtKind::kBlock);
  bool is_do = At(TokenKind::kDo);
  ++at_;
  if (At(TokenKind::kLeftParen)) SkipBalanced();
  if (At(TokenKind::kLeftBrace)) SkipBalanced();
  if (is_do && Accept(TokenKind::kWhile) && At(TokenKind::kLeftParen)) SkipBalanced();
  Accept(TokenKind::kSemicolon);
  return stmt;
}

Stmt* Parser::ParseBlock() {
  Stmt* block = NewStmt(StmtKind::kBlock);
  SourceRange open = Range();
  ++at_;
  while (!At(TokenKind::kRightBrace)) {
    if (At(TokenKind::kEnd)) {
      if (Diagnostic* error = Error(DiagnosticKind::kBlockSyntax, Range(),
                                    "expected '}', found the end of the file")) {
        error->AddNote(open, "to close this '{'");
      }
      return nullptr;
    }
    if (Stmt* stmt = ParseStatement()) {
      block->body.push_back(stmt);
    } else {
      SkipStatement();
    }
  }
  ++at_;
  return block;
}

// Reads the part in parentheses again as mere tokens, after a mistake in it.
void Parser::SkipHeader(size_t open) {
  if (gave_up_) return;
  at_ = open;
  if (At(TokenKind::kLeftParen)) SkipBalanced();
}

Stmt* Parser::ParseIf() {
  Stmt* stmt = NewStmt(StmtKind::kIf);
  size_t open = ++at_;
  bool whole = Expect(TokenKind::kLeftParen, "after 'if'");
  stmt->value = whole ? ParseExpression() : nullptr;
  if (!stmt->value || !Expect(TokenKind::kRightParen, "after the condition")) SkipHeader(open);
  stmt->first = ParseStatement();
  if (!stmt->first) SkipStatement();
  if (Accept(TokenKind::kElse)) {
    stmt->second = ParseStatement();
    if (!stmt->second) SkipStatement();
  }
  return stmt;
}

Stmt* Parser::ParseFor() {
  Stmt* stmt = NewStmt(StmtKind::kFor);
  size_t open = ++at_;
  if (!ParseForHeader(*stmt)) SkipHeader(open);
  stmt->first = ParseStatement();
  if (!stmt->first) SkipStatement();
  return stmt;
}

bool Parser::ParseForHeader(Stmt& stmt) {
  if (!Expect(TokenKind::kLeftParen, "after 'for'")) return false;
  if (!AtDeclaration()) {
    Error(DiagnosticKind::kBlockSubset, Range(),
          "a loop makes its own index: 'for (int i = 0; i < n; i++)'");
    return false;
  }
  stmt.init = ParseDeclare();
  if (!stmt.init || !Expect(TokenKind::kSemicolon, "after the loop's index")) return false;
  stmt.value = ParseExpression();
  if (!stmt.value || !Expect(TokenKind::kSemicolon, "after the loop's condition")) return false;
  stmt.step = ParseAssignOrCall();
  return stmt.step && Expect(TokenKind::kRightParen, "after the loop's step");
}

Stmt* Parser::ParseReturn() {
  Stmt* stmt = NewStmt(StmtKind::kReturn);
  ++at_;
  if (!At(TokenKind::kSemicolon)) {
    stmt->value = ParseExpression();
    if (!stmt->value) return nullptr;
  }
  return Expect(TokenKind::kSemicolon, "after 'return'") ? stmt : nullptr;
}

Stmt* Parser::ParseDeclare() {
  Stmt* stmt = NewStmt(StmtKind::kDeclare);
  stmt->is_const = Accept(TokenKind::kConst);
  TypeName type;
  if (RefusedQualifier() || !ParseType(type)) return nullptr;
  return ParseDeclarators(type, stmt->declarators) ? stmt : nullptr;
}

Stmt* Parser::ParseAssignOrCall() {
  Stmt* stmt = NewStmt(StmtKind::kAssign);
  if (IsStep(Kind())) {
    stmt->op = Kind();
    ++at_;
    stmt->target = ParsePostfix();
    if (stmt->target) stmt->range = RangeFrom(stmt->range.begin);
    return stmt->target ? stmt : nullptr;
  }
  stmt->target = ParseExpression();
  if (!stmt->target) return nullptr;
  if (IsStep(Kind())) {
    stmt->op = Kind();
    ++at_;
  } else if (IsAssignment(Kind())) {
    stmt->op = Kind();
    ++at_;
    stmt->value = ParseExpression();
    if (!stmt->value) return nullptr;
    if (IsAssignment(Kind())) {
      Error(DiagnosticKind::kBlockSubset, Range(), "assign one variable in each statement");
      return nullptr;
    }
  } else if (stmt->target->kind == ExprKind::kCall) {
    stmt->kind = StmtKind::kCall;
    stmt->value = stmt->target;
  } else if (At(TokenKind::kSemicolon)) {
    Error(DiagnosticKind::kBlockSyntax, stmt->target->range, "this statement does nothing");
    return nullptr;
  } else {
    Error(DiagnosticKind::kBlockSyntax, Range(), "expected a statement's '=' or ';', " + Seen());
    return nullptr;
  }
  stmt->range = RangeFrom(stmt->range.begin);
  return stmt;
}

}  // namespace texgraph::blocks
