// SPDX-License-Identifier: Apache-2.0
// The pictures of a graph's textures: where they come from, and what they are called when they were
// prepared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "compiler/glsl/print_glsl.h"
#include "compiler/graph/graph.h"
#include "compiler/ir/module.h"
#include "compiler/textures/prepare.h"

namespace texgraph::manifest {

// The graph's file names are relative to `folder`.
textures::PictureSource PictureOf(const graph::Texture& texture, size_t layer,
                                  const std::string& folder);

// "wall.leaf.png", and for the layers of an array "wall.leaf.0.png": of the first of equal
// textures.
std::string PreparedName(const graph::Graph& graph, uint32_t texture, size_t layer);

// By index of the texture: whether the shader samples it.
std::vector<bool> UsedTextures(const graph::Graph& graph, const ir::Module& module,
                               const glsl::ShaderInterface& shader);

}  // namespace texgraph::manifest
