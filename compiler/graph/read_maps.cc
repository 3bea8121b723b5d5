// SPDX-License-Identifier: Apache-2.0
// Textures of whole numbers that stand in the graph: maps, and lists.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "compiler/graph/argument.h"
#include "compiler/graph/graph_reader.h"

namespace texgraph::graph {
namespace {

constexpr size_t kMaxLegendColors = 65536;

std::optional<uint32_t> HexDigit(char c) {
  if (c >= '0' && c <= '9') return static_cast<uint32_t>(c - '0');
  if (c >= 'a' && c <= 'f') return static_cast<uint32_t>(c - 'a' + 10);
  if (c >= 'A' && c <= 'F') return static_cast<uint32_t>(c - 'A' + 10);
  return std::nullopt;
}

// "#rrggbb"
std::optional<LegendColor> ReadColor(std::string_view text) {
  LegendColor color;
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  for (size_t c = 0; c < 3; ++c) {
    const auto high = HexDigit(text[1 + 2 * c]), low = HexDigit(text[2 + 2 * c]);
    if (!high || !low) return std::nullopt;
    color.rgb[c] = static_cast<uint8_t>(*high * 16 + *low);
  }
  return color;
}

}  // namespace

void GraphReader::ReadMap(const TextureKeys& keys, Owner owner, Texture& texture) {
  const DocumentNode& map = *keys[static_cast<size_t>(TextureKey::kMap)];
  const DocumentNode* legend = keys[static_cast<size_t>(TextureKey::kLegend)];
  ReadBinding(keys, owner, texture);
  if (map.kind == DocumentKind::kString) {
    ReadFile(map, owner, texture);
    if (legend) ReadLegend(*legend, owner, texture);
    return;
  }
  if (legend) {
    diagnostics_
        .Error(
            DiagnosticKind::kGraphShape, legend->key_range,
            fmt::format("{} has a 'legend', which belongs to the picture of a map", owner.Text()))
        .AddNote(map.range, "this map has its numbers here");
  }
  if (map.kind == DocumentKind::kArray) return ReadMapRows(map, owner, texture);
  diagnostics_.Error(DiagnosticKind::kGraphShape, map.range,
                     fmt::format("'map' of {} must be rows of numbers, or the name of a picture, "
                                 "not {}",
                                 owner.Text(), KindText(map.kind)));
}

// As a picture: the first row is the top one.
void GraphReader::ReadMapRows(const DocumentNode& rows, Owner owner, Texture& texture) {
  if (rows.child_count == 0) return BadValue(rows, "a map has at least one row of numbers");
  const DocumentNode& first = document_.nodes[rows.first_child];
  std::vector<std::vector<int32_t>> numbers;
  for (const DocumentNode& row : document_.children(rows)) {
    if (!Is(&row, DocumentKind::kArray, owner)) return;
    if (row.child_count == 0) return BadValue(row, "a row of a map has at least one number");
    if (row.child_count != first.child_count) {
      diagnostics_
          .Error(DiagnosticKind::kBadValue, row.range,
                 fmt::format("this row has {} numbers, the first has {}; the rows of a map are "
                             "equally long",
                             row.child_count, first.child_count))
          .AddNote(first.range, "the first row is here");
      return;
    }
    if (!ReadNumbers(row, "a map", numbers.emplace_back())) return;
  }
  texture.map = MapOfRows(numbers);
  CheckMapSize(texture.map.width, texture.map.height, texture, rows.range, diagnostics_);
}

bool GraphReader::ReadNumbers(const DocumentNode& row, std::string_view what,
                              std::vector<int32_t>& numbers) {
  for (const DocumentNode& number : document_.children(row)) {
    const bool is_whole = number.kind == DocumentKind::kNumber && number.is_integer;
    if (!is_whole || number.integer < -1 || number.integer > kMaxMapNumber) {
      BadValue(number,
               is_whole ? fmt::format("{} holds numbers from -1, which is nothing, to {}; "
                                      "got {}",
                                      what, kMaxMapNumber, number.integer)
               : number.kind == DocumentKind::kNumber
                   ? fmt::format("{} holds whole numbers, without '.' and exponent", what)
                   : fmt::format("{} holds whole numbers, got {}", what, KindText(number.kind)));
      return false;
    }
    numbers.push_back(static_cast<int32_t>(number.integer));
  }
  return true;
}

// Colours as picture editors write them; the first is number 0.
void GraphReader::ReadLegend(const DocumentNode& node, Owner owner, Texture& texture) {
  if (!Is(&node, DocumentKind::kArray, owner)) return;
  texture.legend_range = node.range;
  if (node.child_count == 0) return BadValue(node, "a legend has at least one colour");
  if (node.child_count > kMaxLegendColors) {
    return BadValue(node, fmt::format("a legend has at most {} colours", kMaxLegendColors));
  }
  std::vector<std::pair<uint32_t, const DocumentNode*>> seen;
  for (const DocumentNode& child : document_.children(node)) {
    if (!Is(&child, DocumentKind::kString, owner)) return;
    const std::optional<LegendColor> color = ReadColor(child.text);
    if (!color) {
      return BadValue(child, fmt::format("a colour of a legend is written '#3a7d2c', not '{}'",
                                         Printable(child.text, 64)));
    }
    texture.legend.push_back(*color);
    const auto& rgb = color->rgb;
    seen.emplace_back(uint32_t{rgb[0]} << 16 | uint32_t{rgb[1]} << 8 | rgb[2], &child);
  }
  std::ranges::stable_sort(seen, {}, [](const auto& entry) { return entry.first; });
  const auto twice =
      std::ranges::adjacent_find(seen, {}, [](const auto& entry) { return entry.first; });
  if (twice == seen.end()) return;
  diagnostics_
      .Error(DiagnosticKind::kBadValue, twice[1].second->range,
             "this colour stands in the legend twice")
      .AddNote(twice[0].second->range, "it stands here first");
}

// A row for each list, as wide as the longest: shorter ones are repeated.
void GraphReader::ReadLists(const TextureKeys& keys, Owner owner, Texture& texture) {
  const DocumentNode& lists = *keys[static_cast<size_t>(TextureKey::kLists)];
  ReadBinding(keys, owner, texture);
  if (!Is(&lists, DocumentKind::kArray, owner)) return;
  if (lists.child_count == 0) return BadValue(lists, "there is at least one list");
  const DocumentNode* longest = nullptr;
  for (const DocumentNode& list : document_.children(lists)) {
    if (!Is(&list, DocumentKind::kArray, owner)) return;
    if (list.child_count == 0) return BadValue(list, "an empty list has nothing to choose from");
    if (!longest || list.child_count > longest->child_count) longest = &list;
  }
  if (!CheckMapSize(longest->child_count, lists.child_count, texture, lists.range, diagnostics_)) {
    return;
  }
  std::vector<std::vector<int32_t>> numbers;
  for (const DocumentNode& list : document_.children(lists)) {
    if (longest->child_count % list.child_count != 0) {
      diagnostics_
          .Error(DiagnosticKind::kBadValue, list.range,
                 fmt::format("this list has {} numbers, which does not divide the {} of the "
                             "longest; it cannot be repeated to that length",
                             list.child_count, longest->child_count))
          .AddNote(longest->range, "the longest list is here");
      return;
    }
    if (!ReadNumbers(list, "a list", numbers.emplace_back())) return;
  }
  texture.map = MapOfLists(numbers).value();
}

void GraphReader::ReadBinding(const TextureKeys& keys, Owner owner, Texture& texture) {
  const DocumentNode* binding = keys[static_cast<size_t>(TextureKey::kBinding)];
  ReadWord<bool>(binding, owner, {{"texture", false}, {"constant", true}}, texture.is_constant);
  if (binding) texture.binding_range = binding->range;
}

// "grid" and "cells": columns and rows.
bool GraphReader::ReadSides(const DocumentNode* node, Owner owner, uint32_t greatest,
                            std::array<uint32_t, 2>& sides) {
  if (!Is(node, DocumentKind::kArray, owner)) return false;
  size_t count = 0;
  for (const DocumentNode& child : document_.children(*node)) {
    const bool good = child.kind == DocumentKind::kNumber && child.is_integer &&
                      child.integer >= 1 && child.integer <= greatest;
    if (good && count < sides.size()) sides[count] = static_cast<uint32_t>(child.integer);
    count += good ? 1 : sides.size() + 1;
  }
  if (count == sides.size()) return true;
  BadValue(*node, fmt::format("'{}' is columns and rows, each a whole number from 1 to {}",
                              node->key, greatest));
  return false;
}

bool CheckMapSize(uint32_t columns, uint32_t rows, const Texture& texture, SourceRange range,
                  Diagnostics& diagnostics) {
  const uint64_t numbers = uint64_t{columns} * rows;
  if (columns > kMaxMapSide || rows > kMaxMapSide || numbers > kMaxMapNumbers) {
    diagnostics.Error(
        DiagnosticKind::kSizeLimit, range,
        fmt::format("texture '{}' has {} x {} numbers; the limits are {} each way and "
                    "{} in all",
                    texture.name, columns, rows, kMaxMapSide, kMaxMapNumbers));
    return false;
  }
  if (!texture.is_constant || numbers <= kMaxConstantNumbers) return true;
  diagnostics.Error(DiagnosticKind::kSizeLimit, texture.binding_range,
                    fmt::format("texture '{}' has {} numbers; at most {} can be constants of the "
                                "shader",
                                texture.name, numbers, kMaxConstantNumbers));
  return false;
}

}  // namespace texgraph::graph
