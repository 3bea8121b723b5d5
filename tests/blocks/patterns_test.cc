// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using reference::Clamp;
using reference::Mix;
using reference::OverlapWithCells;

// A float output of one node, which stands alone in a graph.
Values RunNode(const std::string& node, const std::vector<Point>& points, Point pixel) {
  std::string text =
      R"({"texgraph": 1, "nodes": {"n": )" + node + R"(}, "outputs": {"height": "n"}})";
  auto outputs = RunGraph(text, points, pixel);
  return outputs.empty() ? Floats(std::vector<double>(points.size(), NAN)) : outputs["height"];
}

// The mean over [low, high] of the wave that is 1 in even cells and -1 in odd ones.
double SquareWaveMean(double low, double high) {
  double even = 2 * OverlapWithCells(low / 2, high / 2, 0, 0.5);
  return 2 * even / (high - low) - 1;
}

TEST(CheckerTest, IsTheBoxIntegralAtEveryPixelSize) {
  for (double pixel : {0.0005, 0.01, 0.03, 0.1, 0.37, 2.3}) {
    std::vector<Point> points = ScatteredPoints(200, -2, 3);
    Values seen =
        RunNode(R"({"block": "checker", "in": {"scale": [8, 5]}})", points, {pixel, pixel});
    for (size_t i = 0; i < points.size(); ++i) {
      double x = 8 * points[i].x, y = 5 * points[i].y;
      double wave = SquareWaveMean(x - 4 * pixel, x + 4 * pixel) *
                    SquareWaveMean(y - 2.5 * pixel, y + 2.5 * pixel);
      ASSERT_NEAR(seen.Float(i), 0.5 - 0.5 * wave, 0.004)
          << points[i].x << " " << points[i].y << " " << pixel;
    }
  }
}

TEST(CheckerTest, FarAwayItIsTheMean) {
  std::vector<Point> points = ScatteredPoints(50, -2, 3);
  Values seen =
      RunNode(R"({"block": "checker", "in": {"scale": 64, "a": 0.2, "b": 0.6}})", points, {1, 1});
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(seen.Float(i), 0.4, 1e-4);
  }
}

TEST(CheckerTest, TheSquareAtTheOriginHasTheFirstValue) {
  Values seen = RunNode(R"({"block": "checker", "in": {"scale": 2, "a": 3, "b": 7}})",
                        {{0.2, 0.2}, {0.7, 0.2}, {0.2, 0.7}, {-0.2, 0.2}}, {1e-4, 1e-4});
  EXPECT_NEAR(seen.Float(0), 3, 0.005);
  EXPECT_NEAR(seen.Float(1), 7, 0.005);
  EXPECT_NEAR(seen.Float(2), 7, 0.005);
  EXPECT_NEAR(seen.Float(3), 7, 0.005);
}

TEST(CheckerTest, AMirroredPatternIsFilteredAlike) {
  for (double pixel : {0.0005, 0.1, 2.3}) {
    std::vector<Point> points = ScatteredPoints(100, -2, 3);
    Values seen =
        RunNode(R"({"block": "checker", "in": {"scale": [-8, 5]}})", points, {pixel, pixel});
    for (size_t i = 0; i < points.size(); ++i) {
      double x = -8 * points[i].x, y = 5 * points[i].y;
      double wave = SquareWaveMean(x - 4 * pixel, x + 4 * pixel) *
                    SquareWaveMean(y - 2.5 * pixel, y + 2.5 * pixel);
      ASSERT_NEAR(seen.Float(i), 0.5 - 0.5 * wave, 0.004) << pixel;
    }
  }
}

TEST(RampTest, RisesAlongItsAxisAndIsConstantBeyond) {
  std::vector<Point> points = {{-1, 0.3}, {0.25, 0.9}, {0.5, -2}, {3, 0.1}};
  Values across = RunNode(R"({"block": "ramp", "in": {"a": 2, "b": 4}})", points, {0.01, 0.01});
  Values up = RunNode(R"({"block": "ramp", "in": {"a": 2, "b": 4, "direction": "up"}})", points,
                      {0.01, 0.01});
  const float kAcross[] = {2, 2.5, 3, 4};
  const float kUp[] = {2.6f, 3.8f, 2, 2.2f};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(across.Float(i), kAcross[i], 1e-6);
    EXPECT_NEAR(up.Float(i), kUp[i], 1e-6);
  }
}

