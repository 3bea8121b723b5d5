// SPDX-License-Identifier: Apache-2.0
// What it costs to show tiles made of a picture, beside one look-up in the same pack.
#include <fmt/format.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/bench/measure.h"
#include "tests/bench/measure_shader.h"

namespace texgraph::bench {
namespace {

constexpr int kQuietRounds = 12;
// Of 64 texels, side by side in the picture: one and a half texels a pixel.
constexpr int kTiles = 24;

constexpr std::string_view kHead = R"(#version 450 core
layout(location = 0) in vec2 uv;
layout(binding = 0) uniform sampler2D grass;
layout(location = 0) out vec4 out_color;
)";

// What an engineer would write who knows the pack of two colours, with the hash of stdlib_blocks.
constexpr std::string_view kCornersByHand = R"(
uint hash(uint value) {
  uint state = value * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
  return (word >> 22u) ^ word;
}
uint corner(ivec2 at) { return hash(uint(at.x) + hash(uint(at.y) + 129708002u)) & 1u; }
const int columns[16] = int[](2, 1, 2, 3, 2, 1, 0, 1, 3, 2, 3, 0, 1, 0, 3, 0);
const int rows[16] = int[](2, 2, 1, 1, 3, 1, 2, 0, 2, 0, 3, 1, 3, 3, 0, 0);
void main() {
  vec2 p = uv * 24.0;
  ivec2 cell = ivec2(floor(p));
  uint index = corner(cell) + 2u * corner(cell + ivec2(1, 0)) + 4u * corner(cell + ivec2(0, 1)) +
               8u * corner(cell + 1);
  vec2 place = vec2(columns[index], rows[index]) + fract(p);
  out_color = textureGrad(grass, place / 4.0, dFdx(p) / 4.0, dFdy(p) / 4.0);
}
)";

// A graph that shows tiles of 64 texels by `block`, cut and packed as `setting` says.
Drawable PrepareTiles(const std::string& root, const std::string& setting, const std::string& block,
                      const std::string& more_textures = {}) {
  return Prepare(
      root + "/graphs/grass_tiles/measured.json",
      fmt::format(
          R"({{"texgraph": 1, "textures": {{"grass": {{"tiles": "grass.png", "tile_size": 64,
            "wrap": "repeat", {}}}{}}},
          "nodes": {{"t": {{"block": {}, "tiling": {}}}}}}},
          "outputs": {{"color": "t.color"}}}})",
          setting, more_textures, block, kTiles));
}

TilesEntry Measure(const std::string& name, const Drawable& tiles, const Drawable& atlas,
                   int columns, double most_to_plain, std::string_view by_hand = {}) {
  TilesEntry entry;
  entry.name = name;
  entry.most_to_plain = most_to_plain;
  entry.error = tiles.error + atlas.error;
  if (!entry.error.empty()) return entry;
  entry.samples = tiles.weight.samples;
  entry.computing = tiles.weight.computing;
  const double repeats = static_cast<double>(kTiles) / columns;
  std::vector<std::string> others = {
      fmt::format("void main() {{ out_color = texture(grass, uv * {:f}); }}\n", repeats),
      fmt::format("void main() {{ vec2 at = uv * {:f}; "
                  "out_color = textureGrad(grass, at, dFdx(at), dFdy(at)); }}\n",
                  repeats)};
  if (!by_hand.empty()) others.emplace_back(by_hand);
  std::vector<runtime::RenderRequest> requests = {tiles.request};
  for (const std::string& other : others) {
    requests.push_back(atlas.request);
    requests.back().shader = std::string(kHead) + other;
  }
  const Drawn drawn = DrawInTurns(requests, kQuietRounds);
  entry.error = drawn.error;
  if (!entry.error.empty()) return entry;
  entry.frame_ms = drawn.frame_ms[0];
  entry.to_plain = drawn.frame_ms[0] / drawn.frame_ms[1];
  entry.to_gradients = drawn.frame_ms[0] / drawn.frame_ms[2];
  if (by_hand.empty()) return entry;
  entry.to_by_hand = drawn.frame_ms[0] / drawn.frame_ms[3];
  const double difference = MeanDifference(drawn.pictures[0], drawn.pictures[3]);
  if (difference > 0.2) entry.error = fmt::format("by hand another picture: {:.3f}", difference);
  return entry;
}

}  // namespace

std::vector<TilesEntry> MeasureTiles(const std::string& root) {
  constexpr double kPromised = 1.45;
  const std::string corners = R"("corner_tiles", "in": {"tiles": "grass")";
  const std::string edges = R"("wang_tiles", "in": {"tiles": "grass")";
  const std::string two = R"("corner_colors": 2)", three = R"("corner_colors": 3)";
  const std::string two_each = R"("edge_colors": [2, 2])", in_atlas = R"(, "pack": "atlas")";
  const Drawable of_two = PrepareTiles(root, two + in_atlas, corners);
  const Drawable of_three = PrepareTiles(root, three + in_atlas, corners);
  const Drawable of_edges = PrepareTiles(root, two_each + in_atlas, edges);
  const Drawable mapped =
      PrepareTiles(root, two + in_atlas, R"("tile_map", "in": {"tiles": "grass", "map": "plan")",
                   R"(, "plan": {"tiling": "grass", "cells": [64, 64]})");
  const Drawable mended =
      PrepareTiles(root, two_each + in_atlas,
                   R"("wang_tiles_with_corners", "in": {"tiles": "grass", "corners": "around")",
                   R"(, "around": {"corners": "grass"})");
  const Drawable permuted =
      PrepareTiles(root, two_each + in_atlas,
                   R"("permutation_wang_tiles", "in": {"tiles": "grass", "table": "hashes")",
                   R"(, "hashes": {"permutation": 64})");
  return {
      Measure("corner_tiles, 2 colours", PrepareTiles(root, two, corners), of_two, 4, kPromised,
              kCornersByHand),
      Measure("the same in an atlas", of_two, of_two, 4, 0, kCornersByHand),
      Measure("corner_tiles, 3 colours", PrepareTiles(root, three, corners), of_three, 9, 0),
      Measure("the same in an atlas", of_three, of_three, 9, 0),
      Measure("wang_tiles, 2 and 2 colours", PrepareTiles(root, two_each, edges), of_edges, 4,
              kPromised),
      Measure("the same in an atlas", of_edges, of_edges, 4, 0),
      Measure("wang_tiles_with_corners", mended, of_edges, 4, 0),
      Measure("permutation_wang_tiles", permuted, of_edges, 4, 0),
      Measure("tile_map", mapped, of_two, 4, 0),
  };
}

}  // namespace texgraph::bench
