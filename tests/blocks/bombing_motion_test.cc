// SPDX-License-Identifier: Apache-2.0
// Bombing: its random numbers, density, motion, repetition, edges, and what is left of it from far
// away.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/blocks/bombing_reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using reference::CopyBits;

std::vector<std::pair<int32_t, int32_t>> Square(int32_t x, int32_t y, int side) {
  std::vector<std::pair<int32_t, int32_t>> cells;
  for (int i = 0; i < side * side; ++i) cells.push_back({x + i % side, y + i / side});
  return cells;
}

TEST(CopyBitsTest, AreThoseOfPcg2d) {
  const auto cells = Square(-3, -2, 8);
  for (int copy : {0, 5}) {
    auto outputs = RunBlock(
        "copy_bits", {{"cell", CellsOf(cells)}, {"copy", Ints({copy})}, {"seed", Ints({77})}});
    auto hash = RunBlock("cell_hash", {{"cell", CellsOf(cells)}, {"seed", Ints({77})}});
    for (size_t i = 0; i < cells.size(); ++i) {
      const auto expected = CopyBits(cells[i].first, cells[i].second, copy, 77);
      for (size_t n = 0; n < 4; ++n) ASSERT_EQ(outputs["result"].Uint(i, n), expected[n]);
      if (copy == 0) {
        ASSERT_EQ(outputs["result"].Uint(i, 3), hash["result"].Uint(i));
      }
    }
  }
}

// How far counts of pairs of 16 classes are from equal, in standard deviations of the chi square of
// 255 degrees of freedom.
double PairScore(const std::vector<uint32_t>& a, const std::vector<uint32_t>& b) {
  std::vector<double> counts(256);
  for (size_t i = 0; i < a.size(); ++i) ++counts[(a[i] >> 28) * 16 + (b[i] >> 28)];
  const double expected = double(a.size()) / 256;
  double sum = 0;
  for (double count : counts) sum += (count - expected) * (count - expected) / expected;
  return (sum - 255) / std::sqrt(2 * 255.0);
}

// Numbers of one copy, of neighbours, and of two copies in a cell do not know of each other.
TEST(CopyBitsTest, AreUnrelated) {
  constexpr int kSide = 192;
  for (auto [x, y] : {std::pair{0, 0}, {-100, -90}, {1 << 20, -(1 << 19)}}) {
    std::array<std::vector<uint32_t>, 4> here, right, up, next;
    auto take = [&](std::array<std::vector<uint32_t>, 4>& to, int dx, int dy, int copy) {
      auto outputs = RunBlock("copy_bits", {{"cell", CellsOf(Square(x + dx, y + dy, kSide))},
                                            {"copy", Ints({copy})},
                                            {"seed", Ints({0})}});
      for (size_t n = 0; n < 4; ++n) {
        for (size_t i = 0; i < kSide * kSide; ++i) to[n].push_back(outputs["result"].Uint(i, n));
      }
    };
    take(here, 0, 0, 0);
    take(right, 1, 0, 0);
    take(up, 0, 1, 0);
    take(next, 0, 0, 1);
    for (size_t a = 0; a < 4; ++a) {
      for (size_t b = 0; b < 4; ++b) {
        if (a < b) {
          EXPECT_LT(PairScore(here[a], here[b]), 4.5) << a << b;
        }
        EXPECT_LT(PairScore(here[a], right[b]), 4.5) << a << b << " right";
        EXPECT_LT(PairScore(here[a], up[b]), 4.5) << a << b << " up";
        EXPECT_LT(PairScore(here[a], next[b]), 4.5) << a << b << " next";
      }
    }
  }
}

std::string Plane(const std::string& ports, const std::string& functions = "") {
  return R"({"texgraph": 1, "functions": {)" + functions + R"(
      "paper": {"inputs": {"uv": "vec2"}, "nodes": {
        "c": {"block": "combine4", "in": {"x": 1, "y": 0.5, "z": 0.25, "w": 1}}},
        "outputs": {"color": "c"}}},
    "nodes": {"bomb": {"block": "bomb", "in": {"image": "paper")" +
         ports + R"(}},
      "parts": {"block": "tile_parts", "in": {"tile": "bomb.tile"}},
      "place": {"block": "components", "in": {"vector": "parts.local"}},
      "luck": {"block": "tile_random", "in": {"tile": "bomb.tile"}},
      "e": {"block": "combine3", "in": {"x": "place.x", "y": "place.y", "z": "luck"}}},
    "outputs": {"color": "bomb.color", "emission": "e", "opacity": "bomb.covered"}})";
}

std::vector<Point> Middles(int x, int y, int side, double scale) {
  std::vector<Point> points;
  for (auto [column, row] : Square(x, y, side))
    points.push_back({(column + 0.5) / scale, (row + 0.5) / scale});
  return points;
}

double Mean(const Values& values) {
  double sum = 0;
  for (size_t i = 0; i < values.count; ++i) sum += values.Float(i);
  return sum / static_cast<double>(values.count);
}

