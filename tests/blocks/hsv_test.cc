// SPDX-License-Identifier: Apache-2.0
// Hue, saturation and value against the sextants of Smith, Color Gamut Transform Pairs (1978), as
// Foley, van Dam, Feiner and Hughes, Computer Graphics, section 13.3.4, write them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Triple = std::array<double, 3>;

// The hue from 0 to 1.
Triple RgbToHsv(const Vector& rgb) {
  double r = rgb[0], g = rgb[1], b = rgb[2];
  double max = std::max({r, g, b}), min = std::min({r, g, b}), delta = max - min;
  if (max == 0 || delta == 0) return {0, 0, max};
  double h = r == max   ? (g - b) / delta       // between yellow and magenta
             : g == max ? 2 + (b - r) / delta   // between cyan and yellow
                        : 4 + (r - g) / delta;  // between magenta and cyan
  return {(h < 0 ? h + 6 : h) / 6, delta / max, max};
}

Triple HsvToRgb(const Triple& hsv) {
  auto [hue, s, v] = hsv;
  double h = (hue - std::floor(hue)) * 6;
  double i = std::floor(h), f = h - i;
  double p = v * (1 - s), q = v * (1 - s * f), t = v * (1 - s * (1 - f));
  switch (static_cast<int>(i)) {
    case 0:
      return {v, t, p};
    case 1:
      return {q, v, p};
    case 2:
      return {p, v, t};
    case 3:
      return {p, q, v};
    case 4:
      return {t, p, v};
    default:
      return {v, p, q};
  }
}

Triple Adjusted(const Vector& color, double degrees, double saturation, double value) {
  auto [h, s, v] = RgbToHsv(color);
  return HsvToRgb({h + degrees / 360, std::min(s * saturation, 1.0), v * value});
}

// The corners, edges and middle of the cube, colours next to grey and to black, and 2,000 at
// random, some of them brighter than 1.
std::vector<Vector> Colors() {
  std::vector<Vector> colors;
  for (double r : {0.0, 0.5, 1.0}) {
    for (double g : {0.0, 0.5, 1.0}) {
      for (double b : {0.0, 0.5, 1.0}) {
        colors.push_back({r, g, b});
      }
    }
  }
  colors.insert(colors.end(), {{1, 0.0009765625, 0}, {0.5, 0.5, 0.5009765625}, {0, 0, 1e-6}});
  std::mt19937 bits(11);
  std::uniform_real_distribution<float> light(0, 1.5f);
  for (int i = 0; i < 2000; ++i) {
    float r = light(bits), g = light(bits);
    colors.push_back({r, g, light(bits)});
  }
  return colors;
}

void ExpectColor(const Values& seen, size_t i, const Triple& wanted, double tolerance) {
  for (size_t c = 0; c < 3; ++c) {
    ASSERT_NEAR(seen.Float(i, c), wanted[c], tolerance) << i << ", component " << c;
  }
}

// How far apart two hues are, round the circle.
double HueDistance(double a, double b) {
  double d = a - b - std::floor(a - b);
  return std::min(d, 1 - d);
}

