// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "compiler/textures/tile_pictures.h"
#include "tests/unit/textures/tile_testing.h"

namespace texgraph::textures {
namespace {

using test::AllTiles;
using test::SmallTiles;
using test::StrokesImage;
using test::TileTexel;
using test::UpAt;

std::optional<TileSet> Make(std::span<const Image> maps, const TileSetOptions& options,
                            std::span<const double> weights = {}) {
  Diagnostics diagnostics;
  auto set = MakeTileSet(maps, weights, options, "grass", {}, diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
  return set;
}

// A texel of a tile, or beside it, as the patch of a colour goes on there. `corner`: 0 to 3 as in
// TileColors, or which edge.
uint32_t PatchTexel(const TileSet& set, const Image& sample, uint32_t label, uint32_t color,
                    int64_t x, int64_t y, uint32_t channel) {
  const int64_t size = set.layout.tile_size;
  std::array<int64_t, 2> patch;
  if (set.layout.kind == TileKind::kCorner) {
    patch = set.patches[color];
    if (label % 2 == 0) patch[0] += size;
    if (label / 2 == 0) patch[1] += size;
  } else {
    const bool stands = label % 2 == 1;
    patch = set.patches[color + (stands ? set.layout.colors[0] : 0)];
    if (label == 0) patch[1] += size;
    if (label == 3) patch[0] += size;
  }
  return UpAt(sample, patch[0] + x, patch[1] + y, channel);
}

bool IsPatch(const TileSet& set, const Image& sample, const TileColors& tile, uint32_t label,
             int64_t x, int64_t y) {
  for (uint32_t c = 0; c < sample.channels; ++c) {
    if (TileTexel(set.packs[0], set.layout, PackedTile(set.layout, tile), x, y, c) !=
        PatchTexel(set, sample, label, tile[label], x, y, c)) {
      return false;
    }
  }
  return true;
}

// How many texels of a border, from its first corner on, are of that corner's patch, if all others
// are of the second one's: nothing if they are not.
std::optional<uint32_t> CrossingOf(const TileSet& set, const Image& sample, const TileColors& tile,
                                   uint32_t from, uint32_t to) {
  const uint32_t size = set.layout.tile_size;
  const bool stands = to - from == 2;
  const bool far = stands ? from == 1 : from == 2;
  uint32_t first = 0;
  uint32_t second = size;
  const auto is = [&](uint32_t label, uint32_t at) {
    const int64_t across = far ? size - 1 : 0;
    return stands ? IsPatch(set, sample, tile, label, across, at)
                  : IsPatch(set, sample, tile, label, at, across);
  };
  while (first < size && is(from, first)) ++first;
  while (second > 0 && is(to, second - 1)) --second;
  // Patches may agree by chance; then any of them is right.
  if (first < second) return std::nullopt;
  return first;
}

// O20: along every border the texels of both tiles are those of the same patch, going on.
TEST(TileSetTest, CornerTilesContinueOneAnother) {
  for (const auto& [colors, size] : {std::pair{2u, 16u}, {3u, 13u}, {4u, 8u}}) {
    const Image sample = StrokesImage(67, 59, 3, 16, colors);
    const auto set = Make({&sample, 1}, SmallTiles(TileKind::kCorner, {colors, colors}, size));
    ASSERT_TRUE(set);
    // The same for the same colours, of tiles on both sides.
    std::map<std::array<uint32_t, 3>, std::set<uint32_t>> crossings;
    for (const TileColors& tile : AllTiles(set->layout)) {
      for (const auto& [from, to] : {std::pair{0u, 1u}, {2u, 3u}, {0u, 2u}, {1u, 3u}}) {
        const auto crossing = CrossingOf(*set, sample, tile, from, to);
        ASSERT_TRUE(crossing);
        EXPECT_GE(*crossing, size / 4);
        EXPECT_LE(*crossing, size - size / 4);
        crossings[{to - from, tile[from], tile[to]}].insert(*crossing);
      }
    }
    EXPECT_EQ(crossings.size(), 2 * colors * colors);
    for (const auto& [key, values] : crossings) EXPECT_EQ(values.size(), 1u);
  }
}

TEST(TileSetTest, WangTilesContinueOneAnother) {
  for (const auto& [colors, size] :
       {std::pair{std::array{2u, 2u}, 16u}, {std::array{3u, 1u}, 13u}, {std::array{1u, 4u}, 9u}}) {
    const Image sample = StrokesImage(67, 59, 3, 16, size);
    const auto set = Make({&sample, 1}, SmallTiles(TileKind::kWang, colors, size));
    ASSERT_TRUE(set);
    for (const TileColors& tile : AllTiles(set->layout)) {
      for (uint32_t i = 0; i < size; ++i) {
        EXPECT_TRUE(IsPatch(*set, sample, tile, 0, i, 0));
        EXPECT_TRUE(IsPatch(*set, sample, tile, 2, i, size - 1));
        if (i == 0 || i + 1 == size) continue;
        EXPECT_TRUE(IsPatch(*set, sample, tile, 1, size - 1, i));
        EXPECT_TRUE(IsPatch(*set, sample, tile, 3, 0, i));
      }
    }
  }
}

// Wei's pack of corners shows what is around a corner by the two edges that meet there: it is the
// same in all tiles that have them, an eighth of a tile far.
TEST(TileSetTest, WangTilesAgreeAtCorners) {
  constexpr uint32_t kSize = 24;
  const Image sample = StrokesImage(67, 59, 1, 16, 3);
  const auto set = Make({&sample, 1}, SmallTiles(TileKind::kWang, {2, 3}, kSize));
  ASSERT_TRUE(set);
  std::map<std::array<uint32_t, 3>, std::set<std::vector<uint32_t>>> seen;
  for (const TileColors& tile : AllTiles(set->layout)) {
    for (uint32_t corner = 0; corner < 4; ++corner) {
      const uint32_t right = corner % 2;
      const uint32_t top = corner / 2;
      std::vector<uint32_t> texels;
      for (uint32_t i = 0; i < 9; ++i) {
        const uint32_t x = right == 1 ? kSize - 1 - i % 3 : i % 3;
        const uint32_t y = top == 1 ? kSize - 1 - i / 3 : i / 3;
        texels.push_back(
            TileTexel(set->packs[0], set->layout, PackedTile(set->layout, tile), x, y, 0));
      }
      seen[{corner, tile[2 * top], tile[right == 1 ? 1 : 3]}].insert(texels);
    }
  }
  EXPECT_EQ(seen.size(), 24u);
  for (const auto& [key, texels] : seen) EXPECT_EQ(texels.size(), 1u);
}

// Every texel of every map is one of the sample's, from the same place in all maps.
TEST(TileSetTest, MapsAreCutAlike) {
  const uint32_t side = 48;
  std::vector<uint32_t> places(size_t{side} * side);
  for (uint32_t i = 0; i < places.size(); ++i) places[i] = i;
  std::vector<uint32_t> colors;
  for (uint32_t i : places) colors.insert(colors.end(), {i % 256, i / 256, i * 7 % 251, i % 13});
  const std::vector<Image> maps = {test::MakeImage(side, side, 1, 16, places),
                                   test::MakeImage(side, side, 4, 8, colors)};
  for (TileKind kind : {TileKind::kCorner, TileKind::kWang}) {
    const auto set = Make(maps, SmallTiles(kind, {2, 2}, 20));
    ASSERT_TRUE(set);
    ASSERT_EQ(set->packs.size(), 2u);
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(set->packs[i].channels, maps[i].channels);
      EXPECT_EQ(set->packs[i].bits, maps[i].bits);
      EXPECT_EQ(set->packs[i].width, 80u);
      EXPECT_EQ(set->packs[i].height, 80u);
    }
    for (uint32_t y = 0; y < 80; ++y) {
      for (uint32_t x = 0; x < 80; ++x) {
        const uint32_t place = set->packs[0].At(x, y, 0);
        ASSERT_LT(place, places.size());
        for (uint32_t c = 0; c < 4; ++c) {
          ASSERT_EQ(set->packs[1].At(x, y, c), maps[1].At(place % side, place / side, c));
        }
      }
    }
  }
}

TEST(TileSetTest, MapsOfNoWeightDoNotCount) {
  const std::vector<Image> maps = {StrokesImage(64, 64, 3, 8, 1), StrokesImage(64, 64, 3, 8, 2)};
  const TileSetOptions options = SmallTiles(TileKind::kCorner, {2, 2}, 24);
  const auto alone = Make({maps.data(), 1}, options);
  const auto first = Make(maps, options, std::vector<double>{1, 0});
  const auto second = Make(maps, options, std::vector<double>{0, 1});
  const auto negative = Make(maps, options, std::vector<double>{2, -3});
  ASSERT_TRUE(alone && first && second && negative);
  EXPECT_EQ(negative->packs[0].pixels, alone->packs[0].pixels);
  EXPECT_EQ(first->packs[0].pixels, alone->packs[0].pixels);
  EXPECT_NE(second->packs[0].pixels, alone->packs[0].pixels);
}

TEST(TileSetTest, ThreadsAndRunsGiveTheSameTiles) {
  const Image sample = StrokesImage(60, 52, 3, 8, 3);
  for (TileKind kind : {TileKind::kCorner, TileKind::kWang}) {
    TileSetOptions options = SmallTiles(kind, {2, 2}, 20);
    const auto one = Make({&sample, 1}, options);
    options.threads = 4;
    const auto four = Make({&sample, 1}, options);
    options.seed = 6;
    const auto other = Make({&sample, 1}, options);
    ASSERT_TRUE(one && four && other);
    EXPECT_EQ(one->packs[0].pixels, four->packs[0].pixels);
    EXPECT_EQ(one->patches, four->patches);
    EXPECT_EQ(one->quality.mean, four->quality.mean);
    EXPECT_EQ(one->quality.tiles, four->quality.tiles);
    EXPECT_NE(one->packs[0].pixels, other->packs[0].pixels);
  }
}

TEST(TileSetTest, GuttersHaveWhatWouldLieThere) {
  const Image sample = StrokesImage(40, 40, 1, 8, 4);
  const auto set = Make({&sample, 1}, SmallTiles(TileKind::kCorner, {4, 4}, 9));
  ASSERT_TRUE(set);
  const TilePackLayout& layout = set->layout;
  ASSERT_EQ(layout.gutter, 5u);
  ASSERT_EQ(set->packs[0].height, 16u * 9 + 10);
  for (uint32_t x = 0; x < layout.columns; ++x) {
    const TileColors top = TileAt(layout, x, layout.rows - 1);
    const TileColors bottom = TileAt(layout, x, 0);
    // Any tile with these two corners would do; which one is known from its neighbour, too.
    const TileColors above = TileAt(layout, x, layout.rows);
    const TileColors below = TileAt(layout, x, -1);
    ASSERT_EQ(above[0], top[2]);
    ASSERT_EQ(above[1], top[3]);
    ASSERT_EQ(below[2], bottom[0]);
    ASSERT_EQ(below[3], bottom[1]);
    for (int64_t y = 0; y < 5; ++y) {
      for (int64_t i = 0; i < 9; ++i) {
        const TilePlace highest{x, layout.rows - 1};
        const TilePlace lowest{x, 0};
        ASSERT_EQ(TileTexel(set->packs[0], layout, highest, i, 9 + y, 0),
                  TileTexel(set->packs[0], layout, PackedTile(layout, above), i, y, 0));
        ASSERT_EQ(TileTexel(set->packs[0], layout, lowest, i, -1 - y, 0),
                  TileTexel(set->packs[0], layout, PackedTile(layout, below), i, 8 - y, 0));
      }
    }
  }
}

// Without patches of their own, tiles have texels of their colours' patches alone; with them, also
// others in their middles, but not near their borders.
TEST(TileSetTest, TilesMayHaveMiddlesOfTheirOwn) {
  const Image sample = test::RandomImage(70, 70, 3, 16, 4);
  for (TileKind kind : {TileKind::kCorner, TileKind::kWang}) {
    TileSetOptions options = SmallTiles(kind, {2, 2}, 16);
    for (bool own : {false, true}) {
      options.own_middles = own;
      const auto set = Make({&sample, 1}, options);
      ASSERT_TRUE(set);
      for (const TileColors& tile : AllTiles(set->layout)) {
        uint32_t others = 0;
        for (int64_t i = 0; i < 256; ++i) {
          bool known = false;
          for (uint32_t label = 0; label < 4 && !known; ++label)
            known = IsPatch(*set, sample, tile, label, i % 16, i / 16);
          others += known ? 0 : 1;
          const int64_t inner = std::min({i % 16, i / 16, 15 - i % 16, 15 - i / 16});
          EXPECT_TRUE(known || inner >= 2);
        }
        EXPECT_EQ(others >= 16, own);
        EXPECT_TRUE(own || others == 0);
      }
    }
  }
}

// A sample that is periodic in half a tile fits itself wherever it is laid on multiples of that.
TEST(TileSetTest, PeriodicSamplesGetSeamsThatCannotBeSeen) {
  const Image cell = StrokesImage(8, 8, 3, 8, 7);
  std::vector<uint32_t> samples;
  for (uint32_t y = 0; y < 40; ++y) {
    for (uint32_t x = 0; x < 40; ++x) {
      for (uint32_t c = 0; c < 3; ++c) samples.push_back(cell.At(x % 8, y % 8, c));
    }
  }
  const Image sample = test::MakeImage(40, 40, 3, 8, samples);
  TileSetOptions options = SmallTiles(TileKind::kCorner, {2, 2}, 16);
  options.wraps = true;
  options.candidates = 200;
  const auto set = Make({&sample, 1}, options);
  ASSERT_TRUE(set);
  for (int axis : {0, 1}) {
    EXPECT_EQ(
        (set->patches[0][static_cast<size_t>(axis)] - set->patches[1][static_cast<size_t>(axis)]) %
            8,
        0);
  }
  EXPECT_LT(set->quality.mean, 1.2);
}

// The ratio of a seam is measured against the sample's own steps: on a sample of one colour all
// are 0, on noise without neighbourhood 1.
TEST(TileSetTest, QualityIsMeasuredAgainstTheSample) {
  const Image noise = test::RandomImage(80, 80, 1, 8, 1);
  for (TileKind kind : {TileKind::kCorner, TileKind::kWang}) {
    const auto set = Make({&noise, 1}, SmallTiles(kind, {2, 2}, 24));
    ASSERT_TRUE(set);
    EXPECT_EQ(set->quality.tiles.size(), 16u);
    EXPECT_EQ(set->quality.edges.size(), kind == TileKind::kCorner ? 8u : 4u);
    EXPECT_GT(set->quality.mean, 0.3);
    EXPECT_LT(set->quality.mean, 1.1);
    const Image plain = test::MakeImage(80, 80, 1, 8, std::vector<uint32_t>(6400, 90));
    const auto flat = Make({&plain, 1}, SmallTiles(kind, {2, 2}, 24));
    ASSERT_TRUE(flat);
    EXPECT_EQ(flat->quality.mean, 0);
  }
}

TEST(TileSetTest, ProgressGoesFromPartsToAll) {
  const Image sample = StrokesImage(48, 48, 1, 8, 1);
  std::vector<double> shares;
  Diagnostics diagnostics;
  ASSERT_TRUE(MakeTileSet({&sample, 1}, {}, SmallTiles(TileKind::kWang, {1, 2}, 16), "grass", {},
                          diagnostics, [&](double share) { shares.push_back(share); }));
  ASSERT_GT(shares.size(), 4u);
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_GT(shares.front(), 0);
  EXPECT_EQ(shares.back(), 1);
}

std::string ErrorOf(std::span<const Image> maps, const TileSetOptions& options,
                    DiagnosticKind kind) {
  Diagnostics diagnostics;
  EXPECT_FALSE(MakeTileSet(maps, {}, options, "grass", {}, diagnostics));
  if (diagnostics.all().size() != 1) return "";
  EXPECT_EQ(diagnostics.all()[0].kind, kind);
  return diagnostics.all()[0].message;
}

TEST(TileSetTest, SaysWhatWouldDo) {
  const Image sample = StrokesImage(100, 70, 3, 8, 1);
  const std::span<const Image> maps{&sample, 1};
  EXPECT_EQ(ErrorOf(maps, SmallTiles(TileKind::kCorner, {2, 2}, 36), DiagnosticKind::kBadImage),
            "the sample of 'grass' has 100 x 70 pixels; tiles of 36 texels take at least 72 x 72; "
            "tiles of 35 texels would do");
  TileSetOptions periodic = SmallTiles(TileKind::kCorner, {2, 2}, 48);
  periodic.wraps = true;
  EXPECT_EQ(ErrorOf(maps, periodic, DiagnosticKind::kBadImage),
            "the sample of 'grass' has 100 x 70 pixels; tiles of 48 texels take at least 72 x 72; "
            "tiles of 46 texels would do");
  EXPECT_EQ(ErrorOf(maps, SmallTiles(TileKind::kCorner, {5, 5}, 16), DiagnosticKind::kSizeLimit),
            "the tiles of 'grass' have 5 corner colours; 2 to 4 are possible");
  EXPECT_EQ(ErrorOf(maps, SmallTiles(TileKind::kWang, {2, 0}, 16), DiagnosticKind::kSizeLimit),
            "the tiles of 'grass' have 2 and 0 edge colours; 1 to 4 of each are possible");
  EXPECT_EQ(ErrorOf(maps, SmallTiles(TileKind::kWang, {2, 4}, 3), DiagnosticKind::kSizeLimit),
            "the tiles of 'grass' have 3 texels a side; 4 to 1024 are possible where a pack has 64 "
            "tiles");
  // 7952 x 8450 texels are more than 2^26.
  EXPECT_EQ(ErrorOf(maps, SmallTiles(TileKind::kCorner, {4, 4}, 497), DiagnosticKind::kSizeLimit),
            "the tiles of 'grass' have 497 texels a side; 4 to 496 are possible where a pack has "
            "256 tiles");
  const std::vector<Image> three(3, sample);
  EXPECT_EQ(ErrorOf(three, SmallTiles(TileKind::kCorner, {2, 2}, 1183), DiagnosticKind::kSizeLimit),
            "the tiles of 'grass' have 1183 texels a side; 4 to 1182 are possible where a pack has "
            "16 tiles and there are 3 packs");
  TileSetOptions few = SmallTiles(TileKind::kWang, {2, 2}, 16);
  few.candidates = 7;
  EXPECT_EQ(ErrorOf(maps, few, DiagnosticKind::kSizeLimit),
            "the tiles of 'grass' try 7 patches; 8 to 1024 are possible");
  EXPECT_EQ(ErrorOf({}, few, DiagnosticKind::kBadImage), "the tiles of 'grass' have no sample");
  const std::vector<Image> differ = {StrokesImage(40, 40, 1, 8, 1), StrokesImage(40, 41, 1, 8, 1)};
  EXPECT_EQ(ErrorOf(differ, SmallTiles(TileKind::kWang, {2, 2}, 16), DiagnosticKind::kBadImage),
            "the maps of the sample of 'grass' differ in size: 40 x 40 and 40 x 41; maps of one "
            "material are equally large");
}

TEST(TileSetTest, TheLeastSampleIsEnough) {
  for (bool wraps : {false, true}) {
    for (uint32_t size : {4u, 5u, 7u, 10u, 19u}) {
      const uint32_t side = LeastSample(size, wraps);
      EXPECT_GE(LargestTileOfSample(side, side + 9, wraps), size);
      EXPECT_LT(LargestTileOfSample(side - 1, side + 9, wraps), size);
      const Image sample = StrokesImage(side, side, 1, 8, size);
      TileSetOptions options = SmallTiles(TileKind::kCorner, {2, 2}, size);
      options.wraps = wraps;
      EXPECT_TRUE(Make({&sample, 1}, options));
      options.kind = TileKind::kWang;
      EXPECT_TRUE(Make({&sample, 1}, options));
    }
  }
}

// Differences of neighbours across a line of texels, or second ones, all channels.
struct Steps {
  std::vector<double> values;
  double Mean() const {
    double sum = 0;
    for (double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }
};

// Kolmogorov and Smirnov: the largest distance of the two distributions.
double Distance(Steps a, Steps b) {
  std::ranges::sort(a.values);
  std::ranges::sort(b.values);
  double most = 0;
  for (double value : a.values) {
    const auto share = [&](const Steps& steps) {
      return static_cast<double>(std::ranges::upper_bound(steps.values, value) -
                                 steps.values.begin()) /
             static_cast<double>(steps.values.size());
    };
    most = std::max(most, std::abs(share(a) - share(b)));
  }
  return most;
}

// Noise of which only texels beside each other have anything in common; channels have nothing.
Image SoftNoise(uint32_t side, uint32_t seed) {
  const Image noise = test::RandomImage(side, side, 4, 8, seed);
  std::vector<uint32_t> samples;
  for (uint32_t y = 0; y < side; ++y) {
    for (uint32_t x = 0; x < side; ++x) {
      for (uint32_t c = 0; c < 4; ++c) {
        const uint32_t right = (x + 1) % side;
        const uint32_t below = (y + 1) % side;
        samples.push_back((noise.At(x, y, c) + noise.At(right, y, c) + noise.At(x, below, c) +
                           noise.At(right, below, c)) /
                          4);
      }
    }
  }
  return test::MakeImage(side, side, 4, 8, samples);
}

// Of a tiling with tiles of this size: order 1 are steps between neighbours, 2 are bends. Of every
// second row, so that they are independent. Those at corners are left out for Wang tiles: there
// edges end that have nothing to do with each other.
void AddSteps(const Image& tiling, const TilePackLayout& layout, bool upwards, int order,
              Steps& border, Steps& inside) {
  const uint32_t size = layout.tile_size;
  for (int64_t across = 2; across + 2 < tiling.width; ++across) {
    for (int64_t i = 0; i < int64_t{tiling.width} * 2; ++i) {
      const int64_t along = i / 4 * 2;
      if (layout.kind == TileKind::kWang && (along + 1) % size < 2) continue;
      const auto at = [&](int64_t place) {
        const auto channel = static_cast<uint32_t>(i % 4);
        return static_cast<double>(upwards ? UpAt(tiling, along, place, channel)
                                           : UpAt(tiling, place, along, channel));
      };
      const double step = at(across) - at(across - 1);
      const double bend = at(across + 1) - at(across) - step;
      const int64_t place = across % size;
      const bool over = place == 0 || (order == 2 && place + 1 == size);
      (over ? border : inside).values.push_back(std::abs(order == 1 ? step : bend));
    }
  }
}

// The mean step (order 1) or bend at each distance from the border, up to the middle of the tiles.
std::vector<double> MeansByDepth(const std::vector<Image>& tilings, uint32_t size, int order) {
  std::vector<double> sums(size / 2 + 1);
  std::vector<double> counts(sums.size());
  for (const Image& tiling : tilings) {
    const int64_t side = tiling.width;
    for (int64_t i = 0; i < 8 * side * side; ++i) {
      const int64_t across = i / 8 % side;
      const auto at = [&](int64_t place) {
        const auto channel = static_cast<uint32_t>(i % 4);
        const int64_t along = i / 8 / side;
        return static_cast<double>(i % 8 < 4 ? UpAt(tiling, along, place, channel)
                                             : UpAt(tiling, place, along, channel));
      };
      const double step = at(across) - at(across - 1);
      const double bend = at(across + 1) - at(across) - step;
      const int64_t place = across % size;
      const auto depth = static_cast<size_t>(std::min(place, size - place));
      sums[depth] += std::abs(order == 1 ? step : bend);
      counts[depth] += 1;
    }
  }
  for (size_t depth = 0; depth < sums.size(); ++depth) sums[depth] /= counts[depth];
  return sums;
}

// O22: steps and bends over borders of tiles are like those inside.
TEST(TileSetTest, BordersOfTilesAreNotSeen) {
  constexpr uint32_t kSets = 6;
  constexpr uint32_t kSize = 24;
  for (TileKind kind : {TileKind::kCorner, TileKind::kWang}) {
    const TilePackLayout layout = LayOutTiles(kind, {2, 2}, kSize);
    std::vector<Image> tilings;
    for (uint32_t seed = 0; seed < kSets; ++seed) {
      const Image sample = SoftNoise(3 * kSize, seed);
      TileSetOptions options = SmallTiles(kind, {2, 2}, kSize);
      options.candidates = 8;
      const auto set = Make({&sample, 1}, options);
      ASSERT_TRUE(set);
      tilings.push_back(MakeTiling(set->packs[0], set->layout, 4, 4, seed));
    }
    for (bool upwards : {false, true}) {
      for (int order : {1, 2}) {
        Steps border;
        Steps inside;
        for (const Image& tiling : tilings)
          AddSteps(tiling, layout, upwards, order, border, inside);
        EXPECT_LE(border.Mean(), 1.1 * inside.Mean());
        // Borders repeat: no more values are independent than the middles of two patches
        // have. 1.63: one time in a hundred.
        EXPECT_LT(Distance(border, inside), 1.63 / std::sqrt(kSets * kSize * 4));
      }
    }
    // Nor does any other row stand out, that in which a border's own texels end among them.
    if (kind == TileKind::kWang) continue;
    for (int order : {1, 2}) {
      const std::vector<double> means = MeansByDepth(tilings, kSize, order);
      const double mean =
          std::reduce(means.begin(), means.end()) / static_cast<double>(means.size());
      for (size_t depth = 0; depth < means.size(); ++depth)
        EXPECT_LE(means[depth], 1.1 * mean) << "order " << order << ", depth " << depth;
    }
  }
}

}  // namespace
}  // namespace texgraph::textures
