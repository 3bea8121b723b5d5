// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/moments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

// The paper's, unless something clips.
constexpr double kByteFactor = 16;
constexpr double kLeastFactor = 0x1p-16;

// What texels of the finer level a texel is made of, along one axis.
struct Reduction {
  uint32_t first = 0;
  uint32_t count = 1;
  std::array<double, 3> weights{1, 0, 0};
};

// The texel covers from / to texels of the finer level: 2, or 3 in parts if `from` is odd.
Reduction ReductionOf(uint32_t index, uint32_t from, uint32_t to) {
  if (from == to) return {index, 1, {1, 0, 0}};
  if (from % 2 == 0) return {2 * index, 2, {0.5, 0.5, 0}};
  const double n = from;
  return {2 * index, 3, {(to - index) / n, to / n, (index + 1) / n}};
}

class LevelMaker {
 public:
  LevelMaker(const MomentLevel& from, size_t fields) : from_(from), fields_(fields) {
    to_.width = std::max(from.width / 2, 1u);
    to_.height = std::max(from.height / 2, 1u);
    const size_t count = size_t{to_.width} * to_.height;
    for (size_t f = 0; f < fields; ++f) {
      to_.mean[f].resize(count);
      to_.variance[f].resize(count);
    }
    if (fields == 2) to_.covariance.resize(count);
  }

  MomentLevel Make() {
    for (uint32_t y = 0; y < to_.height; ++y) {
      const Reduction rows = ReductionOf(y, from_.height, to_.height);
      for (uint32_t x = 0; x < to_.width; ++x)
        MakeTexel(size_t{y} * to_.width + x, ReductionOf(x, from_.width, to_.width), rows);
    }
    return std::move(to_);
  }

 private:
  // The variance of a union is the mean of the variances and the variance of the means: nothing
  // cancels, as it does in the mean of squares minus the square of the mean.
  void MakeTexel(size_t at, const Reduction& columns, const Reduction& rows) {
    std::array<double, 2> mean{};
    ForEach(columns, rows, [&](size_t i, double weight) {
      for (size_t f = 0; f < fields_; ++f) mean[f] += weight * double{from_.mean[f][i]};
    });
    std::array<double, 2> variance{};
    double covariance = 0;
    ForEach(columns, rows, [&](size_t i, double weight) {
      std::array<double, 2> off{};
      for (size_t f = 0; f < fields_; ++f) {
        off[f] = double{from_.mean[f][i]} - mean[f];
        variance[f] += weight * (double{from_.variance[f][i]} + off[f] * off[f]);
      }
      if (fields_ == 2) covariance += weight * (double{from_.covariance[i]} + off[0] * off[1]);
    });
    for (size_t f = 0; f < fields_; ++f) {
      to_.mean[f][at] = static_cast<float>(mean[f]);
      to_.variance[f][at] = static_cast<float>(variance[f]);
    }
    if (fields_ == 2) to_.covariance[at] = static_cast<float>(covariance);
  }

  template <class Use>
  void ForEach(const Reduction& columns, const Reduction& rows, Use use) const {
    for (uint32_t j = 0; j < rows.count; ++j) {
      for (uint32_t i = 0; i < columns.count; ++i) {
        use(size_t{rows.first + j} * from_.width + columns.first + i,
            rows.weights[j] * columns.weights[i]);
      }
    }
  }

  const MomentLevel& from_;
  size_t fields_;
  MomentLevel to_;
};

MomentPyramid BuildMoments(std::span<const Plane> fields) {
  MomentPyramid pyramid;
  pyramid.fields = fields.size();
  MomentLevel base;
  base.width = fields[0].width;
  base.height = fields[0].height;
  for (size_t f = 0; f < fields.size(); ++f) {
    base.mean[f] = fields[f].values;
    base.variance[f].resize(fields[f].values.size());
  }
  if (fields.size() == 2) base.covariance.resize(fields[0].values.size());
  pyramid.levels.push_back(std::move(base));
  while (pyramid.levels.back().width > 1 || pyramid.levels.back().height > 1)
    pyramid.levels.push_back(LevelMaker(pyramid.levels.back(), fields.size()).Make());
  return pyramid;
}

