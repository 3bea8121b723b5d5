// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_set.h"

#include <fmt/format.h>
#include <string.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "compiler/textures/texel_chain.h"
#include "compiler/textures/tile_evening.h"
#include "compiler/textures/tile_labels.h"
#include "compiler/textures/tile_patches.h"
#include "compiler/textures/tile_quality.h"
#include "compiler/textures/tile_sample.h"
#include "compiler/textures/tile_threads.h"

namespace texgraph::textures {
namespace {

static_assert(kMaxTilePackTexels <= kMaxImagePixels);
constexpr uint32_t kMinCandidates = 8;
constexpr uint32_t kSearchSide = 32;    // of a tile where patches are searched
constexpr uint32_t kMiddles = 256;      // looked at for each tile
constexpr uint32_t kMaxFinalists = 24;  // sets of patches that are tried
constexpr uint32_t kTriedTiles = 16;    // of each
// Of a grid as strong as that of random patches, as a part of what the seams cost.
constexpr double kTriedGridCost = 0.5;
constexpr uint64_t kTryingTime = 500;  // about as long as so many pairs take

// Seeds' streams: candidates use those below.
constexpr uint32_t kMiddleStream = 1u << 16;

int64_t Around(int64_t at, int64_t size, bool wraps) {
  if (!wraps) return std::clamp<int64_t>(at, 0, size - 1);
  const int64_t rest = at % size;
  return rest < 0 ? rest + size : rest;
}

class TileSetMaker {
 public:
  TileSetMaker(std::span<const Image> maps, const TileSetOptions& options, const TileSample& sample)
      : maps_(maps), options_(options), sample_(sample) {
    set_.layout = LayOutTiles(options.kind, options.colors, options.tile_size);
    for (const Image& map : maps) {
      Image& pack = set_.packs.emplace_back();
      static_cast<ImageInfo&>(pack) = map;
      pack.width = set_.layout.width();
      pack.height = set_.layout.height();
      pack.pixels.resize(pack.RowBytes() * pack.height);
    }
  }

  TileSet Make(const TileProgress& progress);

 private:
  // Of a set of patches: the seams over borders, of each ordered pair, first those that lie.
  using Borders = std::vector<std::vector<uint32_t>>;

