// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Cell = std::pair<int32_t, int32_t>;

// A Tile in Values: cell, local, size, seed.
Cell CellOf(const Values& tiles, size_t i) { return {tiles.Int(i, 0), tiles.Int(i, 1)}; }
double LocalX(const Values& tiles, size_t i) { return tiles.Float(i, 2); }
double LocalY(const Values& tiles, size_t i) { return tiles.Float(i, 3); }
uint32_t SeedOf(const Values& tiles, size_t i) { return tiles.Uint(i, 6); }

struct Grid {
  int32_t rows = 5;
  int32_t columns = 3;
  double offset = 0.5;
  double jitter = 0;
  bool toroidal = false;
};

Values Tiles(const Grid& grid, const std::vector<Vector>& uv) {
  auto outputs = RunBlock("brick_grid", {{"uv", Vectors(uv)},
                                         {"rows", Ints({grid.rows})},
                                         {"columns", Ints({grid.columns})},
                                         {"row_offset", Floats({grid.offset})},
                                         {"row_jitter", Floats({grid.jitter})},
                                         {"seed", Ints({9})},
                                         {"toroidal", Bools({grid.toroidal})}});
  EXPECT_EQ(outputs.size(), 1u);
  return outputs.empty() ? Values{} : outputs["tile"];
}

// O34. Every point of one brick has the same number and the same seed, and it runs from end to end:
// walking along a row, the number changes where the local coordinate starts again, and only there.
TEST(BrickGridTest, OneIdentityForEachBrick) {
  for (const Grid& grid : {Grid{}, Grid{8, 4, 0.25, 0, false}, Grid{7, 5, 0.5, 1, false},
                           Grid{6, 4, 0.3, 0.7, true}}) {
    constexpr int kSide = 200;
    Values tiles = Tiles(grid, Lattice(-1, 2, kSide));
    std::map<Cell, uint32_t> seeds;
    std::set<uint32_t> different;
    for (size_t i = 0; i < tiles.count; ++i) {
      auto [entry, is_new] = seeds.emplace(CellOf(tiles, i), SeedOf(tiles, i));
      ASSERT_EQ(entry->second, SeedOf(tiles, i));
      if (is_new) {
        EXPECT_TRUE(different.insert(SeedOf(tiles, i)).second);
      }
      if (i % kSide == 0) {
        continue;
      }
      bool same_brick = LocalX(tiles, i) > LocalX(tiles, i - 1);
      EXPECT_EQ(CellOf(tiles, i) == CellOf(tiles, i - 1), same_brick);
      EXPECT_EQ(SeedOf(tiles, i) == SeedOf(tiles, i - 1), same_brick);
    }
  }
}

TEST(BrickGridTest, SeedsAreTheHashOfTheCell) {
  Values tiles = Tiles({}, Lattice(-2, 2, 40));
  for (size_t i = 0; i < tiles.count; ++i) {
    auto [column, row] = CellOf(tiles, i);
    EXPECT_EQ(SeedOf(tiles, i), reference::CellHash(column, row, 9));
  }
}

TEST(BrickGridTest, BricksAreWhereTheyShouldBe) {
  Grid grid{4, 2, 0.25, 0, false};
  std::vector<Vector> uv = Lattice(-1, 2, 60);
  Values tiles = Tiles(grid, uv);
  for (size_t i = 0; i < uv.size(); ++i) {
    double y = uv[i][1] * 4;
    int row = static_cast<int>(std::floor(y));
    double x = uv[i][0] * 2 + ((row % 2 + 2) % 2 == 1 ? 0.25 : 0);
    EXPECT_EQ(CellOf(tiles, i), Cell(static_cast<int32_t>(std::floor(x)), row));
    EXPECT_NEAR(LocalX(tiles, i), x - std::floor(x), 1e-5);
    EXPECT_NEAR(LocalY(tiles, i), y - std::floor(y), 1e-5);
    EXPECT_FLOAT_EQ(tiles.Float(i, 4), 0.5f);
    EXPECT_FLOAT_EQ(tiles.Float(i, 5), 0.25f);
  }
}

