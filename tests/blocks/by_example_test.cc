// SPDX-License-Identifier: Apache-2.0
// Tiling by example, against references in double precision that search for what is near: a hat
// function on every hexagon in place of the triangle that the point is in.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <set>
#include <string>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using reference::CellHash;
using reference::Pcg;

struct Setting {
  Point tiling = {1, 1}, scale = {3.5, 4}, rotation = {-180, 180}, offset = {1, 1};
  double contrast = 0.6, exponent = 7;
  int columns = 0, rows = 0, seed = 0;
};

std::string Pair(double x, double y) {
  return "[" + std::to_string(x) + ", " + std::to_string(y) + "]";
}

std::string PortsOf(const Setting& s) {
  return R"("tiling": )" + Pair(s.tiling.x, s.tiling.y) + R"(, "scale": )" +
         Pair(s.scale.x, s.scale.y) + R"(, "rotation": )" + Pair(s.rotation.x, s.rotation.y) +
         R"(, "offset": )" + Pair(s.offset.x, s.offset.y) + R"(, "contrast": )" +
         std::to_string(s.contrast) + R"(, "exponent": )" + std::to_string(s.exponent) +
         R"(, "period": [)" + std::to_string(s.columns) + ", " + std::to_string(s.rows) +
         R"(], "seed": )" + std::to_string(s.seed);
}

// A hexagon that counts at a point.
struct Hexagon {
  int column = 0, row = 0;
  double share = 0;  // before what it shows is weighed
  double angle = 0;
  uint32_t seed = 0;
  Point place;  // in its picture
};

int Wrapped(int cell, int count) { return count == 0 ? cell : ((cell % count) + count) % count; }

