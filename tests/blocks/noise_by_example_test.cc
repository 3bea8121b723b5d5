// SPDX-License-Identifier: Apache-2.0
// Noise by example: the blocks against what their textures hold, statistics of the plane that they
// cover, and brute force over the footprints of pixels.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "compiler/textures/gaussianize.h"
#include "compiler/textures/map_filter.h"
#include "compiler/textures/moments.h"
#include "compiler/textures/noise_spectrum.h"
#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using reference::CellHash;
using reference::Pcg;

// Two noises of `frequency` waves across.
ir::Texture Exemplar(uint32_t size, double frequency, uint32_t seed = 1) {
  Diagnostics diagnostics;
  const textures::NoiseSpectrum band = {{textures::BandSpectrum{frequency, 1, {}}, 1}};
  const std::vector<textures::NoiseSpectrum> channels = {band, band};
  textures::NoiseOptions options;
  options.size = size;
  options.seed = seed;
  const auto planes = textures::MakeNoise(channels, options, "noise", {}, diagnostics);
  const auto moments = textures::MakeMoments(*planes, "noise", {}, diagnostics);
  return ToTexture(textures::PackMoments(*moments, textures::MomentFormat::kHalves, false).moments);
}

// Squares of four pixels, the first at the point.
std::vector<Vector> Quads(const std::vector<Vector>& points, double pixel) {
  std::vector<Vector> quads;
  for (const Vector& p : points) {
    for (int i = 0; i < 4; ++i) quads.push_back({p[0] + (i & 1) * pixel, p[1] + (i >> 1) * pixel});
  }
  return quads;
}

std::map<std::string, Values> Field(const ir::Texture& noise, const std::vector<Vector>& uv,
                                    int taps = 1, double exponent = 2,
                                    std::pair<int32_t, int32_t> period = {0, 0}, int seed = 0) {
  return RunBlock("noise_field", {{"noise", noise},
                                  {"uv", Vectors(uv)},
                                  {"tiling", Vectors({{1, 1}})},
                                  {"scale", Vectors({{4, 4}})},
                                  {"exponent", Floats({exponent})},
                                  {"taps", Ints({taps})},
                                  {"period", CellsOf({period})},
                                  {"seed", Ints({seed})}});
}

// Middles of texels of an exemplar of `size`, anywhere in a plane of many.
std::vector<Vector> TexelMiddles(size_t count, int size, int reach, uint32_t seed) {
  std::mt19937 random(seed);
  const auto place = [&] {
    const auto texel = static_cast<int64_t>(random() % uint32_t(size * reach));
    return (static_cast<double>(texel) + 0.5) / size;
  };
  std::vector<Vector> points;
  for (size_t i = 0; i < count; ++i) points.push_back({place(), place()});
  return points;
}

TEST(NoiseOffsetTest, IsWholeTexelsByTheHash) {
  std::vector<std::pair<int32_t, int32_t>> nodes = {{0, 0}, {5, -3}, {-70000, 12}, {3, 1}};
  auto out =
      RunBlock("noise_offset",
               {{"node", CellsOf(nodes)}, {"texels", CellsOf({{64, 48}})}, {"seed", Ints({7})}});
  for (size_t i = 0; i < nodes.size(); ++i) {
    const uint32_t bits = Pcg(CellHash(nodes[i].first, nodes[i].second, 7) - 1);
    EXPECT_FLOAT_EQ(out["result"].Float(i, 0), std::floor(reference::Low16(bits) * 64) / 64);
    EXPECT_FLOAT_EQ(out["result"].Float(i, 1), std::floor(reference::High16(bits) * 48) / 48);
  }
}

