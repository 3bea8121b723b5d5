// SPDX-License-Identifier: Apache-2.0
// The algebraic rules: what simpler operation computes the same. Tables (rules_*.def) hold what the
// pattern language can say, split by operator:
//
//   RULE(name, "pattern", "replacement", flags, types)
//
// flags say what a rule does not preserve, and speak of floats: on integers and bools every rule is
// exact. types is the type of the first operand, of a select the second. Commuted forms of a
// pattern are made from it. No rule makes more operations or costlier ones than it replaces, even
// if the inner operations of its pattern have other uses. No sum or product of floats is regrouped.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/ir/builder.h"
#include "compiler/passes/pattern.h"

namespace texgraph::passes {

using RuleFlags = uint8_t;
inline constexpr RuleFlags kExact = 0;         // the same bits, always
inline constexpr RuleFlags kUnsignedZero = 1;  // may change the sign of a zero
inline constexpr RuleFlags kFinite = 2;    // only if no operand and no result is NaN or infinite
inline constexpr RuleFlags kRounding = 4;  // leaves out roundings: nearer to the true value
inline constexpr RuleFlags kAllRules = 7;

enum class RuleTypes : uint8_t {
  kAny,
  kNumeric,
  kSigned,
  kFloat,
  kScalarFloat,
  kInteger,
  kInt,
  kUint,
  kBool
};

struct Rule {
  std::string_view name;
  std::string_view pattern;
  std::string_view replacement;
  RuleFlags flags;
  RuleTypes types;
};

// The tables, in the order in which rules of one operation are tried.
std::span<const Rule> AllRules();
bool Fits(RuleTypes types, ir::TypeId type);

// A rule's pattern in one order of its operands.
struct RuleVariant {
  const Rule* rule;
  Pattern pattern;
  Pattern replacement;
};
std::vector<const RuleVariant*> AllVariants();
// The first one that applies to the operation that is about to be made; null if none does.
const RuleVariant* FirstMatch(const ir::Builder& builder, ir::Op op, ir::TypeId type,
                              std::span<const ir::ValueId> operands, RuleFlags allowed,
                              Bindings& bindings);

// Rules that the pattern language cannot say, in code: rules_structure.cc, rules_range.cc,
// rules_bits.cc.
struct CodeRule {
  std::string_view name;
  RuleFlags flags;
  // The simpler value, or an invalid id.
  ir::ValueId (*apply)(ir::Builder& builder, ir::Op op, ir::TypeId type,
                       std::span<const ir::ValueId> operands);
};
std::span<const CodeRule> StructureRules();
std::span<const CodeRule> RangeRules();
std::span<const CodeRule> BitRules();

// What Simplify gives its builders. One object serves one thread.
class SimplifyRules final : public ir::Rules {
 public:
  // Only rules whose flags are among `allowed`.
  explicit SimplifyRules(RuleFlags allowed = kAllRules) : allowed_(allowed) {}
  ir::ValueId Apply(ir::Builder& builder, ir::Op op, ir::TypeId type,
                    std::span<const ir::ValueId> operands, uint32_t aux) const override;

 private:
  RuleFlags allowed_;
  mutable int depth_ = 0;  // replacements that are being made
};

}  // namespace texgraph::passes
