// SPDX-License-Identifier: Apache-2.0
// A picture never replaces what it was made from.
#pragma once

#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"

namespace texgraph::cli {

// False, with kUsage reported, if `output` is one of the files that are read, also by another name.
// "-" is standard output.
bool CheckOutput(const std::string& output, const std::vector<std::string>& inputs,
                 Diagnostics& diagnostics);

}  // namespace texgraph::cli
