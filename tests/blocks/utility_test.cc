// SPDX-License-Identifier: Apache-2.0
// Blocks that bend coordinates, smear and sharpen functions, find edges and bulges, project an
// image on a solid, and cut masks: against geometry and sums in double precision.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

constexpr double kPi = std::numbers::pi;
using Vec3 = std::array<double, 3>;

std::vector<Vector> Places(int count) {
  std::vector<Vector> places;
  for (Point p : ScatteredPoints(count)) places.push_back({4 * p.x - 2, 4 * p.y - 2});
  return places;
}

// `nodes` and the node "n" with the value that is asked for; "c" has the components of uv.
Values RunNode(const std::string& nodes, const std::vector<Point>& points, Point pixel,
               const std::string& output = "height", const std::string& functions = "") {
  auto outputs =
      RunGraph(R"({"texgraph": 1, )" + functions +
                   R"("nodes": {"c": {"block": "components", "in": {"vector": "uv"}}, )" + nodes +
                   R"(}, "outputs": {")" + output + R"(": "n"}})",
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

double Binomial(int n, int k) {
  return std::tgamma(n + 1) / std::tgamma(k + 1) / std::tgamma(n - k + 1) / std::pow(2, n);
}

TEST(UtilityTest, ShearUndoesTwoSlants) {
  const std::vector<Vector> places = Places(40);
  const double across = 0.7, up = -1.3;
  std::vector<Vector> slanted;
  for (const Vector& p : places) {
    const double x = p[0] + across * p[1];
    slanted.push_back({x + 0.2, p[1] + up * x - 0.4});
  }
  Values seen = RunBlock("shear", {{"uv", Vectors(slanted)},
                                   {"amount", Vectors({{across, up}})},
                                   {"pivot", Vectors({{0.2, -0.4}})}})["result"];
  for (size_t i = 0; i < places.size(); ++i) {
    EXPECT_NEAR(seen.Float(i, 0), places[i][0] + 0.2, 2e-6);
    EXPECT_NEAR(seen.Float(i, 1), places[i][1] - 0.4, 2e-6);
  }
}

Values Spherized(const std::vector<Vector>& places, double amount) {
  return RunBlock("spherize", {{"uv", Vectors(places)},
                               {"center", Vectors({{0.3, -0.1}})},
                               {"amount", Floats({amount})},
                               {"radius", Floats({1.5})}})["result"];
}

TEST(UtilityTest, SpherizeShowsABallFromFarAway) {
  const std::vector<Vector> places = Places(200);
  const Values ball = Spherized(places, 1), half = Spherized(places, 0.5);
  std::vector<Vector> bulged;
  for (size_t i = 0; i < places.size(); ++i) {
    const double x = (places[i][0] - 0.3) / 1.5, y = (places[i][1] + 0.1) / 1.5;
    const double square = x * x + y * y;
    // The angle between the axis and the place on the unit ball that is seen there, in right
    // angles.
    const double angle = square < 1 ? std::acos(std::sqrt(1 - square)) / (kPi / 2) : 0;
    const double times = square < 1 ? angle / std::sqrt(square) : 1;
    EXPECT_NEAR(ball.Float(i, 0), 0.3 + 1.5 * x * times, 2e-4) << square;
    EXPECT_NEAR(ball.Float(i, 1), -0.1 + 1.5 * y * times, 2e-4) << square;
    EXPECT_NEAR(half.Float(i, 0), 0.3 + 1.5 * x * (1 + times) / 2, 2e-4) << square;
    bulged.push_back({ball.Float(i, 0), ball.Float(i, 1)});
  }
  const Values back = Spherized(bulged, -1), middle = Spherized({{0.3, -0.1}}, 1);
  for (size_t i = 0; i < places.size(); ++i) {
    // At the rim the ball is so narrow that rounding shows.
    EXPECT_NEAR(back.Float(i, 0), places[i][0], 1e-3);
    EXPECT_NEAR(back.Float(i, 1), places[i][1], 1e-3);
  }
  EXPECT_FLOAT_EQ(middle.Float(0, 0), 0.3f);
  EXPECT_FLOAT_EQ(middle.Float(0, 1), -0.1f);
}

TEST(UtilityTest, DirectionalBlurIsASumOfBoxesOnALine) {
  const std::vector<Point> points = ScatteredPoints(40);
  const double radius = 0.07, pixel = 0.01;
  for (int taps : {1, 3, 8}) {
    for (double angle : {0.0, 60.0, 90.0, 205.0}) {
      Values seen =
          RunNode(kStripes + R"(, "n": {"block": "directional_blur", "in": {"image": "stripes",
              "radius": 0.07, "taps": )" +
                      std::to_string(taps) + R"(, "angle": )" + std::to_string(angle) + "}}",
                  points, {pixel, pixel});
      const double c = std::fabs(std::cos(angle * kPi / 180)), s = std::sin(angle * kPi / 180);
      const double apart = radius / std::sqrt((taps - 1) / 4.0 + 1 / 12.0);
      const double width = std::hypot(c * std::hypot(apart, pixel), s * pixel);
      for (size_t i = 0; i < points.size(); ++i) {
        double wanted = 0;
        for (int k = 0; k < taps; ++k) {
          wanted += Binomial(taps - 1, k) *
                    StripesMean(points[i].x + c * (k - (taps - 1) / 2.0) * apart, width);
        }
        EXPECT_NEAR(seen.Float(i), wanted, 2e-3) << taps << " " << angle << " " << points[i].x;
      }
    }
  }
}

TEST(UtilityTest, SharpenAddsWhatABlurTakesAway) {
  const std::vector<Point> points = ScatteredPoints(60);
  const double radius = 0.03, pixel = 0.004;
  Values seen = RunNode(kStripes + R"(, "n": {"block": "sharpen", "in": {"image": "stripes",
      "amount": 0.8, "radius": 0.03}})",
                        points, {pixel, pixel});
  const double apart = radius / std::sqrt(0.5 + 1 / 12.0), width = std::hypot(apart, pixel);
  for (size_t i = 0; i < points.size(); ++i) {
    double blurred = 0;
    for (int k = 0; k < 3; ++k) {
      blurred += Binomial(2, k) * StripesMean(points[i].x + (k - 1) * apart, width);
    }
    const double here = StripesMean(points[i].x, pixel);
    EXPECT_NEAR(seen.Float(i), here + 0.8 * (here - blurred), 3e-3) << points[i].x;
  }
}

