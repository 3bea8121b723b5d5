// SPDX-License-Identifier: Apache-2.0
// What changes a value or a colour: contrast, saturation, levels, curves and ramps.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

double MeanOf(const std::function<double(double)>& f, double middle, double width) {
  constexpr int kSamples = 20000;
  double sum = 0;
  for (int i = 0; i < kSamples; ++i) sum += f(middle + width * ((i + 0.5) / kSamples - 0.5));
  return sum / kSamples;
}

TEST(AdjustTest, BrightnessContrast) {
  std::vector<Argument> arguments = {
      {"contrast", Floats({3})}, {"brightness", Floats({0.1})}, {"pivot", Floats({0.25})}};
  auto run = [&](const char* port, Values values) {
    std::vector<Argument> all = arguments;
    all.push_back({port, std::move(values)});
    return RunBlock("brightness_contrast", all)["result"];
  };
  Values number = run("value", Floats({0.25, 0.5, 0}));
  Values color = run("color", Vectors({{0.25, 0.5, 0, 0.7}}));
  Values opaque = run("color", Vectors({{0.25, 0.5, 0}}));
  const float kWanted[] = {0.35f, 1.1f, -0.4f};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_FLOAT_EQ(number.Float(i), kWanted[i]);
    EXPECT_FLOAT_EQ(color.Float(0, i), kWanted[i]);
    EXPECT_FLOAT_EQ(opaque.Float(0, i), kWanted[i]);
  }
  EXPECT_EQ(color.Float(0, 3), 0.7f);
}

TEST(AdjustTest, SaturateKeepsTheLuminance) {
  for (double amount : {0.0, 0.5, 1.0, 1.7}) {
    auto outputs = RunBlock(
        "saturate", {{"color", Vectors({{0.8, 0.3, 0.1, 0.4}})}, {"amount", Floats({amount})}});
    auto opaque =
        RunBlock("saturate", {{"color", Vectors({{0.8, 0.3, 0.1}})}, {"amount", Floats({amount})}});
    ASSERT_EQ(outputs.size() + opaque.size(), 2u);
    const Values& seen = outputs["result"];
    double grey = 0.2126 * 0.8 + 0.7152 * 0.3 + 0.0722 * 0.1;
    EXPECT_NEAR(0.2126 * seen.Float(0, 0) + 0.7152 * seen.Float(0, 1) + 0.0722 * seen.Float(0, 2),
                grey, 1e-6);
    EXPECT_NEAR(seen.Float(0, 0) - seen.Float(0, 2), amount * 0.7, 1e-6);
    EXPECT_NEAR(seen.Float(0, 0), opaque["result"].Float(0, 0), 1e-7);
    EXPECT_EQ(seen.Float(0, 3), 0.4f);
  }
}

// A float of one node, whose port gets x of the texture plane.
Values RunOnX(const std::string& block, const std::string& port, const std::string& ports,
              const std::vector<Point>& points, double width) {
  auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
      "c": {"block": "components", "in": {"vector": "uv"}},
      "n": {"block": ")" + block +
                              R"(", "in": {")" + port + R"(": "c.x", )" + ports + R"(}}},
      "outputs": {"height": "n"}})",
                          points, {width, width}, 1e-3);
  return outputs.empty() ? Floats(std::vector<double>(points.size(), NAN)) : outputs["height"];
}

std::vector<Point> Line(double low, double high, int count) {
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) points.push_back({low + (high - low) * (i + 0.5) / count, 0.5});
  return points;
}

TEST(LevelsTest, AreTheMeanOverThePixel) {
  struct Row {
    double in_low, in_high, gamma, out_low, out_high;
  };
  for (Row row : {Row{0.2, 0.7, 1, 0, 1}, Row{0.2, 0.7, 2.2, 0.1, 0.9}, Row{0.6, 0.1, 0.5, 0, 1},
                  Row{0.499, 0.501, 1, 1, 0}, Row{0, 1, 3, 0, 2}}) {
    std::string ports = R"("in_low": )" + std::to_string(row.in_low) + R"(, "in_high": )" +
                        std::to_string(row.in_high) + R"(, "gamma": )" + std::to_string(row.gamma) +
                        R"(, "out_low": )" + std::to_string(row.out_low) + R"(, "out_high": )" +
                        std::to_string(row.out_high);
    auto level = [&](double x) {
      double t = std::clamp((x - row.in_low) / (row.in_high - row.in_low), 0.0, 1.0);
      return row.out_low + (row.out_high - row.out_low) * std::pow(t, 1 / row.gamma);
    };
    for (double width : {1e-4, 0.002, 0.05, 0.3, 1.5}) {
      std::vector<Point> points = Line(-0.2, 1.2, 97);
      Values seen = RunOnX("levels", "value", ports, points, width);
      for (size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(seen.Float(i), MeanOf(level, points[i].x, width), 0.003)
            << ports << " at " << points[i].x << ", " << width;
      }
    }
  }
}

