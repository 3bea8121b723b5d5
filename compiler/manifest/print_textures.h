// SPDX-License-Identifier: Apache-2.0
// The manifest's section "textures": what every texture of the graph is, where its texels are, and
// what they mean where they are numbers, so that a program can change them.
#pragma once

#include <span>
#include <string>

#include "compiler/compile.h"
#include "compiler/glsl/print_glsl.h"
#include "compiler/graph/graph.h"
#include "compiler/ir/module.h"
#include "compiler/manifest/graph_textures.h"
#include "compiler/manifest/json_writer.h"

namespace texgraph::manifest {

struct TextureSection {
  const graph::Graph& graph;
  const ir::Module& module;
  const glsl::ShaderInterface& shader;
  const CompileOptions& options;
  const std::string& graph_folder;  // that the graph's file names start from
  std::span<const DerivedTexture> derived;
};

void PrintTextures(const TextureSection& section, JsonWriter& json);
// The object "tiles", which says what a pack of tiles is. The tile in column x, row y of the pack,
// from below, begins y tiles and the gutter above its lower border.
void PrintTileLayout(const textures::TilePackLayout& layout, JsonWriter& json);

}  // namespace texgraph::manifest
