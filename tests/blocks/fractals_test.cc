// SPDX-License-Identifier: Apache-2.0
// Sums of noises, warps and curls over function ports, against the same sums in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "tests/blocks/noise_reference.h"
#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

using reference::Mix;
using reference::Noise;
using reference::NoiseAt;
using reference::Place;

// One output of a graph with these nodes.
Values RunNodes(const std::string& nodes, const std::string& output,
                const std::vector<Point>& points, double pixel, double tolerance = 1e-4) {
  auto outputs = RunGraph(R"({"texgraph": 1, "functions": {"perlin": {
        "inputs": {"p": "vec3"},
        "nodes": {"n": {"block": "gradient_noise", "in": {"uv": "p", "scale": 1, "seed": 5}}},
        "outputs": {"value": "n"}}}, "nodes": {)" +
                              nodes + R"(}, "outputs": {)" + output + "}}",
                          points, {pixel, pixel}, tolerance);
  if (outputs.empty()) return Floats(std::vector<double>(points.size(), NAN));
  return outputs.begin()->second;
}

const char kPerlin[] = R"("n": {"block": "gradient_noise", "in": {"scale": 1, "seed": 5}},)";
const char kBare[] = R"("n": {"block": "gradient_noise",
                              "in": {"scale": 1, "seed": 5, "filtered": false}},)";

// The place in the plane that is laid through space, at z = 0.3.
const char kSpace[] = R"(
    "parts": {"block": "components", "in": {"vector": "uv"}},
    "p": {"block": "combine3", "in": {"x": "parts.x", "y": "parts.y", "z": 0.3}},)";

struct Settings {
  double scale = 3;
  int octaves = 4;
  double lacunarity = 2.5, gain = 0.6, feedback = 0.8;
};

std::string Ports(const Settings& s, bool feedback) {
  std::string ports =
      "\"scale\": " + std::to_string(s.scale) + ", \"octaves\": " + std::to_string(s.octaves) +
      ", \"lacunarity\": " + std::to_string(s.lacunarity) + ", \"gain\": " + std::to_string(s.gain);
  if (feedback) ports += ", \"feedback\": " + std::to_string(s.feedback);
  return ports;
}

enum class Kind { kFbm, kTurbulence, kBillow, kRidged };

double Fold(Kind kind, double noise) {
  const double folded = std::fabs(2 * noise - 1);
  return kind == Kind::kFbm ? noise : kind == Kind::kRidged ? std::pow(1 - folded, 2) : folded;
}

// The definition: octave i weighs gain^i, and follows the one before.
double FractalOf(Kind kind, const Place& uv, const Settings& s, uint32_t seed) {
  double sum = 0, weights = 0, carry = 1;
  const bool follows = kind == Kind::kBillow || kind == Kind::kRidged;
  for (int i = 0; i < s.octaves; ++i) {
    Place p = uv;
    for (double& x : p) x = x * s.scale * std::pow(s.lacunarity, i) + 37.7 * i;
    const double octave = Fold(kind, NoiseAt(Noise::kGradient, p, seed)) * carry;
    sum += std::pow(s.gain, i) * octave;
    weights += std::pow(s.gain, i);
    if (follows) carry = 1 - s.feedback + s.feedback * octave;
  }
  return sum / weights;
}
double Fractal(Kind kind, const Place& uv, const Settings& s) { return FractalOf(kind, uv, s, 5); }

struct Case {
  const char* block;
  Kind kind;
};

class FractalTest : public testing::TestWithParam<Case> {
 protected:
  std::string Node(const Settings& s, const std::string& noise = "n") const {
    const Kind kind = GetParam().kind;
    return R"("f": {"block": ")" + std::string(GetParam().block) + R"(", "in": {"noise": ")" +
           noise + "\", " + Ports(s, kind == Kind::kBillow || kind == Kind::kRidged);
  }
};

TEST_P(FractalTest, IsTheSumOfItsOctaves) {
  const std::vector<Point> points = ScatteredPoints(300, -2, 3);
  for (double gain : {0.6, 1.0}) {
    Settings settings;
    settings.gain = gain;
    const Values seen =
        RunNodes(kPerlin + Node(settings) + "}}", R"("height": "f")", points, 1e-5, 2e-3);
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_NEAR(seen.Float(i), Fractal(GetParam().kind, {points[i].x, points[i].y}, settings),
                  1e-3);
    }
  }
}

