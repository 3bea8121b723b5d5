// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/noise_spectrum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "compiler/textures/fourier.h"

namespace texgraph::textures {
namespace {

using Complex = std::complex<double>;

NoiseSpectrum Only(decltype(SpectrumPart::kind) kind) { return {{std::move(kind), 1}}; }

std::vector<Plane> Make(const std::vector<NoiseSpectrum>& channels, const NoiseOptions& options) {
  Diagnostics diagnostics;
  auto planes = MakeNoise(channels, options, "noise", {}, diagnostics);
  EXPECT_TRUE(planes) << (diagnostics.all().empty() ? "" : diagnostics.all()[0].message);
  return planes ? *std::move(planes) : std::vector<Plane>{};
}

std::string Complaint(const std::vector<NoiseSpectrum>& channels, const NoiseOptions& options) {
  Diagnostics diagnostics;
  EXPECT_FALSE(MakeNoise(channels, options, "n", {}, diagnostics));
  if (diagnostics.all().size() != 1) return "not one diagnostic";
  EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kValueRange);
  return diagnostics.all()[0].message;
}

double Covariance(const Plane& a, const Plane& b) {
  double mean_a = 0, mean_b = 0, sum = 0;
  const auto n = static_cast<double>(a.values.size());
  for (size_t i = 0; i < a.values.size(); ++i) mean_a += a.values[i] / n, mean_b += b.values[i] / n;
  for (size_t i = 0; i < a.values.size(); ++i)
    sum += (a.values[i] - mean_a) * (b.values[i] - mean_b) / n;
  return sum;
}

double Mean(const Plane& plane) {
  double sum = 0;
  for (const float value : plane.values) sum += value;
  return sum / static_cast<double>(plane.values.size());
}

// The share of the variance at each frequency, of noise as it came out.
std::vector<double> SharesOf(const Plane& plane) {
  std::vector<Complex> values(plane.values.begin(), plane.values.end());
  FourierTransform(values, plane.width, plane.height, false);
  std::vector<double> shares;
  const auto n = static_cast<double>(values.size());
  const double variance = Covariance(plane, plane);
  for (const Complex& value : values) shares.push_back(std::norm(value) / (n * n * variance));
  return shares;
}

size_t At(int x, int y, int size) {
  return size_t((y + size) % size) * size_t(size) + size_t((x + size) % size);
}

TEST(FourierTest, IsTheSum) {
  constexpr uint32_t kWidth = 12, kHeight = 10;
  std::mt19937 random(1);
  std::vector<Complex> values(kWidth * kHeight);
  for (Complex& value : values) value = {random() * 0x1p-32, random() * 0x1p-32};
  std::vector<Complex> sums(values.size());
  for (uint32_t v = 0; v < kHeight; ++v) {
    for (uint32_t u = 0; u < kWidth; ++u) {
      for (uint32_t y = 0; y < kHeight; ++y) {
        for (uint32_t x = 0; x < kWidth; ++x) {
          const double turns = double(u * x) / kWidth + double(v * y) / kHeight;
          sums[v * kWidth + u] +=
              values[y * kWidth + x] * std::polar(1.0, -2 * std::numbers::pi * turns);
        }
      }
    }
  }
  std::vector<Complex> transformed = values;
  FourierTransform(transformed, kWidth, kHeight, false);
  for (size_t i = 0; i < values.size(); ++i) EXPECT_LT(std::abs(transformed[i] - sums[i]), 1e-11);
  FourierTransform(transformed, kWidth, kHeight, true);
  for (size_t i = 0; i < values.size(); ++i)
    EXPECT_LT(std::abs(transformed[i] / 120.0 - values[i]), 1e-14);
}

TEST(PowerTest, Bands) {
  const auto power = *PowerOf(Only(BandSpectrum{16, 4, {}}), 64);
  EXPECT_NEAR(power[At(12, 0, 64)] / power[At(16, 0, 64)], std::exp(-0.5), 1e-12);
  EXPECT_NEAR(power[At(0, -24, 64)] / power[At(0, 16, 64)], std::exp(-2), 1e-12);
  EXPECT_EQ(power[0], 0);
  // (24, 7) and (0, 25) are as far from 0.
  EXPECT_NEAR(power[At(24, 7, 64)] / power[At(0, 25, 64)], 1, 1e-12);
  // 20 degrees off, with a spread of 10.
  const auto some = *PowerOf(Only(BandSpectrum{0, 120, {0, 1, 10}}), 256);
  const double off = std::atan2(20.0, 55.0) * 180 / std::numbers::pi / 10;
  const double length = 20.0 * 20 + 55 * 55;
  EXPECT_NEAR(some[At(55, 20, 256)] / some[At(-55, 0, 256)],
              std::exp(-0.5 * (off * off + (length - 55 * 55) / 14400)), 1e-9);
  const auto turned = *PowerOf(Only(BandSpectrum{0, 20, {90, 3, 0}}), 64);
  EXPECT_NEAR(turned[At(4, 5, 64)] / turned[At(0, 13, 64)], 1, 1e-12);  // 3 * 4, 5
}

TEST(PowerTest, LobesPowerLawsAndSums) {
  const auto lobes = *PowerOf(Only(LobeSpectrum{10, 5, 1}), 64);
  EXPECT_NEAR(lobes[At(-11, -5, 64)] / lobes[At(10, 5, 64)], std::exp(-0.5), 1e-9);
  EXPECT_LT(lobes[At(10, -5, 64)], 1e-20);
  const auto law = *PowerOf(Only(PowerLawSpectrum{3, 2, 20, {}}), 64);
  EXPECT_NEAR(law[At(12, 16, 64)] / law[At(0, 2, 64)], 1e-3, 1e-12);
  EXPECT_EQ(law[At(1, 1, 64)], 0);
  EXPECT_EQ(law[At(20, 1, 64)], 0);
  const NoiseSpectrum sum = {{LobeSpectrum{10, 5, 1}, 3}, {PowerLawSpectrum{3, 2, 20, {}}, 1}};
  const auto both = *PowerOf(sum, 64);
  double whole = 0;
  for (size_t i = 0; i < both.size(); ++i) {
    EXPECT_NEAR(both[i], 0.75 * lobes[i] + 0.25 * law[i], 1e-15);
    whole += both[i];
  }
  EXPECT_NEAR(whole, 1, 1e-12);
}

TEST(PowerTest, Painted) {
  // As large as the exemplar: a texel a frequency.
  Plane plane{16, 16, std::vector<float>(256)};
  plane.values[8 * 16 + 8] = 5;   // 0 itself does not count
  plane.values[9 * 16 + 11] = 3;  // (3, 1)
  plane.values[2 * 16 + 8] = 1;   // (0, -6)
  const auto power = *PowerOf(Only(PaintedSpectrum{plane}), 16);
  EXPECT_DOUBLE_EQ(power[At(3, 1, 16)], 0.375);
  EXPECT_DOUBLE_EQ(power[At(-3, -1, 16)], 0.375);
  EXPECT_DOUBLE_EQ(power[At(0, 6, 16)], 0.125);
  EXPECT_DOUBLE_EQ(power[At(0, -6, 16)], 0.125);
  // Smaller ones are larger spots, larger ones are averaged.
  Plane small{4, 4, std::vector<float>(16)};
  small.values[3 * 4 + 2] = 1;  // from (0, 4) to (3, 7) of 16
  const auto spots = *PowerOf(Only(PaintedSpectrum{small}), 16);
  EXPECT_NEAR(spots[At(3, 7, 16)], 1.0 / 32, 1e-15);
  EXPECT_NEAR(spots[At(-3, -7, 16)], 1.0 / 32, 1e-15);
  EXPECT_EQ(spots[At(4, 7, 16)], 0);
  Plane large{48, 48, std::vector<float>(48 * 48)};
  large.values[(24 + 4) * 48 + 24 + 9] = 1;   // in (3, 1)
  large.values[(24 + 3) * 48 + 24 + 15] = 3;  // in (5, 1)
  const auto means = *PowerOf(Only(PaintedSpectrum{large}), 16);
  EXPECT_NEAR(means[At(5, 1, 16)] / means[At(3, 1, 16)], 3, 1e-12);
  EXPECT_NEAR(means[At(5, 1, 16)], 0.375, 1e-12);
}

TEST(NoiseTest, HasItsMeanAndItsDeviation) {
  for (const NoiseSpectrum& spectrum :
       {Only(BandSpectrum{6, 2, {}}), Only(LobeSpectrum{3, 11, 1}), Only(PowerLawSpectrum{})}) {
    for (const double sigma : {kNoiseSigma, 2.5}) {
      NoiseOptions options;
      options.size = 64;
      options.sigma = sigma;
      const Plane plane = Make({spectrum}, options)[0];
      EXPECT_NEAR(Mean(plane), 0, 1e-8 * sigma);
      EXPECT_NEAR(Covariance(plane, plane), sigma * sigma, 1e-7 * sigma * sigma);
    }
  }
}

// Squared and divided by their power, the coefficients of Gaussian noise have an exponential
// distribution with the mean 1.
TEST(NoiseTest, HasItsSpectrumAndIsGaussian) {
  const NoiseSpectrum spectrum = {{PowerLawSpectrum{1, 1, 0, {30, 2, 0}}, 1},
                                  {BandSpectrum{20, 3, {}}, 1}};
  NoiseOptions options;
  options.size = 128;
  options.seed = 77;
  const std::vector<double> power = *PowerOf(spectrum, 128);
  const std::vector<double> shares = SharesOf(Make({spectrum}, options)[0]);
  // Octaves and four directions apart.
  std::map<std::pair<int, int>, std::array<double, 3>> parts;
  for (int y = 0; y < 64; ++y) {
    for (int x = -63; x < 64; ++x) {
      if (y == 0 && x <= 0) continue;  // the other half says the same
      const double length = std::hypot(x, y);
      const int octave = static_cast<int>(std::log2(length));
      const int direction = static_cast<int>(std::atan2(y, x) / std::numbers::pi * 3.999);
      const double z = shares[At(x, y, 128)] / power[At(x, y, 128)];
      auto& [count, sum, above] = parts[{octave, direction}];
      count += 1;
      sum += z;
      above += z > 1;
    }
  }
  ASSERT_GT(parts.size(), 20u);
  for (const auto& [part, numbers] : parts) {
    const auto [count, sum, above] = numbers;
    EXPECT_NEAR(sum / count, 1, 4 / std::sqrt(count)) << part.first << " " << part.second;
    EXPECT_NEAR(above / count, std::exp(-1), 4 * 0.483 / std::sqrt(count))
        << part.first << " " << part.second;
  }
}

TEST(NoiseTest, SeedsAndChannelsAreTheirOwn) {
  NoiseOptions options;
  options.size = 64;
  const NoiseSpectrum white = Only(PowerLawSpectrum{0, 0, 0, {}});
  const std::vector<Plane> planes = Make({white, white, white}, options);
  EXPECT_EQ(Make({white}, options)[0].values, planes[0].values);
  options.seed = 1;
  const Plane other = Make({white}, options)[0];
  const double variance = kNoiseSigma * kNoiseSigma;
  for (const auto& [a, b] : {std::pair(&planes[0], &planes[1]), std::pair(&planes[1], &planes[2]),
                             std::pair(&planes[0], &other)}) {
    EXPECT_LT(std::abs(Covariance(*a, *b)), 4 * variance / 64);
  }
}

TEST(NoiseTest, CovariancesAreExact) {
  NoiseOptions options;
  options.size = 64;
  options.sigma = 0.5;
  options.correlations = {1, 0.6, -0.3, 0.6, 1, 0, -0.3, 0, 1};
  const std::vector<NoiseSpectrum> spectra = {Only(BandSpectrum{8, 3, {}}),
                                              Only(BandSpectrum{10, 3, {}}),
                                              Only(PowerLawSpectrum{2, 5, 12, {}})};
  const std::vector<Plane> planes = Make(spectra, options);
  ASSERT_EQ(planes.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(Mean(planes[i]), 0, 1e-8);
    for (size_t j = 0; j < 3; ++j) {
      EXPECT_NEAR(Covariance(planes[i], planes[j]), 0.25 * options.correlations[3 * i + j], 1e-6)
          << i << " " << j;
    }
  }
  // Each still has its own spectrum: the third has nothing at 3 cycles, and the others have.
  EXPECT_LT(SharesOf(planes[2])[At(3, 0, 64)], 1e-12);
  EXPECT_GT(SharesOf(planes[0])[At(3, 0, 64)] + SharesOf(planes[0])[At(0, 3, 64)], 1e-8);
}

TEST(NoiseTest, TheEndsOfCorrelation) {
  NoiseOptions options;
  options.size = 32;
  options.correlations = {1, 1, 1, 1};
  const NoiseSpectrum band = Only(BandSpectrum{6, 2, {}});
  const std::vector<Plane> same = Make({band, band}, options);
  for (size_t i = 0; i < same[0].values.size(); ++i)
    ASSERT_NEAR(same[0].values[i], same[1].values[i], 1e-6);
  options.correlations = {1, -1, -1, 1};
  const std::vector<Plane> opposite = Make({band, band}, options);
  for (size_t i = 0; i < same[0].values.size(); ++i)
    ASSERT_NEAR(opposite[0].values[i], -opposite[1].values[i], 1e-6);
  // Nothing in common: 0 can be had, and nothing else.
  const std::vector<NoiseSpectrum> apart = {Only(PowerLawSpectrum{0, 1, 5, {}}),
                                            Only(PowerLawSpectrum{0, 8, 12, {}})};
  options.correlations = {1, 0, 0, 1};
  EXPECT_NEAR(Covariance(Make(apart, options)[0], Make(apart, options)[1]), 0, 1e-9);
  options.correlations = {1, 0.2, 0.2, 1};
  EXPECT_THAT(Complaint(apart, options), testing::HasSubstr("more in common"));
  options.correlations = {1, 0.9, 0.9, 0.9, 1, -0.9, 0.9, -0.9, 1};
  EXPECT_THAT(Complaint({band, band, band}, options), testing::HasSubstr("channel 2 cannot"));
}

TEST(NoiseTest, SaysWhatIsWrong) {
  const double nan = std::nan("");
  const NoiseOptions small{.size = 32};
  const std::pair<NoiseSpectrum, std::string> spectra[] = {
      {{}, "noise 'n': it has no parts"},
      {{{BandSpectrum{}, 0}}, "the share of a part is 0"},
      {Only(BandSpectrum{16, 4, {}}), "its frequency is 16; it can be 0 to 15"},
      {Only(BandSpectrum{nan, 4, {}}), "its frequency is nan"},
      {Only(BandSpectrum{6, 0.1, {}}), "its bandwidth is 0.1; it can be 0.25 to 15"},
      {Only(BandSpectrum{6, 4, {0, 0.5, 0}}), "its stretch is 0.5; it can be 1 to 64"},
      {Only(BandSpectrum{6, 4, {0, 1, 91}}), "its spread is 91; it can be 0 to 90"},
      {Only(BandSpectrum{6, 4, {400, 1, 0}}), "its direction is 400; it can be -360 to 360"},
      {Only(LobeSpectrum{0, -16, 1}), "its frequency is -16; it can be -15 to 15"},
      {Only(LobeSpectrum{0, 6, nan}), "its bandwidth is nan"},
      {Only(PowerLawSpectrum{9, 1, 0, {}}), "its exponent is 9; it can be -8 to 8"},
      {Only(PowerLawSpectrum{2, -1, 0, {}}), "its lowest frequency is -1; it can be 0 to 32"},
      {Only(PowerLawSpectrum{2, 4, 3, {}}), "its highest frequency is 3; it can be 4 to 32"},
      {Only(PowerLawSpectrum{2, 30, 31, {}}), "has no power at any frequency"},
      {Only(PaintedSpectrum{}), "its picture has no pixels"},
      {Only(PaintedSpectrum{{1, 1, {-1}}}), "its picture has numbers that are not 0 or more"},
      {Only(PaintedSpectrum{{1, 2, {0, 0}}}), "has no power at any frequency"}};
  for (const auto& [spectrum, message] : spectra)
    EXPECT_THAT(Complaint({spectrum}, small), testing::HasSubstr(message));
  const NoiseSpectrum good = Only(BandSpectrum{6, 2, {}});
  EXPECT_THAT(Complaint({good, {}}, small), testing::HasSubstr("in channel 1, it has no parts"));
  EXPECT_THAT(Complaint({}, small), testing::HasSubstr("it has 0 channels; it can have 1 to 4"));
  const std::pair<NoiseOptions, std::string> options[] = {
      {{.size = 48}, "its size is 48; it can be a power of two from 16 to 2048"},
      {{.size = 8}, "its size is 8"},
      {{.size = 32, .sigma = 0}, "its standard deviation is 0"},
      {{.size = 32, .correlations = {1, 0, 1}}, "it has 3 correlations; 2 channels have 4"},
      {{.size = 32, .correlations = {1, 0.5, 0.4, 1}}, "channels 1 and 0 correlate by 0.4 and 0.5"},
      {{.size = 32, .correlations = {1, 2, 2, 1}}, "channels 1 and 0 correlate by 2 and 2"},
      {{.size = 32, .correlations = {0.5, 0, 0, 1}}, "channels 0 and 0 correlate by 0.5"}};
  for (const auto& [o, message] : options)
    EXPECT_THAT(Complaint({good, good}, o), testing::HasSubstr(message));
}

}  // namespace
}  // namespace texgraph::textures
