// SPDX-License-Identifier: Apache-2.0
// The command line of texgraph as a value, checked as far as it can be without reading a file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "compiler/base/diagnostics.h"
#include "compiler/compile.h"
#include "runtime/render.h"

namespace texgraph::cli {

struct RenderOptions {
  std::string input;   // a graph or a manifest; "-" is a graph on standard input
  std::string output;  // the PNG file, or "-"
  uint32_t width = 512;
  uint32_t height = 512;
  std::array<double, 4> window = {0, 0, 1, 1};
  std::string output_name;  // "": color, or the first
  uint8_t bits = 8;
  double time = 0;
  double timeout = 60;
  runtime::ContextChoice context = runtime::ContextChoice::kAuto;
  CompileOptions compile;
  bool color = false;
  bool quiet = false;
};

struct TexgraphCommandLine {
  RenderOptions render;
  std::string text;  // to print instead: the help or the version
};

// Nothing, with kUsage (or kSizeLimit) reported, if the command line is wrong.
std::optional<TexgraphCommandLine> ReadTexgraphCommandLine(int argc, const char* const* argv,
                                                           Diagnostics& diagnostics);

}  // namespace texgraph::cli