// At a texel's middle the plane is the sum of three texels, with the shares of the hexagons divided
// by the root of the sum of their squares.
TEST(NoiseFieldTest, BlendsTexels) {
  const ir::Texture noise = Exemplar(32, 4);
  const std::vector<Vector> points = TexelMiddles(400, 32, 20, 3);
  std::vector<Vector> places;
  for (const Vector& p : points) places.push_back({4 * p[0], 4 * p[1]});
  auto shares = RunBlock("hex_shares", {{"place", Vectors(places)}, {"exponent", Floats({3})}});
  auto out = Field(noise, Quads(points, 1e-5), 1, 3);
  for (size_t i = 0; i < points.size(); ++i) {
    std::array<double, 2> sum{};
    double squares = 0;
    for (size_t k = 0; k < 3; ++k) {
      const double share = shares["shares"].Float(i, k);
      const Values& node = shares[k == 0 ? "first" : k == 1 ? "second" : "third"];
      const uint32_t bits = Pcg(CellHash(node.Int(i, 0), node.Int(i, 1), 0) - 1);
      const auto column = static_cast<uint32_t>(points[i][0] * 32) + (bits & 0xffff) * 32 / 65536;
      const auto row = static_cast<uint32_t>(points[i][1] * 32) + (bits >> 16) * 32 / 65536;
      const ir::Texel& texel = noise.levels[0].texels[row % 32 * 32 + column % 32];
      for (size_t c = 0; c < 2; ++c) sum[c] += share * double{texel[c]};
      squares += share * share;
    }
    for (size_t c = 0; c < 2; ++c) {
      EXPECT_NEAR(out["value"].Float(4 * i, c), 0.5 + sum[c] / std::sqrt(squares), 2e-3);
      EXPECT_EQ(out["deviation"].Float(4 * i, c), 0);
    }
  }
}

// In the middles of hexagons as between two and between three of them.
TEST(NoiseFieldTest, HasItsVarianceEverywhere) {
  const ir::Texture noise = Exemplar(64, 6);
  const std::vector<Vector> points = TexelMiddles(6000, 64, 2000, 5);
  std::vector<Vector> places;
  for (const Vector& p : points) places.push_back({4 * p[0], 4 * p[1]});
  auto shares = RunBlock("hex_shares", {{"place", Vectors(places)}, {"exponent", Floats({1})}});
  auto out = Field(noise, Quads(points, 1e-5), 1, 1);
  std::array<double, 3> count{}, sum{}, squares{};
  for (size_t i = 0; i < points.size(); ++i) {
    double most = 0;
    for (size_t k = 0; k < 3; ++k) most = std::max(most, double{shares["shares"].Float(i, k)});
    const size_t zone = most > 0.7 ? 0 : most > 0.48 ? 1 : 2;
    const double value = out["value"].Float(4 * i) - 0.5;
    count[zone] += 1;
    sum[zone] += value;
    squares[zone] += value * value;
  }
  for (size_t zone = 0; zone < 3; ++zone) {
    ASSERT_GT(count[zone], 500);
    // Four standard deviations of a mean, and of a variance.
    EXPECT_NEAR(sum[zone] / count[zone], 0, 4 / 6.0 / std::sqrt(count[zone])) << zone;
    EXPECT_NEAR(squares[zone] / count[zone] * 36, 1, 4 * std::sqrt(2 / count[zone])) << zone;
  }
}

TEST(NoiseFieldTest, RepeatsAfterItsPeriodOnly) {
  const ir::Texture noise = Exemplar(32, 4);
  const std::vector<Vector> points = TexelMiddles(300, 32, 1, 8);
  std::vector<Vector> moved;
  for (const Vector& p : points) moved.push_back({p[0] + 2, p[1] - 1});
  auto here = Field(noise, Quads(points, 1e-5), 1, 2, {8, 4});
  auto there = Field(noise, Quads(moved, 1e-5), 1, 2, {8, 4});
  auto free = Field(noise, Quads(moved, 1e-5));
  auto other = Field(noise, Quads(points, 1e-5), 1, 2, {8, 4}, 1);
  size_t same = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(here["value"].Float(4 * i), there["value"].Float(4 * i), 1e-4);
    same += std::abs(here["value"].Float(4 * i) - free["value"].Float(4 * i)) < 1e-3;
    same += std::abs(here["value"].Float(4 * i) - other["value"].Float(4 * i)) < 1e-3;
  }
  EXPECT_LT(same, 30u);
}

