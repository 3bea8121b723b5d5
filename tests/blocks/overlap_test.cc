// SPDX-License-Identifier: Apache-2.0
// Elements that reach over the border of their tile: against a reference that looks at every tile
// far around, and by what must hold whatever the ranges are: no area is lost, and no tile too many
// is looked at.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <tuple>

#include "tests/blocks/layer_reference.h"
#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using reference::Frame;
using reference::InFrame;
using reference::Limits;
using reference::PlaceIn;

constexpr int kRows = 6, kColumns = 3, kSeed = 7;

// Of a running bond that does not repeat.
Frame BrickFrame(int column, int row) {
  const double shift = 0.5 * (row & 1);
  return {{(column + 0.5 - shift) / kColumns, (row + 0.5) / kRows},
          0,
          {1.0 / kColumns, 1.0 / kRows},
          reference::CellHash(column, row, kSeed)};
}

struct Seen {
  bool is_clear = true;  // the point is not near an edge of an element
  bool is_covered = false;
  Point q;  // in the topmost element's image
};

// Rows from the bottom up, in a row from left to right; the last one is on top.
Seen Topmost(Point p, const std::function<Frame(const Frame&)>& element_in) {
  Seen seen;
  const int row = static_cast<int>(std::floor(p.y * kRows));
  for (int y = row - 5; y <= row + 5; ++y) {
    const int column = static_cast<int>(std::floor(p.x * kColumns));
    for (int x = column - 5; x <= column + 6; ++x) {
      const Point q = InFrame(element_in(BrickFrame(x, y)), p);
      const double edge = std::fmin(0.5 - std::fabs(q.x - 0.5), 0.5 - std::fabs(q.y - 0.5));
      if (std::fabs(edge) < 2e-3) seen.is_clear = false;
      if (edge < 0) continue;
      seen.is_covered = true;
      seen.q = q;
    }
  }
  return seen;
}