TEST(LevelsTest, LeaveAlphaAlone) {
  auto color = RunBlock("levels", {{"color", Vectors({{0.25, 0.5, 0.9, 0.3}})},
                                   {"in_high", Floats({0.5})},
                                   {"gamma", Floats({2})}});
  auto opaque = RunBlock(
      "levels",
      {{"color", Vectors({{0.25, 0.5, 0.9}})}, {"in_high", Floats({0.5})}, {"gamma", Floats({2})}});
  ASSERT_EQ(color.size() + opaque.size(), 2u);
  const double kWanted[] = {std::sqrt(0.5), 1, 1};
  for (size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(color["result"].Float(0, c), kWanted[c], 1e-6);
    EXPECT_NEAR(opaque["result"].Float(0, c), kWanted[c], 1e-6);
  }
  EXPECT_EQ(color["result"].Float(0, 3), 0.3f);
}

struct Stop {
  double place;
  Vector color;
};

// Between stops a straight line or 3t^2 - 2t^3, or the colour of the stop before.
Vector RampAt(const std::vector<Stop>& stops, const std::string& curve, double x) {
  if (x < stops.front().place) return stops.front().color;
  for (size_t i = 0; i + 1 < stops.size(); ++i) {
    double low = stops[i].place, high = stops[i + 1].place;
    if (x >= high) continue;
    double t = curve == "steps" ? 0 : (x - low) / (high - low);
    if (curve == "smooth") t = 3 * t * t - 2 * t * t * t;
    Vector color;
    for (size_t c = 0; c < 4; ++c) {
      color.push_back(stops[i].color[c] + t * (stops[i + 1].color[c] - stops[i].color[c]));
    }
    return color;
  }
  return stops.back().color;
}

// The mean of light and of cover, over the light's share of the cover.
Vector MeanColor(const std::vector<Stop>& stops, const std::string& curve, double x, double width) {
  Vector sum(4, 0.0);
  constexpr int kSamples = 20000;
  for (int i = 0; i < kSamples; ++i) {
    Vector color = RampAt(stops, curve, x + width * ((i + 0.5) / kSamples - 0.5));
    for (size_t c = 0; c < 3; ++c) sum[c] += color[c] * color[3] / kSamples;
    sum[3] += color[3] / kSamples;
  }
  return sum;
}

TEST(ColorRampTest, OfAListIsTheMeanOverThePixel) {
  const std::vector<Stop> stops = {{-0.2, {0.1, 0.9, 0.3, 1}}, {0.25, {1, 0.2, 0, 0.25}},
                                   {0.3, {0, 0, 1, 1}},        {0.6, {0.5, 3, 0.1, 0.5}},
                                   {0.6, {0, 1, 0, 0.75}},     {1.1, {1, 1, 1, 0.1}}};
  const std::string lists = R"("colors": [[0.1, 0.9, 0.3, 1], [1, 0.2, 0, 0.25], [0, 0, 1, 1],
      [0.5, 3, 0.1, 0.5], [0, 1, 0, 0.75], [1, 1, 1, 0.1]],
      "stops": [-0.2, 0.25, 0.3, 0.6, 0.6, 1.1])";
  for (std::string curve : {"linear", "smooth", "steps"}) {
    for (double width : {1e-4, 0.02, 0.2, 0.9, 4.0}) {
      std::vector<Point> points = Line(-0.6, 1.5, 61);
      auto outputs = RunGraph(R"({"texgraph": 1, "nodes": {
          "c": {"block": "components", "in": {"vector": "uv"}},
          "n": {"block": "color_ramp", "in": {"position": "c.x", )" +
                                  lists + R"(, "curve": ")" + curve + R"("}}},
          "outputs": {"color": "n"}})",
                              points, {width, width}, 1e-3);
      ASSERT_EQ(outputs.size(), 1u);
      for (size_t i = 0; i < points.size(); ++i) {
        Vector wanted = MeanColor(stops, curve, points[i].x, width);
        double alpha = outputs["color"].Float(i, 3);
        ASSERT_NEAR(alpha, wanted[3], 4e-4) << curve << points[i].x << " " << width;
        for (size_t c = 0; c < 3; ++c) {
          ASSERT_NEAR(outputs["color"].Float(i, c) * alpha, wanted[c], 1e-3)
              << curve << " " << points[i].x << ", " << width;
        }
      }
    }
  }
}

