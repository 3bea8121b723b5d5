// SPDX-License-Identifier: Apache-2.0
// Pictures as Gaussian noise (Heitz and Neyret 2018, Deliot and Heitz 2019): each channel, after a
// rotation to axes without correlation, becomes the quantiles of a normal distribution in the order
// of its values, and a table turns them back. A row of the table for each mip level of the exemplar
// gives the mean of what the filter took away: row l is blurred by the mean variance in a texel of
// level l, and stands at (l + 1/2) / rows. docs/decisions/0025-noise-preparation.md has the why.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/gaussian.h"
#include "compiler/textures/plane.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

inline constexpr size_t kMaxGaussianChannels = 4;
// The table goes so many standard deviations to both sides: 6 of 100,000 texels are beyond.
inline constexpr double kTableReach = 4;

struct GaussianOptions {
  double sigma = kNoiseSigma;
  bool decorrelate = true;  // else each channel is turned alone
  uint32_t columns = 256;   // of the table, 16 to 4,096
};

struct GaussianExemplar {
  double sigma = kNoiseSigma;
  std::vector<Plane> noise;  // as many as channels, mean 0; as large as the picture
  // A channel of the picture at c: mean[c] + the sum over the axes a of axes[a][c] times what the
  // table has for noise a.
  std::array<double, kMaxGaussianChannels> mean{};
  std::array<std::array<double, kMaxGaussianChannels>, kMaxGaussianChannels> axes{};
  uint32_t columns = 0;
  uint32_t rows = 0;                      // as many as levels
  std::vector<std::vector<float>> table;  // of each axis, row 0 first
  std::vector<std::vector<double>> lost;  // of each axis and row: the mean variance in a texel
};

// Where a table is read, from 0 to 1: `noise` in its own units, clamped; `level` may lie between
// two, and is clamped.
double TableColumn(double noise, double sigma);
double TableRow(double level, uint32_t rows);

// 1 to 4 channels of the same size, of any numbers; light should be linear, as means are taken.
// Texels of equal value are ordered by what is around them, so that flat areas stay smooth.
// Reported, naming `name`: kBadImage for channels, kValueRange for options, kSizeLimit,
// kOutOfMemory.
std::optional<GaussianExemplar> Gaussianize(std::span<const Plane> channels,
                                            const GaussianOptions& options, std::string_view name,
                                            SourceRange range, Diagnostics& diagnostics);

// What stands for a texel: the linear sum of the table's values, read as a GPU reads it.
std::array<double, kMaxGaussianChannels> TurnBack(const GaussianExemplar& exemplar,
                                                  std::span<const double> noise, double level);

// The noise as halves with all levels, repeat: axis a in channel a, 0 for those there are not.
// The table as halves, clamp, linear, one level: an array with a layer for each axis, which has
// what that axis adds to the channels, the first with the mean. So a channel of the picture is the
// sum of the layers, each read at its own noise, and a shader needs to know no axes.
TextureData NoiseTexture(const GaussianExemplar& exemplar);
TextureData TableTexture(const GaussianExemplar& exemplar);

}  // namespace texgraph::textures
