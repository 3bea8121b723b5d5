// SPDX-License-Identifier: Apache-2.0
// "Numbers out of range" of docs/indirection.md, line by line: what the blocks give for numbers
// that a program could write into a uniform or a map. Outside of a texture the evaluator reads
// zeros, and no map here has a zero: so whatever comes out of a map was read inside of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <functional>
#include <limits>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/blocks/run_block.h"

namespace texgraph::blocks {
namespace {

using Rows = std::vector<std::vector<double>>;
using Outputs = std::map<std::string, Values>;

constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr size_t kLocal = 2, kSeed = 6;  // words of a Tile

const std::vector<int32_t> kBelow = {-1, -5, -1000000000, INT_MIN};
const std::vector<int32_t> kAnywhere = {INT_MIN, INT_MIN + 1, -1000000007, -1,
                                        3,       1000000007,  INT_MAX - 1, INT_MAX};
const std::vector<double> kWildTimes = {0.5, -0.5, 1e9, -1e9, 1e30, -1e30, 3e38, kInf, -kInf, kNan};
const Rows kMap = {{11, 12, 13}, {21, 22, 23}};  // from v = 0

std::set<int> NumbersOf(const Rows& rows) {
  std::set<int> numbers;
  for (const auto& row : rows) numbers.insert(row.begin(), row.end());
  return numbers;
}

void ExpectAmong(const Values& values, const std::set<int>& allowed, const std::string& what) {
  ASSERT_GT(values.count, 0u) << what;
  for (size_t i = 0; i < values.count; ++i) {
    EXPECT_TRUE(allowed.contains(values.Int(i))) << what << " " << i << ": " << values.Int(i);
  }
}

// Patterns of one colour each: 1, 2 and 3 in all channels but the alpha.
ir::Texture PatternsOf(uint32_t width, uint32_t height, uint32_t depth) {
  ir::Texture texture;
  texture.is_array = depth == 3;
  texture.is_3d = depth > 3;
  ir::Texture::Level level{width, height, depth, {}};
  for (uint32_t z = 0; z < depth; ++z) {
    for (uint32_t y = 0; y < height; ++y) {
      for (uint32_t x = 0; x < width; ++x) {
        const auto number = static_cast<float>(1 + (depth == 1 ? 3 * x / width : 3 * z / depth));
        level.texels.push_back({number, number, number, 1});
      }
    }
  }
  texture.levels.push_back(std::move(level));
  return texture;
}

// Four pixels of a tile each, so that footprints are those of a pixel.
Values Tiles(size_t count = 8) {
  std::vector<Vector> uv;
  for (size_t i = 0; i < count; ++i) {
    uv.push_back({0.3 + 0.25 * static_cast<double>(i / 4) + 0.01 * static_cast<double>(i % 2),
                  0.4 + 0.01 * static_cast<double>(i / 2 % 2)});
  }
  return RunBlock("virtual_tile_map", {{"uv", Vectors(uv)}, {"cells", CellsOf({{4, 4}})}})["tile"];
}

// A tile for every two of these numbers as its column and row, with random bits of all kinds.
Values TilesAt(const std::vector<int32_t>& numbers) {
  Values tiles = Tiles(numbers.size() * numbers.size());
  for (size_t i = 0; i < tiles.count; ++i) {
    tiles.words[i] = static_cast<uint32_t>(numbers[i % numbers.size()]);
    tiles.words[tiles.count + i] = static_cast<uint32_t>(numbers[i / numbers.size()]);
    tiles.words[kSeed * tiles.count + i] = static_cast<uint32_t>(i) * 2654435769u;
  }
  return tiles;
}

// Cells of a line and in space with the same numbers in all directions.
Values Tiles1() {
  return RunBlock("virtual_tile_map",
                  {{"uv", Floats({0.1, 0.11, 0.1, 0.11})}, {"cells", Ints({4})}})["tile"];
}
Values Tiles3() {
  const Values cells{ir::kIvec3, 1, {4, 4, 4}};
  return RunBlock(
      "virtual_tile_map",
      {{"uv", Vectors({{0.1, 0.2, 0.3}, {0.11, 0.2, 0.3}, {0.1, 0.21, 0.3}, {0.11, 0.21, 0.3}})},
       {"cells", cells}})["tile"];
}
Values WithCell(Values tiles, size_t directions, int32_t cell) {
  for (size_t i = 0; i < directions * tiles.count; ++i)
    tiles.words[i] = static_cast<uint32_t>(cell);
  return tiles;
}

// --- The lines ---------------------------------------------------------------------------------

// What all kinds of patterns show for these numbers.
void ExpectPatterns(const std::vector<int32_t>& patterns, float color, float alpha) {
  const ir::Texture array = PatternsOf(4, 4, 3), atlas = PatternsOf(12, 4, 1),
                    volume = PatternsOf(4, 4, 12);
  for (int32_t pattern : patterns) {
    const Argument number{"pattern", Ints({pattern})};
    std::vector<Outputs> shown = {
        RunBlock("reference_texture", {{"patterns", array}, {"tile", Tiles()}, number}),
        RunBlock("reference_texture", {{"patterns", array}, {"tile", Tiles1()}, number}),
        RunBlock("reference_texture",
                 {{"patterns", atlas}, {"tile", Tiles()}, number, {"grid", CellsOf({{3, 1}})}}),
        RunBlock(
            "reference_texture",
            {{"patterns", volume}, {"tile", Tiles3()}, number, {"patterns_count", Ints({3})}})};
    if (pattern < 0) {
      shown.push_back(
          RunBlock("reference_texture", {{"patterns", volume}, {"tile", Tiles3()}, number}));
    }
    for (size_t kind = 0; kind < shown.size(); ++kind) {
      const Values& colors = shown[kind]["result"];
      ASSERT_GT(colors.count, 0u);
      for (size_t i = 0; i < colors.count; ++i) {
        EXPECT_NEAR(colors.Float(i, 0), color, 1e-5) << pattern << " of kind " << kind;
        EXPECT_NEAR(colors.Float(i, 3), alpha, 1e-5) << pattern << " of kind " << kind;
      }
    }
  }
}

void PatternBelow() { ExpectPatterns(kBelow, 0, 0); }
void PatternBeyond() { ExpectPatterns({2, 3, 77, 1000000000, INT_MAX}, 3, 1); }

Values PatternOfMaterial(int32_t material, const Values& tiles) {
  const ir::Texture lists = MapOf(kMap);
  return RunBlock("materials_map",
                  {{"lists", lists}, {"material", Ints({material})}, {"tile", tiles}})["result"];
}
Values PatternOfList(int32_t list) {
  const ir::Texture lists = MapOf(kMap);
  return RunBlock("probability_map", {{"random", Floats({0, 0.4, 0.9, 0.99})},
                                      {"lists", lists},
                                      {"list", Ints({list})}})["result"];
}

void MaterialBelow() {
  for (int32_t material : kBelow) {
    for (const Values& tiles : {TilesAt(kAnywhere), Tiles1(), Tiles3()}) {
      ExpectAmong(PatternOfMaterial(material, tiles), {-1}, "materials_map");
    }
    ExpectAmong(PatternOfList(material), {-1}, "probability_map");
  }
}

void MaterialBeyond() {
  for (int32_t material : {1, 2, 1000000000, INT_MAX}) {
    for (const Values& tiles : {TilesAt(kAnywhere), Tiles1(), Tiles3()}) {
      ExpectAmong(PatternOfMaterial(material, tiles), {21, 22, 23}, "materials_map");
    }
    ExpectAmong(PatternOfList(material), {21, 22, 23}, "probability_map");
  }
}

size_t Floored(int64_t a, int64_t n) { return static_cast<size_t>((a % n + n) % n); }

void CellBeyondTheMap() {
  const ir::Texture map = MapOf(kMap), line = MapOf({kMap[1]});
  ir::Texture volume = MapOf(kMap);
  volume.is_3d = true;
  const Values tiles = TilesAt(kAnywhere);
  const Values seen =
      RunBlock("explicit_indirection_map", {{"map", map}, {"tile", tiles}})["result"];
  ASSERT_EQ(seen.count, tiles.count);
  for (size_t i = 0; i < seen.count; ++i) {
    EXPECT_EQ(seen.Int(i), kMap[Floored(tiles.Int(i, 1), 2)][Floored(tiles.Int(i, 0), 3)]);
  }
  for (int32_t cell : kAnywhere) {
    const Values in_line =
        RunBlock("explicit_indirection_map",
                 {{"map", line}, {"tile", WithCell(Tiles1(), 1, cell)}})["result"];
    ExpectAmong(in_line, {static_cast<int>(kMap[1][Floored(cell, 3)])}, "of a line");
    const Values in_space =
        RunBlock("explicit_indirection_map",
                 {{"map", volume}, {"tile", WithCell(Tiles3(), 3, cell)}})["result"];
    ExpectAmong(in_space, {static_cast<int>(kMap[Floored(cell, 2)][Floored(cell, 3)])}, "in space");
  }
}

// Maps that do not divide the cells, and cells beyond both.
void MapThatDoesNotDivide() {
  for (std::pair<int32_t, int32_t> cells :
       {std::pair{7, 5}, {1, 1}, {2, 1}, {6, 4}, {1048576, 1048575}}) {
    for (const Rows& rows : {kMap, Rows{{31}}, Rows{{41, 42, 43, 44, 45}}}) {
      const ir::Texture map = MapOf(rows);
      for (const char* block : {"areas_map", "dithered_areas_map"}) {
        const Values seen = RunBlock(
            block,
            {{"areas", map}, {"tile", TilesAt(kAnywhere)}, {"cells", CellsOf({cells})}})["result"];
        ExpectAmong(seen, NumbersOf(rows), block);
        const Values line = RunBlock(block, {{"areas", map},
                                             {"tile", WithCell(Tiles1(), 1, INT_MIN)},
                                             {"cells", Ints({cells.first})}})["result"];
        ExpectAmong(line, NumbersOf(rows), block);
      }
    }
  }
}

void RandomOutsideOfOne() {
  const std::vector<double> random = {-3, -0.001, -kInf, 1, 1.5, 1e30, kInf, kNan};
  const ir::Texture lists = MapOf({{11, 12, 13}});
  const std::vector<Values> seen = {
      RunBlock("probability_map",
               {{"random", Floats(random)}, {"patterns", List{Ints({11, 12, 13})}}})["result"],
      RunBlock("probability_map",
               {{"random", Floats(random)}, {"lists", lists}, {"list", Ints({0})}})["result"]};
  for (const Values& numbers : seen) {
    ASSERT_EQ(numbers.count, random.size());
    for (size_t i = 0; i < 3; ++i) EXPECT_EQ(numbers.Int(i), 11) << random[i];
    for (size_t i = 3; i < 7; ++i) EXPECT_EQ(numbers.Int(i), 13) << random[i];
    EXPECT_TRUE(numbers.Int(7) == 11 || numbers.Int(7) == 13);
  }
}

void CellsBelowOne() {
  std::vector<Vector> uv = Lattice(-3, 3, 6);
  auto tiles = [&](int32_t cells, bool toroidal) {
    return RunBlock("virtual_tile_map", {{"uv", Vectors(uv)},
                                         {"cells", CellsOf({{cells, cells}})},
                                         {"toroidal", Bools({toroidal})}})["tile"];
  };
  for (bool toroidal : {false, true}) {
    const Values one = tiles(1, toroidal);
    for (int32_t cells : {0, -1, -7, INT_MIN}) EXPECT_EQ(tiles(cells, toroidal).words, one.words);
  }
  for (int32_t cells : {0, INT_MIN}) {
    const Values line = RunBlock("virtual_tile_map",
                                 {{"uv", Floats({1.5, -1.5})}, {"cells", Ints({cells})}})["tile"];
    EXPECT_EQ(line.Int(0), 1);
    EXPECT_EQ(line.Int(1), -2);
    const Values count{ir::kIvec3, 1, std::vector<uint32_t>(3, static_cast<uint32_t>(cells))};
    const Values space = RunBlock("virtual_tile_map",
                                  {{"uv", Vectors({{1.5, -1.5, 0.5}})}, {"cells", count}})["tile"];
    EXPECT_EQ(space.Int(0, 1), -2);
  }
}

void CoordinatesThatAreNone() {
  std::vector<Vector> uv;
  for (double x : {kNan, kInf, -kInf, 1e30, -1e30, 3e9, -3e9, 0.5}) {
    for (double y : {kNan, kInf, -1e30, 0.5}) uv.push_back({x, y});
  }
  const ir::Texture map = MapOf(kMap), array = PatternsOf(4, 4, 3);
  for (bool toroidal : {false, true}) {
    const Values tiles = RunBlock("virtual_tile_map", {{"uv", Vectors(uv)},
                                                       {"cells", CellsOf({{12, 8}})},
                                                       {"toroidal", Bools({toroidal})},
                                                       {"seed", Ints({INT_MIN})}})["tile"];
    for (size_t i = 0; toroidal && i < tiles.count; ++i) {
      EXPECT_TRUE(tiles.Int(i, 0) >= 0 && tiles.Int(i, 0) < 12) << tiles.Int(i, 0);
      EXPECT_TRUE(tiles.Int(i, 1) >= 0 && tiles.Int(i, 1) < 8) << tiles.Int(i, 1);
    }
    ExpectAmong(RunBlock("explicit_indirection_map", {{"map", map}, {"tile", tiles}})["result"],
                NumbersOf(kMap), "explicit_indirection_map");
    for (const char* block : {"areas_map", "dithered_areas_map"}) {
      ExpectAmong(
          RunBlock(block,
                   {{"areas", map}, {"tile", tiles}, {"cells", CellsOf({{12, 8}})}})["result"],
          NumbersOf(kMap), block);
    }
    ExpectAmong(PatternOfMaterial(0, tiles), {11, 12, 13}, "materials_map");
    for (const char* randomness : {"hash", "permutation"}) {
      ExpectAmong(RunBlock("virtual_indirection_map", {{"tile", tiles},
                                                       {"patterns", Ints({3})},
                                                       {"randomness", Word{randomness}}})["result"],
                  {0, 1, 2}, randomness);
      const Values luck = RunBlock("virtual_random_map",
                                   {{"tile", tiles}, {"randomness", Word{randomness}}})["result"];
      for (size_t i = 0; i < luck.count; ++i) {
        EXPECT_TRUE(luck.Float(i, 2) >= 0 && luck.Float(i, 2) < 1) << randomness;
      }
    }
    // It does not matter what is shown: that it ends, and with the right alpha.
    const Values colors =
        RunBlock("reference_texture",
                 {{"patterns", array}, {"tile", tiles}, {"pattern", Ints({-1})}})["result"];
    for (size_t i = 0; i < colors.count; ++i) EXPECT_EQ(colors.Float(i, 3), 0);
  }
}

void ScaleOfNothing() {
  for (double scale : {0.0, -1.0, -1e30, -kInf, kNan}) {
    for (const char* place : {"inside", "anywhere"}) {
      for (const Values& tiles : {Tiles(), Tiles3()}) {
        const Values coverage = RunBlock(
            "tile_transform",
            {{"tile", tiles}, {"scale", Floats({scale})}, {"place", Word{place}}})["coverage"];
        ASSERT_GT(coverage.count, 0u);
        for (size_t i = 0; i < coverage.count; ++i) EXPECT_EQ(coverage.Float(i), 0) << scale;
      }
    }
  }
}

Values Animated(const char* block, int32_t frames, double rest, const std::vector<double>& times) {
  return RunBlock(
      block,
      {{"time", Floats(times)}, {"frames", Ints({frames})}, {"rest", Floats({rest})}})["result"];
}

void FewerThanOnePicture() {
  for (const char* block : {"animation_sequence", "animation_map"}) {
    for (int32_t frames : {0, -1, -100, INT_MIN}) {
      for (double rest : {-5.0, 0.0, 3.0}) {
        ExpectAmong(Animated(block, frames, rest, kWildTimes), {0}, block);
      }
    }
    const std::vector<double> times = {0.5, 1.5, 2.5, 3.5, 4.5, 5.5, 6.5, 7.5};
    for (double rest : {-1.0, -1e30, -kInf}) {
      EXPECT_EQ(Animated(block, 4, rest, times).words, Animated(block, 4, 0, times).words) << block;
    }
  }
}

void TimesThatAreNone() {
  const std::set<int> pictures = {0, 1, 2, 3, 4};
  for (const char* block : {"animation_sequence", "animation_map"}) {
    const Values most = Animated(block, INT_MAX, 0, kWildTimes);
    for (size_t i = 0; i < most.count; ++i) {
      EXPECT_TRUE(most.Int(i) >= 0 && most.Int(i) < INT_MAX) << block << kWildTimes[i];
    }
  }
  for (const char* block : {"animation_sequence", "animation_map"}) {
    for (double rest : {0.0, 2.5, 1e30, 3e38, kInf, kNan}) {
      ExpectAmong(Animated(block, 5, rest, kWildTimes), pictures, block);
    }
  }
  for (double wild : kWildTimes) {
    for (const char* port : {"phase", "rate", "old_rest", "old_rate", "change_time"}) {
      ExpectAmong(RunBlock("animation_map", {{"time", Floats({0, 3.5, 1e9, 1e30})},
                                             {"frames", Ints({5})},
                                             {"rest", Floats({2})},
                                             {port, Floats({wild})}})["result"],
                  pictures, port);
    }
  }
}

// Materials by a map, to families 0, 1, 1, 0.
void MaterialWithoutFamily() {
  const Rows materials = {{-1, 2, 99}, {-7, 3, 1e9}};
  std::vector<int> family = {0, 1, 1, 0};
  const auto family_of = [&](double material) {
    return family[static_cast<size_t>(std::clamp(material, 0.0, 3.0))];
  };
  const std::string graph = R"({"texgraph": 1, "textures": {"m": {"map": [[0, 0, 0], [0, 0, 0]]}},
      "nodes": {"g": {"block": "virtual_tile_map", "in": {"cells": [3, 2]}},
        "a": {"block": "explicit_indirection_map", "in": {"map": "m", "tile": "g"}},
        "t": {"block": "transition_tiles", "in": {"material": "a", "families": [0, 1, 1, 0],
              "transitions": [99, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 98]}}},
      "outputs": {"height": "t.transition", "roughness": "t.material_here"}})";
  std::vector<Point> points;
  for (int i = 0; i < 6; ++i) points.push_back({(i % 3 + 0.5) / 3, (i / 3 + 0.5) / 2});
  auto outputs =
      RunGraph(graph, points, {0.001, 0.001}, 0, PictureFolder(), {{"m", MapOf(materials)}});
  ASSERT_EQ(outputs.size(), 2u);
  for (size_t i = 0; i < 6; ++i) {
    const size_t x = i % 3, y = i / 3, right = (x + 1) % 3, up = (y + 1) % 2;
    const int number = family_of(materials[y][x]) + 2 * family_of(materials[y][right]) +
                       4 * family_of(materials[up][x]) + 8 * family_of(materials[up][right]);
    EXPECT_EQ(outputs["height"].Float(i), number == 0 || number == 15 ? -1 : number) << i;
    EXPECT_EQ(outputs["roughness"].Float(i), static_cast<float>(materials[y][x])) << i;
  }
}

