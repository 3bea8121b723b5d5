// SPDX-License-Identifier: Apache-2.0
// The grids other than brick_grid: what every tiling of the plane must fulfil, whatever its shape,
// and the numbers and areas that geometry gives for each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Cell = std::pair<int32_t, int32_t>;

struct Grid {
  std::string name;
  std::string block;
  std::vector<Argument> arguments;
  std::vector<double> areas;  // of the kinds of tiles; empty: any
  std::vector<int> numbers;   // of tiles of each kind in the unit square; one number if any area
  double skew = 0;            // how far off right angles and lengths a frame may be
};

// Areas and numbers in the unit square by geometry: rows times columns of them, or pairs of them.
std::vector<Grid> Grids() {
  auto sized = [](int rows, int columns) {
    return std::vector<Argument>{{"rows", Ints({rows})}, {"columns", Ints({columns})}};
  };
  auto with = [](std::vector<Argument> arguments, const char* port, Values value) {
    arguments.emplace_back(port, std::move(value));
    return arguments;
  };
  double cut = 2 * 0.2 * 0.2;  // the square's share of a cell: half of its diagonals' product
  std::vector<Argument> lengths = with(sized(6, 4), "length_variation", Floats({0.9}));
  return {
      {"herringbone2", "herringbone_grid", with(sized(2, 2), "ratio", Ints({2})), {2.0 / 64}, {32}},
      {"herringbone3", "herringbone_grid", with(sized(1, 2), "ratio", Ints({3})), {3.0 / 72}, {24}},
      {"herringbone5",
       "herringbone_grid",
       with(sized(1, 1), "ratio", Ints({5})),
       {5.0 / 100},
       {20}},
      {"basket_weave2", "basket_weave_grid", sized(4, 4), {1.0 / 32}, {32}},
      {"basket_weave3",
       "basket_weave_grid",
       with(sized(4, 6), "bricks", Ints({3})),
       {1.0 / 72},
       {72}},
      {"flemish",
       "flemish_grid",
       with(sized(6, 3), "header", Floats({0.4})),
       {1 / 1.4 / 18, 0.4 / 1.4 / 18},
       {18, 18}},
      {"random_length", "random_length_grid", lengths, {}, {24}},
      {"random_height",
       "random_length_grid",
       with(with(lengths, "height_variation", Floats({0.6})), "row_jitter", Floats({1})),
       {},
       {24}},
      {"hexagon", "hexagon_grid", sized(8, 7), {1.0 / 56}, {56}},
      {"hexagon_wide", "hexagon_grid", sized(6, 3), {1.0 / 18}, {18}},
      {"triangle", "triangle_grid", sized(8, 7), {0.5 / 56}, {112}},
      {"triangle_high", "triangle_grid", sized(4, 6), {0.5 / 24}, {48}},
      {"octagon",
       "octagon_square_grid",
       with(sized(5, 5), "corner", Floats({0.2})),
       {(1 - cut) / 25, cut / 25},
       {25, 25}},
      {"octagon_wide",
       "octagon_square_grid",
       with(sized(6, 4), "corner", Floats({0.2})),
       {(1 - cut) / 24, cut / 24},
       {24, 24},
       0.5},
  };
}

struct Point2 {
  double x, y;
};

// One evaluation of a grid. A Tile in Values: cell, local, size, seed.
struct Tiling {
  Values tile, edge, spacing;
  Cell CellOf(size_t i) const { return {tile.Int(i, 0), tile.Int(i, 1)}; }
  Point2 Local(size_t i) const { return {tile.Float(i, 2), tile.Float(i, 3)}; }
  Point2 Size(size_t i) const { return {tile.Float(i, 4), tile.Float(i, 5)}; }
  uint32_t Seed(size_t i) const { return tile.Uint(i, 6); }
  double Edge(size_t i) const { return edge.Float(i); }
};

Tiling Evaluate(const Grid& grid, bool toroidal, const std::vector<Vector>& uv) {
  std::vector<Argument> arguments = grid.arguments;
  arguments.emplace_back("uv", Vectors(uv));
  arguments.emplace_back("seed", Ints({11}));
  arguments.emplace_back("toroidal", Bools({toroidal}));
  auto outputs = RunBlock(grid.block, arguments);
  EXPECT_EQ(outputs.size(), 3u) << grid.block;
  return {outputs["tile"], outputs["edge"], outputs["spacing"]};
}

