// SPDX-License-Identifier: Apache-2.0
// Tile maps and the choice of patterns, against references in C++, and what must hold without any:
// randomness that is neither uneven nor too even, without periods, and maps that echo.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Cell = std::pair<int32_t, int32_t>;

// --- References --------------------------------------------------------------------------------

// pcg2d and pcg3d as the paper lists them (Jarzynski and Olano 2020, listings of section 4.3), with
// seeds for the constants, and without the last xor of shifts.
uint32_t Pcg2d(Cell cell, int32_t seed) {
  uint32_t first = reference::Pcg(static_cast<uint32_t>(seed)), second = reference::Pcg(first);
  uint32_t x = static_cast<uint32_t>(cell.first) * 1664525u;
  uint32_t y = static_cast<uint32_t>(cell.second) * 1664525u;
  x += y * 1664525u;
  y += x * 1664525u;
  x += first;
  y += second;
  x ^= x >> 16;
  y ^= y >> 16;
  x += y * 1664525u;
  y += x * 1664525u;
  return y;
}

uint32_t Pcg3d(std::array<int32_t, 3> cell, int32_t seed) {
  std::array<uint32_t, 3> v;
  uint32_t bits = static_cast<uint32_t>(seed);
  for (size_t i = 0; i < 3; ++i) {
    bits = reference::Pcg(bits);
    v[i] = static_cast<uint32_t>(cell[i]) * 1664525u + bits;
  }
  auto round = [&] {
    v[0] += v[1] * v[2];
    v[1] += v[2] * v[0];
    v[2] += v[0] * v[1];
  };
  round();
  for (uint32_t& word : v) word ^= word >> 16;
  round();
  return v[2];
}

// The numbers from 0 to 255 in the order of their hashes.
std::array<int, 256> Sigma() {
  std::array<int, 256> sigma;
  std::iota(sigma.begin(), sigma.end(), 0);
  std::sort(sigma.begin(), sigma.end(), [](int a, int b) {
    return reference::Pcg(static_cast<uint32_t>(a)) < reference::Pcg(static_cast<uint32_t>(b));
  });
  return sigma;
}

int Floored(int64_t a, int64_t n) { return static_cast<int>((a % n + n) % n); }
int64_t FlooredQuotient(int64_t a, int64_t n) { return (a - Floored(a, n)) / n; }

// The paper's series in base 256, three steps; of y first, and then of x.
int Permuted(std::vector<int64_t> cell) {
  static const std::array<int, 256> sigma = Sigma();
  int s = 0;
  for (int64_t digit : {1, 256, 65536}) {
    for (size_t i = cell.size(); i-- > 0;) {
      s = sigma[static_cast<size_t>(Floored(FlooredQuotient(cell[i], digit) + s, 256))];
    }
  }
  return s;
}

// --- Running -----------------------------------------------------------------------------------

std::vector<Cell> Window(int side, int32_t x = 0, int32_t y = 0) {
  std::vector<Cell> cells;
  for (int32_t row = 0; row < side; ++row) {
    for (int32_t column = 0; column < side; ++column) cells.emplace_back(x + column, y + row);
  }
  return cells;
}

Values CellHashes(const std::vector<Cell>& cells, int32_t seed) {
  return RunBlock("cell_hash", {{"cell", CellsOf(cells)}, {"seed", Ints({seed})}})["result"];
}

Values Tiles(const std::vector<Vector>& uv, Cell cells, bool toroidal, int32_t seed = 0) {
  return RunBlock("virtual_tile_map", {{"uv", Vectors(uv)},
                                       {"cells", CellsOf({cells})},
                                       {"seed", Ints({seed})},
                                       {"toroidal", Bools({toroidal})}})["tile"];
}

// The tiles of a window of cells, seen from their middles.
Values TilesOfWindow(int side, int32_t seed = 0) {
  std::vector<Vector> uv;
  for (Cell cell : Window(side)) {
    uv.push_back({(cell.first + 0.5) / side, (cell.second + 0.5) / side});
  }
  return Tiles(uv, {side, side}, false, seed);
}

Cell CellOf(const Values& tiles, size_t i) { return {tiles.Int(i, 0), tiles.Int(i, 1)}; }
constexpr size_t kLocal = 2, kSize = 4, kSeed = 6;