// O14. A number for the whole plane, and one that grows with u from 0 to 1 in eight steps.
TEST(BombTest, DensityIsTheShareOfCopies) {
  const std::string grid = R"(, "jitter": 0, "size": 0.5, "scale": [64, 64])";
  for (double density : {0.0, 0.25, 0.8, 1.0}) {
    auto outputs = RunGraph(Plane(grid + R"(, "density": )" + std::to_string(density)),
                            Middles(-32, 7, 64, 64), {1e-5, 1e-5});
    const double deviation = std::sqrt(density * (1 - density) / 4096);
    EXPECT_NEAR(Mean(outputs["opacity"]), density, 4 * deviation) << density;
  }
  const std::string painted = R"("painted": {"inputs": {"uv": "vec2"}, "nodes": {
      "p": {"block": "components", "in": {"vector": "uv"}}}, "outputs": {"d": "p.x"}},)";
  auto outputs = RunGraph(Plane(grid + R"(, "density": "painted")", painted), Middles(0, 0, 64, 64),
                          {1e-5, 1e-5});
  for (int part = 0; part < 8; ++part) {
    double sum = 0;
    for (int i = 0; i < 512; ++i)
      sum += outputs["opacity"].Float(static_cast<size_t>(64 * (i / 8) + 8 * part + i % 8));
    EXPECT_NEAR(sum / 512, (part + 0.5) / 8, 4 * std::sqrt(0.25 / 512)) << part;
  }
}

std::map<std::string, Values> At(double phase, const std::string& ports,
                                 const std::vector<Point>& points) {
  return RunGraph(Plane(R"(, "wander": true, "phase": )" + std::to_string(phase) + ports), points,
                  {1e-5, 1e-5});
}

// O15. A copy that is as large as three cells, so that it still is there; its frame tells how far
// it went. Near the origin and 4,000 cells away.
TEST(BombTest, SpeedHasABound) {
  const std::string ports = R"(, "jitter": 0.8, "size": 3, "meet": "rows")";
  constexpr double kJitter = 0.8, kSide = 3, kStep = 1.0 / 32;
  for (int far : {0, 4000}) {
    const std::vector<Point> points = Middles(far, -far, 16, 8);
    double fastest = 0, longest = 0;
    auto first = At(0, ports, points), before = first;
    for (int step = 1; step <= 80; ++step) {
      auto now = At(step * kStep, ports, points);
      for (size_t i = 0; i < points.size(); ++i) {
        for (size_t axis = 0; axis < 2; ++axis) {
          const Values &a = before["emission"], &b = now["emission"], &c = first["emission"];
          if (a.Float(i, 2) == b.Float(i, 2)) {
            fastest = std::max(fastest, std::fabs(b.Float(i, axis) - a.Float(i, axis)) * kSide);
          }
          if (c.Float(i, 2) == b.Float(i, 2)) {
            longest = std::max(longest, std::fabs(b.Float(i, axis) - c.Float(i, axis)) * kSide);
          }
        }
      }
      before = now;
    }
    EXPECT_LT(fastest, 1.5 * kJitter * kStep + 2e-3) << far;
    EXPECT_GT(fastest, 0.5 * kJitter * kStep) << far;
    EXPECT_LT(longest, kJitter) << far;
    EXPECT_GT(longest, 0.5 * kJitter) << far;
  }
}

// How far the frames of the copies are from those of `b`, where there are copies; far if others are
// on top or are there.
double Furthest(std::map<std::string, Values> a, std::map<std::string, Values> b) {
  double furthest = 0;
  const size_t count = a["opacity"].count;
  if (count == 0 || b["opacity"].count != count) return 1e9;
  for (size_t i = 0; i < count; ++i) {
    if (a["opacity"].Float(i) != b["opacity"].Float(i)) return 1e9;
    if (a["opacity"].Float(i) == 0) continue;
    for (size_t c = 0; c < 3; ++c) {
      furthest = std::max<double>(furthest,
                                  std::fabs(a["emission"].Float(i, c) - b["emission"].Float(i, c)));
    }
  }
  return furthest;
}

TEST(BombTest, MotionRepeats) {
  const std::vector<Point> points = Middles(-8, 3, 24, 8);
  const std::string loop = R"(, "edges": false, "size": 1.5, "loop": 3)";
  auto first = At(0.25, loop, points);
  // But for the rounding of the phase.
  EXPECT_LT(Furthest(first, At(3.25, loop, points)), 1e-5);
  EXPECT_LT(Furthest(first, At(-2.75, loop, points)), 1e-5);
  EXPECT_GT(Furthest(first, At(1.25, loop, points)), 0.1);
  EXPECT_GT(Furthest(first, At(3.25, R"(, "edges": false, "size": 1.5)", points)), 0.1);
}

