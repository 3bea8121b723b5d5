// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_cut.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <random>

namespace texgraph::textures {
namespace {

struct Costs {
  std::vector<std::array<int32_t, 8>> values;
  uint32_t side;
  int32_t operator()(uint32_t x, uint32_t y, uint32_t a, uint32_t b) const {
    return std::abs(values[y * side + x][a] - values[y * side + x][b]);
  }
};

// Labels at the border are fixed, each side its own; all `labels` are possible inside.
TileCut RandomCut(uint32_t side, uint32_t labels, uint32_t seed) {
  std::mt19937 random(seed);
  Costs costs{{}, side};
  costs.values.resize(size_t{side} * side);
  for (auto& texel : costs.values) {
    for (int32_t& value : texel) value = static_cast<int32_t>(random() % 1000);
  }
  TileCut cut;
  cut.side = side;
  cut.cost = costs;
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      const bool border = x == 0 || y == 0 || x + 1 == side || y + 1 == side;
      const uint32_t label = (x < side / 2 ? 0u : 1u) + (labels > 2 && y >= side / 2 ? 2u : 0u);
      cut.labels.push_back(static_cast<uint8_t>(label));
      cut.allowed.push_back(static_cast<uint8_t>(border ? 1u << label : (1u << labels) - 1));
    }
  }
  return cut;
}

// What the borders cost, from the definition.
int64_t BorderCosts(const TileCut& cut) {
  int64_t sum = 0;
  const auto add = [&](uint32_t x, uint32_t y, uint32_t x2, uint32_t y2) {
    const uint32_t a = cut.labels[y * cut.side + x];
    const uint32_t b = cut.labels[y2 * cut.side + x2];
    if (a != b) sum += int64_t{cut.cost(x, y, a, b)} + cut.cost(x2, y2, a, b) + 1;
  };
  for (uint32_t y = 0; y < cut.side; ++y) {
    for (uint32_t x = 0; x < cut.side; ++x) {
      if (x + 1 < cut.side) add(x, y, x + 1, y);
      if (y + 1 < cut.side) add(x, y, x, y + 1);
    }
  }
  return sum;
}

std::vector<uint32_t> FreeTexels(const TileCut& cut) {
  std::vector<uint32_t> texels;
  for (uint32_t i = 0; i < cut.labels.size(); ++i) {
    if ((cut.allowed[i] & (cut.allowed[i] - 1)) != 0) texels.push_back(i);
  }
  return texels;
}

// Each texel in `texels` keeps its label or takes `alpha`: the least that a choice can cost.
int64_t LeastByExpansion(TileCut cut, uint32_t alpha) {
  const std::vector<uint32_t> texels = FreeTexels(cut);
  const std::vector<uint8_t> before = cut.labels;
  int64_t least = std::numeric_limits<int64_t>::max();
  for (uint32_t choice = 0; choice < 1u << texels.size(); ++choice) {
    for (size_t i = 0; i < texels.size(); ++i) {
      const bool takes = choice >> i & 1;
      cut.labels[texels[i]] = takes ? static_cast<uint8_t>(alpha) : before[texels[i]];
    }
    least = std::min(least, BorderCosts(cut));
  }
  return least;
}

TEST(TileCutTest, EnergyIsThatOfTheBorders) {
  for (uint32_t seed = 0; seed < 5; ++seed) {
    const TileCut cut = RandomCut(9, 4, seed);
    EXPECT_EQ(cut.Energy(), BorderCosts(cut));
  }
}

// With two labels one expansion reaches everything, so the result is the best of all 2^9 or 2^16.
TEST(TileCutTest, TwoLabelsAreCutAtLeastCost) {
  for (uint32_t seed = 0; seed < 12; ++seed) {
    TileCut cut = RandomCut(seed < 10 ? 5 : 6, 2, seed);
    TileCut ones = cut;
    for (uint32_t texel : FreeTexels(ones)) ones.labels[texel] = 1;
    const int64_t least = LeastByExpansion(ones, 0);
    cut.Improve();
    EXPECT_EQ(BorderCosts(cut), least);
  }
}

TEST(TileCutTest, NoExpansionIsLeftThatGains) {
  for (uint32_t seed = 0; seed < 20; ++seed) {
    TileCut cut = RandomCut(5, 5, seed);
    const int64_t before = BorderCosts(cut);
    const std::vector<uint8_t> labels = cut.labels;
    cut.Improve();
    const int64_t after = BorderCosts(cut);
    EXPECT_LE(after, before);
    for (uint32_t alpha = 0; alpha < 5; ++alpha) EXPECT_EQ(LeastByExpansion(cut, alpha), after);
    for (size_t i = 0; i < labels.size(); ++i) {
      EXPECT_TRUE(cut.allowed[i] >> cut.labels[i] & 1);
      const bool fixed = (cut.allowed[i] & (cut.allowed[i] - 1)) == 0;
      EXPECT_TRUE(!fixed || cut.labels[i] == labels[i]);
    }
  }
}

TEST(TileCutTest, LabelsThatAreNotAllowedAreNotTaken) {
  TileCut cut = RandomCut(12, 4, 3);
  for (uint32_t texel : FreeTexels(cut)) {
    cut.allowed[texel] = static_cast<uint8_t>(1u << cut.labels[texel] | 1u << texel % 4);
  }
  cut.Improve();
  for (size_t i = 0; i < cut.labels.size(); ++i) EXPECT_TRUE(cut.allowed[i] >> cut.labels[i] & 1);
}

}  // namespace
}  // namespace texgraph::textures
