// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "compiler/blocks/check_body.h"

namespace texgraph::blocks {
namespace {

using ir::Op;
using ir::TypeId;

Op OpOf(TokenKind kind) {
  switch (kind) {
    case TokenKind::kAdd:
      return Op::kAdd;
    case TokenKind::kSub:
      return Op::kSub;
    case TokenKind::kMul:
      return Op::kMul;
    case TokenKind::kDiv:
      return Op::kDiv;
    case TokenKind::kMod:
      return Op::kMod;
    case TokenKind::kAnd:
      return Op::kAnd;
    case TokenKind::kOr:
      return Op::kOr;
    case TokenKind::kXor:
      return Op::kXor;
    case TokenKind::kShl:
      return Op::kShl;
    case TokenKind::kShr:
      return Op::kShr;
    case TokenKind::kAndAnd:
      return Op::kLogicalAnd;
    case TokenKind::kOrOr:
      return Op::kLogicalOr;
    default:
      return Op::kLogicalXor;
  }
}

// float over uint over int; -1 for what is no number.
int Rank(TypeId type) {
  if (ir::IsFloat(type)) return 2;
  if (!ir::IsInteger(type)) return -1;
  return ir::ScalarOf(type) == ir::Scalar::kUint ? 1 : 0;
}

}  // namespace

// Gives both the scalar kind of the higher one. False if one is no number.
bool BodyChecker::Unify(TypedId& a, TypedId& b) {
  int rank_a = Rank(TypeOf(a)), rank_b = Rank(TypeOf(b));
  if (rank_a < 0 || rank_b < 0) return false;
  if (rank_a == rank_b) return true;
  TypedId& lower = rank_a < rank_b ? a : b;
  ir::Scalar scalar = std::max(rank_a, rank_b) == 2 ? ir::Scalar::kFloat : ir::Scalar::kUint;
  // A matrix is of floats, so it is never the lower one.
  lower = ConvertTo(lower, ir::Vector(scalar, ir::Width(TypeOf(lower))));
  return true;
}

TypedId BodyChecker::NoOperator(TokenKind op, TypedId a, TypedId b, SourceRange range,
                                std::string_view advice) {
  std::string text = std::string(TokenText(op)) + " does not take " + Text(TypeOf(a));
  if (b) text += " and " + Text(TypeOf(b));
  Error(DiagnosticKind::kBlockType, range, text + std::string(advice));
  return {};
}

TypedId BodyChecker::CheckUnary(const Expr& expr) {
  TypedId operand = Check(*expr.args[0]);
  if (!operand) return {};
  TypeId type = TypeOf(operand);
  switch (expr.op) {
    case TokenKind::kAdd:
      if (Rank(type) >= 0) return operand;
      break;
    case TokenKind::kSub:
      if (ir::IsMatrix(type)) {
        return AddComposite(Composite::kByColumn, type, {{operand}}, expr.range, Op::kNeg);
      }
      if (Rank(type) >= 0) return AddOp(Op::kNeg, type, {operand}, expr.range);
      break;
    case TokenKind::kTilde:
      if (ir::IsInteger(type)) return AddOp(Op::kNot, type, {operand}, expr.range);
      break;
    default:
      if (type == ir::kBool) return AddOp(Op::kLogicalNot, type, {operand}, expr.range);
      if (ir::IsBool(type)) return NoOperator(expr.op, operand, {}, expr.range, "; use 'not'");
      break;
  }
  return NoOperator(expr.op, operand, {}, expr.range);
}

TypedId BodyChecker::CheckBinary(const Expr& expr) {
  TypedId a = Check(*expr.args[0]);
  TypedId b = Check(*expr.args[1]);
  return a && b ? Binary(expr.op, a, b, expr.range) : TypedId();
}

TypedId BodyChecker::Binary(TokenKind op, TypedId a, TypedId b, SourceRange range) {
  switch (op) {
    case TokenKind::kAdd:
    case TokenKind::kSub:
    case TokenKind::kMul:
    case TokenKind::kDiv:
    case TokenKind::kMod:
    case TokenKind::kAnd:
    case TokenKind::kOr:
    case TokenKind::kXor:
      return Arithmetic(op, a, b, range);
    case TokenKind::kShl:
    case TokenKind::kShr:
      return Shift(op, a, b, range);
    case TokenKind::kLt:
    case TokenKind::kLe:
    case TokenKind::kGt:
    case TokenKind::kGe:
      return Comparison(op, a, b, range);
    case TokenKind::kEq:
    case TokenKind::kNe:
      return Equality(op, a, b, range);
    default:
      return Logic(op, a, b, range);
  }
}

TypedId BodyChecker::Arithmetic(TokenKind op, TypedId a, TypedId b, SourceRange range) {
  bool integers_only = op == TokenKind::kMod || op == TokenKind::kAnd || op == TokenKind::kOr ||
                       op == TokenKind::kXor;
  if (ir::IsMatrix(TypeOf(a)) || ir::IsMatrix(TypeOf(b))) return MatrixArithmetic(op, a, b, range);
  TypedId left = a, right = b;
  if (!Unify(left, right)) return NoOperator(op, a, b, range);
  if (integers_only && ir::IsFloat(TypeOf(left))) {
    return NoOperator(op, a, b, range, op == TokenKind::kMod ? "; use 'mod'" : "");
  }
  uint32_t width = std::max(ir::Width(TypeOf(left)), ir::Width(TypeOf(right)));
  TypeId type = ir::WithWidth(TypeOf(left), width);
  for (TypedId* side : {&left, &right}) {
    if (ir::IsScalar(TypeOf(*side))) *side = SplatTo(*side, type);
    if (TypeOf(*side) != type) return NoOperator(op, a, b, range);
  }
  return AddOp(OpOf(op), type, {left, right}, range);
}

TypedId BodyChecker::MatrixArithmetic(TokenKind op, TypedId a, TypedId b, SourceRange range) {
  bool known = op == TokenKind::kAdd || op == TokenKind::kSub || op == TokenKind::kMul ||
               op == TokenKind::kDiv;
  TypedId left = a, right = b;
  if (!known || !Unify(left, right)) return NoOperator(op, a, b, range);
  TypeId left_type = TypeOf(left), right_type = TypeOf(right);
  TypeId matrix = ir::IsMatrix(left_type) ? left_type : right_type;
  TypeId column = ir::ColumnType(matrix);
  auto fits = [&](TypeId type) { return type == matrix || type == column; };
  if (op == TokenKind::kMul && fits(left_type) && fits(right_type)) {
    TypeId type = left_type == right_type ? matrix : column;
    return AddOp(Op::kMatMul, type, {left, right}, range);
  }
  auto by_column = [&](TypeId type) { return type == matrix || type == ir::kFloat; };
  if (!by_column(left_type) || !by_column(right_type)) return NoOperator(op, a, b, range);
  return AddComposite(Composite::kByColumn, matrix, {{left, right}}, range, OpOf(op));
}

// Both sides are integers, of either sign; the result is as the left one.
TypedId BodyChecker::Shift(TokenKind op, TypedId a, TypedId b, SourceRange range) {
  TypeId type = TypeOf(a), distance = TypeOf(b);
  bool fits = ir::IsInteger(type) && ir::IsInteger(distance) &&
              (ir::IsScalar(distance) || ir::Width(distance) == ir::Width(type));
  if (!fits) return NoOperator(op, a, b, range);
  b = SplatTo(ConvertTo(b, ir::WithWidth(type, ir::Width(distance))), type);
  return AddOp(OpOf(op), type, {a, b}, range);
}

TypedId BodyChecker::Logic(TokenKind op, TypedId a, TypedId b, SourceRange range) {
  if (TypeOf(a) != ir::kBool || TypeOf(b) != ir::kBool) return NoOperator(op, a, b, range);
  return AddOp(OpOf(op), ir::kBool, {a, b}, range);
}

TypedId BodyChecker::Comparison(TokenKind op, TypedId a, TypedId b, SourceRange range) {
  TypedId left = a, right = b;
  bool numbers = Unify(left, right);
  if (!numbers || !ir::IsScalar(TypeOf(left)) || !ir::IsScalar(TypeOf(right))) {
    return NoOperator(op, a, b, range, numbers ? "; use 'lessThan' and its kind" : "");
  }
  if (op == TokenKind::kGt || op == TokenKind::kGe) std::swap(left, right);
  bool strict = op == TokenKind::kLt || op == TokenKind::kGt;
  return AddOp(strict ? Op::kLt : Op::kLe, ir::kBool, {left, right}, range);
}

TypedId BodyChecker::Equality(TokenKind op, TypedId a, TypedId b, SourceRange range) {
  TypedId left = a, right = b;
  Unify(left, right);
  TypeId type = TypeOf(left);
  bool compares = type != ir::kVoid && !ir::IsSampler(type) && !IsUnsized(types_, type);
  if (type != TypeOf(right) || !compares) {
    return NoOperator(op, a, b, range);
  }
  bool equal = op == TokenKind::kEq;
  if (ir::IsVector(type)) {
    TypeId result = ir::Vector(ir::Scalar::kBool, ir::Width(type));
    TypedId same = AddOp(equal ? Op::kEq : Op::kNe, result, {left, right}, range);
    if (ir::IsScalar(type)) return same;
    return AddOp(equal ? Op::kAll : Op::kAny, ir::kBool, {same}, range);
  }
  TypedId same = AddComposite(Composite::kAllEqual, ir::kBool, {{left, right}}, range);
  return equal ? same : AddOp(Op::kLogicalNot, ir::kBool, {same}, range);
}

}  // namespace texgraph::blocks
