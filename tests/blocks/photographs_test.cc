// SPDX-License-Identifier: Apache-2.0
// Graphs on photographs, tests/graphs/brick_photo/, leaf_photo/ and tile_photos/. The photographs
// are not part of the project: TEXGRAPH_DATA names their folder, else it is ../shared/data beside
// the source; without them the tests are skipped.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "compiler/compile.h"
#include "compiler/textures/image.h"
#include "compiler/textures/tile_set.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

std::string DataFolder() {
  const char* folder = std::getenv("TEXGRAPH_DATA");
  return folder != nullptr ? std::string(folder) + "/" : TEXGRAPH_SOURCE_DIR "/../shared/data/";
}

class PhotographsTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(DataFolder() + "brick_base_gray.jpg")) {
      GTEST_SKIP() << "no photographs in " << DataFolder();
    }
  }
};

std::string GraphText(const char* name) {
  std::ifstream file(std::string(TEXGRAPH_SOURCE_DIR "/tests/graphs/") + name);
  std::stringstream text;
  text << file.rdbuf();
  return text.str();
}

// The middles of kSide * kSide pixels.
constexpr int kSide = 96;
std::vector<Point> Pixels() {
  std::vector<Point> points;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) points.push_back({(x + 0.5) / kSide, (y + 0.5) / kSide});
  }
  return points;
}

TEST_F(PhotographsTest, BrickWallCompilesForEveryTarget) {
  for (Target target : {Target::kGlsl330, Target::kGlsl450, Target::kSpirv}) {
    Sources sources;
    Diagnostics diagnostics;
    SourceId source =
        sources.Add(DataFolder() + "brick_photo.json", GraphText("brick_photo/brick_photo.json"));
    CompileOptions options;
    options.target = target;
    auto compiled = Compile(source, graph::DocumentFormat::kJson, options, sources, diagnostics);
    ASSERT_TRUE(compiled.has_value()) << FormatDiagnostics(diagnostics, sources, false);
    EXPECT_EQ(compiled->dependencies.size(), 2u);
  }
}

// Mortar is grey, bricks are red, and both take their share.
TEST_F(PhotographsTest, BrickWallShowsBricksAndMortar) {
  const std::vector<Point> points = Pixels();
  auto outputs = RunGraph(GraphText("brick_photo/brick_photo.json"), points, {1.0 / 512, 1.0 / 512},
                          2e-3, DataFolder());
  ASSERT_EQ(outputs.size(), 1u);
  const Values& color = outputs["color"];
  int red = 0, grey = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    double r = color.Float(i, 0), g = color.Float(i, 1), b = color.Float(i, 2);
    ASSERT_TRUE(std::isfinite(r) && std::isfinite(g) && std::isfinite(b));
    ASSERT_NEAR(color.Float(i, 3), 1, 1e-5);
    grey += r < 1.1 * b && r > 0.2;
    red += r > 1.4 * b;
  }
  double all = kSide * kSide;
  // Of the photographed cell about a fifth is joint, blurred edges included.
  EXPECT_GT(grey / all, 0.06);
  EXPECT_LT(grey / all, 0.35);
  EXPECT_GT(red / all, 0.55);
}

// A leaf has 0.339 of the square in which its outline was drawn, and that is 0.84 of its frame
// wide. Of the frames 0.8 are there, of a mean square of 1.363; a cell has 0.866: were they
// anywhere, that would cover 1 - exp(-0.339 * 0.84^2 * 0.8 * 1.363 / 0.866) = 0.26 of the ground;
// on a grid they overlap less, and at most 0.30 is covered. On blue ground leaves are what is not
// blue, and shadows are blue.
TEST_F(PhotographsTest, LeavesLieOnTheGround) {
  std::string text = GraphText("leaf_photo/leaf_photo.jsonc");
  const std::string ground = R"("background": "ground")";
  const size_t at = text.find(ground);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, ground.size(), R"("background": [0, 0, 1, 1])");
  std::vector<Point> points = Pixels();
  for (Point& point : points) point = {6 * point.x, 6 * point.y};  // 1,000 cells
  auto outputs = RunGraph(text, points, {1.0 / 512, 1.0 / 512}, 5e-3, DataFolder());
  const Values& color = outputs["color"];
  int leaves = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    ASSERT_NEAR(color.Float(i, 3), 1, 1e-5);
    leaves += std::max(color.Float(i, 0), color.Float(i, 1)) > color.Float(i, 2);
  }
  EXPECT_NEAR(leaves / static_cast<double>(kSide * kSide), 0.28, 0.03);
}

TEST_F(PhotographsTest, TilesCompileForEveryTarget) {
  for (Target target : {Target::kGlsl330, Target::kGlsl450, Target::kSpirv}) {
    Sources sources;
    Diagnostics diagnostics;
    SourceId source =
        sources.Add(DataFolder() + "tile_photos.jsonc", GraphText("tile_photos/tile_photos.jsonc"));
    CompileOptions options;
    options.target = target;
    EXPECT_TRUE(Compile(source, graph::DocumentFormat::kJsonc, options, sources, diagnostics))
        << FormatDiagnostics(diagnostics, sources, false);
  }
}

struct Photograph {
  const char* file;
  uint32_t tile_size;
  double ratio;  // of seams at most, as docs/by_example.md says, and a fifth for few candidates
};

class TilesOfPhotographs : public testing::TestWithParam<Photograph> {};

TEST_P(TilesOfPhotographs, SeamsAreNoWorseThanTheManualSays) {
  const std::string path = DataFolder() + GetParam().file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "no photographs in " << DataFolder();
  Diagnostics diagnostics;
  const auto photograph = textures::ReadImage(path, {}, diagnostics);
  ASSERT_TRUE(photograph);
  textures::TileSetOptions options;
  options.tile_size = GetParam().tile_size;
  options.candidates = 16;
  const auto set =
      textures::MakeTileSet({&*photograph, 1}, {}, options, "photograph", {}, diagnostics);
  ASSERT_TRUE(set);
  EXPECT_EQ(set->packs[0].width, 4 * options.tile_size);
  EXPECT_GT(set->quality.mean, 0.5);
  EXPECT_LT(set->quality.mean, 1.2 * GetParam().ratio);
}

INSTANTIATE_TEST_SUITE_P(
    Photographs, TilesOfPhotographs,
    testing::Values(Photograph{"brick_base_gray.jpg", 128, 1.05},
                    Photograph{"wood_color.jpg", 128, 1.69},
                    Photograph{"quilting_input.png", 64, 2.41}),
    [](const auto& info) {
      return std::string(info.param.file).substr(0, std::string(info.param.file).find('.'));
    });

}  // namespace
}  // namespace texgraph::blocks
