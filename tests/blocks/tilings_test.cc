// SPDX-License-Identifier: Apache-2.0
// The tilings of figures 10a to 10d of "Pattern Based Procedural Textures", which leaves their
// filtering open: against 1,024 samples a pixel, and their borders at every mip level.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "compiler/compile.h"
#include "compiler/ir/print.h"
#include "tests/blocks/mean_error.h"

namespace texgraph::blocks {
namespace {

constexpr double kCells = 64;  // a side, in all of the graphs

std::string FolderOf(const std::string& name) {
  return TEXGRAPH_SOURCE_DIR "/graphs/" + name + "/";
}

std::string TextOf(const std::string& name) {
  std::ifstream file(FolderOf(name) + name + ".jsonc");
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return at == text.npos ? text : text.replace(at, from.size(), to);
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

// Mean absolute differences of two neighbouring pixels, and of the two differences of three, where
// they lie in one cell and where a border passes between them.
struct Jumps {
  double value_inside = 0, value_across = 0, slope_inside = 0, slope_across = 0;
};

// Three pixels of 1 / `pixels` of a cell in a row, at many places. `upright`: above each other.
Jumps JumpsAt(const std::string& text, const std::string& folder, int pixels, bool upright) {
  constexpr int kPlaces = 3072;
  const double step = 1 / (kCells * pixels);
  const auto share = [](double factor, int i) { return std::fmod(0.5 + factor * i, 1); };
  std::vector<Point> points;
  for (bool is_across : {false, true}) {
    for (int i = 0; i < kPlaces; ++i) {
      // Where the second pixel is, in cells. All parts of a border come in turn.
      const double aside = std::floor(kCells * share(0.8191725134, i)) + (i + 0.5) / kPlaces;
      const double border = std::floor(kCells * share(0.6710436067, i));
      const double phase = share(0.5497004779, i);
      const double along =
          border + (is_across ? (2 * phase - 1) / pixels : (1 + phase * (pixels - 2)) / pixels);
      for (int k : {-1, 0, 1}) {
        const double u = along / kCells + k * step, v = aside / kCells;
        points.push_back(upright ? Point{v, u} : Point{u, v});
      }
    }
  }
  const std::vector<double> colors = ColorsAt(text, points, step, folder);
  std::array<double, 4> sums{};
  for (size_t i = 0; i < points.size(); i += 3) {
    const bool is_across = i >= points.size() / 2;
    const double middle = kCells * (upright ? points[i + 1].y : points[i + 1].x);
    // The border is in the cell's whole part; before the second pixel, or behind it.
    const bool is_behind = is_across && std::fmod(middle + 1, 1) > 0.5;
    for (size_t c = 0; c < 3; ++c) {
      const double before = colors[3 * i + c], here = colors[3 * i + 3 + c],
                   after = colors[3 * i + 6 + c];
      sums[is_across] += std::fabs(is_behind ? after - here : here - before);
      sums[2 + is_across] += std::fabs(after - 2 * here + before);
    }
  }
  return {sums[0] / kPlaces, sums[1] / kPlaces, sums[2] / kPlaces, sums[3] / kPlaces};
}

// The graph with one material everywhere, so that no border lies between two.
std::string OfOneMaterial(std::string text, int material) {
  const std::string begin = R"("map": )", end = "]]";
  const size_t at = text.find(begin), to = text.find(end, at);
  EXPECT_NE(to, text.npos);
  return text.replace(at, to + end.size() - at, begin + "[[" + std::to_string(material) + "]]");
}

struct Surface {
  std::string name, graph;
  std::optional<int> material;  // the only one
};

class TilingBordersTest : public testing::TestWithParam<Surface> {};

TEST_P(TilingBordersTest, DoNotShow) {
  const Surface& surface = GetParam();
  std::string text = TextOf(surface.graph);
  if (surface.material) text = OfOneMaterial(text, *surface.material);
  // From four pixels a texel to four pixels a pattern: with two, none of three lie inside.
  for (int pixels : {512, 256, 128, 96, 64, 48, 32, 24, 16, 12, 8, 6, 4}) {
    for (bool upright : {false, true}) {
      const Jumps jumps = JumpsAt(text, FolderOf(surface.graph), pixels, upright);
      EXPECT_LE(jumps.value_across, 1.1 * jumps.value_inside)
          << pixels << " pixels a pattern, " << (upright ? "upwards" : "to the right");
      EXPECT_LE(jumps.slope_across, 1.1 * jumps.slope_inside)
          << pixels << " pixels a pattern, " << (upright ? "upwards" : "to the right");
      RecordProperty((upright ? "up_" : "right_") + std::to_string(pixels),
                     std::to_string(jumps.value_across / jumps.value_inside) + " " +
                         std::to_string(jumps.slope_across / jumps.slope_inside));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Grounds, TilingBordersTest,
                         testing::Values(Surface{"Meadow", "aperiodic_tiling", {}},
                                         Surface{"Weighted", "weighted_tiling", {}},
                                         Surface{"Grass", "areas_tiling", 0},
                                         Surface{"Flowers", "areas_tiling", 1},
                                         Surface{"DryGrass", "areas_tiling", 2},
                                         Surface{"Stones", "areas_tiling", 3}),
                         [](const auto& surface) { return surface.param.name; });

// How much brighter pixels that touch a border of a cell are than the others, as a part of these.
double BrightnessOfBorders(const std::string& text, const std::string& folder, int pixels) {
  const double step = 1 / (kCells * pixels);
  const int side = 8 * pixels;
  std::vector<Point> points;
  for (int i = 0; i < side * side; ++i) {
    points.push_back({(i % side + 0.5) * step, (i / side + 0.5) * step});
  }
  const std::vector<double> colors = ColorsAt(text, points, step, folder);
  auto touches = [&](double along) {
    const double in_cell = kCells * along - std::floor(kCells * along);
    return std::min(in_cell, 1 - in_cell) * pixels < 1;
  };
  std::array<double, 2> sums{}, counts{};
  for (size_t i = 0; i < points.size(); ++i) {
    const bool is_border = touches(points[i].x) || touches(points[i].y);
    const double* color = &colors[3 * i];
    sums[is_border] += 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    ++counts[is_border];
  }
  return sums[1] / counts[1] / (sums[0] / counts[0]) - 1;
}

// Borders within a material are as bright as the patterns have them, with no tint of the other
// materials.
TEST(TilingBorders, OfAMaterialAreNotTintedByOthers) {
  const std::string folder = FolderOf("areas_tiling");
  for (int material = 0; material < 4; ++material) {
    const std::string matched = OfOneMaterial(TextOf("areas_tiling"), material);
    const std::string given = Replaced(matched, R"(, "edges": "kinds")", "");
    for (int pixels : {10, 14, 20}) {
      const std::string where =
          "material " + std::to_string(material) + ", pixels " + std::to_string(pixels);
      EXPECT_NEAR(BrightnessOfBorders(matched, folder, pixels),
                  BrightnessOfBorders(given, folder, pixels), 0.01)
          << where;
    }
  }
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
      const std::vector<double> known = ColorsAt(text, points, pixel, folder);
      const std::vector<double> general =
          ColorsAt(Replaced(text, c.from, c.to), points, pixel, folder);
      // A texture that repeats is read at another whole place; that rounds in another way.
      for (size_t i = 0; i < known.size(); ++i) {
        ASSERT_NEAR(known[i], general[i], 2e-4)
            << c.graph << " with " << c.to << ", pixels of " << pixel;
      }
    }
  }
}

// Where a texture repeats in all directions its coordinate need not jump; else it must.
TEST(RepeatedCoordinates, NeedEveryDirection) {
  auto lowered = [](const std::string& wrap) {
    Sources sources;
    Diagnostics diagnostics;
    const std::string text = R"({"texgraph": 1, "textures": {"trees": {"sheet": "trees.png",
      "grid": [12, 12], "pack": "volume", )" +
                             wrap +
                             R"(}}, "nodes": {
      "grid": {"block": "virtual_tile_map", "in": {"uv": "position", "cells": [8, 8, 8]}},
      "tree": {"block": "reference_texture", "in": {"patterns": "trees", "tile": "grid",
               "pattern": 0}}}, "outputs": {"color": "tree"}})";
    SourceId source = sources.Add(FolderOf("volumetric_trees") + "g.json", text);
    auto done = Lower(source, graph::DocumentFormat::kJson, {}, sources, diagnostics);
    EXPECT_TRUE(done) << FormatDiagnostics(diagnostics, sources, false);
    return done ? ir::Print(*done->module) : "";
  };
  EXPECT_EQ(lowered(R"("wrap": "repeat")").find("sample_grad"), std::string::npos);
  for (const char* wrap : {R"("wrap": "clamp", "wrap_u": "repeat", "wrap_v": "repeat")",
                           R"("wrap_u": "mirror")", R"("wrap_v": "clamp")"}) {
    EXPECT_NE(lowered(wrap).find("sample_grad"), std::string::npos) << wrap;
  }
}

}  // namespace
}  // namespace texgraph::blocks
