// SPDX-License-Identifier: Apache-2.0
// Texture sampling against values worked out by hand from the specification's formulas, and against
// a slow reference that knows linear filtering as a tent over every texel near by and wrapping as a
// walk.
#include "compiler/ir/texture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace texgraph::ir {
namespace {

constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// One row of texels with the given red values.
Texture Row(std::vector<float> reds) {
  Texture texture;
  Texture::Level level;
  level.width = static_cast<uint32_t>(reds.size());
  for (float red : reds) level.texels.push_back({red, 0, 0, 1});
  texture.levels.push_back(std::move(level));
  return texture;
}

Texture RandomTexture(uint32_t width, uint32_t height, uint32_t depth, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> value(0.0f, 1.0f);
  Texture texture;
  Texture::Level level{width, height, depth, {}};
  for (uint32_t i = 0; i < width * height * depth; ++i) {
    level.texels.push_back({value(random), value(random), value(random), value(random)});
  }
  texture.levels.push_back(std::move(level));
  return texture;
}

float Red(const Texture& texture, float u, float lod = 0.0f) {
  float at[] = {u, 0.5f, 0.0f};
  return SampleLod(texture, at, lod)[0];
}

// --- The slow reference --------------------------------------------------------------------------

int WalkToTexel(int i, int size, Wrap wrap) {
  while (i < 0 || i >= size) {
    switch (wrap) {
      case Wrap::kRepeat:
        i += i < 0 ? size : -size;
        break;
      case Wrap::kClamp:
        i += i < 0 ? 1 : -1;
        break;
      case Wrap::kMirror:
        i = i < 0 ? -1 - i : 2 * size - 1 - i;
        break;
    }
  }
  return i;
}

double Tent(double x) { return std::max(0.0, 1.0 - std::fabs(x)); }

std::array<double, 4> ReferenceLinear(const Texture& texture, const float* at, size_t index) {
  const Texture::Level& level = texture.levels[index];
  const SamplerState& s = texture.sampler;
  double u = double{at[0]} * level.width, v = double{at[1]} * level.height;
  double w = texture.is_3d ? double{at[2]} * level.depth : 0.5;
  int layer = texture.is_array ? static_cast<int>(at[2] + 0.5f) : 0;
  std::array<double, 4> sum{};
  auto near = [](double x) { return static_cast<int>(std::floor(x)); };
  for (int k = near(w) - 2; k <= near(w) + 2; ++k) {
    for (int j = near(v) - 2; j <= near(v) + 2; ++j) {
      for (int i = near(u) - 2; i <= near(u) + 2; ++i) {
        double weight = Tent(u - i - 0.5) * Tent(v - j - 0.5) * Tent(w - k - 0.5);
        int z = texture.is_3d ? WalkToTexel(k, level.depth, s.wrap_w) : layer;
        size_t texel =
            (size_t(z) * level.height + WalkToTexel(j, level.height, s.wrap_v)) * level.width +
            WalkToTexel(i, level.width, s.wrap_u);
        for (int c = 0; c < 4; ++c) sum[c] += weight * level.texels[texel][c];
      }
    }
  }
  return sum;
}

// --- Within one level ----------------------------------------------------------------------------

TEST(Texture, NearestTakesTheTexelThatTheCoordinateIsIn) {
  Texture texture = Row({10, 20, 30, 40});
  texture.sampler.filter = Filter::kNearest;
  EXPECT_EQ(Red(texture, 0.0f), 10);
  EXPECT_EQ(Red(texture, 0.24f), 10);
  EXPECT_EQ(Red(texture, 0.25f), 20);
  EXPECT_EQ(Red(texture, 0.99f), 40);
}

TEST(Texture, LinearIsATexelAtItsCentreAndTheMeanBetweenTwo) {
  Texture texture = Row({10, 20, 30, 40});
  EXPECT_EQ(Red(texture, 0.125f), 10);
  EXPECT_EQ(Red(texture, 0.25f), 15);
  EXPECT_EQ(Red(texture, 0.3125f), 17.5f);
  // Repeat: half of the last and half of the first.
  EXPECT_EQ(Red(texture, 0.0f), 25);
  EXPECT_EQ(Red(texture, 1.0f), 25);
}

TEST(Texture, WrapModesAtEveryTexelOfFivePeriods) {
  // Table 8.20 written out: texel index for i = -4 .. 7 of a row of 4.
  const int repeat[] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
  const int clamp[] = {0, 0, 0, 0, 0, 1, 2, 3, 3, 3, 3, 3};
  const int mirror[] = {3, 2, 1, 0, 0, 1, 2, 3, 3, 2, 1, 0};
  Texture texture = Row({0, 1, 2, 3});
  texture.sampler.filter = Filter::kNearest;
  for (int i = -4; i < 8; ++i) {
    float u = (i + 0.5f) / 4.0f;
    texture.sampler.wrap_u = Wrap::kRepeat;
    EXPECT_EQ(Red(texture, u), repeat[i + 4]) << i;
    texture.sampler.wrap_u = Wrap::kClamp;
    EXPECT_EQ(Red(texture, u), clamp[i + 4]) << i;
    texture.sampler.wrap_u = Wrap::kMirror;
    EXPECT_EQ(Red(texture, u), mirror[i + 4]) << i;
  }
}

TEST(Texture, LinearAtTheEdgesOfEachWrapMode) {
  Texture texture = Row({10, 20, 30, 40});
  texture.sampler.wrap_u = Wrap::kClamp;
  EXPECT_EQ(Red(texture, 0.0f), 10);
  EXPECT_EQ(Red(texture, 1.0f), 40);
  EXPECT_EQ(Red(texture, -3.0f), 10);
  texture.sampler.wrap_u = Wrap::kMirror;
  EXPECT_EQ(Red(texture, 0.0f), 10);
  EXPECT_EQ(Red(texture, 1.0f), 40);
  EXPECT_EQ(Red(texture, 1.25f), 35);
  EXPECT_EQ(Red(texture, -0.25f), 15);
}

TEST(Texture, RowZeroIsTheBottom) {
  Texture texture;
  texture.levels.push_back({1, 2, 1, {{1, 0, 0, 0}, {2, 0, 0, 0}}});
  float low[] = {0.5f, 0.25f}, high[] = {0.5f, 0.75f};
  EXPECT_EQ(SampleLod(texture, low, 0)[0], 1);
  EXPECT_EQ(SampleLod(texture, high, 0)[0], 2);
}

TEST(Texture, KOverSizeIsTexelK) {
  // In real numbers float(k / n) * n may lie below k; GPUs multiply in float, where it does not.
  for (uint32_t size : {3u, 7u, 48u, 49u, 100u, 1000u}) {
    std::vector<float> reds(size);
    for (uint32_t i = 0; i < size; ++i) reds[i] = static_cast<float>(i);
    Texture texture = Row(reds);
    texture.sampler.filter = Filter::kNearest;
    for (uint32_t k = 0; k < size; ++k) {
      float u = static_cast<float>(k) / static_cast<float>(size);
      EXPECT_EQ(Red(texture, u), std::floor(u * static_cast<float>(size))) << k << "/" << size;
    }
  }
}

TEST(Texture, EveryCoordinateIsDefined) {
  for (Wrap wrap : {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror}) {
    for (Filter filter : {Filter::kNearest, Filter::kLinear}) {
      Texture texture = RandomTexture(5, 3, 2, 1);
      texture.is_3d = true;
      BuildMipChain(texture);
      texture.sampler.wrap_u = texture.sampler.wrap_v = texture.sampler.wrap_w = wrap;
      texture.sampler.filter = filter;
      for (float nasty :
           {kInf, -kInf, kNan, 3.4e38f, -3.4e38f, 1e20f, -1e10f, 16777217.0f, 1e-45f, -0.0f}) {
        for (int axis = 0; axis < 3; ++axis) {
          float at[] = {0.3f, 0.4f, 0.6f};
          at[axis] = nasty;
          for (float lod : {0.0f, 0.7f, nasty}) {
            for (float component : SampleLod(texture, at, lod)) {
              EXPECT_TRUE(component >= 0 && component <= 1) << nasty << " " << lod;
            }
          }
          float gradient[] = {nasty, 0.1f, nasty};
          EXPECT_TRUE(std::isfinite(SampleGrad(texture, at, gradient, at)[0]));
          texture.sampler.anisotropy = 4;
          EXPECT_TRUE(std::isfinite(SampleGrad(texture, at, gradient, at)[0]));
          texture.sampler.anisotropy = 1;
        }
      }
    }
  }
}

TEST(Texture, LinearFilteringAgreesWithTheTent) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> coordinate(-3.0f, 3.0f);
  for (auto [width, height] : {std::pair{1, 1}, {4, 4}, {5, 3}, {8, 1}, {2, 9}}) {
    for (Wrap wrap_u : {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror}) {
      for (Wrap wrap_v : {Wrap::kRepeat, Wrap::kClamp, Wrap::kMirror}) {
        Texture texture = RandomTexture(width, height, 3, 11);
        texture.is_3d = true;
        texture.sampler.wrap_u = wrap_u;
        texture.sampler.wrap_v = texture.sampler.wrap_w = wrap_v;
        for (int i = 0; i < 200; ++i) {
          float at[] = {coordinate(random), coordinate(random), coordinate(random)};
          std::array<double, 4> expected = ReferenceLinear(texture, at, 0);
          Texel got = SampleLod(texture, at, 0);
          for (int c = 0; c < 4; ++c) EXPECT_NEAR(got[c], expected[c], 1e-5);
        }
      }
    }
  }
}

