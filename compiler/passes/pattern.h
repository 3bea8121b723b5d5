// SPDX-License-Identifier: Apache-2.0
// The small language of the algebraic rules (rules_*.def) and of the derivative column of
// ir/ops.def: "(add (mul d0 x1) (mul x0 d1))".
//
// - (op p...): an operation of ops.def. A suffix names the scalar of its result: (convert.float a).
// - a b c d e f: variables of rules. One that occurs twice stands for one and the same value.
// - x0..x3 d0..d3 r: operands, their derivatives and the result, in derivative rules.
// - a.int, c:const: a variable whose scalar is int, one that passes a test (see ValueTest); a:unit.
// - 0 -1 0.5 1e-8: a literal, in every component of the type that its place needs.
// - true false: literals of bools. ones: an integer with every bit set. tiny: 1e-20.
//
// A pattern is parsed once; matching and instantiating allocate nothing and do not recurse.
// Malformed text aborts: the tables are part of the program.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/ir/builder.h"

namespace texgraph::passes {

// What a variable's value must be known to be. "Constant" is one that folds: its floats are zero or
// normal, for a GPU may take a subnormal number for zero.
enum class ValueTest : uint8_t {
  kAny,
  kConst,       // a constant
  kReciprocal,  // a float constant whose reciprocal is exact and folds: a power of two, or minus
                // one
  kNegative,    // a constant with every component below zero, but none the least int
  kWrapping,    // a uint constant at most 2^16 below 2^32: to add it is to subtract
  kPowerOfTwo,  // an integer constant, each component a power of two, above zero
  kShift,  // an integer constant from 0 to 15: two of them together still shift by less than 32
  kNonnegative,   // never below zero; it may be NaN
  kIntegral,      // a float that is a whole number, infinite or NaN
  kFloatInteger,  // an integer that a float can hold: at most 2^24 from zero
};

struct PatternNode {
  enum class Kind : uint8_t { kOp, kVariable, kLiteral };
  static constexpr uint8_t kAnyScalar = 0xff;

  Kind kind = Kind::kLiteral;
  ir::Op op = ir::Op::kConst;
  uint8_t operand_count = 0;
  uint8_t variable = 0;
  uint8_t scalar = kAnyScalar;  // ir::Scalar that the value must have, or that the operation makes
  ValueTest test = ValueTest::kAny;
  bool all_ones = false;  // of a literal
  float literal = 0;
};

// Operands before operations, in order; the root is last.
using Pattern = std::span<const PatternNode>;

std::vector<PatternNode> ParsePattern(std::string_view text);
// Appends the nodes to `pool`.
void ParsePattern(std::string_view text, std::vector<PatternNode>& pool);
// The operation at the root of a pattern that is one, without parsing the rest.
ir::Op RootOf(std::string_view text);

// Indices of variables: a..f and x0..x3 begin at 0, d0..d3 at 4, r is 8.
inline constexpr size_t kMaxVariables = 9;
struct Bindings {
  std::array<ir::ValueId, kMaxVariables> values;
};

// Whether the operation that is about to be made is an instance of `pattern`. With `signed_zero`,
// the literal 0 is +0 alone and -0 is -0 alone. `bindings` must be empty; its contents are
// unspecified after a failure.
bool Match(Pattern pattern, const ir::Builder& builder, ir::Op op, ir::TypeId type,
           std::span<const ir::ValueId> operands, bool signed_zero, Bindings& bindings);
// Whether `value` is known to pass the test. Tests of values look a few operations deep.
bool Passes(ValueTest test, const ir::Builder& builder, ir::ValueId value);

// Makes the value that `pattern` stands for, of type `type`: a scalar is splat if that is a vector.
ir::ValueId Instantiate(Pattern pattern, ir::Builder& builder, const Bindings& bindings,
                        ir::TypeId type);

// --- Derivatives ---------------------------------------------------------------------------------

enum class DerivativeKind : uint8_t {
  kZero,  // "0": the derivative is zero
  kRule,  // InstantiateDerivative makes it
  kCode,  // "code": differentiate.cc makes it
  kNone,  // "none": the result holds no float
};
DerivativeKind DerivativeOf(ir::Op op);

// The derivative of r = op(x...) in r's type, where the derivatives of x are `d`: an invalid or
// missing one is zero, and no value is made for what it vanishes from. nullopt: the derivative is
// zero. `op` is of kind kRule or kZero; the x that a rule does not name may be invalid.
std::optional<ir::ValueId> InstantiateDerivative(ir::Op op, ir::Builder& builder,
                                                 std::span<const ir::ValueId> x,
                                                 std::span<const ir::ValueId> d, ir::ValueId r);

}  // namespace texgraph::passes
