// SPDX-License-Identifier: Apache-2.0
// The power of each frequency, and whether a spectrum makes sense.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <string>

#include "compiler/textures/noise_spectrum.h"

namespace texgraph::textures {
namespace {

double Square(double x) { return x * x; }

struct Frequency {
  double x, y;  // from -size / 2 to size / 2 - 1
};

// How far from 0 a frequency counts as being, and the weight of its direction.
struct Shaped {
  double length, weight;
};

Shaped ShapedOf(const SpectrumShape& shape, Frequency at) {
  const double angle = shape.direction * std::numbers::pi / 180;
  const double along = at.x * std::cos(angle) + at.y * std::sin(angle);
  const double across = at.y * std::cos(angle) - at.x * std::sin(angle);
  Shaped shaped{std::hypot(along, across * shape.stretch), 1};
  if (shape.spread > 0) {
    const double off = std::atan2(std::abs(across), std::abs(along)) * 180 / std::numbers::pi;
    shaped.weight = std::exp(-0.5 * Square(off / shape.spread));
  }
  return shaped;
}

struct PowerAt {
  Frequency at;
  uint32_t size;

  double operator()(const BandSpectrum& band) const {
    const auto [length, weight] = ShapedOf(band.shape, at);
    return weight * std::exp(-0.5 * Square((length - band.frequency) / band.bandwidth));
  }
  double operator()(const LobeSpectrum& lobe) const {
    const auto spot = [&](double x, double y) {
      return std::exp(-0.5 * (Square(at.x - x) + Square(at.y - y)) / Square(lobe.bandwidth));
    };
    return spot(lobe.x, lobe.y) + spot(-lobe.x, -lobe.y);
  }
  double operator()(const PowerLawSpectrum& law) const {
    const auto [length, weight] = ShapedOf(law.shape, at);
    const bool beyond = law.highest > 0 && length > law.highest;
    if (length == 0 || length < law.lowest || beyond) return 0;
    return weight * std::pow(length, -law.exponent);
  }
  // The mean of the part of the picture that stands for this frequency.
  double operator()(const PaintedSpectrum& painted) const {
    const Plane& plane = painted.power;
    const auto [x0, x1] = Part(at.x, plane.width);
    const auto [y0, y1] = Part(at.y, plane.height);
    double sum = 0;
    for (auto y = static_cast<uint32_t>(y0); y < plane.height && y < y1; ++y) {
      const double tall = std::min(y1, y + 1.0) - std::max(y0, 1.0 * y);
      for (auto x = static_cast<uint32_t>(x0); x < plane.width && x < x1; ++x)
        sum += tall * (std::min(x1, x + 1.0) - std::max(x0, 1.0 * x)) * double{plane.At(x, y)};
    }
    return sum / ((x1 - x0) * (y1 - y0));
  }

 private:
  std::pair<double, double> Part(double frequency, uint32_t texels) const {
    const double from = (frequency + size / 2) * texels / size;
    return {from, from + static_cast<double>(texels) / size};
  }
};

// Both of a frequency and its opposite: the noise is real.
void MakeEven(std::vector<double>& power, uint32_t size) {
  for (uint32_t y = 0; y < size; ++y) {
    for (uint32_t x = 0; x < size; ++x) {
      double& here = power[size_t{y} * size + x];
      double& there = power[size_t{(size - y) % size} * size + (size - x) % size];
      here = there = 0.5 * (here + there);
    }
  }
}

// Says what is wrong with a spectrum, if anything.
struct Complaint {
  uint32_t size;

  std::string operator()(const BandSpectrum& band) const {
    if (!Within(band.frequency, 0, Most())) return OutOf("frequency", band.frequency, 0, Most());
    if (!Within(band.bandwidth, kMinBandwidth, Most()))
      return OutOf("bandwidth", band.bandwidth, kMinBandwidth, Most());
    return OfShape(band.shape);
  }
  std::string operator()(const LobeSpectrum& lobe) const {
    for (const double part : {lobe.x, lobe.y}) {
      if (!Within(part, -Most(), Most())) return OutOf("frequency", part, -Most(), Most());
    }
    if (!Within(lobe.bandwidth, kMinBandwidth, Most()))
      return OutOf("bandwidth", lobe.bandwidth, kMinBandwidth, Most());
    return {};
  }
  std::string operator()(const PowerLawSpectrum& law) const {
    if (!Within(law.exponent, -8, 8)) return OutOf("exponent", law.exponent, -8, 8);
    if (!Within(law.lowest, 0, size)) return OutOf("lowest frequency", law.lowest, 0, size);
    if (law.highest != 0 && !Within(law.highest, law.lowest, size))
      return OutOf("highest frequency", law.highest, law.lowest, size);
    return OfShape(law.shape);
  }
  std::string operator()(const PaintedSpectrum& painted) const {
    const Plane& plane = painted.power;
    if (plane.values.empty() || plane.values.size() != size_t{plane.width} * plane.height)
      return "its picture has no pixels";
    if (!std::ranges::all_of(plane.values, [](float v) { return v >= 0 && std::isfinite(v); }))
      return "its picture has numbers that are not 0 or more";
    return {};
  }

