// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/tile_packing.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace texgraph::textures {
namespace {

std::vector<TilePackLayout> AllLayouts() {
  std::vector<TilePackLayout> layouts;
  for (uint32_t lying = 1; lying <= 4; ++lying) {
    for (uint32_t standing = 1; standing <= 4; ++standing)
      layouts.push_back(LayOutTiles(TileKind::kWang, {lying, standing}, 8));
  }
  for (uint32_t colors = 2; colors <= 4; ++colors)
    layouts.push_back(LayOutTiles(TileKind::kCorner, {colors, colors}, 8));
  return layouts;
}

// Wei 2004, equation 9: [0..N] is [0..N-1], then 0N 1N N1 2N N2 .. NN N0 in the order of figure 4.
TEST(TilePackingTest, TheTourOfPairsIsWeis) {
  const std::vector<std::pair<uint32_t, uint32_t>> tour = {
      {0, 0}, {0, 1}, {1, 1}, {1, 0}, {0, 2}, {2, 1}, {1, 2}, {2, 2},
      {2, 0}, {0, 3}, {3, 1}, {1, 3}, {3, 2}, {2, 3}, {3, 3}, {3, 0}};
  for (uint32_t i = 0; i < tour.size(); ++i)
    EXPECT_EQ(TileIndex1D(tour[i].first, tour[i].second), i);
}

// O21: every combination once.
TEST(TilePackingTest, EachTileHasAPlaceOfItsOwn) {
  for (const TilePackLayout& layout : AllLayouts()) {
    const bool corner = layout.kind == TileKind::kCorner;
    const uint32_t south = layout.colors[0];
    const uint32_t east = corner ? south : layout.colors[1];
    std::set<std::pair<uint32_t, uint32_t>> places;
    for (uint32_t a = 0; a < south; ++a) {
      for (uint32_t b = 0; b < east; ++b) {
        for (uint32_t c = 0; c < south; ++c) {
          for (uint32_t d = 0; d < east; ++d) {
            const TilePlace place = PackedTile(layout, {a, b, c, d});
            ASSERT_LT(place.x, layout.columns);
            ASSERT_LT(place.y, layout.rows);
            ASSERT_TRUE(places.insert({place.x, place.y}).second);
            ASSERT_EQ(TileAt(layout, place.x, place.y), (TileColors{a, b, c, d}));
          }
        }
      }
    }
    EXPECT_EQ(places.size(), layout.tiles());
  }
}

// O21: tiles beside each other share their colours there; around the torus where there are no
// gutters, and into the gutters where there are.
TEST(TilePackingTest, NeighboursInThePackHaveTheSameColours) {
  for (const TilePackLayout& layout : AllLayouts()) {
    const bool corner = layout.kind == TileKind::kCorner;
    const auto at = [&](int64_t x, int64_t y) {
      const auto columns = int64_t{layout.columns};
      const auto rows = int64_t{layout.rows};
      x = (x + columns) % columns;
      if (layout.gutter == 0) y = (y + rows) % rows;
      // In gutters what stands there is a tile of the pack, too.
      const TilePlace place = ContinuedPlace(layout, x, y);
      return TileAt(layout, place.x, place.y);
    };
    const int64_t around = layout.gutter > 0 ? 1 : 0;
    for (int64_t y = -around; y < int64_t{layout.rows} + around; ++y) {
      for (int64_t x = 0; x < int64_t{layout.columns}; ++x) {
        const TileColors tile = at(x, y);
        const TileColors right = at(x + 1, y);
        ASSERT_EQ(tile[1], right[corner ? 0 : 3]);
        if (corner) {
          ASSERT_EQ(tile[3], right[2]);
        }
        if (y == int64_t{layout.rows} + around - 1 && around > 0) continue;
        const TileColors above = at(x, y + 1);
        ASSERT_EQ(tile[2], above[0]);
        if (corner) {
          ASSERT_EQ(tile[3], above[1]);
        }
      }
    }
  }
}

// Each layer of 2 x 2 tiles is a torus, and each tile stands once at each of the four places.
TEST(TilePackingTest, LayersCloseAndHaveEachTileFourTimes) {
  for (const TilePackLayout& layout : AllLayouts()) {
    const bool corner = layout.kind == TileKind::kCorner;
    std::set<TileColors> seen[4];
    for (uint32_t layer = 0; layer < layout.tiles(); ++layer) {
      for (uint32_t place = 0; place < 4; ++place) {
        const uint32_t x = place % 2, y = place / 2;
        const TileColors tile = TileInLayer(layout, layer, x, y);
        EXPECT_TRUE(seen[place].insert(tile).second);
        const TileColors right = TileInLayer(layout, layer, 1 - x, y);
        const TileColors above = TileInLayer(layout, layer, x, 1 - y);
        ASSERT_EQ(tile[1], right[corner ? 0 : 3]);
        ASSERT_EQ(tile[2], above[0]);
        if (!corner) continue;
        ASSERT_EQ(tile[3], right[2]);
        ASSERT_EQ(tile[3], above[1]);
      }
    }
    for (const auto& tiles : seen) EXPECT_EQ(tiles.size(), layout.tiles());
  }
}

// Wei 2004, appendix B: corners beside each other share the edge between them, on the torus.
TEST(TilePackingTest, WeisCornersFitOnATorus) {
  for (uint32_t lying = 1; lying <= 4; ++lying) {
    for (uint32_t standing = 1; standing <= 4; ++standing) {
      const uint32_t columns = lying * lying;
      const uint32_t rows = standing * standing;
      std::vector<TileColors> corners(size_t{columns} * rows, TileColors{9, 9, 9, 9});
      for (uint32_t bottom = 0; bottom < standing; ++bottom) {
        for (uint32_t right = 0; right < lying; ++right) {
          for (uint32_t top = 0; top < standing; ++top) {
            for (uint32_t left = 0; left < lying; ++left) {
              const TilePlace place = PackedWeiCorner(bottom, right, top, left);
              ASSERT_LT(place.x, columns);
              ASSERT_LT(place.y, rows);
              TileColors& corner = corners[place.y * columns + place.x];
              ASSERT_EQ(corner[0], 9u);
              corner = {bottom, right, top, left};
            }
          }
        }
      }
      for (uint32_t y = 0; y < rows; ++y) {
        for (uint32_t x = 0; x < columns; ++x) {
          const TileColors& corner = corners[y * columns + x];
          ASSERT_EQ(corner[1], corners[y * columns + (x + 1) % columns][3]);
          ASSERT_EQ(corner[2], corners[(y + 1) % rows * columns + x][0]);
        }
      }
    }
  }
}

TEST(TilePackingTest, TheLargestTileIsTheLargest) {
  for (const TilePackLayout& layout : AllLayouts()) {
    for (uint64_t maps : {1u, 3u}) {
      const auto is_within = [&](uint32_t size) {
        const TilePackLayout pack = LayOutTiles(layout.kind, layout.colors, size);
        return std::max(pack.width(), pack.height()) <= 16384 &&
               maps * pack.width() * pack.height() <= uint64_t{1} << 26;
      };
      const uint32_t size = LargestTile(layout.kind, layout.colors, maps);
      EXPECT_TRUE(is_within(size));
      EXPECT_FALSE(is_within(size + 1));
    }
  }
}

TEST(TilePackingTest, ColoursHaveLimits) {
  EXPECT_TRUE(AreTileColors(TileKind::kWang, {1, 4}));
  EXPECT_FALSE(AreTileColors(TileKind::kWang, {0, 2}));
  EXPECT_FALSE(AreTileColors(TileKind::kWang, {2, 5}));
  EXPECT_TRUE(AreTileColors(TileKind::kCorner, {4, 4}));
  EXPECT_FALSE(AreTileColors(TileKind::kCorner, {1, 1}));
  EXPECT_FALSE(AreTileColors(TileKind::kCorner, {5, 5}));
  EXPECT_FALSE(AreTileColors(TileKind::kCorner, {2, 3}));
}

}  // namespace
}  // namespace texgraph::textures
