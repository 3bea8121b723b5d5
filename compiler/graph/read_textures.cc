// SPDX-License-Identifier: Apache-2.0
// The section "textures".
#include <fmt/format.h>

#include <algorithm>

#include "compiler/graph/graph_reader.h"
#include "compiler/graph/names.h"

namespace texgraph::graph {
namespace {

constexpr int kMaxKeyEdge = 64;  // in texels
constexpr int kMaxLevel = 30;    // of a mip chain; no texture has more

bool HasControlCharacter(std::string_view text) {
  return std::ranges::any_of(text,
                             [](char c) { return static_cast<uint8_t>(c) < 0x20 || c == 0x7f; });
}

}  // namespace

void GraphReader::ReadTextures(const DocumentNode* section) {
  if (!Is(section, DocumentKind::kObject, {"the graph", ""})) return;
  graph_.textures.reserve(section->child_count);
  for (const DocumentNode& child : document_.children(*section)) ReadTexture(child);
}

void GraphReader::ReadTexture(const DocumentNode& node) {
  CheckName(node.key, node.key_range, diagnostics_);
  Owner owner{"texture", node.key};
  Texture texture;
  texture.name = node.key;
  texture.range = node.key_range;
  if (Is(&node, DocumentKind::kObject, owner)) {
    constexpr std::array<std::string_view, 12> kKeys = {
        "file",   "layers", "mask",   "key",    "color_space", "alpha",
        "filter", "wrap",   "wrap_u", "wrap_v", "mipmaps",     "max_level"};
    auto [file, layers, mask, key, space, alpha, filter, wrap, wrap_u, wrap_v, mipmaps, level] =
        Keys(node, owner, kKeys);
    ReadFiles(node, file, layers, texture);
    if (mask) ReadMasks(*mask, owner, texture);
    if (key) ReadKey(*key, owner, texture);
    ReadWord<ColorSpace>(space, owner,
                         {{"srgb", ColorSpace::kSrgb},
                          {"linear", ColorSpace::kLinear},
                          {"data", ColorSpace::kLinear}},
                         texture.color_space);
    texture.alpha_is_opacity = texture.IsPrepared() || texture.color_space == ColorSpace::kSrgb;
    ReadWord<bool>(alpha, owner, {{"opacity", true}, {"data", false}}, texture.alpha_is_opacity);
    ReadWord<TextureFilter>(
        filter, owner, {{"linear", TextureFilter::kLinear}, {"nearest", TextureFilter::kNearest}},
        texture.filter);
    for (auto [key, both] : {std::pair(wrap, true), {wrap_u, false}, {wrap_v, false}}) {
      TextureWrap& out = key == wrap_v ? texture.wrap_v : texture.wrap_u;
      if (!key) continue;
      ReadWord<TextureWrap>(key, owner,
                            {{"repeat", TextureWrap::kRepeat},
                             {"clamp", TextureWrap::kClamp},
                             {"mirror", TextureWrap::kMirror}},
                            out);
      if (both) texture.wrap_v = texture.wrap_u;
    }
    ReadBool(mipmaps, owner, texture.mipmaps);
    if (Is(level, DocumentKind::kNumber, owner)) {
      if (!level->is_integer || level->integer < 0 || level->integer > kMaxLevel) {
        BadValue(*level, fmt::format("'max_level' is a whole number from 0 to {}", kMaxLevel));
      } else {
        texture.max_level = static_cast<int>(level->integer);
      }
    }
  }
  graph_.textures.push_back(std::move(texture));
}

void GraphReader::ReadFiles(const DocumentNode& node, const DocumentNode* file,
                            const DocumentNode* layers, Texture& texture) {
  Owner owner{"texture", node.key};
  if (!file && !layers) return ReportMissing(node, owner, "file");
  if (file && layers) {
    diagnostics_
        .Error(DiagnosticKind::kGraphShape, layers->key_range,
               fmt::format("texture '{}' has 'file' and 'layers'; it takes one of them",
                           Printable(node.key)))
        .AddNote(file->key_range, "'file' is here");
    return;
  }
  if (file) return ReadFile(*file, owner, texture);
  texture.is_array = true;
  if (!Is(layers, DocumentKind::kArray, owner)) return;
  if (layers->child_count == 0) BadValue(*layers, "'layers' names at least one file");
  for (const DocumentNode& child : document_.children(*layers)) ReadFile(child, owner, texture);
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
  if (!texture.is_array) {
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
