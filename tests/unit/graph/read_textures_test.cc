// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/unit/graph/graph_testing.h"

namespace texgraph::graph {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// The section "textures" stands on the first line of a graph, from column 30 on.
ReadGraphText ReadSection(std::string_view textures) {
  return ReadGraphText(fmt::format(R"({{ "texgraph": 1, "textures": {},
 "outputs": {{ "height": 1 }} }})",
                                   textures));
}

constexpr std::string_view kAll = R"({
  "far":     { "means": "where", "dithered": true },
  "where":   { "map": [[0, 1], [1, -1], [1, 0]], "of": "mixed" },
  "mixed":     { "lists": [[0, 0, 1, 3], [2, 3], [1]], "of": "ground", "binding": "constant" },
  "ground":  { "layers": ["a.png", "b.png", "c.png", "d.png"], "edges": "match", "weights": "mixed" },
  "sheet":   { "sheet": "s.png", "grid": [4, 2], "weights": [1, 2, 0, 0, 0.5, 0, 0, 1] },
  "even":    { "layers": ["a.png", "b.png", "c.png"], "weights": 2 },
  "atlas":   { "sheet": "s.png", "grid": [4, 2], "pack": "atlas" },
  "joined":  { "layers": ["a.png", "b.png", "c.png"], "pack": "atlas", "grid": [2, 2] },
  "tree":    { "layers": ["a.png", "b.png"], "pack": "volume", "wrap": "clamp" },
  "painted": { "map": "p.png", "legend": ["#3a7d2c", "#C8B46A"], "of": "mixed" },
  "leaves":  { "sprites": [{ "pattern": 3, "at": [2.25, 3] }, { "pattern": 0, "at": [2, 2.5] }],
               "cells": [16, 8], "of": "ground" }
})";

const Texture& Named(const Graph& graph, std::string_view name) {
  for (const Texture& texture : graph.textures) {
    if (texture.name == name) return texture;
  }
  ADD_FAILURE() << name;
  return graph.textures[0];
}

TEST(ReadTextures, ReadsPatterns) {
  const ReadGraphText read = ReadSection(kAll);
  ASSERT_TRUE(read.graph) << read.Messages();
  const Texture& ground = Named(*read.graph, "ground");
  EXPECT_EQ(ground.kind, TextureKind::kLayers);
  EXPECT_TRUE(ground.is_array);
  EXPECT_TRUE(ground.match_edges);
  EXPECT_TRUE(ground.IsDerived());
  // Over rows of four: 0 0 1 3, 2 3 2 3, 1 1 1 1.
  EXPECT_THAT(ground.weights, ElementsAre(2, 5, 2, 3));
  const Texture& sheet = Named(*read.graph, "sheet");
  EXPECT_EQ(sheet.kind, TextureKind::kSheet);
  EXPECT_THAT(sheet.files, ElementsAre("s.png"));
  EXPECT_THAT(sheet.grid, ElementsAre(4u, 2u));
  EXPECT_EQ(sheet.PatternCount(), 8u);
  EXPECT_THAT(sheet.weights, ElementsAre(1, 2, 0, 0, 0.5, 0, 0, 1));
  EXPECT_THAT(Named(*read.graph, "even").weights, ElementsAre(2, 2, 2));
  const Texture& atlas = Named(*read.graph, "atlas");
  EXPECT_EQ(atlas.pack, TexturePack::kAtlas);
  EXPECT_FALSE(atlas.is_array || atlas.is_3d);
  const Texture& joined = Named(*read.graph, "joined");
  EXPECT_THAT(joined.grid, ElementsAre(2u, 2u));
  EXPECT_EQ(joined.PatternCount(), 3u);
  const Texture& tree = Named(*read.graph, "tree");
  EXPECT_TRUE(tree.is_3d);
  EXPECT_FALSE(tree.is_array);
  EXPECT_EQ(tree.wrap_u, TextureWrap::kClamp);
  EXPECT_EQ(tree.wrap_w, TextureWrap::kClamp);
}