TEST_P(FractalTest, InSpaceLikewise) {
  const std::vector<Point> points = ScatteredPoints(200, -2, 3);
  const Values seen = RunNodes(kSpace + Node({}, "perlin") + R"(, "uv": "p"}})", R"("height": "f")",
                               points, 1e-5, 2e-3);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(seen.Float(i), Fractal(GetParam().kind, {points[i].x, points[i].y, 0.3}, {}), 1e-3);
  }
}

// Octave by octave the mean stays, from pixels of no size to pixels of many cells; in the end it is
// all there is.
void ExpectMeanAtAllSizes(Kind kind, const std::string& noise, const std::string& node,
                          const Settings& settings) {
  const std::vector<Point> points = ScatteredPoints(4000, -2, 3);
  // Of independent octaves, the mean of the product is the product of the means.
  const double fold = kind == Kind::kFbm ? 0.5 : kind == Kind::kRidged ? 0.571 : 0.269;
  const bool follows = kind == Kind::kBillow || kind == Kind::kRidged;
  double mean = 0, weights = 0, carry = 1;
  for (int i = 0; i < settings.octaves; ++i) {
    mean += std::pow(settings.gain, i) * fold * carry;
    weights += std::pow(settings.gain, i);
    if (follows) carry = 1 - settings.feedback + settings.feedback * fold * carry;
  }
  mean /= weights;
  double last = 1;
  for (double pixel : {1e-5, 0.003, 0.006, 0.012, 0.02, 0.03, 0.045, 0.0625, 1.0}) {
    const Values seen = RunNodes(noise + node + "}}", R"("height": "f")", points, pixel, 2e-3);
    double sum = 0, squares = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      sum += seen.Float(i);
      squares += std::pow(seen.Float(i) - mean, 2);
    }
    const double count = static_cast<double>(points.size());
    // Four standard deviations, and what the block's `far` is rounded by.
    EXPECT_NEAR(sum / count, mean, 4 * std::sqrt(squares) / count + 0.0006) << pixel;
    const double deviation = std::sqrt(squares / count);
    EXPECT_LE(deviation, last + 0.002) << pixel;
    last = deviation;
  }
  EXPECT_LT(last, 1e-3);
}

TEST_P(FractalTest, GoesToItsMeanWithoutADetour) {
  Settings settings;
  settings.scale = 16;
  settings.lacunarity = 2;
  ExpectMeanAtAllSizes(GetParam().kind, kPerlin, Node(settings), settings);
  ExpectMeanAtAllSizes(GetParam().kind, kBare, Node(settings), settings);
}

INSTANTIATE_TEST_SUITE_P(All, FractalTest,
                         testing::Values(Case{"fbm", Kind::kFbm},
                                         Case{"turbulence", Kind::kTurbulence},
                                         Case{"billow", Kind::kBillow},
                                         Case{"ridged", Kind::kRidged}),
                         [](const auto& test) { return std::string(test.param.block); });

// The figures that the texts of turbulence, billow and ridged give for the noises.
TEST(FoldedNoiseTest, HasTheMeansOfTheTexts) {
  const struct {
    Noise noise;
    double folded[2], ridge[2];
  } kWanted[] = {{Noise::kValue, {0.378, 0.330}, {0.448, 0.500}},
                 {Noise::kGradient, {0.269, 0.196}, {0.571, 0.665}},
                 {Noise::kSimplex, {0.391, 0.220}, {0.423, 0.637}}};
  constexpr int kCount = 60000;
  for (const auto& wanted : kWanted) {
    for (size_t dimensions : {2, 3}) {
      double folded = 0, ridge = 0;
      for (int i = 0; i < kCount; ++i) {
        Place p = {std::fmod(0.8191725134 * i, 1) * 1000, std::fmod(0.6710436067 * i, 1) * 1000,
                   std::fmod(0.5497004779 * i, 1) * 1000};
        p.resize(dimensions);
        const double noise = NoiseAt(wanted.noise, p, 1);
        folded += Fold(Kind::kTurbulence, noise) / kCount;
        ridge += Fold(Kind::kRidged, noise) / kCount;
      }
      // Four standard deviations of 60,000 numbers, which deviate by at most 0.3.
      EXPECT_NEAR(folded, wanted.folded[dimensions - 2], 0.005);
      EXPECT_NEAR(ridge, wanted.ridge[dimensions - 2], 0.005);
    }
  }
}

