// SPDX-License-Identifier: Apache-2.0
// Patterns from arrays, atlases and volumes: the right one, where it belongs, and never a trace of
// another, however large a pixel is.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tests/blocks/run_block.h"
#include "tests/blocks/scattered_points.h"

namespace texgraph::blocks {
namespace {

// The colour of pattern `p`: no two are alike, and no mean of some is another.
std::array<float, 4> ColorOf(int p) {
  return {static_cast<float>(p + 1), static_cast<float>((p * p) % 7), static_cast<float>(p % 3), 1};
}

// Patterns of one colour each, side by side in the order of rows from the top.
ir::Texture Atlas(int columns, int rows, int side) {
  ir::Texture atlas;
  ir::Texture::Level level;
  level.width = static_cast<uint32_t>(columns * side);
  level.height = static_cast<uint32_t>(rows * side);
  for (int y = 0; y < rows * side; ++y) {
    for (int x = 0; x < columns * side; ++x) {
      level.texels.push_back(ColorOf((rows - 1 - y / side) * columns + x / side));
    }
  }
  atlas.levels.push_back(level);
  ir::BuildMipChain(atlas);
  // No level coarser than a texel a pattern.
  atlas.sampler.max_level = static_cast<float>(std::countr_zero(static_cast<uint32_t>(side)));
  return atlas;
}

std::vector<Point> Scatter(int count) {
  std::vector<Point> points = ScatteredPoints(count);
  // At borders of tiles.
  for (double p : {0.0, 0.25, 0.5, 0.75, 0.24999, 0.50001}) {
    points.push_back({p, 0.3});
    points.push_back({0.6, p});
  }
  return points;
}

// A pattern, or by way of a node that numbers are not followed through: those that are known to be
// beyond the last are refused.
std::string PatternPort(int pattern) {
  return R"("pattern": )" + (pattern > 5 ? R"("beyond")" : std::to_string(pattern));
}

// A graph that draws one pattern in a map of 4 x 4 tiles.
std::map<std::string, Values> Draw(const std::string& declaration, const std::string& ports,
                                   const ir::Texture& texture, const std::vector<Point>& points,
                                   Point pixel) {
  return RunGraph(R"({"texgraph": 1, "textures": {"p": )" + declaration + R"(}, "nodes": {
      "tiles": {"block": "virtual_tile_map", "in": {"cells": [4, 4]}},
      "beyond": {"block": "to_int", "in": {"value": 9}},
      "color": {"block": "reference_texture", "in": {"patterns": "p", "tile": "tiles", )" +
                      ports + R"(}}}, "outputs": {"color": "color"}})",
                  points, pixel, 1e-4, PictureFolder(), {{"p", texture}});
}

void ExpectOnly(const std::map<std::string, Values>& outputs, std::array<float, 4> wanted,
                const std::string& what) {
  ASSERT_EQ(outputs.size(), 1u) << what;
  const Values& color = outputs.at("color");
  for (size_t i = 0; i < color.count; ++i) {
    for (size_t c = 0; c < 4; ++c) ASSERT_NEAR(color.Float(i, c), wanted[c], 1e-5) << what;
  }
}

TEST(ReferenceTextureTest, AtlasesNeverMixPatterns) {
  const std::vector<Point> points = Scatter(300);
  for (int side : {16, 12, 5}) {
    const ir::Texture atlas = Atlas(3, 2, side);
    for (double pixel : {1e-4, 0.01, 0.03, 0.1, 0.25, 1.0, 7.0}) {
      for (int pattern : {0, 2, 3, 5}) {
        auto outputs = Draw(R"({"file": "moss.png"})",
                            R"("grid": [3, 2], "pattern": )" + std::to_string(pattern), atlas,
                            points, {pixel, 0.6 * pixel});
        ExpectOnly(
            outputs, ColorOf(pattern),
            std::to_string(side) + " " + std::to_string(pixel) + " " + std::to_string(pattern));
      }
    }
    for (auto [pattern, wanted] : {std::pair{-1, std::array<float, 4>{}}, {6, ColorOf(5)}}) {
      ExpectOnly(Draw(R"({"file": "moss.png"})", R"("grid": [3, 2], )" + PatternPort(pattern),
                      atlas, points, {0.01, 0.01}),
                 wanted, "beyond");
    }
  }
}

// What the texture says of its own grid nobody has to say again.
TEST(ReferenceTextureTest, AtlasesKnowTheirGrid) {
  const ir::Texture atlas = Atlas(3, 2, 8);
  const std::string declaration = R"({"layers": ["moss.png", "moss.png", "moss.png", "moss.png",
      "moss.png"], "pack": "atlas", "grid": [3, 2]})";
  for (int pattern : {0, 1, 3, 4}) {
    ExpectOnly(Draw(declaration, PatternPort(pattern), atlas, Scatter(50), {0.01, 0.01}),
               ColorOf(pattern), std::to_string(pattern));
  }
}

