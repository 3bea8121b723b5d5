// SPDX-License-Identifier: Apache-2.0
// Pictures made of numbers, for tests of textures.
#pragma once

#include <string.h>

#include <cstdint>
#include <random>
#include <vector>

#include "compiler/textures/image.h"

namespace texgraph::textures::test {

// Samples row by row from the top, channels interleaved.
inline Image MakeImage(uint32_t width, uint32_t height, uint8_t channels, uint8_t bits,
                       const std::vector<uint32_t>& samples) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = channels;
  image.bits = bits;
  image.pixels.resize(samples.size() * bits / 8);
  for (size_t i = 0; i < samples.size(); ++i) {
    if (bits == 8) {
      image.pixels[i] = static_cast<uint8_t>(samples[i]);
    } else {
      const auto deep = static_cast<uint16_t>(samples[i]);
      memcpy(&image.pixels[2 * i], &deep, 2);
    }
  }
  return image;
}

inline Image RandomImage(uint32_t width, uint32_t height, uint8_t channels, uint8_t bits,
                         uint32_t seed) {
  std::mt19937 random(seed);
  std::vector<uint32_t> samples(size_t{width} * height * channels);
  for (uint32_t& sample : samples) sample = static_cast<uint32_t>(random()) >> (32 - bits);
  return MakeImage(width, height, channels, bits, samples);
}

}  // namespace texgraph::textures::test