// How much is left of cells that are so many pixels small: all at two pixels, nothing at one.
double Left(double cells_a_pixel) { return std::clamp(2 - 2 * cells_a_pixel, 0.0, 1.0); }

// Five octaves of Perlin's noise at one pixel size. `cells`: of the noise for each unit; what has
// more than one fades for itself as well.
double FadedFbm(const Place& uv, double scale, double pixel, double cells, uint32_t seed) {
  double sum = 0.5;
  for (int i = 0; i < 5; ++i) {
    Place p = uv;
    for (double& x : p) x = cells * (x * scale * std::pow(2, i) + 37.7 * i);
    const double width = pixel * scale * std::pow(2, i);
    const double left = Left(width) * (cells > 1 ? Left(cells * width) : 1);
    const double weight = 16.0 / 31 / std::pow(2, i);
    sum += weight * left * (NoiseAt(Noise::kGradient, p, seed) - 0.5);
  }
  return sum;
}

// Octaves fade once: by the fractal, which the noise learns, whether it is connected as a node,
// through other nodes or as a function. What has more cells, or lies at another place than the
// fractal asks at, still fades for itself.
TEST(FbmTest, FadesItsOctavesOnce) {
  const std::string functions = R"({"texgraph": 1, "functions": {
      "noise": {"inputs": {"place": "vec2"},
        "nodes": {"n": {"block": "gradient_noise", "in": {"uv": "place", "scale": 1, "seed": 5}}},
        "outputs": {"value": "n"}},
      "outer": {"inputs": {"p": "vec2"},
        "nodes": {"n": {"block": "noise", "in": {"place": "p"}}}, "outputs": {"value": "n"}}},
    "nodes": {)";
  const std::string one = R"("n": {"block": "gradient_noise", "in": {"scale": 1, "seed": 5}})";
  const std::string moved = R"("p": {"block": "multiply", "in": {"a": "uv", "b": 8}},
      "n": {"block": "gradient_noise", "in": {"uv": "p", "scale": 1, "seed": 5}})";
  const struct {
    std::string nodes;
    const char* noise;
    double cells;
  } kCases[] = {
      {one, "n", 1},
      {one + R"(, "m": {"block": "maximum", "in": {"a": "n", "b": 0}})", "m", 1},
      {R"("unused": {"block": "float_constant", "in": {"value": 0}})", "noise", 1},
      {R"("unused": {"block": "float_constant", "in": {"value": 0}})", "outer", 1},
      {R"("n": {"block": "noise", "in": {"place": "uv"}})", "n", 1},
      {R"("n": {"block": "gradient_noise", "in": {"scale": 8, "seed": 5}})", "n", 8},
      {moved, "n", 8},
      {R"("p": {"block": "multiply", "in": {"a": "uv", "b": 8}},
          "n": {"block": "noise", "in": {"place": "p"}})",
       "n", 8},
  };
  const std::vector<Point> points = ScatteredPoints(200, -2, 3);
  for (const auto& wanted : kCases) {
    // Of the third octave, three quarters of which are left, the cells are 1.6 pixels large; if the
    // noise has 8 cells where the fractal has one, these are those of the noise.
    const double scale = 4 / wanted.cells, pixel = 1 / (16 * 1.6);
    const std::string graph =
        functions + wanted.nodes + R"(, "f": {"block": "fbm", "in": {"noise": ")" + wanted.noise +
        R"(", "scale": )" + std::to_string(scale) + R"(}}}, "outputs": {"height": "f"}})";
    auto outputs = RunGraph(graph, points, {pixel, pixel}, 2e-3);
    ASSERT_EQ(outputs.size(), 1u) << graph;
    double farthest = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const double expected = FadedFbm({points[i].x, points[i].y}, scale, pixel, wanted.cells, 5);
      farthest = std::max(farthest, std::fabs(outputs["height"].Float(i) - expected));
    }
    EXPECT_LT(farthest, 1e-3) << graph;
  }
}

