// SPDX-License-Identifier: Apache-2.0
#include "compiler/ir/op.h"

#include <algorithm>
#include <iterator>

namespace texgraph::ir {
namespace {

constexpr OpInfo kOps[] = {
#define OP(id, name, shape, glsl, cost, ulp, derivative) {name, OpShape::shape, glsl, cost, ulp, derivative},
#include "compiler/ir/ops.def"
#undef OP
};

}  // namespace

const OpInfo& Info(Op op) { return kOps[static_cast<size_t>(op)]; }

std::optional<Op> FindOp(std::string_view name) {
  auto found = std::find_if(std::begin(kOps), std::end(kOps),
                            [&](const OpInfo& info) { return info.name == name; });
  if (found == std::end(kOps)) return std::nullopt;
  return static_cast<Op>(found - std::begin(kOps));
}

}  // namespace texgraph::ir
