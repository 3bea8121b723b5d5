// SPDX-License-Identifier: Apache-2.0
#include "compiler/graph/order.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <initializer_list>
#include <random>
#include <vector>

namespace texgraph::graph {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Dependencies Needs(std::initializer_list<std::vector<uint32_t>> needs) {
  Dependencies dependencies;
  for (const auto& list : needs) {
    for (uint32_t need : list) dependencies.Add(need);
    dependencies.EndThing();
  }
  return dependencies;
}

TEST(Order, KeepsTheGivenOrderWhereItIsFree) {
  EXPECT_THAT(OrderByNeed(Needs({{}, {0}, {}, {2, 1}})).sequence, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(OrderByNeed(Needs({{3}, {}, {1}, {}})).sequence, ElementsAre(1, 2, 3, 0));
  EXPECT_THAT(OrderByNeed(Needs({{1, 1, 1}, {}})).sequence, ElementsAre(1, 0));
  EXPECT_THAT(OrderByNeed(Needs({})).sequence, IsEmpty());
}

TEST(Order, FindsTheShortestCircleOfEachGroup) {
  // 0 -> 1 -> 2 -> 0 with the shortcut 1 -> 0; 3 needs itself; 4 needs a circle but is in none.
  Order order = OrderByNeed(Needs({{1}, {2, 0}, {0}, {3}, {0}, {}}));
  EXPECT_THAT(order.circles, ElementsAre(ElementsAre(0, 1), ElementsAre(3)));
  EXPECT_THAT(order.sequence, ElementsAre(5, 0, 1, 2, 3, 4));
}

TEST(Order, LongChainsAndCirclesNeedNoStack) {
  constexpr uint32_t kLength = 200'000;
  Dependencies chain;
  for (uint32_t i = 0; i < kLength; ++i) {
    if (i + 1 < kLength) chain.Add(i + 1);
    chain.EndThing();
  }
  Order order = OrderByNeed(chain);
  EXPECT_EQ(order.sequence.front(), kLength - 1);
  EXPECT_EQ(order.sequence.back(), 0u);
  EXPECT_THAT(order.circles, IsEmpty());
  Dependencies circle;
  for (uint32_t i = 0; i < kLength; ++i) {
    circle.Add((i + 1) % kLength);
    circle.EndThing();
  }
  Order whole = OrderByNeed(circle);
  ASSERT_EQ(whole.circles.size(), 1u);
  EXPECT_EQ(whole.circles[0].size(), kLength);
}

// Against the definition: each after what it needs, and circles are circles.
TEST(Order, RandomGraphs) {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    uint32_t size = 1 + random() % 12;
    Dependencies dependencies;
    for (uint32_t i = 0; i < size; ++i) {
      for (uint32_t k = random() % 3; k > 0; --k) dependencies.Add(random() % size);
      dependencies.EndThing();
    }
    Order order = OrderByNeed(dependencies);
    // Which things reach themselves, by transitive closure.
    std::vector<std::vector<bool>> reach(size, std::vector<bool>(size, false));
    for (uint32_t i = 0; i < size; ++i) {
      for (uint32_t need : dependencies.Of(i)) reach[i][need] = true;
    }
    for (uint32_t k = 0; k < size; ++k) {
      for (uint32_t i = 0; i < size; ++i) {
        for (uint32_t j = 0; j < size; ++j) {
          if (reach[i][k] && reach[k][j]) reach[i][j] = true;
        }
      }
    }
    uint32_t groups = 0;
    std::vector<bool> held_up(size, false);
    for (uint32_t i = 0; i < size; ++i) {
      bool first = reach[i][i];
      for (uint32_t j = 0; j < i; ++j) first = first && !(reach[i][j] && reach[j][i]);
      groups += first;
      for (uint32_t j = 0; j < size; ++j) {
        held_up[i] = held_up[i] || reach[i][i] || (reach[i][j] && reach[j][j]);
      }
    }
    EXPECT_EQ(order.circles.size(), groups);
    for (const auto& circle : order.circles) {
      for (size_t i = 0; i < circle.size(); ++i) {
        EXPECT_THAT(dependencies.Of(circle[i]),
                    ::testing::Contains(circle[(i + 1) % circle.size()]));
      }
    }
    ASSERT_EQ(order.sequence.size(), size);
    std::vector<bool> done(size, false);
    for (uint32_t thing : order.sequence) {
      EXPECT_FALSE(done[thing]);
      done[thing] = true;
      if (held_up[thing]) continue;
      for (uint32_t need : dependencies.Of(thing)) EXPECT_TRUE(done[need]);
    }
  }
}

}  // namespace
}  // namespace texgraph::graph
