// SPDX-License-Identifier: Apache-2.0
// Bombing in space: against a reference that looks at every cell far around, and by what must hold
// whatever the ranges are: no copy is clipped, no cell too many is looked at, and balls fill as
// much of space as their volumes say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "tests/blocks/bombing3_reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using reference::BodiesAt;
using reference::Body;
using reference::Space;
using reference::Vec3;

constexpr double kScale = 8;  // cells for each unit

// A plane through space that no axis lies in: where the test looks, for u and v.
Vec3 OnPlane(Point p) { return {p.x, 0.8 * p.y, 0.35 * p.x - 0.6 * p.y + 0.3}; }

// The image paints its own coordinate. Emission has a random number of the copy in front, how much
// is covered, and the copy's number in its cell.
std::map<std::string, Values> Draw(const std::string& ports, const std::vector<Point>& points,
                                   double pixel = 1e-5) {
  const std::string text = R"({"texgraph": 1,
    "functions": {"where": {"inputs": {"position": "vec3"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "position"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y", "z": "p.z", "w": 1}}},
        "outputs": {"color": "c"}}},
    "nodes": {
      "p": {"block": "components", "in": {"vector": "uv"}},
      "y": {"block": "multiply", "in": {"a": "p.y", "b": 0.8}},
      "z_of_x": {"block": "multiply", "in": {"a": "p.x", "b": 0.35}},
      "z_of_y": {"block": "multiply", "in": {"a": "p.y", "b": -0.6}},
      "slope": {"block": "add", "in": {"a": "z_of_x", "b": "z_of_y"}},
      "z": {"block": "add", "in": {"a": "slope", "b": 0.3}},
      "place": {"block": "combine3", "in": {"x": "p.x", "y": "y", "z": "z"}},
      "bomb": {"block": "bomb3", "in": {"image": "where", "uv": "place")" +
                           ports + R"(}},
      "luck": {"block": "tile_random", "in": {"tile": "bomb.tile"}},
      "number": {"block": "to_float", "in": {"value": "bomb.index"}},
      "e": {"block": "combine3", "in": {"x": "luck", "y": "bomb.covered", "z": "number"}}},
    "outputs": {"color": "bomb.color", "emission": "e", "normal": "bomb.normal"}})";
  return RunGraph(text, points, {pixel, pixel}, 2e-3);
}

// Which of two copies is in front; the first of the two comes after the second in its order.
using IsAbove = std::function<bool(const Body& later, const Body& earlier)>;

// Out of the shape of a copy at a point: from its centre, or the side that is nearest.
Vec3 NormalOf(const Space& space, const Body& body) {
  Vec3 arm{};
  for (size_t i = 0; i < 3; ++i) arm[i] = body.q[i] - 0.5;
  if (!space.is_ball) {
    size_t most = 0;
    for (size_t i = 1; i < 3; ++i) {
      if (std::fabs(arm[i]) > std::fabs(arm[most])) most = i;
    }
    for (size_t i = 0; i < 3; ++i) arm[i] = i == most ? std::copysign(1, arm[i]) : 0;
  }
  const double length = std::sqrt(reference::Dot(arm, arm));
  for (double& a : arm) a /= length;
  return reference::Times(body.turn, arm);
}

// Whether rounding may choose another side of a cube, or another direction at a ball's centre.
bool HasClearNormal(const Body& body) {
  std::array<double, 3> away{};
  for (size_t i = 0; i < 3; ++i) away[i] = std::fabs(body.q[i] - 0.5);
  std::ranges::sort(away);
  return away[2] - away[1] > 1e-3 && away[2] > 0.01;
}

