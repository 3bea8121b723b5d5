// SPDX-License-Identifier: Apache-2.0
// The leaves of a type are the vectors, scalars, matrices, arrays and samplers that it is made of, depth first: structs and
// tuples have one run of leaves for each element. Analyses keep one state for each leaf of a value.
#pragma once

#include <deque>
#include <string>
#include <vector>

#include "compiler/ir/builder.h"
#include "compiler/ir/module.h"

namespace texgraph::passes {

struct Leaf {
  ir::TypeId type;
  std::vector<uint32_t> path;  // element indices from the value down to the leaf
  std::string suffix;          // "_local" for Tile's member; empty for a value that is its own leaf
};

class Leaves {
 public:
  explicit Leaves(const ir::Types& types) : types_(types) {}

  uint32_t Count(ir::TypeId type);
  // The first leaf of element `index` of a struct or tuple; 0 for other aggregates, whose only leaf holds every element.
  uint32_t Offset(ir::TypeId aggregate, uint32_t index);
  const std::vector<Leaf>& Of(ir::TypeId type);

 private:
  void Collect(ir::TypeId type, Leaf prefix, std::vector<Leaf>& out);
  const ir::Types& types_;
  std::deque<std::vector<Leaf>> by_type_;  // references stay good while it grows
};

// Whether a leaf can have a derivative.
constexpr bool IsDifferentiable(ir::TypeId leaf) { return ir::IsFloat(leaf); }

}  // namespace texgraph::passes