// Points in the unit square that are spread evenly and follow no grid (Roberts's R2 sequence).
Point2 Spread(int i) {
  return {std::fmod(0.5 + 0.7548776662466927 * i, 1), std::fmod(0.5 + 0.5698402909980532 * i, 1)};
}

std::vector<Vector> SpreadPoints(int count) {
  std::vector<Vector> uv;
  for (int i = 0; i < count; ++i) {
    uv.push_back({Spread(i).x, Spread(i).y});
  }
  return uv;
}

class GridsTest : public testing::TestWithParam<Grid> {};

// O34. Every point of a tile has the tile's seed; no two tiles share one.
TEST_P(GridsTest, OneSeedForEachTile) {
  for (bool toroidal : {false, true}) {
    Tiling tiling = Evaluate(GetParam(), toroidal, Lattice(-1, 2, 300));
    std::map<Cell, size_t> first;
    std::set<uint32_t> seeds;
    for (size_t i = 0; i < tiling.tile.count; ++i) {
      auto [entry, is_new] = first.emplace(tiling.CellOf(i), i);
      size_t j = entry->second;
      ASSERT_EQ(tiling.Seed(i), tiling.Seed(j));
      ASSERT_NEAR(tiling.Size(i).x, tiling.Size(j).x, 1e-5);
      ASSERT_NEAR(tiling.Size(i).y, tiling.Size(j).y, 1e-5);
      if (is_new) {
        EXPECT_TRUE(seeds.insert(tiling.Seed(i)).second);
      }
    }
    EXPECT_GT(seeds.size(), toroidal ? 0u : first.size() / 2);
  }
}

// The seed is the hash of the cell, as for brick_grid.
TEST_P(GridsTest, SeedsAreTheHashOfTheCell) {
  Tiling tiling = Evaluate(GetParam(), false, Lattice(-2, 2, 60));
  for (size_t i = 0; i < tiling.tile.count; ++i) {
    auto [column, row] = tiling.CellOf(i);
    ASSERT_EQ(tiling.Seed(i), reference::CellHash(column, row, 11));
  }
}

// The tiles of a toroidal grid, their number and areas, by counting points: the plane is covered
// once, and each tile is as large as geometry says.
TEST_P(GridsTest, TilesHaveTheirAreas) {
  const Grid& grid = GetParam();
  constexpr int kPoints = 400000;
  Tiling tiling = Evaluate(grid, true, SpreadPoints(kPoints));
  std::map<Cell, double> areas;
  for (size_t i = 0; i < tiling.tile.count; ++i) {
    areas[tiling.CellOf(i)] += 1.0 / kPoints;
  }
  size_t expected = 0;
  for (int number : grid.numbers) {
    expected += static_cast<size_t>(number);
  }
  EXPECT_EQ(areas.size(), expected);
  std::vector<int> seen(grid.areas.size());
  for (auto [cell, area] : areas) {
    for (size_t kind = 0; kind < grid.areas.size(); ++kind) {
      seen[kind] += std::abs(area - grid.areas[kind]) < 0.02 * area ? 1 : 0;
    }
  }
  if (!grid.areas.empty()) {
    EXPECT_EQ(seen, grid.numbers);
  }
}