// --- Layers and slices ---------------------------------------------------------------------------

TEST(Texture, LayersAreRoundedAndClampedNeverBlended) {
  Texture texture;
  texture.is_array = true;
  texture.levels.push_back({1, 1, 3, {{1, 0, 0, 0}, {2, 0, 0, 0}, {3, 0, 0, 0}}});
  auto layer = [&](float r) {
    float at[] = {0.5f, 0.5f, r};
    return SampleLod(texture, at, 0)[0];
  };
  EXPECT_EQ(layer(-5.0f), 1);
  EXPECT_EQ(layer(0.49f), 1);
  EXPECT_EQ(layer(0.5f), 2);
  EXPECT_EQ(layer(1.49f), 2);
  EXPECT_EQ(layer(1.5f), 3);
  EXPECT_EQ(layer(99.0f), 3);
  EXPECT_EQ(layer(kNan), 1);
}

TEST(Texture, SlicesAreBlended) {
  Texture texture;
  texture.is_3d = true;
  texture.sampler.wrap_w = Wrap::kClamp;
  texture.levels.push_back({1, 1, 2, {{10, 0, 0, 0}, {20, 0, 0, 0}}});
  auto slice = [&](float w) {
    float at[] = {0.5f, 0.5f, w};
    return SampleLod(texture, at, 0)[0];
  };
  EXPECT_EQ(slice(0.25f), 10);
  EXPECT_EQ(slice(0.5f), 15);
  EXPECT_EQ(slice(0.625f), 17.5f);
  EXPECT_EQ(slice(1.0f), 20);
}

