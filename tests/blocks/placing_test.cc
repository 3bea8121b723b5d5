// SPDX-License-Identifier: Apache-2.0
// Patterns that are moved, turned and scaled in their tiles, that reach over them, and that a map
// of sprites places: against references in double precision and brute force over all tiles.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using Cell = std::pair<int32_t, int32_t>;

// --- tile_transform ----------------------------------------------------------------------------

struct Pose {
  Point position;
  double scale, degrees;
};

// Where the place `t` of a tile of the given size is in the pattern, in double: half the box around
// the turned pattern keeps it inside, h = s / 2 (|cos| + |sin| times the ratio of the sides).
Point InPattern(Point t, Pose pose, Point size, bool inside) {
  const double a = pose.degrees * std::numbers::pi / 180, c = std::cos(a), s = std::sin(a);
  Point middle = pose.position;
  double scale = pose.scale;
  if (inside) {
    const Point box{std::fabs(c) + std::fabs(s) * size.y / size.x,
                    std::fabs(c) + std::fabs(s) * size.x / size.y};
    scale = std::fmin(scale, std::fmin(1 / box.x, 1 / box.y));
    const Point h{scale * box.x / 2, scale * box.y / 2};
    middle = {h.x + pose.position.x * (1 - 2 * h.x), h.y + pose.position.y * (1 - 2 * h.y)};
  }
  const double x = (t.x - middle.x) * size.x, y = (t.y - middle.y) * size.y;
  return {(c * x + s * y) / (scale * size.x) + 0.5, (c * y - s * x) / (scale * size.y) + 0.5};
}

const std::vector<Pose> kPoses = {{{0.5, 0.5}, 1, 0},     {{0.5, 0.5}, 0.5, 0}, {{0, 1}, 0.5, 0},
                                  {{1, 0}, 0.6, 90},      {{0, 0}, 0.5, 45},    {{1, 1}, 0.7, -30},
                                  {{0.3, 0.8}, 0.4, 200}, {{0.2, 0.9}, 3, 20}};

TEST(TileTransformTest, IsTheReferencesFrame) {
  std::vector<Vector> uv = Lattice(0, 1, 30);
  for (Cell cells : {Cell{1, 1}, {2, 5}}) {
    const Point size{1.0 / cells.first, 1.0 / cells.second};
    Values tiles =
        RunBlock("virtual_tile_map", {{"uv", Vectors(uv)}, {"cells", CellsOf({cells})}})["tile"];
    for (const Pose& pose : kPoses) {
      for (const char* place : {"inside", "anywhere"}) {
        auto outputs =
            RunBlock("tile_transform", {{"tile", tiles},
                                        {"position", Vectors({{pose.position.x, pose.position.y}})},
                                        {"scale", Floats({pose.scale})},
                                        {"rotation", Floats({pose.degrees})},
                                        {"place", Word{place}}});
        ASSERT_EQ(outputs.size(), 2u);
        const Values& inner = outputs["inner"];
        for (size_t i = 0; i < uv.size(); ++i) {
          const Point t{tiles.Float(i, 2), tiles.Float(i, 3)};
          const Point q = InPattern(t, pose, size, place == std::string("inside"));
          ASSERT_NEAR(inner.Float(i, 2), q.x, 2e-5 * (1 + 1 / pose.scale));
          ASSERT_NEAR(inner.Float(i, 3), q.y, 2e-5 * (1 + 1 / pose.scale));
          EXPECT_EQ(inner.Uint(i, 6), tiles.Uint(i, 6));
        }
      }
    }
  }
}

// Inside its tile nothing of the pattern is cut off, at any position: no point of the tile's border
// lies within it. The paper's formula cuts off all but position 0.
TEST(TileTransformTest, StaysInsideItsTile) {
  std::vector<Vector> uv;
  for (int i = 0; i <= 200; ++i) {
    for (double edge : {0.0, std::nextafter(1.0f, 0.0f) * 1.0}) {
      uv.push_back({i / 201.0, edge});
      uv.push_back({edge, i / 201.0});
    }
  }
  Values tiles =
      RunBlock("virtual_tile_map", {{"uv", Vectors(uv)}, {"cells", CellsOf({{1, 1}})}})["tile"];
  for (const Pose& pose : kPoses) {
    auto outputs =
        RunBlock("tile_transform", {{"tile", tiles},
                                    {"position", Vectors({{pose.position.x, pose.position.y}})},
                                    {"scale", Floats({pose.scale})},
                                    {"rotation", Floats({pose.degrees})},
                                    {"place", Word{"inside"}}});
    for (size_t i = 0; i < uv.size(); ++i) {
      const double x = outputs["inner"].Float(i, 2), y = outputs["inner"].Float(i, 3);
      EXPECT_LT(std::fmin(std::fmin(x, 1 - x), std::fmin(y, 1 - y)), 1e-5);
    }
  }
}

