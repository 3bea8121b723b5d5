// SPDX-License-Identifier: Apache-2.0
// A fixed budget of random graphs, valid and broken: docs/testing.md. fuzz_graphs runs longer.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/fuzz/break_graph.h"
#include "tests/fuzz/check_graph.h"
#include "tests/fuzz/random_graph.h"
#include "tests/unit/base/scratch_folder.h"

namespace texgraph::fuzz {
namespace {

constexpr uint32_t kGraphs = 400;
constexpr uint32_t kBrokenGraphs = 400;
constexpr uint32_t kBrokenTexts = 16;  // of each graph

TEST(RandomGraphs, AreValidAndMeanTheSameOptimizedOrNot) {
  ScratchFolder folder;
  ASSERT_TRUE(WriteGraphImages(folder.path()));
  uint32_t limits = 0, costly = 0;
  uint64_t values = 0, undefined = 0, loose = 0;
  for (uint32_t seed = 1; seed <= kGraphs; ++seed) {
    const RandomGraphText graph = RandomGraph(seed);
    const GraphReport report =
        CheckValidGraph(graph.text, graph.format, folder / graph.FileName(seed), seed);
    EXPECT_EQ(report.failure, "") << "seed " << seed << "\n" << graph.text;
    if (!report.limit.empty()) ++limits;
    costly += report.costly;
    values += report.values;
    undefined += report.undefined;
    loose += report.loose;
  }
  EXPECT_LE(limits, kGraphs / 50);
  EXPECT_LE(costly, kGraphs / 50);
  EXPECT_GT(values, uint64_t{kGraphs} * 64);
  EXPECT_LT(undefined, values / 100);
  EXPECT_LT(loose, values / 10);
}

// How many graphs that takes grows with the library; a block that is never drawn is in none.
TEST(RandomGraphs, UseEveryBlock) {
  const std::set<std::string> usable = UsableBlocks();
  std::set<std::string> unused = usable;
  for (uint32_t seed = 1; seed <= 10 * kGraphs && !unused.empty(); ++seed) {
    for (const std::string& block : RandomGraph(seed).blocks) unused.erase(block);
  }
  EXPECT_THAT(unused, testing::IsEmpty());
  EXPECT_GT(usable.size(), 50u);
}

TEST(RandomGraphs, BrokenOnesAreRefusedWithAPlaceOrCompile) {
  ScratchFolder folder;
  ASSERT_TRUE(WriteGraphImages(folder.path()));
  for (uint32_t seed = 1; seed <= kBrokenGraphs; ++seed) {
    const RandomGraphText graph = RandomGraph(seed);
    std::mt19937 random(seed);
    for (uint32_t i = 0; i < kBrokenTexts; ++i) {
      const std::string text = BreakGraph(graph, random);
      const std::string wrong = CheckBrokenGraph(text, graph.format, folder / graph.FileName(seed));
      EXPECT_EQ(wrong, "") << "seed " << seed << ", text " << i << "\n" << text;
    }
  }
}

}  // namespace
}  // namespace texgraph::fuzz
