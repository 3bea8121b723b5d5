// SPDX-License-Identifier: Apache-2.0
// Masks and colour keys against pictures whose alpha and colour are known because they were mixed
// here, by C = alpha F + (1 - alpha) K.
#include "compiler/textures/prepare.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "compiler/textures/fill.h"
#include "compiler/textures/srgb.h"
#include "compiler/textures/texels.h"
#include "tests/unit/runtime/image_files.h"

namespace texgraph::textures {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Color = std::array<double, 3>;
using Codes = std::array<uint32_t, 4>;

Image MakeImage(uint32_t width, uint32_t height, uint8_t channels,
                const std::function<uint8_t(uint32_t, uint32_t, uint32_t)>& sample) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = channels;
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      for (uint32_t c = 0; c < channels; ++c) image.pixels.push_back(sample(x, y, c));
    }
  }
  return image;
}

Codes At(const Image& image, uint32_t x, uint32_t y) {
  return {image.At(x, y, 0), image.At(x, y, 1), image.At(x, y, 2), image.At(x, y, 3)};
}

Image Prepare(const Image& picture, const PictureSource& source, const Image* mask = nullptr) {
  bool left = false;
  return PreparePicture(picture, mask, source, left);
}

PictureSource Keyed(std::array<float, 3> color, float tolerance, uint32_t edge) {
  PictureSource source;
  source.key = ColorKey{color, tolerance, edge};
  return source;
}

// How much of a texel a disc with a rim of `rim` texels covers.
double Coverage(uint32_t x, uint32_t y, double radius, double rim) {
  const double distance = std::hypot(x + 0.5 - 32, y + 0.5 - 32);
  return std::clamp((radius - distance) / rim + 0.5, 0.0, 1.0);
}

// A disc of linear colour `full` before `key`, mixed in linear light or, without `srgb`, as
// numbers.
Image Disc(const Color& full, const Color& key, double radius, double rim, bool srgb) {
  return MakeImage(64, 64, 3, [&](uint32_t x, uint32_t y, uint32_t c) {
    const double a = Coverage(x, y, radius, rim);
    const auto mixed = static_cast<float>(a * full[c] + (1 - a) * key[c]);
    return srgb ? SrgbEncode8(mixed) : Unorm8(mixed);
  });
}

double Linear(uint32_t code, bool srgb) { return srgb ? SrgbDecode(code / 255.0) : code / 255.0; }

struct KeyCase {
  Color full, key;
  bool srgb;
};

class KeyTest : public testing::TestWithParam<KeyCase> {};

INSTANTIATE_TEST_SUITE_P(Colors, KeyTest,
                         testing::Values(KeyCase{{0.6, 0.3, 0.1}, {0, 0, 0}, true},
                                         KeyCase{{0.05, 0.3, 0.02}, {1, 1, 1}, true},
                                         KeyCase{{0.7, 0.2, 0.1}, {0, 1, 0}, true},
                                         KeyCase{{0.5, 0.5, 1}, {0, 0, 0}, false}));

TEST_P(KeyTest, FindsAlphaAndColorOfASoftEdge) {
  const auto& [full, key, srgb] = GetParam();
  PictureSource source =
      Keyed({static_cast<float>(key[0]), static_cast<float>(key[1]), static_cast<float>(key[2])},
            0.02f, 4);
  source.srgb = srgb;
  const Image image = Prepare(Disc(full, key, 20, 3, srgb), source);
  ASSERT_EQ(image.channels, 4);
  double sum = 0, expected = 0;
  for (uint32_t y = 0; y < 64; ++y) {
    for (uint32_t x = 0; x < 64; ++x) {
      const double alpha = image.At(x, y, 3) / 255.0, a = Coverage(x, y, 20, 3);
      // What the tolerance takes away: 0.02 near white is 0.05 in linear light.
      EXPECT_NEAR(alpha, a, 0.06) << x << " " << y;
      sum += alpha;
      expected += a;
      // The texels that are transparent, too.
      for (uint32_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(Linear(image.At(x, y, c), srgb), full[c], 0.03) << x << " " << y << " " << c;
      }
    }
  }
  EXPECT_NEAR(sum, expected, 0.005 * expected);
}

