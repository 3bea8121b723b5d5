// SPDX-License-Identifier: Apache-2.0
// A drawn output as the bytes of an OpenEXR file: the shader's own numbers, linear and unclamped,
// alpha not multiplied in, one part of scan lines from the top. Channels are Y, or R, G, B and A as
// far as the output has them. The same pixels give the same bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace texgraph::runtime {

enum class ExrDepth : uint8_t {
  kHalf,  // rounded to the nearest, ties to even; beyond 65520 is infinity
  kFloat
};

// Four floats for each pixel, the bottom row first, as kFloat of render.h; the first `channels` (1
// to 4) are written. Nothing if there are no pixels or memory ran out.
std::optional<std::string> EncodeExr(std::span<const float> pixels, uint32_t width, uint32_t height,
                                     uint32_t channels, ExrDepth depth);

}  // namespace texgraph::runtime
