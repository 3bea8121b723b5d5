// SPDX-License-Identifier: Apache-2.0
#include "compiler/passes/slopes.h"

#include "compiler/passes/pattern.h"

namespace texgraph::passes {

using ir::Op;
using ir::ValueId;

bool IsPolynomial(Op op) {
  return op == Op::kAdd || op == Op::kSub || op == Op::kMul || op == Op::kNeg || op == Op::kMix ||
         op == Op::kFma;
}

std::optional<Slopes> DeriveSlopes(ir::Builder& builder, Op op, std::span<const ValueId> x,
                                   std::span<const Slopes> operands, ValueId r) {
  std::vector<Change> sources;
  std::vector<std::vector<ValueId>> slopes;  // of each source, by operand
  size_t terms = 0, varying = 0;
  Slopes made;
  for (size_t i = 0; i < operands.size(); ++i) {
    made.linear = made.linear && operands[i].linear;
    varying += !operands[i].terms.empty();
    terms += operands[i].terms.size();
    for (const Slopes::Term& term : operands[i].terms) {
      size_t s = 0;
      while (s < sources.size() && sources[s] != term.from) ++s;
      if (s == 2) return std::nullopt;
      if (s == sources.size()) {
        sources.push_back(term.from);
        slopes.emplace_back(operands.size());
      }
      slopes[s][i] = term.slope;
    }
  }
  if (sources.size() == 2 && terms == 2) return std::nullopt;
  made.linear = made.linear && (varying == 1 || op == Op::kAdd || op == Op::kSub);
  for (size_t s = 0; s < sources.size(); ++s) {
    std::optional<ValueId> slope = InstantiateDerivative(op, builder, x, slopes[s], r);
    if (slope && *slope) made.terms.push_back({*slope, sources[s]});
  }
  return made;
}

ValueId Multiply(ir::Builder& builder, const Slopes& slopes, int axis) {
  ValueId sum;
  for (const Slopes::Term& term : slopes.terms) {
    if (!term.from[axis]) continue;
    ValueId product = builder.Op2(Op::kMul, term.from[axis], term.slope);
    sum = sum ? builder.Op2(Op::kAdd, sum, product) : product;
  }
  return sum;
}

}  // namespace texgraph::passes
