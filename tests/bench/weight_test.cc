// SPDX-License-Identifier: Apache-2.0
// Promises of what a pixel costs, counted in SPIR-V after spirv-opt -O: texture look-ups and
// instructions that compute. The graphs are those of the table of "Pattern Based Procedural
// Textures", section 6, and figures of "Texture Bombing", whose daisies take 8 look-ups and 44
// instructions, and whose circles 8 and 62.
#include <gtest/gtest.h>

#include "compiler/base/files.h"
#include "compiler/compile.h"
#include "compiler/spirv/compile_spirv.h"
#include "tests/bench/spirv_weight.h"
#include "tests/bench/synthetic_graphs.h"

namespace texgraph::bench {
namespace {

struct Promise {
  const char* graph;
  int samples, computing;
};

class WeightTest : public testing::TestWithParam<Promise> {};

TEST_P(WeightTest, IsKept) {
  const std::string name = GetParam().graph;
  const std::string path =
      std::string(TEXGRAPH_SOURCE_DIR) + "/graphs/" + name + "/" + name + ".jsonc";
  Sources sources;
  Diagnostics diagnostics;
  auto text = ReadFile(path, 1 << 20, {}, diagnostics);
  ASSERT_TRUE(text);
  const graph::DocumentFormat format = graph::FormatOf(path, *text);
  CompileOptions options;
  options.target = Target::kSpirv;
  auto compiled =
      Compile(sources.Add(path, std::move(*text)), format, options, sources, diagnostics);
  ASSERT_TRUE(compiled) << FormatDiagnostics(diagnostics, sources, false);
  auto weight = WeightOf(compiled->spirv);
  ASSERT_TRUE(weight);
  EXPECT_LE(weight->samples, GetParam().samples);
  EXPECT_LE(weight->computing, GetParam().computing);
  RecordProperty("samples", weight->samples);
  RecordProperty("computing", weight->computing);
}

INSTANTIATE_TEST_SUITE_P(PaperTable, WeightTest,
                         testing::Values(Promise{"aperiodic_tiling", 1, 32},
                                         Promise{"areas_tiling", 3, 40},
                                         Promise{"dithered_areas_tiling", 3, 70},
                                         Promise{"transition_tiling", 7, 256}),
                         [](const auto& promise) { return std::string(promise.param.graph); });

// A graph against tests/bench/reference/NAME.frag, which a person wrote for it.
void ExpectNoHeavierThanByHand(const std::string& graph_path, const std::string& name) {
  Sources sources;
  Diagnostics diagnostics;
  const std::string path = TEXGRAPH_SOURCE_DIR + graph_path;
  auto graph = ReadFile(path, 1 << 20, {}, diagnostics);
  ASSERT_TRUE(graph);
  CompileOptions options;
  options.target = Target::kSpirv;
  auto compiled = Compile(sources.Add(path, *graph), graph::DocumentFormat::kJsonc, options,
                          sources, diagnostics);
  ASSERT_TRUE(compiled) << FormatDiagnostics(diagnostics, sources, false);
  auto text = ReadFile(std::string(TEXGRAPH_SOURCE_DIR) + "/tests/bench/reference/" + name, 1 << 20,
                       {}, diagnostics);
  ASSERT_TRUE(text);
  auto reference = spirv::CompileSpirv(*text, diagnostics);
  ASSERT_TRUE(reference) << FormatDiagnostics(diagnostics, sources, false);
  auto ours = WeightOf(compiled->spirv), theirs = WeightOf(*reference);
  ASSERT_TRUE(ours && theirs);
  EXPECT_LE(ours->computing, 1.05 * theirs->computing);
  testing::Test::RecordProperty("computing", ours->computing);
  testing::Test::RecordProperty("reference", theirs->computing);
}

// Five octaves of gradient noise, as one connects them: the noise learns that its cells are faded.
TEST(Weight, FbmIsNotHeavierThanByHand) {
  ExpectNoHeavierThanByHand("/tests/bench/reference/fbm.json", "fbm.frag");
}

// Exact nearest points, with a colour for each cell.
TEST(Weight, VoronoiIsNotHeavierThanByHand) {
  ExpectNoHeavierThanByHand("/graphs/voronoi/voronoi.json", "voronoi.frag");
}

// A picture, and discs that are computed: one copy for each cell.
TEST(Weight, BombingIsNotHeavierThanByHand) {
  ExpectNoHeavierThanByHand("/graphs/daisies/daisies.jsonc", "daisies.frag");
  ExpectNoHeavierThanByHand("/graphs/circles/circles.jsonc", "circles.frag");
}

// Lit balls in space, of which a surface shows the topmost.
TEST(Weight, SpheresAreNotHeavierThanByHand) {
  ExpectNoHeavierThanByHand("/graphs/spheres/spheres.jsonc", "spheres.frag");
}

INSTANTIATE_TEST_SUITE_P(TextureBombing, WeightTest,
                         testing::Values(Promise{"daisies", 4, 50}, Promise{"circles", 1, 56}),
                         [](const auto& promise) { return std::string(promise.param.graph); });

// One look-up for tiles, six more for a table of permuted numbers, one more for corners or a map.
// Wei's program takes nine.
class TileWeight : public testing::TestWithParam<Promise> {};

TEST_P(TileWeight, IsKept) {
  const std::string path =
      std::string(TEXGRAPH_SOURCE_DIR) + "/graphs/" + GetParam().graph + ".jsonc";
  Sources sources;
  Diagnostics diagnostics;
  auto text = ReadFile(path, 1 << 20, {}, diagnostics);
  ASSERT_TRUE(text);
  CompileOptions options;
  options.target = Target::kSpirv;
  auto compiled = Compile(sources.Add(path, std::move(*text)), graph::DocumentFormat::kJsonc,
                          options, sources, diagnostics);
  ASSERT_TRUE(compiled) << FormatDiagnostics(diagnostics, sources, false);
  auto weight = WeightOf(compiled->spirv);
  ASSERT_TRUE(weight);
  EXPECT_EQ(weight->samples, GetParam().samples);
  EXPECT_LE(weight->computing, GetParam().computing);
  RecordProperty("computing", weight->computing);
}

INSTANTIATE_TEST_SUITE_P(Tiles, TileWeight,
                         testing::Values(Promise{"wei_tiles/dots_at_corners", 1, 46},
                                         Promise{"grass_tiles/grass_wang_tiles", 1, 53},
                                         Promise{"grass_tiles/grass_tile_map", 2, 33},
                                         Promise{"wei_tiles/grass_permutation", 7, 71},
                                         Promise{"wei_tiles/grass_with_corners", 2, 184}));

// What counts and what does not, by a shader whose operations are known.
TEST(Weight, CountsWhatComputes) {
  Sources sources;
  Diagnostics diagnostics;
  const std::string graph = R"({"texgraph": 1,
    "parameters": {"a": {"type": "vec4", "value": [1, 1, 1, 1], "binding": "uniform"},
                   "b": {"type": "vec4", "value": [1, 1, 1, 1], "binding": "uniform"}},
    "nodes": {"sum": {"block": "add", "in": {"a": "a", "b": "b"}},
              "root": {"block": "square_root", "in": {"value": "sum"}}},
    "outputs": {"color": "root"}})";
  CompileOptions options;
  options.target = Target::kSpirv;
  auto compiled = Compile(sources.Add("g.jsonc", graph), graph::DocumentFormat::kJsonc, options,
                          sources, diagnostics);
  ASSERT_TRUE(compiled) << FormatDiagnostics(diagnostics, sources, false);
  auto weight = WeightOf(compiled->spirv);
  ASSERT_TRUE(weight);
  // A sum, a maximum with 0 and a root.
  EXPECT_GE(weight->computing, 2);
  EXPECT_LE(weight->computing, 3);
  EXPECT_EQ(weight->samples, 0);
  EXPECT_GT(weight->instructions, weight->computing);
}

