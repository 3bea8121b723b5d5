// SPDX-License-Identifier: Apache-2.0
// Measures the seams of tiles against the sample itself.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/textures/tile_labels.h"
#include "compiler/textures/tile_sample.h"
#include "compiler/textures/tile_set.h"

namespace texgraph::textures {

class QualityOfTiles {
 public:
  QualityOfTiles(const TileSample& sample, const TilePackLayout& layout);

  // Once for each tile; different tiles at the same time are fine.
  void Measure(uint32_t tile, const LabelledTile& labelled);
  TileSetQuality Sum() const;

 private:
  struct Seams {
    double steps = 0;  // differences across the seam, as parts of the sample's mean one
    double count = 0;
    void Add(const Seams& seams) {
      steps += seams.steps;
      count += seams.count;
    }
    double Ratio() const { return count > 0 ? steps / count : 0; }
  };
  struct Tile {
    Seams all;
    std::vector<Seams> edges;
  };
  void AddLink(const TileColors& colors, const LabelledTile& labelled, uint32_t p, uint32_t q,
               Tile& tile) const;
  // The edges whose seams lie between these two labels, as indices; fewer than two: none.
  std::vector<uint32_t> EdgesBetween(const TileColors& colors, uint32_t a, uint32_t b) const;

  const TileSample& sample_;
  const TilePackLayout& layout_;
  std::vector<TileSetQuality::Edge> edges_;
  double beside_;
  double above_;
  std::vector<Tile> tiles_;
};

}  // namespace texgraph::textures
