// SPDX-License-Identifier: Apache-2.0
// Textures of pictures: their files, masks and keys, and how patterns are packed together.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/graph/graph_reader.h"

namespace texgraph::graph {
namespace {

constexpr int kMaxKeyEdge = 64;  // in texels

bool HasControlCharacter(std::string_view text) {
  return std::ranges::any_of(text,
                             [](char c) { return static_cast<uint8_t>(c) < 0x20 || c == 0x7f; });
}

}  // namespace

void GraphReader::ReadLayers(const DocumentNode& layers, Owner owner, Texture& texture) {
  if (!Is(&layers, DocumentKind::kArray, owner)) return;
  if (layers.child_count == 0) {
    BadValue(layers, fmt::format("'{}' names at least one file", layers.key));
  }
  for (const DocumentNode& child : document_.children(layers)) ReadFile(child, owner, texture);
}

void GraphReader::ReadPatterns(const DocumentNode& node, const TextureKeys& keys, Owner owner,
                               Texture& texture) {
  auto at = [&](TextureKey key) { return keys[static_cast<size_t>(key)]; };
  ReadWord<TexturePack>(at(TextureKey::kPack), owner,
                        {{"array", TexturePack::kArray},
                         {"atlas", TexturePack::kAtlas},
                         {"volume", TexturePack::kVolume}},
                        texture.pack);
  texture.is_array = texture.pack == TexturePack::kArray;
  texture.is_3d = texture.pack == TexturePack::kVolume;
  ReadGrid(node, keys, owner, texture);
  if (texture.is_array) return;
  for (const DocumentNode* key : {at(TextureKey::kEdges), at(TextureKey::kWeights)}) {
    if (!key) continue;
    diagnostics_
        .Error(DiagnosticKind::kGraphShape, key->key_range,
               fmt::format("'{}' of {} needs patterns that are packed as an array", key->key,
                           owner.Text()))
        .AddNote(at(TextureKey::kPack)->range, "the pack is given here");
  }
}

// Of a sheet, and of layers that become an atlas.
void GraphReader::ReadGrid(const DocumentNode& node, const TextureKeys& keys, Owner owner,
                           Texture& texture) {
  const DocumentNode* grid = keys[static_cast<size_t>(TextureKey::kGrid)];
  const bool is_sheet = texture.kind == TextureKind::kSheet;
  if (!is_sheet && texture.pack != TexturePack::kAtlas) {
    if (!grid) return;
    diagnostics_.Error(
        DiagnosticKind::kGraphShape, grid->key_range,
        fmt::format("{} takes a 'grid' only with \"pack\": \"atlas\"", owner.Text()));
    return;
  }
  if (!grid) return ReportMissing(node, owner, "grid");
  texture.grid_range = grid->range;
  if (!ReadSides(grid, owner, kMaxGridSide, texture.grid) || is_sheet) return;
  const size_t count = texture.files.size();
  const size_t columns = texture.grid[0];
  const size_t rows = (count + columns - 1) / columns;
  if (rows == texture.grid[1] || count == 0) return;
  BadValue(*grid, fmt::format("{} layers in {} columns take {} rows, but the grid has {}", count,
                              columns, rows, texture.grid[1]));
}

void GraphReader::ReadFile(const DocumentNode& node, Owner owner, Texture& texture) {
  std::string_view path;
  if (!ReadPath(&node, owner, path)) return;
  texture.files.push_back(path);
  texture.file_ranges.push_back(node.range);
}

bool GraphReader::ReadPath(const DocumentNode* node, Owner owner, std::string_view& path) {
  if (!ReadText(node, owner, path)) return false;
  if (path.empty()) {
    BadValue(*node, "the file's name is empty");
  } else if (HasControlCharacter(path)) {
    BadValue(*node, "the file's name has control characters");
  } else {
    return true;
  }
  return false;
}

// A mask for all layers, or a list of one for each.
void GraphReader::ReadMasks(const DocumentNode& node, Owner owner, Texture& texture) {
  if (node.kind != DocumentKind::kArray) return ReadMask(node, owner, texture);
  if (texture.kind != TextureKind::kLayers) {
    return BadValue(node,
                    "a list of masks belongs to 'layers'; a texture of one file has one mask");
  }
  if (node.child_count != texture.files.size()) {
    return BadValue(node, fmt::format("there are {} masks for {} layers; give one for each, or one "
                                      "without a list for all of them",
                                      node.child_count, texture.files.size()));
  }
  for (const DocumentNode& child : document_.children(node)) ReadMask(child, owner, texture);
}

void GraphReader::ReadMask(const DocumentNode& node, Owner owner, Texture& texture) {
  Mask mask;
  mask.range = node.range;
  const DocumentNode* file = &node;
  if (node.kind == DocumentKind::kObject) {
    constexpr std::array<std::string_view, 3> kKeys = {"file", "channel", "invert"};
    Owner part{"the mask of texture", owner.name};
    auto [path, channel, invert] = Keys(node, part, kKeys);
    if (!path) return ReportMissing(node, part, "file");
    ReadWord<MaskChannel>(channel, part,
                          {{"red", MaskChannel::kRed},
                           {"green", MaskChannel::kGreen},
                           {"blue", MaskChannel::kBlue},
                           {"alpha", MaskChannel::kAlpha}},
                          mask.channel);
    ReadBool(invert, part, mask.invert);
    mask.range = path->range;
    file = path;
  }
  if (ReadPath(file, owner, mask.file)) texture.masks.push_back(mask);
}

void GraphReader::ReadKey(const DocumentNode& node, Owner owner, Texture& texture) {
  ColorKey& key = texture.key.emplace();
  if (!Is(&node, DocumentKind::kObject, owner)) return;
  constexpr std::array<std::string_view, 3> kKeys = {"color", "tolerance", "edge"};
  Owner part{"the key of texture", owner.name};
  auto [color, tolerance, edge] = Keys(node, part, kKeys);
  if (Is(color, DocumentKind::kArray, part)) {
    size_t count = 0;
    for (const DocumentNode& child : document_.children(*color)) {
      const bool good =
          child.kind == DocumentKind::kNumber && child.number >= 0 && child.number <= 1;
      if (good && count < key.color.size()) key.color[count] = child.number;
      count += good ? 1 : key.color.size() + 1;
    }
    if (count != key.color.size()) {
      BadValue(*color, "a key's 'color' is red, green and blue, each from 0 to 1");
    }
  }
  if (Is(tolerance, DocumentKind::kNumber, part)) {
    key.tolerance = tolerance->number;
    if (!(key.tolerance >= 0 && key.tolerance < 1)) {
      BadValue(*tolerance, "'tolerance' is a number from 0 up to, but not, 1");
    }
  }
  if (Is(edge, DocumentKind::kNumber, part)) {
    if (!edge->is_integer || edge->integer < 0 || edge->integer > kMaxKeyEdge) {
      BadValue(*edge, fmt::format("'edge' is a whole number of texels from 0 to {}", kMaxKeyEdge));
    } else {
      key.edge = static_cast<int>(edge->integer);
    }
  }
}

}  // namespace texgraph::graph
