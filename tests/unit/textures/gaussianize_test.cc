// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/gaussianize.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "compiler/textures/moments.h"
#include "compiler/textures/noise_spectrum.h"

namespace texgraph::textures {
namespace {

GaussianExemplar Make(const std::vector<Plane>& channels, const GaussianOptions& options = {}) {
  Diagnostics diagnostics;
  auto exemplar = Gaussianize(channels, options, "photo", {}, diagnostics);
  EXPECT_TRUE(exemplar) << (diagnostics.all().empty() ? "" : diagnostics.all()[0].message);
  return exemplar ? *std::move(exemplar) : GaussianExemplar{};
}

std::vector<Plane> Clouds(size_t count, uint32_t size, uint32_t seed) {
  Diagnostics diagnostics;
  const NoiseSpectrum spectrum = {{PowerLawSpectrum{2, 1, 0, {}}, 1}};
  const std::vector<NoiseSpectrum> spectra(count, spectrum);
  NoiseOptions options;
  options.size = size;
  options.seed = seed;
  options.sigma = 1;
  return *MakeNoise(spectra, options, "clouds", {}, diagnostics);
}

// As a photograph has it: dark, with few bright places, its channels much alike, steps of 8 bits.
std::vector<Plane> Photo(uint32_t size) {
  const std::vector<Plane> clouds = Clouds(3, size, 9);
  std::vector<Plane> channels(3, Plane{size, size, std::vector<float>(size_t{size} * size)});
  for (size_t i = 0; i < channels[0].values.size(); ++i) {
    const float light = std::exp(0.6f * clouds[0].values[i] - 2);
    for (size_t c = 0; c < 3; ++c) {
      const float tint = 1 + 0.15f * clouds[1 + c % 2].values[i] * (c == 2 ? -1.0f : 1.0f);
      channels[c].values[i] = std::clamp(std::round(light * tint * 255), 0.0f, 255.0f) / 255;
    }
  }
  return channels;
}

std::vector<double> NoiseAt(const GaussianExemplar& exemplar, size_t texel) {
  std::vector<double> noise;
  for (const Plane& plane : exemplar.noise) noise.push_back(plane.values[texel]);
  return noise;
}

TEST(GaussianizeTest, NoiseIsTheQuantilesInTheOrderOfValues) {
  const Plane photo = Photo(32)[0];
  const GaussianExemplar exemplar = Make({photo});
  ASSERT_EQ(exemplar.noise.size(), 1u);
  EXPECT_EQ(exemplar.axes[0][0], 1);
  std::vector<std::pair<float, float>> order;
  for (size_t i = 0; i < 1024; ++i)
    order.emplace_back(exemplar.noise[0].values[i], photo.values[i]);
  std::ranges::sort(order);
  for (size_t i = 0; i < order.size(); ++i) {
    const double share = (static_cast<double>(i) + 0.5) / 1024;
    EXPECT_NEAR(NormalCdf(order[i].first / kNoiseSigma), share, 1e-5);
    EXPECT_LE(order[i > 0 ? i - 1 : 0].second, order[i].second);
  }
}

// The table is linear between its columns and never falls, so what comes back is off by less than
// the step between them; beyond the last column it is what stands there.
TEST(GaussianizeTest, ComesBack) {
  const std::vector<Plane> photo = Photo(64);
  for (const bool decorrelate : {false, true}) {
    GaussianOptions options;
    options.decorrelate = decorrelate;
    const GaussianExemplar exemplar = Make(photo, options);
    double squares = 0;
    for (size_t i = 0; i < photo[0].values.size(); ++i) {
      const std::vector<double> noise = NoiseAt(exemplar, i);
      const auto color = TurnBack(exemplar, noise, 0);
      double bound = 1e-5;
      for (size_t a = 0; a < 3; ++a) {
        const double place = TableColumn(noise[a], kNoiseSigma) * exemplar.columns - 0.5;
        const auto below = static_cast<size_t>(std::clamp(place, 0.0, exemplar.columns - 2.0));
        bound += exemplar.table[a][below + 1] - exemplar.table[a][below];
      }
      for (size_t c = 0; c < 3; ++c) {
        const double off = color[c] - photo[c].values[i];
        EXPECT_LE(std::abs(off), bound) << i;
        squares += off * off;
      }
    }
    EXPECT_LT(std::sqrt(squares / (3 * 64 * 64)), 0.5 / 255);  // half a step of 8 bits
  }
}

TEST(GaussianizeTest, AxesDoNotCorrelate) {
  const std::vector<Plane> photo = Photo(64);
  const GaussianExemplar exemplar = Make(photo);
  const auto correlation = [](auto a, auto b) {
    double aa = 0, bb = 0, ab = 0;
    for (size_t i = 0; i < 64 * 64; ++i) aa += a(i) * a(i), bb += b(i) * b(i), ab += a(i) * b(i);
    return ab / std::sqrt(aa * bb);
  };
  const auto channel = [&](size_t c) {
    return [&, c](size_t i) { return photo[c].values[i] - exemplar.mean[c]; };
  };
  const auto axis = [&](size_t a) {
    return [&, a](size_t i) {
      double sum = 0;
      for (size_t c = 0; c < 3; ++c) sum += exemplar.axes[a][c] * channel(c)(i);
      return sum;
    };
  };
  EXPECT_GT(correlation(channel(0), channel(1)), 0.9);
  EXPECT_NEAR(correlation(axis(0), axis(1)), 0, 1e-6);
  EXPECT_NEAR(correlation(axis(0), axis(2)), 0, 1e-6);
  EXPECT_NEAR(correlation(axis(1), axis(2)), 0, 1e-6);
}

TEST(GaussianizeTest, AConstantStaysItself) {
  const std::vector<Plane> grey(3, Plane{16, 8, std::vector<float>(128, 0.3f)});
  const GaussianExemplar exemplar = Make(grey);
  EXPECT_EQ(exemplar.rows, 5u);
  for (const double level : {0.0, 1.5, 9.0}) {
    for (const double noise : {-3.0, -0.1, 0.0, 2.0}) {
      for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(TurnBack(exemplar, std::vector<double>(3, noise), level)[c], 0.3f, 1e-9);
      }
    }
  }
}

TEST(GaussianizeTest, TwoValues) {
  // A disc of ones: a share of pi / 16.
  Plane disc{64, 64, std::vector<float>(4096)};
  const auto distance = [](size_t i) {
    return std::hypot(double(i % 64) - 31.5, double(i / 64) - 31.5);
  };
  size_t ones = 0;
  for (size_t i = 0; i < 4096; ++i) {
    disc.values[i] = distance(i) < 16 ? 1 : 0;
    ones += distance(i) < 16;
  }
  const GaussianExemplar exemplar = Make({disc});
  // Only what falls between two columns of the table is neither 0 nor 1.
  size_t wrong = 0;
  for (size_t i = 0; i < 4096; ++i) {
    const double back = TurnBack(exemplar, NoiseAt(exemplar, i), 0)[0];
    EXPECT_GE(back, -1e-6);
    EXPECT_LE(back, 1 + 1e-6);
    wrong += std::abs(back - disc.values[i]) > 1e-3;
  }
  const double column = 2 * kTableReach / exemplar.columns;
  EXPECT_LE(double(wrong), 2 * column * NormalDensity(0) * 4096 + 2);
  // Row l is the step, blurred by what that level lost.
  const double step = NormalQuantile(1 - double(ones) / 4096);
  for (uint32_t row = 1; row < exemplar.rows; ++row) {
    const double sigma = std::sqrt(exemplar.lost[0][row]) / kNoiseSigma;
    for (const double place : {-2.0, 0.1, 0.8, 1.0, 2.5}) {
      EXPECT_NEAR(TurnBack(exemplar, std::vector{place * kNoiseSigma}, row)[0],
                  NormalCdf((place - step) / sigma), 0.02)
          << row << " " << place;
    }
  }
  // What is equal is ordered by what is around it: the middle is above the rim, the far corners
  // are below, so that shapes stay smooth when they are mixed.
  const auto noise = [&](size_t x, size_t y) { return exemplar.noise[0].At(x, y); };
  for (uint32_t r = 1; r < 15; ++r) EXPECT_GT(noise(31 + r, 31), noise(32 + r, 31)) << r;
  for (uint32_t r = 17; r < 28; ++r) EXPECT_GT(noise(31 + r, 31), noise(32 + r, 31)) << r;
}

// Where the picture is a function of Gaussian noise, the mean of what a level's filter took away
// has a closed form: E exp(k (g + s z)) = exp(k g + k^2 s^2 / 2).
TEST(GaussianizeTest, RowsAreMeansOverWhatTheirLevelLost) {
  std::vector<Plane> cloud = Clouds(1, 128, 4);
  const GaussianExemplar itself = Make(cloud);
  Plane picture = itself.noise[0];
  for (float& value : picture.values) value = static_cast<float>(std::exp(3 * value));
  const GaussianExemplar exemplar = Make({picture});
  EXPECT_EQ(exemplar.rows, 8u);
  for (uint32_t row = 0; row < exemplar.rows; ++row) {
    EXPECT_EQ(exemplar.lost[0][row], itself.lost[0][row]);
    for (double g = -0.25; g <= 0.25; g += 0.05) {
      const double expected = std::exp(3 * g + 4.5 * exemplar.lost[0][row]);
      EXPECT_NEAR(TurnBack(exemplar, std::vector{g}, row)[0], expected, 0.01) << row << " " << g;
    }
  }
}

// What a level lost and what it kept are the whole variance; so the mean stays.
TEST(GaussianizeTest, LevelsKeepTheMean) {
  const std::vector<Plane> photo = Photo(64);
  const GaussianExemplar exemplar = Make(photo);
  const ir::Texture noise = ToTexture(NoiseTexture(exemplar));
  ASSERT_EQ(noise.levels.size(), exemplar.rows);
  for (uint32_t l = 0; l < exemplar.rows; ++l) {
    double kept = 0;
    std::array<double, 3> mean{};
    const auto n = static_cast<double>(noise.levels[l].texels.size());
    for (const ir::Texel& texel : noise.levels[l].texels) {
      kept += double{texel[0]} * texel[0] / n;
      const std::vector<double> at(texel.begin(), texel.begin() + 3);
      for (size_t c = 0; c < 3; ++c) mean[c] += TurnBack(exemplar, at, l)[c] / n;
    }
    EXPECT_NEAR(kept + exemplar.lost[0][l], exemplar.lost[0].back(), 1e-4);
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / exemplar.mean[c], 1, 0.03) << l;
  }
}

