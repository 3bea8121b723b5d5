// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/map_filter.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <vector>

#include "compiler/textures/gaussian.h"
#include "compiler/textures/texel_chain.h"
#include "compiler/textures/tile_threads.h"

namespace texgraph::textures {
namespace {

// As many texels are filtered at once: their sums stay in registers.
constexpr uint32_t kBlockTexels = 4;
constexpr uint32_t kBlock = 4 * kBlockTexels;

using Weights = std::vector<GaussianWeights>;  // of each texel along an axis

Weights WeightsOf(uint32_t size, double sigma) {
  Weights weights;
  weights.reserve(size);
  for (uint32_t i = 0; i < size; ++i) weights.push_back(WeightsAt(size, i, sigma * size));
  return weights;
}

// Rows of texels as floats, padded with zeros to whole blocks.
struct Rows {
  Rows(uint32_t width, uint32_t height)
      : stride((width + kBlockTexels - 1) / kBlockTexels * kBlock),
        values(size_t{stride} * height) {}
  uint32_t stride;
  std::vector<float> values;
};

// `to` has the first `texels` of row `row` of the convolution along columns.
void FilterRow(const Rows& from, const GaussianWeights& weights, uint32_t texels, ir::Texel* to) {
  const size_t first = size_t{weights.first} * from.stride;
  for (uint32_t block = 0; block * kBlockTexels < texels; ++block) {
    std::array<float, kBlock> sums{};
    size_t at = first + size_t{block} * kBlock;
    for (const double weight : weights.weights) {
      const auto w = static_cast<float>(weight);
      const float* row = &from.values[at];
      for (uint32_t i = 0; i < kBlock; ++i) sums[i] += w * row[i];
      at += from.stride;
    }
    const uint32_t count = std::min(kBlockTexels, texels - block * kBlockTexels);
    for (uint32_t t = 0; t < count; ++t) {
      for (uint32_t c = 0; c < 4; ++c) to[block * kBlockTexels + t][c] = sums[4 * t + c];
    }
  }
}

class MapFilter {
 public:
  MapFilter(const Image& map, const TextureOptions& texture, const MapFilterOptions& options)
      : width_(map.width),
        height_(map.height),
        options_(options),
        along_(options.sigmas, Rows(map.width, map.height)) {
    AppendPicture(map, texture.srgb, map_);
    weigh_ = texture.alpha_is_opacity &&
             std::ranges::any_of(map_, [](const ir::Texel& t) { return t[3] != 1.0f; });
    format_ = FormatFor({&map, 1}, texture);
  }

  TextureData Make();

 private:
  void FilterAlong(uint32_t x);
  TextureData Layer(uint32_t x, uint32_t y) const;