// One layer, or a parent and a child; the image paints its own coordinate.
std::map<std::string, Values> Draw(const std::string& parent, const std::string& child,
                                   const std::vector<Point>& points) {
  const std::string last = child.empty() ? "parent" : "child";
  std::string text = R"({"texgraph": 1,
    "functions": {"where": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y"}}}, "outputs": {"color": "c"}}},
    "nodes": {"grid": {"block": "brick_grid", "in": {"rows": 6, "columns": 3, "seed": 7}},
      "parent": {"block": "layer", "in": {"tile": "grid", "image": "where")" +
                     parent + "}}";
  if (!child.empty()) {
    text += R"(, "child": {"block": "layer", "in": {"tile": "parent.inner", "image": "where")" +
            child + "}}";
  }
  return RunGraph(text + R"(}, "outputs": {"color": ")" + last + R"(.color"}})", points,
                  {1e-4, 1e-4}, 1e-3);
}

void ExpectTopmost(const std::map<std::string, Values>& outputs, const std::vector<Point>& points,
                   const std::function<Frame(const Frame&)>& element_in, double tolerance) {
  ASSERT_EQ(outputs.size(), 1u);
  const Values& color = outputs.at("color");
  int covered = 0, clear = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Seen seen = Topmost(points[i], element_in);
    if (!seen.is_clear) continue;
    ++clear;
    covered += seen.is_covered;
    ASSERT_NEAR(color.Float(i, 3), seen.is_covered ? 1 : 0, 1e-4)
        << points[i].x << " " << points[i].y;
    if (!seen.is_covered) continue;
    ASSERT_NEAR(color.Float(i, 0), seen.q.x, tolerance) << points[i].x << " " << points[i].y;
    ASSERT_NEAR(color.Float(i, 1), seen.q.y, tolerance) << points[i].x << " " << points[i].y;
  }
  EXPECT_GT(clear, static_cast<int>(points.size()) * 9 / 10);
  EXPECT_GT(covered, clear / 20);
}

const Limits kWide = {{0.0, -0.2}, {1.1, 0.9}, 0.5, 1.3, -60, 80, false, 2};
const char* const kWidePorts =
    R"(, "position_min": [0, -0.2], "position_max": [1.1, 0.9], "scale": [0.5, 1.3], "rotation": [-60, 80], "stream": 2)";
const Limits kChild = {{0.1, 0.2}, {0.9, 0.7}, 0.3, 0.5, -180, 180, true, 3};
const char* const kChildPorts =
    R"(, "position_min": [0.1, 0.2], "position_max": [0.9, 0.7], "scale": [0.3, 0.5], "rotation": [-180, 180], "fit": "contain", "stream": 3)";

TEST(OverlapTest, ElementsLieOnEachOtherInOrder) {
  const std::vector<Point> points = ScatteredPoints(800, -1, 1);
  ExpectTopmost(
      Draw(kWidePorts, "", points), points, [](const Frame& tile) { return PlaceIn(tile, kWide); },
      1e-3);
}

TEST(OverlapTest, ChildrenGoOverTheBorderWithTheirParents) {
  const std::vector<Point> points = ScatteredPoints(500, -1, 1);
  // Parents that stay near their tiles; their children still leave them.
  const Limits near = {{0.3, 0.3}, {0.7, 0.7}, 0.8, 1.0, -20, 20, false, 0};
  const char* const ports =
      R"(, "position_min": 0.3, "position_max": 0.7, "scale": [0.8, 1.0], "rotation": [-20, 20])";
  ExpectTopmost(
      Draw(ports, kChildPorts, points), points,
      [&](const Frame& tile) { return PlaceIn(PlaceIn(tile, near), kChild); }, 4e-3);
}

// A child whose chance is its parent's presence is there when the parent is, whoever's tile it is
// in.
TEST(OverlapTest, ChildrenCanBeLeftOutWithTheirParents) {
  const std::vector<Point> points = ScatteredPoints(600, -1, 1);
  auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
      "grid": {"block": "brick_grid", "in": {"rows": 6, "columns": 3, "seed": 7}},
      "parent": {"block": "layer", "in": {"tile": "grid", "image": [1, 1, 1, 1], "chance": 0.4,
                 "position_min": 0.2, "position_max": 0.8}},
      "child": {"block": "layer", "in": {"tile": "parent.inner", "image": [1, 1, 1, 1],
                "scale": 0.5, "stream": 1, "chance": "parent.present"}},
      "free": {"block": "layer", "in": {"tile": "parent.inner", "image": [1, 1, 1, 1],
               "scale": 0.5, "stream": 1}},
      "a": {"block": "channel", "in": {"color": "parent.color", "name": "a"}},
      "b": {"block": "channel", "in": {"color": "child.color", "name": "a"}},
      "c": {"block": "channel", "in": {"color": "free.color", "name": "a"}}},
    "outputs": {"opacity": "a", "height": "b", "roughness": "c"}})",
                          points, {1e-4, 1e-4});
  ASSERT_EQ(outputs.size(), 3u);
  int alone = 0, together = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const bool parent = outputs["opacity"].Float(i) > 0.5, child = outputs["height"].Float(i) > 0.5;
    // The child lies in the middle of its parent, and is half as large.
    EXPECT_TRUE(parent || !child) << points[i].x << " " << points[i].y;
    together += child;
    alone += outputs["roughness"].Float(i) > 0.5 && !parent;
  }
  EXPECT_GT(together, 30);
  EXPECT_GT(alone, 30);
}

