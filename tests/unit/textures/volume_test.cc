// SPDX-License-Identifier: Apache-2.0
// Textures with three axes, and those that hold numbers.
#include <gtest/gtest.h>
#include <string.h>

#include "compiler/textures/texels.h"
#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures {
namespace {

using test::MakeImage;

TextureOptions VolumeOptions() {
  TextureOptions options;
  options.is_3d = true;
  options.srgb = false;
  options.as_float = true;
  return options;
}

TextureData Make(const std::vector<Image>& slices, const TextureOptions& options) {
  Diagnostics diagnostics;
  auto data = MakeTexture(slices, options, "t", {}, diagnostics);
  EXPECT_TRUE(data);
  return data ? std::move(*data) : TextureData();
}

TEST(VolumeTest, SlicesGoUpFromZero) {
  const TextureData data =
      Make({MakeImage(1, 2, 1, 8, {1, 2}), MakeImage(1, 2, 1, 8, {3, 4})}, VolumeOptions());
  EXPECT_TRUE(data.is_3d);
  EXPECT_FALSE(data.is_array);
  EXPECT_EQ(data.layers, 1u);
  EXPECT_EQ(data.levels[0].depth, 2u);
  const ir::Texture texture = ToTexture(data);
  EXPECT_TRUE(texture.is_3d);
  const int32_t top_of_first[] = {0, 1, 0};
  const int32_t bottom_of_second[] = {0, 0, 1};
  EXPECT_EQ(ir::Fetch(texture, top_of_first, 0)[0], 1 / 255.0f);
  EXPECT_EQ(ir::Fetch(texture, bottom_of_second, 0)[0], 4 / 255.0f);
}

TEST(VolumeTest, LevelsAverageEightTexels) {
  std::vector<Image> slices;
  double sum[4] = {};
  for (uint32_t z = 0; z < 4; ++z) {
    slices.push_back(test::RandomImage(4, 2, 1, 8, z));
    for (uint32_t y = 0; y < 2; ++y) {
      for (uint32_t x = 0; x < 4; ++x) sum[z / 2 * 2 + x / 2] += slices[z].At(x, y, 0) / 255.0;
    }
  }
  const TextureData data = Make(slices, VolumeOptions());
  ASSERT_EQ(data.levels.size(), 3u);
  EXPECT_EQ(data.levels[1].width, 2u);
  EXPECT_EQ(data.levels[1].height, 1u);
  EXPECT_EQ(data.levels[1].depth, 2u);
  EXPECT_EQ(data.levels[2].depth, 1u);
  const ir::Texture texture = ToTexture(data);
  for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(texture.levels[1].texels[i][0], sum[i] / 8, 1e-6) << i;
  EXPECT_NEAR(texture.levels[2].texels[0][0], (sum[0] + sum[1] + sum[2] + sum[3]) / 32, 1e-6);
}

// An opaque red texel among seven transparent ones: an eighth of it, but as red.
TEST(VolumeTest, OpacityWeighsColors) {
  TextureOptions options = VolumeOptions();
  options.alpha_is_opacity = true;
  std::vector<uint32_t> red(16, 0);
  red[0] = red[3] = 255;
  const TextureData data = Make(
      {MakeImage(2, 2, 4, 8, red), MakeImage(2, 2, 4, 8, std::vector<uint32_t>(16, 0))}, options);
  const ir::Texel texel = ToTexture(data).levels[1].texels[0];
  EXPECT_NEAR(texel[0], 1.0, 1e-4);
  EXPECT_NEAR(texel[3], 1.0 / 8, 1e-6);
}

TEST(VolumeTest, WrapsEachAxisByItself) {
  TextureOptions options = VolumeOptions();
  options.wrap_u = ir::Wrap::kMirror;
  options.wrap_w = ir::Wrap::kClamp;
  const Image slice = MakeImage(1, 1, 1, 8, {1});
  EXPECT_EQ(Make({slice}, options).sampler.wrap_w, ir::Wrap::kClamp);
  options.wrap_w = ir::Wrap::kRepeat;
  EXPECT_EQ(Make({slice}, options).sampler.wrap_w, ir::Wrap::kRepeat);
  options.is_3d = false;
  EXPECT_EQ(Make({slice}, options).sampler.wrap_w, ir::Wrap::kClamp);  // layers of an array do not
}

TEST(VolumeTest, RefusesUnequalSlices) {
  const Image slices[] = {MakeImage(1, 1, 1, 8, {1}), MakeImage(1, 2, 1, 8, {3, 4})};
  Diagnostics diagnostics;
  EXPECT_FALSE(MakeTexture(slices, VolumeOptions(), "t", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(DiagnosticName(diagnostics.all()[0].kind), "bad-image");
}

TEST(NumberFormatTest, AShaderReadsTheNumber) {
  TextureData data;
  data.format = TexelFormat::kR16F;
  TexelLevel& level = data.levels.emplace_back();
  level.width = 3;
  for (uint16_t half : {0xbc00, 0x0000, 0x6800}) {  // -1, 0, 2048
    const auto* bytes = reinterpret_cast<const uint8_t*>(&half);
    level.bytes.insert(level.bytes.end(), bytes, bytes + 2);
  }
  const ir::Texture halves = ToTexture(data);
  EXPECT_EQ(halves.levels[0].texels[0], (ir::Texel{-1, 0, 0, 1}));
  EXPECT_EQ(halves.levels[0].texels[1], (ir::Texel{0, 0, 0, 1}));
  EXPECT_EQ(halves.levels[0].texels[2], (ir::Texel{2048, 0, 0, 1}));
  data.format = TexelFormat::kR32F;
  level.width = 1;
  level.bytes.resize(4);
  const float large = 16777215.0f;
  memcpy(level.bytes.data(), &large, 4);
  EXPECT_EQ(ToTexture(data).levels[0].texels[0], (ir::Texel{large, 0, 0, 1}));
  EXPECT_EQ(TexelBytes(TexelFormat::kR16F), 2u);
  EXPECT_EQ(TexelBytes(TexelFormat::kR32F), 4u);
}

}  // namespace
}  // namespace texgraph::textures
