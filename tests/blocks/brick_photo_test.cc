// SPDX-License-Identifier: Apache-2.0
// The brick wall on photographs, tests/graphs/brick_photo/. They are not part of the project:
// TEXGRAPH_DATA names their folder, else it is ../shared/data beside the source; without them the
// tests are skipped.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "compiler/compile.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

std::string DataFolder() {
  const char* folder = std::getenv("TEXGRAPH_DATA");
  return folder != nullptr ? std::string(folder) + "/" : TEXGRAPH_SOURCE_DIR "/../shared/data/";
}

class BrickPhotoTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(DataFolder() + "brick_base_gray.jpg")) {
      GTEST_SKIP() << "no photographs in " << DataFolder();
    }
    std::ifstream file(TEXGRAPH_SOURCE_DIR "/tests/graphs/brick_photo/brick_photo.json");
    std::stringstream text;
    text << file.rdbuf();
    text_ = text.str();
  }
  std::string text_;
};

TEST_F(BrickPhotoTest, CompilesForEveryTarget) {
  for (Target target : {Target::kGlsl330, Target::kGlsl450, Target::kSpirv}) {
    Sources sources;
    Diagnostics diagnostics;
    SourceId source = sources.Add(DataFolder() + "brick_photo.json", text_);
    CompileOptions options;
    options.target = target;
    auto compiled = Compile(source, graph::DocumentFormat::kJson, options, sources, diagnostics);
    ASSERT_TRUE(compiled.has_value()) << FormatDiagnostics(diagnostics, sources, false);
    EXPECT_EQ(compiled->dependencies.size(), 2u);
  }
}

// Mortar is grey, bricks are red, and both take their share.
TEST_F(BrickPhotoTest, ShowsBricksAndMortar) {
  constexpr int kSide = 96;
  std::vector<Point> points;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      points.push_back({(x + 0.5) / kSide, (y + 0.5) / kSide});
    }
  }
  auto outputs = RunGraph(text_, points, {1.0 / 512, 1.0 / 512}, 2e-3, DataFolder());
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

}  // namespace
}  // namespace texgraph::blocks
