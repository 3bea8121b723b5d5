// SPDX-License-Identifier: Apache-2.0
// Borders of patterns that stand beside each other in any order: measured by sampling random
// tilings, as a shader would, and compared with what the patterns are inside.
#include <gtest/gtest.h>

#include "compiler/textures/pattern_levels.h"
#include "compiler/textures/texels.h"
#include "tests/unit/textures/pattern_sets.h"
#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures {
namespace {

using test::PatternKind;
using test::PatternMaker;
using test::Tiling;

constexpr uint32_t kLayers = 16;

// Mean absolute differences of what random tilings show, over borders and inside of patterns.
struct Mean {
  double sum = 0, count = 0;
  void Add(double value) {
    sum += value;
    ++count;
  }
  double Get() const { return sum / count; }
};
struct Steps {
  Mean value_border, value_inside;  // over the borders of tiles, and over those of texels
  Mean kink_border, kink_inside;    // of the slope, which inside are at the middles of texels
  Mean slope_border, slope_inside;  // second differences in steps of a texel, wherever they begin
};

class Walker {
 public:
  Walker(const ir::Texture& patterns, size_t level, uint32_t seed)
      : patterns_(patterns),
        level_(level),
        side_(patterns.levels[level].width),
        tiling_(LayerShares({}, kLayers), seed),
        random_(seed) {}

  void Walk(double step, Steps& steps) {
    for (int i = 0; i < 1500; ++i) {
      const double border = static_cast<double>(random_() % 1000 * side_);
      const double offset = Uniform() - 0.5;
      steps.value_border.Add(First(border + offset * step, step));
      steps.kink_border.Add(Second(border, 0.25));
      const uint32_t margin = side_ > 2 ? 2 : 1;  // so that no step leaves the tile
      const double inside =
          border + margin + static_cast<double>(random_() % (side_ - 2 * margin + 1));
      steps.value_inside.Add(First(inside + offset * step, step));
      steps.kink_inside.Add(Second(border + 0.5 + static_cast<double>(random_() % side_), 0.25));
      if (side_ == 2) continue;
      steps.slope_border.Add(Second(border + offset, 1));
      steps.slope_inside.Add(Second(inside + offset, 1));
    }
  }

  // The largest jump over borders, right and left of them.
  double LargestJump() {
    double largest = 0;
    for (int i = 0; i < 500; ++i) {
      NewLine();
      const double border = static_cast<double>(random_() % 1000 * side_);
      const ir::Texel a = At(border - 1e-8 * side_), b = At(border + 1e-8 * side_);
      for (size_t c = 0; c < 4; ++c)
        largest = std::max(largest, std::abs(double{a[c]} - double{b[c]}));
    }
    return largest;
  }

 private:
  double Uniform() { return static_cast<double>(random_() >> 8) * 0x1p-24; }
  void NewLine() {
    vertical_ = random_() % 2 == 0;
    line_ = Uniform() * 1000;
  }
  ir::Texel At(double texels) const {
    const double along = texels / side_;
    return tiling_.Sample(patterns_, vertical_ ? line_ : along, vertical_ ? along : line_,
                          static_cast<float>(level_));
  }
  double First(double middle, double step) {
    NewLine();
    const ir::Texel a = At(middle - step / 2), b = At(middle + step / 2);
    double sum = 0;
    for (size_t c = 0; c < 3; ++c) sum += std::abs(double{b[c]} - double{a[c]});
    return sum;
  }
  double Second(double middle, double step) {
    NewLine();
    const ir::Texel a = At(middle - step), b = At(middle), d = At(middle + step);
    double sum = 0;
    for (size_t c = 0; c < 3; ++c) sum += std::abs(double{a[c]} - 2 * double{b[c]} + double{d[c]});
    return sum;
  }

