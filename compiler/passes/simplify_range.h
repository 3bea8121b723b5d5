// SPDX-License-Identifier: Apache-2.0
// What is known of a value from the few operations that made it.
#pragma once

#include "compiler/ir/builder.h"

namespace texgraph::passes {

// Every component lies from `low` to `high`, if no NaN is about. The bounds of floats are floats.
struct Range {
  double low;
  double high;
};

// `value` is a scalar or a vector of float, int, uint or bool. Looks at most four operations deep.
Range RangeOf(const ir::Builder& builder, ir::ValueId value);

// Whether every component of a float is a whole number, infinite or NaN.
bool IsIntegral(const ir::Builder& builder, ir::ValueId value);

}  // namespace texgraph::passes
