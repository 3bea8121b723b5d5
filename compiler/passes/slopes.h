// SPDX-License-Identifier: Apache-2.0
// Changes over one pixel, and those that are still sums of products: a slope times the change of
// what the value came from. Slopes are the same in x and in y, so that Differentiate makes them
// once for both. Sums and products of values hand them on.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "compiler/ir/builder.h"

namespace texgraph::passes {

// The change over one pixel in x and in y; invalid: zero.
struct Change {
  ir::ValueId dx, dy;
  ir::ValueId& operator[](int axis) { return axis ? dy : dx; }
  ir::ValueId operator[](int axis) const { return axis ? dy : dx; }
  bool operator==(const Change&) const = default;
};

struct Slopes {
  struct Term {
    ir::ValueId slope;  // of the change's type
    Change from;
  };
  std::vector<Term> terms;  // none: no change
  bool linear = true;       // the slopes do not depend on what the value came from
};

// Whether the operation is a sum or a product, of floats in the cases that matter. Rules with
// quotients stay out, for their slopes may be infinite where the changes are not.
bool IsPolynomial(ir::Op op);

// The slopes of r = op(x...), a polynomial one of floats, from those of its operands. nullopt where
// they are no less work than the changes themselves: they come from more than two values, or from
// two without anything in common.
std::optional<Slopes> DeriveSlopes(ir::Builder& builder, ir::Op op, std::span<const ir::ValueId> x,
                                   std::span<const Slopes> operands, ir::ValueId r);

// The change along one axis: the sum of the products.
ir::ValueId Multiply(ir::Builder& builder, const Slopes& slopes, int axis);

}  // namespace texgraph::passes
