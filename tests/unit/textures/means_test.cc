// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/means.h"

#include <gtest/gtest.h>

#include "compiler/textures/srgb.h"
#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures {
namespace {

using Numbers = std::vector<int32_t>;

void ExpectNear(const MeanColor& a, const MeanColor& b, double tolerance) {
  for (size_t c = 0; c < 4; ++c) EXPECT_NEAR(a[c], b[c], tolerance) << "channel " << c;
}

TextureData Array(const std::vector<Image>& layers) {
  TextureOptions options;
  options.is_array = true;
  Diagnostics diagnostics;
  return *MakeTexture(layers, options, "t", {}, diagnostics);
}

TEST(MeansTest, AreOfLightAndWeighedByOpacity) {
  // Opaque white, and black of opacity 51 / 255 = 0.2.
  const TextureData data = Array({test::MakeImage(2, 1, 4, 8, {255, 255, 255, 255, 0, 0, 0, 51}),
                                  test::MakeImage(2, 1, 3, 8, {188, 0, 0, 0, 0, 255})});
  const auto weighed = PatternMeans(data, true);
  ASSERT_EQ(weighed.size(), 2u);
  ExpectNear(weighed[0], {1 / 1.2f, 1 / 1.2f, 1 / 1.2f, 0.6f}, 1e-6);
  const auto red = static_cast<float>(SrgbDecode(188 / 255.0) / 2);
  ExpectNear(weighed[1], {red, 0, 0.5f, 1}, 1e-6);
  ExpectNear(PatternMeans(data, false)[0], {0.5f, 0.5f, 0.5f, 0.6f}, 1e-6);
}

TEST(MeansTest, TransparentPatternsHaveTheirPlainMean) {
  const TextureData data = Array({test::MakeImage(2, 1, 4, 8, {255, 0, 0, 0, 0, 0, 255, 0})});
  ExpectNear(PatternMeans(data, true)[0], {0.5f, 0, 0.5f, 0}, 1e-6);
}

TEST(MeansTest, ListsWeighPatternsByCount) {
  const MeanColor patterns[] = {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}};
  const NumberMap lists = *MapOfLists(std::vector<Numbers>{{0, 0, 1, 0}, {2, 1}, {-1, 2}, {-1}});
  const auto weighed = ListMeans(lists, patterns, true);
  ASSERT_EQ(weighed.size(), 4u);
  ExpectNear(weighed[0], {0.75f, 0.25f, 0, 1}, 1e-6);
  ExpectNear(weighed[1], {0, 1 / 1.5f, 0.5f / 1.5f, 0.75f}, 1e-6);
  ExpectNear(weighed[2], {0, 0, 1, 0.25f}, 1e-6);
  EXPECT_EQ(weighed[3], (MeanColor{0, 0, 0, 0}));
  const auto plain = ListMeans(lists, patterns, false);
  ExpectNear(plain[1], {0, 0.5f, 0.5f, 0.75f}, 1e-6);
  ExpectNear(plain[2], {0, 0, 1, 0.5f}, 1e-6);
}

TEST(MeansTextureTest, HasATexelACellWhereDithered) {
  const MeanColor means[] = {{0.25f, 0.5f, 0.75f, 1}, {1, 0, 0, 1}};
  const NumberMap map = MapOfRows(std::vector<Numbers>{{0, 1}, {1, 1}});
  Diagnostics diagnostics;
  const auto data = MeansTexture(map, means, true, true, "far", {}, diagnostics);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->format, TexelFormat::kRgba16);
  EXPECT_EQ(data->sampler.filter, ir::Filter::kLinear);
  EXPECT_EQ(data->sampler.mip_filter, ir::MipFilter::kLinear);
  EXPECT_EQ(data->sampler.wrap_u, ir::Wrap::kRepeat);
  const ir::Texture texture = ToTexture(*data);
  ASSERT_EQ(texture.levels.size(), 2u);
  EXPECT_EQ(texture.levels[0].width, 2u);
  for (size_t i : {0u, 1u, 3u}) ExpectNear(texture.levels[0].texels[i], means[1], 1e-5);
  ExpectNear(texture.levels[0].texels[2], means[0], 1e-5);  // the top row is the last
  ExpectNear(texture.levels[1].texels[0], {3.25f / 4, 0.5f / 4, 0.75f / 4, 1}, 1e-5);
}

TEST(MeansTextureTest, HasManyTexelsACellElse) {
  const MeanColor means[] = {{0.25f, 0.5f, 0.75f, 1}, {1, 0, 0, 1}};
  const NumberMap map = MapOfRows(std::vector<Numbers>{{0, 1, 1}});
  Diagnostics diagnostics;
  const auto data = MeansTexture(map, means, false, true, "far", {}, diagnostics);
  ASSERT_TRUE(data);
  const ir::Texture texture = ToTexture(*data);
  EXPECT_EQ(texture.levels[0].width, 24u);
  EXPECT_EQ(texture.levels[0].height, 8u);
  for (size_t y = 0; y < 8; ++y) {
    for (size_t x = 0; x < 24; ++x)
      ExpectNear(texture.levels[0].texels[y * 24 + x], means[x < 8 ? 0 : 1], 1e-5);
  }
  for (auto [side, texels] :
       {std::pair{128u, 8u}, {129u, 4u}, {512u, 2u}, {513u, 1u}, {2000u, 1u}}) {
    NumberMap wide;
    wide.width = side;
    wide.height = 1;
    wide.numbers.resize(side);
    EXPECT_EQ(MeansTexture(wide, means, false, true, "far", {}, diagnostics)->levels[0].height,
              texels)
        << side;
  }
}

TEST(MeansTextureTest, EmptyCellsAreTransparentAndTintNothing) {
  const MeanColor means[] = {{1, 0.5f, 0, 1}};
  const NumberMap map = MapOfRows(std::vector<Numbers>{{0, -1}, {-1, 5}});
  Diagnostics diagnostics;
  const ir::Texture texture =
      ToTexture(*MeansTexture(map, means, true, true, "far", {}, diagnostics));
  for (size_t i : {0u, 1u, 3u}) ExpectNear(texture.levels[0].texels[i], {1, 0.5f, 0, 0}, 1e-5);
  ExpectNear(texture.levels[1].texels[0], {1, 0.5f, 0, 0.25f}, 1e-4);
  const ir::Texture data = ToTexture(*MeansTexture(map, means, true, false, "f", {}, diagnostics));
  ExpectNear(data.levels[0].texels[0], {0, 0, 0, 0}, 0);
  ExpectNear(data.levels[1].texels[0], {0.25f, 0.125f, 0, 0.25f}, 1e-5);
}

TEST(MeansTextureTest, HasALimit) {
  NumberMap map;
  map.width = 1u << 14;
  map.height = (1u << 12) + 1;
  Diagnostics diagnostics;
  EXPECT_FALSE(MeansTexture(map, {}, true, true, "far", {}, diagnostics));
  EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kSizeLimit);
}

}  // namespace
}  // namespace texgraph::textures