std::vector<int> Patterns(const Values& tiles, int patterns, const char* randomness = "hash",
                          int stream = 0) {
  auto outputs = RunBlock("virtual_indirection_map", {{"tile", tiles},
                                                      {"patterns", Ints({patterns})},
                                                      {"stream", Ints({stream})},
                                                      {"randomness", Word{randomness}}});
  std::vector<int> result;
  for (size_t i = 0; i < tiles.count; ++i) result.push_back(outputs["result"].Int(i));
  return result;
}

// --- The hash ----------------------------------------------------------------------------------

TEST(CellHashTest, IsPcg2dToTheBit) {
  std::vector<Cell> cells = Window(40, -20, -20);
  std::mt19937 random(5);
  std::uniform_int_distribution<int32_t> far(-1048576, 1048576);
  for (int i = 0; i < 4000; ++i) cells.emplace_back(far(random), far(random));
  for (int32_t x : {-1048576, 1048576, INT32_MIN, INT32_MAX}) cells.emplace_back(x, -x / 3);
  for (int32_t seed : {0, 1, -7, 123456}) {
    Values bits = CellHashes(cells, seed);
    ASSERT_EQ(bits.count, cells.size());
    for (size_t i = 0; i < cells.size(); ++i) {
      ASSERT_EQ(bits.Uint(i), Pcg2d(cells[i], seed)) << cells[i].first << " " << cells[i].second;
    }
  }
}

TEST(CellHashTest, OfALineAndInSpace) {
  std::mt19937 random(6);
  std::uniform_int_distribution<int32_t> far(-1048576, 1048576);
  std::vector<int32_t> line = {0, 1, -1, INT32_MIN};
  Values space{ir::Vector(ir::Scalar::kInt, 3), 1000, {}};
  for (int i = 0; i < 1000; ++i) line.push_back(far(random));
  for (int i = 0; i < 3000; ++i) space.words.push_back(static_cast<uint32_t>(far(random)));
  auto of_line = RunBlock("cell_hash", {{"cell", Ints(line)}, {"seed", Ints({9})}});
  auto in_space = RunBlock("cell_hash", {{"cell", space}, {"seed", Ints({9})}});
  ASSERT_EQ(of_line.size() + in_space.size(), 2u);
  for (size_t i = 0; i < line.size(); ++i) {
    EXPECT_EQ(of_line["result"].Uint(i),
              reference::Pcg(static_cast<uint32_t>(line[i]) + reference::Pcg(9)));
  }
  for (size_t i = 0; i < 1000; ++i) {
    EXPECT_EQ(in_space["result"].Uint(i),
              Pcg3d({space.Int(i, 0), space.Int(i, 1), space.Int(i, 2)}, 9));
  }
}

// O1, O2: for k - 1 degrees of freedom the statistic has mean k - 1 and variance 2 (k - 1); five
// standard deviations on both sides, for too even is not random either.
void ExpectChance(const std::vector<int>& values, int kinds, const char* what) {
  std::vector<int> counts(static_cast<size_t>(kinds));
  for (int value : values) ++counts[static_cast<size_t>(value)];
  const double expected = static_cast<double>(values.size()) / kinds;
  double statistic = 0;
  for (int count : counts) statistic += (count - expected) * (count - expected) / expected;
  const double spread = 5 * std::sqrt(2.0 * (kinds - 1));
  EXPECT_GT(statistic, kinds - 1 - spread) << what;
  EXPECT_LT(statistic, kinds - 1 + spread) << what;
}

constexpr int kSide = 256;

TEST(VirtualIndirectionMapTest, PatternsAndPairsOfNeighboursAreChance) {
  for (int32_t seed : {0, 3}) {
    std::vector<int> patterns = Patterns(TilesOfWindow(kSide, seed), 16);
    ExpectChance(patterns, 16, "single");
    for (auto [dx, dy] : {Cell{1, 0}, {0, 1}, {1, 1}}) {
      // Pairs that share no cell with each other, else they would not be independent.
      std::vector<int> pairs;
      for (int y = 0; y + dy < kSide; y += 1 + dy) {
        for (int x = 0; x + dx < kSide; x += 1 + dx) {
          pairs.push_back(patterns[static_cast<size_t>(y * kSide + x)] * 16 +
                          patterns[static_cast<size_t>((y + dy) * kSide + x + dx)]);
        }
      }
      ExpectChance(pairs, 256, "pairs");
    }
  }
}