// Jitter moves whole rows, each by less than the given part of a brick, and not all by the same.
TEST(BrickGridTest, JitterMovesRows) {
  Grid still{32, 4, 0, 0, false}, moved{32, 4, 0, 0.4, false};
  std::vector<Vector> uv = Lattice(0, 1, 96);
  Values a = Tiles(still, uv), b = Tiles(moved, uv);
  std::map<int32_t, double> shifts;
  for (size_t i = 0; i < uv.size(); ++i) {
    double shift = b.Int(i, 0) + LocalX(b, i) - a.Int(i, 0) - LocalX(a, i);
    EXPECT_GE(shift, -1e-5);
    EXPECT_LT(shift, 0.4);
    auto [entry, is_new] = shifts.emplace(a.Int(i, 1), shift);
    EXPECT_NEAR(entry->second, shift, 1e-4);
  }
  double low = 1, high = 0;
  for (auto [row, shift] : shifts) {
    low = std::min(low, shift);
    high = std::max(high, shift);
  }
  EXPECT_LT(low, 0.05);
  EXPECT_GT(high, 0.35);
}

// O35. A toroidal grid repeats with every unit; then a texture of it has no border.
TEST(BrickGridTest, ToroidalGridsRepeat) {
  for (Grid grid : {Grid{6, 4, 0.5, 0.3, true}, Grid{5, 7, 0.5, 0, true}}) {
    std::vector<Vector> uv = Lattice(0, 1, 50);
    Values here = Tiles(grid, uv);
    for (Vector by : {Vector{1, 0}, Vector{0, 1}, Vector{-3, -2}}) {
      std::vector<Vector> moved = uv;
      for (Vector& p : moved) {
        p = {p[0] + by[0], p[1] + by[1]};
      }
      Values there = Tiles(grid, moved);
      for (size_t i = 0; i < uv.size(); ++i) {
        ASSERT_EQ(CellOf(here, i), CellOf(there, i));
        ASSERT_EQ(SeedOf(here, i), SeedOf(there, i));
        ASSERT_NEAR(LocalX(here, i), LocalX(there, i), 1e-4);
      }
    }
    for (size_t i = 0; i < uv.size(); ++i) {
      EXPECT_GE(here.Int(i, 0), 0);
      EXPECT_LT(here.Int(i, 0), grid.columns);
    }
    // The brick that the border u = 0 cuts is one brick on both sides.
    Values left = Tiles(grid, {{0.0005, 0.3}}), right = Tiles(grid, {{0.9995, 0.3}});
    if (LocalX(left, 0) > 0.01) {
      EXPECT_EQ(SeedOf(left, 0), SeedOf(right, 0));
    }
  }
}

