// SPDX-License-Identifier: Apache-2.0
// Pyramids of mean, variance and covariance (Grenier et al. 2022, equations 10 and 16): what a
// level's texel says of all texels of level 0 that it stands for, each counted alike. Levels halve
// down to 1 x 1; odd sizes are weighed by area, so a level's texels need not be powers of two.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/plane.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

struct MomentLevel {
  uint32_t width = 1;
  uint32_t height = 1;
  std::array<std::vector<float>, 2> mean;      // row 0 is v = 0; the second is empty for one field
  std::array<std::vector<float>, 2> variance;  // the square of the standard deviation
  std::vector<float> covariance;               // of the two fields; empty for one
};

struct MomentPyramid {
  size_t fields = 1;  // 1 or 2
  std::vector<MomentLevel> levels;
};

// How a stored number becomes a moment: moment = (stored - zero) / factor.
struct MomentCode {
  double factor = 1;
  double zero = 0;
};

enum class MomentFormat : uint8_t {
  kHalves,  // the moments themselves
  kBytes  // as the paper has them: means around 1/2, variances times 16 or, where that clips, less
};

struct MomentTextures {
  TextureData moments;                    // (mean, mean', variance, variance'); 0 for one field
  std::optional<TextureData> covariance;  // in red, for two fields
  MomentCode mean_code, variance_code, covariance_code;
};

// One field, or two of the same size. Reported, naming `name`: no field, more than two or different
// sizes (kBadImage), kSizeLimit, kOutOfMemory.
std::optional<MomentPyramid> MakeMoments(std::span<const Plane> fields, std::string_view name,
                                         SourceRange range, Diagnostics& diagnostics);

// All levels, repeat, linear between texels and levels. `with_covariance`: also that of two fields.
MomentTextures PackMoments(const MomentPyramid& pyramid, MomentFormat format, bool with_covariance);

}  // namespace texgraph::textures
