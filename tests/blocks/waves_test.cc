// SPDX-License-Identifier: Apache-2.0
// Waves, gradients and staircases against the mean of many samples over the pixel.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using Wave = std::function<double(double)>;

constexpr double kTurn = 2 * std::numbers::pi;

double MeanOf(const Wave& wave, double middle, double width) {
  constexpr int kSamples = 20000;
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) {
    sum += wave(middle + width * ((i + 0.5) / kSamples - 0.5));
  }
  return sum / kSamples;
}

double Fraction(double x) { return x - std::floor(x); }
double Triangle(double x) { return std::fabs(2 * std::remainder(x, 1)); }
double Clamped(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

// The block's port gets x of the texture plane, and a pixel is `width` wide and high.
void CheckMean(const std::string& block, const std::string& port, const std::string& ports,
               const Wave& wave, double tolerance = 2e-4) {
  for (double width : {1e-5, 0.003, 0.09, 0.35, 0.77, 1.0, 2.3, 11.9}) {
    std::vector<Point> points;
    for (int i = 0; i < 60; ++i) {
      points.push_back({7 * Fraction(0.1234 + 0.7548776662 * i) - 3.5, 0.25});
    }
    // Close to the places where something happens.
    for (double at : {-1.0, -0.5, 0.0, 0.3, 0.5, 1.0, 2.0}) {
      points.push_back({at + 0.2 * width, 0.5});
      points.push_back({at - 0.3 * width, 0.5});
    }
    auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
        "c": {"block": "components", "in": {"vector": "uv"}},
        "n": {"block": ")" + block +
                                R"(", "in": {")" + port + R"(": "c.x")" + ports + R"(}}},
        "outputs": {"height": "n"}})",
                            points, {width, width}, 1e-3);
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < points.size(); ++i) {
      double wanted = MeanOf(wave, static_cast<float>(points[i].x), width);
      // The pixel's width, as a difference of floats, is only known so well.
      double slack = tolerance + 2e-7 / width;
      ASSERT_NEAR(outputs["height"].Float(i), wanted, slack)
          << block << ports << " at " << points[i].x << ", " << width;
    }
  }
}

TEST(WavesTest, AreTheMeanOverThePixel) {
  CheckMean("sine_wave", "phase", "", [](double x) { return 0.5 + 0.5 * std::sin(kTurn * x); });
  CheckMean("sawtooth_wave", "phase", "", Fraction);
  CheckMean("triangle_wave", "phase", "", Triangle);
  for (double share : {0.3, 0.5, 0.95, 0.0, 1.0}) {
    CheckMean("square_wave", "phase", R"(, "share": )" + std::to_string(share),
              [&](double x) { return Fraction(x) < share ? 1 : 0; });
  }
}

TEST(WavesTest, SpreadGoesOnBeyondItsEnds) {
  CheckMean("spread_range", "value", "", Clamped);
  CheckMean("spread_range", "value", R"(, "spread": "repeat")", Fraction);
  CheckMean("spread_range", "value", R"(, "spread": "reflect")",
            [](double x) { return Triangle(x / 2); });
}

TEST(QuantizeTest, IsTheMeanOfTheStairs) {
  CheckMean("quantize", "value", R"(, "steps": 3, "rounding": "down")",
            [](double x) { return std::floor(3 * x) / 3; });
  CheckMean("quantize", "value", R"(, "steps": 5)",
            [](double x) { return std::floor(5 * x + 0.5) / 5; });
  CheckMean("quantize", "value", R"(, "steps": 2, "rounding": "up")",
            [](double x) { return std::ceil(2 * x) / 2; });
}

// One node that stands alone, at points of the plane.
Values RunNode(const std::string& node, const std::vector<Point>& points, double pixel) {
  auto outputs =
      RunGraph(R"({"texgraph": 1, "nodes": {"n": )" + node + R"(}, "outputs": {"height": "n"}})",
               points, {pixel, pixel}, 1e-3);
  return outputs.empty() ? Floats(std::vector<double>(points.size(), NAN)) : outputs["height"];
}

// Away from jumps, with pixels that are next to nothing.
void CheckShape(const std::string& node, const std::function<double(double, double)>& wanted,
                double near_jump = 0) {
  std::vector<Point> points = ScatteredPoints(200, -1, 2);
  Values seen = RunNode(node, points, 1e-5);
  int checked = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    double t = wanted(points[i].x, points[i].y);
    if (std::fabs(std::remainder(t, 1)) < near_jump) continue;
    ++checked;
    EXPECT_NEAR(seen.Float(i), near_jump > 0 ? Fraction(t) : t, 1e-4)
        << node << " " << points[i].x << " " << points[i].y;
  }
  EXPECT_GT(checked, 150);
}

TEST(GradientsTest, Shapes) {
  CheckShape(R"({"block": "gradient_linear", "in": {"start": [0.2, 0], "end": [1, 0.6]}})",
             [](double x, double y) { return Clamped((x - 0.2) * 0.8 + y * 0.6); });
  CheckShape(R"({"block": "gradient_linear", "in": {"end": [0.25, 0], "spread": "repeat"}})",
             [](double x, double) { return 4 * x; }, 0.001);
  CheckShape(
      R"({"block": "gradient_radial", "in": {"inner_radius": 0.1, "spread": "reflect"}})",
      [](double x, double y) { return Triangle((std::hypot(x - 0.5, y - 0.5) - 0.1) / 0.8); });
  CheckShape(R"({"block": "gradient_box", "in": {"center": [0.3, 0.5], "size": [0.8, 2]}})",
             [](double x, double y) {
               return std::fmin(std::fmax(std::fabs(x - 0.3) / 0.4, std::fabs(y - 0.5)), 1);
             });
  CheckShape(
      R"({"block": "gradient_angular", "in": {"angle": 30, "count": 3}})",
      [](double x, double y) { return 3 * (std::atan2(y - 0.5, x - 0.5) / kTurn - 1.0 / 12); },
      0.002);
  CheckShape(R"({"block": "gradient_angular", "in": {"reflected": true}})",
             [](double x, double y) { return Triangle(std::atan2(y - 0.5, x - 0.5) / kTurn); });
}

// In the middle of a pixel's size all angles meet. At the jump a pixel shows some of both ends.
TEST(GradientsTest, AngularIsFilteredAtItsJumpAndInTheMiddle) {
  Values seen = RunNode(R"({"block": "gradient_angular"})",
                        {{0.5001, 0.50005}, {0.9, 0.5}, {0.9, 0.501}, {0.9, 0.499}}, 0.002);
  EXPECT_NEAR(seen.Float(0), 0.5, 0.06);
  EXPECT_NEAR(seen.Float(1), 0.5, 0.01);
  EXPECT_NEAR(seen.Float(2), 0.0, 0.01);
  EXPECT_NEAR(seen.Float(3), 1.0, 0.01);
}

TEST(GradientsTest, Ramp4IsBilinear) {
  Values seen = RunNode(R"({"block": "ramp4", "in": {"lower_left": 1, "lower_right": 2,
      "upper_left": 4, "upper_right": 8}})",
                        {{0, 0}, {1, 0}, {-1, 2}, {3, 3}, {0.25, 0.5}}, 1e-5);
  const double kWanted[] = {1, 2, 4, 8, 0.5 * (0.75 + 0.5) + 0.5 * (3 + 2)};
  for (size_t i = 0; i < 5; ++i) EXPECT_NEAR(seen.Float(i), kWanted[i], 1e-4);
}

}  // namespace
}  // namespace texgraph::blocks
