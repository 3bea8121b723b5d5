// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/texels.h"

#include <gtest/gtest.h>
#include <string.h>

#include <cmath>
#include <random>

#include "compiler/textures/srgb.h"

namespace texgraph::textures {
namespace {

Image MakeImage(uint32_t width, uint32_t height, uint8_t channels, uint8_t bits,
                const std::vector<uint32_t>& samples) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = channels;
  image.bits = bits;
  for (uint32_t sample : samples) {
    if (bits == 8) {
      image.pixels.push_back(static_cast<uint8_t>(sample));
    } else {
      const uint16_t deep = static_cast<uint16_t>(sample);
      const auto* bytes = reinterpret_cast<const uint8_t*>(&deep);
      image.pixels.insert(image.pixels.end(), bytes, bytes + 2);
    }
  }
  return image;
}

TextureData Make(const Image& image, const TextureOptions& options) {
  Diagnostics diagnostics;
  auto data = MakeTexture(std::span<const Image>(&image, 1), options, "t", {}, diagnostics);
  EXPECT_TRUE(data);
  return data ? *data : TextureData();
}

std::array<uint8_t, 4> Bytes(const TextureData& data, size_t level, size_t texel) {
  std::array<uint8_t, 4> bytes;
  memcpy(bytes.data(), data.levels[level].bytes.data() + 4 * texel, 4);
  return bytes;
}

// The standard's own anchors: its two branches meet, and middle grey is where tables print it.
TEST(SrgbTest, FollowsTheStandard) {
  EXPECT_EQ(SrgbDecode(0), 0);
  EXPECT_NEAR(SrgbDecode(1), 1, 1e-15);
  EXPECT_NEAR(SrgbDecode(0.04045), 0.04045 / 12.92, 1e-9);
  EXPECT_NEAR(SrgbDecode(0.5), 0.2140411405, 1e-9);
  EXPECT_NEAR(SrgbEncode(0.18), 0.4613561, 1e-6);
  EXPECT_NEAR(SrgbEncode(0.001), 0.01292, 1e-9);
}

TEST(SrgbTest, EveryCodeReturns) {
  for (uint32_t code = 0; code < 256; ++code) {
    EXPECT_EQ(SrgbEncode8(SrgbDecode8(static_cast<uint8_t>(code))), code);
  }
}

TEST(SrgbTest, TheTableIsTheFormula) {
  for (int i = -10; i <= 100010; ++i) {
    const float linear = static_cast<float>(i) / 100000.0f;
    const double exact = 255 * SrgbEncode(std::clamp(static_cast<double>(linear), 0.0, 1.0));
    // Within a rounding step; at a tie of the formula the table may be on either side.
    ASSERT_NEAR(SrgbEncode8(linear), exact, 0.5001) << linear;
  }
  EXPECT_EQ(SrgbEncode8(NAN), 0);
  EXPECT_EQ(SrgbEncode8(-INFINITY), 0);
  EXPECT_EQ(SrgbEncode8(INFINITY), 255);
  EXPECT_EQ(SrgbEncode16(INFINITY), 65535);
  EXPECT_EQ(Unorm8(NAN), 0);
  EXPECT_EQ(Unorm16(2.0f), 65535);
}

TEST(TexelsTest, SpreadsChannelsAndTurnsRows) {
  TextureOptions options;
  options.srgb = false;
  options.mipmaps = false;
  using Four = std::array<uint8_t, 4>;
  // The picture's top row is v = 1: the last row of texels.
  const TextureData grey = Make(MakeImage(1, 2, 1, 8, {10, 20}), options);
  EXPECT_EQ(grey.format, TexelFormat::kRgba8);
  EXPECT_EQ(grey.levels.size(), 1u);
  EXPECT_EQ(Bytes(grey, 0, 0), (Four{20, 20, 20, 255}));
  EXPECT_EQ(Bytes(grey, 0, 1), (Four{10, 10, 10, 255}));
  EXPECT_EQ(Bytes(Make(MakeImage(1, 1, 2, 8, {10, 20}), options), 0, 0), (Four{10, 10, 10, 20}));
  EXPECT_EQ(Bytes(Make(MakeImage(1, 1, 3, 8, {1, 2, 3}), options), 0, 0), (Four{1, 2, 3, 255}));
  EXPECT_EQ(Bytes(Make(MakeImage(1, 1, 4, 8, {1, 2, 3, 4}), options), 0, 0), (Four{1, 2, 3, 4}));
}

TEST(TexelsTest, KeepsEveryByteOfTheBaseLevel) {
  std::vector<uint32_t> samples(256 * 4);
  for (uint32_t i = 0; i < 256; ++i) {
    for (uint32_t c = 0; c < 4; ++c) samples[4 * i + c] = (i * (2 * c + 1)) % 256;
  }
  for (bool srgb : {false, true}) {
    TextureOptions options;
    options.srgb = srgb;
    const TextureData data = Make(MakeImage(256, 1, 4, 8, samples), options);
    EXPECT_EQ(data.format, srgb ? TexelFormat::kSrgb8Alpha8 : TexelFormat::kRgba8);
    for (size_t i = 0; i < samples.size(); ++i) ASSERT_EQ(data.levels[0].bytes[i], samples[i]);
  }
}

// Black and white average to 1/2 of the light: 188 in sRGB, not 128; alpha is linear.
TEST(TexelsTest, AveragesLight) {
  const Image image =
      MakeImage(2, 2, 4, 8, {0, 0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0});
  const TextureData srgb = Make(image, {});
  ASSERT_EQ(srgb.levels.size(), 2u);
  EXPECT_EQ(Bytes(srgb, 1, 0), (std::array<uint8_t, 4>{188, 188, 188, 128}));
  TextureOptions linear;
  linear.srgb = false;
  EXPECT_EQ(Bytes(Make(image, linear), 1, 0), (std::array<uint8_t, 4>{128, 128, 128, 128}));
}

TEST(TexelsTest, MakesLevelsToTheLimit) {
  const Image image = MakeImage(37, 5, 1, 8, std::vector<uint32_t>(37 * 5, 9));
  const TextureData all = Make(image, {});
  ASSERT_EQ(all.levels.size(), 6u);  // 37 18 9 4 2 1
  const uint32_t widths[] = {37, 18, 9, 4, 2, 1};
  const uint32_t heights[] = {5, 2, 1, 1, 1, 1};
  for (size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(all.levels[i].width, widths[i]);
    EXPECT_EQ(all.levels[i].height, heights[i]);
    EXPECT_EQ(Bytes(all, i, 0)[0], 9);  // the average of equal texels
  }
  TextureOptions options;
  options.max_level = 2;
  EXPECT_EQ(Make(image, options).levels.size(), 3u);
  options.max_level = 0;
  EXPECT_EQ(Make(image, options).levels.size(), 1u);
  options.max_level = 20;
  EXPECT_EQ(Make(image, options).levels.size(), 6u);
}

TEST(TexelsTest, SixteenBitsStayDeep) {
  TextureOptions options;
  options.srgb = false;
  const TextureData linear = Make(MakeImage(1, 1, 1, 16, {0x1234}), options);
  EXPECT_EQ(linear.format, TexelFormat::kRgba16);
  EXPECT_EQ(ToTexture(linear).levels[0].texels[0][0], 0x1234 / 65535.0f);
  options.srgb = true;
  const TextureData srgb = Make(MakeImage(1, 1, 1, 16, {32768}), options);
  EXPECT_NEAR(ToTexture(srgb).levels[0].texels[0][0], SrgbDecode(32768 / 65535.0), 0.5 / 65535);
}

TEST(TexelsTest, DecodesWhatAGpuSees) {
  const Image image = MakeImage(2, 1, 4, 8, {0, 128, 255, 64, 1, 2, 3, 4});
  const ir::Texture texture = ToTexture(Make(image, {}));
  EXPECT_EQ(texture.levels[0].texels[0][0], 0.0f);
  EXPECT_NEAR(texture.levels[0].texels[0][1], 0.21586, 1e-5);
  EXPECT_EQ(texture.levels[0].texels[0][2], 1.0f);
  EXPECT_EQ(texture.levels[0].texels[0][3], 64 / 255.0f);
  TextureOptions exact;
  exact.as_float = true;
  const TextureData floats = Make(image, exact);
  EXPECT_EQ(floats.format, TexelFormat::kRgba32F);
  EXPECT_EQ(ToTexture(floats).levels[0].texels, texture.levels[0].texels);
}

TEST(TexelsTest, LayersOfAnArray) {
  const Image layers[] = {MakeImage(1, 2, 1, 8, {1, 2}), MakeImage(1, 2, 1, 8, {3, 4})};
  TextureOptions options;
  options.is_array = true;
  options.srgb = false;
  Diagnostics diagnostics;
  const auto data = MakeTexture(layers, options, "t", {}, diagnostics);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->layers, 2u);
  const ir::Texture texture = ToTexture(*data);
  ASSERT_EQ(texture.levels.size(), 2u);
  EXPECT_EQ(texture.levels[0].depth, 2u);
  EXPECT_EQ(texture.levels[1].depth, 2u);
  EXPECT_EQ(texture.levels[0].texels[0][0], 2 / 255.0f);  // layer 0, bottom row
  EXPECT_EQ(texture.levels[0].texels[3][0], 3 / 255.0f);  // layer 1, top row
}

