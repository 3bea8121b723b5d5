// SPDX-License-Identifier: Apache-2.0
// Takes away what all tiles of a set have in common: where they are lighter than the set at the
// same place of each, a plane of them shows a grid from afar. Each texel gets as much darker as the
// mean of all tiles around its place is too light. The shade is soft and the same in all tiles, and
// goes on over their borders, so tiles fit as before.
#pragma once

#include <span>

#include "compiler/textures/image.h"
#include "compiler/textures/tile_packing.h"

namespace texgraph::textures {

// The packs of a set, gutters not yet filled. Channels are evened each for itself, as numbers.
void EvenTiles(const TilePackLayout& layout, std::span<Image> packs);

}  // namespace texgraph::textures