// Transparent red beside opaque green stays green, and its alpha between 0 and 1.
TEST(UtilityTest, SharpenWeighsColoursByAlpha) {
  Values seen = RunNode(R"("color": {"block": "color_ramp", "in": {"position": "c.x",
      "colors": [[1, 0, 0, 0], [0, 1, 0, 1]], "stops": [0, 0.5], "curve": "steps"}},
      "n": {"block": "sharpen", "in": {"image": "color", "radius": 0.1, "amount": 0.5}})",
                        {{0.48, 0.5}, {0.52, 0.5}}, {1e-3, 1e-3}, "color");
  EXPECT_NEAR(seen.Float(0, 3), 0, 1e-6);
  EXPECT_NEAR(seen.Float(1, 3), 1, 1e-6);
  EXPECT_NEAR(seen.Float(1, 0), 0, 1e-6);
  EXPECT_NEAR(seen.Float(1, 1), 1, 1e-5);
}

// A bowl x^2 + xy + y / 2, whose slope differences are exact.
const std::string kBowl = R"(
    "xx": {"block": "multiply", "in": {"a": "c.x", "b": "c.x"}},
    "xy": {"block": "multiply", "in": {"a": "c.x", "b": "c.y"}},
    "rise": {"block": "multiply", "in": {"a": "c.y", "b": 0.5}},
    "sum": {"block": "add", "in": {"a": "xx", "b": "xy"}},
    "bowl": {"block": "add", "in": {"a": "sum", "b": "rise"}})";

