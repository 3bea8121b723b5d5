// SPDX-License-Identifier: Apache-2.0
// What must hold for every valid graph, and for every text that was one before it was broken.
#pragma once

#include <cstdint>
#include <string>

#include "compiler/compile.h"
#include "compiler/graph/document.h"
#include "compiler/ir/evaluate.h"

namespace texgraph::fuzz {

struct GraphReport {
  std::string failure;     // "" if all is well
  std::string limit;       // the name of the stated limit that was reached instead, or ""
  bool costly = false;     // it runs so much for each pixel that it was not evaluated
  uint64_t values = 0;     // that were compared, optimised with not optimised
  uint64_t undefined = 0;  // that differed, where something was infinite or undefined on the way
  uint64_t loose = 0;      // with more than 0.01 of slack, or no numbers both: they say little
};

// `path`: where the text seems to lie; its textures are in that folder. Compiles it to SPIR-V and
// to both dialects, one as a shader and one as a function, without a word, to something that
// glslang and spirv-val accept and that samples implicitly only where that is right; and compares
// the optimised with the unoptimised module.
GraphReport CheckValidGraph(const std::string& text, graph::DocumentFormat format,
                            const std::string& path, uint32_t seed);

// Success with a valid shader, or errors that each have a place in a file; the same twice. "" or
// what is wrong.
std::string CheckBrokenGraph(const std::string& text, graph::DocumentFormat format,
                             const std::string& path);

// The name of the stated limit that is the only reason why a graph is refused, or "".
std::string ReachedLimit(const Diagnostics& diagnostics);

// The graph as a module, with the sources and diagnostics that it came with.
struct LoweredText {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Lowered> lowered;
  std::string Errors() const { return FormatDiagnostics(diagnostics, sources, false); }
};
void LowerText(const std::string& text, graph::DocumentFormat format, const std::string& path,
               const CompileOptions& options, LoweredText& result);

}  // namespace texgraph::fuzz
