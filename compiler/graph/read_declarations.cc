// SPDX-License-Identifier: Apache-2.0
// The sections "textures" and "parameters".
#include <fmt/format.h>

#include <algorithm>

#include "compiler/graph/argument.h"
#include "compiler/graph/graph_reader.h"
#include "compiler/graph/names.h"

namespace texgraph::graph {
namespace {

constexpr int kMaxLevel = 30;  // of a mip chain; no texture has more

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
    constexpr std::array<std::string_view, 9> kKeys = {"file",   "layers",  "color_space",
                                                       "filter", "wrap",    "wrap_u",
                                                       "wrap_v", "mipmaps", "max_level"};
    auto [file, layers, space, filter, wrap, wrap_u, wrap_v, mipmaps, level] =
        Keys(node, owner, kKeys);
    ReadFiles(node, file, layers, texture);
    ReadWord<ColorSpace>(space, owner,
                         {{"srgb", ColorSpace::kSrgb},
                          {"linear", ColorSpace::kLinear},
                          {"data", ColorSpace::kLinear}},
                         texture.color_space);
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
  if (!ReadText(&node, owner, path)) return;
  if (path.empty()) return BadValue(node, "the file's name is empty");
  if (HasControlCharacter(path)) return BadValue(node, "the file's name has control characters");
  texture.files.push_back(path);
  texture.file_ranges.push_back(node.range);
}

void GraphReader::ReadParameters(const DocumentNode* section) {
  if (!Is(section, DocumentKind::kObject, {"the graph", ""})) return;
  graph_.parameters.reserve(section->child_count);
  for (const DocumentNode& child : document_.children(*section)) ReadParameter(child);
}

void GraphReader::ReadParameter(const DocumentNode& node) {
  CheckName(node.key, node.key_range, diagnostics_);
  Owner owner{"parameter", node.key};
  Parameter parameter;
  parameter.name = node.key;
  parameter.range = node.key_range;
  if (Is(&node, DocumentKind::kObject, owner)) {
    constexpr std::array<std::string_view, 7> kKeys = {"type",  "value", "range", "binding",
                                                       "label", "help",  "unit"};
    auto [type, value, range, binding, label, help, unit] = Keys(node, owner, kKeys);
    if (!type) ReportMissing(node, owner, "type");
    if (ReadText(type, owner, parameter.type)) parameter.type_range = type->range;
    if (!value) ReportMissing(node, owner, "value");
    if (value) {
      parameter.value = ReadArgument(document_, *value, diagnostics_).value_or(Argument{});
    }
    ReadRange(range, owner, parameter);
    ReadWord<Binding>(binding, owner,
                      {{"constant", Binding::kConstant},
                       {"specialization", Binding::kSpecialization},
                       {"uniform", Binding::kUniform}},
                      parameter.binding);
    ReadText(label, owner, parameter.label);
    ReadText(help, owner, parameter.help);
    ReadText(unit, owner, parameter.unit);
  }
  graph_.parameters.push_back(std::move(parameter));
}

// "range": [least, greatest].
void GraphReader::ReadRange(const DocumentNode* node, Owner owner, Parameter& parameter) {
  if (!Is(node, DocumentKind::kArray, owner)) return;
  std::optional<Argument> argument = ReadArgument(document_, *node, diagnostics_);
  if (!argument) return;
  if (argument->numbers.size() != 2) {
    return BadValue(*node, "'range' is two numbers: the least and the greatest value");
  }
  if (argument->numbers[0] > argument->numbers[1]) {
    return BadValue(*node, "the first number of 'range' is the smaller one");
  }
  parameter.minimum = argument->numbers[0];
  parameter.maximum = argument->numbers[1];
}

}  // namespace texgraph::graph
