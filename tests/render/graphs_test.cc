// SPDX-License-Identifier: Apache-2.0
// Every example graph, whole: the shader on the GPU against the module on the CPU, optimised in
// both dialects and not optimised.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>

#include "compiler/base/files.h"
#include "compiler/blocks/block.h"
#include "compiler/compile.h"
#include "compiler/graph/checked_graph.h"
#include "compiler/graph/graph.h"
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

// Pixels each way. Dozens of copies or octaves for each pixel are drawn smaller: the CPU computes
// every one of them, eight times.
int SideOf(const fs::path& graph) {
  static const std::set<std::string> kHeavy = {"cobblestones", "cracked_mud", "flower_field",
                                               "island_map",   "leaf_litter", "pixel_sunset",
                                               "rose_window",  "solid_wood",  "starry_sky"};
  return kHeavy.contains(graph.stem()) ? 40 : 128;
}

class GraphTest : public testing::TestWithParam<fs::path> {};

// With mip levels, the level of a sample differs by up to 0.043 (docs/rendering.md); without them
// nothing does.
TEST_P(GraphTest, TheGpuDrawsWhatTheCpuComputes) {
  const std::string path = GetParam();
  CheckOptions options;
  options.width = options.height = SideOf(path);
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
        options.textures =
            fuzz::LoadGraphTextures(*graph.lowered->graph, std::string(FolderOf(path)), mipmaps);
        ASSERT_EQ(options.textures.size(), graph.lowered->graph->textures.size());
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
