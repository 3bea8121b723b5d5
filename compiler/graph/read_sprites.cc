// SPDX-License-Identifier: Apache-2.0
// Texture sprites: patterns at places of their own. Each cell of their map lists those that it
// sees.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "compiler/graph/graph_reader.h"

namespace texgraph::graph {

void GraphReader::ReadSprites(const DocumentNode& node, const TextureKeys& keys, Owner owner,
                              Texture& texture) {
  const DocumentNode& list = *keys[static_cast<size_t>(TextureKey::kSprites)];
  const DocumentNode* cells = keys[static_cast<size_t>(TextureKey::kCells)];
  const DocumentNode* layers = keys[static_cast<size_t>(TextureKey::kLayers)];
  texture.is_array = true;
  std::optional<uint32_t> limit;
  if (Is(layers, DocumentKind::kNumber, owner)) {
    if (!layers->is_integer || layers->integer < 1 || layers->integer > kMaxSpriteLayers) {
      return BadValue(*layers, fmt::format("'layers' of sprites is a whole number from 1 to {}",
                                           kMaxSpriteLayers));
    }
    limit = static_cast<uint32_t>(layers->integer);
  }
  if (!cells) return ReportMissing(node, owner, "cells");
  std::array<uint32_t, 2> sides;
  if (!ReadSides(cells, owner, kMaxMapSide, sides)) return;
  SpriteMap& map = texture.sprites;
  map.columns = sides[0];
  map.rows = sides[1];
  if (!Is(&list, DocumentKind::kArray, owner)) return;
  const size_t before = diagnostics_.error_count();
  for (const DocumentNode& child : document_.children(list)) {
    Sprite sprite;
    if (!ReadSprite(child, owner, map, sprite)) continue;
    map.sprites.push_back(sprite);
    map.ranges.push_back(child.range);
  }
  if (diagnostics_.error_count() == before) CountLayers(limit, cells->range, map);
}

bool GraphReader::ReadSprite(const DocumentNode& node, Owner owner, const SpriteMap& map,
                             Sprite& sprite) {
  if (!Is(&node, DocumentKind::kObject, owner)) return false;
  constexpr std::array<std::string_view, 2> kKeys = {"pattern", "at"};
  const Owner part{"a sprite of texture", owner.name};
  auto [pattern, at] = Keys(node, part, kKeys);
  for (auto [key, name] : {std::pair(pattern, "pattern"), {at, "at"}}) {
    if (!key) ReportMissing(node, part, name);
  }
  if (!Is(pattern, DocumentKind::kNumber, part) || !Is(at, DocumentKind::kArray, part)) {
    return false;
  }
  if (!pattern->is_integer || pattern->integer < 0 || pattern->integer > kMaxMapNumber) {
    BadValue(*pattern, "a sprite's 'pattern' is a whole number from 0 on");
    return false;
  }
  sprite.pattern = static_cast<int32_t>(pattern->integer);
  size_t count = 0;
  for (const DocumentNode& child : document_.children(*at)) {
    const bool good = child.kind == DocumentKind::kNumber;
    if (good && count < 2) sprite.at[count] = child.number;
    count += good ? 1 : 3;
  }
  if (count != 2) {
    BadValue(*at, "a sprite's 'at' is two numbers: its left lower corner, in cells");
    return false;
  }
  const bool inside = sprite.at[0] > -1 && sprite.at[0] < map.columns && sprite.at[1] > -1 &&
                      sprite.at[1] < map.rows;
  if (inside) return true;
  diagnostics_.Error(
      DiagnosticKind::kValueRange, at->range,
      fmt::format("this sprite is outside of its map, which has {} x {} cells and does not repeat "
                  "sprites",
                  map.columns, map.rows));
  return false;
}

// How many sprites the fullest cell has. `limit`: the layers that the graph asks for.
void GraphReader::CountLayers(std::optional<uint32_t> limit, SourceRange cells, SpriteMap& map) {
  const uint64_t area = uint64_t{map.columns} * map.rows;
  const auto fits = [&](uint64_t layers) {
    if (area * layers <= kMaxSpriteTexels) return true;
    diagnostics_.Error(DiagnosticKind::kSizeLimit, cells,
                       fmt::format("these sprites take {} x {} cells in {} layers; the limit is {} "
                                   "cells in all",
                                   map.columns, map.rows, layers, kMaxSpriteTexels));
    return false;
  };
  if (!fits(limit.value_or(1))) return;
  const uint32_t most = limit.value_or(kMaxSpriteLayers);
  std::vector<uint32_t> counts(area);
  map.layers = limit.value_or(1);
  for (size_t s = 0; s < map.sprites.size(); ++s) {
    // Of a square from 2 to 3 only cell 2 is touched.
    const auto first = [](double at) {
      return static_cast<uint32_t>(std::max(0.0, std::floor(at)));
    };
    const auto end = [](double at, uint32_t cells) {
      return std::min(cells, static_cast<uint32_t>(std::ceil(at + 1)));
    };
    const Sprite& sprite = map.sprites[s];
    for (uint32_t y = first(sprite.at[1]); y < end(sprite.at[1], map.rows); ++y) {
      for (uint32_t x = first(sprite.at[0]); x < end(sprite.at[0], map.columns); ++x) {
        const uint32_t count = ++counts[size_t{y} * map.columns + x];
        map.layers = std::max(map.layers, count);
        if (count <= most) continue;
        diagnostics_.Error(limit ? DiagnosticKind::kValueRange : DiagnosticKind::kSizeLimit,
                           map.ranges[s],
                           fmt::format("with this sprite, cell ({}, {}) has {} of them; {} {}", x,
                                       y, count, limit ? "'layers' allows" : "the limit is", most));
        return;
      }
    }
  }
  (void)fits(map.layers);
}

}  // namespace texgraph::graph