void ExpectTopmost(const std::string& ports, const Space& space, const IsAbove& is_above) {
  const std::vector<Point> points = ScatteredPoints(400, -1.5, 1.5);
  auto outputs = Draw(ports, points);
  ASSERT_EQ(outputs.size(), 3u);
  int clear = 0, covered = 0, contested = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    Vec3 p = OnPlane(points[i]);
    for (double& x : p) x *= kScale;
    // Without the copies at whose rims rounding decides, and with them.
    const Body *top = nullptr, *perhaps = nullptr;
    const std::vector<Body> bodies = BodiesAt(space, p);
    for (const Body& body : bodies) {
      if (body.edge < -2e-3) continue;
      if (!perhaps || is_above(body, *perhaps)) perhaps = &body;
      if (body.edge < 2e-3) continue;
      contested += top != nullptr;
      if (!top || is_above(body, *top)) top = &body;
    }
    if (top != perhaps) continue;
    ++clear;
    covered += top != nullptr;
    ASSERT_NEAR(outputs["emission"].Float(i, 1), top ? 1 : 0, 1e-4) << i;
    for (size_t c = 0; c < 3; ++c) {
      if (!top) {
        ASSERT_EQ(outputs["normal"].Float(i, c), 0) << i;
        continue;
      }
      ASSERT_NEAR(outputs["color"].Float(i, c), top->q[c], 1e-3) << i;
      if (HasClearNormal(*top)) {
        ASSERT_NEAR(outputs["normal"].Float(i, c), NormalOf(space, *top)[c], 1e-3) << i;
      }
    }
    if (!top) continue;
    ASSERT_NEAR(outputs["emission"].Float(i, 0), reference::Unit24(reference::Pcg(top->seed)), 1e-6)
        << i;
    ASSERT_EQ(outputs["emission"].Float(i, 2), top->index) << i;
  }
  EXPECT_GT(clear, 350);
  EXPECT_GT(covered, 80);
  EXPECT_GT(contested, 20);
}

bool IsOfHigherRank(const Body& a, const Body& b) { return a.rank > b.rank; }

// O13.
TEST(Bomb3Test, TheHighestRankWins) {
  ExpectTopmost("", {}, IsOfHigherRank);
  ExpectTopmost(R"(, "shape": "ball", "seed": 3)", {.is_ball = true, .seed = 3}, IsOfHigherRank);
  ExpectTopmost(
      R"(, "size": [0.4, 1.4], "rotation": [-40, 75], "axis": [1, -2, 3], "copies": 2, "seed": 9)",
      {.size_min = 0.4,
       .size_max = 1.4,
       .rotation_min = -40,
       .rotation_max = 75,
       .axis = {1, -2, 3},
       .copies = 2,
       .seed = 9},
      IsOfHigherRank);
}

TEST(Bomb3Test, TumblesAndShrinks) {
  ExpectTopmost(R"(, "size": [0.3, 1.6], "tumble": true)",
                {.size_min = 0.3, .size_max = 1.6, .tumble = true}, IsOfHigherRank);
  ExpectTopmost(R"(, "shape": "ball", "size": [1, 2], "jitter": 1.5, "density": 0.4,
                     "tumble": true)",
                {.jitter = 1.5,
                 .size_min = 1,
                 .size_max = 2,
                 .tumble = true,
                 .is_ball = true,
                 .density = 0.4},
                IsOfHigherRank);
}

TEST(Bomb3Test, LeavesOutCopiesThatAreTooNear) {
  ExpectTopmost(
      R"(, "spacing": 0.7, "copies": 2, "shape": "ball", "size": 1.6, "seed": 4)",
      {.size_min = 1.6, .size_max = 1.6, .is_ball = true, .copies = 2, .seed = 4, .spacing = 0.7},
      IsOfHigherRank);
  const std::vector<Point> points = ScatteredPoints(250, -1.5, 1.5);
  auto own = Draw(R"(, "spacing": 0.45, "copies": 2, "meet": "sum")", points);
  auto more = Draw(R"(, "spacing": 0.45, "copies": 2, "meet": "sum", "rivals": 3)", points);
  auto less = Draw(R"(, "spacing": 0.45, "copies": 2, "meet": "sum", "rivals": 1)", points);
  EXPECT_EQ(own["color"].words, more["color"].words);
  EXPECT_NE(own["color"].words, less["color"].words);
}

// A number says the same as a range that has no other; below 0 it is chance again.
TEST(Bomb3Test, SizesAndAnglesMayBeTold) {
  const std::vector<Point> points = ScatteredPoints(300, -1.5, 1.5);
  auto told = Draw(R"(, "size": [0.5, 1.5], "rotation": [-90, 30], "size_at": 0.25,
                      "rotation_at": 0.5)",
                   points);
  auto fixed = Draw(R"(, "size": 0.75, "rotation": -30)", points);
  for (size_t i = 0; i < points.size(); ++i) {
    for (size_t c = 0; c < 4; ++c) {
      ASSERT_NEAR(told["color"].Float(i, c), fixed["color"].Float(i, c), 1e-5) << i;
    }
  }
  const std::string range = R"(, "size": [0.5, 1.5], "rotation": [-90, 30])";
  auto chance = Draw(range + R"(, "size_at": -0.001, "rotation_at": -1)", points);
  EXPECT_EQ(chance["color"].words, Draw(range, points)["color"].words);
}

