// SPDX-License-Identifier: Apache-2.0
// The coarsest levels of patterns that are drawn at random, against a box over a random tiling.
#include <gtest/gtest.h>

#include <functional>

#include "compiler/textures/pattern_levels.h"
#include "compiler/textures/texels.h"
#include "tests/unit/textures/pattern_sets.h"
#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures {
namespace {

using test::PatternKind;
using test::PatternMaker;
using test::Tiling;

constexpr uint32_t kLayers = 64;
constexpr uint32_t kSide = 16;

// The tiling's texels summed up, so that the mean over any box takes four look-ups.
class Plane {
 public:
  static constexpr uint32_t kTiles = 64;
  static constexpr uint32_t kTexels = kTiles * kSide;

  Plane(const ir::Texture& patterns, const Tiling& tiling) : sums_((kTexels + 1) * (kTexels + 1)) {
    for (uint32_t y = 0; y < kTexels; ++y) {
      double row = 0;
      for (uint32_t x = 0; x < kTexels; ++x) {
        const size_t layer = tiling.At(x / kSide, y / kSide);
        row +=
            double{patterns.levels[0].texels[(layer * kSide + y % kSide) * kSide + x % kSide][0]};
        At(x + 1, y + 1) = At(x + 1, y) + row;
      }
    }
  }

  // A square of `side` tiles around (x, y), in tiles.
  double Mean(double x, double y, double side) const {
    const double l = (x - side / 2) * kSide, r = (x + side / 2) * kSide;
    const double b = (y - side / 2) * kSide, t = (y + side / 2) * kSide;
    return (Sum(r, t) - Sum(l, t) - Sum(r, b) + Sum(l, b)) / (side * side * kSide * kSide);
  }

 private:
  double& At(size_t x, size_t y) { return sums_[y * (kTexels + 1) + x]; }
  double At(size_t x, size_t y) const { return sums_[y * (kTexels + 1) + x]; }
  double Sum(double x, double y) const {
    const auto i = static_cast<size_t>(x), j = static_cast<size_t>(y);
    const double a = x - static_cast<double>(i), b = y - static_cast<double>(j);
    return (1 - b) * ((1 - a) * At(i, j) + a * At(i + 1, j)) +
           b * ((1 - a) * At(i, j + 1) + a * At(i + 1, j + 1));
  }

