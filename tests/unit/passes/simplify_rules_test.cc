// SPDX-License-Identifier: Apache-2.0
// Every rule of the tables, in every order of its operands and on every type that it fits: the same
// value on both sides, it really applies, and it never costs more.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "compiler/passes/rules.h"
#include "tests/unit/passes/rule_instances.h"

namespace texgraph::passes {
namespace {

using ir::Op;
using ir::TypeId;
using ir::ValueId;

constexpr uint32_t kLanes = 512;

bool IsSampling(const Rule& rule) { return rule.pattern.starts_with("(sample"); }

// The rule's name, its pattern's order and the types, for messages.
std::string Describe(const RuleVariant& variant, const Typing& typing, const ir::Types& types) {
  std::string text(variant.rule->name);
  text += " ";
  text += variant.rule->pattern;
  for (size_t i = 0; i < kMaxVariables; ++i) {
    if (typing.variables[i])
      text += std::string(" ") + char('a' + i) + ":" + types.Text(typing.variables[i]);
  }
  return text + " -> " + types.Text(typing.root);
}

// The typings that the rule is for.
std::vector<Typing> FittingTypings(const RuleVariant& variant) {
  std::vector<Typing> fitting;
  for (const Typing& typing : TypingsOf(variant.pattern)) {
    ir::Module module;
    ir::Function function;
    ir::Builder builder(module, function, {.fold = false});
    std::mt19937 random(1);
    Bindings bindings = MakeVariables(variant.pattern, typing, builder, random);
    std::vector<ValueId> operands = BuildOperands(variant.pattern, typing, bindings, builder);
    TypeId subject = builder.TypeOf(operands[variant.pattern.back().op == Op::kSelect ? 1 : 0]);
    bool passes = Fits(variant.rule->types, subject);
    for (const PatternNode& node : variant.pattern) {
      if (node.kind != PatternNode::Kind::kVariable) continue;
      passes = passes && Passes(node.test, builder, bindings.values[node.variable]);
    }
    if (passes) fitting.push_back(typing);
  }
  return fitting;
}

float AsFloat(uint32_t word) { return std::bit_cast<float>(word); }

// The distance in units in the last place.
int64_t UlpsApart(float a, float b) {
  auto ordered = [](float x) {
    int32_t bits = std::bit_cast<int32_t>(x);
    return int64_t(bits < 0 ? int32_t(0x80000000) - bits : bits);
  };
  return std::abs(ordered(a) - ordered(b));
}

class Comparison {
 public:
  // Under `flags`, the rule's own as a rule.
  Comparison(const RuleVariant& variant, const Typing& typing, RuleFlags flags)
      : variant_(variant), typing_(typing), flags_(flags) {}

  // Builds both sides on constants from `random`, compares all lanes. The first difference, or "".
  std::string Run(std::mt19937& random) {
    ir::Module module;
    ir::Function function;
    ir::Builder builder(module, function, {.fold = false});
    const bool moderate = (flags_ & kRounding) != 0;
    Bindings bindings = MakeVariables(variant_.pattern, typing_, builder, random);
    ValueId left = Build(variant_.pattern, typing_, bindings, builder);
    const size_t left_size = function.insts.size();
    ValueId right = Instantiate(variant_.replacement, builder, bindings, typing_.root);
    if (builder.TypeOf(left) != builder.TypeOf(right)) return "another type";
    std::vector<std::vector<uint32_t>> parameters;
    for (const ir::Parameter& parameter : function.parameters) {
      TypeId scalar = ir::IsVector(parameter.type) ? ir::ScalarType(parameter.type) : ir::kFloat;
      std::vector<uint32_t> words(module.types.Words(parameter.type) * kLanes);
      for (uint32_t& word : words) word = (moderate ? ModerateWord : AwkwardWord)(scalar, random);
      parameters.push_back(words);
    }
    values_ = EvaluateAll(module, function, parameters, kLanes);
    for (uint32_t lane = 0; lane < kLanes; ++lane) {
      largest_ = 0;
      if ((flags_ & kFinite) != 0 && !AllFinite(module, function, left_size, lane)) continue;
      ++compared;
      for (size_t at = lane; at < values_[left.index].size(); at += kLanes) {
        uint32_t a = values_[left.index][at], b = values_[right.index][at];
        if (Agree(a, b)) continue;
        std::string operands;
        for (const auto& words : parameters) {
          for (size_t k = lane; k < words.size(); k += kLanes) {
            operands += " " + std::to_string(AsFloat(words[k])) + "/" + std::to_string(words[k]);
          }
        }
        return Describe(variant_, typing_, module.types) + ": " + std::to_string(AsFloat(a)) + "/" +
               std::to_string(a) + " became " + std::to_string(AsFloat(b)) + "/" +
               std::to_string(b) + " for" + operands;
      }
    }
    return "";
  }

