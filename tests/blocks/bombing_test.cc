// SPDX-License-Identifier: Apache-2.0
// Bombing: against a reference that looks at every cell far around, and by what must hold whatever
// the ranges are: no copy is clipped, no cell too many is looked at, speeds have a bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "tests/blocks/bombing_reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using reference::CopiesAt;
using reference::Copy;
using reference::CopyBits;
using reference::Plane;

constexpr double kScale = 8;  // cells for each unit

// The image paints its own coordinate. Emission has a random number of the copy on top, how much is
// covered, and the copy's number in its cell.
std::map<std::string, Values> Draw(const std::string& ports, const std::vector<Point>& points,
                                   double pixel = 1e-5, const std::string& more_nodes = "") {
  const std::string text = R"({"texgraph": 1,
    "functions": {"where": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y"}}}, "outputs": {"color": "c"}}},
    "nodes": {)" + more_nodes +
                           R"("bomb": {"block": "bomb", "in": {"image": "where")" + ports + R"(}},
      "luck": {"block": "tile_random", "in": {"tile": "bomb.tile"}},
      "number": {"block": "to_float", "in": {"value": "bomb.index"}},
      "e": {"block": "combine3", "in": {"x": "luck", "y": "bomb.covered", "z": "number"}}},
    "outputs": {"color": "bomb.color", "emission": "e"}})";
  return RunGraph(text, points, {pixel, pixel}, 1e-3);
}

// Which of two copies is on top; the first of the two comes before the second in its order.
using IsAbove = std::function<bool(const Copy& later, const Copy& earlier)>;

void ExpectTopmost(const std::string& ports, const Plane& plane, const IsAbove& is_above) {
  const std::vector<Point> points = ScatteredPoints(700, -1.5, 1.5);
  auto outputs = Draw(ports, points);
  ASSERT_EQ(outputs.size(), 2u);
  int clear = 0, covered = 0, contested = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    // Without the copies at whose rims rounding decides, and with them.
    const Copy *top = nullptr, *perhaps = nullptr;
    const std::vector<Copy> copies = CopiesAt(plane, {points[i].x * kScale, points[i].y * kScale});
    for (const Copy& copy : copies) {
      if (copy.edge < -2e-3) continue;
      if (!perhaps || is_above(copy, *perhaps)) perhaps = &copy;
      if (copy.edge < 2e-3) continue;
      contested += top != nullptr;
      if (!top || is_above(copy, *top)) top = &copy;
    }
    if (top != perhaps) continue;
    ++clear;
    covered += top != nullptr;
    ASSERT_NEAR(outputs["emission"].Float(i, 1), top ? 1 : 0, 1e-4) << i;
    if (!top) continue;
    ASSERT_NEAR(outputs["color"].Float(i, 0), top->q.x, 1e-3) << i;
    ASSERT_NEAR(outputs["color"].Float(i, 1), top->q.y, 1e-3) << i;
    ASSERT_NEAR(outputs["emission"].Float(i, 0), reference::Unit24(reference::Pcg(top->seed)), 1e-6)
        << i;
    ASSERT_EQ(outputs["emission"].Float(i, 2), top->index) << i;
  }
  EXPECT_GT(clear, 600);
  EXPECT_GT(covered, 100);
  EXPECT_GT(contested, 20);
}

bool IsOfHigherRank(const Copy& a, const Copy& b) { return a.rank > b.rank; }

// O13.
TEST(BombTest, TheHighestRankWins) {
  ExpectTopmost("", {}, IsOfHigherRank);
  ExpectTopmost(R"(, "shape": "disc", "seed": 3)", {.is_disc = true, .seed = 3}, IsOfHigherRank);
  ExpectTopmost(R"(, "size": [0.4, 1.7], "rotation": [-30, 200], "copies": 2, "seed": 9)",
                {.size_min = 0.4,
                 .size_max = 1.7,
                 .rotation_min = -30,
                 .rotation_max = 200,
                 .copies = 2,
                 .seed = 9},
                IsOfHigherRank);
  ExpectTopmost(R"(, "shape": "disc", "size": [1, 2.5], "jitter": 2, "density": 0.4)",
                {.jitter = 2, .size_min = 1, .size_max = 2.5, .is_disc = true, .density = 0.4},
                IsOfHigherRank);
}