std::string Transformed(const Pose& pose, const char* place, const std::string& more = "") {
  return R"({"texgraph": 1, "nodes": {
      "tiles": {"block": "virtual_tile_map", "in": {"cells": [4, 4]}},
      "moved": {"block": "tile_transform", "in": {"tile": "tiles", "position": [)" +
         std::to_string(pose.position.x) + ", " + std::to_string(pose.position.y) +
         R"(], "scale": )" + std::to_string(pose.scale) + R"(, "rotation": )" +
         std::to_string(pose.degrees) + R"(, "place": ")" + place + "\"" + more +
         R"(}}}, "outputs": {"height": "moved.coverage"}})";
}

// O15. A pattern that is moved by so much moves by so much, wherever its tile is: no place grows
// with the number of the cell.
TEST(TileTransformTest, MovesAsFastFarAway) {
  for (double cell : {0.0, 1000.0, -524288.0, 524000.0}) {
    std::vector<Vector> uv;
    for (const Vector& p : Lattice(0, 1, 8)) uv.push_back({cell + p[0], cell + p[1]});
    Values tiles =
        RunBlock("virtual_tile_map", {{"uv", Vectors(uv)}, {"cells", CellsOf({{1, 1}})}})["tile"];
    auto at = [&](double x) {
      return RunBlock("tile_transform", {{"tile", tiles},
                                         {"position", Vectors({{x, 0.25}})},
                                         {"scale", Floats({0.5})},
                                         {"place", Word{"anywhere"}}})["inner"];
    };
    Values before = at(0.25), after = at(0.28125);
    for (size_t i = 0; i < uv.size(); ++i) {
      EXPECT_NEAR(before.Float(i, 2) - after.Float(i, 2), 0.03125 / 0.5, 1e-5) << cell;
      EXPECT_EQ(before.Float(i, 3), after.Float(i, 3)) << cell;
    }
  }
}

// O11. The area that is covered is what the patterns take, n s^2, and nothing is counted twice.
TEST(TileTransformTest, CoversItsArea) {
  const std::vector<Point> points = ScatteredPoints(20000);
  for (const Pose& pose : kPoses) {
    auto outputs = RunGraph(Transformed(pose, "inside"), points, {0.002, 0.002});
    ASSERT_EQ(outputs.size(), 1u);
    double sum = 0;
    for (size_t i = 0; i < points.size(); ++i) sum += outputs["height"].Float(i);
    const double a = pose.degrees * std::numbers::pi / 180;
    const double scale =
        std::fmin(pose.scale, 1 / (std::fabs(std::cos(a)) + std::fabs(std::sin(a))));
    EXPECT_NEAR(sum / 20000, scale * scale, 0.006) << pose.scale << " " << pose.degrees;
  }
}

// A pattern that fills its tile has no seam; from afar there is the mean, the one that is given as
// well; no scale, no pattern.
TEST(TileTransformTest, SeamsMeansAndNothing) {
  std::vector<Point> points = ScatteredPoints(500);
  for (int i = -20; i < 20; ++i) points.push_back({0.25 + i * 1e-4, 0.3});
  auto all = [&](const std::string& graph, double pixel, double wanted) {
    auto outputs = RunGraph(graph, points, {pixel, pixel});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < points.size(); ++i) {
      ASSERT_NEAR(outputs["height"].Float(i), wanted, 1e-4) << graph << pixel;
    }
  };
  for (double pixel : {0.0005, 0.01, 0.1, 1.0})
    all(Transformed({{0.5, 0.5}, 1, 0}, "inside"), pixel, 1);
  all(Transformed({{0.1, 0.7}, 0.5, 0}, "inside"), 1, 0.25);
  all(Transformed({{0.1, 0.7}, 0.5, 0}, "inside", R"(, "far": 0.4)"), 1, 0.4);
  for (const char* place : {"inside", "anywhere"}) {
    all(Transformed({{0.1, 0.7}, 0, 0}, place), 0.01, 0);
    all(Transformed({{0.1, 0.7}, -1, 0}, place), 0.01, 0);
  }
}