// --- Levels --------------------------------------------------------------------------------------

// Level l is everywhere l * 10.
Texture Staircase(uint32_t size) {
  Texture texture;
  float red = 0;
  for (; size > 0; size /= 2, red += 10) {
    texture.levels.push_back({size, size, 1, std::vector<Texel>(size * size, Texel{red, 0, 0, 0})});
  }
  return texture;
}

TEST(Texture, LinearMipFilterBlendsTwoLevels) {
  Texture texture = Staircase(16);
  EXPECT_EQ(Red(texture, 0.3f, -2.0f), 0);
  EXPECT_EQ(Red(texture, 0.3f, 0.5f), 5);
  EXPECT_EQ(Red(texture, 0.3f, 1.0f), 10);
  EXPECT_EQ(Red(texture, 0.3f, 2.25f), 22.5f);
  EXPECT_EQ(Red(texture, 0.3f, 4.0f), 40);
  EXPECT_EQ(Red(texture, 0.3f, 9.0f), 40);
  EXPECT_EQ(Red(texture, 0.3f, -kInf), 0);
  EXPECT_EQ(Red(texture, 0.3f, kInf), 40);
}

TEST(Texture, NearestMipFilterRoundsHalvesToTheFinerLevel) {
  Texture texture = Staircase(16);
  texture.sampler.mip_filter = MipFilter::kNearest;
  EXPECT_EQ(Red(texture, 0.3f, 0.5f), 0);
  EXPECT_EQ(Red(texture, 0.3f, 0.51f), 10);
  EXPECT_EQ(Red(texture, 0.3f, 1.5f), 10);
  EXPECT_EQ(Red(texture, 0.3f, 1.6f), 20);
  EXPECT_EQ(Red(texture, 0.3f, 99.0f), 40);
}

