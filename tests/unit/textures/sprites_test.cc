// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/sprites.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

namespace texgraph::textures {
namespace {

using Failure = SpriteGrid::Failure;
using Value = std::array<float, 4>;

constexpr uint32_t kWidth = 5;
constexpr uint32_t kHeight = 4;

const Value& At(const SpriteGrid& grid, uint32_t x, uint32_t y, uint32_t layer) {
  return grid.texels()[(size_t{layer} * grid.height() + y) * grid.width() + x];
}

TEST(SpritesTest, ASpriteIsInTheCellsItTouches) {
  SpriteGrid grid(kWidth, kHeight, 1, 10);
  SpriteGrid::Id id;
  ASSERT_EQ(grid.Add({3, 2.25, 0.5}, id), Failure::kNone);
  EXPECT_EQ(At(grid, 2, 0, 0), (Value{0.25f, 0.5f, 3, 1}));
  EXPECT_EQ(At(grid, 3, 0, 0), (Value{-0.75f, 0.5f, 3, 1}));
  EXPECT_EQ(At(grid, 2, 1, 0), (Value{0.25f, -0.5f, 3, 1}));
  EXPECT_EQ(At(grid, 3, 1, 0), (Value{-0.75f, -0.5f, 3, 1}));
  EXPECT_EQ(grid.TakeChanges().size(), 4u);
  ASSERT_EQ(grid.Move(id, {4, 1, 2}), Failure::kNone);  // one cell alone
  EXPECT_EQ(At(grid, 1, 2, 0), (Value{0, 0, 4, 1}));
  const auto changes = grid.TakeChanges();
  ASSERT_EQ(changes.size(), 5u);
  EXPECT_EQ(changes[4].x, 1u);
  EXPECT_EQ(changes[4].y, 2u);
  EXPECT_EQ(changes[0].value, (Value{0, 0, -1, 1}));
  ASSERT_EQ(grid.Move(id, {4, 0.5, 2}), Failure::kNone);
  EXPECT_EQ(grid.TakeChanges().size(), 2u);
  ASSERT_EQ(grid.Move(id, {4, 0.5, 2}), Failure::kNone);
  EXPECT_TRUE(grid.TakeChanges().empty());  // nothing differs
}

TEST(SpritesTest, TheGridDoesNotWrap) {
  SpriteGrid grid(kWidth, kHeight, 1, 1);
  SpriteGrid::Id id;
  ASSERT_EQ(grid.Add({0, -0.5, 3.5}, id), Failure::kNone);
  const auto changes = grid.TakeChanges();
  ASSERT_EQ(changes.size(), 1u);
  EXPECT_EQ(changes[0].value, (Value{-0.5f, 0.5f, 0, 1}));
  EXPECT_EQ(changes[0].y, 3u);
  for (const Sprite& sprite : {Sprite{0, -1, 0},
                               {0, 5, 0},
                               {0, 0, 4},
                               {0, 0, -1},
                               {0, NAN, 0},
                               {0, 0, INFINITY},
                               {0, -1e300, 0},
                               {0, 1e300, 1}}) {
    EXPECT_EQ(grid.Add(sprite, id), Failure::kOutside) << sprite.x << ' ' << sprite.y;
  }
  EXPECT_TRUE(grid.TakeChanges().empty());
}

TEST(SpritesTest, FailuresChangeNothing) {
  SpriteGrid grid(kWidth, kHeight, 2, 3);
  SpriteGrid::Id a, b, c;
  ASSERT_EQ(grid.Add({0, 1, 1}, a), Failure::kNone);
  ASSERT_EQ(grid.Add({1, 1.5, 1}, b), Failure::kNone);
  grid.TakeChanges();
  const auto before = grid.texels();
  EXPECT_EQ(grid.Add({2, 0.5, 0.5}, c), Failure::kTooManyInACell);
  EXPECT_EQ(grid.Add({3, 0, 0}, c), Failure::kNoSuchPattern);
  EXPECT_EQ(grid.Add({-1, 0, 0}, c), Failure::kNoSuchPattern);
  EXPECT_EQ(grid.Move(a, {3, 0, 0}), Failure::kNoSuchPattern);
  EXPECT_EQ(grid.Move(7, {0, 0, 0}), Failure::kNoSuchSprite);
  EXPECT_EQ(grid.Remove(7), Failure::kNoSuchSprite);
  EXPECT_EQ(grid.texels(), before);
  EXPECT_TRUE(grid.TakeChanges().empty());
  // A sprite makes room for itself.
  EXPECT_EQ(grid.Move(a, {0, 1.25, 1}), Failure::kNone);
  EXPECT_EQ(grid.Remove(a), Failure::kNone);
  EXPECT_EQ(grid.Remove(a), Failure::kNoSuchSprite);
  EXPECT_EQ(grid.Move(a, {0, 0, 0}), Failure::kNoSuchSprite);
  EXPECT_EQ(grid.Add({2, 0.5, 0.5}, c), Failure::kNone);
}

// What a shader would show at a point: the patterns of the sprites there, the lowest first.
std::vector<int> Shown(const SpriteGrid& grid, double x, double y) {
  const auto i = static_cast<uint32_t>(x), j = static_cast<uint32_t>(y);
  std::vector<int> patterns;
  for (uint32_t layer = 0; layer < grid.layers(); ++layer) {
    const Value& texel = At(grid, i, j, layer);
    const double u = x - i - texel[0], v = y - j - texel[1];
    if (texel[2] >= 0 && u >= 0 && u <= 1 && v >= 0 && v <= 1) {
      patterns.push_back(static_cast<int>(texel[2]));
    }
  }
  return patterns;
}

// Random edits: at every point the sprites whose squares hold it, in the order they were added; and
// whoever follows the changes has the same texels.
TEST(SpritesTest, RandomEditsShowEachSpriteWhereItIs) {
  std::mt19937 random(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 8) * 0x1p-24;
  };
  SpriteGrid grid(kWidth, kHeight, 16, 1000);
  std::map<SpriteGrid::Id, Sprite> there;
  std::vector<Value> follower(grid.texels());
  for (int step = 0; step < 400; ++step) {
    const Sprite sprite{step, uniform(-0.99, kWidth - 0.01), uniform(-0.99, kHeight - 0.01)};
    const uint32_t what = static_cast<uint32_t>(random() >> 16) % 4;
    auto some = there.begin();
    if (!there.empty()) std::advance(some, static_cast<long>(random() % there.size()));
    if (what < 2 && there.size() < 16) {
      SpriteGrid::Id id;
      ASSERT_EQ(grid.Add(sprite, id), Failure::kNone);
      there[id] = sprite;
    } else if (what == 2 && !there.empty()) {
      ASSERT_EQ(grid.Move(some->first, sprite), Failure::kNone);
      some->second = sprite;
    } else if (!there.empty()) {
      ASSERT_EQ(grid.Remove(some->first), Failure::kNone);
      there.erase(some);
    }
    if (step % 3 == 0) {
      for (const SpriteGrid::Texel& texel : grid.TakeChanges())
        follower[(size_t{texel.layer} * kHeight + texel.y) * kWidth + texel.x] = texel.value;
      ASSERT_EQ(follower, grid.texels());
    }
    for (int i = 0; i < 10; ++i) {
      const double x = uniform(0, kWidth), y = uniform(0, kHeight);
      std::vector<int> expected;
      for (const auto& [id, s] : there) {
        if (x - s.x >= 0 && x - s.x <= 1 && y - s.y >= 0 && y - s.y <= 1) {
          expected.push_back(s.pattern);
        }
      }
      ASSERT_EQ(Shown(grid, x, y), expected) << "step " << step;
    }
  }
}

std::vector<PlacedSprite> Placed(std::initializer_list<Sprite> sprites) {
  std::vector<PlacedSprite> placed;
  for (const Sprite& sprite : sprites)
    placed.push_back({sprite, {SourceId(0), static_cast<uint32_t>(placed.size()), 0}});
  return placed;
}

TEST(SpritesTextureTest, HasAsManyLayersAsNeeded) {
  const auto placed = Placed({{1, 0.5, 0.5}, {2, 1, 0}, {0, 1.5, 1}, {3, 3, 3}});
  EXPECT_EQ(SpriteLayersNeeded(placed, kWidth, kHeight), 2u);
  EXPECT_EQ(SpriteLayersNeeded({}, kWidth, kHeight), 1u);
  Diagnostics diagnostics;
  auto data = SpritesTexture(placed, kWidth, kHeight, {}, 4, "t", {}, diagnostics);
  ASSERT_TRUE(data);
  EXPECT_EQ(data->format, TexelFormat::kRgba32F);
  EXPECT_TRUE(data->is_array);
  EXPECT_EQ(data->layers, 2u);
  EXPECT_EQ(data->sampler.filter, ir::Filter::kNearest);
  const ir::Texture texture = ToTexture(*data);
  const int32_t low[] = {1, 0, 0}, high[] = {1, 0, 1}, empty[] = {4, 0, 1};
  EXPECT_EQ(ir::Fetch(texture, low, 0), (Value{-0.5f, 0.5f, 1, 1}));
  EXPECT_EQ(ir::Fetch(texture, high, 0), (Value{0, 0, 2, 1}));
  EXPECT_EQ(ir::Fetch(texture, empty, 0), (Value{0, 0, -1, 1}));
  EXPECT_EQ(SpritesTexture(placed, kWidth, kHeight, 3, 4, "t", {}, diagnostics)->layers, 3u);
}

TEST(SpritesTextureTest, ReportsEachSpriteAtItsPlace) {
  const auto placed =
      Placed({{4, 0, 0}, {0, 7.5, 1}, {0, 2, 2}, {0, 2.5, 2}, {0, 2, 2.5}, {0, 0, 0}});
  Diagnostics diagnostics;
  EXPECT_FALSE(SpritesTexture(placed, kWidth, kHeight, 2, 4, "leaves", {}, diagnostics));
  ASSERT_EQ(diagnostics.all().size(), 3u);
  EXPECT_EQ(diagnostics.all()[0].message,
            "a sprite of texture 'leaves' shows pattern 4; there are 4, counted from 0");
  EXPECT_EQ(diagnostics.all()[1].message,
            "a sprite of texture 'leaves' stands at (7.5, 1), outside of its 5 x 4 cells");
  EXPECT_EQ(diagnostics.all()[2].message, "more than 2 sprites of texture 'leaves' touch one cell");
  const uint32_t places[] = {0, 1, 4};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(diagnostics.all()[i].kind, DiagnosticKind::kValueRange);
    EXPECT_EQ(diagnostics.all()[i].range.begin, places[i]);
  }
}

TEST(SpritesTextureTest, HasLimits) {
  for (auto [width, height, layers] :
       {std::array{4096u, 4096u, 1u}, {1u, 1u, 65u}, {0u, 4u, 1u}, {1024u, 1024u, 5u}}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(SpritesTexture({}, width, height, layers, 1, "t", {}, diagnostics));
    ASSERT_EQ(diagnostics.all().size(), 1u);
    EXPECT_EQ(diagnostics.all()[0].kind, DiagnosticKind::kSizeLimit);
  }
}

}  // namespace
}  // namespace texgraph::textures
