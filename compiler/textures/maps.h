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
#include "compiler/textures/image.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

// Every number up to it is a float.
inline constexpr int32_t kMaxMapNumber = 1 << 24;

struct NumberMap {
  uint32_t width = 0;
  uint32_t height = 0;
  std::vector<int32_t> numbers;  // -1 to kMaxMapNumber; row 0 is v = 0

  int32_t At(uint32_t x, uint32_t y) const { return numbers[size_t{y} * width + x]; }
  bool operator==(const NumberMap&) const = default;
};

// A map from rows as people write them, the first at the top. All have equally many numbers.
NumberMap MapOfRows(std::span<const std::vector<int32_t>> rows);

// A map from a picture. With a legend a texel's number is the index of its colour there (in the
// picture's own numbers; alpha is not compared, 16-bit samples are those of 8 times 257). Without
// one the picture has to be grey and its samples are the numbers. Transparent texels (alpha 0) are
// -1. Reported, naming `name` and the first texel that is wrong: kBadImage.
std::optional<NumberMap> MapOfImage(const Image& image,
                                    std::span<const std::array<uint8_t, 3>> legend,
                                    std::string_view name, SourceRange range,
                                    Diagnostics& diagnostics);

// Row i, counted from v = 0, is list i. Lists may have different lengths if each divides the
// longest: shorter ones are repeated, so that a number's share is the same. No list is empty.
// Nothing if a length does not divide the longest.
std::optional<NumberMap> MapOfLists(std::span<const std::vector<int32_t>> lists);

// The first number that is not below `count` (nor below -1), as its index in `numbers`; nothing if
// all are good.
std::optional<size_t> FindOutOfRange(const NumberMap& map, uint32_t count);

// How often each of `count` patterns is drawn if all rows of the map are drawn equally often; -1
// and numbers beyond `count` are left out. The sum is 1, or 0 if nothing is drawn.
std::vector<double> PatternWeights(const NumberMap& map, uint32_t count);

// kR16F if all numbers are at most 2,048, else kR32F. One level, nearest.
TextureData MapTexture(const NumberMap& map, ir::Wrap wrap_u = ir::Wrap::kRepeat,
                       ir::Wrap wrap_v = ir::Wrap::kRepeat);

}  // namespace texgraph::textures
