// SPDX-License-Identifier: Apache-2.0
// Textures that texgraph makes itself, from the graph to pixels: patterns of one colour each, so
// that what every pixel must show is known.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <functional>

#include "compiler/textures/image.h"
#include "compiler/textures/srgb.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

using textures::Image;
using Rgb = std::array<uint8_t, 3>;

constexpr Rgb kColors[] = {{200, 30, 40}, {20, 180, 60}, {40, 50, 220}, {230, 200, 90}};
constexpr uint32_t kSize = 64;  // of the pictures that are drawn

Image Picture(uint32_t width, uint32_t height,
              const std::function<Rgb(uint32_t x, uint32_t y)>& color) {
  Image image;
  image.width = width;
  image.height = height;
  image.channels = 3;
  for (uint32_t y = 0; y < height; ++y) {
    for (uint32_t x = 0; x < width; ++x) {
      for (uint8_t c : color(x, y)) image.pixels.push_back(c);
    }
  }
  return image;
}

// What is drawn at the middle of a cell, of 2 x 2; y counts from the top.
Rgb CellColor(const Image& image, uint32_t x, uint32_t y) {
  Rgb color{};
  for (uint32_t c = 0; c < 3; ++c) {
    color[c] =
        static_cast<uint8_t>(image.At(kSize / 4 + x * kSize / 2, kSize / 4 + y * kSize / 2, c));
  }
  return color;
}

double Decoded(uint8_t sample) { return textures::SrgbDecode(sample / 255.0); }

class Derived : public testing::Test {
 protected:
  Derived() {
    // From the left top corner, row by row: 0 1 above 2 3.
    WritePicture("sheet.png", Picture(16, 16, [](uint32_t x, uint32_t y) {
                   return kColors[x / 8 + 2 * (y / 8)];
                 }));
    for (size_t i = 0; i < 4; ++i) {
      WritePicture("p" + std::to_string(i) + ".png",
                   Picture(8, 8, [i](uint32_t, uint32_t) { return kColors[i]; }));
    }
    std::filesystem::create_directory(folder / "blocks");
    std::filesystem::create_directory(folder / "out");
  }

  void WritePicture(const std::string& name, const Image& image) {
    folder.Write(name, *textures::EncodePng(image));
  }

  // A graph of one block that is made for it.
  void WriteGraph(const std::string& textures, const std::string& parameters,
                  const std::string& inputs, const std::string& body) {
    folder.Write("blocks/shown.glsl", "/// Shows what the test made.\nvec4 shown(vec2 uv, " +
                                          parameters + ") {\n" + body + "\n}\n");
    folder.Write("g.json", R"({ "texgraph": 1, "textures": {)" + textures +
                               R"(}, "nodes": { "n": { "block": "shown", "in": { "uv": "uv", )" +
                               inputs + R"(} } }, "outputs": { "color": "n" } })");
  }

  Image Render(const std::vector<std::string>& arguments) {
    Program program;
    program.path = TEXGRAPH_PROGRAM;
    program.folder = folder.path();
    program.arguments = {"render", "--size", std::to_string(kSize), "-o", "o.png"};
    program.arguments.insert(program.arguments.end(), arguments.begin(), arguments.end());
    const Outcome outcome = program.Run();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    Diagnostics diagnostics;
    auto image = textures::ReadImage(folder / "o.png", {}, diagnostics);
    return image ? *image : Image{{kSize, kSize, 3, 8}, std::vector<uint8_t>(kSize * kSize * 3)};
  }

  // Draws the graph, and what texgraphc writes of it, which must be the same.
  Image RenderBoth() {
    const Image image = Render({"-I", "blocks", "g.json"});
    const Outcome compiled =
        Texgraphc({"-I", "blocks", "g.json", "-o", "out/g.frag"}, folder.path()).Run();
    EXPECT_EQ(compiled.exit_code, 0) << compiled.error;
    EXPECT_EQ(Render({"out/g.json"}).pixels, image.pixels);
    return image;
  }

  std::string Manifest() { return folder.Read("out/g.json"); }

  ScratchFolder folder;
};

constexpr const char* kShowMap = R"(
  ivec2 size = textureSize(map, 0);
  ivec2 cell = ivec2(floor(uv * vec2(size)));
  int number = int(texelFetch(map, cell, 0).r);
  return texture(patterns, vec3(uv, float(number)));)";

