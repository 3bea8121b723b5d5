// SPDX-License-Identifier: Apache-2.0
// Tiles by the colours of their corners and edges: the blocks against the definition of a set (each
// combination of colours once, neighbours that agree), counts of tiles, and what must not repeat.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using reference::CellHash;

int Wrapped(int cell, int count) { return count == 0 ? cell : ((cell % count) + count) % count; }

// A pack with one texel a tile, which has its column, its row and 1.
ir::Texture PackOf(int columns, int rows) {
  ir::Texture pack;
  ir::Texture::Level& level = pack.levels.emplace_back();
  level.width = static_cast<uint32_t>(columns);
  level.height = static_cast<uint32_t>(rows);
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      level.texels.push_back({static_cast<float>(x), static_cast<float>(y), 1, 1});
    }
  }
  pack.sampler.filter = ir::Filter::kNearest;
  pack.sampler.mip_filter = ir::MipFilter::kNone;
  return pack;
}

// For each way in which four colours can stand at the corners of a tile, or on its edges (west,
// east, south, north), the texel of its tile in the pack.
using Texels = std::map<std::array<int, 4>, ir::Texel>;

// The same tiles in layers: of corners, digits are the colours of those that are even in both
// directions, odd across, odd up, odd in both; of edges, of those that stand, even and odd, and of
// those that lie, even and odd. The first digit is the last of the number.
ir::Texture LayersOf(const Texels& tiles, bool wang, std::array<int, 2> colors) {
  ir::Texture layers;
  layers.is_array = true;
  layers.sampler.filter = ir::Filter::kNearest;
  layers.sampler.mip_filter = ir::MipFilter::kNone;
  ir::Texture::Level& level = layers.levels.emplace_back();
  level.width = level.height = 2;
  level.depth = static_cast<uint32_t>(tiles.size());
  const auto [lying, standing] = colors;
  for (int layer = 0; layer < static_cast<int>(tiles.size()); ++layer) {
    for (int y = 0; y < 2; ++y) {
      for (int x = 0; x < 2; ++x) {
        std::array<int, 4> around{};
        if (wang) {
          const int stand[2] = {layer % standing, layer / standing % standing};
          const int rest = layer / (standing * standing);
          const int lie[2] = {rest % lying, rest / lying};
          around = {stand[x], stand[1 - x], lie[y], lie[1 - y]};
        } else {
          for (int corner = 0; corner < 4; ++corner) {
            const int kind = (x + corner) % 2 + 2 * ((y + corner / 2) % 2);
            around[static_cast<size_t>(corner)] =
                layer / static_cast<int>(std::pow(lying, kind)) % lying;
          }
        }
        level.texels.push_back(tiles.at(around));
      }
    }
  }
  return layers;
}

// The middles of count x count cells from (x, y), row by row.
std::vector<Vector> Middles(int x, int y, int columns, int rows) {
  std::vector<Vector> places;
  for (int v = y; v < y + rows; ++v) {
    for (int u = x; u < x + columns; ++u) places.push_back({u + 0.5, v + 0.5});
  }
  return places;
}

// ---- Where tiles stand in the pack.

// Equation 6, written out for up to four colours.
TEST(TileIndexTest, IsThePlaceInWeisTour) {
  const std::vector<std::string> tour = {"00", "01", "11", "10", "02", "21", "12", "22",
                                         "20", "03", "31", "13", "32", "23", "33", "30"};
  for (size_t i = 0; i < tour.size(); ++i) {
    auto outputs = RunBlock(
        "tile_index", {{"first", Ints({tour[i][0] - '0'})}, {"second", Ints({tour[i][1] - '0'})}});
    EXPECT_EQ(outputs["result"].Int(0), static_cast<int>(i)) << tour[i];
  }
}