double ValueNoise(double x, double y, uint32_t seed) {
  int32_t cx = static_cast<int32_t>(std::floor(x)), cy = static_cast<int32_t>(std::floor(y));
  auto fade = [](double t) {
    return 6 * std::pow(t, 5) - 15 * std::pow(t, 4) + 10 * std::pow(t, 3);
  };
  auto corner = [&](int dx, int dy) {
    return reference::Unit24(reference::CellHash(cx + dx, cy + dy, seed));
  };
  double u = fade(x - cx), v = fade(y - cy);
  return Mix(Mix(corner(0, 0), corner(1, 0), u), Mix(corner(0, 1), corner(1, 1), u), v);
}

TEST(ValueNoiseTest, InterpolatesHashesOfTheCorners) {
  std::vector<Point> points = ScatteredPoints(500, -2, 3);
  Values seen = RunNode(R"({"block": "value_noise", "in": {"scale": [7, 11], "seed": 42}})", points,
                        {0.001, 0.001});
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(seen.Float(i), ValueNoise(7 * points[i].x, 11 * points[i].y, 42), 2e-5);
  }
}

TEST(ValueNoiseTest, RangeMeanAndSlope) {
  std::vector<Point> points;
  constexpr double kStep = 1.0 / 64;  // of a cell
  for (int i = 0; i < 40000; ++i) {
    points.push_back({i * kStep, 0.37 + 0.5 * std::floor(i * kStep)});
  }
  Values seen = RunNode(R"({"block": "value_noise", "in": {"scale": 1}})", points, {1e-4, 1e-4});
  double sum = 0, low = 1, high = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    double value = seen.Float(i);
    sum += value;
    low = std::min(low, value);
    high = std::max(high, value);
    if (i > 0 && points[i].y == points[i - 1].y) {
      // The steepest slope of the fade curve is 15/8.
      EXPECT_LE(std::fabs(value - seen.Float(i - 1)), 1.875 * kStep + 1e-6);
    }
  }
  EXPECT_GE(low, 0);
  EXPECT_LE(high, 1);
  EXPECT_LT(low, 0.1);
  EXPECT_GT(high, 0.9);
  EXPECT_NEAR(sum / static_cast<double>(points.size()), 0.5, 0.03);
}

TEST(ValueNoiseTest, FadesToItsMean) {
  std::vector<Point> points = ScatteredPoints(100, -2, 3);
  Values far = RunNode(R"({"block": "value_noise", "in": {"scale": 10}})", points, {0.1, 0.1});
  Values half = RunNode(R"({"block": "value_noise", "in": {"scale": 10}})", points, {0.075, 0.01});
  Values near = RunNode(R"({"block": "value_noise", "in": {"scale": 10}})", points, {0.05, 0.05});
  for (size_t i = 0; i < points.size(); ++i) {
    double noise = ValueNoise(10 * points[i].x, 10 * points[i].y, 0);
    EXPECT_NEAR(far.Float(i), 0.5, 1e-4);
    EXPECT_NEAR(half.Float(i), Mix(noise, 0.5, 0.5), 1e-3);
    EXPECT_NEAR(near.Float(i), noise, 1e-3);
  }
}

TEST(ValueNoiseTest, MirroredNoiseFadesAlike) {
  std::vector<Point> points = ScatteredPoints(100, -2, 3);
  const char* node = R"({"block": "value_noise", "in": {"scale": [-10, 10]}})";
  Values far = RunNode(node, points, {0.1, 0.01});
  Values near = RunNode(node, points, {0.001, 0.001});
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(far.Float(i), 0.5, 1e-4);
    EXPECT_NEAR(near.Float(i), ValueNoise(-10 * points[i].x, 10 * points[i].y, 0), 1e-4);
  }
}

TEST(RectangleTest, IsTheShareOfThePixel) {
  for (double pixel : {0.001, 0.05, 0.48}) {
    std::vector<Point> points = ScatteredPoints(300, -2, 3);
    Values seen =
        RunNode(R"({"block": "rectangle", "in": {"center": [0.4, 0.6], "size": [0.8, 0.3]}})",
                points, {pixel, pixel});
    for (size_t i = 0; i < points.size(); ++i) {
      auto overlap = [&](double p, double low, double high) {
        return std::fmax(0, std::fmin(p + pixel / 2, high) - std::fmax(p - pixel / 2, low)) / pixel;
      };
      double wanted = overlap(points[i].x, 0, 0.8) * overlap(points[i].y, 0.45, 0.75);
      EXPECT_NEAR(seen.Float(i), wanted, 2e-3) << points[i].x << " " << points[i].y << " " << pixel;
    }
  }
}

