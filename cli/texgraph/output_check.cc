// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/output_check.h"

#include <fmt/format.h>

#include "compiler/base/files.h"

namespace texgraph::cli {

bool CheckOutput(const std::string& output, const std::vector<std::string>& inputs,
                 Diagnostics& diagnostics) {
  if (output == "-") return true;
  for (const std::string& input : inputs) {
    if (AbsolutePath(input) != AbsolutePath(output) && !SameFile(input, output)) continue;
    diagnostics.Error(
        DiagnosticKind::kUsage, {},
        fmt::format("cannot write '{}': it is one of the files that are read", Printable(output)));
    return false;
  }
  return true;
}

}  // namespace texgraph::cli
