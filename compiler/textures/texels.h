// SPDX-License-Identifier: Apache-2.0
// Images as a texture: the exact numbers that are uploaded to the GPU, all mip levels included, and
// the same numbers for the CPU evaluator. Levels are averaged in linear light and then stored in
// the texture's format, here and not by the driver, so that every machine sees the same texels.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/ir/texture.h"
#include "compiler/textures/image.h"

namespace texgraph::textures {

// Always four channels: grey is spread to red, green and blue; a missing alpha is 1.
enum class TexelFormat : uint8_t { kRgba8, kSrgb8Alpha8, kRgba16, kRgba32F };

struct TexelLevel {
  uint32_t width = 1;
  uint32_t height = 1;
  std::vector<uint8_t>
      bytes;  // row 0 is v = 0; x fastest, then y, then layer; in the machine's byte order
};

struct TextureOptions {
  bool srgb = true;  // the numbers of the image are sRGB, not linear; alpha is always linear
  // Alpha says how much of a texel there is: mip levels average colours weighted by it, so that
  // what is transparent tints nothing. Else it is a number like the others.
  bool alpha_is_opacity = false;
  bool mipmaps = true;
  std::optional<uint32_t> max_level;        // the coarsest level that is made
  ir::Filter filter = ir::Filter::kLinear;  // nearest also picks the nearest mip level
  ir::Wrap wrap_u = ir::Wrap::kRepeat;
  ir::Wrap wrap_v = ir::Wrap::kRepeat;
  bool is_array = false;
  bool as_float = false;  // kRgba32F, with no rounding at all; for comparing filters
};

struct TextureData {
  TexelFormat format = TexelFormat::kRgba8;
  uint32_t layers = 1;
  bool is_array = false;
  std::vector<TexelLevel> levels;  // at least one
  ir::SamplerState sampler;
};

uint32_t TexelBytes(TexelFormat format);

// 8-bit images become kSrgb8Alpha8 or kRgba8. 16-bit ones become kRgba16, decoded first if they are
// sRGB, since GL has no sRGB format of 16 bits. `layers` has one image unless `options.is_array`.
// Reported, naming `name`: layers of different sizes (kBadImage), kSizeLimit and kOutOfMemory.
std::optional<TextureData> MakeTexture(std::span<const Image> layers, const TextureOptions& options,
                                       std::string_view name, SourceRange range,
                                       Diagnostics& diagnostics);

// What a GPU sees in `data`, decoded to linear floats.
ir::Texture ToTexture(const TextureData& data);

}  // namespace texgraph::textures
