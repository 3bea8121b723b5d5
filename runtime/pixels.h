// SPDX-License-Identifier: Apache-2.0
// The shader's numbers as the samples of a picture. docs/rendering.md gives the meanings.
#pragma once

#include <cstdint>
#include <string_view>

#include "runtime/render.h"

namespace texgraph::runtime {

enum class Encoding : uint8_t {
  kLinear,  // as it is
  kSrgb,    // linear light to sRGB; a fourth channel as it is
  kNormal   // -1..1 to 0..1
};

// By the output's name: color, emission and lit are light, normal is a direction.
Encoding EncodingOf(std::string_view output);

// Rows that were read from a framebuffer (RGBA floats, the bottom row first) into a picture.
struct PixelRows {
  const float* floats;  // 4 for each pixel
  uint32_t width;
  uint32_t height;
  uint32_t x;  // of the first pixel in the whole picture, from the left bottom corner
  uint32_t y;
};
struct PictureTarget {
  uint8_t* pixels;  // as textures::Image, or floats from the bottom row up
  uint32_t width;
  uint32_t height;
  uint32_t channels;        // of the shader's output
  uint32_t image_channels;  // of the picture; 4 for floats
  PixelFormat format;
  Encoding encoding;
};
// Returns how many pixels have a NaN among the shader's channels; in pictures NaN becomes 0.
uint64_t StorePixels(const PixelRows& rows, const PictureTarget& target);

}  // namespace texgraph::runtime
