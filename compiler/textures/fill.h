// SPDX-License-Identifier: Apache-2.0
// Colours for texels that have none, smoothly from those around them: pull-push interpolation
// (Gortler, Grzeszczuk, Szeliski, Cohen, The Lumigraph, SIGGRAPH 1996, section 3.4). Linear in the
// number of texels, and the same on every machine.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace texgraph::textures {

// Each texel is a colour times its weight, and the weight: 1 where the colour is known, 0 where it
// is not, between where it is little more than a guess. Afterwards all have a colour and the weight
// 1, those of weight 1 their own. False, with nothing changed, if all weights are 0.
bool FillColors(std::vector<std::array<float, 4>>& texels, uint32_t width, uint32_t height);

}  // namespace texgraph::textures
