// SPDX-License-Identifier: Apache-2.0
// Materials and areas: probabilities that are what the lists say, areas that are where the map has
// them, borders that dissolve by the weights of bilinear interpolation, transitions that fit.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "tests/blocks/reference.h"
#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Cell = std::pair<int32_t, int32_t>;

int Floored(int a, int n) { return (a % n + n) % n; }

Values Tiles(const std::vector<Vector>& uv, Cell cells, bool toroidal = false, int32_t seed = 0) {
  return RunBlock("virtual_tile_map", {{"uv", Vectors(uv)},
                                       {"cells", CellsOf({cells})},
                                       {"seed", Ints({seed})},
                                       {"toroidal", Bools({toroidal})}})["tile"];
}

// All tiles of a unit square, from their middles.
Values AllTiles(Cell cells, int32_t seed = 0) {
  std::vector<Vector> uv;
  for (int y = 0; y < cells.second; ++y) {
    for (int x = 0; x < cells.first; ++x) {
      uv.push_back({(x + 0.5) / cells.first, (y + 0.5) / cells.second});
    }
  }
  return Tiles(uv, cells, false, seed);
}

std::vector<int> IntsOf(const Values& values) {
  std::vector<int> result;
  for (size_t i = 0; i < values.count; ++i) result.push_back(values.Int(i));
  return result;
}

// --- Probabilities -----------------------------------------------------------------------------

// O6. Over numbers that are spread evenly each pattern comes up exactly as often as the list has
// it.
TEST(ProbabilityMapTest, FrequenciesAreThoseOfTheList) {
  const std::vector<int32_t> list = {4, 4, 4, -1, 9, 9, 0};
  std::vector<double> luck;
  for (int i = 0; i < 700; ++i) luck.push_back((i + 0.5) / 700);
  auto outputs =
      RunBlock("probability_map", {{"random", Floats(luck)}, {"patterns", List{Ints(list)}}});
  ASSERT_EQ(outputs.size(), 1u);
  std::map<int, int> counts;
  for (int pattern : IntsOf(outputs["result"])) ++counts[pattern];
  EXPECT_EQ(counts, (std::map<int, int>{{-1, 100}, {0, 100}, {4, 300}, {9, 200}}));
  // The ends, and beyond: never outside of the list.
  luck = {0, std::nextafter(1.0f, 0.0f) * 1.0, 1, 1e9, -0.2, -1e9};
  outputs = RunBlock("probability_map", {{"random", Floats(luck)}, {"patterns", List{Ints(list)}}});
  EXPECT_EQ(IntsOf(outputs["result"]), (std::vector<int>{4, 0, 0, 0, 4, 4}));
}

TEST(ProbabilityMapTest, TakesARowOfATexture) {
  const ir::Texture lists = MapOf({{1, 1, 2, 3}, {7, 8, 8, 8}});
  auto run = [&](int list) {
    auto outputs = RunBlock(
        "probability_map",
        {{"random", Floats({0, 0.3, 0.6, 0.99, 5, -5})}, {"lists", lists}, {"list", Ints({list})}});
    return IntsOf(outputs["result"]);
  };
  EXPECT_EQ(run(0), (std::vector<int>{1, 1, 2, 3, 3, 1}));
  EXPECT_EQ(run(1), (std::vector<int>{7, 8, 8, 8, 8, 7}));
  EXPECT_EQ(run(9), run(1)) << "beyond the last it is the last";
  EXPECT_EQ(run(-1), std::vector<int>(6, -1)) << "nothing";
}