TEST(UtilityTest, SlopeBlurFollowsTheSlope) {
  const std::vector<Point> points = ScatteredPoints(30);
  for (const char* mode : {"blur", "min", "max"}) {
    Values seen = RunNode(
        kBowl + R"(, "ramp": {"block": "gradient_linear", "in": {"start": [-4, 0], "end": [4, 3]}},
            "n": {"block": "slope_blur", "in": {"image": "ramp", "height": "bowl", "taps": 5,
            "amount": -0.3, "mode": ")" +
            mode + "\"}}",
        points, {0.001, 0.001});
    for (size_t i = 0; i < points.size(); ++i) {
      double x = points[i].x, y = points[i].y, sum = 0, least = 1e9, most = -1e9;
      for (int k = 0; k <= 5; ++k) {
        const double image = ((x + 4) * 8 + y * 3) / 73;
        sum += image / 6;
        least = std::min(least, image);
        most = std::max(most, image);
        const double right = 2 * x + y, up = x + 0.5;
        x -= 0.3 / 5 * right;
        y -= 0.3 / 5 * up;
      }
      const double wanted = mode[1] == 'i' ? least : mode[1] == 'a' ? most : sum;
      EXPECT_NEAR(seen.Float(i), wanted, 5e-4) << mode;
    }
  }
}

TEST(UtilityTest, EdgeDetectShowsAnEdgeAsALine) {
  std::vector<Point> points;
  for (int i = 0; i < 80; ++i) points.push_back({0.3 + 0.005 * i, 0.5});
  for (double pixel : {1e-4, 0.05}) {
    for (bool color : {false, true}) {
      const std::string edge = R"("edge": {"block": "threshold", "in": {"value": "c.x"}},
          "wide": {"block": "combine4", "in": {"x": "edge", "y": "c.y", "z": "edge", "w": 1}})";
      Values seen = RunNode(edge + R"(, "n": {"block": "edge_detect", "in": {"image": ")" +
                                (color ? "wide" : "edge") + R"(", "width": [0.08, 1e-5]}})",
                            points, {pixel, pixel});
      const double width = std::hypot(0.08, pixel);
      for (size_t i = 0; i < points.size(); ++i) {
        const double edges = std::fmax(0, 1 - std::fabs(points[i].x - 0.5) / width);
        const double down = color ? std::hypot(1e-5, pixel) : 0;
        EXPECT_NEAR(seen.Float(i), std::hypot(color ? std::sqrt(2) * edges : edges, down), 2e-3)
            << points[i].x << " " << pixel;
      }
    }
  }
}

// A ball and a lying cylinder of radius 2 around (0.5, 0.5).
TEST(UtilityTest, CurvatureOfABallIsItsRadius) {
  std::vector<Point> points;
  for (Point p : ScatteredPoints(30)) points.push_back({2 * p.x - 0.5, 2 * p.y - 0.5});
  const std::string round = R"(
      "x": {"block": "subtract", "in": {"a": "c.x", "b": 0.5}},
      "y": {"block": "subtract", "in": {"a": "c.y", "b": 0.5}},
      "xx": {"block": "multiply", "in": {"a": "x", "b": "x"}},
      "yy": {"block": "multiply", "in": {"a": "y", "b": "y"}},
      "four": {"block": "subtract", "in": {"a": 4, "b": "xx"}},
      "rest": {"block": "subtract", "in": {"a": "four", "b": "yy"}},
      "cylinder": {"block": "square_root", "in": {"value": "four"}},
      "ball": {"block": "square_root", "in": {"value": "rest"}}, )";
  auto run = [&](const std::string& height, double strength) {
    return RunNode(round + R"("n": {"block": "curvature", "in": {"height": ")" + height +
                       R"(", "radius": 0.5, "smallest_step": 0.03, "strength": )" +
                       std::to_string(strength) + "}}",
                   points, {1e-3, 1e-3});
  };
  const Values ball = run("ball", 1), bowl = run("ball", -1), cylinder = run("cylinder", 1);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(ball.Float(i), 0.25, 2e-3) << i;
    EXPECT_NEAR(bowl.Float(i), -0.25, 2e-3) << i;
    EXPECT_NEAR(cylinder.Float(i), 0.125, 2e-3) << i;
  }
}

