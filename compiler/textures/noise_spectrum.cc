// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/noise_spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <new>
#include <numeric>

#include "compiler/textures/fourier.h"
#include "compiler/textures/hash.h"
#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

// Less than it is 0: a sum of products of two fields of variance 1.
constexpr double kLeastProduct = 1e-9;
constexpr double kTolerance = 1e-6;

using Field = std::vector<double>;
using Numbers = std::array<double, kMaxNoiseChannels>;

double MeanProduct(const Field& a, const Field& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) / static_cast<double>(a.size());
}

// White noise `stream`, filtered so that it has the spectrum, mean 0 and variance 1.
Field FilteredNoise(const std::vector<double>& power, uint32_t size, uint32_t seed,
                    uint32_t stream) {
  std::vector<std::complex<double>> values(power.size());
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      const double share = (TexelHash(seed, stream, x, y) + 0.5) * 0x1p-32;
      values[size_t{y} * size + x] = NormalQuantile(share);
    }
  }
  FourierTransform(values, size, size, false);
  for (size_t i = 0; i < power.size(); ++i) values[i] *= std::sqrt(power[i]);
  FourierTransform(values, size, size, true);
  Field field(power.size());
  for (size_t i = 0; i < field.size(); ++i) field[i] = values[i].real();
  const double mean = std::accumulate(field.begin(), field.end(), 0.0) / double(field.size());
  for (double& value : field) value -= mean;
  const double scale = 1 / std::sqrt(MeanProduct(field, field));
  for (double& value : field) value *= scale;
  return field;
}

// Solves `rows` for `rhs`, both given by their upper left n x n and first n numbers, with full
// pivots; unknowns that nothing determines are 0.
using Matrix = std::array<Numbers, kMaxNoiseChannels>;
Numbers Solve(Matrix rows, Numbers rhs, size_t n) {
  std::array<size_t, kMaxNoiseChannels> unknowns;
  std::iota(unknowns.begin(), unknowns.end(), size_t{0});
  size_t rank = 0;
  for (; rank < n; ++rank) {
    size_t row = rank, column = rank;
    for (size_t i = rank; i < n; ++i) {
      for (size_t j = rank; j < n; ++j) {
        if (std::abs(rows[i][j]) > std::abs(rows[row][column])) row = i, column = j;
      }
    }
    if (std::abs(rows[row][column]) < kLeastProduct) break;
    std::swap(rows[row], rows[rank]);
    std::swap(rhs[row], rhs[rank]);
    for (Numbers& r : rows) std::swap(r[column], r[rank]);
    std::swap(unknowns[column], unknowns[rank]);
    for (size_t i = rank + 1; i < n; ++i) {
      const double factor = rows[i][rank] / rows[rank][rank];
      for (size_t j = rank; j < n; ++j) rows[i][j] -= factor * rows[rank][j];
      rhs[i] -= factor * rhs[rank];
    }
  }
  Numbers solution{};
  for (size_t i = rank; i-- > 0;) {
    double value = rhs[i];
    for (size_t j = i + 1; j < rank; ++j) value -= rows[i][j] * solution[unknowns[j]];
    solution[unknowns[i]] = value / rows[i][i];
  }
  return solution;
}