  const ir::Texture& patterns_;
  size_t level_;
  uint32_t side_;
  Tiling tiling_;
  std::mt19937 random_;
  bool vertical_ = false;
  double line_ = 0;
};

class MatchEdgesTest : public testing::TestWithParam<PatternKind> {};
INSTANTIATE_TEST_SUITE_P(Kinds, MatchEdgesTest,
                         testing::Values(PatternKind::kMatching, PatternKind::kSmooth,
                                         PatternKind::kWhite, PatternKind::kFlat),
                         [](const auto& info) { return test::NameOf(info.param); });

// Several sets: what is common to the borders of one set is little to measure.
TEST_P(MatchEdgesTest, NoBorderShowsAtAnyLevel) {
  constexpr uint32_t kSets = 6;
  std::vector<ir::Texture> sets;
  for (uint32_t seed = 1; seed <= kSets; ++seed) {
    const ir::Texture given = PatternMaker(GetParam(), 64, kLayers, seed).Make();
    ir::Texture& matched = sets.emplace_back(given);
    MatchEdges(matched, LayerShares({}, kLayers), true);
    EXPECT_EQ(matched.levels.back().texels, given.levels.back().texels);  // no border to match
  }
  for (size_t level = 0; level < 6; ++level) {
    const bool is_tiny = level >= 4;  // 4 and 2 texels a side
    for (double step : {is_tiny ? 0.5 : 0.25, 1.0}) {
      Steps steps;
      for (uint32_t i = 0; i < kSets; ++i) {
        Walker walker(sets[i], level, i);
        if (!is_tiny) {
          EXPECT_LE(walker.LargestJump(), 1e-5) << "level " << level;
        }
        walker.Walk(step, steps);
      }
      const std::string where = "level " + std::to_string(level) + " step " + std::to_string(step);
      EXPECT_LE(steps.value_border.Get(), 1.1 * steps.value_inside.Get() + 1e-6) << where;
      if (!is_tiny) {
        EXPECT_LE(steps.kink_border.Get(), 1.1 * steps.kink_inside.Get() + 1e-6) << where;
      }
      if (level == 5) continue;
      EXPECT_LE(steps.slope_border.Get(), 1.1 * steps.slope_inside.Get() + 1e-6) << where;
    }
    for (const ir::Texture& matched : sets) {
      for (const ir::Texel& texel : matched.levels[level].texels) {
        for (float channel : texel) ASSERT_TRUE(channel >= 0 && channel <= 1);
      }
    }
  }
}

TEST(MatchEdgesTest, ItIsNeeded) {
  // Patterns that fit at level 0 do not at the others: there their borders are parts of larger
  // texels.
  const ir::Texture matching = PatternMaker(PatternKind::kMatching, 64, kLayers, 1).Make();
  for (size_t level = 3; level < 6; ++level)
    EXPECT_GT(Walker(matching, level, 7).LargestJump(), 0.01) << "level " << level;
  const ir::Texture smooth = PatternMaker(PatternKind::kSmooth, 64, kLayers, 1).Make();
  for (size_t level = 0; level < 6; ++level) {
    Steps steps;
    Walker(smooth, level, 7).Walk(0.25, steps);
    EXPECT_GT(steps.value_border.Get(), 1.2 * steps.value_inside.Get()) << "level " << level;
  }
}

TEST(MatchEdgesTest, WhatFitsIsLeftAsItIs) {
  const ir::Texture given = PatternMaker(PatternKind::kMatching, 64, kLayers, 2).Make();
  ir::Texture matched = given;
  MatchEdges(matched, LayerShares({}, kLayers), true);
  EXPECT_EQ(matched.levels[0].texels, given.levels[0].texels);
}

// Noise has room for any border: its outermost texels alone are changed.
TEST(MatchEdgesTest, ChangesNoMoreThanIsNeeded) {
  const ir::Texture given = PatternMaker(PatternKind::kWhite, 64, kLayers, 2).Make();
  ir::Texture matched = given;
  MatchEdges(matched, LayerShares({}, kLayers), true);
  for (size_t level = 0; level < 4; ++level) {
    const uint32_t side = given.levels[level].width;
    for (size_t i = 0; i < given.levels[level].texels.size(); ++i) {
      const size_t x = i % side, y = i / side % side;
      if (std::min({x, y, side - 1 - x, side - 1 - y}) == 0) continue;
      ASSERT_EQ(matched.levels[level].texels[i], given.levels[level].texels[i]) << level;
    }
  }
}

// Whatever the colours: black and white texels leave no room for slopes.
TEST(MatchEdgesTest, HoldsAtTheEndsOfTheRange) {
  for (auto [width, height] : {std::pair{8u, 8u}, {5u, 9u}, {17u, 6u}}) {
    ir::Texture texture;
    texture.is_array = true;
    ir::Texture::Level& level = texture.levels.emplace_back();
    level.width = width;
    level.height = height;
    level.depth = kLayers;
    std::mt19937 random(9);
    for (size_t i = 0; i < size_t{width} * height * kLayers; ++i) {
      ir::Texel& texel = level.texels.emplace_back();
      for (float& channel : texel) channel = random() % 2 == 0 ? 0.0f : 1.0f;
    }
    MatchEdges(texture, LayerShares({}, kLayers), true);
    const ir::Texture::Level& matched = texture.levels[0];
    for (const ir::Texel& texel : matched.texels) {
      for (float channel : texel) ASSERT_TRUE(channel >= 0 && channel <= 1);
    }
    const auto at = [&](size_t layer, size_t x, size_t y, size_t c) {
      return matched.texels[(layer * height + y) * width + x][c];
    };
    for (size_t layer = 1; layer < kLayers; ++layer) {
      for (size_t c = 0; c < 4; ++c) {
        for (size_t y = 0; y < height; ++y) {
          ASSERT_NEAR(at(layer, 0, y, c) + at(layer, width - 1, y, c),
                      at(0, 0, y, c) + at(0, width - 1, y, c), 1e-5);
        }
        for (size_t x = 0; x < width; ++x) {
          ASSERT_NEAR(at(layer, x, 0, c) + at(layer, x, height - 1, c),
                      at(0, x, 0, c) + at(0, x, height - 1, c), 1e-5);
        }
      }
    }
  }
}

// The common border is that of all patterns by their shares, and of what is opaque in them.
TEST(MatchEdgesTest, SharesAndOpacityWeighTheMean) {
  const auto make = [] {
    ir::Texture texture;
    texture.is_array = true;
    ir::Texture::Level& level = texture.levels.emplace_back();
    level.width = level.height = 2;
    level.depth = 2;
    level.texels.assign(4, {1, 0, 0, 1});
    level.texels.resize(8, {0, 0, 1, 0.5f});
    return texture;
  };
  const double weights[] = {1, 3};
  ir::Texture texture = make();
  MatchEdges(texture, LayerShares(weights, 2), true);
  const double red = 0.25 / (0.25 + 0.375);
  for (const ir::Texel& texel : texture.levels[0].texels) {
    EXPECT_NEAR(texel[0], red, 1e-5);
    EXPECT_NEAR(texel[2], 1 - red, 1e-5);
    EXPECT_NEAR(texel[3], 0.625, 1e-6);
  }
  texture = make();
  MatchEdges(texture, LayerShares(weights, 2), false);
  EXPECT_NEAR(texture.levels[0].texels[0][0], 0.25, 1e-6);
}

constexpr uint32_t kGroups[] = {0, 1, 1, 0, 4, 0};  // layer 4 is in none
const double kGroupWeights[] = {1, 2, 1, 3, 9, 2};

// A group is what it would be as an array of its own, whatever the others are.
TEST(MatchEdgesTest, GroupsAreMatchedEachForItself) {
  for (PatternKind kind : {PatternKind::kMatching, PatternKind::kSmooth, PatternKind::kWhite}) {
    const ir::Texture given = PatternMaker(kind, 32, 6, 5).Make();
    ir::Texture matched = given;
    MatchEdges(matched, LayerShares(kGroupWeights, 6), true, kGroups);
    for (const std::vector<uint32_t>& group :
         {std::vector<uint32_t>{0, 3, 5}, std::vector<uint32_t>{1, 2}}) {
      ir::Texture alone = given;
      std::vector<double> weights;
      for (uint32_t layer : group) weights.push_back(kGroupWeights[layer]);
      for (size_t l = 0; l < given.levels.size(); ++l) {
        const size_t plane = size_t{given.levels[l].width} * given.levels[l].height;
        alone.levels[l].depth = static_cast<uint32_t>(group.size());
        alone.levels[l].texels.clear();
        for (uint32_t layer : group) {
          const auto first = given.levels[l].texels.begin() + static_cast<long>(layer * plane);
          alone.levels[l].texels.insert(alone.levels[l].texels.end(), first,
                                        first + static_cast<long>(plane));
        }
      }
      MatchEdges(alone, LayerShares(weights, group.size()), true);
      for (size_t l = 0; l < given.levels.size(); ++l) {
        const size_t plane = size_t{given.levels[l].width} * given.levels[l].height;
        for (size_t i = 0; i < group.size() * plane; ++i) {
          ASSERT_EQ(matched.levels[l].texels[group[i / plane] * plane + i % plane],
                    alone.levels[l].texels[i]);
        }
      }
    }
    for (size_t l = 0; l < given.levels.size(); ++l) {
      const size_t plane = size_t{given.levels[l].width} * given.levels[l].height;
      for (size_t i = 4 * plane; i < 5 * plane; ++i)
        ASSERT_EQ(matched.levels[l].texels[i], given.levels[l].texels[i]);
    }
  }
}

// The borders of a group have its own mean and nothing of the others, through MakeTexture as well.
TEST(MatchEdgesTest, NoColorLeaksIntoAnotherGroup) {
  const std::array<uint8_t, 3> colors[] = {{200, 0, 0}, {0, 0, 90}, {0, 0, 30},
                                           {100, 0, 0}, {0, 77, 0}, {40, 0, 0}};
  std::vector<Image> layers;
  for (const auto& color : colors) {
    Image& image = layers.emplace_back();
    image.width = image.height = 8;
    image.channels = 3;
    image.bits = 8;
    for (int i = 0; i < 64; ++i)
      image.pixels.insert(image.pixels.end(), color.begin(), color.end());
  }
  TextureOptions options;
  options.is_array = options.match_edges = true;
  options.srgb = options.mipmaps = false;
  options.edge_groups.assign(std::begin(kGroups), std::end(kGroups));
  Diagnostics diagnostics;
  const ir::Texture matched = ToTexture(*MakeTexture(layers, options, "t", {}, diagnostics));
  const float red = (200 + 100 + 40) / 3.0f / 255, blue = 60 / 255.0f, green = 77 / 255.0f;
  for (size_t layer = 0; layer < 6; ++layer) {
    const ir::Texel& corner = matched.levels[0].texels[layer * 64];
    EXPECT_NEAR(corner[0], kGroups[layer] == 0 ? red : 0, 0.5001 / 255) << layer;
    EXPECT_NEAR(corner[2], kGroups[layer] == 1 ? blue : 0, 0.5001 / 255) << layer;
    EXPECT_NEAR(corner[1], kGroups[layer] == 4 ? green : 0, 1e-6) << layer;
  }
}

// Level 0 of a group that fits there is left as it is, though the other group does not.
TEST(MatchEdgesTest, WhatFitsInAGroupIsLeftAsItIs) {
  const ir::Texture fits = PatternMaker(PatternKind::kMatching, 32, 2, 3).Make();
  ir::Texture both = PatternMaker(PatternKind::kWhite, 32, 4, 3).Make();
  std::ranges::copy(fits.levels[0].texels, both.levels[0].texels.begin() + 1024);
  const ir::Texture given = both;
  MatchEdges(both, LayerShares({}, 4), true, std::array<uint32_t, 4>{0, 1, 1, 0});
  const auto layer = [](const ir::Texture& texture, size_t index) {
    return std::span(texture.levels[0].texels).subspan(1024 * index, 1024);
  };
  EXPECT_TRUE(std::ranges::equal(layer(both, 1), layer(given, 1)));
  EXPECT_TRUE(std::ranges::equal(layer(both, 2), layer(given, 2)));
  EXPECT_FALSE(std::ranges::equal(layer(both, 0), layer(given, 0)));
}

// As pictures go: through MakeTexture, with the rounding of the format.
TEST(MatchEdgesTest, PicturesMatchWithinAStep) {
  std::vector<Image> layers;
  for (uint32_t i = 0; i < 4; ++i) layers.push_back(test::RandomImage(16, 16, 3, 8, i));
  TextureOptions options;
  options.is_array = true;
  options.srgb = false;
  Diagnostics diagnostics;
  const ir::Texture plain = ToTexture(*MakeTexture(layers, options, "t", {}, diagnostics));
  options.match_edges = true;
  const ir::Texture matched = ToTexture(*MakeTexture(layers, options, "t", {}, diagnostics));
  for (size_t level = 0; level < 2; ++level) {
    const auto side = static_cast<size_t>(16 >> level);
    double plain_jump = 0, matched_jump = 0;
    const auto jump = [&](const ir::Texture& texture, size_t y, size_t layer) {
      const auto pair = [&](size_t k) {
        const auto& texels = texture.levels[level].texels;
        return texels[(k * side + y) * side][0] + texels[(k * side + y) * side + side - 1][0];
      };
      return double{std::abs(pair(layer) - pair(0))} / 2;
    };
    for (size_t y = 0; y < side; ++y) {
      for (size_t layer = 1; layer < 4; ++layer) {
        plain_jump = std::max(plain_jump, jump(plain, y, layer));
        matched_jump = std::max(matched_jump, jump(matched, y, layer));
      }
    }
    EXPECT_LE(matched_jump, 1.001 / 255) << level;  // half a step for each of two texels
    EXPECT_GT(plain_jump, 2.0 / 255) << level;
  }
}

// The measure, by its definition: all pairs of layers, and the worse of the two axes.
TEST(MeasureBordersTest, IsTheMeanOfAllPairs) {
  const ir::Texture texture = PatternMaker(PatternKind::kSmooth, 8, 5, 3).Make();
  const ir::Texture::Level& level = texture.levels[0];
  const auto at = [&](size_t layer, bool vertical, size_t line, size_t i, size_t c) {
    const size_t x = vertical ? line : i, y = vertical ? i : line;
    return double{level.texels[(layer * 8 + y) * 8 + x][c]};
  };
  BorderRatios expected;
  for (bool v : {false, true}) {
    double values = 0, halves = 0, seconds = 0, jumps = 0, value_count = 0, second_count = 0,
           jump_count = 0;
    double inside_values = 0, inside_slopes = 0, inside_value_count = 0, inside_slope_count = 0;
    for (size_t line = 0; line < 8; ++line) {
      for (size_t c = 0; c < 4; ++c) {
        for (size_t a = 0; a < 5; ++a) {
          for (size_t i = 0; i < 7; ++i, ++inside_value_count)
            inside_values += std::abs(at(a, v, line, i + 1, c) - at(a, v, line, i, c));
          for (size_t i = 1; i < 7; ++i, ++inside_slope_count) {
            inside_slopes += std::abs(at(a, v, line, i - 1, c) - 2 * at(a, v, line, i, c) +
                                      at(a, v, line, i + 1, c));
          }
          for (size_t b = 0; b < 5; ++b) {
            if (a == b) continue;
            const double last = at(a, v, line, 7, c), first = at(b, v, line, 0, c);
            values += std::abs(first - last);
            // A quarter of a texel to both sides, with wrap repeat.
            halves += std::abs(0.75 * first + 0.25 * at(b, v, line, 7, c) - 0.75 * last -
                               0.25 * at(a, v, line, 0, c));
            ++value_count;
            seconds += std::abs(at(a, v, line, 6, c) - 2 * last + first);
            seconds += std::abs(last - 2 * first + at(b, v, line, 1, c));
            second_count += 2;
            jumps += std::abs((first - at(b, v, line, 7, c)) - (at(a, v, line, 0, c) - last));
            ++jump_count;
          }
        }
      }
    }
    expected.values = std::max(expected.values, std::max(values, 2 * halves) / value_count /
                                                    (inside_values / inside_value_count));
    const double slopes = std::max(seconds / second_count, jumps / jump_count);
    expected.slopes = std::max(expected.slopes, slopes / (inside_slopes / inside_slope_count));
  }
  const BorderRatios ratios = MeasureBorders(level);
  EXPECT_NEAR(ratios.values, expected.values, 1e-9);
  EXPECT_NEAR(ratios.slopes, expected.slopes, 1e-9);
}

}  // namespace
}  // namespace texgraph::textures
