// SPDX-License-Identifier: Apache-2.0
// What seams between two patches cost, by dynamic programming over paths.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/textures/tile_sample.h"

namespace texgraph::textures {

// A square region at a scale of the sample with texel (0, 0) of two patches' tiles, or corners.
struct TilePair {
  const TileSample& sample;
  uint32_t scale;
  uint32_t side;  // of a tile, texels of the scale
  TexelPlace a;   // in texels of the scale
  TexelPlace b;
};

// `a` lies left of `b` (`stands`: below): the cost of the cheapest path between them that crosses
// row 0 (column 0) in the middle half of the tile and runs `length` texels to both sides of it.
int64_t SeamBetween(const TilePair& pair, bool stands, int64_t length);
// The path itself, in the rows from -`depth` to before `depth` (at most `length`): the first texel
// of `b` in each.
std::vector<uint32_t> SeamPath(const TilePair& pair, bool stands, int64_t length, int64_t depth);

// The cheapest path from a corner of the tile (`right`, `top`) to its middle.
int64_t SeamFromCorner(const TilePair& pair, bool right, bool top);

// The cheapest path from a corner of the tile between an edge that lies, with patch `a`, and one
// that stands, with `b`, through the wedge between half and twice their distances: for `depth` rows
// away from the edge that lies, how many texels, counted from the edge that stands, are of `b`.
// None of the first row is, and no row has fewer than the one before it, or more than `depth`.
std::vector<uint32_t> SeamAtCorner(const TilePair& pair, bool right, bool top, int64_t depth);

// The mean difference within `reach` texels of their common (0, 0), times the texels of a seam from
// a corner to the middle.
int64_t MismatchAround(const TilePair& pair, int64_t reach);

}  // namespace texgraph::textures