TEST(WrapCellTest, IsTheFlooredRemainder) {
  std::vector<int32_t> cells = {
      std::numeric_limits<int32_t>::min(), -1000001, -8, -7, -1, 0, 1, 6, 7, 1000003,
      std::numeric_limits<int32_t>::max()};
  for (int32_t count : {1, 2, 7, 100, 4096}) {
    auto outputs = RunBlock("wrap_cell", {{"cell", Ints(cells)}, {"count", Ints({count})}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < cells.size(); ++i) {
      int64_t wanted = ((int64_t{cells[i]} % count) + count) % count;
      EXPECT_EQ(outputs["result"].Int(i), wanted) << cells[i] << " " << count;
    }
  }
}

Values SomeTiles(size_t count) {
  std::vector<Vector> uv;
  for (size_t i = 0; i < count; ++i) {
    uv.push_back({static_cast<double>(i) + 0.5, 0.5});
  }
  return Tiles({1, 1, 0, 0, false}, uv);
}

TEST(TileRandomTest, SpreadEvenlyBetweenItsLimits) {
  Values tiles = SomeTiles(20000);
  auto numbers =
      RunBlock("tile_random", {{"tile", tiles}, {"low", Floats({-2})}, {"high", Floats({6})}});
  auto colors =
      RunBlock("tile_random_color",
               {{"tile", tiles}, {"low", Vectors({{0, 1, 2}})}, {"high", Vectors({{1, 1, 4}})}});
  ASSERT_EQ(numbers.size() + colors.size(), 2u);
  std::array<int, 8> counts{};
  double sum = 0;
  for (size_t i = 0; i < tiles.count; ++i) {
    float value = numbers["result"].Float(i);
    ASSERT_GE(value, -2.0f);
    ASSERT_LE(value, 6.0f);
    ++counts[std::min<size_t>(7, static_cast<size_t>(value + 2))];
    EXPECT_EQ(colors["result"].Float(i, 1), 1.0f);
    sum += colors["result"].Float(i, 2);
  }
  for (int count : counts) {
    EXPECT_NEAR(count, 2500, 5 * std::sqrt(2500 * 7 / 8.0));
  }
  EXPECT_NEAR(sum / 20000, 3, 0.03);
}

TEST(TileChoiceTest, EveryNumberEquallyOften) {
  Values tiles = SomeTiles(21000);
  auto outputs = RunBlock("tile_choice", {{"tile", tiles}, {"count", Ints({7})}});
  ASSERT_EQ(outputs.size(), 1u);
  std::array<int, 7> counts{};
  for (size_t i = 0; i < tiles.count; ++i) {
    int32_t choice = outputs["result"].Int(i);
    ASSERT_GE(choice, 0);
    ASSERT_LT(choice, 7);
    ++counts[static_cast<size_t>(choice)];
  }
  for (int count : counts) {
    EXPECT_NEAR(count, 3000, 5 * std::sqrt(3000 * 6 / 7.0));
  }
}

TEST(TileWeightedChoiceTest, EveryNumberAsOftenAsItsWeight) {
  constexpr int kTiles = 20000;
  Values tiles = SomeTiles(kTiles);
  for (const Vector& weights : {Vector{1, 1, 1, 1}, Vector{5, 0, 3, 2}, Vector{0, 0, 0.25, 0},
                                Vector{0, 7, 0, 1}, Vector{1e-3, 2e-3, 3e-3, 0}}) {
    auto outputs =
        RunBlock("tile_weighted_choice", {{"tile", tiles}, {"weights", Vectors({weights})}});
    ASSERT_EQ(outputs.size(), 1u);
    std::array<int, 4> counts{};
    for (size_t i = 0; i < tiles.count; ++i) {
      int32_t choice = outputs["result"].Int(i);
      ASSERT_TRUE(choice >= 0 && choice < 4);
      ++counts[static_cast<size_t>(choice)];
    }
    double sum = weights[0] + weights[1] + weights[2] + weights[3];
    for (size_t k = 0; k < 4; ++k) {
      double p = weights[k] / sum;
      EXPECT_NEAR(counts[k], kTiles * p, 5 * std::sqrt(kTiles * p * (1 - p))) << k;
    }
  }
}

TEST(TilePartsTest, AreTheTiles) {
  Values tiles = Tiles({}, {{0.3, 0.7}});
  auto parts = RunBlock("tile_parts", {{"tile", tiles}});
  auto uv = RunBlock("tile_uv", {{"tile", tiles}});
  ASSERT_EQ(parts.size() + uv.size(), 5u);
  EXPECT_EQ(parts["cell"].Int(0, 1), tiles.Int(0, 1));
  EXPECT_EQ(parts["local"].Float(0, 0), tiles.Float(0, 2));
  EXPECT_EQ(parts["size"].Float(0, 1), tiles.Float(0, 5));
  EXPECT_EQ(parts["seed"].Uint(0), SeedOf(tiles, 0));
  EXPECT_EQ(uv["result"].Float(0, 1), tiles.Float(0, 3));
}

TEST(TileDistanceTest, IsInTextureSpace) {
  // A brick of 1/3 by 1/5; from its middle the upper and lower edges are nearest.
  Values tiles = Tiles({5, 3, 0, 0, false}, {{0.5, 0.5}, {0.34, 0.5}});
  auto outputs = RunBlock("tile_distance", {{"tile", tiles}});
  ASSERT_EQ(outputs.size(), 1u);
  EXPECT_NEAR(outputs["result"].Float(0), 0.1, 1e-6);
  EXPECT_NEAR(outputs["result"].Float(1), 0.34 - 1.0 / 3, 1e-6);
}

// The joints' mask from a graph, at points with a given pixel.
Values Mortar(const std::string& grid, double width, const std::vector<Point>& points,
              double pixel) {
  std::string text = R"({"texgraph": 1, "nodes": {"grid": {"block": "brick_grid", "in": )" + grid +
                     R"(}, "joint": {"block": "mortar", "in": {"tile": "grid", "width": )" +
                     std::to_string(width) + R"(}}}, "outputs": {"height": "joint"}})";
  auto outputs = RunGraph(text, points, {pixel, pixel});
  return outputs.empty() ? Floats(std::vector<double>(points.size(), NAN)) : outputs["height"];
}

// O37
TEST(MortarTest, IsTheBoxIntegralAtEveryPixelSize) {
  constexpr double kWidth = 0.02;
  for (double pixel : {0.0007, 0.01, 0.05, 0.3, 1.7}) {
    std::vector<Point> points;
    for (int i = 0; i < 400; ++i) {
      points.push_back({std::fmod(0.7548776662 * i, 3) - 1, std::fmod(0.5698402910 * i, 3) - 1});
    }
    Values seen = Mortar(R"({"rows": 6, "columns": 3, "row_offset": 0})", kWidth, points, pixel);
    for (size_t i = 0; i < points.size(); ++i) {
      auto brick = [&](double p, int count) {
        double joint = kWidth * count / 2;
        return reference::OverlapWithCells((p - pixel / 2) * count, (p + pixel / 2) * count, joint,
                                           1 - joint) /
               (pixel * count);
      };
      double wanted = 1 - brick(points[i].x, 3) * brick(points[i].y, 6);
      ASSERT_NEAR(seen.Float(i), wanted, 0.003)
          << points[i].x << " " << points[i].y << " " << pixel;
    }
  }
}

// O37. Measured along lines through the middle of bricks: the same width in both directions, for
// long bricks and for square ones.
TEST(MortarTest, WidthIsConstantInTextureSpace) {
  constexpr double kWidth = 0.015;
  constexpr int kSamples = 30000;
  for (auto [rows, columns] : {std::pair{12, 3}, {4, 4}, {3, 9}}) {
    std::string grid = "{\"rows\": " + std::to_string(rows) +
                       ", \"columns\": " + std::to_string(columns) + ", \"row_offset\": 0}";
    std::vector<Point> across, up;
    for (int i = 0; i < kSamples; ++i) {
      across.push_back({(i + 0.5) / kSamples, 0.5 / rows});
      up.push_back({0.5 / columns, (i + 0.5) / kSamples});
    }
    Values a = Mortar(grid, kWidth, across, 1e-4), b = Mortar(grid, kWidth, up, 1e-4);
    double length_across = 0, length_up = 0;
    for (size_t i = 0; i < kSamples; ++i) {
      length_across += a.Float(i) / kSamples;
      length_up += b.Float(i) / kSamples;
    }
    EXPECT_NEAR(length_across / columns, kWidth, 3e-4) << grid;
    EXPECT_NEAR(length_up / rows, kWidth, 3e-4) << grid;
  }
}

// The frame's middle is one place for all points of a tile, also where the frame is turned, and it
// lies in the tile.
TEST(TileCenterTest, IsOnePlaceForEachTile) {
  for (const char* grid : {"brick_grid", "herringbone_grid", "octagon_square_grid", "hexagon_grid",
                           "triangle_grid", "basket_weave_grid", "flemish_grid"}) {
    std::vector<Point> points;
    for (const Vector& p : Lattice(-1, 1, 50)) points.push_back({p[0], p[1]});
    auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
        "grid": {"block": ")" + std::string(grid) +
                                R"("},
        "parts": {"block": "tile_parts", "in": {"tile": "grid.tile"}},
        "number": {"block": "tile_random", "in": {"tile": "grid.tile"}},
        "center": {"block": "tile_center", "in": {"tile": "grid.tile"}},
        "there": {"block": ")" + std::string(grid) +
                                R"(", "in": {"uv": "center"}},
        "same": {"block": "tile_random", "in": {"tile": "there.tile"}},
        "c": {"block": "components", "in": {"vector": "center"}},
        "told": {"block": "combine4", "in": {"x": "c.x", "y": "c.y", "z": "number", "w": "same"}}},
      "outputs": {"color": "told"}})",
                            points, {1e-4, 1e-4});
    ASSERT_EQ(outputs.size(), 1u) << grid;
    const Values& color = outputs["color"];
    std::map<float, Point> centers;
    for (size_t i = 0; i < points.size(); ++i) {
      // A triangle's frame has its middle inside as well.
      EXPECT_EQ(color.Float(i, 2), color.Float(i, 3)) << grid;
      const Point center{color.Float(i, 0), color.Float(i, 1)};
      auto [known, is_new] = centers.emplace(color.Float(i, 2), center);
      EXPECT_NEAR(known->second.x, center.x, 1e-5) << grid;
      EXPECT_NEAR(known->second.y, center.y, 1e-5) << grid;
    }
    EXPECT_GT(centers.size(), 20u) << grid;
  }
}

