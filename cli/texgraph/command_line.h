// SPDX-License-Identifier: Apache-2.0
// The command line of texgraph: which command it is, and its options.
#pragma once

#include <optional>
#include <string>

#include "cli/texgraph/render_options.h"
#include "cli/texgraph/tiles_options.h"
#include "compiler/base/diagnostics.h"

namespace texgraph::cli {

struct TexgraphCommandLine {
  // One of them, or a text to print instead: the help or the version.
  std::optional<RenderOptions> render;
  std::optional<TilesOptions> tiles;
  std::string text;

  bool color() const { return (render && render->color) || (tiles && tiles->color); }
  bool quiet() const { return (render && render->quiet) || (tiles && tiles->quiet); }
};

// Nothing, with kUsage (or kSizeLimit) reported, if the command line is wrong.
std::optional<TexgraphCommandLine> ReadTexgraphCommandLine(int argc, const char* const* argv,
                                                           Diagnostics& diagnostics);

}  // namespace texgraph::cli