// How much of a hexagon's middle a point has: 1 there, 0 at the middles of its neighbours, linear
// on each of the triangles between these. `x`, `y`: from the middle, for neighbours at distance 1.
double Hat(double x, double y) {
  double farthest = 0;
  for (double degrees : {30.0, 90.0, 150.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    farthest = std::max(farthest, std::fabs(x * std::cos(angle) + y * std::sin(angle)));
  }
  return std::max(0.0, 1 - farthest / (0.5 * std::numbers::sqrt3));
}

std::vector<Hexagon> HexagonsAt(Point p, const Setting& s) {
  const Point cells = {s.tiling.x * s.scale.x, s.tiling.y * s.scale.y};
  std::vector<Hexagon> found;
  double most = 0;
  for (int row = static_cast<int>(std::floor(p.y * cells.y)) - 3, end = row + 7; row < end; ++row) {
    const int first = static_cast<int>(std::floor(p.x * cells.x)) - 3;
    for (int column = first; column < first + 7; ++column) {
      const double shift = row % 2 == 0 ? 0 : 0.5;
      const double hat =
          Hat(p.x * cells.x - column - shift, (p.y * cells.y - row) * 0.5 * std::numbers::sqrt3);
      if (hat <= 0) continue;
      most = std::max(most, hat);
      Hexagon hexagon;
      hexagon.share = hat;
      hexagon.column = Wrapped(column, s.columns);
      hexagon.row = Wrapped(row, s.rows + s.rows % 2);
      hexagon.seed = CellHash(hexagon.column, hexagon.row, static_cast<uint32_t>(s.seed));
      const double luck = reference::Unit24(Pcg(hexagon.seed - 2));
      hexagon.angle = reference::Mix(s.rotation.x, s.rotation.y, luck) * std::numbers::pi / 180;
      const double x = p.x - (column + shift) / cells.x, y = p.y - row / cells.y;
      const double c = std::cos(-hexagon.angle), d = std::sin(-hexagon.angle);
      const uint32_t bits = Pcg(hexagon.seed - 1);
      hexagon.place = {((hexagon.column + shift) / cells.x + c * x - d * y) * s.tiling.x +
                           s.offset.x * reference::Low16(bits),
                       (hexagon.row / cells.y + d * x + c * y) * s.tiling.y +
                           s.offset.y * reference::High16(bits)};
      found.push_back(hexagon);
    }
  }
  double sum = 0;
  for (Hexagon& hexagon : found) {
    hexagon.share = std::max(std::pow(hexagon.share / most, s.exponent) - 0.01, 0.0);
    sum += hexagon.share;
  }
  std::erase_if(found, [](const Hexagon& hexagon) { return hexagon.share <= 0; });
  for (Hexagon& hexagon : found) hexagon.share /= sum;
  return found;
}

// Places that floats have exactly.
std::vector<Point> Places(size_t count, Point low, Point high, uint32_t seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> x(low.x, high.x), y(low.y, high.y);
  std::vector<Point> points(count);
  for (Point& p : points) p = {static_cast<float>(x(random)), static_cast<float>(y(random))};
  return points;
}

// ---- The shares.

TEST(HexSharesTest, AreThoseOfTheHats) {
  for (double exponent : {1.0, 7.0, 64.0}) {
    const std::vector<Point> points = Places(3000, {-20, -20}, {20, 20}, 3);
    std::vector<Vector> places;
    for (Point p : points) places.push_back({p.x, p.y});
    auto seen =
        RunBlock("hex_shares", {{"place", Vectors(places)}, {"exponent", Floats({exponent})}});
    ASSERT_EQ(seen.size(), 4u);
    Setting s;
    s.scale = {1, 1};
    s.exponent = exponent;
    for (size_t i = 0; i < points.size(); ++i) {
      double sum = 0;
      const char* names[] = {"first", "second", "third"};
      for (size_t k = 0; k < 3; ++k) {
        double wanted = 0;
        for (const Hexagon& h : HexagonsAt(points[i], s)) {
          if (seen[names[k]].Int(i, 0) == h.column && seen[names[k]].Int(i, 1) == h.row) {
            wanted = h.share;
          }
        }
        ASSERT_NEAR(seen["shares"].Float(i, k), wanted, 2e-4) << points[i].x << " " << points[i].y;
        sum += seen["shares"].Float(i, k);
      }
      ASSERT_NEAR(sum, 1, 1e-6);
    }
  }
}

// How many hexagons count in the mean: b2 / b1 is above r = 0.01^(1 / exponent) in the share of the
// triangle that the integral of (1 + x + y)^-3 over x from r to 1 and y from 0 to 1 gives.
TEST(HexSharesTest, LeaveOutWhatIsNotSeen) {
  for (double exponent : {4.0, 7.0, 16.0}) {
    auto seen = RunBlock(
        "hex_shares", {{"place", Vectors(Lattice(-4, 4, 211))}, {"exponent", Floats({exponent})}});
    ASSERT_EQ(seen.size(), 4u);
    size_t counted = 0;
    const Values& shares = seen["shares"];
    for (size_t i = 0; i < shares.count; ++i) {
      for (size_t k = 0; k < 3; ++k) counted += shares.Float(i, k) > 0;
    }
    const double r = std::pow(0.01, 1 / exponent);
    const double wanted = 1 + 6 * ((1 / (1 + r) - 0.5) - (1 / (2 + r) - 1.0 / 3));
    const double mean = static_cast<double>(counted) / static_cast<double>(shares.count);
    EXPECT_NEAR(mean, wanted, 0.01) << exponent;
    if (exponent == 7) {
      EXPECT_LE(mean, 1.6);
    }
  }
}

// The frame of a hexagon: its axes lead from its middle to the point, and it repeats.
TEST(HexFrameTest, IsTurnedAboutTheMiddle) {
  const std::vector<Vector> uv = Lattice(-1, 1, 12);
  auto out = RunBlock("hex_frame", {{"uv", Vectors(uv)},
                                    {"cells", Vectors({{4, 6}})},
                                    {"node", CellsOf({{-3, 5}})},
                                    {"rotation", Vectors({{-180, 180}})},
                                    {"period", CellsOf({{4, 3}})},
                                    {"seed", Ints({9})}});
  ASSERT_EQ(out.size(), 2u);
  const Values& tile = out["tile"];
  const uint32_t seed = CellHash(1, 1, 9);
  const double angle = (-180 + 360 * reference::Unit24(Pcg(seed - 2))) * std::numbers::pi / 180;
  const double c = std::cos(angle), s = std::sin(angle);
  for (size_t i = 0; i < uv.size(); ++i) {
    ASSERT_EQ(tile.Int(i, 0), 1);
    ASSERT_EQ(tile.Int(i, 1), 1);
    ASSERT_EQ(tile.Uint(i, 6), seed);
    const double axes[4] = {c, s, -s, c};
    for (size_t k = 0; k < 4; ++k) ASSERT_NEAR(tile.Float(i, 7 + k), axes[k], 1e-6);
    const double along = (tile.Float(i, 2) - 0.5) * tile.Float(i, 4);
    const double up = (tile.Float(i, 3) - 0.5) * tile.Float(i, 5);
    ASSERT_NEAR(-2.5 / 4 + along * c - up * s, uv[i][0], 1e-5);
    ASSERT_NEAR(5.0 / 6 + along * s + up * c, uv[i][1], 1e-5);
    ASSERT_NEAR(out["place"].Float(i, 0), 1.5 / 4 + along, 1e-5);
    ASSERT_NEAR(out["place"].Float(i, 1), 1.0 / 6 + up, 1e-5);
  }
}

// ---- The colours.

// Where it is looked at, as a colour; blue says which hexagon.
constexpr char kWhere[] = R"({"texgraph": 1, "functions": {
    "where": {"inputs": {"uv": "vec2", "tile": "Tile"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "luck": {"block": "tile_random", "in": {"tile": "tile"}},
        "c": {"block": "combine4", "in": {"x": "p.x", "y": "p.y", "z": "luck", "w": 1}}},
      "outputs": {"color": "c"}},
    "across": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}}}, "outputs": {"value": "p.x"}}},
    "nodes": {"n": {"block": "hex_tiling", "in": {"image": "where", )";

TEST(HexTilingTest, IsAsByBruteForce) {
  Setting plain, turned, stretched, weighed, repeated;
  turned.rotation = {20, 95};
  turned.exponent = 2;
  turned.contrast = 0;
  stretched.tiling = {2, 0.7};
  stretched.scale = {3, 7};
  stretched.offset = {0.25, 3};
  stretched.seed = -5;
  weighed.contrast = 1;
  weighed.seed = 77;
  repeated.columns = 4;
  repeated.rows = 5;
  for (const Setting& s : {plain, turned, stretched, weighed, repeated}) {
    const bool is_weighed = s.seed == 77;
    const std::vector<Point> points = Places(600, {5, 5}, {25, 25}, 11);
    auto out =
        RunGraph(std::string(kWhere) + PortsOf(s) + (is_weighed ? R"(, "weight": "across")" : "") +
                     R"(}}}, "outputs": {"color": "n"}})",
                 points, {1e-4, 1e-4}, 5e-3);
    ASSERT_EQ(out.size(), 1u);
    for (size_t i = 0; i < points.size(); ++i) {
      double sum[4] = {0, 0, 0, 0};
      for (const Hexagon& h : HexagonsAt(points[i], s)) {
        const double luck = reference::Unit24(Pcg(h.seed));
        const double light = 0.2126 * h.place.x + 0.7152 * h.place.y + 0.0722 * luck;
        double weight = reference::Mix(1, light, s.contrast) * (is_weighed ? h.place.x : 1);
        weight = h.share * std::max(weight, 0.001);
        const double color[4] = {h.place.x, h.place.y, luck, 1};
        for (size_t k = 0; k < 4; ++k) sum[k] += weight * color[k];
      }
      for (size_t k = 0; k < 3; ++k) {
        ASSERT_NEAR(out["color"].Float(i, k), sum[k] / sum[3], 2e-3)
            << PortsOf(s) << " at " << points[i].x << " " << points[i].y;
      }
    }
  }
}

// Far to all sides of the origin, where cells have great numbers.
TEST(HexTilingTest, IsTheSameFarAway) {
  Setting s;
  s.contrast = 0;
  for (double x : {-900.0, 900.0}) {
    for (double y : {-900.0, 900.0}) {
      const std::vector<Point> points = Places(100, {x, y}, {x + 4, y + 4}, 12);
      auto out = RunGraph(std::string(kWhere) + PortsOf(s) + R"(}}}, "outputs": {"color": "n"}})",
                          points, {1e-4, 1e-4}, 5e-2);
      ASSERT_EQ(out.size(), 1u);
      for (size_t i = 0; i < points.size(); ++i) {
        double wanted = 0;
        for (const Hexagon& h : HexagonsAt(points[i], s)) {
          wanted += h.share * reference::Unit24(Pcg(h.seed));
        }
        ASSERT_NEAR(out["color"].Float(i, 2), wanted, 0.02);
      }
    }
  }
}

// O28, and so the shares of what is seen add up to 1, for every type and weight.
TEST(HexTilingTest, TheSameEverywhereGivesTheSame) {
  const std::vector<Point> points = Places(300, {-9, -9}, {9, 9}, 4);
  for (double contrast : {0.0, 0.6, 1.0}) {
    for (double exponent : {1.0, 7.0, 64.0}) {
      Setting s;
      s.contrast = contrast;
      s.exponent = exponent;
      for (const std::array<double, 4>& color :
           {std::array<double, 4>{0.2, 0.7, 0.4, 0.5}, {0, 0, 0, 1}, {3, 8, 0.1, 1}}) {
        std::string text = R"({"texgraph": 1, "nodes": {
            "c4": {"block": "color_constant", "in": {"value": [)";
        for (double channel : color) text += std::to_string(channel) + ",";
        text.back() = ']';
        text += R"(}}, "c3": {"block": "rgb", "in": {"color": "c4"}},
            "c1": {"block": "channel", "in": {"color": "c4", "name": "g"}},)";
        for (const char* n : {"4", "3", "1"}) {
          text += std::string(R"("n)") + n + R"(": {"block": "hex_tiling", "in": {"image": "c)" +
                  n + R"(", )" + PortsOf(s) + "}},";
        }
        text.back() = '}';
        text += R"(, "outputs": {"color": "n4", "emission": "n3", "height": "n1"}})";
        auto out = RunGraph(text, points, {0.01, 0.01});
        ASSERT_EQ(out.size(), 3u);
        for (size_t i = 0; i < points.size(); ++i) {
          for (size_t k = 0; k < 4; ++k) {
            ASSERT_NEAR(out["color"].Float(i, k), color[k], 2e-6 * (1 + color[k]));
          }
          ASSERT_NEAR(out["emission"].Float(i, 1), color[1], 2e-6 * (1 + color[1]));
          ASSERT_NEAR(out["height"].Float(i), color[1], 2e-6 * (1 + color[1]));
        }
      }
    }
  }
}

