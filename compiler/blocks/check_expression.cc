// SPDX-License-Identifier: Apache-2.0
#include "compiler/blocks/check_body.h"
#include "compiler/blocks/lower.h"

namespace texgraph::blocks {

using ir::Op;
using ir::TypeId;

TypedId BodyChecker::Check(const Expr& expr) {
  switch (expr.kind) {
    case ExprKind::kLiteral:
      return CheckLiteral(expr);
    case ExprKind::kName:
      return CheckName(expr);
    case ExprKind::kUnary:
      return CheckUnary(expr);
    case ExprKind::kBinary:
      return CheckBinary(expr);
    case ExprKind::kChoose:
      return CheckChoose(expr);
    case ExprKind::kCall:
      return CheckCall(expr, false);
    case ExprKind::kMember:
      return CheckMember(expr);
    case ExprKind::kLength:
      return CheckLength(expr);
    case ExprKind::kIndex:
      return CheckIndex(expr);
  }
  return {};
}

TypedId BodyChecker::CheckLiteral(const Expr& expr) {
  switch (expr.op) {
    case TokenKind::kInt:
      return AddScalar(ir::kInt, expr.bits, expr.range);
    case TokenKind::kUint:
      return AddScalar(ir::kUint, expr.bits, expr.range);
    case TokenKind::kFloat:
      return AddScalar(ir::kFloat, expr.bits, expr.range);
    default:
      return AddScalar(ir::kBool, expr.bits, expr.range);
  }
}

TypedId BodyChecker::CheckName(const Expr& expr) {
  if (uint32_t slot = FindSlot(expr.name); slot != kNoSlot) {
    TypedExpr result;
    result.kind = TypedKind::kSlot;
    result.type = function_.slots[slot].type;
    result.aux = slot;
    return result.type ? Add(result, {}, expr.range) : TypedId();
  }
  const ConstantInfo* constant = nullptr;
  if (auto found = file_.constants.find(expr.name); found != file_.constants.end()) {
    if (anywhere_ || found->second.position < expr.range.begin) constant = &found->second;
  }
  const File* shared = program_.SharedFile();
  if (!constant && shared) {
    auto found = shared->constants.find(expr.name);
    if (found != shared->constants.end()) constant = &found->second;
  }
  if (constant) {
    if (!constant->value) return {};  // it is wrong, which was reported
    TypedExpr result;
    result.kind = TypedKind::kConstant;
    result.type = program_.module.constant(constant->value).type;
    result.aux = constant->value.index;
    return Add(result, {}, expr.range);
  }
  std::string quoted = "'" + Printable(expr.name, 60) + "'";
  if (FindBuiltin(expr.name) || file_.functions_by_name.contains(expr.name)) {
    Error(DiagnosticKind::kBlockName, expr.range, quoted + " is a function; call it with '(...)'");
    return {};
  }
  if (file_.constants.contains(expr.name)) {
    Error(DiagnosticKind::kBlockName, expr.range, quoted + " is declared below; move it up");
    return {};
  }
  std::vector<std::string_view> known;
  for (const auto& [name, slot] : names_) known.push_back(name);
  for (const auto& [name, info] : file_.constants) known.push_back(name);
  if (shared) {
    for (const auto& [name, info] : shared->constants) known.push_back(name);
  }
  Error(DiagnosticKind::kBlockName, expr.range,
        "there is no " + quoted + " here" + DidYouMean(expr.name, known));
  return {};
}

TypedId BodyChecker::CheckChoose(const Expr& expr) {
  TypedId condition = CheckAs(*expr.args[0], ir::kBool, "the condition");
  TypedId a = Check(*expr.args[1]);
  TypedId b = Check(*expr.args[2]);
  if (!condition || !a || !b) return {};
  Unify(a, b);
  if (TypeOf(a) != TypeOf(b)) {
    Error(DiagnosticKind::kBlockType, expr.range,
          "the two values of '?' are " + Text(TypeOf(a)) + " and " + Text(TypeOf(b)));
    return {};
  }
  if (ir::IsSampler(TypeOf(a)) || TypeOf(a) == ir::kVoid || IsUnsized(types_, TypeOf(a))) {
    Error(DiagnosticKind::kBlockType, expr.range,
          "'?' cannot choose between values of type " + Text(TypeOf(a)));
    return {};
  }
  TypedExpr result;
  result.kind = TypedKind::kChoose;
  result.type = TypeOf(a);
  return Add(result, {{condition, a, b}}, expr.range);
}

// --- Parts
// -------------------------------------------------------------------------------------------------------

std::optional<uint32_t> BodyChecker::SwizzleMask(const Expr& expr, TypeId type) {
  constexpr std::string_view kSets[] = {"xyzw", "rgba", "stpq"};
  std::string quoted = "'" + Printable(expr.name, 40) + "'";
  if (!ir::IsVector(type)) {
    Error(DiagnosticKind::kBlockType, expr.name_range, Text(type) + " has no member " + quoted);
    return std::nullopt;
  }
  uint32_t width = ir::Width(type);
  for (std::string_view set : kSets) {
    if (set.find(expr.name[0]) == std::string_view::npos) continue;
    uint32_t mask = 0;
    bool fits = expr.name.size() <= 4;
    for (size_t i = 0; fits && i < expr.name.size(); ++i) {
      size_t component = set.find(expr.name[i]);
      fits = component < width;
      mask |= static_cast<uint32_t>(component) << (2 * i);
    }
    if (fits) return mask;
  }
  Error(DiagnosticKind::kBlockType, expr.name_range,
        Text(type) + " has no components " + quoted + "; it has '" +
            std::string(kSets[0].substr(0, width)) + "'");
  return std::nullopt;
}

std::optional<uint32_t> BodyChecker::MemberIndex(const Expr& expr, TypeId type) {
  const std::vector<ir::StructField>& fields = types_[type].fields;
  std::vector<std::string_view> names;
  for (uint32_t i = 0; i < fields.size(); ++i) {
    if (fields[i].name == expr.name) return i;
    names.push_back(fields[i].name);
  }
  Error(DiagnosticKind::kBlockType, expr.name_range,
        "'" + Text(type) + "' has no member '" + Printable(expr.name, 60) + "'" +
            DidYouMean(expr.name, names));
  return std::nullopt;
}

TypedId BodyChecker::CheckMember(const Expr& expr) {
  TypedId base = Check(*expr.args[0]);
  if (!base) return {};
  TypeId type = TypeOf(base);
  if (types_.Kind(type) == ir::TypeKind::kStruct) {
    std::optional<uint32_t> index = MemberIndex(expr, type);
    if (!index) return {};
    return AddOp(Op::kExtract, types_.ElementType(type, *index), {base}, expr.range, *index);
  }
  std::optional<uint32_t> mask = SwizzleMask(expr, type);
  if (!mask) return {};
  TypedExpr result;
  result.kind = TypedKind::kSwizzle;
  result.type = ir::WithWidth(type, static_cast<uint32_t>(expr.name.size()));
  result.aux = *mask;
  return Add(result, {{base}}, expr.range);
}

TypedId BodyChecker::CheckElementIndex(const Expr& index, TypeId aggregate,
                                       std::optional<uint32_t>& constant) {
  ir::TypeKind kind = types_.Kind(aggregate);
  bool has_elements = kind == ir::TypeKind::kArray || kind == ir::TypeKind::kMatrix ||
                      (kind == ir::TypeKind::kVector && !ir::IsScalar(aggregate));
  if (!has_elements) {
    Error(DiagnosticKind::kBlockType, index.range, Text(aggregate) + " has no elements");
    return {};
  }
  TypedId value = Check(index);
  if (!value) return {};
  if (TypeOf(value) != ir::kInt && TypeOf(value) != ir::kUint) {
    Error(DiagnosticKind::kBlockType, index.range,
          "an index must be int, got " + Text(TypeOf(value)));
    return {};
  }
  ir::ConstId known = EvaluateConstant(program_.module, function_, value);
  if (!known) return value;
  // A negative one is large as well.
  uint32_t word = program_.module.Words(known)[0];
  if (IsUnsized(types_, aggregate)) return value;
  if (word >= types_.ElementCount(aggregate)) {
    Error(DiagnosticKind::kBlockType, index.range,
          "the index is outside of " + Text(aggregate) + ", whose last one is " +
              std::to_string(types_.ElementCount(aggregate) - 1));
    return {};
  }
  constant = word;
  return value;
}

TypedId BodyChecker::CheckIndex(const Expr& expr) {
  TypedId base = Check(*expr.args[0]);
  if (!base) return {};
  std::optional<uint32_t> constant;
  TypedId index = CheckElementIndex(*expr.args[1], TypeOf(base), constant);
  if (!index) return {};
  TypeId type = types_.ElementType(TypeOf(base), 0);
  if (constant) return AddOp(Op::kExtract, type, {base}, expr.range, *constant);
  return AddOp(Op::kIndex, type, {base, ConvertTo(index, ir::kInt)}, expr.range);
}

TypedId BodyChecker::CheckLength(const Expr& expr) {
  TypedId base = Check(*expr.args[0]);
  if (!base) return {};
  if (types_.Kind(TypeOf(base)) != ir::TypeKind::kArray) {
    Error(DiagnosticKind::kBlockType, expr.range,
          "only arrays have '.length()'; this is " + Text(TypeOf(base)));
    return {};
  }
  if (IsUnsized(types_, TypeOf(base))) {
    TypedExpr length;
    length.kind = TypedKind::kLength;
    length.type = ir::kInt;
    return Add(length, {{base}}, expr.range);
  }
  return AddScalar(ir::kInt, types_.ElementCount(TypeOf(base)), expr.range);
}

}  // namespace texgraph::blocks
