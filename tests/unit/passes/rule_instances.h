// SPDX-License-Identifier: Apache-2.0
// Typed instances of the patterns of the algebraic rules, built and evaluated without any of the
// passes, so that each rule can be tried on every type that it fits.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <random>
#include <vector>

#include "compiler/ir/builder.h"
#include "compiler/passes/pattern.h"

namespace texgraph::passes {

// What the text of a pattern leaves open.
struct Typing {
  std::array<ir::TypeId, kMaxVariables> variables;
  // By node: the result's type of conversions, splats and operations of literals alone.
  std::vector<ir::TypeId> nodes;
  ir::TypeId root;  // what the pattern makes
};

// Every well-typed choice of scalars and of vectors of three; mat2 and vec2 where it has matrices.
std::vector<Typing> TypingsOf(Pattern pattern);

// Builds the pattern literally: one Emit for each node, children first.
ir::ValueId Build(Pattern pattern, const Typing& typing, const Bindings& bindings,
                  ir::Builder& builder);
// All of it but the root: the root's operands.
std::vector<ir::ValueId> BuildOperands(Pattern pattern, const Typing& typing,
                                       const Bindings& bindings, ir::Builder& builder);

// Words that find mistakes: zeros, ones, ends of ranges, infinities, NaN, and random ones. Moderate
// floats lie between 1/100 and 10, either sign.
uint32_t AwkwardWord(ir::TypeId scalar, std::mt19937& random);
uint32_t ModerateWord(ir::TypeId scalar, std::mt19937& random);

// Values for the variables of a pattern: parameters, or what makes a variable pass its test.
// Constants come from `random`.
Bindings MakeVariables(Pattern pattern, const Typing& typing, ir::Builder& builder,
                       std::mt19937& random);

// The words of every value of a function of one region without calls, by ValueId, for `lanes`
// lanes. `parameters` are laid out as in ir::OpArguments.
std::vector<std::vector<uint32_t>> EvaluateAll(const ir::Module& module,
                                               const ir::Function& function,
                                               const std::vector<std::vector<uint32_t>>& parameters,
                                               uint32_t lanes);

}  // namespace texgraph::passes