// With nothing random it is the picture itself.
TEST(HexTilingTest, WithoutChanceItIsThePicture) {
  Setting s;
  s.rotation = s.offset = {0, 0};
  s.tiling = {3, 2};
  const std::vector<Point> points = Places(300, {-9, -9}, {9, 9}, 4);
  auto out = RunGraph(std::string(kWhere) + PortsOf(s) + R"(}}}, "outputs": {"color": "n"}})",
                      points, {0.01, 0.01}, 1e-3);
  ASSERT_EQ(out.size(), 1u);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(out["color"].Float(i, 0), 3 * points[i].x, 1e-4);
    EXPECT_NEAR(out["color"].Float(i, 1), 2 * points[i].y, 1e-4);
  }
}

// Which hexagons count, and which most.
std::set<std::pair<int, int>> StatusAt(Point p, const Setting& s) {
  std::set<std::pair<int, int>> status;
  std::pair<int, int> top;
  double most = 0;
  for (const Hexagon& h : HexagonsAt(p, s)) {
    status.insert({h.column, h.row});
    if (h.share > most) {
      most = h.share;
      top = {h.column + 1000, h.row};
    }
  }
  status.insert(top);
  return status;
}

// Across all borders: of triangles, of hexagons, and where one begins to count. Every hexagon has a
// colour of its own, so that nothing but the shares changes.
TEST(HexTilingTest, HasNoSeams) {
  Setting s;
  const std::vector<Point> ends = Places(1200, {-5, -5}, {5, 5}, 6);
  std::vector<Point> sides;
  for (size_t i = 0; i + 1 < ends.size(); i += 2) {
    Point a = ends[i], b = {a.x + 0.1 * (ends[i + 1].x / 5), a.y + 0.1 * (ends[i + 1].y / 5)};
    const auto status = StatusAt(a, s);
    if (StatusAt(b, s) == status) continue;
    while (std::hypot(b.x - a.x, b.y - a.y) > 4e-6) {
      const Point middle = {0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
      (StatusAt(middle, s) == status ? a : b) = middle;
    }
    sides.push_back(a);
    sides.push_back(b);
  }
  ASSERT_GT(sides.size(), 400u);
  auto out = RunGraph(std::string(kWhere) + PortsOf(s) +
                          R"(, "weight": 1}}, "blue": {"block": "channel", "in": {"color": "n",
                          "name": "b"}}}, "outputs": {"height": "blue"}})",
                      sides, {1e-7, 1e-7}, 5e-3);
  ASSERT_EQ(out.size(), 1u);
  for (size_t i = 0; i < sides.size(); i += 2) {
    // Shares grow by at most 100 for each unit here.
    ASSERT_NEAR(out["height"].Float(i), out["height"].Float(i + 1), 1e-3)
        << sides[i].x << " " << sides[i].y;
  }
}