// Where a function port within asks at places of its own, these are no octave's.
TEST(FbmTest, OtherPortsBeginAnew) {
  const std::vector<Point> points = ScatteredPoints(200, -2, 3);
  const double pixel = 1 / (16 * 1.6);
  const std::string one = R"("n": {"block": "gradient_noise", "in": {"scale": 1, "seed": 5}},)";
  const std::string scaled = R"("n": {"block": "gradient_noise", "in": {"scale": 8, "seed": 5}},)";
  // A warp by nothing, at 8 times the coordinate.
  const std::string warped = one + R"("p": {"block": "multiply", "in": {"a": "uv", "b": 8}},
      "w": {"block": "vector_warp", "in":
          {"image": "n", "uv": "p", "amount": 0, "displacement": [0, 0]}},
      "f": {"block": "fbm", "in": {"noise": "w", "scale": 0.5}})";
  const Values seen = RunNodes(warped, R"("height": "f")", points, pixel, 2e-3);
  const Values wanted =
      RunNodes(scaled + R"("f": {"block": "fbm", "in": {"noise": "n", "scale": 0.5}})",
               R"("height": "f")", points, pixel, 2e-3);
  for (size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(seen.Float(i), wanted.Float(i), 1e-4);
}

// Without a noise, fractals have "unit_noise", in as many dimensions as their coordinate.
TEST_P(FractalTest, NeedsNoNoise) {
  const std::vector<Point> points = ScatteredPoints(100, -2, 3);
  const Kind kind = GetParam().kind;
  const std::string block = GetParam().block;
  const Settings settings{3, 4, 2.5, 0.6, 0.8};
  const std::string ports = Ports(settings, kind == Kind::kBillow || kind == Kind::kRidged);
  const struct {
    const char* uv;
    std::vector<double> more;
    size_t dimensions;
  } kCases[] = {{"", {}, 2},
                {R"(, "uv": "p3")", {0.3}, 3},
                {R"(, "uv": "parts.x")", {}, 1},
                {R"(, "uv": "p4")", {0.3, 0.7}, 4}};
  for (const auto& c : kCases) {
    const Values seen = RunNodes(R"("parts": {"block": "components", "in": {"vector": "uv"}},
            "p3": {"block": "combine3", "in": {"x": "parts.x", "y": "parts.y", "z": 0.3}},
            "p4": {"block": "combine4", "in": {"x": "parts.x", "y": "parts.y", "z": 0.3, "w": 0.7}},
            "f": {"block": ")" + block +
                                     R"(", "in": {)" + ports + c.uv + "}}",
                                 R"("height": "f")", points, 1e-5, 2e-3);
    for (size_t i = 0; i < points.size(); ++i) {
      Place place = {points[i].x, points[i].y};
      place.insert(place.end(), c.more.begin(), c.more.end());
      place.resize(c.dimensions);
      EXPECT_NEAR(seen.Float(i), FractalOf(kind, place, settings, 0), 1e-3) << c.dimensions;
    }
  }
}

// A function of the graph learns the octave.
TEST(FbmTest, TellsTheOctave) {
  const std::string graph = R"({"texgraph": 1,
    "functions": {"third": {"inputs": {"octave": "int"}, "nodes": {
        "is": {"block": "compare", "in": {"a": "octave", "b": 2, "relation": "equal"}},
        "n": {"block": "select", "in": {"condition": "is", "if_true": 1.0, "if_false": 0.5}}},
      "outputs": {"value": "n"}}},
    "nodes": {"f": {"block": "fbm", "in": {"noise": "third", "octaves": 3}}},
    "outputs": {"height": "f"}})";
  auto outputs = RunGraph(graph, {{0.3, 0.4}}, {1e-5, 1e-5});
  ASSERT_EQ(outputs.size(), 1u);
  // Weights 4/7, 2/7 and 1/7.
  EXPECT_NEAR(outputs["height"].Float(0), 0.5 + 0.5 / 7, 1e-6);
}

// A period of the noise is one of the sum.
TEST(FbmTest, OfATileIsATile) {
  const std::string nodes = R"("n": {"block": "value_noise", "in": {"scale": 1, "period": [4, 8]}},
      "f": {"block": "fbm", "in": {"noise": "n", "scale": [4, 8], "octaves": 3}})";
  std::vector<Point> here = ScatteredPoints(200, -2, 3), there = here;
  for (size_t i = 0; i < here.size(); ++i) {
    here[i] = {std::round(here[i].x * 64) / 64, std::round(here[i].y * 64) / 64};
    there[i] = {here[i].x + 2, here[i].y - 1};
  }
  const Values a = RunNodes(nodes, R"("height": "f")", here, 1e-5);
  const Values b = RunNodes(nodes, R"("height": "f")", there, 1e-5);
  for (size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(a.Float(i), b.Float(i), 1e-4);
}

