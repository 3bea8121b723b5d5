// SPDX-License-Identifier: Apache-2.0
// Every example graph, whole: the shader on the GPU against the module on the CPU, optimised in
// both dialects and not optimised.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>

#include "compiler/base/files.h"
#include "compiler/blocks/block.h"
#include "compiler/compile.h"
#include "compiler/graph/checked_graph.h"
#include "compiler/graph/graph.h"
#include "compiler/passes/passes.h"
#include "tests/fuzz/graph_textures.h"
#include "tests/render/render_check.h"

namespace texgraph::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> Graphs() {
  std::vector<fs::path> graphs;
  for (const auto& entry :
       fs::recursive_directory_iterator(fs::path(TEXGRAPH_SOURCE_DIR) / "graphs")) {
    const std::string extension = entry.path().extension();
    if (extension == ".json" || extension == ".jsonc" || extension == ".yaml")
      graphs.push_back(entry.path());
  }
  std::sort(graphs.begin(), graphs.end());
  return graphs;
}

struct LoweredGraph {
  Sources sources;
  Diagnostics diagnostics;
  std::optional<Lowered> lowered;
  std::string Errors() const { return FormatDiagnostics(diagnostics, sources, false); }
};

void LowerGraph(const std::string& path, bool optimize, glsl::Dialect dialect,
                LoweredGraph& graph) {
  auto text = ReadFile(path, graph::kMaxDocumentBytes, {}, graph.diagnostics);
  if (!text) return;
  const graph::DocumentFormat format = graph::FormatOf(path, *text);
  const SourceId source = graph.sources.Add(path, std::move(*text));
  CompileOptions options;
  options.optimize = optimize;
  options.target = dialect == glsl::Dialect::k330 ? Target::kGlsl330 : Target::kGlsl450;
  if (auto lowered = Lower(source, format, options, graph.sources, graph.diagnostics)) {
    graph.lowered.emplace(std::move(*lowered));
  }
}

// A function that is not of the exact class may fall on the other side of a step: nearly all values
// are near, and few are not.
void ExpectNear(const CheckReport& report, double tolerance, const std::string& what) {
  ASSERT_EQ(report.error, "") << what;
  for (const OutputDifference& output : report.outputs) {
    EXPECT_LE(output.CountBeyond(tolerance), output.cpu.size() / 1000) << what << "\n"
                                                                       << report.Text();
  }
}

// Pixels each way. What computes much for each pixel is drawn smaller: the CPU computes all of it,
// eight times.
uint32_t SideOf(const ir::Module& module) {
  constexpr double kOperations = 128 * 128 * 1000;
  const double pixels =
      kOperations / static_cast<double>(std::max<uint64_t>(passes::OperationsForAPixel(module), 1));
  return std::clamp(static_cast<uint32_t>(std::sqrt(pixels)) / 8 * 8, 40u, 128u);
}

class GraphTest : public testing::TestWithParam<fs::path> {};

// With mip levels, the level of a sample differs by up to 0.043 (docs/rendering.md); without them
// nothing does.
TEST_P(GraphTest, TheGpuDrawsWhatTheCpuComputes) {
  const std::string path = GetParam();
  CheckOptions options;
  std::optional<uint32_t> side;
  fuzz::GraphTextures textures[2];  // the same for all: without mip levels, and with them
  for (const std::array<double, 4>& window :
       {std::array<double, 4>{0, 0, 1, 1}, {-3.7, 2.1, 4.9, 9.3}}) {
    options.window = window;
    for (glsl::Dialect dialect : {glsl::Dialect::k330, glsl::Dialect::k450}) {
      options.dialect = dialect;
      for (bool mipmaps : {true, false}) {
        // Not optimised: what the folding and simplifying of the other might hide.
        const bool optimize = mipmaps || dialect == glsl::Dialect::k330;
        LoweredGraph graph;
        LowerGraph(path, optimize, dialect, graph);
        ASSERT_TRUE(graph.lowered) << graph.Errors();
        fuzz::GraphTextures& loaded = textures[mipmaps];
        if (loaded.empty()) {
          loaded =
              fuzz::LoadGraphTextures(*graph.lowered->graph, std::string(FolderOf(path)), mipmaps);
        }
        options.textures = loaded;
        ASSERT_EQ(options.textures.size(), graph.lowered->graph->textures.size());
        if (!side) side = SideOf(*graph.lowered->module);
        options.width = options.height = *side;
        const CheckReport report = CompareCpuAndGpu(*graph.lowered->module, options);
        ExpectNear(report, mipmaps ? 0.02 : 1e-4,
                   fmt::format("window at {}, dialect {}, mipmaps {}, optimised {}", window[0],
                               static_cast<int>(dialect), mipmaps, optimize));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Examples, GraphTest, testing::ValuesIn(Graphs()),
                         [](const auto& info) { return info.param.stem().string(); });

}  // namespace
}  // namespace texgraph::test