TEST(HexTilingTest, RepeatsAfterItsPeriod) {
  Setting s;
  s.tiling = {2, 2};
  s.columns = 7;
  s.rows = 8;
  std::vector<Point> points = Places(200, {0, 0}, {1, 1}, 8);
  for (size_t i = 0; i < 200; ++i) points.push_back({points[i].x - 2, points[i].y + 3});
  for (bool repeats : {true, false}) {
    if (!repeats) s.columns = s.rows = 0;
    auto out = RunGraph(std::string(kWhere) + PortsOf(s) + R"(}}}, "outputs": {"color": "n"}})",
                        points, {1e-4, 1e-4}, 5e-3);
    ASSERT_EQ(out.size(), 1u);
    double difference = 0;
    for (size_t i = 0; i < 200; ++i) {
      for (size_t k = 0; k < 3; ++k) {
        const double jump = std::fabs(out["color"].Float(i, k) - out["color"].Float(i + 200, k));
        difference = std::max(difference, jump);
      }
    }
    EXPECT_EQ(difference < 2e-3, repeats) << difference;
  }
}

// ---- Filtering.

constexpr char kPainted[] =
    R"({"texgraph": 1, "textures": {"paint": {"file": "brick.png"}}, "nodes": {
      "picture": {"block": "image", "in": {"picture": "paint"}},
      "n": {"block": "hex_tiling", "in": {"image": "picture", )";

// Each level of the texture says which it is: all places have that which the pixel's size asks for,
// however they are turned, also where hexagons meet.
TEST(HexTilingTest, SamplesTheLevelOfThePixel) {
  ir::Texture paint;
  for (uint32_t side = 256, level = 0; side > 0; side /= 2, ++level) {
    const float grey = 0.125f * static_cast<float>(level);
    paint.levels.push_back({side, side, 1, {}});
    paint.levels.back().texels.assign(size_t{side} * side, {grey, grey, grey, 1});
  }
  Setting s;
  s.tiling = {3, 3};
  for (double level : {1.0, 2.5, 4.0}) {
    const double pixel = std::exp2(level) / 256 / 3;
    const std::vector<Point> points = Places(200, {-3, -3}, {3, 3}, 9);
    auto out = RunGraph(std::string(kPainted) + PortsOf(s) + R"(}}}, "outputs": {"color": "n"}})",
                        points, {pixel, 0.7 * pixel}, 1e-3, PictureFolder(), {{"paint", paint}});
    ASSERT_EQ(out.size(), 1u);
    for (size_t i = 0; i < points.size(); ++i) {
      ASSERT_NEAR(out["color"].Float(i), 0.125 * level, 1e-3);
    }
  }
}

struct Moments {
  double mean = 0, deviation = 0;
};
Moments MomentsOf(const Values& values) {
  double sum = 0, squares = 0;
  for (size_t i = 0; i < values.count; ++i) {
    sum += values.Float(i);
    squares += double{values.Float(i)} * values.Float(i);
  }
  const double n = static_cast<double>(values.count);
  return {sum / n, std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n)))};
}

