// SPDX-License-Identifier: Apache-2.0
// Complete sets of cubes made of one solid sample: a tiling of space by the colours at their
// corners (cube_packing.h) looks like the sample and has no jumps at the faces. Every texel of a
// cube is one of the sample's, unchanged; only combinations are new: each cube is divided among
// patches of the sample, one a colour (cube_parts.h). The same input gives the same cubes on every
// machine and with any number of threads. docs/decisions/0024-cube-tiles.md has the why.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/cube_packing.h"
#include "compiler/textures/cube_sample.h"
#include "compiler/textures/image.h"

namespace texgraph::textures {

inline constexpr uint32_t kMinCubeCandidates = 8;
inline constexpr uint32_t kMaxCubeCandidates = 256;

struct CubeSetOptions {
  uint32_t colors = 2;      // kMinCubeColors to kMaxCubeColors
  uint32_t cube_size = 16;  // texels
  bool wraps = false;       // the sample is periodic itself, along all axes
  uint32_t seed = 0;
  uint32_t candidates = 64;  // patches among which the best are searched
  uint32_t threads = 0;      // 0: as many as there are cores
};

struct CubeSet {
  CubePackLayout layout;
  // The layers of texels above each other, that of w = 0 the lowest, with the sample's channels and
  // bits: the row at y in the layer z is row z * width + y from below.
  Image pack;
  // Where the corner of a patch for each colour lies in the sample: 3/4 of a cube around it are
  // used.
  std::vector<VoxelPlace> corners;
  // Mean absolute differences of texels on both sides of a seam, as parts of those of neighbours in
  // the sample along the same axis: 1 is what the sample has itself.
  double seams = 0;
};

// The least extent of a sample for cubes of this size, along each axis.
uint32_t LeastSolid(uint32_t cube_size, bool wraps);
// The largest cube whose pack is within the limits.
uint32_t LargestCube(uint32_t colors);

// False, with all that is wrong reported and what would do: kSizeLimit for colours, sizes and
// candidates beyond the limits, kBadImage for a sample that is too small.
bool CheckCubeSet(const CubeSetOptions& options, const std::array<uint32_t, 3>& sample,
                  std::string_view name, SourceRange range, Diagnostics& diagnostics);

// `slices`: the sample's, from w = 0 up. Reported, naming `name`: all of CheckCubeSet, kBadImage
// for no slices or slices of different sizes, kOutOfMemory.
std::optional<CubeSet> MakeCubeSet(std::span<const Image> slices, const CubeSetOptions& options,
                                   std::string_view name, SourceRange range,
                                   Diagnostics& diagnostics);

}  // namespace texgraph::textures