// The local coordinate goes from 0 to 1 over each tile, in both directions.
TEST_P(GridsTest, FramesFitTheTiles) {
  Tiling tiling = Evaluate(GetParam(), true, SpreadPoints(300000));
  std::map<Cell, std::pair<Point2, Point2>> boxes;
  for (size_t i = 0; i < tiling.tile.count; ++i) {
    Point2 p = tiling.Local(i);
    auto [entry, is_new] = boxes.emplace(tiling.CellOf(i), std::pair{p, p});
    auto& [low, high] = entry->second;
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  for (const auto& [cell, box] : boxes) {
    const auto& [low, high] = box;
    ASSERT_GE(std::min(low.x, low.y), -1e-5);
    ASSERT_LE(std::max(high.x, high.y), 1 + 1e-5);
    ASSERT_LE(std::max(low.x, low.y), 0.1);
    ASSERT_GE(std::min(high.x, high.y), 0.9);
  }
}

// In a tile, local times size is the point moved and turned, not stretched and not mirrored.
TEST_P(GridsTest, LocalTimesSizeKeepsLengthsAndAngles) {
  constexpr int kSide = 300;
  constexpr double kStep = 3.0 / kSide;
  Tiling tiling = Evaluate(GetParam(), false, Lattice(-1, 2, kSide));
  size_t compared = 0;
  for (size_t i = 0; i + kSide + 1 < tiling.tile.count; ++i) {
    size_t right = i + 1, up = i + kSide;
    if (tiling.CellOf(i) != tiling.CellOf(right) || tiling.CellOf(i) != tiling.CellOf(up) ||
        (i + 1) % kSide == 0) {
      continue;
    }
    Point2 size = tiling.Size(i), p = tiling.Local(i), q = tiling.Local(right),
           r = tiling.Local(up);
    Point2 across = {(q.x - p.x) * size.x / kStep, (q.y - p.y) * size.y / kStep};
    Point2 along = {(r.x - p.x) * size.x / kStep, (r.y - p.y) * size.y / kStep};
    double slack = 1e-3 + GetParam().skew;
    ASSERT_NEAR(std::hypot(across.x, across.y), 1, slack);
    ASSERT_NEAR(std::hypot(along.x, along.y), 1, slack);
    ASSERT_NEAR(across.x * along.y - across.y * along.x, 1, slack);
    ++compared;
  }
  EXPECT_GT(compared, tiling.tile.count / 2);
}

// Against the nearest point of another tile, by trying all of a lattice.
TEST_P(GridsTest, EdgeIsTheDistanceToOtherTiles) {
  constexpr int kSide = 400;
  constexpr double kStep = 1.2 / kSide;
  std::vector<Vector> uv = Lattice(-0.6, 0.6, kSide);
  Tiling tiling = Evaluate(GetParam(), false, uv);
  double greatest = 0;
  for (int k = 0; k < 150; ++k) {
    int x = kSide / 4 + (k * 7919) % (kSide / 2), y = kSide / 4 + (k * 104729) % (kSide / 2);
    size_t i = static_cast<size_t>(y * kSide + x);
    double nearest = 1;
    for (size_t j = 0; j < uv.size(); ++j) {
      if (tiling.CellOf(j) != tiling.CellOf(i)) {
        nearest = std::min(nearest, std::hypot(uv[j][0] - uv[i][0], uv[j][1] - uv[i][1]));
      }
    }
    ASSERT_GE(tiling.Edge(i), 0);
    ASSERT_LE(tiling.Edge(i), nearest + 1e-6);
    ASSERT_GE(tiling.Edge(i), nearest - 1.5 * kStep) << uv[i][0] << " " << uv[i][1];
    greatest = std::max(greatest, tiling.Edge(i));
  }
  EXPECT_GT(greatest, 0.01);
}

// O35. The tiles of the border u = 0 go on at u = 1. Coordinates are binary fractions, so that
// moving them by whole numbers is exact.
TEST_P(GridsTest, ToroidalGridsRepeat) {
  std::vector<Vector> uv;
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      uv.push_back({(x + 0.371) / 64, (y + 0.613) / 64});
    }
    uv.push_back({0, (y + 0.613) / 64});
    uv.push_back({(y + 0.371) / 64, 0});
  }
  for (Vector& p : uv) {
    p = {std::round(p[0] * 65536) / 65536, std::round(p[1] * 65536) / 65536};
  }
  Tiling here = Evaluate(GetParam(), true, uv);
  for (Vector by : {Vector{1, 0}, Vector{0, 1}, Vector{-3, -2}}) {
    std::vector<Vector> moved = uv;
    for (Vector& p : moved) {
      p = {p[0] + by[0], p[1] + by[1]};
    }
    Tiling there = Evaluate(GetParam(), true, moved);
    for (size_t i = 0; i < uv.size(); ++i) {
      ASSERT_NEAR(here.Edge(i), there.Edge(i), 2e-6);
      if (here.Edge(i) < 1e-5) {
        continue;  // rounding decides between two neighbours
      }
      ASSERT_EQ(here.CellOf(i), there.CellOf(i)) << uv[i][0] << " " << uv[i][1];
      ASSERT_EQ(here.Seed(i), there.Seed(i));
      ASSERT_NEAR(here.Local(i).x, there.Local(i).x, 1e-4);
      ASSERT_NEAR(here.Local(i).y, there.Local(i).y, 1e-4);
    }
  }
}

