// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/sprites.h"

#include <fmt/format.h>
#include <string.h>

#include <algorithm>
#include <cmath>
#include <new>

#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

constexpr std::array<float, 4> kEmpty{0, 0, -1, 1};

// The cells, of 0 to size - 1, that a unit length from `at` covers more than a point of.
struct Span {
  uint32_t first = 0;
  uint32_t count = 0;
};

Span SpanOf(double at, uint32_t size) {
  if (!(at > -1.0 && at < static_cast<double>(size))) return {};  // NaN, too
  const double below = std::floor(at);
  const double end = std::min(below == at ? below + 1 : below + 2, static_cast<double>(size));
  const double first = std::max(below, 0.0);
  return {static_cast<uint32_t>(first), static_cast<uint32_t>(end - first)};
}

std::string MessageOf(SpriteGrid::Failure failure, const Sprite& sprite, const SpriteGrid& grid,
                      uint32_t patterns, std::string_view name) {
  switch (failure) {
    case SpriteGrid::Failure::kNoSuchPattern:
      return fmt::format("a sprite of texture '{}' shows pattern {}; there are {}, counted from 0",
                         Printable(name), sprite.pattern, patterns);
    case SpriteGrid::Failure::kOutside:
      return fmt::format(
          "a sprite of texture '{}' stands at ({}, {}), outside of its {} x {} cells",
          Printable(name), sprite.x, sprite.y, grid.width(), grid.height());
    default:
      return fmt::format("more than {} sprites of texture '{}' touch one cell", grid.layers(),
                         Printable(name));
  }
}

}  // namespace

SpriteGrid::SpriteGrid(uint32_t width, uint32_t height, uint32_t layers, uint32_t patterns)
    : width_(width),
      height_(height),
      layers_(layers),
      patterns_(patterns),
      cells_(size_t{width} * height),
      texels_(cells_.size() * layers, kEmpty),
      seen_(texels_) {}

SpriteGrid::Cells SpriteGrid::CellsOf(const Sprite& sprite) const {
  const Span x = SpanOf(sprite.x, width_);
  const Span y = SpanOf(sprite.y, height_);
  Cells cells;
  for (uint32_t j = 0; j < y.count; ++j) {
    for (uint32_t i = 0; i < x.count; ++i)
      cells.index[cells.count++] = (y.first + j) * width_ + x.first + i;
  }
  return cells;
}

SpriteGrid::Failure SpriteGrid::Check(const Sprite& sprite, const Cells& cells,
                                      const Cells& leaving) const {
  if (sprite.pattern < 0 || static_cast<uint32_t>(sprite.pattern) >= patterns_) {
    return Failure::kNoSuchPattern;
  }
  if (cells.count == 0) return Failure::kOutside;
  const auto left = leaving.index.begin() + leaving.count;
  for (uint32_t i = 0; i < cells.count; ++i) {
    const bool was_here = std::find(leaving.index.begin(), left, cells.index[i]) != left;
    if (cells_[cells.index[i]].size() - (was_here ? 1 : 0) >= layers_) {
      return Failure::kTooManyInACell;
    }
  }
  return Failure::kNone;
}

void SpriteGrid::Put(Id id) {
  const Cells cells = CellsOf(*sprites_[id]);
  for (uint32_t i = 0; i < cells.count; ++i) {
    std::vector<Id>& here = cells_[cells.index[i]];
    here.insert(std::ranges::lower_bound(here, id), id);
    WriteCell(cells.index[i]);
  }
}

void SpriteGrid::Take(Id id) {
  const Cells cells = CellsOf(*sprites_[id]);
  for (uint32_t i = 0; i < cells.count; ++i) {
    std::erase(cells_[cells.index[i]], id);
    WriteCell(cells.index[i]);
  }
}

void SpriteGrid::WriteCell(uint32_t cell) {
  const std::vector<Id>& here = cells_[cell];
  for (uint32_t layer = 0; layer < layers_; ++layer) {
    std::array<float, 4>& texel = texels_[size_t{layer} * cells_.size() + cell];
    texel = kEmpty;
    if (layer >= here.size()) continue;
    const Sprite& sprite = *sprites_[here[layer]];
    texel[0] = static_cast<float>(sprite.x - cell % width_);
    texel[1] = static_cast<float>(sprite.y - cell / width_);
    texel[2] = static_cast<float>(sprite.pattern);
  }
  dirty_.push_back(cell);
}

SpriteGrid::Failure SpriteGrid::Add(const Sprite& sprite, Id& id) {
  const Failure failure = Check(sprite, CellsOf(sprite), {});
  if (failure != Failure::kNone) return failure;
  id = static_cast<Id>(sprites_.size());
  sprites_.emplace_back(sprite);
  Put(id);
  return Failure::kNone;
}