// O6. Realised frequencies of materials, within what chance allows; the tile's own bits decide.
TEST(MaterialsMapTest, PatternsComeAsOftenAsTheirListsSay) {
  const std::vector<std::vector<double>> rows = {
      {0, 0, 0, 1, 2}, {5, 5, 5, 5, 6}, {-1, -1, 3, 3, 4}};
  const ir::Texture lists = MapOf(rows);
  Values tiles = AllTiles({200, 100}, 3);
  std::vector<std::vector<int>> streams;
  for (int stream : {0, 4}) {
    for (int material : {0, 1, 2}) {
      auto outputs = RunBlock("materials_map", {{"lists", lists},
                                                {"material", Ints({material})},
                                                {"tile", tiles},
                                                {"stream", Ints({stream})}});
      ASSERT_EQ(outputs.size(), 1u);
      std::vector<int> patterns = IntsOf(outputs["result"]);
      std::map<int, int> counts, wanted;
      for (double pattern : rows[static_cast<size_t>(material)])
        ++wanted[static_cast<int>(pattern)];
      for (size_t i = 0; i < patterns.size(); ++i) {
        ++counts[patterns[i]];
        uint32_t bits = tiles.Uint(i, 6);
        if (stream != 0) bits = reference::Pcg(bits + 4);
        ASSERT_EQ(patterns[i], rows[static_cast<size_t>(material)][(bits >> 16) * 5 / 65536]);
      }
      for (auto [pattern, count] : counts) {
        const double p = wanted[pattern] / 5.0, n = 20000;
        EXPECT_NEAR(count, n * p, 4 * std::sqrt(n * p * (1 - p))) << pattern;
      }
      if (material == 0) streams.push_back(patterns);
    }
  }
  int equal = 0;
  for (size_t i = 0; i < streams[0].size(); ++i) equal += streams[0][i] == streams[1][i];
  EXPECT_NEAR(equal, 20000 * 11 / 25.0, 5 * std::sqrt(20000 * 0.25)) << "streams are independent";
  for (int material : {-1, -100}) {
    auto nothing = RunBlock("materials_map",
                            {{"lists", lists}, {"material", Ints({material})}, {"tile", tiles}});
    EXPECT_EQ(IntsOf(nothing["result"]), std::vector<int>(20000, -1));
  }
  auto beyond =
      RunBlock("materials_map", {{"lists", lists}, {"material", Ints({7})}, {"tile", tiles}});
  auto last =
      RunBlock("materials_map", {{"lists", lists}, {"material", Ints({2})}, {"tile", tiles}});
  EXPECT_EQ(beyond["result"].words, last["result"].words);
}

// --- Areas -------------------------------------------------------------------------------------

std::vector<std::vector<double>> SomeMap(int width, int height) {
  std::vector<std::vector<double>> rows(static_cast<size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) rows[static_cast<size_t>(y)].push_back(width * y + x - 1);
  }
  return rows;
}

int NumberAt(const std::vector<std::vector<double>>& rows, int x, int y) {
  const std::vector<double>& row =
      rows[static_cast<size_t>(Floored(y, static_cast<int>(rows.size())))];
  return static_cast<int>(row[static_cast<size_t>(Floored(x, static_cast<int>(row.size())))]);
}

TEST(AreasMapTest, AreasAreWhereTheMapHasThem) {
  struct Case {
    int width, height;
    Cell cells;
  };
  for (const Case& one : {Case{8, 8, {64, 64}}, {3, 5, {12, 35}}, {4, 2, {4, 2}}, {1, 1, {9, 9}}}) {
    const auto rows = SomeMap(one.width, one.height);
    const ir::Texture map = MapOf(rows);
    std::vector<Vector> uv = Lattice(-1, 2, 90);
    for (bool toroidal : {false, true}) {
      Values tiles = Tiles(uv, one.cells, toroidal);
      auto outputs =
          RunBlock("areas_map", {{"areas", map}, {"tile", tiles}, {"cells", CellsOf({one.cells})}});
      ASSERT_EQ(outputs.size(), 1u);
      for (size_t i = 0; i < uv.size(); ++i) {
        // The middle of the tile, in areas.
        const double x = (std::floor(uv[i][0] * one.cells.first) + 0.5) / one.cells.first;
        const double y = (std::floor(uv[i][1] * one.cells.second) + 0.5) / one.cells.second;
        ASSERT_EQ(outputs["result"].Int(i),
                  NumberAt(rows, static_cast<int>(std::floor(x * one.width)),
                           static_cast<int>(std::floor(y * one.height))))
            << uv[i][0] << " " << uv[i][1];
      }
    }
  }
}