TEST(Texture, WithoutMipFilterThereIsOneLevel) {
  Texture texture = Staircase(16);
  texture.sampler.mip_filter = MipFilter::kNone;
  EXPECT_EQ(Red(texture, 0.3f, 3.0f), 0);
}

TEST(Texture, MaxLevelBoundsTheLevel) {
  Texture texture = Staircase(16);
  texture.sampler.max_level = 2;
  EXPECT_EQ(Red(texture, 0.3f, 1.5f), 15);
  EXPECT_EQ(Red(texture, 0.3f, 3.5f), 20);
  texture.sampler.mip_filter = MipFilter::kNearest;
  EXPECT_EQ(Red(texture, 0.3f, 3.5f), 20);
  texture.sampler.max_level = -1;
  EXPECT_EQ(Red(texture, 0.3f, 3.5f), 0);
}

TEST(Texture, LevelOfGradientsIsTheLongerOneInTexels) {
  Texture texture = RandomTexture(16, 8, 1, 2);
  float one[] = {1.0f / 16, 0}, four[] = {0, 0.5f};  // 1 texel along u, 4 texels along v
  EXPECT_FLOAT_EQ(LodOfGradients(texture, one, one), 0.0f);
  EXPECT_FLOAT_EQ(LodOfGradients(texture, one, four), 2.0f);
  EXPECT_FLOAT_EQ(LodOfGradients(texture, four, one), 2.0f);
  float three_four[] = {3.0f / 16, 4.0f / 8};  // 5 texels
  EXPECT_FLOAT_EQ(LodOfGradients(texture, one, three_four), std::log2(5.0f));
  float none[] = {0, 0};
  EXPECT_EQ(LodOfGradients(texture, none, none), -kInf);
}

TEST(Texture, DepthCountsInGradientsOfSolidTexturesOnly) {
  Texture texture = RandomTexture(4, 4, 8, 2);
  float dx[] = {0.25f, 0, 1}, dy[] = {0, 0, 0};
  texture.is_3d = true;
  EXPECT_FLOAT_EQ(LodOfGradients(texture, dx, dy), std::log2(std::sqrt(65.0f)));
  texture.is_3d = false;
  texture.is_array = true;
  EXPECT_FLOAT_EQ(LodOfGradients(texture, dx, dy), 0.0f);
}

TEST(Texture, GradientAndBiasChooseTheLevel) {
  Texture texture = Staircase(16);
  float at[] = {0.3f, 0.3f}, dx[] = {4.0f / 16, 0}, dy[] = {0, 1.0f / 16};
  EXPECT_FLOAT_EQ(SampleGrad(texture, at, dx, dy)[0], 20);
  EXPECT_FLOAT_EQ(SampleGrad(texture, at, dx, dy, 0.5f)[0], 25);
  EXPECT_FLOAT_EQ(SampleGrad(texture, at, dx, dy, -1.0f)[0], 10);
}

TEST(Texture, AnisotropyTakesTheLevelOfTheShorterAxis) {
  Texture texture = Staircase(16);
  float at[] = {0.3f, 0.3f}, dx[] = {4.0f / 16, 0}, dy[] = {0, 1.0f / 16};
  texture.sampler.anisotropy = 4;
  EXPECT_FLOAT_EQ(SampleGrad(texture, at, dx, dy)[0], 0);
  texture.sampler.anisotropy = 2;
  EXPECT_FLOAT_EQ(SampleGrad(texture, at, dx, dy)[0], 10);
  texture.sampler.anisotropy = 8;
  EXPECT_FLOAT_EQ(SampleGrad(texture, at, dx, dx)[0], 20);
}

TEST(Texture, AnisotropicSamplesLieAlongTheLongerAxis) {
  // Two samples, a third of the axis apart: at 0.5 -+ 1/6 * 0.5.
  Texture texture = Row({0, 1, 2, 3, 4, 5, 6, 7});
  texture.sampler.filter = Filter::kNearest;
  texture.sampler.anisotropy = 2;
  float at[] = {0.5f, 0.5f}, dx[] = {0.5f, 0}, dy[] = {0, 1.0f};
  EXPECT_FLOAT_EQ(SampleGrad(texture, at, dx, dy)[0], (3 + 4) / 2.0f);
  float wide[] = {0.75f, 0};  // at 0.375 and 0.625
  EXPECT_FLOAT_EQ(SampleGrad(texture, at, wide, dy)[0], (3 + 5) / 2.0f);
}