// O3. Cells at any distance are equal as often as chance wants: nothing repeats. 8,256 distances,
// of which chance puts one in 30,000 beyond four standard deviations.
TEST(VirtualIndirectionMapTest, NothingRepeats) {
  std::vector<int> patterns = Patterns(TilesOfWindow(kSide), 16);
  int beyond = 0;
  for (int dy = 0; dy <= 64; ++dy) {
    for (int dx = -64; dx <= 64; ++dx) {
      if (dy == 0 && dx <= 0) continue;
      int equal = 0;
      for (int y = 0; y + dy < kSide; ++y) {
        const int* here = &patterns[static_cast<size_t>(y * kSide)];
        const int* there = &patterns[static_cast<size_t>((y + dy) * kSide)];
        for (int x = std::max(0, -dx); x < kSide && x + dx < kSide; ++x) {
          equal += here[x] == there[x + dx];
        }
      }
      const double pairs = (kSide - dy) * (kSide - std::abs(dx));
      const double excess = (equal / pairs - 1 / 16.0) / std::sqrt(15 / 256.0 / pairs);
      beyond += excess > 4;
      EXPECT_LT(excess, 5) << dx << " " << dy;
    }
  }
  EXPECT_LE(beyond, 2);
  // Exact periods, along the eight directions of the lattice.
  for (auto [dx, dy] : {Cell{1, 0}, {0, 1}, {1, 1}, {1, -1}}) {
    for (int period = 1; period < kSide; ++period) {
      bool all_equal = true;
      for (int y = 0; y < kSide && all_equal; ++y) {
        for (int x = 0; x < kSide && all_equal; ++x) {
          const int there_x = x + dx * period, there_y = y + dy * period;
          if (there_x >= kSide || there_y >= kSide || there_y < 0) continue;
          all_equal = patterns[static_cast<size_t>(y * kSide + x)] ==
                      patterns[static_cast<size_t>(there_y * kSide + there_x)];
        }
      }
      EXPECT_FALSE(all_equal) << dx << " " << dy << " " << period;
    }
  }
}

// O5. A row's pattern says nothing of the column, and the other way round: the mutual information
// of 16 patterns and 256 columns is what chance leaves, (16 - 1) (256 - 1) / (2 n) nats.
TEST(VirtualIndirectionMapTest, IsNotSeparable) {
  std::vector<int> patterns = Patterns(TilesOfWindow(kSide), 16);
  for (bool columns : {true, false}) {
    std::vector<double> counts(16 * kSide), totals(16);
    for (int i = 0; i < kSide * kSide; ++i) {
      const int line = columns ? i % kSide : i / kSide;
      const int pattern = patterns[static_cast<size_t>(i)];
      ++counts[static_cast<size_t>(pattern * kSide + line)];
      ++totals[static_cast<size_t>(pattern)];
    }
    double information = 0;
    const double n = kSide * kSide;
    for (int i = 0; i < 16 * kSide; ++i) {
      const double p = counts[static_cast<size_t>(i)] / n;
      if (p > 0) {
        information += p * std::log(p / (totals[static_cast<size_t>(i / kSide)] / n / kSide));
      }
    }
    const double freedoms = 15 * 255;
    EXPECT_NEAR(information, freedoms / (2 * n), 5 * std::sqrt(2 * freedoms) / (2 * n));
  }
}

TEST(VirtualIndirectionMapTest, TakesTheUpperBits) {
  Values tiles = TilesOfWindow(64);
  for (int count : {1, 2, 7, 16, 1000, 65536}) {
    std::vector<int> first = Patterns(tiles, count), third = Patterns(tiles, count, "hash", 3);
    for (size_t i = 0; i < tiles.count; ++i) {
      uint64_t bits = tiles.Uint(i, kSeed) >> 16;
      EXPECT_EQ(first[i], static_cast<int>(bits * static_cast<uint64_t>(count) / 65536));
      bits = reference::Pcg(tiles.Uint(i, kSeed) + 3) >> 16;
      EXPECT_EQ(third[i], static_cast<int>(bits * static_cast<uint64_t>(count) / 65536));
    }
  }
}