TEST(TexelsTest, RefusesUnequalLayers) {
  const Image layers[] = {MakeImage(1, 1, 1, 8, {1}), MakeImage(1, 2, 1, 8, {3, 4})};
  TextureOptions options;
  Diagnostics several;
  EXPECT_FALSE(MakeTexture(layers, options, "t", {}, several));
  options.is_array = true;
  Diagnostics diagnostics;
  EXPECT_FALSE(MakeTexture(layers, options, "t", {}, diagnostics));
  EXPECT_EQ(DiagnosticName(diagnostics.all().front().kind), "bad-image");
  EXPECT_FALSE(MakeTexture({}, options, "t", {}, diagnostics));
}

TEST(TexelsTest, SamplerFollowsTheOptions) {
  const Image image = MakeImage(1, 1, 1, 8, {1});
  TextureOptions options;
  options.wrap_v = ir::Wrap::kMirror;
  EXPECT_EQ(Make(image, options).sampler.mip_filter, ir::MipFilter::kLinear);
  EXPECT_EQ(Make(image, options).sampler.wrap_v, ir::Wrap::kMirror);
  options.filter = ir::Filter::kNearest;
  EXPECT_EQ(Make(image, options).sampler.mip_filter, ir::MipFilter::kNearest);
  options.mipmaps = false;
  EXPECT_EQ(Make(image, options).sampler.mip_filter, ir::MipFilter::kNone);
}

