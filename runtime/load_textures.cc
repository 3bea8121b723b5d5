// SPDX-License-Identifier: Apache-2.0
#include <set>

#include "compiler/base/files.h"
#include "runtime/render.h"

namespace texgraph::runtime {

bool LoadTextures(const Manifest& manifest, const std::string& folder,
                  std::vector<TextureBinding>& textures, Diagnostics& diagnostics,
                  const Roots& roots) {
  bool all = true;
  std::set<std::string_view> variables;
  for (const ManifestTexture& texture : manifest.textures) {
    if (!texture.is_used || !variables.insert(texture.variable).second) continue;
    std::vector<textures::Image> layers;
    for (size_t layer = 0; layer < texture.files.size(); ++layer) {
      textures::PictureSource source;
      source.file = JoinPath(folder, texture.files[layer]);
      source.range = texture.place;
      source.srgb = texture.options.srgb;
      source.key = texture.key;
      if (!texture.masks.empty()) {
        source.mask = texture.masks[texture.masks.size() == 1 ? 0 : layer];
        source.mask->file = JoinPath(folder, source.mask->file);
      }
      auto image = textures::ReadPicture(source, diagnostics, roots);
      if (image) layers.push_back(std::move(*image));
    }
    if (layers.size() != texture.files.size()) {
      all = false;
      continue;
    }
    auto data =
        textures::MakeTexture(layers, texture.options, texture.name, texture.place, diagnostics);
    if (data) {
      textures.push_back(
          {texture.variable, std::make_shared<textures::TextureData>(std::move(*data))});
    } else {
      all = false;
    }
  }
  return all;
}

}  // namespace texgraph::runtime