// One layer of sprites, the same in all cells.
ir::Texture SpriteMap(double x, double y, double pattern) {
  ir::Texture map = MapOf({{1, 1}, {1, 1}});
  map.is_array = true;
  for (auto& texel : map.levels[0].texels) {
    texel = {static_cast<float>(x), static_cast<float>(y), static_cast<float>(pattern), 1};
  }
  return map;
}

void LayerThatIsNotThere() {
  const ir::Texture map = SpriteMap(0, 0, 2);
  for (int32_t layer : {-1, INT_MIN, 1, 2, 1000000000, INT_MAX}) {
    auto outputs =
        RunBlock("explicit_positioning",
                 {{"sprites", map}, {"tile", TilesAt(kAnywhere)}, {"layer", Ints({layer})}});
    ExpectAmong(outputs["pattern"], {-1}, "layer");
    for (size_t i = 0; i < outputs["coverage"].count; ++i) {
      EXPECT_EQ(outputs["coverage"].Float(i), 0);
    }
  }
}

void NumbersThatAreNone() {
  const ir::Texture array = PatternsOf(4, 4, 3), lists = MapOf(kMap);
  for (double number : {kNan, kInf, -kInf, 1e30, -1e30, 3e9}) {
    const ir::Texture map = MapOf({{number}});
    const Values material =
        RunBlock("explicit_indirection_map", {{"map", map}, {"tile", Tiles()}})["result"];
    std::set<int> patterns = NumbersOf(kMap);
    patterns.insert(-1);
    const Values pattern = RunBlock(
        "materials_map", {{"lists", lists}, {"material", material}, {"tile", Tiles()}})["result"];
    ExpectAmong(pattern, patterns, "materials_map");
    const Values color =
        RunBlock("reference_texture",
                 {{"patterns", array}, {"tile", Tiles()}, {"pattern", material}})["result"];
    for (size_t i = 0; i < color.count; ++i) {
      EXPECT_TRUE(std::set<float>({0, 1, 2, 3}).contains(color.Float(i))) << number;
    }
    const ir::Texture sprites = SpriteMap(0, 0, number);
    const Values sprite =
        RunBlock("texture_sprites",
                 {{"sprites", sprites}, {"patterns", array}, {"tile", Tiles()}})["result"];
    for (size_t i = 0; i < sprite.count; ++i) {
      EXPECT_TRUE(std::set<float>({0, 1, 2, 3}).contains(sprite.Float(i))) << number;
      EXPECT_TRUE(sprite.Float(i, 3) >= 0 && sprite.Float(i, 3) <= 1) << number;
    }
  }
}

