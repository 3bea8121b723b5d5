// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/map_filter.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "compiler/textures/gaussian.h"
#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures {
namespace {

using test::MakeImage;
using test::RandomImage;

TextureOptions Floats() {
  TextureOptions options;
  options.srgb = false;
  options.as_float = true;
  return options;
}

ir::Texture Filtered(const Image& map, const MapFilterOptions& options = {},
                     const TextureOptions& texture = Floats()) {
  Diagnostics diagnostics;
  const auto data = MakeColorMap(map, texture, options, "map", {}, diagnostics);
  EXPECT_TRUE(data);
  return data ? ToTexture(*data) : ir::Texture{};
}

const ir::Texel& At(const ir::Texture& texture, uint32_t x, uint32_t y, uint32_t layer) {
  const ir::Texture::Level& level = texture.levels[0];
  return level.texels[(size_t{layer} * level.height + y) * level.width + x];
}

// A map of 16 bits with red by column and green by row.
template <class Red, class Green>
Image MapOf(uint32_t width, uint32_t height, Red red, Green green) {
  std::vector<uint32_t> samples;
  for (uint32_t row = height; row-- > 0;) {
    for (uint32_t x = 0; x < width; ++x) {
      const auto bits = [](double v) { return static_cast<uint32_t>(std::lround(v * 65535)); };
      samples.insert(samples.end(), {bits(red(x)), bits(green(row)), 0});
    }
  }
  return MakeImage(width, height, 3, 16, samples);
}

TEST(MapFilterTest, DeviationsDoubleAndMixBySquares) {
  const MapFilterOptions options;
  EXPECT_EQ(SigmaAt(options, 0), 0);
  for (uint32_t i = 1; i < 7; ++i) EXPECT_EQ(SigmaAt(options, i), std::ldexp(1.0, int(i)) / 256);
  for (double sigma = 0; sigma <= 0.25; sigma += 0.0007) {
    const double index = SigmaIndex(options, sigma);
    const auto below = static_cast<uint32_t>(std::min(index, 5.0));
    const double mixed = std::lerp(std::pow(SigmaAt(options, below), 2),
                                   std::pow(SigmaAt(options, below + 1), 2), index - below);
    EXPECT_NEAR(mixed, sigma * sigma, 1e-15) << sigma;
  }
  EXPECT_EQ(SigmaIndex(options, 0.25), 6);
  EXPECT_EQ(SigmaIndex(options, 9), 6);
  EXPECT_EQ(SigmaIndex(options, -1), 0);
  EXPECT_EQ(SigmaIndex(options, std::nan("")), 0);
  EXPECT_EQ(MapLayer(options, 2, 3), 23u);
}

TEST(MapFilterTest, WithoutDeviationItIsTheMap) {
  const Image map = RandomImage(19, 11, 4, 8, 3);
  Diagnostics diagnostics;
  TextureOptions options;
  options.mipmaps = false;
  const TextureData plain = *MakeTexture({&map, 1}, options, "map", {}, diagnostics);
  const TextureData data = *MakeColorMap(map, options, {}, "map", {}, diagnostics);
  EXPECT_EQ(data.format, TexelFormat::kSrgb8Alpha8);
  EXPECT_EQ(data.layers, 49u);
  EXPECT_TRUE(data.is_array);
  EXPECT_EQ(data.sampler.wrap_u, ir::Wrap::kClamp);
  EXPECT_EQ(data.sampler.mip_filter, ir::MipFilter::kNone);
  const std::vector<uint8_t>& all = data.levels[0].bytes;
  ASSERT_EQ(all.size(), 49 * plain.levels[0].bytes.size());
  EXPECT_TRUE(std::equal(plain.levels[0].bytes.begin(), plain.levels[0].bytes.end(), all.begin()));
}

TEST(MapFilterTest, AConstantStays) {
  const Image map = MakeImage(13, 6, 4, 8, [] {
    std::vector<uint32_t> samples;
    for (int i = 0; i < 13 * 6; ++i) samples.insert(samples.end(), {30, 100, 200, 255});
    return samples;
  }());
  const ir::Texture filtered = Filtered(map);
  for (const ir::Texel& texel : filtered.levels[0].texels) {
    EXPECT_NEAR(texel[0], 30 / 255.0, 1e-6);
    EXPECT_NEAR(texel[1], 100 / 255.0, 1e-6);
    EXPECT_NEAR(texel[2], 200 / 255.0, 1e-6);
    EXPECT_NEAR(texel[3], 1, 1e-6);
  }
}

// Red climbs along u and green along v: each is the integral of a ramp between two clamps, which is
// x away from them, whatever the other deviation is.
TEST(MapFilterTest, RampsHaveAClosedForm) {
  constexpr uint32_t kWidth = 64, kHeight = 32;
  const Image map = MapOf(
      kWidth, kHeight, [](uint32_t x) { return x / 63.0; }, [](uint32_t y) { return y / 31.0; });
  const MapFilterOptions options;
  const ir::Texture filtered = Filtered(map, options);
  const auto ramp = [](double x, double sigma) {
    return x * NormalCdf(x / sigma) + sigma * NormalDensity(x / sigma);
  };
  const auto expected = [&](double at, double last, double sigma) {
    return sigma == 0 ? at / last : (ramp(at, sigma) - ramp(at - last, sigma)) / last;
  };
  for (uint32_t j = 0; j < 7; ++j) {
    for (uint32_t i = 0; i < 7; ++i) {
      for (uint32_t y = 0; y < kHeight; y += 3) {
        for (uint32_t x = 0; x < kWidth; x += 3) {
          const ir::Texel& texel = At(filtered, x, y, MapLayer(options, i, j));
          EXPECT_NEAR(texel[0], expected(x, 63, SigmaAt(options, i) * 64), 2e-5);
          EXPECT_NEAR(texel[1], expected(y, 31, SigmaAt(options, j) * 32), 2e-5);
        }
      }
    }
  }
  EXPECT_NEAR(At(filtered, 32, 3, MapLayer(options, 4, 5))[0], 32 / 63.0, 2e-5);
}

// A step is linear over one texel, the mean of steps there: it is off from Phi by a 24th of its
// second derivative, at most 0.242 / sigma^2.
TEST(MapFilterTest, AStepIsPhi) {
  const Image map = MapOf(
      64, 4, [](uint32_t x) { return x < 20 ? 0.0 : 1.0; }, [](uint32_t) { return 0.0; });
  const MapFilterOptions options;
  const ir::Texture filtered = Filtered(map, options);
  for (uint32_t i = 3; i < 7; ++i) {
    const double sigma = SigmaAt(options, i) * 64;
    for (uint32_t x = 0; x < 64; ++x) {
      EXPECT_NEAR(At(filtered, x, 2, MapLayer(options, i, 6))[0], NormalCdf((x - 19.5) / sigma),
                  0.242 / 24 / (sigma * sigma) + 1e-6);
    }
  }
}

// The definition, by a sampler: the mean of the map at Gaussian places.
TEST(MapFilterTest, IsTheMeanOfWhatASamplerSees) {
  const Image map = RandomImage(10, 14, 3, 8, 6);
  MapFilterOptions options;
  options.sigmas = 4;
  options.greatest = 0.2;
  const ir::Texture filtered = Filtered(map, options);
  for (const auto& [i, j] : {std::pair(3u, 1u), std::pair(2u, 3u)}) {
    for (const auto& [x, y] : {std::pair(0u, 13u), std::pair(4u, 6u)}) {
      std::array<double, 3> sum{};
      double whole = 0;
      constexpr int kSteps = 201;
      for (int v = 0; v < kSteps; ++v) {
        for (int u = 0; u < kSteps; ++u) {
          const auto z = [](int n) { return (n / (kSteps - 1.0) * 2 - 1) * 5; };
          const double weight = NormalDensity(z(u)) * NormalDensity(z(v));
          const float at[3] = {float((x + 0.5) / 10 + SigmaAt(options, i) * z(u)),
                               float((y + 0.5) / 14 + SigmaAt(options, j) * z(v)), 0};
          const ir::Texel texel = ir::SampleLod(filtered, at, 0);
          for (size_t c = 0; c < 3; ++c) sum[c] += weight * texel[c];
          whole += weight;
        }
      }
      for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(At(filtered, x, y, MapLayer(options, i, j))[c], sum[c] / whole, 1e-3)
            << i << " " << j << " at " << x << " " << y;
      }
    }
  }
}