TEST(BombTest, PlaneRepeats) {
  std::vector<Point> points, further;
  for (int i = 0; i < 500; ++i) {
    // Multiples of 1/1024, so that moved coordinates have no rounding.
    const Point p{(i * 37 % 1024) / 1024.0, (i * 101 % 1024) / 1024.0};
    points.push_back(p);
    further.push_back({p.x + 0.75, p.y - 1.25});
  }
  const std::string ports = R"(, "scale": [8, 8], "size": [0.5, 1.6], "rotation": [0, 90])";
  auto draw = [&](const char* period, const std::vector<Point>& at) {
    return RunGraph(Plane(ports + period), at, {1e-5, 1e-5});
  };
  const char* const period = R"(, "period": [6, 5])";
  EXPECT_EQ(Furthest(draw(period, points), draw(period, further)), 0);
  EXPECT_GT(Furthest(draw("", points), draw("", further)), 0.1);
}

// In one cell with one copy: a rim of one pixel, inside of the copy.
TEST(BombTest, EdgesAreOnePixelWide) {
  constexpr double kPixel = 0.02;
  for (const char* shape : {"square", "disc"}) {
    std::vector<Point> points;
    std::vector<double> expected;
    for (int i = -20; i < 40; ++i) {
      const double inside = i * kPixel / 20;  // from the right rim
      points.push_back({0.9 - inside, 0.5});
      expected.push_back(reference::Clamp(inside / kPixel, 0, 1));
    }
    auto outputs = RunGraph(Plane(R"(, "scale": [1, 1], "jitter": 0, "size": 0.8, "shape": ")" +
                                  std::string(shape) + "\""),
                            points, {kPixel, kPixel});
    // Of a circle it is measured by the square of the radius: within a pixel per radius.
    const double tolerance = shape[0] == 'd' ? kPixel / 0.4 / 2 : 1e-3;
    for (size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(outputs["opacity"].Float(i), expected[i], tolerance) << shape << " " << i;
  }
}

// Two copies, which fill their cell, in each cell: light is added, or the greatest.
TEST(BombTest, AddsLight) {
  const std::string half = R"("partly": {"inputs": {"uv": "vec2"}, "nodes": {
      "c": {"block": "float_constant", "in": {"value": 0.375}}}, "outputs": {"d": "c"}},)";
  const std::string ports =
      R"(, "jitter": 0, "copies": 2, "edges": false, "coverage": "partly", "meet": )";
  const std::vector<Point> points = Middles(0, 0, 4, 8);
  struct Case {
    const char* meet;
    double covered;
  };
  for (const Case& c :
       {Case{"\"sum\"", 0.75}, Case{"\"max\"", 0.375}, Case{"\"rows\"", 1 - 0.625 * 0.625},
        Case{"\"random\"", 1 - 0.625 * 0.625}}) {
    auto outputs = RunGraph(Plane(ports + c.meet, half), points, {1e-5, 1e-5});
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(outputs["opacity"].Float(i), c.covered, 1e-6) << c.meet;
      EXPECT_NEAR(outputs["color"].Float(i, 3), c.covered, 1e-6) << c.meet;
      EXPECT_NEAR(outputs["color"].Float(i, 1), 0.5, 1e-6) << c.meet;
    }
  }
}

TEST(BombTest, GoesToItsMeanFromFarAway) {
  const std::string ports =
      R"(, "fade": true, "far": [0.2, 0.4, 0.6, 0.5], "background": [1, 0, 0, 1])";
  const std::vector<Point> points = Middles(0, 0, 6, 3);
  auto near = RunGraph(Plane(R"(, "background": [1, 0, 0, 1])"), points, {0.06, 0.06});
  auto begun = RunGraph(Plane(ports), points, {0.06, 0.06});  // scale 8: 0.48 cells a pixel
  auto over = RunGraph(Plane(ports), points, {0.126, 0.126});
  EXPECT_EQ(near["color"].words, begun["color"].words);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(over["color"].Float(i, 0), 0.6, 1e-6);
    EXPECT_NEAR(over["color"].Float(i, 1), 0.2, 1e-6);
    EXPECT_NEAR(over["color"].Float(i, 2), 0.3, 1e-6);
    EXPECT_NEAR(over["opacity"].Float(i), 0.5, 1e-6);
  }
}

TEST(TilePaletteTest, ChoosesEquallyOften) {
  const std::string text = R"({"texgraph": 1, "nodes": {
      "grid": {"block": "virtual_tile_map", "in": {"cells": [64, 64]}},
      "color": {"block": "tile_palette",
                "in": {"tile": "grid", "colors": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}},
    "outputs": {"emission": "color"}})";
  auto outputs = RunGraph(text, Middles(0, 0, 64, 64), {1e-5, 1e-5});
  for (size_t channel = 0; channel < 3; ++channel) {
    double sum = 0;
    for (size_t i = 0; i < 4096; ++i) sum += outputs["emission"].Float(i, channel);
    EXPECT_NEAR(sum / 4096, 1.0 / 3, 4 * std::sqrt(2.0 / 9 / 4096));
  }
}

}  // namespace
}  // namespace texgraph::blocks
