// SPDX-License-Identifier: Apache-2.0
// The texels of a graph's textures, made from what the graph says and the pictures that it names:
// what is uploaded to the GPU, all mip levels included.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/base/roots.h"
#include "compiler/graph/graph.h"
#include "compiler/textures/cube_set.h"
#include "compiler/textures/texels.h"
#include "compiler/textures/tile_set.h"

namespace texgraph::manifest {

// How a texture's pictures become texels, and how it is sampled.
textures::TextureOptions OptionsOf(const graph::Texture& texture);

// Of a texture of kTiles.
textures::TileSetOptions TileOptionsOf(const graph::Texture& texture);
textures::TilePackLayout TileLayoutOf(const graph::Texture& texture);

// Of a texture of kCubes.
textures::CubeSetOptions CubeOptionsOf(const graph::Texture& texture);

// The texture of that index; the graph is a checked one. The graph's file names are relative to
// `folder`. Everything that is wrong with the files is reported.
std::optional<textures::TextureData> MakeGraphTexture(const graph::Graph& graph, uint32_t index,
                                                      const std::string& folder, const Roots& roots,
                                                      Diagnostics& diagnostics);

// "wall.ground.ktx2": the file of a derived texture, of the first of equal ones.
std::string DerivedName(const graph::Graph& graph, uint32_t texture);

// A derived texture of the graph that the shader samples.
struct DerivedTexture {
  uint32_t texture;
  std::shared_ptr<const textures::TextureData> data;
};
// All of them, each of equal ones once; nothing if one cannot be made. `used`: by texture.
std::optional<std::vector<DerivedTexture>> DeriveTextures(const graph::Graph& graph,
                                                          const std::vector<bool>& used,
                                                          const std::string& folder,
                                                          const Roots& roots,
                                                          Diagnostics& diagnostics);

}  // namespace texgraph::manifest