  int compared = 0;
  bool tolerant = true;  // of the units in the last place that the operation may be off

 private:
  // No infinity and no NaN among the floats of the left side, constants and parameters included.
  bool AllFinite(const ir::Module& module, const ir::Function& function, size_t size,
                 uint32_t lane) {
    for (size_t i = 0; i < size; ++i) {
      if (!ir::IsFloat(function.insts[i].type)) continue;
      for (size_t at = lane; at < module.types.Words(function.insts[i].type) * kLanes;
           at += kLanes) {
        float value = AsFloat(values_[i][at]);
        if (!std::isfinite(value)) return false;
        largest_ = std::max(largest_, std::fabs(value));
      }
    }
    return true;
  }

  bool Agree(uint32_t a, uint32_t b) const {
    if (a == b) return true;
    if (!ir::IsFloat(typing_.root)) return false;
    float x = AsFloat(a), y = AsFloat(b);
    if (std::isnan(x) && std::isnan(y)) return true;
    if (x == 0 && y == 0) return (flags_ & kUnsignedZero) != 0;
    // An operation that is not exact is as good as any that is no farther from the truth.
    const uint16_t ulp = tolerant ? ir::Info(variant_.pattern.back().op).ulp : 0;
    if (ulp > 0 && std::isfinite(x) && std::isfinite(y) && UlpsApart(x, y) <= ulp) return true;
    if ((flags_ & kRounding) == 0) return false;
    return std::fabs(x - y) <= 0x1p-18f * largest_;
  }

