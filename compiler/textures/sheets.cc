// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/sheets.h"

#include <fmt/format.h>
#include <string.h>

#include <algorithm>
#include <new>

#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

Image Cut(const Image& sheet, uint32_t columns, uint32_t rows, uint32_t index) {
  Image picture;
  static_cast<ImageInfo&>(picture) = sheet;
  picture.width = sheet.width / columns;
  picture.height = sheet.height / rows;
  const size_t bytes = picture.RowBytes();
  picture.pixels.resize(bytes * picture.height);
  const uint8_t* from = sheet.pixels.data() +
                        sheet.RowBytes() * picture.height * (index / columns) +
                        bytes * (index % columns);
  for (uint32_t y = 0; y < picture.height; ++y)
    memcpy(&picture.pixels[bytes * y], from + sheet.RowBytes() * y, bytes);
  return picture;
}

struct AtlasGrid {
  uint32_t columns;
  uint32_t rows;
};

// Puts `picture`, a level of one picture, at its place in the same level of the atlas, whose first
// row of pictures is its last of texels.
void Place(const ir::Texture::Level& picture, const AtlasGrid& grid, size_t index,
           ir::Texture::Level& atlas) {
  if (atlas.texels.empty()) {
    atlas.width = picture.width * grid.columns;
    atlas.height = picture.height * grid.rows;
    atlas.texels.resize(size_t{atlas.width} * atlas.height);
  }
  const size_t left = index % grid.columns * picture.width;
  const size_t bottom = (grid.rows - 1 - index / grid.columns) * picture.height;
  for (size_t y = 0; y < picture.height; ++y) {
    std::copy_n(picture.texels.begin() + static_cast<ptrdiff_t>(y * picture.width), picture.width,
                atlas.texels.begin() + static_cast<ptrdiff_t>((bottom + y) * atlas.width + left));
  }
}

TextureData BuildAtlas(std::span<const Image> pictures, const AtlasGrid& grid,
                       const TextureOptions& options) {
  uint32_t last = AtlasMaxLevel(pictures[0].width, pictures[0].height);
  if (options.max_level) last = std::min(last, *options.max_level);
  if (!options.mipmaps) last = 0;
  ir::Texture atlas;
  atlas.levels.resize(last + 1);
  TextureOptions flat = options;
  flat.is_array = flat.is_3d = false;
  flat.max_level = last;
  atlas.sampler = SamplerFor(flat);
  for (size_t i = 0; i < pictures.size(); ++i) {
    ir::Texture chain;
    ir::Texture::Level& base = chain.levels.emplace_back();
    base.width = pictures[i].width;
    base.height = pictures[i].height;
    AppendPicture(pictures[i], options.srgb, base.texels);
    if (last > 0) BuildLevels(chain, options.alpha_is_opacity);
    for (uint32_t level = 0; level <= last; ++level)
      Place(chain.levels[level], grid, i, atlas.levels[level]);
  }
  return EncodeLevels(atlas, FormatFor(pictures, options));
}

}  // namespace

bool CheckSheet(const ImageInfo& sheet, uint32_t columns, uint32_t rows, std::string_view name,
                SourceRange range, Diagnostics& diagnostics) {
  if (columns > 0 && rows > 0 && sheet.width % columns == 0 && sheet.height % rows == 0) {
    return true;
  }
  diagnostics.Error(DiagnosticKind::kBadImage, range,
                    fmt::format("the sheet of texture '{}' has {} x {} pixels, which is no "
                                "multiple of its grid of {} x {} pictures",
                                Printable(name), sheet.width, sheet.height, columns, rows));
  return false;
}

std::optional<std::vector<Image>> CutSheet(const Image& sheet, uint32_t columns, uint32_t rows,
                                           std::string_view name, SourceRange range,
                                           Diagnostics& diagnostics) {
  if (!CheckSheet(sheet, columns, rows, name, range, diagnostics)) return std::nullopt;
  try {
    std::vector<Image> pictures;
    pictures.reserve(size_t{columns} * rows);
    for (uint32_t i = 0; i < columns * rows; ++i) pictures.push_back(Cut(sheet, columns, rows, i));
    return pictures;
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

uint32_t AtlasMaxLevel(uint32_t picture_width, uint32_t picture_height) {
  uint32_t level = 0;
  for (uint32_t w = picture_width, h = picture_height; w > 0 && h > 0 && (w | h) % 2 == 0; w /= 2) {
    h /= 2;
    ++level;
  }
  return level;
}

std::optional<TextureData> MakeAtlas(std::span<const Image> pictures, uint32_t columns,
                                     const TextureOptions& options, std::string_view name,
                                     SourceRange range, Diagnostics& diagnostics) {
  if (pictures.empty() || columns == 0) {
    diagnostics.Error(DiagnosticKind::kBadImage, range,
                      fmt::format("the atlas of texture '{}' has no pictures", Printable(name)));
    return std::nullopt;
  }
  if (!CheckPictures(pictures, name, range, diagnostics)) return std::nullopt;
  const uint64_t rows = (pictures.size() + columns - 1) / columns;
  const uint64_t places = rows * columns;
  const uint64_t each = uint64_t{pictures[0].width} * pictures[0].height;
  // Saturated: the product may be beyond 64 bits.
  const uint64_t pixels = places > kMaxImagePixels ? places : places * each;
  if (!CheckPixels(pixels, name, range, diagnostics)) return std::nullopt;
  try {
    return BuildAtlas(pictures, {columns, static_cast<uint32_t>(rows)}, options);
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace texgraph::textures
