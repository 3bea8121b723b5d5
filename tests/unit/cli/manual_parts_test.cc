// SPDX-License-Identifier: Apache-2.0
// The parts of graphs that the pages of docs/ show compile in a graph that has the rest of it, and
// the manifests there are what texgraphc writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/textures/image.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/page.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

using textures::Image;

// What stands before and behind a part, so that both are a graph.
struct Rest {
  std::string before, behind;
};

Rest TexturesWith(const std::string& more, const std::string& nodes, const std::string& color) {
  return {R"({"texgraph": 1, "textures": {)" + more,
          R"(}, "nodes": {)" + nodes + R"(}, "outputs": {"color": ")" + color + R"("}})"};
}

Rest Nodes(const std::string& textures, const std::string& more, const std::string& output) {
  return {R"({"texgraph": 1, "textures": {)" + textures + R"(}, "nodes": {)" + more,
          R"(}, "outputs": {)" + output + "}}"};
}

constexpr const char* kGround = R"("ground": {"layers": ["g0.png", "g1.png", "g2.png", "g3.png"]})";
constexpr const char* kGrid = R"("grid": {"block": "virtual_tile_map", "in": {}})";

std::string Node(const std::string& name, const std::string& block, const std::string& in) {
  return ", \"" + name + R"(": {"block": ")" + block + R"(", "in": {)" + in + "}}";
}
std::string Pattern(const std::string& name, const std::string& texture, const std::string& tile) {
  return Node(name, "reference_texture",
              R"("patterns": ")" + texture + R"(", "tile": ")" + tile + R"(", "pattern": 1)");
}
std::string ImageOf(const std::string& name, const std::string& texture) {
  return Node(name, "image", R"("picture": ")" + texture + '"');
}
std::string Sum(const std::string& name, const std::string& a, const std::string& b) {
  return Node(name, "add", R"("a": ")" + a + R"(", "b": ")" + b + '"');
}

