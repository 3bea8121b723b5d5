// SPDX-License-Identifier: Apache-2.0
// Sets of tiles and cubes that are made of a sample, and maps of their places.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/graph/graph_reader.h"

namespace texgraph::graph {

void GraphReader::ReadWhole(const DocumentNode* node, Owner owner, uint32_t least,
                            uint32_t greatest, uint32_t& out) {
  if (!Is(node, DocumentKind::kNumber, owner)) return;
  if (!node->is_integer || node->integer < least || node->integer > greatest) {
    return BadValue(
        *node, fmt::format("'{}' is a whole number from {} to {}", node->key, least, greatest));
  }
  out = static_cast<uint32_t>(node->integer);
}

void GraphReader::ReadTiles(const TextureKeys& keys, Owner owner, Texture& texture) {
  const auto at = [&](TextureKey key) { return keys[static_cast<size_t>(key)]; };
  ReadFile(*at(TextureKey::kTiles), owner, texture);
  TileSetting& tiles = texture.tiles;
  ReadWord<bool>(at(TextureKey::kWrap), owner, {{"repeat", true}, {"clamp", false}}, tiles.wraps);
  if (const DocumentNode* weight = at(TextureKey::kWeight)) {
    const double value = ReadWeight(*weight);
    if (value >= 0) tiles.weight = value;
  }
  if (const DocumentNode* like = at(TextureKey::kLike)) {
    for (TextureKey key :
         {TextureKey::kCornerColors, TextureKey::kEdgeColors, TextureKey::kTileSize,
          TextureKey::kPack, TextureKey::kSeed, TextureKey::kCandidates, TextureKey::kOwnMiddles,
          TextureKey::kEven, TextureKey::kWrap}) {
      if (!at(key)) continue;
      diagnostics_
          .Error(DiagnosticKind::kGraphShape, at(key)->key_range,
                 fmt::format("{} is cut like another and has no '{}' of its own", owner.Text(),
                             at(key)->key))
          .AddNote(like->range, "that is said here");
    }
    return;
  }
  ReadTileColors(keys, owner, texture);
  ReadWord<TexturePack>(at(TextureKey::kPack), owner,
                        {{"array", TexturePack::kArray}, {"atlas", TexturePack::kAtlas}},
                        texture.pack);
  texture.is_array = texture.pack == TexturePack::kArray;
  // The pack repeats, but where it has gutters.
  const bool has_gutters = !texture.is_array && !tiles.has_edge_colors && tiles.colors[0] == 4;
  texture.wrap_v = has_gutters ? TextureWrap::kClamp : TextureWrap::kRepeat;
  ReadWhole(at(TextureKey::kTileSize), owner, kMinTileSize, kMaxTileSize, tiles.size);
  ReadWhole(at(TextureKey::kSeed), owner, 0, kMaxMapNumber, tiles.seed);
  ReadWhole(at(TextureKey::kCandidates), owner, kMinTileCandidates, kMaxTileCandidates,
            tiles.candidates);
  ReadBool(at(TextureKey::kOwnMiddles), owner, tiles.own_middles);
  ReadBool(at(TextureKey::kEven), owner, tiles.even);
}

void GraphReader::ReadTileColors(const TextureKeys& keys, Owner owner, Texture& texture) {
  const DocumentNode* corners = keys[static_cast<size_t>(TextureKey::kCornerColors)];
  const DocumentNode* edges = keys[static_cast<size_t>(TextureKey::kEdgeColors)];
  TileSetting& tiles = texture.tiles;
  if (corners && edges) {
    diagnostics_
        .Error(DiagnosticKind::kGraphShape, edges->key_range,
               fmt::format("{} has 'corner_colors' and 'edge_colors'; it takes one of them",
                           owner.Text()))
        .AddNote(corners->key_range, "'corner_colors' is here");
    return;
  }
  if (corners) {
    ReadWhole(corners, owner, 2, kMaxTileColors, tiles.colors[0]);
    tiles.colors[1] = tiles.colors[0];
  }
  if (!edges) return;
  tiles.has_edge_colors = true;
  if (!Is(edges, DocumentKind::kArray, owner)) return;
  size_t count = 0;
  for (const DocumentNode& child : document_.children(*edges)) {
    const bool good = child.kind == DocumentKind::kNumber && child.is_integer &&
                      child.integer >= 1 && child.integer <= kMaxTileColors;
    if (good && count < 2) tiles.colors[count] = static_cast<uint32_t>(child.integer);
    count += good ? 1 : 3;
  }
  if (count == 2) return;
  tiles.colors = {2, 2};
  BadValue(*edges,
           fmt::format("'edge_colors' is two whole numbers from 1 to {}: of edges that lie, "
                       "and of edges that stand",
                       kMaxTileColors));
}

// The sample is a list of slices, or a picture of them in a grid.
void GraphReader::ReadCubes(const DocumentNode& node, const TextureKeys& keys, Owner owner,
                            Texture& texture) {
  const auto at = [&](TextureKey key) { return keys[static_cast<size_t>(key)]; };
  const DocumentNode& slices = *at(TextureKey::kCubes);
  const DocumentNode* grid = at(TextureKey::kGrid);
  texture.is_3d = true;
  if (slices.kind == DocumentKind::kArray) {
    ReadLayers(slices, owner, texture);
    if (grid) {
      diagnostics_
          .Error(DiagnosticKind::kGraphShape, grid->key_range,
                 fmt::format("{} has a list of slices; a 'grid' is for slices in one picture",
                             owner.Text()))
          .AddNote(slices.range, "the list is here");
    }
  } else {
    ReadFile(slices, owner, texture);
    if (!grid) return ReportMissing(node, owner, "grid");
    texture.grid_range = grid->range;
    ReadSides(grid, owner, kMaxGridSide, texture.grid);
  }
  TileSetting& cubes = texture.tiles;
  cubes.size = kCubeSize;
  cubes.candidates = kCubeCandidates;
  ReadWord<bool>(at(TextureKey::kWrap), owner, {{"repeat", true}, {"clamp", false}}, cubes.wraps);
  ReadWhole(at(TextureKey::kCornerColors), owner, 2, kMaxCubeColors, cubes.colors[0]);
  cubes.colors[1] = cubes.colors[0];
  ReadWhole(at(TextureKey::kCubeSize), owner, kMinCubeSize, kMaxCubeSize, cubes.size);
  ReadWhole(at(TextureKey::kSeed), owner, 0, kMaxMapNumber, cubes.seed);
  ReadWhole(at(TextureKey::kCandidates), owner, kMinTileCandidates, kMaxCubeCandidates,
            cubes.candidates);
}

void GraphReader::ReadTiling(const DocumentNode& node, const TextureKeys& keys, Owner owner,
                             Texture& texture) {
  const DocumentNode* cells = keys[static_cast<size_t>(TextureKey::kCells)];
  if (!cells) return ReportMissing(node, owner, "cells");
  std::array<uint32_t, 2> sides{};
  if (ReadSides(cells, owner, kMaxMapSide, sides) &&
      CheckMapSize(sides[0], sides[1], texture, cells->range, diagnostics_)) {
    texture.map.width = sides[0];
    texture.map.height = sides[1];
  }
  ReadWhole(keys[static_cast<size_t>(TextureKey::kSeed)], owner, 0, kMaxMapNumber,
            texture.tiles.seed);
}

void GraphReader::ReadPermutation(const TextureKeys& keys, Owner owner, Texture& texture) {
  texture.map.height = 1;
  ReadWhole(keys[static_cast<size_t>(TextureKey::kPermutation)], owner, kMinPermutation,
            kMaxMapSide, texture.map.width);
  ReadWhole(keys[static_cast<size_t>(TextureKey::kSeed)], owner, 0, kMaxMapNumber,
            texture.tiles.seed);
}

// Tiles that are cut like others, and tilings, name a set that stands for itself.
void GraphReader::ResolveTiles(uint32_t index) {
  Texture& texture = graph_.textures[index];
  const bool is_tiling = texture.kind == TextureKind::kTiling;
  if (!is_tiling && texture.kind != TextureKind::kTiles) return;
  const TextureKey key = is_tiling ? TextureKey::kTiling : TextureKey::kLike;
  const DocumentNode* node = texture_keys_[index][static_cast<size_t>(key)];
  if (!node) return;
  const Owner owner{"texture", texture.name};
  const std::optional<uint32_t> found = FindTexture(*node, owner);
  if (!found) return;
  const Texture& other = graph_.textures[*found];
  const bool is_set = other.kind == TextureKind::kTiles &&
                      !texture_keys_[*found][static_cast<size_t>(TextureKey::kLike)];
  if (!is_set) {
    diagnostics_
        .Error(DiagnosticKind::kBadValue, node->range,
               *found == index
                   ? fmt::format("'{}' of {} names itself", node->key, owner.Text())
                   : fmt::format("'{}' of {} names tiles, but '{}' is {}", node->key, owner.Text(),
                                 other.name,
                                 other.kind == TextureKind::kTiles ? "cut like others itself"
                                                                   : KindText(other.kind)))
        .AddNote(other.range, fmt::format("'{}' is here", other.name));
    return;
  }
  texture.of = found;
  if (is_tiling) return;
  const double weight = texture.tiles.weight;
  texture.tiles = other.tiles;
  texture.tiles.weight = weight;
  texture.pack = other.pack;
  texture.is_array = other.is_array;
  texture.wrap_v = other.wrap_v;
}

// The corners of a pack of Wang tiles, which may be cut like another: read as that one is.
void GraphReader::ResolveCorners(uint32_t index) {
  Texture& texture = graph_.textures[index];
  if (texture.kind != TextureKind::kCorners) return;
  const DocumentNode* node = texture_keys_[index][static_cast<size_t>(TextureKey::kCorners)];
  if (!node) return;
  const Owner owner{"texture", texture.name};
  const std::optional<uint32_t> found = FindTexture(*node, owner);
  if (!found) return;
  const Texture& other = graph_.textures[*found];
  // One that is cut like nothing was reported.
  if (texture_keys_[*found][static_cast<size_t>(TextureKey::kLike)] && !other.of) return;
  if (other.kind != TextureKind::kTiles || !other.tiles.has_edge_colors) {
    diagnostics_
        .Error(DiagnosticKind::kBadValue, node->range,
               fmt::format("'{}' of {} names tiles with 'edge_colors', but '{}' is {}", node->key,
                           owner.Text(), other.name,
                           other.kind == TextureKind::kTiles ? "a set with colours at its corners"
                                                             : KindText(other.kind)))
        .AddNote(other.range, fmt::format("'{}' is here", other.name));
    return;
  }
  texture.of = found;
  texture.tiles = other.tiles;
  texture.color_space = other.color_space;
  texture.alpha_is_opacity = other.alpha_is_opacity;
  texture.filter = other.filter;
}

}  // namespace texgraph::graph