// A map that is larger than the tile map, or does not divide it, is read inside all the same.
TEST(AreasMapTest, NeverReadsOutside) {
  const ir::Texture map = MapOf(std::vector<std::vector<double>>(7, std::vector<double>(5, 2)));
  for (Cell cells : {Cell{3, 3}, {8, 9}, {64, 64}}) {
    Values tiles = Tiles(Lattice(-1, 2, 60), cells);
    for (const char* block : {"areas_map", "dithered_areas_map"}) {
      auto outputs =
          RunBlock(block, {{"areas", map}, {"tile", tiles}, {"cells", CellsOf({cells})}});
      EXPECT_EQ(IntsOf(outputs["result"]), std::vector<int>(3600, 2)) << block;
    }
  }
}

// --- Dithering ---------------------------------------------------------------------------------

// O8. As often as the share says, and exactly at its ends.
TEST(DitherTest, TheSecondComesAsOftenAsItsShare) {
  std::vector<double> luck;
  for (int i = 0; i < 400; ++i) luck.push_back(i / 400.0);
  for (double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    auto outputs = RunBlock("dither", {{"a", Ints({7})},
                                       {"b", Ints({-3})},
                                       {"share", Floats({share})},
                                       {"random", Floats(luck)}});
    ASSERT_EQ(outputs.size(), 1u);
    std::map<int, int> counts;
    for (int number : IntsOf(outputs["result"])) ++counts[number];
    EXPECT_EQ(counts[-3], 400 * share);
    EXPECT_EQ(counts[7], 400 - 400 * share);
  }
}

// The weight of the area (x, y) for the middle of a tile: the product of two hats of the width of
// an area, around the area's middle. In double, on the torus.
double BilinearWeight(Cell tile, Cell area, Cell cells, Cell areas) {
  double weight = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const int count = axis == 0 ? areas.first : areas.second;
    const double p = ((axis == 0 ? tile.first : tile.second) + 0.5) * count /
                     (axis == 0 ? cells.first : cells.second);
    double hats = 0;
    for (int turn : {-1, 0, 1}) {
      const double middle = (axis == 0 ? area.first : area.second) + 0.5 + turn * count;
      hats += std::fmax(0, 1 - std::fabs(p - middle));
    }
    weight *= hats;
  }
  return weight;
}

// O8 in the plane: each of the four areas comes as often as it is weighed, tile by tile, over many
// seeds; what has the weight 0 never comes, what has the weight 1 always.
TEST(DitheredAreasMapTest, AreasComeByTheirBilinearWeights) {
  struct Case {
    Cell areas, cells;
  };
  for (const Case& one : {Case{{4, 4}, {16, 16}}, {{3, 2}, {9, 10}}, {{2, 2}, {2, 2}}}) {
    const auto rows = SomeMap(one.areas.first, one.areas.second);
    const ir::Texture map = MapOf(rows);
    const size_t tiles = static_cast<size_t>(one.cells.first * one.cells.second);
    constexpr int kSeeds = 600;
    std::vector<std::map<int, int>> counts(tiles);
    for (int seed = 0; seed < kSeeds; ++seed) {
      Values all = AllTiles(one.cells, seed);
      auto outputs = RunBlock("dithered_areas_map",
                              {{"areas", map}, {"tile", all}, {"cells", CellsOf({one.cells})}});
      ASSERT_EQ(outputs.size(), 1u);
      for (size_t i = 0; i < tiles; ++i) ++counts[i][outputs["result"].Int(i)];
    }
    double statistic = 0;
    int freedoms = 0;
    for (size_t i = 0; i < tiles; ++i) {
      const Cell tile{static_cast<int>(i) % one.cells.first, static_cast<int>(i) / one.cells.first};
      int wanted_kinds = 0;
      for (int y = 0; y < one.areas.second; ++y) {
        for (int x = 0; x < one.areas.first; ++x) {
          const double weight = BilinearWeight(tile, {x, y}, one.cells, one.areas);
          const int count = counts[i][NumberAt(rows, x, y)];
          const double expected = kSeeds * weight;
          if (weight < 1e-9) {
            ASSERT_EQ(count, 0) << i;
            continue;
          }
          if (weight > 1 - 1e-9) {
            ASSERT_EQ(count, kSeeds) << i;
          }
          EXPECT_NEAR(count, expected, 5.5 * std::sqrt(expected * (1 - weight)) + 1e-6) << i;
          statistic += (count - expected) * (count - expected) / expected;
          ++wanted_kinds;
        }
      }
      freedoms += wanted_kinds - 1;
    }
    const double spread = 5 * std::sqrt(2.0 * freedoms);
    EXPECT_NEAR(statistic, freedoms, spread + 1e-6);
  }
}