TEST(UtilityTest, TriplanarProjectsAlongThreeAxes) {
  // The image is x + 10 y + 100 plane. The normal goes with the place: (x - 1/2, y - 1/2, 0.1 or
  // -0.1).
  const std::vector<Point> points = ScatteredPoints(60);
  const std::string functions = R"("functions": {"picture": {"inputs": {"plane": "int"}, "nodes": {
      "c": {"block": "components", "in": {"vector": "uv"}},
      "which": {"block": "to_float", "in": {"value": "plane"}},
      "up": {"block": "multiply", "in": {"a": "c.y", "b": 10}},
      "far": {"block": "multiply", "in": {"a": "which", "b": 100}},
      "near": {"block": "add", "in": {"a": "c.x", "b": "up"}},
      "sum": {"block": "add", "in": {"a": "near", "b": "far"}}}, "outputs": {"value": "sum"}}}, )";
  for (double sharpness : {1.0, 6.0}) {
    for (double z : {0.1, -0.1}) {
      Values seen =
          RunNode(R"("place": {"block": "combine3", "in": {"x": "c.x", "y": "c.y", "z": 3}},
          "nx": {"block": "subtract", "in": {"a": "c.x", "b": 0.5}},
          "ny": {"block": "subtract", "in": {"a": "c.y", "b": 0.5}},
          "looks": {"block": "combine3", "in": {"x": "nx", "y": "ny", "z": )" +
                      std::to_string(z) + R"(}},
          "n": {"block": "triplanar", "in": {"image": "picture", "position": "place",
                "normal": "looks", "scale": 2, "sharpness": )" +
                      std::to_string(sharpness) + "}}",
                  points, {1e-3, 1e-3}, "height", functions);
      for (size_t i = 0; i < points.size(); ++i) {
        const Vec3 p = {2 * points[i].x, 2 * points[i].y, 6};
        const Vec3 n = {points[i].x - 0.5, points[i].y - 0.5, z};
        // The direction that is to the right and the one that is up, for who looks at that side.
        const Vec3 image = {(n[0] < 0 ? p[2] : -p[2]) + 10 * p[1],
                            p[0] + 10 * (n[1] < 0 ? p[2] : -p[2]) + 100,
                            (n[2] < 0 ? -p[0] : p[0]) + 10 * p[1] + 200};
        double sum = 0, weights = 0;
        const double most = std::max({std::fabs(n[0]), std::fabs(n[1]), std::fabs(n[2])});
        for (int k = 0; k < 3; ++k) {
          const double weight = std::fmax(std::pow(std::fabs(n[k]) / most, sharpness) - 0.001, 0);
          sum += weight * image[k];
          weights += weight;
        }
        EXPECT_NEAR(seen.Float(i), sum / weights, 2e-3) << i;
      }
    }
  }
}

// From outside, the direction to the right, up, and the normal are a right-handed frame.
TEST(UtilityTest, TriplanarMirrorsNothing) {
  const std::string functions = R"("functions": {"picture": {"nodes": {
      "c": {"block": "components", "in": {"vector": "uv"}},
      "n": {"block": "combine4", "in": {"x": "c.x", "y": "c.y", "z": 0, "w": 1}}},
      "outputs": {"value": "n"}}}, )";
  for (int axis = 0; axis < 3; ++axis) {
    for (double side : {1.0, -1.0}) {
      Vec3 normal = {0, 0, 0};
      normal[axis] = side;
      // The image's coordinates at the origin and a step along each axis.
      double right[3], up[3];
      for (int k = 0; k < 4; ++k) {
        Vec3 p = {0, 0, 0};
        if (k < 3) p[k] = 1;
        auto text = [](const Vec3& v) {
          return "[" + std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " +
                 std::to_string(v[2]) + "]";
        };
        Values seen =
            RunNode(R"("n": {"block": "triplanar", "in": {"image": "picture", "position": )" +
                        text(p) + R"(, "normal": )" + text(normal) + "}}",
                    {{0.5, 0.5}}, {1e-3, 1e-3}, "color", functions);
        if (k < 3) {
          right[k] = seen.Float(0, 0);
          up[k] = seen.Float(0, 1);
        }
      }
      for (int k = 0; k < 3; ++k) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        EXPECT_NEAR(right[a] * up[b] - right[b] * up[a], normal[k], 1e-5) << axis << " " << side;
      }
    }
  }
}