// The mean and the deviation within pixels of 8 texels, waves being 32 long, against 256 points in
// each. With four taps the deviation is within a tenth.
TEST(NoiseFieldTest, KnowsWhatIsInAPixel) {
  const ir::Texture noise = Exemplar(128, 4);
  constexpr double kPixel = 8.0 / 128;
  constexpr int kSide = 16;
  std::mt19937 random(4);
  std::vector<Vector> middles, inside;
  for (int i = 0; i < 80; ++i) {
    middles.push_back({random() * 0x1p-32 * 50, random() * 0x1p-32 * 50});
    for (int k = 0; k < kSide * kSide; ++k) {
      inside.push_back({middles.back()[0] + ((k % kSide + 0.5) / kSide - 0.5) * kPixel,
                        middles.back()[1] + ((k / kSide + 0.5) / kSide - 0.5) * kPixel});
    }
  }
  auto near = Field(noise, inside, 1, 1);
  const std::vector<Vector> quads = Quads(middles, kPixel);
  // With one tap as the paper has it: table 1, low frequency, 8 x 8.
  for (const auto& [taps, mean_limit, limit] :
       {std::tuple(1, 0.033, 0.31), std::tuple(2, 0.0165, 0.1)}) {
    auto far = Field(noise, quads, taps, 1);
    double mean_off = 0, off = 0, whole = 0;
    for (size_t i = 0; i < middles.size(); ++i) {
      double sum = 0, squares = 0;
      for (size_t k = 0; k < kSide * kSide; ++k) {
        const double value = near["value"].Float(i * kSide * kSide + k);
        sum += value / (kSide * kSide);
        squares += value * value / (kSide * kSide);
      }
      const double deviation = std::sqrt(std::max(squares - sum * sum, 0.0));
      mean_off += std::abs(far["value"].Float(4 * i) - sum);
      off += std::abs(far["deviation"].Float(4 * i) - deviation);
      whole += deviation;
    }
    EXPECT_LT(mean_off / double(middles.size()), mean_limit) << taps;
    EXPECT_LT(off / whole, limit) << taps;
  }
}

TEST(NoiseFieldTest, FromFarAwayAllOfItIsInAPixel) {
  const ir::Texture noise = Exemplar(32, 4);
  auto out = Field(noise, Quads(TexelMiddles(50, 32, 100, 2), 7.3));
  for (size_t i = 0; i < 50; ++i) {
    EXPECT_NEAR(out["value"].Float(4 * i, 1), 0.5, 1e-3);
    EXPECT_NEAR(out["deviation"].Float(4 * i, 1), 1 / 6.0, 1e-3);
  }
}

textures::Image RandomMap(uint32_t width, uint32_t height, uint8_t channels) {
  std::mt19937 random(7);
  textures::Image image;
  image.width = width;
  image.height = height;
  image.channels = channels;
  image.pixels.resize(size_t{width} * height * channels);
  for (uint8_t& byte : image.pixels) byte = static_cast<uint8_t>(random());
  return image;
}

