// SPDX-License-Identifier: Apache-2.0
// Divides one tile among the patches of its corners or edges, and one of its own in its middle if
// it is to have one.
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
  std::vector<TexelPlace> middles;  // one becomes patch kMiddlePatch, if there are any
};

struct LabelledTile {
  std::vector<uint8_t> labels;      // x fastest, rows upwards
  std::vector<TexelPlace> patches;  // the task's, and that of the middle if there is one
};

// How many scales of the sample LabelTile needs.
uint32_t ScalesOfTile(uint32_t size);

// What the seams of the tile cost if it is cut at this scale alone, without a patch of its own.
int64_t SeamsOfTile(const TileSample& sample, const TileTask& task, uint32_t scale);
// `sample` has ScalesOfTile(task.size) scales at least.
LabelledTile LabelTile(const TileSample& sample, const TileTask& task);

}  // namespace texgraph::textures
