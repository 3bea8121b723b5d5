// SPDX-License-Identifier: Apache-2.0
// What it costs to show tiles made of a picture, beside one look-up in the same pack.
#include <fmt/format.h>

#include <string>
#include <vector>

#include "tests/bench/measure.h"
#include "tests/bench/measure_shader.h"

namespace texgraph::bench {
namespace {

constexpr int kQuietRounds = 12;
// Of 64 texels, side by side in the picture: one and a half texels a pixel.
constexpr int kTiles = 24;

TilesEntry Measure(const std::string& root, const std::string& name, const std::string& setting,
                   const std::string& block, const std::string& more_textures, int columns,
                   double most_to_plain) {
  TilesEntry entry;
  entry.name = name;
  entry.most_to_plain = most_to_plain;
  const std::string text = fmt::format(
      R"({{"texgraph": 1, "textures": {{"grass": {{"tiles": "grass.png", "tile_size": 64,
            "wrap": "repeat", {}}}{}}},
          "nodes": {{"t": {{"block": {}, "tiling": {}}}}}}},
          "outputs": {{"color": "t.color"}}}})",
      setting, more_textures, block, kTiles);
  const Drawable drawable = Prepare(root + "/graphs/grass_tiles/measured.json", text);
  entry.error = drawable.error;
  if (!entry.error.empty()) return entry;
  entry.samples = drawable.weight.samples;
  entry.computing = drawable.weight.computing;
  std::vector<runtime::RenderRequest> requests = {drawable.request, drawable.request};
  requests[1].shader = fmt::format(R"(#version 450 core
layout(location = 0) in vec2 uv;
layout(binding = 0) uniform sampler2D grass;
layout(location = 0) out vec4 out_color;
void main() {{ out_color = texture(grass, uv * {:f}); }}
)",
                                   static_cast<double>(kTiles) / columns);
  const Drawn drawn = DrawInTurns(requests, kQuietRounds);
  entry.error = drawn.error;
  if (!entry.error.empty()) return entry;
  entry.frame_ms = drawn.frame_ms[0];
  entry.to_plain = drawn.frame_ms[0] / drawn.frame_ms[1];
  return entry;
}

}  // namespace

std::vector<TilesEntry> MeasureTiles(const std::string& root) {
  constexpr double kPromised = 1.45;
  const std::string corners = R"("corner_tiles", "in": {"tiles": "grass")";
  return {
      Measure(root, "corner_tiles, 2 colours", R"("corner_colors": 2)", corners, "", 4, kPromised),
      Measure(root, "corner_tiles, 3 colours", R"("corner_colors": 3)", corners, "", 9, 0),
      Measure(root, "wang_tiles, 2 and 2 colours", R"("edge_colors": [2, 2])",
              R"("wang_tiles", "in": {"tiles": "grass")", "", 4, kPromised),
      Measure(root, "wang_tiles_with_corners", R"("edge_colors": [2, 2])",
              R"("wang_tiles_with_corners", "in": {"tiles": "grass", "corners": "around")",
              R"(, "around": {"corners": "grass"})", 4, 0),
      Measure(root, "permutation_wang_tiles", R"("edge_colors": [2, 2])",
              R"("permutation_wang_tiles", "in": {"tiles": "grass", "table": "hashes")",
              R"(, "hashes": {"permutation": 64})", 4, 0),
      Measure(root, "tile_map", R"("corner_colors": 2)",
              R"("tile_map", "in": {"tiles": "grass", "map": "plan")",
              R"(, "plan": {"tiling": "grass", "cells": [64, 64]})", 4, 0),
  };
}

}  // namespace texgraph::bench
