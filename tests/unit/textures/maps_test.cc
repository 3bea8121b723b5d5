// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/maps.h"

#include <gtest/gtest.h>

#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures {
namespace {

using test::MakeImage;
using Numbers = std::vector<int32_t>;
using Rgb = std::array<uint8_t, 3>;

std::string Refusal(const Image& image, std::span<const Rgb> legend) {
  Diagnostics diagnostics;
  EXPECT_FALSE(MapOfImage(image, legend, "where", {}, diagnostics));
  EXPECT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kBadImage);
  return diagnostics.all()[0].message;
}

TEST(MapsTest, TheFirstRowIsTheTop) {
  const std::vector<Numbers> rows = {{1, 2, 3}, {4, 5, -1}};
  const NumberMap map = MapOfRows(rows);
  EXPECT_EQ(map.width, 3u);
  EXPECT_EQ(map.height, 2u);
  EXPECT_EQ(map.numbers, (Numbers{4, 5, -1, 1, 2, 3}));
  EXPECT_EQ(map.At(2, 1), 3);
}

TEST(MapsTest, GreyPicturesAreNumbers) {
  Diagnostics diagnostics;
  auto map = MapOfImage(MakeImage(2, 2, 1, 8, {0, 7, 255, 3}), {}, "m", {}, diagnostics);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->numbers, (Numbers{255, 3, 0, 7}));
  map = MapOfImage(MakeImage(2, 1, 1, 16, {300, 65535}), {}, "m", {}, diagnostics);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->numbers, (Numbers{300, 65535}));
  map = MapOfImage(MakeImage(2, 1, 4, 8, {9, 9, 9, 255, 1, 2, 3, 0}), {}, "m", {}, diagnostics);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->numbers, (Numbers{9, -1}));
  EXPECT_FALSE(diagnostics.HasErrors());
}

TEST(MapsTest, LegendsGiveColorsNumbers) {
  const Rgb legend[] = {{0x3a, 0x7d, 0x2c}, {0xc8, 0xb4, 0x6a}, {0x3a, 0x7d, 0x2c}};
  Diagnostics diagnostics;
  auto map = MapOfImage(MakeImage(2, 1, 3, 8, {0xc8, 0xb4, 0x6a, 0x3a, 0x7d, 0x2c}), legend, "m",
                        {}, diagnostics);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->numbers, (Numbers{1, 0}));  // of equal colours the first
  map = MapOfImage(MakeImage(1, 1, 3, 16, {0xc8c8, 0xb4b4, 0x6a6a}), legend, "m", {}, diagnostics);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->numbers, (Numbers{1}));
  const Rgb greys[] = {{0, 0, 0}, {255, 255, 255}};
  map = MapOfImage(MakeImage(2, 1, 2, 8, {255, 255, 77, 0}), greys, "m", {}, diagnostics);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->numbers, (Numbers{1, -1}));
}

TEST(MapsTest, SaysWhichPixelIsWrong) {
  const Rgb legend[] = {{0xff, 0x7d, 0x2d}, {0x3a, 0x7d, 0x2c}, {0x3a, 0x7d, 0x30}};
  EXPECT_EQ(Refusal(MakeImage(1, 2, 3, 8, {0x3a, 0x7d, 0x2c, 0x3a, 0x7d, 0x2d}), legend),
            "pixel (0, 1) of the map 'where' is #3a7d2d, which is not in the legend; the nearest "
            "there is #3a7d2c, number 1");
  EXPECT_EQ(Refusal(MakeImage(1, 1, 3, 16, {0x3a3a, 0x7d7d, 0x2c2d}), legend),
            "pixel (0, 0) of the map 'where' is #3a3a7d7d2c2d, which is not in the legend; the "
            "nearest there is #3a7d2c, number 1");
  EXPECT_EQ(Refusal(MakeImage(1, 1, 3, 8, {1, 1, 2}), {}),
            "pixel (0, 0) of the map 'where' is #010102, which is not grey: a map of colours needs "
            "a legend");
}

TEST(MapsTest, ShorterListsAreRepeated) {
  const std::vector<Numbers> lists = {{0, 0, 1, 5}, {2, 3}, {4}};
  const auto map = MapOfLists(lists);
  ASSERT_TRUE(map);
  EXPECT_EQ(map->width, 4u);
  EXPECT_EQ(map->height, 3u);
  EXPECT_EQ(map->numbers, (Numbers{0, 0, 1, 5, 2, 3, 2, 3, 4, 4, 4, 4}));
  EXPECT_FALSE(MapOfLists(std::vector<Numbers>{{0, 0, 1, 5}, {2, 3, 4}}));
  EXPECT_FALSE(MapOfLists(std::vector<Numbers>{{0}, {}}));
}

TEST(MapsTest, FindsNumbersThatMeanNothing) {
  NumberMap map = MapOfRows(std::vector<Numbers>{{0, 3, -1}});
  EXPECT_FALSE(FindOutOfRange(map, 4));
  EXPECT_EQ(FindOutOfRange(map, 3), 1u);
  map.numbers[2] = -2;
  EXPECT_EQ(FindOutOfRange(map, 4), 2u);
}

TEST(MapsTest, TexturesHoldTheNumbers) {
  for (int32_t largest : {2048, 2049, kMaxMapNumber}) {
    const NumberMap map = MapOfRows(std::vector<Numbers>{{-1, largest}, {0, 1}});
    const TextureData data = MapTexture(map, ir::Wrap::kClamp);
    EXPECT_EQ(data.format, largest == 2048 ? TexelFormat::kR16F : TexelFormat::kR32F);
    EXPECT_EQ(data.sampler.wrap_u, ir::Wrap::kClamp);
    EXPECT_EQ(data.sampler.wrap_v, ir::Wrap::kRepeat);
    EXPECT_EQ(data.sampler.filter, ir::Filter::kNearest);
    EXPECT_EQ(data.sampler.mip_filter, ir::MipFilter::kNone);
    const ir::Texture texture = ToTexture(data);
    ASSERT_EQ(texture.levels.size(), 1u);
    for (int32_t y = 0; y < 2; ++y) {
      for (int32_t x = 0; x < 2; ++x) {
        const int32_t at[] = {x, y};
        EXPECT_EQ(ir::Fetch(texture, at, 0)[0],
                  static_cast<float>(map.At(static_cast<uint32_t>(x), static_cast<uint32_t>(y))));
      }
    }
  }
}

}  // namespace
}  // namespace texgraph::textures