TEST(GaussianizeTest, ALevelReadsItsOwnRow) {
  GaussianExemplar exemplar = Make({Photo(16)[0]});
  exemplar.mean = {};
  ASSERT_EQ(exemplar.rows, 5u);
  for (uint32_t row = 0; row < 5; ++row)
    std::fill_n(exemplar.table[0].begin() + row * exemplar.columns, exemplar.columns, row * row);
  for (const auto& [level, value] :
       {std::pair(0.0, 0.0), std::pair(1.0, 1.0), std::pair(2.0, 4.0), std::pair(4.0, 16.0),
        std::pair(2.5, 6.5), std::pair(-3.0, 0.0), std::pair(40.0, 16.0)}) {
    EXPECT_NEAR(TurnBack(exemplar, std::vector{0.1}, level)[0], value, 1e-12) << level;
  }
  EXPECT_EQ(TableRow(0, 5), 0.1);
  EXPECT_EQ(TableColumn(0, kNoiseSigma), 0.5);
  EXPECT_EQ(TableColumn(1, 0.25), 1);
  EXPECT_EQ(TableColumn(-9, 0.25), 0);
}

TEST(GaussianizeTest, TexturesHoldIt) {
  const GaussianExemplar exemplar = Make(Photo(16));
  const TextureData table = TableTexture(exemplar);
  EXPECT_EQ(table.format, TexelFormat::kRgba16F);
  EXPECT_EQ(table.sampler.wrap_v, ir::Wrap::kClamp);
  EXPECT_TRUE(table.is_array);
  EXPECT_EQ(table.layers, 3u);
  const ir::Texture texture = ToTexture(table);
  ASSERT_EQ(texture.levels.size(), 1u);
  for (const double level : {0.0, 2.3}) {
    for (const double g : {-0.4, 0.03, 0.2}) {
      ir::Texel sum{};
      for (int a = 0; a < 3; ++a) {
        const float at[3] = {float(TableColumn(g * (a - 1), kNoiseSigma)),
                             float(TableRow(level, 5)), float(a)};
        const ir::Texel texel = ir::SampleLod(texture, at, 0);
        for (size_t c = 0; c < 4; ++c) sum[c] += texel[c];
      }
      const auto color = TurnBack(exemplar, std::vector{-g, 0.0, g}, level);
      for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], color[c], 1e-3);
      EXPECT_EQ(sum[3], 0);
    }
  }
  const TextureData noise = NoiseTexture(exemplar);
  EXPECT_EQ(noise.sampler.wrap_u, ir::Wrap::kRepeat);
  EXPECT_NEAR(ToTexture(noise).levels[0].texels[37][1], exemplar.noise[1].values[37], 1e-3);
}

TEST(GaussianizeTest, SaysWhatIsWrong) {
  const Plane plane{2, 2, {0, 1, 2, 3}};
  const std::vector<Plane> bad[] = {{},
                                    std::vector<Plane>(5, plane),
                                    {plane, Plane{4, 1, {0, 1, 2, 3}}},
                                    {Plane{2, 2, {0, 1}}},
                                    {Plane{2, 2, {0, 1, NAN, 3}}}};
  for (const std::vector<Plane>& channels : bad) {
    Diagnostics diagnostics;
    EXPECT_FALSE(Gaussianize(channels, {}, "p", {}, diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kBadImage);
    EXPECT_THAT(diagnostics.all()[0].message, testing::HasSubstr("takes 1 to 4 channels"));
  }
  for (const GaussianOptions& options :
       {GaussianOptions{.sigma = 0}, GaussianOptions{.columns = 8}}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(Gaussianize({&plane, 1}, options, "p", {}, diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kValueRange);
  }
}

}  // namespace
}  // namespace texgraph::textures
