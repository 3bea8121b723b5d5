// SPDX-License-Identifier: Apache-2.0
// The manifest: a JSON file beside the shader that says all that an engine needs to bind it:
// inputs, outputs, every parameter and every texture of the graph, those too that the shader does
// not contain any more. docs/manifest.md describes it, docs/manifest.schema.json is its schema. The
// text depends on the arguments alone.
#pragma once

#include <span>
#include <string>

#include "compiler/compile.h"
#include "compiler/glsl/print_glsl.h"
#include "compiler/graph/checked_graph.h"
#include "compiler/ir/module.h"
#include "compiler/manifest/graph_textures.h"

namespace texgraph::manifest {

// `module` is the one that was printed as the shader, which declares `shader`. The graph's file
// names are relative to `graph_folder`. `derived`: those that were made.
std::string PrintManifest(const graph::CheckedGraph& graph, const ir::Module& module,
                          const glsl::ShaderInterface& shader, const CompileOptions& options,
                          const std::string& graph_folder,
                          std::span<const DerivedTexture> derived = {});

}  // namespace texgraph::manifest
