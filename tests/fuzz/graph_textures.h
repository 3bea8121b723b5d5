// SPDX-License-Identifier: Apache-2.0
// The textures of a graph as its files and settings say, for evaluating it or drawing it.
#pragma once

#include <map>
#include <memory>
#include <string>

#include "compiler/graph/graph.h"
#include "compiler/textures/texels.h"

namespace texgraph::fuzz {

using GraphTextures = std::map<std::string, std::shared_ptr<const textures::TextureData>>;

// By the name of their global. Floats without rounding to 8 bits, so that the filters of CPU and
// GPU agree. `mipmaps` false: none, whatever the graph says. Those that cannot be read are missing.
GraphTextures LoadGraphTextures(const graph::Graph& graph, const std::string& folder, bool mipmaps);

}  // namespace texgraph::fuzz
