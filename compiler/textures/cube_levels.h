// SPDX-License-Identifier: Apache-2.0
// A pack of cubes as a texture with three axes, whose levels are those of the virtual volume that
// is tiled from it: a texel of a level is the mean of its own cube alone where texels do not cross
// faces. The coarsest level, a texel a cube, is the mean of the set everywhere, as in
// tile_levels.h.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/cube_set.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

// `options` as in MakeTexture; arrays, slices, wraps, edges and weights are not looked at.
// Reported, naming `name`: kOutOfMemory.
std::optional<TextureData> MakeCubeTexture(const CubeSet& set, const TextureOptions& options,
                                           std::string_view name, SourceRange range,
                                           Diagnostics& diagnostics);

}  // namespace texgraph::textures