TEST(Bomb3Test, OrdersByKeyOrNearnessOrRows) {
  const std::string sizes = R"(, "size": [0.6, 1.6], "copies": 2, "meet": )";
  const Space space{.size_min = 0.6, .size_max = 1.6, .copies = 2};
  ExpectTopmost(sizes + "\"nearest\"", space,
                [](const Body& a, const Body& b) { return a.distance < b.distance; });
  // Equal keys: as rows, the later is in front.
  ExpectTopmost(sizes + "\"rows\"", space, [](const Body&, const Body&) { return true; });
  ExpectTopmost(sizes + "\"key\"", space, [](const Body&, const Body&) { return true; });
}

// O16 in space, for one to four points in each cell: balls that fill everything.
TEST(Bomb3Test, NearestOfSeveralPointsAreRegions) {
  for (int copies : {1, 4}) {
    ExpectTopmost(
        R"(, "shape": "ball", "size": 3.5, "edges": false, "meet": "nearest", "copies": )" +
            std::to_string(copies),
        {.size_min = 3.5, .size_max = 3.5, .is_ball = true, .copies = copies},
        [](const Body& a, const Body& b) { return a.distance < b.distance; });
  }
}

// Each copy has the colour that its tile chooses, over that of its image.
TEST(Bomb3Test, TintsEachCopy) {
  const std::string text = R"({"texgraph": 1,
    "functions": {"shade": {"inputs": {"tile": "Tile3"}, "nodes": {
        "luck": {"block": "tile_random", "in": {"tile": "tile"}},
        "tint": {"block": "combine3", "in": {"x": "luck", "y": 0.5, "z": 2}}},
      "outputs": {"tint": "tint"}}},
    "nodes": {"image": {"block": "rgba", "in": {"color": [0.5, 0.25, 0.125]}},
      "p": {"block": "components", "in": {"vector": "uv"}},
      "place": {"block": "combine3", "in": {"x": "p.x", "y": "p.y", "z": 0.3}},
      "bomb": {"block": "bomb3", "in": {"image": "image", "tint": "shade", "uv": "place"}},
      "luck": {"block": "tile_random", "in": {"tile": "bomb.tile"}},
      "e": {"block": "combine3", "in": {"x": "luck"}}},
    "outputs": {"color": "bomb.color", "emission": "e"}})";
  const std::vector<Point> points = ScatteredPoints(300, -1.5, 1.5);
  auto outputs = RunGraph(text, points, {1e-5, 1e-5}, 1e-4);
  ASSERT_EQ(outputs.size(), 2u);
  int covered = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    if (outputs["color"].Float(i, 3) < 1) continue;
    ++covered;
    ASSERT_NEAR(outputs["color"].Float(i, 0), 0.5 * outputs["emission"].Float(i, 0), 1e-5) << i;
    ASSERT_NEAR(outputs["color"].Float(i, 1), 0.125, 1e-6) << i;
    ASSERT_NEAR(outputs["color"].Float(i, 2), 0.25, 1e-6) << i;
  }
  EXPECT_GT(covered, 80);
}

