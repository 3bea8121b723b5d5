// SPDX-License-Identifier: Apache-2.0
// Complete sets of square tiles made of one sample, which may have several maps (colour, normals,
// height) that are cut alike: a tiling by the colours (tile_packing.h) looks like the sample and
// has no jumps at the borders. Every texel of a tile is one of the sample's, unchanged but
// for the shade that `even` takes away; only combinations are new: each tile is divided among patches of the sample, one a colour, along cuts
// of least cost (Kwatra et al. 2003). The same input gives the same tiles on every machine and with
// any number of threads. docs/decisions/0022-tile-sets.md has the why.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/image.h"
#include "compiler/textures/tile_packing.h"

namespace texgraph::textures {

inline constexpr uint32_t kMaxTileCandidates = 1024;

struct TileSetOptions {
  TileKind kind = TileKind::kCorner;
  std::array<uint32_t, 2> colors{2, 2};  // as in TilePackLayout
  uint32_t tile_size = 256;              // texels
  bool wraps = false;                    // the sample is periodic itself
  uint32_t seed = 0;
  uint32_t candidates = 256;  // patches among which the best are searched
  // Each tile also has a patch of its own in its middle. Without, a tile has only what all tiles
  // with one of its colours have: that repeats, but it has the fewest seams. For samples without
  // order.
  bool own_middles = false;
  // Patches are also chosen so that the light parts of one are the dark parts of others: else what
  // is light in all of them comes again in every tile, a grid seen from afar. What is left of the
  // grid is then taken away as a soft shade (tile_evening.h). For samples without order.
  bool even = false;
  uint32_t threads = 0;  // 0: as many as there are cores
};

// How visible the seams are: mean absolute differences of texels on both sides of a seam, as parts
// of those of neighbours in the sample along the same axis. 1 is what the sample has itself.
struct TileSetQuality {
  struct Edge {
    bool stands;      // from a lower to an upper corner
    uint32_t first;   // kCorner: the colours of its left (lower) and right (upper) corner;
    uint32_t second;  // kWang: both the colour of the edge
    double ratio;     // of the seams that go out from it, in all its tiles; 0: there are none
  };
  std::vector<Edge> edges;
  std::vector<double> tiles;  // of all seams of the tile at x + y * columns
  double mean = 0;            // of all seams
};

struct TileSet {
  TilePackLayout layout;
  std::vector<Image> packs;  // one a map, with its channels and bits
  // Left bottom texel, from the sample's left bottom corner, of the patch of each colour. kCorner:
  // 2 tile sizes a side around the corner; kWang: first those of edges that lie, then those of
  // edges that stand, 2 tile sizes long across the edge and 1 along it. May lie outside the sample
  // as far as the patch is not used there.
  std::vector<std::array<int64_t, 2>> patches;
  TileSetQuality quality;
};

// Shares from 0 to 1, never falling, never two calls at a time, from any thread.
using TileProgress = std::function<void(double)>;

// The least side of a sample for tiles of this size, and the largest tile for a sample. A sample
// that has room for one patch alone would give all colours the same one.
uint32_t LeastSample(uint32_t tile_size, bool wraps);
uint32_t LargestTileOfSample(uint32_t width, uint32_t height, bool wraps);

// False, with all that is wrong reported and what would do: kSizeLimit for colours, candidates and
// packs beyond the limits, kBadImage for a sample that is too small.
// `maps`: of one material, which all have a pack.
bool CheckTileSet(const TileSetOptions& options, uint32_t sample_width, uint32_t sample_height,
                  std::string_view name, SourceRange range, Diagnostics& diagnostics,
                  uint64_t maps = 1);

// `weights`: how much each map counts where seams are searched; none, or none above 0: all
// alike. Reported, naming `name`: all of CheckTileSet, kBadImage for no maps or maps of different
// sizes, kSizeLimit, kOutOfMemory.
std::optional<TileSet> MakeTileSet(std::span<const Image> maps, std::span<const double> weights,
                                   const TileSetOptions& options, std::string_view name,
                                   SourceRange range, Diagnostics& diagnostics,
                                   const TileProgress& progress = {});

}  // namespace texgraph::textures
