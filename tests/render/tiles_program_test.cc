// SPDX-License-Identifier: Apache-2.0
// A pack that texgraph tiles wrote, in a graph that names it as a file and says its colours: what
// is drawn are its tiles, whole, and colours agree wherever two of them meet.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "compiler/textures/tile_map.h"
#include "tests/blocks/synthetic_tiles.h"
#include "tests/unit/cli/tiles_testing.h"

namespace texgraph {
namespace {

using textures::Image;
using textures::TileColors;
using textures::TileKind;
using textures::TilePackLayout;

constexpr uint32_t kTile = 8;    // texels
constexpr uint32_t kTiling = 6;  // tiles each way

class TilesInAGraph : public TilesCommand {
 protected:
  // Each tile of the picture, from the left bottom one on, as the colours of that tile of the pack.
  std::vector<TileColors> Draw(const TilePackLayout& layout, const std::string& option,
                               const std::string& block, const std::string& colors) {
    const std::string size = std::to_string(kTile);
    const Outcome made =
        Make({"grass.png", "--tile-size", size, "--candidates", "16",
              layout.kind == TileKind::kWang ? "--edges" : "--corners", option, "-o", "pack.png"})
            .Run();
    EXPECT_EQ(made.exit_code, 0) << made.error;
    folder.Write("graph.json", fmt::format(R"({{ "texgraph": 1,
      "textures": {{ "pack": {{ "file": "pack.png", "mipmaps": false,
                               "wrap": "repeat" }} }},
      "nodes": {{ "tiles": {{ "block": "{}", "in": {{ "tiles": "pack", "tiling": {},
                                                     "colors": {} }} }} }},
      "outputs": {{ "color": "tiles.color" }} }})",
                                           block, kTiling, colors));
    Program render = Make({});
    render.arguments = {"render",    "graph.json", "-o",
                        "drawn.png", "--size",     std::to_string(kTile * kTiling)};
    const Outcome drawn = render.Run();
    EXPECT_EQ(drawn.exit_code, 0) << drawn.error;
    if (drawn.exit_code != 0) return {};
    return TilesOf(Picture("drawn.png"), Picture("pack.png"), layout);
  }

  // The difference of a tile of the picture from one of the pack in the worst of its texels.
  static uint32_t Difference(const Image& drawn, uint32_t column, uint32_t row, const Image& pack,
                             const TilePackLayout& layout, const TileColors& colors) {
    uint32_t worst = 0;
    for (uint32_t i = 0; i < kTile * kTile * 3; ++i) {
      const uint32_t x = i / 3 % kTile;
      const uint32_t y = i / 3 / kTile;
      const auto seen =
          static_cast<int>(textures::test::UpAt(drawn, column * kTile + x, row * kTile + y, i % 3));
      const auto expected = static_cast<int>(
          textures::test::TileTexel(pack, layout, PackedTile(layout, colors), x, y, i % 3));
      worst = std::max(worst, static_cast<uint32_t>(std::abs(seen - expected)));
    }
    return worst;
  }

  static std::vector<TileColors> TilesOf(const Image& drawn, const Image& pack,
                                         const TilePackLayout& layout) {
    std::vector<TileColors> tiles;
    for (uint32_t i = 0; i < kTiling * kTiling; ++i) {
      std::vector<TileColors> found;
      for (const TileColors& colors : textures::test::AllTiles(layout)) {
        // A driver may round otherwise.
        if (Difference(drawn, i % kTiling, i / kTiling, pack, layout, colors) <= 1)
          found.push_back(colors);
      }
      EXPECT_EQ(found.size(), 1u) << "tile " << i;
      tiles.push_back(found.empty() ? TileColors() : found[0]);
    }
    return tiles;
  }
};

TEST_F(TilesInAGraph, CornersAgree) {
  const auto tiles =
      Draw(textures::LayOutTiles(TileKind::kCorner, {4, 4}, kTile), "4", "corner_tiles", "4");
  ASSERT_EQ(tiles.size(), kTiling * kTiling);
  for (uint32_t i = 0; i < tiles.size(); ++i) {
    if (i % kTiling + 1 < kTiling) {
      EXPECT_EQ(tiles[i][1], tiles[i + 1][0]);
      EXPECT_EQ(tiles[i][3], tiles[i + 1][2]);
    }
    if (i + kTiling < tiles.size()) {
      EXPECT_EQ(tiles[i][2], tiles[i + kTiling][0]);
      EXPECT_EQ(tiles[i][3], tiles[i + kTiling][1]);
    }
  }
}

TEST_F(TilesInAGraph, EdgesAgree) {
  const auto tiles =
      Draw(textures::LayOutTiles(TileKind::kWang, {3, 2}, kTile), "3,2", "wang_tiles", "[3, 2]");
  ASSERT_EQ(tiles.size(), kTiling * kTiling);
  for (uint32_t i = 0; i < tiles.size(); ++i) {
    if (i % kTiling + 1 < kTiling) EXPECT_EQ(tiles[i][1], tiles[i + 1][3]);
    if (i + kTiling < tiles.size()) EXPECT_EQ(tiles[i][2], tiles[i + kTiling][0]);
  }
}

