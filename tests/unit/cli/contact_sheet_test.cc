// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/contact_sheet.h"

#include <gtest/gtest.h>

#include <vector>

#include "cli/texgraph/sequence.h"

namespace texgraph::cli {
namespace {

using runtime::PixelFormat;
using runtime::RenderedOutput;

RenderedOutput Image(uint8_t channels, std::vector<uint8_t> pixels) {
  RenderedOutput output;
  output.channels = channels;
  output.image.width = 2;
  output.image.height = 1;
  output.image.channels = channels;
  output.image.pixels = std::move(pixels);
  return output;
}

SheetLayout Layout(uint32_t cells, uint32_t width, uint32_t height) {
  Diagnostics diagnostics;
  const auto layout = LayOutSheet(cells, width, height, PixelFormat::kImage8, diagnostics);
  EXPECT_TRUE(layout) << cells;
  return layout ? *layout : SheetLayout();
}

TEST(ContactSheetTest, AsManyColumnsAsRowsOrOneMore) {
  const uint32_t sizes[][3] = {{1, 1, 1}, {2, 2, 1}, {3, 2, 2}, {4, 2, 2},
                               {5, 3, 2}, {7, 3, 3}, {9, 3, 3}, {10, 4, 3}};
  for (const auto& [cells, columns, rows] : sizes) {
    const SheetLayout layout = Layout(cells, 10, 20);
    EXPECT_EQ(layout.columns, columns) << cells;
    EXPECT_EQ(layout.rows, rows) << cells;
    EXPECT_EQ(layout.width, columns * 10 + (columns - 1) * kSheetGap);
    EXPECT_EQ(layout.height, rows * 20 + (rows - 1) * kSheetGap);
  }
}

TEST(ContactSheetTest, NoLargerThanAPicture) {
  Diagnostics diagnostics;
  EXPECT_FALSE(LayOutSheet(2, 40000, 1, PixelFormat::kImage8, diagnostics));
  EXPECT_FALSE(LayOutSheet(4, 5000, 5000, PixelFormat::kFloat, diagnostics));
  EXPECT_FALSE(LayOutSheet(9999, 65535, 65535, PixelFormat::kFloat, diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 3u);
  EXPECT_EQ(diagnostics.exit_code(), ExitCode::kLimit);
}

TEST(ContactSheetTest, GreyAmongColours) {
  const std::vector<RenderedOutput> cells = {Image(4, {1, 2, 3, 4, 5, 6, 7, 8}), Image(1, {9, 10}),
                                             Image(3, {11, 12, 13, 14, 15, 16})};
  RenderedOutput sheet;
  ASSERT_TRUE(DrawSheet(Layout(3, 2, 1), cells, sheet));
  EXPECT_EQ(sheet.image.channels, 4);
  ASSERT_EQ(sheet.image.width, 8u);
  ASSERT_EQ(sheet.image.height, 6u);
  const auto pixel = [&](uint32_t x, uint32_t y) {
    const uint8_t* at = sheet.image.pixels.data() + (y * 8 + x) * 4;
    return std::vector<int>(at, at + 4);
  };
  EXPECT_EQ(pixel(0, 0), (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(pixel(1, 0), (std::vector<int>{5, 6, 7, 8}));
  EXPECT_EQ(pixel(6, 0), (std::vector<int>{9, 9, 9, 255}));
  EXPECT_EQ(pixel(7, 0), (std::vector<int>{10, 10, 10, 255}));
  EXPECT_EQ(pixel(0, 5), (std::vector<int>{11, 12, 13, 255}));
  EXPECT_EQ(pixel(1, 5), (std::vector<int>{14, 15, 16, 255}));
  for (uint32_t i = 0; i < 8; ++i)
    EXPECT_EQ(pixel(i, 1 + i % 4), (std::vector<int>{0, 0, 0, 255})) << "the gap";
  EXPECT_EQ(pixel(6, 5), (std::vector<int>{0, 0, 0, 255})) << "the empty cell";
}

TEST(ContactSheetTest, FloatsFromTheBottom) {
  std::vector<RenderedOutput> cells(3);
  for (size_t i = 0; i < cells.size(); ++i) {
    cells[i].channels = 1;
    // One column of two pixels, the lower one first.
    cells[i].floats = {1.0f * i, 7, 7, 7, 10.0f + i, 7, 7, 7};
  }
  RenderedOutput sheet;
  ASSERT_TRUE(DrawSheet(Layout(3, 1, 2), cells, sheet));
  EXPECT_EQ(sheet.channels, 1u);
  ASSERT_EQ(sheet.floats.size(), size_t{6} * 8 * 4);
  const auto value = [&](uint32_t x, uint32_t y_from_bottom) {
    return sheet.floats[(y_from_bottom * 6 + x) * 4];
  };
  EXPECT_EQ(value(0, 6), 0);
  EXPECT_EQ(value(0, 7), 10);
  EXPECT_EQ(value(5, 6), 1);
  EXPECT_EQ(value(5, 7), 11);
  EXPECT_EQ(value(0, 0), 2);
  EXPECT_EQ(value(0, 1), 12);
  EXPECT_EQ(value(5, 1), 0);
}

TEST(SequenceTest, NumbersGoBeforeTheExtension) {
  EXPECT_EQ(FramePath("wall.png", 1), "wall.0001.png");
  EXPECT_EQ(FramePath("a.b/wall.exr", 9999), "a.b/wall.9999.exr");
  EXPECT_EQ(FramePath("a.b/wall", 12), "a.b/wall.0012");
  EXPECT_EQ(FramePath(".hidden", 2), ".hidden.0002");
}

}  // namespace
}  // namespace texgraph::cli