TEST(DomainWarpTest, MovesBothDirectionsByNoisesOfTheirOwn) {
  const std::vector<Point> points = ScatteredPoints(200, -2, 3);
  const Values seen = RunNodes(std::string(kPerlin) + R"("w": {"block": "domain_warp", "in":
          {"noise": "n", "amount": [0.3, 0.2], "steps": 2}},
          "parts": {"block": "components", "in": {"vector": "w"}},
          "color": {"block": "combine4", "in": {"x": "parts.x", "y": "parts.y", "z": 0, "w": 1}})",
                               R"("color": "color")", points, 1e-5);
  for (size_t i = 0; i < points.size(); ++i) {
    Place place = {points[i].x, points[i].y};
    for (int step = 0; step < 2; ++step) {
      const double x = NoiseAt(Noise::kGradient, place, 5);
      const double y = NoiseAt(Noise::kGradient, {place[0] + 37.7, place[1] + 37.7}, 5);
      place = {points[i].x + 0.3 * (2 * x - 1), points[i].y + 0.2 * (2 * y - 1)};
    }
    EXPECT_NEAR(seen.Float(i, 0), place[0], 1e-4);
    EXPECT_NEAR(seen.Float(i, 1), place[1], 1e-4);
  }
}

// Around the height sin x sin y the flow is (sin x cos y, -cos x sin y).
TEST(CurlTest, TurnsTheSlope) {
  const std::vector<Point> points = ScatteredPoints(100, -2, 3);
  const std::string nodes = R"("parts": {"block": "components", "in": {"vector": "uv"}},
      "sx": {"block": "sine", "in": {"angle": "parts.x"}},
      "sy": {"block": "sine", "in": {"angle": "parts.y"}},
      "h": {"block": "multiply", "in": {"a": "sx", "b": "sy"}},
      "v": {"block": "curl", "in": {"potential": "h"}},
      "flow": {"block": "components", "in": {"vector": "v"}},
      "color": {"block": "combine4", "in": {"x": "flow.x", "y": "flow.y", "z": 0, "w": 1}})";
  const Values seen = RunNodes(nodes, R"("color": "color")", points, 1e-4, 2e-3);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(seen.Float(i, 0), std::sin(points[i].x) * std::cos(points[i].y), 1e-3);
    EXPECT_NEAR(seen.Float(i, 1), -std::cos(points[i].x) * std::sin(points[i].y), 1e-3);
  }
}

// Of the potential (sin y, sin z, sin x) the flow is (-cos z, -cos x, -cos y).
TEST(CurlTest, InSpace) {
  const std::vector<Point> points = ScatteredPoints(100, -2, 3);
  const std::string nodes = R"("parts": {"block": "components", "in": {"vector": "uv"}},
      "p": {"block": "combine3", "in": {"x": "parts.x", "y": "parts.y", "z": 0.3}},
      "v": {"block": "curl3", "in": {"potential": "potential", "uv": "p"}})";
  auto outputs = RunGraph(R"({"texgraph": 1, "functions": {"potential": {
        "inputs": {"uv": "vec3"}, "nodes": {
          "c": {"block": "components", "in": {"vector": "uv"}},
          "t": {"block": "combine3", "in": {"x": "c.y", "y": "c.z", "z": "c.x"}},
          "s": {"block": "sine", "in": {"angle": "t"}}},
        "outputs": {"value": "s"}}}, "nodes": {)" +
                              nodes + R"(}, "outputs": {"normal": "v"}})",
                          points, {1e-4, 1e-4}, 2e-3);
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(outputs["normal"].Float(i, 0), -std::cos(0.3), 1e-3);
    EXPECT_NEAR(outputs["normal"].Float(i, 1), -std::cos(points[i].x), 1e-3);
    EXPECT_NEAR(outputs["normal"].Float(i, 2), -std::cos(points[i].y), 1e-3);
  }
}

TEST(WidestTest, IsTheGreatestComponent) {
  EXPECT_EQ(RunBlock("widest", {{"value", Floats({-3})}})["result"].Float(0), -3);
  for (size_t n = 2; n <= 4; ++n) {
    for (size_t k = 0; k < n; ++k) {
      Vector value(n, 1);
      value[k] = 2;
      EXPECT_EQ(RunBlock("widest", {{"value", Vectors({value})}})["result"].Float(0), 2);
    }
  }
}

}  // namespace
}  // namespace texgraph::blocks
