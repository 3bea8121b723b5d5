// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/check_textures.h"

#include <fmt/format.h>

#include <array>
#include <optional>
#include <vector>

#include "compiler/base/files.h"
#include "compiler/manifest/graph_textures.h"
#include "compiler/manifest/noise_textures.h"
#include "compiler/manifest/pictures.h"
#include "compiler/textures/maps.h"
#include "compiler/textures/permutation.h"
#include "compiler/textures/sheets.h"
#include "compiler/textures/tile_levels.h"
#include "compiler/textures/tile_map.h"

namespace texgraph::manifest {
namespace {

// Every number of a map's picture must be one of what it counts. Pictures have their pixels
// counted from the left top corner, maps from v = 0.
bool CheckNumbers(const graph::Graph& graph, const graph::Texture& texture, const NumberMap& map,
                  Diagnostics& diagnostics) {
  const std::optional<graph::Reach> reach = graph::ReachOf(graph, texture);
  if (!reach) return true;
  const std::optional<size_t> wrong = textures::FindOutOfRange(map, reach->count);
  if (!wrong) return true;
  diagnostics
      .Error(DiagnosticKind::kValueRange, texture.file_ranges[0],
             fmt::format("pixel ({}, {}) of the map '{}': {}", *wrong % map.width,
                         map.height - 1 - *wrong / map.width, texture.name,
                         graph::BeyondReach(*reach, map.numbers[*wrong])))
      .AddNote(reach->range, fmt::format("'{}' is here", reach->name));
  return false;
}

void DecodeMap(const graph::Graph& graph, graph::Texture& texture, const std::string& folder,
               const Roots& roots, Diagnostics& diagnostics) {
  const std::string path = JoinPath(folder, texture.files[0]);
  const SourceRange range = texture.file_ranges[0];
  const auto info = textures::ProbeImage(path, range, diagnostics, roots);
  if (!info || !graph::CheckMapSize(info->width, info->height, texture, range, diagnostics)) return;
  const auto image = textures::ReadImage(path, range, diagnostics, roots);
  if (!image) return;
  std::vector<std::array<uint8_t, 3>> legend;
  for (const graph::LegendColor& color : texture.legend) legend.push_back(color.rgb);
  auto map = textures::MapOfImage(*image, legend, texture.name, range, diagnostics);
  if (!map || !CheckNumbers(graph, texture, *map, diagnostics)) return;
  texture.map = std::move(*map);
}

// `slice`: the first, or the picture of all of them.
void CheckSolid(const graph::Texture& texture, const textures::ImageInfo& slice,
                Diagnostics& diagnostics) {
  std::array<uint32_t, 3> size = {slice.width, slice.height,
                                  static_cast<uint32_t>(texture.files.size())};
  if (texture.files.size() == 1) {
    const auto [columns, rows] = texture.grid;
    if (!textures::CheckSheet(slice, columns, rows, texture.name, texture.grid_range,
                              diagnostics)) {
      return;
    }
    size = {slice.width / columns, slice.height / rows, columns * rows};
  }
  textures::CheckCubeSet(CubeOptionsOf(texture), size, texture.name, texture.file_ranges[0],
                         diagnostics);
}

// Every file must be an image that can be read, the layers of one array equally large, and a mask
// as large as its picture. The first image, if it can be read.
std::optional<textures::ImageInfo> CheckPictures(const graph::Texture& texture,
                                                 const std::string& folder, const Roots& roots,
                                                 Diagnostics& diagnostics) {
  std::optional<textures::ImageInfo> first;
  for (size_t i = 0; i < texture.files.size(); ++i) {
    const textures::PictureSource source = PictureOf(texture, i, folder);
    const auto info = textures::ProbeImage(source.file, source.range, diagnostics, roots);
    if (source.mask) {
      const auto mask =
          textures::ProbeImage(source.mask->file, source.mask->range, diagnostics, roots);
      if (info && mask) CheckMaskSize(source, *info, *mask, diagnostics);
    }
    if (!info) continue;
    if (texture.kind == graph::TextureKind::kSheet) {
      textures::CheckSheet(*info, texture.grid[0], texture.grid[1], texture.name,
                           texture.grid_range, diagnostics);
    }
    if (texture.kind == graph::TextureKind::kColorMap) {
      textures::CheckColorMap(info->width, info->height, MapOptionsOf(texture), texture.name,
                              texture.file_ranges[i], diagnostics);
    }
    if (texture.kind == graph::TextureKind::kNoise) continue;  // each spectrum is as it is
    if (texture.kind == graph::TextureKind::kCubes && i == 0) {
      CheckSolid(texture, *info, diagnostics);
    }
    if (!first) first = info;
    if (texture.kind == graph::TextureKind::kCubes &&
        (info->channels != first->channels || info->bits != first->bits)) {
      diagnostics.Error(
          DiagnosticKind::kBadImage, texture.file_ranges[i],
          fmt::format("the slices of a sample must be alike; the first has {} channels of {} bits, "
                      "this one {} of {}",
                      first->channels, first->bits, info->channels, info->bits));
    }
    if (info->width == first->width && info->height == first->height) continue;
    diagnostics.Error(
        DiagnosticKind::kBadImage, texture.file_ranges[i],
        fmt::format(
            "the layers of an array must be equally large; the first is {} x {}, this one {} x {}",
            first->width, first->height, info->width, info->height));
  }
  return first;
}

using Infos = std::vector<std::optional<textures::ImageInfo>>;  // of the graph's textures

// What a set of tiles is made of must be large enough, and all maps of one material of one size:
// only then are their tiles cut at the same places.
void CheckTiles(const graph::Graph& graph, const Infos& infos, Diagnostics& diagnostics) {
  std::vector<uint64_t> maps(graph.textures.size(), 1);
  for (uint32_t t = 0; t < graph.textures.size(); ++t) {
    const graph::Texture& texture = graph.textures[t];
    if (texture.kind != graph::TextureKind::kTiles || !texture.of) continue;
    ++maps[*texture.of];
    const auto& own = infos[t];
    const auto& first = infos[*texture.of];
    if (!own || !first || (own->width == first->width && own->height == first->height)) continue;
    const graph::Texture& set = graph.textures[*texture.of];
    diagnostics
        .Error(DiagnosticKind::kBadImage, texture.file_ranges[0],
               fmt::format("'{}' has {} x {} pixels, and '{}', which it is cut like, {} x {}; maps "
                           "of one material are equally large",
                           texture.name, own->width, own->height, set.name, first->width,
                           first->height))
        .AddNote(set.file_ranges[0], fmt::format("the sample of '{}' is here", set.name));
  }
  for (uint32_t t = 0; t < graph.textures.size(); ++t) {
    const graph::Texture& texture = graph.textures[t];
    if (texture.kind != graph::TextureKind::kTiles || texture.of || !infos[t]) continue;
    const bool is_good =
        textures::CheckTileSet(TileOptionsOf(texture), infos[t]->width, infos[t]->height,
                               texture.name, texture.file_ranges[0], diagnostics, maps[t]);
    if (!is_good || !texture.is_array) continue;
    textures::CheckTileLayers(TileLayoutOf(texture), texture.name, texture.file_ranges[0],
                              diagnostics);
  }
}

}  // namespace

void CheckTextures(graph::Graph& graph, const std::string& folder,
                   const std::vector<std::string>& root_folders, Diagnostics& diagnostics) {
  const Roots roots(root_folders, diagnostics);
  Infos infos(graph.textures.size());
  for (uint32_t t = 0; t < graph.textures.size(); ++t) {
    graph::Texture& texture = graph.textures[t];
    if (texture.kind == graph::TextureKind::kTiling) {
      if (!texture.of) continue;  // reported
      texture.map =
          textures::MakeTileMap(TileLayoutOf(graph.textures[*texture.of]), texture.map.width,
                                texture.map.height, texture.tiles.seed);
    } else if (texture.kind == graph::TextureKind::kPermutation) {
      texture.map = textures::MakePermutation(texture.map.width, texture.tiles.seed);
    } else if (texture.kind != graph::TextureKind::kMap) {
      infos[t] = CheckPictures(texture, folder, roots, diagnostics);
    } else if (!texture.files.empty()) {
      DecodeMap(graph, texture, folder, roots, diagnostics);
    }
  }
  CheckTiles(graph, infos, diagnostics);
}

}  // namespace texgraph::manifest
