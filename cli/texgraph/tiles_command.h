// SPDX-License-Identifier: Apache-2.0
// texgraph tiles: from maps of a material to packs of tiles: all files are written or none.
#pragma once

#include "cli/texgraph/tiles_options.h"
#include "compiler/base/diagnostics.h"

namespace texgraph::cli {

// What is wrong is in `diagnostics`; then no file has changed. `message` is a line for the user
// about what was made.
void RunTiles(const TilesOptions& options, Diagnostics& diagnostics, std::string& message);

}  // namespace texgraph::cli