// Shapes in tiles that are smaller than a pixel: the mean of the unit square.
TEST(ShapesTest, FromFarAwayTheyAreTheirShareOfTheUnitSquare) {
  std::vector<Point> points = ScatteredPoints(50, -2, 3);
  for (double pixel : {1.0, 3.0, 100.0}) {
    Values rectangle =
        RunNode(R"({"block": "rectangle", "in": {"center": [0.4, 0.6], "size": [0.8, 0.3]}})",
                points, {pixel, pixel});
    Values circle =
        RunNode(R"({"block": "circle", "in": {"radius": 0.3}})", points, {pixel, pixel});
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(rectangle.Float(i), 0.24, 1e-5);
      EXPECT_NEAR(circle.Float(i), 0.09 * 3.14159265, 1e-5);
    }
  }
}

TEST(CircleTest, InsideEdgeAndOutside) {
  Values seen =
      RunNode(R"({"block": "circle", "in": {"radius": 0.3}})",
              {{0.5, 0.5}, {0.78, 0.5}, {0.8, 0.5}, {0.5, 0.205}, {0.5, 0.1}}, {0.02, 0.02});
  EXPECT_EQ(seen.Float(0), 1.0f);
  EXPECT_EQ(seen.Float(1), 1.0f);
  EXPECT_NEAR(seen.Float(2), 0.5, 1e-3);
  EXPECT_NEAR(seen.Float(3), 0.75, 1e-3);
  EXPECT_EQ(seen.Float(4), 0.0f);
}

// Piecewise linear through the stops, in every channel.
TEST(ColorRampTest, GoesThroughItsStops) {
  const double kStops[] = {0.1, 0.3, 0.6, 0.9};
  const double kRed[] = {0, 1, 0.25, 0.75};
  std::vector<Point> points;
  for (int i = -20; i <= 120; ++i) {
    points.push_back({i / 100.0 + 0.0003, 0});
  }
  for (int stops = 2; stops <= 4; ++stops) {
    std::string ports;
    for (int s = 0; s < stops; ++s) {
      std::string n = std::to_string(s + 1);
      ports += ", \"color_" + n + "\": [" + std::to_string(kRed[s]) + ", 0.5, 0, 1], \"stop_" + n +
               "\": " + std::to_string(kStops[s]);
    }
    auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
        "u": {"block": "components", "in": {"vector": "uv"}},
        "n": {"block": "color_ramp", "in": {"position": "u.x")" +
                                ports + R"(}}}, "outputs": {"color": "n"}})",
                            points, {0.001, 0.001});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < points.size(); ++i) {
      double wanted = kRed[0];
      for (int s = 1; s < stops; ++s) {
        double t = Clamp((points[i].x - kStops[s - 1]) / (kStops[s] - kStops[s - 1]), 0, 1);
        wanted = Mix(wanted, kRed[s], t);
      }
      EXPECT_NEAR(outputs["color"].Float(i, 0), wanted, 1e-4) << stops << " " << points[i].x;
      EXPECT_NEAR(outputs["color"].Float(i, 1), 0.5, 1e-6);
    }
  }
}

TEST(ColorRampTest, Curves) {
  Values position = Floats({0.25, 0.25, 0.25, 0.25});
  Values black = Vectors({{0, 0, 0, 1}}), white = Vectors({{1, 1, 1, 1}});
  auto smooth = RunBlock(
      "color_ramp",
      {{"position", position}, {"color_1", black}, {"color_2", white}, {"curve", Word{"smooth"}}});
  EXPECT_NEAR(smooth["result"].Float(0), 0.25 * 0.25 * 2.5, 1e-6);
  // In steps, one pixel wide: 0.1 a pixel to the right, the step at 0.5.
  auto steps = RunBlock("color_ramp", {{"position", Floats({0.42, 0.52, 0.42, 0.52})},
                                       {"color_1", black},
                                       {"color_2", white},
                                       {"stop_2", Floats({0.5})},
                                       {"curve", Word{"steps"}}});
  EXPECT_NEAR(steps["result"].Float(0), 0.0, 1e-5);
  EXPECT_NEAR(steps["result"].Float(1), 0.7, 1e-5);
}

}  // namespace
}  // namespace texgraph::blocks
