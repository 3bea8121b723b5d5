// SPDX-License-Identifier: Apache-2.0
// The operations of the intermediate form, from ops.def, and what is known of each.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace texgraph::ir {

enum class Op : uint8_t {
#define OP(id, name, shape, glsl, cost, ulp, derivative) id,
#include "compiler/ir/ops.def"
#undef OP
};

// How the types of operands and result relate. T: one type throughout, width 1 to 4.
enum class OpShape : uint8_t {
  kLeaf,
  kNumeric,        // T... -> T, T float, int or uint; matrices for add, sub, mul, div and neg; abs and sign have no uint
  kInteger,        // T... -> T, T int or uint
  kFloating,       // T... -> T, T float
  kDotLike,        // T, T -> float
  kLengthLike,     // T -> float
  kMatrixProduct,  // matrix * matrix, matrix * column, row * matrix
  kMatrixUnary,    // matrix -> matrix
  kComparison,     // T, T -> bool of the same width, T any vector type
  kLogic,          // T... -> T, T bool
  kReduceBool,     // bool vector -> bool
  kTestFloat,      // T float -> bool of the same width
  kSelection,      // bool, or bool vector of T's width, then T, T -> T; with a plain bool T may be of any type
  kConversion,     // T -> U of the same width
  kSplatting,      // scalar -> vector, or float -> matrix
  kMaking,
  kTaking,
  kIndexing,       // vector, matrix or array, then int or uint -> element
  kSampling,       // -> vec4
  kTextureQuery,   // sampler, int -> ivec of the sampler's size
  kControl,
  kCalling,
};

struct OpInfo {
  std::string_view name;
  OpShape shape;
  std::string_view glsl;
  uint16_t cost;
  uint16_t ulp;
  std::string_view derivative;
};

const OpInfo& Info(Op op);
std::optional<Op> FindOp(std::string_view name);
inline constexpr int kOpCount = 0
#define OP(id, name, shape, glsl, cost, ulp, derivative) +1
#include "compiler/ir/ops.def"
#undef OP
    ;

}  // namespace texgraph::ir
