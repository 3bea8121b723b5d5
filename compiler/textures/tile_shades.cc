// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_shades.h"

#include <cstdlib>

namespace texgraph::textures {
namespace {

constexpr int64_t kParts = 4;  // of a tile's side: no grid is seen in what is finer

}  // namespace

PatchShades::PatchShades(const TileSample& sample, uint32_t scale, uint32_t tile_size)
    : sample_(sample), scale_(scale), tile_size_(tile_size), means_(sample.channels()) {
  const int64_t width = (sample.width() + (1u << scale) - 1) >> scale;
  const int64_t height = (sample.height() + (1u << scale) - 1) >> scale;
  for (int64_t y = 0; y < height; ++y) {
    for (int64_t x = 0; x < width; ++x) {
      const uint16_t* values = sample.At(scale, {x, y});
      for (size_t c = 0; c < means_.size(); ++c) means_[c] += values[c];
    }
  }
  for (int64_t& mean : means_) mean /= width * height;
}

void PatchShades::Add(TexelPlace middle, bool is_edge) {
  const int64_t step = int64_t{1} << scale_;
  const int64_t half = tile_size_ / 2;
  const size_t channels = means_.size();
  std::vector<int64_t> sums(static_cast<size_t>(kParts * kParts) * channels);
  std::vector<int64_t> counts(static_cast<size_t>(kParts * kParts));
  for (int64_t y = -half; y < half; y += step) {
    for (int64_t x = -half; x < half; x += step) {
      if (is_edge && std::abs(2 * x + step) + std::abs(2 * y + step) > tile_size_) continue;
      const int64_t row = (y + half) * kParts / (2 * half);
      const int64_t column = (x + half) * kParts / (2 * half);
      const auto part = static_cast<size_t>(row * kParts + column);
      const uint16_t* values =
          sample_.At(scale_, {(middle.x + x) >> scale_, (middle.y + y) >> scale_});
      for (size_t c = 0; c < channels; ++c) sums[part * channels + c] += values[c] - means_[c];
      ++counts[part];
    }
  }
  std::vector<int32_t>& shades = shades_.emplace_back(sums.size());
  for (size_t i = 0; i < sums.size(); ++i) {
    if (const int64_t count = counts[i / channels]) {
      shades[i] = static_cast<int32_t>(sums[i] / count);
    }
  }
}

double PatchShades::Product(size_t i, size_t j) const {
  int64_t sum = 0;
  for (size_t k = 0; k < shades_[i].size(); ++k)
    sum += int64_t{shades_[i][k]} * int64_t{shades_[j][k]};
  return static_cast<double>(sum);
}

}  // namespace texgraph::textures
