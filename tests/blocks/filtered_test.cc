// SPDX-License-Identifier: Apache-2.0
// Whole walls against 1,024 samples a pixel, from one tile to 64 by 64 tiles a pixel:
// what is seen from far away is the mean of what is there, and nothing shimmers or pops on the way.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/blocks/mean_error.h"

namespace texgraph::blocks {
namespace {

constexpr int kColumns = 4, kRows = 8;

struct Wall {
  const char* name;
  std::string graph;
};

std::string Graph(const std::string& functions, const std::string& nodes) {
  return R"({"texgraph": 1, "functions": {)" + functions + R"(}, "nodes": {
      "grid": {"block": "brick_grid", "in": {"rows": 8, "columns": 4, "row_jitter": 0.1, "seed": 3}},)" +
         nodes + R"(}, "outputs": {"color": "wall"}})";
}

const char* const kFace = R"("face": {"inputs": {"uv": "vec2"}, "nodes": {
    "clouds": {"block": "value_noise", "in": {"uv": "uv", "scale": [5, 3], "seed": 1}},
    "tone": {"block": "remap", "in": {"value": "clouds", "out_low": 0.55, "out_high": 1.35}},
    "shape": {"block": "rectangle", "in": {"uv": "uv", "size": [0.92, 0.86]}},
    "rgb": {"block": "combine3", "in": {"x": "tone", "y": "tone", "z": "tone"}},
    "painted": {"block": "rgba", "in": {"color": "rgb", "alpha": "shape"}}}, "outputs": {"color": "painted"}})";
const char* const kSplash = R"(, "splash": {"inputs": {"uv": "vec2"}, "nodes": {
    "disc": {"block": "circle", "in": {"uv": "uv", "radius": 0.4, "softness": 0.08}},
    "lime": {"block": "rgba", "in": {"color": [0.62, 0.58, 0.52], "alpha": "disc"}}},
    "outputs": {"color": "lime"}})";
const char* const kShade = R"(
    "shade": {"block": "tile_random_color", "in": {"tile": "grid", "low": [0.29, 0.1, 0.06], "high": [0.47, 0.14, 0.075]}},)";
const char* const kHsv = R"(
    "shade": {"block": "tile_random_hsv", "in": {"tile": "grid", "color": [0.36, 0.13, 0.075], "hue": [-12, 12], "saturation": [0.8, 1.2], "value": [0.7, 1.3]}},)";
const char* const kBrick = R"(
    "brick": {"block": "layer", "in": {"tile": "grid", "image": "face", "rotation": [-0.5, 0.5], "scale": [0.94, 0.97], "tint": "shade"}},)";

std::vector<Wall> Walls() {
  const std::string mortar = R"(
    "joint": {"block": "mortar", "in": {"tile": "grid", "width": 0.012}},)";
  return {
      {"mortar",
       Graph(
           "",
           mortar +
               R"("even": {"block": "lerp", "in": {"a": [0.36, 0.13, 0.075], "b": [0.4, 0.4, 0.38], "amount": "joint"}}, "wall": {"block": "rgba", "in": {"color": "even"}})")},
      {"shades",
       Graph(
           "",
           std::string(kShade) + mortar +
               R"("even": {"block": "lerp", "in": {"a": "shade", "b": [0.4, 0.4, 0.38], "amount": "joint"}}, "wall": {"block": "rgba", "in": {"color": "even"}})")},
      {"hsv",
       Graph(
           "",
           std::string(kHsv) + mortar +
               R"("even": {"block": "lerp", "in": {"a": "shade", "b": [0.4, 0.4, 0.38], "amount": "joint"}}, "wall": {"block": "rgba", "in": {"color": "even"}})")},
      {"layer",
       Graph(
           kFace,
           std::string(kShade) + kBrick +
               R"("wall": {"block": "over", "in": {"foreground": "brick.color", "background": [0.4, 0.4, 0.38, 1]}})")},
      {"child", Graph(std::string(kFace) + kSplash, std::string(kShade) + kBrick + R"(
        "lime": {"block": "layer", "in": {"tile": "brick.inner", "image": "splash", "fit": "contain", "position_min": [0.4, 0.4], "position_max": [0.6, 0.6],
          "scale": [0.3, 0.5], "rotation": [0, 360], "opacity": [0.2, 0.8], "chance": 0.5, "stream": 1}},
        "bricks": {"block": "over", "in": {"foreground": "brick.color", "background": [0.4, 0.4, 0.38, 1]}},
        "wall": {"block": "over", "in": {"foreground": "lime.color", "background": "bricks"}})")},
      {"discs", Graph(std::string(kFace) + kSplash, R"(
        "lime": {"block": "layer", "in": {"tile": "grid", "image": "splash", "fit": "contain", "position_min": [0.3, 0.4], "position_max": [0.7, 0.6],
          "scale": [0.5, 0.8]}},
        "wall": {"block": "over", "in": {"foreground": "lime.color", "background": [0.2, 0.2, 0.2, 1]}})")},
      {"overlap", Graph(std::string(kFace) + kSplash, R"(
        "lime": {"block": "layer", "in": {"tile": "grid", "image": "splash", "fit": "contain", "position_min": [0.3, 0.2], "position_max": [0.7, 0.8],
          "scale": [0.6, 0.9]}},
        "wall": {"block": "over", "in": {"foreground": "lime.color", "background": [0.2, 0.2, 0.2, 1]}})")},
      {"bright",
       Graph(
           "",
           R"("light": {"block": "tile_random", "in": {"tile": "grid", "low": 0.6, "high": 1.3, "filtered": true}},
        "shade": {"block": "multiply", "in": {"a": [0.36, 0.13, 0.075], "b": "light"}},)" +
               mortar +
               R"("even": {"block": "lerp", "in": {"a": "shade", "b": [0.4, 0.4, 0.38], "amount": "joint"}}, "wall": {"block": "rgba", "in": {"color": "even"}})")},
  };
}

class FilteredTest : public testing::TestWithParam<Wall> {};

TEST_P(FilteredTest, IsTheMeanOfWhatIsThere) {
  for (double tiles : {1.0, 2.0, 4.0, 16.0, 64.0, 4096.0}) {
    const double error = MeanError(GetParam().graph, std::sqrt(tiles / (kColumns * kRows)));
    EXPECT_LE(error, 0.02) << tiles << " tiles a pixel";
    RecordProperty(std::to_string(static_cast<int>(tiles)), std::to_string(error));
  }
}

INSTANTIATE_TEST_SUITE_P(Walls, FilteredTest, testing::ValuesIn(Walls()),
                         [](const auto& wall) { return std::string(wall.param.name); });

}  // namespace
}  // namespace texgraph::blocks
