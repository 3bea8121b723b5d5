// SPDX-License-Identifier: Apache-2.0
// Bombing: against a reference that looks at every cell far around, and by what must hold whatever
// the ranges are: no copy is clipped, no cell too many is looked at, speeds have a bound.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
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
    const Copy* top = nullptr;
    const std::vector<Copy> copies = CopiesAt(plane, {points[i].x * kScale, points[i].y * kScale});
    bool is_clear = true;
    for (const Copy& copy : copies) {
      if (std::fabs(copy.edge) < 2e-3) is_clear = false;
      if (copy.edge < 0) continue;
      contested += top != nullptr;
      if (!top || is_above(copy, *top)) top = &copy;
    }
    if (!is_clear) continue;
    ++clear;
    covered += top != nullptr;
    ASSERT_NEAR(outputs["emission"].Float(i, 1), top ? 1 : 0, 1e-4) << i;
    if (!top) continue;
    ASSERT_NEAR(outputs["color"].Float(i, 0), top->q.x, 1e-3) << i;
    ASSERT_NEAR(outputs["color"].Float(i, 1), top->q.y, 1e-3) << i;
    ASSERT_NEAR(outputs["emission"].Float(i, 0), reference::Unit24(reference::Pcg(top->seed)), 1e-6)
        << i;
  }
  EXPECT_GT(clear, 600);
  EXPECT_GT(covered, 100);
  EXPECT_GT(contested, 20);
}

bool IsOfHigherRank(const Copy& a, const Copy& b) { return a.rank > b.rank; }

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
  auto reach = RunBlock(
      "bomb_reach",
      {{"size", Vectors({{1, 2}})}, {"rotation", Vectors({{0, 30}})}, {"shape", Word{"square"}}});
  EXPECT_NEAR(reach["result"].Float(0), 0.5 + std::sqrt(3.0) / 2, 1e-6);
}

// Identical to the bit with more cells, and not with fewer.
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

}  // namespace
}  // namespace texgraph::blocks