// O12. Specks, and copies that reach as far as eight cells allow; more turns than one.
TEST(BombTest, AreAsSmallAndLargeAndTurnedAsTheyShould) {
  ExpectTopmost(R"(, "size": [0.02, 7], "jitter": 1, "seed": 2)",
                {.size_min = 0.02, .size_max = 7, .seed = 2}, IsOfHigherRank);
  ExpectTopmost(
      R"(, "size": [3.4, 4.2], "rotation": [-1000, 1000], "seed": 5)",
      {.size_min = 3.4, .size_max = 4.2, .rotation_min = -1000, .rotation_max = 1000, .seed = 5},
      IsOfHigherRank);
}

TEST(BombTest, MovesEverySecondRowOfHexagons) {
  ExpectTopmost(R"(, "grid": "hexagon", "jitter": 0.4, "shape": "disc")",
                {.jitter = 0.4, .is_disc = true, .is_hexagonal = true}, IsOfHigherRank);
  ExpectTopmost(R"(, "grid": "hexagon", "size": [0.4, 1.7], "rotation": [-30, 200], "seed": 9)",
                {.size_min = 0.4,
                 .size_max = 1.7,
                 .rotation_min = -30,
                 .rotation_max = 200,
                 .seed = 9,
                 .is_hexagonal = true},
                IsOfHigherRank);
}

TEST(BombTest, LeavesOutCopiesThatAreTooNear) {
  ExpectTopmost(R"(, "spacing": 0.6, "copies": 3, "size": 1.2)",
                {.size_min = 1.2, .size_max = 1.2, .copies = 3, .spacing = 0.6}, IsOfHigherRank);
  ExpectTopmost(R"(, "spacing": 1, "jitter": 0.8, "size": 2.4, "grid": "hexagon", "seed": 3)",
                {.jitter = 0.8,
                 .size_min = 2.4,
                 .size_max = 2.4,
                 .seed = 3,
                 .is_hexagonal = true,
                 .spacing = 1},
                IsOfHigherRank);
}

// O11. Discs as wide as the spacing touch and do not overlap: nowhere is their sum more than one of
// them. Of points anywhere, m others in reach of each in the mean, (1 - exp(-m)) / m stay (Matern
// 1960, hard core of the second kind). Here m is less than n times the area, since a copy is no
// rival of its own: by the part of the disc that lies in its cell, pi r^2 - 8/3 r^3 + r^4 / 2 in
// the mean.
TEST(BombTest, SpacedDiscsDoNotOverlap) {
  const std::vector<Point> points = ScatteredPoints(4000, -1.5, 1.5);
  for (const char* text : {R"("spacing": 0.5, "size": 0.5)", R"("spacing": 0, "size": 0.5)"}) {
    const std::string ports = std::string(R"(, "copies": 4, "shape": "disc", "edges": false,
      "meet": "sum", "background": [0, 0, 0, 1], "tint": 1, )") +
                              text;
    const std::string graph = R"({"texgraph": 1,
      "nodes": {"white": {"block": "rgba", "in": {"color": 1}},
        "bomb": {"block": "bomb", "in": {"image": "white")" +
                              ports + R"(}}},
      "outputs": {"color": "bomb.color"}})";
    auto outputs = RunGraph(graph, points, {1e-5, 1e-5}, 1e-3);
    const bool is_spaced = ports.find("\"spacing\": 0.5") != std::string::npos;
    double most = 0, sum = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      most = std::max<double>(most, outputs["color"].Float(i));
      sum += outputs["color"].Float(i);
    }
    const double share = sum / static_cast<double>(points.size());
    const double area = std::numbers::pi * 0.25;
    const auto covered = [&](double others) {
      return 4 * (1 - std::exp(-others)) / others * area / 4;
    };
    if (is_spaced) {
      EXPECT_EQ(most, 1);
      EXPECT_GT(share, covered(4 * area));
      EXPECT_LT(share, covered(4 * area - (area - 1.0 / 3 + 1.0 / 32)));
    } else {
      EXPECT_GE(most, 3);
      EXPECT_NEAR(share, area, 0.05 * area);
    }
  }
}

// A number says the same as a range that has no other; below 0 it is chance again.
TEST(BombTest, SizesAndAnglesMayBeTold) {
  const std::vector<Point> points = ScatteredPoints(600, -1.5, 1.5);
  auto told = Draw(R"(, "size": [0.5, 1.5], "rotation": [-90, 30], "size_at": 0.25,
                      "rotation_at": 0.5)",
                   points);
  auto fixed = Draw(R"(, "size": 0.75, "rotation": -30)", points);
  auto beyond = Draw(R"(, "size": [0.5, 0.75], "size_at": 7, "rotation": -30)", points);
  auto chance = Draw(R"(, "size": [0.5, 1.5], "size_at": -0.001)", points);
  auto usual = Draw(R"(, "size": [0.5, 1.5])", points);
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t c = 0; c < 4; ++c) {
      ASSERT_NEAR(told["color"].Float(i, c), fixed["color"].Float(i, c), 1e-5) << i;
      ASSERT_NEAR(beyond["color"].Float(i, c), fixed["color"].Float(i, c), 1e-5) << i;
    }
  }
  EXPECT_EQ(chance["color"].words, usual["color"].words);
}

