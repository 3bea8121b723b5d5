// SPDX-License-Identifier: Apache-2.0
// Walls of bricks with layers on them, whose graphs are made here: the chart of the brick shader
// generator, section 3.3.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <tuple>
#include <vector>

#include "compiler/base/files.h"
#include "compiler/textures/image.h"
#include "tests/bench/measure.h"
#include "tests/bench/measure_shader.h"

namespace texgraph::bench {
namespace {

constexpr int kSides[] = {256, 512, 1024, 2048};
constexpr int kMost = 4;  // textures, and layers
constexpr int kQuietRounds = 2;

// A disc with a soft edge, its colour different in every texel; of the first picture the whole
// square is opaque.
textures::Image Picture(int number, int side) {
  textures::Image image;
  image.width = image.height = static_cast<uint32_t>(side);
  image.channels = 4;
  image.pixels.resize(size_t{4} * image.width * image.height);
  uint32_t state = static_cast<uint32_t>(number) * 77777 + 1;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      state = state * 747796405u + 2891336453u;
      uint8_t* pixel = &image.pixels[size_t{4} * (size_t(y) * size_t(side) + size_t(x))];
      for (int c = 0; c < 3; ++c) {
        pixel[c] = static_cast<uint8_t>(((c + number) % 3 * 60 + 40) + (state >> (8 * c) & 63));
      }
      double radius = std::hypot((x + 0.5) / side - 0.5, (y + 0.5) / side - 0.5);
      double alpha = number == 0 ? 1 : std::clamp((0.45 - radius) * 12, 0.0, 1.0);
      pixel[3] = static_cast<uint8_t>(std::lround(255 * alpha));
    }
  }
  return image;
}

// The first layer is the brick; the others are its children. All stay inside their cells.
std::string Wall(int textures, int layers) {
  std::string pictures, nodes, last = "bricks";
  for (int i = 0; i < textures; ++i) {
    pictures += fmt::format("{}\n    \"picture{}\": {{ \"file\": \"picture{}.png\" }}",
                            i > 0 ? "," : "", i, i);
  }
  for (int i = 1; i < layers; ++i) {
    nodes += fmt::format(
        ",\n    \"patch{0}\": {{ \"block\": \"layer\", \"in\": {{ \"tile\": \"brick.inner\", "
        "\"image\": \"picture{1}\",\n      \"position_min\": 0.35, \"position_max\": 0.65, "
        "\"scale\": [0.3, 0.4], \"rotation\": [-20, 20],\n      \"opacity\": [0.6, 1], "
        "\"stream\": {0} }} }},\n"
        "    \"wall{0}\": {{ \"block\": \"over\", \"in\": {{ \"foreground\": \"patch{0}.color\", "
        "\"background\": \"{2}\" }} }}",
        i, i % textures, last);
    last = fmt::format("wall{}", i);
  }
  return fmt::format(R"({{
  "texgraph": 1,
  "textures": {{{}
  }},
  "nodes": {{
    "grid": {{ "block": "brick_grid", "in": {{ "rows": 8, "columns": 4 }} }},
    "brick": {{ "block": "layer", "in": {{ "tile": "grid", "image": "picture0",
      "position_min": 0.49, "position_max": 0.51, "scale": [0.88, 0.94], "rotation": [-1, 1] }} }},
    "bricks": {{ "block": "over", "in": {{ "foreground": "brick.color", "background": [0.4, 0.4, 0.38, 1] }} }}{}
  }},
  "outputs": {{ "color": "{}" }}
}}
)",
                     pictures, nodes, last);
}

constexpr const char* kPlain = R"(#version 450 core
layout(location = 0) in vec2 uv;
layout(binding = 0) uniform sampler2D picture0;
layout(location = 0) out vec4 out_color;
void main() { out_color = texture(picture0, uv * vec2(4.0, 8.0)); }
)";

}  // namespace

std::vector<ChartEntry> MeasureChart(const std::string& root, const std::string& folder) {
  Diagnostics diagnostics;
  auto reference = ReadFile(root + "/tests/bench/reference/chart.frag", 1 << 20, {}, diagnostics);
  std::vector<ChartEntry> entries;
  for (int side : kSides) {
    for (int i = 0; i < kMost; ++i) {
      std::ofstream file(fmt::format("{}/picture{}.png", folder, i), std::ios::binary);
      file << textures::EncodePng(Picture(i, side)).value_or("");
    }
    for (int textures = 1; textures <= kMost; ++textures) {
      for (int layers = textures; layers <= kMost; ++layers) {
        // Layers share one texture, or each has its own.
        if (textures != 1 && textures != layers) continue;
        std::string theirs = reference.value_or("");
        theirs.insert(theirs.find('\n') + 1,
                      fmt::format("#define LAYERS {}\n#define TEXTURES {}\n", layers, textures));
        const std::string others[] = {theirs, kPlain};
        entries.push_back(
            {textures, layers, side,
             CompareShaders(folder + "/chart.json", Wall(textures, layers), others, kQuietRounds)});
      }
    }
  }
  auto order = [](const ChartEntry& e) { return std::tuple(e.textures, e.layers, e.side); };
  std::ranges::sort(entries, {}, order);
  return entries;
}

}  // namespace texgraph::bench
