// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <set>
#include <utility>

#include "compiler/base/files.h"
#include "compiler/textures/ktx2.h"
#include "compiler/textures/texel_chain.h"
#include "runtime/render.h"

namespace texgraph::runtime {
namespace {

using Data = std::shared_ptr<const textures::TextureData>;

std::string_view TypeName(bool is_array, bool is_3d) {
  return is_3d ? "sampler3D" : is_array ? "sampler2DArray" : "sampler2D";
}

// A texture with all its levels. How it is sampled stands in the manifest, not in the file.
Data LoadLevels(const ManifestTexture& texture, const std::string& folder, const Roots& roots,
                Diagnostics& diagnostics) {
  const std::string path = JoinPath(folder, texture.files[0]);
  auto data = textures::ReadKtx2(path, texture.place, diagnostics, roots);
  if (!data) return nullptr;
  const textures::TextureOptions& options = texture.options;
  if (data->is_array != options.is_array || data->is_3d != options.is_3d) {
    diagnostics.Error(DiagnosticKind::kBadImage, texture.place,
                      fmt::format("'{}' has the texels of a {}, but the texture is a {}",
                                  Printable(path), TypeName(data->is_array, data->is_3d),
                                  TypeName(options.is_array, options.is_3d)));
    return nullptr;
  }
  data->sampler = textures::SamplerFor(options);
  return std::make_shared<const textures::TextureData>(std::move(*data));
}

Data LoadPictures(const ManifestTexture& texture, const std::string& folder, const Roots& roots,
                  Diagnostics& diagnostics) {
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
  if (layers.size() != texture.files.size()) return nullptr;
  auto data =
      textures::MakeTexture(layers, texture.options, texture.name, texture.place, diagnostics);
  return data ? std::make_shared<const textures::TextureData>(std::move(*data)) : nullptr;
}

}  // namespace

bool LoadTextures(const Manifest& manifest, const std::string& folder,
                  std::vector<TextureBinding>& textures, Diagnostics& diagnostics,
                  const Roots& roots, const MadeTextures& made) {
  bool all = true;
  std::set<std::string_view> variables;
  for (const ManifestTexture& texture : manifest.textures) {
    if (!texture.is_used || !variables.insert(texture.variable).second) continue;
    Data data;
    if (!texture.has_levels) {
      data = LoadPictures(texture, folder, roots, diagnostics);
    } else if (const auto found = made.find(texture.files[0]); found != made.end()) {
      data = found->second;
    } else {
      data = LoadLevels(texture, folder, roots, diagnostics);
    }
    if (data) {
      textures.push_back({texture.variable, std::move(data)});
    } else {
      all = false;
    }
  }
  return all;
}

}  // namespace texgraph::runtime
