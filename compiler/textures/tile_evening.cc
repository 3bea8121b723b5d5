// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_evening.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

#include "compiler/textures/hash.h"

namespace texgraph::textures {
namespace {

// The shade has at most so many parts a side of a tile, or one a texel.
constexpr uint32_t kMostParts = 32;
// Of the Gaussian, in tiles: finer things that tiles have in common are what they are made of.
constexpr double kDeviation = 1.0 / 16;

// A square of numbers that repeats.
struct Shade {
  uint32_t side = 0;
  std::vector<double> parts;

  double At(int64_t x, int64_t y) const {
    const auto n = static_cast<int64_t>(side);
    return parts[static_cast<size_t>(((y % n + n) % n) * n + (x % n + n) % n)];
  }
  // Between the middles of parts; u and v from 0 to 1 over the tile.
  double Between(double u, double v) const {
    const double x = u * side - 0.5;
    const double y = v * side - 0.5;
    const auto left = static_cast<int64_t>(std::floor(x));
    const auto below = static_cast<int64_t>(std::floor(y));
    const double a = x - std::floor(x);
    const double b = y - std::floor(y);
    return (1 - b) * ((1 - a) * At(left, below) + a * At(left + 1, below)) +
           b * ((1 - a) * At(left, below + 1) + a * At(left + 1, below + 1));
  }
};

Shade Blurred(const Shade& shade) {
  const double deviation = kDeviation * shade.side;
  const auto reach = static_cast<int64_t>(std::ceil(4 * deviation));
  std::vector<double> weights;
  double sum = 0;
  for (int64_t i = -reach; i <= reach; ++i) {
    const double away = static_cast<double>(i) / deviation;
    sum += weights.emplace_back(std::exp(-0.5 * away * away));
  }
  Shade across{shade.side, {}};
  Shade both{shade.side, {}};
  for (uint32_t i = 0; i < shade.side * shade.side; ++i) {
    double mean = 0;
    for (int64_t k = -reach; k <= reach; ++k)
      mean +=
          weights[static_cast<size_t>(k + reach)] * shade.At(i % shade.side + k, i / shade.side);
    across.parts.push_back(mean / sum);
  }
  for (uint32_t i = 0; i < shade.side * shade.side; ++i) {
    double mean = 0;
    for (int64_t k = -reach; k <= reach; ++k)
      mean +=
          weights[static_cast<size_t>(k + reach)] * across.At(i % shade.side, i / shade.side + k);
    both.parts.push_back(mean / sum);
  }
  return both;
}

// One channel of a pack.
class Channel {
 public:
  Channel(const TilePackLayout& layout, Image& pack, uint32_t channel)
      : layout_(layout), pack_(pack), channel_(channel) {}

  void Even() const {
    const Shade common = CommonShade();
    // Once more for what the blur leaves of wide shades.
    const Shade wide = Blurred(common);
    const Shade left = Blurred(wide);
    Shade shade = wide;
    for (size_t i = 0; i < shade.parts.size(); ++i) shade.parts[i] += wide.parts[i] - left.parts[i];
    Subtract(shade);
  }

 private:
  uint8_t* Texel(uint32_t x, uint32_t y) const {
    const size_t row = pack_.height - 1 - layout_.gutter - y;
    return &pack_.pixels[row * pack_.RowBytes() +
                         (size_t{x} * pack_.channels + channel_) * (pack_.bits / 8)];
  }
  uint32_t Number(const uint8_t* texel) const {
    if (pack_.bits == 8) return *texel;
    uint16_t number;
    memcpy(&number, texel, sizeof number);
    return number;
  }

  // How much the mean of all tiles at a place is above that of all places.
  Shade CommonShade() const {
    const uint32_t size = layout_.tile_size;
    Shade shade{std::min(size, kMostParts), {}};
    shade.parts.resize(size_t{shade.side} * shade.side);
    std::vector<double> counts(shade.parts.size());
    double sum = 0;
    for (uint32_t y = 0; y < layout_.rows * size; ++y) {
      for (uint32_t x = 0; x < layout_.columns * size; ++x) {
        const size_t row = uint64_t{y % size} * shade.side / size;
        const size_t part = row * shade.side + uint64_t{x % size} * shade.side / size;
        const double number = Number(Texel(x, y));
        shade.parts[part] += number;
        counts[part] += 1;
        sum += number;
      }
    }
    const double mean = sum / static_cast<double>(uint64_t{layout_.width()} * layout_.rows * size);
    for (size_t i = 0; i < shade.parts.size(); ++i)
      shade.parts[i] = shade.parts[i] / counts[i] - mean;
    return shade;
  }

  void Subtract(const Shade& shade) const {
    const uint32_t size = layout_.tile_size;
    const double most = pack_.bits == 8 ? 255 : 65535;
    for (uint32_t place = 0; place < size * size; ++place) {
      const uint32_t x = place % size;
      const uint32_t y = place / size;
      // What is rounded up and what down changes from texel to texel, or steps would be left.
      const double rounding = TexelHash(0, channel_, x, y) * 0x1p-32;
      const double change = rounding - shade.Between((x + 0.5) / size, (y + 0.5) / size);
      for (uint32_t tile = 0; tile < layout_.tiles(); ++tile) {
        uint8_t* texel =
            Texel(tile % layout_.columns * size + x, tile / layout_.columns * size + y);
        const double number = std::clamp(std::floor(Number(texel) + change), 0.0, most);
        const auto whole = static_cast<uint16_t>(number);
        if (pack_.bits == 8) *texel = static_cast<uint8_t>(whole);
        if (pack_.bits == 16) memcpy(texel, &whole, sizeof whole);
      }
    }
  }

  const TilePackLayout& layout_;
  Image& pack_;
  uint32_t channel_;
};

}  // namespace

void EvenTiles(const TilePackLayout& layout, std::span<Image> packs) {
  for (Image& pack : packs) {
    for (uint32_t channel = 0; channel < pack.channels; ++channel)
      Channel(layout, pack, channel).Even();
  }
}

}  // namespace texgraph::textures