// Two lists that share a pattern are one group; a pattern that is in no list is its own.
TEST(ReadTextures, EdgesMatchWithinLists) {
  const auto groups = [](const std::string& lists) {
    const ReadGraphText read = ReadSection(
        R"({ "g": { "sheet": "s.png", "grid": [4, 2], "edges": "l" }, "l": { "of": "g", "lists": )" +
        lists + " } }");
    EXPECT_TRUE(read.graph) << read.Messages();
    EXPECT_TRUE(read.graph && read.graph->textures[0].match_edges);
    return read.graph ? read.graph->textures[0].edge_groups : std::vector<uint32_t>{};
  };
  EXPECT_THAT(groups("[[6, 1], [7, 3], [5, 7], [-1, 2]]"),
              ElementsAre(0u, 1u, 2u, 3u, 4u, 3u, 1u, 3u));
  // Each pattern with the next one, in an order in which every step joins two groups.
  EXPECT_THAT(groups("[[7, 6], [1, 0], [5, 4], [3, 2], [6, 5], [4, 3]]"),
              ElementsAre(0u, 0u, 2u, 2u, 2u, 2u, 2u, 2u));
  EXPECT_THAT(groups("[[-1]]"), ElementsAre(0u, 1u, 2u, 3u, 4u, 5u, 6u, 7u));
  EXPECT_THAT(groups("[[0, 1, 2, 3], [3, 4, 5, 6], [6, 7]]"), IsEmpty());  // as "match"
}

TEST(ReadTextures, ReadsMaps) {
  const ReadGraphText read = ReadSection(kAll);
  ASSERT_TRUE(read.graph) << read.Messages();
  const Texture& where = Named(*read.graph, "where");
  EXPECT_EQ(where.kind, TextureKind::kMap);
  EXPECT_EQ(where.map.width, 2u);
  EXPECT_EQ(where.map.height, 3u);
  // The first row that is written is the top one, and row 0 of a texture the lowest.
  EXPECT_THAT(where.map.numbers, ElementsAre(1, 0, 1, -1, 0, 1));
  EXPECT_EQ(where.filter, TextureFilter::kNearest);
  EXPECT_FALSE(where.mipmaps);
  EXPECT_FALSE(where.is_constant);
  const Texture& mix = Named(*read.graph, "mixed");
  EXPECT_EQ(mix.map.width, 4u);
  EXPECT_EQ(mix.map.height, 3u);
  EXPECT_THAT(mix.map.numbers, ElementsAre(0, 0, 1, 3, 2, 3, 2, 3, 1, 1, 1, 1));
  EXPECT_TRUE(mix.is_constant);
  EXPECT_EQ(read.graph->textures[*mix.of].name, "ground");
  const Texture& painted = Named(*read.graph, "painted");
  EXPECT_THAT(painted.files, ElementsAre("p.png"));
  ASSERT_EQ(painted.legend.size(), 2u);
  EXPECT_THAT(painted.legend[0].rgb, ElementsAre(0x3a, 0x7d, 0x2c));
  EXPECT_THAT(painted.legend[1].rgb, ElementsAre(0xc8, 0xb4, 0x6a));
  EXPECT_THAT(painted.map.numbers, IsEmpty());
}

TEST(ReadTextures, ReadsSpritesAndMeans) {
  const ReadGraphText read = ReadSection(kAll);
  ASSERT_TRUE(read.graph) << read.Messages();
  const Texture& leaves = Named(*read.graph, "leaves");
  EXPECT_TRUE(leaves.is_array);
  EXPECT_EQ(leaves.sprites.columns, 16u);
  EXPECT_EQ(leaves.sprites.rows, 8u);
  // The first touches cells (2, 3) and (3, 3); the second (2, 2) and (2, 3).
  EXPECT_EQ(leaves.sprites.layers, 2u);
  ASSERT_EQ(leaves.sprites.sprites.size(), 2u);
  EXPECT_EQ(leaves.sprites.sprites[0].pattern, 3);
  EXPECT_THAT(leaves.sprites.sprites[0].at, ElementsAre(2.25, 3));
  const Texture& far = Named(*read.graph, "far");
  EXPECT_EQ(far.kind, TextureKind::kMeans);
  EXPECT_TRUE(far.dithered);
  EXPECT_TRUE(far.mipmaps);
  EXPECT_TRUE(far.alpha_is_opacity);
  const auto patterns = PatternsOf(*read.graph, 0);
  ASSERT_TRUE(patterns);
  EXPECT_EQ(read.graph->textures[*patterns].name, "ground");
}

TEST(ReadTextures, MeansHaveTheAlphaOfTheirPatterns) {
  const ReadGraphText read =
      ReadSection(R"({ "m": { "means": "w" }, "w": { "map": [[0]], "of": "p" },
      "p": { "layers": ["a.png"], "color_space": "data" } })");
  ASSERT_TRUE(read.graph) << read.Messages();
  EXPECT_FALSE(read.graph->textures[0].alpha_is_opacity);
}