// Texels that are black or white, a quarter white.
ir::Texture Specks() {
  std::mt19937 random(2);
  ir::Texture paint;
  paint.levels.push_back({64, 64, 1, {}});
  for (int i = 0; i < 64 * 64; ++i) {
    const float grey = random() % 4 == 0 ? 1.0f : 0.0f;
    paint.levels[0].texels.push_back({grey, grey, grey, 1});
  }
  ir::BuildMipChain(paint);
  return paint;
}

Moments MomentsOfSpecks(const Setting& s, double pixel) {
  auto out = RunGraph(std::string(kPainted) + PortsOf(s) +
                          R"(}}, "red": {"block": "channel", "in": {"color": "n", "name": "r"}}},
                          "outputs": {"height": "red"}})",
                      Places(4000, {-30, -30}, {30, 30}, 10), {pixel, pixel}, 1e-3, PictureFolder(),
                      {{"paint", Specks()}});
  return MomentsOf(out["height"]);
}

// From far away it is the picture's mean, whatever the contrast.
TEST(HexTilingTest, GoesToTheMeanOfThePicture) {
  const double mean = Specks().levels.back().texels[0][0];
  Setting s;
  for (double contrast : {0.0, 0.6, 1.0}) {
    s.contrast = contrast;
    const Moments far = MomentsOfSpecks(s, 2);
    EXPECT_NEAR(far.mean, mean, 1e-5);
    EXPECT_NEAR(far.deviation, 0, 1e-4);
  }
}

