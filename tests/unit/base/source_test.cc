// SPDX-License-Identifier: Apache-2.0
#include "compiler/base/source.h"

#include <gtest/gtest.h>

namespace texgraph {
namespace {

TEST(Sources, LinesAndColumns) {
  Sources sources;
  SourceId id = sources.Add("a", "ab\ncd\r\n\nx");
  auto at = [&](uint32_t offset) {
    LineColumn place = sources.Locate(id, offset);
    return std::pair(place.line, place.column);
  };
  EXPECT_EQ(at(0), std::pair(1u, 1u));
  EXPECT_EQ(at(2), std::pair(1u, 3u));  // the line end belongs to its line
  EXPECT_EQ(at(3), std::pair(2u, 1u));
  EXPECT_EQ(at(7), std::pair(3u, 1u));
  EXPECT_EQ(at(8), std::pair(4u, 1u));
  EXPECT_EQ(at(9), std::pair(4u, 2u));
  EXPECT_EQ(sources.Line(id, 4), "cd");
  EXPECT_EQ(sources.Line(id, 7), "");
  EXPECT_EQ(sources.Line(id, 9), "x");
}

TEST(Sources, TextsStayWhereTheyAre) {
  Sources sources;
  SourceId first = sources.Add("a", "x");
  const char* data = sources.Text(first).data();
  for (int i = 0; i < 1000; ++i) sources.Add("b", "y");
  EXPECT_EQ(sources.Text(first).data(), data);
}

}  // namespace
}  // namespace texgraph
