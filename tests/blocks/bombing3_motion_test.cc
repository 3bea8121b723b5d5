// SPDX-License-Identifier: Apache-2.0
// Bombing in space: its random numbers, rotations, density, motion, repetition, edges, and what is
// left of it from far away; and the blocks that take a copy's frame.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "tests/blocks/bombing3_reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using reference::CopyBits3;

using Cell3 = std::array<int32_t, 3>;

std::vector<Cell3> Block(const Cell3& first, int side) {
  std::vector<Cell3> cells;
  for (int i = 0; i < side * side * side; ++i) {
    cells.push_back({first[0] + i % side, first[1] + i / side % side, first[2] + i / side / side});
  }
  return cells;
}

Values ValuesOf(const std::vector<Cell3>& cells) {
  Values values{ir::kIvec3, cells.size(), {}};
  for (size_t axis = 0; axis < 3; ++axis) {
    for (const Cell3& cell : cells) values.words.push_back(static_cast<uint32_t>(cell[axis]));
  }
  return values;
}

using Words = std::array<std::vector<uint32_t>, 5>;  // the five numbers of many cells

Words BitsOf(const std::vector<Cell3>& cells, int copy, int seed) {
  auto outputs = RunBlock(
      "copy_bits3", {{"cell", ValuesOf(cells)}, {"copy", Ints({copy})}, {"seed", Ints({seed})}});
  Words words;
  for (size_t i = 0; i < cells.size(); ++i) {
    for (size_t n = 0; n < 3; ++n) words[n].push_back(outputs["place"].Uint(i, n));
    words[3].push_back(outputs["luck"].Uint(i));
    words[4].push_back(outputs["bits"].Uint(i));
  }
  return words;
}

