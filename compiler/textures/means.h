// SPDX-License-Identifier: Apache-2.0
// What a map of patterns or materials looks like from so far away that only mean colours are left:
// the mean of each pattern, of each list of patterns, and a texture that has them for each cell of
// a map, with mip levels. Means weigh a colour by its opacity where alpha is opacity.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/maps.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

inline constexpr uint32_t kMeansTexelsPerCell = 8;
inline constexpr uint32_t kMaxMeansSide = 1024;

// Linear light, straight alpha.
using MeanColor = std::array<float, 4>;

// The mean of each layer's level 0, as a shader sees it.
std::vector<MeanColor> PatternMeans(const TextureData& patterns, bool alpha_is_opacity);

// The mean of each row of `lists`, whose numbers are indices of `patterns`. -1 counts as
// transparent where alpha is opacity, and is left out where it is not.
std::vector<MeanColor> ListMeans(const NumberMap& lists, std::span<const MeanColor> patterns,
                                 bool alpha_is_opacity);

// kRgba16, linear, repeat, with mip levels. The numbers of `map` are indices of `means`; -1, and
// what is no index, is transparent (0 in every channel where alpha is not opacity).
// `dithered`: one texel a cell, at its middle. Else kMeansTexelsPerCell each way or, where the
// texture would be larger than kMaxMeansSide, the largest power of two less that fits, at least 1.
// Reported, naming `name`: kSizeLimit, kOutOfMemory.
std::optional<TextureData> MeansTexture(const NumberMap& map, std::span<const MeanColor> means,
                                        bool dithered, bool alpha_is_opacity, std::string_view name,
                                        SourceRange range, Diagnostics& diagnostics);

}  // namespace texgraph::textures
