// SPDX-License-Identifier: Apache-2.0
// Checked expressions become operations. What slots and calls mean is for a derived class to say: a
// function knows them, a constant has none. An invalid value means that there is none, and makes
// all that needs it invalid.
#pragma once

#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "compiler/blocks/typed.h"
#include "compiler/ir/builder.h"

namespace texgraph::blocks {

class ExpressionLowering {
 public:
  // `depth` counts the recursion; beyond kMaxLoweringDepth there are no values.
  ExpressionLowering(ir::Builder& builder, const TypedFunction& function, uint32_t& depth)
      : builder_(builder), function_(function), depth_(depth) {}
  virtual ~ExpressionLowering() = default;

  ir::ValueId Lower(TypedId id);
  // The value as a constant, also where the builder does not fold.
  ir::ConstId Known(ir::ValueId value);

 protected:
  virtual ir::ValueId Slot(uint32_t slot) = 0;
  virtual ir::ValueId Call(const TypedExpr& expr, std::span<const ir::ValueId> arguments) = 0;
  virtual ir::ValueId CallField(const TypedExpr& expr, std::span<const ir::ValueId> arguments) = 0;
  virtual void TooDeep(const TypedExpr& expr) = 0;
  // The index of `expr` is known, and not one of `aggregate`'s.
  virtual void OutOfRange(const TypedExpr& expr, ir::TypeId aggregate) = 0;

  std::optional<bool> KnownBool(ir::ValueId value);
  // Says what an instruction's value is, where folding was done elsewhere.
  void SetKnown(ir::ValueId value, ir::ConstId constant) { known_[value] = constant; }

  ir::Builder& builder_;
  const TypedFunction& function_;
  uint32_t& depth_;

 private:
  ir::ValueId LowerWhole(const TypedExpr& expr);
  ir::ValueId LowerIndex(const TypedExpr& expr, std::span<const ir::ValueId> args);
  ir::ValueId LowerSwizzle(const TypedExpr& expr, ir::ValueId vector);
  ir::ValueId LowerChoose(const TypedExpr& expr);
  bool IsCheap(TypedId id) const;
  void Learn(ir::ValueId value);

  // lower_composite.cc
  ir::ValueId LowerComposite(const TypedExpr& expr, std::span<const ir::ValueId> args);
  ir::ValueId ByColumn(const TypedExpr& expr, std::span<const ir::ValueId> args);
  ir::ValueId Matrix(ir::TypeId type, std::span<const ir::ValueId> parts);
  ir::ValueId Diagonal(ir::TypeId type, ir::ValueId scalar);
  ir::ValueId ResizeMatrix(ir::TypeId type, ir::ValueId matrix);
  ir::ValueId AllEqual(ir::ValueId a, ir::ValueId b);
  ir::ValueId Refract(ir::ValueId incident, ir::ValueId normal, ir::ValueId eta);
  ir::ValueId OuterProduct(ir::TypeId type, ir::ValueId column, ir::ValueId row);
  ir::ValueId Minor(ir::ValueId matrix, uint32_t column, uint32_t row);
  ir::ValueId Determinant(ir::ValueId matrix);
  ir::ValueId Inverse(ir::ValueId matrix);
  ir::ValueId Footprint(ir::ValueId value);

  std::unordered_map<ir::ValueId, ir::ConstId> known_;  // only where the builder does not fold
  uint32_t learned_ = 0;  // instructions that were looked at for known_
};

}  // namespace texgraph::blocks
