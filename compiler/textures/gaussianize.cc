// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/gaussianize.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>

#include "compiler/textures/hash.h"
#include "compiler/textures/moments.h"
#include "compiler/textures/principal_axes.h"
#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

// How far texels of equal value see, in texels: what is around them counts e times less there.
constexpr double kSight = 4;
// Steps of what they see. Finer differences are those of rounding, and a hash decides.
constexpr double kSteps = 0x1p30;
// The table is convolved as a function that is linear between nodes, so many for each standard
// deviation of the Gaussian, to both sides as far as quantiles go; beyond them it is constant.
constexpr double kNodesPerSigma = 32;
constexpr double kMaxNodes = 8192;
constexpr double kNodeReach = 6;

using Field = std::vector<double>;

// Along a line that closes: each value becomes the mean of all, weighted by exp(-distance /
// kSight), by a recursive filter in both directions.
void SmoothLine(double* values, size_t count, size_t stride) {
  const double keep = std::exp(-1 / kSight);
  const double whole = -std::expm1(-static_cast<double>(count) / kSight);
  const auto sweep = [&](auto at) {
    // What has gone round any number of times before the first one.
    double state = 0;
    for (size_t i = 0; i < count; ++i) state = keep * state + (1 - keep) * values[at(i)];
    state /= whole;
    for (size_t i = 0; i < count; ++i) {
      state = keep * state + (1 - keep) * values[at(i)];
      values[at(i)] = state;
    }
  };
  sweep([&](size_t i) { return i * stride; });
  sweep([&](size_t i) { return (count - 1 - i) * stride; });
}

struct Rank {
  double value;
  int64_t around;
  uint32_t hash;
  uint32_t texel;

  bool operator<(const Rank& other) const {
    if (value != other.value) return value < other.value;
    if (around != other.around) return around < other.around;
    return hash != other.hash ? hash < other.hash : texel < other.texel;
  }
};

// All texels in the order of their values.
std::vector<Rank> RankTexels(const Field& values, uint32_t width, uint32_t height, uint32_t axis) {
  const auto [least, most] = std::ranges::minmax(values);
  Field around = values;
  for (uint32_t y = 0; y < height; ++y) SmoothLine(&around[size_t{y} * width], width, 1);
  for (uint32_t x = 0; x < width; ++x) SmoothLine(&around[x], height, width);
  const double scale = most > least ? kSteps / (most - least) : 0;
  std::vector<Rank> ranks(values.size());
  for (uint32_t i = 0; i < ranks.size(); ++i) {
    ranks[i] = {values[i], std::llround((around[i] - least) * scale),
                TexelHash(0, axis, i % width, i / width), i};
  }
  std::sort(ranks.begin(), ranks.end());
  return ranks;
}

// What the table gives for `noise`, before any filter: the value that has as many below it as the
// normal distribution has.
double ValueAt(const std::vector<Rank>& ranks, double deviations) {
  const double last = static_cast<double>(ranks.size()) - 1;
  const double place =
      std::clamp(NormalCdf(deviations) * static_cast<double>(ranks.size()) - 0.5, 0.0, last);
  const auto below = static_cast<size_t>(place);
  const double above = ranks[std::min(below + 1, ranks.size() - 1)].value;
  return std::lerp(ranks[below].value, above, place - static_cast<double>(below));
}