  const RuleVariant& variant_;
  const Typing& typing_;
  RuleFlags flags_;
  std::vector<std::vector<uint32_t>> values_;
  float largest_ = 0;
};

void ExpectEqualSides(const RuleVariant& variant, uint32_t seed) {
  std::vector<Typing> typings = FittingTypings(variant);
  ASSERT_FALSE(typings.empty()) << variant.rule->name << ": no types fit " << variant.rule->pattern;
  std::mt19937 random(seed);
  for (const Typing& typing : typings) {
    Comparison comparison(variant, typing, variant.rule->flags);
    for (int round = 0; round < 8; ++round) {
      std::string difference = comparison.Run(random);
      EXPECT_EQ(difference, "");
      if (!difference.empty()) break;
    }
    EXPECT_GT(comparison.compared, 8) << variant.rule->name << ": hardly any value is finite";
  }
}

TEST(EveryRule, BothSidesAreEqual) {
  uint32_t seed = 0;
  for (const RuleVariant* each : AllVariants()) {
    const RuleVariant& variant = *each;
    if (!IsSampling(*variant.rule)) ExpectEqualSides(variant, ++seed);
  }
}

int CostOf(const ir::Inst& inst) {
  return ir::Info(inst.op).cost *
         (ir::IsVector(inst.type) ? static_cast<int>(ir::Width(inst.type)) : 1);
}

// Whether the rule is the first that applies. Then the operation becomes the replacement.
bool ApplyOnce(const RuleVariant& variant, const Typing& typing, std::mt19937& random) {
  const Rule& rule = *variant.rule;
  ir::Module module;
  ir::Function function;
  SimplifyRules rules(rule.flags);
  ir::Builder builder(module, function, {.fold = true, .rules = &rules});
  Bindings bindings = MakeVariables(variant.pattern, typing, builder, random);
  std::vector<ValueId> operands = BuildOperands(variant.pattern, typing, bindings, builder);
  const size_t before = function.insts.size();
  Bindings found;
  const Op op = variant.pattern.back().op;
  const RuleVariant* first = FirstMatch(builder, op, typing.root, operands, rule.flags, found);
  ValueId made = builder.Emit(op, typing.root, operands);
  int cost = 0, operations = 0;
  for (size_t i = before; i < function.insts.size(); ++i) {
    cost += CostOf(function.insts[i]);
    operations += ir::Info(function.insts[i].op).cost > 0;
  }
  ir::Inst root{.op = op, .type = typing.root};
  EXPECT_LE(cost, CostOf(root)) << Describe(variant, typing, module.types);
  EXPECT_LE(operations, ir::Info(op).cost > 0) << Describe(variant, typing, module.types);
  if (first != &variant) return false;
  ValueId right = Instantiate(variant.replacement, builder, bindings, typing.root);
  EXPECT_EQ(made, right) << Describe(variant, typing, module.types);
  return made == right;
}

// For some type the rule is the first that applies; then the operation becomes the replacement, and
// what is added costs no more than the operation would have.
void ExpectToApply(const RuleVariant& variant) {
  const Rule& rule = *variant.rule;
  bool applied = false;
  std::mt19937 random(7);
  for (const Typing& typing : FittingTypings(variant)) {
    // Several constants: for some of them another rule comes first.
    for (int round = 0; round < 16; ++round) applied |= ApplyOnce(variant, typing, random);
  }
  EXPECT_TRUE(applied) << rule.name << " " << rule.pattern << " never applies";
}

TEST(EveryRule, AppliesAndCostsNoMore) {
  for (const RuleVariant* each : AllVariants()) {
    const RuleVariant& variant = *each;
    if (!IsSampling(*variant.rule)) ExpectToApply(variant);
  }
}

// Flags that no value can justify here: GPUs leave open what min and max make of NaN, ranges are
// known if there is none, and rules that round are compared on moderate values.
bool IsJustified(const RuleVariant& variant, RuleFlags flag) {
  const Rule& rule = *variant.rule;
  if (rule.name == "select_less" || rule.name == "select_greater") return true;
  for (const PatternNode& node : variant.pattern) {
    if (node.test == ValueTest::kNonnegative || node.test == ValueTest::kFloatInteger) return true;
  }
  return flag != kRounding && (rule.flags & kRounding) != 0;
}

// Without this one of the rule's flags, some value shows the difference.
bool ShowsDifference(const RuleVariant& variant, RuleFlags without) {
  std::mt19937 random(11);
  for (const Typing& typing : FittingTypings(variant)) {
    Comparison comparison(variant, typing, static_cast<RuleFlags>(variant.rule->flags & ~without));
    comparison.tolerant = without != kRounding;
    for (int round = 0; round < 8; ++round) {
      if (!comparison.Run(random).empty()) return true;
    }
  }
  return false;
}

TEST(EveryRule, FlagsAreNeeded) {
  for (const Rule& rule : AllRules()) {
    for (RuleFlags flag : {kUnsignedZero, kFinite, kRounding}) {
      bool differs = (rule.flags & flag) == 0;
      for (const RuleVariant* each : AllVariants()) {
        const RuleVariant& variant = *each;
        if (differs || variant.rule != &rule) continue;
        differs = IsJustified(variant, flag) || ShowsDifference(variant, flag);
      }
      EXPECT_TRUE(differs) << rule.name << " is better than its flags say: " << int(flag);
    }
  }
}

TEST(RuleTables, NamesAreUnique) {
  std::set<std::string_view> names;
  for (const Rule& rule : AllRules()) EXPECT_TRUE(names.insert(rule.name).second) << rule.name;
}

// Ranges are known under the assumption that no NaN is about.
TEST(RuleTables, RulesThatAskForRangesAssumeFiniteValues) {
  for (const RuleVariant* each : AllVariants()) {
    const RuleVariant& variant = *each;
    for (const PatternNode& node : variant.pattern) {
      bool asks = node.test == ValueTest::kNonnegative || node.test == ValueTest::kFloatInteger;
      EXPECT_TRUE(!asks || (variant.rule->flags & kFinite) != 0) << variant.rule->name;
    }
  }
}

}  // namespace
}  // namespace texgraph::passes
