// SPDX-License-Identifier: Apache-2.0
// What the writer and the reader of KTX 2.0 files share: where things stand, and which of Vulkan's
// formats texgraph's are.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/textures/texels.h"

namespace texgraph::textures::ktx2 {

inline constexpr std::string_view kIdentifier("\xabKTX 20\xbb\r\n\x1a\n", 12);
// The identifier, nine numbers that say what the texture is, and the index of the sections.
inline constexpr size_t kHeaderBytes = 80;
inline constexpr size_t kLevelIndexBytes = 24;  // offset, length, uncompressed length
inline constexpr std::string_view kOrientation = "KTXorientation";

struct Format {
  TexelFormat format;
  uint32_t vulkan;    // VkFormat
  uint32_t channels;  // each of the same size
  bool is_float;
};

inline constexpr std::array<Format, 7> kFormats = {{
    {TexelFormat::kRgba8, 37, 4, false},        // VK_FORMAT_R8G8B8A8_UNORM
    {TexelFormat::kSrgb8Alpha8, 43, 4, false},  // VK_FORMAT_R8G8B8A8_SRGB
    {TexelFormat::kRgba16, 91, 4, false},       // VK_FORMAT_R16G16B16A16_UNORM
    {TexelFormat::kRgba16F, 97, 4, true},       // VK_FORMAT_R16G16B16A16_SFLOAT
    {TexelFormat::kRgba32F, 109, 4, true},      // VK_FORMAT_R32G32B32A32_SFLOAT
    {TexelFormat::kR16F, 76, 1, true},          // VK_FORMAT_R16_SFLOAT
    {TexelFormat::kR32F, 100, 1, true},         // VK_FORMAT_R32_SFLOAT
}};

inline const Format& FormatOf(TexelFormat format) {
  return *std::ranges::find(kFormats, format, &Format::format);
}

inline uint32_t ChannelBytes(const Format& format) {
  return TexelBytes(format.format) / format.channels;
}

// Levels begin at multiples of the texel's size and of 4: all sizes here are powers of two.
inline uint64_t AlignUp(uint64_t offset, const Format& format) {
  const uint64_t alignment = std::max(TexelBytes(format.format), 4u);
  return (offset + alignment - 1) / alignment * alignment;
}

// Between the file's byte order, little-endian, and the machine's.
inline void SwapOnBigEndian(uint8_t* bytes, size_t count, uint32_t channel_bytes) {
  if constexpr (std::endian::native == std::endian::big) {
    for (size_t i = 0; i + channel_bytes <= count; i += channel_bytes)
      std::reverse(bytes + i, bytes + i + channel_bytes);
  }
}

}  // namespace texgraph::textures::ktx2
