// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/means.h"

#include <algorithm>
#include <new>

#include "compiler/textures/fill.h"
#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

// A mean of colours, each times its opacity where that weighs them.
class Mean {
 public:
  explicit Mean(bool alpha_is_opacity) : alpha_is_opacity_(alpha_is_opacity) {}

  void Add(const MeanColor& color) {
    const double weight = alpha_is_opacity_ ? color[3] : 1.0;
    for (size_t c = 0; c < 3; ++c) {
      plain_[c] += color[c];
      weighed_[c] += weight * color[c];
    }
    alpha_ += color[3];
    weight_ += weight;
    ++count_;
  }
  void AddNothing() { ++count_; }

  // What is all transparent has its plain mean, so that it has the least influence on filters.
  MeanColor Get() const {
    if (count_ == 0) return {};
    const auto count = static_cast<double>(count_);
    MeanColor mean;
    for (size_t c = 0; c < 3; ++c)
      mean[c] = static_cast<float>(weight_ > 0 ? weighed_[c] / weight_ : plain_[c] / count);
    mean[3] = static_cast<float>(alpha_ / count);
    return mean;
  }

 private:
  bool alpha_is_opacity_;
  std::array<double, 3> plain_{}, weighed_{};
  double alpha_ = 0, weight_ = 0;
  uint64_t count_ = 0;
};

const MeanColor* Find(std::span<const MeanColor> means, int32_t number) {
  if (number < 0 || static_cast<size_t>(number) >= means.size()) return nullptr;
  return &means[static_cast<size_t>(number)];
}

uint32_t TexelsPerCell(const NumberMap& map, bool dithered) {
  if (dithered) return 1;
  const uint32_t side = std::max(map.width, map.height);
  uint32_t texels = kMeansTexelsPerCell;
  while (texels > 1 && uint64_t{side} * texels > kMaxMeansSide) texels /= 2;
  return texels;
}

// One texel a cell. Empty cells get the colours around them, so that a filter does not mix
// blackness in.
std::vector<ir::Texel> CellColors(const NumberMap& map, std::span<const MeanColor> means,
                                  bool alpha_is_opacity) {
  std::vector<ir::Texel> cells(map.numbers.size());
  std::vector<ir::Texel> weighed(cells.size());
  bool any_empty = false;
  for (size_t i = 0; i < cells.size(); ++i) {
    const MeanColor* mean = Find(means, map.numbers[i]);
    if (mean != nullptr) {
      cells[i] = *mean;
      weighed[i] = {(*mean)[0], (*mean)[1], (*mean)[2], 1};
    }
    any_empty |= mean == nullptr;
  }
  if (!any_empty || !alpha_is_opacity) return cells;
  FillColors(weighed, map.width, map.height);
  for (size_t i = 0; i < cells.size(); ++i) {
    for (size_t c = 0; c < 3; ++c) cells[i][c] = weighed[i][c];
  }
  return cells;
}

TextureData BuildMeans(const NumberMap& map, std::span<const MeanColor> means, uint32_t scale,
                       bool alpha_is_opacity) {
  const std::vector<ir::Texel> cells = CellColors(map, means, alpha_is_opacity);
  ir::Texture chain;
  chain.sampler.wrap_w = ir::Wrap::kClamp;
  ir::Texture::Level& base = chain.levels.emplace_back();
  base.width = map.width * scale;
  base.height = map.height * scale;
  base.texels.reserve(cells.size() * scale * scale);
  for (uint32_t y = 0; y < base.height; ++y) {
    for (uint32_t x = 0; x < base.width; ++x)
      base.texels.push_back(cells[size_t{y / scale} * map.width + x / scale]);
  }
  BuildLevels(chain, alpha_is_opacity);
  return EncodeLevels(chain, TexelFormat::kRgba16);
}

}  // namespace

std::vector<MeanColor> PatternMeans(const TextureData& patterns, bool alpha_is_opacity) {
  const TexelLevel& level = patterns.levels[0];
  const uint32_t size = TexelBytes(patterns.format);
  const size_t texels = size_t{level.width} * level.height * level.depth;
  std::vector<MeanColor> means;
  const uint8_t* from = level.bytes.data();
  for (uint32_t layer = 0; layer < patterns.layers; ++layer) {
    Mean mean(alpha_is_opacity);
    for (size_t i = 0; i < texels; ++i, from += size) mean.Add(DecodeTexel(patterns.format, from));
    means.push_back(mean.Get());
  }
  return means;
}

std::vector<MeanColor> ListMeans(const NumberMap& lists, std::span<const MeanColor> patterns,
                                 bool alpha_is_opacity) {
  std::vector<MeanColor> means;
  for (uint32_t row = 0; row < lists.height; ++row) {
    Mean mean(alpha_is_opacity);
    for (uint32_t x = 0; x < lists.width; ++x) {
      const MeanColor* pattern = Find(patterns, lists.At(x, row));
      if (pattern != nullptr) {
        mean.Add(*pattern);
      } else if (alpha_is_opacity) {
        mean.AddNothing();
      }
    }
    means.push_back(mean.Get());
  }
  return means;
}

std::optional<TextureData> MeansTexture(const NumberMap& map, std::span<const MeanColor> means,
                                        bool dithered, bool alpha_is_opacity, std::string_view name,
                                        SourceRange range, Diagnostics& diagnostics) {
  const uint32_t scale = TexelsPerCell(map, dithered);
  const uint64_t pixels = uint64_t{map.width} * map.height * scale * scale;
  if (!CheckPixels(pixels, name, range, diagnostics)) return std::nullopt;
  try {
    return BuildMeans(map, means, scale, alpha_is_opacity);
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace texgraph::textures
