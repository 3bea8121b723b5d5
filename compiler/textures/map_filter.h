// SPDX-License-Identifier: Apache-2.0
// Colour maps over two noises, prefiltered (Grenier et al. 2022, equations 5 and 6; Heitz et al.
// 2014): what a map becomes in the mean where its coordinates are Gaussian with a given mean and
// given standard deviations. An exact convolution of the map as a sampler sees it, linear between
// texels and clamped to its edge, in linear light; a layer for each pair of standard deviations.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/image.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

inline constexpr uint32_t kMaxMapSigmas = 8;    // along each axis
inline constexpr uint32_t kMaxColorMap = 1024;  // texels a side

struct MapFilterOptions {
  // Standard deviations along each axis: the first is 0, where the layer is the map itself; each
  // other is twice the one before it, up to `greatest`.
  uint32_t sigmas = 7;
  double greatest = 0.25;  // in units of the map; noise as kNoiseSigma has it needs 1/6 and more
  uint32_t threads = 0;    // 0: as many as there are cores
};

// That of an index below `options.sigmas`.
double SigmaAt(const MapFilterOptions& options, uint32_t index);

// Between which indices a standard deviation lies, as index + fraction. The mix of the two layers
// has exactly this variance: fractions are those of squares, not of logarithms, which blur up to
// an eighth more and have no place for 0. Clamped to what there is; NaN gives 0.
double SigmaIndex(const MapFilterOptions& options, double sigma);

// The layer of two indices.
inline uint32_t MapLayer(const MapFilterOptions& options, uint32_t x, uint32_t y) {
  return y * options.sigmas + x;
}

// False, and reported at `range`, naming `name`: kValueRange for options, kSizeLimit for a map that
// is too large.
bool CheckColorMap(uint32_t width, uint32_t height, const MapFilterOptions& options,
                   std::string_view name, SourceRange range, Diagnostics& diagnostics);

// An array of sigmas^2 layers without mip levels: clamp, linear. Of `texture` counts whether the
// numbers are sRGB, whether alpha is opacity (colours are weighed by it) and `as_float`; 16 bits as
// in MakeTexture. Reported, naming `name`: all of CheckColorMap, kOutOfMemory.
std::optional<TextureData> MakeColorMap(const Image& map, const TextureOptions& texture,
                                        const MapFilterOptions& options, std::string_view name,
                                        SourceRange range, Diagnostics& diagnostics);

}  // namespace texgraph::textures
