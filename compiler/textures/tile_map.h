// SPDX-License-Identifier: Apache-2.0
// A tiling that was made before: for each cell the place of its tile in the pack.
#pragma once

#include <cstdint>

#include "compiler/base/number_map.h"
#include "compiler/textures/tile_packing.h"

namespace texgraph::textures {

// The colours that the blocks corner_tiles and wang_tiles draw: of the corner at the left bottom of
// a cell; of the edge that lies at its bottom, and of the one that stands at its left.
uint32_t DrawnCorner(int32_t x, int32_t y, uint32_t seed, uint32_t colors);
std::array<uint32_t, 2> DrawnEdges(int32_t x, int32_t y, uint32_t seed,
                                   std::array<uint32_t, 2> colors);

// Closes on a torus: x + y * columns of the place in the pack, for each of width x height cells.
NumberMap MakeTileMap(const TilePackLayout& layout, uint32_t width, uint32_t height, uint32_t seed);

}  // namespace texgraph::textures
