// SPDX-License-Identifier: Apache-2.0
// Blocks that ask a function at other places or with other pixels: against sums of what the
// function is there.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

// `nodes` and the node "n" with the height that is asked for.
Values RunNode(const std::string& nodes, const std::vector<Point>& points, Point pixel,
               const std::string& output = "height") {
  auto outputs = RunGraph(
      R"({"texgraph": 1, "nodes": {"c": {"block": "components", "in": {"vector": "uv"}}, )" +
          nodes + R"(}, "outputs": {")" + output + R"(": "n"}})",
      points, pixel, 1e-3);
  return outputs.empty() ? Floats(std::vector<double>(5 * points.size(), NAN)) : outputs[output];
}

// Stripes across, four in a unit, of which 0.3 is 1.
const std::string kStripes =
    R"("phase": {"block": "multiply", "in": {"a": "c.x", "b": 4}},
       "stripes": {"block": "square_wave", "in": {"phase": "phase", "share": 0.3}})";

double StripesMean(double middle, double width) {
  auto integral = [](double x) {
    double cell = std::floor(4 * x);
    return (cell * 0.3 + std::fmin(4 * x - cell, 0.3)) / 4;
  };
  return (integral(middle + width / 2) - integral(middle - width / 2)) / width;
}

TEST(FiltersTest, WidenIsThePlaceWithAnotherPixel) {
  std::vector<Point> points = ScatteredPoints(40);
  for (Point pixel : {Point{0.001, 0.001}, {0.2, 0.003}}) {
    Values seen = RunNode(R"("w": {"block": "widen", "in": {"width": [0.11, 0.04]}},
        "k": {"block": "checker", "in": {"uv": "w", "scale": [3, 7]}},
        "n": {"block": "add", "in": {"a": "k", "b": 0}})",
                          points, pixel);
    auto wave = [](double x, double scale, double width) {
      constexpr int kSamples = 10000;
      double sum = 0;
      for (int i = 0; i < kSamples; ++i) {
        double at = scale * (x + width * ((i + 0.5) / kSamples - 0.5));
        sum += std::fmod(std::fabs(std::floor(at)), 2) == 0 ? 1 : -1;
      }
      return sum / kSamples;
    };
    for (size_t i = 0; i < points.size(); ++i) {
      double wanted = 0.5 - 0.5 * wave(points[i].x, 3, 0.11) * wave(points[i].y, 7, 0.04);
      EXPECT_NEAR(seen.Float(i), wanted, 2e-3) << points[i].x << " " << points[i].y;
    }
  }
  Values same = RunBlock("widen", {{"place", Vectors({{0.25, 7.125}})},
                                   {"width", Vectors({{1, 2}})},
                                   {"uv", Vectors({{0.3, 0.4}})}})["result"];
  EXPECT_EQ(same.Float(0, 0), 0.25f);
  EXPECT_EQ(same.Float(0, 1), 7.125f);
}

// Binomial weights and boxes that touch are a known curve: the mean of the stripes over each box.
TEST(FiltersTest, BlurIsASumOfBoxes) {
  std::vector<Point> points = ScatteredPoints(40);
  const double radius = 0.07, pixel = 0.01;
  for (int taps : {1, 2, 3, 5}) {
    Values seen = RunNode(kStripes + R"(, "n": {"block": "blur", "in": {"image": "stripes",
        "radius": 0.07, "taps": )" +
                              std::to_string(taps) + "}}",
                          points, {pixel, pixel});
    double apart = radius / std::sqrt((taps - 1) / 4.0 + 1 / 12.0);
    double width = std::hypot(apart, pixel);
    for (size_t i = 0; i < points.size(); ++i) {
      double wanted = 0;
      for (int k = 0; k < taps; ++k) {
        double choose = std::tgamma(taps) / std::tgamma(k + 1) / std::tgamma(taps - k);
        wanted += choose / std::pow(2, taps - 1) *
                  StripesMean(points[i].x + (k - (taps - 1) / 2.0) * apart, width);
      }
      EXPECT_NEAR(seen.Float(i), wanted, 1e-3) << taps << " " << points[i].x;
    }
  }
}

double Normal(double x) { return 0.5 + 0.5 * std::erf(x / std::numbers::sqrt2); }

// The greatest distance between the normal distribution and that of the sum of `taps` - 1 fair
// coins and a uniform number, of the same deviation.
double FarthestFromNormal(int taps) {
  double deviation = std::sqrt((taps - 1) / 4.0 + 1 / 12.0), farthest = 0;
  for (double x = -6; x < 6; x += 0.001) {
    double sum = 0;
    for (int k = 0; k < taps; ++k) {
      double choose = std::tgamma(taps) / std::tgamma(k + 1) / std::tgamma(taps - k);
      double reached = x * deviation - k + (taps - 1) / 2.0 + 0.5;
      sum += choose / std::pow(2, taps - 1) * std::fmin(std::fmax(reached, 0), 1);
    }
    farthest = std::fmax(farthest, std::fabs(sum - Normal(x)));
  }
  return farthest;
}