// Copies grow from the left to the right: a disc's side is that of its centre's place.
TEST(BombTest, AsksSizesAtTheCentres) {
  const std::string text = R"({"texgraph": 1,
    "functions": {"across": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "share": {"block": "remap", "in": {"value": "p.x", "in_low": -2, "in_high": 2}}},
      "outputs": {"size": "share"}}},
    "nodes": {"white": {"block": "rgba", "in": {"color": 1}},
      "bomb": {"block": "bomb", "in": {"image": "white", "size": [0.2, 1.8], "size_at": "across",
        "shape": "disc", "edges": false}}},
    "outputs": {"color": "bomb.color"}})";
  const std::vector<Point> points = ScatteredPoints(600, -1.5, 1.5);
  auto outputs = RunGraph(text, points, {1e-5, 1e-5}, 1e-3);
  int covered = 0, open = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Plane plane{.size_min = 1.8, .size_max = 1.8, .is_disc = true};
    double inside = -1;  // of the copy in which the point is furthest from the rim
    for (const Copy& copy : CopiesAt(plane, {points[i].x * kScale, points[i].y * kScale})) {
      const double share = (copy.centre.x / kScale + 2) / 4;
      const double side = 0.2 + 1.6 * share;
      inside = std::max(inside, 0.5 * side - copy.distance);
    }
    if (std::fabs(inside) < 1e-4) continue;
    ASSERT_EQ(outputs["color"].Float(i, 3), inside > 0 ? 1 : 0) << i;
    (inside > 0 ? covered : open) += 1;
  }
  EXPECT_GT(covered, 100);
  EXPECT_GT(open, 100);
}

// Each copy has the colour that its tile chooses, over that of its image.
TEST(BombTest, TintsEachCopy) {
  const std::string text = R"({"texgraph": 1,
    "functions": {"shade": {"inputs": {"tile": "Tile"}, "nodes": {
        "luck": {"block": "tile_random", "in": {"tile": "tile"}},
        "tint": {"block": "combine3", "in": {"x": "luck", "y": 0.5, "z": 2}}},
      "outputs": {"tint": "tint"}}},
    "nodes": {"image": {"block": "rgba", "in": {"color": [0.5, 0.25, 0.125]}},
      "bomb": {"block": "bomb", "in": {"image": "image", "tint": "shade"}},
      "luck": {"block": "tile_random", "in": {"tile": "bomb.tile"}},
      "e": {"block": "combine3", "in": {"x": "luck"}}},
    "outputs": {"color": "bomb.color", "emission": "e"}})";
  const std::vector<Point> points = ScatteredPoints(300, -1.5, 1.5);
  auto outputs = RunGraph(text, points, {1e-5, 1e-5}, 1e-4);
  int covered = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (outputs["color"].Float(i, 3) < 1) continue;
    ++covered;
    ASSERT_NEAR(outputs["color"].Float(i, 0), 0.5 * outputs["emission"].Float(i, 0), 1e-5) << i;
    ASSERT_NEAR(outputs["color"].Float(i, 1), 0.125, 1e-6) << i;
    ASSERT_NEAR(outputs["color"].Float(i, 2), 0.25, 1e-6) << i;
  }
  EXPECT_GT(covered, 100);
}

