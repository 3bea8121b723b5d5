// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"

namespace texgraph {
namespace {

TEST(NearestName, TyposOfEachKind) {
  std::vector<std::string_view> ports = {"rows", "columns", "row_offset", "jitter", "seed", "uv"};
  EXPECT_EQ(NearestName("row_ofset", ports), "row_offset");    // a letter left out
  EXPECT_EQ(NearestName("row_offfset", ports), "row_offset");  // one too many
  EXPECT_EQ(NearestName("row_pffset", ports), "row_offset");   // a wrong one
  EXPECT_EQ(NearestName("row_fofset", ports), "row_offset");   // two swapped
  EXPECT_EQ(NearestName("colunms", ports), "columns");
  EXPECT_EQ(NearestName("Rows", ports), "rows");
  EXPECT_EQ(NearestName("UV", ports), "uv");
  EXPECT_EQ(NearestName("rwos", ports), "rows");
}

TEST(NearestName, SaysNothingWhenNothingIsNear) {
  std::vector<std::string_view> ports = {"rows", "columns", "uv", "a"};
  EXPECT_EQ(NearestName("brightness", ports), "");
  EXPECT_EQ(NearestName("xy", ports), "");
  EXPECT_EQ(NearestName("b", ports), "");
  EXPECT_EQ(NearestName("", ports), "");
  EXPECT_EQ(NearestName("rows", {}), "");
  EXPECT_EQ(NearestName(std::string(100'000, 'r'), ports), "");
  EXPECT_EQ(DidYouMean("brightness", ports), "");
  EXPECT_EQ(DidYouMean("colums", ports), "; did you mean 'columns'?");
}

TEST(NearestName, TheNearestWinsThenTheFirst) {
  EXPECT_EQ(NearestName("noise_c", {"noise_ab", "noise_b", "noise_a"}), "noise_b");
  EXPECT_EQ(NearestName("abcdef", {"abcxyf", "abcdxf", "abcxef"}), "abcdxf");
}

// An independent distance: the full table, without bands.
int ReferenceDistance(const std::string& a, const std::string& b) {
  std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
  for (size_t i = 0; i <= a.size(); ++i) {
    for (size_t j = 0; j <= b.size(); ++j) {
      if (i == 0 || j == 0) {
        d[i][j] = static_cast<int>(i + j);
        continue;
      }
      d[i][j] =
          std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

TEST(NearestName, AgreesWithTheFullTable) {
  unsigned state = 1;
  auto next = [&](unsigned n) { return (state = state * 1664525u + 1013904223u) / 65536 % n; };
  auto word = [&] {
    std::string text;
    for (unsigned n = 3 + next(10); n > 0; --n) text += static_cast<char>('a' + next(3));
    return text;
  };
  for (int round = 0; round < 20000; ++round) {
    std::string seen = word(), candidate = word();
    if (seen == candidate) continue;
    int bound = std::min(4, static_cast<int>(seen.size()) / 3);
    bool near = ReferenceDistance(seen, candidate) <= bound;
    EXPECT_EQ(!NearestName(seen, {candidate}).empty(), near) << seen << " " << candidate;
  }
}

TEST(NearestName, TenThousandLongCandidatesAreQuick) {
  std::vector<std::string> names;
  for (int i = 0; i < 10'000; ++i)
    names.push_back(std::string(58, 'a') + std::to_string(100'000 + i));
  std::vector<std::string_view> candidates(names.begin(), names.end());
  auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < 100; ++i) (void)NearestName(std::string(56, 'a') + "bbbbbbbb", candidates);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace texgraph
