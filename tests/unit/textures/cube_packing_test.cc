// SPDX-License-Identifier: Apache-2.0
#include "compiler/textures/cube_packing.h"

#include <gtest/gtest.h>

#include <set>

namespace texgraph::textures {
namespace {

// The steps run through all pairs of numbers once and close.
TEST(CubePackingTest, LayersAreMovedByEachPairOnce) {
  for (uint32_t colors : {2u, 3u}) {
    const CubePackLayout layout = LayOutCubes(colors, 4);
    const uint32_t n = layout.side;
    EXPECT_EQ(layout.layers, n * n);
    std::set<std::pair<uint32_t, uint32_t>> steps;
    for (uint32_t z = 0; z < layout.layers; ++z) {
      const auto here = CubeShift(z, colors);
      const auto next = CubeShift((z + 1) % layout.layers, colors);
      ASSERT_LT(here[0], n);
      ASSERT_LT(here[1], n);
      const uint32_t x = (next[0] + n - here[0]) % n;
      const uint32_t y = (next[1] + n - here[1]) % n;
      EXPECT_EQ(x + y * n, z) << colors << " colours";
      steps.insert({x, y});
    }
    EXPECT_EQ(steps.size(), layout.layers);
  }
}

TEST(CubePackingTest, EachCubeHasAPlaceOfItsOwn) {
  for (uint32_t colors : {2u, 3u}) {
    const CubePackLayout layout = LayOutCubes(colors, 4);
    std::set<CubeColors> seen;
    for (uint32_t z = 0; z < layout.layers; ++z) {
      for (uint32_t y = 0; y < layout.side; ++y) {
        for (uint32_t x = 0; x < layout.side; ++x) {
          const CubeColors corners = CubeAt(layout, x, y, z);
          ASSERT_TRUE(seen.insert(corners).second) << x << ' ' << y << ' ' << z;
          ASSERT_EQ(PackedCube(corners, colors), (CubePlace{x, y, z}));
        }
      }
    }
    uint32_t cubes = 1;
    for (int corner = 0; corner < 8; ++corner) cubes *= colors;
    EXPECT_EQ(seen.size(), cubes);
    EXPECT_EQ(layout.cubes(), cubes);
  }
}

// All 26 neighbours have the corners in common that they share, around the torus.
TEST(CubePackingTest, NeighboursInThePackHaveTheSameColours) {
  for (uint32_t colors : {2u, 3u}) {
    const CubePackLayout layout = LayOutCubes(colors, 4);
    const auto at = [&](int64_t x, int64_t y, int64_t z) {
      const int64_t side = layout.side;
      const int64_t layers = layout.layers;
      return CubeAt(layout, (x + side) % side, (y + side) % side, (z + layers) % layers);
    };
    for (uint32_t i = 0; i < layout.cubes(); ++i) {
      const int64_t x = i % layout.side;
      const int64_t y = i / layout.side % layout.side;
      const int64_t z = i / layout.side / layout.side;
      const CubeColors here = at(x, y, z);
      for (int to = 0; to < 27; ++to) {
        const int step[3] = {to % 3 - 1, to / 3 % 3 - 1, to / 9 - 1};
        const CubeColors there = at(x + step[0], y + step[1], z + step[2]);
        for (int corner = 0; corner < 8; ++corner) {
          int other = 0;
          bool shared = true;
          for (int axis = 0; axis < 3; ++axis) {
            const int bit = (corner >> axis & 1) - step[axis];
            shared = shared && (bit == 0 || bit == 1);
            other |= (bit & 1) << axis;
          }
          if (!shared) continue;
          ASSERT_EQ(here[static_cast<size_t>(corner)], there[static_cast<size_t>(other)])
              << colors << " colours, cube " << x << ' ' << y << ' ' << z << " to " << to;
        }
      }
    }
  }
}

}  // namespace
}  // namespace texgraph::textures
