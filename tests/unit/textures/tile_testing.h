// SPDX-License-Identifier: Apache-2.0
// Samples for tests of tile sets.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "compiler/textures/image.h"
#include "compiler/textures/tile_set.h"
#include "tests/unit/textures/texture_testing.h"

namespace texgraph::textures::test {

// Grass of a kind: random strokes over one another, some fine noise. Periodic.
inline Image StrokesImage(uint32_t width, uint32_t height, uint8_t channels, uint8_t bits,
                          uint32_t seed) {
  std::mt19937 random(seed);
  const auto below = [&](uint32_t n) { return static_cast<uint32_t>(random() % n); };
  const uint32_t most = bits == 8 ? 255 : 65535;
  std::vector<uint32_t> samples(size_t{width} * height * channels, most / 3);
  for (uint32_t stroke = 0; stroke < width * height / 12; ++stroke) {
    const uint32_t x0 = below(width);
    const uint32_t y0 = below(height);
    const uint32_t length = 4 + below(10);
    const double lean = below(1000) / 1000.0 - 0.5;
    std::vector<uint32_t> color(channels);
    for (uint32_t& value : color) value = most / 8 + below(most * 3 / 4);
    for (uint32_t i = 0; i < length; ++i) {
      const auto x = static_cast<uint32_t>(x0 + width + std::lround(lean * i)) % width;
      const uint32_t y = (y0 + i) % height;
      for (uint32_t c = 0; c < channels; ++c)
        samples[(size_t{y} * width + x) * channels + c] = color[c];
    }
  }
  for (uint32_t& value : samples) value = std::min(value + below(most / 16), most);
  return MakeImage(width, height, channels, bits, samples);
}

inline TileSetOptions SmallTiles(TileKind kind, std::array<uint32_t, 2> colors, uint32_t size) {
  TileSetOptions options;
  options.kind = kind;
  options.colors = colors;
  options.tile_size = size;
  options.candidates = 24;
  options.seed = 5;
  options.threads = 1;
  return options;
}

// Counted from the left bottom corner; around the image if it lies outside.
inline uint32_t UpAt(const Image& image, int64_t x, int64_t y, uint32_t channel) {
  const int64_t width = image.width;
  const int64_t height = image.height;
  x = (x % width + width) % width;
  y = (y % height + height) % height;
  return image.At(static_cast<uint32_t>(x), static_cast<uint32_t>(height - 1 - y), channel);
}

inline uint32_t TileTexel(const Image& pack, const TilePackLayout& layout, TilePlace tile,
                          int64_t x, int64_t y, uint32_t channel) {
  return UpAt(pack, int64_t{tile.x} * layout.tile_size + x,
              int64_t{tile.y} * layout.tile_size + layout.gutter + y, channel);
}

inline std::vector<TileColors> AllTiles(const TilePackLayout& layout) {
  std::vector<TileColors> tiles;
  for (uint32_t y = 0; y < layout.rows; ++y) {
    for (uint32_t x = 0; x < layout.columns; ++x) tiles.push_back(TileAt(layout, x, y));
  }
  return tiles;
}

}  // namespace texgraph::textures::test