TEST(ReadTextures, SpritesOnWholeCellsTouchOneCell) {
  const ReadGraphText read = ReadSection(R"({ "s": { "sprites": [
      { "pattern": 0, "at": [0, 0] }, { "pattern": 0, "at": [1, 0] }, { "pattern": 0, "at": [1, 1] },
      { "pattern": 0, "at": [-0.5, 1.5] }], "cells": [2, 2] } })");
  ASSERT_TRUE(read.graph) << read.Messages();
  EXPECT_EQ(read.graph->textures[0].sprites.layers, 1u);
}

TEST(ReadTextures, Noise) {
  const ReadGraphText read = ReadSection(R"({
      "a": { "noise": [{ "band": 12, "direction": -30, "stretch": 3, "spread": 20, "share": 0.5 },
                       { "painted": "b.png" }], "second": { "lobes": [3, -4] }, "size": 64, "seed": 9 },
      "p": { "noise": { "power_law": 2, "highest": 20 } },
      "q": { "noise": [{ "power_law": 2.0, "highest": 20, "lowest": 1 }] },
      "g": { "gaussian": "a.png" }, "h": { "gaussian": "a.png" }, "t": { "table": "h" },
      "m": { "color_map": "a.png" }, "n": { "color_map": "a.png", "deviations": 5 } })");
  ASSERT_TRUE(read.graph) << read.Messages();
  const std::vector<Texture>& textures = read.graph->textures;
  EXPECT_EQ(textures[0].kind, TextureKind::kNoise);
  const NoiseSetting& noise = textures[0].noise;
  EXPECT_EQ(noise.size, 64u);
  EXPECT_EQ(noise.seed, 9u);
  ASSERT_EQ(noise.spectra[0].size(), 2u);
  const NoisePart& band = noise.spectra[0][0];
  EXPECT_EQ(band.frequency[0], 12);
  EXPECT_EQ(band.bandwidth, 3);  // a quarter
  EXPECT_EQ(band.direction, -30);
  EXPECT_EQ(band.stretch, 3);
  EXPECT_EQ(band.spread, 20);
  EXPECT_EQ(band.share, 0.5);
  EXPECT_EQ(noise.spectra[0][1].kind, NoisePart::Kind::kPainted);
  EXPECT_THAT(textures[0].files, ElementsAre("b.png"));
  ASSERT_EQ(noise.spectra[1].size(), 1u);
  EXPECT_EQ(noise.spectra[1][0].frequency, (std::array<double, 2>{3, -4}));
  EXPECT_EQ(noise.spectra[1][0].bandwidth, 1.25);
  EXPECT_TRUE(textures[1].noise.spectra[1].empty());
  EXPECT_FALSE(textures[0].is_array);
  EXPECT_TRUE(textures[0].IsDerived());
  EXPECT_TRUE(textures[5].is_array);
  EXPECT_EQ(textures[5].of, 4u);
  EXPECT_TRUE(textures[6].is_array);
  EXPECT_EQ(textures[6].wrap_u, TextureWrap::kClamp);
  EXPECT_EQ(textures[6].deviations, 7u);
  std::vector<uint32_t> first;
  for (uint32_t i = 0; i < 8; ++i) first.push_back(FirstEqualTexture(*read.graph, i));
  EXPECT_THAT(first, ElementsAre(0u, 1u, 1u, 3u, 3u, 5u, 6u, 7u));
}

TEST(ReadTextures, EqualMapsShareASampler) {
  const ReadGraphText read = ReadSection(R"({
      "a": { "map": [[1, 2]] }, "b": { "map": [[1, 2]] }, "c": { "map": [[1], [2]] },
      "d": { "map": [[1, 2]], "binding": "constant" }, "e": { "lists": [[1, 2]] },
      "g": { "layers": ["a.png"] }, "h": { "layers": ["a.png"], "weights": [1] },
      "i": { "layers": ["a.png"], "pack": "volume" },
      "j": { "layers": ["a.png", "b.png"], "edges": "match" },
      "k": { "layers": ["a.png", "b.png"], "edges": "m" }, "m": { "lists": [[0, 1]], "of": "k" },
      "n": { "layers": ["a.png", "b.png"], "edges": "o" }, "o": { "lists": [[0], [1]], "of": "n" } })");
  ASSERT_TRUE(read.graph) << read.Messages();
  std::vector<uint32_t> first;
  for (uint32_t i = 0; i < 13; ++i) first.push_back(FirstEqualTexture(*read.graph, i));
  EXPECT_THAT(first, ElementsAre(0u, 0u, 2u, 3u, 4u, 5u, 6u, 7u, 8u, 8u, 10u, 11u, 12u));
}

struct Mistake {
  std::string_view textures;
  std::string_view place;  // the first diagnostic
  std::string_view message;
};

class TextureMistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(TextureMistakes, AreReported) {
  const ReadGraphText read = ReadSection(GetParam().textures);
  EXPECT_FALSE(read.graph);
  ASSERT_FALSE(read.Places().empty());
  EXPECT_EQ(read.Places()[0], GetParam().place) << read.Messages();
  EXPECT_THAT(read.Messages(), HasSubstr(std::string(GetParam().message)));
}

constexpr Mistake kMistakes[] = {
    {R"({ "m": { "binding": "constant" } })", "1:32 missing-key", "needs one of the keys"},
    {R"({ "m": { "map": [[1]], "lists": [[1]] } })", "1:53 graph-shape (1:39)",
     "'map' and 'lists'"},
    {R"({ "m": { "map": [[1]], "grid": [1, 1] } })", "1:53 unknown-key", "no key 'grid'"},
    {R"({ "m": { "means": "m" } })", "1:48 bad-value (1:32)", "names a map, but 'm' is means"},
    {R"({ "m": { "map": [[1]], "of": "m" } })", "1:59 bad-value (1:32)", "but 'm' is a map"},
    {R"({ "m": { "map": [[1]], "of": "n" } })", "1:59 unknown-reference", "no texture"},
    {R"({ "m": { "map": [] } })", "1:46 bad-value", "at least one row"},
    {R"({ "m": { "map": [[]] } })", "1:47 bad-value", "at least one number"},
    {R"({ "m": { "map": [[1, 2], [3]] } })", "1:55 bad-value (1:47)", "1 numbers, the first has 2"},
    {R"({ "m": { "map": [[1, 2.0]] } })", "1:51 bad-value", "whole numbers, without '.'"},
    {R"({ "m": { "map": [[1, -2]] } })", "1:51 bad-value", "from -1"},
    {R"({ "m": { "map": [[16777217]] } })", "1:48 bad-value", "to 16777216"},
    {R"({ "m": { "map": 7 } })", "1:46 graph-shape", "rows of numbers"},
    {R"({ "m": { "map": [[1]], "legend": ["#000000"] } })", "1:53 graph-shape (1:46)", "picture"},
    {R"({ "m": { "map": "m.png", "legend": ["#00000"] } })", "1:66 bad-value", "'#3a7d2c'"},
    {R"({ "m": { "map": "m.png", "legend": ["#00000a", "#00000A"] } })", "1:77 bad-value (1:66)",
     "twice"},
    {R"({ "m": { "lists": [[1, 2, 3], [1, 2]] } })", "1:60 bad-value (1:49)", "does not divide"},
    {R"({ "m": { "lists": [[1], []] } })", "1:54 bad-value", "empty list"},
    {R"({ "g": { "layers": ["a.png"] }, "m": { "lists": [[0, 1]], "of": "g" } })",
     "1:83 value-range (1:32)", "'g' has 1 patterns, 0 to 0; 1 is none of them"},
    {R"({ "g": { "sheet": "a.png", "grid": [2, 2] }, "m": { "map": [[3], [4]], "of": "g" } })",
     "1:96 value-range (1:32)", "4 is none of them"},
    {R"({ "l": { "lists": [[1], [2]] }, "m": { "map": [[1, 2]], "of": "l" } })",
     "1:81 value-range (1:32)", "'l' has 2 lists, 0 to 1; 2 is none of them"},
    {R"({ "g": { "layers": ["a.png", "b.png"], "weights": [1] } })", "1:80 bad-value",
     "2 patterns, but 1 weights"},
    {R"({ "g": { "layers": ["a.png", "b.png"], "weights": [0, 0] } })", "1:80 bad-value",
     "sum to nothing"},
    {R"({ "g": { "layers": ["a.png"], "weights": [-1] } })", "1:72 bad-value", "from 0"},
    {R"({ "g": { "layers": ["a.png"], "weights": -1 } })", "1:71 bad-value", "from 0"},
    {R"({ "g": { "layers": ["a.png"], "weights": 0 } })", "1:71 bad-value", "sum to nothing"},
    {R"({ "g": { "layers": ["a.png"], "weights": "l" }, "l": { "lists": [[-1]], "of": "g" } })",
     "1:71 bad-value", "sum to nothing"},
    {R"({ "g": { "layers": ["a.png"], "weights": "l" }, "l": { "lists": [[0]] } })",
     "1:71 bad-value (1:78)", "not of the patterns"},
    {R"({ "g": { "layers": ["a.png"], "weights": "g" } })", "1:71 bad-value (1:32)", "names lists"},
    {R"({ "g": { "layers": ["a.png"], "edges": "macth" } })", "1:69 unknown-reference",
     "neither 'match' nor the name of a texture"},
    {R"({ "g": { "layers": ["a.png"], "edges": true } })", "1:69 graph-shape", "'edges'"},
    {R"({ "g": { "layers": ["a.png"], "edges": "g" } })", "1:69 bad-value (1:32)",
     "'edges' of texture 'g' names lists, but 'g' is an array of layers"},
    {R"({ "g": { "layers": ["a.png"], "edges": "l" }, "l": { "lists": [[0]] } })",
     "1:69 bad-value (1:76)", "not of the patterns"},
    {R"({ "g": { "layers": ["a.png"], "weights": [1], "mipmaps": false } })", "1:87 bad-value",
     "mip levels"},
    {R"({ "g": { "layers": ["a.png"], "pack": "volume", "edges": "match" } })",
     "1:78 graph-shape (1:68)", "packed as an array"},
    {R"({ "g": { "layers": ["a.png", "b.png"], "pack": "atlas", "grid": [1, 1] } })",
     "1:94 bad-value", "2 layers in 1 columns take 2 rows"},
    {R"({ "g": { "sheet": "a.png" } })", "1:32 missing-key", "'grid'"},
    {R"({ "g": { "sheet": "a.png", "grid": [0, 2] } })", "1:65 bad-value", "columns and rows"},
    {R"({ "s": { "sprites": [] } })", "1:32 missing-key", "'cells'"},
    {R"({ "s": { "sprites": [{ "pattern": 0, "at": [4, 1] }], "cells": [4, 4] } })",
     "1:73 value-range", "outside of its map"},
    {R"({ "s": { "sprites": [{ "pattern": -1, "at": [1, 1] }], "cells": [4, 4] } })",
     "1:64 bad-value", "from 0"},
    {R"({ "s": { "sprites": [{ "pattern": 0, "at": [1] }], "cells": [4, 4] } })", "1:73 bad-value",
     "two numbers"},
    {R"({ "g": { "layers": ["a.png"] }, "s": { "sprites": [{ "pattern": 1, "at": [1, 1] }],
        "cells": [4, 4], "of": "g" } })",
     "1:94 value-range (1:32)", "1 is none of them"},
    {R"({ "s": { "sprites": [{ "pattern": 0, "at": [1, 1] }, { "pattern": 0, "at": [1.5, 1] }],
        "cells": [4, 4], "layers": 1 } })",
     "1:83 value-range", "cell (1, 1) has 2 of them; 'layers' allows 1"},
    {R"({ "f": { "means": "m" }, "m": { "map": [[1]] } })", "1:48 bad-value (1:55)",
     "lead to no patterns"},
    {R"({ "f": { "means": "m" }, "m": { "map": [[1]], "of": "l" }, "l": { "lists": [[0], [1]] } })",
     "1:48 bad-value (1:89)", "'l' has no 'of'"},
};

