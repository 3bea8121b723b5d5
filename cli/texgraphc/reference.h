// SPDX-License-Identifier: Apache-2.0
// What --list-blocks and --print-reference print: the blocks of the library and of the -I folders,
// from their own comments.
#pragma once

#include <string>

#include "cli/texgraphc/options.h"
#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"

namespace texgraph::cli {

// The blocks by family, each with its summary. Blocks that are wrong are reported and left out.
std::string ListBlocks(const Options& options, Sources& sources, Diagnostics& diagnostics);

// One block: its text, and for each overload the ports with types, defaults, ranges and help.
// Reports kUnknownBlock.
std::string PrintReference(const Options& options, Sources& sources, Diagnostics& diagnostics);

}  // namespace texgraph::cli
