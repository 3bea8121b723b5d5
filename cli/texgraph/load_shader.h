// SPDX-License-Identifier: Apache-2.0
// What texgraph draws: a shader that a manifest names, or one compiled from a graph.
#pragma once

#include <string>
#include <vector>

#include "cli/texgraph/render_options.h"
#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "runtime/manifest.h"
#include "runtime/render.h"

namespace texgraph::cli {

// A shader to draw, wherever it came from.
struct Shader {
  std::string text;
  runtime::Manifest manifest;
  runtime::MadeTextures made;       // in this process, where there is no file
  std::string folder;               // that the manifest's paths start from
  std::vector<std::string> inputs;  // all files that were read
};

// Reads options.input, with the settings applied. False if anything is wrong, which is reported.
bool LoadShader(const RenderOptions& options, Sources& sources, Shader& shader,
                Diagnostics& diagnostics);

}  // namespace texgraph::cli