// Every combination of corner colours stands somewhere, no two at the same place, and who touches
// in the pack has the same colours there: on a torus, but for four colours from row to row 15.
TEST(CornerTilePlaceTest, PacksEachTileOnceWithFittingNeighbours) {
  for (int colors = 2; colors <= 4; ++colors) {
    const int side = colors * colors;
    std::map<std::array<int, 2>, std::array<int, 4>> tiles;
    for (int c = 0; c < side * side; ++c) {
      const std::array<int, 4> corners = {c % colors, c / colors % colors, c / side % colors,
                                          c / side / colors};
      Values corner_values{ir::kIvec4, 1, {}};
      for (int corner : corners) corner_values.words.push_back(static_cast<uint32_t>(corner));
      auto outputs =
          RunBlock("corner_tile_place", {{"corners", corner_values}, {"colors", Ints({colors})}});
      const std::array<int, 2> place = {outputs["result"].Int(0, 0), outputs["result"].Int(0, 1)};
      ASSERT_GE(std::min(place[0], place[1]), 0);
      ASSERT_LT(std::max(place[0], place[1]), side);
      EXPECT_TRUE(tiles.emplace(place, corners).second) << c;
    }
    for (const auto& [place, corners] : tiles) {
      const auto& right = tiles[{(place[0] + 1) % side, place[1]}];
      EXPECT_EQ(corners[1], right[0]);
      EXPECT_EQ(corners[3], right[2]);
      if (colors == 4 && place[1] == side - 1) continue;
      const auto& above = tiles[{place[0], (place[1] + 1) % side}];
      EXPECT_EQ(corners[2], above[0]);
      EXPECT_EQ(corners[3], above[1]);
    }
  }
}

// ---- The tilings.

struct Tiling {
  std::vector<std::array<int, 2>> places;  // in the pack, of each cell
  std::vector<int> numbers;
};

Tiling Tile(const std::string& block, const ir::Texture& pack, int columns, Values colors,
            const std::vector<Vector>& at,
            std::vector<std::pair<int32_t, int32_t>> period = {{0, 0}}, int seed = 0) {
  auto outputs = RunBlock(block, {{"tiles", pack},
                                  {"uv", Vectors(at)},
                                  {"tiling", Vectors({{1, 1}})},
                                  {"colors", std::move(colors)},
                                  {"period", CellsOf(period)},
                                  {"seed", Ints({seed})}});
  Tiling tiling;
  for (size_t i = 0; i < at.size(); ++i) {
    tiling.places.push_back({static_cast<int>(outputs["color"].Float(i, 0)),
                             static_cast<int>(outputs["color"].Float(i, 1))});
    tiling.numbers.push_back(outputs["index"].Int(i));
    EXPECT_EQ(tiling.numbers.back(), tiling.places.back()[0] + tiling.places.back()[1] * columns);
  }
  return tiling;
}

// Both kinds of pack.
std::vector<ir::Texture> CornerPacks(int colors) {
  const int count = colors * colors;
  Texels texels;
  for (int c = 0; c < count * count; ++c) {
    const std::array<int, 4> corners = {c % colors, c / colors % colors, c / count % colors,
                                        c / count / colors};
    Values values{ir::kIvec4, 1, {}};
    for (int corner : corners) values.words.push_back(static_cast<uint32_t>(corner));
    auto place = RunBlock("corner_tile_place", {{"corners", values}, {"colors", Ints({colors})}});
    texels[corners] = {static_cast<float>(place["result"].Int(0, 0)),
                       static_cast<float>(place["result"].Int(0, 1)), 1, 1};
  }
  return {PackOf(count, count), LayersOf(texels, false, {colors, colors})};
}

// Each tile is the one whose corners have the colours that the hash draws, by way of where such a
// tile stands; also far from the origin, with a period and with a seed.
TEST(CornerTilesTest, ShowsTheTileOfTheDrawnCorners) {
  for (int colors = 2; colors <= 4; ++colors) {
    const std::vector<ir::Texture> packs = CornerPacks(colors);
    for (const auto& [pack, x, y, period, seed] : {std::tuple(0, -3, -4, 0, 0),
                                                   {0, 100000, -70000, 0, 7},
                                                   {0, -2, 3, 5, 1},
                                                   {1, -3, -4, 0, 0},
                                                   {1, 100001, -70001, 0, 7},
                                                   {1, -2, 3, 5, 1},
                                                   {1, 1, 0, 1, 1}}) {
      const Tiling tiling = Tile("corner_tiles", packs[static_cast<size_t>(pack)], colors * colors,
                                 Ints({colors}), Middles(x, y, 8, 8), {{period, period}}, seed);
      for (int v = 0; v < 8; ++v) {
        for (int u = 0; u < 8; ++u) {
          Values corners{ir::kIvec4, 1, {}};
          for (int corner = 0; corner < 4; ++corner) {
            const uint32_t bits =
                CellHash(Wrapped(x + u + corner % 2, period), Wrapped(y + v + corner / 2, period),
                         static_cast<uint32_t>(seed));
            corners.words.push_back(bits % static_cast<uint32_t>(colors));
          }
          auto place =
              RunBlock("corner_tile_place", {{"corners", corners}, {"colors", Ints({colors})}});
          const auto& seen = tiling.places[static_cast<size_t>(8 * v + u)];
          ASSERT_EQ(seen[0], place["result"].Int(0, 0));
          ASSERT_EQ(seen[1], place["result"].Int(0, 1));
        }
      }
    }
  }
}