// --- The permutation ---------------------------------------------------------------------------

TEST(CellPermutationTest, IsThePapersSeries) {
  std::mt19937 random(8);
  std::uniform_int_distribution<int32_t> far(-8388608, 8388607);
  std::vector<Cell> cells = Window(30, -15, -15);
  std::vector<int32_t> line;
  Values space{ir::Vector(ir::Scalar::kInt, 3), 1000, {}};
  for (int i = 0; i < 1000; ++i) cells.emplace_back(far(random), far(random));
  for (int i = 0; i < 1000; ++i) line.push_back(far(random));
  for (int i = 0; i < 3000; ++i) space.words.push_back(static_cast<uint32_t>(far(random)));
  auto in_plane = RunBlock("cell_permutation", {{"cell", CellsOf(cells)}});
  auto of_line = RunBlock("cell_permutation", {{"cell", Ints(line)}});
  auto in_space = RunBlock("cell_permutation", {{"cell", space}});
  ASSERT_EQ(in_plane.size() + of_line.size() + in_space.size(), 3u);
  for (size_t i = 0; i < cells.size(); ++i) {
    ASSERT_EQ(in_plane["result"].Int(i), Permuted({cells[i].first, cells[i].second}));
  }
  for (size_t i = 0; i < line.size(); ++i) {
    ASSERT_EQ(of_line["result"].Int(i), Permuted({line[i]}));
    ASSERT_EQ(in_space["result"].Int(i),
              Permuted({space.Int(i, 0), space.Int(i, 1), space.Int(i, 2)}));
  }
}

// O6. Over a full period of the table every pattern comes up exactly as often as any other; what
// the hash does not promise.
TEST(VirtualIndirectionMapTest, ThePermutationIsExactlyFair) {
  std::vector<int> patterns = Patterns(TilesOfWindow(kSide), 16, "permutation");
  for (int row = 0; row < kSide; ++row) {
    std::array<int, 16> counts{};
    for (int x = 0; x < kSide; ++x) {
      ++counts[static_cast<size_t>(patterns[static_cast<size_t>(row * kSide + x)])];
    }
    for (int count : counts) ASSERT_EQ(count, 16) << row;
  }
  std::vector<int> other = Patterns(TilesOfWindow(kSide), 16, "permutation", 1);
  int equal = 0;
  for (size_t i = 0; i < patterns.size(); ++i) equal += patterns[i] == other[i];
  EXPECT_NEAR(equal, 4096, 5 * std::sqrt(65536 * 15 / 256.0));
  // Not the paper's vector of tables: columns are not alike.
  int same_as_below = 0;
  for (size_t i = kSide; i < patterns.size(); ++i)
    same_as_below += patterns[i] == patterns[i - kSide];
  EXPECT_LT(same_as_below, 65536 / 8);
}

// --- Tile maps ---------------------------------------------------------------------------------

// O7, and the floored remainder below 0.
TEST(VirtualTileMapTest, CellsAreWhereTheyShouldBe) {
  std::vector<Vector> uv = Lattice(-2, 2, 60);
  for (double edge : {0.0, 1.0, -1.0, std::nextafter(1.0f, 0.0f) * 1.0, -1e-6}) {
    uv.push_back({edge, 0.3});
    uv.push_back({0.7, edge});
  }
  for (bool toroidal : {false, true}) {
    for (Cell cells : {Cell{8, 8}, {5, 12}, {1, 1}}) {
      Values tiles = Tiles(uv, cells, toroidal, 4);
      ASSERT_EQ(tiles.count, uv.size());
      for (size_t i = 0; i < uv.size(); ++i) {
        // In floats, as the shader multiplies.
        const float x = static_cast<float>(uv[i][0]) * static_cast<float>(cells.first);
        const float y = static_cast<float>(uv[i][1]) * static_cast<float>(cells.second);
        Cell cell{static_cast<int32_t>(std::floor(x)), static_cast<int32_t>(std::floor(y))};
        EXPECT_NEAR(tiles.Float(i, kLocal), x - cell.first, 1e-5);
        EXPECT_NEAR(tiles.Float(i, kLocal + 1), y - cell.second, 1e-5);
        EXPECT_FLOAT_EQ(tiles.Float(i, kSize), 1.0f / static_cast<float>(cells.first));
        if (toroidal) cell = {Floored(cell.first, cells.first), Floored(cell.second, cells.second)};
        EXPECT_EQ(CellOf(tiles, i), cell) << uv[i][0] << " " << uv[i][1];
        EXPECT_EQ(tiles.Uint(i, kSeed), Pcg2d(cell, 4));
      }
    }
  }
}

