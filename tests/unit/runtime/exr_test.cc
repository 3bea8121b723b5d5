// SPDX-License-Identifier: Apache-2.0
// What is written is read back by an independent reader.
#include "runtime/exr.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "tests/unit/runtime/exr_reader.h"

namespace texgraph::runtime {
namespace {

// Numbers of every size and both signs.
std::vector<float> Numbers(uint32_t width, uint32_t height) {
  std::vector<float> pixels(size_t{width} * height * 4);
  uint32_t state = 1;
  for (float& pixel : pixels) {
    state = state * 1664525u + 1013904223u;
    pixel =
        std::ldexp(static_cast<float>(state >> 8) - 8388608.0f, static_cast<int>(state % 40) - 40);
  }
  return pixels;
}

// The nearest number of 11 bits by division, ties to even: what half holds in its normal range.
float NearestHalf(float value) {
  if (value == 0 || std::abs(value) < 6.103515625e-5f)
    return static_cast<float>(std::nearbyint(double{value} * 16777216.0) / 16777216.0);
  int exponent = 0;
  const double mantissa = std::frexp(double{value}, &exponent);
  return static_cast<float>(std::ldexp(std::nearbyint(mantissa * 2048), exponent - 11));
}

TEST(ExrTest, FloatsComeBackExactly) {
  // More rows than a chunk of 16, and a last chunk that is not full.
  for (const auto& [width, height] : {std::pair{1u, 1u}, {5u, 3u}, {7u, 37u}, {100u, 16u}}) {
    const std::vector<float> pixels = Numbers(width, height);
    for (uint32_t channels = 1; channels <= 4; ++channels) {
      const auto bytes = EncodeExr(pixels, width, height, channels, ExrDepth::kFloat);
      ASSERT_TRUE(bytes);
      const ExrFile read = ReadExr(*bytes);
      EXPECT_EQ(read.width, static_cast<int>(width));
      EXPECT_EQ(read.height, static_cast<int>(height));
      EXPECT_EQ(read.type, Imf::FLOAT);
      const std::vector<std::string> names = {"Y", "GR", "BGR", "ABGR"};
      ASSERT_EQ(read.channels, names[channels - 1]);
      for (uint32_t y = 0; y < height; ++y) {
        for (uint32_t x = 0; x < width; ++x) {
          for (uint32_t c = 0; c < channels; ++c) {
            const float want = pixels[((height - 1 - y) * width + x) * 4 + c];
            ASSERT_EQ(read.planes[channels - 1 - c][y * width + x], want) << x << " " << y;
          }
        }
      }
    }
  }
}

TEST(ExrTest, HalvesAreTheNearest) {
  const uint32_t width = 33, height = 20;
  const std::vector<float> pixels = Numbers(width, height);
  const auto bytes = EncodeExr(pixels, width, height, 4, ExrDepth::kHalf);
  ASSERT_TRUE(bytes);
  const ExrFile read = ReadExr(*bytes);
  EXPECT_EQ(read.type, Imf::HALF);
  ASSERT_EQ(read.channels, "ABGR");
  for (uint32_t i = 0; i < width * height; ++i) {
    const uint32_t at = (height - 1 - i / width) * width + i % width;
    for (uint32_t c = 0; c < 4; ++c) {
      const float want = NearestHalf(pixels[at * 4 + c]);
      ASSERT_EQ(read.planes[3 - c][i],
                std::abs(want) >= 65520 ? std::copysign(INFINITY, want) : want)
          << pixels[at * 4 + c];
    }
  }
}

TEST(ExrTest, WhatIsNoNumberComesBack) {
  const float infinity = std::numeric_limits<float>::infinity();
  const std::vector<float> pixels = {std::nanf(""), infinity, -infinity, -0.0f,  //
                                     65504.0f,      65519.0f, 65521.0f,  1e-45f};
  for (const ExrDepth depth : {ExrDepth::kHalf, ExrDepth::kFloat}) {
    const auto bytes = EncodeExr(pixels, 2, 1, 4, depth);
    ASSERT_TRUE(bytes);
    const ExrFile read = ReadExr(*bytes);
    EXPECT_TRUE(std::isnan(read.planes[3][0]));
    EXPECT_EQ(read.planes[2][0], infinity);
    EXPECT_EQ(read.planes[1][0], -infinity);
    EXPECT_EQ(std::bit_cast<uint32_t>(read.planes[0][0]), 0x80000000u);
    EXPECT_EQ(read.planes[3][1], 65504.0f);
    const bool half = depth == ExrDepth::kHalf;
    EXPECT_EQ(read.planes[2][1], half ? 65504.0f : 65519.0f);
    EXPECT_EQ(read.planes[1][1], half ? infinity : 65521.0f);
    EXPECT_EQ(read.planes[0][1], half ? 0.0f : 1e-45f);
  }
}

TEST(ExrTest, TheSamePixelsGiveTheSameBytes) {
  const std::vector<float> pixels = Numbers(40, 40);
  EXPECT_EQ(EncodeExr(pixels, 40, 40, 3, ExrDepth::kHalf),
            EncodeExr(pixels, 40, 40, 3, ExrDepth::kHalf));
}

TEST(ExrTest, NoPicture) {
  const std::vector<float> pixels(16);
  EXPECT_FALSE(EncodeExr(pixels, 0, 1, 4, ExrDepth::kFloat));
  EXPECT_FALSE(EncodeExr(pixels, 1, 0, 4, ExrDepth::kFloat));
  EXPECT_FALSE(EncodeExr(pixels, 2, 2, 5, ExrDepth::kFloat));
  EXPECT_FALSE(EncodeExr(pixels, 2, 2, 0, ExrDepth::kFloat));
  EXPECT_FALSE(EncodeExr(pixels, 5, 1, 4, ExrDepth::kFloat));
}

}  // namespace
}  // namespace texgraph::runtime
