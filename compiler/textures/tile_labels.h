// SPDX-License-Identifier: Apache-2.0
// Divides one tile among the patches of its corners or edges, and one more in its middle where that
// makes seams cheaper.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "compiler/textures/tile_packing.h"
#include "compiler/textures/tile_sample.h"

namespace texgraph::textures {

inline constexpr uint32_t kMiddlePatch = 4;

struct TileTask {
  TileKind kind = TileKind::kCorner;
  uint32_t size = 0;                // texels
  std::vector<TexelPlace> patches;  // where texel (0, 0) lies in the sample for each label
  // Corner tiles: SeamOverBorder of the borders at the south, east, north and west.
  std::array<std::span<const uint32_t>, 4> borders;
  std::vector<TexelPlace> middles;  // tried as patch kMiddlePatch
};

struct LabelledTile {
  std::vector<uint8_t> labels;      // x fastest, rows upwards
  std::vector<TexelPlace> patches;  // the task's, and that of the middle if it is used
};

// How many scales of the sample LabelTile needs.
uint32_t ScalesOfTile(uint32_t size);

// `sample` has ScalesOfTile(task.size) scales at least.
LabelledTile LabelTile(const TileSample& sample, const TileTask& task);

}  // namespace texgraph::textures