// --- Mip chains ----------------------------------------------------------------------------------

TEST(Texture, MipChainHalvesDownToOneTexel) {
  Texture texture = RandomTexture(12, 5, 1, 3);
  BuildMipChain(texture);
  std::vector<std::pair<uint32_t, uint32_t>> sizes;
  for (const Texture::Level& level : texture.levels) {
    sizes.emplace_back(level.width, level.height);
    EXPECT_EQ(level.texels.size(), level.width * level.height);
  }
  EXPECT_THAT(sizes, testing::ElementsAre(std::pair{12, 5}, std::pair{6, 2}, std::pair{3, 1},
                                          std::pair{1, 1}));
}

TEST(Texture, EvenLevelsAreMeansOfFour) {
  Texture texture;
  texture.levels.push_back({2, 2, 1, {{1, 0, 0, 8}, {2, 0, 0, 8}, {3, 0, 0, 8}, {6, 4, 0, 8}}});
  BuildMipChain(texture);
  ASSERT_EQ(texture.levels.size(), 2u);
  EXPECT_EQ(texture.levels[1].texels[0], (Texel{3, 1, 0, 8}));
}

TEST(Texture, OddLevelsAreWeightedByArea) {
  Texture texture = Row({10, 20, 30, 40, 50});
  BuildMipChain(texture);
  ASSERT_EQ(texture.levels.size(), 3u);
  // 2.5 texels each: (10 + 20 + 15) / 2.5 and (15 + 40 + 50) / 2.5.
  EXPECT_FLOAT_EQ(texture.levels[1].texels[0][0], 18);
  EXPECT_FLOAT_EQ(texture.levels[1].texels[1][0], 42);
  EXPECT_FLOAT_EQ(texture.levels[2].texels[0][0], 30);
}

TEST(Texture, EveryLevelKeepsTheMean) {
  for (auto [width, height, depth] : {std::tuple{7, 13, 5}, {9, 6, 3}, {1, 17, 1}, {16, 16, 16}}) {
    Texture texture = RandomTexture(width, height, depth, 5);
    texture.is_3d = true;
    BuildMipChain(texture);
    auto mean = [](const Texture::Level& level) {
      double sum = 0;
      for (const Texel& texel : level.texels) sum += texel[2];
      return sum / static_cast<double>(level.texels.size());
    };
    EXPECT_EQ(texture.levels.back().texels.size(), 1u);
    for (const Texture::Level& level : texture.levels) {
      EXPECT_NEAR(mean(level), mean(texture.levels[0]), 1e-6);
    }
  }
}

TEST(Texture, LayersKeepTheirNumberAndDoNotMix) {
  Texture texture;
  texture.is_array = true;
  texture.levels.push_back({2, 1, 2, {{1, 0, 0, 0}, {3, 0, 0, 0}, {10, 0, 0, 0}, {30, 0, 0, 0}}});
  BuildMipChain(texture);
  ASSERT_EQ(texture.levels.size(), 2u);
  EXPECT_EQ(texture.levels[1].depth, 2u);
  EXPECT_EQ(texture.levels[1].texels[0][0], 2);
  EXPECT_EQ(texture.levels[1].texels[1][0], 20);
}

// --- Fetch ---------------------------------------------------------------------------------------

TEST(Texture, FetchTakesTexelsAndZerosOutside) {
  Texture texture = Row({10, 20, 30, 40});
  BuildMipChain(texture);
  auto fetch = [&](int x, int y, int level) {
    int32_t at[] = {x, y, 0};
    return Fetch(texture, at, level)[0];
  };
  EXPECT_EQ(fetch(2, 0, 0), 30);
  EXPECT_EQ(fetch(1, 0, 1), 35);
  EXPECT_EQ(fetch(0, 0, 2), 25);
  EXPECT_EQ(fetch(-1, 0, 0), 0);
  EXPECT_EQ(fetch(4, 0, 0), 0);
  EXPECT_EQ(fetch(0, 1, 0), 0);
  EXPECT_EQ(fetch(0, 0, 3), 0);
  EXPECT_EQ(fetch(0, 0, -1), 0);
  EXPECT_EQ(fetch(INT32_MIN, INT32_MAX, INT32_MAX), 0);
}

}  // namespace
}  // namespace texgraph::ir