TEST_P(KeyTest, NoMipLevelShowsTheBackground) {
  const auto& [full, key, srgb] = GetParam();
  PictureSource source =
      Keyed({static_cast<float>(key[0]), static_cast<float>(key[1]), static_cast<float>(key[2])},
            0.02f, 4);
  source.srgb = srgb;
  const Image image = Prepare(Disc(full, key, 20, 3, srgb), source);
  TextureOptions options;
  options.srgb = srgb;
  options.alpha_is_opacity = true;
  options.as_float = true;
  Diagnostics diagnostics;
  const auto data = MakeTexture({&image, 1}, options, "t", {}, diagnostics);
  ASSERT_TRUE(data);
  const ir::Texture texture = ToTexture(*data);
  ASSERT_EQ(texture.levels.size(), 7u);
  for (const ir::Texture::Level& level : texture.levels) {
    double alpha = 0;
    for (const auto& texel : level.texels) {
      for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(texel[c], full[c], 0.03);
      alpha += texel[3] / static_cast<double>(level.texels.size());
    }
    EXPECT_NEAR(alpha, M_PI * 20 * 20 / (64 * 64), 0.004);
  }
}

// 0.1 is 25.5 of 255, and each channel counts for itself.
TEST(Key, ToleranceIsOfTheNumbersOfThePicture) {
  const Image picture = MakeImage(4, 1, 3, [](uint32_t x, uint32_t, uint32_t c) -> uint8_t {
    const uint8_t samples[4][3] = {{25, 25, 25}, {26, 0, 0}, {0, 0, 255}, {0, 25, 3}};
    return samples[x][c];
  });
  const Image image = Prepare(picture, Keyed({0, 0, 0}, 0.1f, 0));
  EXPECT_EQ(image.At(0, 0, 3), 0u);
  EXPECT_EQ(image.At(3, 0, 3), 0u);
  // Without an edge what is kept stays to the bit.
  EXPECT_THAT(At(image, 1, 0), ElementsAre(26, 0, 0, 255));
  EXPECT_THAT(At(image, 2, 0), ElementsAre(0, 0, 255, 255));
  // A limit on a number of the picture includes it.
  EXPECT_EQ(Prepare(picture, Keyed({0, 0, 0}, 26 / 255.0f, 0)).At(1, 0, 3), 0u);
}

TEST(Key, WhatIsFarFromTheBackgroundStaysToTheBit) {
  const Image picture = MakeImage(16, 16, 3, [](uint32_t x, uint32_t y, uint32_t c) {
    return static_cast<uint8_t>(x < 4 ? 0 : 40 + 11 * ((7 * x + 3 * y + 5 * c) % 17));
  });
  const Image image = Prepare(picture, Keyed({0, 0, 0}, 0.05f, 3));
  for (uint32_t y = 0; y < 16; ++y) {
    for (uint32_t x = 7; x < 16; ++x) {
      EXPECT_THAT(At(image, x, y),
                  ElementsAre(picture.At(x, y, 0), picture.At(x, y, 1), picture.At(x, y, 2), 255));
    }
  }
}

// White under an alpha of 0 does not make the colour next to it lighter.
TEST(Key, HiddenColorsDoNotCount) {
  const uint8_t half = SrgbEncode8(0.2f), full = SrgbEncode8(0.4f);
  const Image picture = MakeImage(16, 1, 4, [&](uint32_t x, uint32_t, uint32_t c) -> uint8_t {
    if (c == 3) return x < 8 ? 255 : 0;
    return x < 4 ? 0 : x == 4 ? half : x < 8 ? full : 255;
  });
  const Image image = Prepare(picture, Keyed({0, 0, 0}, 0.05f, 3));
  EXPECT_NEAR(image.At(4, 0, 3), 128, 4);
  for (uint32_t x = 0; x < 16; ++x) {
    EXPECT_NEAR(image.At(x, 0, 0), full, 3) << x;
    if (x != 4) {
      EXPECT_NEAR(image.At(x, 0, 3), x > 4 && x < 8 ? 255 : 0, 4) << x;
    }
  }
}

// A line one texel wide has no inside. Its texels stand for themselves.
TEST(Key, ThinLinesStay) {
  const Image picture = MakeImage(32, 32, 3, [](uint32_t x, uint32_t, uint32_t c) -> uint8_t {
    const uint8_t line[3] = {200, 120, 30};
    return x == 13 ? line[c] : 0;
  });
  const Image image = Prepare(picture, Keyed({0, 0, 0}, 0.05f, 2));
  for (uint32_t y = 0; y < 32; ++y) {
    EXPECT_NEAR(image.At(13, y, 0), 200, 3);
    EXPECT_NEAR(image.At(13, y, 1), 120, 3);
    EXPECT_GE(image.At(13, y, 3), 250u);
    EXPECT_EQ(image.At(12, y, 3), 0u);
  }
}

