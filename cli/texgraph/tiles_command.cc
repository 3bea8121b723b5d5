// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/tiles_command.h"

#include <fmt/format.h>

#include <utility>

#include "cli/texgraph/progress.h"
#include "cli/texgraph/tiles_files.h"
#include "cli/texgraph/tiles_report.h"
#include "compiler/base/output_files.h"
#include "compiler/textures/image.h"
#include "compiler/textures/tile_pictures.h"

namespace texgraph::cli {
namespace {

using textures::Image;
using textures::TileSet;

// Steps of the bar: more than it has columns.
constexpr uint32_t kProgressSteps = 1000;

// Nothing if one of them cannot be read; all mistakes are reported.
std::optional<std::vector<Image>> ReadMaps(const TilesOptions& options, Diagnostics& diagnostics) {
  std::vector<Image> maps;
  for (const std::string& path : options.maps) {
    if (auto map = textures::ReadImage(path, {}, diagnostics)) maps.push_back(std::move(*map));
  }
  if (maps.size() != options.maps.size()) return std::nullopt;
  return maps;
}

bool CheckTiling(const TilesOptions& options, Diagnostics& diagnostics) {
  if (options.tiling.empty()) return true;
  const auto [columns, rows] = options.tiling_size;
  const uint64_t tiles = uint64_t{columns} * rows;
  const uint64_t size = options.set.tile_size;
  if (tiles <= textures::kMaxImagePixels / (size * size)) return true;
  diagnostics.Error(
      DiagnosticKind::kSizeLimit, {},
      fmt::format("a tiling of {} x {} tiles of {} pixels has more than {} pixels, the limit",
                  columns, rows, size, textures::kMaxImagePixels));
  return false;
}

// What is made of a set, from the pictures to the files.
class TilesWriter {
 public:
  TilesWriter(const TilesOptions& options, const TilesFiles& names, const TileSet& set,
              Diagnostics& diagnostics)
      : options_(options), names_(names), set_(set), diagnostics_(diagnostics) {}

  // False, with what is wrong reported: then no file has changed.
  bool Run() {
    for (size_t i = 0; i < set_.packs.size(); ++i) {
      if (!Stage(names_.packs[i], set_.packs[i])) return false;
      if (options_.corner_pack &&
          !Stage(names_.corner_packs[i], MakeWeiCornerPack(set_.packs[i], set_.layout))) {
        return false;
      }
    }
    if (!options_.view.empty() && !Stage(options_.view, MakeTileView(set_.packs[0], set_.layout)))
      return false;
    if (!options_.tiling.empty()) {
      const auto [columns, rows] = options_.tiling_size;
      if (!Stage(options_.tiling,
                 MakeTiling(set_.packs[0], set_.layout, columns, rows, options_.set.seed))) {
        return false;
      }
    }
    if (!names_.json.empty()) files_.Add(names_.json, TilesJson(set_, options_.maps, names_));
    if (options_.report) files_.Add("-", TilesReport(set_));
    return files_.Commit(diagnostics_);
  }

 private:
  bool Stage(const std::string& path, const Image& image) {
    if (auto bytes = textures::EncodePng(image))
      return files_.Stage(path, std::move(*bytes), diagnostics_);
    diagnostics_.Error(DiagnosticKind::kOutOfMemory, {},
                       fmt::format("there is not enough memory to write '{}'", Printable(path)));
    return false;
  }

  const TilesOptions& options_;
  const TilesFiles& names_;
  const TileSet& set_;
  Diagnostics& diagnostics_;
  OutputFiles files_;
};

std::string MessageOf(const TileSet& set, const TilesFiles& names) {
  std::string text;
  for (const std::string& pack : names.packs) text += (text.empty() ? "" : ", ") + Printable(pack);
  const uint32_t size = set.layout.tile_size;
  text += fmt::format(": {} tiles of {} x {} pixels", set.layout.tiles(), size, size);
  if (set.quality.mean > 0) {
    text += fmt::format("; neighbours across seams differ {:.2f} times as much as in the sample",
                        set.quality.mean);
  }
  return text + "\n";
}

}  // namespace

void RunTiles(const TilesOptions& options, Diagnostics& diagnostics, std::string& message) {
  const auto names = NameTilesFiles(options, diagnostics);
  if (!names) return;
  const auto maps = ReadMaps(options, diagnostics);
  if (!maps) return;
  std::optional<TileSet> set;
  {
    Progress progress(kProgressSteps, !options.quiet, ProgressUnit::kPercent);
    const auto reach = [&](double share) {
      progress.Reach(static_cast<uint32_t>(share * kProgressSteps));
    };
    if (textures::CheckTileSet(options.set, maps->front().width, maps->front().height,
                               options.maps[0], {}, diagnostics, maps->size()) &&
        CheckTiling(options, diagnostics)) {
      set = textures::MakeTileSet(*maps, options.weights, options.set, options.maps[0], {},
                                  diagnostics, reach);
    }
  }
  if (set && TilesWriter(options, *names, *set, diagnostics).Run())
    message = MessageOf(*set, *names);
}

}  // namespace texgraph::cli
