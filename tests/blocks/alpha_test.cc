// SPDX-License-Identifier: Apache-2.0
// Blocks that make and change alpha: masks, keys, and the two forms of colours.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

const std::vector<Vector> kColors = {{0.25, 0.5, 1, 0.5},  {0.25, 0.5, 1, 1}, {3, 0, 0.125, 0.75},
                                     {0.25, 0.5, 1, 0},    {0, 0, 0, 0},      {1, 1, 1, 0x1p-10},
                                     {0.5, 1, 0.25, 1e-38}};

void ExpectVector(const Values& seen, size_t i, const Vector& wanted) {
  for (size_t c = 0; c < wanted.size(); ++c) {
    EXPECT_FLOAT_EQ(seen.Float(i, c), static_cast<float>(wanted[c])) << i << ", component " << c;
  }
}

TEST(PremultiplyTest, MultipliesLight) {
  auto outputs = RunBlock("premultiply", {{"color", Vectors(kColors)}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < kColors.size(); ++i) {
    const Vector& c = kColors[i];
    double a = static_cast<float>(c[3]);
    ExpectVector(outputs["result"], i, {c[0] * a, c[1] * a, c[2] * a, a});
  }
}

TEST(UnpremultiplyTest, IsTheInverseAndBlackWithoutAlpha) {
  auto premultiplied = RunBlock("premultiply", {{"color", Vectors(kColors)}});
  ASSERT_EQ(premultiplied.size(), 1u);
  auto outputs = RunBlock("unpremultiply", {{"color", premultiplied["result"]}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < kColors.size(); ++i) {
    const Vector& c = kColors[i];
    if (c[3] > 1e-20) {
      ExpectVector(outputs["result"], i, c);
    }
  }
  // Light without alpha, or nearly without.
  auto odd = RunBlock("unpremultiply", {{"color", Vectors({{1, 2, 3, 0}, {1, 2, 3, 1e-38}})}});
  ASSERT_EQ(odd.size(), 1u);
  ExpectVector(odd["result"], 0, {0, 0, 0, 0});
  EXPECT_TRUE(std::isfinite(odd["result"].Float(1, 2)));
}

TEST(ApplyMaskTest, MultipliesAlpha) {
  for (bool invert : {false, true}) {
    for (double mask : {0.0, 0.25, 1.0}) {
      double shown = invert ? 1 - mask : mask;
      auto straight = RunBlock(
          "apply_mask",
          {{"color", Vectors(kColors)}, {"mask", Floats({mask})}, {"invert", Bools({invert})}});
      auto premultiplied = RunBlock("apply_mask", {{"color", Vectors(kColors)},
                                                   {"mask", Floats({mask})},
                                                   {"invert", Bools({invert})},
                                                   {"alpha", Word{"premultiplied"}}});
      ASSERT_EQ(straight.size() + premultiplied.size(), 2u);
      for (size_t i = 0; i < kColors.size(); ++i) {
        const Vector& c = kColors[i];
        double a = static_cast<float>(c[3]) * shown;
        ExpectVector(straight["result"], i, {c[0], c[1], c[2], a});
        ExpectVector(premultiplied["result"], i, {c[0] * shown, c[1] * shown, c[2] * shown, a});
      }
    }
  }
}

double Keyed(const Vector& color, const Vector& key, double tolerance, double softness) {
  auto outputs = RunBlock("color_key", {{"color", Vectors({color})},
                                        {"key", Vectors({key})},
                                        {"tolerance", Floats({tolerance})},
                                        {"softness", Floats({softness})}});
  if (outputs.empty()) return NAN;
  for (size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(outputs["result"].Float(0, c), static_cast<float>(color[c]));
  }
  return outputs["result"].Float(0, 3);
}

TEST(ColorKeyTest, RisesFromToleranceOverSoftness) {
  // The distance of (0.3, 0.6, 0.6) from black is 0.9.
  const Vector color = {0.3, 0.6, 0.6, 0.5}, black = {0, 0, 0};
  EXPECT_EQ(Keyed(color, black, 1.0, 0.5), 0);
  EXPECT_NEAR(Keyed(color, black, 0.5, 0.8), 0.5 * 0.5, 1e-6);
  EXPECT_NEAR(Keyed(color, black, 0.8, 0.4), 0.25 * 0.5, 1e-6);
  EXPECT_EQ(Keyed(color, black, 0.5, 0.25), 0.5);
  EXPECT_NEAR(Keyed(color, {0.3, 0.2, 0.3}, 0.25, 0.5), 0.5 * 0.5, 1e-6);
  EXPECT_EQ(Keyed({0, 0, 0, 1}, black, 0, 1), 0);
}

TEST(ColorKeyTest, WithoutSoftnessItIsAStep) {
  EXPECT_EQ(Keyed({0.2, 0, 0, 1}, {0, 0, 0}, 0.1, 0), 1);
  EXPECT_EQ(Keyed({0.05, 0, 0, 1}, {0, 0, 0}, 0.1, 0), 0);
  EXPECT_EQ(Keyed({0, 0, 0, 1}, {0, 0, 0}, 0, 0), 0);
}

}  // namespace
}  // namespace texgraph::blocks
