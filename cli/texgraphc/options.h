// SPDX-License-Identifier: Apache-2.0
// The command line of texgraphc as a value, checked as far as it can be without reading a file.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/compile.h"
#include "compiler/graph/document.h"

namespace texgraph::cli {

struct Options {
  std::vector<std::string> graphs;  // "-" is standard input
  std::string output;    // -o: a file, "-", or a folder if it ends with '/' or there are several
                         // graphs; "": none
  std::string manifest;  // --manifest
  bool write_dependencies = false;  // -MD
  std::string dependency_file;      // -MF
  std::string dependency_target;    // -MT
  std::optional<graph::DocumentFormat> format;
  unsigned jobs = 1;  // 0: one for each core
  bool no_warnings = false;
  bool warnings_are_errors = false;
  bool color = false;
  bool list_blocks = false;
  std::string reference;  // --print-reference
  CompileOptions compile;

  // Each graph's outputs get their names from the graph, in one folder.
  bool OutputIsFolder() const {
    return graphs.size() > 1 || output.empty() || output.ends_with('/');
  }
};

struct CommandLine {
  Options options;
  std::string text;  // to print instead of compiling: the help or the version
};

// Nothing, with kUsage reported, if the command line is wrong.
std::optional<CommandLine> ReadCommandLine(int argc, const char* const* argv,
                                           Diagnostics& diagnostics);

// Whether standard error takes colours by itself: a terminal, and neither NO_COLOR nor TERM=dumb.
bool TerminalHasColor();

}  // namespace texgraph::cli
