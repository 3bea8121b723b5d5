// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "compiler/blocks/check_body.h"

namespace texgraph::blocks {
namespace {

using ir::TypeId;

// "+=" is "+"; an invalid kind for "=".
TokenKind OperatorOf(TokenKind assignment) {
  switch (assignment) {
    case TokenKind::kAddAssign:
    case TokenKind::kIncrement:
      return TokenKind::kAdd;
    case TokenKind::kSubAssign:
    case TokenKind::kDecrement:
      return TokenKind::kSub;
    case TokenKind::kMulAssign:
      return TokenKind::kMul;
    case TokenKind::kDivAssign:
      return TokenKind::kDiv;
    case TokenKind::kModAssign:
      return TokenKind::kMod;
    case TokenKind::kAndAssign:
      return TokenKind::kAnd;
    case TokenKind::kOrAssign:
      return TokenKind::kOr;
    case TokenKind::kXorAssign:
      return TokenKind::kXor;
    case TokenKind::kShlAssign:
      return TokenKind::kShl;
    case TokenKind::kShrAssign:
      return TokenKind::kShr;
    default:
      return TokenKind::kEnd;
  }
}

bool Returns(const std::vector<TypedStmt>& list) {
  return std::ranges::any_of(list, [](const TypedStmt& stmt) { return stmt.returns; });
}

bool Ends(const std::vector<TypedStmt>& list) {
  return std::ranges::any_of(list, [](const TypedStmt& stmt) { return stmt.ends; });
}

}  // namespace

void BodyChecker::CheckInto(const Stmt& stmt, Stmts& list) {
  Stmts* outer = list_;
  list_ = &list;
  switch (stmt.kind) {
    case StmtKind::kDeclare:
      CheckDeclare(stmt);
      break;
    case StmtKind::kAssign:
      CheckAssign(stmt);
      break;
    case StmtKind::kCall:
      CheckCallStatement(stmt);
      break;
    case StmtKind::kIf:
      CheckIf(stmt);
      break;
    case StmtKind::kFor:
      CheckFor(stmt);
      break;
    case StmtKind::kReturn:
      CheckReturn(stmt);
      break;
    case StmtKind::kBlock:
      OpenScope();
      for (const Stmt* inner : stmt.body) CheckInto(*inner, list);
      CloseScope();
      break;
  }
  list_ = outer;
}

void BodyChecker::CheckScoped(const Stmt* stmt, Stmts& list) {
  if (!stmt) return;
  OpenScope();
  CheckInto(*stmt, list);
  CloseScope();
}

TypedId BodyChecker::CheckWhole(const Expr& expr) {
  return expr.kind == ExprKind::kCall ? CheckCall(expr, true) : Check(expr);
}

// --- Declarations and assignments
// --------------------------------------------------------------------------------

void BodyChecker::CheckDeclare(const Stmt& stmt) {
  for (const Declarator& declarator : stmt.declarators) CheckDeclarator(declarator, stmt.is_const);
}

void BodyChecker::CheckDeclarator(const Declarator& declarator, bool is_const) {
  const Expr* value = declarator.value;
  uint32_t length = value && value->type ? static_cast<uint32_t>(value->args.size()) : 0;
  TypeId type = ResolveType(program_, file_, declarator.type, function_.gen_type, length);
  failed_ = failed_ || !type;
  if (type == ir::kVoid || (type && ir::IsSampler(type))) {
    Error(DiagnosticKind::kBlockType, declarator.type.range,
          "a variable cannot be a " + Text(type));
    type = {};
  }
  std::string quoted = "'" + std::string(declarator.name) + "'";
  TypedId result = value ? CheckWhole(*value) : TypedId();
  if (result) result = Coerce(result, type, "the value of " + quoted);
  Place place;
  place.slot = AddSlot(declarator.name, type, declarator.range, is_const);
  if (!value && is_const) {
    Error(DiagnosticKind::kBlockSyntax, declarator.range,
          "the constant " + quoted + " needs a value");
  }
  if (value && !result) return;
  Assign(std::move(place), result, declarator.range);
}

void BodyChecker::Assign(Place place, TypedId value, SourceRange range) {
  TypedStmt& stmt = list_->emplace_back();
  stmt.kind = TypedStmtKind::kAssign;
  stmt.value = value;
  stmt.range = range;
  function_.slots[place.slot].is_assigned = true;
  assigned_.push_back(place.slot);
  stmt.places.push_back(std::move(place));
}

void BodyChecker::CheckAssign(const Stmt& stmt) {
  TypeId type;
  std::optional<Place> place = CheckPlace(*stmt.target, type);
  TokenKind op = OperatorOf(stmt.op);
  TypedId value;
  if (op == TokenKind::kEnd) {
    value = CheckWhole(*stmt.value);
  } else {
    TypedId old = place ? Check(*stmt.target) : TypedId();
    if (stmt.value) {
      value = CheckWhole(*stmt.value);
    } else if (old) {
      bool numeric = ir::IsVector(type) && !ir::IsBool(type);
      TypeId one = numeric ? ir::ScalarType(type) : ir::kInt;
      value = AddScalar(one, one == ir::kFloat ? 0x3f800000u : 1u, stmt.range);
    }
    if (old && value) value = Binary(op, old, value, stmt.range);
  }
  if (!place || !value) return;
  value = Coerce(value, type, "what is assigned");
  if (value) Assign(std::move(*place), value, stmt.range);
}

void BodyChecker::CheckCallStatement(const Stmt& stmt) {
  size_t before = list_->size();
  TypedId call = CheckCall(*stmt.value, true);
  if (call && list_->size() == before) {
    Error(DiagnosticKind::kBlockSyntax, stmt.range,
          "this statement does nothing: the function has no out parameters");
  }
}

// What may be assigned to: a variable, or a part of one.
std::optional<Place> BodyChecker::CheckPlace(const Expr& expr, TypeId& type) {
  if (expr.kind == ExprKind::kMember || expr.kind == ExprKind::kIndex) {
    std::optional<Place> place = CheckPlace(*expr.args[0], type);
    if (!place) return std::nullopt;
    bool added = expr.kind == ExprKind::kMember ? AddMemberStep(expr, *place, type)
                                                : AddIndexStep(expr, *place, type);
    return added ? place : std::nullopt;
  }
  if (expr.kind != ExprKind::kName) {
    Error(DiagnosticKind::kBlockType, expr.range,
          "this is not a variable, so it cannot be assigned to");
    return std::nullopt;
  }
  uint32_t slot = FindSlot(expr.name);
  if (slot == kNoSlot) {
    if (!CheckName(expr)) return std::nullopt;
    Error(DiagnosticKind::kBlockType, expr.range,
          "'" + std::string(expr.name) + "' is a constant, so it cannot be assigned to");
    return std::nullopt;
  }
  type = function_.slots[slot].type;
  if (!type) return std::nullopt;
  if (function_.slots[slot].is_fixed || ir::IsSampler(type)) {
    Error(DiagnosticKind::kBlockType, expr.range,
          "'" + std::string(expr.name) + "' cannot be assigned to")
        .AddNote(function_.slots[slot].range, ir::IsSampler(type)
                                                  ? "it is a texture"
                                                  : "it is a constant or the index of a loop");
    return std::nullopt;
  }
  return Place{slot, {}};
}

bool BodyChecker::AddMemberStep(const Expr& expr, Place& place, TypeId& type) {
  using Kind = Place::Step::Kind;
  if (types_.Kind(type) == ir::TypeKind::kStruct) {
    std::optional<uint32_t> index = MemberIndex(expr, type);
    if (!index) return false;
    type = types_.ElementType(type, *index);
    place.steps.push_back({Kind::kElement, *index, {}, type});
    return true;
  }
  std::optional<uint32_t> mask = SwizzleMask(expr, type);
  if (!mask) return false;
  uint32_t width = static_cast<uint32_t>(expr.name.size());
  for (uint32_t i = 0, seen = 0; i < width; ++i) {
    uint32_t bit = 1u << (*mask >> (2 * i) & 3);
    if (seen & bit) {
      Error(DiagnosticKind::kBlockType, expr.name_range, "a component is assigned twice here");
      return false;
    }
    seen |= bit;
  }
  type = ir::WithWidth(type, width);
  if (width == 1) {
    place.steps.push_back({Kind::kElement, *mask & 3, {}, type});
  } else {
    place.steps.push_back({Kind::kSwizzle, *mask, {}, type});
  }
  return true;
}

bool BodyChecker::AddIndexStep(const Expr& expr, Place& place, TypeId& type) {
  using Kind = Place::Step::Kind;
  std::optional<uint32_t> constant;
  TypedId index = CheckElementIndex(*expr.args[1], type, constant);
  if (!index) return false;
  uint32_t count = types_.ElementCount(type);
  type = types_.ElementType(type, 0);
  if (constant) {
    place.steps.push_back({Kind::kElement, *constant, {}, type});
    return true;
  }
  if (count > kMaxComputedWrites) {
    Error(DiagnosticKind::kSizeLimit, expr.range,
          "only arrays of at most 64 elements can be written at a computed index");
    return false;
  }
  place.steps.push_back({Kind::kComputed, 0, index, type});
  return true;
}

// --- if, return
// --------------------------------------------------------------------------------------------------

void BodyChecker::CheckIf(const Stmt& stmt) {
  TypedStmt result;
  result.kind = TypedStmtKind::kIf;
  result.range = stmt.range;
  result.value = CheckAs(*stmt.value, ir::kBool, "the condition");
  CheckScoped(stmt.first, result.first);
  CheckScoped(stmt.second, result.second);
  result.returns = Returns(result.first) || Returns(result.second);
  result.ends = Ends(result.first) && Ends(result.second);
  list_->push_back(std::move(result));
}

void BodyChecker::CheckReturn(const Stmt& stmt) {
  TypedId value;
  std::string name = "'" + std::string(file_.functions[function_.function].ast->name) + "'";
  if (stmt.value) {
    value = CheckWhole(*stmt.value);
    if (value && signature_->result == ir::kVoid) {
      Error(DiagnosticKind::kBlockType, stmt.value->range, name + " returns no value");
      return;
    }
    value = Coerce(value, signature_->result, "what " + name + " returns");
  } else if (signature_->result != ir::kVoid) {
    Error(DiagnosticKind::kBlockType, stmt.range,
          name + " must return a " + Text(signature_->result));
  }
  if (loops_ > 0) {
    Error(DiagnosticKind::kBlockSubset, stmt.range,
          "a loop has no 'return'; keep the value in a variable and return it behind the loop");
  }
  TypedStmt& result = list_->emplace_back();
  result.kind = TypedStmtKind::kReturn;
  result.range = stmt.range;
  result.value = value;
  result.returns = result.ends = true;
}

// --- for
// ---------------------------------------------------------------------------------------------------------

void BodyChecker::CheckFor(const Stmt& stmt) {
  TypedStmt loop;
  loop.kind = TypedStmtKind::kFor;
  loop.range = stmt.range;
  OpenScope();
  uint32_t first_inner = static_cast<uint32_t>(function_.slots.size());
  bool sound = CheckIndex(stmt, loop) && CheckBound(stmt, loop) && CheckStep(stmt, loop);
  size_t mark = assigned_.size();
  ++loops_;
  if (stmt.first && stmt.first->kind == StmtKind::kBlock) {
    // The body's braces open no scope of their own in GLSL: the index cannot be declared again in
    // it.
    for (const Stmt* inner : stmt.first->body) CheckInto(*inner, loop.first);
  } else if (stmt.first) {
    CheckInto(*stmt.first, loop.first);
  }
  --loops_;
  CloseScope();
  if (!sound) return;
  for (size_t i = mark; i < assigned_.size(); ++i) {
    if (assigned_[i] < first_inner) loop.carried.push_back(assigned_[i]);
  }
  std::ranges::sort(loop.carried);
  auto repeated = std::ranges::unique(loop.carried);
  loop.carried.erase(repeated.begin(), repeated.end());
  list_->push_back(std::move(loop));
}

// int i = first
bool BodyChecker::CheckIndex(const Stmt& stmt, TypedStmt& loop) {
  const Declarator& index = stmt.init->declarators[0];
  bool is_int = index.type.name == "int" && !index.type.is_array;
  if (!is_int || stmt.init->declarators.size() != 1 || stmt.init->is_const) {
    Error(DiagnosticKind::kBlockSubset, stmt.init->range,
          "a loop has one index, an int: 'for (int i = 0; i < n; i++)'");
  } else if (!index.value) {
    Error(DiagnosticKind::kBlockSubset, index.range, "the loop's index needs its first value");
  } else {
    loop.value = CheckAs(*index.value, ir::kInt, "the index's first value");
  }
  // Known to the body whatever is wrong with it.
  loop.slot = AddSlot(index.name, ir::kInt, index.range, true);
  return loop.value.valid();
}

// i < last
bool BodyChecker::CheckBound(const Stmt& stmt, TypedStmt& loop) {
  const Expr& condition = *stmt.value;
  std::string_view name = stmt.init->declarators[0].name;
  bool names_index = condition.kind == ExprKind::kBinary &&
                     condition.args[0]->kind == ExprKind::kName && condition.args[0]->name == name;
  switch (names_index ? condition.op : TokenKind::kEnd) {
    case TokenKind::kLt:
      break;
    case TokenKind::kLe:
      loop.inclusive = true;
      break;
    case TokenKind::kGt:
      loop.downward = true;
      break;
    case TokenKind::kGe:
      loop.downward = loop.inclusive = true;
      break;
    default:
      Error(DiagnosticKind::kBlockSubset, condition.range,
            "a loop compares its index with a bound: '" + std::string(name) + " < n'");
      return false;
  }
  size_t mark = function_.exprs.size();
  loop.last = CheckAs(*condition.args[1], ir::kInt, "the loop's bound");
  for (size_t i = mark; i < function_.exprs.size(); ++i) {
    const TypedExpr& expr = function_.exprs[i];
    if (expr.kind != TypedKind::kSlot || expr.aux != loop.slot) continue;
    Error(DiagnosticKind::kBlockSubset, condition.args[1]->range,
          "the loop's bound cannot depend on the loop's index");
    return false;
  }
  return loop.last.valid();
}

// i++, i += step
bool BodyChecker::CheckStep(const Stmt& stmt, TypedStmt& loop) {
  const Stmt& step = *stmt.step;
  std::string_view name = stmt.init->declarators[0].name;
  bool names_index = step.kind == StmtKind::kAssign && step.target->kind == ExprKind::kName &&
                     step.target->name == name;
  TokenKind op = names_index ? OperatorOf(step.op) : TokenKind::kEnd;
  if (op != TokenKind::kAdd && op != TokenKind::kSub) {
    Error(DiagnosticKind::kBlockSubset, step.range,
          "a loop steps its index: '" + std::string(name) + "++' or '" + std::string(name) +
              " += 2'");
    return false;
  }
  loop.negated = op == TokenKind::kSub;
  loop.step = step.value ? CheckAs(*step.value, ir::kInt, "the loop's step")
                         : AddScalar(ir::kInt, 1, step.range);
  return loop.step.valid();
}

}  // namespace texgraph::blocks
