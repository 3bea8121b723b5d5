// SPDX-License-Identifier: Apache-2.0
#include "runtime/live_sprites.h"

#include <fmt/format.h>

#include <array>
#include <cstring>

namespace texgraph::runtime {
namespace {

using Value = std::array<float, 4>;

void Append(const Value* values, size_t count, std::vector<uint8_t>& bytes) {
  const size_t before = bytes.size();
  bytes.resize(before + count * sizeof(Value));
  std::memcpy(bytes.data() + before, values, count * sizeof(Value));
}

}  // namespace

LiveSprites::LiveSprites(std::string texture, const textures::TextureData& data, uint32_t patterns)
    : texture_(std::move(texture)),
      patterns_(patterns),
      grid_(data.levels[0].width, data.levels[0].height, data.layers, patterns) {}

std::optional<LiveSprites> LiveSprites::Open(const LiveRenderer& renderer, std::string_view texture,
                                             Diagnostics& diagnostics) {
  const auto found = renderer.FindTexture(texture);
  if (!found) {
    diagnostics.Error(DiagnosticKind::kUnknownReference, {},
                      fmt::format("the shader uses no texture '{}'", Printable(texture)));
    return std::nullopt;
  }
  const textures::TextureData& data = *found->data;
  const std::optional<ManifestMap>& map = found->texture->map;
  const bool has_sprites = map && map->holds == MapContents::kSprites && map->count;
  if (!has_sprites || !data.is_array || data.format != textures::TexelFormat::kRgba32F ||
      data.levels.size() != 1 || data.layers > textures::kMaxSpriteLayers) {
    diagnostics.Error(DiagnosticKind::kPortType, {},
                      fmt::format("texture '{}' holds no sprites", Printable(texture)));
    return std::nullopt;
  }
  return LiveSprites(std::string(texture), data, *map->count);
}

std::vector<TexelUpdate> LiveSprites::TakeUpdates() {
  std::vector<TexelUpdate> updates;
  const std::vector<textures::SpriteGrid::Texel> changes = grid_.TakeChanges();
  if (!has_sent_) {
    const size_t count = size_t{grid_.width()} * grid_.height();
    for (uint32_t layer = 0; layer < grid_.layers(); ++layer) {
      TexelUpdate& update = updates.emplace_back();
      update.texture = texture_;
      update.layer = layer;
      update.width = grid_.width();
      update.height = grid_.height();
      Append(grid_.texels().data() + layer * count, count, update.texels);
    }
    has_sent_ = true;
    return updates;
  }
  for (const textures::SpriteGrid::Texel& texel : changes) {
    const bool goes_on = !updates.empty() && updates.back().layer == texel.layer &&
                         updates.back().y == texel.y &&
                         updates.back().x + updates.back().width == texel.x;
    if (goes_on) {
      ++updates.back().width;
    } else {
      TexelUpdate& update = updates.emplace_back();
      update.texture = texture_;
      update.x = texel.x;
      update.y = texel.y;
      update.layer = texel.layer;
    }
    Append(&texel.value, 1, updates.back().texels);
  }
  return updates;
}

std::optional<size_t> LiveSprites::Send(LiveRenderer& renderer, Diagnostics& diagnostics) {
  size_t texels = 0;
  for (const TexelUpdate& update : TakeUpdates()) {
    if (!renderer.UpdateTexels(update, diagnostics)) return std::nullopt;
    texels += size_t{update.width} * update.height;
  }
  return texels;
}

}  // namespace texgraph::runtime