  std::vector<double> sums_;
};

// Errors of what trilinear filtering shows, root mean square, for pixels of `side` tiles.
double ErrorAt(const ir::Texture& shown, const Tiling& tiling, const Plane& plane, double side) {
  const auto lod = static_cast<float>(std::log2(side * kSide));
  const int steps = 160;
  double sum = 0;
  for (int j = 0; j < steps; ++j) {
    for (int i = 0; i < steps; ++i) {
      // All over the plane, and evenly within the tiles.
      const double x = 4 + (i + 0.5) * (Plane::kTiles - 8.0) / steps;
      const double y = 4 + (j + 0.5) * (Plane::kTiles - 8.0) / steps;
      const double error = double{tiling.Sample(shown, x, y, lod)[0]} - plane.Mean(x, y, side);
      sum += error * error;
    }
  }
  return std::sqrt(sum / (steps * steps));
}

// Over pixels of 2^from to 2^to tiles a side, in eighths of an octave.
double MeanError(const ir::Texture& shown, const Tiling& tiling, const Plane& plane, double from,
                 double to) {
  double sum = 0;
  int count = 0;
  for (double log = from; log <= to; log += 0.125, ++count) {
    const double error = ErrorAt(shown, tiling, plane, std::exp2(log));
    sum += error * error;
  }
  return std::sqrt(sum / count);
}

std::vector<double> Shares() {
  std::vector<double> weights;
  for (uint32_t i = 0; i < kLayers; ++i) weights.push_back(1 + i % 4);
  return LayerShares(weights, kLayers);
}

class MixLevelsTest : public testing::TestWithParam<PatternKind> {
 protected:
  MixLevelsTest() : given_(PatternMaker(GetParam(), kSide, kLayers, 4).Make()), mixed_(given_) {
    MixCoarsestLevels(mixed_, Shares(), true);
  }
  ir::Texture given_, mixed_;
  Tiling tiling_{Shares(), 11};
};
INSTANTIATE_TEST_SUITE_P(Kinds, MixLevelsTest,
                         testing::Values(PatternKind::kMatching, PatternKind::kSmooth,
                                         PatternKind::kWhite, PatternKind::kFlat),
                         [](const auto& info) { return test::NameOf(info.param); });

TEST_P(MixLevelsTest, TheCoarsestLevelIsTheMeanOfAll) {
  const std::vector<double> shares = Shares();
  double mean[3] = {};
  for (size_t layer = 0; layer < kLayers; ++layer) {
    for (size_t c = 0; c < 3; ++c)
      mean[c] += shares[layer] * double{given_.levels.back().texels[layer][c]};
  }
  for (const ir::Texel& texel : mixed_.levels.back().texels) {
    for (size_t c = 0; c < 3; ++c) EXPECT_NEAR(texel[c], mean[c], 1e-6);
    EXPECT_EQ(texel[3], 1);
  }
  for (size_t level = 0; level + 2 < given_.levels.size(); ++level)
    EXPECT_EQ(mixed_.levels[level].texels, given_.levels[level].texels);
}

TEST_P(MixLevelsTest, IsNearerToABoxOverTheTiling) {
  const Plane plane(given_, tiling_);
  // From 1/4 to 4 patterns a pixel, and where it is the mean of several.
  EXPECT_LT(MeanError(mixed_, tiling_, plane, -2, 2), MeanError(given_, tiling_, plane, -2, 2));
  // What all patterns have in common repeats in each tile; no level knows where the pixel lies.
  const double part = GetParam() == PatternKind::kMatching ? 1.0 : 0.75;
  EXPECT_LT(MeanError(mixed_, tiling_, plane, 1, 2),
            part * MeanError(given_, tiling_, plane, 1, 2));
}

// Where all is one mean, what is missed is the deviation of a box over the tiling.
TEST(MixLevelsTest, ErrorsAreThoseOfAMean) {
  const ir::Texture given = PatternMaker(PatternKind::kFlat, kSide, kLayers, 4).Make();
  ir::Texture mixed = given;
  MixCoarsestLevels(mixed, Shares(), true);
  const Tiling tiling(Shares(), 11);
  const Plane plane(given, tiling);
  double mean = 0, square = 0;
  for (size_t layer = 0; layer < kLayers; ++layer) {
    const double color = double{given.levels.back().texels[layer][0]};
    mean += Shares()[layer] * color;
    square += Shares()[layer] * color * color;
  }
  const double sigma = std::sqrt(square - mean * mean);
  // One side of n tiles and a part, at all places: n - 1 whole ones and two parts with the sum 1,
  // or n of them; the mean square of the parts is (n - 1/3) / n^2.
  for (double n : {1.0, 2.0, 4.0}) {
    const double expected = sigma * (n - 1 / 3.0) / (n * n);
    EXPECT_NEAR(ErrorAt(mixed, tiling, plane, n), expected, 0.06 * expected) << n;
  }
}

// The level before the last, with other shares of the mean than the one that it has.
TEST(MixedShareTest, IsTheBestForFlatPatternsAndHarmsNoOthers) {
  for (PatternKind kind : {PatternKind::kFlat, PatternKind::kMatching, PatternKind::kWhite}) {
    const ir::Texture given = PatternMaker(kind, kSide, kLayers, 4).Make();
    ir::Texture mixed = given;
    MixCoarsestLevels(mixed, Shares(), true);
    const Tiling tiling(Shares(), 11);
    const Plane plane(given, tiling);
    const size_t before = given.levels.size() - 2;
    const double error = MeanError(mixed, tiling, plane, -2, -0.125);
    for (double scale : {0.0, 2.5}) {  // none of it, and too much
      ir::Texture other = mixed;
      for (size_t i = 0; i < other.levels[before].texels.size(); ++i) {
        const float from = given.levels[before].texels[i][0];
        const float to = mixed.levels[before].texels[i][0];
        other.levels[before].texels[i][0] = from + static_cast<float>(scale) * (to - from);
      }
      const double other_error = MeanError(other, tiling, plane, -2, -0.125);
      if (kind == PatternKind::kFlat) {
        EXPECT_LT(error, other_error) << scale;
      } else {
        EXPECT_LT(error, 1.002 * other_error) << test::NameOf(kind) << ' ' << scale;
      }
    }
  }
}

TEST(MixLevelsTest, OpacityWeighsColors) {
  std::vector<uint32_t> red, blue;
  for (int i = 0; i < 16; ++i) {
    red.insert(red.end(), {255, 0, 0, 255});
    blue.insert(blue.end(), {0, 0, 255, 51});
  }
  const Image layers[] = {test::MakeImage(4, 4, 4, 8, red), test::MakeImage(4, 4, 4, 8, blue)};
  TextureOptions options;
  options.is_array = true;
  options.as_float = true;
  options.alpha_is_opacity = true;
  options.weights = {2, 1};
  Diagnostics diagnostics;
  const ir::Texture texture = ToTexture(*MakeTexture(layers, options, "t", {}, diagnostics));
  ASSERT_EQ(texture.levels.size(), 3u);
  const double opacity = (2 + 0.2) / 3, part = 2 / 2.2;
  for (const ir::Texel& texel : texture.levels[2].texels) {
    EXPECT_NEAR(texel[0], part, 1e-5);
    EXPECT_NEAR(texel[2], 1 - part, 1e-5);
    EXPECT_NEAR(texel[3], opacity, 1e-6);
  }
  // On the way there, also as parts of opacity.
  const ir::Texel& on_the_way = texture.levels[1].texels[0];
  const double moved = 1 + 0.112 * (opacity - 1), moved_blue = 0.112 * (1 - part) * opacity;
  EXPECT_NEAR(on_the_way[3], moved, 1e-5);
  EXPECT_NEAR(on_the_way[2], moved_blue / moved, 1e-4);
  EXPECT_EQ(texture.levels[0].texels[0], (ir::Texel{1, 0, 0, 1}));
  // A level that is not used is not made.
  options.max_level = 1;
  EXPECT_EQ(ToTexture(*MakeTexture(layers, options, "t", {}, diagnostics)).levels.size(), 2u);
}

// Where borders match, they go on matching.
TEST(MixLevelsTest, KeepsMatchedBorders) {
  for (PatternKind kind : {PatternKind::kMatching, PatternKind::kSmooth, PatternKind::kWhite}) {
    ir::Texture texture = PatternMaker(kind, kSide, kLayers, 5).Make();
    MatchEdges(texture, Shares(), true);
    const size_t before = texture.levels.size() - 2;
    const BorderRatios matched = MeasureBorders(texture.levels[before]);
    MixCoarsestLevels(texture, Shares(), true);
    const BorderRatios mixed = MeasureBorders(texture.levels[before]);
    EXPECT_LE(mixed.values, matched.values + 1e-6);
    EXPECT_LE(mixed.slopes, matched.slopes + 1e-6);
  }
}

TEST(MixLevelsTest, SmallTexturesKeepTheirTexels) {
  for (uint32_t side : {1u, 2u}) {
    const ir::Texture given = PatternMaker(PatternKind::kFlat, side, 4, 5).Make();
    ir::Texture mixed = given;
    MixCoarsestLevels(mixed, LayerShares({}, 4), true);
    EXPECT_EQ(mixed.levels[0].texels, given.levels[0].texels);
  }
}

TEST(LayerSharesTest, AreAPartOfOne) {
  const double weights[] = {1, 0, 3};
  EXPECT_EQ(LayerShares(weights, 3), (std::vector<double>{0.25, 0, 0.75}));
  EXPECT_EQ(LayerShares(weights, 2), (std::vector<double>{0.5, 0.5}));
  const double nothing[] = {0, 0};
  EXPECT_EQ(LayerShares(nothing, 2), (std::vector<double>{0.5, 0.5}));
}

}  // namespace
}  // namespace texgraph::textures
