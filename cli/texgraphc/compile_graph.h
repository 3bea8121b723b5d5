// SPDX-License-Identifier: Apache-2.0
// One graph from its file to its outputs, in two steps: compiling, which can be done for many
// graphs at the same time, and finishing, which is done in the order of the graphs, so that
// messages and files do not depend on which was faster.
#pragma once

#include <optional>
#include <string>

#include "cli/texgraphc/options.h"
#include "cli/texgraphc/output_paths.h"
#include "compiler/base/diagnostics.h"
#include "compiler/base/source.h"
#include "compiler/compile.h"

namespace texgraph::cli {

struct CompiledGraph {
  std::string path;
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Compiled> compiled;  // nothing if there was an error
};

// Reads and compiles; writes nothing.
CompiledGraph CompileGraph(const Options& options, const std::string& path);

// Writes the outputs and prints what there is to say. `planner` knows those of the graphs before.
ExitCode FinishGraph(const Options& options, CompiledGraph graph, OutputPlanner& planner);

// All graphs of the command line, `options.jobs` at a time. The exit code of the first that failed.
ExitCode CompileGraphs(const Options& options);

// Prints to standard error.
void PrintDiagnostics(const Diagnostics& diagnostics, const Sources& sources, bool color);

}  // namespace texgraph::cli
