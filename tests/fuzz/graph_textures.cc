// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/graph_textures.h"

#include <vector>

#include "compiler/manifest/pictures.h"

namespace texgraph::fuzz {

GraphTextures LoadGraphTextures(const graph::Graph& graph, const std::string& folder,
                                bool mipmaps) {
  GraphTextures loaded;
  for (const graph::Texture& texture : graph.textures) {
    std::vector<textures::Image> layers;
    Diagnostics diagnostics;
    for (size_t layer = 0; layer < texture.files.size(); ++layer) {
      auto image = textures::ReadPicture(manifest::PictureOf(texture, layer, folder), diagnostics);
      if (image) layers.push_back(std::move(*image));
    }
    if (layers.size() != texture.files.size()) continue;
    textures::TextureOptions how;
    how.srgb = texture.color_space == graph::ColorSpace::kSrgb;
    how.alpha_is_opacity = texture.alpha_is_opacity;
    how.mipmaps = texture.mipmaps && mipmaps;
    if (texture.max_level) how.max_level = static_cast<uint32_t>(*texture.max_level);
    how.filter = texture.filter == graph::TextureFilter::kNearest ? ir::Filter::kNearest
                                                                  : ir::Filter::kLinear;
    how.wrap_u = static_cast<ir::Wrap>(texture.wrap_u);
    how.wrap_v = static_cast<ir::Wrap>(texture.wrap_v);
    how.is_array = texture.is_array;
    how.as_float = true;
    auto data = MakeTexture(layers, how, texture.name, {}, diagnostics);
    if (!data) continue;
    loaded[std::string(texture.name)] = std::make_shared<textures::TextureData>(std::move(*data));
  }
  return loaded;
}

}  // namespace texgraph::fuzz
