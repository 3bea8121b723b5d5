// SPDX-License-Identifier: Apache-2.0
// texgraph: what is done with compiled graphs, and with pictures without one. See
// docs/rendering.md.
#include <unistd.h>

#include "cli/texgraph/command_line.h"
#include "cli/texgraph/render_command.h"
#include "cli/texgraph/tiles_command.h"
#include "compiler/base/failures.h"
#include "compiler/base/output_files.h"

namespace texgraph::cli {
namespace {

ExitCode Run(int argc, const char* const* argv) {
  Diagnostics diagnostics;
  Sources sources;
  const auto line = ReadTexgraphCommandLine(argc, argv, diagnostics);
  std::string message;
  if (line && !line->text.empty()) {
    OutputFiles files;
    files.Add("-", line->text);
    files.Commit(diagnostics);
  } else if (line && line->tiles) {
    RunTiles(*line->tiles, diagnostics, message);
  } else if (line) {
    RunRender(*line->render, sources, diagnostics, message);
  }
  std::string text;
  if (!diagnostics.all().empty())
    text = FormatDiagnostics(diagnostics, sources, line && line->color());
  if (line && !line->quiet()) text += message;
  if (!text.empty()) (void)WriteAll(STDERR_FILENO, text);
  return diagnostics.exit_code();
}

}  // namespace
}  // namespace texgraph::cli

int main(int argc, char** argv) {
  texgraph::PrepareProcess();
  texgraph::PrepareFailures();
  return static_cast<int>(texgraph::cli::Run(argc, argv));
}