// O9. All points of a tile get one material, also in the middle of a border.
TEST(DitheredAreasMapTest, TilesAreOfOneMaterial) {
  const ir::Texture map = MapOf(SomeMap(4, 4));
  std::vector<Vector> uv = Lattice(-1, 1, 240);
  Values tiles = Tiles(uv, {16, 16});
  auto outputs = RunBlock("dithered_areas_map",
                          {{"areas", map}, {"tile", tiles}, {"cells", CellsOf({{16, 16}})}});
  ASSERT_EQ(outputs.size(), 1u);
  std::map<Cell, int> materials;
  std::set<int> kinds;
  for (size_t i = 0; i < uv.size(); ++i) {
    const Cell cell{tiles.Int(i, 0), tiles.Int(i, 1)};
    auto [known, is_new] = materials.emplace(cell, outputs["result"].Int(i));
    ASSERT_EQ(known->second, outputs["result"].Int(i));
    kinds.insert(known->second);
  }
  EXPECT_EQ(kinds.size(), 16u);
}

TEST(DitheredAreasMapTest, StreamsAreIndependent) {
  const ir::Texture map = MapOf({{0, 1}, {2, 3}});
  Values tiles = AllTiles({128, 128});
  std::array<std::vector<int>, 2> seen;
  for (int stream : {0, 1}) {
    seen[static_cast<size_t>(stream)] =
        IntsOf(RunBlock("dithered_areas_map", {{"areas", map},
                                               {"tile", tiles},
                                               {"cells", CellsOf({{128, 128}})},
                                               {"stream", Ints({stream})}})["result"]);
  }
  // Equal as often as the squares of the weights add up to.
  double expected = 0, variance = 0;
  int equal = 0;
  for (int i = 0; i < 128 * 128; ++i) {
    double same = 0;
    for (int area = 0; area < 4; ++area) {
      const double w = BilinearWeight({i % 128, i / 128}, {area % 2, area / 2}, {128, 128}, {2, 2});
      same += w * w;
    }
    expected += same;
    variance += same * (1 - same);
    equal += seen[0][static_cast<size_t>(i)] == seen[1][static_cast<size_t>(i)];
  }
  EXPECT_NEAR(equal, expected, 5 * std::sqrt(variance));
}

// --- Transitions -------------------------------------------------------------------------------

struct Transitions {
  std::vector<int> materials, transitions;
};

// As many transitions as there are for so many families: number i is pattern i.
std::string NumberedTransitions(int count) {
  std::string list = "[0";
  for (int i = 1; i < count * count * count * count; ++i) list += ", " + std::to_string(i);
  return list + "]";
}