// O23 where a driver filters: corner tiles beside an ordinary texture of the whole virtual texture,
// with all its mip levels, magnified, between levels and small.
TEST_F(TilesInAGraph, AreFilteredAsAnOrdinaryTexture) {
  constexpr uint32_t kSide = 16;  // texels
  constexpr uint32_t kTiles = 8;  // then all repeats
  const TilePackLayout layout = textures::LayOutTiles(TileKind::kCorner, {2, 2}, kSide);
  const Image pack = blocks::synthetic::Pack(layout);
  std::vector<uint32_t> texels;
  for (uint32_t i = 0; i < kTiles * kTiles * kSide * kSide; ++i) {
    const uint32_t x = i % (kTiles * kSide);
    const uint32_t y = kTiles * kSide - 1 - i / (kTiles * kSide);
    const auto corner = [&](uint32_t right, uint32_t up) {
      return textures::DrawnCorner(static_cast<int32_t>((x / kSide + right) % kTiles),
                                   static_cast<int32_t>((y / kSide + up) % kTiles), 0, 2);
    };
    const TileColors colors = {corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)};
    texels.push_back(textures::test::TileTexel(pack, layout, PackedTile(layout, colors), x % kSide,
                                               y % kSide, 0));
  }
  folder.Write("pack.png", *textures::EncodePng(pack));
  folder.Write("whole.png", *textures::EncodePng(textures::test::MakeImage(
                                kTiles * kSide, kTiles * kSide, 1, 16, texels)));
  const auto draw = [&](const std::string& file, const std::string& node, const std::string& out,
                        uint32_t size) {
    folder.Write("graph.json",
                 R"({ "texgraph": 1,
      "textures": { "pack": { "file": ")" +
                     file + R"(", "color_space": "linear", "max_level": 3 } },
      "nodes": { "seen": )" +
                     node + R"( }, "outputs": { "color": ")" + out + R"(" } })");
    Program render = Make({});
    render.arguments = {"render", "graph.json", "-o",     "drawn.png",
                        "--bits", "16",         "--size", std::to_string(size)};
    const Outcome outcome = render.Run();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return Picture("drawn.png");
  };
  // Of the magnified texture; errors are parts of it.
  double deviation = 0;
  // Half a texel to a pixel, one and a half, three, and seven: between levels of which the coarser
  // one has 16, 8, 4 and 2 texels a tile.
  for (const auto& [size, limit] :
       {std::pair{256u, 0.001}, {85u, 0.001}, {43u, 0.01}, {18u, 0.05}}) {
    const Image tiles = draw("pack.png", R"({ "block": "corner_tiles",
        "in": { "tiles": "pack", "colors": 2, "tiling": 8, "period": 8 } })",
                             "seen.color", size);
    const Image whole =
        draw("whole.png", R"({ "block": "image", "in": { "picture": "pack" } })", "seen", size);
    double difference = 0;
    double sum = 0;
    double squares = 0;
    for (uint32_t i = 0; i < size * size; ++i) {
      const double seen = tiles.At(i % size, i / size, 0);
      const double wanted = whole.At(i % size, i / size, 0);
      difference += (seen - wanted) * (seen - wanted);
      sum += wanted;
      squares += wanted * wanted;
    }
    const double count = size * size;
    if (deviation == 0) deviation = std::sqrt(squares / count - sum / count * (sum / count));
    EXPECT_GT(deviation, 1000);
    EXPECT_LE(std::sqrt(difference / count) / deviation, limit) << size;
  }
}

// The keys of a graph and the options of the command mean the same.
TEST_F(TilesInAGraph, AreCutAsTheCommandCutsThem) {
  const Outcome made = Make({"grass.png", "--tile-size", std::to_string(kTile), "--candidates",
                             "16", "--seed", "3", "--even", "--own-middles", "-o", "pack.png"})
                           .Run();
  ASSERT_EQ(made.exit_code, 0) << made.error;
  for (const bool all : {true, false}) {
    folder.Write("graph.json", fmt::format(R"({{ "texgraph": 1,
      "textures": {{ "grass": {{ "tiles": "grass.png", "tile_size": {}, "candidates": 16, "seed": 3,
                                "even": true, "own_middles": {} }} }},
      "nodes": {{ "tiles": {{ "block": "corner_tiles", "in": {{ "tiles": "grass",
                                                              "tiling": {} }} }} }},
      "outputs": {{ "color": "tiles.color" }} }})",
                                           kTile, all, kTiling));
    Program render = Make({});
    render.arguments = {"render",    "graph.json", "-o",
                        "drawn.png", "--size",     std::to_string(kTile * kTiling)};
    const Outcome drawn = render.Run();
    ASSERT_EQ(drawn.exit_code, 0) << drawn.error;
    const Image picture = Picture("drawn.png");
    const Image pack = Picture("pack.png");
    const TilePackLayout layout = textures::LayOutTiles(TileKind::kCorner, {2, 2}, kTile);
    size_t found = 0;
    for (uint32_t i = 0; i < kTiling * kTiling; ++i) {
      found += std::ranges::any_of(textures::test::AllTiles(layout), [&](const TileColors& colors) {
        return Difference(picture, i % kTiling, i / kTiling, pack, layout, colors) <= 1;
      });
    }
    EXPECT_EQ(found == kTiling * kTiling, all) << found;
  }
}

}  // namespace
}  // namespace texgraph
