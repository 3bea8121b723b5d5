// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/sheets.h"

#include <gtest/gtest.h>

#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures {
namespace {

using test::RandomImage;

TEST(SheetsTest, PicturesAreCountedFromTheLeftTopCorner) {
  for (uint8_t channels : {1, 2, 3, 4}) {
    for (uint8_t bits : {8, 16}) {
      const Image sheet = RandomImage(12, 6, channels, bits, 1);
      Diagnostics diagnostics;
      const auto pictures = CutSheet(sheet, 4, 3, "s", {}, diagnostics);
      ASSERT_TRUE(pictures);
      ASSERT_EQ(pictures->size(), 12u);
      for (uint32_t i = 0; i < 12; ++i) {
        const Image& picture = (*pictures)[i];
        ASSERT_EQ(picture.width, 3u);
        ASSERT_EQ(picture.height, 2u);
        ASSERT_EQ(picture.channels, channels);
        ASSERT_EQ(picture.bits, bits);
        ASSERT_EQ(picture.pixels.size(), picture.RowBytes() * 2);
        for (uint32_t y = 0; y < 2; ++y) {
          for (uint32_t x = 0; x < 3; ++x) {
            for (uint32_t c = 0; c < channels; ++c) {
              ASSERT_EQ(picture.At(x, y, c), sheet.At(i % 4 * 3 + x, i / 4 * 2 + y, c));
            }
          }
        }
      }
    }
  }
}

TEST(SheetsTest, RefusesGridsThatDoNotFit) {
  const Image sheet = RandomImage(12, 6, 1, 8, 1);
  for (auto [columns, rows] : {std::pair{5u, 3u}, {4u, 4u}, {0u, 1u}, {1u, 0u}, {24u, 1u}}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(CutSheet(sheet, columns, rows, "ground", {}, diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kBadImage);
  }
  Diagnostics diagnostics;
  EXPECT_FALSE(CheckSheet(sheet, 5, 3, "ground", {}, diagnostics));
  EXPECT_EQ(diagnostics.all()[0].message,
            "the sheet of texture 'ground' has 12 x 6 pixels, which is no multiple of its grid of "
            "5 x 3 pictures");
}

std::vector<Image> Pictures(size_t count, uint32_t width, uint32_t height) {
  std::vector<Image> pictures;
  for (size_t i = 0; i < count; ++i)
    pictures.push_back(RandomImage(width, height, 4, 8, static_cast<uint32_t>(i)));
  return pictures;
}

// Each picture's own mip levels, at its place: texel by texel.
TEST(AtlasTest, NoLevelMixesPictures) {
  const std::vector<Image> pictures = Pictures(5, 8, 8);
  TextureOptions options;
  options.alpha_is_opacity = true;
  options.wrap_v = ir::Wrap::kMirror;
  Diagnostics diagnostics;
  const auto atlas = MakeAtlas(pictures, 2, options, "a", {}, diagnostics);
  ASSERT_TRUE(atlas);
  EXPECT_FALSE(atlas->is_array);
  EXPECT_EQ(atlas->format, TexelFormat::kSrgb8Alpha8);
  EXPECT_EQ(atlas->sampler.max_level, 3);
  EXPECT_EQ(atlas->sampler.wrap_v, ir::Wrap::kMirror);
  ASSERT_EQ(atlas->levels.size(), 4u);
  const ir::Texture texture = ToTexture(*atlas);
  for (size_t i = 0; i < 6; ++i) {
    std::optional<ir::Texture> alone;
    if (i < 5) {
      alone = ToTexture(*MakeTexture(std::span(&pictures[i], 1), options, "one", {}, diagnostics));
    }
    for (size_t level = 0; level < 4; ++level) {
      const uint32_t side = 8u >> level;
      ASSERT_EQ(texture.levels[level].width, 2 * side);
      ASSERT_EQ(texture.levels[level].height, 3 * side);
      for (uint32_t y = 0; y < side; ++y) {
        for (uint32_t x = 0; x < side; ++x) {
          const size_t at = ((2 - i / 2) * side + y) * 2 * side + i % 2 * side + x;
          const ir::Texel expected =
              alone ? alone->levels[level].texels[y * side + x] : ir::Texel{};
          ASSERT_EQ(texture.levels[level].texels[at], expected) << i << " level " << level;
        }
      }
    }
  }
}

TEST(AtlasTest, PutsASheetTogetherAgain) {
  const Image sheet = RandomImage(16, 12, 3, 8, 5);
  Diagnostics diagnostics;
  const auto pictures = CutSheet(sheet, 4, 3, "s", {}, diagnostics);
  ASSERT_TRUE(pictures);
  const auto atlas = MakeAtlas(*pictures, 4, {}, "a", {}, diagnostics);
  const auto whole = MakeTexture(std::span(&sheet, 1), {}, "t", {}, diagnostics);
  ASSERT_TRUE(atlas && whole);
  EXPECT_EQ(atlas->levels[0].bytes, whole->levels[0].bytes);
}

TEST(AtlasTest, EndsWhereAPictureCannotBeHalved) {
  EXPECT_EQ(AtlasMaxLevel(1, 1), 0u);
  EXPECT_EQ(AtlasMaxLevel(64, 64), 6u);
  EXPECT_EQ(AtlasMaxLevel(24, 24), 3u);
  EXPECT_EQ(AtlasMaxLevel(24, 16), 3u);
  EXPECT_EQ(AtlasMaxLevel(16, 4), 2u);
  EXPECT_EQ(AtlasMaxLevel(7, 8), 0u);
  Diagnostics diagnostics;
  const std::vector<Image> pictures = Pictures(3, 24, 16);
  auto atlas = MakeAtlas(pictures, 3, {}, "a", {}, diagnostics);
  ASSERT_TRUE(atlas);
  // Every level has the size that a texture's level has to have.
  for (size_t level = 0; level < atlas->levels.size(); ++level) {
    EXPECT_EQ(atlas->levels[level].width, atlas->levels[0].width >> level);
    EXPECT_EQ(atlas->levels[level].height, atlas->levels[0].height >> level);
  }
  EXPECT_EQ(atlas->levels.size(), 4u);
  TextureOptions options;
  options.max_level = 1;
  EXPECT_EQ(MakeAtlas(pictures, 3, options, "a", {}, diagnostics)->levels.size(), 2u);
  options.max_level.reset();
  options.mipmaps = false;
  EXPECT_EQ(MakeAtlas(pictures, 3, options, "a", {}, diagnostics)->levels.size(), 1u);
}

TEST(AtlasTest, RefusesWhatHasNoAtlas) {
  Diagnostics diagnostics;
  EXPECT_FALSE(MakeAtlas({}, 1, {}, "a", {}, diagnostics));
  EXPECT_FALSE(MakeAtlas(Pictures(2, 2, 2), 0, {}, "a", {}, diagnostics));
  std::vector<Image> unequal = Pictures(1, 2, 2);
  unequal.push_back(RandomImage(2, 4, 1, 8, 9));
  EXPECT_FALSE(MakeAtlas(unequal, 2, {}, "a", {}, diagnostics));
  for (const Diagnostic& diagnostic : diagnostics.all())
    EXPECT_EQ(diagnostic.kind, DiagnosticKind::kBadImage);
  Diagnostics large;
  EXPECT_FALSE(MakeAtlas(Pictures(1, 2, 2), 0xffffffffu, {}, "a", {}, large));
  ASSERT_EQ(large.all().size(), 1u);
  EXPECT_EQ(large.all()[0].kind, DiagnosticKind::kSizeLimit);
}

}  // namespace
}  // namespace texgraph::textures