// For the parts of a page, in their order.
std::map<std::string, std::vector<Rest>> RestOfPages() {
  const std::string grid = kGrid, ground = kGround;
  const std::string maps =
      grid + Node("a", "explicit_indirection_map", R"("map": "where", "tile": "grid")") +
      Node("b", "explicit_indirection_map", R"("map": "where2", "tile": "grid")") +
      Node("c", "dither", R"("a": "a", "b": "b", "share": 0.5, "random": "time")") +
      Node("d", "materials_map", R"("lists": "meadow", "material": "c", "tile": "grid")") +
      Node("e", "reference_texture", R"("patterns": "ground", "tile": "grid", "pattern": "d")") +
      Node("f", "texture_sprites",
           R"("sprites": "leaves", "patterns": "leaf_patterns", "tile": "grid")") +
      Sum("g", "e", "f");
  return {
      {"docs/graph-format.md",
       {Nodes(R"("brick": {"file": "brick.png"})",
              R"("grid": {"block": "brick_grid", "in": {"rows": 4, "columns": 4}}, )",
              R"("color": "face.color")"),
        TexturesWith(
            "", grid + ImageOf("a", "brick") + Pattern("b", "stains", "grid") + Sum("c", "a", "b"),
            "c"),
        TexturesWith(R"("meadow": {"lists": [[0, 1], [2, 3]], "of": "ground"}, )",
                     grid + Node("boxes", "virtual_tile_map", R"("uv": "position")") +
                         Pattern("a", "ground", "grid") + Pattern("b", "ground2", "grid") +
                         Pattern("c", "tiles", "grid") +
                         Node("d", "reference_texture", R"("patterns": "trunk", "tile": "boxes",
                              "pattern": 0)") +
                         Sum("e", "a", "b") + Sum("f", "c", "d") + Sum("g", "e", "f"),
                     "g"),
        TexturesWith(
            "",
            grid + Node("a", "corner_tiles", R"("tiles": "grass")") +
                Node("b", "corner_tiles", R"("tiles": "grass_normal")") +
                Node("c", "wang_tiles", R"("tiles": "sand")") +
                Node("d", "tile_map", R"("tiles": "lawn", "map": "plan")") +
                Node("h", "wang_tiles_with_corners",
                     R"("tiles": "sand", "corners": "sand_corners")") +
                Node("i", "permutation_wang_tiles", R"("tiles": "sand", "table": "hashes")") +
                Sum("e", "a.color", "b.color") + Sum("f", "c.color", "d.color") +
                Sum("j", "h.color", "i.color") + Sum("k", "e", "f") + Sum("g", "j", "k"),
            "g"),
        TexturesWith("",
                     grid + ImageOf("a", "waves") + ImageOf("b", "streaks") +
                         ImageOf("c", "drawn") + ImageOf("d", "lawn_noise") +
                         ImageOf("e", "lawn_table") + ImageOf("f", "palette") + Sum("g", "a", "b") +
                         Sum("h", "c", "d") + Sum("i", "e", "f") + Sum("j", "g", "h") +
                         Sum("k", "i", "j"),
                     "k"),
        TexturesWith("", R"("a": {"block": "corner_cubes", "in": {"cubes": "granite"}})",
                     "a.color"),
        TexturesWith(ground + R"(, "leaf_patterns": {"layers": ["g0.png", "g1.png", "g2.png",
                     "g3.png"]}, )",
                     maps, "g"),
        TexturesWith(ground + R"(, "meadow": {"lists": [[0, 1], [2, 3]], "of": "ground"},
                     "where": {"map": [[0, 1], [1, -1]], "of": "meadow"}, )",
                     grid + ImageOf("a", "far"), "a"),
        TexturesWith(
            "", grid + ImageOf("a", "moss") + Pattern("b", "soot", "grid") + Sum("c", "a", "b"),
            "c"),
        TexturesWith("", grid + ImageOf("a", "leaf"), "a"),
        {R"({"texgraph": 1, "parameters": {)",
         R"(}, "nodes": {"grid": {"block": "brick_grid", "in": {"rows": "rows", "columns": 4}},
             "tone": {"block": "tile_random", "in": {"tile": "grid"}},
             "paint": {"block": "rgba", "in": {"color": "tint", "alpha": "tone"}}},
             "outputs": {"color": "paint"}})"},
        {R"({"texgraph": 1, )",
         R"(, "nodes": {"dots": {"block": "spots", "in": {"uv": "uv"}}},
             "outputs": {"color": "dots"}})"}}},
      {"docs/indirection.md",
       {{R"({"texgraph": 1, )", R"(, "outputs": {"color": "color"}})"},
        Nodes(ground + R"(, "where": {"map": [[0, 1], [2, 3]], "of": "ground"},
              "means": {"means": "where"})",
              R"("tiles": {"block": "virtual_tile_map", "in": {}})" +
                  Node("which", "explicit_indirection_map", R"("map": "where", "tile": "tiles")") +
                  Node("color", "reference_texture",
                       R"("patterns": "ground", "tile": "tiles", "pattern": "which")") +
                  ", ",
              R"("color": "shown")")}},
      {"docs/by_example.md",
       {Nodes(R"("lawn": {"file": "g0.png"})", "", R"("color": "everywhere")"),
        Nodes(
            R"("stones_map": {"file": "g0.png"}, "relief": {"file": "g1.png", "color_space": "data"},
              "heights": {"file": "g2.png", "color_space": "data"})",
            R"("picture": {"block": "image", "in": {"picture": "stones_map"}})" +
                ImageOf("texel", "relief") + Node("slope", "normal_map", R"("texel": "texel")") +
                ImageOf("height_texel", "heights") + ", ",
            R"("color": "stones", "normal": "facing")"),
        {R"({"texgraph": 1, )", R"(, "outputs": {"color": "blades.color"}})"},
        {R"({"texgraph": 1, )", R"(, "outputs": {"color": "stone.color"}})"},
        {R"({"texgraph": 1, )", R"(, "outputs": {"color": "lichen"}})"},
        {R"({"texgraph": 1, )", R"(, "outputs": {"color": "meadow"}})"}}},
      {"docs/grids.md",
       {Nodes("", "", R"("height": "tone", "opacity": "gap")"),
        Nodes(R"("where_moss_grows": {"file": "g0.png"}, "moss": {"file": "g1.png"})",
              R"("grid": {"block": "brick_grid", "in": {"rows": 4, "columns": 4}}, )",
              R"("color": "tufts.color")")}},
      {"docs/materials.md",
       {{R"({"texgraph": 1, "textures": {"glaze": {"file": "g0.png"},
             "glaze_relief": {"file": "g1.png", "color_space": "data"}}, )",
         "}"}}},
      {"docs/shapes.md",
       {Nodes("", "", R"("color": "paint")"), Nodes("", "", R"("opacity": "mask")")}},
  };
}