// What samples that have nothing to do with each other lose in a mean with these shares.
TEST(HexTilingTest, KeepsMeanAndContrast) {
  const double mean = Specks().levels.back().texels[0][0];
  Setting s;
  s.contrast = 0;
  s.exponent = 64;
  const Moments sharp = MomentsOfSpecks(s, 1e-4);
  for (double exponent : {1.0, 7.0}) {
    s.exponent = exponent;
    const Moments seen = MomentsOfSpecks(s, 1e-4);
    EXPECT_NEAR(seen.mean, mean, 0.015);
    double lost = 0, lost_sharp = 0;
    Setting sharpest = s;
    sharpest.exponent = 64;
    const std::vector<Point> points = Places(4000, {-30, -30}, {30, 30}, 13);
    for (Point p : points) {
      for (const Hexagon& h : HexagonsAt(p, s)) lost += h.share * h.share;
      for (const Hexagon& h : HexagonsAt(p, sharpest)) lost_sharp += h.share * h.share;
    }
    EXPECT_NEAR(seen.deviation / sharp.deviation, std::sqrt(lost / lost_sharp), 0.03) << exponent;
  }
  // White counts more than black: there is more contrast, and a little more light.
  s.exponent = 7;
  Moments last;
  for (double contrast : {0.0, 0.6, 1.0}) {
    s.contrast = contrast;
    const Moments seen = MomentsOfSpecks(s, 1e-4);
    EXPECT_GT(seen.deviation, last.deviation + 0.003) << contrast;
    EXPECT_GT(seen.mean, last.mean + 0.005) << contrast;
    if (contrast == 0.6) {
      EXPECT_LT(seen.mean, last.mean + 0.015);
    }
    last = seen;
  }
}

// ---- Normals.

