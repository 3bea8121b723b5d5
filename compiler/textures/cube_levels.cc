// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_levels.h"

#include <algorithm>
#include <new>

#include "compiler/textures/texel_chain.h"
#include "compiler/textures/tile_levels.h"

namespace texgraph::textures {
namespace {

TextureData BuildTexture(const CubeSet& set, const TextureOptions& options) {
  const uint32_t coarsest = TileMaxLevel(set.layout.cube_size);
  uint32_t last = options.mipmaps ? coarsest : 0;
  if (options.max_level) last = std::min(last, *options.max_level);
  TextureOptions solid = options;
  solid.is_array = false;
  solid.is_3d = true;
  solid.max_level = last;
  solid.wrap_u = solid.wrap_v = solid.wrap_w = ir::Wrap::kRepeat;
  ir::Texture chain;
  chain.is_3d = true;
  chain.sampler = SamplerFor(solid);
  ir::Texture::Level& base = chain.levels.emplace_back();
  base.width = base.height = set.layout.width();
  base.depth = set.layout.depth();
  base.texels.reserve(size_t{base.width} * base.height * base.depth);
  AppendPicture(set.pack, options.srgb, base.texels);
  if (last > 0) BuildLevels(chain, options.alpha_is_opacity);
  chain.levels.resize(last + 1);
  if (last > 0 && last == coarsest) {
    const ir::Texel mean = MeanTexel(chain.levels[0].texels, options.alpha_is_opacity);
    for (ir::Texel& texel : chain.levels[last].texels) texel = mean;
  }
  return EncodeLevels(chain, FormatFor({&set.pack, 1}, options));
}

}  // namespace

std::optional<TextureData> MakeCubeTexture(const CubeSet& set, const TextureOptions& options,
                                           std::string_view name, SourceRange range,
                                           Diagnostics& diagnostics) {
  try {
    return BuildTexture(set, options);
  } catch (const std::bad_alloc&) {
    ReportNoMemory(name, range, diagnostics);
    return std::nullopt;
  }
}

}  // namespace texgraph::textures
