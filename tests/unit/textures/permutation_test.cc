// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/permutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <vector>

namespace texgraph::textures {
namespace {

TEST(PermutationTest, HasEachNumberOnce) {
  for (uint32_t size : {2u, 3u, 32u, 1000u}) {
    const NumberMap map = MakePermutation(size, 7);
    EXPECT_EQ(map.width, size);
    EXPECT_EQ(map.height, 1u);
    std::vector<int32_t> sorted = map.numbers;
    std::ranges::sort(sorted);
    ASSERT_EQ(sorted.size(), size);
    for (uint32_t i = 0; i < size; ++i) EXPECT_EQ(sorted[i], static_cast<int32_t>(i));
  }
}

// All 24 orders of four numbers, each as often as the others: the chi-square with 23 degrees of
// freedom is below 49.7 in 999 of 1000.
TEST(PermutationTest, AllOrdersComeEquallyOften) {
  std::map<std::vector<int32_t>, double> counts;
  for (uint32_t seed = 0; seed < 2400; ++seed) counts[MakePermutation(4, seed).numbers] += 1;
  EXPECT_EQ(counts.size(), 24u);
  double chi_square = 0;
  for (const auto& [order, count] : counts) chi_square += (count - 100) * (count - 100) / 100;
  EXPECT_LT(chi_square, 49.7);
}

}  // namespace
}  // namespace texgraph::textures