// An edge becomes the distribution of the weights, so it differs from the Gaussian's no more than
// both distributions do. At a stripe two edges may add up.
TEST(FiltersTest, BlurComesToTheGaussian) {
  std::vector<Point> points = ScatteredPoints(100);
  EXPECT_LT(FarthestFromNormal(3), 0.032);
  EXPECT_LT(FarthestFromNormal(5), 0.02);
  auto gaussian = [](double x, double radius) {
    double sum = 0;
    for (int k = -8; k <= 12; ++k) {
      sum += Normal(((k + 0.3) / 4 - x) / radius) - Normal((k / 4.0 - x) / radius);
    }
    return sum;
  };
  for (int taps : {1, 3, 5, 7}) {
    Values seen = RunNode(kStripes + R"(, "n": {"block": "blur", "in": {"image": "stripes",
        "radius": 0.04, "taps": )" +
                              std::to_string(taps) + "}}",
                          points, {1e-4, 1e-4});
    double most = 2 * FarthestFromNormal(taps) + 5e-4;
    for (size_t p = 0; p < points.size(); ++p) {
      EXPECT_NEAR(seen.Float(p), gaussian(points[p].x, 0.04), most) << taps;
    }
  }
}

// Transparent red beside opaque green: half covered, and green.
TEST(FiltersTest, BlurAndPixelateWeighColoursByAlpha) {
  const std::string color = R"("color": {"block": "color_ramp", "in": {"position": "c.x",
      "colors": [[1, 0, 0, 0], [0, 1, 0, 1]], "stops": [0, 0.5], "curve": "steps"}})";
  Values blur =
      RunNode(color + R"(, "n": {"block": "blur", "in": {"image": "color", "radius": 0.1}})",
              {{0.5, 0.5}}, {1e-3, 1e-3}, "color");
  EXPECT_NEAR(blur.Float(0, 3), 0.5, 0.02);
  EXPECT_NEAR(blur.Float(0, 1), 1, 1e-4);
  EXPECT_NEAR(blur.Float(0, 0), 0, 1e-4);
  Values coarse =
      RunNode(color + R"(, "n": {"block": "pixelate", "in": {"image": "color", "scale": 8}})",
              {{0.5, 0.56}}, {0.05, 0.001}, "color");
  EXPECT_NEAR(coarse.Float(0, 3), 0.5, 0.02);
  EXPECT_NEAR(coarse.Float(0, 1), 1, 1e-4);
  EXPECT_NEAR(coarse.Float(0, 0), 0, 1e-4);
}

TEST(FiltersTest, PixelateShowsMeansOfSquares) {
  std::vector<Point> points = ScatteredPoints(60);
  for (double pixel : {0.001, 0.05, 0.3}) {
    Values seen = RunNode(
        kStripes + R"(, "n": {"block": "pixelate", "in": {"image": "stripes", "scale": [9, 5]}})",
        points, {pixel, pixel});
    for (size_t i = 0; i < points.size(); ++i) {
      // The pixel is a box over squares, and what each square has is a mean, too. A pixel larger
      // than a square sees two, with pixels as large as itself.
      double seen_width = std::fmin(pixel, 1.0 / 9), wanted = 0;
      constexpr int kSamples = 2000;
      for (int k = 0; k < kSamples; ++k) {
        double x = points[i].x + seen_width * ((k + 0.5) / kSamples - 0.5);
        wanted += StripesMean((std::floor(9 * x) + 0.5) / 9, std::fmax(pixel, 1.0 / 9)) / kSamples;
      }
      EXPECT_NEAR(seen.Float(i), wanted, 2e-3) << points[i].x << " " << pixel;
    }
  }
}

// A bowl x^2 + xy + y / 2, whose slope differences are exact.
const std::string kBowl = R"(
    "xx": {"block": "multiply", "in": {"a": "c.x", "b": "c.x"}},
    "xy": {"block": "multiply", "in": {"a": "c.x", "b": "c.y"}},
    "rise": {"block": "multiply", "in": {"a": "c.y", "b": 0.5}},
    "sum": {"block": "add", "in": {"a": "xx", "b": "xy"}},
    "bowl": {"block": "add", "in": {"a": "sum", "b": "rise"}})";