TEST(VirtualTileMapTest, NeighboursAreTheTilesBeside) {
  std::vector<Vector> uv = Lattice(0, 1, 32);
  for (Cell step : {Cell{1, 0}, {0, 1}, {-1, 2}}) {
    std::vector<Vector> moved = uv;
    for (Vector& p : moved) p = {p[0] + step.first / 16.0, p[1] + step.second / 8.0};
    auto asked = RunBlock("virtual_tile_map", {{"uv", Vectors(uv)},
                                               {"cells", CellsOf({{16, 8}})},
                                               {"toroidal", Bools({true})},
                                               {"neighbour", CellsOf({step})}})["tile"];
    Values there = Tiles(moved, {16, 8}, true);
    for (size_t i = 0; i < uv.size(); ++i) {
      ASSERT_EQ(CellOf(asked, i), CellOf(there, i));
      ASSERT_EQ(asked.Uint(i, kSeed), there.Uint(i, kSeed));
      EXPECT_NEAR(asked.Float(i, kLocal), there.Float(i, kLocal) - step.first, 1e-5);
      EXPECT_NEAR(asked.Float(i, kLocal + 1), there.Float(i, kLocal + 1) - step.second, 1e-5);
    }
  }
}

// O42. Moved by whole cells, and scaled with the number of cells, the map is the same; a number of
// cells below 1 counts as 1.
TEST(VirtualTileMapTest, MovesAndScalesWithItsCells) {
  std::vector<Vector> uv = Lattice(0, 1, 64), moved = uv, scaled = uv;
  for (Vector& p : moved) p = {p[0] + 3.0 / 16, p[1] - 5.0 / 16};
  for (Vector& p : scaled) p = {p[0] / 4, p[1] / 4};
  Values a = Tiles(uv, {16, 16}, false), b = Tiles(moved, {16, 16}, false),
         c = Tiles(scaled, {64, 64}, false);
  for (size_t i = 0; i < uv.size(); ++i) {
    EXPECT_EQ(CellOf(b, i), Cell(a.Int(i, 0) + 3, a.Int(i, 1) - 5));
    EXPECT_EQ(CellOf(c, i), CellOf(a, i));
    EXPECT_EQ(a.Uint(i, kSeed), c.Uint(i, kSeed));
    EXPECT_EQ(a.Float(i, kLocal), b.Float(i, kLocal));
    EXPECT_EQ(a.Float(i, kLocal), c.Float(i, kLocal));
  }
  Values none = Tiles({{0.3, 0.7}, {1.2, -0.1}}, {0, -4}, true);
  EXPECT_EQ(CellOf(none, 0), Cell(0, 0));
  EXPECT_EQ(CellOf(none, 1), Cell(0, 0));
}

