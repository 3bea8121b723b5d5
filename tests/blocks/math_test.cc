// SPDX-License-Identifier: Apache-2.0
// The math shelf, the constants and the channels: each block at values where it matters, against
// the C++ library or by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

const std::vector<double> kA = {-3.5, -1, -0.25, 0, 0.25, 0.5, 1, 2.75, 100};
const std::vector<double> kB = {2, -0.5, 4, 0, 1, 0.3, -7, 0.125, 3};

using Unary = std::function<double(double)>;
using Binary = std::function<double(double, double)>;

void ExpectNear(double seen, double wanted, double relative, const std::string& what) {
  EXPECT_NEAR(seen, wanted, relative * std::fmax(1, std::fabs(wanted))) << what;
}

// On floats, and in the last component of vectors of every width.
void CheckUnary(const std::string& block, const std::string& port, const Unary& wanted,
                double relative = 0) {
  for (size_t width = 1; width <= 4; ++width) {
    std::vector<Vector> values;
    for (double a : kA) {
      values.push_back(Vector(width, 9));
      values.back().back() = a;
    }
    auto outputs = RunBlock(block, {{port, Vectors(values)}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < kA.size(); ++i) {
      ExpectNear(outputs["result"].Float(i, width - 1), wanted(kA[i]), relative,
                 block + " " + std::to_string(kA[i]));
    }
  }
}

void CheckBinary(const std::string& block, const std::string& port_a, const std::string& port_b,
                 const Binary& wanted, double relative = 0) {
  for (size_t width = 1; width <= 4; ++width) {
    std::vector<Vector> values_a, values_b;
    for (size_t i = 0; i < kA.size(); ++i) {
      values_a.push_back(Vector(width, 9));
      values_b.push_back(Vector(width, 9));
      values_a.back().back() = kA[i];
      values_b.back().back() = kB[i];
    }
    auto outputs = RunBlock(block, {{port_a, Vectors(values_a)}, {port_b, Vectors(values_b)}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < kA.size(); ++i) {
      double expected = wanted(static_cast<float>(kA[i]), static_cast<float>(kB[i]));
      ExpectNear(outputs["result"].Float(i, width - 1), expected, relative,
                 block + " " + std::to_string(kA[i]) + " " + std::to_string(kB[i]));
    }
  }
}

TEST(MathTest, OneValue) {
  CheckUnary("negate", "value", [](double a) { return -a; });
  CheckUnary("invert", "value", [](double a) { return 1 - a; });
  CheckUnary("absolute", "value", [](double a) { return std::fabs(a); });
  CheckUnary("round_down", "value", [](double a) { return std::floor(a); });
  CheckUnary("round_up", "value", [](double a) { return std::ceil(a); });
  CheckUnary("fraction", "value", [](double a) { return a - std::floor(a); });
  CheckUnary(
      "sine", "angle", [](double a) { return std::sin(a); }, 1e-6);
  CheckUnary(
      "cosine", "angle", [](double a) { return std::cos(a); }, 1e-6);
  CheckUnary(
      "square_root", "value", [](double a) { return a > 0 ? std::sqrt(a) : 0; }, 1e-6);
}

TEST(MathTest, TwoValues) {
  constexpr double kUlp = 1e-6;
  CheckBinary(
      "add", "a", "b", [](double a, double b) { return a + b; }, kUlp);
  CheckBinary(
      "subtract", "a", "b", [](double a, double b) { return a - b; }, kUlp);
  CheckBinary(
      "multiply", "a", "b", [](double a, double b) { return a * b; }, kUlp);
  CheckBinary(
      "divide", "a", "b", [](double a, double b) { return b == 0 ? 0 : a / b; }, kUlp);
  CheckBinary(
      "modulo", "a", "b", [](double a, double b) { return b == 0 ? 0 : a - b * std::floor(a / b); },
      kUlp);
  CheckBinary("minimum", "a", "b", [](double a, double b) { return std::fmin(a, b); });
  CheckBinary("maximum", "a", "b", [](double a, double b) { return std::fmax(a, b); });
  CheckBinary(
      "power", "base", "exponent",
      [](double a, double b) { return std::pow(std::fmax(a, 1e-37), std::fmax(b, -1)); }, 1e-5);
}

TEST(MathTest, DivisionByZeroIsZeroInEveryComponent) {
  auto outputs =
      RunBlock("divide", {{"a", Vectors({{1, -2, 0, 8}})}, {"b", Vectors({{0, 4, 0, 2}})}});
  ASSERT_EQ(outputs.size(), 1u);
  EXPECT_EQ(outputs["result"].Float(0, 0), 0.0f);
  EXPECT_EQ(outputs["result"].Float(0, 1), -0.5f);
  EXPECT_EQ(outputs["result"].Float(0, 2), 0.0f);
  EXPECT_EQ(outputs["result"].Float(0, 3), 4.0f);
}

TEST(MathTest, Vectors) {
  auto dot = RunBlock("dot_product", {{"a", Vectors({{1, 2, -3}})}, {"b", Vectors({{4, -5, 6}})}});
  auto length = RunBlock("magnitude", {{"vector", Vectors({{2, -3, 6}})}});
  auto unit = RunBlock("normalized", {{"vector", Vectors({{2, -3, 6}, {0, 0, 0}})}});
  ASSERT_EQ(dot.size() + length.size() + unit.size(), 3u);
  EXPECT_FLOAT_EQ(dot["result"].Float(0), 4 - 10 - 18);
  EXPECT_FLOAT_EQ(length["result"].Float(0), 7);
  EXPECT_FLOAT_EQ(unit["result"].Float(0, 0), 2.0f / 7);
  EXPECT_FLOAT_EQ(unit["result"].Float(0, 1), -3.0f / 7);
  EXPECT_FLOAT_EQ(unit["result"].Float(0, 2), 6.0f / 7);
  EXPECT_EQ(unit["result"].Float(1, 0), 0.0f);  // not a NaN
}

TEST(MathTest, Lerp) {
  auto outputs = RunBlock(
      "lerp", {{"a", Floats({2})}, {"b", Floats({10})}, {"amount", Floats({0, 0.25, 1, 1.5})}});
  ASSERT_EQ(outputs.size(), 1u);
  EXPECT_EQ(outputs["result"].Float(0), 2);
  EXPECT_EQ(outputs["result"].Float(1), 4);
  EXPECT_EQ(outputs["result"].Float(2), 10);
  EXPECT_EQ(outputs["result"].Float(3), 14);
}

TEST(MathTest, ClampRange) {
  auto outputs =
      RunBlock("clamp_range",
               {{"value", Floats({-1, 0.3, 9})}, {"low", Floats({0.25})}, {"high", Floats({4})}});
  ASSERT_EQ(outputs.size(), 1u);
  EXPECT_EQ(outputs["result"].Float(0), 0.25f);
  EXPECT_EQ(outputs["result"].Float(1), 0.3f);
  EXPECT_EQ(outputs["result"].Float(2), 4.0f);
}

TEST(MathTest, Remap) {
  std::vector<Argument> range = {{"value", Floats({10, 15, 20, 30})},
                                 {"in_low", Floats({10})},
                                 {"in_high", Floats({20})},
                                 {"out_low", Floats({1})},
                                 {"out_high", Floats({-1})}};
  auto free = RunBlock("remap", range);
  range.push_back({"limited", Bools({true})});
  auto limited = RunBlock("remap", range);
  auto empty = RunBlock("remap", {{"value", Floats({5})},
                                  {"in_low", Floats({2})},
                                  {"in_high", Floats({2})},
                                  {"out_low", Floats({7})},
                                  {"out_high", Floats({9})}});
  ASSERT_EQ(free.size() + limited.size() + empty.size(), 3u);
  const float kFree[] = {1, 0, -1, -3};
  const float kLimited[] = {1, 0, -1, -1};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_FLOAT_EQ(free["result"].Float(i), kFree[i]);
    EXPECT_FLOAT_EQ(limited["result"].Float(i), kLimited[i]);
  }
  EXPECT_EQ(empty["result"].Float(0), 7.0f);
}

TEST(MathTest, SmoothStep) {
  auto outputs =
      RunBlock("smooth_step",
               {{"value", Floats({0, 1, 1.5, 2, 3})}, {"low", Floats({1})}, {"high", Floats({2})}});
  auto jump =
      RunBlock("smooth_step",
               {{"value", Floats({0.99, 1.01})}, {"low", Floats({1})}, {"high", Floats({1})}});
  ASSERT_EQ(outputs.size() + jump.size(), 2u);
  const float kWanted[] = {0, 0, 0.5, 1, 1};
  for (size_t i = 0; i < 5; ++i) {
    EXPECT_FLOAT_EQ(outputs["result"].Float(i), kWanted[i]);
  }
  EXPECT_EQ(jump["result"].Float(0), 0.0f);
  EXPECT_EQ(jump["result"].Float(1), 1.0f);
}

// With the ends exchanged it is what 1 leaves of the rise.
TEST(MathTest, SmoothStepFallsWithItsEndsExchanged) {
  const Values value = Floats({-1, 0.2, 0.5, 0.9, 1.3, 1.7, 1.9, 4});
  auto rise = RunBlock("smooth_step",
                       {{"value", value}, {"low", Floats({0.25})}, {"high", Floats({1.75})}});
  auto fall = RunBlock("smooth_step",
                       {{"value", value}, {"low", Floats({1.75})}, {"high", Floats({0.25})}});
  ASSERT_EQ(rise.size() + fall.size(), 2u);
  for (size_t i = 0; i < value.count; ++i) {
    EXPECT_NEAR(fall["result"].Float(i), 1 - rise["result"].Float(i), 1e-6) << i;
  }
  EXPECT_EQ(fall["result"].Float(0), 1.0f);
  EXPECT_EQ(fall["result"].Float(7), 0.0f);
}

// A straight edge between pixels: each gets the share of itself that lies above.
TEST(MathTest, ThresholdGivesAPixelItsShare) {
  // One quad; the value rises by 0.1 a pixel to the right and not upwards.
  auto outputs =
      RunBlock("threshold", {{"value", Floats({0.48, 0.58, 0.48, 0.58})}, {"edge", Floats({0.5})}});
  ASSERT_EQ(outputs.size(), 1u);
  EXPECT_NEAR(outputs["result"].Float(0), 0.3, 1e-5);
  EXPECT_NEAR(outputs["result"].Float(1), 1.0, 1e-5);
  auto still = RunBlock("threshold", {{"value", Floats({0.4, 0.4, 0.4, 0.4})}});
  ASSERT_EQ(still.size(), 1u);
  EXPECT_EQ(still["result"].Float(0), 0.0f);
}

TEST(MathTest, CompareAndSelect) {
  struct Row {
    const char* word;
    bool below, same, above;
  };
  for (const Row& row : {Row{"less", true, false, false},
                         {"less_equal", true, true, false},
                         {"greater", false, false, true},
                         {"greater_equal", false, true, true},
                         {"equal", false, true, false},
                         {"not_equal", true, false, true}}) {
    auto outputs = RunBlock(
        "compare", {{"a", Floats({1, 2, 3})}, {"b", Floats({2})}, {"relation", Word{row.word}}});
    ASSERT_EQ(outputs.size(), 1u);
    EXPECT_EQ(outputs["result"].Uint(0) != 0, row.below) << row.word;
    EXPECT_EQ(outputs["result"].Uint(1) != 0, row.same) << row.word;
    EXPECT_EQ(outputs["result"].Uint(2) != 0, row.above) << row.word;
  }
  auto outputs = RunBlock("select", {{"condition", Bools({true, false})},
                                     {"if_true", Vectors({{1, 2}})},
                                     {"if_false", Vectors({{3, 4}})}});
  ASSERT_EQ(outputs.size(), 1u);
  EXPECT_EQ(outputs["result"].Float(0, 1), 2.0f);
  EXPECT_EQ(outputs["result"].Float(1, 1), 4.0f);
}

TEST(ConstantsTest, GiveTheirValue) {
  EXPECT_EQ(RunBlock("float_constant", {{"value", Floats({0.7})}})["result"].Float(0), 0.7f);
  EXPECT_EQ(RunBlock("int_constant", {{"value", Ints({-12})}})["result"].Int(0), -12);
  EXPECT_EQ(RunBlock("vec2_constant", {{"value", Vectors({{1, 2}})}})["result"].Float(0, 1), 2.0f);
  EXPECT_EQ(RunBlock("vec3_constant", {{"value", Vectors({{1, 2, 3}})}})["result"].Float(0, 2),
            3.0f);
  EXPECT_EQ(RunBlock("color_constant", {{"value", Vectors({{1, 2, 3, 4}})}})["result"].Float(0, 3),
            4.0f);
}

TEST(ChannelsTest, PutTogetherAndTakenApart) {
  auto two = RunBlock("combine2", {{"x", Floats({1})}, {"y", Floats({2})}});
  auto three = RunBlock("combine3", {{"x", Floats({1})}, {"y", Floats({2})}, {"z", Floats({3})}});
  auto four = RunBlock("combine4", {{"x", Floats({1})}, {"y", Floats({2})}, {"z", Floats({3})}});
  EXPECT_EQ(two["result"].Float(0, 1), 2.0f);
  EXPECT_EQ(three["result"].Float(0, 2), 3.0f);
  EXPECT_EQ(four["result"].Float(0, 2), 3.0f);
  EXPECT_EQ(four["result"].Float(0, 3), 1.0f);  // alpha's default

  Values color = Vectors({{0.1, 0.2, 0.3, 0.4}});
  auto parts = RunBlock("separate", {{"color", color}});
  const char* kNames[] = {"r", "g", "b", "a"};
  for (size_t i = 0; i < 4; ++i) {
    auto channel = RunBlock("channel", {{"color", color}, {"name", Word{kNames[i]}}});
    EXPECT_EQ(channel["result"].Float(0), color.Float(0, i)) << kNames[i];
    EXPECT_EQ(parts[kNames[i]].Float(0), color.Float(0, i)) << kNames[i];
  }
  auto opaque = RunBlock("separate", {{"color", Vectors({{0.1, 0.2, 0.3}})}});
  EXPECT_EQ(opaque.size(), 3u);
  EXPECT_EQ(opaque["b"].Float(0), 0.3f);
  auto pair = RunBlock("separate", {{"color", Vectors({{0.1, 0.2}})}});
  EXPECT_EQ(pair.size(), 2u);
  EXPECT_EQ(pair["g"].Float(0), 0.2f);
  auto rgb = RunBlock("rgb", {{"color", color}});
  EXPECT_EQ(rgb["result"].Float(0, 2), 0.3f);
  auto rgba = RunBlock("rgba", {{"color", Vectors({{0.1, 0.2, 0.3}})}, {"alpha", Floats({0.5})}});
  EXPECT_EQ(rgba["result"].Float(0, 2), 0.3f);
  EXPECT_EQ(rgba["result"].Float(0, 3), 0.5f);
  auto xy = RunBlock("xy", {{"vector", Vectors({{5, 6, 7}})}});
  EXPECT_EQ(xy["result"].Float(0, 1), 6.0f);
  auto components = RunBlock("components", {{"vector", Vectors({{5, 6, 7}})}});
  EXPECT_EQ(components["x"].Float(0), 5.0f);
  EXPECT_EQ(components["z"].Float(0), 7.0f);
  auto all_four = RunBlock("components", {{"vector", Vectors({{5, 6, 7, 8}})}});
  EXPECT_EQ(all_four["x"].Float(0), 5.0f);
  EXPECT_EQ(all_four["w"].Float(0), 8.0f);
}

// White has luminance 1, and green is brightest.
TEST(ChannelsTest, Luminance) {
  auto outputs =
      RunBlock("luminance", {{"color", Vectors({{1, 1, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})}});
  ASSERT_EQ(outputs.size(), 1u);
  const float kWanted[] = {1, 0.2126f, 0.7152f, 0.0722f};
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(outputs["result"].Float(i), kWanted[i], 1e-6);
  }
  auto with_alpha = RunBlock("luminance", {{"color", Vectors({{0, 1, 0, 0}})}});
  EXPECT_NEAR(with_alpha["result"].Float(0), 0.7152, 1e-6);
}

TEST(ChannelsTest, Conversions) {
  EXPECT_EQ(RunBlock("to_float", {{"value", Ints({-7})}})["result"].Float(0), -7.0f);
  EXPECT_EQ(RunBlock("to_float", {{"value", Uints({4000000000u})}})["result"].Float(0),
            4000000000.0f);
  EXPECT_EQ(RunBlock("to_float", {{"value", Bools({true})}})["result"].Float(0), 1.0f);
  auto ints = RunBlock("to_int", {{"value", Floats({-0.5, 2.9, -3})}});
  EXPECT_EQ(ints["result"].Int(0), -1);
  EXPECT_EQ(ints["result"].Int(1), 2);
  EXPECT_EQ(ints["result"].Int(2), -3);
  EXPECT_EQ(RunBlock("to_int", {{"value", Uints({0xffffffffu})}})["result"].Int(0), -1);
}

}  // namespace
}  // namespace texgraph::blocks
