// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/tiles_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "compiler/base/files.h"
#include "compiler/base/text.h"
#include "compiler/manifest/json_writer.h"
#include "compiler/manifest/print_textures.h"
#include "compiler/textures/tile_levels.h"

namespace texgraph::cli {
namespace {

using manifest::JsonList;
using textures::TileKind;
using textures::TilePackLayout;
using textures::TileSet;
using textures::TileSetQuality;

std::string Sides(uint32_t first, uint32_t second) {
  return JsonList({std::to_string(first), std::to_string(second)});
}

// More digits would only be noise.
std::string RatioJson(double ratio) { return DoubleText(std::round(ratio * 1e4) / 1e4); }

std::string RatioText(double ratio) { return ratio > 0 ? fmt::format("{:.2f}", ratio) : "none"; }

// Of each combination of colours, the first one counting fastest.
std::string PlacesJson(const TilePackLayout& layout) {
  const bool corner = layout.kind == TileKind::kCorner;
  const auto count = [&](uint32_t i) { return layout.colors[corner || i % 2 == 0 ? 0 : 1]; };
  std::vector<std::string> places;
  for (uint32_t i = 0; i < layout.tiles(); ++i) {
    textures::TileColors colors;
    uint32_t rest = i;
    for (uint32_t c = 0; c < 4; ++c) {
      colors[c] = rest % count(c);
      rest /= count(c);
    }
    const textures::TilePlace place = PackedTile(layout, colors);
    places.push_back(std::to_string(place.x + place.y * layout.columns));
  }
  return JsonList(places);
}

void PrintQuality(const TileSet& set, manifest::JsonWriter& json) {
  json.OpenObject("quality");
  json.Raw("mean", RatioJson(set.quality.mean));
  json.OpenList("edges");
  for (const TileSetQuality::Edge& edge : set.quality.edges) {
    const std::string colors = set.layout.kind == TileKind::kWang
                                   ? fmt::format("\"color\": {}", edge.first)
                                   : fmt::format("\"colors\": {}", Sides(edge.first, edge.second));
    json.Raw("", fmt::format("{{ \"stands\": {}, {}, \"ratio\": {} }}", edge.stands, colors,
                             edge.ratio > 0 ? RatioJson(edge.ratio) : "null"));
  }
  json.CloseList();
  json.CloseObject();
}

// The ratio of the edge of these colours, if there is such an edge.
std::optional<double> RatioOf(const TileSetQuality& quality, bool stands, uint32_t first,
                              uint32_t second) {
  const auto edge = std::ranges::find_if(quality.edges, [&](const TileSetQuality::Edge& edge) {
    return edge.stands == stands && edge.first == first && edge.second == second;
  });
  if (edge == quality.edges.end()) return std::nullopt;
  return edge->ratio;
}

std::string EdgeTable(const TileSet& set) {
  const bool corner = set.layout.kind == TileKind::kCorner;
  const auto cell = [&](bool stands, uint32_t first, uint32_t second) {
    const auto ratio = RatioOf(set.quality, stands, first, second);
    return ratio ? RatioText(*ratio) : "";
  };
  std::string text = fmt::format("{:<12}{:>8}{:>8}\n", "edge", "lies", "stands");
  const uint32_t colors = std::max(set.layout.colors[0], set.layout.colors[1]);
  for (uint32_t first = 0; first < colors; ++first) {
    for (uint32_t second = corner ? 0 : first; second < (corner ? colors : first + 1); ++second) {
      const std::string name =
          corner ? fmt::format("{} to {}", first, second) : fmt::format("colour {}", first);
      const std::string lies = cell(false, first, second);
      const std::string stands = cell(true, first, second);
      text += fmt::format("{:<12}{:>8}", name, lies);
      text += stands.empty() ? "\n" : fmt::format("{:>8}\n", stands);
    }
  }
  return text;
}

// Rows from the top, as in the picture.
std::string TileTable(const TileSet& set) {
  const TilePackLayout& layout = set.layout;
  std::string text = fmt::format("{:<12}", "tile");
  for (uint32_t x = 0; x < layout.columns; ++x) text += fmt::format("{:>6}", x);
  text += '\n';
  for (uint32_t y = layout.rows; y-- > 0;) {
    text += fmt::format("{:<12}", fmt::format("row {}", y));
    for (uint32_t x = 0; x < layout.columns; ++x)
      text += fmt::format("{:>6}", RatioText(set.quality.tiles[x + size_t{y} * layout.columns]));
    text += '\n';
  }
  return text;
}

}  // namespace

uint32_t LastTileLevel(uint32_t tile_size) { return textures::TileMaxLevel(tile_size) - 1; }

std::string TilesJson(const TileSet& set, const std::vector<std::string>& maps,
                      const TilesFiles& files) {
  const std::string folder =
      AbsolutePath(files.json == "-" ? std::string() : std::string(FolderOf(files.json)));
  const auto listed = [&](const std::vector<std::string>& paths) {
    std::vector<std::string> names;
    for (const std::string& path : paths) {
      names.push_back(JsonQuoted(path == "-" ? path : RelativePath(AbsolutePath(path), folder)));
    }
    return JsonList(names);
  };
  manifest::JsonWriter json;
  json.OpenObject();
  json.Integer("texgraph_tiles", 1);
  json.Raw("files", listed(files.packs));
  if (!files.corner_packs.empty()) json.Raw("corner_packs", listed(files.corner_packs));
  json.OpenObject("prepared_from");
  json.Raw("files", listed(maps));
  json.CloseObject();
  manifest::PrintTileLayout(set.layout, json);
  json.Raw("places", PlacesJson(set.layout));
  json.Raw("wrap", set.layout.gutter > 0 ? R"(["repeat", "clamp"])" : R"(["repeat", "repeat"])");
  json.Integer("max_level", LastTileLevel(set.layout.tile_size));
  PrintQuality(set, json);
  json.CloseObject();
  return json.Take();
}

std::string TilesReport(const TileSet& set) {
  return "How much neighbours differ across seams; 1 is as much as neighbours in the sample.\n\n" +
         EdgeTable(set) + '\n' + TileTable(set) +
         fmt::format("\n{:<12}{:>6}\n", "all seams", RatioText(set.quality.mean));
}

}  // namespace texgraph::cli