// Half of the light goes through each copy: the topmost has half of what is seen, the next a
// quarter.
TEST(Bomb3Test, CompositesFromTheTopmostDown) {
  const std::vector<Point> points = ScatteredPoints(300, -1.5, 1.5);
  auto outputs = Draw(R"(, "coverage": 0.5, "size": 1.5, "shape": "ball")", points);
  ASSERT_EQ(outputs.size(), 3u);
  size_t deepest = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    Vec3 p = OnPlane(points[i]);
    for (double& x : p) x *= kScale;
    std::vector<Body> bodies = BodiesAt({.size_min = 1.5, .size_max = 1.5, .is_ball = true}, p);
    if (std::ranges::any_of(bodies, [](const Body& b) { return std::fabs(b.edge) < 2e-3; })) {
      continue;
    }
    std::erase_if(bodies, [](const Body& b) { return b.edge < 0; });
    std::ranges::sort(bodies, IsOfHigherRank);
    deepest = std::max(deepest, bodies.size());
    double through = 1;
    Vec3 light{};
    for (const Body& body : bodies) {
      through /= 2;
      for (size_t c = 0; c < 3; ++c) light[c] += through * body.q[c];
    }
    ASSERT_NEAR(outputs["color"].Float(i, 3), 1 - through, 1e-3) << i;
    for (size_t c = 0; c < 3 && through < 1; ++c) {
      ASSERT_NEAR(outputs["color"].Float(i, c), light[c] / (1 - through), 2e-3) << i;
    }
  }
  EXPECT_GE(deepest, 4u);
}

// By the y of their centres, with numbers below and above 0.
TEST(Bomb3Test, AsksTheKeyOfEachCopy) {
  const std::string text = R"({"texgraph": 1,
    "functions": {
      "where": {"inputs": {"position": "vec3"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "position"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y", "z": "p.z", "w": 1}}},
        "outputs": {"color": "c"}},
      "height": {"inputs": {"tile": "Tile3"}, "nodes": {
        "at": {"block": "components", "in": {"vector": "uv"}},
        "place": {"block": "combine3", "in": {"x": "at.x", "y": "at.y", "z": 0}},
        "middle": {"block": "tile_center", "in": {"tile": "tile", "uv": "place"}},
        "p": {"block": "components", "in": {"vector": "middle"}},
        "down": {"block": "negate", "in": {"value": "p.y"}}}, "outputs": {"key": "down"}}},
    "nodes": {
      "at": {"block": "components", "in": {"vector": "uv"}},
      "place": {"block": "combine3", "in": {"x": "at.x", "y": "at.y", "z": 0}},
      "bomb": {"block": "bomb3",
      "in": {"image": "where", "uv": "place", "key": "height", "meet": "key", "size": 1.2,
             "tumble": true}}},
    "outputs": {"color": "bomb.color"}})";
  const std::vector<Point> points = ScatteredPoints(250, -1.5, 1.5);
  auto outputs = RunGraph(text, points, {1e-5, 1e-5}, 2e-3);
  ASSERT_EQ(outputs.size(), 1u);
  int contested = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Body* top = nullptr;
    bool is_clear = true;
    const std::vector<Body> bodies = BodiesAt({.size_min = 1.2, .size_max = 1.2, .tumble = true},
                                              {points[i].x * kScale, points[i].y * kScale, 0});
    for (const Body& body : bodies) {
      if (std::fabs(body.edge) < 2e-3) is_clear = false;
      if (body.edge < 0) continue;
      contested += top != nullptr;
      if (top && std::fabs(body.centre[1] - top->centre[1]) < 1e-4) is_clear = false;
      if (!top || body.centre[1] < top->centre[1]) top = &body;
    }
    if (!is_clear || !top) continue;
    for (size_t c = 0; c < 3; ++c) {
      ASSERT_NEAR(outputs["color"].Float(i, c), top->q[c], 1e-3) << i;
    }
  }
  EXPECT_GT(contested, 100);
}

// The greatest reach of the turned cube, of very many angles.
Vec3 WidestOf(const Vec3& axis, double from, double to) {
  Vec3 widest{};
  for (int step = 0; step <= 20000; ++step) {
    const double angle = reference::Mix(from, to, step / 20000.0) * std::numbers::pi / 180;
    const reference::Matrix3 turn = reference::Rotation(axis, angle);
    for (size_t i = 0; i < 3; ++i) {
      double sum = 0;
      for (double x : turn[i]) sum += std::fabs(x);
      widest[i] = std::max(widest[i], sum / 2);
    }
  }
  return widest;
}

