// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/progress.h"

#include <gtest/gtest.h>

namespace texgraph::cli {
namespace {

TEST(ProgressTest, Lines) {
  const std::string dots(30, '.');
  EXPECT_EQ(ProgressLine(0, 24, 0, 80), "[" + dots + "] 0 of 24 frames");
  EXPECT_EQ(ProgressLine(12, 24, 3, 80),
            "[" + std::string(15, '#') + std::string(15, '.') + "] 12 of 24 frames, 3 s left");
  EXPECT_EQ(ProgressLine(24, 24, 6, 80), "[" + std::string(30, '#') + "] 24 of 24 frames");
  EXPECT_EQ(ProgressLine(1, 1000, 1, 80),
            "[" + dots + "] 1 of 1000 frames, 17 min left");  // 999 s
}

TEST(ProgressTest, LinesOfShares) {
  EXPECT_EQ(ProgressLine(250, 1000, 2, 80, ProgressUnit::kPercent),
            "[" + std::string(7, '#') + std::string(23, '.') + "] 25 %, 6 s left");
  EXPECT_EQ(ProgressLine(999, 1000, 0, 20, ProgressUnit::kPercent), "99 %, 0 s left");
}

TEST(ProgressTest, NeverReachesTheLastColumn) {
  for (uint32_t columns = 0; columns < 100; ++columns) {
    const std::string line = ProgressLine(1234, 9999, 5000, columns);
    EXPECT_LT(line.size(), columns == 0 ? 1 : columns) << line;
  }
}

}  // namespace
}  // namespace texgraph::cli
