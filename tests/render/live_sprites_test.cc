// SPDX-License-Identifier: Apache-2.0
// Sprites that move between pictures, against textures that were made for where they are.
#include "runtime/live_sprites.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "tests/render/render_testing.h"

namespace texgraph::runtime {
namespace {

using test::FirstMessage;
using test::FirstName;
using textures::PlacedSprite;
using textures::Sprite;
using textures::TextureData;
using Failure = textures::SpriteGrid::Failure;

constexpr uint32_t kWidth = 8;
constexpr uint32_t kHeight = 6;
constexpr uint32_t kLayers = 4;
constexpr uint32_t kPatterns = 5;

TextureData TextureOf(const std::vector<Sprite>& sprites) {
  std::vector<PlacedSprite> placed;
  for (const Sprite& sprite : sprites) placed.push_back({sprite, {}});
  Diagnostics diagnostics;
  auto data = textures::SpritesTexture(placed, kWidth, kHeight, kLayers, kPatterns, "sprites", {},
                                       diagnostics);
  EXPECT_TRUE(data) << FirstMessage(diagnostics);
  return data ? std::move(*data) : TextureData();
}

// Each sprite is a square of its pattern's colour that is brighter to the right, over those below.
RenderRequest RequestFor(TextureData data) {
  RenderRequest request =
      test::ShaderRequest("uniform sampler2DArray sprites;",
                          "vec2 at = uv * vec2(8.0, 6.0); ivec2 cell = ivec2(floor(at));\n"
                          "out_color = vec4(0.0); out_height = 0.0;\n"
                          "for (int layer = 0; layer < 4; ++layer) {\n"
                          "  vec4 sprite = texelFetch(sprites, ivec3(cell, layer), 0);\n"
                          "  vec2 inner = at - vec2(cell) - sprite.xy;\n"
                          "  if (sprite.z >= 0.0 && all(greaterThanEqual(inner, vec2(0.0))) &&\n"
                          "      all(lessThanEqual(inner, vec2(1.0)))) {\n"
                          "    out_color = vec4(sprite.z + 1.0, inner, 1.0);\n"
                          "  }\n"
                          "}",
                          128, 96);
  test::AddTexture(request, "sprites", std::move(data));
  request.manifest.textures[0].map = {MapContents::kSprites, kPatterns};
  return request;
}

std::vector<float> PixelsOf(const std::vector<Sprite>& sprites) {
  const RenderResult result = Render(RequestFor(TextureOf(sprites)));
  EXPECT_TRUE(result.ok()) << FirstMessage(result.diagnostics);
  return result.outputs[0].floats;
}

TEST(LiveSpritesTest, PicturesAreThoseOfSpritesThatWereThereFromTheBeginning) {
  Diagnostics diagnostics;
  // What the graph has is gone when the program's own sprites are sent.
  const auto renderer = LiveRenderer::Open(RequestFor(TextureOf({{2, 1.5, 1.5}})), diagnostics);
  ASSERT_TRUE(renderer) << FirstMessage(diagnostics);
  EXPECT_EQ(renderer->Draw(0).outputs[0].floats, PixelsOf({{2, 1.5, 1.5}}));
  auto live = LiveSprites::Open(*renderer, "sprites", diagnostics);
  ASSERT_TRUE(live) << FirstMessage(diagnostics);
  ASSERT_EQ(live->Send(*renderer, diagnostics), kWidth * kHeight * kLayers);
  EXPECT_EQ(renderer->Draw(0).outputs[0].floats, PixelsOf({}));

  std::mt19937 random(3);
  const auto anywhere = [&] {
    return Sprite{static_cast<int32_t>(random() % kPatterns), random() % 800 / 100.0 - 0.5,
                  random() % 600 / 100.0 - 0.5};
  };
  std::vector<Sprite> sprites;
  for (uint32_t i = 0; i < 7; ++i) {
    const Sprite sprite = anywhere();
    textures::SpriteGrid::Id id = 0;
    if (live->grid().Add(sprite, id) != Failure::kNone) continue;
    ASSERT_EQ(id, sprites.size());
    sprites.push_back(sprite);
  }
  ASSERT_GE(sprites.size(), 5u);
  for (int picture = 0; picture < 12; ++picture) {
    const uint32_t id = random() % sprites.size();
    const Sprite to = anywhere();
    if (live->grid().Move(id, to) == Failure::kNone) sprites[id] = to;
    const auto texels = live->Send(*renderer, diagnostics);
    ASSERT_TRUE(texels) << FirstMessage(diagnostics);
    EXPECT_LE(*texels, picture == 0 ? kWidth * kHeight * kLayers : 8 * kLayers);
    const RenderResult result = renderer->Draw(picture);
    ASSERT_TRUE(result.ok()) << FirstMessage(result.diagnostics);
    EXPECT_EQ(result.outputs[0].floats, PixelsOf(sprites)) << picture;
  }
}

TEST(LiveSpritesTest, OnlyWhatChangedTravels) {
  Diagnostics diagnostics;
  const auto renderer = LiveRenderer::Open(RequestFor(TextureOf({})), diagnostics);
  ASSERT_TRUE(renderer) << FirstMessage(diagnostics);
  auto live = LiveSprites::Open(*renderer, "sprites", diagnostics);
  ASSERT_TRUE(live);
  EXPECT_EQ(live->TakeUpdates().size(), kLayers);
  textures::SpriteGrid::Id id = 0;
  ASSERT_EQ(live->grid().Add({1, 2.25, 3.5}, id), Failure::kNone);
  const std::vector<TexelUpdate> updates = live->TakeUpdates();
  ASSERT_EQ(updates.size(), 2u);  // two rows of two cells
  for (uint32_t row = 0; row < 2; ++row) {
    EXPECT_EQ(updates[row].texture, "sprites");
    EXPECT_EQ(updates[row].x, 2u);
    EXPECT_EQ(updates[row].y, 3 + row);
    EXPECT_EQ(updates[row].layer, 0u);
    EXPECT_EQ(updates[row].width, 2u);
    EXPECT_EQ(updates[row].height, 1u);
    float values[8];
    ASSERT_EQ(updates[row].texels.size(), sizeof values);
    std::memcpy(values, updates[row].texels.data(), sizeof values);
    EXPECT_THAT(values, testing::ElementsAre(0.25f, 0.5f - static_cast<float>(row), 1, 1, -0.75f,
                                             0.5f - static_cast<float>(row), 1, 1));
  }
  EXPECT_TRUE(live->TakeUpdates().empty());
}

TEST(LiveSpritesTest, TexturesWithoutSprites) {
  TextureData data = TextureOf({});
  data.is_array = false;
  data.layers = 1;
  RenderRequest request = test::ShaderRequest(
      "uniform sampler2D sprites;", "out_color = texture(sprites, uv); out_height = 0.0;", 4, 4);
  data.levels[0].bytes.resize(size_t{kWidth} * kHeight * 16);
  test::AddTexture(request, "sprites", std::move(data));
  Diagnostics opening;
  const auto renderer = LiveRenderer::Open(request, opening);
  ASSERT_TRUE(renderer) << FirstMessage(opening);
  Diagnostics wrong, missing;
  EXPECT_FALSE(LiveSprites::Open(*renderer, "sprites", wrong));
  EXPECT_EQ(FirstName(wrong), "port-type");
  EXPECT_FALSE(LiveSprites::Open(*renderer, "spites", missing));
  EXPECT_EQ(FirstName(missing), "unknown-reference");
}

}  // namespace
}  // namespace texgraph::runtime
