// SPDX-License-Identifier: Apache-2.0
// The tilings of figures 10a to 10d of "Pattern Based Procedural Textures", which leaves their
// filtering open: against 1,024 samples a pixel.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/blocks/mean_error.h"

namespace texgraph::blocks {
namespace {

constexpr double kCells = 64;  // a side, in all of the graphs

std::string FolderOf(const std::string& name) {
  return std::string(TEXGRAPH_SOURCE_DIR) + "/graphs/" + name + "/";
}

std::string TextOf(const std::string& name) {
  std::ifstream file(FolderOf(name) + name + ".jsonc");
  return {std::istreambuf_iterator<char>(file), {}};
}

class TilingTest : public testing::TestWithParam<const char*> {};

TEST_P(TilingTest, IsTheMeanOfWhatIsThere) {
  const std::string text = TextOf(GetParam()), folder = FolderOf(GetParam());
  for (double patterns : {1.0, 2.0, 4.0, 16.0, 64.0, 4096.0}) {
    const double error = MeanError(text, std::sqrt(patterns) / kCells, folder);
    EXPECT_LE(error, 0.02) << patterns << " patterns a pixel";
    RecordProperty(std::to_string(static_cast<int>(patterns)), std::to_string(error));
  }
}

INSTANTIATE_TEST_SUITE_P(Figure10, TilingTest,
                         testing::Values("aperiodic_tiling", "weighted_tiling", "areas_tiling",
                                         "dithered_areas_tiling"),
                         [](const auto& name) { return std::string(name.param); });

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
}

// What is known when the shader is made changes its code, not its picture.
TEST(TilingSpecialisation, ChangesNothing) {
  std::vector<Point> points;
  for (int i = 0; i < 400; ++i) {
    points.push_back(
        {3 * std::fmod(0.7548776662 * i, 1) - 1, 3 * std::fmod(0.5698402910 * i, 1) - 1});
  }
  const std::string uniform_cells = R"("type": "ivec2", "binding": "uniform")";
  struct Case {
    const char* graph;
    const char* from;
    std::string to;
  };
  for (const Case& c :
       {Case{"aperiodic_tiling", R"("type": "ivec2")", uniform_cells},
        Case{"weighted_tiling", R"("type": "ivec2")", uniform_cells},
        Case{"weighted_tiling", R"("binding": "constant")", R"("binding": "texture")"},
        Case{"areas_tiling", R"("binding": "constant")", R"("binding": "texture")"},
        Case{"areas_tiling", R"("of": "kinds" })", R"("of": "kinds", "binding": "constant" })"},
        Case{"dithered_areas_tiling", R"("of": "kinds" })",
             R"("of": "kinds", "binding": "constant" })"}}) {
    const std::string text = TextOf(c.graph), folder = FolderOf(c.graph);
    for (double pixel : {1e-5, 2e-3, 0.05}) {
      EXPECT_EQ(ColorsAt(text, points, pixel, folder),
                ColorsAt(Replaced(text, c.from, c.to), points, pixel, folder))
          << c.graph << " with " << c.to << ", pixels of " << pixel;
    }
  }
}

}  // namespace
}  // namespace texgraph::blocks