template <class Of>
double Largest(const MomentPyramid& pyramid, Of of) {
  float largest = 0;
  for (const MomentLevel& level : pyramid.levels) {
    for (const std::vector<float>* values : of(level)) {
      for (const float value : *values) largest = std::max(largest, std::abs(value));
    }
  }
  return largest;
}

// The largest power of two, `most` or less, that brings nothing beyond `room`.
double FactorFor(double largest, double most, double room) {
  double factor = most;
  while (largest * factor > room && factor > kLeastFactor) factor /= 2;
  return factor;
}

float Stored(float moment, const MomentCode& code) {
  return static_cast<float>(double{moment} * code.factor + code.zero);
}

ir::Texture ChainOf(const MomentPyramid& pyramid) {
  ir::Texture chain;
  for (const MomentLevel& from : pyramid.levels) {
    ir::Texture::Level& to = chain.levels.emplace_back();
    to.width = from.width;
    to.height = from.height;
    to.texels.resize(size_t{from.width} * from.height, ir::Texel{0, 0, 0, 1});
  }
  return chain;
}

}  // namespace

std::optional<MomentPyramid> MakeMoments(std::span<const Plane> fields, std::string_view name,
                                         SourceRange range, Diagnostics& diagnostics) {
  const bool fits = (fields.size() == 1 || fields.size() == 2) &&
                    std::ranges::all_of(fields, [&](const Plane& plane) {
                      const Plane& first = fields[0];
                      return plane.width == first.width && plane.height == first.height &&
                             plane.width > 0 && plane.height > 0 &&
                             plane.values.size() == size_t{plane.width} * plane.height;
                    });
  if (!fits) {
    diagnostics.Error(
        DiagnosticKind::kBadImage, range,
        fmt::format("the moments of texture '{}' take one field, or two of the same size",
                    Printable(name)));
    return std::nullopt;
  }
  if (!CheckPixels(uint64_t{fields[0].width} * fields[0].height, name, range, diagnostics))
    return std::nullopt;
  try {
    return BuildMoments(fields);
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

MomentTextures PackMoments(const MomentPyramid& pyramid, MomentFormat format,
                           bool with_covariance) {
  using Planes = std::vector<const std::vector<float>*>;
  MomentTextures result;
  const bool bytes = format == MomentFormat::kBytes;
  if (bytes) {
    const auto means = [](const MomentLevel& l) { return Planes{&l.mean[0], &l.mean[1]}; };
    const auto variances = [](const MomentLevel& l) {
      return Planes{&l.variance[0], &l.variance[1]};
    };
    const auto covariances = [](const MomentLevel& l) { return Planes{&l.covariance}; };
    result.mean_code = {FactorFor(Largest(pyramid, means), 1, 0.5), 0.5};
    result.variance_code = {FactorFor(Largest(pyramid, variances), kByteFactor, 1), 0};
    result.covariance_code = {FactorFor(Largest(pyramid, covariances), kByteFactor, 0.5), 0.5};
  }
  ir::Texture chain = ChainOf(pyramid);
  for (size_t l = 0; l < chain.levels.size(); ++l) {
    const MomentLevel& from = pyramid.levels[l];
    for (size_t i = 0; i < chain.levels[l].texels.size(); ++i) {
      ir::Texel& texel = chain.levels[l].texels[i];
      for (size_t f = 0; f < 2; ++f) {
        const bool has = f < pyramid.fields;
        texel[f] = Stored(has ? from.mean[f][i] : 0, result.mean_code);
        texel[2 + f] = Stored(has ? from.variance[f][i] : 0, result.variance_code);
      }
    }
  }
  result.moments = EncodeLevels(chain, bytes ? TexelFormat::kRgba8 : TexelFormat::kRgba16F);
  if (!with_covariance || pyramid.fields != 2) return result;
  chain = ChainOf(pyramid);
  for (size_t l = 0; l < chain.levels.size(); ++l) {
    for (size_t i = 0; i < chain.levels[l].texels.size(); ++i) {
      chain.levels[l].texels[i][0] =
          Stored(pyramid.levels[l].covariance[i], result.covariance_code);
    }
  }
  result.covariance = EncodeLevels(chain, bytes ? TexelFormat::kRgba8 : TexelFormat::kR16F);
  return result;
}

}  // namespace texgraph::textures
