// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/texels.h"

#include <fmt/format.h>

#include <new>

#include "compiler/textures/pattern_levels.h"
#include "compiler/textures/texel_chain.h"

namespace texgraph::textures {
namespace {

TextureData Build(std::span<const Image> layers, const TextureOptions& options) {
  ir::Texture chain;
  chain.is_array = options.is_array;
  chain.is_3d = options.is_3d;
  chain.sampler = SamplerFor(options);
  ir::Texture::Level& base = chain.levels.emplace_back();
  base.width = layers[0].width;
  base.height = layers[0].height;
  base.depth = static_cast<uint32_t>(layers.size());
  base.texels.reserve(size_t{base.width} * base.height * base.depth);
  for (const Image& image : layers) AppendPicture(image, options.srgb, base.texels);
  if (options.mipmaps && options.max_level != 0u) BuildLevels(chain, options.alpha_is_opacity);
  if (options.is_array && (options.match_edges || !options.weights.empty())) {
    const std::vector<double> shares = LayerShares(options.weights, layers.size());
    if (options.match_edges) {
      MatchEdges(chain, shares, options.alpha_is_opacity, options.edge_groups);
    }
    if (!options.weights.empty()) MixCoarsestLevels(chain, shares, options.alpha_is_opacity);
  }
  if (options.max_level && chain.levels.size() > size_t{*options.max_level} + 1) {
    chain.levels.resize(size_t{*options.max_level} + 1);
  }
  return EncodeLevels(chain, FormatFor(layers, options));
}

}  // namespace

uint32_t TexelBytes(TexelFormat format) {
  switch (format) {
    case TexelFormat::kR16F:
      return 2;
    case TexelFormat::kRgba8:
    case TexelFormat::kSrgb8Alpha8:
    case TexelFormat::kR32F:
      return 4;
    case TexelFormat::kRgba16:
    case TexelFormat::kRgba16F:
      return 8;
    case TexelFormat::kRgba32F:
      return 16;
  }
  return 0;
}

std::optional<TextureData> MakeTexture(std::span<const Image> layers, const TextureOptions& options,
                                       std::string_view name, SourceRange range,
                                       Diagnostics& diagnostics) {
  if (layers.empty() || (layers.size() > 1 && !options.is_array && !options.is_3d)) {
    diagnostics.Error(DiagnosticKind::kBadImage, range,
                      fmt::format("texture '{}' has {} images", Printable(name), layers.size()));
    return std::nullopt;
  }
  if (!CheckPictures(layers, name, range, diagnostics)) return std::nullopt;
  try {
    return Build(layers, options);
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

ir::Texture ToTexture(const TextureData& data) {
  ir::Texture texture;
  texture.sampler = data.sampler;
  texture.is_array = data.is_array;
  texture.is_3d = data.is_3d;
  const uint32_t size = TexelBytes(data.format);
  for (const TexelLevel& from : data.levels) {
    ir::Texture::Level& to = texture.levels.emplace_back();
    to.width = from.width;
    to.height = from.height;
    to.depth = data.is_3d ? from.depth : data.layers;
    to.texels.resize(from.bytes.size() / size);
    for (size_t i = 0; i < to.texels.size(); ++i)
      to.texels[i] = DecodeTexel(data.format, &from.bytes[i * size]);
  }
  return texture;
}

}  // namespace texgraph::textures
