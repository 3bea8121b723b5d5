// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_quality.h"

#include <algorithm>
#include <utility>

namespace texgraph::textures {

QualityOfTiles::QualityOfTiles(const TileSample& sample, const TilePackLayout& layout)
    : sample_(sample),
      layout_(layout),
      beside_(sample.MeanStep(false)),
      above_(sample.MeanStep(true)),
      tiles_(layout.tiles()) {
  for (const bool stands : {false, true}) {
    const uint32_t colors = layout.colors[stands ? 1 : 0];
    for (uint32_t first = 0; first < colors; ++first) {
      if (layout.kind == TileKind::kWang) {
        edges_.push_back({stands, first, first, 0});
        continue;
      }
      for (uint32_t second = 0; second < colors; ++second)
        edges_.push_back({stands, first, second, 0});
    }
  }
}

std::vector<uint32_t> QualityOfTiles::EdgesBetween(const TileColors& colors, uint32_t a,
                                                   uint32_t b) const {
  if (std::max(a, b) >= kMiddlePatch) return {};
  if (layout_.kind == TileKind::kWang) {
    // Labels are south, east, north, west.
    const auto edge = [&](uint32_t label) {
      return colors[label] + (label % 2 == 1 ? layout_.colors[0] : 0);
    };
    return {edge(a), edge(b)};
  }
  const auto [low, high] = std::minmax(a, b);
  const bool lies = high - low == 1 && low % 2 == 0;
  if (!lies && high - low != 2) return {};
  const uint32_t count = layout_.colors[0];
  return {(lies ? 0 : count * count) + colors[low] * count + colors[high]};
}

void QualityOfTiles::AddLink(const TileColors& colors, const LabelledTile& labelled, uint32_t p,
                             uint32_t q, Tile& tile) const {
  const uint32_t a = labelled.labels[p];
  const uint32_t b = labelled.labels[q];
  if (a == b) return;
  const uint32_t size = layout_.tile_size;
  const auto place = [&](uint32_t label, uint32_t texel) {
    const TexelPlace& patch = labelled.patches[label];
    return TexelPlace{patch.x + texel % size, patch.y + texel / size};
  };
  const double usual = q == p + 1 ? beside_ : above_;
  const double step = sample_.Difference(0, place(a, p), place(b, q));
  const Seams seam{usual > 0 ? step / usual : 0, 1};
  tile.all.Add(seam);
  for (uint32_t edge : EdgesBetween(colors, a, b)) tile.edges[edge].Add(seam);
}

void QualityOfTiles::Measure(uint32_t index, const LabelledTile& labelled) {
  Tile& tile = tiles_[index];
  tile.edges.resize(edges_.size());
  const TileColors colors = TileAt(layout_, index % layout_.columns, index / layout_.columns);
  const uint32_t size = layout_.tile_size;
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const uint32_t p = y * size + x;
      if (x + 1 < size) AddLink(colors, labelled, p, p + 1, tile);
      if (y + 1 < size) AddLink(colors, labelled, p, p + size, tile);
    }
  }
}

TileSetQuality QualityOfTiles::Sum() const {
  TileSetQuality quality;
  quality.edges = edges_;
  Seams all;
  for (const Tile& tile : tiles_) {
    quality.tiles.push_back(tile.all.Ratio());
    all.Add(tile.all);
  }
  quality.mean = all.Ratio();
  for (size_t i = 0; i < edges_.size(); ++i) {
    Seams seams;
    for (const Tile& tile : tiles_) seams.Add(tile.edges[i]);
    quality.edges[i].ratio = seams.Ratio();
  }
  return quality;
}

}  // namespace texgraph::textures
