// SPDX-License-Identifier: Apache-2.0
// Live edits of graphs that texgraphc compiled, against graphs whose maps say the same from the
// beginning, and the program of the examples that moves sprites.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "compiler/graph/document.h"
#include "compiler/textures/image.h"
#include "runtime/live_sprites.h"
#include "tests/render/render_testing.h"
#include "tests/unit/base/scratch_folder.h"
#include "tests/unit/cli/program.h"

namespace texgraph {
namespace {

using runtime::LiveRenderer;
using runtime::RenderRequest;
using runtime::RenderResult;
using test::FirstMessage;
using testing::HasSubstr;

class LiveGraphTest : public testing::Test {
 protected:
  LiveGraphTest() {
    textures::Image image;  // four patterns beside each other, of one colour each
    image.width = 8;
    image.height = 2;
    image.channels = 3;
    for (uint32_t i = 0; i < 16; ++i) {
      const uint8_t pattern = static_cast<uint8_t>(i % 8 / 2);
      for (int c = 0; c < 3; ++c) image.pixels.push_back(static_cast<uint8_t>(pattern * 60 + c));
    }
    folder.Write("patterns.png", *textures::EncodePng(image));
    folder.Write("show_sprites.glsl",
                 "/// Sprites, each on the ones below.\n"
                 "/// @param sprites where they are\n"
                 "/// @param patterns what they are\n"
                 "/// @param uv coordinate @default uv\n"
                 "vec4 show_sprites(sampler2DArray sprites, sampler2DArray patterns, vec2 uv) {\n"
                 "  ivec3 size = textureSize(sprites, 0);\n"
                 "  vec2 p = uv * vec2(size.xy);\n"
                 "  ivec2 cell = clamp(ivec2(floor(p)), ivec2(0), size.xy - 1);\n"
                 "  vec4 color = vec4(0.0);\n"
                 "  for (int layer = 0; layer < 8; ++layer) {\n"
                 "    vec4 sprite = texelFetch(sprites, ivec3(cell, min(layer, size.z - 1)), 0);\n"
                 "    vec2 q = p - vec2(cell) - sprite.xy;\n"
                 "    if (sprite.z >= 0.0 && max(abs(q.x - 0.5), abs(q.y - 0.5)) < 0.5) {\n"
                 "      color = textureLod(patterns, vec3(q, sprite.z), 0.0);\n"
                 "    }\n"
                 "  }\n"
                 "  return color;\n"
                 "}\n");
  }

  // The request for a graph with that texture and these nodes; "patterns" has four patterns.
  RenderRequest Compile(const std::string& name, const std::string& texture,
                        const std::string& nodes) {
    folder.Write(name + ".graph.json", R"({ "texgraph": 1, "textures": {
      "patterns": { "sheet": "patterns.png", "grid": [4, 1] }, )" +
                                           texture + R"( }, "nodes": { )" + nodes +
                                           R"( }, "outputs": { "color": "seen" } })");
    const Outcome outcome =
        Texgraphc({name + ".graph.json", "-o", name + ".frag", "-I", "."}, folder.path()).Run();
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    Sources sources;
    Diagnostics diagnostics;
    const SourceId source = sources.Add(name, folder.Read(name + ".json"));
    const auto document =
        graph::ReadDocument(source, graph::DocumentFormat::kJson, sources, diagnostics);
    auto manifest = document ? runtime::ReadManifest(*document, diagnostics) : std::nullopt;
    RenderRequest request;
    if (manifest) request.manifest = std::move(*manifest);
    EXPECT_TRUE(LoadTextures(request.manifest, folder.path(), request.textures, diagnostics))
        << FirstMessage(diagnostics);
    request.shader = folder.Read(name + ".frag");
    request.width = request.height = 64;
    request.format = runtime::PixelFormat::kFloat;
    return request;
  }

  RenderRequest CompileMap(const std::string& name, const std::string& map) {
    return Compile(name, R"("map": { "of": "patterns", "map": )" + map + " }",
                   R"("grid": { "block": "virtual_tile_map", "in": { "cells": [4, 2] } },
           "which": { "block": "explicit_indirection_map", "in": { "map": "map", "tile": "grid" } },
           "seen": { "block": "reference_texture",
                     "in": { "patterns": "patterns", "tile": "grid", "pattern": "which" } })");
  }

