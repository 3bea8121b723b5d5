// SPDX-License-Identifier: Apache-2.0
#include "cli/texgraph/command_line.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "cli/texgraph/help.h"

namespace texgraph::cli {

std::optional<TexgraphCommandLine> ReadTexgraphCommandLine(int argc, const char* const* argv,
                                                           Diagnostics& diagnostics) {
  const std::string_view command = argc > 1 ? argv[1] : "";
  TexgraphCommandLine line;
  bool wants_help = false;
  if (command == "render") {
    line.render = ReadRenderOptions(argc, argv, wants_help, diagnostics);
    if (wants_help) line.text = kRenderHelp;
    if (!line.render) return std::nullopt;
    return line;
  }
  if (command == "tiles") {
    line.tiles = ReadTilesOptions(argc, argv, wants_help, diagnostics);
    if (wants_help) line.text = kTilesHelp;
    if (!line.tiles) return std::nullopt;
    return line;
  }
  if (command == "--help" || command == "-h" || command == "help") {
    line.text = kTexgraphHelp;
    return line;
  }
  if (command == "--version") {
    line.text = "texgraph " TEXGRAPH_VERSION "\n";
    return line;
  }
  const std::vector<std::string_view> names = {"render", "tiles", "--help", "--version"};
  diagnostics
      .Error(DiagnosticKind::kUsage, {},
             argc > 1 ? fmt::format("unknown command '{}'{}", Printable(command),
                                    DidYouMean(command, names))
                      : "no command given")
      .AddNote({}, "'texgraph --help' lists the commands");
  return std::nullopt;
}

}  // namespace texgraph::cli