// The size of the SPIR-V before spirv-opt, which puts every function where it is called.
size_t InstructionsOf(const std::string& graph) {
  Sources sources;
  Diagnostics diagnostics;
  CompileOptions options;
  options.target = Target::kSpirv;
  auto compiled = Compile(sources.Add("g.json", graph), graph::DocumentFormat::kJson, options,
                          sources, diagnostics);
  EXPECT_TRUE(compiled) << FormatDiagnostics(diagnostics, sources, false);
  return compiled ? compiled->spirv.size() : 0;
}

// Bombings over one another.
std::string LayersOfBombing(int count) {
  std::string nodes, below = "[0, 0, 0, 1]";
  for (int i = 1; i <= count; ++i) {
    const std::string n = std::to_string(i);
    nodes += (i > 1 ? ", \"layer" : "\"layer") + n +
             R"(": {"block": "bomb", "in": {"image": [1, )" + n + R"(, 0, 0.5], "scale": [)" + n +
             ", 3], \"seed\": " + n + ", \"background\": " + below + "}}";
    below = "\"layer" + n + ".color\"";
  }
  return R"({"texgraph": 1, "nodes": {)" + nodes + R"(}, "outputs": {"color": )" + below + "}}";
}

// Each further one costs what the one before did, but for the lengths of numbers.
TEST(Weight, NestingAndLayersOfBombingGrowLinearly) {
  for (auto graph : {BombingInsideBombing, LayersOfBombing}) {
    const double few = InstructionsOf(graph(7)) - InstructionsOf(graph(4));
    const double many = InstructionsOf(graph(10)) - InstructionsOf(graph(7));
    EXPECT_GT(few, 0);
    EXPECT_NEAR(many, few, 0.02 * few);
  }
}

}  // namespace
}  // namespace texgraph::bench