// Four layers, mixed so that the squares of their deviations are; alpha weighs colours.
TEST(ColorMap2dTest, MixesLayersBySquares) {
  for (const uint32_t sigmas : {2u, 7u, 8u}) {
    Diagnostics diagnostics;
    textures::TextureOptions how;
    how.as_float = how.alpha_is_opacity = true;
    textures::MapFilterOptions options;
    options.sigmas = sigmas;
    const ir::Texture map =
        ToTexture(*MakeColorMap(RandomMap(12, 9, 4), how, options, "map", {}, diagnostics));
    std::mt19937 random(sigmas);
    std::vector<Vector> values, deviations;
    for (int i = 0; i < 300; ++i) {
      const auto pick = [&] { return random() * 0x1p-32; };
      values.push_back({1.4 * pick() - 0.2, pick()});
      deviations.push_back({i % 5 == 0 ? 0 : 0.3 * std::pow(pick(), 3),
                            i % 7 == 0 ? SigmaAt(options, uint32_t(i) % sigmas) : 0.3 * pick()});
    }
    auto out =
        RunBlock("color_map_2d",
                 {{"map", map}, {"value", Vectors(values)}, {"deviation", Vectors(deviations)}});
    for (size_t i = 0; i < values.size(); ++i) {
      std::array<double, 4> sum{};
      std::array<double, 2> index, part;
      for (size_t c = 0; c < 2; ++c) {
        index[c] = SigmaIndex(options, deviations[i][c]);
        const double below = std::min(std::floor(index[c]), sigmas - 2.0);
        part[c] = index[c] - below;
        index[c] = below;
      }
      for (int k = 0; k < 4; ++k) {
        const double share = (k % 2 ? part[0] : 1 - part[0]) * (k / 2 ? part[1] : 1 - part[1]);
        const uint32_t layer =
            MapLayer(options, uint32_t(index[0]) + k % 2, uint32_t(index[1]) + k / 2);
        const float at[3] = {float(values[i][0]), float(values[i][1]), float(layer)};
        const ir::Texel texel = ir::SampleLod(map, at, 0);
        for (size_t c = 0; c < 3; ++c) sum[c] += share * double{texel[c]} * double{texel[3]};
        sum[3] += share * double{texel[3]};
      }
      for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(out["result"].Float(i, c), sum[c] / sum[3], 1e-4) << sigmas << " " << i;
      EXPECT_NEAR(out["result"].Float(i, 3), sum[3], 1e-4);
    }
  }
}

// A map of three hard sectors over two noises: from far away the mean stays, and each pixel is near
// to the mean of what is in it; nearer than without the deviation.
TEST(ColorMap2dTest, FiltersWhatNoiseMakesOfIt) {
  const ir::Texture noise = Exemplar(128, 4);
  textures::Image sectors = RandomMap(64, 64, 3);
  for (uint32_t i = 0; i < 64 * 64; ++i) {
    const double turns = std::atan2(i / 64 - 31.5, i % 64 - 31.5) / 6.2831853 + 0.5;
    const auto which = static_cast<uint32_t>(turns * 3);
    for (uint32_t c = 0; c < 3; ++c) sectors.pixels[3 * i + c] = c == which ? 255 : 0;
  }
  Diagnostics diagnostics;
  textures::TextureOptions how;
  how.srgb = false;
  const ir::Texture map = ToTexture(*MakeColorMap(sectors, how, {}, "map", {}, diagnostics));
  const auto color = [&](const std::map<std::string, Values>& field, bool filtered) {
    Values none = Vectors({{0, 0}});
    return RunBlock("color_map_2d", {{"map", map},
                                     {"value", field.at("value")},
                                     {"deviation", filtered ? field.at("deviation") : none}});
  };
  constexpr int kSide = 16;
  constexpr double kPixel = 16.0 / 128;
  std::mt19937 random(9);
  std::vector<Vector> middles, inside;
  for (int i = 0; i < 100; ++i) {
    middles.push_back({random() * 0x1p-32 * 50, random() * 0x1p-32 * 50});
    for (int k = 0; k < kSide * kSide; ++k) {
      inside.push_back({middles.back()[0] + ((k % kSide + 0.5) / kSide - 0.5) * kPixel,
                        middles.back()[1] + ((k / kSide + 0.5) / kSide - 0.5) * kPixel});
    }
  }
  auto near = color(Field(noise, inside, 1, 1), false);
  const auto far = Field(noise, Quads(middles, kPixel), 2, 1);
  auto filtered = color(far, true);
  auto plain = color(far, false);
  double error = 0, plain_error = 0;
  std::array<double, 3> bias{};
  for (size_t i = 0; i < middles.size(); ++i) {
    double square = 0, plain_square = 0;
    for (size_t c = 0; c < 3; ++c) {
      double mean = 0;
      for (size_t k = 0; k < kSide * kSide; ++k)
        mean += near["result"].Float(i * kSide * kSide + k, c) / (kSide * kSide);
      square += std::pow(filtered["result"].Float(4 * i, c) - mean, 2);
      plain_square += std::pow(plain["result"].Float(4 * i, c) - mean, 2);
      bias[c] += (filtered["result"].Float(4 * i, c) - mean) / double(middles.size());
    }
    error += std::sqrt(square) / double(middles.size());
    plain_error += std::sqrt(plain_square) / double(middles.size());
  }
  EXPECT_LT(error, 0.5 * plain_error);
  // Two standard deviations of the mean of 100 such pixels.
  for (const double channel : bias) EXPECT_NEAR(channel, 0, 0.02);
}