// The tour names the colours of a place: those of its west and east edge from the column, south and
// north from the row.
std::array<int, 4> EdgesAt(const std::array<int, 2>& place) {
  std::array<int, 4> edges{};
  static const char* const kPairs[] = {"00", "01", "11", "10", "02", "21", "12", "22",
                                       "20", "03", "31", "13", "32", "23", "33", "30"};
  for (size_t i = 0; i < 2; ++i) {
    const char* pair = kPairs[place[i]];
    edges[2 * i] = pair[0] - '0';
    edges[2 * i + 1] = pair[1] - '0';
  }
  return edges;
}

std::vector<ir::Texture> WangPacks(int lying, int standing) {
  Texels texels;
  for (int y = 0; y < lying * lying; ++y) {
    for (int x = 0; x < standing * standing; ++x) {
      texels[EdgesAt({x, y})] = {static_cast<float>(x), static_cast<float>(y), 1, 1};
    }
  }
  return {PackOf(standing * standing, lying * lying), LayersOf(texels, true, {lying, standing})};
}

// West and east, south and north agree with the neighbours', for all numbers of colours, on a torus
// too; and all tiles of the set come.
TEST(WangTilesTest, NeighboursAgree) {
  for (int lying = 1; lying <= 4; ++lying) {
    for (int standing = 1; standing <= 4; ++standing) {
      const std::vector<ir::Texture> packs = WangPacks(lying, standing);
      std::vector<int> numbers;
      for (const auto& [pack, period] : {std::pair(0, 0), {0, 24}, {1, 0}, {1, 24}}) {
        const Tiling tiling =
            Tile("wang_tiles", packs[static_cast<size_t>(pack)], standing * standing,
                 CellsOf({{lying, standing}}), Middles(-7, -9, 24, 24), {{period, period}}, 3);
        // However they are packed, the tiles are the same.
        if (pack == 0 && period == 0) numbers = tiling.numbers;
        if (period == 0) {
          ASSERT_EQ(tiling.numbers, numbers);
        }
        const auto at = [&](int x, int y) {
          return EdgesAt(tiling.places[static_cast<size_t>(24 * (y % 24) + x % 24)]);
        };
        for (int y = 0; y + (period == 0) < 24; ++y) {
          for (int x = 0; x + (period == 0) < 24; ++x) {
            ASSERT_EQ(at(x, y)[1], at(x + 1, y)[0]);
            ASSERT_EQ(at(x, y)[3], at(x, y + 1)[2]);
          }
        }
        if (lying * standing > 6) continue;
        const std::set<int> seen(tiling.numbers.begin(), tiling.numbers.end());
        EXPECT_EQ(seen.size(), static_cast<size_t>(lying * lying * standing * standing));
      }
    }
  }
}

// O24: of 16 tiles in 256 x 256 cells each comes as often as in independent draws. The chi-square
// with 15 degrees of freedom is between 3.5 and 37.7 in 998 of 1000; neighbours share corners,
// which makes it wider, so both sides are doubled.
TEST(TileBlocksTest, TilesComeEquallyOften) {
  const ir::Texture pack = PackOf(4, 4);
  for (int seed : {0, 1, 77}) {
    for (const bool wang : {false, true}) {
      const Tiling tiling = wang ? Tile("wang_tiles", pack, 4, CellsOf({{2, 2}}),
                                        Middles(-128, -128, 256, 256), {{0, 0}}, seed)
                                 : Tile("corner_tiles", pack, 4, Ints({2}),
                                        Middles(-128, -128, 256, 256), {{0, 0}}, seed);
      std::vector<double> counts(16);
      for (int number : tiling.numbers) counts[static_cast<size_t>(number)] += 1;
      double chi_square = 0;
      for (double count : counts) chi_square += (count - 4096) * (count - 4096) / 4096;
      EXPECT_GT(chi_square, 3.5 / 2) << seed << " " << wang;
      EXPECT_LT(chi_square, 37.7 * 2) << seed << " " << wang;
    }
  }
}