TEST(Key, PicturesWithNothingOrAllOfTheColor) {
  const auto grey = [](uint8_t value) {
    return MakeImage(5, 3, 1, [=](uint32_t, uint32_t, uint32_t) { return value; });
  };
  bool left = true;
  const PictureSource source = Keyed({0, 0, 0}, 0.05f, 2);
  Image image = PreparePicture(grey(3), nullptr, source, left);
  EXPECT_FALSE(left);
  EXPECT_THAT(At(image, 4, 2), ElementsAre(3, 3, 3, 0));
  image = PreparePicture(grey(200), nullptr, source, left);
  EXPECT_TRUE(left);
  EXPECT_THAT(At(image, 4, 2), ElementsAre(200, 200, 200, 255));
  // A picture that is transparent everywhere.
  const Image none =
      MakeImage(3, 3, 4, [](uint32_t, uint32_t, uint32_t c) -> uint8_t { return c == 3 ? 0 : 90; });
  image = PreparePicture(none, nullptr, source, left);
  EXPECT_FALSE(left);
  EXPECT_THAT(At(image, 1, 1), ElementsAre(90, 90, 90, 0));
}

TEST(Mask, BecomesAlphaTimesThePicturesOwn) {
  const Image picture = MakeImage(3, 1, 4, [](uint32_t x, uint32_t, uint32_t c) -> uint8_t {
    return c == 3 ? (x == 2 ? 128 : 255) : static_cast<uint8_t>(50 + 60 * x + c);
  });
  const Image mask = MakeImage(3, 1, 4, [](uint32_t x, uint32_t, uint32_t c) -> uint8_t {
    const uint8_t samples[3][4] = {{255, 10, 20, 30}, {0, 100, 110, 120}, {102, 200, 255, 51}};
    return samples[x][c];
  });
  const auto alphas = [&](MaskChannel channel, bool invert) {
    PictureSource source;
    source.mask = MaskSource{"m", {}, channel, invert};
    const Image image = Prepare(picture, source, &mask);
    return std::array<uint32_t, 3>{image.At(0, 0, 3), image.At(1, 0, 3), image.At(2, 0, 3)};
  };
  // 128 / 255 of 102, 200, 255 and 51.
  EXPECT_THAT(alphas(MaskChannel::kRed, false), ElementsAre(255, 0, 51));
  EXPECT_THAT(alphas(MaskChannel::kGreen, false), ElementsAre(10, 100, 100));
  EXPECT_THAT(alphas(MaskChannel::kBlue, false), ElementsAre(20, 110, 128));
  EXPECT_THAT(alphas(MaskChannel::kAlpha, false), ElementsAre(30, 120, 26));
  EXPECT_THAT(alphas(MaskChannel::kRed, true), ElementsAre(0, 255, 77));
}

TEST(Mask, ColorsStayWhereTheyShowAndSpreadWhereNot) {
  const Image picture = MakeImage(8, 8, 3, [](uint32_t x, uint32_t, uint32_t c) -> uint8_t {
    const uint8_t sides[2][3] = {{10, 20, 30}, {200, 100, 50}};
    return sides[x / 4][c];
  });
  const Image mask = MakeImage(8, 8, 1, [](uint32_t x, uint32_t, uint32_t) -> uint8_t {
    return x < 4 ? 0 : x == 4 ? 7 : 255;
  });
  PictureSource source;
  source.mask = MaskSource{"m", {}, MaskChannel::kRed, false};
  const Image image = Prepare(picture, source, &mask);
  for (uint32_t y = 0; y < 8; ++y) {
    for (uint32_t x = 0; x < 8; ++x) {
      EXPECT_THAT(At(image, x, y), ElementsAre(200, 100, 50, mask.At(x, y, 0)));
    }
  }
}

TEST(Mask, AndAKeyAreMultiplied) {
  const Image picture =
      MakeImage(4, 1, 1, [](uint32_t x, uint32_t, uint32_t) -> uint8_t { return x < 2 ? 0 : 250; });
  const Image mask = MakeImage(
      4, 1, 1, [](uint32_t x, uint32_t, uint32_t) -> uint8_t { return x % 2 == 0 ? 0 : 100; });
  PictureSource source = Keyed({0, 0, 0}, 0.05f, 0);
  source.mask = MaskSource{"m", {}, MaskChannel::kRed, false};
  const Image image = Prepare(picture, source, &mask);
  for (uint32_t x = 0; x < 4; ++x) EXPECT_EQ(image.At(x, 0, 3), x == 3 ? 100u : 0u);
  for (uint32_t x = 0; x < 4; ++x) EXPECT_EQ(image.At(x, 0, 0), 250u);
}

