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

// Pictures have four channels: grey is spread to red, green and blue; a missing alpha is 1. Maps of
// numbers (maps.h) have one; a shader reads them as (number, 0, 0, 1). Noise and its statistics are
// halves, which have signs and do not clip.
enum class TexelFormat : uint8_t {
  kRgba8,
  kSrgb8Alpha8,
  kRgba16,
  kRgba16F,
  kRgba32F,
  kR16F,
  kR32F
};

struct TexelLevel {
  uint32_t width = 1;
  uint32_t height = 1;
  uint32_t depth = 1;  // slices of a 3D texture; 1 else, also for an array
  // Row 0 is v = 0; x fastest, then y, then slice or layer; in the machine's byte order.
  std::vector<uint8_t> bytes;
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
  ir::Wrap wrap_w = ir::Wrap::kRepeat;  // of a 3D texture
  bool is_array = false;
  bool is_3d = false;     // the images are slices, from w = 0 up; mip levels are 2x2x2
  bool as_float = false;  // kRgba32F, with no rounding at all; for comparing filters
  // For arrays whose layers are patterns that stand beside each other: pattern_levels.h.
  bool match_edges = false;
  // Of the edges that match: as MatchEdges has it. None: all patterns are one group.
  std::vector<uint32_t> edge_groups;
  // How often each layer is drawn; none: the levels are those of each layer alone. As many as
  // layers, none negative, the sum above 0; only their ratios count.
  std::vector<double> weights;
};

struct TextureData {
  TexelFormat format = TexelFormat::kRgba8;
  uint32_t layers = 1;  // of an array; 1 else
  bool is_array = false;
  bool is_3d = false;
  std::vector<TexelLevel> levels;  // at least one
  ir::SamplerState sampler;
};

uint32_t TexelBytes(TexelFormat format);

// 8-bit images become kSrgb8Alpha8 or kRgba8. 16-bit ones become kRgba16, decoded first if they are
// sRGB, since GL has no sRGB format of 16 bits. `layers` has one image unless `options.is_array` or
// `options.is_3d`.
// Reported, naming `name`: layers of different sizes (kBadImage), kSizeLimit and kOutOfMemory.
std::optional<TextureData> MakeTexture(std::span<const Image> layers, const TextureOptions& options,
                                       std::string_view name, SourceRange range,
                                       Diagnostics& diagnostics);

// What a GPU sees in `data`, decoded to linear floats.
ir::Texture ToTexture(const TextureData& data);

}  // namespace texgraph::textures