// No row or column of 2^16 tiles repeats itself, nor comes again beside itself.
TEST(TileBlocksTest, NothingRepeats) {
  constexpr int kLong = 1 << 16;
  const ir::Texture pack = PackOf(4, 4);
  for (const bool is_row : {true, false}) {
    for (const bool wang : {false, true}) {
      const auto line = [&](int at) {
        const std::vector<Vector> places =
            is_row ? Middles(-kLong / 2, at, kLong, 1) : Middles(at, -kLong / 2, 1, kLong);
        return (wang ? Tile("wang_tiles", pack, 4, CellsOf({{2, 2}}), places)
                     : Tile("corner_tiles", pack, 4, Ints({2}), places))
            .numbers;
      };
      const std::vector<int> first = line(0), second = line(1);
      for (int shift = 1; shift <= kLong / 2; ++shift) {
        ASSERT_FALSE(std::equal(first.begin() + shift, first.end(), first.begin())) << shift;
      }
      for (int shift = 0; shift <= kLong / 2; ++shift) {
        ASSERT_FALSE(std::equal(first.begin() + shift, first.end(), second.begin())) << shift;
      }
    }
  }
}

// ---- The paper's own way.

std::vector<int> ShuffledTable(int size, uint32_t seed) {
  std::vector<int> table;
  for (int i = 0; i < size; ++i) table.push_back(i);
  std::mt19937 random(seed);
  for (size_t i = table.size(); i > 1; --i) std::swap(table[i - 1], table[random() % i]);
  return table;
}

Tiling TilePermuted(const std::vector<int>& table, int lying, int standing,
                    const std::vector<Vector>& at, int period) {
  const ir::Texture pack = PackOf(standing * standing, lying * lying);
  const ir::Texture hash = MapOf({std::vector<double>(table.begin(), table.end())});
  auto outputs = RunBlock("permutation_wang_tiles", {{"tiles", pack},
                                                     {"table", hash},
                                                     {"uv", Vectors(at)},
                                                     {"tiling", Vectors({{1, 1}})},
                                                     {"colors", CellsOf({{lying, standing}})},
                                                     {"period", CellsOf({{period, period}})}});
  Tiling tiling;
  for (size_t i = 0; i < at.size(); ++i) {
    tiling.places.push_back({static_cast<int>(outputs["color"].Float(i, 0)),
                             static_cast<int>(outputs["color"].Float(i, 1))});
    tiling.numbers.push_back(outputs["index"].Int(i));
  }
  return tiling;
}

// Equation 2 as it is printed, with tables that are as large as the plane, smaller, larger and of
// no power of two.
TEST(PermutationWangTilesTest, DrawsTheColoursOfEquation2) {
  for (const auto& [size, m, kh, kv] :
       {std::tuple(16, 16, 2, 2), {8, 16, 3, 2}, {40, 10, 2, 4}, {23, 12, 1, 3}}) {
    const std::vector<int> table = ShuffledTable(size, static_cast<uint32_t>(size + m));
    const auto hash = [&](int i) { return table[static_cast<size_t>(i % size)]; };
    const std::vector<Vector> at = Middles(-5, -4, 20, 20);
    const Tiling tiling = TilePermuted(table, kh, kv, at, m);
    for (size_t i = 0; i < at.size(); ++i) {
      const int oh = Wrapped(static_cast<int>(std::floor(at[i][0])), m);
      const int ov = Wrapped(static_cast<int>(std::floor(at[i][1])), m);
      const std::array<int, 4> edges = EdgesAt(tiling.places[i]);
      ASSERT_EQ(edges[2], hash(hash(oh) + ov) % kh);                // south
      ASSERT_EQ(edges[1], hash((oh + 1) % m + hash(2 * ov)) % kv);  // east
      ASSERT_EQ(edges[3], hash(hash(oh) + (ov + 1) % m) % kh);      // north
      ASSERT_EQ(edges[0], hash(oh + hash(2 * ov)) % kv);            // west
      ASSERT_EQ(tiling.numbers[i], tiling.places[i][0] + tiling.places[i][1] * kv * kv);
    }
  }
}

