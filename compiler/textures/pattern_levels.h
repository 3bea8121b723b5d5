// SPDX-License-Identifier: Apache-2.0
// Mip levels of an array of patterns that stand beside each other, one to a tile, in any order:
// levels whose borders fit whatever the neighbour is, and levels that fade to the mean of all
// patterns where a pixel is as large as a tile. docs/decisions/0020-pattern-arrays.md has the why.
#pragma once

#include <span>
#include <vector>

#include "compiler/ir/texture.h"

namespace texgraph::textures {

// The shares of `layers` patterns, with the sum 1: equal ones if there are not as many weights, or
// if their sum is not above 0.
std::vector<double> LayerShares(std::span<const double> weights, size_t layers);

// Patterns that stand beside each other are a group; `groups` has for each layer the first layer of
// its group. Without it, all are one. Changes every layer of a group near its borders, in levels of
// 2x2 texels or more, so that a tiling of the group's patterns, sampled bilinearly with wrap
// repeat, has no jump in value at any border (in levels of 4 texels a side and less: none that is
// larger in the mean than the differences inside of the patterns in steps of half a texel or more),
// and none in slope that is larger in the mean than those inside, as far as that can be had: the
// outermost texels alone where that is enough, more where it is not. Numbers stay within 0 to 1.
// Level 0 stays as it is if its outermost texels are equal in all layers of a group. Where alpha is
// opacity, it weighs the colours of the mean that texels are moved to. Layers alone in their group
// stay as they are.
void MatchEdges(ir::Texture& patterns, std::span<const double> shares, bool alpha_is_opacity,
                std::span<const uint32_t> groups = {});

// Gives all layers of the 1x1 level the mean of all patterns, and lets the level before it go there
// part of the way. Level 0 stays as it is.
void MixCoarsestLevels(ir::Texture& patterns, std::span<const double> shares,
                       bool alpha_is_opacity);

// Mean absolute differences at borders of two different layers, as parts of those inside of the
// layers along the same axis, over all channels: of the two axes the larger. 0 where there are none
// at borders, infinity where there are none inside.
struct BorderRatios {
  double values = 0;  // the larger of steps of a texel, and of half a texel of the filter's
  double slopes = 0;  // the larger of second differences, and of jumps of the bilinear slope
};
BorderRatios MeasureBorders(const ir::Texture::Level& level);

}  // namespace texgraph::textures
