// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_evening.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/textures/tile_testing.h"

namespace texgraph::textures {
namespace {

constexpr uint32_t kSize = 64;

// A wave over the tile that repeats with it: `times` from side to side, and once upwards.
double Wave(uint32_t x, uint32_t y, uint32_t times) {
  const double turn = 2 * std::numbers::pi / kSize;
  return std::cos(turn * times * x) * std::cos(turn * y);
}

// Noise of each tile's own around the middle, and a wave that they have in common.
Image Shaded(const TilePackLayout& layout, uint8_t bits, double height, uint32_t times) {
  const double most = bits == 8 ? 255 : 65535;
  std::mt19937 random(7);
  std::vector<uint32_t> samples;
  for (uint32_t row = 0; row < layout.height(); ++row) {
    const uint32_t up = layout.height() - 1 - row;
    for (uint32_t x = 0; x < layout.width(); ++x) {
      const uint32_t y = (up + kSize - layout.gutter) % kSize;
      const double noise = static_cast<double>(random() % 1000) / 1000 - 0.5;
      const double value = 0.5 + 0.2 * noise + height * Wave(x % kSize, y, times);
      samples.push_back(static_cast<uint32_t>(std::lround(value * most)));
    }
  }
  return test::MakeImage(layout.width(), layout.height(), 1, bits, samples);
}

// How much of the wave all tiles together have.
double CommonWave(const Image& pack, const TilePackLayout& layout, uint32_t times) {
  double sum = 0;
  for (uint32_t y = 0; y < layout.rows * kSize; ++y) {
    for (uint32_t x = 0; x < layout.width(); ++x) {
      const double value = test::UpAt(pack, x, layout.gutter + y, 0);
      sum += value * Wave(x % kSize, y % kSize, times);
    }
  }
  const double texels = double{1} * layout.width() * layout.rows * kSize;
  return 4 * sum / texels / (pack.bits == 8 ? 255 : 65535);
}

double Mean(const Image& pack, const TilePackLayout& layout) {
  double sum = 0;
  for (uint32_t y = 0; y < layout.rows * kSize; ++y) {
    for (uint32_t x = 0; x < layout.width(); ++x) sum += test::UpAt(pack, x, layout.gutter + y, 0);
  }
  return sum / (double{1} * layout.width() * layout.rows * kSize);
}

// What is left of the wave: a Gaussian of a sixteenth of a tile, twice, of which 32 parts a side
// are kept, each a mean, with straight lines between them.
double Left(uint32_t times) {
  const auto blurred = [](double k) {
    return std::exp(-0.5 * std::pow(2 * std::numbers::pi * k / 16, 2));
  };
  const auto kept = [](double k) {
    const double half = std::numbers::pi * k / 32;
    return std::pow(std::sin(half) / half, 3);
  };
  const double blur = blurred(times) * blurred(1);
  return 1 - (1 - (1 - blur) * (1 - blur)) * kept(times) * kept(1);
}

TEST(TileEveningTest, WideShadesGoAndFineOnesStay) {
  EXPECT_LT(Left(1), 0.03);
  EXPECT_GT(Left(12), 0.99);
  for (const auto& [kind, bits] : {std::pair(TileKind::kCorner, 8), {TileKind::kWang, 16}}) {
    const TilePackLayout layout = LayOutTiles(kind, {2, 2}, kSize);
    for (const uint32_t times : {1u, 2u, 12u}) {
      Image pack = Shaded(layout, static_cast<uint8_t>(bits), 0.1, times);
      ASSERT_NEAR(CommonWave(pack, layout, times), 0.1, 0.002);
      const double mean = Mean(pack, layout);
      EvenTiles(layout, {&pack, 1});
      EXPECT_NEAR(CommonWave(pack, layout, times), 0.1 * Left(times), 0.002);
      EXPECT_NEAR(Mean(pack, layout), mean, bits == 8 ? 0.05 : 13);
    }
  }
}

// What tiles differ in stays as it is, to the last bit: the shade is the same in all.
TEST(TileEveningTest, TilesDifferAsBefore) {
  const TilePackLayout layout = LayOutTiles(TileKind::kCorner, {4, 4}, kSize);
  const Image before = Shaded(layout, 8, 0.1, 1);
  Image after = before;
  EvenTiles(layout, {&after, 1});
  for (uint32_t place = 0; place < kSize * kSize; place += 5) {
    const uint32_t x = place % kSize, y = place / kSize;
    const auto changed = [&](uint32_t tile) {
      const TilePlace at{tile % layout.columns, tile / layout.columns};
      return static_cast<int>(test::TileTexel(after, layout, at, x, y, 0)) -
             static_cast<int>(test::TileTexel(before, layout, at, x, y, 0));
    };
    for (uint32_t tile = 1; tile < layout.tiles(); tile += 7) ASSERT_EQ(changed(tile), changed(0));
  }
  // Gutters are filled later.
  for (uint32_t x = 0; x < layout.width(); ++x)
    ASSERT_EQ(test::UpAt(after, x, 0, 0), test::UpAt(before, x, 0, 0));
}

}  // namespace
}  // namespace texgraph::textures
