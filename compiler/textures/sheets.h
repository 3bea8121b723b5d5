// SPDX-License-Identifier: Apache-2.0
// Many pictures in one: a sheet is cut into them, an atlas is made of them. In an atlas no texel of
// any mip level mixes two pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/image.h"
#include "compiler/textures/texels.h"

namespace texgraph::textures {

// The pictures of a sheet of `columns` times `rows` equal ones: from the left top corner, row by
// row. Reported, naming `name`: kBadImage if the sheet's size is not a multiple of the grid's.
std::optional<std::vector<Image>> CutSheet(const Image& sheet, uint32_t columns, uint32_t rows,
                                           std::string_view name, SourceRange range,
                                           Diagnostics& diagnostics);
// The check alone, from the size.
bool CheckSheet(const ImageInfo& sheet, uint32_t columns, uint32_t rows, std::string_view name,
                SourceRange range, Diagnostics& diagnostics);

// One 2D texture, `columns` pictures wide and as high as needed: the pictures stand as in a sheet,
// from the left top corner, row by row; places left over are transparent black.
// The levels are made for each picture alone, wrapped by itself, as long as both sides of a picture
// are even: the last has one texel a picture if they are equal powers of two. That is the sampler's
// max_level, too. `options` as in MakeTexture; `is_array` and `is_3d` are not looked at. Reported
// as in MakeTexture.
std::optional<TextureData> MakeAtlas(std::span<const Image> pictures, uint32_t columns,
                                     const TextureOptions& options, std::string_view name,
                                     SourceRange range, Diagnostics& diagnostics);

// The coarsest level of an atlas of such pictures.
uint32_t AtlasMaxLevel(uint32_t picture_width, uint32_t picture_height);

}  // namespace texgraph::textures