// Why it is not the default: the colours of standing edges come again after half as many rows as
// the table has numbers, and all their rows are one sequence that is moved along. A table that is
// twice the plane has no such period in it.
TEST(PermutationWangTilesTest, RepeatsAfterHalfTheTable) {
  for (const auto& [m, size] :
       {std::pair(32, 8), {32, 16}, {32, 32}, {32, 64}, {32, 128}, {256, 256}, {256, 512}}) {
    for (uint32_t seed : {1u, 2u}) {
      const std::vector<int> table = ShuffledTable(size, seed);
      const Tiling tiling = TilePermuted(table, 2, 2, Middles(0, 0, 32, m), m);
      const auto standing = [&](int row, int column) {
        return EdgesAt(tiling.places[static_cast<size_t>(row % m * 32 + column)])[0];
      };
      // The least number of rows after which all standing edges come again.
      int found = 1;
      const auto repeats = [&](int rows) {
        for (int i = 0; i < 32 * m; ++i) {
          if (standing(i / 32, i % 32) != standing(i / 32 + rows, i % 32)) return false;
        }
        return true;
      };
      while (found < m && !repeats(found)) ++found;
      if (size > m) {
        EXPECT_EQ(found, m) << size;
      } else {
        EXPECT_LE(found, size / 2) << size;
        EXPECT_EQ(size / 2 % found, 0) << size;
      }
      if (size != 32) continue;
      for (int row = 0; row < m; ++row) {
        bool rotated = false;
        for (int by = 0; by < 32 && !rotated; ++by) {
          rotated = true;
          for (int i = 0; i < 32; ++i) rotated &= standing(row, i) == standing(0, (i + by) % 32);
        }
        EXPECT_TRUE(rotated) << row;
      }
    }
  }
}

// Around a corner of `wang_tiles` the pack of corners has the edges that meet there (equation 10),
// and counts within a sixteenth of a tile. Here a tile has one texel.
TEST(WangCornersTest, ShowsTheEdgesThatMeet) {
  constexpr int kLying = 2;
  constexpr int kStanding = 3;
  static const char* const kTour[] = {"00", "01", "11", "10", "02", "21", "12", "22", "20"};
  const auto index = [&](int first, int second) {
    for (int i = 0; i < 9; ++i) {
      if (kTour[i][0] - '0' == first && kTour[i][1] - '0' == second) return i;
    }
    return -1;
  };
  for (const auto& [period, seed] : {std::pair(0, 0), {5, 9}}) {
    const Values colors = CellsOf({{kLying, kStanding}});
    const std::vector<std::pair<int32_t, int32_t>> periods = {{period, period}};
    const ir::Texture pack = PackOf(kStanding * kStanding, kLying * kLying);
    const Tiling tiling = Tile("wang_tiles", pack, kStanding * kStanding, colors,
                               Middles(-4, -4, 10, 10), periods, seed);
    const auto edges = [&](int x, int y) {
      return EdgesAt(tiling.places[static_cast<size_t>(10 * (y + 4) + x + 4)]);
    };
    const ir::Texture corners = PackOf(kLying * kLying, kStanding * kStanding);
    std::vector<Vector> at;
    for (int i = 0; i < 64; ++i) at.push_back({i % 8 - 3 - 0.01, i / 8 - 3 - 0.01});
    for (double away : {0.06, 0.09375, 0.125, 0.3}) at.push_back({away, 0.01});
    auto outputs = RunBlock("wang_corners", {{"corners", corners},
                                             {"uv", Vectors(at)},
                                             {"tiling", Vectors({{1, 1}})},
                                             {"colors", colors},
                                             {"period", CellsOf(periods)},
                                             {"seed", Ints({seed})}});
    for (int i = 0; i < 64; ++i) {
      // The tile left below the corner, and its neighbours.
      const int x = i % 8 - 4;
      const int y = i / 8 - 4;
      const auto k = static_cast<size_t>(i);
      ASSERT_EQ(outputs["color"].Float(k, 0), index(edges(x, y)[3], edges(x + 1, y)[3]));
      ASSERT_EQ(outputs["color"].Float(k, 1), index(edges(x, y)[1], edges(x, y + 1)[1]));
      ASSERT_EQ(outputs["weight"].Float(k), 1);
    }
    const double weights[] = {1, 0.5, 0, 0};
    for (size_t i = 0; i < 4; ++i) EXPECT_NEAR(outputs["weight"].Float(64 + i), weights[i], 1e-5);
  }
}