// A mask of where elements are: each tile is there or not as a whole, as often as the mask says.
TEST(TileImageTest, MasksWholeTiles) {
  const std::string graph = R"({"texgraph": 1, "textures": {"mask": {"file": "moss.png"}},
    "nodes": {
      "grid": {"block": "brick_grid", "in": {"rows": 16, "columns": 16}},
      "map": {"block": "tile_image", "in": {"picture": "mask", "tile": "grid"}},
      "share": {"block": "channel", "in": {"color": "map", "name": "a"}},
      "layer": {"block": "layer", "in": {"tile": "grid", "image": [1, 1, 1, 1], "chance": "share"}},
      "there": {"block": "channel", "in": {"color": "layer.color", "name": "a"}}},
    "outputs": {"height": "share", "opacity": "there"}})";
  std::vector<Point> points;
  // Several points of each of 256 tiles.
  for (int i = 0; i < 4096; ++i) {
    const int column = i % 16, row = i / 16 % 16, place = i / 256;
    const double shift = 0.5 * (row & 1);
    points.push_back(
        {(column + 0.1 + 0.2 * (place % 4) - shift) / 16, (row + 0.1 + 0.2 * (place / 4)) / 16});
  }
  auto outputs = RunGraph(graph, points, {1e-4, 1e-4});
  ASSERT_EQ(outputs.size(), 2u);
  double wanted = 0, drawn = 0;
  float low = 1, high = 0;
  for (int i = 0; i < 4096; ++i) {
    EXPECT_NEAR(outputs["height"].Float(i), outputs["height"].Float(i % 256), 1e-3);
    EXPECT_EQ(outputs["opacity"].Float(i), outputs["opacity"].Float(i % 256));
    if (i >= 256) continue;
    wanted += outputs["height"].Float(i);
    drawn += outputs["opacity"].Float(i);
    low = std::min(low, outputs["height"].Float(i));
    high = std::max(high, outputs["height"].Float(i));
  }
  EXPECT_LT(low, 0.1);
  EXPECT_GT(high, 0.5);
  EXPECT_NEAR(drawn, wanted, 5 * std::sqrt(256 * 0.25));
}

// The share of a pixel that its middle's tile covers, the mean over all places of the pixel: an
// estimate, off by up to an eighth.
TEST(TileNearTest, IsAboutTheShareOfTheMiddlesTile) {
  for (double size : {0.01, 0.25, 0.5, 1.0, 2.0, 4.0, 8.0}) {
    double share = 0;
    constexpr int kSteps = 1000;
    for (int i = 0; i < kSteps; ++i) {
      const double middle = (i + 0.5) / kSteps;
      const double low = std::max(middle - size / 2, 0.0), high = std::min(middle + size / 2, 1.0);
      share += (high - low) / size / kSteps;
    }
    auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
        "grid": {"block": "brick_grid", "in": {"rows": 4, "columns": 4, "row_offset": 0}},
        "near": {"block": "tile_near", "in": {"tile": "grid"}}},
      "outputs": {"height": "near"}})",
                            {{0.3, 0.4}}, {size / 4, size / 4});
    ASSERT_EQ(outputs.size(), 1u);
    EXPECT_NEAR(outputs["height"].Float(0), share * share, 0.125) << size;
  }
}

}  // namespace
}  // namespace texgraph::blocks
