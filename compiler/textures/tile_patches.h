// SPDX-License-Identifier: Apache-2.0
// Which places of the sample the colours of a tile set stand for: random ones are tried, pairs are
// rated by the least cost of a seam between them, and sets are ranked by what their seams cost,
// kept from being the same place several times.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/textures/tile_sample.h"
#include "compiler/textures/tile_set.h"
#include "compiler/textures/tile_threads.h"

namespace texgraph::textures {

// How far from the corner or edge that it belongs to a patch is used: three quarters of a tile, so
// that the patches of two opposite ones overlap by half a tile.
inline uint32_t TileReach(uint32_t tile_size) { return (3 * tile_size + 3) / 4; }

// So near to a border all depends on its colours alone, so that filters see the same from both
// sides whatever the tiles are, in all levels with eight texels a tile and more.
inline uint32_t BorderDepth(uint32_t tile_size) { return tile_size < 8 ? 1 : tile_size / 8; }

// An independent random number for each pair of numbers.
uint32_t TileHash(uint32_t seed, uint32_t stream);

// Where texel (0, 0) of a tile lies in the sample for each of its patches, in the order of its
// colours.
std::vector<TexelPlace> PatchesOfTile(const TilePackLayout& layout,
                                      const std::vector<std::array<int64_t, 2>>& patches,
                                      const TileColors& colors);

struct PatchSet {
  // The left bottom texels of a patch for each colour, as TileSet has them.
  std::vector<std::array<int64_t, 2>> patches;
  double roughness = 0;  // mean step between neighbours in them, at the scale of the search
  double grid = 0;       // how strong it is (tile_shades.h), as part of that of random patches,
                         // if the options ask for it
};

// Sets that differ, the best first: at least one, at most `most`. Tells `work` of each pair that is
// rated.
std::vector<PatchSet> RankPatches(const TileSample& sample, const TilePackLayout& layout,
                                  const TileSetOptions& options, uint32_t scale, size_t most,
                                  TileWork& work);

// The seam over the border of two corner tiles that lies along the x axis (`stands`: along the y
// axis), from the corner of patch `from` to that of patch `to`: in the rows from -BorderDepth to
// before BorderDepth of that border, the first texel, from 0 to the tile's size, of patch `to`. On
// the best of the paths that cross the border in its middle half and run a quarter of a tile to
// both sides.
std::vector<uint32_t> SeamOverBorder(const TileSample& sample, uint32_t tile_size, bool stands,
                                     const std::array<int64_t, 2>& from,
                                     const std::array<int64_t, 2>& to);

}  // namespace texgraph::textures