// In the cell (0, 0) of 2 x 2; the sprite of the cell beside it stays as it is.
void SpriteThatIsNowhere() {
  const ir::Texture array = PatternsOf(4, 4, 3);
  for (double place : {kNan, kInf, -kInf, 1e30, -1e30}) {
    ir::Texture sprites = SpriteMap(0, 0, 1);
    sprites.levels[0].texels[0][0] = static_cast<float>(place);
    Values tiles = Tiles(4);
    for (uint32_t column : {0u, 1u}) {
      for (size_t i = 0; i < 2 * tiles.count; ++i) tiles.words[i] = i < tiles.count ? column : 0;
      auto outputs = RunBlock("explicit_positioning", {{"sprites", sprites}, {"tile", tiles}});
      ExpectAmong(outputs["pattern"], {1}, "pattern");
      for (size_t i = 0; i < tiles.count; ++i) {
        const float coverage = outputs["coverage"].Float(i);
        // Of no number nothing is promised.
        if (column == 0 && std::isnan(place)) continue;
        EXPECT_EQ(coverage, column) << place;
      }
    }
    const Values color = RunBlock(
        "texture_sprites", {{"sprites", sprites}, {"patterns", array}, {"tile", tiles}})["result"];
    EXPECT_EQ(color.Float(0, 0), 2);
  }
}