double MeanOf(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

class GaussianMaker {
 public:
  GaussianMaker(std::span<const Plane> channels, const GaussianOptions& options)
      : channels_(channels), options_(options) {
    result_.sigma = options.sigma;
    result_.columns = options.columns;
  }

  GaussianExemplar Make() {
    FindAxes();
    for (uint32_t axis = 0; axis < channels_.size(); ++axis) {
      const Plane& first = channels_[0];
      const std::vector<Rank> ranks = RankTexels(Projection(axis), first.width, first.height, axis);
      result_.noise.push_back(NoiseOf(ranks));
      result_.lost.push_back(LostVariances(result_.noise.back()));
      result_.rows = static_cast<uint32_t>(result_.lost.back().size());
      result_.table.push_back(TableOf(ranks, result_.lost.back()));
    }
    return std::move(result_);
  }

 private:
  void FindAxes() {
    const size_t n = channels_.size();
    for (size_t c = 0; c < n; ++c) result_.mean[c] = MeanOf(channels_[c].values);
    Axes covariances{};
    for (size_t a = 0; options_.decorrelate && a < n; ++a) {
      for (size_t b = 0; b <= a; ++b) {
        double sum = 0;
        for (size_t i = 0; i < channels_[0].values.size(); ++i)
          sum += (channels_[a].values[i] - result_.mean[a]) *
                 (channels_[b].values[i] - result_.mean[b]);
        covariances[a][b] = covariances[b][a] = sum;
      }
    }
    result_.axes = PrincipalAxes(covariances, n);
  }

  Field Projection(size_t axis) const {
    Field field(channels_[0].values.size());
    for (size_t c = 0; c < channels_.size(); ++c) {
      for (size_t i = 0; i < field.size(); ++i)
        field[i] += result_.axes[axis][c] * (channels_[c].values[i] - result_.mean[c]);
    }
    return field;
  }

  Plane NoiseOf(const std::vector<Rank>& ranks) const {
    Plane noise{channels_[0].width, channels_[0].height, std::vector<float>(ranks.size())};
    for (size_t i = 0; i < ranks.size(); ++i) {
      const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(ranks.size());
      noise.values[ranks[i].texel] = static_cast<float>(options_.sigma * NormalQuantile(share));
    }
    return noise;
  }

  // Of each level, in standard deviations squared.
  std::vector<double> LostVariances(const Plane& noise) const {
    Diagnostics none;  // sizes have been checked, and memory that runs out is thrown
    std::vector<double> lost;
    const auto moments = MakeMoments({&noise, 1}, {}, {}, none);
    if (!moments) throw std::bad_alloc();
    for (const MomentLevel& level : moments->levels) lost.push_back(MeanOf(level.variance[0]));
    return lost;
  }

  std::vector<float> TableOf(const std::vector<Rank>& ranks,
                             const std::vector<double>& lost) const {
    std::vector<float> table;
    table.reserve(lost.size() * options_.columns);
    for (const double variance : lost) {
      Field row(options_.columns);
      for (uint32_t x = 0; x < options_.columns; ++x)
        row[x] = ((x + 0.5) / options_.columns * 2 - 1) * kTableReach;
      FillRow(ranks, std::sqrt(variance) / options_.sigma, row);
      table.insert(table.end(), row.begin(), row.end());
    }
    return table;
  }

  // From standard deviations to the mean of the values around them.
  static void FillRow(const std::vector<Rank>& ranks, double sigma, Field& row) {
    if (sigma == 0) {
      for (double& value : row) value = ValueAt(ranks, value);
      return;
    }
    const double count = std::min(std::ceil(2 * kNodeReach * kNodesPerSigma / sigma), kMaxNodes);
    const double step = 2 * kNodeReach / count;
    Field nodes(static_cast<size_t>(count) + 1);
    for (size_t i = 0; i < nodes.size(); ++i)
      nodes[i] = ValueAt(ranks, static_cast<double>(i) * step - kNodeReach);
    for (double& value : row) {
      const GaussianWeights at =
          WeightsAt(static_cast<uint32_t>(nodes.size()), (value + kNodeReach) / step, sigma / step);
      value = std::inner_product(at.weights.begin(), at.weights.end(),
                                 nodes.begin() + ptrdiff_t{at.first}, 0.0);
    }
  }

  std::span<const Plane> channels_;
  const GaussianOptions& options_;
  GaussianExemplar result_;
};

bool CheckChannels(std::span<const Plane> channels, const GaussianOptions& options,
                   std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  const bool fits =
      !channels.empty() && channels.size() <= kMaxGaussianChannels &&
      std::ranges::all_of(channels, [&](const Plane& plane) {
        return plane.width == channels[0].width && plane.height == channels[0].height &&
               !plane.values.empty() && plane.values.size() == size_t{plane.width} * plane.height &&
               std::ranges::all_of(plane.values, [](float v) { return std::isfinite(v); });
      });
  if (!fits) {
    diagnostics.Error(DiagnosticKind::kBadImage, range,
                      fmt::format("the Gaussian texture '{}' takes 1 to {} channels of finite "
                                  "numbers, all of the same size",
                                  Printable(name), kMaxGaussianChannels));
    return false;
  }
  const bool columns = options.columns >= 16 && options.columns <= 4096;
  if (!columns || !(options.sigma > 0 && options.sigma <= 1000)) {
    diagnostics.Error(DiagnosticKind::kValueRange, range,
                      fmt::format("the Gaussian texture '{}' has a standard deviation of {} and a "
                                  "table of {} columns; they can be above 0 up to 1,000, and 16 to "
                                  "4,096",
                                  Printable(name), options.sigma, options.columns));
    return false;
  }
  return CheckPixels(uint64_t{channels[0].width} * channels[0].height, name, range, diagnostics);
}

// Between texels of a line, clamped at its ends.
struct Between {
  uint32_t below, above;
  double fraction;
};

Between BetweenTexels(double coordinate, uint32_t count) {
  const double place = std::clamp(coordinate * count - 0.5, 0.0, count - 1.0);
  const auto below = static_cast<uint32_t>(place);
  return {below, std::min(below + 1, count - 1), place - below};
}

}  // namespace