TEST(FiltersTest, HeightToNormalHasTheSlope) {
  std::vector<Point> points = ScatteredPoints(30);
  for (double pixel : {1e-6, 0.02, 0.3}) {
    Values seen = RunNode(kBowl + R"(, "n": {"block": "height_to_normal", "in": {"height": "bowl",
        "strength": 1.5}})",
                          points, {pixel, pixel}, "normal");
    for (size_t i = 0; i < points.size(); ++i) {
      double u = 1.5 * (2 * points[i].x + points[i].y), v = 1.5 * (points[i].x + 0.5);
      double length = std::sqrt(u * u + v * v + 1);
      EXPECT_NEAR(seen.Float(i, 0), -u / length, 5e-4) << pixel;
      EXPECT_NEAR(seen.Float(i, 1), -v / length, 5e-4) << pixel;
      EXPECT_NEAR(seen.Float(i, 2), 1 / length, 5e-4) << pixel;
    }
  }
}

// Nobody knows a connected step before it is 0: the slope of nothing over nothing is none.
TEST(FiltersTest, SlopesHaveAValueWithoutAStep) {
  const std::string none = R"("none": {"block": "multiply", "in": {"a": "c.x", "b": 0}},)" + kBowl;
  const std::vector<Point> points = ScatteredPoints(30);
  Values normals = RunNode(none + R"(, "n": {"block": "height_to_normal", "in": {
      "height": "bowl", "smallest_step": "none"}})",
                           points, {0, 0}, "normal");
  Values warped = RunNode(none + R"(, "n": {"block": "warp", "in": {
      "image": "bowl", "height": "bowl", "smallest_step": "none"}})",
                          points, {0, 0});
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(std::hypot(normals.Float(i, 0), normals.Float(i, 1), normals.Float(i, 2)), 1, 1e-5);
    EXPECT_TRUE(std::isfinite(warped.Float(i))) << i;
  }
}

// A relief of stripes far finer than the pixel has no slope left.
TEST(FiltersTest, HeightToNormalIsFlatFromFarAway) {
  Values seen = RunNode(R"("noise": {"block": "value_noise", "in": {"scale": 300}},
      "n": {"block": "height_to_normal", "in": {"height": "noise", "strength": 10}})",
                        ScatteredPoints(20), {0.02, 0.02}, "normal");
  for (size_t i = 0; i < 20; ++i) EXPECT_NEAR(seen.Float(i, 2), 1, 1e-6);
}

// The image is a sine of both coordinates, filtered by nothing; what counts is where it is looked
// at.
TEST(FiltersTest, WarpsLookElsewhere) {
  const std::string image = kBowl + R"(,
      "ramp": {"block": "gradient_linear", "in": {"start": [-4, 0], "end": [4, 3]}})";
  auto at = [](double x, double y) { return ((x + 4) * 8 + y * 3) / 73; };
  std::vector<Point> points = ScatteredPoints(30);
  Values slopes =
      RunNode(image + R"(, "n": {"block": "warp", "in": {"image": "ramp", "height": "bowl",
          "amount": 0.2}})",
              points, {0.001, 0.001});
  Values vectors = RunNode(
      image + R"(, "n": {"block": "vector_warp", "in": {"image": "ramp", "displacement": "d",
          "amount": 0.3, "center": [0.5, 0.25]}},
          "d": {"block": "combine2", "in": {"x": "bowl", "y": "c.x"}})",
      points, {0.001, 0.001});
  Values lines = RunNode(
      image + R"(, "n": {"block": "directional_warp", "in": {"image": "ramp", "intensity": "bowl",
          "amount": 0.3, "angle": 120, "center": 0.5}})",
      points, {0.001, 0.001});
  for (size_t i = 0; i < points.size(); ++i) {
    double x = points[i].x, y = points[i].y, bowl = x * x + x * y + y / 2;
    EXPECT_NEAR(slopes.Float(i), at(x + 0.2 * (2 * x + y), y + 0.2 * (x + 0.5)), 2e-4);
    EXPECT_NEAR(vectors.Float(i), at(x + 0.3 * (bowl - 0.5), y + 0.3 * (x - 0.25)), 1e-5);
    double far = 0.3 * (bowl - 0.5);
    EXPECT_NEAR(lines.Float(i), at(x + far * std::cos(kTurn / 3), y + far * std::sin(kTurn / 3)),
                1e-5);
  }
}

// Where a warp stretches the coordinate eleven times, a pixel holds eleven times as much.
TEST(FiltersTest, WarpsAreFilteredForTheirStretch) {
  std::vector<Point> points = ScatteredPoints(30);
  const double pixel = 0.003;
  Values seen = RunNode(kStripes + R"(, "d": {"block": "combine2", "in": {"x": "c.x", "y": 0}},
          "n": {"block": "vector_warp", "in": {"image": "stripes", "displacement": "d",
          "amount": 10}})",
                        points, {pixel, pixel});
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(seen.Float(i), StripesMean(11 * points[i].x, 11 * pixel), 2e-3);
  }
}

}  // namespace
}  // namespace texgraph::blocks