// A red texel of half opacity and one of full, the rest transparent and black.
TEST(TexelsTest, OpacityWeighsTheColorsOfMipLevels) {
  const Image image =
      MakeImage(2, 2, 4, 8, {255, 0, 0, 102, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 255, 255});
  TextureOptions options;
  options.srgb = false;
  options.as_float = true;
  options.alpha_is_opacity = true;
  const ir::Texture weighed = ToTexture(Make(image, options));
  const auto& texel = weighed.levels[1].texels[0];
  // 0.4 of red and 1 of blue.
  EXPECT_NEAR(texel[0], 0.4 / 1.4, 1e-5);
  EXPECT_NEAR(texel[2], 1 / 1.4, 1e-5);
  EXPECT_NEAR(texel[3], 1.4 / 4, 1e-6);
  // Level 0 is the picture.
  EXPECT_EQ(weighed.levels[0].texels[1], (std::array<float, 4>{0, 0, 1, 1}));
  options.alpha_is_opacity = false;
  const auto plain = ToTexture(Make(image, options)).levels[1].texels[0];
  EXPECT_NEAR(plain[0], 0.25, 1e-6);
  EXPECT_NEAR(plain[3], 1.4 / 4, 1e-6);
}

TEST(TexelsTest, TransparentTexelsHaveTheirPlainMean) {
  const Image image = MakeImage(2, 1, 4, 8, {255, 0, 51, 0, 0, 102, 153, 0});
  TextureOptions options;
  options.srgb = false;
  options.as_float = true;
  options.alpha_is_opacity = true;
  const auto texel = ToTexture(Make(image, options)).levels[1].texels[0];
  EXPECT_NEAR(texel[0], 0.5, 1e-6);
  EXPECT_NEAR(texel[1], 0.2, 1e-6);
  EXPECT_NEAR(texel[2], 0.4, 1e-6);
  EXPECT_EQ(texel[3], 0);
}

}  // namespace
}  // namespace texgraph::textures
