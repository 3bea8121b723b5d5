// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/graph_textures.h"

#include <cstring>
#include <map>
#include <vector>

#include "compiler/manifest/graph_textures.h"
#include "compiler/manifest/pictures.h"

namespace texgraph::fuzz {
namespace {

// What a GPU sees of the texels, without its own rounding; maps are numbers already.
textures::TextureData AsFloats(textures::TextureData data, bool mipmaps) {
  using textures::TexelFormat;
  if (!mipmaps) {
    data.levels.resize(1);
    data.sampler.mip_filter = ir::MipFilter::kNone;
  }
  if (data.format == TexelFormat::kR16F || data.format == TexelFormat::kR32F ||
      data.format == TexelFormat::kRgba16F || data.format == TexelFormat::kRgba32F) {
    return data;
  }
  const ir::Texture texture = ToTexture(data);
  data.format = TexelFormat::kRgba32F;
  for (size_t level = 0; level < data.levels.size(); ++level) {
    const auto& texels = texture.levels[level].texels;
    data.levels[level].bytes.resize(texels.size() * sizeof(texels[0]));
    std::memcpy(data.levels[level].bytes.data(), texels.data(), data.levels[level].bytes.size());
  }
  return data;
}

using Derived = std::map<uint32_t, std::shared_ptr<const textures::TextureData>>;

// All at once: maps of one material are cut once. If one cannot be made, each by itself.
Derived DeriveAll(const graph::Graph& graph, const std::string& folder) {
  Derived derived;
  Diagnostics diagnostics;
  const std::vector<bool> used(graph.textures.size(), true);
  if (const auto all = manifest::DeriveTextures(graph, used, folder, {}, diagnostics)) {
    for (const manifest::DerivedTexture& made : *all) derived[made.texture] = made.data;
    return derived;
  }
  for (uint32_t t = 0; t < graph.textures.size(); ++t) {
    if (!graph.textures[t].IsDerived() || graph::FirstEqualTexture(graph, t) != t) continue;
    if (auto data = manifest::MakeGraphTexture(graph, t, folder, {}, diagnostics)) {
      derived[t] = std::make_shared<const textures::TextureData>(std::move(*data));
    }
  }
  return derived;
}

}  // namespace

GraphTextures LoadGraphTextures(const graph::Graph& graph, const std::string& folder,
                                bool mipmaps) {
  GraphTextures loaded;
  const Derived derived = DeriveAll(graph, folder);
  for (uint32_t t = 0; t < graph.textures.size(); ++t) {
    const graph::Texture& texture = graph.textures[t];
    Diagnostics diagnostics;
    if (texture.IsDerived()) {
      const auto made = derived.find(graph::FirstEqualTexture(graph, t));
      if (made == derived.end()) continue;
      loaded[std::string(texture.name)] =
          std::make_shared<textures::TextureData>(AsFloats(*made->second, mipmaps));
      continue;
    }
    std::vector<textures::Image> layers;
    for (size_t layer = 0; layer < texture.files.size(); ++layer) {
      auto image = textures::ReadPicture(manifest::PictureOf(texture, layer, folder), diagnostics);
      if (image) layers.push_back(std::move(*image));
    }
    if (layers.size() != texture.files.size()) continue;
    textures::TextureOptions how = manifest::OptionsOf(texture);
    how.mipmaps = texture.mipmaps && mipmaps;
    how.as_float = true;
    auto data = MakeTexture(layers, how, texture.name, {}, diagnostics);
    if (!data) continue;
    loaded[std::string(texture.name)] = std::make_shared<textures::TextureData>(std::move(*data));
  }
  return loaded;
}

}  // namespace texgraph::fuzz
