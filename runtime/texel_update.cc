// SPDX-License-Identifier: Apache-2.0
#include "runtime/texel_update.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "compiler/textures/half.h"
#include "compiler/textures/maps.h"

namespace texgraph::runtime {
namespace {

constexpr int32_t kMaxHalfNumber = 2048;  // every whole number up to it is a half

}  // namespace

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

bool EncodeNumbers(std::span<const int32_t> numbers, const textures::TextureData& data,
                   std::optional<uint32_t> count, TexelUpdate& update, Diagnostics& diagnostics) {
  const bool is_half = data.format == textures::TexelFormat::kR16F;
  if (!is_half && data.format != textures::TexelFormat::kR32F) {
    diagnostics.Error(
        DiagnosticKind::kPortType, {},
        fmt::format("texture '{}' holds no whole numbers", Printable(update.texture)));
    return false;
  }
  int32_t most = is_half ? kMaxHalfNumber : textures::kMaxMapNumber;
  if (count) most = std::min(most, static_cast<int32_t>(*count) - 1);
  update.texels.clear();
  for (int32_t number : numbers) {
    if (number < -1 || number > most) {
      diagnostics.Error(DiagnosticKind::kValueRange, {},
                        fmt::format("texture '{}' takes numbers from -1 to {}, not {}",
                                    Printable(update.texture), most, number));
      return false;
    }
    const auto value = static_cast<float>(number);
    const uint16_t half = textures::FloatToHalf(value);
    const size_t before = update.texels.size();
    update.texels.resize(before + (is_half ? sizeof half : sizeof value));
    std::memcpy(update.texels.data() + before, is_half ? static_cast<const void*>(&half) : &value,
                update.texels.size() - before);
  }
  return true;
}

}  // namespace texgraph::runtime