TEST(Bomb3Test, ReachIsThatOfTheWidestAngle) {
  struct Case {
    Vector axis;
    double from, to;
  };
  const Case cases[] = {{{0, 0, 1}, 0, 30},   {{0, 0, 1}, -180, 180}, {{1, 1, 1}, 0, 360},
                        {{1, 1, 1}, -20, 20}, {{1, -2, 3}, 10, 35},   {{-3, 0.5, 1}, 70, 400},
                        {{0, 5, 0}, 44, 46},  {{2, 1, 0}, 100, 100}};
  for (const Case& c : cases) {
    auto reach = RunBlock("bomb3_reach", {{"size", Vectors({{1, 2}})},
                                          {"rotation", Vectors({{c.from, c.to}})},
                                          {"axis", Vectors({c.axis})},
                                          {"shape", Word{"cube"}}});
    const Vec3 widest = WidestOf({c.axis[0], c.axis[1], c.axis[2]}, c.from, c.to);
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(reach["result"].Float(0, i), 2 * widest[i], 2e-6) << c.from << " to " << c.to;
    }
  }
}

TEST(Bomb3Test, LooksAtAsManyCellsAsTheRangesNeed) {
  struct Case {
    Vector jitter, size, rotation, axis;
    bool tumble;
    const char* shape;
    int columns, rows, slices;
  };
  const Vector up{0, 0, 1}, all{1, 1, 1};
  auto tumbled =
      RunBlock("bomb3_reach",
               {{"size", Vectors({{1, 2}})}, {"tumble", Bools({true})}, {"shape", Word{"cube"}}});
  EXPECT_NEAR(tumbled["result"].Float(0, 1), std::sqrt(3.0), 1e-6);
  const Case cases[] = {
      {{1, 1, 1}, {1, 1}, {0, 0}, up, false, "cube", 2, 2, 2},  // the chapter's
      {{1, 1, 1}, {0.3, 1}, {0, 0}, up, true, "ball", 2, 2, 2},
      {{1, 1, 1}, {0.3, 1}, {0, 360}, all, false, "ball", 2, 2, 2},
      {{1, 1, 1}, {1, 1}, {0, 0}, up, true, "cube", 3, 3, 3},      // 1 + sqrt(3)
      {{1, 1, 1}, {1, 1}, {-10, 10}, up, false, "cube", 3, 3, 2},  // upright all the same
      {{1, 1, 1}, {1, 1}, {90, 90}, {0, 1, 0}, false, "cube", 2, 2, 2},
      {{0.2, 0.2, 0.2}, {0.5, 0.57}, {0, 0}, up, true, "cube", 2, 2, 2},  // 0.2 + 0.57 * sqrt(3)
      {{0.2, 0.2, 0.2}, {0.4, 0.46}, {0, 0}, up, true, "cube", 1, 1, 1},
      // About the diagonal a row is at most 5/3: at 60 degrees it is (2, 2, -1) / 3.
      {{1, 1, 1}, {1, 1.19}, {0, 60}, all, false, "cube", 3, 3, 3},
      {{1, 1, 1}, {1, 1.21}, {0, 60}, all, false, "cube", 4, 4, 4},
      {{0, 0, 0}, {1, 1}, {0, 0}, up, false, "cube", 1, 1, 1},
      {{1, 0, 0.5}, {1.5, 1.6}, {0, 0}, up, false, "ball", 3, 2, 3},
  };
  for (const Case& c : cases) {
    auto outputs = RunBlock("bomb3_cells", {{"jitter", Vectors({c.jitter})},
                                            {"size", Vectors({c.size})},
                                            {"rotation", Vectors({c.rotation})},
                                            {"axis", Vectors({c.axis})},
                                            {"tumble", Bools({c.tumble})},
                                            {"shape", Word{c.shape}}});
    EXPECT_EQ(outputs["result"].Int(0, 0), c.columns);
    EXPECT_EQ(outputs["result"].Int(0, 1), c.rows);
    EXPECT_EQ(outputs["result"].Int(0, 2), c.slices);
  }
}

TEST(Bomb3Test, LooksAtAsManyRivalsAsSpacingNeeds) {
  auto rivals =
      RunBlock("bomb3_rivals", {{"jitter", Vectors({{0, 0.5, 1}})}, {"spacing", Floats({0.7})}});
  EXPECT_EQ(rivals["result"].Int(0, 0), 2);  // 1.4
  EXPECT_EQ(rivals["result"].Int(0, 1), 2);  // 1.9
  EXPECT_EQ(rivals["result"].Int(0, 2), 3);  // 2.4
}