class ManualParts : public testing::Test {
 protected:
  // Pictures of every name that the pages' parts have, all of one size but for what must be.
  ManualParts() {
    for (const char* name :
         {"brick.png",    "soot.png",     "moss.png",          "g0.png",        "g1.png",
          "g2.png",       "g3.png",       "ground.png",        "slice0.png",    "slice1.png",
          "slice2.png",   "slice3.png",   "moss.jpg",          "moss_mask.jpg", "a.jpg",
          "b.jpg",        "a.png",        "leaf_on_black.jpg", "ground_0.png",  "ground_1.png",
          "ground_2.png", "ground_3.png", "leaf0.png",         "leaf1.png",     "leaf2.png",
          "leaf3.png",    "lawn.png",     "palette.png",       "spectrum.png"}) {
      Write(name, {{40, 90, 200, 255}, {120, 60, 20, 128}});
    }
    // Samples of tiles and cubes.
    for (const char* name : {"grass.png", "grass_normal.png", "sand.png", "granite.png"}) {
      Write(name, {{40, 90, 200, 255}, {120, 60, 20, 128}}, 128);
    }
    Write("areas.png", {{0x3a, 0x7d, 0x2c, 255}, {0xc8, 0xb4, 0x6a, 255}});
  }

  void Write(const std::string& name, const std::vector<std::vector<uint8_t>>& colors,
             uint32_t side = 16) {
    Image image;
    image.width = image.height = side;
    image.channels = 4;
    for (uint32_t i = 0; i < side * side; ++i) {
      const auto& color = colors[(i / 4 + i / (4 * side)) % colors.size()];
      image.pixels.insert(image.pixels.end(), color.begin(), color.end());
    }
    folder.Write(name, *textures::EncodePng(image));
  }

  ScratchFolder folder;
};

TEST_F(ManualParts, Compile) {
  for (const auto& [page, rests] : RestOfPages()) {
    std::vector<std::string> parts;
    for (const std::string& text : Fenced(ReadPage(page), "json")) {
      if (text.find("\"texgraph\"") == std::string::npos) parts.push_back(text);
    }
    // A part that is new needs its rest here.
    ASSERT_EQ(parts.size(), rests.size()) << page;
    for (size_t i = 0; i < parts.size(); ++i) {
      const std::string graph = rests[i].before + parts[i] + rests[i].behind;
      folder.Write("graph.json", graph);
      const Outcome outcome =
          Texgraphc({"-Werror", "graph.json", "-o", "shader.frag"}, folder.path()).Run();
      EXPECT_EQ(outcome.exit_code, 0) << page << "\n" << graph << outcome.error;
    }
  }
}

// The sprites of "Derived textures", in a graph of that name.
TEST_F(ManualParts, ManifestsAreWhatIsWritten) {
  const std::vector<std::string> shown = Fenced(ReadPage("docs/manifest.md"), "json");
  ASSERT_EQ(shown.size(), 2u);
  folder.Write("forest.json", R"({"texgraph": 1, "textures": {
      "leaf_patterns": {"layers": ["leaf0.png", "leaf1.png", "leaf2.png", "leaf3.png"]},
      "leaves": {"sprites": [{"pattern": 3, "at": [2.25, 7.5]}, {"pattern": 0, "at": [2, 7]}],
                 "cells": [16, 16], "of": "leaf_patterns"}},
      "nodes": {"grid": {"block": "virtual_tile_map", "in": {"cells": [16, 16]}},
                "seen": {"block": "texture_sprites", "in": {"sprites": "leaves",
                         "patterns": "leaf_patterns", "tile": "grid", "layers": 2}}},
      "outputs": {"color": "seen"}})");
  const Outcome outcome = Texgraphc({"forest.json", "-o", "forest.frag"}, folder.path()).Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const auto manifest = nlohmann::json::parse(folder.Read("forest.manifest.json"));
  const auto whole = nlohmann::json::parse(shown[0]);
  const auto leaves = nlohmann::json::parse(shown[1]);
  bool found = false;
  for (nlohmann::json texture : manifest["textures"]) {
    if (texture["name"] != "leaves") continue;
    found = true;
    // Further keys may be left out on the page, but none is wrong.
    for (const auto& [key, value] : leaves.items()) EXPECT_EQ(texture[key], value) << key;
  }
  EXPECT_TRUE(found);
  for (const auto& [key, value] : whole.items()) EXPECT_TRUE(manifest.contains(key)) << key;
}

}  // namespace
}  // namespace texgraph
