// SPDX-License-Identifier: Apache-2.0
// Functions and operators of GLSL that are several operations of the IR.
#include "compiler/blocks/lower_expression.h"

namespace texgraph::blocks {

using ir::Op;
using ir::TypeId;
using ir::ValueId;

ValueId ExpressionLowering::LowerComposite(const TypedExpr& expr, std::span<const ValueId> args) {
  switch (expr.composite) {
    case Composite::kByColumn:
      return ByColumn(expr, args);
    case Composite::kMatrix:
      return Matrix(expr.type, args);
    case Composite::kDiagonal:
      return Diagonal(expr.type, args[0]);
    case Composite::kResizeMatrix:
      return ResizeMatrix(expr.type, args[0]);
    case Composite::kAllEqual:
      return AllEqual(args[0], args[1]);
    case Composite::kRefract:
      return Refract(args[0], args[1], args[2]);
    case Composite::kFaceforward: {
      // faceforward(N, I, Nref)
      ValueId towards = builder_.Op2(Op::kDot, args[2], args[1]);
      ValueId facing = builder_.Op2(Op::kLt, towards, builder_.Float(0));
      return builder_.Op3(Op::kSelect, facing, args[0], builder_.Op1(Op::kNeg, args[0]));
    }
    case Composite::kOuterProduct:
      return OuterProduct(expr.type, args[0], args[1]);
    case Composite::kDeterminant:
      return Determinant(args[0]);
    case Composite::kInverse:
      return Inverse(args[0]);
    case Composite::kFootprint:
      return Footprint(args[0]);
    case Composite::kNone:
      break;
  }
  return {};
}

// Matrices are added, scaled and so on one column after the other.
ValueId ExpressionLowering::ByColumn(const TypedExpr& expr, std::span<const ValueId> args) {
  std::vector<ValueId> columns;
  for (uint32_t i = 0; i < ir::MatrixSize(expr.type); ++i) {
    auto part = [&](ValueId v) {
      return ir::IsMatrix(builder_.TypeOf(v)) ? builder_.Extract(v, i) : v;
    };
    columns.push_back(args.size() == 1 ? builder_.Op1(expr.op, part(args[0]))
                                       : builder_.Op2(expr.op, part(args[0]), part(args[1])));
  }
  return builder_.Construct(expr.type, columns);
}

ValueId ExpressionLowering::Matrix(TypeId type, std::span<const ValueId> parts) {
  std::vector<ValueId> columns;
  bool by_column = true;
  for (ValueId part : parts) by_column = by_column && builder_.TypeOf(part) == ir::ColumnType(type);
  if (by_column) return builder_.Construct(type, parts);
  std::vector<ValueId> components;
  for (ValueId part : parts) {
    for (uint32_t i = 0; i < ir::Width(builder_.TypeOf(part)); ++i) {
      components.push_back(builder_.Extract(part, i));
    }
  }
  uint32_t size = ir::MatrixSize(type);
  for (uint32_t i = 0; i < size; ++i) {
    columns.push_back(builder_.Construct(
        ir::ColumnType(type), std::span<const ValueId>(components).subspan(i * size, size)));
  }
  return builder_.Construct(type, columns);
}

ValueId ExpressionLowering::Diagonal(TypeId type, ValueId scalar) {
  uint32_t size = ir::MatrixSize(type);
  std::vector<ValueId> components(size * size, builder_.Float(0));
  for (uint32_t i = 0; i < size; ++i) components[i * size + i] = scalar;
  return Matrix(type, components);
}

ValueId ExpressionLowering::ResizeMatrix(TypeId type, ValueId matrix) {
  uint32_t size = ir::MatrixSize(type), old_size = ir::MatrixSize(builder_.TypeOf(matrix));
  std::vector<ValueId> components;
  for (uint32_t column = 0; column < size; ++column) {
    for (uint32_t row = 0; row < size; ++row) {
      bool inside = column < old_size && row < old_size;
      components.push_back(inside ? builder_.Extract(builder_.Extract(matrix, column), row)
                                  : builder_.Float(column == row ? 1.0f : 0.0f));
    }
  }
  return Matrix(type, components);
}

// Structs nest at most kMaxStructDepth deep, so this does not either.
ValueId ExpressionLowering::AllEqual(ValueId a, ValueId b) {
  TypeId type = builder_.TypeOf(a);
  if (ir::IsVector(type)) {
    ValueId same = builder_.Op2(Op::kEq, a, b);
    return ir::IsScalar(type) ? same : builder_.Op1(Op::kAll, same);
  }
  ValueId all;
  for (uint32_t i = 0; i < builder_.module().types.ElementCount(type); ++i) {
    ValueId same = AllEqual(builder_.Extract(a, i), builder_.Extract(b, i));
    all = all ? builder_.Op2(Op::kLogicalAnd, all, same) : same;
  }
  return all;
}

// The GLSL specification, chapter 8.5: k = 1 - eta^2 (1 - dot(N, I)^2); zero if k < 0, else eta I -
// (eta dot(N, I) + sqrt(k)) N.
ValueId ExpressionLowering::Refract(ValueId incident, ValueId normal, ValueId eta) {
  ir::Builder& b = builder_;
  ValueId cosine = b.Op2(Op::kDot, normal, incident);
  ValueId sine2 = b.Op2(Op::kSub, b.Float(1), b.Op2(Op::kMul, cosine, cosine));
  ValueId k = b.Op2(Op::kSub, b.Float(1), b.Op2(Op::kMul, b.Op2(Op::kMul, eta, eta), sine2));
  ValueId root = b.Op1(Op::kSqrt, b.Op2(Op::kMax, k, b.Float(0)));
  ValueId along = b.Op2(Op::kAdd, b.Op2(Op::kMul, eta, cosine), root);
  ValueId bent = b.Op2(Op::kSub, b.Op2(Op::kMul, eta, incident), b.Op2(Op::kMul, along, normal));
  return b.Op3(Op::kSelect, b.Op2(Op::kLt, k, b.Float(0)), b.Zero(b.TypeOf(bent)), bent);
}

ValueId ExpressionLowering::OuterProduct(TypeId type, ValueId column, ValueId row) {
  std::vector<ValueId> columns;
  for (uint32_t i = 0; i < ir::MatrixSize(type); ++i) {
    columns.push_back(builder_.Op2(Op::kMul, column, builder_.Extract(row, i)));
  }
  return builder_.Construct(type, columns);
}

// The determinant of what is left of a mat3 without that column and row, with the sign of its
// place.
ValueId ExpressionLowering::Minor(ValueId matrix, uint32_t column, uint32_t row) {
  auto at = [&](uint32_t c, uint32_t r) {
    return builder_.Extract(builder_.Extract(matrix, (column + c) % 3), (row + r) % 3);
  };
  // Counting on cyclically from the place gives the sign.
  return builder_.Op2(Op::kSub, builder_.Op2(Op::kMul, at(1, 1), at(2, 2)),
                      builder_.Op2(Op::kMul, at(1, 2), at(2, 1)));
}

ValueId ExpressionLowering::Determinant(ValueId matrix) {
  ir::Builder& b = builder_;
  auto at = [&](uint32_t c, uint32_t r) { return b.Extract(b.Extract(matrix, c), r); };
  if (b.TypeOf(matrix) == ir::kMat2) {
    return b.Op2(Op::kSub, b.Op2(Op::kMul, at(0, 0), at(1, 1)),
                 b.Op2(Op::kMul, at(0, 1), at(1, 0)));
  }
  ValueId sum;
  for (uint32_t row = 0; row < 3; ++row) {
    ValueId term = b.Op2(Op::kMul, at(0, row), Minor(matrix, 0, row));
    sum = sum ? b.Op2(Op::kAdd, sum, term) : term;
  }
  return sum;
}

// The adjugate over the determinant.
ValueId ExpressionLowering::Inverse(ValueId matrix) {
  ir::Builder& b = builder_;
  TypeId type = b.TypeOf(matrix);
  ValueId scale = b.Op2(Op::kDiv, b.Float(1), Determinant(matrix));
  std::vector<ValueId> components;
  if (type == ir::kMat2) {
    auto at = [&](uint32_t c, uint32_t r) { return b.Extract(b.Extract(matrix, c), r); };
    components = {at(1, 1), b.Op1(Op::kNeg, at(0, 1)), b.Op1(Op::kNeg, at(1, 0)), at(0, 0)};
  } else {
    for (uint32_t column = 0; column < 3; ++column) {
      for (uint32_t row = 0; row < 3; ++row) components.push_back(Minor(matrix, row, column));
    }
  }
  for (ValueId& component : components) component = b.Op2(Op::kMul, component, scale);
  return Matrix(type, components);
}

// The length, component by component, of the changes along the two directions of the screen.
ValueId ExpressionLowering::Footprint(ValueId value) {
  ValueId x = builder_.Op1(Op::kDx, value);
  ValueId y = builder_.Op1(Op::kDy, value);
  ValueId sum = builder_.Op2(Op::kAdd, builder_.Op2(Op::kMul, x, x), builder_.Op2(Op::kMul, y, y));
  return builder_.Op1(Op::kSqrt, sum);
}

}  // namespace texgraph::blocks