void GridFinerThanItsPicture() {
  const ir::Texture small = PatternsOf(3, 4, 1), thin = PatternsOf(4, 4, 4);
  for (int32_t pattern : {0, 5, INT_MAX}) {
    for (const Values& color :
         {RunBlock("reference_texture", {{"patterns", small},
                                         {"tile", Tiles()},
                                         {"pattern", Ints({pattern})},
                                         {"grid", CellsOf({{100, 100}})}})["result"],
          RunBlock("reference_texture", {{"patterns", thin},
                                         {"tile", Tiles3()},
                                         {"pattern", Ints({pattern})},
                                         {"patterns_count", Ints({100})}})["result"]}) {
      for (size_t i = 0; i < color.count; ++i) {
        EXPECT_TRUE(color.Float(i) >= 1 && color.Float(i) <= 3) << color.Float(i);
      }
    }
  }
}

struct Line {
  const char* what;  // as the page has it
  std::function<void()> check;
};

const std::vector<Line> kLines = {
    {"a pattern below 0", PatternBelow},
    {"a pattern beyond the last", PatternBeyond},
    {"a material below 0", MaterialBelow},
    {"a material beyond the last", MaterialBeyond},
    {"a cell beyond the map, or below 0", CellBeyondTheMap},
    {"a map that does not divide the tile map, bound by mistake", MapThatDoesNotDivide},
    {"a random number outside of 0 to 1, for a list", RandomOutsideOfOne},
    {"a number of cells below 1", CellsBelowOne},
    {"a coordinate that is not finite, or too large to tell cells apart", CoordinatesThatAreNone},
    {"a scale of 0 or less", ScaleOfNothing},
    {"fewer than one picture, a rest below 0", FewerThanOnePicture},
    {"a time, rest or phase that is not finite, or too large to tell pictures apart",
     TimesThatAreNone},
    {"a material without a family, -1 among them", MaterialWithoutFamily},
    {"a layer of sprites that the map does not have", LayerThatIsNotThere},
    {"a number in a map that is not finite", NumbersThatAreNone},
    {"a sprite whose place is not finite", SpriteThatIsNowhere},
    {"more patterns than an atlas has texels, or a volume slices", GridFinerThanItsPicture},
};

TEST(OutOfRangeTest, IsAsThePageSays) {
  for (const Line& line : kLines) {
    SCOPED_TRACE(line.what);
    line.check();
  }
}

// Every line of the page has its check, and every check its line.
TEST(OutOfRangeTest, NamesTheLinesOfThePage) {
  std::ifstream file(TEXGRAPH_SOURCE_DIR "/docs/indirection.md");
  std::set<std::string> lines, checked;
  bool inside = false;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("## ")) inside = line == "## Numbers out of range";
    const size_t end = line.find(" |", 2);
    if (!inside || !line.starts_with("| ") || end == std::string::npos) continue;
    lines.insert(line.substr(2, end - 2));
  }
  lines.erase("What");
  for (const Line& line : kLines) checked.insert(line.what);
  EXPECT_EQ(lines, checked);
}

}  // namespace
}  // namespace texgraph::blocks
