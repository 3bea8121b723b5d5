// SPDX-License-Identifier: Apache-2.0
// How light and how dark the parts of patches are, seen from afar. At each place of a tile stand
// few patches, one a colour; where they are lighter or darker than the sample in the mean, all
// tiles are, and a plane shows a grid.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/textures/tile_sample.h"

namespace texgraph::textures {

class PatchShades {
 public:
  // At this scale of the sample; `tile_size` in texels of scale 0, at least 2.
  PatchShades(const TileSample& sample, uint32_t scale, uint32_t tile_size);

  // The next patch: around `middle`, in texels of scale 0, a square as large as a tile; with
  // `is_edge` only where it is nearer to an edge there than to those that stand on it.
  void Add(TexelPlace middle, bool is_edge);
  // Of two patches, the sum of what each of their parts differs from the sample, multiplied.
  // Summed over all pairs of a set in both orders, and over the patches with themselves, it is the
  // grid's strength.
  double Product(size_t i, size_t j) const;

 private:
  const TileSample& sample_;
  uint32_t scale_;
  int64_t tile_size_;
  std::vector<int64_t> means_;                // of the sample's channels
  std::vector<std::vector<int32_t>> shades_;  // of each patch: part by part, all channels
};

}  // namespace texgraph::textures
