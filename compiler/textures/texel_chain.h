// SPDX-License-Identifier: Apache-2.0
// The steps from pictures to a texture's bytes: decoded to linear floats, mip levels made of them,
// encoded in a format. Behind MakeTexture, and behind all textures that are made otherwise.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "compiler/textures/texels.h"

namespace texgraph::textures {

// Appends the picture's texels, row 0 at v = 0.
void AppendPicture(const Image& image, bool srgb, std::vector<ir::Texel>& texels);
// One texel as it is stored, as a shader sees it.
ir::Texel DecodeTexel(TexelFormat format, const uint8_t* from);
// That of the pictures' layers or slices: 16 bits if one of them has so many.
TexelFormat FormatFor(std::span<const Image> pictures, const TextureOptions& options);
ir::SamplerState SamplerFor(const TextureOptions& options);

// All texels of a coarse level that are transparent give their plain mean: this much of each counts
// as there. It is below half a step of 16 bits by far.
inline constexpr float kLeastOpacity = 0x1p-20f;
// Multiplies colours by their opacity, or divides them by it.
void WeighColors(std::span<ir::Texel> texels, bool divide);
// Of at least one texel, colours weighed by alpha where it is opacity.
ir::Texel MeanTexel(std::span<const ir::Texel> texels, bool alpha_is_opacity);

// The levels below level 0, as many as there are; colours weighed by alpha where it is opacity.
void BuildLevels(ir::Texture& chain, bool alpha_is_opacity);
// The levels as they are stored. Takes the texels of `chain` away as it goes, to save memory.
TextureData EncodeLevels(ir::Texture& chain, TexelFormat format);

// False, and reported at `range`, if `pixels` are more than kMaxImagePixels.
bool CheckPixels(uint64_t pixels, std::string_view name, SourceRange range,
                 Diagnostics& diagnostics);
// False, and reported as kBadImage, if the pictures differ in size; CheckPixels of them all.
bool CheckPictures(std::span<const Image> pictures, std::string_view name, SourceRange range,
                   Diagnostics& diagnostics);
// Reports kOutOfMemory.
void ReportNoMemory(std::string_view name, SourceRange range, Diagnostics& diagnostics);

}  // namespace texgraph::textures
