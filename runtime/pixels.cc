// SPDX-License-Identifier: Apache-2.0
#include "runtime/pixels.h"

#include <string.h>

#include <cmath>

#include "compiler/textures/srgb.h"

namespace texgraph::runtime {
namespace {

using textures::SrgbEncode16;
using textures::SrgbEncode8;
using textures::Unorm16;
using textures::Unorm8;

// One sample of a picture; `light`: through the sRGB curve.
uint8_t Sample8(float value, bool light) { return light ? SrgbEncode8(value) : Unorm8(value); }
uint16_t Sample16(float value, bool light) { return light ? SrgbEncode16(value) : Unorm16(value); }

void StorePixel(const float* from, const PictureTarget& target, uint8_t* to) {
  for (uint32_t c = 0; c < target.image_channels; ++c) {
    float value = c < target.channels ? from[c] : 0.0f;
    if (target.encoding == Encoding::kNormal) value = 0.5f * value + 0.5f;
    const bool light = target.encoding == Encoding::kSrgb && c < 3;
    if (target.format == PixelFormat::kImage8) {
      to[c] = Sample8(value, light);
    } else {
      const uint16_t sample = Sample16(value, light);
      memcpy(to + 2 * c, &sample, sizeof sample);
    }
  }
}

bool HasNan(const float* pixel, uint32_t channels) {
  for (uint32_t c = 0; c < channels; ++c) {
    if (std::isnan(pixel[c])) return true;
  }
  return false;
}

}  // namespace

Encoding EncodingOf(std::string_view output) {
  if (output == "color" || output == "emission" || output == kLitOutput) return Encoding::kSrgb;
  return output == "normal" ? Encoding::kNormal : Encoding::kLinear;
}

uint64_t StorePixels(const PixelRows& rows, const PictureTarget& target) {
  const bool floats = target.format == PixelFormat::kFloat;
  const size_t sample = floats ? 4 : target.format == PixelFormat::kImage16 ? 2 : 1;
  const size_t pixel_bytes = target.image_channels * sample;
  uint64_t nan_pixels = 0;
  for (uint32_t row = 0; row < rows.height; ++row) {
    const uint32_t from_bottom = rows.y + row;
    const uint32_t y = floats ? from_bottom : target.height - 1 - from_bottom;
    const float* from = rows.floats + size_t{row} * rows.width * 4;
    uint8_t* to = target.pixels + (size_t{y} * target.width + rows.x) * pixel_bytes;
    for (uint32_t x = 0; x < rows.width; ++x, from += 4, to += pixel_bytes) {
      if (HasNan(from, target.channels)) ++nan_pixels;
      if (floats) {
        memcpy(to, from, 4 * sizeof(float));
      } else {
        StorePixel(from, target, to);
      }
    }
  }
  return nan_pixels;
}

}  // namespace texgraph::runtime
