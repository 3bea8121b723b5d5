// SPDX-License-Identifier: Apache-2.0
// What each operation computes: the one definition behind constant folding and the CPU evaluator.
#pragma once

#include <cstdint>
#include <span>

#include "compiler/ir/op.h"
#include "compiler/ir/type.h"

namespace texgraph::ir {

// Values lie as words, word w of lane l at [w * lanes + l]; floats as their bits, bools as 0 or 1, aggregates word after word.
struct OpArguments {
  Op op;
  TypeId type;                                // of the result
  std::span<const TypeId> operand_types;
  std::span<const uint32_t* const> operands;
  uint32_t aux = 0;
  uint32_t lanes = 1;
};

// Computes one operation for all lanes into `result`, Types::Words(type) * lanes words. True if the operation is one of values
// alone; false, with nothing written, for leaves, control, calls, textures and derivatives.
bool EvaluateOp(const Types& types, const OpArguments& arguments, uint32_t* result);

// Whether folding this with these constants (lanes = 1) gives what every GPU would: no division of integers by zero, no shift
// beyond the width, no float out of an integer's range, no NaN or infinity among `result`'s floats.
bool MayFold(const Types& types, const OpArguments& arguments, const uint32_t* result);

}  // namespace texgraph::ir
