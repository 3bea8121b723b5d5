// SPDX-License-Identifier: Apache-2.0
// Random modules: they are well formed, read back as what they were, and give every quad the same
// whatever stands beside it.
#include "tests/fuzz/random_module.h"

#include <gtest/gtest.h>

#include <cstddef>

#include "compiler/ir/evaluate.h"
#include "compiler/ir/print.h"
#include "compiler/ir/verify.h"
#include "tests/unit/ir/module_text.h"

namespace texgraph::ir {
namespace {

constexpr uint32_t kSeeds = 60;
constexpr uint32_t kLanes = 200;

// Some tame, some with everything that the CPU defines.
Module ModuleOf(uint32_t seed) {
  fuzz::RandomModuleOptions options;
  options.tame = seed % 2 == 0;
  options.exact = seed % 3 == 0;
  options.derivatives = seed % 5 == 0;
  options.depth = 1 + seed % 4;
  return fuzz::RandomModule(seed, options);
}

// The words of quad `q` among values of `lanes` lanes.
std::vector<uint32_t> QuadOf(const std::vector<uint32_t>& words, uint32_t lanes, uint32_t q) {
  std::vector<uint32_t> quad;
  for (size_t word = 0; word < words.size() / lanes; ++word) {
    auto first = words.begin() + static_cast<ptrdiff_t>(word * lanes + 4 * q);
    quad.insert(quad.end(), first, first + 4);
  }
  return quad;
}

TEST(RandomModules, ReadBackAsTheyWere) {
  for (uint32_t seed = 0; seed < kSeeds; ++seed) {
    Module module = ModuleOf(seed);
    ASSERT_EQ(Verify(module), "") << seed;
    const std::string text = Print(module);
    Module again = ModuleFrom(text);
    ASSERT_EQ(Print(again), text) << seed;
    EvaluateInputs inputs = fuzz::RandomInputs(module, seed, kLanes, seed % 2 == 0);
    EXPECT_EQ(Evaluate(again, again.main, inputs), Evaluate(module, module.main, inputs)) << text;
  }
}

TEST(RandomModules, GiveEveryQuadTheSameAlone) {
  for (uint32_t seed = 0; seed < kSeeds; ++seed) {
    Module module = ModuleOf(seed);
    EvaluateInputs inputs = fuzz::RandomInputs(module, seed, kLanes, seed % 2 == 0);
    auto together = Evaluate(module, module.main, inputs);
    for (uint32_t q = 0; q < kLanes / 4; q += 7) {
      EvaluateInputs alone = inputs;
      alone.lanes = 4;
      for (size_t i = 0; i < module.globals.size(); ++i) {
        const uint32_t words = module.types.Words(module.globals[i].type);
        if (i >= alone.globals.size() || alone.globals[i].size() <= words) continue;
        alone.globals[i] = QuadOf(inputs.globals[i], kLanes, q);
      }
      auto results = Evaluate(module, module.main, alone);
      for (size_t r = 0; r < results.size(); ++r) {
        EXPECT_EQ(results[r], QuadOf(together[r], kLanes, q)) << seed << "\n" << Print(module);
      }
    }
  }
}

}  // namespace
}  // namespace texgraph::ir
