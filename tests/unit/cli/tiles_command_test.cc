// SPDX-License-Identifier: Apache-2.0
// texgraph tiles: what it writes is what the functions make, and what it says of it is true.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <span>
#include <string>

#include "cli/texgraph/help.h"
#include "compiler/textures/tile_pictures.h"
#include "compiler/textures/tile_set.h"
#include "tests/unit/cli/page.h"
#include "tests/unit/cli/tiles_testing.h"

namespace texgraph {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using textures::TileKind;
using textures::TileSet;
using textures::TileSetOptions;

TileSet Expected(std::span<const textures::Image> maps, const TileSetOptions& options,
                 std::span<const double> weights = {}) {
  Diagnostics diagnostics;
  auto set = textures::MakeTileSet(maps, weights, options, "", {}, diagnostics);
  EXPECT_TRUE(set);
  return set ? std::move(*set) : TileSet();
}

TEST_F(TilesCommand, WritesThePacksOfAllMaps) {
  const Outcome outcome =
      Make({"grass.png", "height.png", "--tile-size", "12", "--corners", "3", "--seed", "7",
            "--candidates", "24", "--weights", "1,0.25", "--own-middles"})
          .Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.error, HasSubstr("grass.tiles.png, height.tiles.png: 81 tiles of 12 x 12"));
  TileSetOptions options;
  options.colors = {3, 3};
  options.tile_size = 12;
  options.seed = 7;
  options.candidates = 24;
  options.own_middles = true;
  const textures::Image maps[] = {color_, height_};
  const double weights[] = {1, 0.25};
  const TileSet set = Expected(maps, options, weights);
  ASSERT_EQ(set.packs.size(), 2u);
  ExpectPicture("grass.tiles.png", set.packs[0]);
  ExpectPicture("height.tiles.png", set.packs[1]);
  EXPECT_THAT(folder.Names(), ElementsAre("grass.png", "grass.tiles.json", "grass.tiles.png",
                                          "height.png", "height.tiles.png"));
  // Each of the options matters.
  options.own_middles = false;
  EXPECT_NE(Expected(maps, options, weights).packs[0].pixels, set.packs[0].pixels);
  options.own_middles = true;
  EXPECT_NE(Expected(maps, options).packs[0].pixels, set.packs[0].pixels);
}

TEST_F(TilesCommand, WritesPicturesOfWangTiles) {
  const Outcome outcome =
      Make({"grass.png",     "--tile-size", "20",       "--edges",  "3,2",        "--wraps",
            "--candidates",  "8",           "--seed",   "3",        "-o",         "set.png",
            "--corner-pack", "--view",      "view.png", "--tiling", "tiling.png", "--tiling-size",
            "5x3",           "-q"})
          .Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  TileSetOptions options;
  options.kind = TileKind::kWang;
  options.colors = {3, 2};
  options.tile_size = 20;
  options.wraps = true;
  options.candidates = 8;
  options.seed = 3;
  const TileSet set = Expected({&color_, 1}, options);
  ExpectPicture("set.png", set.packs[0]);
  ExpectPicture("set.corners.png", MakeWeiCornerPack(set.packs[0], set.layout));
  ExpectPicture("view.png", MakeTileView(set.packs[0], set.layout));
  ExpectPicture("tiling.png", MakeTiling(set.packs[0], set.layout, 5, 3, 3));
  const json said = json::parse(folder.Read("set.json"));
  EXPECT_EQ(said["corner_packs"], json({"set.corners.png"}));
  EXPECT_EQ(said["tiles"], json::parse(R"({"edge_colors": [3, 2], "tile_size": 20,
                                           "pack": [4, 9], "gutter": 0})"));
  EXPECT_EQ(said["max_level"], 3);  // 2.5 texels a tile; the next has 1.25
}

// "places" by the colours that the pack itself has at each of its tiles.
void ExpectPlaces(const json& said, const textures::TilePackLayout& layout) {
  ASSERT_EQ(said["places"].size(), layout.tiles());
  const bool corner = layout.kind == TileKind::kCorner;
  const uint32_t first = layout.colors[0];
  const uint32_t second = layout.colors[corner ? 0 : 1];
  for (uint32_t y = 0; y < layout.rows; ++y) {
    for (uint32_t x = 0; x < layout.columns; ++x) {
      const textures::TileColors c = TileAt(layout, x, y);
      const uint32_t index = c[0] + first * (c[1] + second * (c[2] + first * c[3]));
      EXPECT_EQ(said["places"][index], x + layout.columns * y);
    }
  }
}

TEST_F(TilesCommand, SaysWhatAProgramMustKnow) {
  std::filesystem::create_directory(folder / "out");
  const Outcome outcome = Make({"grass.png", "--tile-size", "16", "--corners", "4", "--candidates",
                                "8", "-o", "out/set.png"})
                              .Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const json said = json::parse(folder.Read("out/set.json"));
  EXPECT_EQ(said["texgraph_tiles"], 1);
  EXPECT_EQ(said["files"], json({"set.png"}));
  EXPECT_EQ(said["prepared_from"]["files"], json({"../grass.png"}));
  EXPECT_EQ(said["tiles"], json::parse(R"({"corner_colors": 4, "tile_size": 16,
                                           "pack": [16, 16], "gutter": 8})"));
  EXPECT_EQ(said["wrap"], json({"repeat", "clamp"}));
  EXPECT_EQ(said["max_level"], 3);  // two texels a tile
  EXPECT_EQ(Picture("out/set.png").height, 16u * 16 + 2 * 8);
  ExpectPlaces(said, textures::LayOutTiles(TileKind::kCorner, {4, 4}, 16));
}