// Identical to the bit with more cells, and not with fewer.
TEST(Bomb3Test, NothingIsClipped) {
  struct Case {
    std::string ports;
    int cells;
  };
  const Case cases[] = {
      {"", 2},
      {R"(, "shape": "ball", "tumble": true)", 2},
      {R"(, "tumble": true, "size": [0.9, 1.1], "edges": false)", 3},
      {R"(, "size": [0.9, 1.1], "rotation": [0, 360], "axis": [2, 1, 3])", 3},
      {R"(, "density": 0.5, "meet": "nearest")", 2},
      {R"(, "size": [1.3, 1.4], "shape": "ball", "meet": "sum", "copies": 2)", 3},
      {R"(, "size": 2.2, "shape": "ball", "copies": 3)", 4},
      {R"(, "size": [1.1, 1.15], "tumble": true, "meet": "max", "seed": 4)", 3},
      {R"(, "size": 1.5, "meet": "rows", "wander": true, "phase": 17.3)", 3},
  };
  std::vector<Point> points = ScatteredPoints(600, -1.5, 1.5);
  for (Point p : ScatteredPoints(100, -1.5, 1.5)) points.push_back({p.x * 1e-4, p.y * 1e-4 + 0.5});
  for (const Case& c : cases) {
    auto with = [&](int cells) {
      const std::string n = std::to_string(cells);
      return Draw(c.ports + R"(, "cells": [)" + n + ", " + n + ", " + n + "]", points);
    };
    auto own = Draw(c.ports, points), same = with(c.cells), more = with(c.cells + 2),
         odd = with(c.cells + 1), less = with(c.cells - 1);
    EXPECT_EQ(own["color"].words, same["color"].words) << c.ports;
    EXPECT_EQ(own["color"].words, more["color"].words) << c.ports;
    EXPECT_EQ(own["color"].words, odd["color"].words) << c.ports;
    EXPECT_NE(own["color"].words, less["color"].words) << c.ports;
  }
}

// The share of 16 x 16 x 16 cells that is covered, of 37 x 37 x 37 places: no two of a row are at
// the same place of their cells.
double Filled(const std::string& ports) {
  constexpr int kSide = 37;
  auto place = [](int i) { return (i + 0.5) / kSide * 16 / kScale; };
  std::vector<Point> points;
  for (int i = 0; i < kSide * kSide; ++i) points.push_back({place(i % kSide), place(i / kSide)});
  double sum = 0;
  for (int z = 0; z < kSide; ++z) {
    const std::string text = R"({"texgraph": 1, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "place": {"block": "combine3", "in": {"x": "p.x", "y": "p.y", "z": )" +
                             std::to_string(place(z)) + R"(}},
        "white": {"block": "color_constant", "in": {"value": [1, 1, 1, 1]}},
        "bomb": {"block": "bomb3", "in": {"image": "white", "uv": "place", "edges": false)" +
                             ports + R"(}}},
      "outputs": {"opacity": "bomb.covered"}})";
    auto outputs = RunGraph(text, points, {1e-5, 1e-5});
    for (size_t i = 0; i < points.size(); ++i) sum += outputs["opacity"].Float(i);
  }
  return sum / std::pow(kSide, 3);
}

// O11. Balls and cubes that stay in their cells: the sum of the volumes. A place in a cell is
// covered or not, so the standard deviation is at most 1/2 by the root of the number of places;
// between places of one cell it is less, for balls are round.
TEST(Bomb3Test, FillsAsMuchAsTheVolumes) {
  const double pi = std::numbers::pi, deviation = 0.5 / std::pow(37, 1.5);
  EXPECT_NEAR(Filled(R"(, "shape": "ball", "size": 0.7, "jitter": 0.3)"), pi / 6 * std::pow(0.7, 3),
              4 * deviation);
  // The mean of d^3 of all d from a to b is (b^4 - a^4) / (4 (b - a)).
  EXPECT_NEAR(Filled(R"(, "shape": "ball", "size": [0.2, 0.8], "jitter": 0.2, "density": 0.5)"),
              0.5 * pi / 6 * (std::pow(0.8, 4) - std::pow(0.2, 4)) / (4 * 0.6), 5 * deviation);
  EXPECT_NEAR(Filled(R"(, "size": 0.5, "jitter": 0.13, "tumble": true)"), 0.125, 4 * deviation);
}

}  // namespace
}  // namespace texgraph::blocks
