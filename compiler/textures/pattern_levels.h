// SPDX-License-Identifier: Apache-2.0
// Mip levels of an array of patterns that stand beside each other, one to a tile, in any order:
// levels whose borders fit whatever the neighbour is, and levels that fade to the mean of all
// patterns where a pixel is as large as a tile. docs/decisions/0020-pattern-arrays.md has the why.
#pragma once

#include <span>
#include <vector>

#include "compiler/ir/texture.h"

namespace texgraph::textures {

// The shares of `layers` patterns, with the sum 1: equal ones if `weights` has not as many.
std::vector<double> LayerShares(std::span<const double> weights, size_t layers);

// Moves the outermost texels of every layer and level so that a tiling of the patterns, sampled
// bilinearly with wrap repeat, has no jump in value at any border, and none in slope that is larger
// in the mean than inside of the patterns: levels of 2x2 texels or more. Colours stay within 0
// to 1. Patterns that have equal outermost texels keep them. Colours that alpha weighs
// (`alpha_is_opacity`) have a mean that is weighed so.
void MatchEdges(ir::Texture& patterns, std::span<const double> shares, bool alpha_is_opacity);

// Gives all layers of the 1x1 level the mean of all patterns, and lets the level before it go there
// part of the way.
void MixCoarsestLevels(ir::Texture& patterns, std::span<const double> shares,
                       bool alpha_is_opacity);

// Mean absolute differences of neighbours at borders of two different layers, as parts of those
// inside: of values, and of slopes. 0 where both are 0, infinity where only those inside are.
struct BorderRatios {
  double values = 0;
  double slopes = 0;
};
BorderRatios MeasureBorders(const ir::Texture::Level& level);

}  // namespace texgraph::textures