// The copy's choice says which of two functions paints it.
TEST(BombTest, ChoosesAmongFunctions) {
  const std::string text = R"({"texgraph": 1,
    "functions": {
      "across": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "w": 1}}}, "outputs": {"color": "c"}},
      "up": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "c": {"block": "combine4", "in": {"y": "p.y", "z": 1, "w": 1}}},
        "outputs": {"color": "c"}},
      "either": {"inputs": {"uv": "vec2", "tile": "Tile"}, "nodes": {
        "luck": {"block": "tile_random", "in": {"tile": "tile"}},
        "is_first": {"block": "compare", "in": {"a": "luck", "b": 0.5, "relation": "less"}},
        "a": {"block": "across", "in": {"uv": "uv"}}, "b": {"block": "up", "in": {"uv": "uv"}},
        "c": {"block": "select", "in": {"condition": "is_first", "if_true": "a", "if_false": "b"}}},
        "outputs": {"color": "c"}}},
    "nodes": {"bomb": {"block": "bomb", "in": {"image": "either"}},
      "luck": {"block": "tile_random", "in": {"tile": "bomb.tile"}},
      "parts": {"block": "tile_parts", "in": {"tile": "bomb.tile"}},
      "q": {"block": "components", "in": {"vector": "parts.local"}},
      "e": {"block": "combine3", "in": {"x": "luck", "y": "q.x", "z": "q.y"}}},
    "outputs": {"color": "bomb.color", "emission": "e"}})";
  const std::vector<Point> points = ScatteredPoints(300, -1.5, 1.5);
  auto outputs = RunGraph(text, points, {1e-5, 1e-5}, 1e-3);
  ASSERT_EQ(outputs.size(), 2u);
  int first = 0, second = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Values &color = outputs["color"], &seen = outputs["emission"];
    if (color.Float(i, 3) < 1) continue;
    const bool is_first = seen.Float(i, 0) < 0.5f;
    (is_first ? first : second) += 1;
    ASSERT_NEAR(color.Float(i, 0), is_first ? seen.Float(i, 1) : 0, 1e-4) << i;
    ASSERT_NEAR(color.Float(i, 1), is_first ? 0 : seen.Float(i, 2), 1e-4) << i;
    ASSERT_NEAR(color.Float(i, 2), is_first ? 0 : 1, 1e-4) << i;
  }
  EXPECT_GT(first, 60);
  EXPECT_GT(second, 60);
}

TEST(BombTest, OrdersByKeyOrNearnessOrRows) {
  const std::string sizes = R"(, "size": [0.6, 1.6], "copies": 2, "meet": )";
  const Plane plane{.size_min = 0.6, .size_max = 1.6, .copies = 2};
  ExpectTopmost(sizes + "\"nearest\"", plane,
                [](const Copy& a, const Copy& b) { return a.distance < b.distance; });
  // Equal keys: as rows, the later is on top.
  ExpectTopmost(sizes + "\"rows\"", plane, [](const Copy&, const Copy&) { return true; });
  ExpectTopmost(sizes + "\"key\"", plane, [](const Copy&, const Copy&) { return true; });
}

// By the y of their centres, as trees on a hill, with numbers below and above 0.
TEST(BombTest, AsksTheKeyOfEachCopy) {
  const std::string text = R"({"texgraph": 1,
    "functions": {
      "where": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y"}}}, "outputs": {"color": "c"}},
      "height": {"inputs": {"tile": "Tile"}, "nodes": {
        "middle": {"block": "tile_center", "in": {"tile": "tile"}},
        "p": {"block": "components", "in": {"vector": "middle"}},
        "down": {"block": "negate", "in": {"value": "p.y"}}}, "outputs": {"key": "down"}}},
    "nodes": {"bomb": {"block": "bomb",
      "in": {"image": "where", "key": "height", "meet": "key", "size": 1.5}}},
    "outputs": {"color": "bomb.color"}})";
  const std::vector<Point> points = ScatteredPoints(500, -1.5, 1.5);
  auto outputs = RunGraph(text, points, {1e-5, 1e-5}, 1e-3);
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < points.size(); ++i) {
    const Copy* top = nullptr;
    bool is_clear = true;
    const auto copies =
        CopiesAt({.size_min = 1.5, .size_max = 1.5}, {points[i].x * kScale, points[i].y * kScale});
    for (const Copy& copy : copies) {
      if (std::fabs(copy.edge) < 2e-3) is_clear = false;
      if (copy.edge < 0) continue;
      if (top && std::fabs(copy.centre.y - top->centre.y) < 1e-4) is_clear = false;
      if (!top || copy.centre.y < top->centre.y) top = &copy;
    }
    if (!is_clear || !top) continue;
    ASSERT_NEAR(outputs["color"].Float(i, 0), top->q.x, 1e-3) << i;
    ASSERT_NEAR(outputs["color"].Float(i, 1), top->q.y, 1e-3) << i;
  }
}