TEST(VirtualTileMapTest, OfALineAndInSpace) {
  std::vector<double> u;
  std::vector<Vector> uvw;
  for (int i = 0; i < 200; ++i) {
    u.push_back(std::fmod(0.618034 * i, 4) - 2);
    uvw.push_back({u.back(), std::fmod(0.7548776 * i, 4) - 2, std::fmod(0.5698 * i, 4) - 2});
  }
  Values cells{ir::Vector(ir::Scalar::kInt, 3), 1, {4, 5, 6}};
  auto line = RunBlock("virtual_tile_map",
                       {{"uv", Floats(u)}, {"cells", Ints({7})}, {"toroidal", Bools({true})}});
  auto space = RunBlock("virtual_tile_map",
                        {{"uv", Vectors(uvw)}, {"cells", cells}, {"toroidal", Bools({true})}});
  ASSERT_EQ(line.size() + space.size(), 2u);
  const Values &one = line["tile"], &three = space["tile"];
  for (size_t i = 0; i < u.size(); ++i) {
    const double x = static_cast<float>(u[i]) * 7.0f;
    EXPECT_EQ(one.Int(i, 0), Floored(static_cast<int64_t>(std::floor(x)), 7));
    EXPECT_NEAR(one.Float(i, 1), x - std::floor(x), 1e-5);
    EXPECT_EQ(one.Uint(i, 3),
              reference::Pcg(static_cast<uint32_t>(one.Int(i, 0)) + reference::Pcg(0)));
    std::array<int32_t, 3> cell;
    for (size_t c = 0; c < 3; ++c) {
      const int count = 4 + static_cast<int>(c);
      const double p = static_cast<float>(uvw[i][c]) * static_cast<float>(count);
      cell[c] = Floored(static_cast<int64_t>(std::floor(p)), count);
      EXPECT_EQ(three.Int(i, c), cell[c]);
      EXPECT_NEAR(three.Float(i, 3 + c), p - std::floor(p), 1e-5);
      EXPECT_FLOAT_EQ(three.Float(i, 6 + c), 1.0f / static_cast<float>(count));
    }
    EXPECT_EQ(three.Uint(i, 9), Pcg3d(cell, 0));
  }
  for (const Values* tiles : {&one, &three}) {
    const size_t seed = tiles == &one ? 3 : 9;
    std::vector<int> patterns = Patterns(*tiles, 5), permuted = Patterns(*tiles, 5, "permutation");
    for (size_t i = 0; i < tiles->count; ++i) {
      EXPECT_EQ(patterns[i], static_cast<int>((tiles->Uint(i, seed) >> 16) * 5 / 65536));
      const int s = tiles == &one ? Permuted({one.Int(i, 0)})
                                  : Permuted({three.Int(i, 0), three.Int(i, 1), three.Int(i, 2)});
      EXPECT_EQ(permuted[i], s * 5 / 256);
    }
  }
}

// --- Random numbers ----------------------------------------------------------------------------

TEST(VirtualRandomMapTest, AreFourIndependentNumbers) {
  Values tiles = TilesOfWindow(kSide);
  for (const char* randomness : {"hash", "permutation"}) {
    std::vector<Values> streams;
    for (int stream : {0, 1}) {
      streams.push_back(
          RunBlock("virtual_random_map", {{"tile", tiles},
                                          {"stream", Ints({stream})},
                                          {"randomness", Word{randomness}}})["result"]);
    }
    std::vector<std::vector<float>> numbers;
    for (const Values& stream : streams) {
      for (size_t c = 0; c < 4; ++c) {
        std::vector<float>& list = numbers.emplace_back();
        std::vector<int> sixteenths;
        for (size_t i = 0; i < stream.count; ++i) {
          list.push_back(stream.Float(i, c));
          ASSERT_GE(list.back(), 0.0f);
          ASSERT_LT(list.back(), 1.0f);
          sixteenths.push_back(static_cast<int>(16 * list.back()));
        }
        if (std::string(randomness) == "hash") ExpectChance(sixteenths, 16, randomness);
      }
    }
    for (size_t a = 0; a < numbers.size(); ++a) {
      for (size_t b = a + 1; b < numbers.size(); ++b) {
        double covariance = 0;
        for (size_t i = 0; i < tiles.count; ++i) {
          covariance += (numbers[a][i] - 0.5) * (numbers[b][i] - 0.5);
        }
        EXPECT_LT(std::fabs(covariance / kSide / kSide * 12), 5.0 / kSide) << a << " " << b;
      }
    }
  }
}