 private:
  double Most() const { return size / 2 - 1.0; }
  static bool Within(double value, double least, double most) {
    return value >= least && value <= most;  // false for NaN
  }
  static std::string OutOf(std::string_view what, double value, double least, double most) {
    return fmt::format("its {} is {}; it can be {} to {}", what, value, least, most);
  }
  static std::string OfShape(const SpectrumShape& shape) {
    if (!Within(shape.direction, -360, 360)) return OutOf("direction", shape.direction, -360, 360);
    if (!Within(shape.stretch, 1, kMaxStretch))
      return OutOf("stretch", shape.stretch, 1, kMaxStretch);
    if (!Within(shape.spread, 0, 90)) return OutOf("spread", shape.spread, 0, 90);
    return {};
  }
};

std::string ComplaintOf(const NoiseSpectrum& spectrum, uint32_t size) {
  if (spectrum.empty()) return "it has no parts";
  for (const SpectrumPart& part : spectrum) {
    if (!(part.share > 0 && part.share <= 1e6)) {
      return fmt::format("the share of a part is {}; it can be above 0, up to 1,000,000",
                         part.share);
    }
    std::string complaint = std::visit(Complaint{size}, part.kind);
    if (!complaint.empty()) return complaint;
  }
  return {};
}

std::string ComplaintOf(const NoiseOptions& options, size_t channels) {
  const uint32_t size = options.size;
  if (size < kMinNoiseSize || size > kMaxNoiseSize || !std::has_single_bit(size)) {
    return fmt::format("its size is {}; it can be a power of two from {} to {}", size,
                       kMinNoiseSize, kMaxNoiseSize);
  }
  if (channels == 0 || channels > kMaxNoiseChannels)
    return fmt::format("it has {} channels; it can have 1 to {}", channels, kMaxNoiseChannels);
  if (!(options.sigma > 0 && options.sigma <= 1000)) {
    return fmt::format("its standard deviation is {}; it can be above 0, up to 1,000",
                       options.sigma);
  }
  const std::vector<double>& c = options.correlations;
  if (c.empty()) return {};
  if (c.size() != channels * channels) {
    return fmt::format("it has {} correlations; {} channels have {}", c.size(), channels,
                       channels * channels);
  }
  for (size_t i = 0; i < channels; ++i) {
    for (size_t j = 0; j <= i; ++j) {
      const double here = c[i * channels + j];
      const bool fits = i == j ? here == 1 : std::abs(here) <= 1;
      if (!fits || here != c[j * channels + i]) {
        return fmt::format(
            "channels {} and {} correlate by {} and {}; both have to be the same number from -1 "
            "to 1, and 1 for a channel with itself",
            i, j, here, c[j * channels + i]);
      }
    }
  }
  return {};
}

}  // namespace

std::optional<std::vector<double>> PowerOf(const NoiseSpectrum& spectrum, uint32_t size) {
  const size_t count = size_t{size} * size;
  double shares = 0;
  for (const SpectrumPart& part : spectrum) shares += part.share;
  std::vector<double> power(count);
  std::vector<double> one(count);
  for (const SpectrumPart& part : spectrum) {
    for (uint32_t y = 0; y < size; ++y) {
      for (uint32_t x = 0; x < size; ++x) {
        const auto signed_of = [&](uint32_t i) { return i < size / 2 ? 1.0 * i : 1.0 * i - size; };
        const PowerAt at{{signed_of(x), signed_of(y)}, size};
        one[size_t{y} * size + x] = std::visit(at, part.kind);
      }
    }
    one[0] = 0;
    MakeEven(one, size);
    double sum = 0;
    for (const double value : one) sum += value;
    if (!(sum > 0 && std::isfinite(sum))) return std::nullopt;
    for (size_t i = 0; i < count; ++i) power[i] += one[i] / sum * (part.share / shares);
  }
  return power;
}

bool CheckNoise(std::span<const NoiseSpectrum> channels, const NoiseOptions& options,
                std::string_view name, SourceRange range, Diagnostics& diagnostics) {
  std::string complaint = ComplaintOf(options, channels.size());
  for (size_t i = 0; complaint.empty() && i < channels.size(); ++i) {
    complaint = ComplaintOf(channels[i], options.size);
    if (!complaint.empty() && channels.size() > 1)
      complaint = fmt::format("in channel {}, {}", i, complaint);
  }
  if (complaint.empty()) return true;
  diagnostics.Error(DiagnosticKind::kValueRange, range,
                    fmt::format("noise '{}': {}", Printable(name), complaint));
  return false;
}

}  // namespace texgraph::textures