// The blocks in a graph, at the middle of each tile of a torus: the material is a map's.
Transitions RunTransitions(const std::vector<std::vector<double>>& rows,
                           const std::string& families, int count) {
  const int width = static_cast<int>(rows[0].size()), height = static_cast<int>(rows.size());
  const std::string size = "[" + std::to_string(width) + ", " + std::to_string(height) + "]";
  std::vector<Point> points;
  for (int i = 0; i < width * height; ++i) {
    points.push_back({(i % width + 0.5) / width, (i / width + 0.5) / height});
  }
  auto outputs = RunGraph(
      R"({"texgraph": 1, "textures": {"where": {"file": "moss.png"}}, "nodes": {
        "tiles": {"block": "virtual_tile_map", "in": {"cells": )" +
          size + R"(, "toroidal": true}},
        "map": {"block": "explicit_indirection_map", "in": {"map": "where", "tile": "tiles"}},
        "t": {"block": "transition_tiles", "in": {"material": "map", "families": )" +
          families + R"(, "transitions": )" + NumberedTransitions(count) + R"(}},
        "told": {"block": "combine2", "in": {"x": "t.material_here", "y": "t.transition"}},
        "both": {"block": "components", "in": {"vector": "told"}},
        "color": {"block": "combine4", "in": {"x": "both.x", "y": "both.y"}}},
      "outputs": {"color": "color"}})",
      points, {1e-4, 1e-4}, 1e-4, PictureFolder(), {{"where", MapOf(rows)}});
  Transitions seen;
  for (size_t i = 0; i < points.size() && !outputs.empty(); ++i) {
    seen.materials.push_back(static_cast<int>(outputs["color"].Float(i, 0)));
    seen.transitions.push_back(static_cast<int>(outputs["color"].Float(i, 1)));
  }
  return seen;
}

// O10. Tiles that share a border have the same families at its ends; plain tiles have no
// transition; and all of m^4 - m transitions come up.
TEST(TransitionTilesTest, BordersAgreeAboutTheirCorners) {
  for (int count : {2, 3}) {
    const std::vector<int> families = {0, 1, 1, count - 1, 0};
    // A torus of random materials, large enough that each transition comes up.
    const int side = 48;
    const int kinds = count == 2 ? 3 : 5;
    std::vector<std::vector<double>> rows(side, std::vector<double>(side));
    for (int i = 0; i < side * side; ++i) {
      rows[static_cast<size_t>(i / side)][static_cast<size_t>(i % side)] =
          reference::Pcg(static_cast<uint32_t>(i)) % static_cast<uint32_t>(kinds);
    }
    Transitions seen =
        RunTransitions(rows, count == 2 ? "[0, 1, 1, 1, 0]" : "[0, 1, 1, 2, 0]", count);
    ASSERT_EQ(seen.transitions.size(), static_cast<size_t>(side * side));
    // The families of a tile's four corners: left below, right below, left above, right above.
    auto corners = [&](int x, int y) {
      const int at = Floored(y, side) * side + Floored(x, side);
      const int transition = seen.transitions[static_cast<size_t>(at)];
      const int here = families[static_cast<size_t>(seen.materials[static_cast<size_t>(at)])];
      std::array<int, 4> corners{here, here, here, here};
      for (int k = 0, rest = transition; k < 4 && transition >= 0; ++k, rest /= count) {
        corners[static_cast<size_t>(k)] = rest % count;
      }
      return corners;
    };
    std::set<int> different;
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        const size_t at = static_cast<size_t>(y * side + x);
        ASSERT_EQ(seen.materials[at], rows[static_cast<size_t>(y)][static_cast<size_t>(x)]);
        const auto here = corners(x, y), right = corners(x + 1, y), up = corners(x, y + 1);
        ASSERT_EQ(here[0], families[static_cast<size_t>(seen.materials[at])]);
        ASSERT_EQ(here[1], right[0]);
        ASSERT_EQ(here[3], right[2]);
        ASSERT_EQ(here[2], up[0]);
        ASSERT_EQ(here[3], up[1]);
        const bool plain = here[0] == here[1] && here[0] == here[2] && here[0] == here[3];
        EXPECT_EQ(seen.transitions[at] == -1, plain);
        if (!plain) different.insert(seen.transitions[at]);
      }
    }
    EXPECT_EQ(different.size(), static_cast<size_t>(count * count * count * count - count));
  }
}

