// SPDX-License-Identifier: Apache-2.0
// Reads PNG and JPEG files that may come from strangers, and writes PNG. Only regular files are
// opened, the size is judged from the header before anything is allocated, and a damaged file is an
// error, never half a picture. What a file says of its own colour (gamma, profiles) and orientation
// is not looked at: the graph says what its numbers mean.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/roots.h"
#include "compiler/base/source.h"

namespace texgraph::textures {

inline constexpr uint64_t kMaxImagePixels = uint64_t{1} << 26;
inline constexpr uint64_t kMaxImageFileBytes = uint64_t{1} << 30;

struct ImageInfo {
  uint32_t width = 0;
  uint32_t height = 0;
  uint8_t channels =
      0;  // 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA; palettes and fewer bits than 8 are expanded
  uint8_t bits = 8;  // 8 or 16 for each channel
};

struct Image : ImageInfo {
  // Rows from the top, pixels from the left, channels interleaved; 16 bits as uint16_t in the
  // machine's byte order.
  std::vector<uint8_t> pixels;

  size_t RowBytes() const { return size_t{width} * channels * (bits / 8); }
  // A sample, 0 to 255 or 0 to 65535, at column x and row y from the top.
  uint32_t At(uint32_t x, uint32_t y, uint32_t channel) const;
};

// The size and format from the header alone. Reported at `range`: kMissingFile, kOutsideRoot,
// kCannotRead (also for what is no regular file), kBadImage, kSizeLimit.
std::optional<ImageInfo> ProbeImage(const std::string& path, SourceRange range,
                                    Diagnostics& diagnostics, const Roots& roots = {});
// The same checks, and the whole image; kOutOfMemory too.
std::optional<Image> ReadImage(const std::string& path, SourceRange range, Diagnostics& diagnostics,
                               const Roots& roots = {});

// The image as the bytes of a PNG file: the same image gives the same bytes. Nothing if it has no
// pixels or memory ran out.
std::optional<std::string> EncodePng(const Image& image);

}  // namespace texgraph::textures