// What varies by tile is asked of each tile that is looked at.
TEST(OverlapTest, OtherPortsAreThoseOfTheElementsTile) {
  const std::vector<Point> points = ScatteredPoints(400, -1, 1);
  auto outputs = RunGraph(R"({"texgraph": 1,
    "nodes": {"grid": {"block": "brick_grid", "in": {"rows": 6, "columns": 3, "seed": 7}},
      "tone": {"block": "tile_random", "in": {"tile": "grid", "stream": 4}},
      "tint": {"block": "combine3", "in": {"x": "tone", "y": "tone", "z": "tone"}},
      "moved": {"block": "layer", "in": {"tile": "grid", "image": [1, 1, 1, 1],
                "position_min": 0.8, "position_max": 0.8, "scale": 0.9, "tint": "tint"}}},
    "outputs": {"color": "moved.color"}})",
                          points, {1e-4, 1e-4});
  ASSERT_EQ(outputs.size(), 1u);
  const Limits limits = {{0.8, 0.8}, {0.8, 0.8}, 0.9, 0.9, 0, 0, false, 0};
  for (size_t i = 0; i < points.size(); ++i) {
    uint32_t seed = 0;
    const Seen seen = Topmost(points[i], [&](const Frame& tile) {
      const Frame element = PlaceIn(tile, limits);
      const Point q = InFrame(element, points[i]);
      if (q.x > 0 && q.x < 1 && q.y > 0 && q.y < 1) seed = tile.seed;
      return element;
    });
    if (!seen.is_clear || !seen.is_covered) continue;
    // tile_random with stream 4
    const double tone = reference::Unit24(reference::Pcg(seed + 4));
    ASSERT_NEAR(outputs["color"].Float(i, 0), tone, 1e-5) << points[i].x << " " << points[i].y;
  }
}

// On grids of bricks of several lengths, against what the grid itself says of tiles farther around.
TEST(OverlapTest, TilesOfAllLengthsAreFound) {
  const std::vector<Point> points = ScatteredPoints(300, -1, 1);
  const char* const kRanges =
      R"("position_min": [-0.3, 0.1], "position_max": [1.2, 1.0], "scale": [0.3, 0.8], "rotation": [-40, 70])";
  for (
      const char* grid :
      {R"("random_length_grid", "in": {"length_variation": 0.8, "rows": 5)",
       R"("random_length_grid", "in": {"length_variation": 0.3, "height_variation": 0.7, "toroidal": true)",
       R"("flemish_grid", "in": {"header": 0.25)",
       R"("flemish_grid", "in": {"header": 0.9, "toroidal": true)"}) {
    auto drawn = [&](const std::string& ports) {
      auto outputs =
          RunGraph(R"({"texgraph": 1, "nodes": {"grid": {"block": )" + std::string(grid) + R"(}},
        "layer": {"block": "layer", "in": {"tile": "grid.tile", "image": "where", )" +
                       kRanges + ports + R"(}}},
      "functions": {"where": {"inputs": {"uv": "vec2"}, "nodes": {
          "p": {"block": "components", "in": {"vector": "uv"}},
          "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y"}}}, "outputs": {"color": "c"}}},
      "outputs": {"color": "layer.color"}})",
                   points, {1e-4, 1e-4}, 1e-2);
      return outputs["color"];
    };
    const Values own = drawn(""), most = drawn(R"(, "neighbours": 3)");
    const Values cut = drawn(R"(, "neighbours": 0)");
    int covered = 0, lost = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      ASSERT_EQ(own.Float(i, 3), most.Float(i, 3)) << grid;
      if (own.Float(i, 3) > 0.5) {
        ASSERT_NEAR(own.Float(i, 0), most.Float(i, 0), 1e-5) << grid;
      }
      covered += own.Float(i, 3) > 0.5;
      lost += own.Float(i, 3) > cut.Float(i, 3) + 0.5;
    }
    EXPECT_GT(covered, 60) << grid;
    EXPECT_GT(lost, 10) << grid;
  }
}

// An element that stays in its tile is no reason to look at others, however short tiles can be.
TEST(LayerNeighboursTest, StayingInsideNeedsNone) {
  for (auto [scale, rotation, wanted] : {std::tuple{1.0, 0.0, 0}, {1.1, 0.0, 1}, {0.3, 90.0, 0}}) {
    auto outputs =
        RunGraph(R"({"texgraph": 1, "nodes": {
        "grid": {"block": "random_length_grid", "in": {"rows": 4, "columns": 4}},
        "number": {"block": "layer_neighbours", "in": {"tile": "grid.tile", "scale": )" +
                     std::to_string(scale) + R"(, "rotation": )" + std::to_string(rotation) + R"(}},
        "n": {"block": "to_float", "in": {"value": "number"}}}, "outputs": {"height": "n"}})",
                 {{0.3, 0.4}}, {1e-4, 1e-4});
    ASSERT_EQ(outputs.size(), 1u);
    EXPECT_EQ(outputs["height"].Float(0), wanted) << scale;
  }
}

