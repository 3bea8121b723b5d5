// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_sample.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace texgraph::textures {
namespace {

// All channels of one place together stay below it.
constexpr double kLargestSum = 1 << 18;
constexpr double kLargestValue = 65535;

int64_t Inside(int64_t at, int64_t size, bool wraps) {
  if (at >= 0 && at < size) return at;
  if (!wraps) return at < 0 ? 0 : size - 1;
  const int64_t rest = at % size;
  return rest < 0 ? rest + size : rest;
}

}  // namespace

TileSample::TileSample(std::span<const Image> maps, std::span<const double> weights, bool wraps,
                       uint32_t scales)
    : wraps_(wraps) {
  for (size_t i = 0; i < maps.size(); ++i) {
    if (weights[i] > 0) channels_ += maps[i].channels;
  }
  scales_.reserve(scales);
  Scale& base = scales_.emplace_back();
  base.width = maps[0].width;
  base.height = maps[0].height;
  base.values.resize(size_t{maps[0].width} * maps[0].height * channels_);
  Fill(maps, weights);
  while (scales_.size() < scales) scales_.push_back(Halved(scales_.back()));
}

void TileSample::Fill(std::span<const Image> maps, std::span<const double> weights) {
  double largest = 0;
  double sum = 0;
  for (size_t i = 0; i < maps.size(); ++i) {
    largest = std::max(largest, weights[i]);
    sum += weights[i] * maps[i].channels;
  }
  const double unit = std::min(kLargestValue / largest, kLargestSum / sum);
  std::vector<uint16_t>& values = scales_[0].values;
  uint32_t first = 0;
  for (size_t i = 0; i < maps.size(); ++i) {
    if (weights[i] <= 0) continue;
    const Image& map = maps[i];
    std::vector<uint16_t> table(size_t{1} << map.bits);
    for (size_t v = 0; v < table.size(); ++v) {
      table[v] = static_cast<uint16_t>(static_cast<double>(v) /
                                       static_cast<double>(table.size() - 1) * unit * weights[i]);
    }
    for (uint32_t y = 0; y < map.height; ++y) {
      uint16_t* to = &values[size_t{y} * map.width * channels_ + first];
      for (uint32_t x = 0; x < map.width; ++x, to += channels_) {
        for (uint32_t c = 0; c < map.channels; ++c) to[c] = table[map.At(x, map.height - 1 - y, c)];
      }
    }
    first += map.channels;
  }
}

TileSample::Scale TileSample::Halved(const Scale& from) const {
  Scale scale;
  scale.width = (from.width + 1) / 2;
  scale.height = (from.height + 1) / 2;
  scale.values.resize(static_cast<size_t>(scale.width * scale.height) * channels_);
  uint16_t* to = scale.values.data();
  for (int64_t y = 0; y < scale.height; ++y) {
    for (int64_t x = 0; x < scale.width; ++x) {
      const uint16_t* quad[4] = {At(from, {2 * x, 2 * y}), At(from, {2 * x + 1, 2 * y}),
                                 At(from, {2 * x, 2 * y + 1}), At(from, {2 * x + 1, 2 * y + 1})};
      for (uint32_t c = 0; c < channels_; ++c) {
        const uint32_t sum = uint32_t{quad[0][c]} + quad[1][c] + quad[2][c] + quad[3][c];
        *to++ = static_cast<uint16_t>((sum + 2) / 4);
      }
    }
  }
  return scale;
}

const uint16_t* TileSample::At(const Scale& scale, TexelPlace place) const {
  const int64_t x = Inside(place.x, scale.width, wraps_);
  const int64_t y = Inside(place.y, scale.height, wraps_);
  return &scale.values[static_cast<size_t>(y * scale.width + x) * channels_];
}

int32_t TileSample::Difference(uint32_t scale, TexelPlace a, TexelPlace b) const {
  const uint16_t* left = At(scales_[scale], a);
  const uint16_t* right = At(scales_[scale], b);
  int32_t sum = 0;
  for (uint32_t c = 0; c < channels_; ++c) sum += std::abs(int32_t{left[c]} - int32_t{right[c]});
  return sum;
}

int32_t TileSample::SeamCost(uint32_t scale, TexelPlace a, TexelPlace b) const {
  const Scale& values = scales_[scale];
  const uint16_t* a0 = At(values, a);
  const uint16_t* b0 = At(values, b);
  const uint16_t* ax = At(values, {a.x + 1, a.y});
  const uint16_t* bx = At(values, {b.x + 1, b.y});
  const uint16_t* ay = At(values, {a.x, a.y + 1});
  const uint16_t* by = At(values, {b.x, b.y + 1});
  int32_t sum = 0;
  int32_t steps = 0;
  for (uint32_t c = 0; c < channels_; ++c) {
    const int32_t here = int32_t{a0[c]} - int32_t{b0[c]};
    sum += std::abs(here);
    steps += std::abs(int32_t{ax[c]} - int32_t{bx[c]} - here) +
             std::abs(int32_t{ay[c]} - int32_t{by[c]} - here);
  }
  // Doubled, so that halves need no rounding, which would break the triangle inequality.
  return 2 * sum + steps;
}

double TileSample::MeanStep(bool upwards) const {
  const Scale& base = scales_[0];
  const int64_t columns = base.width - (upwards ? 0 : 1);
  const int64_t rows = base.height - (upwards ? 1 : 0);
  if (columns < 1 || rows < 1) return 0;
  int64_t sum = 0;
  for (int64_t y = 0; y < rows; ++y) {
    for (int64_t x = 0; x < columns; ++x)
      sum += Difference(0, {x, y}, {x + (upwards ? 0 : 1), y + (upwards ? 1 : 0)});
  }
  return static_cast<double>(sum) / static_cast<double>(columns * rows);
}

}  // namespace texgraph::textures
