// SPDX-License-Identifier: Apache-2.0
// A pack of tiles, in one picture or in layers of 2 x 2 tiles (TileInLayer), as a texture whose
// levels are those of the virtual texture that is tiled from it: a texel of a level is the mean of
// its own tile alone where texels do not cross borders. The coarsest level, a texel a tile, is the
// mean of the set everywhere: from there on no pack can be right, as each tile would need all its
// neighbours, and what is left would flicker. The filter between levels fades to it.
#pragma once

#include <optional>
#include <string_view>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/image.h"
#include "compiler/textures/texels.h"
#include "compiler/textures/tile_packing.h"

namespace texgraph::textures {

// The coarsest level: a texel a tile, more if the size is no power of two.
uint32_t TileMaxLevel(uint32_t tile_size);

// Layers have four times the texels of the set: false, and kSizeLimit reported with what would do,
// if these are too many.
bool CheckTileLayers(const TilePackLayout& layout, std::string_view name, SourceRange range,
                     Diagnostics& diagnostics);

// `pack` as MakeTileSet makes it, or read from its file. `options` as in MakeTexture; slices, edges
// and weights are not looked at; wraps are repeat, but in one picture clamp upwards where there are
// gutters. Reported, naming `name`: kBadImage for a pack whose size is not the layout's,
// kSizeLimit, kOutOfMemory.
std::optional<TextureData> MakeTileTexture(const Image& pack, const TilePackLayout& layout,
                                           const TextureOptions& options, std::string_view name,
                                           SourceRange range, Diagnostics& diagnostics);

// Its second pack, MakeWeiCornerPack of `pack`: the coarsest level is the mean of the tiles of
// `pack`, so that both fade to the same. Of Wang tiles; `pack` is as large as the layout says.
std::optional<TextureData> MakeCornerTexture(const Image& pack, const TilePackLayout& layout,
                                             const TextureOptions& options, std::string_view name,
                                             SourceRange range, Diagnostics& diagnostics);

}  // namespace texgraph::textures