// A channel beside those before it. `candidates` all have its spectrum, the i-th of the white
// noise that channel i began with. Their sum, with the factors that are found here, has variance 1
// and the correlations asked for; nothing if there are none such.
std::optional<Field> Correlate(const std::vector<Field>& channels,
                               const std::vector<Field>& candidates,
                               std::span<const double> correlations) {
  const size_t n = channels.size();
  Matrix rows{};
  Numbers fixed{}, moving{};
  for (size_t k = 0; k < n; ++k) {
    for (size_t i = 0; i < n; ++i) rows[k][i] = MeanProduct(channels[k], candidates[i]);
    fixed[k] = correlations[k];
    moving[k] = -MeanProduct(channels[k], candidates[n]);
  }
  // All that correlate as they should are base + t * step.
  Numbers base = Solve(rows, fixed, n);
  Numbers step = Solve(rows, moving, n);
  base[n] = 0;
  step[n] = 1;
  double a = 0, b = 0, c = -1;
  for (size_t i = 0; i <= n; ++i) {
    for (size_t j = 0; j <= n; ++j) {
      const double product = MeanProduct(candidates[i], candidates[j]);
      a += step[i] * step[j] * product;
      b += base[i] * step[j] * product;
      c += base[i] * base[j] * product;
    }
  }
  const double discriminant = b * b - a * c;
  if (!(discriminant > -kTolerance)) return std::nullopt;
  const double t = (std::sqrt(std::max(discriminant, 0.0)) - b) / a;
  Field field(candidates[0].size());
  for (size_t i = 0; i <= n; ++i) {
    const double factor = base[i] + t * step[i];
    for (size_t p = 0; p < field.size(); ++p) field[p] += factor * candidates[i][p];
  }
  for (size_t k = 0; k < n; ++k) {
    if (std::abs(MeanProduct(channels[k], field) - correlations[k]) > kTolerance)
      return std::nullopt;
  }
  return field;
}

Plane PlaneOf(const Field& field, uint32_t size, double sigma) {
  Plane plane{size, size, std::vector<float>(field.size())};
  for (size_t i = 0; i < field.size(); ++i) plane.values[i] = static_cast<float>(sigma * field[i]);
  return plane;
}

class NoiseMaker {
 public:
  NoiseMaker(std::span<const NoiseSpectrum> spectra, const NoiseOptions& options)
      : spectra_(spectra), options_(options) {}

  // What is wrong stands in `complaint`.
  std::optional<std::vector<Plane>> Make(std::string& complaint) const {
    std::vector<Field> fields;
    std::vector<Plane> planes;
    for (uint32_t i = 0; i < spectra_.size(); ++i) {
      const auto power = PowerOf(spectra_[i], options_.size);
      if (!power) {
        complaint = "a part of its spectrum has no power at any frequency";
        return std::nullopt;
      }
      std::optional<Field> field = Channel(i, *power, fields);
      if (!field) {
        complaint = fmt::format(
            "channel {} cannot correlate so with those before it: it takes spectra that have more "
            "in common, or correlations that agree with each other",
            i);
        return std::nullopt;
      }
      planes.push_back(PlaneOf(*field, options_.size, options_.sigma));
      if (!options_.correlations.empty()) fields.push_back(std::move(*field));
    }
    return planes;
  }

 private:
  std::optional<Field> Channel(uint32_t index, const std::vector<double>& power,
                               const std::vector<Field>& before) const {
    const auto noise = [&](uint32_t stream) {
      return FilteredNoise(power, options_.size, options_.seed, stream);
    };
    if (options_.correlations.empty()) return noise(index);
    std::vector<Field> candidates;
    for (uint32_t i = 0; i <= index; ++i) candidates.push_back(noise(i));
    return Correlate(before, candidates,
                     std::span(options_.correlations).subspan(index * spectra_.size(), index));
  }

  std::span<const NoiseSpectrum> spectra_;
  const NoiseOptions& options_;
};

}  // namespace

std::optional<std::vector<Plane>> MakeNoise(std::span<const NoiseSpectrum> channels,
                                            const NoiseOptions& options, std::string_view name,
                                            SourceRange range, Diagnostics& diagnostics) {
  if (!CheckNoise(channels, options, name, range, diagnostics)) return std::nullopt;
  try {
    std::string complaint;
    auto planes = NoiseMaker(channels, options).Make(complaint);
    if (!planes) {
      diagnostics.Error(DiagnosticKind::kValueRange, range,
                        fmt::format("noise '{}': {}", Printable(name), complaint));
    }
    return planes;
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace texgraph::textures
