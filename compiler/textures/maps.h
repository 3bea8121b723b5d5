// SPDX-License-Identifier: Apache-2.0
// Maps of whole numbers: of patterns, materials, lists. As textures they hold the numbers
// themselves as floats, read at the nearest texel, so that a shader decodes nothing; -1 is empty.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/number_map.h"
#include "compiler/textures/image.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

// Every number up to it is a float.
inline constexpr int32_t kMaxMapNumber = 1 << 24;

// A map from a picture. With a legend a texel's number is the index of its colour there (in the
// picture's own numbers; alpha is not compared, 16-bit samples are those of 8 times 257). Without
// one the picture has to be grey and its samples are the numbers. Transparent texels (alpha 0) are
// -1. Reported, naming `name` and the first texel that is wrong: kBadImage.
std::optional<NumberMap> MapOfImage(const Image& image,
                                    std::span<const std::array<uint8_t, 3>> legend,
                                    std::string_view name, SourceRange range,
                                    Diagnostics& diagnostics);

// The first number that is not below `count` (nor below -1), as its index in `numbers`; nothing if
// all are good.
std::optional<size_t> FindOutOfRange(const NumberMap& map, uint32_t count);

// kR16F if all numbers are at most 2,048, else kR32F. One level, nearest.
TextureData MapTexture(const NumberMap& map, ir::Wrap wrap_u = ir::Wrap::kRepeat,
                       ir::Wrap wrap_v = ir::Wrap::kRepeat);

}  // namespace texgraph::textures