// A joint of width w covers w / 2 times the perimeter of each tile, less the corners: for narrow
// joints, 2 w / spacing of the surface. The same for all widths, so it is constant everywhere.
TEST_P(GridsTest, SpacingTellsTheShareOfTheJoints) {
  constexpr int kPoints = 500000;
  Tiling tiling = Evaluate(GetParam(), true, SpreadPoints(kPoints));
  double spacing = tiling.spacing.Float(0);
  for (double share : {0.03, 0.06}) {
    double width = share * spacing / 2;
    double seen = 0;
    for (size_t i = 0; i < tiling.tile.count; ++i) {
      seen += tiling.Edge(i) < width / 2 ? 1.0 / kPoints : 0;
    }
    double wanted = 1 - (1 - width / spacing) * (1 - width / spacing);
    EXPECT_NEAR(seen, wanted, 0.08 * share);
  }
}

// The filtered joint against 1,024 samples a pixel, from pixels much smaller than a joint to 64
// times the spacing. In between, where a pixel is about as large as a tile, it is an estimate.
TEST_P(GridsTest, JointsAreFiltered) {
  const Grid& grid = GetParam();
  Tiling one = Evaluate(grid, false, {{0.1, 0.1}});
  double spacing = one.spacing.Float(0);
  for (double size : {0.02, 0.1, 0.5, 1.0, 2.0, 8.0, 64.0}) {
    double pixel = size * spacing;
    constexpr int kPixels = 120, kSamples = 1024;
    std::vector<Vector> middles, samples;
    for (int i = 0; i < kPixels; ++i) {
      Vector middle = {Spread(i).x, Spread(i).y};
      for (int k = 0; k < kSamples; ++k) {
        samples.push_back(
            {middle[0] + pixel * (Spread(k).x - 0.5), middle[1] + pixel * (Spread(k).y - 0.5)});
      }
      middles.push_back(middle);
    }
    Tiling fine = Evaluate(grid, false, samples), coarse = Evaluate(grid, false, middles);
    std::vector<double> edges;
    for (size_t i = 0; i < kPixels; ++i) {
      // A quad in which the distance changes by one pixel to the right, and stays upwards.
      double edge = coarse.Edge(i);
      edges.insert(edges.end(), {edge, edge + pixel, edge, edge + pixel});
    }
    for (double share : {0.025, 0.05}) {
      double width = share * spacing;
      auto joint = RunBlock(
          "joint",
          {{"edge", Floats(edges)}, {"width", Floats({width})}, {"spacing", Floats({spacing})}});
      double error = 0;
      for (size_t i = 0; i < kPixels; ++i) {
        double wanted = 0;
        for (size_t k = 0; k < kSamples; ++k) {
          wanted += fine.Edge(i * kSamples + k) < width / 2 ? 1 : 0;
        }
        error += std::abs(joint["result"].Float(4 * i) - wanted / kSamples) / kPixels;
      }
      EXPECT_LT(error, size < 0.5 || size > 1 ? 0.02 : 0.9 * share) << size << " " << share;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, GridsTest, testing::ValuesIn(Grids()),
                         [](const auto& grid) { return grid.param.name; });

// Herringbone by its definition, on the squares of a brick's width: every square has its neighbours
// either across or up and down, one step up the diagonal everything repeats, and the end of a lying
// brick meets the side of a standing one.
TEST(HerringboneGridTest, StandingBricksLeanOnLyingOnes) {
  constexpr int kRatio = 3, kCells = 2 * kRatio * 2;
  std::vector<Vector> uv;
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      uv.push_back({(x + 0.5) / kCells, (y + 0.5) / kCells});
    }
  }
  Grid grid{"", "herringbone_grid", {{"ratio", Ints({kRatio})}}, {}, {}};
  Tiling tiling = Evaluate(grid, false, uv);
  auto at = [&](int x, int y) { return static_cast<size_t>(y * kCells + x); };
  int lying = 0;
  for (int y = 1; y + 1 < kCells; ++y) {
    for (int x = 1; x + 1 < kCells; ++x) {
      size_t i = at(x, y);
      bool right = tiling.CellOf(i) == tiling.CellOf(at(x + 1, y));
      bool left = tiling.CellOf(i) == tiling.CellOf(at(x - 1, y));
      bool up = tiling.CellOf(i) == tiling.CellOf(at(x, y + 1));
      bool down = tiling.CellOf(i) == tiling.CellOf(at(x, y - 1));
      ASSERT_NE(left || right, up || down);  // a brick is one cell wide
      lying += left || right ? 1 : 0;
      // From one step of the staircase to the next the pattern repeats.
      Cell next = tiling.CellOf(at(x + 1, y + 1)), here = tiling.CellOf(i);
      EXPECT_EQ(next, Cell(here.first + 1, here.second + 1));
      // The end of a lying brick meets the side of a standing one.
      if (left && !right) {
        EXPECT_EQ(tiling.CellOf(at(x + 1, y)).first, x + 1);
        EXPECT_TRUE(tiling.CellOf(at(x + 1, y)) == tiling.CellOf(at(x + 1, y + 1)) ||
                    tiling.CellOf(at(x + 1, y)) == tiling.CellOf(at(x + 1, y - 1)));
      }
    }
  }
  EXPECT_NEAR(lying, (kCells - 2) * (kCells - 2) / 2, kCells);
}

