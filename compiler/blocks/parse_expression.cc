// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "compiler/blocks/parse.h"

namespace texgraph::blocks {
namespace {

// How tightly a binary operator binds; 0 if it is none. From the GLSL specification, chapter 5.1.
int Precedence(TokenKind kind) {
  switch (kind) {
    case TokenKind::kMul:
    case TokenKind::kDiv:
    case TokenKind::kMod:
      return 11;
    case TokenKind::kAdd:
    case TokenKind::kSub:
      return 10;
    case TokenKind::kShl:
    case TokenKind::kShr:
      return 9;
    case TokenKind::kLt:
    case TokenKind::kGt:
    case TokenKind::kLe:
    case TokenKind::kGe:
      return 8;
    case TokenKind::kEq:
    case TokenKind::kNe:
      return 7;
    case TokenKind::kAnd:
      return 6;
    case TokenKind::kXor:
      return 5;
    case TokenKind::kOr:
      return 4;
    case TokenKind::kAndAnd:
      return 3;
    case TokenKind::kXorXor:
      return 2;
    case TokenKind::kOrOr:
      return 1;
    default:
      return 0;
  }
}

}  // namespace

Expr* Parser::NewExpr(ExprKind kind, uint32_t begin, std::initializer_list<Expr*> args) {
  Expr& expr = file_.exprs.emplace_back();
  expr.kind = kind;
  expr.args.assign(args);
  return Finish(&expr, begin);
}

// Sets what follows from the arguments and from the last token read.
Expr* Parser::Finish(Expr* expr, uint32_t begin) {
  expr->range = RangeFrom(begin);
  for (const Expr* arg : expr->args) {
    expr->depth = std::max(expr->depth, static_cast<uint16_t>(arg->depth + 1));
  }
  if (expr->depth <= kMaxNesting) return expr;
  GiveUp(expr->range, "this expression is nested too deeply; give its parts names");
  return nullptr;
}

Expr* Parser::ParseOnlyExpression() {
  Expr* expr = ParseExpression();
  if (!expr) return nullptr;
  if (At(TokenKind::kEnd)) return expr;
  Error(DiagnosticKind::kBlockSyntax, Range(), "expected one expression, " + Seen());
  return nullptr;
}

Expr* Parser::ParseExpression() {
  Level level(*this);
  if (!level) return nullptr;
  uint32_t begin = Now().begin;
  Expr* condition = ParseBinary(1);
  if (!condition || !At(TokenKind::kQuestion)) return condition;
  SourceRange range = Range();
  ++at_;
  Expr* on_true = ParseExpression();
  if (!on_true || !Expect(TokenKind::kColon, "between the two values of '?'")) return nullptr;
  Expr* on_false = ParseExpression();
  if (!on_false) return nullptr;
  Expr* expr = NewExpr(ExprKind::kChoose, begin, {condition, on_true, on_false});
  if (expr) expr->name_range = range;
  return expr;
}

Expr* Parser::ParseBinary(int least) {
  uint32_t begin = Now().begin;
  Expr* left = ParseUnary();
  while (left) {
    TokenKind op = Kind();
    int precedence = Precedence(op);
    if (precedence == 0 || precedence < least) return left;
    SourceRange range = Range();
    ++at_;
    Expr* right = ParseBinary(precedence + 1);
    if (!right) return nullptr;
    left = NewExpr(ExprKind::kBinary, begin, {left, right});
    if (!left) return nullptr;
    left->op = op;
    left->name_range = range;
  }
  return nullptr;
}

Expr* Parser::ParseUnary() {
  TokenKind op = Kind();
  if (op == TokenKind::kIncrement || op == TokenKind::kDecrement) {
    Error(DiagnosticKind::kBlockSubset, Range(),
          std::string(TokenText(op)) + " stands in a statement of its own");
    return nullptr;
  }
  bool is_unary = op == TokenKind::kAdd || op == TokenKind::kSub || op == TokenKind::kNot ||
                  op == TokenKind::kTilde;
  if (!is_unary) return ParsePostfix();
  Level level(*this);
  if (!level) return nullptr;
  SourceRange range = Range();
  ++at_;
  Expr* operand = ParseUnary();
  if (!operand) return nullptr;
  Expr* expr = NewExpr(ExprKind::kUnary, range.begin, {operand});
  if (!expr) return nullptr;
  expr->op = op;
  expr->name_range = range;
  return expr;
}

Expr* Parser::ParsePostfix() {
  Expr* expr = ParsePrimary();
  while (expr) {
    if (At(TokenKind::kDot)) {
      expr = ParseMember(expr);
    } else if (At(TokenKind::kLeftBracket)) {
      expr = ParseElement(expr);
    } else {
      return expr;
    }
  }
  return nullptr;
}

Expr* Parser::ParseMember(Expr* base) {
  ++at_;
  std::string_view name;
  SourceRange range;
  if (!ParseName("a member or components", name, range)) return nullptr;
  bool is_length = name == "length" && At(TokenKind::kLeftParen);
  if (is_length) {
    ++at_;
    if (!Expect(TokenKind::kRightParen, "after '.length('")) return nullptr;
  }
  Expr* expr =
      NewExpr(is_length ? ExprKind::kLength : ExprKind::kMember, base->range.begin, {base});
  if (!expr) return nullptr;
  expr->name = name;
  expr->name_range = range;
  return expr;
}

Expr* Parser::ParseElement(Expr* base) {
  ++at_;
  Expr* index = ParseExpression();
  if (!index || !Expect(TokenKind::kRightBracket, "after the index")) return nullptr;
  Expr* expr = NewExpr(ExprKind::kIndex, base->range.begin, {base, index});
  if (expr) expr->name_range = index->range;
  return expr;
}

// "float[4](", "Tile[]("
bool Parser::AtArrayConstructor() const {
  size_t ahead = 1;
  if (Kind(ahead) != TokenKind::kLeftBracket) return false;
  for (uint32_t depth = 0; Kind(ahead) != TokenKind::kEnd; ++ahead) {
    if (Kind(ahead) == TokenKind::kLeftBracket) ++depth;
    if (Kind(ahead) == TokenKind::kSemicolon) return false;
    if (Kind(ahead) == TokenKind::kRightBracket && --depth == 0) {
      return Kind(ahead + 1) == TokenKind::kLeftParen;
    }
  }
  return false;
}

Expr* Parser::ParsePrimary() {
  const Token token = Now();
  switch (token.kind) {
    case TokenKind::kInt:
    case TokenKind::kUint:
    case TokenKind::kFloat:
    case TokenKind::kTrue:
    case TokenKind::kFalse: {
      ++at_;
      Expr* expr = NewExpr(ExprKind::kLiteral, token.begin, {});
      expr->op = token.kind;
      expr->bits = token.kind == TokenKind::kTrue ? 1 : token.bits;
      return expr;
    }
    case TokenKind::kLeftParen: {
      ++at_;
      Expr* inner = ParseExpression();
      if (!inner || !Expect(TokenKind::kRightParen, "to close '('")) return nullptr;
      inner->range = RangeFrom(token.begin);
      return inner;
    }
    case TokenKind::kLeftBrace:
      Error(DiagnosticKind::kBlockSubset, Range(),
            "blocks have no lists in braces; write a constructor, as in 'float[2](0.0, 1.0)'");
      return nullptr;
    case TokenKind::kIdentifier:
      break;
    default:
      Error(DiagnosticKind::kBlockSyntax, Range(), "expected a value, " + Seen());
      return nullptr;
  }
  if (AtArrayConstructor()) {
    TypeName& type = file_.types.emplace_back();
    if (!ParseType(type)) return nullptr;
    return ParseCall(token.begin, &type);
  }
  ++at_;
  if (At(TokenKind::kLeftParen)) {
    --at_;
    return ParseCall(token.begin, nullptr);
  }
  Expr* expr = NewExpr(ExprKind::kName, token.begin, {});
  expr->name = Text(token);
  expr->name_range = expr->range;
  return expr;
}

// From the name, or behind the type of an array constructor.
Expr* Parser::ParseCall(uint32_t begin, TypeName* type) {
  Expr& expr = file_.exprs.emplace_back();
  expr.kind = ExprKind::kCall;
  expr.type = type;
  if (type) {
    expr.name = type->name;
    expr.name_range = type->range;
  } else {
    expr.name = Text();
    expr.name_range = Range();
    ++at_;
  }
  ++at_;  // the parenthesis
  if (At(TokenKind::kIdentifier) && Text() == "void" && Kind(1) == TokenKind::kRightParen) ++at_;
  if (Accept(TokenKind::kRightParen)) return Finish(&expr, begin);
  do {
    Expr* arg = ParseExpression();
    if (!arg) return nullptr;
    expr.args.push_back(arg);
  } while (Accept(TokenKind::kComma));
  if (!Expect(TokenKind::kRightParen, "or ',' after the argument")) return nullptr;
  return Finish(&expr, begin);
}

}  // namespace texgraph::blocks
