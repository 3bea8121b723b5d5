// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "compiler/blocks/check_body.h"

namespace texgraph::blocks {

using ir::Op;
using ir::TypeId;

bool BodyChecker::CheckArguments(const Expr& expr, std::vector<TypedId>& args) {
  bool sound = true;
  for (const Expr* arg : expr.args) {
    args.push_back(Check(*arg));
    if (!args.back()) {
      sound = false;
    } else if (TypeOf(args.back()) == ir::kVoid) {
      Error(DiagnosticKind::kBlockType, arg->range, "this has no value");
      sound = false;
    }
  }
  return sound;
}

TypedId BodyChecker::CheckConstructor(const Expr& expr, TypeId type) {
  std::vector<TypedId> args;
  if (!type || !CheckArguments(expr, args)) return {};
  if (ir::IsSampler(type) || type == ir::kVoid) {
    Error(DiagnosticKind::kBlockType, expr.range, "a " + Text(type) + " cannot be made");
    return {};
  }
  if (!ir::IsVector(type) && !ir::IsMatrix(type)) return ConstructElements(expr, type, args);
  if (args.empty()) {
    Error(DiagnosticKind::kBlockType, expr.range, Text(type) + " needs at least one value");
    return {};
  }
  if (ir::IsMatrix(type)) return ConstructMatrix(expr, type, args);
  if (ir::IsScalar(type)) {
    if (args.size() == 1) return ConstructScalar(expr, type, args[0]);
    Error(DiagnosticKind::kBlockType, expr.range,
          Text(type) + " takes one value, got " + std::to_string(args.size()));
    return {};
  }
  return ConstructVector(expr, type, args);
}

// The first component of anything made of numbers.
TypedId BodyChecker::ConstructScalar(const Expr& expr, TypeId type, TypedId arg) {
  if (ir::IsMatrix(TypeOf(arg))) arg = ElementOf(arg, 0);
  if (!ir::IsVector(TypeOf(arg))) {
    Error(DiagnosticKind::kBlockType, expr.range,
          Text(type) + " cannot be made of " + Text(TypeOf(arg)));
    return {};
  }
  return ConvertTo(ElementOf(arg, 0), type);
}

// Replaces matrices by their columns; what is left must be vectors and scalars.
bool BodyChecker::Flatten(const Expr& expr, std::vector<TypedId>& args) {
  std::vector<TypedId> parts;
  for (TypedId arg : args) {
    TypeId type = TypeOf(arg);
    if (ir::IsMatrix(type)) {
      for (uint32_t i = 0; i < ir::MatrixSize(type); ++i) parts.push_back(ElementOf(arg, i));
    } else if (ir::IsVector(type)) {
      parts.push_back(arg);
    } else {
      Error(DiagnosticKind::kBlockType, RangeOf(arg),
            std::string(expr.name) + " cannot be made of " + Text(type));
      return false;
    }
  }
  args = std::move(parts);
  return true;
}

TypedId BodyChecker::ConstructVector(const Expr& expr, TypeId type, std::vector<TypedId>& args) {
  bool single = args.size() == 1;
  if (!Flatten(expr, args)) return {};
  TypeId scalar = ir::ScalarType(type);
  if (single && args.size() == 1 && ir::IsScalar(TypeOf(args[0]))) {
    return SplatTo(ConvertTo(args[0], scalar), type);
  }
  uint32_t width = ir::Width(type), seen = 0;
  std::vector<TypedId> parts;
  for (TypedId arg : args) {
    // The last argument may bring more than is needed; one that brings nothing is a mistake.
    if (seen == width && !single) {
      Error(DiagnosticKind::kBlockType, RangeOf(arg),
            Text(type) + " takes " + std::to_string(width) + " components; this is too much");
      return {};
    }
    if (seen == width) break;
    TypedId part = Prefix(arg, std::min(width - seen, ir::Width(TypeOf(arg))));
    seen += ir::Width(TypeOf(part));
    parts.push_back(ConvertTo(part, ir::WithWidth(type, ir::Width(TypeOf(part)))));
  }
  if (seen < width) {
    Error(DiagnosticKind::kBlockType, expr.range,
          Text(type) + " takes " + std::to_string(width) + " components, got " +
              std::to_string(seen));
    return {};
  }
  return parts.size() == 1 ? parts[0] : AddConstruct(type, parts, expr.range);
}

TypedId BodyChecker::ConstructMatrix(const Expr& expr, TypeId type, std::vector<TypedId>& args) {
  if (args.size() == 1 && ir::IsMatrix(TypeOf(args[0]))) {
    if (TypeOf(args[0]) == type) return args[0];
    return AddComposite(Composite::kResizeMatrix, type, args, expr.range);
  }
  uint32_t seen = 0, size = ir::MatrixSize(type);
  for (TypedId& arg : args) {
    if (!ir::IsVector(TypeOf(arg))) {
      Error(DiagnosticKind::kBlockType, RangeOf(arg),
            Text(type) + " cannot be made of " + Text(TypeOf(arg)) + " and more");
      return {};
    }
    arg = ConvertTo(arg, ir::Vector(ir::Scalar::kFloat, ir::Width(TypeOf(arg))));
    seen += ir::Width(TypeOf(arg));
  }
  if (args.size() == 1 && seen == 1) {
    return AddComposite(Composite::kDiagonal, type, args, expr.range);
  }
  if (seen != size * size) {
    Error(DiagnosticKind::kBlockType, expr.range,
          Text(type) + " takes one value or " + std::to_string(size * size) + ", got " +
              std::to_string(seen));
    return {};
  }
  return AddComposite(Composite::kMatrix, type, args, expr.range);
}

// Structs and arrays: one value for each member or element.
TypedId BodyChecker::ConstructElements(const Expr& expr, TypeId type,
                                       std::span<const TypedId> args) {
  uint32_t count = types_.ElementCount(type);
  if (args.size() != count) {
    Error(DiagnosticKind::kBlockType, expr.range,
          "'" + Text(type) + "' takes " + std::to_string(count) + " values, got " +
              std::to_string(args.size()));
    return {};
  }
  std::vector<TypedId> parts;
  const ir::Type& info = types_[type];
  for (uint32_t i = 0; i < count; ++i) {
    std::string what = info.kind == ir::TypeKind::kStruct ? "member '" + info.fields[i].name + "'"
                                                          : "element " + std::to_string(i);
    parts.push_back(Coerce(args[i], types_.ElementType(type, i), what));
  }
  return AddConstruct(type, parts, expr.range);
}

}  // namespace texgraph::blocks
