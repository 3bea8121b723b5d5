// SPDX-License-Identifier: Apache-2.0
// Sets of patterns, made of numbers, for tests of their mip levels.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "compiler/ir/texture.h"

namespace texgraph::textures::test {

enum class PatternKind {
  kMatching,  // smooth noise, the same near the borders of all patterns, other inside
  kSmooth,    // smooth noise that tiles by itself: no two patterns fit
  kWhite,     // each texel for itself
  kFlat,      // one colour a pattern
};

inline const char* NameOf(PatternKind kind) {
  const char* const names[] = {"Matching", "Smooth", "White", "Flat"};
  return names[static_cast<int>(kind)];
}

class PatternMaker {
 public:
  PatternMaker(PatternKind kind, uint32_t side, uint32_t layers, uint32_t seed)
      : kind_(kind), side_(side), layers_(layers), random_(seed) {}

  // An array with all its mip levels, opaque.
  ir::Texture Make() {
    ir::Texture texture;
    texture.is_array = true;
    texture.sampler.wrap_w = ir::Wrap::kClamp;
    ir::Texture::Level& level = texture.levels.emplace_back();
    level.width = level.height = side_;
    level.depth = layers_;
    level.texels.assign(size_t{side_} * side_ * layers_, {0.5f, 0.5f, 0.5f, 1.0f});
    for (size_t channel = 0; channel < 3; ++channel) Fill(level, channel);
    ir::BuildMipChain(texture);
    return texture;
  }

 private:
  double Uniform() { return static_cast<double>(random_() >> 8) * 0x1p-24; }

  void Fill(ir::Texture::Level& level, size_t channel) {
    const size_t plane = size_t{side_} * side_;
    for (size_t layer = 0; layer < layers_ && kind_ == PatternKind::kFlat; ++layer) {
      const auto color = static_cast<float>(Uniform());
      for (size_t i = 0; i < plane; ++i) level.texels[layer * plane + i][channel] = color;
    }
    if (kind_ == PatternKind::kWhite) {
      for (ir::Texel& texel : level.texels) texel[channel] = static_cast<float>(Uniform());
    }
    if (kind_ != PatternKind::kMatching && kind_ != PatternKind::kSmooth) return;
    const std::vector<double> common = Lattices();
    for (size_t layer = 0; layer < layers_; ++layer) {
      const std::vector<double> noise = Noise(common, Lattices());
      for (size_t i = 0; i < plane; ++i) {
        level.texels[layer * plane + i][channel] =
            static_cast<float>(std::clamp(0.5 + 0.6 * noise[i], 0.0, 1.0));
      }
    }
  }

  // The lattices of all octaves, one after the other.
  std::vector<double> Lattices() {
    std::vector<double> lattices;
    double amplitude = 0.5;
    for (uint32_t cells = 4; cells <= side_ / 2; cells *= 2, amplitude *= 0.6) {
      for (uint32_t i = 0; i < cells * cells; ++i)
        lattices.push_back(amplitude * (2 * Uniform() - 1));
    }
    return lattices;
  }

  // Value noise with wrap. Patterns that match have all lattice points in common that the noise
  // depends on in the cells along the borders.
  std::vector<double> Noise(const std::vector<double>& common, const std::vector<double>& own) {
    std::vector<double> sum(size_t{side_} * side_);
    size_t begin = 0;
    for (uint32_t cells = 4; cells <= side_ / 2; cells *= 2) {
      std::vector<double> lattice(size_t{cells} * cells);
      for (uint32_t i = 0; i < cells * cells; ++i) {
        const uint32_t x = (i % cells + 1) % cells, y = (i / cells + 1) % cells;
        const bool shared = kind_ == PatternKind::kMatching && std::min(x, y) < 4;
        lattice[i] = (shared ? common : own)[begin + i];
      }
      begin += lattice.size();
      for (uint32_t i = 0; i < side_ * side_; ++i)
        sum[i] += Interpolate(lattice, cells, i % side_, i / side_);
    }
    return sum;
  }
  double Interpolate(const std::vector<double>& lattice, uint32_t cells, uint32_t x,
                     uint32_t y) const {
    // Borders lie elsewhere in the cells of each octave: the noise is smoothest within them.
    const double shift = std::fmod(0.3819660 * std::log2(cells), 1.0);
    const double u = (x + 0.5) * cells / side_ + shift, v = (y + 0.5) * cells / side_ + shift;
    const auto i = static_cast<uint32_t>(u), j = static_cast<uint32_t>(v);
    const double a = Fade(u - i), b = Fade(v - j);
    const auto at = [&](uint32_t p, uint32_t q) { return lattice[q % cells * cells + p % cells]; };
    return (1 - b) * ((1 - a) * at(i, j) + a * at(i + 1, j)) +
           b * ((1 - a) * at(i, j + 1) + a * at(i + 1, j + 1));
  }
  static double Fade(double t) { return t * t * (3 - 2 * t); }

  PatternKind kind_;
  uint32_t side_, layers_;
  std::mt19937 random_;
};

// A random tiling of the patterns of an array: which stands in a cell.
class Tiling {
 public:
  Tiling(std::vector<double> shares, uint32_t seed) : shares_(std::move(shares)), seed_(seed) {}

  uint32_t At(int64_t x, int64_t y) const {
    uint64_t h = seed_ + static_cast<uint64_t>(x) * 0x9e3779b97f4a7c15u +
                 static_cast<uint64_t>(y) * 0xc2b2ae3d27d4eb4fu;
    for (int i = 0; i < 2; ++i) {
      h = (h ^ h >> 31) * 0xbf58476d1ce4e5b9u;
      h ^= h >> 29;
    }
    double random = static_cast<double>(h >> 11) * 0x1p-53;
    for (uint32_t k = 0; k + 1 < shares_.size(); ++k) {
      if (random < shares_[k]) return k;
      random -= shares_[k];
    }
    return static_cast<uint32_t>(shares_.size() - 1);
  }

  // What a shader shows at a point of the plane, one tile a unit.
  ir::Texel Sample(const ir::Texture& patterns, double x, double y, float lod) const {
    const double i = std::floor(x), j = std::floor(y);
    const auto layer = At(static_cast<int64_t>(i), static_cast<int64_t>(j));
    const float at[] = {static_cast<float>(x - i), static_cast<float>(y - j),
                        static_cast<float>(layer)};
    return ir::SampleLod(patterns, at, lod);
  }

 private:
  std::vector<double> shares_;
  uint32_t seed_;
};

}  // namespace texgraph::textures::test