constexpr const char* kSheet = R"("ground": { "sheet": "sheet.png", "grid": [2, 2] })";

void ExpectMap(const Image& image, const std::array<int, 4>& numbers) {
  for (uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(CellColor(image, i % 2, i / 2), kColors[numbers[i]]) << i;
  }
}

TEST_F(Derived, MapsShowTheTopRowAtTheTop) {
  WriteGraph(std::string(kSheet) + R"(, "where": { "map": [[0, 1], [3, 2]], "of": "ground" })",
             "sampler2D map, sampler2DArray patterns", R"("map": "where", "patterns": "ground")",
             kShowMap);
  ExpectMap(RenderBoth(), {0, 1, 3, 2});
  EXPECT_TRUE(std::filesystem::exists(folder / "out/g.where.ktx2"));
  EXPECT_NE(Manifest().find("\"format\": \"r16f\""), std::string::npos);
}

TEST_F(Derived, ConstantMapsAreTheSameWithoutATexture) {
  WriteGraph(std::string(kSheet) +
                 R"(, "where": { "map": [[0, 1], [3, 2]], "of": "ground", "binding": "constant" })",
             "sampler2D map, sampler2DArray patterns", R"("map": "where", "patterns": "ground")",
             kShowMap);
  ExpectMap(RenderBoth(), {0, 1, 3, 2});
  EXPECT_FALSE(std::filesystem::exists(folder / "out/g.where.ktx2"));
  EXPECT_NE(Manifest().find("\"status\": \"folded\""), std::string::npos);
}

TEST_F(Derived, MapsFromPictures) {
  constexpr Rgb kGreen = {0x3a, 0x7d, 0x2c}, kSand = {0xc8, 0xb4, 0x6a};
  WritePicture("areas.png", Picture(2, 2, [&](uint32_t x, uint32_t y) {
                 return x == 1 && y == 0 ? kSand : kGreen;
               }));
  WriteGraph(
      std::string(kSheet) +
          R"(, "where": { "map": "areas.png", "legend": ["#c8b46a", "#3a7d2c"], "of": "ground" })",
      "sampler2D map, sampler2DArray patterns", R"("map": "where", "patterns": "ground")",
      kShowMap);
  ExpectMap(RenderBoth(), {1, 0, 1, 1});
}

TEST_F(Derived, ListsBeginAtTheBottom) {
  WriteGraph(std::string(kSheet) + R"(, "where": { "lists": [[0, 1], [3]], "of": "ground" })",
             "sampler2D map, sampler2DArray patterns", R"("map": "where", "patterns": "ground")",
             kShowMap);
  ExpectMap(RenderBoth(), {3, 3, 0, 1});
}

TEST_F(Derived, AtlasesAreAsSheets) {
  WriteGraph(R"("joined": { "layers": ["p0.png", "p1.png", "p2.png", "p3.png"], "pack": "atlas",
                "grid": [2, 2] })",
             "sampler2D atlas", R"("atlas": "joined")", "return texture(atlas, uv);");
  ExpectMap(RenderBoth(), {0, 1, 2, 3});
  EXPECT_NE(Manifest().find("\"max_level\": 3"), std::string::npos);
}

TEST_F(Derived, VolumesHaveTheirSlicesFromBelow) {
  WriteGraph(R"("tree": { "layers": ["p0.png", "p1.png", "p2.png", "p3.png"], "pack": "volume" })",
             "sampler3D volume", R"("volume": "tree")",
             "vec2 cell = floor(2.0 * uv);\n"
             "return texture(volume, vec3(uv, (cell.x + 2.0 * cell.y + 0.5) / 4.0));");
  ExpectMap(RenderBoth(), {2, 3, 0, 1});
}