// A transparent half: what shows through the border is its alpha, not its colour.
TEST(MapFilterTest, AlphaWeighsColours) {
  std::vector<uint32_t> samples;
  for (int i = 0; i < 16 * 16; ++i) {
    const bool clear = i % 16 >= 8;
    samples.insert(samples.end(), {clear ? 255u : 51u, 102, 0, clear ? 0u : 255u});
  }
  const Image map = MakeImage(16, 16, 4, 8, samples);
  TextureOptions options = Floats();
  options.alpha_is_opacity = true;
  const ir::Texture filtered = Filtered(map, {}, options);
  const ir::Texel& middle = At(filtered, 9, 8, MapLayer({}, 5, 5));
  EXPECT_NEAR(middle[0], 0.2, 1e-4);
  EXPECT_GT(middle[3], 0.1);
  EXPECT_LT(middle[3], 0.5);
  options.alpha_is_opacity = false;
  EXPECT_GT(At(Filtered(map, {}, options), 9, 8, MapLayer({}, 5, 5))[0], 0.5);
}

TEST(MapFilterTest, ThreadsDoNotMatter) {
  const Image map = RandomImage(20, 20, 3, 16, 2);
  Diagnostics diagnostics;
  MapFilterOptions options;
  options.threads = 1;
  const TextureData one = *MakeColorMap(map, {}, options, "map", {}, diagnostics);
  EXPECT_EQ(one.format, TexelFormat::kRgba16);
  options.threads = 3;
  const TextureData three = *MakeColorMap(map, {}, options, "map", {}, diagnostics);
  EXPECT_EQ(one.levels[0].bytes, three.levels[0].bytes);
}

TEST(MapFilterTest, SaysWhatIsWrong) {
  const Image map = RandomImage(4, 4, 3, 8, 2);
  const auto complaint = [](const Image& image, const MapFilterOptions& options) {
    Diagnostics diagnostics;
    EXPECT_FALSE(MakeColorMap(image, {}, options, "m", {}, diagnostics));
    return diagnostics.all().size() == 1 ? diagnostics.all()[0].message : "";
  };
  using testing::HasSubstr;
  EXPECT_THAT(complaint(map, {.sigmas = 1}), HasSubstr("it can have 2 to 8"));
  EXPECT_THAT(complaint(map, {.sigmas = 9}), HasSubstr("has 9 standard deviations"));
  EXPECT_THAT(complaint(map, {.greatest = 0}), HasSubstr("is 0; it can be above 0, up to 1"));
  EXPECT_THAT(complaint(map, {.greatest = NAN}), HasSubstr("is nan"));
  EXPECT_THAT(complaint(RandomImage(1025, 1, 1, 8, 1), {}), HasSubstr("up to 1024 x 1024"));
}

}  // namespace
}  // namespace texgraph::textures
