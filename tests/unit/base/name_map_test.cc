// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/name_map.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace texgraph {
namespace {

TEST(NameMap, FindsNothingInAnEmptyOne) {
  NameMap<int> map;
  EXPECT_EQ(map.Find("a"), nullptr);
  EXPECT_EQ(map.Find(""), nullptr);
}

TEST(NameMap, KeepsTheFirstValueOfAName) {
  NameMap<int> map;
  EXPECT_TRUE(map.Add("brick", 1).second);
  auto [value, added] = map.Add("brick", 2);
  EXPECT_FALSE(added);
  EXPECT_EQ(*value, 1);
  *value = 3;
  EXPECT_EQ(*map.Find("brick"), 3);
  ASSERT_EQ(map.entries().size(), 1u);
}

// Lengths on both sides of the eight bytes that are hashed at once, and names that differ in one byte anywhere.
TEST(NameMap, TellsNamesOfAllLengthsApart) {
  std::vector<std::string> names{""};
  for (size_t length = 1; length <= 20; ++length) {
    names.push_back(std::string(length, 'a'));
    for (size_t at = 0; at < length; ++at) {
      names.push_back(std::string(length, 'a'));
      names.back()[at] = 'b';
    }
  }
  NameMap<size_t> map;
  for (size_t i = 0; i < names.size(); ++i) EXPECT_TRUE(map.Add(names[i], i).second) << names[i];
  for (size_t i = 0; i < names.size(); ++i) EXPECT_EQ(*map.Find(names[i]), i) << names[i];
  EXPECT_FALSE(map.Contains("aabac"));
}

TEST(NameMap, DoesWhatAMapDoesInTheOrderOfAddition) {
  std::mt19937 random(7);
  std::vector<std::string> words;
  for (int i = 0; i < 5000; ++i) words.push_back("name" + std::to_string(random() % 3000));
  NameMap<int> map;
  map.Reserve(10);
  std::map<std::string, int> reference;
  std::vector<std::string> order;
  for (int i = 0; i < 5000; ++i) {
    const bool added = map.Add(words[i], i).second;
    EXPECT_EQ(added, reference.emplace(words[i], i).second);
    if (added) order.push_back(words[i]);
  }
  ASSERT_EQ(map.entries().size(), order.size());
  for (size_t i = 0; i < order.size(); ++i) EXPECT_EQ(map.entries()[i].name, order[i]);
  for (const auto& [name, value] : reference) EXPECT_EQ(*map.Find(name), value);
  EXPECT_FALSE(map.Contains("name3000"));
}

}  // namespace
}  // namespace texgraph