TEST(TileTransformTest, InSpace) {
  std::vector<Vector> uvw;
  for (int i = 0; i < 300; ++i) {
    uvw.push_back(
        {std::fmod(0.754877 * i, 1), std::fmod(0.56984 * i, 1), std::fmod(0.3141 * i, 1)});
  }
  Values cells{ir::Vector(ir::Scalar::kInt, 3), 1, {1, 1, 1}};
  Values tiles = RunBlock("virtual_tile_map", {{"uv", Vectors(uvw)}, {"cells", cells}})["tile"];
  for (const Pose& pose : kPoses) {
    auto outputs = RunBlock("tile_transform",
                            {{"tile", tiles},
                             {"position", Vectors({{pose.position.x, pose.position.y, 0.25}})},
                             {"scale", Floats({pose.scale})},
                             {"rotation", Floats({pose.degrees})},
                             {"place", Word{"inside"}}});
    ASSERT_EQ(outputs.size(), 2u);
    for (size_t i = 0; i < uvw.size(); ++i) {
      const Point q = InPattern({uvw[i][0], uvw[i][1]}, pose, {1, 1}, true);
      ASSERT_NEAR(outputs["inner"].Float(i, 3), q.x, 1e-4);
      ASSERT_NEAR(outputs["inner"].Float(i, 4), q.y, 1e-4);
      const double a = pose.degrees * std::numbers::pi / 180;
      const double s = std::fmin(pose.scale, 1 / (std::fabs(std::cos(a)) + std::fabs(std::sin(a))));
      const double middle = s / 2 + 0.25 * (1 - s);
      ASSERT_NEAR(outputs["inner"].Float(i, 5), (uvw[i][2] - middle) / s + 0.5, 1e-4);
    }
  }
}

// --- overlap -----------------------------------------------------------------------------------

uint32_t SeedOf(const Values& tiles, size_t i) { return tiles.Uint(i, 6); }

// O11, O13. Boxes that are moved at random and reach over their tiles: the same as when all tiles
// are asked, the last one in the order of rows and columns on top.
TEST(OverlapTest, IsTheSameAsAskingAllTiles) {
  constexpr int kCells = 6;
  const std::string graph = R"({"texgraph": 1, "nodes": {
      "tiles": {"block": "virtual_tile_map", "in": {"cells": [6, 6], "toroidal": true}},
      "luck": {"block": "virtual_random_map", "in": {"tile": "tiles"}},
      "where": {"block": "xy", "in": {"vector": "luck"}},
      "moved": {"block": "tile_transform", "in": {"tile": "tiles", "position": "where",
                "scale": 0.9, "place": "anywhere"}},
      "tint": {"block": "tile_random_color", "in": {"tile": "tiles", "stream": 5}},
      "one": {"block": "rgba", "in": {"color": "tint", "alpha": "moved.coverage"}},
      "color": {"block": "overlap", "in": {"color": "one", "tile": "tiles"}}},
    "outputs": {"color": "color"}})";
  const std::vector<Point> points = ScatteredPoints(3000);
  auto outputs = RunGraph(graph, points, {1e-5, 1e-5});
  ASSERT_EQ(outputs.size(), 1u);
  std::vector<Vector> middles;
  for (int i = 0; i < kCells * kCells; ++i) {
    middles.push_back({(i % kCells + 0.5) / kCells, (i / kCells + 0.5) / kCells});
  }
  Values tiles = RunBlock("virtual_tile_map", {{"uv", Vectors(middles)},
                                               {"cells", CellsOf({{kCells, kCells}})}})["tile"];
  int covered = 0, beyond = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x * kCells, y = points[i].y * kCells;
    const int column = static_cast<int>(x), row = static_cast<int>(y);
    std::array<double, 4> wanted{};
    double nearest = 1;
    for (int dy = -2; dy <= 2; ++dy) {
      for (int dx = -2; dx <= 2; ++dx) {
        const int cx = (column + dx + kCells) % kCells, cy = (row + dy + kCells) % kCells;
        const uint32_t seed = SeedOf(tiles, static_cast<size_t>(cy * kCells + cx));
        const uint32_t bits = reference::Pcg(seed);
        const double qx = (x - (column + dx) - reference::Low16(bits)) / 0.9,
                     qy = (y - (row + dy) - reference::High16(bits)) / 0.9;
        const double depth = 0.5 - std::fmax(std::fabs(qx), std::fabs(qy));
        nearest = std::fmin(nearest, std::fabs(depth));
        if (depth <= 0) continue;
        const uint32_t tint = reference::Pcg(seed + 5);
        wanted = {reference::Low16(tint), reference::High16(tint),
                  reference::Unit24(reference::Pcg(tint)), 1};
        beyond += dx != 0 || dy != 0;
      }
    }
    if (nearest < 1e-3) continue;
    covered += wanted[3] > 0;
    for (size_t c = 0; c < 4; ++c) {
      ASSERT_NEAR(outputs["color"].Float(i, c), wanted[c], 1e-3)
          << points[i].x << " " << points[i].y;
    }
  }
  EXPECT_GT(covered, 1200);
  EXPECT_GT(beyond, 600);
}