// The place in the tile goes on over its borders as the coordinate does, and its mip level is that
// of the tiling: a pack with a texel of its own colour for each place is a ramp in each tile.
TEST(TileBlocksTest, TheLevelIsThatOfTheCoordinate) {
  ir::Texture pack = PackOf(64, 64);
  for (size_t i = 0; i < pack.levels[0].texels.size(); ++i) {
    const size_t x = i % 64 % 16, y = i / 64 % 16;
    pack.levels[0].texels[i] = {(x + 0.5f) / 16, (y + 0.5f) / 16, 0, 1};
  }
  BuildMipChain(pack);
  for (size_t level = 0; level < pack.levels.size(); ++level) {
    for (auto& texel : pack.levels[level].texels) texel[2] = static_cast<float>(level);
  }
  pack.sampler.filter = ir::Filter::kNearest;
  pack.sampler.mip_filter = ir::MipFilter::kLinear;
  const std::string graph = R"({"texgraph": 1,
    "textures": {"set": {"file": "mortar.png"}},
    "nodes": {"t": {"block": "corner_tiles", "in": {"tiles": "set", "colors": 2, "tiling": 4}}},
    "outputs": {"color": "t.color"}})";
  for (double level : {0.0, 1.0, 2.5}) {
    const double pixel = std::exp2(level) / 64;  // 64 texels for each unit
    std::vector<Point> points;
    for (int i = 0; i < 64; ++i) points.push_back({-1 + 0.03125 * i + 0.001, 0.3 + 0.0411 * i});
    auto outputs = RunGraph(graph, points, {pixel, pixel}, 1e-4, PictureFolder(), {{"set", pack}});
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(outputs["color"].Float(i, 2), level, 1e-4);
    }
  }
}

// A map names the tiles; below 0 there is none, beyond the last is the last. It repeats.
TEST(TileMapTest, ShowsTheTilesOfTheMap) {
  const ir::Texture pack = PackOf(4, 4);
  const ir::Texture map = MapOf({{0, 5, 15}, {-1, 99, 4}});
  auto outputs = RunBlock("tile_map", {{"tiles", pack},
                                       {"map", map},
                                       {"uv", Vectors(Middles(-3, -2, 6, 4))},
                                       {"tiling", Vectors({{1, 1}})},
                                       {"pack", CellsOf({{4, 4}})}});
  const int numbers[2][3] = {{0, 5, 15}, {-1, 99, 4}};
  for (size_t i = 0; i < 24; ++i) {
    const int number = numbers[i / 6 % 2][i % 3];
    const int shown = std::clamp(number, 0, 15);
    EXPECT_EQ(outputs["index"].Int(i), number);
    EXPECT_EQ(outputs["color"].Float(i, 3), number < 0 ? 0 : 1);
    if (number < 0) continue;
    EXPECT_EQ(outputs["color"].Float(i, 0), shown % 4);
    EXPECT_EQ(outputs["color"].Float(i, 1), shown / 4);
  }
}

// Four colours have gutters of half a tile: 16 tiles of 6 texels and 3 texels below and above.
TEST(PackPlaceTest, LeavesGuttersOut) {
  const ir::Texture pack = PackOf(96, 102);
  auto outputs = RunBlock("pack_place", {{"tiles", pack},
                                         {"place", CellsOf({{0, 0}, {15, 15}, {7, 3}})},
                                         {"local", Vectors({{0, 0}, {1, 1}, {0.5, 0.25}})},
                                         {"pack", CellsOf({{16, 16}})},
                                         {"gutters", Bools({true})}});
  const double expected[3][2] = {{0, 3.0 / 102}, {1, 99.0 / 102}, {45.0 / 96, 22.5 / 102}};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(outputs["result"].Float(i, 0), expected[i][0], 1e-6);
    EXPECT_NEAR(outputs["result"].Float(i, 1), expected[i][1], 1e-6);
  }
}

}  // namespace
}  // namespace texgraph::blocks