// The pixels of one period, summed, have the elements' area, wherever these lie; a cut layer loses
// what sticks out.
TEST(OverlapTest, NoAreaIsLost) {
  constexpr int kSide = 60;
  std::vector<Point> pixels;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) pixels.push_back({(x + 0.5) / kSide, (y + 0.5) / kSide});
  }
  auto area = [&](const char* grid, const char* ports) {
    auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {"grid": {"block": ")" + std::string(grid) +
                                R"(", "in": {"rows": 4, "columns": 4, "toroidal": true}},
      "layer": {"block": "layer", "in": {"tile": "grid.tile", "image": [1, 1, 1, 1])" +
                                std::string(ports) + R"(}},
      "alpha": {"block": "channel", "in": {"color": "layer.color", "name": "a"}}},
    "outputs": {"opacity": "alpha"}})",
                            pixels, {1.0 / kSide, 1.0 / kSide});
    double sum = 0;
    for (size_t i = 0; i < pixels.size(); ++i) sum += outputs["opacity"].Float(i);
    return sum;
  };
  // 16 squares of 0.4 tiles, a tile being 15 pixels wide. Those that are not turned are exact.
  const double whole = 16 * 0.4 * 0.4 * 15 * 15;
  for (const char* place : {"0.5", "[0.9, 0.1]", "[1.3, 0.8]", "[-0.7, 1.6]"}) {
    const std::string ports = R"(, "scale": 0.4, "position_min": )" + std::string(place) +
                              R"(, "position_max": )" + place;
    EXPECT_NEAR(area("brick_grid", ports.c_str()), whole, 0.5) << place;
    // Turned edges are filtered as the product of two; their sum keeps the area to a few pixels.
    EXPECT_NEAR(area("brick_grid", (ports + R"(, "rotation": 30)").c_str()), whole, 0.02 * whole)
        << place;
    // A hexagon's frame is 4/3 of a row high.
    SCOPED_TRACE(place);
    EXPECT_NEAR(area("hexagon_grid", ports.c_str()), whole * 4 / 3, 0.5) << place;
    if (place == std::string("0.5")) continue;
    EXPECT_LT(area("brick_grid", (ports + R"(, "neighbours": 0)").c_str()), 0.9 * whole) << place;
  }
}

// O35: what leaves the unit square on one side comes in on the other.
TEST(OverlapTest, ToroidalLayersRepeat) {
  std::vector<Point> points = ScatteredPoints(300, -1, 1), next = points;
  for (Point& p : next) p = {p.x + 1, p.y - 2};
  const std::string text = R"({"texgraph": 1, "nodes": {
      "grid": {"block": "brick_grid", "in": {"rows": 6, "columns": 3, "toroidal": true}},
      "layer": {"block": "layer", "in": {"tile": "grid", "image": [1, 0.5, 0.25, 1])" +
                           std::string(kWidePorts) + R"(}}}, "outputs": {"color": "layer.color"}})";
  auto here = RunGraph(text, points, {1e-4, 1e-4}), there = RunGraph(text, next, {1e-4, 1e-4});
  int differ = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    // An edge may pass between two roundings of one place.
    differ += std::fabs(here["color"].Float(i, 3) - there["color"].Float(i, 3)) > 1e-2;
  }
  EXPECT_LE(differ, 2);
}

// --- How far a layer looks -----------------------------------------------------------------------

struct Ranges {
  Point position_min, position_max;
  double scale, stretch, rotation_min, rotation_max;
  bool contain;
};