// Within a pattern an atlas shows what a texture of the pattern alone does, away from its border.
TEST(ReferenceTextureTest, AtlasesShowTheirPatternsInPlace) {
  constexpr int kSide = 8;
  ir::Texture atlas = Atlas(2, 2, kSide);
  auto& texels = atlas.levels[0].texels;
  for (size_t i = 0; i < texels.size(); ++i) {
    texels[i][0] = static_cast<float>(i % (2 * kSide));
    texels[i][1] = static_cast<float>(i / (2 * kSide));
  }
  std::vector<Point> points;
  for (int i = 0; i < 64; ++i) {
    points.push_back({(i % 8 + 0.5) / 32 + 0.25, (i / 8 + 0.5) / 32 + 0.5});
  }
  // Pattern 1 is the right upper one: its texels begin at (8, 8).
  auto outputs = Draw(R"({"file": "moss.png"})", R"("grid": [2, 2], "pattern": 1)", atlas, points,
                      {1e-4, 1e-4});
  ASSERT_EQ(outputs.size(), 1u);
  for (int i = 0; i < 64; ++i) {
    EXPECT_NEAR(outputs["color"].Float(static_cast<size_t>(i), 0), 8 + i % 8, 1e-3);
    EXPECT_NEAR(outputs["color"].Float(static_cast<size_t>(i), 1), 8 + i / 8, 1e-3);
  }
}

TEST(ReferenceTextureTest, LayersOfAnArray) {
  ir::Texture array;
  array.is_array = true;
  array.levels.push_back({4, 4, 3, {}});
  for (int i = 0; i < 48; ++i) array.levels[0].texels.push_back(ColorOf(i / 16));
  ir::BuildMipChain(array);
  const std::vector<Point> points = Scatter(100);
  for (double pixel : {1e-4, 0.05, 0.5, 3.0}) {
    for (int pattern : {0, 1, 2, 9, -1}) {
      auto outputs = Draw(R"({"layers": ["moss.png", "soot.png", "moss.png"]})",
                          PatternPort(pattern), array, points, {pixel, pixel});
      ExpectOnly(outputs, pattern < 0 ? std::array<float, 4>{} : ColorOf(std::min(pattern, 2)),
                 std::to_string(pattern));
    }
  }
}

// Volumes one upon the other: a pattern fills its slices and no other's, in each level.
TEST(ReferenceTextureTest, VolumesNeverMixPatterns) {
  ir::Texture volume;
  volume.is_3d = true;
  volume.levels.push_back({4, 4, 12, {}});
  for (int i = 0; i < 192; ++i) volume.levels[0].texels.push_back(ColorOf(i / 64));
  ir::BuildMipChain(volume);
  std::vector<Vector> uvw;
  for (int i = 0; i < 200; ++i) {
    uvw.push_back(
        {std::fmod(0.754877 * i, 2), std::fmod(0.56984 * i, 2), std::fmod(0.3141 * i, 2)});
    if (i % 10 == 0) uvw.back()[2] = i % 20 == 0 ? 0.5 : 0.49999;
  }
  Values cells{ir::Vector(ir::Scalar::kInt, 3), 1, {2, 2, 2}};
  Values tiles = RunBlock("virtual_tile_map", {{"uv", Vectors(uvw)}, {"cells", cells}})["tile"];
  for (int pattern : {0, 1, 2, 7, -1}) {
    auto outputs = RunBlock("reference_texture", {{"patterns", volume},
                                                  {"tile", tiles},
                                                  {"pattern", Ints({pattern})},
                                                  {"patterns_count", Ints({3})}});
    ASSERT_EQ(outputs.size(), 1u);
    const std::array<float, 4> wanted =
        pattern < 0 ? std::array<float, 4>{} : ColorOf(std::min(pattern, 2));
    for (size_t i = 0; i < uvw.size(); ++i) {
      for (size_t c = 0; c < 4; ++c) {
        ASSERT_NEAR(outputs["result"].Float(i, c), wanted[c], 1e-5) << pattern << " " << i;
      }
    }
  }
}

}  // namespace
}  // namespace texgraph::blocks
