// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_levels.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>
#include <span>

#include "compiler/textures/texel_chain.h"
#include "compiler/textures/tile_pictures.h"

namespace texgraph::textures {
namespace {

// The mean of the tiles alone: gutters would count some of them twice.
ir::Texel MeanOfTiles(const ir::Texture::Level& level, const TilePackLayout& layout,
                      bool alpha_is_opacity) {
  const size_t first = size_t{layout.gutter} * level.width;
  const size_t texels = size_t{layout.rows} * layout.tile_size * level.width;
  return MeanTexel(std::span(level.texels).subspan(first, texels), alpha_is_opacity);
}

// A level 0 of the picture.
ir::Texture::Level BaseLevel(const Image& picture, bool srgb) {
  ir::Texture::Level base;
  base.width = picture.width;
  base.height = picture.height;
  base.texels.reserve(size_t{picture.width} * picture.height);
  AppendPicture(picture, srgb, base.texels);
  return base;
}

// The tiles of a pack in layers of 2 x 2.
ir::Texture::Level InLayers(const ir::Texture::Level& pack, const TilePackLayout& layout) {
  const uint32_t size = layout.tile_size, side = 2 * size;
  ir::Texture::Level layers;
  layers.width = layers.height = side;
  layers.depth = layout.tiles();
  layers.texels.resize(size_t{side} * side * layers.depth);
  for (uint32_t tile = 0; tile < 4 * layers.depth; ++tile) {
    const uint32_t layer = tile / 4, column = tile % 2, row = tile / 2 % 2;
    const TilePlace from = PackedTile(layout, TileInLayer(layout, layer, column, row));
    for (uint32_t y = 0; y < size; ++y) {
      const size_t pack_row = layout.gutter + size_t{from.y} * size + y;
      const size_t layer_row = size_t{layer} * side + size_t{row} * size + y;
      std::copy_n(pack.texels.begin() + pack_row * pack.width + size_t{from.x} * size, size,
                  layers.texels.begin() + layer_row * side + size_t{column} * size);
    }
  }
  return layers;
}

// `corners`: Wei's second pack instead of the tiles themselves.
TextureData BuildTexture(const Image& pack, const TilePackLayout& layout, bool corners,
                         const TextureOptions& options) {
  const uint32_t coarsest = TileMaxLevel(layout.tile_size);
  uint32_t last = options.mipmaps ? coarsest : 0;
  if (options.max_level) last = std::min(last, *options.max_level);
  TextureOptions flat = options;
  flat.is_3d = false;
  flat.max_level = last;
  flat.wrap_u = ir::Wrap::kRepeat;
  flat.wrap_v = layout.gutter > 0 && !options.is_array ? ir::Wrap::kClamp : ir::Wrap::kRepeat;
  ir::Texture chain;
  chain.sampler = SamplerFor(flat);
  chain.is_array = options.is_array;
  ir::Texture::Level tiles = BaseLevel(pack, options.srgb);
  ir::Texel mean{};
  if (last > 0 && last == coarsest) mean = MeanOfTiles(tiles, layout, options.alpha_is_opacity);
  if (corners) tiles = BaseLevel(MakeWeiCornerPack(pack, layout), options.srgb);
  chain.levels.push_back(options.is_array ? InLayers(tiles, layout) : std::move(tiles));
  if (last > 0) BuildLevels(chain, options.alpha_is_opacity);
  chain.levels.resize(last + 1);
  if (last > 0 && last == coarsest) {
    for (ir::Texel& texel : chain.levels[last].texels) texel = mean;
  }
  return EncodeLevels(chain, FormatFor({&pack, 1}, options));
}

}  // namespace

uint32_t TileMaxLevel(uint32_t tile_size) {
  return static_cast<uint32_t>(std::bit_width(tile_size)) - 1;
}

namespace {

std::optional<TextureData> CheckAndBuild(const Image& pack, const TilePackLayout& layout,
                                         bool corners, const TextureOptions& options,
                                         std::string_view name, SourceRange range,
                                         Diagnostics& diagnostics) {
  if (pack.width != layout.width() || pack.height != layout.height()) {
    diagnostics.Error(
        DiagnosticKind::kBadImage, range,
        fmt::format(
            "the tiles of texture '{}' have {} x {} pixels; {} x {} tiles of {} take {} x {}",
            Printable(name), pack.width, pack.height, layout.columns, layout.rows, layout.tile_size,
            layout.width(), layout.height()));
    return std::nullopt;
  }
  if (options.is_array
          ? !CheckTileLayers(layout, name, range, diagnostics)
          : !CheckPixels(uint64_t{pack.width} * pack.height, name, range, diagnostics)) {
    return std::nullopt;
  }
  try {
    return BuildTexture(pack, layout, corners, options);
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace

bool CheckTileLayers(const TilePackLayout& layout, std::string_view name, SourceRange range,
                     Diagnostics& diagnostics) {
  const uint64_t tiles = 4 * uint64_t{layout.tiles()};
  const uint64_t size = layout.tile_size;
  if (tiles * size * size <= kMaxImagePixels) return true;
  auto largest = static_cast<uint64_t>(std::sqrt(static_cast<double>(kMaxImagePixels / tiles)));
  diagnostics.Error(
      DiagnosticKind::kSizeLimit, range,
      fmt::format(
          "the tiles of '{}' have {} texels a side; in layers, where each stands four times, "
          "up to {} are possible; \"pack\": \"atlas\" has each once",
          Printable(name), layout.tile_size, largest));
  return false;
}

std::optional<TextureData> MakeTileTexture(const Image& pack, const TilePackLayout& layout,
                                           const TextureOptions& options, std::string_view name,
                                           SourceRange range, Diagnostics& diagnostics) {
  return CheckAndBuild(pack, layout, false, options, name, range, diagnostics);
}

std::optional<TextureData> MakeCornerTexture(const Image& pack, const TilePackLayout& layout,
                                             const TextureOptions& options, std::string_view name,
                                             SourceRange range, Diagnostics& diagnostics) {
  return CheckAndBuild(pack, layout, true, options, name, range, diagnostics);
}

}  // namespace texgraph::textures