TEST(Mask, SixteenBitsOfEitherAreKept) {
  Image deep;
  deep.width = deep.height = 1;
  deep.channels = 1;
  deep.bits = 16;
  deep.pixels = {0x34, 0x12};
  const uint32_t sample = deep.At(0, 0, 0);
  const Image shallow =
      MakeImage(1, 1, 1, [](uint32_t, uint32_t, uint32_t) { return uint8_t{77}; });
  PictureSource source;
  source.mask = MaskSource{"m", {}, MaskChannel::kRed, false};
  Image image = Prepare(shallow, source, &deep);
  EXPECT_EQ(image.bits, 16);
  EXPECT_THAT(At(image, 0, 0), ElementsAre(77 * 257, 77 * 257, 77 * 257, sample));
  image = Prepare(deep, source, &shallow);
  EXPECT_THAT(At(image, 0, 0), ElementsAre(sample, sample, sample, 77 * 257));
}

class ReadPictureTest : public testing::Test {
 protected:
  static std::string Write(const std::string& name, const Image& image) {
    return test::WriteTemporary(name, *EncodePng(image));
  }
  static Image Grey(uint32_t width, uint32_t height, uint8_t value) {
    return MakeImage(width, height, 1, [=](uint32_t, uint32_t, uint32_t) { return value; });
  }
  std::string Report() const { return FormatDiagnostics(diagnostics, Sources(), false); }
  Diagnostics diagnostics;
};

TEST_F(ReadPictureTest, SizesMustAgree) {
  PictureSource source;
  source.file = Write("prepare_picture.png", Grey(4, 3, 9));
  source.mask = MaskSource{Write("prepare_mask.png", Grey(3, 4, 9)), {}, MaskChannel::kRed, false};
  EXPECT_FALSE(ReadPicture(source, diagnostics));
  EXPECT_THAT(Report(), HasSubstr("prepare_mask.png' has 3 x 4 pixels, its picture '"));
  EXPECT_THAT(Report(),
              HasSubstr("prepare_picture.png' 4 x 3; they must be equally large [bad-image]"));
}

TEST_F(ReadPictureTest, BothFilesAreReported) {
  PictureSource source;
  source.file = "/nothing/a.png";
  source.mask = MaskSource{"/nothing/b.png", {}, MaskChannel::kRed, false};
  EXPECT_FALSE(ReadPicture(source, diagnostics));
  EXPECT_EQ(diagnostics.error_count(), 2u);
  EXPECT_THAT(Report(), HasSubstr("'/nothing/b.png' [missing-file]"));
}

TEST_F(ReadPictureTest, NothingLeftIsAWarning) {
  PictureSource source;
  source.file = Write("prepare_black.png", Grey(4, 4, 0));
  source.key = ColorKey{};
  EXPECT_TRUE(ReadPicture(source, diagnostics));
  EXPECT_FALSE(diagnostics.HasErrors());
  EXPECT_THAT(Report(), HasSubstr("warning: nothing is left of image '"));
  // Without key and mask a picture is what its file has.
  source.key.reset();
  EXPECT_EQ(ReadPicture(source, diagnostics)->channels, 1);
}

TEST(FillColorsTest, KnownOnesStayAndTheOthersFollow) {
  for (auto [width, height] : {std::pair(7u, 5u), {1u, 9u}, {8u, 8u}, {1u, 1u}, {33u, 2u}}) {
    std::vector<std::array<float, 4>> texels(size_t{width} * height);
    EXPECT_FALSE(FillColors(texels, width, height));
    // One colour, wherever it is known, is everywhere.
    texels[texels.size() / 2] = {0.25f, 0.5f, 1, 1};
    texels[0] = {0.25f * 0.125f, 0.5f * 0.125f, 0.125f, 0.125f};
    ASSERT_TRUE(FillColors(texels, width, height));
    for (const auto& texel : texels) {
      EXPECT_NEAR(texel[0], 0.25f, 1e-6);
      EXPECT_NEAR(texel[2], 1, 1e-6);
      EXPECT_EQ(texel[3], 1);
    }
  }
  // Between a black and a white side it rises, and never leaves their range.
  std::vector<std::array<float, 4>> texels(64 * 4);
  for (size_t y = 0; y < 4; ++y) {
    texels[y * 64] = {0, 0, 0, 1};
    texels[y * 64 + 63] = {1, 1, 1, 1};
  }
  ASSERT_TRUE(FillColors(texels, 64, 4));
  for (size_t x = 1; x < 64; ++x) EXPECT_GE(texels[x][0], texels[x - 1][0] - 1e-6f) << x;
  EXPECT_EQ(texels[0][0], 0);
  EXPECT_EQ(texels[63][0], 1);
  EXPECT_NEAR(texels[16][0] + texels[47][0], 1, 1e-5);
}

}  // namespace
}  // namespace texgraph::textures
