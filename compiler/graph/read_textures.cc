// SPDX-License-Identifier: Apache-2.0
// The section "textures": which keys a texture has, and how it is sampled.
#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/text.h"
#include "compiler/graph/graph_reader.h"
#include "compiler/graph/names.h"

namespace texgraph::graph {
namespace {

constexpr int kCoarsestLevel = 30;  // of a mip chain; no texture has more

using Key = TextureKey;

constexpr size_t kKindCount = 16;  // the first keys are those of the kinds, in TextureKind's order

constexpr std::array<std::string_view, kTextureKeyCount> kTextureKeys = {
    "file",        "layers",    "sheet",      "map",       "lists",       "sprites",
    "means",       "tiles",     "tiling",     "corners",   "permutation", "noise",
    "gaussian",    "table",     "color_map",  "cubes",     "mask",        "key",
    "color_space", "alpha",     "filter",     "wrap",      "wrap_u",      "wrap_v",
    "mipmaps",     "max_level", "grid",       "pack",      "edges",       "weights",
    "legend",      "of",        "binding",    "cells",     "dithered",    "corner_colors",
    "edge_colors", "tile_size", "like",       "seed",      "candidates",  "weight",
    "size",        "second",    "deviations", "cube_size", "own_middles", "even"};

constexpr uint64_t Bit(TextureKey key) { return uint64_t{1} << static_cast<uint32_t>(key); }

constexpr uint64_t kSamplingKeys = Bit(Key::kMask) | Bit(Key::kKey) | Bit(Key::kColorSpace) |
                                   Bit(Key::kAlpha) | Bit(Key::kFilter) | Bit(Key::kWrap) |
                                   Bit(Key::kWrapU) | Bit(Key::kWrapV) | Bit(Key::kMipmaps) |
                                   Bit(Key::kMaxLevel);
constexpr uint64_t kPatternKeys =
    kSamplingKeys | Bit(Key::kGrid) | Bit(Key::kPack) | Bit(Key::kEdges) | Bit(Key::kWeights);

// What a texture of each kind may have.
constexpr std::array<uint64_t, kKindCount> kKeysOfKind = {
    Bit(Key::kFile) | kSamplingKeys,
    Bit(Key::kLayers) | kPatternKeys,
    Bit(Key::kSheet) | kPatternKeys,
    Bit(Key::kMap) | Bit(Key::kLegend) | Bit(Key::kOf) | Bit(Key::kBinding),
    Bit(Key::kLists) | Bit(Key::kOf) | Bit(Key::kBinding),
    Bit(Key::kSprites) | Bit(Key::kCells) | Bit(Key::kLayers) | Bit(Key::kOf),
    Bit(Key::kMeans) | Bit(Key::kDithered),
    Bit(Key::kTiles) | Bit(Key::kColorSpace) | Bit(Key::kAlpha) | Bit(Key::kFilter) |
        Bit(Key::kWrap) | Bit(Key::kPack) | Bit(Key::kCornerColors) | Bit(Key::kEdgeColors) |
        Bit(Key::kTileSize) | Bit(Key::kLike) | Bit(Key::kSeed) | Bit(Key::kCandidates) |
        Bit(Key::kWeight) | Bit(Key::kOwnMiddles) | Bit(Key::kEven),
    Bit(Key::kTiling) | Bit(Key::kCells) | Bit(Key::kSeed),
    Bit(Key::kCorners),
    Bit(Key::kPermutation) | Bit(Key::kSeed),
    Bit(Key::kNoise) | Bit(Key::kSecond) | Bit(Key::kSize) | Bit(Key::kSeed),
    Bit(Key::kGaussian) | Bit(Key::kColorSpace),
    Bit(Key::kTable),
    Bit(Key::kColorMap) | Bit(Key::kColorSpace) | Bit(Key::kAlpha) | Bit(Key::kDeviations),
    Bit(Key::kCubes) | Bit(Key::kGrid) | Bit(Key::kColorSpace) | Bit(Key::kAlpha) |
        Bit(Key::kFilter) | Bit(Key::kWrap) | Bit(Key::kCornerColors) | Bit(Key::kCubeSize) |
        Bit(Key::kSeed) | Bit(Key::kCandidates)};

const DocumentNode* At(const std::array<const DocumentNode*, kTextureKeyCount>& keys,
                       TextureKey key) {
  return keys[static_cast<size_t>(key)];
}

}  // namespace

void GraphReader::ReadTextures(const DocumentNode* section) {
  if (!Is(section, DocumentKind::kObject, {"the graph", ""})) return;
  graph_.textures.reserve(section->child_count);
  texture_keys_.reserve(section->child_count);
  for (const DocumentNode& child : document_.children(*section)) ReadTexture(child);
  ResolveTextures();
}

void GraphReader::ReadTexture(const DocumentNode& node) {
  CheckBoundName(node.key, node.key_range, diagnostics_);
  const Owner owner{"texture", node.key};
  Texture texture;
  texture.name = node.key;
  texture.range = node.key_range;
  TextureKeys keys{};
  if (Is(&node, DocumentKind::kObject, owner)) {
    keys = Keys(node, owner, kTextureKeys);
    if (ReadTextureKind(node, owner, keys, texture)) {
      CheckTextureKeys(keys, owner, texture);
      if (texture.IsMap()) texture.color_space = ColorSpace::kLinear;
      switch (texture.kind) {
        case TextureKind::kFile:
          ReadFile(*At(keys, Key::kFile), owner, texture);
          break;
        case TextureKind::kLayers:
          ReadLayers(*At(keys, Key::kLayers), owner, texture);
          ReadPatterns(node, keys, owner, texture);
          break;
        case TextureKind::kSheet:
          ReadFile(*At(keys, Key::kSheet), owner, texture);
          ReadPatterns(node, keys, owner, texture);
          break;
        case TextureKind::kMap:
          ReadMap(keys, owner, texture);
          break;
        case TextureKind::kLists:
          ReadLists(keys, owner, texture);
          break;
        case TextureKind::kSprites:
          ReadSprites(node, keys, owner, texture);
          break;
        case TextureKind::kMeans:
          ReadBool(At(keys, Key::kDithered), owner, texture.dithered);
          break;
        case TextureKind::kTiles:
          ReadTiles(keys, owner, texture);
          break;
        case TextureKind::kTiling:
          ReadTiling(node, keys, owner, texture);
          break;
        case TextureKind::kCorners:
          break;
        case TextureKind::kPermutation:
          ReadPermutation(keys, owner, texture);
          break;
        case TextureKind::kNoise:
          ReadNoise(keys, owner, texture);
          break;
        case TextureKind::kGaussian:
          ReadFile(*At(keys, Key::kGaussian), owner, texture);
          break;
        case TextureKind::kTable:
          texture.is_array = true;
          break;
        case TextureKind::kColorMap:
          ReadFile(*At(keys, Key::kColorMap), owner, texture);
          ReadWhole(At(keys, Key::kDeviations), owner, 2, kMaxDeviations, texture.deviations);
          texture.is_array = true;
          break;
        case TextureKind::kCubes:
          ReadCubes(node, keys, owner, texture);
          break;
      }
      ReadSampling(keys, owner, texture);
    }
  }
  graph_.textures.push_back(std::move(texture));
  texture_keys_.push_back(keys);
}

// Exactly one of the keys says what a texture is made of; the "layers" of sprites are a number.
bool GraphReader::ReadTextureKind(const DocumentNode& node, Owner owner, TextureKeys& keys,
                                  Texture& texture) {
  std::optional<size_t> kind;
  const bool has_sprites = At(keys, Key::kSprites) != nullptr;
  for (size_t i = 0; i < kKindCount; ++i) {
    if (!keys[i] || (has_sprites && i == static_cast<size_t>(Key::kLayers))) continue;
    if (kind) {
      diagnostics_
          .Error(DiagnosticKind::kGraphShape, keys[i]->key_range,
                 fmt::format("{} has '{}' and '{}'; it takes one of them", owner.Text(),
                             keys[*kind]->key, keys[i]->key))
          .AddNote(keys[*kind]->key_range, fmt::format("'{}' is here", keys[*kind]->key));
      keys = {};  // nothing is known of the texture
      return false;
    }
    kind = i;
  }
  if (kind) {
    texture.kind = static_cast<TextureKind>(*kind);
    return true;
  }
  diagnostics_.Error(
      DiagnosticKind::kMissingKey, node.key_range,
      fmt::format("{} needs one of the keys {}", owner.Text(),
                  ListedQuoted(std::span(kTextureKeys).first<kKindCount>(), " or ")));
  keys = {};
  return false;
}

// Keys that other kinds of textures have.
void GraphReader::CheckTextureKeys(const TextureKeys& keys, Owner owner, const Texture& texture) {
  const auto kind = static_cast<size_t>(texture.kind);
  for (size_t i = 0; i < kTextureKeyCount; ++i) {
    if (!keys[i] || (kKeysOfKind[kind] >> i & 1)) continue;
    std::vector<std::string_view> others;
    for (size_t k = 0; k < kTextureKeyCount; ++k) {
      if (k != kind && (kKeysOfKind[kind] >> k & 1)) others.push_back(kTextureKeys[k]);
    }
    diagnostics_.Error(DiagnosticKind::kUnknownKey, keys[i]->key_range,
                       fmt::format("{} with '{}' has no key '{}'; it may have {}", owner.Text(),
                                   kTextureKeys[kind], kTextureKeys[i],
                                   others.empty() ? "no other" : ListedQuoted(others, " and ")));
  }
}

void GraphReader::ReadSampling(const TextureKeys& keys, Owner owner, Texture& texture) {
  if (texture.IsMap()) {
    texture.filter = TextureFilter::kNearest;
    texture.mipmaps = false;
    texture.alpha_is_opacity = false;
    return;
  }
  if (texture.kind == TextureKind::kCorners) return;  // as its tiles
  if (texture.kind == TextureKind::kMeans) {
    texture.color_space = ColorSpace::kLinear;
    return;
  }
  if (texture.kind == TextureKind::kNoise || texture.kind == TextureKind::kTable) {
    texture.color_space = ColorSpace::kLinear;
    texture.alpha_is_opacity = false;
  }
  if (texture.kind == TextureKind::kTable || texture.kind == TextureKind::kColorMap) {
    texture.wrap_u = texture.wrap_v = TextureWrap::kClamp;
    texture.mipmaps = false;
  }
  if (texture.kind == TextureKind::kNoise || texture.kind == TextureKind::kTable) return;
  if (At(keys, Key::kMask)) ReadMasks(*At(keys, Key::kMask), owner, texture);
  if (At(keys, Key::kKey)) ReadKey(*At(keys, Key::kKey), owner, texture);
  ReadWord<ColorSpace>(
      At(keys, Key::kColorSpace), owner,
      {{"srgb", ColorSpace::kSrgb}, {"linear", ColorSpace::kLinear}, {"data", ColorSpace::kLinear}},
      texture.color_space);
  texture.alpha_is_opacity =
      !texture.masks.empty() || texture.key.has_value() || texture.color_space == ColorSpace::kSrgb;
  ReadWord<bool>(At(keys, Key::kAlpha), owner, {{"opacity", true}, {"data", false}},
                 texture.alpha_is_opacity);
  ReadWord<TextureFilter>(
      At(keys, Key::kFilter), owner,
      {{"linear", TextureFilter::kLinear}, {"nearest", TextureFilter::kNearest}}, texture.filter);
  if (texture.kind == TextureKind::kGaussian) texture.alpha_is_opacity = false;
  if (texture.HasTiles()) return;  // its wrap is that of the sample
  for (TextureKey key : {Key::kWrap, Key::kWrapU, Key::kWrapV}) {
    TextureWrap& out = key == Key::kWrapV ? texture.wrap_v : texture.wrap_u;
    if (!At(keys, key)) continue;
    ReadWord<TextureWrap>(At(keys, key), owner,
                          {{"repeat", TextureWrap::kRepeat},
                           {"clamp", TextureWrap::kClamp},
                           {"mirror", TextureWrap::kMirror}},
                          out);
    if (key == Key::kWrap) texture.wrap_v = texture.wrap_w = texture.wrap_u;
  }
  ReadBool(At(keys, Key::kMipmaps), owner, texture.mipmaps);
  if (!texture.mipmaps && At(keys, Key::kWeights)) {
    BadValue(*At(keys, Key::kMipmaps), "the weights of patterns are in their mip levels");
  }
  const DocumentNode* level = At(keys, Key::kMaxLevel);
  if (!Is(level, DocumentKind::kNumber, owner)) return;
  if (!level->is_integer || level->integer < 0 || level->integer > kCoarsestLevel) {
    BadValue(*level, fmt::format("'max_level' is a whole number from 0 to {}", kCoarsestLevel));
  } else {
    texture.max_level = static_cast<int>(level->integer);
  }
}

}  // namespace texgraph::graph