TEST(UtilityTest, HistogramScanIsTheMeanOfARamp) {
  for (double contrast : {0.0, 0.8, 1.0}) {
    for (double position : {0.0, 0.3, 0.75, 1.0}) {
      for (double pixel : {1e-4, 0.05, 0.7}) {
        std::vector<double> values;
        for (int i = 0; i < 40; ++i) {
          const double middle = (i + 0.5) / 40;
          for (int k = 0; k < 4; ++k) values.push_back(middle + (k % 2) * pixel);
        }
        Values seen = RunBlock("histogram_scan", {{"value", Floats(values)},
                                                  {"position", Floats({position})},
                                                  {"contrast", Floats({contrast})}})["result"];
        const double ramp = std::fmax(1 - contrast, 1e-4);
        for (size_t i = 0; i < values.size(); i += 4) {
          double wanted = 0;
          constexpr int kSamples = 4000;
          for (int k = 0; k < kSamples; ++k) {
            const double value = values[i] + pixel * ((k + 0.5) / kSamples - 0.5);
            // From all black to all white the ramp passes over the values from 0 to 1.
            const double foot = 1 - position * (1 + ramp);
            wanted += std::clamp((value - foot) / ramp, 0.0, 1.0) / kSamples;
          }
          EXPECT_NEAR(seen.Float(i), wanted, 1e-3)
              << values[i] << " " << position << " " << contrast << " " << pixel;
        }
      }
    }
  }
}

Vec3 NormalOf(double right, double up) {
  const double length = std::sqrt(right * right + up * up + 1);
  return {-right / length, -up / length, 1 / length};
}

TEST(UtilityTest, NormalStrengthMultipliesSlopes) {
  for (double strength : {0.0, 1.0, 2.5, -1.0}) {
    for (const Vector& slope : Places(20)) {
      const Vec3 n = NormalOf(slope[0], slope[1]);
      const Vec3 wanted = NormalOf(strength * slope[0], strength * slope[1]);
      Values seen = RunBlock("normal_strength", {{"normal", Vectors({{n[0], n[1], n[2]}})},
                                                 {"strength", Floats({strength})}})["result"];
      for (size_t k = 0; k < 3; ++k) EXPECT_NEAR(seen.Float(0, k), wanted[k], 2e-6);
    }
  }
}

