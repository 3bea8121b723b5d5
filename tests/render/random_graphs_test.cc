// SPDX-License-Identifier: Apache-2.0
// Random graphs on the CPU and the GPU, optimised or not, in both dialects. How far a pixel may be
// off follows from the graph itself (tests/fuzz/rounding_noise.h). TEXGRAPH_FUZZ_SEEDS=1000 runs
// longer.
#include <gtest/gtest.h>

#include <cstdlib>
#include <deque>

#include "compiler/blocks/block.h"
#include "compiler/graph/checked_graph.h"
#include "tests/fuzz/check_graph.h"
#include "tests/fuzz/graph_textures.h"
#include "tests/fuzz/random_graph.h"
#include "tests/render/render_check.h"
#include "tests/unit/base/scratch_folder.h"

namespace texgraph::test {
namespace {

constexpr uint32_t kGraphs = 48;
constexpr uint32_t kBatch = 24;  // in one process that draws

uint32_t Seeds() {
  const char* text = std::getenv("TEXGRAPH_FUZZ_SEEDS");
  return text ? static_cast<uint32_t>(std::strtoul(text, nullptr, 10)) : kGraphs;
}

struct RandomCase {
  uint32_t seed = 0;
  fuzz::RandomGraphText graph;
  fuzz::LoweredText lowered;
};

// Without mip levels, since those that a GPU chooses are up to 0.043 off (docs/rendering.md).
CheckOptions OptionsFor(const RandomCase& random, const std::string& folder) {
  CheckOptions options;
  options.width = options.height = 32;
  options.window = random.seed % 3 == 0 ? std::array<double, 4>{-2.7, -1.1, 4.2, 3.9}
                                        : std::array<double, 4>{0.1, 0.2, 1.3, 0.9};
  options.time = 0.1 * random.seed;
  options.dialect = random.seed % 2 == 0 ? glsl::Dialect::k330 : glsl::Dialect::k450;
  options.textures = fuzz::LoadGraphTextures(*random.lowered.lowered->graph, folder, false);
  options.slack = fuzz::NoiseOptions{4, 2e-5};
  return options;
}

void Compare(std::deque<RandomCase>& batch, const std::string& folder) {
  std::vector<CheckCase> cases;
  for (RandomCase& random : batch) {
    cases.push_back({random.lowered.lowered->module.get(), OptionsFor(random, folder)});
  }
  const std::vector<CheckReport> reports = CompareCpuAndGpu(cases);
  for (size_t i = 0; i < reports.size(); ++i) {
    ASSERT_EQ(reports[i].error, "") << "seed " << batch[i].seed << "\n" << batch[i].graph.text;
    for (const OutputDifference& output : reports[i].outputs) {
      EXPECT_EQ(output.CountBeyondSlack(), 0u)
          << "seed " << batch[i].seed << "\n"
          << batch[i].graph.text << reports[i].Text() << reports[i].glsl;
    }
  }
  batch.clear();
}

TEST(RandomGraphs, CpuAndGpuAgree) {
  ScratchFolder folder;
  ASSERT_TRUE(fuzz::WriteGraphImages(folder.path()));
  std::deque<RandomCase> batch;
  uint32_t limits = 0;
  for (uint32_t seed = 1; seed <= Seeds(); ++seed) {
    RandomCase& random = batch.emplace_back();
    random.seed = seed;
    random.graph = fuzz::RandomGraph(seed);
    CompileOptions options;
    options.target = seed % 2 == 0 ? Target::kGlsl330 : Target::kGlsl450;
    options.optimize = seed % 4 != 0;
    fuzz::LowerText(random.graph.text, random.graph.format, folder / random.graph.FileName(seed),
                    options, random.lowered);
    if (!random.lowered.lowered) {
      ASSERT_NE(fuzz::ReachedLimit(random.lowered.diagnostics), "") << random.lowered.Errors();
      batch.pop_back();
      ++limits;
    }
    if (batch.size() == kBatch || seed == Seeds()) Compare(batch, folder.path());
  }
  EXPECT_LE(limits, 1 + Seeds() / 40);
}

}  // namespace
}  // namespace texgraph::test
