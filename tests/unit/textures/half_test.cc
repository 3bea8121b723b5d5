// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/half.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace texgraph::textures {
namespace {

// IEEE 754-2019, table 3.5: binary16 has 5 bits of exponent, biased by 15, and 10 of fraction.
double ValueOf(uint32_t half) {
  const int exponent = static_cast<int>(half / 1024 % 32);
  const int fraction = static_cast<int>(half % 1024);
  const double sign = half >= 0x8000 ? -1.0 : 1.0;
  if (exponent == 0) return sign * std::ldexp(fraction, -24);
  return sign * std::ldexp(1024 + fraction, exponent - 25);
}

TEST(HalfTest, EveryHalfIsItsValueAndComesBack) {
  for (uint32_t i = 0; i < 0x10000; ++i) {
    const auto half = static_cast<uint16_t>(i);
    const float value = HalfToFloat(half);
    if (i / 1024 % 32 == 31) {
      EXPECT_EQ(std::isnan(value), i % 1024 != 0) << i;
      EXPECT_EQ(std::isinf(value), i % 1024 == 0) << i;
      EXPECT_TRUE(std::isnan(value) || std::signbit(value) == (i >= 0x8000)) << i;
      EXPECT_TRUE(std::isnan(value) || FloatToHalf(value) == half) << i;
      continue;
    }
    ASSERT_EQ(value, ValueOf(i)) << i;
    ASSERT_EQ(FloatToHalf(value), half) << i;
  }
}

TEST(HalfTest, RoundsToTheNearestAndTiesToEven) {
  for (uint32_t i = 0; i < 0x7bff; ++i) {  // each half and the one after it
    const double low = ValueOf(i);
    const double high = ValueOf(i + 1);
    const auto middle = static_cast<float>((low + high) / 2);  // one bit more: exact
    const uint32_t even = i % 2 == 0 ? i : i + 1;
    ASSERT_EQ(FloatToHalf(middle), even) << i;
    ASSERT_EQ(FloatToHalf(std::nextafter(middle, 0.0f)), i) << i;
    ASSERT_EQ(FloatToHalf(std::nextafter(middle, 1e9f)), i + 1) << i;
    ASSERT_EQ(FloatToHalf(-middle), even | 0x8000) << i;
  }
}

TEST(HalfTest, EndsInInfinity) {
  EXPECT_EQ(FloatToHalf(65504.0f), 0x7bff);
  EXPECT_EQ(FloatToHalf(std::nextafter(65520.0f, 0.0f)), 0x7bff);
  EXPECT_EQ(FloatToHalf(65520.0f), 0x7c00);
  EXPECT_EQ(FloatToHalf(-INFINITY), 0xfc00);
  EXPECT_TRUE(std::isnan(HalfToFloat(FloatToHalf(NAN))));
  EXPECT_EQ(FloatToHalf(1e-30f), 0);
  EXPECT_EQ(FloatToHalf(-0.0f), 0x8000);
}

// What maps need: every whole number to 2,048 is a half, 2,049 is not.
TEST(HalfTest, HoldsWholeNumbers) {
  for (int i = -1; i <= 2048; ++i) {
    EXPECT_EQ(HalfToFloat(FloatToHalf(static_cast<float>(i))), static_cast<float>(i));
  }
  EXPECT_NE(HalfToFloat(FloatToHalf(2049.0f)), 2049.0f);
}

}  // namespace
}  // namespace texgraph::textures
