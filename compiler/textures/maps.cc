// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/maps.h"

#include <fmt/format.h>
#include <string.h>

#include <algorithm>
#include <unordered_map>

#include "compiler/textures/half.h"

namespace texgraph::textures {
namespace {

// The largest number up to which halves have them all.
constexpr int32_t kMaxHalfNumber = 2048;

using MapColor = std::array<uint32_t, 3>;

MapColor ColorAt(const Image& image, uint32_t x, uint32_t y) {
  if (image.channels < 3) {
    const uint32_t grey = image.At(x, y, 0);
    return {grey, grey, grey};
  }
  return {image.At(x, y, 0), image.At(x, y, 1), image.At(x, y, 2)};
}

bool IsTransparent(const Image& image, uint32_t x, uint32_t y) {
  return image.channels % 2 == 0 && image.At(x, y, image.channels - 1u) == 0;
}

uint64_t KeyOf(const MapColor& color) {
  return uint64_t{color[0]} << 32 | uint64_t{color[1]} << 16 | color[2];
}

// As in the picture: two digits a channel, or four for deep ones.
std::string Hex(const Image& image, const MapColor& color) {
  const int digits = image.bits / 4;
  return fmt::format("#{:0{}x}{:0{}x}{:0{}x}", color[0], digits, color[1], digits, color[2],
                     digits);
}

// The legend's numbers by colour, in the picture's bits. Of equal colours the first counts.
class Legend {
 public:
  Legend(std::span<const std::array<uint8_t, 3>> colors, uint8_t bits) {
    const uint32_t scale = bits == 16 ? 257 : 1;
    for (size_t i = 0; i < colors.size(); ++i) {
      const MapColor color{colors[i][0] * scale, colors[i][1] * scale, colors[i][2] * scale};
      numbers_.emplace(KeyOf(color), static_cast<int32_t>(i));
    }
  }
  std::optional<int32_t> Find(const MapColor& color) const {
    const auto found = numbers_.find(KeyOf(color));
    if (found == numbers_.end()) return std::nullopt;
    return found->second;
  }
  bool empty() const { return numbers_.empty(); }

 private:
  std::unordered_map<uint64_t, int32_t> numbers_;
};

// "; the nearest there is #3a7d2c, number 2": by the sum of the channels' squared distances.
std::string NearestText(const Image& image, std::span<const std::array<uint8_t, 3>> legend,
                        const MapColor& color) {
  const uint32_t scale = image.bits == 16 ? 257 : 1;
  size_t nearest = 0;
  uint64_t least = UINT64_MAX;
  for (size_t i = 0; i < legend.size(); ++i) {
    uint64_t distance = 0;
    for (size_t c = 0; c < 3; ++c) {
      const int64_t difference = int64_t{legend[i][c]} * scale - color[c];
      distance += static_cast<uint64_t>(difference * difference);
    }
    if (distance >= least) continue;
    least = distance;
    nearest = i;
  }
  const std::array<uint8_t, 3>& rgb = legend[nearest];
  return fmt::format("; the nearest there is #{:02x}{:02x}{:02x}, number {}", rgb[0], rgb[1],
                     rgb[2], nearest);
}

std::optional<int32_t> NumberOf(const Legend& legend, const MapColor& color) {
  if (!legend.empty()) return legend.Find(color);
  if (color[0] != color[1] || color[0] != color[2]) return std::nullopt;
  return static_cast<int32_t>(color[0]);
}

}  // namespace

std::optional<NumberMap> MapOfImage(const Image& image,
                                    std::span<const std::array<uint8_t, 3>> legend,
                                    std::string_view name, SourceRange range,
                                    Diagnostics& diagnostics) {
  const Legend numbers(legend, image.bits);
  NumberMap map;
  map.width = image.width;
  map.height = image.height;
  map.numbers.resize(size_t{map.width} * map.height);
  for (uint32_t y = 0; y < image.height; ++y) {
    int32_t* row = &map.numbers[size_t{image.height - 1 - y} * image.width];
    for (uint32_t x = 0; x < image.width; ++x) {
      const MapColor color = ColorAt(image, x, y);
      const std::optional<int32_t> number =
          IsTransparent(image, x, y) ? -1 : NumberOf(numbers, color);
      if (!number) {
        diagnostics.Error(
            DiagnosticKind::kBadImage, range,
            fmt::format("pixel ({}, {}) of the map '{}' is {}, which {}", x, y, Printable(name),
                        Hex(image, color),
                        legend.empty()
                            ? "is not grey: a map of colours needs a legend"
                            : "is not in the legend" + NearestText(image, legend, color)));
        return std::nullopt;
      }
      row[x] = *number;
    }
  }
  return map;
}

std::optional<size_t> FindOutOfRange(const NumberMap& map, uint32_t count) {
  const auto bad = std::ranges::find_if(
      map.numbers, [count](int32_t n) { return n < -1 || n >= static_cast<int64_t>(count); });
  if (bad == map.numbers.end()) return std::nullopt;
  return static_cast<size_t>(bad - map.numbers.begin());
}

TextureData MapTexture(const NumberMap& map, ir::Wrap wrap_u, ir::Wrap wrap_v) {
  TextureData data;
  const bool half =
      std::ranges::all_of(map.numbers, [](int32_t n) { return n <= kMaxHalfNumber && n >= -1; });
  data.format = half ? TexelFormat::kR16F : TexelFormat::kR32F;
  data.sampler.wrap_u = wrap_u;
  data.sampler.wrap_v = wrap_v;
  data.sampler.wrap_w = ir::Wrap::kClamp;
  data.sampler.filter = ir::Filter::kNearest;
  data.sampler.mip_filter = ir::MipFilter::kNone;
  TexelLevel& level = data.levels.emplace_back();
  level.width = map.width;
  level.height = map.height;
  const uint32_t size = TexelBytes(data.format);
  level.bytes.resize(map.numbers.size() * size);
  for (size_t i = 0; i < map.numbers.size(); ++i) {
    const auto value = static_cast<float>(map.numbers[i]);
    const uint16_t bits = FloatToHalf(value);
    memcpy(&level.bytes[i * size], half ? static_cast<const void*>(&bits) : &value, size);
  }
  return data;
}

}  // namespace texgraph::textures