  uint32_t width_, height_;
  const MapFilterOptions& options_;
  std::vector<ir::Texel> map_;
  bool weigh_ = false;
  TexelFormat format_ = TexelFormat::kRgba8;
  std::vector<Rows> along_;       // the map filtered along u, for each standard deviation
  std::vector<Weights> weights_;  // along v
};

void MapFilter::FilterAlong(uint32_t x) {
  const Weights weights = WeightsOf(width_, SigmaAt(options_, x));
  std::vector<ir::Texel> row(width_);
  for (uint32_t y = 0; y < height_; ++y) {
    std::copy_n(map_.begin() + ptrdiff_t{y} * width_, width_, row.begin());
    if (weigh_) WeighColors(row, false);
    float* to = &along_[x].values[size_t{y} * along_[x].stride];
    for (uint32_t i = 0; i < width_; ++i, to += 4) {
      const ir::Texel* from = &row[weights[i].first];
      for (const double weight : weights[i].weights) {
        for (uint32_t c = 0; c < 4; ++c) to[c] += static_cast<float>(weight) * (*from)[c];
        ++from;
      }
    }
  }
}

TextureData MapFilter::Layer(uint32_t x, uint32_t y) const {
  ir::Texture layer;
  ir::Texture::Level& level = layer.levels.emplace_back();
  level.width = width_;
  level.height = height_;
  if (x == 0 && y == 0) {
    level.texels = map_;
  } else {
    level.texels.resize(size_t{width_} * height_);
    for (uint32_t row = 0; row < height_; ++row)
      FilterRow(along_[x], weights_[y][row], width_, &level.texels[size_t{row} * width_]);
    if (weigh_) WeighColors(level.texels, true);
  }
  return EncodeLevels(layer, format_);
}

TextureData MapFilter::Make() {
  TextureData data;
  data.format = format_;
  data.is_array = true;
  data.layers = options_.sigmas * options_.sigmas;
  data.sampler.wrap_u = data.sampler.wrap_v = data.sampler.wrap_w = ir::Wrap::kClamp;
  data.sampler.mip_filter = ir::MipFilter::kNone;
  TexelLevel& level = data.levels.emplace_back();
  level.width = width_;
  level.height = height_;
  const size_t bytes = size_t{width_} * height_ * TexelBytes(format_);
  level.bytes.resize(bytes * data.layers);
  weights_.resize(options_.sigmas);
  ForEachTile(options_.sigmas, options_.threads, [&](uint32_t i) {
    weights_[i] = WeightsOf(height_, SigmaAt(options_, i));
    FilterAlong(i);
  });
  ForEachTile(data.layers, options_.threads, [&](uint32_t i) {
    const TextureData layer = Layer(i % options_.sigmas, i / options_.sigmas);
    std::ranges::copy(layer.levels[0].bytes, level.bytes.begin() + ptrdiff_t(i * bytes));
  });
  return data;
}

}  // namespace

double SigmaAt(const MapFilterOptions& options, uint32_t index) {
  if (index == 0) return 0;
  return std::ldexp(options.greatest, static_cast<int>(index + 1) - int(options.sigmas));
}

double SigmaIndex(const MapFilterOptions& options, double sigma) {
  if (!(sigma > 0)) return 0;
  uint32_t index = 0;
  while (index + 2 < options.sigmas && sigma > SigmaAt(options, index + 1)) ++index;
  const double low = SigmaAt(options, index);
  const double high = SigmaAt(options, index + 1);
  return index + std::min((sigma * sigma - low * low) / (high * high - low * low), 1.0);
}

bool CheckColorMap(uint32_t width, uint32_t height, const MapFilterOptions& options,
                   std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  if (options.sigmas < 2 || options.sigmas > kMaxMapSigmas) {
    diagnostics.Error(DiagnosticKind::kValueRange, range,
                      fmt::format("the colour map '{}' has {} standard deviations; it can have 2 "
                                  "to {}",
                                  Printable(name), options.sigmas, kMaxMapSigmas));
    return false;
  }
  if (!(options.greatest > 0 && options.greatest <= 1)) {
    diagnostics.Error(
        DiagnosticKind::kValueRange, range,
        fmt::format("the greatest standard deviation of the colour map '{}' is {}; it can be above "
                    "0, up to 1",
                    Printable(name), options.greatest));
    return false;
  }
  if (width > kMaxColorMap || height > kMaxColorMap) {
    diagnostics.Error(DiagnosticKind::kSizeLimit, range,
                      fmt::format("the colour map '{}' has {} x {} pixels; it can have up to {} x "
                                  "{}",
                                  Printable(name), width, height, kMaxColorMap, kMaxColorMap));
    return false;
  }
  return CheckPixels(uint64_t{width} * height * options.sigmas * options.sigmas, name, range,
                     diagnostics);
}

std::optional<TextureData> MakeColorMap(const Image& map, const TextureOptions& texture,
                                        const MapFilterOptions& options, std::string_view name,
                                        SourceRange range, Diagnostics& diagnostics) {
  if (!CheckColorMap(map.width, map.height, options, name, range, diagnostics)) return std::nullopt;
  try {
    return MapFilter(map, texture, options).Make();
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace texgraph::textures