TEST(HsvTest, OfRgbIsTheTextbooks) {
  std::vector<Vector> colors = Colors();
  auto outputs = RunBlock("rgb_to_hsv", {{"color", Vectors(colors)}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < colors.size(); ++i) {
    Triple wanted = RgbToHsv(colors[i]);
    EXPECT_LT(HueDistance(outputs["result"].Float(i, 0), wanted[0]), 1e-5) << i;
    EXPECT_NEAR(outputs["result"].Float(i, 1), wanted[1], 1e-6) << i;
    EXPECT_FLOAT_EQ(outputs["result"].Float(i, 2), static_cast<float>(wanted[2])) << i;
  }
}

TEST(HsvTest, ToRgbIsTheTextbooks) {
  std::vector<Vector> hsv;
  for (int step = -24; step <= 48; ++step) {  // every 15 degrees, once back and twice round
    for (double s : {0.0, 0.3, 1.0}) {
      for (double v : {0.0, 0.6, 1.0, 3.0}) {
        hsv.push_back({step / 24.0, s, v});
      }
    }
  }
  auto outputs = RunBlock("hsv_to_rgb", {{"hsv", Vectors(hsv)}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < hsv.size(); ++i) {
    ExpectColor(outputs["result"], i, HsvToRgb({hsv[i][0], hsv[i][1], hsv[i][2]}), 5e-6);
  }
}

TEST(HsvTest, GoesThereAndBack) {
  std::vector<Vector> colors = Colors();
  auto hsv = RunBlock("rgb_to_hsv", {{"color", Vectors(colors)}});
  ASSERT_EQ(hsv.size(), 1u);
  auto rgb = RunBlock("hsv_to_rgb", {{"hsv", hsv["result"]}});
  ASSERT_EQ(rgb.size(), 1u);
  for (size_t i = 0; i < colors.size(); ++i) {
    ExpectColor(rgb["result"], i, {colors[i][0], colors[i][1], colors[i][2]}, 3e-6);
  }
}

TEST(HsvTest, IsFiniteForAllLight) {
  std::vector<Vector> colors;
  for (double a : {0.0, 1e-38, 1e-21, 1e-7, 1.0, 65504.0}) {
    for (double b : {0.0, 1e-38, 1.0, 1.0000001, 65504.0}) {
      colors.insert(colors.end(), {{a, b, b}, {b, a, b}, {a, a, b}, {a, b, 0}});
    }
  }
  auto hsv = RunBlock("rgb_to_hsv", {{"color", Vectors(colors)}});
  auto rgb = RunBlock("hsv_adjust",
                      {{"color", Vectors(colors)}, {"hue", Floats({90})}, {"value", Floats({2})}});
  ASSERT_EQ(hsv.size() + rgb.size(), 2u);
  for (size_t i = 0; i < 3 * colors.size(); ++i) {
    EXPECT_TRUE(std::isfinite(hsv["result"].Float(i / 3, i % 3))) << i / 3;
    EXPECT_TRUE(std::isfinite(rgb["result"].Float(i / 3, i % 3))) << i / 3;
  }
}

TEST(HsvAdjustTest, TurnsAndMultiplies) {
  std::vector<Vector> colors = Colors();
  struct Change {
    double degrees, saturation, value;
  };
  for (Change change : {Change{0, 1, 1}, {120, 1, 1}, {-47, 0.6, 1.3}, {400, 3, 0.5}, {10, 0, 1}}) {
    auto outputs = RunBlock("hsv_adjust", {{"color", Vectors(colors)},
                                           {"hue", Floats({change.degrees})},
                                           {"saturation", Floats({change.saturation})},
                                           {"value", Floats({change.value})}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < colors.size(); ++i) {
      ExpectColor(outputs["result"], i,
                  Adjusted(colors[i], change.degrees, change.saturation, change.value), 1e-5);
    }
  }
}

TEST(HsvAdjustTest, AThirdOfTheCircleMovesTheComponentsOn) {
  auto outputs =
      RunBlock("hsv_adjust", {{"color", Vectors({{0.9, 0.2, 0.4, 0.3}})}, {"hue", Floats({120})}});
  ASSERT_EQ(outputs.size(), 1u);
  const double wanted[] = {0.4, 0.9, 0.2, 0.3};
  for (size_t c = 0; c < 4; ++c) {
    EXPECT_NEAR(outputs["result"].Float(0, c), wanted[c], 1e-6);
  }
}

// Tiles with seeds of all kinds.
Values TilesWithSeeds(size_t count, std::vector<uint32_t>& seeds) {
  std::vector<Vector> uv;
  for (size_t i = 0; i < count; ++i) {
    uv.push_back({static_cast<double>(i) + 0.5, 0.5});
  }
  auto outputs = RunBlock("brick_grid", {{"uv", Vectors(uv)},
                                         {"rows", Ints({1})},
                                         {"columns", Ints({1})},
                                         {"row_offset", Floats({0})}});
  if (outputs.empty()) return {};
  for (size_t i = 0; i < count; ++i) {
    seeds.push_back(outputs["tile"].Uint(i, 6));
  }
  return outputs["tile"];
}

TEST(TileRandomHsvTest, AdjustsByTheTilesNumbers) {
  std::vector<uint32_t> seeds;
  Values tiles = TilesWithSeeds(2000, seeds);
  ASSERT_EQ(seeds.size(), 2000u);
  const Vector color = {0.75, 0.25, 0.125, 0.5};
  auto outputs = RunBlock("tile_random_hsv", {{"tile", tiles},
                                              {"color", Vectors({color})},
                                              {"hue", Vectors({{-30, 90}})},
                                              {"saturation", Vectors({{0.25, 1.5}})},
                                              {"value", Vectors({{0.5, 2}})},
                                              {"stream", Ints({5})}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < seeds.size(); ++i) {
    uint32_t bits = reference::Pcg(seeds[i] + 5);
    Triple wanted = Adjusted(color, reference::Mix(-30, 90, reference::Low16(bits)),
                             reference::Mix(0.25, 1.5, reference::High16(bits)),
                             reference::Mix(0.5, 2, reference::Unit24(reference::Pcg(bits))));
    ExpectColor(outputs["result"], i, wanted, 1e-5);
    EXPECT_EQ(outputs["result"].Float(i, 3), 0.5f);
  }
}

// What can be seen of the limits: value and saturation lie between theirs, evenly, and each tile
// has numbers of its own. By default nothing changes.
TEST(TileRandomHsvTest, StaysWithinItsLimits) {
  std::vector<uint32_t> seeds;
  Values tiles = TilesWithSeeds(5000, seeds);
  ASSERT_EQ(seeds.size(), 5000u);
  auto varied = RunBlock("tile_random_hsv", {{"tile", tiles},
                                             {"color", Vectors({{0.8, 0.4, 0.4}})},
                                             {"saturation", Vectors({{0.5, 1.5}})},
                                             {"value", Vectors({{0.5, 1}})}});
  auto same = RunBlock("tile_random_hsv", {{"tile", tiles}, {"color", Vectors({{0.8, 0.4, 0.2}})}});
  ASSERT_EQ(varied.size() + same.size(), 2u);
  double sum = 0, product = 0;
  for (size_t i = 0; i < seeds.size(); ++i) {
    double value = varied["result"].Float(i, 0);
    double saturation = 1 - varied["result"].Float(i, 1) / value;
    ASSERT_GE(value, 0.4 - 1e-6);
    ASSERT_LE(value, 0.8 + 1e-6);
    ASSERT_GE(saturation, 0.25 - 1e-5);
    ASSERT_LE(saturation, 0.75 + 1e-5);
    sum += value;
    product += (value - 0.6) * (saturation - 0.5);
    ExpectColor(same["result"], i, {0.8, 0.4, 0.2}, 1e-6);
  }
  // Standard deviations of uniform numbers: 0.4 and 0.5 over the root of 12.
  EXPECT_NEAR(sum / 5000, 0.6, 5 * 0.1155 / std::sqrt(5000.0));
  EXPECT_NEAR(product / 5000, 0, 5 * 0.1155 * 0.1443 / std::sqrt(5000.0));
}

}  // namespace
}  // namespace texgraph::blocks
