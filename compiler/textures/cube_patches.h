// SPDX-License-Identifier: Apache-2.0
// Which places of the sample the colours of a set of cubes stand for: random ones are tried, pairs
// are rated by what a seam between them costs at least, and of the best sets the one whose faces
// are cut best is taken.
#pragma once

#include <cstdint>
#include <vector>

#include "compiler/textures/cube_sample.h"
#include "compiler/textures/cube_set.h"

namespace texgraph::textures {

// Patches are searched where a cube has about so many texels a side.
inline constexpr uint32_t kCubeSearchSide = 8;

// How many scales of a sample the search needs.
uint32_t ScalesOfCube(uint32_t cube_size);

// Where the corner of a patch for each colour lies in the sample. The sample must be large enough.
std::vector<VoxelPlace> ChooseCubePatches(const CubeSample& sample, const CubeSetOptions& options);

}  // namespace texgraph::textures
