// SPDX-License-Identifier: Apache-2.0
// The command line of texgraph tiles as a value, checked as far as it can be without reading a
// file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/textures/tile_set.h"

namespace texgraph::cli {

struct TilesOptions {
  std::vector<std::string> maps;
  std::vector<std::string> packs;  // a file for each map, or none: they are named after the maps
  std::string json;                // "": beside the first pack
  bool corner_pack = false;
  std::string view;    // "": none
  std::string tiling;  // "": none
  std::array<uint32_t, 2> tiling_size = {8, 8};
  bool report = false;
  textures::TileSetOptions set;
  std::vector<double> weights;  // one a map, or none
  bool color = false;
  bool quiet = false;
};

// From the third argument on. Nothing, with kUsage (or kSizeLimit) reported, if the command line is
// wrong; with `wants_help` nothing else was looked at.
std::optional<TilesOptions> ReadTilesOptions(int argc, const char* const* argv, bool& wants_help,
                                             Diagnostics& diagnostics);

}  // namespace texgraph::cli