TEST(VirtualRandomMapTest, OfALineAndInSpace) {
  Values line =
      RunBlock("virtual_tile_map", {{"uv", Floats({0.1, 0.6})}, {"cells", Ints({4})}})["tile"];
  Values cells{ir::Vector(ir::Scalar::kInt, 3), 1, {4, 4, 4}};
  Values space = RunBlock("virtual_tile_map", {{"uv", Vectors({{0.1, 0.2, 0.3}, {0.6, 0.1, 0.9}})},
                                               {"cells", cells}})["tile"];
  for (const Values* tiles : {&line, &space}) {
    const size_t seed = tiles == &line ? 3 : 9;
    auto hashed = RunBlock("virtual_random_map", {{"tile", *tiles}, {"stream", Ints({2})}});
    auto permuted =
        RunBlock("virtual_random_map", {{"tile", *tiles}, {"randomness", Word{"permutation"}}});
    for (size_t i = 0; i < 2; ++i) {
      const uint32_t first = reference::Pcg(tiles->Uint(i, seed) + 2);
      EXPECT_EQ(hashed["result"].Float(i, 0), reference::Low16(first));
      EXPECT_EQ(hashed["result"].Float(i, 1), reference::High16(first));
      EXPECT_EQ(hashed["result"].Float(i, 3), reference::High16(reference::Pcg(first)));
    }
    EXPECT_NE(permuted["result"].Float(0, 0), permuted["result"].Float(0, 1));
    EXPECT_NE(permuted["result"].Float(0, 0), permuted["result"].Float(1, 0));
  }
}

// --- Explicit maps -----------------------------------------------------------------------------

// O7. Each cell gets its own number, on both sides of 0, and also where the grid is larger.
TEST(ExplicitIndirectionMapTest, EchoesTheMap) {
  std::vector<std::vector<double>> rows(6, std::vector<double>(8));
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 8; ++x) {
      rows[static_cast<size_t>(y)][static_cast<size_t>(x)] =
          8 * y + x == 13 ? -1 : 250 * (8 * y + x);
    }
  }
  const ir::Texture map = MapOf(rows);
  std::vector<Vector> uv = Lattice(-1, 2, 72);
  for (double edge : {0.0, 1.0, std::nextafter(1.0f, 0.0f) * 1.0, -1e-7})
    uv.push_back({edge, edge});
  for (Cell cells : {Cell{8, 6}, {16, 18}, {4, 3}}) {
    Values tiles = Tiles(uv, cells, false);
    auto outputs = RunBlock("explicit_indirection_map", {{"map", map}, {"tile", tiles}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < uv.size(); ++i) {
      auto [x, y] = CellOf(tiles, i);
      EXPECT_EQ(outputs["result"].Int(i),
                rows[static_cast<size_t>(Floored(y, 6))][static_cast<size_t>(Floored(x, 8))]);
    }
  }
}

TEST(ExplicitIndirectionMapTest, OfALineAndInSpace) {
  const ir::Texture row = MapOf({{5, 6, -1, 8, 9}});
  ir::Texture volume;
  volume.is_3d = true;
  volume.levels.push_back({2, 2, 2, {}});
  for (int i = 0; i < 8; ++i) volume.levels[0].texels.push_back({static_cast<float>(i), 0, 0, 1});
  std::vector<double> u;
  std::vector<Vector> uvw;
  for (int i = -7; i < 7; ++i) {
    u.push_back((i + 0.5) / 5);
    uvw.push_back({(i + 0.5) / 2, (i / 2 + 0.5) / 2, 0.75});
  }
  Values line = RunBlock("virtual_tile_map", {{"uv", Floats(u)}, {"cells", Ints({5})}})["tile"];
  Values cells{ir::Vector(ir::Scalar::kInt, 3), 1, {2, 2, 2}};
  Values space = RunBlock("virtual_tile_map", {{"uv", Vectors(uvw)}, {"cells", cells}})["tile"];
  auto of_line = RunBlock("explicit_indirection_map", {{"map", row}, {"tile", line}});
  auto in_space = RunBlock("explicit_indirection_map", {{"map", volume}, {"tile", space}});
  ASSERT_EQ(of_line.size() + in_space.size(), 2u);
  for (int i = -7; i < 7; ++i) {
    const size_t at = static_cast<size_t>(i + 7);
    EXPECT_EQ(of_line["result"].Int(at),
              row.levels[0].texels[static_cast<size_t>(Floored(i, 5))][0]);
    EXPECT_EQ(in_space["result"].Int(at), Floored(i, 2) + 2 * Floored(i / 2, 2) + 4);
  }
}

}  // namespace
}  // namespace texgraph::blocks