// The lengths lie within the limits, use them, and have the mean.
TEST(RandomLengthGridTest, LengthsLieWithinTheLimits) {
  constexpr int kColumns = 500;
  Grid grid{"",
            "random_length_grid",
            {{"rows", Ints({4})},
             {"columns", Ints({kColumns})},
             {"length_variation", Floats({0.6})},
             {"height_variation", Floats({0.3})}},
            {},
            {}};
  std::vector<Vector> uv;
  for (int i = 0; i < 8000; ++i) {
    uv.push_back({(i + 0.5) / 8000, 0.6});
  }
  Tiling tiling = Evaluate(grid, true, uv);
  std::map<Cell, double> lengths;
  for (size_t i = 0; i < uv.size(); ++i) {
    lengths[tiling.CellOf(i)] = tiling.Size(i).x * kColumns;
    ASSERT_GT(tiling.Size(i).y * 4, 0.7 - 1e-4);
    ASSERT_LT(tiling.Size(i).y * 4, 1.3 + 1e-4);
  }
  ASSERT_EQ(lengths.size(), size_t{kColumns});
  double sum = 0, least = 9, greatest = 0;
  for (auto [cell, length] : lengths) {
    sum += length;
    least = std::min(least, length);
    greatest = std::max(greatest, length);
  }
  EXPECT_NEAR(sum / kColumns, 1, 1e-3);
  EXPECT_GT(least, 0.4 - 1e-3);
  EXPECT_LT(least, 0.5);
  EXPECT_LT(greatest, 1.6 + 1e-3);
  EXPECT_GT(greatest, 1.5);
}

// Each header has its middle over the middle of a stretcher.
TEST(FlemishGridTest, HeadersStandOverStretchers) {
  Grid grid{"", "flemish_grid", {{"rows", Ints({4})}, {"columns", Ints({3})}}, {}, {}};
  std::vector<Vector> low, high;
  for (int i = 0; i < 3000; ++i) {
    low.push_back({(i + 0.5) / 3000, 0.1});
    high.push_back({(i + 0.5) / 3000, 0.3});
  }
  Tiling a = Evaluate(grid, true, low), b = Evaluate(grid, true, high);
  int middles = 0;
  for (size_t i = 0; i < low.size(); ++i) {
    EXPECT_EQ(a.Size(i).x > 0.17, a.CellOf(i).first % 2 == 0);
    if (a.CellOf(i).first % 2 == 1 && std::abs(a.Local(i).x - 0.5) < 0.005) {
      EXPECT_EQ(b.CellOf(i).first % 2, 0);
      EXPECT_NEAR(b.Local(i).x, 0.5, 0.006);
      ++middles;
    }
  }
  EXPECT_GE(middles, 3);
}

// A regular hexagon or octagon has all its sides at the same distance from its middle.
TEST(PolygonGridsTest, RegularOnesHaveEqualSides) {
  Grid octagons{"", "octagon_square_grid", {{"rows", Ints({4})}, {"columns", Ints({4})}}, {}, {}};
  Tiling square = Evaluate(octagons, false, {{0.25, 0.25}});
  Tiling octagon = Evaluate(octagons, false, {{0.125, 0.125}});
  EXPECT_NEAR(octagon.Edge(0), 0.125, 1e-6);
  double side = 0.25 * (std::sqrt(2.0) - 1);  // of an octagon with a width of 0.25
  EXPECT_NEAR(square.Size(0).x, side, 1e-6);
  EXPECT_NEAR(square.Edge(0), side / 2, 1e-6);
}

}  // namespace
}  // namespace texgraph::blocks