// --- Lines and volumes, computed areas, masks ---------------------------------------------------

Values Whole3(int x, int y, int z) {
  return {ir::Vector(ir::Scalar::kInt, 3),
          1,
          {static_cast<uint32_t>(x), static_cast<uint32_t>(y), static_cast<uint32_t>(z)}};
}

// Of a line and in space: areas where the map has them, and borders by the linear weights.
TEST(AreasMapTest, OfALineAndInSpace) {
  const ir::Texture row = MapOf({{4, 7, -1}});
  ir::Texture volume;
  volume.is_3d = true;
  volume.levels.push_back({1, 1, 3, {{4, 0, 0, 1}, {7, 0, 0, 1}, {-1, 0, 0, 1}}});
  std::array<std::map<int, int>, 12> of_line, in_space;
  constexpr int kSeeds = 800;
  for (int seed = 0; seed < kSeeds; ++seed) {
    std::vector<double> u;
    std::vector<Vector> uvw;
    for (int i = -6; i < 6; ++i) {
      u.push_back((i + 0.5) / 12);
      uvw.push_back({0.3, 0.6, (i + 0.5) / 12});
    }
    Values line =
        RunBlock("virtual_tile_map",
                 {{"uv", Floats(u)}, {"cells", Ints({12})}, {"seed", Ints({seed})}})["tile"];
    Values space = RunBlock(
        "virtual_tile_map",
        {{"uv", Vectors(uvw)}, {"cells", Whole3(2, 2, 12)}, {"seed", Ints({seed})}})["tile"];
    auto plain_line =
        RunBlock("areas_map", {{"areas", row}, {"tile", line}, {"cells", Ints({12})}});
    auto plain_space =
        RunBlock("areas_map", {{"areas", volume}, {"tile", space}, {"cells", Whole3(2, 2, 12)}});
    auto line_numbers =
        RunBlock("dithered_areas_map", {{"areas", row}, {"tile", line}, {"cells", Ints({12})}});
    auto space_numbers = RunBlock(
        "dithered_areas_map", {{"areas", volume}, {"tile", space}, {"cells", Whole3(2, 2, 12)}});
    for (size_t i = 0; i < 12; ++i) {
      const int area = std::array<int, 3>{4, 7, -1}[(i + 6) % 12 / 4];
      ASSERT_EQ(plain_line["result"].Int(i), area);
      ASSERT_EQ(plain_space["result"].Int(i), area);
      ++of_line[i][line_numbers["result"].Int(i)];
      ++in_space[i][space_numbers["result"].Int(i)];
    }
  }
  for (size_t i = 0; i < 12; ++i) {
    for (int area = 0; area < 3; ++area) {
      // The other axes have one area: their weight is 1.
      const double weight =
          BilinearWeight({static_cast<int>((i + 6) % 12), 0}, {area, 0}, {12, 1}, {3, 1});
      const int number = std::array<int, 3>{4, 7, -1}[static_cast<size_t>(area)];
      const double spread = 5 * std::sqrt(kSeeds * weight * (1 - weight)) + 1e-6;
      EXPECT_NEAR(of_line[i][number], kSeeds * weight, spread);
      EXPECT_NEAR(in_space[i][number], kSeeds * weight, spread);
    }
  }
}

TEST(MaterialsMapTest, OfALineAndInSpace) {
  const ir::Texture lists = MapOf({{0, 1, 2}, {3, 4, 5}});
  Values line =
      RunBlock("virtual_tile_map", {{"uv", Floats({0.1, 0.7})}, {"cells", Ints({9})}})["tile"];
  Values space = RunBlock("virtual_tile_map", {{"uv", Vectors({{0.1, 0.7, 0.2}, {0.4, 0.2, 0.9}})},
                                               {"cells", Whole3(5, 6, 7)}})["tile"];
  for (const Values* tiles : {&line, &space}) {
    auto outputs =
        RunBlock("materials_map", {{"lists", lists}, {"material", Ints({1})}, {"tile", *tiles}});
    ASSERT_EQ(outputs.size(), 1u);
    for (size_t i = 0; i < 2; ++i) {
      const uint32_t bits = tiles->Uint(i, tiles == &line ? 3 : 9);
      EXPECT_EQ(outputs["result"].Int(i), static_cast<int>(3 + (bits >> 16) * 3 / 65536));
    }
  }
}