  ScratchFolder folder;
};

TEST_F(LiveGraphTest, AMapThatChangesIsOneThatWasSo) {
  const RenderRequest before = CompileMap("before", "[[0, 1, 2, 3], [3, 2, 1, 0]]");
  const RenderRequest after = CompileMap("after", "[[0, 1, 2, 3], [3, 0, -1, 0]]");
  Diagnostics diagnostics;
  const auto renderer = LiveRenderer::Open(before, diagnostics);
  ASSERT_TRUE(renderer) << FirstMessage(diagnostics);
  const RenderResult first = renderer->Draw(0);
  runtime::TexelUpdate update;
  update.texture = "map";
  update.x = 1;
  update.y = 0;  // the last row of a graph's map is v = 0
  update.width = 2;
  EXPECT_FALSE(renderer->UpdateMap(update, std::array{0, 4}, diagnostics));  // there are 4 patterns
  ASSERT_TRUE(renderer->UpdateMap(update, std::array{0, -1}, diagnostics));
  const RenderResult live = renderer->Draw(0);
  const RenderResult whole = Render(after);
  ASSERT_TRUE(live.ok() && whole.ok()) << FirstMessage(live.diagnostics);
  EXPECT_EQ(live.outputs[0].floats, whole.outputs[0].floats);
  EXPECT_NE(live.outputs[0].floats, first.outputs[0].floats);
}

TEST_F(LiveGraphTest, SpritesThatMoveAreWhereTheyWouldBe) {
  const std::string nodes =
      R"("seen": { "block": "show_sprites",
                     "in": { "sprites": "beetles", "patterns": "patterns" } })";
  const auto sprites = [](const std::string& list) {
    return R"("beetles": { "of": "patterns", "cells": [6, 5], "layers": 2, "sprites": [)" + list +
           "] }";
  };
  const RenderRequest before =
      Compile("before", sprites(R"({ "pattern": 3, "at": [1, 1] })"), nodes);
  const RenderRequest after = Compile("after", sprites(R"({ "pattern": 2, "at": [2.25, 3.5] },
                                  { "pattern": 1, "at": [2.75, 3.125] })"),
                                      nodes);
  Diagnostics diagnostics;
  const auto renderer = LiveRenderer::Open(before, diagnostics);
  ASSERT_TRUE(renderer) << FirstMessage(diagnostics);
  auto beetles = runtime::LiveSprites::Open(*renderer, "beetles", diagnostics);
  ASSERT_TRUE(beetles) << FirstMessage(diagnostics);
  EXPECT_EQ(beetles->patterns(), 4u);
  textures::SpriteGrid::Id first = 0, second = 0;
  beetles->grid().Add({2, 0.5, 0.5}, first);
  beetles->grid().Add({1, 4.5, 3.125}, second);
  ASSERT_TRUE(beetles->Send(*renderer, diagnostics));
  const RenderResult start = renderer->Draw(0);
  beetles->grid().Move(first, {2, 2.25, 3.5});
  beetles->grid().Move(second, {1, 2.75, 3.125});
  ASSERT_LE(*beetles->Send(*renderer, diagnostics), 16u);
  const RenderResult live = renderer->Draw(0);
  const RenderResult whole = Render(after);
  ASSERT_TRUE(live.ok() && whole.ok()) << FirstMessage(live.diagnostics);
  EXPECT_EQ(live.outputs[0].floats, whole.outputs[0].floats);
  EXPECT_NE(live.outputs[0].floats, start.outputs[0].floats);
}

TEST_F(LiveGraphTest, TheExampleMovesSprites) {
  Compile("walk",
          R"("beetles": { "of": "patterns", "cells": [6, 5], "layers": 3, "sprites": [
                          { "pattern": 0, "at": [1, 1] }] })",
          R"("seen": { "block": "show_sprites",
                     "in": { "sprites": "beetles", "patterns": "patterns" } })");
  Program program;
  program.path = MOVE_SPRITES_PROGRAM;
  program.folder = folder.path();
  program.arguments = {"walk.json", "beetles", "3", "w.png"};
  const Outcome outcome = program.Run();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("3 frames; "));
  EXPECT_NE(folder.Read("w.0001.png"), "");
  EXPECT_NE(folder.Read("w.0001.png"), folder.Read("w.0002.png"));
  EXPECT_NE(folder.Read("w.0002.png"), folder.Read("w.0003.png"));
  const auto error = [&](std::vector<std::string> arguments) {
    program.arguments = std::move(arguments);
    const Outcome failure = program.Run();
    return std::to_string(failure.exit_code) + " " + failure.error;
  };
  EXPECT_THAT(error({"walk.json", "patterns", "3", "x.png"}),
              HasSubstr("1 error: texture 'patterns'"));
  EXPECT_THAT(error({"walk.json", "bees", "3", "x.png"}), HasSubstr("1 error: the shader uses no"));
  EXPECT_THAT(error({"none.json", "beetles", "3", "x.png"}), HasSubstr("3 error: "));
  EXPECT_THAT(error({"walk.json", "beetles", "0", "x.png"}), HasSubstr("2 error: usage"));
  EXPECT_THAT(error({"walk.json", "beetles", "3", "no/x.png"}), HasSubstr("3 error: "));
  EXPECT_EQ(folder.Read("x.0001.png"), "");
}

}  // namespace
}  // namespace texgraph
