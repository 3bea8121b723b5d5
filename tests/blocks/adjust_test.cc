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

}  // namespace
}  // namespace texgraph::blocks
