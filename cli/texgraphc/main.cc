// SPDX-License-Identifier: Apache-2.0
// texgraphc: texture graphs in, shaders out. See docs/texgraphc.md.
#include <unistd.h>

#include "cli/texgraphc/compile_graph.h"
#include "cli/texgraphc/options.h"
#include "cli/texgraphc/reference.h"
#include "compiler/base/failures.h"
#include "compiler/base/files.h"
#include "compiler/base/output_files.h"

namespace texgraph::cli {
namespace {

// Text that was asked for, to standard output.
void PrintText(const std::string& text, Diagnostics& diagnostics) {
  OutputFiles files;
  files.Add("-", text);
  files.Commit(diagnostics);
}

ExitCode Run(int argc, const char* const* argv) {
  Diagnostics diagnostics;
  Sources sources;
  std::optional<CommandLine> line = ReadCommandLine(argc, argv, diagnostics);
  if (!line) {
    PrintDiagnostics(diagnostics, sources, TerminalHasColor());
    return diagnostics.exit_code();
  }
  const Options& options = line->options;
  bool reference = options.list_blocks || !options.reference.empty();
  if (line->text.empty() && !reference) return CompileGraphs(options);
  std::string text = std::move(line->text);
  if (text.empty()) {
    text = options.list_blocks ? ListBlocks(options, sources, diagnostics)
                               : PrintReference(options, sources, diagnostics);
  }
  PrintText(text, diagnostics);
  PrintDiagnostics(diagnostics, sources, options.color);
  return diagnostics.exit_code();
}

}  // namespace
}  // namespace texgraph::cli

int main(int argc, char** argv) {
  texgraph::PrepareProcess();
  texgraph::PrepareFailures();
  // Everything is written; taking the structures apart would only cost time.
  _exit(static_cast<int>(texgraph::cli::Run(argc, argv)));
}
