// SPDX-License-Identifier: Apache-2.0
// What of a graph's textures stands in files: that the files are pictures of sizes that fit each
// other and their grid, and the numbers of maps that are pictures.
#pragma once

#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/graph/graph.h"

namespace texgraph::manifest {

// Reads the headers of all pictures, and decodes those of maps into Texture::map. The graph's file
// names are relative to `folder`. Everything is reported at the file's place in the graph.
void CheckTextures(graph::Graph& graph, const std::string& folder,
                   const std::vector<std::string>& root_folders, Diagnostics& diagnostics);

}  // namespace texgraph::manifest
