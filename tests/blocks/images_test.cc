// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "graphs/pictures/picture.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

TEST(UvTransformTest, DrawsScaledThenTurnedThenMoved) {
  constexpr double kAngle = 30 * std::numbers::pi / 180;
  const Vector kTranslate = {0.3, -0.1}, kScale = {2, 0.5}, kPivot = {0.25, 0.75};
  // A point of the drawing, and where it is seen.
  std::vector<Vector> drawn = {{0, 0}, {0.25, 0.75}, {1, 0.2}, {-0.7, 3}}, seen;
  for (const Vector& p : drawn) {
    double x = (p[0] - kPivot[0]) * kScale[0], y = (p[1] - kPivot[1]) * kScale[1];
    seen.push_back({std::cos(kAngle) * x - std::sin(kAngle) * y + kPivot[0] + kTranslate[0],
                    std::sin(kAngle) * x + std::cos(kAngle) * y + kPivot[1] + kTranslate[1]});
  }
  auto outputs = RunBlock("uv_transform", {{"uv", Vectors(seen)},
                                           {"translate", Vectors({kTranslate})},
                                           {"rotation", Floats({30})},
                                           {"scale", Vectors({kScale})},
                                           {"pivot", Vectors({kPivot})}});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < drawn.size(); ++i) {
    EXPECT_NEAR(outputs["result"].Float(i, 0), drawn[i][0], 1e-5);
    EXPECT_NEAR(outputs["result"].Float(i, 1), drawn[i][1], 1e-5);
  }
}

// The colour of the texel whose middle is at a point, decoded by the formula of IEC 61966-2-1,
// straight from the file.
std::array<double, 3> TexelAt(const pictures::Picture& picture, int x, int y_from_below) {
  std::array<double, 3> texel{};
  size_t channels = picture.has_alpha ? 4 : 3;
  for (size_t c = 0; c < 3; ++c) {
    size_t row = static_cast<size_t>(picture.height - 1 - y_from_below);
    double v = picture.pixels[channels * (row * picture.width + x) + c] / 255.0;
    texel[c] = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  }
  return texel;
}

constexpr char kTextures[] =
    R"({"texgraph": 1, "textures": {"mortar": {"file": "mortar.png"}}, "nodes": {"n": )";

TEST(ImageTest, GivesTheTexelsOfThePicture) {
  pictures::Picture mortar = pictures::MakeMortar(256);
  std::vector<Point> points;
  std::vector<std::pair<int, int>> texels = {{0, 0}, {255, 255}, {17, 201}, {128, 3}};
  for (auto [x, y] : texels) {
    points.push_back({(x + 0.5) / 256, (y + 0.5) / 256});
  }
  auto outputs = RunGraph(
      std::string(kTextures) +
          R"({"block": "image", "in": {"picture": "mortar"}}}, "outputs": {"color": "n"}})",
      points, {1e-5, 1e-5});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < points.size(); ++i) {
    std::array<double, 3> wanted = TexelAt(mortar, texels[i].first, texels[i].second);
    for (size_t c = 0; c < 3; ++c) {
      EXPECT_NEAR(outputs["color"].Float(i, c), wanted[c], 2e-4);
    }
    EXPECT_EQ(outputs["color"].Float(i, 3), 1.0f);
  }
}

// Layer 0, layer 1, and the last one for a number beyond it.
TEST(ImageTest, GivesTheLayersOfAnArray) {
  const std::array<pictures::Picture, 2> layers = {pictures::MakeMoss(256), pictures::MakeSoot()};
  const std::vector<std::pair<int, int>> texels = {{0, 0}, {255, 255}, {17, 201}, {128, 3}};
  std::vector<Point> points;
  for (auto [x, y] : texels) points.push_back({(x + 0.5) / 256, (y + 0.5) / 256});
  for (int layer : {0, 1, 5}) {
    auto outputs = RunGraph(
        R"({"texgraph": 1, "textures": {"stains": {"layers": ["moss.png", "soot.png"]}}, "nodes": {
            "n": {"block": "image", "in": {"picture": "stains", "layer": )" +
            std::to_string(layer) + R"(}}}, "outputs": {"color": "n"}})",
        points, {1e-5, 1e-5});
    ASSERT_EQ(outputs.size(), 1u);
    const pictures::Picture& shown = layers[std::min(layer, 1)];
    for (size_t i = 0; i < points.size(); ++i) {
      std::array<double, 3> wanted = TexelAt(shown, texels[i].first, texels[i].second);
      for (size_t c = 0; c < 3; ++c) {
        EXPECT_NEAR(outputs["color"].Float(i, c), wanted[c], 2e-4) << layer;
      }
    }
  }
}

// Pictures stand side by side: three to a unit and moved by a quarter picture to the right.
TEST(TiledImageTest, RepeatsAndMoves) {
  pictures::Picture mortar = pictures::MakeMortar(256);
  std::vector<Point> points;
  std::vector<std::pair<int, int>> texels = {{5, 9}, {250, 130}};
  for (int n = -1; n < 3; ++n) {
    for (auto [x, y] : texels) {
      points.push_back({((x + 0.5) / 256 + n + 0.25) / 3, ((y + 0.5) / 256 + 2 * n) / 2});
    }
  }
  auto outputs =
      RunGraph(std::string(kTextures) +
                   R"({"block": "tiled_image", "in": {"picture": "mortar", "tiling": [3, 2],
                              "offset": [0.25, 0]}}}, "outputs": {"color": "n"}})",
               points, {1e-5, 1e-5});
  ASSERT_EQ(outputs.size(), 1u);
  for (size_t i = 0; i < points.size(); ++i) {
    std::array<double, 3> wanted = TexelAt(mortar, texels[i % 2].first, texels[i % 2].second);
    EXPECT_NEAR(outputs["color"].Float(i, 1), wanted[1], 2e-3);
  }
}

}  // namespace
}  // namespace texgraph::blocks