struct Picture {
  ir::Texture noise, table;
  std::array<double, 3> mean{}, deviation{};
};

// Dark with bright spots, as `skewed` says, or of one colour.
Picture MakePicture(bool skewed) {
  Diagnostics diagnostics;
  const textures::NoiseSpectrum band = {{textures::BandSpectrum{7, 2, {}}, 1}};
  const std::vector<textures::NoiseSpectrum> spectra(3, band);
  textures::NoiseOptions options;
  options.size = 64;
  options.sigma = 1;
  auto planes = *textures::MakeNoise(spectra, options, "", {}, diagnostics);
  Picture picture;
  for (size_t c = 0; c < 3; ++c) {
    for (float& value : planes[c].values) {
      value = skewed ? std::exp(0.6f * value - 2) : 0.2f * static_cast<float>(c + 1);
      picture.mean[c] += value / 4096;
    }
    for (const float value : planes[c].values)
      picture.deviation[c] += std::pow(value - picture.mean[c], 2) / 4096;
    picture.deviation[c] = std::sqrt(picture.deviation[c]);
  }
  const auto exemplar = textures::Gaussianize(planes, {}, "", {}, diagnostics);
  picture.noise = ToTexture(NoiseTexture(*exemplar));
  picture.table = ToTexture(TableTexture(*exemplar));
  return picture;
}

std::map<std::string, Values> Cover(const Picture& picture, const std::vector<Vector>& uv) {
  return RunBlock("histogram_tiling", {{"noise", picture.noise},
                                       {"table", picture.table},
                                       {"uv", Vectors(uv)},
                                       {"tiling", Vectors({{1, 1}})},
                                       {"exponent", Floats({1})}});
}

TEST(HistogramTilingTest, AConstantStays) {
  const Picture picture = MakePicture(false);
  for (const double pixel : {1e-4, 0.1, 3.0}) {
    auto out = Cover(picture, Quads(TexelMiddles(100, 64, 30, 1), pixel));
    for (size_t i = 0; i < 400; ++i) {
      for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(out["result"].Float(i, c), 0.2 * double(c + 1), 5e-4);
      EXPECT_EQ(out["result"].Float(i, 3), 1);
    }
  }
}

// From near, colours are as often as in the picture; from far away, the mean is seen.
TEST(HistogramTilingTest, KeepsTheHistogramAndTheMean) {
  const Picture picture = MakePicture(true);
  const std::vector<Vector> points = TexelMiddles(3000, 64, 500, 2);
  auto near = Cover(picture, Quads(points, 1e-5));
  auto far = Cover(picture, Quads(TexelMiddles(50, 64, 500, 3), 2.7));
  for (size_t c = 0; c < 3; ++c) {
    double mean = 0, square = 0, skew = 0;
    const auto n = static_cast<double>(points.size());
    for (size_t i = 0; i < points.size(); ++i) mean += near["result"].Float(4 * i, c) / n;
    for (size_t i = 0; i < points.size(); ++i) {
      const double off = (near["result"].Float(4 * i, c) - picture.mean[c]) / picture.deviation[c];
      square += off * off / n;
      skew += off * off * off / n;
    }
    EXPECT_NEAR(mean / picture.mean[c], 1, 0.04) << c;
    EXPECT_NEAR(std::sqrt(square), 1, 0.1) << c;
    EXPECT_GT(skew, 1) << c;  // a mean of pictures has less
    for (size_t i = 0; i < 50; ++i)
      EXPECT_NEAR(far["result"].Float(4 * i, c) / picture.mean[c], 1, 0.02) << c;
  }
}

}  // namespace
}  // namespace texgraph::blocks
