// SPDX-License-Identifier: Apache-2.0
// What texgraph tiles says of a set: to programs, and to people.
#pragma once

#include <string>
#include <vector>

#include "cli/texgraph/tiles_files.h"
#include "compiler/textures/tile_set.h"

namespace texgraph::cli {

// The coarsest mip level of a pack that shows the tiling: two texels a tile, or more if its size is
// no power of two. What is coarser depends on how the tiles stand in the pack.
uint32_t LastTileLevel(uint32_t tile_size);

// The JSON file; docs/by_example.md describes it. Files are named from its folder.
std::string TilesJson(const textures::TileSet& set, const std::vector<std::string>& maps,
                      const TilesFiles& files);

// Tables of the seams' ratios, by edge and by tile, as the tiles stand in the pack.
std::string TilesReport(const textures::TileSet& set);

}  // namespace texgraph::cli