double TableColumn(double noise, double sigma) {
  return std::clamp(noise / (2 * kTableReach * sigma) + 0.5, 0.0, 1.0);
}

double TableRow(double level, uint32_t rows) {
  return (std::clamp(level, 0.0, rows - 1.0) + 0.5) / rows;
}

std::optional<GaussianExemplar> Gaussianize(std::span<const Plane> channels,
                                            const GaussianOptions& options, std::string_view name,
                                            SourceRange range, Diagnostics& diagnostics) {
  if (!CheckChannels(channels, options, name, range, diagnostics)) return std::nullopt;
  try {
    return GaussianMaker(channels, options).Make();
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

std::array<double, kMaxGaussianChannels> TurnBack(const GaussianExemplar& exemplar,
                                                  std::span<const double> noise, double level) {
  std::array<double, kMaxGaussianChannels> color = exemplar.mean;
  const Between y = BetweenTexels(TableRow(level, exemplar.rows), exemplar.rows);
  for (size_t a = 0; a < exemplar.table.size(); ++a) {
    const Between x = BetweenTexels(TableColumn(noise[a], exemplar.sigma), exemplar.columns);
    const auto at = [&](uint32_t row) {
      const float* values = &exemplar.table[a][size_t{row} * exemplar.columns];
      return std::lerp(double{values[x.below]}, double{values[x.above]}, x.fraction);
    };
    const double value = std::lerp(at(y.below), at(y.above), y.fraction);
    for (size_t c = 0; c < exemplar.table.size(); ++c) color[c] += exemplar.axes[a][c] * value;
  }
  return color;
}

TextureData NoiseTexture(const GaussianExemplar& exemplar) {
  ir::Texture chain;
  ir::Texture::Level& base = chain.levels.emplace_back();
  base.width = exemplar.noise[0].width;
  base.height = exemplar.noise[0].height;
  base.texels.resize(exemplar.noise[0].values.size());
  for (size_t a = 0; a < exemplar.noise.size(); ++a) {
    for (size_t i = 0; i < base.texels.size(); ++i) base.texels[i][a] = exemplar.noise[a].values[i];
  }
  ir::BuildMipChain(chain);
  return EncodeLevels(chain, TexelFormat::kRgba16F);
}

TextureData TableTexture(const GaussianExemplar& exemplar) {
  ir::Texture chain;
  chain.sampler.wrap_u = chain.sampler.wrap_v = chain.sampler.wrap_w = ir::Wrap::kClamp;
  chain.sampler.mip_filter = ir::MipFilter::kNone;
  ir::Texture::Level& base = chain.levels.emplace_back();
  chain.is_array = true;
  base.width = exemplar.columns;
  base.height = exemplar.rows;
  base.depth = static_cast<uint32_t>(exemplar.table.size());
  for (size_t a = 0; a < exemplar.table.size(); ++a) {
    for (const float value : exemplar.table[a]) {
      ir::Texel& texel = base.texels.emplace_back();
      for (size_t c = 0; c < exemplar.table.size(); ++c) {
        const double mean = a == 0 ? exemplar.mean[c] : 0;
        texel[c] = static_cast<float>(mean + exemplar.axes[a][c] * value);
      }
    }
  }
  return EncodeLevels(chain, TexelFormat::kRgba16F);
}

}  // namespace texgraph::textures
