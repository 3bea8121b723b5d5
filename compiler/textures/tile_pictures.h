// SPDX-License-Identifier: Apache-2.0
// Pictures made of a pack of tiles: Wei's second pack for corners, a view of the set for people,
// and a tiling.
#pragma once

#include <cstdint>

#include "compiler/textures/image.h"
#include "compiler/textures/tile_packing.h"

namespace texgraph::textures {

// Wei's corner pack (appendix B) of Wang tiles: all combinations of the four edges around a corner,
// on a torus of colors[0]^2 x colors[1]^2 tiles. The corner of PackedWeiCorner is the right top one
// of its tile; within half a tile of it, all is as in the virtual texture's tiles next to their
// corner and edges.
Image MakeWeiCornerPack(const Image& pack, const TilePackLayout& layout);

// The tiles of the pack apart, with the colours of their corners or edges marked beside them. 8
// bits RGB.
Image MakeTileView(const Image& pack, const TilePackLayout& layout);

// A virtual tiling of so many tiles with random colours, as a shader would draw it.
Image MakeTiling(const Image& pack, const TilePackLayout& layout, uint32_t columns, uint32_t rows,
                 uint32_t seed);

}  // namespace texgraph::textures
