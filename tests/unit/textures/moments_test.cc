// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/moments.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace texgraph::textures {
namespace {

Plane RandomPlane(uint32_t width, uint32_t height, uint32_t seed, float offset = 0) {
  std::mt19937 random(seed);
  Plane plane{width, height, std::vector<float>(size_t{width} * height)};
  for (float& value : plane.values) value = offset + static_cast<float>(random() * 0x1p-32) - 0.5f;
  return plane;
}

MomentPyramid Make(const std::vector<Plane>& fields) {
  Diagnostics diagnostics;
  auto pyramid = MakeMoments(fields, "moments", {}, diagnostics);
  EXPECT_TRUE(pyramid);
  return pyramid ? *std::move(pyramid) : MomentPyramid{};
}

// What each texel of level 0 counts for each texel of a level, along one axis: the parts of its
// length that they share, level after level.
std::vector<std::vector<double>> Shares(uint32_t size, size_t level) {
  std::vector<std::vector<double>> shares(size, std::vector<double>(size));
  for (uint32_t i = 0; i < size; ++i) shares[i][i] = 1;
  for (size_t l = 0; l < level; ++l) {
    const auto from = static_cast<double>(shares.size());
    const double to = std::max(std::floor(from / 2), 1.0);
    std::vector<std::vector<double>> next(static_cast<size_t>(to), std::vector<double>(size));
    for (double i = 0; i < to; ++i) {
      for (double j = 0; j < from; ++j) {
        const double begin = std::max(i * from / to, j);
        const double end = std::min((i + 1) * from / to, j + 1);
        for (uint32_t k = 0; k < size && end > begin; ++k)
          next[size_t(i)][k] += (end - begin) * to / from * shares[size_t(j)][k];
      }
    }
    shares = std::move(next);
  }
  return shares;
}

TEST(MomentsTest, AreTheirDefinition) {
  for (const auto& [width, height] : {std::pair(16u, 8u), std::pair(13u, 7u), std::pair(1u, 6u)}) {
    const std::vector<Plane> fields = {RandomPlane(width, height, 1),
                                       RandomPlane(width, height, 2)};
    const MomentPyramid pyramid = Make(fields);
    ASSERT_EQ(pyramid.levels.size(), std::bit_width(std::max(width, height)));
    for (size_t l = 0; l < pyramid.levels.size(); ++l) {
      const MomentLevel& level = pyramid.levels[l];
      ASSERT_EQ(level.width, std::max(width >> l, 1u));
      ASSERT_EQ(level.height, std::max(height >> l, 1u));
      const auto columns = Shares(width, l);
      const auto rows = Shares(height, l);
      for (uint32_t y = 0; y < level.height; ++y) {
        for (uint32_t x = 0; x < level.width; ++x) {
          const auto mean_of = [&](auto value) {
            double sum = 0;
            for (uint32_t v = 0; v < height; ++v) {
              for (uint32_t u = 0; u < width; ++u) sum += rows[y][v] * columns[x][u] * value(u, v);
            }
            return sum;
          };
          std::array<double, 2> mean;
          const size_t i = size_t{y} * level.width + x;
          const auto off = [&](size_t f, uint32_t u, uint32_t v) {
            return fields[f].At(u, v) - mean[f];
          };
          for (size_t f = 0; f < 2; ++f) {
            mean[f] = mean_of([&](uint32_t u, uint32_t v) { return double{fields[f].At(u, v)}; });
            EXPECT_NEAR(level.mean[f][i], mean[f], 1e-6);
            EXPECT_NEAR(
                level.variance[f][i],
                mean_of([&](uint32_t u, uint32_t v) { return off(f, u, v) * off(f, u, v); }), 1e-6);
          }
          EXPECT_NEAR(level.covariance[i],
                      mean_of([&](uint32_t u, uint32_t v) { return off(0, u, v) * off(1, u, v); }),
                      1e-6);
        }
      }
    }
  }
}

TEST(MomentsTest, NothingCancels) {
  const std::vector<Plane> fields = {RandomPlane(64, 64, 5, 1000)};
  const MomentPyramid pyramid = Make(fields);
  double mean = 0, variance = 0;
  for (const float value : fields[0].values) mean += value / 4096;
  for (const float value : fields[0].values) variance += (value - mean) * (value - mean) / 4096;
  EXPECT_NEAR(pyramid.levels.back().variance[0][0], variance, 1e-5);
  EXPECT_TRUE(pyramid.levels[0].mean[1].empty());
  EXPECT_TRUE(pyramid.levels[0].covariance.empty());
  const Plane constant{8, 8, std::vector<float>(64, 0.7f)};
  const MomentPyramid flat = Make({constant});
  for (const MomentLevel& level : flat.levels) {
    for (const float value : level.variance[0]) EXPECT_EQ(value, 0);
    for (const float value : level.mean[0]) EXPECT_EQ(value, 0.7f);
  }
}

TEST(MomentsTest, HalvesAreTheMoments) {
  const MomentPyramid pyramid = Make({RandomPlane(16, 16, 1), RandomPlane(16, 16, 2)});
  const MomentTextures packed = PackMoments(pyramid, MomentFormat::kHalves, true);
  EXPECT_EQ(packed.moments.format, TexelFormat::kRgba16F);
  EXPECT_EQ(packed.moments.sampler.wrap_u, ir::Wrap::kRepeat);
  ASSERT_TRUE(packed.covariance);
  EXPECT_EQ(packed.covariance->format, TexelFormat::kR16F);
  const ir::Texture texture = ToTexture(packed.moments);
  const ir::Texture covariance = ToTexture(*packed.covariance);
  ASSERT_EQ(texture.levels.size(), 5u);
  // Halves have 11 bits, and steps of 2^-24 at the least.
  const auto near = [](float stored, float moment) {
    EXPECT_NEAR(stored, moment, std::max(std::abs(moment) * 0x1p-11f, 0x1p-25f));
  };
  for (size_t l = 0; l < 5; ++l) {
    const MomentLevel& level = pyramid.levels[l];
    for (size_t i = 0; i < texture.levels[l].texels.size(); ++i) {
      for (size_t f = 0; f < 2; ++f) {
        near(texture.levels[l].texels[i][f], level.mean[f][i]);
        near(texture.levels[l].texels[i][2 + f], level.variance[f][i]);
      }
      near(covariance.levels[l].texels[i][0], level.covariance[i]);
    }
  }
  EXPECT_FALSE(PackMoments(pyramid, MomentFormat::kHalves, false).covariance);
  const MomentTextures one = PackMoments(Make({RandomPlane(4, 4, 1)}), MomentFormat::kHalves, true);
  EXPECT_FALSE(one.covariance);
  EXPECT_EQ(ToTexture(one.moments).levels[1].texels[0][1], 0);
  EXPECT_EQ(ToTexture(one.moments).levels[1].texels[0][3], 0);
}

// A factor of 16 where it fits, as the paper has it; less where variances are above 1/16.
TEST(MomentsTest, BytesDoNotClip) {
  for (const auto& [height, factor, mean_factor] :
       {std::tuple(0.2f, 16.0, 1.0), std::tuple(0.3f, 8.0, 1.0), std::tuple(0.7f, 2.0, 0.5)}) {
    // Up and down by `height`: a variance of height^2 from level 1 on.
    Plane plane{8, 8, std::vector<float>(64)};
    for (size_t i = 0; i < 64; ++i) plane.values[i] = i % 2 ? height : -height;
    const MomentPyramid pyramid = Make({plane, plane});
    const MomentTextures packed = PackMoments(pyramid, MomentFormat::kBytes, true);
    EXPECT_EQ(packed.variance_code.factor, factor);
    EXPECT_EQ(packed.mean_code.factor, mean_factor);
    EXPECT_EQ(packed.moments.format, TexelFormat::kRgba8);
    const ir::Texture texture = ToTexture(packed.moments);
    const ir::Texture covariance = ToTexture(*packed.covariance);
    const auto near = [](float stored, const MomentCode& code, float moment) {
      EXPECT_NEAR((stored - code.zero) / code.factor, moment, 0.501 / 255 / code.factor);
    };
    for (size_t l = 0; l < texture.levels.size(); ++l) {
      for (size_t i = 0; i < texture.levels[l].texels.size(); ++i) {
        const ir::Texel& texel = texture.levels[l].texels[i];
        near(texel[0], packed.mean_code, pyramid.levels[l].mean[0][i]);
        near(texel[3], packed.variance_code, pyramid.levels[l].variance[1][i]);
        near(covariance.levels[l].texels[i][0], packed.covariance_code,
             pyramid.levels[l].covariance[i]);
      }
    }
  }
}

TEST(MomentsTest, TakesOneFieldOrTwoOfASize) {
  const Plane plane = RandomPlane(4, 4, 1);
  const std::vector<Plane> bad[] = {
      {}, {plane, plane, plane}, {plane, RandomPlane(4, 8, 1)}, {Plane{4, 4, {1, 2}}}};
  for (const std::vector<Plane>& fields : bad) {
    Diagnostics diagnostics;
    EXPECT_FALSE(MakeMoments(fields, "m", {}, diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kBadImage);
  }
}

}  // namespace
}  // namespace texgraph::textures