TEST(ColorRampTest, UnfilteredIsTheRampItself) {
  const std::vector<Stop> stops = {
      {0.1, {0, 1, 0.5, 1}}, {0.5, {1, 0, 0, 0.2}}, {0.9, {0, 0, 1, 1}}};
  std::vector<double> places;
  for (int i = 0; i < 40; ++i) places.push_back(-0.1 + 0.0313 * i);
  for (std::string curve : {"linear", "smooth", "steps"}) {
    auto outputs = RunBlock(
        "color_ramp", {{"position", Floats(places)},
                       {"colors", List{Vectors({stops[0].color, stops[1].color, stops[2].color})}},
                       {"stops", List{Floats({0.1, 0.5, 0.9})}},
                       {"curve", Word{curve}},
                       {"filtered", Bools({false})}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < places.size(); ++i) {
      Vector wanted = RampAt(stops, curve, places[i]);
      for (size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(outputs["result"].Float(i, c), wanted[c], 1e-5) << curve << places[i];
      }
    }
  }
}

const std::vector<Point> kCurve = {{0, 0.1},   {0.2, 0.15}, {0.3, 0.8}, {0.6, 0.8},
                                   {0.7, 0.2}, {0.9, 0.25}, {1, 0.9}};

std::string CurvePorts(const std::string& rest) {
  return R"("points": [[0, 0.1], [0.2, 0.15], [0.3, 0.8], [0.6, 0.8], [0.7, 0.2], [0.9, 0.25],
      [1, 0.9]])" +
         rest;
}

// Without a pixel to speak of it passes through its points, stays between those on both sides, and
// its slope has no jumps. Steffen's slopes at points where the secants have the same sign are those
// of the parabola through three points unless that is too steep: at 0.9 it is not.
TEST(CurveTest, IsMonotoneAndSmooth) {
  for (const char* rest : {"", R"(, "filtered": false)"}) {
    Values at_points = RunOnX("curve", "value", CurvePorts(rest), kCurve, 1e-6);
    for (size_t i = 0; i < kCurve.size(); ++i) {
      EXPECT_NEAR(at_points.Float(i), kCurve[i].y, 1e-4);
    }
    constexpr int kCount = 4000;
    std::vector<Point> points = Line(-0.1, 1.1, kCount);
    Values seen = RunOnX("curve", "value", CurvePorts(rest), points, 1e-6);
    const double step = 1.2 / kCount;
    for (size_t i = 1; i + 1 < points.size(); ++i) {
      double x = points[i].x;
      for (size_t k = 0; k + 1 < kCurve.size(); ++k) {
        if (x < kCurve[k].x || x > kCurve[k + 1].x) continue;
        EXPECT_GE(seen.Float(i), std::fmin(kCurve[k].y, kCurve[k + 1].y) - 1e-5) << x;
        EXPECT_LE(seen.Float(i), std::fmax(kCurve[k].y, kCurve[k + 1].y) + 1e-5) << x;
      }
      if (x < 2 * step || x > 1 - 2 * step) continue;
      double bend = (seen.Float(i + 1) - 2.0 * seen.Float(i) + seen.Float(i - 1)) / step;
      // The greatest second derivative is near 6 * 13 / 0.1; a kink would be a jump of the slope.
      EXPECT_LE(std::fabs(bend), 1000 * step + 0.01) << x;
    }
    Values beyond = RunOnX("curve", "value", CurvePorts(rest), {{-3, 0}, {7, 0}}, 1e-6);
    EXPECT_NEAR(beyond.Float(0), 0.1, 1e-6);
    EXPECT_NEAR(beyond.Float(1), 0.9, 1e-6);
  }
}

// Three points of the parabola x^2 + x, whose slopes are within Steffen's limits: the cubic is the
// parabola.
TEST(CurveTest, AParabolaIsAParabola) {
  std::vector<Point> points = Line(0, 2, 50);
  Values seen = RunOnX("curve", "value", R"("points": [[0, 0], [1, 2], [2, 6]])", points, 1e-6);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(seen.Float(i), points[i].x * points[i].x + points[i].x, 2e-5);
  }
}

TEST(CurveTest, IsTheMeanOverThePixel) {
  for (std::string interpolation : {"linear", "monotone", "steps"}) {
    std::string rest = R"(, "interpolation": ")" + interpolation + R"(")";
    // The curve itself, as it is without filtering, at 10 places in each of 24,000 parts.
    std::vector<Point> fine = Line(-0.1, 1.1, 24000);
    Values curve =
        RunOnX("curve", "value", CurvePorts(rest + R"(, "filtered": false)"), fine, 1e-6);
    auto at = [&](double x) {
      if (x <= 0) return kCurve.front().y;
      if (x >= 1) return kCurve.back().y;
      return static_cast<double>(curve.Float(static_cast<size_t>((x + 0.1) / 1.2 * 24000)));
    };
    for (double width : {0.03, 0.25, 1.7}) {
      std::vector<Point> points = Line(-0.4, 1.4, 50);
      Values seen = RunOnX("curve", "value", CurvePorts(rest), points, width);
      for (size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(seen.Float(i), MeanOf(at, points[i].x, width), 1.5e-3)
            << interpolation << points[i].x << " " << width;
      }
    }
  }
}

}  // namespace
}  // namespace texgraph::blocks