TEST_F(TilesCommand, PlacesOfWangTiles) {
  const Outcome outcome = Make({"grass.png", "--tile-size", "8", "--edges", "2,3", "--candidates",
                                "8", "-o", "-", "--json", "w.json", "-q"})
                              .Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const json said = json::parse(folder.Read("w.json"));
  EXPECT_EQ(said["wrap"], json({"repeat", "repeat"}));
  ExpectPlaces(said, textures::LayOutTiles(TileKind::kWang, {2, 3}, 8));
}

TEST_F(TilesCommand, SaysHowGoodTheSeamsAre) {
  const Outcome outcome =
      Make({"grass.png", "--tile-size", "16", "--candidates", "16", "--report"}).Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  TileSetOptions options;
  options.tile_size = 16;
  options.candidates = 16;
  const textures::TileSetQuality quality = Expected({&color_, 1}, options).quality;
  ASSERT_GT(quality.mean, 0);
  const json said = json::parse(folder.Read("grass.tiles.json"))["quality"];
  EXPECT_NEAR(said["mean"], quality.mean, 1e-4);
  ASSERT_EQ(said["edges"].size(), 8u);
  for (size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(said["edges"][i]["stands"], quality.edges[i].stands);
    EXPECT_EQ(said["edges"][i]["colors"], json({quality.edges[i].first, quality.edges[i].second}));
    EXPECT_NEAR(said["edges"][i]["ratio"], quality.edges[i].ratio, 1e-4);
  }
  // The tables: four edges that lie and stand, and the tiles from the top row down.
  std::map<std::pair<bool, std::string>, double> edges;
  for (const auto& edge : quality.edges) {
    edges[{edge.stands, fmt::format("{} to {}", edge.first, edge.second)}] = edge.ratio;
  }
  for (const char* name : {"0 to 0", "0 to 1", "1 to 0", "1 to 1"}) {
    EXPECT_THAT(outcome.out, HasSubstr(fmt::format("\n{}          {:.2f}    {:.2f}\n", name,
                                                   edges[{false, name}], edges[{true, name}])));
  }
  size_t at = 0;
  for (uint32_t y = 4; y-- > 0;) {
    std::string row = fmt::format("\nrow {}       ", y);
    for (uint32_t x = 0; x < 4; ++x) row += fmt::format("  {:.2f}", quality.tiles[x + 4 * y]);
    const size_t found = outcome.out.find(row + "\n");
    ASSERT_NE(found, std::string::npos) << row << outcome.out;
    EXPECT_GT(found, at);
    at = found;
  }
  EXPECT_THAT(outcome.out, HasSubstr(fmt::format("\nall seams     {:.2f}\n", quality.mean)));
}

TEST_F(TilesCommand, TheSameSampleGivesTheSameFiles) {
  for (const char* name : {"a.png", "b.png"}) {
    ASSERT_EQ(
        Make({"grass.png", "--tile-size", "8", "--candidates", "8", "-o", name}).Run().exit_code,
        0);
  }
  EXPECT_FALSE(folder.Read("a.png").empty());
  EXPECT_EQ(folder.Read("a.png"), folder.Read("b.png"));
}

TEST_F(TilesCommand, UsesStandardOutput) {
  const std::vector<std::string> arguments = {"grass.png",    "--tile-size", "8",
                                              "--candidates", "8",           "-o"};
  auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), arguments.begin(), arguments.end());
    return Make(more).Run();
  };
  const Outcome pack = with({"-"});
  ASSERT_EQ(pack.exit_code, 0) << pack.error;
  EXPECT_EQ(pack.out.substr(0, 4), "\x89PNG");
  EXPECT_THAT(folder.Names(), ElementsAre("grass.png", "height.png"));
  const Outcome said = with({"a.png", "--json", "-"});
  ASSERT_EQ(said.exit_code, 0) << said.error;
  EXPECT_EQ(json::parse(said.out)["files"], json({"a.png"}));
  EXPECT_EQ(folder.Read("a.png"), pack.out);
}

TEST_F(TilesCommand, HelpAndDocumentsNameTheSameOptions) {
  const Outcome outcome = Make({"--help"}).Run();
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, cli::kTilesHelp);
  EXPECT_THAT(Make({"-h"}).Run().out, HasSubstr("usage: texgraph tiles"));
  EXPECT_THAT(std::string(cli::kTexgraphHelp), HasSubstr("\n  tiles "));
  const std::regex option("--[a-z]+(-[a-z]+)*|-[a-zA-Z]\\b");
  const auto options = [&](const std::string& text) {
    return std::set<std::string>(std::sregex_token_iterator(text.begin(), text.end(), option), {});
  };
  std::set<std::string> in_help = options(std::string(cli::kTilesHelp));
  in_help.erase("--help");
  in_help.erase("-h");
  EXPECT_GE(in_help.size(), 17u);
  const std::string page = ReadPage("docs/rendering.md");
  const size_t begin = page.find("| option |", page.find("## Tile sets"));
  ASSERT_NE(begin, std::string::npos);
  EXPECT_EQ(options(page.substr(begin, page.find("\n\n", begin) - begin)), in_help);
}

}  // namespace
}  // namespace texgraph
