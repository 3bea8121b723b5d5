// SPDX-License-Identifier: Apache-2.0
// Random modules before and after Simplify: the same values, never more work, nothing left to do.
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "compiler/ir/evaluate.h"
#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"
#include "compiler/passes/simplify.h"
#include "tests/fuzz/random_module.h"

namespace texgraph::passes {
namespace {

constexpr uint32_t kLanes = 16;

// TEXGRAPH_FUZZ_SEEDS=100000 for a long run by hand.
uint32_t Seeds() {
  const char* text = std::getenv("TEXGRAPH_FUZZ_SEEDS");
  return text ? static_cast<uint32_t>(std::strtoul(text, nullptr, 10)) : 300;
}

bool IsNan(uint32_t word) { return (word & 0x7fffffffu) > 0x7f800000u; }

// Under kUnsignedZero, zeros of both signs are one.
bool Same(ir::TypeId type, uint32_t a, uint32_t b, RuleFlags allowed) {
  if (a == b) return true;
  if (!ir::IsFloat(type)) return false;
  if (IsNan(a) && IsNan(b)) return true;
  return (allowed & kUnsignedZero) != 0 && (a << 1) == 0 && (b << 1) == 0;
}

void ExpectSameResults(const ir::Module& before, const ir::Module& after, uint32_t seed, bool tame,
                       RuleFlags allowed) {
  std::vector<std::vector<uint32_t>> expected =
      Evaluate(before, before.main, fuzz::RandomInputs(before, seed, kLanes, tame));
  std::vector<std::vector<uint32_t>> actual =
      Evaluate(after, after.main, fuzz::RandomInputs(after, seed, kLanes, tame));
  ASSERT_EQ(expected.size(), actual.size());
  for (size_t r = 0; r < expected.size(); ++r) {
    ASSERT_EQ(expected[r].size(), actual[r].size());
    const ir::TypeId type = before[before.main].results[r].type;
    for (size_t i = 0; i < expected[r].size(); ++i) {
      ASSERT_TRUE(Same(type, expected[r][i], actual[r][i], allowed))
          << "result " << r << " word " << i << ": " << expected[r][i] << " became " << actual[r][i]
          << "\n"
          << ir::Print(before) << "\nbecame\n"
          << ir::Print(after);
    }
  }
}

struct Case {
  const char* name;
  fuzz::RandomModuleOptions options;
  RuleFlags allowed;
};

class SimplifyRandom : public ::testing::TestWithParam<Case> {};

TEST_P(SimplifyRandom, SameValuesLessWorkNothingLeft) {
  const Case& c = GetParam();
  uint64_t cost_before = 0, cost_after = 0;
  for (uint32_t seed = 1; seed <= Seeds() && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ir::Module before = fuzz::RandomModule(seed, c.options);
    ASSERT_EQ(ir::Verify(before), "");
    ir::Module after = fuzz::RandomModule(seed, c.options);
    Simplify(after, c.allowed);
    ASSERT_EQ(ir::Verify(after), "") << ir::Print(before) << "\nbecame\n" << ir::Print(after);
    ExpectSameResults(before, after, seed, c.options.tame, c.allowed);
    ASSERT_LE(fuzz::CostOfMain(after), fuzz::CostOfMain(before));
    cost_before += fuzz::CostOfMain(before);
    cost_after += fuzz::CostOfMain(after);
    const std::string once = ir::Print(after);
    Simplify(after, c.allowed);
    ASSERT_EQ(ir::Print(after), once) << "not idempotent; before:\n" << ir::Print(before);
  }
  RecordProperty("cost", std::to_string(cost_before) + " -> " + std::to_string(cost_after));
  EXPECT_LT(cost_after, cost_before * 3 / 4) << "hardly anything is simplified";
}

constexpr Case kCases[] = {
    {"ExactRulesOnAnything", {.tame = false, .exact = false}, kExact},
    {"AllRulesOnTameValues", {}, kFinite | kUnsignedZero},
    {"StraightCode", {.functions = 0, .values = 80, .depth = 0}, kFinite | kUnsignedZero},
    {"ManyFunctions", {.functions = 12, .values = 10, .depth = 1}, kFinite | kUnsignedZero},
    {"DeepRegions", {.functions = 1, .values = 30, .depth = 5}, kFinite | kUnsignedZero},
    {"TexturesAndDerivatives", {.textures = true, .derivatives = true}, kFinite | kUnsignedZero},
};

INSTANTIATE_TEST_SUITE_P(Modules, SimplifyRandom, ::testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

// With every rule, values may differ by roundings; the other promises hold.
TEST(SimplifyRandomAllRules, LessWorkNothingLeft) {
  for (uint32_t seed = 1; seed <= Seeds(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    ir::Module module = fuzz::RandomModule(seed, {.exact = false});
    const uint64_t cost = fuzz::CostOfMain(module);
    Simplify(module);
    ASSERT_EQ(ir::Verify(module), "");
    ASSERT_LE(fuzz::CostOfMain(module), cost);
    const std::string once = ir::Print(module);
    Simplify(module);
    ASSERT_EQ(ir::Print(module), once);
  }
}

}  // namespace
}  // namespace texgraph::passes