// The turn about the axis (0, 0, 1) x base by the angle between them, by Rodrigues' formula.
TEST(UtilityTest, ReorientNormalTurnsTheDetail) {
  const std::vector<Vector> slopes = Places(30);
  for (size_t i = 0; i + 1 < slopes.size(); ++i) {
    const Vec3 base = NormalOf(slopes[i][0], slopes[i][1]);
    const Vec3 detail = NormalOf(slopes[i + 1][1], slopes[i + 1][0]);
    const double sine = std::hypot(base[0], base[1]), cosine = base[2];
    const Vec3 axis = {-base[1] / sine, base[0] / sine, 0};
    const Vec3 across = {axis[1] * detail[2] - axis[2] * detail[1],
                         axis[2] * detail[0] - axis[0] * detail[2],
                         axis[0] * detail[1] - axis[1] * detail[0]};
    const double along = axis[0] * detail[0] + axis[1] * detail[1] + axis[2] * detail[2];
    Values seen = RunBlock("reorient_normal",
                           {{"base", Vectors({{base[0], base[1], base[2]}})},
                            {"detail", Vectors({{detail[0], detail[1], detail[2]}})}})["result"];
    for (size_t k = 0; k < 3; ++k) {
      const double wanted = cosine * detail[k] + sine * across[k] + (1 - cosine) * along * axis[k];
      EXPECT_NEAR(seen.Float(0, k), wanted, 3e-6);
    }
  }
}

Values Dissolved(double opacity, double alpha, const std::vector<Point>& points, double pixel) {
  return RunNode(R"("n": {"block": "dissolve", "in": {"foreground": [1, 0, 0, )" +
                     std::to_string(alpha) + R"(], "background": [0, 1, 0, 1], "scale": 40,
                     "opacity": )" +
                     std::to_string(opacity) + "}}",
                 points, {pixel, pixel}, "color");
}

TEST(UtilityTest, DissolveShowsAsManyGrainsAsItsOpacitySays) {
  constexpr size_t kCount = 4000;
  const std::vector<Point> points = ScatteredPoints(kCount);
  for (double pixel : {1e-6, 0.01}) {
    const Values seen = Dissolved(0.6, 0.5, points, pixel);
    double red = 0;
    size_t whole = 0;
    for (size_t i = 0; i < kCount; ++i) {
      EXPECT_NEAR(seen.Float(i, 0) + seen.Float(i, 1), 1, 1e-5);
      EXPECT_NEAR(seen.Float(i, 3), 1, 1e-5);
      red += seen.Float(i, 0) / kCount;
      whole += seen.Float(i, 0) < 1e-3 || seen.Float(i, 0) > 0.999;
    }
    // 1600 grains: the standard deviation is 0.0115.
    EXPECT_NEAR(red, 0.3, 0.03) << pixel;
    if (pixel < 1e-3) {
      EXPECT_GE(whole, kCount - 8);
    }
  }
  const Values far = Dissolved(0.6, 0.5, points, 0.03);
  for (size_t i = 0; i < kCount; ++i) EXPECT_NEAR(far.Float(i, 0), 0.3, 1e-5);
}

TEST(UtilityTest, SwizzleTakesComponentsByName) {
  Values four = RunBlock("swizzle", {{"vector", Vectors({{2, 3, 5, 7}})},
                                     {"x", Word{"w"}},
                                     {"y", Word{"one"}},
                                     {"z", Word{"x"}},
                                     {"w", Word{"zero"}}})["result"];
  const double wanted[] = {7, 1, 2, 0};
  for (size_t k = 0; k < 4; ++k) EXPECT_EQ(four.Float(0, k), wanted[k]);
  Values three = RunBlock("swizzle", {{"vector", Vectors({{2, 3, 5}})},
                                      {"x", Word{"z"}},
                                      {"y", Word{"y"}},
                                      {"z", Word{"w"}}})["result"];
  const double missing[] = {5, 3, 0};
  for (size_t k = 0; k < 3; ++k) EXPECT_EQ(three.Float(0, k), missing[k]);
  Values two = RunBlock(
      "swizzle", {{"vector", Vectors({{2, 3}})}, {"x", Word{"y"}}, {"y", Word{"x"}}})["result"];
  EXPECT_EQ(two.Float(0, 0), 3);
  EXPECT_EQ(two.Float(0, 1), 2);
}

}  // namespace
}  // namespace texgraph::blocks
