// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_pictures.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <set>

#include "tests/unit/textures/tile_testing.h"

namespace texgraph::textures {
namespace {

using test::RandomImage;
using test::TileTexel;
using test::UpAt;

Image RandomPack(const TilePackLayout& layout, uint8_t channels, uint8_t bits) {
  return RandomImage(layout.width(), layout.height(), channels, bits, 1);
}

// Wei's equation 10: what is around each corner is what four tiles with these edges have there.
TEST(TilePicturesTest, WeisCornerPackHasAllCorners) {
  for (const std::array<uint32_t, 2> colors : {std::array{2u, 2u}, {3u, 1u}, {2u, 4u}}) {
    const TilePackLayout layout = LayOutTiles(TileKind::kWang, colors, 6);
    const Image pack = RandomPack(layout, 3, 16);
    const Image corners = MakeWeiCornerPack(pack, layout);
    ASSERT_EQ(corners.width, colors[0] * colors[0] * 6);
    ASSERT_EQ(corners.height, colors[1] * colors[1] * 6);
    // Tiles of the pack by their texels: texel i of a tile is at the same place in all of them.
    for (uint32_t bottom = 0; bottom < colors[1]; ++bottom) {
      for (uint32_t right = 0; right < colors[0]; ++right) {
        for (uint32_t top = 0; top < colors[1]; ++top) {
          for (uint32_t left = 0; left < colors[0]; ++left) {
            const TilePlace at = PackedWeiCorner(bottom, right, top, left);
            // The four tiles around the right top corner of tile `at`, the edges that meet there
            // being right: found in the pack by their texel in the middle.
            for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
              std::set<std::pair<uint32_t, uint32_t>> edges;
              for (uint32_t tile = 0; tile < layout.tiles(); ++tile) {
                const TilePlace place{tile % layout.columns, tile / layout.columns};
                bool same = true;
                for (uint32_t i = 0; i < 36 && same; ++i) {
                  same = TileTexel(pack, layout, place, i % 6, i / 6, 0) ==
                         UpAt(corners, (int64_t{at.x} + dx) * 6 + i % 6,
                              (int64_t{at.y} + dy) * 6 + i / 6, 0);
                }
                const TileColors found = TileAt(layout, place.x, place.y);
                // The lying edge at the corner is its north or south, the standing one its east or
                // west.
                if (same) edges.insert({found[dy == 0 ? 2 : 0], found[dx == 0 ? 1 : 3]});
              }
              ASSERT_EQ(edges.size(), 1u);
              EXPECT_EQ(edges.begin()->first, dx == 0 ? left : right);
              EXPECT_EQ(edges.begin()->second, dy == 0 ? bottom : top);
            }
          }
        }
      }
    }
  }
}

TEST(TilePicturesTest, TheViewShowsEachTileApart) {
  for (const TilePackLayout& layout :
       {LayOutTiles(TileKind::kCorner, {4, 4}, 8), LayOutTiles(TileKind::kWang, {2, 3}, 8)}) {
    const Image pack = RandomPack(layout, 3, 8);
    const Image view = MakeTileView(pack, layout);
    // Marks of two texels, a texel of ground to both sides: 14 a tile.
    ASSERT_EQ(view.width, layout.columns * 14);
    ASSERT_EQ(view.height, layout.rows * 14);
    const auto color = [&](int64_t x, int64_t y) {
      return std::array{UpAt(view, x, y, 0), UpAt(view, x, y, 1), UpAt(view, x, y, 2)};
    };
    std::map<std::pair<bool, uint32_t>, std::set<std::array<uint32_t, 3>>> marks;
    std::set<std::array<uint32_t, 3>> all;
    for (uint32_t y = 0; y < layout.rows; ++y) {
      for (uint32_t x = 0; x < layout.columns; ++x) {
        const int64_t left = x * 14 + 3;
        const int64_t bottom = y * 14 + 3;
        for (uint32_t i = 0; i < 64; ++i) {
          for (uint32_t c = 0; c < 3; ++c) {
            ASSERT_EQ(UpAt(view, left + i % 8, bottom + i / 8, c),
                      TileTexel(pack, layout, {x, y}, i % 8, i / 8, c));
          }
        }
        const TileColors tile = TileAt(layout, x, y);
        const bool corner = layout.kind == TileKind::kCorner;
        const int64_t at[4][2] = {{corner ? -1 : 4, -1},
                                  {8, corner ? -1 : 4},
                                  {corner ? -1 : 4, 8},
                                  {corner ? 8 : -1, corner ? 8 : 4}};
        for (uint32_t i = 0; i < 4; ++i) {
          const auto mark = color(left + at[i][0], bottom + at[i][1]);
          marks[{!corner && i % 2 == 1, tile[i]}].insert(mark);
          all.insert(mark);
        }
      }
    }
    // One mark for each colour, each its own.
    EXPECT_EQ(all.size(), marks.size());
    for (const auto& [key, values] : marks) EXPECT_EQ(values.size(), 1u);
    EXPECT_EQ(marks.size(), layout.kind == TileKind::kCorner ? 4u : 5u);
  }
}

// O24 is the shader's; here: the tiling is made of tiles whose colours agree.
TEST(TilePicturesTest, TilingsAreMadeOfTilesThatFit) {
  for (const TilePackLayout& layout :
       {LayOutTiles(TileKind::kCorner, {3, 3}, 4), LayOutTiles(TileKind::kWang, {2, 3}, 4)}) {
    const Image pack = RandomPack(layout, 1, 16);
    const Image tiling = MakeTiling(pack, layout, 9, 7, 1);
    ASSERT_EQ(tiling.width, 36u);
    ASSERT_EQ(tiling.height, 28u);
    const auto tile_at = [&](uint32_t x, uint32_t y) {
      for (uint32_t tile = 0; tile < layout.tiles(); ++tile) {
        const TilePlace place{tile % layout.columns, tile / layout.columns};
        bool same = true;
        for (uint32_t i = 0; i < 16 && same; ++i) {
          same = TileTexel(pack, layout, place, i % 4, i / 4, 0) ==
                 UpAt(tiling, x * 4 + i % 4, y * 4 + i / 4, 0);
        }
        if (same) return TileAt(layout, place.x, place.y);
      }
      ADD_FAILURE() << "no tile of the pack";
      return TileColors{};
    };
    const bool corner = layout.kind == TileKind::kCorner;
    std::set<TileColors> seen;
    for (uint32_t y = 0; y + 1 < 7; ++y) {
      for (uint32_t x = 0; x + 1 < 9; ++x) {
        const TileColors tile = tile_at(x, y);
        seen.insert(tile);
        EXPECT_EQ(tile[1], tile_at(x + 1, y)[corner ? 0 : 3]);
        EXPECT_EQ(tile[2], tile_at(x, y + 1)[0]);
        EXPECT_TRUE(!corner || tile[3] == tile_at(x + 1, y + 1)[0]);
      }
    }
    EXPECT_GT(seen.size(), 15u);
  }
}

}  // namespace
}  // namespace texgraph::textures