TEST(HexTilingNormalTest, AKnownAngle) {
  Setting s;
  s.rotation = {37, 37};
  const std::vector<Point> points = Places(200, {-5, -5}, {5, 5}, 14);
  auto out = RunGraph(R"({"texgraph": 1, "nodes": {
      "tilted": {"block": "vec3_constant", "in": {"value": [0.6, 0, 0.8]}},
      "n": {"block": "hex_tiling_normal", "in": {"normal": "tilted", )" +
                          PortsOf(s) + R"(}}}, "outputs": {"normal": "n"}})",
                      points, {1e-3, 1e-3});
  ASSERT_EQ(out.size(), 1u);
  const double angle = 37 * std::numbers::pi / 180;
  for (size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(out["normal"].Float(i, 0), 0.6 * std::cos(angle), 1e-5);
    ASSERT_NEAR(out["normal"].Float(i, 1), 0.6 * std::sin(angle), 1e-5);
    ASSERT_NEAR(out["normal"].Float(i, 2), 0.8, 1e-5);
  }
}

// Heights are tiled by `hex_tiling` and their normals by this block; where one hexagon alone is
// seen the normals must be those of the tiled heights, which are asked at four places around.
TEST(HexTilingNormalTest, AreThoseOfTheTiledHeights) {
  Setting s;
  const std::string text =
      R"({"texgraph": 1, "functions": {
      "hill": {"inputs": {"uv": "vec2"}, "nodes": {
          "h": {"block": "gradient_noise", "in": {"uv": "uv", "scale": 5}}},
        "outputs": {"value": "h"}},
      "facing": {"inputs": {"uv": "vec2"}, "nodes": {
          "n": {"block": "height_to_normal", "in": {"height": "hill", "uv": "uv"}}},
        "outputs": {"normal": "n"}}},
    "nodes": {
      "h": {"block": "hex_tiling", "in": {"image": "hill", )" +
      PortsOf(s) + R"(}}, "n": {"block": "hex_tiling_normal", "in": {"normal": "facing", )" +
      PortsOf(s) + R"(}}}, "outputs": {"height": "h", "normal": "n"}})";
  constexpr double kStep = 1.0 / 1024;
  std::vector<Point> points;
  for (Point p : Places(1500, {-5, -5}, {5, 5}, 15)) {
    if (HexagonsAt(p, s).size() > 1) continue;
    points.insert(
        points.end(),
        {p, {p.x - kStep, p.y}, {p.x + kStep, p.y}, {p.x, p.y - kStep}, {p.x, p.y + kStep}});
  }
  ASSERT_GT(points.size(), 2000u);
  auto out = RunGraph(text, points, {1e-5, 1e-5}, 1e-2);
  ASSERT_EQ(out.size(), 2u);
  size_t compared = 0;
  for (size_t i = 0; i < points.size(); i += 5) {
    // Some of the four may lie where another hexagon begins.
    bool alone = true;
    for (size_t k = 1; k < 5; ++k) alone = alone && HexagonsAt(points[i + k], s).size() == 1;
    if (!alone) continue;
    ++compared;
    const auto height = [&](size_t k) { return double{out["height"].Float(i + k)}; };
    const double x = (height(1) - height(2)) / (2 * kStep),
                 y = (height(3) - height(4)) / (2 * kStep);
    const double length = std::sqrt(x * x + y * y + 1);
    ASSERT_NEAR(out["normal"].Float(i, 0), x / length, 0.01) << points[i].x << " " << points[i].y;
    ASSERT_NEAR(out["normal"].Float(i, 1), y / length, 0.01);
    ASSERT_NEAR(out["normal"].Float(i, 2), 1 / length, 0.01);
  }
  EXPECT_GT(compared, 300u);
}

// Slopes are mixed, by shares, steepness and the weight; each hexagon has a slope of its own.
TEST(HexTilingNormalTest, IsAsByBruteForce) {
  const std::string function = R"({"texgraph": 1, "functions": {
    "facing": {"inputs": {"uv": "vec2", "tile": "Tile"}, "nodes": {
        "x": {"block": "tile_random", "in": {"tile": "tile", "low": -0.7, "high": 0.7}},
        "v": {"block": "combine3", "in": {"x": "x", "y": 0.3, "z": 0.6}},
        "n": {"block": "normalized", "in": {"vector": "v"}}}, "outputs": {"normal": "n"}},
    "across": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}}}, "outputs": {"value": "p.x"}}},
    "nodes": {"n": {"block": "hex_tiling_normal", "in": {"normal": "facing", )";
  Setting even, weighed, turned;
  even.contrast = 0;
  weighed.seed = 77;
  turned.rotation = {-20, 30};
  turned.contrast = 1;
  turned.exponent = 3;
  for (const Setting& s : {even, weighed, turned}) {
    const std::string weight = s.seed == 77 ? R"(, "weight": "across")" : "";
    const std::vector<Point> points = Places(500, {5, 5}, {25, 25}, 16);
    auto out = RunGraph(function + PortsOf(s) + weight + R"(}}}, "outputs": {"normal": "n"}})",
                        points, {1e-4, 1e-4}, 5e-3);
    ASSERT_EQ(out.size(), 1u);
    for (size_t i = 0; i < points.size(); ++i) {
      double x = 0, y = 0, total = 0;
      for (const Hexagon& h : HexagonsAt(points[i], s)) {
        const double a = (-0.7 + 1.4 * reference::Unit24(Pcg(h.seed))) / 0.6, b = 0.5;
        const double sine = std::sin(std::atan(std::hypot(a, b)));
        const double own = reference::Mix(1, sine, s.contrast) * (s.seed == 77 ? h.place.x : 1);
        const double share = h.share * std::max(own, 0.001);
        x += share * (a * std::cos(h.angle) - b * std::sin(h.angle));
        y += share * (a * std::sin(h.angle) + b * std::cos(h.angle));
        total += share;
      }
      const double length = std::sqrt(x * x + y * y + total * total);
      ASSERT_NEAR(out["normal"].Float(i, 0), x / length, 2e-3) << PortsOf(s);
      ASSERT_NEAR(out["normal"].Float(i, 1), y / length, 2e-3) << PortsOf(s);
      ASSERT_NEAR(out["normal"].Float(i, 2), total / length, 2e-3) << PortsOf(s);
    }
  }
}

}  // namespace
}  // namespace texgraph::blocks
