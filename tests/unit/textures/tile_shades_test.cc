// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_shades.h"

#include <gtest/gtest.h>

#include "tests/unit/textures/tile_testing.h"

namespace texgraph::textures {
namespace {

using test::SmallTiles;

// Squares of 8 texels, dark and light in turn, of 8 x 8 squares.
TileSample Chequered() {
  std::vector<uint32_t> samples;
  for (uint32_t i = 0; i < 64 * 64; ++i) samples.push_back((i % 64 / 8 + i / 512) % 2 * 200);
  const Image image = test::MakeImage(64, 64, 1, 8, samples);
  const std::vector<double> weights{1};
  return TileSample({&image, 1}, weights, true, 2);
}

TEST(PatchShadesTest, OppositeShadesCancel) {
  const TileSample sample = Chequered();
  for (uint32_t scale : {0u, 1u}) {
    PatchShades shades(sample, scale, 32);
    for (int64_t x : {16, 24, 32, 28}) shades.Add({x, 16}, false);
    const double square = shades.Product(0, 0);
    EXPECT_GT(square, 0);
    // Moved by a square, it is the other colour everywhere; by two, the same; by half a one, each
    // part is half of both.
    EXPECT_NEAR(shades.Product(0, 1), -square, 1e-3 * square);
    EXPECT_NEAR(shades.Product(0, 2), square, 1e-3 * square);
    EXPECT_NEAR(shades.Product(0, 3), 0, 1e-3 * square);
  }
}

// Of an edge only what is within half a tile of its middle, along it and across together, counts.
TEST(PatchShadesTest, EdgesHaveCornersOfTheirTilesLess) {
  std::vector<uint32_t> samples(64 * 64, 100);
  for (uint32_t y = 16; y < 20; ++y) {
    for (uint32_t x = 16; x < 20; ++x) samples[y * 64 + x] = 255;
  }
  const Image image = test::MakeImage(64, 64, 1, 8, samples);
  const std::vector<double> weights{1};
  const TileSample sample({&image, 1}, weights, true, 1);
  PatchShades shades(sample, 0, 32);
  // Rows count upwards: the spot's middle is at (18, 46).
  const int64_t x = 18;
  const int64_t y = 46;
  shades.Add({x + 14, y + 14}, false);  // the spot is in a corner of the square
  shades.Add({x + 14, y + 14}, true);
  shades.Add({x, y}, true);
  EXPECT_GT(shades.Product(0, 0), 10 * shades.Product(1, 1));
  EXPECT_GT(shades.Product(2, 2), 10 * shades.Product(1, 1));
}

// How much the mean of all tiles varies from part to part, of 4 x 4.
double GridOf(const TileSet& set) {
  const uint32_t size = set.layout.tile_size;
  std::vector<double> parts(16);
  for (const TileColors& colors : test::AllTiles(set.layout)) {
    const TilePlace place = PackedTile(set.layout, colors);
    for (uint32_t i = 0; i < size * size; ++i) {
      parts[i / size * 4 / size * 4 + i % size * 4 / size] +=
          test::TileTexel(set.packs[0], set.layout, place, i % size, i / size, 0);
    }
  }
  double mean = 0;
  for (double part : parts) mean += part / 16;
  double square = 0;
  for (double part : parts) square += (part / mean - 1) * (part / mean - 1) / 16;
  return std::sqrt(square);
}

TEST(PatchShadesTest, EvenSetsHaveWeakerGrids) {
  const Image sample = test::StrokesImage(64, 64, 1, 8, 21);
  for (const TileKind kind : {TileKind::kCorner, TileKind::kWang}) {
    double grids[2] = {};
    for (uint32_t seed = 0; seed < 2; ++seed) {
      for (const bool even : {false, true}) {
        TileSetOptions options = SmallTiles(kind, {2, 2}, 16);
        options.wraps = true;
        options.seed = seed;
        options.even = even;
        options.candidates = 32;
        Diagnostics diagnostics;
        const auto set = MakeTileSet({&sample, 1}, {}, options, "grass", {}, diagnostics);
        ASSERT_TRUE(set);
        grids[even ? 1 : 0] += GridOf(*set);
      }
    }
    EXPECT_LT(grids[1], 0.8 * grids[0]) << static_cast<int>(kind);
  }
}

}  // namespace
}  // namespace texgraph::textures
