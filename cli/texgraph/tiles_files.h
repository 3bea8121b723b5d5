// SPDX-License-Identifier: Apache-2.0
// Where the files of texgraph tiles go. None is written over a map, nor two to one path.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/texgraph/tiles_options.h"

namespace texgraph::cli {

struct TilesFiles {
  std::vector<std::string> packs;         // a file for each map; "-" is standard output
  std::vector<std::string> corner_packs;  // beside them; none if none are wanted
  std::string json;                       // "": none
};

// Nothing, with kUsage reported, if a file would be written over a map or another one.
std::optional<TilesFiles> NameTilesFiles(const TilesOptions& options, Diagnostics& diagnostics);

}  // namespace texgraph::cli