INSTANTIATE_TEST_SUITE_P(ReadTextures, TextureMistakes, ::testing::ValuesIn(kMistakes));

TEST(ReadTextures, ConstantsHaveALimit) {
  std::string row = "[1";
  for (int i = 1; i < 64; ++i) row += ", 1";
  row += "]";
  std::string rows = row;
  for (int i = 1; i < 64; ++i) rows += ", " + row;
  EXPECT_TRUE(
      ReadSection("{ \"m\": { \"binding\": \"constant\", \"map\": [" + rows + "] } }").graph);
  const ReadGraphText over =
      ReadSection("{ \"m\": { \"binding\": \"constant\", \"map\": [" + rows + ", " + row + "] } }");
  EXPECT_THAT(over.Places(), ElementsAre("1:50 size-limit"));
  EXPECT_EQ(over.diagnostics.exit_code(), ExitCode::kLimit);
}

// 4,194,304 cells in all layers: what is let through here can be written.
TEST(ReadTextures, SpritesHaveALimit) {
  const auto read = [](const std::string& cells) {
    return ReadSection(R"({ "s": { "sprites": [{ "pattern": 0, "at": [1, 1] }], "cells": )" +
                       cells + " } }");
  };
  EXPECT_TRUE(read("[2048, 2048]").graph);
  EXPECT_TRUE(read(R"([512, 128], "layers": 64)").graph);
  for (const char* over : {"[2049, 2048]", "[4096, 4096]", R"([512, 129], "layers": 64)"}) {
    EXPECT_THAT(read(over).diagnostics.exit_code(), ExitCode::kLimit) << over;
  }
}

}  // namespace
}  // namespace texgraph::graph