  uint32_t SearchScale() const;
  uint32_t Finalists() const { return std::clamp(options_.candidates / 10, 1u, kMaxFinalists); }
  Borders BordersOf(const std::vector<std::array<int64_t, 2>>& patches) const;
  TileTask TaskOf(uint32_t tile, const std::vector<std::array<int64_t, 2>>& patches,
                  const Borders& borders) const;
  std::vector<TexelPlace> MiddlesOf(uint32_t tile) const;
  void ChoosePatches(TileWork& work);
  void CopyTile(uint32_t tile, const LabelledTile& labelled);
  void FillGutters();
  std::span<const Image> maps_;
  const TileSetOptions& options_;
  const TileSample& sample_;
  TileSet set_;
  Borders borders_;
};

uint32_t TileSetMaker::SearchScale() const {
  uint32_t scale = 0;
  while ((options_.tile_size >> scale) > kSearchSide) ++scale;
  return scale;
}

TileSetMaker::Borders TileSetMaker::BordersOf(
    const std::vector<std::array<int64_t, 2>>& patches) const {
  Borders borders;
  if (options_.kind != TileKind::kCorner) return borders;
  for (const bool stands : {false, true}) {
    for (const auto& from : patches) {
      for (const auto& to : patches)
        borders.push_back(SeamOverBorder(sample_, options_.tile_size, stands, from, to));
    }
  }
  return borders;
}

TileTask TileSetMaker::TaskOf(uint32_t tile, const std::vector<std::array<int64_t, 2>>& patches,
                              const Borders& borders) const {
  const TilePackLayout& layout = set_.layout;
  const TileColors colors = TileAt(layout, tile % layout.columns, tile / layout.columns);
  TileTask task;
  task.kind = layout.kind;
  task.size = layout.tile_size;
  task.patches = PatchesOfTile(layout, patches, colors);
  if (layout.kind == TileKind::kCorner) {
    const size_t count = layout.colors[0];
    const auto border = [&](bool stands, uint32_t from, uint32_t to) {
      return std::span(borders[((stands ? count : 0) + from) * count + to]);
    };
    task.borders = {border(false, colors[0], colors[1]), border(true, colors[1], colors[3]),
                    border(false, colors[2], colors[3]), border(true, colors[0], colors[2])};
  }
  return task;
}

std::vector<TexelPlace> TileSetMaker::MiddlesOf(uint32_t tile) const {
  std::vector<TexelPlace> middles;
  for (uint32_t i = 0; i < kMiddles; ++i) {
    const uint32_t stream = kMiddleStream + 2 * (tile * kMiddles + i);
    const auto random = [&](uint32_t axis, uint32_t size) {
      const uint32_t places = sample_.wraps() ? size : size - options_.tile_size + 1;
      return static_cast<int64_t>(uint64_t{TileHash(options_.seed, stream + axis)} * places >> 32);
    };
    middles.push_back({random(0, sample_.width()), random(1, sample_.height())});
  }
  return middles;
}

// Pairs say little of how the seams of four patches go together, so the best sets are tried.
void TileSetMaker::ChoosePatches(TileWork& work) {
  std::vector<PatchSet> sets =
      RankPatches(sample_, set_.layout, options_, SearchScale(), Finalists(), work);
  std::vector<Borders> borders(sets.size());
  const auto count = static_cast<uint32_t>(sets.size());
  ForEachTile(count, options_.threads,
              [&](uint32_t i) { borders[i] = BordersOf(sets[i].patches); });
  const uint32_t tiles = std::min(set_.layout.tiles(), kTriedTiles);
  std::vector<int64_t> costs(size_t{count} * tiles);
  ForEachTile(count * tiles, options_.threads, [&](uint32_t i) {
    // Spread over the pack if it has more tiles.
    const auto tile = static_cast<uint32_t>(uint64_t{i % tiles} * set_.layout.tiles() / tiles);
    const TileTask task = TaskOf(tile, sets[i / tiles].patches, borders[i / tiles]);
    costs[i] = SeamsOfTile(sample_, task, SearchScale());
    work.Add(kTryingTime);
  });
  // As many were to be tried.
  work.Add(uint64_t{Finalists() - count} * tiles * kTryingTime);
  size_t best = 0;
  double least = 0;
  for (size_t i = 0; i < sets.size(); ++i) {
    double cost = 0;
    for (uint32_t tile = 0; tile < tiles; ++tile)
      cost += static_cast<double>(costs[i * tiles + tile]);
    cost *= (1 + kTriedGridCost * sets[i].grid) / (sets[i].roughness + 1);
    if (i > 0 && cost >= least) continue;
    least = cost;
    best = i;
  }
  set_.patches = std::move(sets[best].patches);
  borders_ = std::move(borders[best]);
}

void TileSetMaker::CopyTile(uint32_t tile, const LabelledTile& labelled) {
  const uint32_t size = options_.tile_size;
  const size_t left = size_t{tile % set_.layout.columns} * size;
  const size_t bottom = set_.layout.gutter + size_t{tile / set_.layout.columns} * size;
  for (size_t i = 0; i < maps_.size(); ++i) {
    const Image& map = maps_[i];
    Image& pack = set_.packs[i];
    const size_t bytes = size_t{map.channels} * (map.bits / 8);
    for (uint32_t y = 0; y < size; ++y) {
      uint8_t* to = &pack.pixels[pack.RowBytes() * (pack.height - 1 - bottom - y) + left * bytes];
      for (uint32_t x = 0; x < size; ++x, to += bytes) {
        const TexelPlace& patch = labelled.patches[labelled.labels[size_t{y} * size + x]];
        const int64_t column = Around(patch.x + x, map.width, options_.wraps);
        const int64_t row = map.height - 1 - Around(patch.y + y, map.height, options_.wraps);
        memcpy(to,
               &map.pixels[map.RowBytes() * static_cast<size_t>(row) +
                           static_cast<size_t>(column) * bytes],
               bytes);
      }
    }
  }
}

void TileSetMaker::FillGutters() {
  const TilePackLayout& layout = set_.layout;
  const size_t size = layout.tile_size;
  for (Image& pack : set_.packs) {
    const size_t bytes = size_t{pack.channels} * (pack.bits / 8) * size;
    const auto texels = [&](size_t column, size_t row) {
      return &pack.pixels[pack.RowBytes() * (pack.height - 1 - row) + column * bytes];
    };
    for (uint32_t x = 0; x < layout.columns; ++x) {
      const TilePlace above = ContinuedPlace(layout, x, layout.rows);
      const TilePlace below = ContinuedPlace(layout, x, -1);
      for (size_t y = 0; y < layout.gutter; ++y) {
        memcpy(texels(x, layout.gutter + layout.rows * size + y),
               texels(above.x, layout.gutter + above.y * size + y), bytes);
        memcpy(texels(x, layout.gutter - 1 - y),
               texels(below.x, layout.gutter + (below.y + 1) * size - 1 - y), bytes);
      }
    }
  }
}

TileSet TileSetMaker::Make(const TileProgress& progress) {
  const uint32_t tiles = set_.layout.tiles();
  const uint32_t candidates = (options_.kind == TileKind::kWang ? 2 : 1) * options_.candidates;
  const uint64_t pairs = uint64_t{candidates} * (candidates + 1) / 2;
  // A tile takes about as long as so many pairs.
  const uint64_t per_tile = uint64_t{8} * options_.tile_size;
  const uint64_t trials = uint64_t{Finalists()} * std::min(tiles, kTriedTiles);
  TileWork work(progress, pairs + trials * kTryingTime + tiles * per_tile);
  ChoosePatches(work);
  QualityOfTiles quality(sample_, set_.layout);
  ForEachTile(tiles, options_.threads, [&](uint32_t tile) {
    TileTask task = TaskOf(tile, set_.patches, borders_);
    if (options_.own_middles) task.middles = MiddlesOf(tile);
    const LabelledTile labelled = LabelTile(sample_, task);
    CopyTile(tile, labelled);
    quality.Measure(tile, labelled);
    work.Add(per_tile);
  });
  if (options_.even) EvenTiles(set_.layout, set_.packs);
  FillGutters();
  set_.quality = quality.Sum();
  return std::move(set_);
}

bool CheckColors(const TileSetOptions& options, std::string_view name, SourceRange range,
                 Diagnostics& diagnostics) {
  if (AreTileColors(options.kind, options.colors)) return true;
  const bool corner = options.kind == TileKind::kCorner;
  diagnostics.Error(
      DiagnosticKind::kSizeLimit, range,
      corner ? fmt::format("the tiles of '{}' have {} corner colours; 2 to {} are possible",
                           Printable(name), options.colors[0], kMaxTileColors)
             : fmt::format("the tiles of '{}' have {} and {} edge colours; 1 to {} of "
                           "each are possible",
                           Printable(name), options.colors[0], options.colors[1], kMaxTileColors));
  return false;
}

bool CheckSize(const TileSetOptions& options, uint64_t maps, std::string_view name,
               SourceRange range, Diagnostics& diagnostics) {
  const uint32_t largest = LargestTile(options.kind, options.colors, maps);
  if (options.tile_size >= kMinTileSize && options.tile_size <= largest) return true;
  const uint32_t tiles = LayOutTiles(options.kind, options.colors, 1).tiles();
  diagnostics.Error(
      DiagnosticKind::kSizeLimit, range,
      fmt::format("the tiles of '{}' have {} texels a side; {} to {} are possible where a pack has "
                  "{}{}",
                  Printable(name), options.tile_size, kMinTileSize, largest,
                  tiles == 1 ? "1 tile" : fmt::format("{} tiles", tiles),
                  maps == 1 ? "" : fmt::format(" and there are {} packs", maps)));
  return false;
}

bool CheckSample(const TileSetOptions& options, uint32_t width, uint32_t height,
                 std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  const uint32_t least = LeastSample(options.tile_size, options.wraps);
  if (width >= least && height >= least) return true;
  std::string advice =
      fmt::format("tiles of {} texels take at least {} x {}", options.tile_size, least, least);
  const uint32_t largest = LargestTileOfSample(width, height, options.wraps);
  if (largest >= kMinTileSize) {
    advice += fmt::format("; tiles of {} texels would do", largest);
  }
  diagnostics.Error(DiagnosticKind::kBadImage, range,
                    fmt::format("the sample of '{}' has {} x {} pixels; {}", Printable(name), width,
                                height, advice));
  return false;
}

bool CheckMaps(std::span<const Image> maps, std::string_view name, SourceRange range,
               Diagnostics& diagnostics) {
  if (maps.empty()) {
    diagnostics.Error(DiagnosticKind::kBadImage, range,
                      fmt::format("the tiles of '{}' have no sample", Printable(name)));
    return false;
  }
  for (const Image& map : maps) {
    if (map.width == maps[0].width && map.height == maps[0].height) continue;
    diagnostics.Error(
        DiagnosticKind::kBadImage, range,
        fmt::format(
            "the maps of the sample of '{}' differ in size: {} x {} and {} x {}; maps of one "
            "material are equally large",
            Printable(name), maps[0].width, maps[0].height, map.width, map.height));
    return false;
  }
  return true;
}

// One for each map: the weights, or 1 if none of them can be used.
std::vector<double> WeightsOf(std::span<const double> weights, size_t maps) {
  const auto counts = [](double weight) { return std::isfinite(weight) && weight > 0; };
  if (weights.size() != maps || std::ranges::none_of(weights, counts)) {
    return std::vector<double>(maps, 1.0);
  }
  std::vector<double> good(weights.begin(), weights.end());
  for (double& weight : good) weight = counts(weight) ? weight : 0;
  return good;
}

}  // namespace

uint32_t LeastSample(uint32_t tile_size, bool wraps) {
  return wraps ? 2 * TileReach(tile_size) : 2 * tile_size;
}

uint32_t LargestTileOfSample(uint32_t width, uint32_t height, bool wraps) {
  const uint32_t side = std::min(width, height);
  uint32_t size = wraps ? static_cast<uint32_t>(uint64_t{side} * 2 / 3) : side / 2;
  while (size > 0 && LeastSample(size, wraps) > side) --size;
  return size;
}

bool CheckTileSet(const TileSetOptions& options, uint32_t sample_width, uint32_t sample_height,
                  std::string_view name, SourceRange range, Diagnostics& diagnostics,
                  uint64_t maps) {
  bool good = CheckColors(options, name, range, diagnostics) &&
              CheckSize(options, maps, name, range, diagnostics) &&
              CheckSample(options, sample_width, sample_height, name, range, diagnostics);
  if (options.candidates < kMinCandidates || options.candidates > kMaxTileCandidates) {
    diagnostics.Error(
        DiagnosticKind::kSizeLimit, range,
        fmt::format("the tiles of '{}' try {} patches; {} to {} are possible", Printable(name),
                    options.candidates, kMinCandidates, kMaxTileCandidates));
    good = false;
  }
  return good;
}

std::optional<TileSet> MakeTileSet(std::span<const Image> maps, std::span<const double> weights,
                                   const TileSetOptions& options, std::string_view name,
                                   SourceRange range, Diagnostics& diagnostics,
                                   const TileProgress& progress) {
  if (!CheckMaps(maps, name, range, diagnostics) ||
      !CheckTileSet(options, maps[0].width, maps[0].height, name, range, diagnostics,
                    maps.size())) {
    return std::nullopt;
  }
  try {
    uint32_t scales = ScalesOfTile(options.tile_size);
    while ((options.tile_size >> (scales - 1)) > kSearchSide) ++scales;
    const TileSample sample(maps, WeightsOf(weights, maps.size()), options.wraps, scales);
    return TileSetMaker(maps, options, sample).Make(progress);
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace texgraph::textures