// --- Sprites -----------------------------------------------------------------------------------

struct Sprite {
  int pattern;
  Point at;
};

// The map of one layer for each list: each sprite in the cells that its unit square touches.
ir::Texture MapOfSprites(const std::vector<std::vector<Sprite>>& layers, int columns, int rows) {
  ir::Texture map;
  map.is_array = true;
  map.sampler.filter = ir::Filter::kNearest;
  const auto cells = static_cast<uint32_t>(columns * rows);
  map.levels.push_back({static_cast<uint32_t>(columns),
                        static_cast<uint32_t>(rows),
                        static_cast<uint32_t>(layers.size()),
                        {}});
  map.levels[0].texels.assign(cells * layers.size(), {0, 0, -1, 1});
  for (size_t layer = 0; layer < layers.size(); ++layer) {
    for (const Sprite& sprite : layers[layer]) {
      for (int y = 0; y < rows; ++y) {
        for (int x = 0; x < columns; ++x) {
          const double dx = sprite.at.x - x, dy = sprite.at.y - y;
          if (dx <= -1 || dx >= 1 || dy <= -1 || dy >= 1) continue;
          map.levels[0].texels[layer * cells + static_cast<size_t>(y * columns + x)] = {
              static_cast<float>(dx), static_cast<float>(dy), static_cast<float>(sprite.pattern),
              1};
        }
      }
    }
  }
  return map;
}

const std::vector<std::vector<Sprite>> kSprites = {
    {{0, {2.25, 3.5}}, {1, {5, 5}}, {2, {0.5, 6.75}}, {1, {6.5, 0.125}}},
    {{2, {2.75, 3.25}}, {0, {4.5, 5.5}}}};

std::array<float, 4> ColorOf(int pattern) {
  return {0.25f * static_cast<float>(pattern + 1), pattern == 1 ? 1.0f : 0.0f, 0.5f, 1};
}

ir::Texture PatternsOf() {
  ir::Texture patterns;
  patterns.is_array = true;
  patterns.levels.push_back({4, 4, 3, {}});
  for (int i = 0; i < 48; ++i) patterns.levels[0].texels.push_back(ColorOf(i / 16));
  ir::BuildMipChain(patterns);
  return patterns;
}

std::map<std::string, Values> DrawSprites(const std::vector<Point>& points, double pixel,
                                          int layers) {
  return RunGraph(R"({"texgraph": 1, "textures": {"map": {"layers": ["moss.png", "soot.png"]},
      "patterns": {"layers": ["soot.png", "moss.png"]}}, "nodes": {
      "cells": {"block": "virtual_tile_map", "in": {"cells": [8, 8]}},
      "where": {"block": "explicit_positioning", "in": {"sprites": "map", "tile": "cells"}},
      "inner": {"block": "tile_uv", "in": {"tile": "where.inner"}},
      "uv2": {"block": "components", "in": {"vector": "inner"}},
      "told": {"block": "combine3", "in": {"x": "uv2.x", "y": "uv2.y", "z": "where.pattern"}},
      "color": {"block": "texture_sprites", "in": {"sprites": "map", "patterns": "patterns",
                "tile": "cells", "layers": )" +
                      std::to_string(layers) + R"(}}},
    "outputs": {"color": "color", "normal": "told", "height": "where.coverage"}})",
                  points, {pixel, pixel}, 1e-4, PictureFolder(),
                  {{"map", MapOfSprites(kSprites, 8, 8)}, {"patterns", PatternsOf()}});
}

