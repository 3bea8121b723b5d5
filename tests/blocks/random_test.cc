// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

constexpr size_t kCount = 65536;

std::vector<uint32_t> Seeds() {
  std::vector<uint32_t> seeds(kCount);
  for (size_t i = 0; i < kCount; ++i) {
    seeds[i] = static_cast<uint32_t>(i);
  }
  return seeds;
}

// For k - 1 degrees of freedom the statistic has mean k - 1 and variance 2 (k - 1); five standard
// deviations, on both sides: too even is not random either.
template <size_t k>
void ExpectUniform(const std::array<int, k>& counts, const char* what) {
  double expected = static_cast<double>(kCount) / k;
  double statistic = 0;
  for (int count : counts) {
    statistic += (count - expected) * (count - expected) / expected;
  }
  double spread = 5 * std::sqrt(2.0 * (k - 1));
  EXPECT_GT(statistic, k - 1 - spread) << what;
  EXPECT_LT(statistic, k - 1 + spread) << what;
}

TEST(RandomTest, HashIsPcgToTheBit) {
  std::vector<uint32_t> values = Seeds();
  for (uint32_t value : {0xffffffffu, 0x80000000u, 0x7fffffffu, 0xdeadbeefu}) {
    values.push_back(value);
  }
  auto outputs = RunBlock("hash", {{"value", Uints(values)}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(outputs["result"].Uint(i), reference::Pcg(values[i])) << values[i];
  }
}

TEST(RandomTest, HashOfAVectorIsThatOfItsComponents) {
  std::vector<uint32_t> words = Seeds();
  for (uint32_t width : {2u, 4u}) {
    Values vectors{width == 2 ? ir::kUvec2 : ir::kUvec4, kCount / width, words};
    auto outputs = RunBlock("hash", {{"value", vectors}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < kCount; ++i) {
      ASSERT_EQ(outputs["result"].words[i], reference::Pcg(words[i])) << width << " " << i;
    }
  }
}

TEST(RandomTest, HashOfACellIsNestedPcg) {
  std::vector<std::pair<int32_t, int32_t>> cells;
  for (int32_t x : {-1048576, -17, -1, 0, 1, 27, 1048576}) {
    for (int32_t y : {-1048576, -3, 0, 5, 1048575}) {
      cells.emplace_back(x, y);
    }
  }
  auto outputs = RunBlock("hash", {{"cell", CellsOf(cells)}, {"seed", Uints({77})}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < cells.size(); ++i) {
    EXPECT_EQ(outputs["result"].Uint(i), reference::CellHash(cells[i].first, cells[i].second, 77));
  }
}

TEST(RandomTest, RandomIsTheUpper24BitsAndUniform) {
  for (int32_t stream : {0, 1, -3}) {
    auto outputs = RunBlock("random", {{"seed", Uints(Seeds())}, {"stream", Ints({stream})}});
    ASSERT_EQ(outputs.size(), 1u);
    std::array<int, 64> counts{};
    for (size_t i = 0; i < kCount; ++i) {
      float value = outputs["result"].Float(i);
      uint32_t bits = reference::Pcg(static_cast<uint32_t>(i) + static_cast<uint32_t>(stream));
      ASSERT_EQ(value, reference::Unit24(bits));
      ASSERT_GE(value, 0.0f);
      ASSERT_LT(value, 1.0f);
      ++counts[static_cast<size_t>(value * 64)];
    }
    ExpectUniform(counts, "random");
  }
}

TEST(RandomTest, ComponentsAreUniformInPairs) {
  auto two = RunBlock("random2", {{"seed", Uints(Seeds())}});
  auto three = RunBlock("random3", {{"seed", Uints(Seeds())}, {"stream", Ints({5})}});
  ASSERT_EQ(two.size(), 1u);
  ASSERT_EQ(three.size(), 1u);
  const Values& pairs = two["result"];
  const Values& triples = three["result"];
  auto cell = [](float a, float b) {
    return static_cast<size_t>(a * 16) * 16 + static_cast<size_t>(b * 16);
  };
  std::array<int, 256> xy{}, ab{}, bc{}, ac{};
  for (size_t i = 0; i < kCount; ++i) {
    for (size_t c = 0; c < 3; ++c) {
      ASSERT_GE(triples.Float(i, c), 0.0f);
      ASSERT_LT(triples.Float(i, c), 1.0f);
    }
    ++xy[cell(pairs.Float(i, 0), pairs.Float(i, 1))];
    ++ab[cell(triples.Float(i, 0), triples.Float(i, 1))];
    ++bc[cell(triples.Float(i, 1), triples.Float(i, 2))];
    ++ac[cell(triples.Float(i, 0), triples.Float(i, 2))];
  }
  ExpectUniform(xy, "random2");
  ExpectUniform(ab, "random3, first and second");
  ExpectUniform(bc, "random3, second and third");
  ExpectUniform(ac, "random3, first and third");
}

// The values of one stream say nothing about those of another.
TEST(RandomTest, StreamsAreIndependent) {
  std::vector<Values> streams;
  for (int32_t stream = -4; stream < 4; ++stream) {
    auto outputs =
        RunBlock("random", {{"seed", Uints([] {
                               std::vector<uint32_t> seeds = Seeds();
                               for (uint32_t& seed : seeds) {
                                 seed = reference::CellHash(static_cast<int32_t>(seed), 0, 0);
                               }
                               return seeds;
                             }())},
                            {"stream", Ints({stream})}});
    ASSERT_EQ(outputs.size(), 1u);
    streams.push_back(outputs["result"]);
  }
  for (size_t a = 0; a < streams.size(); ++a) {
    for (size_t b = a + 1; b < streams.size(); ++b) {
      double covariance = 0;
      for (size_t i = 0; i < kCount; ++i) {
        covariance += (streams[a].Float(i) - 0.5) * (streams[b].Float(i) - 0.5);
      }
      double correlation = covariance / kCount * 12;
      EXPECT_LT(std::fabs(correlation), 5 / std::sqrt(static_cast<double>(kCount)))
          << a << " " << b;
    }
  }
}

// Cells a fixed distance apart share their upper four bits as often as chance wants, in every
// direction.
TEST(RandomTest, CellsAtADistanceAreUnrelated) {
  constexpr int kSide = 96;
  std::vector<std::pair<int32_t, int32_t>> cells;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      cells.emplace_back(x, y);
    }
  }
  auto outputs = RunBlock("hash", {{"cell", CellsOf(cells)}});
  ASSERT_EQ(outputs.size(), 1u);
  auto top = [&](int x, int y) {
    return outputs["result"].Uint(static_cast<size_t>(y * kSide + x)) >> 28;
  };
  for (int dy = 0; dy <= 32; ++dy) {
    for (int dx = -32; dx <= 32; ++dx) {
      if (dy == 0 && dx <= 0) {
        continue;
      }
      int equal = 0, pairs = 0;
      for (int y = 0; y + dy < kSide; ++y) {
        for (int x = dx < 0 ? -dx : 0; x < kSide && x + dx < kSide; ++x) {
          ++pairs;
          equal += top(x, y) == top(x + dx, y + dy);
        }
      }
      double expected = pairs / 16.0;
      EXPECT_LT(std::fabs(equal - expected), 6 * std::sqrt(expected)) << dx << " " << dy;
    }
  }
}

}  // namespace
}  // namespace texgraph::blocks