SpriteGrid::Failure SpriteGrid::Move(Id id, const Sprite& to) {
  if (id >= sprites_.size() || !sprites_[id]) return Failure::kNoSuchSprite;
  const Failure failure = Check(to, CellsOf(to), CellsOf(*sprites_[id]));
  if (failure != Failure::kNone) return failure;
  Take(id);
  sprites_[id] = to;
  Put(id);
  return Failure::kNone;
}

SpriteGrid::Failure SpriteGrid::Remove(Id id) {
  if (id >= sprites_.size() || !sprites_[id]) return Failure::kNoSuchSprite;
  Take(id);
  sprites_[id].reset();
  return Failure::kNone;
}

std::vector<SpriteGrid::Texel> SpriteGrid::TakeChanges() {
  std::ranges::sort(dirty_);
  const auto rest = std::ranges::unique(dirty_);
  dirty_.erase(rest.begin(), rest.end());
  std::vector<Texel> changes;
  for (uint32_t layer = 0; layer < layers_; ++layer) {
    for (uint32_t cell : dirty_) {
      const size_t index = size_t{layer} * cells_.size() + cell;
      if (texels_[index] == seen_[index]) continue;
      seen_[index] = texels_[index];
      changes.push_back({cell % width_, cell / width_, layer, texels_[index]});
    }
  }
  dirty_.clear();
  return changes;
}

uint32_t SpriteLayersNeeded(std::span<const PlacedSprite> sprites, uint32_t width,
                            uint32_t height) {
  std::vector<uint32_t> counts(size_t{width} * height);
  uint32_t most = 1;
  for (const PlacedSprite& placed : sprites) {
    const Span x = SpanOf(placed.sprite.x, width);
    const Span y = SpanOf(placed.sprite.y, height);
    for (uint32_t j = y.first; j < y.first + y.count; ++j) {
      for (uint32_t i = x.first; i < x.first + x.count; ++i)
        most = std::max(most, ++counts[size_t{j} * width + i]);
    }
  }
  return most;
}

std::optional<TextureData> SpritesTexture(std::span<const PlacedSprite> sprites, uint32_t width,
                                          uint32_t height, std::optional<uint32_t> layers,
                                          uint32_t patterns, std::string_view name,
                                          SourceRange range, Diagnostics& diagnostics) try {
  const uint64_t cells = uint64_t{width} * height;
  if (cells == 0 || cells > kMaxSpriteTexels || layers > kMaxSpriteLayers) {
    diagnostics.Error(DiagnosticKind::kSizeLimit, range,
                      fmt::format("texture '{}' has {} x {} cells of {} sprites; the limits are {} "
                                  "cells and {} sprites in each",
                                  Printable(name), width, height, layers.value_or(1),
                                  kMaxSpriteTexels, kMaxSpriteLayers));
    return std::nullopt;
  }
  const uint32_t needed =
      layers.value_or(std::min(SpriteLayersNeeded(sprites, width, height), kMaxSpriteLayers));
  if (cells * needed > kMaxSpriteTexels) {
    diagnostics.Error(DiagnosticKind::kSizeLimit, range,
                      fmt::format("texture '{}' has {} texels; the limit is {}", Printable(name),
                                  cells * needed, kMaxSpriteTexels));
    return std::nullopt;
  }
  SpriteGrid grid(width, height, needed, patterns);
  bool all = true;
  for (const PlacedSprite& placed : sprites) {
    SpriteGrid::Id id;
    const SpriteGrid::Failure failure = grid.Add(placed.sprite, id);
    if (failure == SpriteGrid::Failure::kNone) continue;
    diagnostics.Error(DiagnosticKind::kValueRange, placed.range,
                      MessageOf(failure, placed.sprite, grid, patterns, name));
    all = false;
  }
  if (!all) return std::nullopt;
  TextureData data;
  data.format = TexelFormat::kRgba32F;
  data.is_array = true;
  data.layers = needed;
  // The map does not wrap sprites; a shader that asks beyond its borders gets what a map gives.
  data.sampler.wrap_w = ir::Wrap::kClamp;
  data.sampler.filter = ir::Filter::kNearest;
  data.sampler.mip_filter = ir::MipFilter::kNone;
  TexelLevel& level = data.levels.emplace_back();
  level.width = width;
  level.height = height;
  level.bytes.resize(grid.texels().size() * sizeof grid.texels()[0]);
  memcpy(level.bytes.data(), grid.texels().data(), level.bytes.size());
  return data;
} catch (const std::bad_alloc&) {
  ReportNoMemory(name, range, diagnostics);
  return std::nullopt;
}

}  // namespace texgraph::textures