TEST(TextureSpritesTest, SpritesAreWhereTheListHasThem) {
  const std::vector<Point> points = ScatteredPoints(4000);
  for (int layers : {1, 2, 3}) {
    auto outputs = DrawSprites(points, 1e-5, layers);
    ASSERT_EQ(outputs.size(), 3u);
    int seen = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const double x = points[i].x * 8, y = points[i].y * 8;
      std::array<float, 4> wanted{};
      bool near_border = false;
      for (int layer = 0; layer < std::min(layers, 2); ++layer) {
        for (const Sprite& sprite : kSprites[static_cast<size_t>(layer)]) {
          const double qx = x - sprite.at.x, qy = y - sprite.at.y;
          const double depth = std::fmin(std::fmin(qx, 1 - qx), std::fmin(qy, 1 - qy));
          near_border = near_border || std::fabs(depth) < 1e-3;
          if (depth <= 0) continue;
          wanted = ColorOf(sprite.pattern);
          if (layer > 0) continue;
          EXPECT_NEAR(outputs["normal"].Float(i, 0), qx, 1e-4);
          EXPECT_NEAR(outputs["normal"].Float(i, 1), qy, 1e-4);
          EXPECT_EQ(outputs["normal"].Float(i, 2), sprite.pattern);
        }
      }
      if (near_border) continue;
      seen += wanted[3] > 0;
      for (size_t c = 0; c < 4; ++c) ASSERT_NEAR(outputs["color"].Float(i, c), wanted[c], 1e-4);
    }
    EXPECT_GT(seen, 150);
  }
}

// Near and far the sprites of a layer cover as much as they are many: four of 64 cells.
TEST(ExplicitPositioningTest, CoversAsMuchAsThereAreSprites) {
  const std::vector<Point> points = ScatteredPoints(40000);
  for (double pixel : {1e-4, 0.01, 0.03, 0.2, 1.0}) {
    auto outputs = DrawSprites(points, pixel, 1);
    ASSERT_EQ(outputs.size(), 3u);
    double sum = 0;
    for (size_t i = 0; i < points.size(); ++i) sum += outputs["height"].Float(i);
    EXPECT_NEAR(sum / 40000, 4 / 64.0, 0.002) << pixel;
  }
}

// The random bits and the cell are the sprite's own, all over it; a layer that there is not is
// empty.
TEST(ExplicitPositioningTest, ASpriteHasOneSeed) {
  const ir::Texture map = MapOfSprites(kSprites, 8, 8);
  std::vector<Vector> uv;
  for (const Vector& p : Lattice(0.01, 0.99, 20)) {
    uv.push_back({(2.25 + p[0]) / 8, (3.5 + p[1]) / 8});
  }
  Values tiles =
      RunBlock("virtual_tile_map", {{"uv", Vectors(uv)}, {"cells", CellsOf({{8, 8}})}})["tile"];
  auto outputs = RunBlock("explicit_positioning", {{"sprites", map}, {"tile", tiles}});
  auto other =
      RunBlock("explicit_positioning", {{"sprites", map}, {"tile", tiles}, {"layer", Ints({2})}});
  ASSERT_EQ(outputs.size() + other.size(), 6u);
  for (size_t i = 0; i < uv.size(); ++i) {
    EXPECT_EQ(outputs["pattern"].Int(i), 0);
    EXPECT_EQ(outputs["inner"].Int(i, 0), 2);
    EXPECT_EQ(outputs["inner"].Int(i, 1), 4);
    EXPECT_EQ(SeedOf(outputs["inner"], i), SeedOf(outputs["inner"], 0));
    EXPECT_EQ(other["pattern"].Int(i), -1);
    EXPECT_EQ(other["coverage"].Float(i), 0);
  }
}

}  // namespace
}  // namespace texgraph::blocks
