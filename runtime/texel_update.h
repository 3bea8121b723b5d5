// SPDX-License-Identifier: Apache-2.0
// Some texels of a texture that is on the GPU, to be changed while it stays there. Coarser levels
// are not made anew: textures that are changed have one level as a rule, as maps have.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/texels.h"

namespace texgraph::runtime {

struct TexelUpdate {
  std::string texture;  // its name in the graph
  uint32_t level = 0;
  uint32_t x = 0;  // the left lower texel: row 0 is v = 0
  uint32_t y = 0;
  uint32_t layer = 0;  // of an array; a slice of a 3D texture
  uint32_t width = 1;
  uint32_t height = 1;
  // In the texture's format (textures::TexelFormat), x fastest, rows from the lowest up.
  std::vector<uint8_t> texels;
};

// Whether `data` has all of these texels, and as many bytes are there for them. Reported:
// kValueRange.
bool CheckUpdate(const TexelUpdate& update, const textures::TextureData& data,
                 Diagnostics& diagnostics);

// Sets the texels to whole numbers, -1 for nothing, in the format of a map. Reported: kPortType if
// `data` is no map of numbers, kValueRange for a number below -1, not below `count` or beyond what
// the format holds.
bool EncodeNumbers(std::span<const int32_t> numbers, const textures::TextureData& data,
                   std::optional<uint32_t> count, TexelUpdate& update, Diagnostics& diagnostics);

}  // namespace texgraph::runtime