TEST(CopyBits3Test, AreThoseOfPcg3d) {
  const auto cells = Block({-2, -1, 100}, 4);
  auto hash = RunBlock("cell_hash", {{"cell", ValuesOf(cells)}, {"seed", Ints({77})}});
  for (int copy : {0, 5}) {
    const Words words = BitsOf(cells, copy, 77);
    for (size_t i = 0; i < cells.size(); ++i) {
      const auto expected = CopyBits3(cells[i][0], cells[i][1], cells[i][2], copy, 77);
      for (size_t n = 0; n < 3; ++n) ASSERT_EQ(words[n][i], expected.place[n]);
      ASSERT_EQ(words[3][i], expected.luck);
      ASSERT_EQ(words[4][i], expected.bits);
      if (copy == 0) {
        ASSERT_EQ(words[4][i], hash["result"].Uint(i));
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
TEST(CopyBits3Test, AreUnrelated) {
  constexpr int kSide = 32;
  for (const Cell3& at : {Cell3{0, 0, 0}, Cell3{-100, -90, 7}, Cell3{1 << 20, -(1 << 19), 5}}) {
    const Words here = BitsOf(Block(at, kSide), 0, 0);
    const Words others[] = {BitsOf(Block({at[0] + 1, at[1], at[2]}, kSide), 0, 0),
                            BitsOf(Block({at[0], at[1] + 1, at[2]}, kSide), 0, 0),
                            BitsOf(Block({at[0], at[1], at[2] + 1}, kSide), 0, 0),
                            BitsOf(Block(at, kSide), 1, 0)};
    for (size_t a = 0; a < 5; ++a) {
      for (size_t b = 0; b < 5; ++b) {
        if (a < b) {
          EXPECT_LT(PairScore(here[a], here[b]), 4.5) << a << b;
        }
        for (size_t other = 0; other < 4; ++other) {
          EXPECT_LT(PairScore(here[a], others[other][b]), 4.5) << a << b << " " << other;
        }
      }
    }
  }
}

// Opaque paper, at places with the third coordinate z, or as "turned" with the first. The normal is
// that of one side of the copy; emission is where the place is in the copy, across and up, and the
// copy's random number.
std::string Solid(const std::string& ports, double z, const std::string& functions = "",
                  const std::string& uv = "plane") {
  return R"({"texgraph": 1, "functions": {)" + functions + R"(
      "paper": {"inputs": {"position": "vec3"}, "nodes": {
        "c": {"block": "combine4", "in": {"x": 1, "y": 0.5, "z": 0.25, "w": 1}}},
        "outputs": {"color": "c"}}},
    "nodes": {
      "p": {"block": "components", "in": {"vector": "uv"}},
      "plane": {"block": "combine3", "in": {"x": "p.x", "y": "p.y", "z": )" +
         std::to_string(z) + R"(}},
      "turned": {"block": "combine3", "in": {"x": )" +
         std::to_string(z) + R"(, "y": "p.x", "z": "p.y"}},
      "bomb": {"block": "bomb3", "in": {"image": "paper", "uv": ")" +
         uv + "\"" + ports + R"(}},
      "parts": {"block": "tile_parts", "in": {"tile": "bomb.tile"}},
      "at": {"block": "components", "in": {"vector": "parts.local"}},
      "luck": {"block": "tile_random", "in": {"tile": "bomb.tile"}},
      "e": {"block": "combine3", "in": {"x": "at.x", "y": "at.y", "z": "luck"}},
      "side": {"block": "turn_normal", "in": {"normal": [1, 0, 0], "tile": "bomb.tile"}}},
    "outputs": {"color": "bomb.color", "emission": "e", "opacity": "bomb.covered",
                "normal": "side"}})";
}

constexpr double kFine = 0.5 / 64;  // the middle of the first slice, of 64 for each unit
constexpr double kMiddle = 0.5 / 8;

std::vector<Point> Middles(int x, int y, int side, double scale) {
  std::vector<Point> points;
  for (int i = 0; i < side * side; ++i)
    points.push_back({(x + i % side + 0.5) / scale, (y + i / side + 0.5) / scale});
  return points;
}

double Mean(const Values& values, size_t component = 0, int power = 1) {
  double sum = 0;
  for (size_t i = 0; i < values.count; ++i) sum += std::pow(values.Float(i, component), power);
  return sum / static_cast<double>(values.count);
}

// Every direction is as probable as each other: the mean of a component is 0, that of its square
// 1/3 with a variance of 4/45, that of its fourth power 1/5 with 1/9 - 1/25.
TEST(Bomb3Test, TumblesInAllDirections) {
  auto outputs =
      RunGraph(Solid(R"(, "jitter": 0, "size": 0.5, "scale": [64, 64, 64], "tumble": true)", kFine),
               Middles(0, 0, 64, 64), {1e-5, 1e-5});
  const Values& side = outputs["normal"];
  ASSERT_EQ(side.count, 4096u);
  for (size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(Mean(side, axis), 0, 4 * std::sqrt(1.0 / 3 / 4096));
    EXPECT_NEAR(Mean(side, axis, 2), 1.0 / 3, 4 * std::sqrt(4.0 / 45 / 4096));
    EXPECT_NEAR(Mean(side, axis, 4), 1.0 / 5, 4 * std::sqrt((1.0 / 9 - 1.0 / 25) / 4096));
  }
  for (size_t i = 0; i < side.count; ++i) {
    ASSERT_NEAR(std::hypot(side.Float(i, 0), side.Float(i, 1), side.Float(i, 2)), 1, 1e-5);
  }
}

// O14. A number for all of space, and one that grows with x from 0 to 1 in eight steps.
TEST(Bomb3Test, DensityIsTheShareOfCopies) {
  const std::string grid = R"(, "jitter": 0, "size": 0.5, "scale": [64, 64, 64])";
  for (double density : {0.0, 0.25, 0.8, 1.0}) {
    auto outputs = RunGraph(Solid(grid + R"(, "density": )" + std::to_string(density), kFine),
                            Middles(-32, 7, 64, 64), {1e-5, 1e-5});
    const double deviation = std::sqrt(density * (1 - density) / 4096);
    EXPECT_NEAR(Mean(outputs["opacity"]), density, 4 * deviation) << density;
  }
  const std::string painted = R"("painted": {"inputs": {"position": "vec3"}, "nodes": {
      "p": {"block": "components", "in": {"vector": "position"}}}, "outputs": {"d": "p.x"}},)";
  auto outputs = RunGraph(Solid(grid + R"(, "density": "painted")", kFine, painted),
                          Middles(0, 0, 64, 64), {1e-5, 1e-5});
  for (int part = 0; part < 8; ++part) {
    double sum = 0;
    for (int i = 0; i < 512; ++i)
      sum += outputs["opacity"].Float(static_cast<size_t>(64 * (i / 8) + 8 * part + i % 8));
    EXPECT_NEAR(sum / 512, (part + 0.5) / 8, 4 * std::sqrt(0.25 / 512)) << part;
  }
}

std::map<std::string, Values> At(double phase, const std::string& ports,
                                 const std::vector<Point>& points,
                                 const std::string& uv = "plane") {
  return RunGraph(
      Solid(R"(, "wander": true, "phase": )" + std::to_string(phase) + ports, kMiddle, "", uv),
      points, {1e-5, 1e-5});
}

// O15. A copy that is as large as three cells, so that it still is there; its frame tells how far
// it went. Near the origin and 4,000 cells away; in the plane of x and y and in that of z and x.
TEST(Bomb3Test, SpeedHasABound) {
  const std::string ports = R"(, "jitter": 0.8, "size": 3, "meet": "rows")";
  constexpr double kJitter = 0.8, kSide = 3, kStep = 1.0 / 16;
  for (const char* uv : {"plane", "turned"}) {
    const int far = uv[0] == 'p' ? 0 : 4000;
    const std::vector<Point> points = Middles(far, -far, 6, 8);
    double fastest = 0, longest = 0;
    auto first = At(0, ports, points, uv), before = first;
    for (int step = 1; step <= 40; ++step) {
      auto now = At(step * kStep, ports, points, uv);
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
    EXPECT_GT(longest, 0.4 * kJitter) << far;
  }
}

// How far the frames of the copies are from those of `b`, where there are copies; far if others are
// in front or are there.
double Furthest(std::map<std::string, Values> a, std::map<std::string, Values> b) {
  double furthest = 0;
  const size_t count = a["opacity"].count;
  if (count == 0 || b["opacity"].count != count) return 1e9;
  for (size_t i = 0; i < count; ++i) {
    if (a["opacity"].Float(i) != b["opacity"].Float(i)) return 1e9;
    if (a["opacity"].Float(i) == 0) continue;
    for (size_t c = 0; c < 3; ++c) {
      const Values &x = a["emission"], &y = b["emission"], &m = a["normal"], &n = b["normal"];
      furthest = std::max<double>(furthest, std::fabs(x.Float(i, c) - y.Float(i, c)));
      furthest = std::max<double>(furthest, std::fabs(m.Float(i, c) - n.Float(i, c)));
    }
  }
  return furthest;
}

TEST(Bomb3Test, MotionRepeats) {
  const std::vector<Point> points = Middles(-8, 3, 16, 8);
  const std::string loop = R"(, "edges": false, "size": 1.5, "loop": 3)";
  auto first = At(0.25, loop, points);
  // But for the rounding of the phase.
  EXPECT_LT(Furthest(first, At(3.25, loop, points)), 1e-5);
  EXPECT_LT(Furthest(first, At(-2.75, loop, points)), 1e-5);
  EXPECT_GT(Furthest(first, At(1.25, loop, points)), 0.1);
  EXPECT_GT(Furthest(first, At(3.25, R"(, "edges": false, "size": 1.5)", points)), 0.1);
}

// At places that are multiples of 1/1024, so that moved coordinates have no rounding; in the plane
// of x and y and in that of z and x.
TEST(Bomb3Test, SpaceRepeats) {
  std::vector<Point> points, further;
  for (int i = 0; i < 300; ++i) {
    const Point p{(i * 37 % 1024) / 1024.0, (i * 101 % 1024) / 1024.0};
    points.push_back(p);
    further.push_back({p.x + 0.75, p.y - 1.25});
  }
  const std::string ports = R"(, "scale": [8, 8, 8], "size": [0.5, 1.1], "tumble": true)";
  auto draw = [&](const char* period, const std::vector<Point>& at, const char* uv) {
    return RunGraph(Solid(ports + period, kMiddle, "", uv), at, {1e-5, 1e-5}, 1e-3);
  };
  EXPECT_EQ(Furthest(draw(R"(, "period": [6, 5, 0])", points, "plane"),
                     draw(R"(, "period": [6, 5, 0])", further, "plane")),
            0);
  EXPECT_EQ(Furthest(draw(R"(, "period": [0, 6, 5])", points, "turned"),
                     draw(R"(, "period": [0, 6, 5])", further, "turned")),
            0);
  for (const char* uv : {"plane", "turned"}) {
    EXPECT_GT(Furthest(draw("", points, uv), draw("", further, uv)), 0.1);
    EXPECT_GT(Furthest(draw(R"(, "period": [5, 0, 6])", points, uv),
                       draw(R"(, "period": [5, 0, 6])", further, uv)),
              0.1);
  }
}

// In one cell with one copy that the surface cuts through the middle: a rim of one pixel, inside of
// the copy. Turned by 45 degrees about the second axis, a cube of 0.6 is 0.6 * sqrt(2) wide there.
TEST(Bomb3Test, EdgesAreOnePixelWide) {
  constexpr double kPixel = 0.02;
  struct Case {
    const char* ports;
    double half;
  };
  for (const Case& c :
       {Case{R"("size": 0.8)", 0.4}, Case{R"("size": 0.8, "shape": "ball")", 0.4},
        Case{R"("size": 0.6, "rotation": 45, "axis": [0, 1, 0])", 0.3 * std::sqrt(2.0)}}) {
    std::vector<Point> points;
    std::vector<double> expected;
    for (int i = -20; i < 40; ++i) {
      const double inside = i * kPixel / 20;  // from the right rim
      points.push_back({0.5 + c.half - inside, 0.5});
      // Of the corner of the turned cube, both sides are there.
      const double part = reference::Clamp(inside / kPixel, 0, 1);
      expected.push_back(c.half == 0.4 ? part : part * part);
    }
    auto outputs =
        RunGraph(Solid(R"(, "scale": [1, 1, 1], "jitter": 0, )" + std::string(c.ports), 0.5),
                 points, {kPixel, kPixel});
    // Of a ball it is measured by the square of the radius: within a pixel per radius.
    const double tolerance = kPixel / 0.4 / 2;
    for (size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(outputs["opacity"].Float(i), expected[i], tolerance) << c.ports << " " << i;
  }
}

// A ball whose top the surface only just cuts, by a disc of a third of a pixel: its share of the
// area of the pixel where that is in its middle, and nothing beyond.
TEST(Bomb3Test, CapsThatAreSmallerThanAPixelAreTheirArea) {
  constexpr double kPixel = 0.06, kRadius = 0.02, kBall = 0.4;
  const double z = 0.5 + std::sqrt(kBall * kBall - kRadius * kRadius);
  auto outputs =
      RunGraph(Solid(R"(, "scale": [1, 1, 1], "jitter": 0, "size": 0.8, "shape": "ball")", z),
               {{0.5, 0.5}, {0.53, 0.5}}, {kPixel, kPixel});
  const double share = std::numbers::pi * std::pow(kRadius / kPixel, 2);
  EXPECT_NEAR(outputs["opacity"].Float(0), share, 0.01);
  EXPECT_EQ(outputs["opacity"].Float(1), 0);
}

// Two copies, which fill their cell, in each cell: light is added, or the greatest.
TEST(Bomb3Test, AddsLight) {
  const std::string half = R"("partly": {"inputs": {"position": "vec3"}, "nodes": {
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
    auto outputs = RunGraph(Solid(ports + c.meet, kMiddle, half), points, {1e-5, 1e-5});
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(outputs["opacity"].Float(i), c.covered, 1e-6) << c.meet;
      EXPECT_NEAR(outputs["color"].Float(i, 3), c.covered, 1e-6) << c.meet;
      EXPECT_NEAR(outputs["color"].Float(i, 1), 0.5, 1e-6) << c.meet;
    }
  }
}

TEST(Bomb3Test, GoesToItsMeanFromFarAway) {
  const std::string ports =
      R"(, "fade": true, "far": [0.2, 0.4, 0.6, 0.5], "background": [1, 0, 0, 1])";
  const std::vector<Point> points = Middles(0, 0, 6, 3);
  auto near = RunGraph(Solid(R"(, "background": [1, 0, 0, 1])", kMiddle), points, {0.06, 0.06});
  auto begun = RunGraph(Solid(ports, kMiddle), points, {0.06, 0.06});  // 0.48 cells a pixel
  auto over = RunGraph(Solid(ports, kMiddle), points, {0.126, 0.126});
  EXPECT_EQ(near["color"].words, begun["color"].words);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(over["color"].Float(i, 0), 0.6, 1e-6);
    EXPECT_NEAR(over["color"].Float(i, 1), 0.2, 1e-6);
    EXPECT_NEAR(over["color"].Float(i, 2), 0.3, 1e-6);
    EXPECT_NEAR(over["opacity"].Float(i), 0.5, 1e-6);
  }
}

// What the blocks of tiles make of a cell in space, from the cell's bits.
TEST(Tile3Test, HasTheBlocksOfTiles) {
  const std::string text = R"({"texgraph": 1, "nodes": {
      "p": {"block": "components", "in": {"vector": "uv"}},
      "place": {"block": "combine3", "in": {"x": "p.x", "y": "p.y", "z": 0.0625}},
      "bomb": {"block": "bomb3", "in": {"image": [1, 1, 1, 1], "uv": "place", "jitter": 0}},
      "choice": {"block": "tile_choice", "in": {"tile": "bomb.tile", "count": 5, "stream": 2}},
      "weighted": {"block": "tile_weighted_choice",
                   "in": {"tile": "bomb.tile", "weights": [1, 0, 2, 5]}},
      "near": {"block": "tile_near", "in": {"tile": "bomb.tile"}},
      "c": {"block": "to_float", "in": {"value": "choice"}},
      "w": {"block": "to_float", "in": {"value": "weighted"}},
      "numbers": {"block": "combine3", "in": {"x": "c", "y": "w", "z": "near"}},
      "random_color": {"block": "tile_random_color", "in": {"tile": "bomb.tile", "stream": 3}},
      "palette": {"block": "tile_palette",
                  "in": {"tile": "bomb.tile", "colors": [[0, 0, 0], [1, 0, 0], [2, 0, 0]]}},
      "grey": {"block": "tile_random_hsv",
               "in": {"tile": "bomb.tile", "color": [0.25, 0.25, 0.25], "value": [0.5, 2]}},
      "g": {"block": "components", "in": {"vector": "grey"}},
      "which": {"block": "components", "in": {"vector": "palette"}},
      "four": {"block": "combine4", "in": {"x": "which.x", "y": "g.x", "z": "g.y", "w": 1}}},
    "outputs": {"emission": "numbers", "normal": "random_color", "color": "four"}})";
  const std::vector<Point> points = Middles(0, 0, 8, 8);
  auto outputs = RunGraph(text, points, {1e-6, 1e-6});
  ASSERT_EQ(outputs.size(), 3u);
  using reference::High16, reference::Low16, reference::Pcg, reference::Unit24;
  for (size_t i = 0; i < points.size(); ++i) {
    const uint32_t seed =
        CopyBits3(static_cast<int32_t>(i % 8), static_cast<int32_t>(i / 8), 0, 0, 0).bits;
    EXPECT_EQ(outputs["emission"].Float(i, 0), std::floor(High16(Pcg(seed + 2)) * 5));
    const double place = Unit24(Pcg(seed)) * 8;
    EXPECT_EQ(outputs["emission"].Float(i, 1), place < 1 ? 0 : place < 3 ? 2 : 3);
    EXPECT_NEAR(outputs["emission"].Float(i, 2), 1, 1e-6);
    const uint32_t bits = Pcg(seed + 3);
    EXPECT_NEAR(outputs["normal"].Float(i, 0), Low16(bits), 1e-5);
    EXPECT_NEAR(outputs["normal"].Float(i, 1), High16(bits), 1e-5);
    EXPECT_NEAR(outputs["normal"].Float(i, 2), Unit24(Pcg(bits)), 1e-5);
    EXPECT_EQ(outputs["color"].Float(i, 0), std::floor(High16(seed) * 3));
    const double value = 0.25 * reference::Mix(0.5, 2, Unit24(Pcg(Pcg(seed))));
    EXPECT_NEAR(outputs["color"].Float(i, 1), value, 1e-5);
    EXPECT_NEAR(outputs["color"].Float(i, 2), value, 1e-5);
  }
  // Two cells a pixel, across and up: half of each is this one's, and along the third axis all.
  auto far = RunGraph(text, {{0.06, 0.06}}, {0.25, 0.25});
  EXPECT_NEAR(far["emission"].Float(0, 2), 0.25, 1e-5);
}

}  // namespace
}  // namespace texgraph::blocks