// O16 for one to four points in each cell: discs that cover everything, of which the nearest is
// seen.
TEST(BombTest, NearestOfSeveralPointsAreRegions) {
  for (int copies = 1; copies <= 4; ++copies) {
    ExpectTopmost(R"(, "shape": "disc", "size": 3, "edges": false, "meet": "nearest", "copies": )" +
                      std::to_string(copies),
                  {.size_min = 3, .size_max = 3, .is_disc = true, .copies = copies},
                  [](const Copy& a, const Copy& b) { return a.distance < b.distance; });
  }
}

// Ranges that are uniforms, with as many cells as they need, are ranges; with fewer, copies are
// cut.
TEST(BombTest, RangesMayBeUniforms) {
  const auto draw = [](const std::string& binding, const std::string& cells) {
    const std::string text = R"({"texgraph": 1,
      "parameters": {
        "sides": {"type": "vec2", "value": [0.5, 1.2], "binding": ")" +
                             binding + R"("},
        "turns": {"type": "vec2", "value": [-20, 70], "binding": ")" +
                             binding + R"("}},
      "nodes": {"luck": {"block": "tile_random", "in": {"tile": "bomb.tile"}},
        "bomb": {"block": "bomb", "in": {"image": [1, 0.5, 0.25, 1], "size": "sides",
          "rotation": "turns")" +
                             cells + R"(}},
        "e": {"block": "combine3", "in": {"x": "luck", "y": "bomb.covered"}}},
      "outputs": {"emission": "e"}})";
    return RunGraph(text, ScatteredPoints(600, -1.5, 1.5), {1e-5, 1e-5}, 1e-3)["emission"];
  };
  const Values known = draw("constant", "");
  const auto equal_to_known = [&](const Values& other) {
    int equal = 0;
    for (size_t i = 0; i < 600; ++i) {
      equal += known.Float(i, 0) == other.Float(i, 0) &&
               std::fabs(known.Float(i, 1) - other.Float(i, 1)) < 1e-4;
    }
    return equal;
  };
  EXPECT_GE(equal_to_known(draw("uniform", R"(, "cells": [3, 3])")), 598);
  EXPECT_LT(equal_to_known(draw("uniform", R"(, "cells": [2, 2])")), 590);
}

TEST(BombTest, LooksAtAsManyCellsAsTheRangesNeed) {
  struct Case {
    Vector jitter, size, rotation;
    const char* shape;
    int columns, rows;
  };
  const Case cases[] = {
      {{1, 1}, {1, 1}, {0, 0}, "square", 2, 2},             // the chapter's
      {{1, 1}, {0.3, 1}, {-180, 180}, "disc", 2, 2},        // a disc of diameter 1 may turn
      {{1, 1}, {1, 1}, {-10, 10}, "square", 3, 3},          // a square may not
      {{0, 0}, {1, 1}, {0, 0}, "square", 1, 1},             // a regular grid
      {{0.5, 0}, {1, 1}, {0, 0}, "square", 2, 1},           // of rows that slide
      {{1, 1}, {1, 1.5}, {0, 360}, "square", 4, 4},         // 1 + 1.5 * sqrt(2) = 3.12
      {{0.2, 0.2}, {0.5, 0.56}, {0, 360}, "square", 1, 1},  // 0.2 + 0.56 * sqrt(2) = 0.99
      {{1, 1}, {1, 1}, {80, 100}, "square", 3, 3},
      {{1, 1}, {1, 1}, {90, 90}, "square", 2, 2},
  };
  for (const Case& c : cases) {
    auto outputs = RunBlock("bomb_cells", {{"jitter", Vectors({c.jitter})},
                                           {"size", Vectors({c.size})},
                                           {"rotation", Vectors({c.rotation})},
                                           {"shape", Word{c.shape}}});
    EXPECT_EQ(outputs["result"].Int(0, 0), c.columns);
    EXPECT_EQ(outputs["result"].Int(0, 1), c.rows);
  }
  // Rows of hexagons are nearer to each other: 2 / 0.866 = 2.31.
  auto cells = RunBlock("bomb_cells", {{"grid", Word{"hexagon"}},
                                       {"jitter", Vectors({{0.5, 0.5}})},
                                       {"size", Vectors({{1.5, 1.5}})}});
  EXPECT_EQ(cells["result"].Int(0, 0), 2);
  EXPECT_EQ(cells["result"].Int(0, 1), 3);
  auto rivals =
      RunBlock("bomb_rivals", {{"jitter", Vectors({{0.5, 1}})}, {"spacing", Floats({1})}});
  EXPECT_EQ(rivals["result"].Int(0, 0), 3);
  EXPECT_EQ(rivals["result"].Int(0, 1), 3);
  auto reach = RunBlock(
      "bomb_reach",
      {{"size", Vectors({{1, 2}})}, {"rotation", Vectors({{0, 30}})}, {"shape", Word{"square"}}});
  EXPECT_NEAR(reach["result"].Float(0), 0.5 + std::sqrt(3.0) / 2, 1e-6);
}