// The same where an area has more half tiles than 16 random bits have values: from 3/8 of the way
// the right one of two areas has the weight 1/4.
TEST(DitheredAreaTest, LargeAreasAreWeighedAsSmallOnes) {
  for (int tiles : {16, 30000, 70000, 1 << 19}) {
    std::vector<Cell> cells;
    std::vector<int32_t> line;
    std::vector<uint32_t> seeds;
    constexpr int kCount = 20000;
    for (int i = 0; i < kCount; ++i) {
      cells.emplace_back(3 * tiles / 4, tiles / 2);
      line.push_back(3 * tiles / 4);
      seeds.push_back(reference::Pcg(static_cast<uint32_t>(i)));
    }
    const std::vector<Values> picked = {
        RunBlock("dithered_area", {{"cell", CellsOf(cells)},
                                   {"seed", Uints(seeds)},
                                   {"cells", CellsOf({{2 * tiles, tiles}})},
                                   {"tiles", CellsOf({{tiles, tiles}})}})["result"],
        RunBlock("dithered_area", {{"cell", Ints(line)},
                                   {"seed", Uints(seeds)},
                                   {"cells", Ints({2 * tiles})},
                                   {"tiles", Ints({tiles})}})["result"]};
    for (const Values& areas : picked) {
      ASSERT_EQ(areas.count, seeds.size());
      // The middle of a cell is half a cell further.
      const double weight = 0.25 + 0.5 / tiles;
      int right = 0;
      for (size_t i = 0; i < areas.count; ++i) {
        ASSERT_TRUE(areas.Int(i) == 0 || areas.Int(i) == 1);
        right += areas.Int(i);
      }
      EXPECT_NEAR(right, kCount * weight, 5 * std::sqrt(kCount * weight * (1 - weight))) << tiles;
    }
  }
}

// Computed areas are those of a map with the same numbers, tile by tile, dithered or not.
TEST(VirtualAreasMapTest, IsTheMapThatItComputes) {
  // 8 * row + column, rounded down in 64ths of the middle's coordinates.
  const std::string graph = R"({"texgraph": 1, "textures": {"where": {"file": "moss.png"}},
    "functions": {"number": {"inputs": {"uv": "vec2"}, "nodes": {
        "p": {"block": "components", "in": {"vector": "uv"}},
        "x": {"block": "multiply", "in": {"a": "p.x", "b": 4}},
        "y": {"block": "multiply", "in": {"a": "p.y", "b": 2}},
        "column": {"block": "round_down", "in": {"value": "x"}},
        "row": {"block": "round_down", "in": {"value": "y"}},
        "rows": {"block": "multiply", "in": {"a": "row", "b": 4}},
        "sum": {"block": "add", "in": {"a": "rows", "b": "column"}},
        "whole": {"block": "to_int", "in": {"value": "sum"}}}, "outputs": {"number": "whole"}}},
    "nodes": {
      "tiles": {"block": "virtual_tile_map", "in": {"cells": [16, 12]}},
      "sharp": {"block": "virtual_areas_map", "in": {"area": "number", "tile": "tiles",
                "cells": [16, 12], "areas": [4, 2]}},
      "soft": {"block": "virtual_areas_map", "in": {"area": "number", "tile": "tiles",
               "cells": [16, 12], "areas": [4, 2], "dithered": true}},
      "map": {"block": "explicit_indirection_map", "in": {"map": "where", "tile": "areas"}},
      "areas": {"block": "virtual_tile_map", "in": {"cells": [4, 2]}},
      "told": {"block": "combine3", "in": {"x": "sharp", "y": "soft", "z": "map"}}},
    "outputs": {"normal": "told"}})";
  const auto rows = std::vector<std::vector<double>>{{0, 1, 2, 3}, {4, 5, 6, 7}};
  const ir::Texture map = MapOf(rows);
  std::vector<Point> points;
  std::vector<Vector> uv;
  for (const Vector& p : Lattice(-1, 2, 48)) {
    points.push_back({p[0], p[1]});
    uv.push_back(p);
  }
  auto outputs = RunGraph(graph, points, {1e-5, 1e-5}, 1e-4, PictureFolder(), {{"where", map}});
  ASSERT_EQ(outputs.size(), 1u);
  auto soft =
      RunBlock("dithered_areas_map",
               {{"areas", map}, {"tile", Tiles(uv, {16, 12})}, {"cells", CellsOf({{16, 12}})}});
  for (size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(outputs["normal"].Float(i, 0), outputs["normal"].Float(i, 2));
    EXPECT_EQ(outputs["normal"].Float(i, 1), soft["result"].Int(i));
  }
}

