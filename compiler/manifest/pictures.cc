// SPDX-License-Identifier: Apache-2.0
#include "compiler/manifest/pictures.h"

#include <fmt/format.h>

#include <algorithm>

#include "compiler/base/files.h"

namespace texgraph::manifest {

textures::PictureSource PictureOf(const graph::Texture& texture, size_t layer,
                                  const std::string& folder) {
  textures::PictureSource source;
  source.file = JoinPath(folder, texture.files[layer]);
  source.range = texture.file_ranges[layer];
  source.srgb = texture.color_space == graph::ColorSpace::kSrgb;
  if (const graph::Mask* mask = texture.MaskOf(layer)) {
    source.mask = {JoinPath(folder, mask->file), mask->range,
                   static_cast<textures::MaskChannel>(mask->channel), mask->invert};
  }
  if (texture.key) {
    textures::ColorKey& key = source.key.emplace();
    std::ranges::transform(texture.key->color, key.color.begin(),
                           [](double number) { return static_cast<float>(number); });
    key.tolerance = static_cast<float>(texture.key->tolerance);
    key.edge = static_cast<uint32_t>(texture.key->edge);
  }
  return source;
}

std::string PreparedName(const graph::Graph& graph, uint32_t texture, size_t layer) {
  const graph::Texture& first = graph.textures[graph::FirstEqualTexture(graph, texture)];
  if (!first.is_array) return fmt::format("{}.{}.png", graph.name, first.name);
  return fmt::format("{}.{}.{}.png", graph.name, first.name, layer);
}

std::vector<bool> UsedTextures(const graph::Graph& graph, const ir::Module& module,
                               const glsl::ShaderInterface& shader) {
  std::vector<bool> used;
  for (uint32_t t = 0; t < graph.textures.size(); ++t) {
    const graph::Texture& sampled = graph.textures[graph::FirstEqualTexture(graph, t)];
    used.push_back(std::ranges::any_of(shader.textures, [&](const auto& entry) {
      return module.globals[entry.global.index].name == sampled.name;
    }));
  }
  return used;
}

}  // namespace texgraph::manifest