// O11. Identical to the bit with more cells, and not with fewer.
TEST(BombTest, NothingIsClipped) {
  struct Case {
    std::string ports;
    int cells;
  };
  const Case cases[] = {
      {"", 2},
      {R"(, "shape": "disc", "rotation": [0, 360])", 2},
      {R"(, "rotation": [-45, 45], "size": [0.9, 1], "edges": false)", 3},
      {R"(, "jitter": 0.8, "size": [0.3, 2], "rotation": 20, "copies": 2, "meet": "sum")", 4},
      {R"(, "density": 0.5, "meet": "nearest")", 2},
      {R"(, "size": [1.3, 1.4], "shape": "disc", "meet": "sum")", 3},
      {R"(, "size": [1.3, 1.4], "meet": "max", "seed": 4)", 3},
      {R"(, "size": 1.5, "meet": "rows", "wander": true, "phase": 17.3)", 3},
      {R"(, "grid": "hexagon", "size": [0.5, 1.4], "shape": "disc", "meet": "sum")", 3},
      {R"(, "grid": "hexagon", "jitter": 0.2, "spacing": 0.9, "size": 1.3)", 2},
  };
  std::vector<Point> points = ScatteredPoints(1500, -1.5, 1.5);
  for (Point p : ScatteredPoints(300, -1.5, 1.5)) points.push_back({p.x * 1e-4, p.y * 1e-4});
  for (const Case& c : cases) {
    auto with = [&](int cells) {
      const std::string number = std::to_string(cells);
      return Draw(c.ports + R"(, "cells": [)" + number + ", " + number + "]", points);
    };
    auto own = Draw(c.ports, points), same = with(c.cells), more = with(c.cells + 2),
         odd = with(c.cells + 1), less = with(c.cells - 1);
    EXPECT_EQ(own["color"].words, same["color"].words) << c.ports;
    EXPECT_EQ(own["color"].words, more["color"].words) << c.ports;
    EXPECT_EQ(own["color"].words, odd["color"].words) << c.ports;
    EXPECT_NE(own["color"].words, less["color"].words) << c.ports;
  }
}

// As with the cells that copies reach: identical with more that are asked whether they are too
// near, and not with fewer.
TEST(BombTest, LooksAtAsManyRivalsAsSpacingNeeds) {
  const std::vector<Point> points = ScatteredPoints(500, -1.5, 1.5);
  struct Case {
    std::string ports;
    int rivals;
  };
  const Case cases[] = {
      {R"(, "spacing": 0.5, "copies": 2)", 2},
      {R"(, "spacing": 1)", 3},
      {R"(, "spacing": 0.69, "jitter": 0.4, "grid": "hexagon")", 2},
  };
  for (const Case& c : cases) {
    auto with = [&](int rivals) {
      const std::string number = std::to_string(rivals);
      return Draw(c.ports + R"(, "rivals": [)" + number + ", " + number + "]", points);
    };
    auto own = Draw(c.ports, points);
    EXPECT_EQ(own["color"].words, with(c.rivals)["color"].words) << c.ports;
    EXPECT_EQ(own["color"].words, with(c.rivals + 1)["color"].words) << c.ports;
    EXPECT_EQ(own["color"].words, with(c.rivals + 2)["color"].words) << c.ports;
    EXPECT_NE(own["color"].words, with(c.rivals - 1)["color"].words) << c.ports;
  }
}

// An odd period of rows becomes the next even one, so that moved rows close.
TEST(BombTest, HexagonsRepeat) {
  const std::vector<Point> points = ScatteredPoints(400, -1.5, 1.5);
  std::vector<Point> moved;
  for (Point p : points) moved.push_back({p.x + 5 / kScale, p.y + 4 * std::sqrt(0.75) / kScale});
  const std::string ports = R"(, "grid": "hexagon", "period": [5, 3], "size": 1.4)";
  auto here = Draw(ports, points), there = Draw(ports, moved);
  int equal = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    equal += std::fabs(here["color"].Float(i, 0) - there["color"].Float(i, 0)) < 1e-4 &&
             here["emission"].Float(i, 0) == there["emission"].Float(i, 0);
  }
  EXPECT_GE(equal, 399);
}

}  // namespace
}  // namespace texgraph::blocks