// The border of a mask is a pixel wide at every magnification, and from afar the share is the mean.
TEST(PixelMapTest, BordersAreAPixelWide) {
  ir::Texture mask;
  mask.levels.push_back({16, 16, 1, {}});
  for (int i = 0; i < 256; ++i) {
    const float inside = i % 16 >= 4 && i % 16 < 8 ? 1.0f : 0.0f;
    mask.levels[0].texels.push_back({inside, 0.3f, 0.7f, 1});
  }
  ir::BuildMipChain(mask);
  const std::string graph =
      R"({"texgraph": 1, "textures": {"mask": {"file": "moss.png"}}, "nodes": {
      "families": {"block": "pixel_map", "in": {"mask": "mask"}},
      "told": {"block": "combine3", "in": {"x": "families.family", "y": "families.share"}}},
    "outputs": {"normal": "told"}})";
  for (double pixel : {0.0005, 0.004, 0.03}) {
    std::vector<Point> points;
    for (int i = 0; i < 4000; ++i) points.push_back({(i + 0.5) / 4000, 0.53});
    auto outputs = RunGraph(graph, points, {pixel, pixel}, 1e-4, PictureFolder(), {{"mask", mask}});
    ASSERT_EQ(outputs.size(), 1u);
    int between = 0;
    double sum = 0;
    for (size_t i = 0; i < points.size(); ++i) {
      const float share = outputs["normal"].Float(i, 1);
      between += share > 0.001 && share < 0.999;
      sum += share;
      EXPECT_EQ(outputs["normal"].Float(i, 0), share >= 0.5f);
      if (std::fabs(points[i].x - 0.375) < 0.125 - pixel) {
        ASSERT_NEAR(share, 1, 1e-4);
      }
    }
    // Two borders, each a pixel wide.
    EXPECT_NEAR(between / 4000.0, 2 * pixel, 0.1 * pixel + 0.002);
    EXPECT_NEAR(sum / 4000, 0.25, 1e-3);
  }
  auto far =
      RunGraph(graph, {{0.3, 0.3}, {0.8, 0.1}}, {2, 2}, 1e-4, PictureFolder(), {{"mask", mask}});
  EXPECT_NEAR(far["normal"].Float(0, 1), 0.25, 1e-4);
  EXPECT_NEAR(far["normal"].Float(1, 1), 0.25, 1e-4);
}

TEST(TransitionPatternTest, IsTheTilesOwnUnlessThereIsATransition) {
  auto outputs = RunBlock("transition_pattern",
                          {{"plain", Ints({5, 5, 5, -1})}, {"transition", Ints({-1, 0, 14, -1})}});
  ASSERT_EQ(outputs.count("result"), 1u);
  const int expected[] = {5, 0, 14, -1};
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(outputs["result"].Int(i), expected[i]) << i;
}

}  // namespace
}  // namespace texgraph::blocks