// By trying poses, the extreme ones among them.
double ReachOf(const Ranges& ranges, double width, double height) {
  double reach = -1;
  const double side = std::fmin(width, height);
  const double w = ranges.scale * (ranges.contain ? side : width);
  const double h = ranges.scale * ranges.stretch * (ranges.contain ? side : height);
  for (int i = 0; i <= 2000; ++i) {
    const double degrees = reference::Mix(ranges.rotation_min, ranges.rotation_max, i / 2000.0);
    const double angle = degrees * std::numbers::pi / 180;
    const double c = std::fabs(std::cos(angle)), s = std::fabs(std::sin(angle));
    const double x = (c * w + s * h) / 2 / width, y = (s * w + c * h) / 2 / height;
    for (const Point& p : {ranges.position_min, ranges.position_max}) {
      reach = std::fmax(reach, std::fabs(p.x - 0.5) + x - 0.5);
      reach = std::fmax(reach, std::fabs(p.y - 0.5) + y - 0.5);
    }
  }
  return reach;
}

TEST(LayerNeighboursTest, AreThoseThatTheRangesNeed) {
  auto grid = RunBlock(
      "brick_grid",
      {{"uv", Vectors({{0.3, 0.4}})}, {"rows", Ints({kRows})}, {"columns", Ints({kColumns})}});
  ASSERT_FALSE(grid.empty());
  int compared = 0, counts[8] = {};
  for (int i = 0; i < 400; ++i) {
    auto at = [&](int k, double low, double high) {
      return reference::Mix(low, high, reference::Unit24(reference::Pcg(100 * i + k)));
    };
    Ranges ranges{{at(0, -0.5, 0.5), at(1, -0.5, 0.5)},
                  {at(2, 0.5, 1.5), at(3, 0.5, 1.5)},
                  at(4, 0.05, i % 4 ? 2 : 0.3),
                  i % 3 ? 1 : at(5, 0.5, 1.5),
                  i % 2 ? 0 : at(6, -180, 20),
                  i % 2 ? 0 : at(7, 20, 180),
                  i % 5 == 0};
    if (i % 4 == 0) ranges.position_min = ranges.position_max = {at(0, 0.4, 0.6), 0.5};
    const double reach = ReachOf(ranges, 1.0 / kColumns, 1.0 / kRows);
    // The poses that are tried miss the widest one by a little.
    if (std::fabs(reach - std::round(reach)) < 1e-3) continue;
    auto outputs =
        RunBlock("layer_neighbours",
                 {{"tile", grid["tile"]},
                  {"position_min", Vectors({{ranges.position_min.x, ranges.position_min.y}})},
                  {"position_max", Vectors({{ranges.position_max.x, ranges.position_max.y}})},
                  {"scale", Vectors({{0.1, ranges.scale}})},
                  {"stretch", Vectors({{0.5, ranges.stretch}})},
                  {"rotation", Vectors({{ranges.rotation_min, ranges.rotation_max}})},
                  {"fit", Word{ranges.contain ? "contain" : "stretch"}}});
    ASSERT_EQ(outputs.size(), 1u);
    const int wanted = static_cast<int>(std::ceil(std::fmax(reach, 0)));
    ASSERT_EQ(outputs["result"].Int(0), wanted) << i << ": reach " << reach;
    ++compared;
    ++counts[wanted];
  }
  EXPECT_GT(compared, 300);
  for (int n = 0; n <= 2; ++n) EXPECT_GT(counts[n], 5) << n;
}

// `layer_element` alone, in one tile: the same as a layer that does not look around.
TEST(LayerElementTest, IsWhatALayerDrawsInOneTile) {
  const std::vector<Point> points = ScatteredPoints(200, -1, 1);
  const std::string ports =
      R"("tile": "grid", "scale": [0.5, 0.9], "rotation": [-30, 30], "opacity": [0.5, 1])";
  auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
      "grid": {"block": "brick_grid", "in": {"rows": 6, "columns": 3}},
      "layer": {"block": "layer", "in": {"image": [1, 1, 1, 1], "neighbours": 0, )" +
                              ports + R"(}},
      "element": {"block": "layer_element", "in": {)" +
                              ports + R"(}}},
    "outputs": {"color": "layer.color", "opacity": "element.alpha"}})",
                          points, {1e-3, 1e-3});
  ASSERT_EQ(outputs.size(), 2u);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(outputs["color"].Float(i, 3), outputs["opacity"].Float(i));
  }
}

}  // namespace
}  // namespace texgraph::blocks