TEST_F(Derived, SpritesStandInTheCellsTheyTouch) {
  WriteGraph(std::string(kSheet) + R"(, "leaves": { "cells": [2, 2], "of": "ground", "sprites": [
               { "pattern": 2, "at": [0.5, 0] }, { "pattern": 3, "at": [1, 0.25] }] })",
             "sampler2DArray sprites", R"("sprites": "leaves")", R"(
  ivec2 cell = ivec2(floor(2.0 * uv));
  vec4 low = texelFetch(sprites, ivec3(cell, 0), 0), high = texelFetch(sprites, ivec3(cell, 1), 0);
  return vec4(0.25 * (low.z + 1.0), 0.25 * (high.z + 1.0), 0.5 + 0.5 * low.x, 1.0);)");
  const Image image = RenderBoth();
  const auto shown = [](double r, double g, double b) {
    return Rgb{textures::SrgbEncode8(static_cast<float>(r)),
               textures::SrgbEncode8(static_cast<float>(g)),
               textures::SrgbEncode8(static_cast<float>(b))};
  };
  EXPECT_EQ(CellColor(image, 0, 1), shown(0.75, 0, 0.75));  // the first, half a cell to the right
  EXPECT_EQ(CellColor(image, 1, 1), shown(0.75, 1, 0.25));  // both, the later one on top
  EXPECT_EQ(CellColor(image, 1, 0), shown(1, 0, 0.5));      // the second alone
  EXPECT_EQ(CellColor(image, 0, 0)[0], 0);                  // none
}

TEST_F(Derived, MeansAreThoseOfTheLists) {
  WriteGraph(std::string(kSheet) + R"(,
               "mixes": { "lists": [[0, 0, 0, 1], [2, 3]], "of": "ground" },
               "where": { "map": [[0, 1], [1, 0]], "of": "mixes" }, "far": { "means": "where" })",
             "sampler2D means", R"("means": "far")", "return texture(means, uv);");
  const Image image = RenderBoth();
  for (uint32_t c = 0; c < 3; ++c) {
    const double first = 0.75 * Decoded(kColors[0][c]) + 0.25 * Decoded(kColors[1][c]);
    const double second = 0.5 * Decoded(kColors[2][c]) + 0.5 * Decoded(kColors[3][c]);
    EXPECT_NEAR(CellColor(image, 0, 0)[c], textures::SrgbEncode8(static_cast<float>(first)), 1);
    EXPECT_NEAR(CellColor(image, 1, 0)[c], textures::SrgbEncode8(static_cast<float>(second)), 1);
    EXPECT_NEAR(CellColor(image, 0, 1)[c], textures::SrgbEncode8(static_cast<float>(second)), 1);
    EXPECT_NEAR(CellColor(image, 1, 1)[c], textures::SrgbEncode8(static_cast<float>(first)), 1);
  }
}

// Far away a pixel shows all patterns, each as often as it is chosen.
TEST_F(Derived, WeightsAreInTheCoarsestLevel) {
  WriteGraph(R"("ground": { "sheet": "sheet.png", "grid": [2, 2], "weights": "mixes" },
               "mixes": { "lists": [[0, 0, 0, 1], [2, 0]], "of": "ground" })",
             "sampler2DArray patterns", R"("patterns": "ground")",
             "return textureLod(patterns, vec3(uv, 3.0), 16.0);");
  const Image image = RenderBoth();
  for (uint32_t c = 0; c < 3; ++c) {
    const double mean =
        (5 * Decoded(kColors[0][c]) + Decoded(kColors[1][c]) + 2 * Decoded(kColors[2][c])) / 8;
    EXPECT_NEAR(CellColor(image, 0, 0)[c], textures::SrgbEncode8(static_cast<float>(mean)), 1);
  }
}

TEST_F(Derived, FilesOfAnotherKindAreRefused) {
  WriteGraph(std::string(kSheet) + R"(, "where": { "map": [[0, 1], [3, 2]], "of": "ground" })",
             "sampler2D map, sampler2DArray patterns", R"("map": "where", "patterns": "ground")",
             kShowMap);
  ASSERT_EQ(
      Texgraphc({"-I", "blocks", "g.json", "-o", "out/g.frag"}, folder.path()).Run().exit_code, 0);
  folder.Write("out/g.where.ktx2", folder.Read("out/g.ground.ktx2"));
  Program program;
  program.path = TEXGRAPH_PROGRAM;
  program.folder = folder.path();
  program.arguments = {"render", "out/g.json", "-o", "o.png"};
  const Outcome outcome = program.Run();
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(
      outcome.error.find("has the texels of a sampler2DArray, but the texture is a sampler2D"),
      std::string::npos)
      << outcome.error;
}

}  // namespace
}  // namespace texgraph
