// SPDX-License-Identifier: Apache-2.0
#include "runtime/texel_update.h"

#include <fmt/format.h>

namespace texgraph::runtime {

bool CheckUpdate(const TexelUpdate& update, const textures::TextureData& data,
                 Diagnostics& diagnostics) {
  const auto refuse = [&](std::string text) {
    diagnostics.Error(DiagnosticKind::kValueRange, {},
                      fmt::format("texture '{}' {}", Printable(update.texture), text));
    return false;
  };
  if (update.level >= data.levels.size()) {
    return refuse(fmt::format("has {} levels; there is no level {} to change", data.levels.size(),
                              update.level));
  }
  const textures::TexelLevel& level = data.levels[update.level];
  const uint32_t layers = data.is_3d ? level.depth : data.layers;
  const bool is_inside = update.width >= 1 && update.height >= 1 && update.layer < layers &&
                         uint64_t{update.x} + update.width <= level.width &&
                         uint64_t{update.y} + update.height <= level.height;
  if (!is_inside) {
    return refuse(
        fmt::format("has {} x {} texels and {} layers at level {}; {} x {} texels at ({}, {}) in "
                    "layer {} are not all among them",
                    level.width, level.height, layers, update.level, update.width, update.height,
                    update.x, update.y, update.layer));
  }
  const uint64_t bytes = uint64_t{update.width} * update.height * textures::TexelBytes(data.format);
  if (update.texels.size() == bytes) return true;
  return refuse(fmt::format("needs {} bytes for {} x {} texels, not {}", bytes, update.width,
                            update.height, update.texels.size()));
}

}  // namespace texgraph::runtime
